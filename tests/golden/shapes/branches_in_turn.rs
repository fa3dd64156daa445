// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __BranchesInTurnRegion0 {
    Idle,
    Fill,
    Filled,
    Mix,
    Rest,
    Rested,
    Rinse,
    Dry,
    Dried,
    Open,
    Shake,
    Shaken,
    Close,
    INIT,
}
enum __BranchesInTurnRegion1 {
    Warm,
    Warmed,
    Drain,
    Drained,
    Cool,
    Cooled,
    Blow,
    Blown,
    NONE,
}
impl BranchesInTurn {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &BranchesInTurnInputs,
        #[cfg(doc)]
        inputs: &BranchesInTurnInputs,
        #[cfg(not(doc))]
        now_: impl core::convert::Into<
            Ticks,
        >,
        #[cfg(doc)]
        now: impl core::convert::Into<Ticks>,
    ) -> BranchesInTurnOutputs {
        let now_: Ticks = core::convert::Into::into(
            now_,
        );
        let mut outputs_ = BranchesInTurnOutputs {
            valve: false,
            heater: false,
            pump: false,
            lamp: false,
            batches: 0,
        };
        self.reading = now_;
        fence_beyond_armv6m();
        match self.region_0 {
            __BranchesInTurnRegion0::INIT => {
                self.region_0 = __BranchesInTurnRegion0::Idle;
            }
            _ => {
                let last_batches_: core::primitive::u8;
                let mut any_119__: bool = false;
                if inputs_.stop {
                    last_batches_ = self.batches;
                    match self.region_0 {
                        __BranchesInTurnRegion0::Idle => {
                            if inputs_.start {
                                self.region_0 = __BranchesInTurnRegion0::Fill;
                                self.region_1 = __BranchesInTurnRegion1::Warm;
                                self.since_warm = self.reading;
                                outputs_.valve = true;
                                outputs_.heater = true;
                                self.passed_warm = false;
                                any_119__ = true;
                            }
                        }
                        __BranchesInTurnRegion0::Mix
                        | __BranchesInTurnRegion0::Rinse
                        | __BranchesInTurnRegion0::Open
                        | __BranchesInTurnRegion0::Close => {
                            self.region_0 = __BranchesInTurnRegion0::Idle;
                            self.s_ff_lamp = false;
                            any_119__ = true;
                        }
                        _ => {
                            self.s_ff_lamp = false;
                            self.region_0 = __BranchesInTurnRegion0::Idle;
                            any_119__ = true;
                            match self.region_1 {
                                __BranchesInTurnRegion1::Warm
                                | __BranchesInTurnRegion1::Warmed
                                | __BranchesInTurnRegion1::Drained
                                | __BranchesInTurnRegion1::Cool
                                | __BranchesInTurnRegion1::Cooled
                                | __BranchesInTurnRegion1::Blow
                                | __BranchesInTurnRegion1::Blown => {
                                    self.region_1 = __BranchesInTurnRegion1::NONE;
                                }
                                __BranchesInTurnRegion1::Drain => {
                                    self.region_1 = __BranchesInTurnRegion1::NONE;
                                    self.batches = {
                                        let batches = self.batches;
                                        batches % 60 + 2
                                    };
                                }
                                _ => {}
                            }
                        }
                    }
                } else {
                    last_batches_ = self.batches;
                    match self.region_0 {
                        __BranchesInTurnRegion0::Idle => {
                            if inputs_.start {
                                self.region_0 = __BranchesInTurnRegion0::Fill;
                                self.region_1 = __BranchesInTurnRegion1::Warm;
                                self.since_warm = self.reading;
                                outputs_.valve = true;
                                outputs_.heater = true;
                                self.passed_warm = false;
                                any_119__ = true;
                            }
                        }
                        __BranchesInTurnRegion0::Mix => {
                            if inputs_.start {
                                self.region_0 = __BranchesInTurnRegion0::Rest;
                                self.region_1 = __BranchesInTurnRegion1::Drain;
                                self.since_idle = self.reading;
                                outputs_.pump = true;
                                any_119__ = true;
                            }
                        }
                        __BranchesInTurnRegion0::Rinse => {
                            if inputs_.full {
                                self.region_0 = __BranchesInTurnRegion0::Dry;
                                self.region_1 = __BranchesInTurnRegion1::Cool;
                                self.since_warm = self.reading;
                                self.s_ff_lamp = true;
                                outputs_.heater = true;
                                any_119__ = true;
                            } else {
                                outputs_.valve = true;
                            }
                        }
                        __BranchesInTurnRegion0::Open => {
                            if inputs_.start {
                                self.region_0 = __BranchesInTurnRegion0::Shake;
                                self.region_1 = __BranchesInTurnRegion1::Blow;
                                outputs_.pump = true;
                                any_119__ = true;
                            } else {
                                outputs_.lamp = true;
                            }
                        }
                        __BranchesInTurnRegion0::Close => {
                            if !inputs_.start {
                                self.region_0 = __BranchesInTurnRegion0::Idle;
                                self.s_ff_lamp = false;
                                any_119__ = true;
                            }
                        }
                        _ => {
                            let was_state_warm_: __BranchesInTurnRegion1 = self.region_1;
                            let mut left_drain_: bool = false;
                            let mut entered_mix_: bool = false;
                            let mut any_117__: bool = false;
                            let mut any_118__: bool = false;
                            any_119__ = false;
                            match self.region_0 {
                                __BranchesInTurnRegion0::Fill => {
                                    if inputs_.full {
                                        any_117__ = true;
                                        any_119__ = true;
                                        self.region_0 = __BranchesInTurnRegion0::Filled;
                                    }
                                }
                                __BranchesInTurnRegion0::Filled => {
                                    if self.region_1 == __BranchesInTurnRegion1::Warmed {
                                        entered_mix_ = true;
                                        any_117__ = true;
                                        any_119__ = true;
                                        self.region_1 = __BranchesInTurnRegion1::NONE;
                                        self.region_0 = __BranchesInTurnRegion0::Mix;
                                    }
                                }
                                __BranchesInTurnRegion0::Rest => {
                                    if has_reached!(
                                        self.reading.since(self.since_idle),
                                        Ticks::new(9u32)
                                    ) {
                                        any_117__ = true;
                                        any_119__ = true;
                                        self.region_0 = __BranchesInTurnRegion0::Rested;
                                    }
                                }
                                __BranchesInTurnRegion0::Rested => {
                                    if self.region_1 == __BranchesInTurnRegion1::Drained
                                        && inputs_.start
                                    {
                                        any_117__ = true;
                                        any_119__ = true;
                                        self.region_1 = __BranchesInTurnRegion1::NONE;
                                        self.region_0 = __BranchesInTurnRegion0::Rinse;
                                    }
                                }
                                __BranchesInTurnRegion0::Dry => {
                                    if inputs_.warm {
                                        any_117__ = true;
                                        any_119__ = true;
                                        self.region_0 = __BranchesInTurnRegion0::Dried;
                                    }
                                }
                                __BranchesInTurnRegion0::Dried => {
                                    if self.region_1 == __BranchesInTurnRegion1::Cooled {
                                        any_117__ = true;
                                        any_119__ = true;
                                        self.region_1 = __BranchesInTurnRegion1::NONE;
                                        self.region_0 = __BranchesInTurnRegion0::Open;
                                    }
                                }
                                __BranchesInTurnRegion0::Shake => {
                                    if inputs_.full {
                                        any_117__ = true;
                                        any_119__ = true;
                                        self.region_0 = __BranchesInTurnRegion0::Shaken;
                                    }
                                }
                                __BranchesInTurnRegion0::Shaken => {
                                    if self.region_1 == __BranchesInTurnRegion1::Blown
                                        && inputs_.start
                                    {
                                        any_117__ = true;
                                        any_119__ = true;
                                        self.region_1 = __BranchesInTurnRegion1::NONE;
                                        self.region_0 = __BranchesInTurnRegion0::Close;
                                    }
                                }
                                _ => {}
                            }
                            core::sync::atomic::compiler_fence(
                                core::sync::atomic::Ordering::SeqCst,
                            );
                            match self.region_1 {
                                __BranchesInTurnRegion1::Warm => {
                                    if inputs_.warm
                                        && has_reached!(
                                            self.reading.since(self.since_warm),
                                            Ticks::new(5u32)
                                        )
                                    {
                                        any_118__ = true;
                                        any_119__ = true;
                                        self.region_1 = __BranchesInTurnRegion1::Warmed;
                                    }
                                }
                                __BranchesInTurnRegion1::Drain => {
                                    if inputs_.empty {
                                        left_drain_ = true;
                                        any_118__ = true;
                                        any_119__ = true;
                                        self.region_1 = __BranchesInTurnRegion1::Drained;
                                    }
                                }
                                __BranchesInTurnRegion1::Cool => {
                                    if has_reached!(
                                        self.reading.since(self.since_warm),
                                        Ticks::new(7u32)
                                    ) {
                                        any_118__ = true;
                                        any_119__ = true;
                                        self.region_1 = __BranchesInTurnRegion1::Cooled;
                                    }
                                }
                                __BranchesInTurnRegion1::Blow => {
                                    if inputs_.empty {
                                        any_118__ = true;
                                        any_119__ = true;
                                        self.region_1 = __BranchesInTurnRegion1::Blown;
                                    }
                                }
                                _ => {}
                            }
                            if any_117__ {
                                self.since_idle = self.reading;
                            }
                            if any_118__ {
                                self.since_warm = self.reading;
                            }
                            if left_drain_ {
                                self.batches = {
                                    let batches = self.batches;
                                    batches % 60 + 2
                                };
                            }
                            if entered_mix_ {
                                self.batches = {
                                    let batches = last_batches_;
                                    batches % 50 + 1
                                };
                            }
                            match self.region_0 {
                                __BranchesInTurnRegion0::Idle => {
                                    self.s_ff_lamp = false;
                                }
                                __BranchesInTurnRegion0::Fill
                                | __BranchesInTurnRegion0::Rinse => {
                                    outputs_.valve = true;
                                }
                                __BranchesInTurnRegion0::Dry => {
                                    outputs_.heater = true;
                                }
                                __BranchesInTurnRegion0::Open => {
                                    outputs_.lamp = true;
                                }
                                _ => {}
                            }
                            core::sync::atomic::compiler_fence(
                                core::sync::atomic::Ordering::SeqCst,
                            );
                            match self.region_1 {
                                __BranchesInTurnRegion1::Warm => {
                                    outputs_.heater = true;
                                    self.passed_warm = was_state_warm_
                                        == __BranchesInTurnRegion1::Warm
                                        && self.reading.since(self.since_warm)
                                            >= Ticks::new(5u32);
                                    if was_state_warm_ == __BranchesInTurnRegion1::Warm
                                        && has_reached!(
                                            self.reading.since(self.since_warm),
                                            Ticks::new(5u32)
                                        )
                                    {
                                        self.since_warm = self
                                            .reading
                                            .since(Ticks::new(5u32));
                                    }
                                }
                                __BranchesInTurnRegion1::Drain
                                | __BranchesInTurnRegion1::Blow => {
                                    outputs_.pump = true;
                                }
                                _ => {}
                            }
                        }
                    }
                }
                any_119__ = any_119__ || self.batches != last_batches_;
                self.settled = !any_119__;
            }
        }
        if self.s_ff_lamp {
            outputs_.lamp = true;
        }
        outputs_.batches = self.batches;
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
        if self.region_1 == __BranchesInTurnRegion1::Warm && !self.passed_warm {
            soonest_ = earlier(
                soonest_,
                self.since_warm.after(Ticks::new(5u32)),
            );
        }
        if self.region_0 == __BranchesInTurnRegion0::Rest {
            soonest_ = earlier(
                soonest_,
                self.since_idle.after(Ticks::new(9u32)),
            );
        }
        if self.region_1 == __BranchesInTurnRegion1::Cool {
            soonest_ = earlier(
                soonest_,
                self.since_warm.after(Ticks::new(7u32)),
            );
        }
        soonest_
    }
}
