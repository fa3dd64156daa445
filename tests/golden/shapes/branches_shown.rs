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
                busy: false,
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
                    outputs_.left = true;
                    outputs_.right = true;
                    self.s_ff_busy = true;
                }
            }
            _ => {
                if self.region_0 == __PressesRegion0::LeftReady
                    && self.region_1 == __PressesRegion1::RightReady && !inputs_.start
                {
                    self.s_ff_busy = false;
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
        outputs_.busy = self.s_ff_busy;
        outputs_
    }
}
