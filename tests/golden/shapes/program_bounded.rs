// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

impl Lamp {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &LampInputs,
        #[cfg(doc)]
        inputs: &LampInputs,
    ) -> LampOutputs {
        let mut outputs_ = LampOutputs { lamp: false };
        let first_: bool = self.situation.state()
            == __LampState::INIT;
        if first_ {
            self.situation = self.situation.with(__LampState::Off);
        }
        let edge0_now_: bool = inputs_.next;
        if first_ {
            self.edge0_before = edge0_now_;
        }
        let mut now_state_: __LampState = self.situation.state();
        self.situation = __LampStateMark::of(now_state_);
        self.situation = self.situation.unmarked();
        let mut evolutions_: u32 = 0;
        loop {
            let inputs_ = core::hint::black_box(inputs_);
            fence_on_armv6m();
            match now_state_ {
                __LampState::Off => {
                    if inputs_.on {
                        if evolutions_ == 8 {
                            self.situation = self.situation.marked();
                            break;
                        } else {
                            now_state_ = __LampState::On;
                        }
                    } else {
                        break;
                    }
                }
                __LampState::On => {
                    if inputs_.off {
                        if evolutions_ == 8 {
                            self.situation = self.situation.marked();
                            break;
                        } else {
                            now_state_ = __LampState::Off;
                        }
                    } else {
                        if !self.edge0_before && edge0_now_ {
                            if evolutions_ == 8 {
                                self.situation = self.situation.marked();
                                break;
                            } else {
                                now_state_ = __LampState::Bright;
                            }
                        } else {
                            break;
                        }
                    }
                }
                __LampState::Bright => {
                    if inputs_.off {
                        if evolutions_ == 8 {
                            self.situation = self.situation.marked();
                            break;
                        } else {
                            now_state_ = __LampState::Off;
                        }
                    } else {
                        break;
                    }
                }
                _ => {
                    break;
                }
            }
            self.situation = __LampStateMark::of(now_state_);
            self.situation = self.situation.unmarked();
            self.edge0_before = edge0_now_;
            evolutions_ = evolutions_.wrapping_add(1);
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.situation.state() {
            __LampState::On | __LampState::Bright => {
                outputs_.lamp = true;
            }
            _ => {}
        }
        if !self.situation.is_marked() {
            self.edge0_before = edge0_now_;
        }
        outputs_
    }
}
