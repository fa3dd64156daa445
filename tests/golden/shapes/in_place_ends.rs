// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

impl Presses {
    /// One cycle: evaluates the transition conditions on `inputs`, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(&mut self, inputs: &PressesInputs) -> PressesOutputs {
        let mut outputs = PressesOutputs {
            left: false,
            right: false,
        };
        let inputs = core::hint::black_box(inputs);
        loop {
            core::sync::atomic::compiler_fence(
                core::sync::atomic::Ordering::SeqCst,
            );
            #[allow(unused_variables)]
            let before_0 = self.region_0;
            #[allow(unused_variables)]
            let before_1 = self.region_1;
            let mut moved = false;
            match self.region_0 {
                __PressesRegion0::Wait => {
                    if inputs.start {
                        self.region_0 = __PressesRegion0::Left;
                        self.region_1 = __PressesRegion1::Right;
                        moved = true;
                    }
                }
                _ => {
                    if self.region_0 == __PressesRegion0::LeftReady
                        && self.region_1 == __PressesRegion1::RightReady && !inputs.start
                    {
                        self.region_1 = __PressesRegion1::NONE;
                        self.region_0 = __PressesRegion0::Wait;
                        moved = true;
                    } else {
                        match self.region_0 {
                            __PressesRegion0::Left => {
                                if inputs.left_done {
                                    self.region_0 = __PressesRegion0::LeftReady;
                                    moved = true;
                                }
                            }
                            _ => {}
                        }
                        match self.region_1 {
                            __PressesRegion1::Right => {
                                if inputs.right_done {
                                    self.region_1 = __PressesRegion1::RightReady;
                                    moved = true;
                                }
                            }
                            _ => {}
                        }
                    }
                }
            }
            #[allow(unused_variables)]
            let after_0 = self.region_0;
            #[allow(unused_variables)]
            let after_1 = self.region_1;
            if !moved {
                break;
            }
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        #[allow(unused_variables)]
        let after_0 = self.region_0;
        #[allow(unused_variables)]
        let after_1 = self.region_1;
        match self.region_0 {
            __PressesRegion0::Wait => {}
            _ => {
                match self.region_0 {
                    __PressesRegion0::Left => {
                        outputs.left = true;
                    }
                    _ => {}
                }
                match self.region_1 {
                    __PressesRegion1::Right => {
                        outputs.right = true;
                    }
                    _ => {}
                }
            }
        }
        outputs
    }
}
impl Presses {
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
        steps: &[PressesStep],
        inputs: &PressesInputs,
    ) -> Result<
        PressesOutputs,
        ForceError<PressesStep>,
    > {
        Possible::Listed(b"\x01\n\x12\x0C\x14")
            .look(<Self as Chart>::STEPS, steps)?;
        let mut forced0: Option<__PressesRegion0> = Option::None;
        let mut forced1: Option<__PressesRegion1> = Option::None;
        for step in steps {
            match *step {
                PressesStep::Wait => {
                    forced0 = Option::Some(__PressesRegion0::Wait);
                }
                PressesStep::Left => {
                    forced0 = Option::Some(__PressesRegion0::Left);
                }
                PressesStep::LeftReady => {
                    forced0 = Option::Some(
                        __PressesRegion0::LeftReady,
                    );
                }
                PressesStep::Right => {
                    forced1 = Option::Some(__PressesRegion1::Right);
                }
                PressesStep::RightReady => {
                    forced1 = Option::Some(
                        __PressesRegion1::RightReady,
                    );
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
            Option::None => __PressesRegion1::NONE,
        };
        Result::Ok({
            let mut outputs = PressesOutputs {
                left: false,
                right: false,
            };
            {
                let before_0 = self.region_0;
                let before_1 = self.region_1;
                let after_0 = forced0;
                let after_1 = forced1;
                self.region_0 = after_0;
                self.region_1 = after_1;
            }
            {
                let before_0 = self.region_0;
                let before_1 = self.region_1;
            }
            let after_0 = self.region_0;
            let after_1 = self.region_1;
            match after_0 {
                __PressesRegion0::Left => {
                    outputs.left = true;
                }
                _ => {}
            }
            match after_1 {
                __PressesRegion1::Right => {
                    outputs.right = true;
                }
                _ => {}
            }
            outputs
        })
    }
}
