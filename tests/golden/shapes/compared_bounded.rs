// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

impl Fill {
    /// One cycle: evaluates the transition conditions on `inputs`, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(&mut self, inputs: &FillInputs) -> FillOutputs {
        let mut outputs = FillOutputs {
            valve: false,
            pump: false,
        };
        self.region_0 = self.region_0.unmarked();
        let mut evolutions_left: u32 = 14;
        loop {
            let inputs = core::hint::black_box(inputs);
            let before_0 = self.region_0.state();
            let before_1 = self.region_1;
            let mut after_0 = before_0;
            let mut after_1 = before_1;
            match before_0 {
                __FillRegion0::Wait => {
                    if inputs.stop {
                        after_0 = __FillRegion0::Stopped;
                    } else if {
                        let value = inputs.start && (!inputs.stop);
                        value
                    } {
                        after_0 = __FillRegion0::Valve;
                        after_1 = __FillRegion1::Pump;
                    } else {}
                }
                __FillRegion0::Valve => {
                    if inputs.stop {
                        after_0 = __FillRegion0::Stopped;
                    } else if {
                        let value = inputs.full && (!inputs.stop);
                        value
                    } {
                        after_0 = __FillRegion0::Open;
                    } else {}
                }
                __FillRegion0::Open => {
                    if inputs.stop {
                        after_0 = __FillRegion0::Stopped;
                    } else if (before_1 == __FillRegion1::Running)
                        && {
                            let stop = inputs.stop;
                            (true) && (!stop)
                        }
                    {
                        after_1 = __FillRegion1::NONE;
                        after_0 = __FillRegion0::Wait;
                    }
                }
                __FillRegion0::Stopped => {
                    if {
                        let stop = inputs.stop;
                        let active_0 = before_0 == __FillRegion0::Wait;
                        let active_1 = before_0 == __FillRegion0::Valve;
                        let active_2 = before_0 == __FillRegion0::Open;
                        let active_3 = before_1 == __FillRegion1::Pump;
                        let active_4 = before_1 == __FillRegion1::Running;
                        (!stop)
                            && (!(stop
                                && (active_0 || active_1
                                    || (active_2 || (active_3 || active_4)))))
                    } {
                        after_0 = __FillRegion0::Wait;
                    }
                }
            }
            match before_1 {
                __FillRegion1::Pump => {
                    if inputs.stop {
                        after_1 = __FillRegion1::NONE;
                        after_0 = __FillRegion0::Stopped;
                    } else if {
                        let value = inputs.full && (!inputs.stop);
                        value
                    } {
                        after_1 = __FillRegion1::Running;
                    } else {}
                }
                __FillRegion1::Running => {
                    if inputs.stop {
                        after_1 = __FillRegion1::NONE;
                        after_0 = __FillRegion0::Stopped;
                    }
                }
                _ => {}
            }
            if after_0 == before_0 && after_1 == before_1 {
                break;
            }
            if evolutions_left == 0 {
                self.region_0 = self.region_0.marked();
                break;
            }
            evolutions_left -= 1;
            self.region_0 = __FillRegion0Mark::of(after_0);
            self.region_1 = after_1;
        }
        let after_0 = self.region_0.state();
        let after_1 = self.region_1;
        match after_0 {
            __FillRegion0::Valve => {
                outputs.valve = true;
            }
            _ => {}
        }
        match after_1 {
            __FillRegion1::Pump => {
                outputs.pump = true;
            }
            _ => {}
        }
        outputs
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
        steps: &[FillStep],
        inputs: &FillInputs,
    ) -> Result<
        FillOutputs,
        ForceError<FillStep>,
    > {
        Possible::Listed(b"\x01\n\x14 ")
            .look(<Self as Chart>::STEPS, steps)?;
        let mut forced0: Option<__FillRegion0> = Option::None;
        let mut forced1: Option<__FillRegion1> = Option::None;
        for step in steps {
            match *step {
                FillStep::Wait => {
                    forced0 = Option::Some(__FillRegion0::Wait);
                }
                FillStep::Valve => {
                    forced0 = Option::Some(__FillRegion0::Valve);
                }
                FillStep::Open => {
                    forced0 = Option::Some(__FillRegion0::Open);
                }
                FillStep::Pump => {
                    forced1 = Option::Some(__FillRegion1::Pump);
                }
                FillStep::Running => {
                    forced1 = Option::Some(__FillRegion1::Running);
                }
                FillStep::Stopped => {
                    forced0 = Option::Some(__FillRegion0::Stopped);
                }
            }
        }
        let forced0 = match forced0 {
            Option::Some(state) => state,
            Option::None => {
                return Result::Err(
                    ForceError::NoSituation,
                );
            }
        };
        let forced1 = match forced1 {
            Option::Some(state) => state,
            Option::None => __FillRegion1::NONE,
        };
        Result::Ok({
            let mut outputs = FillOutputs {
                valve: false,
                pump: false,
            };
            self.region_0 = self.region_0.unmarked();
            {
                let before_0 = self.region_0.state();
                let before_1 = self.region_1;
                let after_0 = forced0;
                let after_1 = forced1;
                self.region_0 = __FillRegion0Mark::of(after_0);
                self.region_1 = after_1;
            }
            {
                let before_0 = self.region_0.state();
                let before_1 = self.region_1;
            }
            let after_0 = self.region_0.state();
            let after_1 = self.region_1;
            match after_0 {
                __FillRegion0::Valve => {
                    outputs.valve = true;
                }
                _ => {}
            }
            match after_1 {
                __FillRegion1::Pump => {
                    outputs.pump = true;
                }
                _ => {}
            }
            outputs
        })
    }
}
