// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

impl Lamp {
    /// One cycle: evaluates the transition conditions on `inputs`, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(&mut self, inputs: &LampInputs) -> LampOutputs {
        let mut outputs = LampOutputs { lamp: false };
        let first: bool = self.situation.state()
            == __LampState::INIT;
        if first {
            self.situation = self.situation.with(__LampState::Off);
        }
        let mut now_state: __LampState = self.situation.state();
        self.situation = __LampStateMark::of(now_state);
        self.situation = self.situation.unmarked();
        let mut edge0_now: bool = false;
        let mut evolutions: u32 = 0;
        loop {
            let inputs = core::hint::black_box(inputs);
            fence_on_armv6m();
            match now_state {
                __LampState::Off => {
                    edge0_now = inputs.next;
                    if first && evolutions == 0 {
                        self.edge0_before = edge0_now;
                    }
                    if inputs.on {
                        if evolutions == 8 {
                            self.situation = self.situation.marked();
                            break;
                        } else {
                            now_state = __LampState::On;
                        }
                    } else {
                        break;
                    }
                }
                __LampState::On => {
                    edge0_now = inputs.next;
                    if first && evolutions == 0 {
                        self.edge0_before = edge0_now;
                    }
                    if inputs.off {
                        if evolutions == 8 {
                            self.situation = self.situation.marked();
                            break;
                        } else {
                            now_state = __LampState::Off;
                        }
                    } else {
                        if !self.edge0_before && edge0_now {
                            if evolutions == 8 {
                                self.situation = self.situation.marked();
                                break;
                            } else {
                                now_state = __LampState::Bright;
                            }
                        } else {
                            break;
                        }
                    }
                }
                __LampState::Bright => {
                    edge0_now = inputs.next;
                    if first && evolutions == 0 {
                        self.edge0_before = edge0_now;
                    }
                    if inputs.off {
                        if evolutions == 8 {
                            self.situation = self.situation.marked();
                            break;
                        } else {
                            now_state = __LampState::Off;
                        }
                    } else {
                        break;
                    }
                }
                _ => {
                    break;
                }
            }
            self.situation = __LampStateMark::of(now_state);
            self.situation = self.situation.unmarked();
            self.edge0_before = edge0_now;
            evolutions = evolutions.wrapping_add(1);
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.situation.state() {
            __LampState::On | __LampState::Bright => {
                outputs.lamp = true;
            }
            _ => {}
        }
        if !self.situation.is_marked() {
            self.edge0_before = edge0_now;
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
    ) -> Result<
        LampOutputs,
        ForceError<LampStep>,
    > {
        Possible::Alone
            .look(<Self as Chart>::STEPS, steps)?;
        let mut forced0: Option<__LampState> = Option::None;
        for step in steps {
            match *step {
                LampStep::Off => {
                    forced0 = Option::Some(__LampState::Off);
                }
                LampStep::On => {
                    forced0 = Option::Some(__LampState::On);
                }
                LampStep::Bright => {
                    forced0 = Option::Some(__LampState::Bright);
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
            let first: bool = self.situation.state()
                == __LampState::INIT;
            let mut edge0_now: bool = inputs.next;
            self.situation = self.situation.with(forced0);
            self.edge0_before = edge0_now;
            let mut evolutions: u32 = 0;
            evolutions = evolutions.wrapping_add(1);
            let was_state: __LampState = self.situation.state();
            edge0_now = inputs.next;
            if first && evolutions == 0 {
                self.edge0_before = edge0_now;
            }
            self.situation = self.situation.unmarked();
            let next_lamp: bool = was_state == __LampState::On
                || was_state == __LampState::Bright;
            outputs.lamp = next_lamp;
            outputs
        })
    }
}
