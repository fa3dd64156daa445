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
