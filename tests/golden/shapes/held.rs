// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __PlantRegion0 {
    Ready,
    Held,
    Stopped,
}
enum __PlantRegion1 {
    M0,
    M1,
    M2,
    M3,
    M4,
    M5,
}
enum __PlantRegion2 {
    B0,
    B1,
    B2,
}
impl Plant {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &PlantInputs,
        #[cfg(doc)]
        inputs: &PlantInputs,
    ) -> PlantOutputs {
        let mut outputs_ = const {
            PlantOutputs {
                red: false,
                yellow: false,
                p: false,
                q: false,
                r: false,
                s: false,
            }
        };
        let inputs_ = core::hint::black_box(inputs_);
        loop {
            fence_on_armv6m();
            let mut moves_36__: bool = false;
            let was_state_m0__: __PlantRegion1 = self.region_1;
            let mut goes_37__: bool = false;
            let mut goes_38__: bool = false;
            match self.region_0 {
                __PlantRegion0::Ready => {
                    if inputs_.stop {
                        self.region_0 = __PlantRegion0::Stopped;
                        moves_36__ = true;
                        self.region_1 = __PlantRegion1::M0;
                        self.region_2 = __PlantRegion2::B0;
                    } else {
                        if inputs_.hold {
                            self.region_0 = __PlantRegion0::Held;
                            moves_36__ = true;
                            goes_37__ = true;
                        } else {
                            goes_37__ = true;
                            goes_38__ = true;
                        }
                    }
                }
                __PlantRegion0::Held => {
                    if inputs_.stop {
                        self.region_0 = __PlantRegion0::Stopped;
                        moves_36__ = true;
                        self.region_1 = __PlantRegion1::M0;
                        self.region_2 = __PlantRegion2::B0;
                    } else {
                        if !inputs_.hold {
                            self.region_0 = __PlantRegion0::Ready;
                            moves_36__ = true;
                            goes_37__ = true;
                        } else {
                            goes_37__ = true;
                        }
                    }
                }
                __PlantRegion0::Stopped => {
                    if !inputs_.stop && inputs_.ack {
                        self.region_0 = __PlantRegion0::Ready;
                        moves_36__ = true;
                    }
                }
            }
            if goes_37__ {
                match self.region_1 {
                    __PlantRegion1::M0 => {
                        if inputs_.a && inputs_.b {
                            self.region_1 = __PlantRegion1::M1;
                            moves_36__ = true;
                        }
                    }
                    __PlantRegion1::M1 => {
                        if inputs_.c {
                            self.region_1 = __PlantRegion1::M2;
                            moves_36__ = true;
                        }
                    }
                    __PlantRegion1::M2 => {
                        if !inputs_.a && self.region_2 != __PlantRegion2::B2 {
                            self.region_1 = __PlantRegion1::M3;
                            moves_36__ = true;
                        }
                    }
                    __PlantRegion1::M3 => {
                        if inputs_.b && !inputs_.c {
                            self.region_1 = __PlantRegion1::M4;
                            moves_36__ = true;
                        }
                    }
                    __PlantRegion1::M4 => {
                        if inputs_.a {
                            self.region_1 = __PlantRegion1::M5;
                            moves_36__ = true;
                        }
                    }
                    __PlantRegion1::M5 => {
                        if self.region_2 == __PlantRegion2::B1 {
                            self.region_1 = __PlantRegion1::M0;
                            moves_36__ = true;
                        }
                    }
                }
            }
            if goes_38__ {
                match self.region_2 {
                    __PlantRegion2::B0 => {
                        if inputs_.a && was_state_m0__ == __PlantRegion1::M1 {
                            self.region_2 = __PlantRegion2::B1;
                            moves_36__ = true;
                        }
                    }
                    __PlantRegion2::B1 => {
                        if inputs_.d {
                            self.region_2 = __PlantRegion2::B2;
                            moves_36__ = true;
                        }
                    }
                    __PlantRegion2::B2 => {
                        if !inputs_.d {
                            self.region_2 = __PlantRegion2::B0;
                            moves_36__ = true;
                        }
                    }
                }
            }
            if !moves_36__ {
                break;
            }
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.region_0 {
            __PlantRegion0::Held => {
                outputs_.yellow = true;
            }
            __PlantRegion0::Stopped => {
                outputs_.red = true;
            }
            _ => {}
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.region_1 {
            __PlantRegion1::M1 => {
                outputs_.p = true;
            }
            __PlantRegion1::M2 => {
                outputs_.q = true;
            }
            __PlantRegion1::M3 => {
                outputs_.p = true;
                outputs_.q = true;
            }
            __PlantRegion1::M4 => {
                outputs_.r = true;
            }
            __PlantRegion1::M5 => {
                outputs_.p = true;
                outputs_.r = true;
            }
            _ => {}
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.region_2 {
            __PlantRegion2::B1 => {
                outputs_.s = true;
            }
            _ => {}
        }
        outputs_
    }
}
