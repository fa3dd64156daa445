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
        self.situation = self.situation.unmarked();
        if self.situation.state() == __CounterState::INIT {
            self.situation = __CounterStateMark::of(__CounterState::Always);
        }
        let mut evolutions_left_: u32 = 4;
        let mut rising_now_0_ = false;
        let mut rising_now_1_ = false;
        loop {
            let inputs_ = core::hint::black_box(inputs_);
            let before_ = self.situation.state();
            let mut after_ = before_;
            let edge_before_0_ = self.edge_0;
            let edge_before_1_ = self.edge_1;
            let value_: bool = inputs_.pulse;
            rising_now_0_ = value_ && !self.edge_0;
            self.edge_0 = value_;
            let value_: bool = inputs_.clear;
            rising_now_1_ = value_ && !self.edge_1;
            self.edge_1 = value_;
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
            if evolutions_left_ == 0 {
                self.edge_0 = edge_before_0_;
                self.edge_1 = edge_before_1_;
                self.situation = self.situation.marked();
                break;
            }
            evolutions_left_ -= 1;
            self.var_count = next_count_;
            self.situation = __CounterStateMark::of(after_);
        }
        let after_ = self.situation.state();
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
impl Counter {
    /// One cycle that leads into a situation by hand, whatever the transition conditions say (decision A38): no transition clears, steps that
    /// are not named are left, named ones entered, each with its actions, and nothing of the steps in between runs.
    ///
    /// For commissioning: nothing that the compiler has proved of the chart's ways holds on this one.
    ///
    /// # Errors
    /// The chart is never in exactly these steps; then nothing has happened.
    #[allow(unused_assignments, unused_mut, unused_variables)]
    fn force(
        &mut self,
        #[cfg(not(doc))]
        steps_: &[CounterStep],
        #[cfg(doc)]
        steps: &[CounterStep],
        #[cfg(not(doc))]
        inputs_: &CounterInputs,
        #[cfg(doc)]
        inputs: &CounterInputs,
    ) -> Result<
        CounterOutputs,
        ForceError<CounterStep>,
    > {
        Possible::Alone
            .look(<Self as Chart>::STEPS, steps_)?;
        let mut forced0_: Option<__CounterState> = Option::None;
        for step_ in steps_ {
            match *step_ {
                CounterStep::Always => {
                    forced0_ = Option::Some(__CounterState::Always);
                }
            }
        }
        let forced0_ = match forced0_ {
            Option::Some(state_) => state_,
            Option::None => {
                return Result::Err(
                    ForceError::NoSituation,
                );
            }
        };
        Result::Ok({
            let mut outputs_ = CounterOutputs { many: false };
            self.situation = self.situation.unmarked();
            if self.situation.state() == __CounterState::INIT {
                self.situation = __CounterStateMark::of(__CounterState::Always);
            }
            let mut rising_now_0_ = false;
            let mut rising_now_1_ = false;
            {
                let before_ = self.situation.state();
                let after_ = forced0_;
                let value_: bool = inputs_.pulse;
                rising_now_0_ = value_ && !self.edge_0;
                self.edge_0 = value_;
                let value_: bool = inputs_.clear;
                rising_now_1_ = value_ && !self.edge_1;
                self.edge_1 = value_;
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
                self.var_count = next_count_;
                self.situation = __CounterStateMark::of(after_);
            }
            let edge_before_0_ = self.edge_0;
            let edge_before_1_ = self.edge_1;
            {
                let before_ = self.situation.state();
                let value_: bool = inputs_.pulse;
                rising_now_0_ = value_ && !self.edge_0;
                self.edge_0 = value_;
                let value_: bool = inputs_.clear;
                rising_now_1_ = value_ && !self.edge_1;
                self.edge_1 = value_;
            }
            self.edge_0 = edge_before_0_;
            self.edge_1 = edge_before_1_;
            let after_ = self.situation.state();
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
        })
    }
}
