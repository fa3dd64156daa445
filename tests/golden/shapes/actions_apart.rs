// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __MashRegion0 {
    Idle,
    Fill,
    Warm,
    Hold,
    Boil,
    Whirl,
    Drain,
    Rinse,
    Rinsed,
    INIT,
}
enum __MashRegion1 {
    Cool,
    Cooled,
    NONE,
}
impl Mash {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &MashInputs,
        #[cfg(doc)]
        inputs: &MashInputs,
    ) -> MashOutputs {
        let mut outputs_ = MashOutputs {
            heater: false,
            pump: false,
            stirrer: false,
            valve: false,
            rinse: false,
            power: 0,
            speed: 0,
        };
        match self.region_0 {
            __MashRegion0::INIT => {
                self.region_0 = __MashRegion0::Idle;
            }
            __MashRegion0::Idle => {
                if inputs_.start & inputs_.level {
                    self.region_0 = __MashRegion0::Fill;
                }
            }
            __MashRegion0::Fill => {
                if inputs_.level {
                    if !inputs_.hot {
                        self.region_0 = __MashRegion0::Warm;
                    }
                } else {
                    if inputs_.hot {
                        self.region_0 = __MashRegion0::Hold;
                    }
                }
            }
            __MashRegion0::Warm => {
                if inputs_.hot {
                    if inputs_.level {
                        self.region_0 = __MashRegion0::Hold;
                    }
                } else {
                    if inputs_.ack & inputs_.cold {
                        self.region_0 = __MashRegion0::Boil;
                    }
                }
            }
            __MashRegion0::Hold => {
                if inputs_.cold {
                    if inputs_.start {
                        self.region_0 = __MashRegion0::Boil;
                    }
                } else {
                    if inputs_.ack {
                        self.region_0 = __MashRegion0::Warm;
                    }
                }
            }
            __MashRegion0::Boil => {
                if inputs_.ack {
                    if inputs_.level {
                        self.region_0 = __MashRegion0::Whirl;
                    }
                } else {
                    if inputs_.cold & !inputs_.level {
                        self.region_0 = __MashRegion0::Drain;
                    }
                }
            }
            __MashRegion0::Whirl => {
                if inputs_.cold & inputs_.ack {
                    self.region_0 = __MashRegion0::Drain;
                } else {
                    if inputs_.hot {
                        if !inputs_.cold & !inputs_.level {
                            self.region_0 = __MashRegion0::Boil;
                        }
                    } else {
                        if inputs_.start & inputs_.level {
                            self.region_0 = __MashRegion0::Rinse;
                            self.region_1 = __MashRegion1::Cool;
                        }
                    }
                }
            }
            __MashRegion0::Drain => {
                if inputs_.level {
                    if inputs_.hot {
                        self.region_0 = __MashRegion0::Whirl;
                    }
                } else {
                    if inputs_.ack {
                        self.region_0 = __MashRegion0::Idle;
                    }
                }
            }
            _ => {
                if self.region_0 == __MashRegion0::Rinsed
                    && self.region_1 == __MashRegion1::Cooled
                    && !(inputs_.hot & !inputs_.ack) && inputs_.ack
                {
                    self.region_1 = __MashRegion1::NONE;
                    self.region_0 = __MashRegion0::Idle;
                } else {
                    match self.region_0 {
                        __MashRegion0::Rinse => {
                            if inputs_.level {
                                self.region_0 = __MashRegion0::Rinsed;
                            }
                        }
                        _ => {}
                    }
                    core::sync::atomic::compiler_fence(
                        core::sync::atomic::Ordering::SeqCst,
                    );
                    match self.region_1 {
                        __MashRegion1::Cool => {
                            if inputs_.cold {
                                self.region_1 = __MashRegion1::Cooled;
                            }
                        }
                        __MashRegion1::Cooled => {
                            if inputs_.hot & !inputs_.ack {
                                self.region_1 = __MashRegion1::Cool;
                            }
                        }
                        _ => {}
                    }
                }
            }
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.region_0 {
            __MashRegion0::Idle => {
                outputs_.valve = true;
                outputs_.power = 10;
                outputs_.speed = 5;
            }
            __MashRegion0::Fill => {
                outputs_.valve = true;
                outputs_.pump = true;
                outputs_.power = 100;
                outputs_.speed = 10;
            }
            __MashRegion0::Warm => {
                outputs_.heater = true;
                outputs_.stirrer = true;
                outputs_.power = 400;
                outputs_.speed = 20;
            }
            __MashRegion0::Hold => {
                outputs_.stirrer = true;
                outputs_.power = 200;
                outputs_.speed = 15;
            }
            __MashRegion0::Boil => {
                outputs_.heater = true;
                outputs_.stirrer = true;
                outputs_.power = 900;
                outputs_.speed = 40;
            }
            __MashRegion0::Whirl => {
                outputs_.pump = true;
                outputs_.stirrer = true;
                outputs_.power = 50;
                outputs_.speed = 90;
            }
            __MashRegion0::Drain => {
                outputs_.pump = true;
                outputs_.power = 20;
                outputs_.speed = 60;
            }
            __MashRegion0::Rinse => {
                outputs_.rinse = true;
            }
            _ => {}
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.region_1 {
            __MashRegion1::Cool => {
                outputs_.valve = outputs_.valve || inputs_.hot;
            }
            _ => {}
        }
        outputs_
    }
}
