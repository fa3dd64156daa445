// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

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
        let elapsed_ = now_.since(self.now);
        self.now = now_;
        self.since_0 = self.since_0 + elapsed_;
        self.since_1 = self.since_1 + elapsed_;
        #[allow(unused_variables)]
        let before_0_ = self.region_0;
        #[allow(unused_variables)]
        let before_1_ = self.region_1;
        self.settled = true;
        let since_before_0_ = self.since_0.ticks();
        let since_before_1_ = self.since_1.ticks();
        match self.region_0 {
            __BatchRegion0::Idle => {
                if inputs_.start {
                    self.region_0 = __BatchRegion0::Fill;
                    self.region_1 = __BatchRegion1::Heat;
                    self.since_1 = ShortTime::ZERO;
                    self.settled = false;
                }
            }
            __BatchRegion0::Stir => {
                if self.since_0.ticks() >= Ticks::new(2000u32) {
                    self.region_0 = __BatchRegion0::Drain;
                    self.since_0 = ShortTime::ZERO;
                    self.settled = false;
                }
            }
            __BatchRegion0::Drain => {
                if !inputs_.full {
                    self.region_0 = __BatchRegion0::Idle;
                    self.settled = false;
                }
            }
            __BatchRegion0::INIT => {
                self.region_0 = __BatchRegion0::Idle;
                self.settled = false;
            }
            _ => {
                if self.region_0 == __BatchRegion0::Fill
                    && self.region_1 == __BatchRegion1::Heat
                    && {
                        let full = inputs_.full;
                        let elapsed_5000_2_ = self.since_1.ticks()
                            >= Ticks::new(5000u32);
                        full && elapsed_5000_2_
                    }
                {
                    self.region_1 = __BatchRegion1::NONE;
                    self.region_0 = __BatchRegion0::Stir;
                    self.since_0 = ShortTime::ZERO;
                    self.settled = false;
                }
            }
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        #[allow(unused_variables)]
        let after_0_ = self.region_0;
        #[allow(unused_variables)]
        let after_1_ = self.region_1;
        let last_count_ = self.out_count;
        let mut reset_lamp_ = false;
        match self.region_0 {
            __BatchRegion0::Drain => {
                if self.since_0.ticks() >= Ticks::new(1000u32) {
                    outputs_.lamp = true;
                }
            }
            __BatchRegion0::Idle | __BatchRegion0::Stir => {}
            _ => {
                match self.region_0 {
                    __BatchRegion0::Fill => {
                        self.out_lamp = true;
                    }
                    _ => {}
                }
                match self.region_1 {
                    __BatchRegion1::Heat => {
                        if self.since_1.ticks()
                            < Ticks::new(3000u32)
                        {
                            outputs_.heat = true;
                        }
                        reset_lamp_ = true;
                    }
                    _ => {}
                }
            }
        }
        let mut flag_n_pump_ = false;
        let mut flag_r_pump_ = false;
        let mut flag_sd_pump_ = false;
        match self.region_0 {
            __BatchRegion0::Fill => {
                flag_n_pump_ = true;
            }
            __BatchRegion0::Stir => {
                flag_sd_pump_ = true;
            }
            __BatchRegion0::Drain => {
                flag_r_pump_ = true;
            }
            _ => {}
        }
        if reset_lamp_ {
            self.out_lamp = false;
            outputs_.lamp = false;
        }
        self.memory_flag_sd_pump = (self.memory_flag_sd_pump || flag_sd_pump_)
            && !flag_r_pump_;
        let done_flag_sd_pump_ = OnDelay::update(
            &mut self.timer_flag_sd_pump,
            self.memory_flag_sd_pump,
            false,
            Ticks::new(2000u32),
            elapsed_,
        );
        let q_pump_ = !flag_r_pump_ && (flag_n_pump_ || done_flag_sd_pump_);
        match before_0_ {
            __BatchRegion0::Idle => {
                if after_0_ != __BatchRegion0::Idle {
                    self.settled = false;
                    self.out_count = 0;
                }
            }
            _ => {}
        }
        match before_0_ {
            __BatchRegion0::Stir => {
                if after_0_ != __BatchRegion0::Stir {
                    self.settled = false;
                    {
                        #[allow(unused_mut, unused_variables)]
                        let mut count = last_count_;
                        let mut written_count_ = false;
                        #[allow(unused_braces)]
                        {
                            if count > 3 {
                                {
                                    count = 0;
                                    written_count_ = true;
                                };
                            }
                        }
                        if written_count_ {
                            self.out_count = count;
                        }
                    }
                }
            }
            _ => {}
        }
        match self.region_0 {
            __BatchRegion0::Fill => {
                if before_0_ != __BatchRegion0::Fill {
                    self.settled = false;
                    self.out_count = {
                        let count = last_count_;
                        count + 1
                    };
                }
            }
            _ => {}
        }
        outputs_.pump = q_pump_;
        match self.region_0 {
            __BatchRegion0::Stir => {
                self.settled = false;
                {
                    #[allow(unused_mut, unused_variables)]
                    let mut count = last_count_;
                    let mut written_count_ = false;
                    #[allow(unused_braces)]
                    {
                        if count > 3 {
                            {
                                count = 0;
                                written_count_ = true;
                            };
                        }
                    }
                    if written_count_ {
                        self.out_count = count;
                    }
                }
            }
            _ => {}
        }
        outputs_.lamp = outputs_.lamp || self.out_lamp;
        outputs_.count = self.out_count;
        outputs_
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
            Option::None => __BatchRegion0::NONE,
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
            let elapsed_ = now_.since(self.now);
            self.now = now_;
            self.since_0 = self.since_0 + elapsed_;
            self.since_1 = self.since_1 + elapsed_;
            let before_0_ = self.region_0;
            let before_1_ = self.region_1;
            let after_0_ = forced0_;
            let after_1_ = forced1_;
            let since_before_0_ = self.since_0.ticks();
            let since_before_1_ = self.since_1.ticks();
            self.region_0 = after_0_;
            self.region_1 = after_1_;
            if before_0_ != after_0_ || before_1_ != after_1_ {
                if after_0_ != before_0_ {
                    self.since_0 = ShortTime::ZERO;
                }
                if after_1_ != before_1_ {
                    self.since_1 = ShortTime::ZERO;
                }
                self.settled = false;
            }
            let last_count_ = self.out_count;
            let mut reset_lamp_ = false;
            match after_0_ {
                __BatchRegion0::Fill => {
                    self.out_lamp = true;
                }
                __BatchRegion0::Drain => {
                    if self.since_0.ticks() >= Ticks::new(1000u32)
                    {
                        outputs_.lamp = true;
                    }
                }
                _ => {}
            }
            match after_1_ {
                __BatchRegion1::Heat => {
                    if self.since_1.ticks() < Ticks::new(3000u32) {
                        outputs_.heat = true;
                    }
                    reset_lamp_ = true;
                }
                _ => {}
            }
            let mut flag_n_pump_ = false;
            let mut flag_r_pump_ = false;
            let mut flag_sd_pump_ = false;
            match after_0_ {
                __BatchRegion0::Fill => {
                    flag_n_pump_ = true;
                }
                __BatchRegion0::Stir => {
                    flag_sd_pump_ = true;
                }
                __BatchRegion0::Drain => {
                    flag_r_pump_ = true;
                }
                _ => {}
            }
            if reset_lamp_ {
                self.out_lamp = false;
                outputs_.lamp = false;
            }
            self.memory_flag_sd_pump = (self.memory_flag_sd_pump || flag_sd_pump_)
                && !flag_r_pump_;
            let done_flag_sd_pump_ = OnDelay::update(
                &mut self.timer_flag_sd_pump,
                self.memory_flag_sd_pump,
                false,
                Ticks::new(2000u32),
                elapsed_,
            );
            let q_pump_ = !flag_r_pump_ && (flag_n_pump_ || done_flag_sd_pump_);
            match before_0_ {
                __BatchRegion0::Idle => {
                    if after_0_ != __BatchRegion0::Idle {
                        self.settled = false;
                        self.out_count = 0;
                    }
                }
                _ => {}
            }
            match before_0_ {
                __BatchRegion0::Stir => {
                    if after_0_ != __BatchRegion0::Stir {
                        self.settled = false;
                        {
                            #[allow(unused_mut, unused_variables)]
                            let mut count = last_count_;
                            let mut written_count_ = false;
                            #[allow(unused_braces)]
                            {
                                if count > 3 {
                                    {
                                        count = 0;
                                        written_count_ = true;
                                    };
                                }
                            }
                            if written_count_ {
                                self.out_count = count;
                            }
                        }
                    }
                }
                _ => {}
            }
            match after_0_ {
                __BatchRegion0::Fill => {
                    if before_0_ != __BatchRegion0::Fill {
                        self.settled = false;
                        self.out_count = {
                            let count = last_count_;
                            count + 1
                        };
                    }
                }
                _ => {}
            }
            outputs_.pump = q_pump_;
            match after_0_ {
                __BatchRegion0::Stir => {
                    self.settled = false;
                    {
                        #[allow(unused_mut, unused_variables)]
                        let mut count = last_count_;
                        let mut written_count_ = false;
                        #[allow(unused_braces)]
                        {
                            if count > 3 {
                                {
                                    count = 0;
                                    written_count_ = true;
                                };
                            }
                        }
                        if written_count_ {
                            self.out_count = count;
                        }
                    }
                }
                _ => {}
            }
            self.settled = false;
            outputs_.lamp = outputs_.lamp || self.out_lamp;
            outputs_.count = self.out_count;
            outputs_
        })
    }
}
