//! The charts that statig can express, as an engineer writes them with it.

include!(concat!(env!("OUT_DIR"), "/statig.rs"));

pub mod motor {
    pub mod sfc {
        use statig::prelude::*;

        pub use crate::signals::motor::{ChartInputs, ChartOutputs};

        pub struct Machine;

        #[state_machine(initial = "State::init()", state(derive(PartialEq)))]
        impl Machine {
            #[state]
            fn init(event: &ChartInputs) -> Outcome<State> {
                _ = event;
                Transition(State::off())
            }

            #[state]
            fn off(event: &ChartInputs) -> Outcome<State> {
                if event.on && !event.over_temp { Transition(State::on()) } else { Handled }
            }

            #[state]
            fn on(event: &ChartInputs) -> Outcome<State> {
                if event.off || event.over_temp { Transition(State::off()) } else { Handled }
            }
        }

        pub struct Chart(InitializedStateMachine<Machine>);

        impl Chart {
            pub fn new() -> Self {
                Self(Machine.uninitialized_state_machine().init())
            }

            pub fn cycle(&mut self, inputs: &ChartInputs) -> ChartOutputs {
                self.0.handle(inputs);
                let on = *self.0.state() == State::On {};
                ChartOutputs { relay: on, green: on, red: !on }
            }
        }

        pub const CYCLE: crate::Cycle<Chart, ChartInputs, ChartOutputs> = Chart::cycle;
    }
}

pub mod line24v {
    pub mod sfc {
        use statig::prelude::*;

        pub use crate::signals::line24v::{ChartInputs, ChartOutputs};

        pub struct Machine {
            q2: bool,
        }

        #[state_machine(initial = "State::init()", state(derive(PartialEq)))]
        impl Machine {
            #[state]
            fn init(event: &ChartInputs) -> Outcome<State> {
                _ = event;
                Transition(State::s1())
            }

            #[state]
            fn s1(event: &ChartInputs) -> Outcome<State> {
                if event.b1 { Transition(State::s2()) } else { Handled }
            }

            #[state(entry_action = "set_q2")]
            fn s2(event: &ChartInputs) -> Outcome<State> {
                if event.b2 { Transition(State::s3()) } else { Handled }
            }

            #[state]
            fn s3(event: &ChartInputs) -> Outcome<State> {
                if event.b3 { Transition(State::s4()) } else { Handled }
            }

            #[state(entry_action = "reset_q2")]
            fn s4(event: &ChartInputs) -> Outcome<State> {
                if event.b4 { Transition(State::s1()) } else { Handled }
            }

            #[action]
            fn set_q2(&mut self) {
                self.q2 = true;
            }

            #[action]
            fn reset_q2(&mut self) {
                self.q2 = false;
            }
        }

        pub struct Chart(InitializedStateMachine<Machine>);

        impl Chart {
            pub fn new() -> Self {
                Self(Machine { q2: false }.uninitialized_state_machine().init())
            }

            pub fn cycle(&mut self, inputs: &ChartInputs) -> ChartOutputs {
                self.0.handle(inputs);
                ChartOutputs {
                    q1: *self.0.state() == State::S1 {},
                    q2: self.0.q2,
                    q3: *self.0.state() == State::S3 {} && inputs.b5,
                }
            }
        }

        pub const CYCLE: crate::Cycle<Chart, ChartInputs, ChartOutputs> = Chart::cycle;
    }
}
