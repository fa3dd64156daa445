//! What can be written down: the values of inputs, of the recipe and of a chart's state.

use super::bits::{Reader, Writer};
use crate::Ticks;

/// A value that a record can hold, in a number of bits that is the same for all values of its type.
///
/// It is there for `bool`, numbers, `char`, [`Ticks`], and for arrays and tuples of these. [`recordable!`](crate::recordable) implements
/// it for an enum without fields, and for what `serde` can write.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be recorded: it is no `Record`",
    label = "no `Record`",
    note = "of an enum without fields: list its variants in the chart, as in `in {{Off, Auto}}`, or write `grafcet::recordable! {{ {Self} {{ Off, Auto }} }}` beside its declaration",
    note = "of what `serde` can write: `grafcet::recordable! {{ {Self} as serde in 8 bytes }}`, with the most bytes that a value takes (feature `postcard`)",
    note = "of anything else: `impl grafcet::record::Record for {Self}`"
)]
pub trait Record: Copy {
    /// How many bits a value takes.
    const BITS: usize;

    /// Writes the value, in as many bits as `BITS` says.
    fn write(&self, to: &mut Writer<'_>);

    /// Reads a value; `None` where these bits are none.
    fn read(from: &mut Reader<'_>) -> Option<Self>;

    /// Whether both values would be written down alike. A float that is no number is the same as itself.
    fn is_same(&self, other: &Self) -> bool;

    /// Whether [`word`](Record::word) tells the value.
    #[doc(hidden)]
    const IS_WORD: bool = false;

    /// All bits of the value: comparing it with a word that is kept takes half the instructions of comparing it with a value.
    #[doc(hidden)]
    fn word(&self) -> u32 {
        0
    }
}

impl Record for bool {
    const BITS: usize = 1;
    const IS_WORD: bool = true;

    #[inline]
    fn word(&self) -> u32 {
        u32::from(*self)
    }

    fn write(&self, to: &mut Writer<'_>) {
        to.put(u32::from(*self), 1);
    }

    fn read(from: &mut Reader<'_>) -> Option<Self> {
        Some(from.take(1)? != 0)
    }

    #[inline]
    fn is_same(&self, other: &Self) -> bool {
        self == other
    }
}

/// How many values of a list stand in front of one.
#[doc(hidden)]
pub fn number_in<T: Record>(all: &[T], value: &T) -> u32 {
    all.iter().take_while(|other| !other.is_same(value)).fold(0, |number, _| number + 1)
}

/// Numbers as they are in memory, the lowest byte first.
macro_rules! numbers {
    ($($number:ty as $bits:ty: $to:expr, $from:expr;)*) => {$(
        impl Record for $number {
            const BITS: usize = <$bits>::BITS as usize;
            const IS_WORD: bool = <$bits>::BITS <= 32;

            #[inline]
            #[allow(clippy::cast_possible_truncation, reason = "it is asked for where it fits")]
            #[allow(clippy::cast_lossless, clippy::unnecessary_cast, reason = "of all widths")]
            fn word(&self) -> u32 {
                let bits: $bits = $to(*self);
                bits as u32
            }

            fn write(&self, to: &mut Writer<'_>) {
                let bits: $bits = $to(*self);
                bits.to_le_bytes().into_iter().for_each(|byte| to.put(u32::from(byte), 8));
            }

            fn read(from: &mut Reader<'_>) -> Option<Self> {
                let mut bytes = [0; size_of::<$bits>()];
                for byte in &mut bytes {
                    *byte = u8::try_from(from.take(8)?).ok()?;
                }
                $from(<$bits>::from_le_bytes(bytes))
            }

            #[inline]
            fn is_same(&self, other: &Self) -> bool {
                $to(*self) == $to(*other)
            }
        }
    )*};
}

numbers! {
    u8 as u8: |n| n, Some;
    u16 as u16: |n| n, Some;
    u32 as u32: |n| n, Some;
    u64 as u64: |n| n, Some;
    u128 as u128: |n| n, Some;
    i8 as u8: |n: i8| u8::from_le_bytes(n.to_le_bytes()), |n: u8| Some(i8::from_le_bytes(n.to_le_bytes()));
    i16 as u16: |n: i16| u16::from_le_bytes(n.to_le_bytes()), |n: u16| Some(i16::from_le_bytes(n.to_le_bytes()));
    i32 as u32: |n: i32| u32::from_le_bytes(n.to_le_bytes()), |n: u32| Some(i32::from_le_bytes(n.to_le_bytes()));
    i64 as u64: |n: i64| u64::from_le_bytes(n.to_le_bytes()), |n: u64| Some(i64::from_le_bytes(n.to_le_bytes()));
    i128 as u128: |n: i128| u128::from_le_bytes(n.to_le_bytes()), |n: u128| Some(i128::from_le_bytes(n.to_le_bytes()));
    f32 as u32: f32::to_bits, |n| Some(f32::from_bits(n));
    f64 as u64: f64::to_bits, |n| Some(f64::from_bits(n));
    char as u32: u32::from, char::from_u32;
    Ticks as u32: Ticks::get, |n| Some(Ticks::new(n));
    // As wide as on the widest machine, so that a record means the same everywhere.
    usize as u64: |n| n as u64, |n| usize::try_from(n).ok();
    isize as u64: |n: isize| u64::from_le_bytes((n as i64).to_le_bytes()), |n: u64| isize::try_from(i64::from_le_bytes(n.to_le_bytes())).ok();
}

impl Record for () {
    const BITS: usize = 0;

    fn write(&self, _: &mut Writer<'_>) {}

    fn read(_: &mut Reader<'_>) -> Option<Self> {
        Some(())
    }

    #[inline]
    fn is_same(&self, (): &Self) -> bool {
        true
    }
}

/// At least one of them: nothing cannot be told from what is missing.
impl<T: Record, const N: usize> Record for [T; N] {
    const BITS: usize = T::BITS * N;

    fn write(&self, to: &mut Writer<'_>) {
        for one in self {
            one.write(to);
        }
    }

    fn read(from: &mut Reader<'_>) -> Option<Self> {
        let read = [(); N].map(|()| T::read(from));
        let first = (*read.first()?)?;
        read.iter().all(Option::is_some).then(|| read.map(|one| one.unwrap_or(first)))
    }

    fn is_same(&self, other: &Self) -> bool {
        self.iter().zip(other).all(|(one, other)| one.is_same(other))
    }
}

/// As wide with a value as without one.
impl<T: Record> Record for Option<T> {
    const BITS: usize = 1 + T::BITS;

    fn write(&self, to: &mut Writer<'_>) {
        self.is_some().write(to);
        match self {
            Some(value) => value.write(to),
            None => to.skip(T::BITS),
        }
    }

    fn read(from: &mut Reader<'_>) -> Option<Self> {
        if bool::read(from)? { T::read(from).map(Some) } else { from.is_empty(T::BITS).then_some(None) }
    }

    fn is_same(&self, other: &Self) -> bool {
        match (self, other) {
            (Some(one), Some(other)) => one.is_same(other),
            (one, other) => one.is_some() == other.is_some(),
        }
    }
}

macro_rules! tuples {
    ($(($($name:ident $field:tt)*))*) => {$(
        impl<$($name: Record),*> Record for ($($name,)*) {
            const BITS: usize = 0 $(+ $name::BITS)*;

            fn write(&self, to: &mut Writer<'_>) {
                $(self.$field.write(to);)*
            }

            fn read(from: &mut Reader<'_>) -> Option<Self> {
                Some(($($name::read(from)?,)*))
            }

            fn is_same(&self, other: &Self) -> bool {
                true $(&& self.$field.is_same(&other.$field))*
            }
        }
    )*};
}

tuples! { (A 0) (A 0 B 1) (A 0 B 1 C 2) (A 0 B 1 C 2 D 3) }

/// Says how values of a type of yours are recorded.
///
/// - An enum without fields, by its variants, which are numbered in this order: `grafcet::recordable! { Mode { Off, Auto, Manual } }`.
/// - Any `Copy` type with `Serialize` and `Deserialize`, as `serde` writes it in the format of `postcard` (feature `postcard`):
///   `grafcet::recordable! { Target as serde in 6 bytes }`, with the most bytes that a value takes.
#[macro_export]
macro_rules! recordable {
    ($name:ty as serde in $bytes:tt bytes $(,)?) => {
        $crate::__recordable_by_serde! { $name, $bytes }
    };
    ($name:ty { $($variant:ident),* $(,)? }) => {
        impl $crate::record::Record for $name {
            const BITS: $crate::record::names::usize = $crate::record::bits_for([$(<$name>::$variant),*].len());

            fn write(&self, to_: &mut $crate::record::Writer<'_>) {
                // A variant that is not listed is an error here.
                match self { $(<$name>::$variant => {})* }
                to_.put($crate::record::names::number_in(&[$(<$name>::$variant),*], self), Self::BITS);
            }

            fn read(from_: &mut $crate::record::Reader<'_>) -> $crate::record::names::Option<Self> {
                let index_ = from_.take(Self::BITS)?;
                <[_]>::get(&[$(<$name>::$variant),*], index_ as $crate::record::names::usize).copied()
            }

            fn is_same(&self, other_: &Self) -> $crate::record::names::bool {
                $crate::record::names::discriminant(self) == $crate::record::names::discriminant(other_)
            }
        }
    };
}

/// The feature is asked for here: a macro that is used elsewhere would ask for a feature of the program.
#[cfg(not(feature = "postcard"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __recordable_by_serde {
    ($name:ty, $bytes:tt) => {
        ::core::compile_error! {
            "recording what `serde` writes needs the feature `postcard`: `grafcet = { …, features = [\"postcard\"] }`"
        }
    };
}
