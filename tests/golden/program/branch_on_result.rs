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
    pub const fn with_params(
        #[cfg(not(doc))]
        params_: SorterParams,
        #[cfg(doc)]
        params: SorterParams,
    ) -> Self {
        #[cfg(doc)]
        let params_ = params;
        Self {
            first: true,
            situation: __SorterState::Feed,
            feed: false,
            keep: false,
            reject: false,
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
        let was_state_: __SorterState = self.situation;
        let entered_feed_: bool;
        let mut entered_measure_: bool = false;
        if self.first {
            entered_feed_ = true;
        } else {
            let clears_feed_measure_: bool = was_state_
                == __SorterState::Feed && inputs_.piece;
            let clears_measure_keep_: bool = was_state_
                == __SorterState::Measure
                && ({
                    let z = self.z;
                    z
                });
            let clears_keep_feed_: bool = was_state_
                == __SorterState::Keep && (!inputs_.piece);
            let clears_measure_reject_: bool = was_state_
                == __SorterState::Measure && !clears_measure_keep_
                && ({
                    let z = self.z;
                    !z
                });
            let clears_reject_feed_: bool = was_state_
                == __SorterState::Reject && (!inputs_.piece);
            let left_feed_: bool = clears_feed_measure_;
            let left_measure_: bool = clears_measure_keep_
                || clears_measure_reject_;
            let left_keep_: bool = clears_keep_feed_;
            let left_reject_: bool = clears_reject_feed_;
            entered_feed_ = (clears_keep_feed_ || clears_reject_feed_)
                && !(was_state_ == __SorterState::Feed && !left_feed_);
            entered_measure_ = clears_feed_measure_
                && !(was_state_ == __SorterState::Measure && !left_measure_);
            let entered_keep_: bool = clears_measure_keep_
                && !(was_state_ == __SorterState::Keep && !left_keep_);
            let entered_reject_: bool = clears_measure_reject_
                && !(was_state_ == __SorterState::Reject && !left_reject_);
            if left_feed_ {
                self.situation = __SorterState::NONE;
            }
            if left_measure_ {
                self.situation = __SorterState::NONE;
            }
            if left_keep_ {
                self.situation = __SorterState::NONE;
            }
            if left_reject_ {
                self.situation = __SorterState::NONE;
            }
            if entered_feed_ {
                self.situation = __SorterState::Feed;
            }
            if entered_measure_ {
                self.situation = __SorterState::Measure;
            }
            if entered_keep_ {
                self.situation = __SorterState::Keep;
            }
            if entered_reject_ {
                self.situation = __SorterState::Reject;
            }
        }
        let on_feed_0__: bool = self.situation
            == __SorterState::Feed;
        let on_measure_1__: bool = entered_measure_;
        let on_keep_2__: bool = self.situation
            == __SorterState::Keep;
        let on_reject_3__: bool = self.situation
            == __SorterState::Reject;
        let q_feed_: bool = on_feed_0__;
        let q_measure_1__: bool = false;
        let q_keep_: bool = on_keep_2__;
        let q_reject_: bool = on_reject_3__;
        if on_measure_1__ {
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
        self.feed = q_feed_;
        self.keep = q_keep_;
        self.reject = q_reject_;
        self.first = false;
        outputs_.feed = self.feed;
        outputs_.keep = self.keep;
        outputs_.reject = self.reject;
        outputs_
    }
}
