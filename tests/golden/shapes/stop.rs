// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __StopState {
    Idle,
    Fill,
    Heat,
    Hold,
    Cool,
    Drain,
    Stopped,
    INIT,
}
impl Stop {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &StopInputs,
        #[cfg(doc)]
        inputs: &StopInputs,
        #[cfg(not(doc))]
        now_: impl core::convert::Into<
            Ticks,
        >,
        #[cfg(doc)]
        now: impl core::convert::Into<Ticks>,
    ) -> StopOutputs {
        let now_: Ticks = core::convert::Into::into(
            now_,
        );
        let mut outputs_ = const {
            StopOutputs {
                fill: false,
                heat: false,
                stir: false,
                drain: false,
                red: false,
            }
        };
        if inputs_.stop {
            if self.delay0_stage == 0 {
                self.delay0_since = now_;
                self.delay0_stage = 1;
            } else {
                if self.delay0_stage == 1
                    && has_reached!(
                        now_.since(self.delay0_since),
                        Ticks::new(200u32)
                    )
                {
                    self.delay0_stage = 2;
                }
            }
        } else {
            self.delay0_stage = 0;
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        let was_state_: __StopState = self.situation;
        self.before_state = self.situation;
        let after_: __StopState;
        if inputs_.stop && self.delay0_stage == 2
            && core::matches!(
                self.situation, __StopState::Idle | __StopState::Fill | __StopState::Heat
                | __StopState::Hold | __StopState::Cool | __StopState::Drain
            )
        {
            after_ = __StopState::Stopped;
        } else {
            match self.situation {
                __StopState::INIT => {
                    after_ = __StopState::Idle;
                }
                __StopState::Idle => {
                    if inputs_.start {
                        after_ = __StopState::Fill;
                    } else {
                        after_ = __StopState::Idle;
                    }
                }
                __StopState::Fill => {
                    if !inputs_.low {
                        after_ = __StopState::Heat;
                    } else {
                        after_ = __StopState::Fill;
                    }
                }
                __StopState::Heat => {
                    if inputs_.hot {
                        after_ = __StopState::Hold;
                    } else {
                        after_ = __StopState::Heat;
                    }
                }
                __StopState::Hold => {
                    if has_reached!(
                        now_.since(self.since), Ticks::new(5000u32)
                    ) {
                        after_ = __StopState::Cool;
                    } else {
                        after_ = __StopState::Hold;
                    }
                }
                __StopState::Cool => {
                    if !inputs_.hot {
                        after_ = __StopState::Drain;
                    } else {
                        after_ = __StopState::Cool;
                    }
                }
                __StopState::Drain => {
                    if inputs_.empty {
                        after_ = __StopState::Idle;
                    } else {
                        after_ = __StopState::Drain;
                    }
                }
                __StopState::Stopped => {
                    if !inputs_.stop & inputs_.ack {
                        after_ = __StopState::Idle;
                    } else {
                        after_ = __StopState::Stopped;
                    }
                }
            }
        }
        self.situation = after_;
        if was_state_ != after_ {
            self.since = now_;
        }
        match after_ {
            __StopState::Fill => {
                outputs_.fill = true;
            }
            __StopState::Heat => {
                outputs_.heat = true;
                outputs_.stir = true;
            }
            __StopState::Hold | __StopState::Cool => {
                outputs_.stir = true;
            }
            __StopState::Drain => {
                outputs_.drain = true;
            }
            __StopState::Stopped => {
                outputs_.red = true;
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
        if self.before_state != self.situation {
            return Option::Some(self.since);
        }
        let mut soonest_ = Option::None;
        if self.situation == __StopState::Hold {
            soonest_ = earlier(
                soonest_,
                self.since.after(Ticks::new(5000u32)),
            );
        }
        if self.delay0_stage == 1 {
            soonest_ = earlier(
                soonest_,
                self.delay0_since.after(Ticks::new(200u32)),
            );
        }
        soonest_
    }
}
