// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

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
        if self.situation == __CounterState::INIT {
            self.situation = __CounterState::Always;
        }
        let mut rising_now_0_ = false;
        let mut rising_now_1_ = false;
        let value_: bool = inputs_.pulse;
        rising_now_0_ = value_ && !self.edge_0;
        self.edge_0 = value_;
        let value_: bool = inputs_.clear;
        rising_now_1_ = value_ && !self.edge_1;
        self.edge_1 = value_;
        loop {
            let inputs_ = core::hint::black_box(inputs_);
            let before_ = self.situation;
            let mut after_ = before_;
            let mut next_count_ = self.var_count;
            match before_ {
                __CounterState::Always => {
                    if {
                        let rising_0_ = rising_now_0_;
                        let rising_1_ = rising_now_1_;
                        rising_0_ && !rising_1_
                    } {
                        next_count_ = {
                            let count = self.var_count;
                            (count + 1) % 1000
                        };
                    }
                    if {
                        let rising_1_ = rising_now_1_;
                        rising_1_
                    } {
                        next_count_ = 0;
                    }
                }
                _ => {}
            }
            if after_ == before_ && next_count_ == self.var_count {
                break;
            }
            self.var_count = next_count_;
            self.situation = after_;
            rising_now_0_ = false;
            rising_now_1_ = false;
        }
        let after_ = self.situation;
        match after_ {
            __CounterState::Always => {
                if {
                    let count = self.var_count;
                    count > 100
                } {
                    outputs_.many = true;
                }
            }
            _ => {}
        }
        outputs_
    }
}
