// Recorded by `cargo xtask bless`: state and cycle of the program, without the facade's path.

pub struct Sorter {
    first: bool,
    situation: __SorterState,
    feed: bool,
    keep: bool,
    reject: bool,
    z: bool,
    params: SorterParams,
}
impl Sorter {
    pub const fn new() -> Self {
        Self::with_params(SorterParams::new())
    }
    pub const fn with_params(params: SorterParams) -> Self {
        Self {
            first: true,
            situation: __SorterState::Feed,
            feed: false,
            keep: false,
            reject: false,
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
        let was_state: __SorterState = self.situation;
        let entered_feed: bool;
        let mut entered_measure: bool = false;
        if self.first {
            entered_feed = true;
        } else {
            let clears_feed_measure: bool = was_state
                == __SorterState::Feed && inputs.piece;
            let clears_measure_keep: bool = was_state
                == __SorterState::Measure
                && ({
                    let z = self.z;
                    z
                });
            let clears_keep_feed: bool = was_state
                == __SorterState::Keep && (!inputs.piece);
            let clears_measure_reject: bool = was_state
                == __SorterState::Measure && !clears_measure_keep
                && ({
                    let z = self.z;
                    !z
                });
            let clears_reject_feed: bool = was_state
                == __SorterState::Reject && (!inputs.piece);
            let left_feed: bool = clears_feed_measure;
            let left_measure: bool = clears_measure_keep
                || clears_measure_reject;
            let left_keep: bool = clears_keep_feed;
            let left_reject: bool = clears_reject_feed;
            entered_feed = (clears_keep_feed || clears_reject_feed)
                && !(was_state == __SorterState::Feed && !left_feed);
            entered_measure = clears_feed_measure
                && !(was_state == __SorterState::Measure && !left_measure);
            let entered_keep: bool = clears_measure_keep
                && !(was_state == __SorterState::Keep && !left_keep);
            let entered_reject: bool = clears_measure_reject
                && !(was_state == __SorterState::Reject && !left_reject);
            if left_feed {
                self.situation = __SorterState::NONE;
            }
            if left_measure {
                self.situation = __SorterState::NONE;
            }
            if left_keep {
                self.situation = __SorterState::NONE;
            }
            if left_reject {
                self.situation = __SorterState::NONE;
            }
            if entered_feed {
                self.situation = __SorterState::Feed;
            }
            if entered_measure {
                self.situation = __SorterState::Measure;
            }
            if entered_keep {
                self.situation = __SorterState::Keep;
            }
            if entered_reject {
                self.situation = __SorterState::Reject;
            }
        }
        let on_feed_0_: bool = self.situation
            == __SorterState::Feed;
        let on_measure_1_: bool = entered_measure;
        let on_keep_2_: bool = self.situation
            == __SorterState::Keep;
        let on_reject_3_: bool = self.situation
            == __SorterState::Reject;
        let q_feed: bool = on_feed_0_;
        let q_measure_1_: bool = false;
        let q_keep: bool = on_keep_2_;
        let q_reject: bool = on_reject_3_;
        if on_measure_1_ {
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
        self.feed = q_feed;
        self.keep = q_keep;
        self.reject = q_reject;
        self.first = false;
        outputs.feed = self.feed;
        outputs.keep = self.keep;
        outputs.reject = self.reject;
        outputs
    }
}
