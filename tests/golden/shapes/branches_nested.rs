// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __NestedRegion0 {
    Idle,
    Feed,
    Clamp,
    Clamped,
    Eject,
    Gone,
    INIT,
}
enum __NestedRegion1 {
    Heat,
    Hot,
    NONE,
}
enum __NestedRegion2 {
    Return,
    Home,
    NONE,
}
impl Nested {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &NestedInputs,
        #[cfg(doc)]
        inputs: &NestedInputs,
        #[cfg(not(doc))]
        now_: impl core::convert::Into<
            Ticks,
        >,
        #[cfg(doc)]
        now: impl core::convert::Into<Ticks>,
    ) -> NestedOutputs {
        let now_: Ticks = core::convert::Into::into(
            now_,
        );
        let mut outputs_ = const {
            NestedOutputs {
                ready: false,
                feed: false,
                clamp: false,
                heat: false,
                eject: false,
            }
        };
        self.reading = now_;
        fence_beyond_armv6m();
        match self.region_0 {
            __NestedRegion0::INIT => {
                self.region_0 = __NestedRegion0::Idle;
                outputs_.ready = true;
            }
            __NestedRegion0::Idle => {
                if inputs_.start {
                    self.region_0 = __NestedRegion0::Feed;
                    self.region_2 = __NestedRegion2::Return;
                    self.since_return = self.reading;
                    outputs_.feed = true;
                    self.settled = false;
                } else {
                    outputs_.ready = true;
                    self.settled = true;
                }
            }
            _ => {
                if self.region_0 == __NestedRegion0::Gone
                    && self.region_2 == __NestedRegion2::Home && !inputs_.start
                {
                    outputs_.ready = true;
                    self.settled = false;
                    self.region_2 = __NestedRegion2::NONE;
                    self.region_0 = __NestedRegion0::Idle;
                } else {
                    let mut any_58__: bool = false;
                    match self.region_0 {
                        __NestedRegion0::Feed => {
                            if inputs_.near {
                                self.region_0 = __NestedRegion0::Clamp;
                                self.region_1 = __NestedRegion1::Heat;
                                self.since_heat = self.reading;
                                outputs_.heat = true;
                                outputs_.clamp = true;
                                self.passed_heat = false;
                                any_58__ = true;
                            } else {
                                outputs_.feed = true;
                            }
                        }
                        __NestedRegion0::Eject => {
                            if inputs_.done {
                                self.region_0 = __NestedRegion0::Gone;
                                any_58__ = true;
                            } else {
                                outputs_.eject = true;
                            }
                        }
                        __NestedRegion0::Gone => {}
                        _ => {
                            if self.region_0 == __NestedRegion0::Clamped
                                && self.region_1 == __NestedRegion1::Hot
                            {
                                outputs_.eject = true;
                                any_58__ = true;
                                self.region_1 = __NestedRegion1::NONE;
                                self.region_0 = __NestedRegion0::Eject;
                            } else {
                                match self.region_1 {
                                    __NestedRegion1::Heat => {
                                        if inputs_.hot
                                            && has_reached!(
                                                self.reading.since(self.since_heat),
                                                Ticks::new(1000u32)
                                            )
                                        {
                                            self.region_1 = __NestedRegion1::Hot;
                                            any_58__ = true;
                                        } else {
                                            outputs_.heat = true;
                                            self.passed_heat = self.reading.since(self.since_heat)
                                                >= Ticks::new(1000u32);
                                            if has_reached!(
                                                self.reading.since(self.since_heat),
                                                Ticks::new(1000u32)
                                            ) {
                                                self.since_heat = self
                                                    .reading
                                                    .since(Ticks::new(1000u32));
                                            }
                                        }
                                    }
                                    _ => {}
                                }
                                core::sync::atomic::compiler_fence(
                                    core::sync::atomic::Ordering::SeqCst,
                                );
                                match self.region_0 {
                                    __NestedRegion0::Clamp => {
                                        if inputs_.far {
                                            self.region_0 = __NestedRegion0::Clamped;
                                            outputs_.clamp = true;
                                            any_58__ = true;
                                        } else {
                                            outputs_.clamp = true;
                                        }
                                    }
                                    __NestedRegion0::Clamped => {
                                        outputs_.clamp = true;
                                    }
                                    _ => {}
                                }
                            }
                        }
                    }
                    core::sync::atomic::compiler_fence(
                        core::sync::atomic::Ordering::SeqCst,
                    );
                    match self.region_2 {
                        __NestedRegion2::Return => {
                            if has_reached!(
                                self.reading.since(self.since_return),
                                Ticks::new(2000u32)
                            ) {
                                self.region_2 = __NestedRegion2::Home;
                                any_58__ = true;
                            }
                        }
                        _ => {}
                    }
                    self.settled = !any_58__;
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
        if !self.settled {
            return Option::Some(self.reading);
        }
        let mut soonest_ = Option::None;
        if self.region_1 == __NestedRegion1::Heat && !self.passed_heat {
            soonest_ = earlier(
                soonest_,
                self.since_heat.after(Ticks::new(1000u32)),
            );
        }
        if self.region_2 == __NestedRegion2::Return {
            soonest_ = earlier(
                soonest_,
                self.since_return.after(Ticks::new(2000u32)),
            );
        }
        soonest_
    }
}
