// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

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
        let elapsed_ = if self.region_0 == __KilnRegion0::INIT {
            Ticks::ZERO
        } else {
            now_.since(self.now)
        };
        self.now = now_;
        self.since_0 = self.since_0 + elapsed_;
        if self.region_0 == __KilnRegion0::INIT {
            self.region_0 = __KilnRegion0::Idle;
        }
        {
            #[allow(unused_variables)]
            let before_0_ = self.region_0;
            #[allow(unused_variables)]
            let before_1_ = self.region_1;
            let input_ = inputs_.hot;
            Delay::update(
                &mut self.delay_0,
                input_,
                Ticks::new(1000u32),
                Ticks::new(2000u32),
                elapsed_,
            );
        }
        let mut rising_now_0_ = false;
        let value_: bool = inputs_.start;
        rising_now_0_ = value_ && !self.edge_0;
        self.edge_0 = value_;
        self.settled = true;
        let inputs_ = core::hint::black_box(inputs_);
        loop {
            core::sync::atomic::compiler_fence(
                core::sync::atomic::Ordering::SeqCst,
            );
            #[allow(unused_variables)]
            let before_0_ = self.region_0;
            #[allow(unused_variables)]
            let before_1_ = self.region_1;
            let mut moved_ = false;
            match self.region_0 {
                __KilnRegion0::Idle => {
                    if {
                        let rising_0_ = rising_now_0_;
                        rising_0_
                    } {
                        self.out_count = {
                            let count = self.out_count;
                            let level = inputs_.level;
                            count + level % 7
                        };
                        self.region_0 = __KilnRegion0::One;
                        self.since_0 = Ticks::ZERO;
                        self.region_1 = __KilnRegion1::Three;
                        moved_ = true;
                    }
                }
                _ => {
                    if self.region_0 == __KilnRegion0::Two
                        && self.region_1 == __KilnRegion1::Four
                        && {
                            let start = inputs_.start;
                            let last = self.out_last;
                            let next = inputs_.next;
                            !(start && last > 2 && !next)
                        }
                    {
                        self.region_1 = __KilnRegion1::NONE;
                        self.region_0 = __KilnRegion0::Idle;
                        moved_ = true;
                    } else {
                        match self.region_0 {
                            __KilnRegion0::One => {
                                if (before_0_ == __KilnRegion0::One)
                                    && (if before_0_ == __KilnRegion0::One {
                                        self.since_0
                                    } else {
                                        Ticks::ZERO
                                    }) >= self.params.limit
                                {
                                    self.region_0 = __KilnRegion0::Two;
                                    self.since_0 = Ticks::ZERO;
                                    moved_ = true;
                                }
                            }
                            _ => {}
                        }
                        match self.region_1 {
                            __KilnRegion1::Three => {
                                if inputs_.next {
                                    self.region_1 = __KilnRegion1::Four;
                                    moved_ = true;
                                }
                            }
                            __KilnRegion1::Four => {
                                if {
                                    let start = inputs_.start;
                                    let last = self.out_last;
                                    let next = inputs_.next;
                                    start && last > 2 && !next
                                } {
                                    self.out_count = {
                                        let count = self.out_count;
                                        let level = inputs_.level;
                                        count + level % 7
                                    };
                                    self.region_1 = __KilnRegion1::Three;
                                    moved_ = true;
                                }
                            }
                            _ => {}
                        }
                    }
                }
            }
            #[allow(unused_variables)]
            let after_0_ = self.region_0;
            #[allow(unused_variables)]
            let after_1_ = self.region_1;
            if !moved_ {
                break;
            }
            match self.region_1 {
                __KilnRegion1::Three => {
                    if before_1_ != __KilnRegion1::Three {
                        self.out_last = {
                            let last = self.out_last;
                            last % 50 + 3
                        };
                    }
                }
                _ => {}
            }
            self.settled = false;
            rising_now_0_ = false;
        }
        if rising_now_0_ {
            self.settled = false;
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        #[allow(unused_variables)]
        let after_0_ = self.region_0;
        #[allow(unused_variables)]
        let after_1_ = self.region_1;
        match self.region_0 {
            __KilnRegion0::Idle => {}
            _ => {
                match self.region_0 {
                    __KilnRegion0::One => {
                        if {
                            let delay_0_ = Delay::output(
                                &self.delay_0,
                            );
                            delay_0_
                        } {
                            outputs_.fire = true;
                        }
                    }
                    _ => {
                        match self.region_0 {
                            __KilnRegion0::Two => {
                                if ((after_0_ == __KilnRegion0::Two)
                                    && (if after_0_ == __KilnRegion0::Two {
                                        self.since_0
                                    } else {
                                        Ticks::ZERO
                                    }) >= Ticks::new(500u32))
                                {
                                    outputs_.fire = true;
                                }
                            }
                            _ => {}
                        }
                    }
                }
            }
        }
        outputs_.count = self.out_count;
        outputs_.last = self.out_last;
        outputs_
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
            let elapsed_ = if self.region_0 == __KilnRegion0::INIT {
                Ticks::ZERO
            } else {
                now_.since(self.now)
            };
            self.now = now_;
            self.since_0 = self.since_0 + elapsed_;
            if self.region_0 == __KilnRegion0::INIT {
                self.region_0 = __KilnRegion0::Idle;
            }
            {
                let before_0_ = self.region_0;
                let before_1_ = self.region_1;
                let input_ = inputs_.hot;
                Delay::update(
                    &mut self.delay_0,
                    input_,
                    Ticks::new(1000u32),
                    Ticks::new(2000u32),
                    elapsed_,
                );
            }
            let mut rising_now_0_ = false;
            let value_: bool = inputs_.start;
            rising_now_0_ = value_ && !self.edge_0;
            self.edge_0 = value_;
            {
                let before_0_ = self.region_0;
                let before_1_ = self.region_1;
                let after_0_ = forced0_;
                let after_1_ = forced1_;
                let mut next_count_ = self.out_count;
                let mut next_last_ = self.out_last;
                match after_1_ {
                    __KilnRegion1::Three => {
                        if before_1_ != __KilnRegion1::Three {
                            next_count_ = {
                                let count = self.out_count;
                                let level = inputs_.level;
                                count + level % 7
                            };
                        }
                        if before_1_ != __KilnRegion1::Three {
                            next_last_ = {
                                let last = self.out_last;
                                last % 50 + 3
                            };
                        }
                    }
                    _ => {}
                }
                self.out_count = next_count_;
                self.out_last = next_last_;
                self.region_0 = after_0_;
                self.region_1 = after_1_;
                if after_0_ != before_0_ {
                    self.since_0 = Ticks::ZERO;
                }
                rising_now_0_ = false;
            }
            let edge_before_0_ = self.edge_0;
            {
                let before_0_ = self.region_0;
                let before_1_ = self.region_1;
            }
            self.edge_0 = edge_before_0_;
            let after_0_ = self.region_0;
            let after_1_ = self.region_1;
            match after_0_ {
                __KilnRegion0::One => {
                    if {
                        let delay_0_ = Delay::output(
                            &self.delay_0,
                        );
                        delay_0_
                    } {
                        outputs_.fire = true;
                    }
                }
                __KilnRegion0::Two => {
                    if ((after_0_ == __KilnRegion0::Two)
                        && (if after_0_ == __KilnRegion0::Two {
                            self.since_0
                        } else {
                            Ticks::ZERO
                        }) >= Ticks::new(500u32))
                    {
                        outputs_.fire = true;
                    }
                }
                _ => {}
            }
            self.settled = false;
            outputs_.count = self.out_count;
            outputs_.last = self.out_last;
            outputs_
        })
    }
}
