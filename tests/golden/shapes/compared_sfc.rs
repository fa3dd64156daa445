// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

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
        let elapsed_ = if self.region_0 == __WorksRegion0::INIT {
            Ticks::ZERO
        } else {
            now_.since(self.now)
        };
        self.now = now_;
        self.since_0 = self.since_0 + elapsed_;
        let before_0_ = self.region_0;
        let before_1_ = self.region_1;
        let mut after_0_ = before_0_;
        let mut after_1_ = before_1_;
        let mut rising_now_0_ = false;
        let mut rising_now_1_ = false;
        let mut falling_now_2_ = false;
        let value_: bool = inputs_.b;
        rising_now_0_ = value_ && !self.edge_0;
        self.edge_0 = value_;
        let value_: bool = inputs_.a;
        rising_now_1_ = value_ && !self.edge_1;
        self.edge_1 = value_;
        let value_: bool = inputs_.c;
        falling_now_2_ = !value_ && self.edge_2;
        self.edge_2 = value_;
        let input_ = inputs_.c;
        Delay::update(
            &mut self.delay_0,
            input_,
            Ticks::new(20u32),
            Ticks::new(30u32),
            elapsed_,
        );
        self.settled = true;
        let since_before_0_ = self.since_0;
        if before_0_ == __WorksRegion0::INIT {
            after_0_ = __WorksRegion0::Idle;
            after_1_ = __WorksRegion1::NONE;
        } else {
            let mut left_2_ = false;
            let mut left_3_ = false;
            if (before_1_ == __WorksRegion1::Three) && !left_3_
                && {
                    let delay_0_ = Delay::output(&self.delay_0);
                    delay_0_
                }
            {
                left_3_ = true;
                after_1_ = __WorksRegion1::Four;
            }
            if (before_0_ == __WorksRegion0::Two) && (before_1_ == __WorksRegion1::Three)
                && !left_2_ && !left_3_
                && {
                    let a = inputs_.a;
                    let elapsed_4000_2_ = self.since_0
                        >= Ticks::new(4000u32);
                    !a || elapsed_4000_2_
                }
            {
                left_2_ = true;
                left_3_ = true;
                after_1_ = __WorksRegion1::NONE;
                after_0_ = __WorksRegion0::Idle;
            }
            match before_0_ {
                __WorksRegion0::Idle => {
                    if {
                        let rising_1_ = rising_now_1_;
                        rising_1_
                    } {
                        after_0_ = __WorksRegion0::One;
                        after_1_ = __WorksRegion1::Three;
                    }
                }
                __WorksRegion0::One => {
                    if {
                        let b = inputs_.b;
                        let since_1_ = self.since_0;
                        let ticks_15_ = Ticks::new(15u32);
                        b && since_1_ > ticks_15_
                    } {
                        after_0_ = __WorksRegion0::Two;
                    }
                }
                _ => {}
            }
            match before_1_ {
                __WorksRegion1::Four => {
                    if {
                        let falling_2_ = falling_now_2_;
                        falling_2_
                    } {
                        after_1_ = __WorksRegion1::Three;
                    }
                }
                _ => {}
            }
        }
        self.region_0 = after_0_;
        self.region_1 = after_1_;
        if before_0_ != after_0_ || before_1_ != after_1_ || rising_now_0_
            || rising_now_1_ || falling_now_2_
        {
            if after_0_ != before_0_ {
                self.since_0 = Ticks::ZERO;
            }
            self.settled = false;
        }
        let last_count_ = self.out_count;
        match after_0_ {
            __WorksRegion0::Idle => {
                self.out_held = false;
            }
            __WorksRegion0::One => {
                self.out_held = true;
                if self.since_0 < Ticks::new(40u32) {
                    outputs_.lamp = true;
                }
            }
            __WorksRegion0::Two => {
                if self.since_0 >= Ticks::new(30u32) {
                    outputs_.lamp = true;
                }
            }
            _ => {}
        }
        let mut flag_r_late_ = false;
        let mut flag_sd_late_ = false;
        let mut flag_r_slow_ = false;
        let mut flag_ds_slow_ = false;
        let mut flag_p_2_count_ = false;
        match after_0_ {
            __WorksRegion0::Idle => {
                flag_r_late_ = true;
                flag_r_slow_ = true;
            }
            __WorksRegion0::One => {
                flag_sd_late_ = true;
            }
            _ => {}
        }
        match after_1_ {
            __WorksRegion1::Three => {
                flag_ds_slow_ = true;
            }
            __WorksRegion1::Four => {
                if before_1_ != __WorksRegion1::Four {
                    if {
                        let rising_0_ = rising_now_0_;
                        rising_0_
                    } {
                        flag_p_2_count_ = true;
                    }
                }
            }
            _ => {}
        }
        self.memory_flag_sd_late = (self.memory_flag_sd_late || flag_sd_late_)
            && !flag_r_late_;
        let done_flag_sd_late_ = OnDelay::update(
            &mut self.timer_flag_sd_late,
            self.memory_flag_sd_late,
            false,
            Ticks::new(2000u32),
            elapsed_,
        );
        let q_late_ = !flag_r_late_ && (done_flag_sd_late_);
        let done_flag_ds_slow_ = OnDelay::update(
            &mut self.timer_flag_ds_slow,
            flag_ds_slow_,
            false,
            Ticks::new(20u32),
            elapsed_,
        );
        self.memory_flag_ds_slow = (self.memory_flag_ds_slow || done_flag_ds_slow_)
            && !flag_r_slow_;
        let q_slow_ = !flag_r_slow_ && (self.memory_flag_ds_slow);
        let q_2_count_ = !false && (flag_p_2_count_);
        match after_1_ {
            __WorksRegion1::Three => {
                if before_1_ != __WorksRegion1::Three {
                    self.settled = false;
                    self.out_count = {
                        let count = last_count_;
                        count % 900 + 7
                    };
                }
            }
            _ => {}
        }
        outputs_.late = q_late_;
        outputs_.slow = q_slow_;
        if q_2_count_ {
            {
                let value_: core::primitive::u16 = {
                    let count = last_count_;
                    count % 900 + 1
                };
                if value_ != self.out_count {
                    self.settled = false;
                    self.out_count = value_;
                }
            }
        } else if self.kept_q_2_count && !q_2_count_ {
            {
                let value_: core::primitive::u16 = {
                    let count = last_count_;
                    count % 900 + 1
                };
                if value_ != self.out_count {
                    self.settled = false;
                    self.out_count = value_;
                }
            }
        }
        self.kept_q_2_count = q_2_count_;
        outputs_.held = self.out_held;
        outputs_.count = self.out_count;
        outputs_
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
            Option::None => __WorksRegion0::NONE,
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
            let elapsed_ = if self.region_0 == __WorksRegion0::INIT {
                Ticks::ZERO
            } else {
                now_.since(self.now)
            };
            self.now = now_;
            self.since_0 = self.since_0 + elapsed_;
            let before_0_ = self.region_0;
            let before_1_ = self.region_1;
            let after_0_ = forced0_;
            let after_1_ = forced1_;
            let mut rising_now_0_ = false;
            let mut rising_now_1_ = false;
            let mut falling_now_2_ = false;
            let value_: bool = inputs_.b;
            rising_now_0_ = value_ && !self.edge_0;
            self.edge_0 = value_;
            let value_: bool = inputs_.a;
            rising_now_1_ = value_ && !self.edge_1;
            self.edge_1 = value_;
            let value_: bool = inputs_.c;
            falling_now_2_ = !value_ && self.edge_2;
            self.edge_2 = value_;
            let input_ = inputs_.c;
            Delay::update(
                &mut self.delay_0,
                input_,
                Ticks::new(20u32),
                Ticks::new(30u32),
                elapsed_,
            );
            let since_before_0_ = self.since_0;
            self.region_0 = after_0_;
            self.region_1 = after_1_;
            if before_0_ != after_0_ || before_1_ != after_1_ || rising_now_0_
                || rising_now_1_ || falling_now_2_
            {
                if after_0_ != before_0_ {
                    self.since_0 = Ticks::ZERO;
                }
                self.settled = false;
            }
            let last_count_ = self.out_count;
            match after_0_ {
                __WorksRegion0::Idle => {
                    self.out_held = false;
                }
                __WorksRegion0::One => {
                    self.out_held = true;
                    if self.since_0 < Ticks::new(40u32) {
                        outputs_.lamp = true;
                    }
                }
                __WorksRegion0::Two => {
                    if self.since_0 >= Ticks::new(30u32) {
                        outputs_.lamp = true;
                    }
                }
                _ => {}
            }
            let mut flag_r_late_ = false;
            let mut flag_sd_late_ = false;
            let mut flag_r_slow_ = false;
            let mut flag_ds_slow_ = false;
            let mut flag_p_2_count_ = false;
            match after_0_ {
                __WorksRegion0::Idle => {
                    flag_r_late_ = true;
                    flag_r_slow_ = true;
                }
                __WorksRegion0::One => {
                    flag_sd_late_ = true;
                }
                _ => {}
            }
            match after_1_ {
                __WorksRegion1::Three => {
                    flag_ds_slow_ = true;
                }
                __WorksRegion1::Four => {
                    if before_1_ != __WorksRegion1::Four {
                        if {
                            let rising_0_ = rising_now_0_;
                            rising_0_
                        } {
                            flag_p_2_count_ = true;
                        }
                    }
                }
                _ => {}
            }
            self.memory_flag_sd_late = (self.memory_flag_sd_late || flag_sd_late_)
                && !flag_r_late_;
            let done_flag_sd_late_ = OnDelay::update(
                &mut self.timer_flag_sd_late,
                self.memory_flag_sd_late,
                false,
                Ticks::new(2000u32),
                elapsed_,
            );
            let q_late_ = !flag_r_late_ && (done_flag_sd_late_);
            let done_flag_ds_slow_ = OnDelay::update(
                &mut self.timer_flag_ds_slow,
                flag_ds_slow_,
                false,
                Ticks::new(20u32),
                elapsed_,
            );
            self.memory_flag_ds_slow = (self.memory_flag_ds_slow || done_flag_ds_slow_)
                && !flag_r_slow_;
            let q_slow_ = !flag_r_slow_ && (self.memory_flag_ds_slow);
            let q_2_count_ = !false && (flag_p_2_count_);
            match after_1_ {
                __WorksRegion1::Three => {
                    if before_1_ != __WorksRegion1::Three {
                        self.settled = false;
                        self.out_count = {
                            let count = last_count_;
                            count % 900 + 7
                        };
                    }
                }
                _ => {}
            }
            outputs_.late = q_late_;
            outputs_.slow = q_slow_;
            if q_2_count_ {
                {
                    let value_: core::primitive::u16 = {
                        let count = last_count_;
                        count % 900 + 1
                    };
                    if value_ != self.out_count {
                        self.settled = false;
                        self.out_count = value_;
                    }
                }
            } else if self.kept_q_2_count && !q_2_count_ {
                {
                    let value_: core::primitive::u16 = {
                        let count = last_count_;
                        count % 900 + 1
                    };
                    if value_ != self.out_count {
                        self.settled = false;
                        self.out_count = value_;
                    }
                }
            }
            self.kept_q_2_count = q_2_count_;
            self.settled = false;
            outputs_.held = self.out_held;
            outputs_.count = self.out_count;
            outputs_
        })
    }
}
