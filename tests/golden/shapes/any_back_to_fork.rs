// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __WasherRegion0 {
    Idle,
    Heat,
    Warm,
    INIT,
}
enum __WasherRegion1 {
    Fill,
    Filled,
    NONE,
}
impl Washer {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &WasherInputs,
        #[cfg(doc)]
        inputs: &WasherInputs,
    ) -> WasherOutputs {
        let mut outputs_ = const {
            WasherOutputs {
                heat: false,
                valve: false,
                lamp: false,
            }
        };
        match self.region_0 {
            __WasherRegion0::INIT => {
                self.region_0 = __WasherRegion0::Idle;
                outputs_.lamp = true;
            }
            __WasherRegion0::Idle => {
                if inputs_.go {
                    self.region_0 = __WasherRegion0::Heat;
                    self.region_1 = __WasherRegion1::Fill;
                    outputs_.valve = true;
                    self.s_ff_heat = true;
                } else {
                    outputs_.lamp = true;
                }
            }
            _ => {
                if inputs_.stop {
                    outputs_.lamp = true;
                    self.region_1 = __WasherRegion1::NONE;
                    self.region_0 = __WasherRegion0::Idle;
                } else {
                    if self.region_0 == __WasherRegion0::Warm
                        && self.region_1 == __WasherRegion1::Filled && inputs_.hot
                        && inputs_.full && inputs_.done
                    {
                        outputs_.lamp = true;
                        self.region_1 = __WasherRegion1::NONE;
                        self.region_0 = __WasherRegion0::Idle;
                    } else {
                        match self.region_0 {
                            __WasherRegion0::Heat => {
                                if inputs_.hot {
                                    self.region_0 = __WasherRegion0::Warm;
                                }
                            }
                            __WasherRegion0::Warm => {
                                if !inputs_.hot {
                                    self.region_0 = __WasherRegion0::Heat;
                                }
                            }
                            _ => {}
                        }
                        match self.region_0 {
                            __WasherRegion0::Heat => {
                                self.s_ff_heat = true;
                            }
                            __WasherRegion0::Warm => {
                                self.s_ff_heat = false;
                            }
                            _ => {}
                        }
                        core::sync::atomic::compiler_fence(
                            core::sync::atomic::Ordering::SeqCst,
                        );
                        match self.region_1 {
                            __WasherRegion1::Fill => {
                                if inputs_.full {
                                    self.region_1 = __WasherRegion1::Filled;
                                } else {
                                    outputs_.valve = true;
                                }
                            }
                            __WasherRegion1::Filled => {
                                if !inputs_.full {
                                    self.region_1 = __WasherRegion1::Fill;
                                    outputs_.valve = true;
                                }
                            }
                            _ => {}
                        }
                    }
                }
            }
        }
        outputs_.heat = self.s_ff_heat;
        outputs_
    }
}
