// Recorded by `cargo xtask bless`: state and cycle of the program, without the facade's path.

pub struct Sorter {
    state: __SorterState,
    z: bool,
    params: SorterParams,
}
impl Sorter {
    pub const fn new() -> Self {
        Self::with_params(SorterParams::new())
    }
    pub const fn with_params(params: SorterParams) -> Self {
        Self {
            state: __SorterState::INIT,
            z: false,
            params,
        }
    }
}
impl Sorter {
    pub fn cycle(&mut self, inputs: &SorterInputs) -> SorterOutputs {
        let mut outputs = SorterOutputs {
            feed: false,
            keep: false,
            reject: false,
        };
        match self.state {
            __SorterState::INIT => {
                self.state = __SorterState::Feed;
            }
            __SorterState::Feed => {
                if inputs.piece {
                    self.state = __SorterState::Measure;
                }
            }
            __SorterState::Measure => {
                if self.z {
                    self.state = __SorterState::Keep;
                } else {
                    self.state = __SorterState::Reject;
                }
            }
            __SorterState::Keep => {
                if !inputs.piece {
                    self.state = __SorterState::Feed;
                }
            }
            __SorterState::Reject => {
                if !inputs.piece {
                    self.state = __SorterState::Feed;
                }
            }
        }
        match self.state {
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
