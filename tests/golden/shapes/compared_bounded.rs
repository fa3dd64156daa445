// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

impl Float {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &FloatInputs,
        #[cfg(doc)]
        inputs: &FloatInputs,
    ) -> FloatOutputs {
        let mut outputs_ = FloatOutputs {
            fill: false,
            drain: false,
        };
        self.region_0 = self.region_0.unmarked();
        let mut evolutions_left_: u32 = 8;
        loop {
            let inputs_ = core::hint::black_box(inputs_);
            let before_0_ = self.region_0.state();
            let before_1_ = self.region_1;
            let before_2_ = self.region_2;
            let mut after_0_ = before_0_;
            let mut after_1_ = before_1_;
            let mut after_2_ = before_2_;
            let mut enter_0_ = false;
            let mut enter_1_ = false;
            let mut enter_2_ = false;
            match before_0_ {
                __FloatRegion0::Rest => {
                    if {
                        let on = inputs_.on;
                        let level = inputs_.level;
                        let low = self.params.low;
                        on && level < low
                    } {
                        if after_0_ == __FloatRegion0::Rest {
                            after_0_ = __FloatRegion0::NONE;
                        }
                        enter_1_ = true;
                    }
                    if {
                        let on = inputs_.on;
                        let level = inputs_.level;
                        let high = self.params.high;
                        on && level > high
                    } {
                        if after_0_ == __FloatRegion0::Rest {
                            after_0_ = __FloatRegion0::NONE;
                        }
                        enter_2_ = true;
                    }
                }
                _ => {}
            }
            match before_1_ {
                __FloatRegion1::Fill => {
                    if {
                        #[allow(unused_variables)]
                        let level = inputs_.level;
                        #[allow(unused_variables)]
                        let low = self.params.low;
                        #[allow(unused_variables)]
                        let on = inputs_.on;
                        level >= low + 2.0 || !on
                    } {
                        after_1_ = __FloatRegion1::NONE;
                        enter_0_ = true;
                    }
                }
                _ => {}
            }
            match before_2_ {
                __FloatRegion2::Drain => {
                    if {
                        #[allow(unused_variables)]
                        let level = inputs_.level;
                        #[allow(unused_variables)]
                        let high = self.params.high;
                        #[allow(unused_variables)]
                        let on = inputs_.on;
                        level <= high - 2.0 || !on
                    } {
                        after_2_ = __FloatRegion2::NONE;
                        enter_0_ = true;
                    }
                }
                _ => {}
            }
            if enter_0_ {
                after_0_ = __FloatRegion0::Rest;
            }
            if enter_1_ {
                after_1_ = __FloatRegion1::Fill;
            }
            if enter_2_ {
                after_2_ = __FloatRegion2::Drain;
            }
            if after_0_ == before_0_ && after_1_ == before_1_ && after_2_ == before_2_ {
                break;
            }
            if evolutions_left_ == 0 {
                self.region_0 = self.region_0.marked();
                break;
            }
            evolutions_left_ -= 1;
            self.region_0 = __FloatRegion0Mark::of(after_0_);
            self.region_1 = after_1_;
            self.region_2 = after_2_;
        }
        let after_0_ = self.region_0.state();
        let after_1_ = self.region_1;
        let after_2_ = self.region_2;
        match after_1_ {
            __FloatRegion1::Fill => {
                outputs_.fill = true;
            }
            _ => {}
        }
        match after_2_ {
            __FloatRegion2::Drain => {
                outputs_.drain = true;
            }
            _ => {}
        }
        outputs_
    }
}
impl Float {
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
        steps_: &[FloatStep],
        #[cfg(doc)]
        steps: &[FloatStep],
        #[cfg(not(doc))]
        inputs_: &FloatInputs,
        #[cfg(doc)]
        inputs: &FloatInputs,
    ) -> Result<
        FloatOutputs,
        ForceError<FloatStep>,
    > {
        Possible::Listed(b"\x01\x03\x07\x05\x02\x06\x04")
            .look(<Self as Chart>::STEPS, steps_)?;
        let mut forced0_: Option<__FloatRegion0> = Option::None;
        let mut forced1_: Option<__FloatRegion1> = Option::None;
        let mut forced2_: Option<__FloatRegion2> = Option::None;
        for step_ in steps_ {
            match *step_ {
                FloatStep::Rest => {
                    forced0_ = Option::Some(__FloatRegion0::Rest);
                }
                FloatStep::Fill => {
                    forced1_ = Option::Some(__FloatRegion1::Fill);
                }
                FloatStep::Drain => {
                    forced2_ = Option::Some(__FloatRegion2::Drain);
                }
            }
        }
        let forced0_ = match forced0_ {
            Option::Some(state_) => state_,
            Option::None => __FloatRegion0::NONE,
        };
        let forced1_ = match forced1_ {
            Option::Some(state_) => state_,
            Option::None => __FloatRegion1::NONE,
        };
        let forced2_ = match forced2_ {
            Option::Some(state_) => state_,
            Option::None => __FloatRegion2::NONE,
        };
        Result::Ok({
            let mut outputs_ = FloatOutputs {
                fill: false,
                drain: false,
            };
            self.region_0 = self.region_0.unmarked();
            {
                let before_0_ = self.region_0.state();
                let before_1_ = self.region_1;
                let before_2_ = self.region_2;
                let after_0_ = forced0_;
                let after_1_ = forced1_;
                let after_2_ = forced2_;
                self.region_0 = __FloatRegion0Mark::of(after_0_);
                self.region_1 = after_1_;
                self.region_2 = after_2_;
            }
            {
                let before_0_ = self.region_0.state();
                let before_1_ = self.region_1;
                let before_2_ = self.region_2;
            }
            let after_0_ = self.region_0.state();
            let after_1_ = self.region_1;
            let after_2_ = self.region_2;
            match after_1_ {
                __FloatRegion1::Fill => {
                    outputs_.fill = true;
                }
                _ => {}
            }
            match after_2_ {
                __FloatRegion2::Drain => {
                    outputs_.drain = true;
                }
                _ => {}
            }
            outputs_
        })
    }
}
