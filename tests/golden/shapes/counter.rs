// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __CounterState {
    Always,
}
impl Counter {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &CounterInputs,
        #[cfg(doc)]
        inputs: &CounterInputs,
    ) -> CounterOutputs {
        let mut outputs_ = CounterOutputs { many: false };
        let edge0_now_: bool = inputs_.pulse;
        let edge1_now_: bool = inputs_.clear;
        loop {
            let mut next_count_: core::primitive::u16 = self.count;
            if !self.edge1_before && edge1_now_ {
                next_count_ = 0;
            } else {
                if !self.edge0_before && edge0_now_ {
                    next_count_ = {
                        let count = self.count;
                        (count + 1) % 1000
                    };
                }
            }
            if self.count == next_count_ {
                break;
            }
            self.count = next_count_;
            self.edge0_before = edge0_now_;
            self.edge1_before = edge1_now_;
        }
        outputs_.many = {
            let count = self.count;
            count > 100
        };
        self.edge0_before = edge0_now_;
        self.edge1_before = edge1_now_;
        outputs_
    }
}
