// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __KettleRegion0 {
    Idle,
    Heat,
    Hold,
    Heated,
    INIT,
}
enum __KettleRegion1 {
    Fill,
    Stir,
    Rest,
    Stirred,
    NONE,
}
impl Kettle {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &KettleInputs,
        #[cfg(doc)]
        inputs: &KettleInputs,
        #[cfg(not(doc))]
        now_: impl core::convert::Into<
            Ticks,
        >,
        #[cfg(doc)]
        now: impl core::convert::Into<Ticks>,
    ) -> KettleOutputs {
        let now_: Ticks = core::convert::Into::into(
            now_,
        );
        let mut outputs_ = const {
            KettleOutputs {
                heater: false,
                valve: false,
                stirrer: false,
                ready: false,
            }
        };
        self.before_state_idle = self.region_0;
        self.before_state_fill = self.region_1;
        let was_state_idle_: __KettleRegion0 = self.region_0;
        match self.region_0 {
            __KettleRegion0::INIT => {
                self.region_0 = __KettleRegion0::Idle;
                self.since_fill = now_;
            }
            __KettleRegion0::Idle => {
                if inputs_.start {
                    self.region_0 = __KettleRegion0::Heat;
                    self.region_1 = __KettleRegion1::Fill;
                    self.since_fill = now_;
                    outputs_.valve = true;
                    outputs_.heater = true;
                }
            }
            _ => {
                if self.region_0 == __KettleRegion0::Heated
                    && self.region_1 == __KettleRegion1::Stirred && !inputs_.start
                {
                    self.s_ff_ready = false;
                    self.region_1 = __KettleRegion1::NONE;
                    self.region_0 = __KettleRegion0::Idle;
                } else {
                    let mut on_stirred_5__: bool = false;
                    match self.region_1 {
                        __KettleRegion1::Fill => {
                            if has_reached!(
                                now_.since(self.since_fill),
                                Ticks::new(1000u32)
                            ) {
                                if inputs_.full {
                                    self.region_1 = __KettleRegion1::Stir;
                                    self.since_fill = now_;
                                    outputs_.stirrer = true;
                                } else {
                                    outputs_.valve = true;
                                    self.since_fill = now_
                                        .since(Ticks::new(1000u32));
                                    self.before_state_fill = __KettleRegion1::Stir;
                                }
                            } else {
                                outputs_.valve = true;
                            }
                        }
                        __KettleRegion1::Stir => {
                            if has_reached!(
                                now_.since(self.since_fill),
                                Ticks::new(3000u32)
                            ) {
                                self.region_1 = __KettleRegion1::Rest;
                                self.since_fill = now_;
                            } else {
                                outputs_.stirrer = true;
                            }
                        }
                        __KettleRegion1::Rest => {
                            if has_reached!(
                                now_.since(self.since_fill),
                                Ticks::new(2000u32)
                            ) {
                                self.region_1 = __KettleRegion1::Stirred;
                                self.since_fill = now_;
                                on_stirred_5__ = true;
                            }
                        }
                        __KettleRegion1::Stirred => {
                            on_stirred_5__ = true;
                        }
                        _ => {}
                    }
                    core::sync::atomic::compiler_fence(
                        core::sync::atomic::Ordering::SeqCst,
                    );
                    match self.region_0 {
                        __KettleRegion0::Heat => {
                            if inputs_.hot {
                                self.region_0 = __KettleRegion0::Hold;
                                outputs_.heater = false;
                            } else {
                                outputs_.heater = true;
                            }
                        }
                        __KettleRegion0::Hold => {
                            if has_reached!(
                                now_.since(self.since_idle),
                                Ticks::new(5000u32)
                            ) {
                                self.region_0 = __KettleRegion0::Heated;
                            } else {
                                outputs_.heater = !inputs_.hot;
                            }
                        }
                        _ => {}
                    }
                    self.s_ff_ready = on_stirred_5__ || self.s_ff_ready;
                    outputs_.ready = self.s_ff_ready;
                }
            }
        }
        if was_state_idle_ != self.region_0 {
            self.since_idle = now_;
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
        if self.before_state_idle != self.region_0
            || self.before_state_fill != self.region_1
                && !(self.region_1 == __KettleRegion1::Fill
                    && self.before_state_fill == __KettleRegion1::Stir)
        {
            return Option::Some(
                if self.before_state_idle != self.region_0 {
                    self.since_idle
                } else {
                    self.since_fill
                },
            );
        }
        let mut soonest_ = Option::None;
        if self.region_0 == __KettleRegion0::Hold {
            soonest_ = earlier(
                soonest_,
                self.since_idle.after(Ticks::new(5000u32)),
            );
        }
        if self.region_1 == __KettleRegion1::Fill
            && !(self.before_state_fill == __KettleRegion1::Stir)
        {
            soonest_ = earlier(
                soonest_,
                self.since_fill.after(Ticks::new(1000u32)),
            );
        }
        if self.region_1 == __KettleRegion1::Stir {
            soonest_ = earlier(
                soonest_,
                self.since_fill.after(Ticks::new(3000u32)),
            );
        }
        if self.region_1 == __KettleRegion1::Rest {
            soonest_ = earlier(
                soonest_,
                self.since_fill.after(Ticks::new(2000u32)),
            );
        }
        soonest_
    }
}
