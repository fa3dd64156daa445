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
    pub const fn with_params(
        #[cfg(not(doc))]
        params_: SorterParams,
        #[cfg(doc)]
        params: SorterParams,
    ) -> Self {
        #[cfg(doc)]
        let params_ = params;
        Self {
            situation: __SorterState::INIT,
            z: false,
            params: params_,
        }
    }
}
impl Sorter {
    pub fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &SorterInputs,
        #[cfg(doc)]
        inputs: &SorterInputs,
    ) -> SorterOutputs {
        let mut outputs_ = const {
            SorterOutputs {
                feed: false,
                keep: false,
                reject: false,
            }
        };
        let after_: __SorterState;
        match self.situation {
            __SorterState::INIT => {
                after_ = __SorterState::Feed;
            }
            __SorterState::Feed => {
                if inputs_.piece {
                    after_ = __SorterState::Measure;
                } else {
                    after_ = __SorterState::Feed;
                }
            }
            __SorterState::Measure => {
                if self.z {
                    after_ = __SorterState::Keep;
                } else {
                    after_ = __SorterState::Reject;
                }
            }
            __SorterState::Keep | __SorterState::Reject => {
                if !inputs_.piece {
                    after_ = __SorterState::Feed;
                } else {
                    after_ = self.situation;
                }
            }
        }
        self.situation = after_;
        match after_ {
            __SorterState::Feed => {
                outputs_.feed = true;
            }
            __SorterState::Measure => {
                self.z = {
                    #[allow(unused_variables)]
                    let length = inputs_.length;
                    #[allow(unused_variables)]
                    let nominal = self.params.nominal;
                    #[allow(unused_variables)]
                    let tolerance = self.params.tolerance;
                    length.abs_diff(nominal) <= tolerance
                };
            }
            __SorterState::Keep => {
                outputs_.keep = true;
            }
            __SorterState::Reject => {
                outputs_.reject = true;
            }
            _ => {}
        }
        outputs_
    }
}
