// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

impl Lamp {
    /// One cycle: evaluates the transition conditions on `inputs`, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        inputs: &LampInputs,
        now: impl core::convert::Into<Ticks>,
    ) -> LampOutputs {
        let now: Ticks = core::convert::Into::into(
            now,
        );
        let mut outputs = LampOutputs { lamp: false };
        self.reading = now;
        match self.situation {
            __LampState::INIT => {
                self.situation = __LampState::Off;
                self.since = now;
                self.settled = false;
            }
            __LampState::Off => {
                if inputs.on {
                    self.situation = __LampState::On;
                    self.since = now;
                    self.settled = false;
                } else {
                    self.settled = true;
                }
            }
            __LampState::On => {
                if now.since(self.since) >= Ticks::new(5000u32) {
                    self.situation = __LampState::Off;
                    self.since = now;
                    self.settled = false;
                } else {
                    self.settled = true;
                }
            }
        }
        match self.situation {
            __LampState::On => {
                outputs.lamp = true;
            }
            _ => {}
        }
        outputs
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
        steps: &[LampStep],
        inputs: &LampInputs,
        now: impl core::convert::Into<Ticks>,
    ) -> Result<
        LampOutputs,
        ForceError<LampStep>,
    > {
        Possible::Alone
            .look(<Self as Chart>::STEPS, steps)?;
        let now: Ticks = core::convert::Into::into(
            now,
        );
        let mut forced0: Option<__LampState> = Option::None;
        for step in steps {
            match *step {
                LampStep::Off => {
                    forced0 = Option::Some(__LampState::Off);
                }
                LampStep::On => {
                    forced0 = Option::Some(__LampState::On);
                }
            }
        }
        let forced0 = match forced0 {
            Option::Some(state) => state,
            Option::None => {
                return Result::Err(
                    ForceError::NoSituation,
                );
            }
        };
        Result::Ok({
            let mut outputs = LampOutputs { lamp: false };
            let first: bool = self.situation == __LampState::INIT;
            if first {
                self.situation = __LampState::Off;
            }
            self.reading = now;
            if first {
                self.since = now;
            }
            let was_state: __LampState = self.situation;
            let entered_off: bool = forced0 == __LampState::Off
                && (first || was_state != __LampState::Off);
            let entered_on: bool = forced0 == __LampState::On
                && (first || was_state != __LampState::On);
            self.situation = forced0;
            if entered_off || entered_on {
                self.since = now;
            }
            let on_on_0_: bool = self.situation == __LampState::On;
            let q_lamp: bool = on_on_0_;
            outputs.lamp = q_lamp;
            if was_state == __LampState::On && self.situation == __LampState::On
                && now.since(self.since) >= Ticks::new(5000u32)
            {
                self.since = now.since(Ticks::new(5000u32));
            }
            self.settled = false;
            outputs
        })
    }
}
