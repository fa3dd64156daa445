// Recorded by `cargo xtask bless`.

///The process inputs of [`Motor`], sampled once per cycle.
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::fmt::Debug,
    ::grafcet::__private::core::cmp::PartialEq,
    ::grafcet::__private::core::cmp::Eq,
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
///The process outputs of [`Motor`]; `default()` holds the initial values.
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::fmt::Debug,
    ::grafcet::__private::core::cmp::PartialEq,
    ::grafcet::__private::core::cmp::Eq,
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
///The names of the steps of [`Motor`].
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::cmp::PartialEq,
    ::grafcet::__private::core::cmp::Eq,
    ::grafcet::__private::core::cmp::PartialOrd,
    ::grafcet::__private::core::cmp::Ord,
    ::grafcet::__private::core::hash::Hash,
    ::grafcet::__private::core::fmt::Debug,
)]
pub enum MotorStep {
    ///Step `Off`.
    Off,
    ///Step `On`.
    On,
}
///The names of the transitions of [`Motor`].
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::cmp::PartialEq,
    ::grafcet::__private::core::cmp::Eq,
    ::grafcet::__private::core::cmp::PartialOrd,
    ::grafcet::__private::core::cmp::Ord,
    ::grafcet::__private::core::hash::Hash,
    ::grafcet::__private::core::fmt::Debug,
)]
pub enum MotorTransition {
    ///`Off -[on && !over_temp]-> On`
    OffToOn,
    ///`On -[off || over_temp]-> Off`
    OnToOff,
}
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::cmp::PartialEq,
    ::grafcet::__private::core::cmp::Eq,
    ::grafcet::__private::core::fmt::Debug,
)]
#[doc(hidden)]
enum __MotorState {
    Off,
    On,
    INIT,
}
/// A motor that can be switched on and off, guarded against over-temperature.
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::fmt::Debug,
    ::grafcet::__private::core::cmp::PartialEq,
    ::grafcet::__private::core::cmp::Eq
)]
pub struct Motor {
    situation: __MotorState,
}
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
impl Motor {
    /// One cycle: evaluates the transition conditions on `inputs`, clears, acts, and returns the outputs of the new
    /// situation.
    pub fn cycle(&mut self, inputs: &MotorInputs) -> MotorOutputs {
        let mut outputs = MotorOutputs {
            relay: false,
            green: false,
            red: false,
        };
        let before = self.situation;
        let after = match before {
            __MotorState::Off => {
                if {
                    let on = inputs.on;
                    let over_temp = inputs.over_temp;
                    on && !over_temp
                } {
                    __MotorState::On
                } else {
                    __MotorState::Off
                }
            }
            __MotorState::On => {
                if {
                    let off = inputs.off;
                    let over_temp = inputs.over_temp;
                    off || over_temp
                } {
                    __MotorState::Off
                } else {
                    __MotorState::On
                }
            }
            __MotorState::INIT => __MotorState::Off,
        };
        self.situation = after;
        match after {
            __MotorState::Off => {
                outputs.red = true;
            }
            __MotorState::On => {
                outputs.relay = true;
                outputs.green = true;
            }
            _ => {}
        }
        outputs
    }
    /// Back to the initial situation (the classic *Init*), stored outputs and variables reset; the next cycle is a
    /// first one.
    pub fn init(&mut self) {
        *self = Self::new();
    }
    /// Whether `step` is active.
    #[must_use]
    pub fn is_active(&self, step: MotorStep) -> ::grafcet::__private::bool {
        self.situation() == step
    }
    /// The active steps, in the order of their declaration; the capacity is the most that can be active.
    #[must_use]
    pub fn active_steps(&self) -> ::grafcet::__private::heapless::Vec<MotorStep, 1> {
        let mut steps = ::grafcet::__private::heapless::Vec::new();
        let _ = steps.push(self.situation());
        steps
    }
    /// The situation: which steps are active.
    #[must_use]
    pub const fn situation(&self) -> MotorStep {
        match self.situation {
            __MotorState::Off | __MotorState::INIT => MotorStep::Off,
            __MotorState::On => MotorStep::On,
        }
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
        inputs: &MotorInputs,
        _now: ::grafcet::__private::Ticks,
        _actions: &mut Self::Actions<'_>,
    ) -> MotorOutputs {
        self.cycle(inputs)
    }
    fn init(&mut self) {
        self.init();
    }
    fn is_active(&self, step: MotorStep) -> ::grafcet::__private::bool {
        self.is_active(step)
    }
    fn situation(&self) -> MotorStep {
        self.situation()
    }
}
