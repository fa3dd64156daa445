// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

impl Presses {
    /// One cycle: evaluates the transition conditions on `inputs`, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(&mut self, inputs: &PressesInputs) -> PressesOutputs {
        let mut outputs = const {
            PressesOutputs {
                left: false,
                right: false,
            }
        };
        let inputs = core::hint::black_box(inputs);
        loop {
            let mut moves_14_: bool = false;
            match self.region_0 {
                __PressesRegion0::Wait => {
                    if inputs.start {
                        self.region_0 = __PressesRegion0::Left;
                        self.region_1 = __PressesRegion1::Right;
                        moves_14_ = true;
                    }
                }
                _ => {
                    if self.region_0 == __PressesRegion0::LeftReady
                        && self.region_1 == __PressesRegion1::RightReady && !inputs.start
                    {
                        moves_14_ = true;
                        self.region_1 = __PressesRegion1::NONE;
                        self.region_0 = __PressesRegion0::Wait;
                    } else {
                        match self.region_0 {
                            __PressesRegion0::Left => {
                                if inputs.left_done {
                                    self.region_0 = __PressesRegion0::LeftReady;
                                    moves_14_ = true;
                                }
                            }
                            _ => {}
                        }
                        core::sync::atomic::compiler_fence(
                            core::sync::atomic::Ordering::SeqCst,
                        );
                        match self.region_1 {
                            __PressesRegion1::Right => {
                                if inputs.right_done {
                                    self.region_1 = __PressesRegion1::RightReady;
                                    moves_14_ = true;
                                }
                            }
                            _ => {}
                        }
                    }
                }
            }
            if !moves_14_ {
                break;
            }
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.region_0 {
            __PressesRegion0::Left => {
                outputs.left = true;
            }
            _ => {}
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.region_1 {
            __PressesRegion1::Right => {
                outputs.right = true;
            }
            _ => {}
        }
        outputs
    }
}
