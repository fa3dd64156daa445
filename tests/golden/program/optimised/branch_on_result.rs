// Recorded by `cargo xtask bless`: state and cycle of the program, without the facade's path.

pub struct Sorter {
    situation: __SorterState,
    z: bool,
    params: SorterParams,
}
impl Sorter {
    pub const fn new() -> Self {
        Self::with_params(SorterParams::new())
    }
    pub const fn with_params(params: SorterParams) -> Self {
        Self {
            situation: __SorterState::INIT,
            z: false,
            params,
        }
    }
}
impl Sorter {
    pub fn cycle(&mut self, inputs: &SorterInputs) -> SorterOutputs {
        let mut outputs = const {
            SorterOutputs {
                feed: false,
                keep: false,
                reject: false,
            }
        };
        let after: __SorterState;
        match self.situation {
            __SorterState::INIT => {
                after = __SorterState::Feed;
            }
            __SorterState::Feed => {
                if inputs.piece {
                    after = __SorterState::Measure;
                } else {
                    after = __SorterState::Feed;
                }
            }
            __SorterState::Measure => {
                if self.z {
                    after = __SorterState::Keep;
                } else {
                    after = __SorterState::Reject;
                }
            }
            __SorterState::Keep | __SorterState::Reject => {
                if !inputs.piece {
                    after = __SorterState::Feed;
                } else {
                    after = self.situation;
                }
            }
        }
        self.situation = after;
        match after {
            __SorterState::Feed => {
                outputs.feed = true;
            }
            __SorterState::Measure => {
                self.z = {
                    #[allow(unused_variables)]
                    let length = inputs.length;
                    #[allow(unused_variables)]
                    let nominal = self.params.nominal;
                    #[allow(unused_variables)]
                    let tolerance = self.params.tolerance;
                    length.abs_diff(nominal) <= tolerance
                };
            }
            __SorterState::Keep => {
                outputs.keep = true;
            }
            __SorterState::Reject => {
                outputs.reject = true;
            }
            _ => {}
        }
        outputs
    }
}
