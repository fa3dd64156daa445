// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __KilnRegion0 {
    Idle,
    One,
    Two,
    INIT,
}
enum __KilnRegion1 {
    Three,
    Four,
    NONE,
}
impl Kiln {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &KilnInputs,
        #[cfg(doc)]
        inputs: &KilnInputs,
        #[cfg(not(doc))]
        now_: impl core::convert::Into<
            Ticks,
        >,
        #[cfg(doc)]
        now: impl core::convert::Into<Ticks>,
    ) -> KilnOutputs {
        let now_: Ticks = core::convert::Into::into(
            now_,
        );
        let mut outputs_ = KilnOutputs {
            fire: false,
            count: 0,
            last: 0,
        };
        if inputs_.hot {
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
                            Ticks::new(1000u32)
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
                            Ticks::new(2000u32)
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
        let first_: bool = self.region_0 == __KilnRegion0::INIT;
        if first_ {
            self.region_0 = __KilnRegion0::Idle;
        }
        let elapsed_: Ticks = if first_ {
            Ticks::ZERO
        } else {
            now_.since(self.reading)
        };
        self.reading = now_;
        self.time_idle = self.time_idle + elapsed_;
        let inputs_ = core::hint::black_box(inputs_);
        loop {
            let mut moves_30__: bool = false;
            let mut next_count_: core::primitive::u16 = self.count;
            let mut next_last_: core::primitive::u16 = self.last;
            match self.region_0 {
                __KilnRegion0::Idle => {
                    if !self.edge0_before && inputs_.start {
                        self.region_0 = __KilnRegion0::One;
                        self.region_1 = __KilnRegion1::Three;
                        next_count_ = {
                            let count = self.count;
                            let level = inputs_.level;
                            count + level % 7
                        };
                        next_last_ = {
                            let last = self.last;
                            last % 50 + 3
                        };
                        moves_30__ = true;
                        self.count = next_count_;
                        self.last = next_last_;
                        self.time_idle = Ticks::ZERO;
                    }
                }
                _ => {
                    if self.region_0 == __KilnRegion0::Two
                        && self.region_1 == __KilnRegion1::Four
                        && !(inputs_.start
                            && ({
                                let last = self.last;
                                last > 2
                            }) && !inputs_.next)
                    {
                        let clears_four_three_: bool = false;
                        moves_30__ = true;
                        self.time_idle = Ticks::ZERO;
                        self.region_1 = __KilnRegion1::NONE;
                        if clears_four_three_ {
                            self.region_1 = __KilnRegion1::Three;
                        }
                        if self.region_1 == __KilnRegion1::Three {
                            next_count_ = {
                                let count = self.count;
                                let level = inputs_.level;
                                count + level % 7
                            };
                            next_last_ = {
                                let last = self.last;
                                last % 50 + 3
                            };
                        }
                        self.count = next_count_;
                        self.last = next_last_;
                        self.region_0 = __KilnRegion0::Idle;
                    } else {
                        match self.region_0 {
                            __KilnRegion0::One => {
                                if self.time_idle >= self.params.limit {
                                    self.region_0 = __KilnRegion0::Two;
                                    moves_30__ = true;
                                    self.time_idle = Ticks::ZERO;
                                }
                            }
                            _ => {}
                        }
                        core::sync::atomic::compiler_fence(
                            core::sync::atomic::Ordering::SeqCst,
                        );
                        match self.region_1 {
                            __KilnRegion1::Three => {
                                if inputs_.next {
                                    self.region_1 = __KilnRegion1::Four;
                                    moves_30__ = true;
                                }
                            }
                            __KilnRegion1::Four => {
                                if inputs_.start
                                    && ({
                                        let last = self.last;
                                        last > 2
                                    }) && !inputs_.next
                                {
                                    self.region_1 = __KilnRegion1::Three;
                                    next_count_ = {
                                        let count = self.count;
                                        let level = inputs_.level;
                                        count + level % 7
                                    };
                                    next_last_ = {
                                        let last = self.last;
                                        last % 50 + 3
                                    };
                                    moves_30__ = true;
                                    self.count = next_count_;
                                    self.last = next_last_;
                                }
                            }
                            _ => {}
                        }
                    }
                }
            }
            if !moves_30__ {
                break;
            }
            self.edge0_before = inputs_.start;
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        self.settled = true;
        self.edge0_before = inputs_.start;
        match self.region_0 {
            __KilnRegion0::One => {
                outputs_.fire = self.delay0_stage >= 2;
            }
            __KilnRegion0::Two => {
                outputs_.fire = self.time_idle
                    >= Ticks::new(500u32);
            }
            _ => {}
        }
        outputs_.count = self.count;
        outputs_.last = self.last;
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
        if self.region_0 == __KilnRegion0::One && self.time_idle < self.params.limit {
            soonest_ = sooner(
                soonest_,
                Option::Some(self.params.limit - self.time_idle),
            );
        }
        if self.region_0 == __KilnRegion0::Two
            && self.time_idle < Ticks::new(500u32)
        {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(500u32) - self.time_idle,
                ),
            );
        }
        if self.delay0_stage == 1 {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(1000u32)
                        - self.reading.since(self.delay0_since),
                ),
            );
        }
        if self.delay0_stage == 3 {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(2000u32)
                        - self.reading.since(self.delay0_since),
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
impl Kiln {
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
        steps_: &[KilnStep],
        #[cfg(doc)]
        steps: &[KilnStep],
        #[cfg(not(doc))]
        inputs_: &KilnInputs,
        #[cfg(doc)]
        inputs: &KilnInputs,
        #[cfg(not(doc))]
        now_: impl core::convert::Into<
            Ticks,
        >,
        #[cfg(doc)]
        now: impl core::convert::Into<Ticks>,
    ) -> Result<
        KilnOutputs,
        ForceError<KilnStep>,
    > {
        Possible::Listed(b"\x01\n\x12\x0C")
            .look(<Self as Chart>::STEPS, steps_)?;
        let now_: Ticks = core::convert::Into::into(
            now_,
        );
        let mut forced0_: Option<__KilnRegion0> = Option::None;
        let mut forced1_: Option<__KilnRegion1> = Option::None;
        for step_ in steps_ {
            match *step_ {
                KilnStep::Idle => {
                    forced0_ = Option::Some(__KilnRegion0::Idle);
                }
                KilnStep::One => {
                    forced0_ = Option::Some(__KilnRegion0::One);
                }
                KilnStep::Two => {
                    forced0_ = Option::Some(__KilnRegion0::Two);
                }
                KilnStep::Three => {
                    forced1_ = Option::Some(__KilnRegion1::Three);
                }
                KilnStep::Four => {
                    forced1_ = Option::Some(__KilnRegion1::Four);
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
            Option::None => __KilnRegion1::NONE,
        };
        Result::Ok({
            let mut outputs_ = KilnOutputs {
                fire: false,
                count: 0,
                last: 0,
            };
            let first_: bool = self.region_0
                == __KilnRegion0::INIT;
            if first_ {
                self.region_0 = __KilnRegion0::Idle;
            }
            let elapsed_: Ticks = if first_ {
                Ticks::ZERO
            } else {
                now_.since(self.reading)
            };
            self.reading = now_;
            self.time_idle = self.time_idle + elapsed_;
            let delay0_now_: bool = inputs_.hot;
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
                                Ticks::new(1000u32)
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
                                Ticks::new(2000u32)
                            )
                        {
                            self.delay0_stage = 0;
                        }
                    }
                }
            }
            let mut was_state_idle_: __KilnRegion0 = self.region_0;
            let was_state_three_: __KilnRegion1 = self.region_1;
            let edge0_now_: bool = inputs_.start;
            self.region_0 = forced0_;
            self.region_1 = forced1_;
            let mut next_count_: core::primitive::u16 = self.count;
            let mut next_last_: core::primitive::u16 = self.last;
            if was_state_three_ != __KilnRegion1::Three
                && self.region_1 == __KilnRegion1::Three
            {
                next_count_ = {
                    let count = self.count;
                    let level = inputs_.level;
                    count + level % 7
                };
            }
            if was_state_three_ != __KilnRegion1::Three
                && self.region_1 == __KilnRegion1::Three
            {
                next_last_ = {
                    let last = self.last;
                    last % 50 + 3
                };
            }
            self.count = next_count_;
            self.last = next_last_;
            if was_state_idle_ != self.region_0 {
                self.time_idle = Ticks::ZERO;
            }
            self.edge0_before = edge0_now_;
            was_state_idle_ = self.region_0;
            let next_fire_: bool = was_state_idle_
                == __KilnRegion0::One
                && ({
                    let delay_0_ = self.delay0_stage >= 2;
                    delay_0_
                })
                || was_state_idle_ == __KilnRegion0::Two
                    && was_state_idle_ == __KilnRegion0::Two
                    && self.time_idle >= Ticks::new(500u32);
            outputs_.fire = next_fire_;
            self.settled = false;
            outputs_.count = self.count;
            outputs_.last = self.last;
            outputs_
        })
    }
}
