//! The charts that smlang can express, as an engineer writes them with it.

include!(concat!(env!("OUT_DIR"), "/smlang.rs"));

pub mod motor {
    pub mod sfc {
        pub use crate::signals::motor::{ChartInputs, ChartOutputs};

        smlang::statemachine! {
            temporary_context: &ChartInputs,
            transitions: {
                *Init + Cycle = Off,
                Off + Cycle [may_run] = On,
                On + Cycle [must_stop] = Off,
            }
        }

        pub struct Context;

        impl StateMachineContext for Context {
            fn may_run(&self, i: &ChartInputs) -> Result<bool, ()> {
                Ok(i.on && !i.over_temp)
            }

            fn must_stop(&self, i: &ChartInputs) -> Result<bool, ()> {
                Ok(i.off || i.over_temp)
            }
        }

        pub struct Chart(StateMachine<Context>);

        impl Chart {
            pub fn new() -> Self {
                Self(StateMachine::new(Context))
            }

            pub fn cycle(&mut self, inputs: &ChartInputs) -> ChartOutputs {
                // A cycle without a transition is none of its errors that matter.
                _ = self.0.process_event(inputs, Events::Cycle);
                let on = *self.0.state() == States::On;
                ChartOutputs { relay: on, green: on, red: !on }
            }
        }

        pub const CYCLE: crate::Cycle<Chart, ChartInputs, ChartOutputs> = Chart::cycle;
    }
}

pub mod line24v {
    pub mod sfc {
        pub use crate::signals::line24v::{ChartInputs, ChartOutputs};

        smlang::statemachine! {
            temporary_context: &ChartInputs,
            transitions: {
                *Init + Cycle = S1,
                S1 + Cycle [b1] / set_q2 = S2,
                S2 + Cycle [b2] = S3,
                S3 + Cycle [b3] / reset_q2 = S4,
                S4 + Cycle [b4] = S1,
            }
        }

        pub struct Context {
            q2: bool,
        }

        impl StateMachineContext for Context {
            fn b1(&self, i: &ChartInputs) -> Result<bool, ()> {
                Ok(i.b1)
            }

            fn b2(&self, i: &ChartInputs) -> Result<bool, ()> {
                Ok(i.b2)
            }

            fn b3(&self, i: &ChartInputs) -> Result<bool, ()> {
                Ok(i.b3)
            }

            fn b4(&self, i: &ChartInputs) -> Result<bool, ()> {
                Ok(i.b4)
            }

            fn set_q2(&mut self, _: &ChartInputs) -> Result<(), ()> {
                self.q2 = true;
                Ok(())
            }

            fn reset_q2(&mut self, _: &ChartInputs) -> Result<(), ()> {
                self.q2 = false;
                Ok(())
            }
        }

        pub struct Chart(StateMachine<Context>);

        impl Chart {
            pub fn new() -> Self {
                Self(StateMachine::new(Context { q2: false }))
            }

            pub fn cycle(&mut self, inputs: &ChartInputs) -> ChartOutputs {
                _ = self.0.process_event(inputs, Events::Cycle);
                let step = self.0.state();
                ChartOutputs { q1: *step == States::S1, q2: self.0.context().q2, q3: *step == States::S3 && inputs.b5 }
            }
        }

        pub const CYCLE: crate::Cycle<Chart, ChartInputs, ChartOutputs> = Chart::cycle;
    }
}
