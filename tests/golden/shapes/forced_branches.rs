// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __PressesRegion0 {
    Wait,
    Left,
    LeftReady,
    INIT,
}
enum __PressesRegion1 {
    Right,
    RightReady,
    NONE,
}
impl Presses {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &PressesInputs,
        #[cfg(doc)]
        inputs: &PressesInputs,
    ) -> PressesOutputs {
        let mut outputs_ = const {
            PressesOutputs {
                left: false,
                right: false,
            }
        };
        match self.region_0 {
            __PressesRegion0::INIT => {
                self.region_0 = __PressesRegion0::Wait;
            }
            __PressesRegion0::Wait => {
                if inputs_.start {
                    self.region_0 = __PressesRegion0::Left;
                    self.region_1 = __PressesRegion1::Right;
                    outputs_ = const {
                        PressesOutputs {
                            left: true,
                            right: true,
                        }
                    };
                }
            }
            _ => {
                if self.region_0 == __PressesRegion0::LeftReady
                    && self.region_1 == __PressesRegion1::RightReady
                {
                    self.region_1 = __PressesRegion1::NONE;
                    self.region_0 = __PressesRegion0::Wait;
                } else {
                    match self.region_0 {
                        __PressesRegion0::Left => {
                            if inputs_.left_done {
                                self.region_0 = __PressesRegion0::LeftReady;
                            } else {
                                outputs_.left = true;
                            }
                        }
                        _ => {}
                    }
                    core::sync::atomic::compiler_fence(
                        core::sync::atomic::Ordering::SeqCst,
                    );
                    match self.region_1 {
                        __PressesRegion1::Right => {
                            if inputs_.right_done {
                                self.region_1 = __PressesRegion1::RightReady;
                            } else {
                                outputs_.right = true;
                            }
                        }
                        _ => {}
                    }
                }
            }
        }
        outputs_
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
        #[cfg(not(doc))]
        steps_: &[PressesStep],
        #[cfg(doc)]
        steps: &[PressesStep],
        #[cfg(not(doc))]
        inputs_: &PressesInputs,
        #[cfg(doc)]
        inputs: &PressesInputs,
    ) -> Result<
        PressesOutputs,
        ForceError<PressesStep>,
    > {
        Possible::Listed(b"\x01\n\x12\x0C\x14")
            .look(<Self as Chart>::STEPS, steps_)?;
        let mut forced0_: Option<__PressesRegion0> = Option::None;
        let mut forced1_: Option<__PressesRegion1> = Option::None;
        for step_ in steps_ {
            match *step_ {
                PressesStep::Wait => {
                    forced0_ = Option::Some(__PressesRegion0::Wait);
                }
                PressesStep::Left => {
                    forced0_ = Option::Some(__PressesRegion0::Left);
                }
                PressesStep::LeftReady => {
                    forced0_ = Option::Some(
                        __PressesRegion0::LeftReady,
                    );
                }
                PressesStep::Right => {
                    forced1_ = Option::Some(
                        __PressesRegion1::Right,
                    );
                }
                PressesStep::RightReady => {
                    forced1_ = Option::Some(
                        __PressesRegion1::RightReady,
                    );
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
        let forced1_ = match forced1_ {
            Option::Some(state_) => state_,
            Option::None => __PressesRegion1::NONE,
        };
        Result::Ok({
            let mut outputs_ = const {
                PressesOutputs {
                    left: false,
                    right: false,
                }
            };
            self.region_0 = forced0_;
            self.region_1 = forced1_;
            let on_left_0__: bool = self.region_0
                == __PressesRegion0::Left;
            let on_right_1__: bool = self.region_1
                == __PressesRegion1::Right;
            let q_left_: bool = on_left_0__;
            let q_right_: bool = on_right_1__;
            outputs_.left = q_left_;
            outputs_.right = q_right_;
            outputs_
        })
    }
}
