// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __LampState {
    Off,
    On,
    INIT,
}
impl Lamp {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &LampInputs,
        #[cfg(doc)]
        inputs: &LampInputs,
        #[cfg(not(doc))]
        now_: impl core::convert::Into<
            Ticks,
        >,
        #[cfg(doc)]
        now: impl core::convert::Into<Ticks>,
    ) -> LampOutputs {
        let now_: Ticks = core::convert::Into::into(
            now_,
        );
        let mut outputs_ = LampOutputs { lamp: false };
        self.reading = now_;
        match self.situation {
            __LampState::INIT => {
                self.situation = __LampState::Off;
                self.since = now_;
                self.settled = false;
            }
            __LampState::Off => {
                if inputs_.on {
                    self.situation = __LampState::On;
                    self.since = now_;
                    self.settled = false;
                } else {
                    self.settled = true;
                }
            }
            __LampState::On => {
                if has_reached!(
                    now_.since(self.since), Ticks::new(5000u32)
                ) {
                    self.situation = __LampState::Off;
                    self.since = now_;
                    self.settled = false;
                } else {
                    self.settled = true;
                }
            }
        }
        match self.situation {
            __LampState::On => {
                outputs_.lamp = true;
            }
            _ => {}
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
        if self.situation == __LampState::On {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(5000u32),
                ),
            );
        }
        match soonest_ {
            Option::Some(time_) => {
                Option::Some(self.since.after(time_))
            }
            Option::None => Option::None,
        }
    }
}
impl Lamp {
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
        steps_: &[LampStep],
        #[cfg(doc)]
        steps: &[LampStep],
        #[cfg(not(doc))]
        inputs_: &LampInputs,
        #[cfg(doc)]
        inputs: &LampInputs,
        #[cfg(not(doc))]
        now_: impl core::convert::Into<
            Ticks,
        >,
        #[cfg(doc)]
        now: impl core::convert::Into<Ticks>,
    ) -> Result<
        LampOutputs,
        ForceError<LampStep>,
    > {
        Possible::Alone
            .look(<Self as Chart>::STEPS, steps_)?;
        let now_: Ticks = core::convert::Into::into(
            now_,
        );
        let mut forced0_: Option<__LampState> = Option::None;
        for step_ in steps_ {
            match *step_ {
                LampStep::Off => {
                    forced0_ = Option::Some(__LampState::Off);
                }
                LampStep::On => {
                    forced0_ = Option::Some(__LampState::On);
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
        Result::Ok({
            let mut outputs_ = LampOutputs { lamp: false };
            let first_: bool = self.situation == __LampState::INIT;
            if first_ {
                self.situation = __LampState::Off;
            }
            self.reading = now_;
            if first_ {
                self.since = now_;
            }
            let was_state_: __LampState = self.situation;
            let entered_off_: bool = forced0_ == __LampState::Off
                && (first_ || was_state_ != __LampState::Off);
            let entered_on_: bool = forced0_ == __LampState::On
                && (first_ || was_state_ != __LampState::On);
            self.situation = forced0_;
            if entered_off_ || entered_on_ {
                self.since = now_;
            }
            let on_on_0__: bool = self.situation
                == __LampState::On;
            let q_lamp_: bool = on_on_0__;
            outputs_.lamp = q_lamp_;
            if was_state_ == __LampState::On && self.situation == __LampState::On
                && has_reached!(
                    now_.since(self.since), Ticks::new(5000u32)
                )
            {
                self.since = now_.since(Ticks::new(5000u32));
            }
            self.settled = false;
            outputs_
        })
    }
}
