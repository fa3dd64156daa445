// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __PressesRegion0 {
    Wait,
    Left,
    LeftReady,
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
        let inputs_ = core::hint::black_box(inputs_);
        loop {
            let mut moves_14__: bool = false;
            match self.region_0 {
                __PressesRegion0::Wait => {
                    if inputs_.start {
                        self.region_0 = __PressesRegion0::Left;
                        self.region_1 = __PressesRegion1::Right;
                        moves_14__ = true;
                    }
                }
                _ => {
                    if self.region_0 == __PressesRegion0::LeftReady
                        && self.region_1 == __PressesRegion1::RightReady
                        && !inputs_.start
                    {
                        moves_14__ = true;
                        self.region_1 = __PressesRegion1::NONE;
                        self.region_0 = __PressesRegion0::Wait;
                    } else {
                        match self.region_0 {
                            __PressesRegion0::Left => {
                                if inputs_.left_done {
                                    self.region_0 = __PressesRegion0::LeftReady;
                                    moves_14__ = true;
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
                                    moves_14__ = true;
                                }
                            }
                            _ => {}
                        }
                    }
                }
            }
            if !moves_14__ {
                break;
            }
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.region_0 {
            __PressesRegion0::Left => {
                outputs_.left = true;
            }
            _ => {}
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.region_1 {
            __PressesRegion1::Right => {
                outputs_.right = true;
            }
            _ => {}
        }
        outputs_
    }
}
