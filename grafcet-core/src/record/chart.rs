//! What the macro says of a chart that can be recorded.

use super::bits::{Reader, Writer};
use super::value::Record;
use crate::{Chart, Possible, Ticks};

/// A chart that can be recorded: with the feature `record`, every chart whose inputs, stored outputs, variables and params are
/// [`Record`]. The macro implements it.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be recorded",
    label = "not recordable",
    note = "it has to be a chart of `grafcet!` whose inputs, stored outputs, variables and params are `grafcet::record::Record`"
)]
pub trait Recordable: Chart<Inputs: Record + Default> + Clone {
    /// Tells charts apart: a number that follows from the chart's source, but for comments.
    const FINGERPRINT: u32;
    /// The same of the state that the compiler has made of it: another version may store the same chart otherwise.
    const LAYOUT: u32;
    /// Whether the chart uses time, and tells until when nothing happens.
    const TIMED: bool;
    /// What is known of its situations.
    #[doc(hidden)]
    const POSSIBLE: Possible<'static>;
    /// How many bits the recipe takes.
    const PARAM_BITS: usize;
    /// How many bits the state takes, without the recipe.
    const STATE_BITS: usize;

    /// Writes the recipe.
    fn write_params(&self, to: &mut Writer<'_>);

    /// Writes the state. The reading of the clock is not part of it: times are stored as they have elapsed, and one of which nothing is to come any more as the
    /// longest that it is compared with.
    fn write_state(&self, to: &mut Writer<'_>);

    /// A chart in the state that was written, as if its last cycle had been at the time `now`; `None` where these bits are none.
    fn read(params: &mut Reader<'_>, state: &mut Reader<'_>, now: Ticks) -> Option<Self>;

    /// A chart with the same recipe in its initial state.
    #[must_use]
    fn begun_anew(&self) -> Self;

    /// Whether recipe and state are the same, the reading of the clock left aside, and what a time was left with of which nothing is to come any more.
    fn is_same_state(&self, other: &Self) -> bool;

    /// The reading of the clock in the last cycle; zero for a chart without time.
    fn reading(&self) -> Ticks;

    /// As `next_deadline` of the chart; `None` for one without time.
    fn wakes_at(&self) -> Option<Ticks>;
}

/// What a chart waits for, on the controller: with the feature `record`, every chart. The macro implements it; a program that never asks links nothing
/// of it, and it stores nothing.
pub trait Blocked {
    /// The transitions in front of which all steps are active, by their numbers in [`Description::transitions`](crate::description::Description): a
    /// few bytes to send. `grafcet_sim::Names::transitions` has the text of each and of its condition, and `grafcet_sim::Blocked`, of a record,
    /// what is false in it.
    fn blocked(&self) -> impl Iterator<Item = usize>;
}

/// What the macro writes, in full.
#[doc(hidden)]
#[macro_export]
macro_rules! __recorded {
    (
        chart $chart:ident $fingerprint:literal $layout:literal
        inputs $inputs:ident { $($input:ident: $input_ty:ty $(as $input_how:ident)?,)* }
        params { $($params:ident { $($param:ident: $param_ty:ty $(as $param_how:ident)?,)* } $(in $out_of_range:ident)? where { $($needs:ty: $needed:tt,)* })? }
        state { $($field:ident: $field_ty:ty $(as $how:ident $($optional:ident)?)?,)* }
        clock { $($clock:ident $($began:ident)*)? }
        awaited { $($this:ident $last:ident $($since:ident ($awaited:expr) $longest:literal)+)? }
        foreign { $($foreign:ty: $bound:tt,)* }
        possible { $possible:expr }
        enums { $($state:ident $($of:ident)? { $($variant:ident)* })* }
        listed { $($listed:ident $listed_ty:ty { $($number:literal ($($value:tt)*),)* })* }
    ) => {
        const _: () = {
            use $crate::record::names as __r;
            // One word, so that what rustc says of it stands at the type for which the chart's code asks for it.
            #[allow(unused_imports)]
            use __r::Record as __Record;

            $(
                struct $listed;
                impl __r::Coding<$listed_ty> for $listed {
                    const BITS: __r::usize = __r::bits_for([$($number),*].len());
                    const IS_WORD: __r::bool = true;
                    #[inline]
                    fn word(value_: &$listed_ty) -> __r::u32 {
                        // Whether these are all variants, the chart asks itself, in the same words: rustc says it once.
                        match value_ { $($($value)* { .. } => $number,)* _ => 0 }
                    }
                    fn write(value_: &$listed_ty, to_: &mut __r::Writer<'_>) { to_.put(Self::word(value_), Self::BITS); }
                    fn read(from_: &mut __r::Reader<'_>) -> __r::Option<$listed_ty> {
                        match from_.take(Self::BITS)? {
                            $($number => __r::Option::Some($($value)* {}),)*
                            _ => __r::Option::None,
                        }
                    }
                    #[inline]
                    fn is_same(one_: &$listed_ty, other_: &$listed_ty) -> __r::bool { Self::word(one_) == Self::word(other_) }
                }
            )*

            impl __r::Record for $inputs where $(for<'chart> $foreign: $bound,)* {
                const BITS: __r::usize = 0 $(+ <$crate::__recorded_as!($($input_how)?) as __r::Coding<$input_ty>>::BITS)*;
                fn write(&self, _to_: &mut __r::Writer<'_>) { $(<$crate::__recorded_as!($($input_how)?) as __r::Coding<$input_ty>>::write(&self.$input, _to_);)* }
                fn read(_from_: &mut __r::Reader<'_>) -> __r::Option<Self> {
                    __r::Option::Some(Self { $($input: <$crate::__recorded_as!($($input_how)?) as __r::Coding<$input_ty>>::read(_from_)?,)* })
                }
                #[inline]
                fn is_same(&self, _other_: &Self) -> __r::bool {
                    true $(& <$crate::__recorded_as!($($input_how)?) as __r::Coding<$input_ty>>::is_same(&self.$input, &_other_.$input))*
                }
                const IS_WORD: __r::bool = Self::BITS <= 32 $(&& <$crate::__recorded_as!($($input_how)?) as __r::Coding<$input_ty>>::IS_WORD)*;
                #[inline]
                fn word(&self) -> __r::u32 {
                    // A shift of 32 bits and more is one of a chart whose inputs are no word.
                    let mut _word_: __r::u32 = 0;
                    let mut _at_: __r::u32 = 0;
                    $(
                        _word_ |= <$crate::__recorded_as!($($input_how)?) as __r::Coding<$input_ty>>::word(&self.$input).wrapping_shl(_at_);
                        _at_ += <$crate::__recorded_as!($($input_how)?) as __r::Coding<$input_ty>>::BITS as __r::u32;
                    )*
                    _word_
                }
            }

            $(impl __r::Record for $params where for<'chart> $params: __r::Copy, $(for<'chart> $needs: $needed,)* {
                const BITS: __r::usize = 0 $(+ <$crate::__recorded_as!($($param_how)?) as __r::Coding<$param_ty>>::BITS)*;
                fn write(&self, _to_: &mut __r::Writer<'_>) { $(<$crate::__recorded_as!($($param_how)?) as __r::Coding<$param_ty>>::write(&self.$param, _to_);)* }
                fn read(_from_: &mut __r::Reader<'_>) -> __r::Option<Self> {
                    let params_ = Self { $($param: <$crate::__recorded_as!($($param_how)?) as __r::Coding<$param_ty>>::read(_from_)?,)* };
                    $(if __r::Option::is_some(&params_.$out_of_range()) {
                        return __r::Option::None;
                    })?
                    __r::Option::Some(params_)
                }
                fn is_same(&self, _other_: &Self) -> __r::bool {
                    true $(&& <$crate::__recorded_as!($($param_how)?) as __r::Coding<$param_ty>>::is_same(&self.$param, &_other_.$param))*
                }
            })?

            $(impl $chart {
                /// What has elapsed of each time that began; the longest that it is compared with, where nothing of it is still to come. There the field
                /// stands for whatever it was left with, which may be something else in a replay, as that leaves out cycles that do nothing.
                fn __elapsed(&$this) -> [__r::Ticks; [$($longest),+].len()] {
                    [$(if $awaited { $this.$last.since($this.$since) } else { __r::Ticks::new($longest) }),+]
                }
            })?

            $($crate::__recorded_states! { $state $($of)? { $($variant)* } })*

            impl __r::Recordable for $chart where $(for<'chart> $foreign: $bound,)* {
                const FINGERPRINT: __r::u32 = $fingerprint;
                const LAYOUT: __r::u32 = $layout;
                const TIMED: __r::bool = $crate::__recorded_clock!(timed self $($clock)?);
                const POSSIBLE: __r::Possible<'static> = $possible;
                const PARAM_BITS: __r::usize = 0 $(+ <$params as __r::Record>::BITS)?;
                const STATE_BITS: __r::usize =
                    0 $(+ <$crate::__recorded_as!($($how $($optional)?)?) as __r::Coding<$field_ty>>::BITS)* $($(+ $crate::__recorded_clock!(bits $began))*)?;
                fn write_params(&self, _to_: &mut __r::Writer<'_>) {
                    $(<$params as __r::Record>::write(&self.params, _to_);)?
                }
                fn write_state(&self, _to_: &mut __r::Writer<'_>) {
                    $(<$crate::__recorded_as!($($how $($optional)?)?) as __r::Coding<$field_ty>>::write(&self.$field, _to_);)*
                    $(for elapsed_ in $crate::__recorded_clock!(elapsed self $last) { __r::Record::write(&elapsed_, _to_); })?
                }
                fn read(_params_: &mut __r::Reader<'_>, _state_: &mut __r::Reader<'_>, _now_: __r::Ticks) -> __r::Option<Self> {
                    __r::Option::Some(Self {
                        $(params: <$params as __r::Record>::read(_params_)?,)?
                        $($field: <$crate::__recorded_as!($($how $($optional)?)?) as __r::Coding<$field_ty>>::read(_state_)?,)*
                        $($($began: _now_.since(<__r::Ticks as __r::Record>::read(_state_)?),)*)?
                        $($clock: _now_,)?
                    })
                }
                fn begun_anew(&self) -> Self { $crate::__recorded_new!(self $($params)?) }
                fn is_same_state(&self, _other_: &Self) -> __r::bool {
                    true $(&& <$params as __r::Record>::is_same(&self.params, &_other_.params))?
                        $(&& <$crate::__recorded_as!($($how $($optional)?)?) as __r::Coding<$field_ty>>::is_same(&self.$field, &_other_.$field))*
                        $(&& $crate::__recorded_clock!(elapsed self $last) == $crate::__recorded_clock!(elapsed _other_ $last))?
                }
                fn reading(&self) -> __r::Ticks { $crate::__recorded_clock!(reading self $($clock)?) }
                fn wakes_at(&self) -> __r::Option<__r::Ticks> { $crate::__recorded_clock!(deadline self $($clock)?) }
            }
        };
    };
}

/// What a chart with mistakes has, so that a program that records it gets no follow-up errors.
#[doc(hidden)]
#[macro_export]
macro_rules! __recorded_stub {
    ($chart:ident $inputs:ident) => {
        const _: () = {
            use $crate::record::names as __r;

            impl __r::Record for $inputs
            where
                for<'chart> $inputs: __r::Copy,
            {
                const BITS: __r::usize = 0;
                fn write(&self, _: &mut __r::Writer<'_>) {}
                fn read(_: &mut __r::Reader<'_>) -> __r::Option<Self> {
                    __r::Option::None
                }
                fn is_same(&self, _: &Self) -> __r::bool {
                    true
                }
            }

            impl __r::Recordable for $chart
            where
                for<'chart> $inputs: __r::Copy,
            {
                const FINGERPRINT: __r::u32 = 0;
                const LAYOUT: __r::u32 = 0;
                const TIMED: __r::bool = false;
                const POSSIBLE: __r::Possible<'static> = __r::Possible::Unknown;
                const PARAM_BITS: __r::usize = 0;
                const STATE_BITS: __r::usize = 0;
                fn write_params(&self, _: &mut __r::Writer<'_>) {}
                fn write_state(&self, _: &mut __r::Writer<'_>) {}
                fn read(_: &mut __r::Reader<'_>, _: &mut __r::Reader<'_>, _: __r::Ticks) -> __r::Option<Self> {
                    __r::Option::None
                }
                fn begun_anew(&self) -> Self {
                    loop {}
                }
                fn is_same_state(&self, _: &Self) -> __r::bool {
                    true
                }
                fn reading(&self) -> __r::Ticks {
                    __r::Ticks::ZERO
                }
                fn wakes_at(&self) -> __r::Option<__r::Ticks> {
                    __r::Option::None
                }
            }
        };
    };
}

/// How a field is written: by the list of a chart, or as its type says.
#[doc(hidden)]
#[macro_export]
macro_rules! __recorded_as {
    () => { __r::Own };
    ($listed:ident) => { $listed };
    ($listed:ident $optional:ident) => { __r::Optional<$listed> };
}

/// What differs between charts with and without a recipe.
#[doc(hidden)]
#[macro_export]
macro_rules! __recorded_new {
    ($chart:ident) => {
        Self::new()
    };
    ($chart:ident $params:ident) => {{
        let mut new_ = Self::new();
        new_.params = $chart.params;
        new_
    }};
}

/// What differs between charts with and without time.
#[doc(hidden)]
#[macro_export]
macro_rules! __recorded_clock {
    (timed $chart:ident) => {
        false
    };
    (timed $chart:ident $clock:ident) => {
        true
    };
    (bits $began:ident) => {
        <__r::Ticks as __r::Record>::BITS
    };
    (reading $chart:ident) => {
        __r::Ticks::ZERO
    };
    (reading $chart:ident $clock:ident) => {
        $chart.$clock
    };
    (elapsed $chart:ident $clock:ident) => {
        $chart.__elapsed()
    };
    (deadline $chart:ident) => {
        __r::Option::None
    };
    (deadline $chart:ident $clock:ident) => {
        $chart.next_deadline()
    };
}

/// The states of a region by their numbers, and the first region's with the mark above it.
#[doc(hidden)]
#[macro_export]
macro_rules! __recorded_states {
    ($state:ident { $($variant:ident)* }) => {
        impl __r::Record for $state {
            const BITS: __r::usize = __r::bits_for([$(Self::$variant),*].len());
            fn write(&self, to_: &mut __r::Writer<'_>) { to_.put(*self as __r::u32, Self::BITS); }
            fn read(from_: &mut __r::Reader<'_>) -> __r::Option<Self> {
                const ALL: &[$state] = &[$($state::$variant),*];
                ALL.get(from_.take(Self::BITS)? as __r::usize).copied()
            }
            #[inline]
            fn is_same(&self, other_: &Self) -> __r::bool { *self == *other_ }
        }
    };
    ($marked:ident $state:ident {}) => {
        impl __r::Record for $marked {
            const BITS: __r::usize = <$state as __r::Record>::BITS + 1;
            fn write(&self, to_: &mut __r::Writer<'_>) {
                __r::Record::write(&self.state(), to_);
                __r::Record::write(&self.is_marked(), to_);
            }
            fn read(from_: &mut __r::Reader<'_>) -> __r::Option<Self> {
                let state_ = Self::of(<$state as __r::Record>::read(from_)?);
                __r::Option::Some(if <__r::bool as __r::Record>::read(from_)? { state_.marked() } else { state_ })
            }
            #[inline]
            fn is_same(&self, other_: &Self) -> __r::bool { *self == *other_ }
        }
    };
}
