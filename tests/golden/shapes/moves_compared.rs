// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __MovesComparedRegion0 {
    Idle,
    Fill,
    Heat,
    Cool,
    Mixed,
    Drain,
    INIT,
}
enum __MovesComparedRegion1 {
    Dose,
    Stir,
    Test,
    Again,
    Dosed,
    NONE,
}
impl MovesCompared {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &MovesComparedInputs,
        #[cfg(doc)]
        inputs: &MovesComparedInputs,
        #[cfg(not(doc))]
        now_: impl core::convert::Into<
            Ticks,
        >,
        #[cfg(doc)]
        now: impl core::convert::Into<Ticks>,
    ) -> MovesComparedOutputs {
        let now_: Ticks = core::convert::Into::into(
            now_,
        );
        let mut outputs_ = const {
            MovesComparedOutputs {
                valve: false,
                heater: false,
                cooler: false,
                drain: false,
                dose: false,
                stir: false,
                lamp: false,
            }
        };
        self.before_state_idle = self.region_0;
        self.before_state_dose = self.region_1;
        self.reading = now_;
        fence_beyond_armv6m();
        match self.region_0 {
            __MovesComparedRegion0::INIT => {
                self.region_0 = __MovesComparedRegion0::Idle;
            }
            __MovesComparedRegion0::Idle => {
                if inputs_.start {
                    self.region_0 = __MovesComparedRegion0::Fill;
                    outputs_.valve = true;
                }
            }
            __MovesComparedRegion0::Fill => {
                if inputs_.full {
                    self.region_0 = __MovesComparedRegion0::Heat;
                    self.region_1 = __MovesComparedRegion1::Dose;
                    self.since_idle = self.reading;
                    outputs_.heater = true;
                    outputs_.lamp = true;
                    outputs_.dose = true;
                } else {
                    outputs_.valve = true;
                }
            }
            __MovesComparedRegion0::Drain => {
                if inputs_.empty {
                    self.region_0 = __MovesComparedRegion0::Idle;
                } else {
                    outputs_.drain = true;
                }
            }
            _ => {
                if self.region_0 == __MovesComparedRegion0::Mixed
                    && self.region_1 == __MovesComparedRegion1::Dosed
                {
                    outputs_.drain = true;
                    self.region_1 = __MovesComparedRegion1::NONE;
                    self.region_0 = __MovesComparedRegion0::Drain;
                } else {
                    match self.region_0 {
                        __MovesComparedRegion0::Heat => {
                            if inputs_.hot {
                                if has_reached!(
                                    self.reading.since(self.since_idle),
                                    Ticks::new(1000u32)
                                ) {
                                    self.region_0 = __MovesComparedRegion0::Cool;
                                    outputs_.cooler = true;
                                } else {
                                    outputs_.heater = true;
                                    outputs_.lamp = rest(
                                        self.reading.since(self.since_idle),
                                        Ticks::new(800u32),
                                    ) < Ticks::new(400u32);
                                }
                            } else {
                                if has_reached!(
                                    self.reading.since(self.since_idle),
                                    Ticks::new(9000u32)
                                ) {
                                    self.region_0 = __MovesComparedRegion0::Mixed;
                                } else {
                                    outputs_.heater = true;
                                    outputs_.lamp = rest(
                                        self.reading.since(self.since_idle),
                                        Ticks::new(800u32),
                                    ) < Ticks::new(400u32);
                                }
                            }
                        }
                        __MovesComparedRegion0::Cool => {
                            if inputs_.cold {
                                self.region_0 = __MovesComparedRegion0::Mixed;
                            } else {
                                outputs_.cooler = true;
                            }
                        }
                        _ => {}
                    }
                    core::sync::atomic::compiler_fence(
                        core::sync::atomic::Ordering::SeqCst,
                    );
                    match self.region_1 {
                        __MovesComparedRegion1::Dose => {
                            if inputs_.good {
                                self.region_1 = __MovesComparedRegion1::Stir;
                                self.since_dose = self.reading;
                                outputs_.lamp = true;
                            } else {
                                if inputs_.bad {
                                    self.region_1 = __MovesComparedRegion1::Again;
                                    self.since_dose = self.reading;
                                }
                            }
                        }
                        __MovesComparedRegion1::Stir => {
                            if has_reached!(
                                self.reading.since(self.since_dose),
                                Ticks::new(2000u32)
                            ) {
                                self.region_1 = __MovesComparedRegion1::Test;
                            } else {
                                outputs_.lamp = outputs_.lamp
                                    || rest(
                                        self.reading.since(self.since_dose),
                                        Ticks::new(400u32),
                                    ) < Ticks::new(200u32);
                            }
                        }
                        __MovesComparedRegion1::Test => {
                            if inputs_.good {
                                self.region_1 = __MovesComparedRegion1::Dosed;
                            } else {
                                if inputs_.bad {
                                    self.region_1 = __MovesComparedRegion1::Again;
                                    self.since_dose = self.reading;
                                }
                            }
                        }
                        __MovesComparedRegion1::Again => {
                            if has_reached!(
                                self.reading.since(self.since_dose),
                                Ticks::new(500u32)
                            ) {
                                self.region_1 = __MovesComparedRegion1::Stir;
                                self.since_dose = self.reading;
                                outputs_.lamp = true;
                            }
                        }
                        _ => {}
                    }
                    match self.region_1 {
                        __MovesComparedRegion1::Dose => {
                            outputs_.dose = true;
                        }
                        __MovesComparedRegion1::Stir => {
                            outputs_.stir = true;
                        }
                        __MovesComparedRegion1::Again => {
                            outputs_.dose = true;
                            outputs_.stir = true;
                        }
                        _ => {}
                    }
                }
            }
        }
        outputs_
    }
    /// The reading of the clock before which nothing changes unless an input does (or the recipe): a controller
    /// that sleeps until then behaves like one that scans all the time. The reading of the last cycle means
    /// "scan again at once"; `None` means "only an input can change anything".
    #[must_use]
    fn next_deadline(
        &self,
    ) -> Option<Ticks> {
        if !!(self.before_state_idle != self.region_0
            || self.before_state_dose != self.region_1)
        {
            return Option::Some(self.reading);
        }
        let mut soonest_ = Option::None;
        if self.region_0 == __MovesComparedRegion0::Heat
            && self.reading.since(self.since_idle)
                < Ticks::new(1000u32)
        {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(1000u32)
                        - self.reading.since(self.since_idle),
                ),
            );
        }
        if self.region_0 == __MovesComparedRegion0::Heat
            && self.reading.since(self.since_idle)
                < Ticks::new(9000u32)
        {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(9000u32)
                        - self.reading.since(self.since_idle),
                ),
            );
        }
        if self.region_0 == __MovesComparedRegion0::Heat {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    (if rest(
                        self.reading.since(self.since_idle),
                        Ticks::new(800u32),
                    ) < Ticks::new(400u32)
                    {
                        Ticks::new(400u32)
                    } else {
                        Ticks::new(800u32)
                    })
                        - rest(
                            self.reading.since(self.since_idle),
                            Ticks::new(800u32),
                        ),
                ),
            );
        }
        if self.region_1 == __MovesComparedRegion1::Stir
            && self.reading.since(self.since_dose)
                < Ticks::new(2000u32)
        {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(2000u32)
                        - self.reading.since(self.since_dose),
                ),
            );
        }
        if self.region_1 == __MovesComparedRegion1::Stir {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    (if rest(
                        self.reading.since(self.since_dose),
                        Ticks::new(400u32),
                    ) < Ticks::new(200u32)
                    {
                        Ticks::new(200u32)
                    } else {
                        Ticks::new(400u32)
                    })
                        - rest(
                            self.reading.since(self.since_dose),
                            Ticks::new(400u32),
                        ),
                ),
            );
        }
        if self.region_1 == __MovesComparedRegion1::Again
            && self.reading.since(self.since_dose)
                < Ticks::new(500u32)
        {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(500u32)
                        - self.reading.since(self.since_dose),
                ),
            );
        }
        match soonest_ {
            Option::Some(time_) => {
                Option::Some(self.reading.after(time_))
            }
            Option::None => Option::None,
        }
    }
}
