// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __BatchRegion0 {
    Idle,
    Fill,
    Stir,
    Drain,
    INIT,
}
enum __BatchRegion1 {
    Heat,
    NONE,
}
impl Batch {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &BatchInputs,
        #[cfg(doc)]
        inputs: &BatchInputs,
        #[cfg(not(doc))]
        now_: impl core::convert::Into<
            Ticks,
        >,
        #[cfg(doc)]
        now: impl core::convert::Into<Ticks>,
    ) -> BatchOutputs {
        let now_: Ticks = core::convert::Into::into(
            now_,
        );
        let mut outputs_ = BatchOutputs {
            lamp: false,
            pump: false,
            heat: false,
            count: 0,
        };
        self.reading = now_;
        fence_beyond_armv6m();
        let last_count_: core::primitive::u16 = self.count;
        let passed_: Ticks = self.reading.since(self.since_idle);
        let mut by_leaving_stir_7__: bool = false;
        let mut on_stir_7__: bool = false;
        let mut own_count_: core::primitive::u16 = 0;
        let mut written_count_: bool = false;
        let mut any_58__: bool = false;
        match self.region_0 {
            __BatchRegion0::INIT => {
                self.region_0 = __BatchRegion0::Idle;
                self.since_heat = self.reading;
                self.since_idle = self.reading;
                any_58__ = true;
            }
            __BatchRegion0::Idle => {
                if inputs_.start {
                    self.region_0 = __BatchRegion0::Fill;
                    self.region_1 = __BatchRegion1::Heat;
                    self.since_idle = self.reading;
                    self.since_heat = self.reading;
                    self.s_ff_lamp = false;
                    outputs_.heat = true;
                    by_leaving_stir_7__ = self.was_q_stir_7_ && self.held_stir_7_;
                    self.count = {
                        let count = last_count_;
                        count + 1
                    };
                    any_58__ = true;
                } else {
                    outputs_.lamp = self.s_ff_lamp;
                    by_leaving_stir_7__ = self.was_q_stir_7_ && self.held_stir_7_;
                    if by_leaving_stir_7__ {
                        own_count_ = last_count_;
                        {
                            #[allow(unused_mut, unused_variables)]
                            let mut count = own_count_;
                            let mut __written_count__ = false;
                            #[allow(unused_braces)]
                            {
                                if count > 3 {
                                    {
                                        count = 0;
                                        __written_count__ = true;
                                    };
                                }
                            }
                            if __written_count__ {
                                own_count_ = count;
                                written_count_ = true;
                            }
                        }
                        if written_count_ {
                            self.count = own_count_;
                        }
                    }
                }
            }
            __BatchRegion0::Stir => {
                if has_reached!(
                    passed_, Ticks::new(2000u32)
                ) {
                    self.region_0 = __BatchRegion0::Drain;
                    self.since_idle = self.reading;
                    outputs_.lamp = self.s_ff_lamp;
                    by_leaving_stir_7__ = self.was_q_stir_7_ && self.held_stir_7_;
                    if by_leaving_stir_7__ {
                        own_count_ = last_count_;
                        {
                            #[allow(unused_mut, unused_variables)]
                            let mut count = own_count_;
                            let mut __written_count__ = false;
                            #[allow(unused_braces)]
                            {
                                if count > 3 {
                                    {
                                        count = 0;
                                        __written_count__ = true;
                                    };
                                }
                            }
                            if __written_count__ {
                                own_count_ = count;
                                written_count_ = true;
                            }
                        }
                        if written_count_ {
                            self.count = own_count_;
                        }
                    }
                    any_58__ = true;
                } else {
                    on_stir_7__ = true;
                    outputs_.lamp = self.s_ff_lamp;
                }
            }
            __BatchRegion0::Drain => {
                if !inputs_.full {
                    self.region_0 = __BatchRegion0::Idle;
                    self.since_idle = self.reading;
                    outputs_.lamp = self.s_ff_lamp;
                    by_leaving_stir_7__ = self.was_q_stir_7_ && self.held_stir_7_;
                    if by_leaving_stir_7__ {
                        own_count_ = last_count_;
                        {
                            #[allow(unused_mut, unused_variables)]
                            let mut count = own_count_;
                            let mut __written_count__ = false;
                            #[allow(unused_braces)]
                            {
                                if count > 3 {
                                    {
                                        count = 0;
                                        __written_count__ = true;
                                    };
                                }
                            }
                            if __written_count__ {
                                own_count_ = count;
                                written_count_ = true;
                            }
                        }
                        if written_count_ {
                            self.count = own_count_;
                        }
                    }
                    any_58__ = true;
                } else {
                    outputs_.lamp = self.s_ff_lamp
                        || passed_ >= Ticks::new(1000u32);
                    by_leaving_stir_7__ = self.was_q_stir_7_ && self.held_stir_7_;
                    if by_leaving_stir_7__ {
                        own_count_ = last_count_;
                        {
                            #[allow(unused_mut, unused_variables)]
                            let mut count = own_count_;
                            let mut __written_count__ = false;
                            #[allow(unused_braces)]
                            {
                                if count > 3 {
                                    {
                                        count = 0;
                                        __written_count__ = true;
                                    };
                                }
                            }
                            if __written_count__ {
                                own_count_ = count;
                                written_count_ = true;
                            }
                        }
                        if written_count_ {
                            self.count = own_count_;
                        }
                    }
                    if has_reached!(
                        passed_, Ticks::new(1000u32)
                    ) {
                        self.since_idle = self
                            .reading
                            .since(Ticks::new(1000u32));
                    }
                }
            }
            _ => {
                match self.region_1 {
                    __BatchRegion1::Heat => {
                        if inputs_.full
                            && has_reached!(
                                self.reading.since(self.since_heat),
                                Ticks::new(5000u32)
                            )
                        {
                            self.region_1 = __BatchRegion1::NONE;
                            self.region_0 = __BatchRegion0::Stir;
                            self.since_idle = self.reading;
                            on_stir_7__ = true;
                            outputs_.lamp = self.s_ff_lamp;
                            any_58__ = true;
                        } else {
                            self.s_ff_lamp = false;
                            outputs_.heat = self.reading.since(self.since_heat)
                                < Ticks::new(3000u32);
                            by_leaving_stir_7__ = self.was_q_stir_7_
                                && self.held_stir_7_;
                            if by_leaving_stir_7__ {
                                own_count_ = last_count_;
                                {
                                    #[allow(unused_mut, unused_variables)]
                                    let mut count = own_count_;
                                    let mut __written_count__ = false;
                                    #[allow(unused_braces)]
                                    {
                                        if count > 3 {
                                            {
                                                count = 0;
                                                __written_count__ = true;
                                            };
                                        }
                                    }
                                    if __written_count__ {
                                        own_count_ = count;
                                        written_count_ = true;
                                    }
                                }
                                if written_count_ {
                                    self.count = own_count_;
                                }
                            }
                            if has_reached!(
                                self.reading.since(self.since_heat),
                                Ticks::new(5000u32)
                            ) {
                                self.since_heat = self
                                    .reading
                                    .since(Ticks::new(5000u32));
                            }
                        }
                    }
                    _ => {
                        self.s_ff_lamp = true;
                        outputs_.lamp = true;
                        by_leaving_stir_7__ = self.was_q_stir_7_ && self.held_stir_7_;
                        if by_leaving_stir_7__ {
                            own_count_ = last_count_;
                            {
                                #[allow(unused_mut, unused_variables)]
                                let mut count = own_count_;
                                let mut __written_count__ = false;
                                #[allow(unused_braces)]
                                {
                                    if count > 3 {
                                        {
                                            count = 0;
                                            __written_count__ = true;
                                        };
                                    }
                                }
                                if __written_count__ {
                                    own_count_ = count;
                                    written_count_ = true;
                                }
                            }
                            if written_count_ {
                                self.count = own_count_;
                            }
                        }
                    }
                }
            }
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        self.held_stir_7_ = on_stir_7__;
        if on_stir_7__ {
            own_count_ = last_count_;
            written_count_ = false;
            {
                #[allow(unused_mut, unused_variables)]
                let mut count = own_count_;
                let mut __written_count__ = false;
                #[allow(unused_braces)]
                {
                    if count > 3 {
                        {
                            count = 0;
                            __written_count__ = true;
                        };
                    }
                }
                if __written_count__ {
                    own_count_ = count;
                    written_count_ = true;
                }
            }
            if written_count_ {
                self.count = own_count_;
            }
        } else {
            if self.was_q_stir_7_ && !by_leaving_stir_7__ {
                own_count_ = last_count_;
                written_count_ = false;
                {
                    #[allow(unused_mut, unused_variables)]
                    let mut count = own_count_;
                    let mut __written_count__ = false;
                    #[allow(unused_braces)]
                    {
                        if count > 3 {
                            {
                                count = 0;
                                __written_count__ = true;
                            };
                        }
                    }
                    if __written_count__ {
                        own_count_ = count;
                        written_count_ = true;
                    }
                }
                if written_count_ {
                    self.count = own_count_;
                }
            }
        }
        let turned_: bool = self.was_q_stir_7_ != on_stir_7__;
        self.was_q_stir_7_ = on_stir_7__;
        any_58__ = any_58__ || self.count != last_count_;
        any_58__ = any_58__ || turned_;
        self.settled = !any_58__;
        let mut on_fill_1__: bool = false;
        let mut on_drain_8__: bool = false;
        match self.region_0 {
            __BatchRegion0::Fill => {
                on_fill_1__ = true;
            }
            __BatchRegion0::Stir => {
                self.sd_ff_pump = true;
            }
            __BatchRegion0::Drain => {
                on_drain_8__ = true;
                self.sd_ff_pump = false;
            }
            _ => {}
        }
        if self.sd_ff_pump {
            if self.sd_tmr_pump_stage == 0 {
                self.sd_tmr_pump_since = self.reading;
                self.sd_tmr_pump_stage = 1;
            } else {
                if self.sd_tmr_pump_stage == 1
                    && has_reached!(
                        self.reading.since(self.sd_tmr_pump_since),
                        Ticks::new(2000u32)
                    )
                {
                    self.sd_tmr_pump_stage = 2;
                }
            }
        } else {
            self.sd_tmr_pump_stage = 0;
        }
        outputs_.pump = !on_drain_8__ && (on_fill_1__ || self.sd_tmr_pump_stage == 2);
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
        if self.region_1 == __BatchRegion1::Heat
            && self.reading.since(self.since_heat)
                < Ticks::new(3000u32)
        {
            soonest_ = earlier(
                soonest_,
                self
                    .reading
                    .after(
                        Ticks::new(3000u32)
                            - self.reading.since(self.since_heat),
                    ),
            );
        }
        if self.region_1 == __BatchRegion1::Heat
            && self.reading.since(self.since_heat)
                < Ticks::new(5000u32)
        {
            soonest_ = earlier(
                soonest_,
                self
                    .reading
                    .after(
                        Ticks::new(5000u32)
                            - self.reading.since(self.since_heat),
                    ),
            );
        }
        if self.region_0 == __BatchRegion0::Stir
            && self.reading.since(self.since_idle)
                < Ticks::new(2000u32)
        {
            soonest_ = earlier(
                soonest_,
                self
                    .reading
                    .after(
                        Ticks::new(2000u32)
                            - self.reading.since(self.since_idle),
                    ),
            );
        }
        if self.region_0 == __BatchRegion0::Drain
            && self.reading.since(self.since_idle)
                < Ticks::new(1000u32)
        {
            soonest_ = earlier(
                soonest_,
                self
                    .reading
                    .after(
                        Ticks::new(1000u32)
                            - self.reading.since(self.since_idle),
                    ),
            );
        }
        if self.sd_tmr_pump_stage == 1 {
            soonest_ = earlier(
                soonest_,
                self.sd_tmr_pump_since.after(Ticks::new(2000u32)),
            );
        }
        soonest_
    }
}
impl Batch {
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
        steps_: &[BatchStep],
        #[cfg(doc)]
        steps: &[BatchStep],
        #[cfg(not(doc))]
        inputs_: &BatchInputs,
        #[cfg(doc)]
        inputs: &BatchInputs,
        #[cfg(not(doc))]
        now_: impl core::convert::Into<
            Ticks,
        >,
        #[cfg(doc)]
        now: impl core::convert::Into<Ticks>,
    ) -> Result<
        BatchOutputs,
        ForceError<BatchStep>,
    > {
        Possible::Listed(b"\x01\x06\x08\x10")
            .look(<Self as Chart>::STEPS, steps_)?;
        let now_: Ticks = core::convert::Into::into(
            now_,
        );
        let mut forced0_: Option<__BatchRegion0> = Option::None;
        let mut forced1_: Option<__BatchRegion1> = Option::None;
        for step_ in steps_ {
            match *step_ {
                BatchStep::Idle => {
                    forced0_ = Option::Some(__BatchRegion0::Idle);
                }
                BatchStep::Fill => {
                    forced0_ = Option::Some(__BatchRegion0::Fill);
                }
                BatchStep::Heat => {
                    forced1_ = Option::Some(__BatchRegion1::Heat);
                }
                BatchStep::Stir => {
                    forced0_ = Option::Some(__BatchRegion0::Stir);
                }
                BatchStep::Drain => {
                    forced0_ = Option::Some(__BatchRegion0::Drain);
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
            Option::None => __BatchRegion1::NONE,
        };
        Result::Ok({
            let mut outputs_ = BatchOutputs {
                lamp: false,
                pump: false,
                heat: false,
                count: 0,
            };
            let first_: bool = self.region_0
                == __BatchRegion0::INIT;
            if first_ {
                self.region_0 = __BatchRegion0::Idle;
            }
            self.reading = now_;
            if first_ {
                self.since_idle = now_;
                self.since_heat = now_;
            }
            let was_state_idle_: __BatchRegion0 = self.region_0;
            let was_state_heat_: __BatchRegion1 = self.region_1;
            let left_idle_: bool = !first_
                && was_state_idle_ == __BatchRegion0::Idle
                && forced0_ != __BatchRegion0::Idle;
            let entered_idle_: bool = forced0_
                == __BatchRegion0::Idle
                && (first_ || was_state_idle_ != __BatchRegion0::Idle);
            let entered_fill_: bool = forced0_
                == __BatchRegion0::Fill
                && (first_ || was_state_idle_ != __BatchRegion0::Fill);
            let entered_heat_: bool = forced1_
                == __BatchRegion1::Heat
                && (first_ || was_state_heat_ != __BatchRegion1::Heat);
            let entered_stir_: bool = forced0_
                == __BatchRegion0::Stir
                && (first_ || was_state_idle_ != __BatchRegion0::Stir);
            let entered_drain_: bool = forced0_
                == __BatchRegion0::Drain
                && (first_ || was_state_idle_ != __BatchRegion0::Drain);
            self.region_0 = forced0_;
            self.region_1 = forced1_;
            if entered_idle_ || entered_fill_ || entered_stir_ || entered_drain_ {
                self.since_idle = now_;
            }
            if entered_heat_ {
                self.since_heat = now_;
            }
            let last_count_: core::primitive::u16 = self.count;
            let on_idle_0__: bool = left_idle_;
            let on_fill_1__: bool = self.region_0
                == __BatchRegion0::Fill;
            let on_fill_2__: bool = entered_fill_;
            let on_fill_3__: bool = self.region_0
                == __BatchRegion0::Fill;
            let on_heat_4__: bool = self.region_1
                == __BatchRegion1::Heat;
            let on_heat_5__: bool = self.region_1
                == __BatchRegion1::Heat;
            let on_stir_6__: bool = self.region_0
                == __BatchRegion0::Stir;
            let on_stir_7__: bool = self.region_0
                == __BatchRegion0::Stir;
            let on_drain_8__: bool = self.region_0
                == __BatchRegion0::Drain;
            let on_drain_9__: bool = self.region_0
                == __BatchRegion0::Drain;
            self.sd_ff_pump = !on_drain_8__ && (on_stir_6__ || self.sd_ff_pump);
            if self.sd_ff_pump {
                if self.sd_tmr_pump_stage == 0 {
                    self.sd_tmr_pump_since = now_;
                    self.sd_tmr_pump_stage = if Ticks::ZERO
                        >= Ticks::new(2000u32)
                    {
                        2
                    } else {
                        1
                    };
                } else {
                    if self.sd_tmr_pump_stage == 1
                        && has_reached!(
                            now_.since(self.sd_tmr_pump_since),
                            Ticks::new(2000u32)
                        )
                    {
                        self.sd_tmr_pump_stage = 2;
                    }
                }
            } else {
                self.sd_tmr_pump_stage = 0;
            }
            let q_pump_: bool = !on_drain_8__
                && (on_fill_1__ || self.sd_tmr_pump_stage == 2);
            self.s_ff_lamp = !on_heat_5__ && (on_fill_3__ || self.s_ff_lamp);
            let q_lamp_: bool = !on_heat_5__
                && (self.s_ff_lamp
                    || on_drain_9__
                        && now_.since(self.since_idle)
                            >= Ticks::new(1000u32));
            let q_heat_: bool = on_heat_4__
                && !(on_heat_4__
                    && now_.since(self.since_heat)
                        >= Ticks::new(3000u32));
            let q_stir_7__: bool = on_stir_7__;
            let by_leaving_stir_7__: bool = self.was_q_stir_7_
                && !q_stir_7__ && self.held_stir_7_
                && self.region_0 != __BatchRegion0::Stir && !on_stir_7__;
            self.held_stir_7_ = q_stir_7__ && on_stir_7__;
            if on_idle_0__ {
                self.count = 0;
            }
            let mut own_count_: core::primitive::u16 = 0;
            let mut written_count_: bool = false;
            if by_leaving_stir_7__ {
                own_count_ = last_count_;
                written_count_ = false;
                {
                    #[allow(unused_mut, unused_variables)]
                    let mut count = own_count_;
                    let mut __written_count__ = false;
                    #[allow(unused_braces)]
                    {
                        if count > 3 {
                            {
                                count = 0;
                                __written_count__ = true;
                            };
                        }
                    }
                    if __written_count__ {
                        own_count_ = count;
                        written_count_ = true;
                    }
                }
                if written_count_ {
                    self.count = own_count_;
                }
            }
            if on_fill_2__ {
                self.count = {
                    let count = last_count_;
                    count + 1
                };
            }
            outputs_.pump = q_pump_;
            outputs_.lamp = q_lamp_;
            outputs_.heat = q_heat_;
            if q_stir_7__ {
                own_count_ = last_count_;
                written_count_ = false;
                {
                    #[allow(unused_mut, unused_variables)]
                    let mut count = own_count_;
                    let mut __written_count__ = false;
                    #[allow(unused_braces)]
                    {
                        if count > 3 {
                            {
                                count = 0;
                                __written_count__ = true;
                            };
                        }
                    }
                    if __written_count__ {
                        own_count_ = count;
                        written_count_ = true;
                    }
                }
                if written_count_ {
                    self.count = own_count_;
                }
            }
            if self.was_q_stir_7_ && !q_stir_7__ && !by_leaving_stir_7__ {
                own_count_ = last_count_;
                written_count_ = false;
                {
                    #[allow(unused_mut, unused_variables)]
                    let mut count = own_count_;
                    let mut __written_count__ = false;
                    #[allow(unused_braces)]
                    {
                        if count > 3 {
                            {
                                count = 0;
                                __written_count__ = true;
                            };
                        }
                    }
                    if __written_count__ {
                        own_count_ = count;
                        written_count_ = true;
                    }
                }
                if written_count_ {
                    self.count = own_count_;
                }
            }
            self.was_q_stir_7_ = q_stir_7__;
            if was_state_heat_ == __BatchRegion1::Heat
                && self.region_1 == __BatchRegion1::Heat
                && has_reached!(
                    now_.since(self.since_heat),
                    Ticks::new(5000u32)
                )
            {
                self.since_heat = now_.since(Ticks::new(5000u32));
            }
            if was_state_idle_ == __BatchRegion0::Stir
                && self.region_0 == __BatchRegion0::Stir
                && has_reached!(
                    now_.since(self.since_idle),
                    Ticks::new(2000u32)
                )
            {
                self.since_idle = now_.since(Ticks::new(2000u32));
            }
            if was_state_idle_ == __BatchRegion0::Drain
                && self.region_0 == __BatchRegion0::Drain
                && has_reached!(
                    now_.since(self.since_idle),
                    Ticks::new(1000u32)
                )
            {
                self.since_idle = now_.since(Ticks::new(1000u32));
            }
            self.settled = false;
            outputs_.count = self.count;
            outputs_
        })
    }
}
