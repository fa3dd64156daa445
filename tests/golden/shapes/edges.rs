// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

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
        match self.situation {
            __SorterState::INIT => {
                self.situation = __SorterState::Wait;
            }
            __SorterState::Wait => {
                if !self.edge0_before && inputs_.part && !inputs_.end {
                    self.situation = __SorterState::Carry;
                }
            }
            __SorterState::Carry => {
                if !self.edge1_before && inputs_.end && inputs_.metal {
                    self.situation = __SorterState::Push;
                    self.edge1_before = true;
                } else {
                    if !self.edge1_before && inputs_.end && !inputs_.metal {
                        self.situation = __SorterState::Wait;
                    }
                }
            }
            __SorterState::Push => {
                if self.edge1_before && !inputs_.end {
                    self.situation = __SorterState::Wait;
                } else {
                    self.edge1_before = inputs_.end;
                }
            }
        }
        match self.situation {
            __SorterState::Wait => {
                outputs_.lamp = true;
                self.edge1_before = inputs_.end;
            }
            __SorterState::Carry => {
                outputs_.belt = true;
                self.edge1_before = inputs_.end;
            }
            __SorterState::Push => {
                outputs_.push = true;
            }
            _ => {}
        }
        self.edge0_before = inputs_.part;
        outputs_
    }
}
