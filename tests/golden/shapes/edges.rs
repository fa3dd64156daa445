// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __SorterState {
    Wait,
    Carry,
    Push,
}
impl Sorter {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &SorterInputs,
        #[cfg(doc)]
        inputs: &SorterInputs,
    ) -> SorterOutputs {
        let mut outputs_ = const {
            SorterOutputs {
                belt: false,
                push: false,
                lamp: false,
            }
        };
        let mut now_state_: __SorterState = self.situation;
        loop {
            let inputs_ = core::hint::black_box(inputs_);
            fence_on_armv6m();
            match now_state_ {
                __SorterState::Wait => {
                    if !self.edge0_before && inputs_.part {
                        now_state_ = __SorterState::Carry;
                    } else {
                        break;
                    }
                }
                __SorterState::Carry => {
                    if inputs_.metal {
                        now_state_ = __SorterState::Push;
                    } else {
                        break;
                    }
                }
                __SorterState::Push => {
                    if self.edge1_before && !inputs_.end {
                        now_state_ = __SorterState::Wait;
                    } else {
                        break;
                    }
                }
            }
            self.situation = now_state_;
            self.edge0_before = inputs_.part;
            self.edge1_before = inputs_.end;
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.situation {
            __SorterState::Wait => {
                outputs_.lamp = true;
            }
            __SorterState::Carry => {
                outputs_.belt = true;
            }
            __SorterState::Push => {
                outputs_.push = true;
            }
        }
        self.edge0_before = inputs_.part;
        self.edge1_before = inputs_.end;
        outputs_
    }
}
