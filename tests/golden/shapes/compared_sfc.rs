// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

impl Fill {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &FillInputs,
        #[cfg(doc)]
        inputs: &FillInputs,
    ) -> FillOutputs {
        let mut outputs_ = FillOutputs {
            valve: false,
            pump: false,
        };
        let before_0_ = self.region_0;
        let before_1_ = self.region_1;
        let mut after_0_ = before_0_;
        let mut after_1_ = before_1_;
        if before_0_ == __FillRegion0::INIT {
            after_0_ = __FillRegion0::Wait;
            after_1_ = __FillRegion1::NONE;
        } else {
            let mut left_2_ = false;
            let mut left_4_ = false;
            if (before_0_ == __FillRegion0::Open) && !left_2_ && inputs_.stop {
                left_2_ = true;
                after_0_ = __FillRegion0::Stopped;
            }
            if (before_1_ == __FillRegion1::Running) && !left_4_ && inputs_.stop {
                left_4_ = true;
                after_1_ = __FillRegion1::NONE;
                after_0_ = __FillRegion0::Stopped;
            }
            if (before_0_ == __FillRegion0::Open)
                && (before_1_ == __FillRegion1::Running) && !left_2_ && !left_4_ && true
            {
                left_2_ = true;
                left_4_ = true;
                after_1_ = __FillRegion1::NONE;
                after_0_ = __FillRegion0::Wait;
            }
            match before_0_ {
                __FillRegion0::Wait => {
                    if inputs_.stop {
                        after_0_ = __FillRegion0::Stopped;
                    } else if inputs_.start {
                        after_0_ = __FillRegion0::Valve;
                        after_1_ = __FillRegion1::Pump;
                    } else {}
                }
                __FillRegion0::Valve => {
                    if inputs_.stop {
                        after_0_ = __FillRegion0::Stopped;
                    } else if inputs_.full {
                        after_0_ = __FillRegion0::Open;
                    } else {}
                }
                __FillRegion0::Stopped => {
                    if {
                        let stop = inputs_.stop;
                        let active_0_ = before_0_ == __FillRegion0::Wait;
                        let active_1_ = before_0_ == __FillRegion0::Valve;
                        let active_2_ = before_0_ == __FillRegion0::Open;
                        let active_3_ = before_1_ == __FillRegion1::Pump;
                        let active_4_ = before_1_ == __FillRegion1::Running;
                        (!stop)
                            && (!(stop
                                && (active_0_ || active_1_
                                    || (active_2_ || (active_3_ || active_4_)))))
                    } {
                        after_0_ = __FillRegion0::Wait;
                    }
                }
                _ => {}
            }
            match before_1_ {
                __FillRegion1::Pump => {
                    if inputs_.stop {
                        after_1_ = __FillRegion1::NONE;
                        after_0_ = __FillRegion0::Stopped;
                    } else if inputs_.full {
                        after_1_ = __FillRegion1::Running;
                    } else {}
                }
                _ => {}
            }
        }
        self.region_0 = after_0_;
        self.region_1 = after_1_;
        match after_0_ {
            __FillRegion0::Valve => {
                outputs_.valve = true;
            }
            _ => {}
        }
        match after_1_ {
            __FillRegion1::Pump => {
                outputs_.pump = true;
            }
            _ => {}
        }
        outputs_
    }
}
impl Fill {
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
        steps_: &[FillStep],
        #[cfg(doc)]
        steps: &[FillStep],
        #[cfg(not(doc))]
        inputs_: &FillInputs,
        #[cfg(doc)]
        inputs: &FillInputs,
    ) -> Result<
        FillOutputs,
        ForceError<FillStep>,
    > {
        Possible::Listed(b"\x01\n\x14 ")
            .look(<Self as Chart>::STEPS, steps_)?;
        let mut forced0_: Option<__FillRegion0> = Option::None;
        let mut forced1_: Option<__FillRegion1> = Option::None;
        for step_ in steps_ {
            match *step_ {
                FillStep::Wait => {
                    forced0_ = Option::Some(__FillRegion0::Wait);
                }
                FillStep::Valve => {
                    forced0_ = Option::Some(__FillRegion0::Valve);
                }
                FillStep::Open => {
                    forced0_ = Option::Some(__FillRegion0::Open);
                }
                FillStep::Pump => {
                    forced1_ = Option::Some(__FillRegion1::Pump);
                }
                FillStep::Running => {
                    forced1_ = Option::Some(__FillRegion1::Running);
                }
                FillStep::Stopped => {
                    forced0_ = Option::Some(__FillRegion0::Stopped);
                }
            }
        }
        let forced0_ = match forced0_ {
            Option::Some(state_) => state_,
            Option::None => __FillRegion0::NONE,
        };
        let forced1_ = match forced1_ {
            Option::Some(state_) => state_,
            Option::None => __FillRegion1::NONE,
        };
        Result::Ok({
            let mut outputs_ = FillOutputs {
                valve: false,
                pump: false,
            };
            let before_0_ = self.region_0;
            let before_1_ = self.region_1;
            let after_0_ = forced0_;
            let after_1_ = forced1_;
            self.region_0 = after_0_;
            self.region_1 = after_1_;
            match after_0_ {
                __FillRegion0::Valve => {
                    outputs_.valve = true;
                }
                _ => {}
            }
            match after_1_ {
                __FillRegion1::Pump => {
                    outputs_.pump = true;
                }
                _ => {}
            }
            outputs_
        })
    }
}
