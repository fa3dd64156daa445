// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

impl Gate {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &GateInputs,
        #[cfg(doc)]
        inputs: &GateInputs,
    ) -> GateOutputs {
        let mut outputs_ = GateOutputs {
            up: false,
            down: false,
        };
        let mut rising_now_0_ = false;
        let mut rising_now_1_ = false;
        let value_: bool = inputs_.open;
        rising_now_0_ = value_ && !self.edge_0;
        self.edge_0 = value_;
        let value_: bool = inputs_.close;
        rising_now_1_ = value_ && !self.edge_1;
        self.edge_1 = value_;
        loop {
            let inputs_ = core::hint::black_box(inputs_);
            let before_0_ = self.region_0;
            let before_1_ = self.region_1;
            let before_2_ = self.region_2;
            let mut after_0_ = before_0_;
            let mut after_1_ = before_1_;
            let mut after_2_ = before_2_;
            let mut enter_0_ = false;
            let mut enter_1_ = false;
            let mut enter_2_ = false;
            match before_0_ {
                __GateRegion0::Rest => {
                    if {
                        let rising_0_ = rising_now_0_;
                        rising_0_
                    } {
                        if after_0_ == __GateRegion0::Rest {
                            after_0_ = __GateRegion0::NONE;
                        }
                        enter_1_ = true;
                    }
                    if {
                        let rising_1_ = rising_now_1_;
                        rising_1_
                    } {
                        if after_0_ == __GateRegion0::Rest {
                            after_0_ = __GateRegion0::NONE;
                        }
                        enter_2_ = true;
                    }
                }
                _ => {}
            }
            match before_1_ {
                __GateRegion1::Raise => {
                    if !inputs_.open {
                        after_1_ = __GateRegion1::NONE;
                        enter_0_ = true;
                    }
                }
                _ => {}
            }
            match before_2_ {
                __GateRegion2::Lower => {
                    if !inputs_.close {
                        after_2_ = __GateRegion2::NONE;
                        enter_0_ = true;
                    }
                }
                _ => {}
            }
            if enter_0_ {
                after_0_ = __GateRegion0::Rest;
            }
            if enter_1_ {
                after_1_ = __GateRegion1::Raise;
            }
            if enter_2_ {
                after_2_ = __GateRegion2::Lower;
            }
            if after_0_ == before_0_ && after_1_ == before_1_ && after_2_ == before_2_ {
                break;
            }
            self.region_0 = after_0_;
            self.region_1 = after_1_;
            self.region_2 = after_2_;
            rising_now_0_ = false;
            rising_now_1_ = false;
        }
        let after_0_ = self.region_0;
        let after_1_ = self.region_1;
        let after_2_ = self.region_2;
        match after_1_ {
            __GateRegion1::Raise => {
                outputs_.up = true;
            }
            _ => {}
        }
        match after_2_ {
            __GateRegion2::Lower => {
                outputs_.down = true;
            }
            _ => {}
        }
        outputs_
    }
}
impl Gate {
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
        steps_: &[GateStep],
        #[cfg(doc)]
        steps: &[GateStep],
        #[cfg(not(doc))]
        inputs_: &GateInputs,
        #[cfg(doc)]
        inputs: &GateInputs,
    ) -> Result<
        GateOutputs,
        ForceError<GateStep>,
    > {
        Possible::Listed(b"\x01\x03\x05\x02\x06\x04")
            .look(<Self as Chart>::STEPS, steps_)?;
        let mut forced0_: Option<__GateRegion0> = Option::None;
        let mut forced1_: Option<__GateRegion1> = Option::None;
        let mut forced2_: Option<__GateRegion2> = Option::None;
        for step_ in steps_ {
            match *step_ {
                GateStep::Rest => {
                    forced0_ = Option::Some(__GateRegion0::Rest);
                }
                GateStep::Raise => {
                    forced1_ = Option::Some(__GateRegion1::Raise);
                }
                GateStep::Lower => {
                    forced2_ = Option::Some(__GateRegion2::Lower);
                }
            }
        }
        let forced0_ = match forced0_ {
            Option::Some(state_) => state_,
            Option::None => __GateRegion0::NONE,
        };
        let forced1_ = match forced1_ {
            Option::Some(state_) => state_,
            Option::None => __GateRegion1::NONE,
        };
        let forced2_ = match forced2_ {
            Option::Some(state_) => state_,
            Option::None => __GateRegion2::NONE,
        };
        Result::Ok({
            let mut outputs_ = GateOutputs {
                up: false,
                down: false,
            };
            let mut rising_now_0_ = false;
            let mut rising_now_1_ = false;
            let value_: bool = inputs_.open;
            rising_now_0_ = value_ && !self.edge_0;
            self.edge_0 = value_;
            let value_: bool = inputs_.close;
            rising_now_1_ = value_ && !self.edge_1;
            self.edge_1 = value_;
            {
                let before_0_ = self.region_0;
                let before_1_ = self.region_1;
                let before_2_ = self.region_2;
                let after_0_ = forced0_;
                let after_1_ = forced1_;
                let after_2_ = forced2_;
                self.region_0 = after_0_;
                self.region_1 = after_1_;
                self.region_2 = after_2_;
                rising_now_0_ = false;
                rising_now_1_ = false;
            }
            let edge_before_0_ = self.edge_0;
            let edge_before_1_ = self.edge_1;
            {
                let before_0_ = self.region_0;
                let before_1_ = self.region_1;
                let before_2_ = self.region_2;
            }
            self.edge_0 = edge_before_0_;
            self.edge_1 = edge_before_1_;
            let after_0_ = self.region_0;
            let after_1_ = self.region_1;
            let after_2_ = self.region_2;
            match after_1_ {
                __GateRegion1::Raise => {
                    outputs_.up = true;
                }
                _ => {}
            }
            match after_2_ {
                __GateRegion2::Lower => {
                    outputs_.down = true;
                }
                _ => {}
            }
            outputs_
        })
    }
}
