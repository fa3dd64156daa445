// Recorded by `cargo xtask bless`.

/// A motor that can be switched on and off, guarded against over-temperature.
#[cfg_attr(
    doc,
    doc = "\n\n<div style=\"overflow-x:auto\"><svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-4.5 -4.5 232 280\" style=\"width:232px;max-width:max(100%,139px);height:auto\" role=\"img\" aria-label=\"Chart Motor\"><g fill=\"none\" stroke=\"currentColor\"><path d=\"M12 8H60M84 56H100M84 152H100M12 264H60M12 8V264M60 8V40M60 72V136M60 168V264M132 40V72M132 136V200M60 96v16M60 224v16\"/><rect x=\"36\" y=\"40\" width=\"48\" height=\"32\"/><rect x=\"39\" y=\"43\" width=\"42\" height=\"26\"/><rect x=\"100\" y=\"40\" width=\"80\" height=\"32\"/><rect x=\"36\" y=\"136\" width=\"48\" height=\"32\"/><rect x=\"100\" y=\"136\" width=\"96\" height=\"32\"/><rect x=\"100\" y=\"168\" width=\"96\" height=\"32\"/><path d=\"M46 104h28M46 232h28\" stroke-width=\"3\"/></g><g fill=\"currentColor\" font-family=\"monospace\" font-size=\"13\" dominant-baseline=\"central\"><path d=\"M12 131l4 9h-8z\"/><text x=\"48\" y=\"56\" textLength=\"24\">Off</text><text x=\"112\" y=\"56\" textLength=\"8\">N</text><text x=\"144\" y=\"56\" textLength=\"24\">red</text><text x=\"88\" y=\"104\" textLength=\"128\">on &amp;&amp; !over_temp</text><text x=\"52\" y=\"152\" textLength=\"16\">On</text><text x=\"112\" y=\"152\" textLength=\"8\">N</text><text x=\"144\" y=\"152\" textLength=\"40\">relay</text><text x=\"112\" y=\"184\" textLength=\"8\">N</text><text x=\"144\" y=\"184\" textLength=\"40\">green</text><text x=\"88\" y=\"232\" textLength=\"128\">off || over_temp</text></g></svg></div>\n"
)]
/**

The situation takes one byte: which of its 2 steps is active.*/
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::fmt::Debug,
    ::grafcet::__private::core::cmp::PartialEq
)]
pub struct Motor {
    situation: __MotorState,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for Motor {}
impl Motor {
    ///A chart `Motor` in its initial situation; its activation belongs to the first cycle.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            situation: __MotorState::INIT,
        }
    }
}
impl ::grafcet::__private::core::default::Default for Motor {
    fn default() -> Self {
        Self::new()
    }
}
///The process inputs of [`Motor`], sampled once per cycle.
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::fmt::Debug,
    ::grafcet::__private::core::cmp::PartialEq,
    ::grafcet::__private::core::default::Default
)]
pub struct MotorInputs {
    ///Input `on`.
    pub on: ::grafcet::__private::core::primitive::bool,
    ///Input `off`.
    pub off: ::grafcet::__private::core::primitive::bool,
    ///Input `over_temp`.
    pub over_temp: ::grafcet::__private::core::primitive::bool,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for MotorInputs {}
impl MotorInputs {
    /// The default inputs, for constants and statics.
    pub const DEFAULT: Self = Self {
        on: false,
        off: false,
        over_temp: false,
    };
}
///The process outputs of [`Motor`]; `default()` holds the initial values.
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::fmt::Debug,
    ::grafcet::__private::core::cmp::PartialEq,
    ::grafcet::__private::core::default::Default
)]
pub struct MotorOutputs {
    ///Output `relay`.
    pub relay: ::grafcet::__private::core::primitive::bool,
    ///Output `green`.
    pub green: ::grafcet::__private::core::primitive::bool,
    ///Output `red`.
    pub red: ::grafcet::__private::core::primitive::bool,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for MotorOutputs {}
///The names of the steps of [`Motor`].
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::cmp::PartialEq,
    ::grafcet::__private::core::cmp::PartialOrd,
    ::grafcet::__private::core::cmp::Ord,
    ::grafcet::__private::core::hash::Hash
)]
pub enum MotorStep {
    ///Step `Off`.
    Off,
    ///Step `On`.
    On,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for MotorStep {}
impl MotorStep {
    /// The name as it is written.
    #[must_use]
    pub const fn name(self) -> &'static ::grafcet::__private::str {
        ::grafcet::__private::name_at(
            &["Off", "On"],
            self as ::grafcet::__private::usize,
        )
    }
}
#[automatically_derived]
impl ::grafcet::__private::core::fmt::Debug for MotorStep {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        f_.write_str((*self).name())
    }
}
impl ::grafcet::__private::core::fmt::Display for MotorStep {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        f_.pad((*self).name())
    }
}
///The names of the transitions of [`Motor`].
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::cmp::PartialEq,
    ::grafcet::__private::core::cmp::PartialOrd,
    ::grafcet::__private::core::cmp::Ord,
    ::grafcet::__private::core::hash::Hash
)]
pub enum MotorTransition {
    ///`Off -[on && !over_temp]-> On`
    OffToOn,
    ///`On -[off || over_temp]-> Off`
    OnToOff,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for MotorTransition {}
impl MotorTransition {
    /// The name as it is written.
    #[must_use]
    pub const fn name(self) -> &'static ::grafcet::__private::str {
        ::grafcet::__private::name_at(
            &["OffToOn", "OnToOff"],
            self as ::grafcet::__private::usize,
        )
    }
}
#[automatically_derived]
impl ::grafcet::__private::core::fmt::Debug for MotorTransition {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        f_.write_str((*self).name())
    }
}
impl ::grafcet::__private::core::fmt::Display for MotorTransition {
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
enum __MotorState {
    Off,
    On,
    INIT,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for __MotorState {}
#[automatically_derived]
impl ::grafcet::__private::core::fmt::Debug for __MotorState {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        f_.write_str(
            ::grafcet::__private::name_at(
                &["Off", "On", "INIT"],
                *self as ::grafcet::__private::usize,
            ),
        )
    }
}
impl Motor {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    pub fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &MotorInputs,
        #[cfg(doc)]
        inputs: &MotorInputs,
    ) -> MotorOutputs {
        let mut outputs_ = const {
            MotorOutputs {
                relay: false,
                green: false,
                red: false,
            }
        };
        let after_: __MotorState;
        match self.situation {
            __MotorState::INIT => {
                after_ = __MotorState::Off;
            }
            __MotorState::Off => {
                if inputs_.on & !inputs_.over_temp {
                    after_ = __MotorState::On;
                } else {
                    after_ = __MotorState::Off;
                }
            }
            __MotorState::On => {
                if inputs_.off | inputs_.over_temp {
                    after_ = __MotorState::Off;
                } else {
                    after_ = __MotorState::On;
                }
            }
        }
        self.situation = after_;
        match after_ {
            __MotorState::Off => {
                outputs_ = const {
                    MotorOutputs {
                        relay: false,
                        green: false,
                        red: true,
                    }
                };
            }
            __MotorState::On => {
                outputs_ = const {
                    MotorOutputs {
                        relay: true,
                        green: true,
                        red: false,
                    }
                };
            }
            _ => {
                outputs_ = const {
                    MotorOutputs {
                        relay: false,
                        green: false,
                        red: false,
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
        step_: MotorStep,
        #[cfg(doc)]
        step: MotorStep,
    ) -> ::grafcet::__private::bool {
        self.situation() == step_
    }
    /// The active steps, in the order of their declaration; the capacity is the most that can be active.
    #[must_use]
    pub fn active_steps(&self) -> ::grafcet::__private::heapless::Vec<MotorStep, 1> {
        let mut steps_ = ::grafcet::__private::heapless::Vec::new();
        let _ = ::grafcet::__private::heapless::Vec::push(&mut steps_, self.situation());
        steps_
    }
    /// The situation: which steps are active.
    #[must_use]
    pub const fn situation(&self) -> MotorStep {
        match self.situation {
            __MotorState::Off | __MotorState::INIT => MotorStep::Off,
            __MotorState::On => MotorStep::On,
        }
    }
    /// Whether these steps are active, in any order, and no others: the same question for one active step and
    /// for several.
    #[must_use]
    pub fn is_exactly(
        &self,
        #[cfg(not(doc))]
        steps_: &[MotorStep],
        #[cfg(doc)]
        steps: &[MotorStep],
    ) -> ::grafcet::__private::bool {
        ::grafcet::__private::Chart::is_exactly(self, steps_)
    }
}
impl ::grafcet::__private::Chart for Motor {
    type Inputs = MotorInputs;
    type Outputs = MotorOutputs;
    type Step = MotorStep;
    type Transition = MotorTransition;
    type Situation = MotorStep;
    type Actions<'a> = ();
    const NAME: &'static ::grafcet::__private::str = "Motor";
    const STEPS: &'static [MotorStep] = &[MotorStep::Off, MotorStep::On];
    const TRANSITIONS: &'static [MotorTransition] = &[
        MotorTransition::OffToOn,
        MotorTransition::OnToOff,
    ];
    fn scan(
        &mut self,
        inputs_: &MotorInputs,
        _: ::grafcet::__private::Ticks,
        _: &mut Self::Actions<'_>,
    ) -> MotorOutputs {
        self.cycle(inputs_)
    }
    fn init(&mut self) {
        self.init();
    }
    fn is_active(&self, step_: MotorStep) -> ::grafcet::__private::bool {
        self.is_active(step_)
    }
    fn situation(&self) -> MotorStep {
        self.situation()
    }
}
impl Motor {
    /// What the chart looks like: its steps, transitions and actions as they stand in the source.
    pub const CHART: ::grafcet::__private::description::Description<'static> = ::grafcet::__private::description::table::Described::<
        Motor,
        3,
        0,
        4,
        1,
        0,
        2,
        2,
        0,
    >::sfc();
}
impl ::grafcet::__private::description::table::Tables for Motor {
    const TEXTS: &'static [&'static ::grafcet::__private::str] = &[
        "",
        "Motor",
        "N",
        "Off",
        "On",
        "green",
        "off || over_temp",
        "on && !over_temp",
        "red",
        "relay",
    ];
    const NUMBERS: &'static [::grafcet::__private::u8] = b"\x02\0\0\x08\x02\0\0\t\x02\0\0\x05\0\x01\x01\0\x01\0\0\0\x03\x01\0\0\x01\0\0\x04\0\0\0\x02\0\0\0\x07\x01\x01\0\0\0\x06\x01\x01\0\0";
}
impl ::grafcet::__private::ActiveSteps for MotorStep {
    fn is_active_at(
        &self,
        step_: ::grafcet::__private::usize,
    ) -> ::grafcet::__private::bool {
        match ::grafcet::__private::step_at::<Motor>(step_) {
            ::grafcet::__private::Option::Some(active_) => active_ == *self,
            ::grafcet::__private::Option::None => false,
        }
    }
}
#[allow(unexpected_cfgs)]
const _: () = {
    #[cfg(rust_analyzer)]
    fn mentions(inputs_: &MotorInputs, outputs_: &MotorOutputs) {
        let _ = [MotorStep::Off, MotorStep::On, MotorStep::Off];
        let _ = (&inputs_.on, &inputs_.over_temp, &inputs_.off, &inputs_.over_temp);
        let _ = (&outputs_.red, &outputs_.relay, &outputs_.green);
    }
};
