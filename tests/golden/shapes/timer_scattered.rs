// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __TimerScatteredState {
    Idle,
    Take,
    Blow,
    Turn,
    Place,
    Clean,
    Back,
    Wait,
    Fault,
    INIT,
}
impl TimerScattered {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &TimerScatteredInputs,
        #[cfg(doc)]
        inputs: &TimerScatteredInputs,
        #[cfg(not(doc))]
        now_: impl core::convert::Into<
            Ticks,
        >,
        #[cfg(doc)]
        now: impl core::convert::Into<Ticks>,
    ) -> TimerScatteredOutputs {
        let now_: Ticks = core::convert::Into::into(
            now_,
        );
        let mut outputs_ = const {
            TimerScatteredOutputs {
                p: false,
                q: false,
                r: false,
                blow: false,
                horn: false,
            }
        };
        let was_state_: __TimerScatteredState = self.situation;
        self.before_state = self.situation;
        self.reading = now_;
        let passed_: Ticks = now_.since(self.since);
        match self.situation {
            __TimerScatteredState::INIT => {
                self.situation = __TimerScatteredState::Idle;
            }
            __TimerScatteredState::Idle => {
                if inputs_.a {
                    self.situation = __TimerScatteredState::Take;
                }
            }
            __TimerScatteredState::Take => {
                if inputs_.b {
                    self.situation = __TimerScatteredState::Blow;
                    outputs_.blow = true;
                } else {
                    if has_reached!(
                        passed_, Ticks::new(2000u32)
                    ) {
                        self.situation = __TimerScatteredState::Fault;
                        self.sd_ff_horn = true;
                    }
                }
            }
            __TimerScatteredState::Blow => {
                if has_reached!(
                    passed_, Ticks::new(400u32)
                ) {
                    if inputs_.c {
                        self.situation = __TimerScatteredState::Turn;
                    } else {
                        outputs_.blow = false;
                        self.since = now_
                            .since(Ticks::new(400u32));
                    }
                } else {
                    outputs_.blow = passed_ < Ticks::new(300u32);
                }
            }
            __TimerScatteredState::Turn => {
                if inputs_.a {
                    self.situation = __TimerScatteredState::Place;
                } else {
                    if has_reached!(
                        passed_, Ticks::new(2000u32)
                    ) {
                        self.situation = __TimerScatteredState::Fault;
                        self.sd_ff_horn = true;
                    }
                }
            }
            __TimerScatteredState::Place => {
                if inputs_.b {
                    self.situation = __TimerScatteredState::Clean;
                    outputs_.blow = true;
                } else {
                    if has_reached!(
                        passed_, Ticks::new(2000u32)
                    ) {
                        self.situation = __TimerScatteredState::Fault;
                        self.sd_ff_horn = true;
                    }
                }
            }
            __TimerScatteredState::Clean => {
                if inputs_.c {
                    self.situation = __TimerScatteredState::Back;
                } else {
                    outputs_.blow = passed_ < Ticks::new(300u32);
                    if has_reached!(
                        passed_, Ticks::new(300u32)
                    ) {
                        self.since = now_
                            .since(Ticks::new(300u32));
                    }
                }
            }
            __TimerScatteredState::Back => {
                if inputs_.a {
                    self.situation = __TimerScatteredState::Wait;
                } else {
                    if has_reached!(
                        passed_, Ticks::new(2000u32)
                    ) {
                        self.situation = __TimerScatteredState::Fault;
                        self.sd_ff_horn = true;
                    }
                }
            }
            __TimerScatteredState::Wait => {
                if inputs_.b {
                    self.situation = __TimerScatteredState::Idle;
                    self.sd_ff_horn = false;
                }
            }
            __TimerScatteredState::Fault => {
                if inputs_.ack {
                    self.situation = __TimerScatteredState::Take;
                }
            }
        }
        if was_state_ != self.situation {
            self.since = now_;
        }
        let mut on_idle_0__: bool = false;
        match self.situation {
            __TimerScatteredState::Idle => {
                on_idle_0__ = true;
            }
            __TimerScatteredState::Take => {
                outputs_.p = true;
            }
            __TimerScatteredState::Turn => {
                outputs_.q = true;
            }
            __TimerScatteredState::Place => {
                outputs_.r = true;
            }
            __TimerScatteredState::Back => {
                outputs_.p = true;
                outputs_.q = true;
            }
            __TimerScatteredState::Wait => {
                outputs_.p = true;
                outputs_.r = true;
            }
            _ => {}
        }
        if self.sd_ff_horn {
            if self.sd_tmr_horn_stage == 0 {
                self.sd_tmr_horn_since = now_;
                self.sd_tmr_horn_stage = 1;
            } else {
                if self.sd_tmr_horn_stage == 1
                    && has_reached!(
                        now_.since(self.sd_tmr_horn_since),
                        Ticks::new(1000u32)
                    )
                {
                    self.sd_tmr_horn_stage = 2;
                }
            }
        } else {
            self.sd_tmr_horn_stage = 0;
        }
        outputs_.horn = !on_idle_0__ && self.sd_tmr_horn_stage == 2;
        outputs_
    }
    /// The reading of the clock before which nothing changes unless an input does (or the recipe): a controller
    /// that sleeps until then behaves like one that scans all the time. The reading of the last cycle means
    /// "scan again at once"; `None` means "only an input can change anything".
    #[must_use]
    fn next_deadline(
        &self,
    ) -> Option<Ticks> {
        if self.before_state != self.situation {
            return Option::Some(self.since);
        }
        let mut soonest_ = Option::None;
        if self.situation == __TimerScatteredState::Take
            && self.reading.since(self.since) < Ticks::new(2000u32)
        {
            soonest_ = earlier(
                soonest_,
                self
                    .reading
                    .after(
                        Ticks::new(2000u32)
                            - self.reading.since(self.since),
                    ),
            );
        }
        if self.situation == __TimerScatteredState::Blow
            && self.reading.since(self.since) < Ticks::new(300u32)
        {
            soonest_ = earlier(
                soonest_,
                self
                    .reading
                    .after(
                        Ticks::new(300u32)
                            - self.reading.since(self.since),
                    ),
            );
        }
        if self.situation == __TimerScatteredState::Blow
            && self.reading.since(self.since) < Ticks::new(400u32)
        {
            soonest_ = earlier(
                soonest_,
                self
                    .reading
                    .after(
                        Ticks::new(400u32)
                            - self.reading.since(self.since),
                    ),
            );
        }
        if self.situation == __TimerScatteredState::Turn
            && self.reading.since(self.since) < Ticks::new(2000u32)
        {
            soonest_ = earlier(
                soonest_,
                self
                    .reading
                    .after(
                        Ticks::new(2000u32)
                            - self.reading.since(self.since),
                    ),
            );
        }
        if self.situation == __TimerScatteredState::Place
            && self.reading.since(self.since) < Ticks::new(2000u32)
        {
            soonest_ = earlier(
                soonest_,
                self
                    .reading
                    .after(
                        Ticks::new(2000u32)
                            - self.reading.since(self.since),
                    ),
            );
        }
        if self.situation == __TimerScatteredState::Clean
            && self.reading.since(self.since) < Ticks::new(300u32)
        {
            soonest_ = earlier(
                soonest_,
                self
                    .reading
                    .after(
                        Ticks::new(300u32)
                            - self.reading.since(self.since),
                    ),
            );
        }
        if self.situation == __TimerScatteredState::Back
            && self.reading.since(self.since) < Ticks::new(2000u32)
        {
            soonest_ = earlier(
                soonest_,
                self
                    .reading
                    .after(
                        Ticks::new(2000u32)
                            - self.reading.since(self.since),
                    ),
            );
        }
        if self.sd_tmr_horn_stage == 1 {
            soonest_ = earlier(
                soonest_,
                self.sd_tmr_horn_since.after(Ticks::new(1000u32)),
            );
        }
        soonest_
    }
}
