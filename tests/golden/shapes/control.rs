// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __WorksRegion0 {
    Idle,
    One,
    Two,
    INIT,
}
enum __WorksRegion1 {
    Three,
    Four,
    NONE,
}
impl Works {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &WorksInputs,
        #[cfg(doc)]
        inputs: &WorksInputs,
        #[cfg(not(doc))]
        now_: impl core::convert::Into<
            Ticks,
        >,
        #[cfg(doc)]
        now: impl core::convert::Into<Ticks>,
    ) -> WorksOutputs {
        let now_: Ticks = core::convert::Into::into(
            now_,
        );
        let mut outputs_ = WorksOutputs {
            held: false,
            late: false,
            slow: false,
            lamp: false,
            count: 3,
        };
        if inputs_.c {
            if self.delay0_stage == 3 {
                self.delay0_stage = 2;
            } else {
                if self.delay0_stage == 0 {
                    self.delay0_since = now_;
                    self.delay0_stage = 1;
                } else {
                    if self.delay0_stage == 1
                        && has_reached!(
                            now_.since(self.delay0_since),
                            Ticks::new(20u32)
                        )
                    {
                        self.delay0_stage = 2;
                    }
                }
            }
        } else {
            if self.delay0_stage == 1 {
                self.delay0_stage = 0;
            } else {
                if self.delay0_stage == 2 {
                    self.delay0_since = now_;
                    self.delay0_stage = 3;
                } else {
                    if self.delay0_stage == 3
                        && has_reached!(
                            now_.since(self.delay0_since),
                            Ticks::new(30u32)
                        )
                    {
                        self.delay0_stage = 0;
                    }
                }
            }
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        self.reading = now_;
        fence_beyond_armv6m();
        match self.region_0 {
            __WorksRegion0::INIT => {
                self.region_0 = __WorksRegion0::Idle;
                self.since_three = self.reading;
                self.since_idle = self.reading;
            }
            _ => {
                let last_count_: core::primitive::u16 = self.count;
                let mut turned_: bool = false;
                let mut on_idle_1__: bool = false;
                let mut any_66__: bool = false;
                match self.region_0 {
                    __WorksRegion0::Idle => {
                        if !self.edge1_before && inputs_.a {
                            self.region_0 = __WorksRegion0::One;
                            self.region_1 = __WorksRegion1::Three;
                            self.since_idle = self.reading;
                            self.since_three = self.reading;
                            self.s_ff_held = true;
                            outputs_.held = true;
                            self.sd_ff_late = true;
                            outputs_.slow = self.ds_ff_slow;
                            outputs_.lamp = true;
                            self.count = {
                                let count = self.count;
                                count % 900 + 7
                            };
                            if self.was_q_four_9_ {
                                self.count = {
                                    let count = last_count_;
                                    count % 900 + 1
                                };
                            }
                            self.was_q_four_9_ = false;
                            any_66__ = true;
                        } else {
                            on_idle_1__ = true;
                            self.s_ff_held = false;
                            self.sd_ff_late = false;
                            self.ds_ff_slow = false;
                            if self.was_q_four_9_ {
                                self.count = {
                                    let count = last_count_;
                                    count % 900 + 1
                                };
                            }
                            turned_ = self.was_q_four_9_;
                            self.was_q_four_9_ = false;
                            any_66__ = turned_;
                        }
                    }
                    _ => {
                        if self.region_0 == __WorksRegion0::Two
                            && self.region_1 == __WorksRegion1::Three
                            && self.delay0_stage < 2
                            && (!inputs_.a
                                || has_reached!(
                                    self.reading.since(self.since_idle),
                                    Ticks::new(4000u32)
                                ))
                        {
                            self.since_idle = self.reading;
                            on_idle_1__ = true;
                            self.s_ff_held = false;
                            self.sd_ff_late = false;
                            self.ds_ff_slow = false;
                            if self.was_q_four_9_ {
                                self.count = {
                                    let count = last_count_;
                                    count % 900 + 1
                                };
                            }
                            self.was_q_four_9_ = false;
                            any_66__ = true;
                            self.region_1 = __WorksRegion1::NONE;
                            self.region_0 = __WorksRegion0::Idle;
                        } else {
                            match self.region_0 {
                                __WorksRegion0::One => {
                                    if inputs_.b
                                        && ({
                                            let since_1_ = self.reading.since(self.since_idle);
                                            let ticks_15_ = Ticks::new(15u32);
                                            since_1_ > ticks_15_
                                        })
                                    {
                                        self.region_0 = __WorksRegion0::Two;
                                        self.since_idle = self.reading;
                                        outputs_.held = self.s_ff_held;
                                        any_66__ = true;
                                    } else {
                                        self.s_ff_held = true;
                                        outputs_.held = true;
                                        self.sd_ff_late = true;
                                        outputs_.lamp = self.reading.since(self.since_idle)
                                            < Ticks::new(40u32);
                                        if has_reached!(
                                            self.reading.since(self.since_idle),
                                            Ticks::new(40u32)
                                        ) {
                                            self.since_idle = self
                                                .reading
                                                .since(Ticks::new(40u32));
                                        }
                                    }
                                }
                                __WorksRegion0::Two => {
                                    outputs_.held = self.s_ff_held;
                                    outputs_.lamp = self.reading.since(self.since_idle)
                                        >= Ticks::new(30u32);
                                    if has_reached!(
                                        self.reading.since(self.since_idle),
                                        Ticks::new(4000u32)
                                    ) {
                                        self.since_idle = self
                                            .reading
                                            .since(Ticks::new(4000u32));
                                    }
                                }
                                _ => {}
                            }
                            core::sync::atomic::compiler_fence(
                                core::sync::atomic::Ordering::SeqCst,
                            );
                            let mut was_state_three_: __WorksRegion1 = __WorksRegion1::NONE;
                            match self.region_1 {
                                __WorksRegion1::Three => {
                                    was_state_three_ = __WorksRegion1::Three;
                                    if self.delay0_stage >= 2 {
                                        self.region_1 = __WorksRegion1::Four;
                                        self.since_three = self.reading;
                                        let q_four_9__: bool = !self
                                            .action_edge0_before && inputs_.b;
                                        if q_four_9__ {
                                            self.count = {
                                                let count = last_count_;
                                                count % 900 + 1
                                            };
                                        } else {
                                            if self.was_q_four_9_ {
                                                self.count = {
                                                    let count = last_count_;
                                                    count % 900 + 1
                                                };
                                            }
                                        }
                                        self.was_q_four_9_ = q_four_9__;
                                        any_66__ = true;
                                    } else {
                                        any_66__ = any_66__ || self.was_q_four_9_;
                                    }
                                }
                                __WorksRegion1::Four => {
                                    was_state_three_ = __WorksRegion1::Four;
                                    if self.edge2_before && !inputs_.c {
                                        self.region_1 = __WorksRegion1::Three;
                                        self.since_three = self.reading;
                                        self.count = {
                                            let count = self.count;
                                            count % 900 + 7
                                        };
                                        any_66__ = true;
                                    } else {
                                        if self.was_q_four_9_ {
                                            self.count = {
                                                let count = last_count_;
                                                count % 900 + 1
                                            };
                                        }
                                        turned_ = self.was_q_four_9_;
                                        self.was_q_four_9_ = false;
                                        any_66__ = any_66__
                                            || !self.action_edge0_before && inputs_.b;
                                        any_66__ = any_66__ || turned_;
                                    }
                                }
                                _ => {}
                            }
                            let mut on_three_8__: bool = false;
                            match self.region_1 {
                                __WorksRegion1::Three => {
                                    on_three_8__ = true;
                                    if self.was_q_four_9_ {
                                        self.count = {
                                            let count = last_count_;
                                            count % 900 + 1
                                        };
                                    }
                                    self.was_q_four_9_ = false;
                                }
                                __WorksRegion1::NONE => {
                                    if self.was_q_four_9_ {
                                        self.count = {
                                            let count = last_count_;
                                            count % 900 + 1
                                        };
                                    }
                                    turned_ = self.was_q_four_9_;
                                    self.was_q_four_9_ = false;
                                    any_66__ = any_66__ || turned_;
                                }
                                _ => {}
                            }
                            self.ds_ff_slow = on_three_8__
                                && self.reading.since(self.since_three)
                                    >= Ticks::new(20u32)
                                || self.ds_ff_slow;
                            outputs_.slow = self.ds_ff_slow;
                            if was_state_three_ == __WorksRegion1::Three
                                && self.region_1 == __WorksRegion1::Three
                                && has_reached!(
                                    self.reading.since(self.since_three),
                                    Ticks::new(20u32)
                                )
                            {
                                self.since_three = self
                                    .reading
                                    .since(Ticks::new(20u32));
                            }
                        }
                    }
                }
                if self.sd_ff_late {
                    if self.sd_tmr_late_stage == 0 {
                        self.sd_tmr_late_since = self.reading;
                        self.sd_tmr_late_stage = 1;
                    } else {
                        if self.sd_tmr_late_stage == 1
                            && has_reached!(
                                self.reading.since(self.sd_tmr_late_since),
                                Ticks::new(2000u32)
                            )
                        {
                            self.sd_tmr_late_stage = 2;
                        }
                    }
                } else {
                    self.sd_tmr_late_stage = 0;
                }
                any_66__ = any_66__ || self.count != last_count_;
                outputs_.late = !on_idle_1__ && self.sd_tmr_late_stage == 2;
                self.settled = !any_66__;
            }
        }
        self.edge1_before = inputs_.a;
        self.edge2_before = inputs_.c;
        self.action_edge0_before = inputs_.b;
        outputs_.count = self.count;
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
        if self.region_0 == __WorksRegion0::One
            && self.reading.since(self.since_idle)
                < Ticks::new(40u32)
        {
            soonest_ = earlier(
                soonest_,
                self
                    .reading
                    .after(
                        Ticks::new(40u32)
                            - self.reading.since(self.since_idle),
                    ),
            );
        }
        if self.region_0 == __WorksRegion0::One
            && self.reading.since(self.since_idle)
                < Ticks::new(16u32)
        {
            soonest_ = earlier(
                soonest_,
                self
                    .reading
                    .after(
                        Ticks::new(16u32)
                            - self.reading.since(self.since_idle),
                    ),
            );
        }
        if self.region_0 == __WorksRegion0::Two
            && self.reading.since(self.since_idle)
                < Ticks::new(30u32)
        {
            soonest_ = earlier(
                soonest_,
                self
                    .reading
                    .after(
                        Ticks::new(30u32)
                            - self.reading.since(self.since_idle),
                    ),
            );
        }
        if self.region_0 == __WorksRegion0::Two
            && self.reading.since(self.since_idle)
                < Ticks::new(4000u32)
        {
            soonest_ = earlier(
                soonest_,
                self
                    .reading
                    .after(
                        Ticks::new(4000u32)
                            - self.reading.since(self.since_idle),
                    ),
            );
        }
        if self.region_1 == __WorksRegion1::Three
            && self.reading.since(self.since_three)
                < Ticks::new(20u32)
        {
            soonest_ = earlier(
                soonest_,
                self
                    .reading
                    .after(
                        Ticks::new(20u32)
                            - self.reading.since(self.since_three),
                    ),
            );
        }
        if self.delay0_stage == 1 {
            soonest_ = earlier(
                soonest_,
                self.delay0_since.after(Ticks::new(20u32)),
            );
        }
        if self.delay0_stage == 3 {
            soonest_ = earlier(
                soonest_,
                self.delay0_since.after(Ticks::new(30u32)),
            );
        }
        if self.sd_tmr_late_stage == 1 {
            soonest_ = earlier(
                soonest_,
                self.sd_tmr_late_since.after(Ticks::new(2000u32)),
            );
        }
        soonest_
    }
}
impl Works {
    /// One cycle that leads into a situation by hand, whatever the transition conditions say (decision A38): no transition clears, steps that
    /// are not named are left, named ones entered, each with its actions, and nothing of the steps in between runs.
    ///
    /// For commissioning: nothing that the compiler has proved of the chart's ways holds on this one.
    ///
    /// # Errors
    /// The chart is never in exactly these steps; then nothing has happened.
    #[allow(unused_assignments, unused_mut, unused_variables)]
    fn force(
        &mut self,
        #[cfg(not(doc))]
        steps_: &[WorksStep],
        #[cfg(doc)]
        steps: &[WorksStep],
        #[cfg(not(doc))]
        inputs_: &WorksInputs,
        #[cfg(doc)]
        inputs: &WorksInputs,
        #[cfg(not(doc))]
        now_: impl core::convert::Into<
            Ticks,
        >,
        #[cfg(doc)]
        now: impl core::convert::Into<Ticks>,
    ) -> Result<
        WorksOutputs,
        ForceError<WorksStep>,
    > {
        Possible::Listed(b"\x01\n\x12\x0C\x14")
            .look(<Self as Chart>::STEPS, steps_)?;
        let now_: Ticks = core::convert::Into::into(
            now_,
        );
        let mut forced0_: Option<__WorksRegion0> = Option::None;
        let mut forced1_: Option<__WorksRegion1> = Option::None;
        for step_ in steps_ {
            match *step_ {
                WorksStep::Idle => {
                    forced0_ = Option::Some(__WorksRegion0::Idle);
                }
                WorksStep::One => {
                    forced0_ = Option::Some(__WorksRegion0::One);
                }
                WorksStep::Two => {
                    forced0_ = Option::Some(__WorksRegion0::Two);
                }
                WorksStep::Three => {
                    forced1_ = Option::Some(__WorksRegion1::Three);
                }
                WorksStep::Four => {
                    forced1_ = Option::Some(__WorksRegion1::Four);
                }
            }
        }
        let forced0_ = match forced0_ {
            Option::Some(state_) => state_,
            Option::None => {
                return Result::Err(
                    ForceError::NoSituation,
                );
            }
        };
        let forced1_ = match forced1_ {
            Option::Some(state_) => state_,
            Option::None => __WorksRegion1::NONE,
        };
        Result::Ok({
            let mut outputs_ = WorksOutputs {
                held: false,
                late: false,
                slow: false,
                lamp: false,
                count: 3,
            };
            let first_: bool = self.region_0
                == __WorksRegion0::INIT;
            if first_ {
                self.region_0 = __WorksRegion0::Idle;
            }
            self.reading = now_;
            if first_ {
                self.since_idle = now_;
                self.since_three = now_;
            }
            let was_state_idle_: __WorksRegion0 = self.region_0;
            let was_state_three_: __WorksRegion1 = self.region_1;
            let delay0_now_: bool = inputs_.c;
            if delay0_now_ {
                if self.delay0_stage == 3 {
                    self.delay0_stage = 2;
                } else {
                    if self.delay0_stage == 0 {
                        self.delay0_since = now_;
                        self.delay0_stage = 1;
                    } else {
                        if self.delay0_stage == 1
                            && has_reached!(
                                now_.since(self.delay0_since),
                                Ticks::new(20u32)
                            )
                        {
                            self.delay0_stage = 2;
                        }
                    }
                }
            } else {
                if self.delay0_stage == 1 {
                    self.delay0_stage = 0;
                } else {
                    if self.delay0_stage == 2 {
                        self.delay0_since = now_;
                        self.delay0_stage = 3;
                    } else {
                        if self.delay0_stage == 3
                            && has_reached!(
                                now_.since(self.delay0_since),
                                Ticks::new(30u32)
                            )
                        {
                            self.delay0_stage = 0;
                        }
                    }
                }
            }
            let edge1_now_: bool = inputs_.a;
            let edge2_now_: bool = inputs_.c;
            let entered_idle_: bool = forced0_
                == __WorksRegion0::Idle
                && (first_ || was_state_idle_ != __WorksRegion0::Idle);
            let entered_one_: bool = forced0_
                == __WorksRegion0::One
                && (first_ || was_state_idle_ != __WorksRegion0::One);
            let entered_two_: bool = forced0_
                == __WorksRegion0::Two
                && (first_ || was_state_idle_ != __WorksRegion0::Two);
            let entered_three_: bool = forced1_
                == __WorksRegion1::Three
                && (first_ || was_state_three_ != __WorksRegion1::Three);
            let entered_four_: bool = forced1_
                == __WorksRegion1::Four
                && (first_ || was_state_three_ != __WorksRegion1::Four);
            self.region_0 = forced0_;
            self.region_1 = forced1_;
            if entered_idle_ || entered_one_ || entered_two_ {
                self.since_idle = now_;
            }
            if entered_three_ || entered_four_ {
                self.since_three = now_;
            }
            let last_count_: core::primitive::u16 = self.count;
            let action_edge0_now_: bool = inputs_.b;
            let on_idle_0__: bool = self.region_0
                == __WorksRegion0::Idle;
            let on_idle_1__: bool = self.region_0
                == __WorksRegion0::Idle;
            let on_idle_2__: bool = self.region_0
                == __WorksRegion0::Idle;
            let on_one_3__: bool = self.region_0
                == __WorksRegion0::One;
            let on_one_4__: bool = self.region_0
                == __WorksRegion0::One;
            let on_one_5__: bool = self.region_0
                == __WorksRegion0::One;
            let on_two_6__: bool = self.region_0
                == __WorksRegion0::Two;
            let on_three_7__: bool = entered_three_;
            let on_three_8__: bool = self.region_1
                == __WorksRegion1::Three;
            let on_four_9__: bool = entered_four_
                && ({
                    let rising_0_ = !self.action_edge0_before && action_edge0_now_;
                    rising_0_
                });
            self.s_ff_held = !on_idle_0__ && (on_one_3__ || self.s_ff_held);
            let q_held_: bool = !on_idle_0__ && self.s_ff_held;
            self.sd_ff_late = !on_idle_1__ && (on_one_4__ || self.sd_ff_late);
            if self.sd_ff_late {
                if self.sd_tmr_late_stage == 0 {
                    self.sd_tmr_late_since = now_;
                    self.sd_tmr_late_stage = if Ticks::ZERO
                        >= Ticks::new(2000u32)
                    {
                        2
                    } else {
                        1
                    };
                } else {
                    if self.sd_tmr_late_stage == 1
                        && has_reached!(
                            now_.since(self.sd_tmr_late_since),
                            Ticks::new(2000u32)
                        )
                    {
                        self.sd_tmr_late_stage = 2;
                    }
                }
            } else {
                self.sd_tmr_late_stage = 0;
            }
            let q_late_: bool = !on_idle_1__
                && self.sd_tmr_late_stage == 2;
            self.ds_ff_slow = !on_idle_2__
                && (on_three_8__
                    && now_.since(self.since_three)
                        >= Ticks::new(20u32) || self.ds_ff_slow);
            let q_slow_: bool = !on_idle_2__ && self.ds_ff_slow;
            let q_lamp_: bool = on_one_5__
                && !(on_one_5__
                    && now_.since(self.since_idle)
                        >= Ticks::new(40u32))
                || on_two_6__
                    && now_.since(self.since_idle)
                        >= Ticks::new(30u32);
            let q_four_9__: bool = on_four_9__;
            if on_three_7__ {
                self.count = {
                    let count = last_count_;
                    count % 900 + 7
                };
            }
            outputs_.held = q_held_;
            outputs_.late = q_late_;
            outputs_.slow = q_slow_;
            outputs_.lamp = q_lamp_;
            if q_four_9__ {
                self.count = {
                    let count = last_count_;
                    count % 900 + 1
                };
            }
            if self.was_q_four_9_ && !q_four_9__ {
                self.count = {
                    let count = last_count_;
                    count % 900 + 1
                };
            }
            self.was_q_four_9_ = q_four_9__;
            if was_state_idle_ == __WorksRegion0::One
                && self.region_0 == __WorksRegion0::One
                && has_reached!(
                    now_.since(self.since_idle), Ticks::new(40u32)
                )
            {
                self.since_idle = now_.since(Ticks::new(40u32));
            }
            if was_state_idle_ == __WorksRegion0::Two
                && self.region_0 == __WorksRegion0::Two
                && has_reached!(
                    now_.since(self.since_idle),
                    Ticks::new(4000u32)
                )
            {
                self.since_idle = now_.since(Ticks::new(4000u32));
            }
            if was_state_three_ == __WorksRegion1::Three
                && self.region_1 == __WorksRegion1::Three
                && has_reached!(
                    now_.since(self.since_three), Ticks::new(20u32)
                )
            {
                self.since_three = now_.since(Ticks::new(20u32));
            }
            self.settled = false;
            self.edge1_before = edge1_now_;
            self.edge2_before = edge2_now_;
            self.action_edge0_before = action_edge0_now_;
            outputs_.count = self.count;
            outputs_
        })
    }
}
