// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __LiftRegion0 {
    Listen,
    Home,
}
enum __LiftRegion1 {
    Below,
    Above,
    Rise,
    Sink,
    Serve0,
    Serve1,
    Close0,
    Close1,
    NONE,
    INIT,
}
impl Lift {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &LiftInputs,
        #[cfg(doc)]
        inputs: &LiftInputs,
        #[cfg(not(doc))]
        now_: impl core::convert::Into<
            Ticks,
        >,
        #[cfg(doc)]
        now: impl core::convert::Into<Ticks>,
    ) -> LiftOutputs {
        let now_: Ticks = core::convert::Into::into(
            now_,
        );
        let mut outputs_ = const {
            LiftOutputs {
                up: false,
                down: false,
                door: false,
                lamp0: false,
                lamp1: false,
            }
        };
        self.reading = now_;
        fence_beyond_armv6m();
        let passed_: Ticks = self.reading.since(self.since_below);
        let mut any_63__: bool = false;
        match self.region_1 {
            __LiftRegion1::INIT => {
                self.region_1 = __LiftRegion1::NONE;
                any_63__ = true;
            }
            __LiftRegion1::Below => {
                if self.lamp0_ {
                    self.region_1 = __LiftRegion1::Serve0;
                    any_63__ = true;
                } else {
                    if self.lamp1_ {
                        self.region_1 = __LiftRegion1::Rise;
                        any_63__ = true;
                    }
                }
            }
            __LiftRegion1::Above => {
                if self.lamp1_ {
                    self.region_1 = __LiftRegion1::Serve1;
                    any_63__ = true;
                } else {
                    if self.lamp0_ {
                        self.region_1 = __LiftRegion1::Sink;
                        any_63__ = true;
                    }
                }
            }
            __LiftRegion1::Rise => {
                if inputs_.at1 {
                    self.region_1 = __LiftRegion1::Serve1;
                    any_63__ = true;
                }
            }
            __LiftRegion1::Sink => {
                if inputs_.at0 {
                    self.region_1 = __LiftRegion1::Serve0;
                    any_63__ = true;
                }
            }
            __LiftRegion1::Serve0 => {
                if inputs_.open {
                    self.region_1 = __LiftRegion1::Close0;
                    self.since_below = self.reading;
                    any_63__ = true;
                }
            }
            __LiftRegion1::Serve1 => {
                if inputs_.open {
                    self.region_1 = __LiftRegion1::Close1;
                    self.since_below = self.reading;
                    any_63__ = true;
                }
            }
            __LiftRegion1::Close0 => {
                if inputs_.shut {
                    self.region_1 = __LiftRegion1::Below;
                    any_63__ = true;
                } else {
                    if has_reached!(
                        passed_, Ticks::new(3000u32)
                    ) {
                        self.region_1 = __LiftRegion1::Serve0;
                        any_63__ = true;
                    }
                }
            }
            __LiftRegion1::Close1 => {
                if inputs_.shut {
                    self.region_1 = __LiftRegion1::Above;
                    any_63__ = true;
                } else {
                    if has_reached!(
                        passed_, Ticks::new(3000u32)
                    ) {
                        self.region_1 = __LiftRegion1::Serve1;
                        any_63__ = true;
                    }
                }
            }
            _ => {
                match self.region_0 {
                    __LiftRegion0::Home => {
                        if inputs_.at0 {
                            self.region_0 = __LiftRegion0::Listen;
                            self.region_1 = __LiftRegion1::Below;
                            any_63__ = true;
                        }
                    }
                    _ => {}
                }
            }
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        let last_lamp0__: bool = self.lamp0_;
        let last_lamp1__: bool = self.lamp1_;
        let mut on_listen_0__: bool = false;
        let mut on_listen_1__: bool = false;
        match self.region_0 {
            __LiftRegion0::Listen => {
                on_listen_0__ = true;
                on_listen_1__ = true;
                match self.region_1 {
                    __LiftRegion1::Rise => {
                        outputs_.up = true;
                    }
                    __LiftRegion1::Sink => {
                        outputs_.down = true;
                    }
                    __LiftRegion1::Serve0 | __LiftRegion1::Serve1 => {
                        outputs_.door = true;
                    }
                    _ => {}
                }
            }
            __LiftRegion0::Home => {
                outputs_.down = true;
            }
        }
        if on_listen_0__ {
            self.lamp0_ = (self.lamp0_ || inputs_.call0)
                && self.region_1 != __LiftRegion1::Serve0;
        } else {
            self.lamp0_ = false;
        }
        if on_listen_1__ {
            self.lamp1_ = (self.lamp1_ || inputs_.call1)
                && self.region_1 != __LiftRegion1::Serve1;
        } else {
            self.lamp1_ = false;
        }
        any_63__ = any_63__ || self.lamp0_ != last_lamp0__;
        any_63__ = any_63__ || self.lamp1_ != last_lamp1__;
        self.settled = !any_63__;
        outputs_.lamp0 = self.lamp0_;
        outputs_.lamp1 = self.lamp1_;
        outputs_
    }
    /// The reading of the clock before which nothing changes unless an input does (or the recipe): a controller
    /// that sleeps until then behaves like one that scans all the time. The reading of the last cycle means
    /// "scan again at once"; `None` means "only an input can change anything".
    #[must_use]
    fn next_deadline(
        &self,
    ) -> Option<Ticks> {
        if !self.settled {
            return Option::Some(self.reading);
        }
        let mut soonest_ = Option::None;
        if self.region_1 == __LiftRegion1::Close0 {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(3000u32),
                ),
            );
        }
        if self.region_1 == __LiftRegion1::Close1 {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(3000u32),
                ),
            );
        }
        match soonest_ {
            Option::Some(time_) => {
                Option::Some(self.since_below.after(time_))
            }
            Option::None => Option::None,
        }
    }
}
