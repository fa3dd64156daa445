// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __HoistsRegion0 {
    Idle,
    WaitA,
    LiftA,
    EndA,
    INIT,
}
enum __HoistsRegion1 {
    WaitB,
    LiftB,
    EndB,
    NONE,
}
impl Hoists {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &HoistsInputs,
        #[cfg(doc)]
        inputs: &HoistsInputs,
        #[cfg(not(doc))]
        now_: impl core::convert::Into<
            Ticks,
        >,
        #[cfg(doc)]
        now: impl core::convert::Into<Ticks>,
    ) -> HoistsOutputs {
        let now_: Ticks = core::convert::Into::into(
            now_,
        );
        let mut outputs_ = const {
            HoistsOutputs {
                lift_a: false,
                lift_b: false,
                ready: false,
            }
        };
        self.before_state_idle = self.region_0;
        self.before_state_waitb = self.region_1;
        let was_state_idle_2__: __HoistsRegion0 = self.region_0;
        match self.region_0 {
            __HoistsRegion0::INIT => {
                self.region_0 = __HoistsRegion0::Idle;
                self.since_waitb = now_;
                outputs_.ready = true;
            }
            __HoistsRegion0::Idle => {
                if inputs_.start {
                    self.region_0 = __HoistsRegion0::WaitA;
                    self.region_1 = __HoistsRegion1::WaitB;
                    self.since_waitb = now_;
                } else {
                    outputs_.ready = true;
                }
            }
            _ => {
                if self.region_0 == __HoistsRegion0::EndA
                    && self.region_1 == __HoistsRegion1::EndB && inputs_.done
                {
                    outputs_.ready = true;
                    self.region_1 = __HoistsRegion1::NONE;
                    self.region_0 = __HoistsRegion0::Idle;
                } else {
                    let was_state_idle_: __HoistsRegion0 = self.region_0;
                    match self.region_0 {
                        __HoistsRegion0::WaitA => {
                            if inputs_.call_a && self.region_1 != __HoistsRegion1::LiftB
                            {
                                self.region_0 = __HoistsRegion0::LiftA;
                                outputs_.lift_a = true;
                            }
                        }
                        __HoistsRegion0::LiftA => {
                            if has_reached!(
                                now_.since(self.since_idle),
                                Ticks::new(2000u32)
                            ) {
                                if inputs_.up {
                                    self.region_0 = __HoistsRegion0::EndA;
                                } else {
                                    outputs_.lift_a = true;
                                    self.since_idle = now_
                                        .since(Ticks::new(2000u32));
                                    self.before_state_idle = __HoistsRegion0::Idle;
                                }
                            } else {
                                outputs_.lift_a = true;
                            }
                        }
                        _ => {}
                    }
                    core::sync::atomic::compiler_fence(
                        core::sync::atomic::Ordering::SeqCst,
                    );
                    match self.region_1 {
                        __HoistsRegion1::WaitB => {
                            if inputs_.call_b
                                && was_state_idle_ != __HoistsRegion0::LiftA
                                && was_state_idle_ != __HoistsRegion0::WaitA
                            {
                                self.region_1 = __HoistsRegion1::LiftB;
                                self.since_waitb = now_;
                                outputs_.lift_b = true;
                            }
                        }
                        __HoistsRegion1::LiftB => {
                            if has_reached!(
                                now_.since(self.since_waitb),
                                Ticks::new(1000u32)
                            ) {
                                if inputs_.down {
                                    self.region_1 = __HoistsRegion1::EndB;
                                    self.since_waitb = now_;
                                } else {
                                    outputs_.lift_b = true;
                                    self.since_waitb = now_
                                        .since(Ticks::new(1000u32));
                                    self.before_state_waitb = __HoistsRegion1::EndB;
                                }
                            } else {
                                outputs_.lift_b = true;
                            }
                        }
                        _ => {}
                    }
                }
            }
        }
        if was_state_idle_2__ != self.region_0 {
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
            && !(self.region_0 == __HoistsRegion0::LiftA
                && self.before_state_idle == __HoistsRegion0::Idle)
            || self.before_state_waitb != self.region_1
                && !(self.region_1 == __HoistsRegion1::LiftB
                    && self.before_state_waitb == __HoistsRegion1::EndB)
        {
            return Option::Some(
                if self.before_state_idle != self.region_0
                    && !(self.region_0 == __HoistsRegion0::LiftA
                        && self.before_state_idle == __HoistsRegion0::Idle)
                {
                    self.since_idle
                } else {
                    self.since_waitb
                },
            );
        }
        let mut soonest_ = Option::None;
        if self.region_0 == __HoistsRegion0::LiftA
            && !(self.before_state_idle == __HoistsRegion0::Idle)
        {
            soonest_ = earlier(
                soonest_,
                self.since_idle.after(Ticks::new(2000u32)),
            );
        }
        if self.region_1 == __HoistsRegion1::LiftB
            && !(self.before_state_waitb == __HoistsRegion1::EndB)
        {
            soonest_ = earlier(
                soonest_,
                self.since_waitb.after(Ticks::new(1000u32)),
            );
        }
        soonest_
    }
}
