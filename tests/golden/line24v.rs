// Recorded by `cargo xtask bless`.

/// The 24 V production line.
#[cfg_attr(
    doc,
    doc = "\n\n<div style=\"overflow-x:auto\"><svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-4.5 -4.5 232 456\" style=\"width:232px;max-width:max(100%,139px);height:auto\" role=\"img\" aria-label=\"Chart Line24V\"><g fill=\"none\" stroke=\"currentColor\"><path d=\"M12 8H60M84 56H100M84 152H100M84 264H100M84 360H100M12 440H60M12 8V440M60 8V40M60 72V136M60 168V248M60 280V344M60 376V440M116 232V248M132 136V168M132 344V376M60 96v16M60 192v16M60 304v16M60 400v16\"/><rect x=\"36\" y=\"40\" width=\"48\" height=\"32\"/><rect x=\"39\" y=\"43\" width=\"42\" height=\"26\"/><rect x=\"100\" y=\"40\" width=\"40\" height=\"32\"/><rect x=\"36\" y=\"136\" width=\"48\" height=\"32\"/><rect x=\"100\" y=\"136\" width=\"112\" height=\"32\"/><rect x=\"36\" y=\"248\" width=\"48\" height=\"32\"/><rect x=\"100\" y=\"248\" width=\"40\" height=\"32\"/><rect x=\"36\" y=\"344\" width=\"48\" height=\"32\"/><rect x=\"100\" y=\"344\" width=\"112\" height=\"32\"/><path d=\"M46 104h28M46 200h28M46 312h28M46 408h28\" stroke-width=\"3\"/></g><g fill=\"currentColor\" font-family=\"monospace\" font-size=\"13\" dominant-baseline=\"central\"><path d=\"M12 195l4 9h-8z\"/><text x=\"52\" y=\"56\" textLength=\"16\">S1</text><text x=\"112\" y=\"56\" textLength=\"16\">q1</text><text x=\"88\" y=\"104\" textLength=\"16\">b1</text><text x=\"52\" y=\"152\" textLength=\"16\">S2</text><text x=\"112\" y=\"152\" textLength=\"8\">↑</text><text x=\"144\" y=\"152\" textLength=\"56\">q2 := 1</text><text x=\"88\" y=\"200\" textLength=\"16\">b2</text><text x=\"52\" y=\"264\" textLength=\"16\">S3</text><text x=\"128\" y=\"232\" textLength=\"16\">b5</text><text x=\"112\" y=\"264\" textLength=\"16\">q3</text><text x=\"88\" y=\"312\" textLength=\"16\">b3</text><text x=\"52\" y=\"360\" textLength=\"16\">S4</text><text x=\"112\" y=\"360\" textLength=\"8\">↑</text><text x=\"144\" y=\"360\" textLength=\"56\">q2 := 0</text><text x=\"88\" y=\"408\" textLength=\"16\">b4</text></g></svg></div>\n"
)]
/**

The situation takes one byte: which of its 4 steps is active.*/
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::fmt::Debug,
    ::grafcet::__private::core::cmp::PartialEq
)]
pub struct Line24V {
    situation: __Line24VStateMark,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for Line24V {}
impl Line24V {
    ///A chart `Line24V` in its initial situation; its activation belongs to the first cycle.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            situation: __Line24VStateMark::of(__Line24VState::S1),
        }
    }
}
impl ::grafcet::__private::core::default::Default for Line24V {
    fn default() -> Self {
        Self::new()
    }
}
///The process inputs of [`Line24V`], sampled once per cycle.
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::fmt::Debug,
    ::grafcet::__private::core::cmp::PartialEq,
    ::grafcet::__private::core::default::Default
)]
pub struct Line24VInputs {
    ///Input `b1`.
    pub b1: ::grafcet::__private::core::primitive::bool,
    ///Input `b2`.
    pub b2: ::grafcet::__private::core::primitive::bool,
    ///Input `b3`.
    pub b3: ::grafcet::__private::core::primitive::bool,
    ///Input `b4`.
    pub b4: ::grafcet::__private::core::primitive::bool,
    ///Input `b5`.
    pub b5: ::grafcet::__private::core::primitive::bool,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for Line24VInputs {}
impl Line24VInputs {
    /// The default inputs, for constants and statics.
    pub const DEFAULT: Self = Self {
        b1: false,
        b2: false,
        b3: false,
        b4: false,
        b5: false,
    };
}
///The process outputs of [`Line24V`]; `default()` holds the initial values.
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::fmt::Debug,
    ::grafcet::__private::core::cmp::PartialEq,
    ::grafcet::__private::core::default::Default
)]
pub struct Line24VOutputs {
    ///Output `q1`.
    pub q1: ::grafcet::__private::core::primitive::bool,
    ///Output `q2`.
    pub q2: ::grafcet::__private::core::primitive::bool,
    ///Output `q3`.
    pub q3: ::grafcet::__private::core::primitive::bool,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for Line24VOutputs {}
///The names of the steps of [`Line24V`].
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::cmp::PartialEq,
    ::grafcet::__private::core::cmp::PartialOrd,
    ::grafcet::__private::core::cmp::Ord,
    ::grafcet::__private::core::hash::Hash
)]
pub enum Line24VStep {
    ///Step `S1`.
    S1,
    ///Step `S2`.
    S2,
    ///Step `S3`.
    S3,
    ///Step `S4`.
    S4,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for Line24VStep {}
impl Line24VStep {
    /// The name as it is written.
    #[must_use]
    pub const fn name(self) -> &'static ::grafcet::__private::str {
        ::grafcet::__private::name_at(
            &["S1", "S2", "S3", "S4"],
            self as ::grafcet::__private::usize,
        )
    }
}
#[automatically_derived]
impl ::grafcet::__private::core::fmt::Debug for Line24VStep {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        f_.write_str((*self).name())
    }
}
impl ::grafcet::__private::core::fmt::Display for Line24VStep {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        f_.pad((*self).name())
    }
}
///The names of the transitions of [`Line24V`].
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::cmp::PartialEq,
    ::grafcet::__private::core::cmp::PartialOrd,
    ::grafcet::__private::core::cmp::Ord,
    ::grafcet::__private::core::hash::Hash
)]
pub enum Line24VTransition {
    ///`S1 -[b1]-> S2`
    S1ToS2,
    ///`S2 -[b2]-> S3`
    S2ToS3,
    ///`S3 -[b3]-> S4`
    S3ToS4,
    ///`S4 -[b4]-> S1`
    S4ToS1,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for Line24VTransition {}
impl Line24VTransition {
    /// The name as it is written.
    #[must_use]
    pub const fn name(self) -> &'static ::grafcet::__private::str {
        ::grafcet::__private::name_at(
            &["S1ToS2", "S2ToS3", "S3ToS4", "S4ToS1"],
            self as ::grafcet::__private::usize,
        )
    }
}
#[automatically_derived]
impl ::grafcet::__private::core::fmt::Debug for Line24VTransition {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        f_.write_str((*self).name())
    }
}
impl ::grafcet::__private::core::fmt::Display for Line24VTransition {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        f_.pad((*self).name())
    }
}
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::cmp::PartialEq
)]
#[doc(hidden)]
#[repr(u32)]
enum __Line24VState {
    S1,
    S2,
    S3,
    S4,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for __Line24VState {}
#[automatically_derived]
impl ::grafcet::__private::core::fmt::Debug for __Line24VState {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        f_.write_str(
            ::grafcet::__private::name_at(
                &["S1", "S2", "S3", "S4"],
                *self as ::grafcet::__private::usize,
            ),
        )
    }
}
/// A state, and above it the mark of a search that did not become stable.
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::cmp::PartialEq,
    ::grafcet::__private::core::fmt::Debug
)]
#[doc(hidden)]
struct __Line24VStateMark(::grafcet::__private::u8);
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for __Line24VStateMark {}
impl __Line24VStateMark {
    const fn of(state_: __Line24VState) -> Self {
        Self(state_ as ::grafcet::__private::u8)
    }
    const fn state(self) -> __Line24VState {
        let number_ = self.0 & 3u8;
        if number_ >= 3u8 {
            __Line24VState::S4
        } else {
            match number_ {
                0u8 => __Line24VState::S1,
                1u8 => __Line24VState::S2,
                _ => __Line24VState::S3,
            }
        }
    }
    /// Another state, and the mark as it is.
    const fn with(self, state_: __Line24VState) -> Self {
        Self(self.0 & 4u8 | state_ as ::grafcet::__private::u8)
    }
    const fn unmarked(self) -> Self {
        Self(self.0 & 3u8)
    }
    const fn marked(self) -> Self {
        Self(self.0 | 4u8)
    }
    const fn is_marked(self) -> ::grafcet::__private::bool {
        self.0 & 4u8 != 0
    }
}
impl Line24V {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    pub fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &Line24VInputs,
        #[cfg(doc)]
        inputs: &Line24VInputs,
    ) -> Line24VOutputs {
        let mut outputs_ = const {
            Line24VOutputs {
                q1: false,
                q2: false,
                q3: false,
            }
        };
        let mut now_state_: __Line24VState = self.situation.state();
        self.situation = __Line24VStateMark::of(now_state_);
        self.situation = self.situation.unmarked();
        let mut evolutions_: ::grafcet::__private::u32 = 0;
        loop {
            let inputs_ = ::grafcet::__private::core::hint::black_box(inputs_);
            ::grafcet::__private::fence_on_armv6m();
            match now_state_ {
                __Line24VState::S1 => {
                    if inputs_.b1 {
                        now_state_ = __Line24VState::S2;
                    } else {
                        break;
                    }
                }
                __Line24VState::S2 => {
                    if inputs_.b2 {
                        now_state_ = __Line24VState::S3;
                    } else {
                        break;
                    }
                }
                __Line24VState::S3 => {
                    if inputs_.b3 {
                        now_state_ = __Line24VState::S4;
                    } else {
                        break;
                    }
                }
                __Line24VState::S4 => {
                    if inputs_.b4 {
                        now_state_ = __Line24VState::S1;
                    } else {
                        break;
                    }
                }
            }
            self.situation = __Line24VStateMark::of(now_state_);
            self.situation = self.situation.unmarked();
            evolutions_ = evolutions_.wrapping_add(1);
            if evolutions_ == 10 {
                self.situation = self.situation.marked();
                break;
            }
        }
        ::grafcet::__private::core::sync::atomic::compiler_fence(
            ::grafcet::__private::core::sync::atomic::Ordering::SeqCst,
        );
        match self.situation.state() {
            __Line24VState::S1 => {
                outputs_ = const {
                    Line24VOutputs {
                        q1: true,
                        q2: false,
                        q3: false,
                    }
                };
            }
            __Line24VState::S2 => {
                outputs_ = const {
                    Line24VOutputs {
                        q1: false,
                        q2: true,
                        q3: false,
                    }
                };
            }
            __Line24VState::S3 => {
                outputs_ = const {
                    Line24VOutputs {
                        q1: false,
                        q2: true,
                        q3: false,
                    }
                };
                outputs_.q3 = inputs_.b5;
            }
            _ => {
                outputs_ = const {
                    Line24VOutputs {
                        q1: false,
                        q2: false,
                        q3: false,
                    }
                };
            }
        }
        outputs_
    }
    /// Back to the initial situation (the classic *Init*), stored outputs and variables reset; the next cycle is a
    /// first one.
    pub fn init(&mut self) {
        *self = Self::new();
    }
    /// Whether the step is active.
    #[must_use]
    pub fn is_active(
        &self,
        #[cfg(not(doc))]
        step_: Line24VStep,
        #[cfg(doc)]
        step: Line24VStep,
    ) -> ::grafcet::__private::bool {
        self.situation() == step_
    }
    /// The active steps, in the order of their declaration; the capacity is the most that can be active.
    #[must_use]
    pub fn active_steps(&self) -> ::grafcet::__private::heapless::Vec<Line24VStep, 1> {
        let mut steps_ = ::grafcet::__private::heapless::Vec::new();
        let _ = ::grafcet::__private::heapless::Vec::push(&mut steps_, self.situation());
        steps_
    }
    /// The situation: which steps are active.
    #[must_use]
    pub const fn situation(&self) -> Line24VStep {
        match self.situation.state() {
            __Line24VState::S1 => Line24VStep::S1,
            __Line24VState::S2 => Line24VStep::S2,
            __Line24VState::S3 => Line24VStep::S3,
            __Line24VState::S4 => Line24VStep::S4,
        }
    }
    /// Whether these steps are active, in any order, and no others: the same question for one active step and
    /// for several.
    #[must_use]
    pub fn is_exactly(
        &self,
        #[cfg(not(doc))]
        steps_: &[Line24VStep],
        #[cfg(doc)]
        steps: &[Line24VStep],
    ) -> ::grafcet::__private::bool {
        ::grafcet::__private::Chart::is_exactly(self, steps_)
    }
    /// Whether the last cycle reached a stable situation. If not, it stopped after the most evolutions it may make
    /// and keeps the situation it had reached (decision A30).
    #[must_use]
    pub const fn is_stable(&self) -> ::grafcet::__private::bool {
        !self.situation.is_marked()
    }
}
impl ::grafcet::__private::Chart for Line24V {
    type Inputs = Line24VInputs;
    type Outputs = Line24VOutputs;
    type Step = Line24VStep;
    type Transition = Line24VTransition;
    type Situation = Line24VStep;
    type Actions<'a> = ();
    const NAME: &'static ::grafcet::__private::str = "Line24V";
    const STEPS: &'static [Line24VStep] = &[
        Line24VStep::S1,
        Line24VStep::S2,
        Line24VStep::S3,
        Line24VStep::S4,
    ];
    const TRANSITIONS: &'static [Line24VTransition] = &[
        Line24VTransition::S1ToS2,
        Line24VTransition::S2ToS3,
        Line24VTransition::S3ToS4,
        Line24VTransition::S4ToS1,
    ];
    fn scan(
        &mut self,
        inputs_: &Line24VInputs,
        _: ::grafcet::__private::Ticks,
        _: &mut Self::Actions<'_>,
    ) -> Line24VOutputs {
        self.cycle(inputs_)
    }
    fn init(&mut self) {
        self.init();
    }
    fn is_active(&self, step_: Line24VStep) -> ::grafcet::__private::bool {
        self.is_active(step_)
    }
    fn situation(&self) -> Line24VStep {
        self.situation()
    }
}
impl Line24V {
    /// What the chart looks like: its steps, transitions and actions as they stand in the source.
    pub const CHART: ::grafcet::__private::description::Description<'static> = ::grafcet::__private::description::table::Described::<
        Line24V,
        4,
        0,
        8,
        1,
        0,
        4,
        4,
        0,
    >::grafcet();
}
impl ::grafcet::__private::description::table::Tables for Line24V {
    const TEXTS: &'static [&'static ::grafcet::__private::str] = &[
        "",
        "Line24V",
        "N",
        "R",
        "S",
        "S1",
        "S2",
        "S3",
        "S4",
        "b1",
        "b2",
        "b3",
        "b4",
        "b5",
        "q1",
        "q2",
        "q3",
    ];
    const NUMBERS: &'static [::grafcet::__private::u8] = b"\x02\0\0\x0E\x04\0\0\x0F\x02\0\r\x10\x03\0\0\x0F\0\x01\x01\x02\x02\x03\x03\0\x01\0\0\0\x05\x01\0\0\x01\0\0\x06\0\0\0\x01\0\0\x07\0\0\0\x01\0\0\x08\0\0\0\x01\0\0\0\t\x01\x01\0\0\0\n\x01\x01\0\0\0\x0B\x01\x01\0\0\0\x0C\x01\x01\0\0";
}
impl ::grafcet::__private::ActiveSteps for Line24VStep {
    fn is_active_at(
        &self,
        step_: ::grafcet::__private::usize,
    ) -> ::grafcet::__private::bool {
        match ::grafcet::__private::step_at::<Line24V>(step_) {
            ::grafcet::__private::Option::Some(active_) => active_ == *self,
            ::grafcet::__private::Option::None => false,
        }
    }
}
#[allow(unexpected_cfgs)]
const _: () = {
    #[cfg(rust_analyzer)]
    fn mentions(inputs_: &Line24VInputs, outputs_: &Line24VOutputs) {
        let _ = [
            Line24VStep::S1,
            Line24VStep::S2,
            Line24VStep::S3,
            Line24VStep::S4,
            Line24VStep::S1,
        ];
        let _ = (&inputs_.b5, &inputs_.b1, &inputs_.b2, &inputs_.b3, &inputs_.b4);
        let _ = (&outputs_.q1, &outputs_.q2, &outputs_.q3, &outputs_.q2);
    }
};
