// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

#[repr(u32)]
enum __LampState {
    Off,
    On,
}
struct __LampStateMark(u8);
impl __LampStateMark {
    const fn of(state_: __LampState) -> Self {
        Self(state_ as u8)
    }
    const fn state(self) -> __LampState {
        let number_ = self.0 & 1u8;
        if number_ >= 1u8 {
            __LampState::On
        } else {
            match number_ {
                _ => __LampState::Off,
            }
        }
    }
    /// Another state, and the mark as it is.
    const fn with(self, state_: __LampState) -> Self {
        Self(self.0 & 2u8 | state_ as u8)
    }
    const fn unmarked(self) -> Self {
        Self(self.0 & 1u8)
    }
    const fn marked(self) -> Self {
        Self(self.0 | 2u8)
    }
    const fn is_marked(self) -> bool {
        self.0 & 2u8 != 0
    }
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
    ) -> LampOutputs {
        let mut outputs_ = LampOutputs { lamp: false };
        let mut now_state_: __LampState = self.situation.state();
        self.situation = __LampStateMark::of(now_state_);
        self.situation = self.situation.unmarked();
        let inputs_ = core::hint::black_box(inputs_);
        let mut evolutions_: u32 = 0;
        loop {
            match now_state_ {
                __LampState::Off => {
                    if inputs_.on {
                        now_state_ = __LampState::On;
                    } else {
                        break;
                    }
                }
                __LampState::On => {
                    if inputs_.off {
                        now_state_ = __LampState::Off;
                    } else {
                        break;
                    }
                }
            }
            self.situation = __LampStateMark::of(now_state_);
            self.situation = self.situation.unmarked();
            evolutions_ = evolutions_.wrapping_add(1);
            if evolutions_ == 6 {
                self.situation = self.situation.marked();
                break;
            }
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.situation.state() {
            __LampState::On => {
                outputs_.lamp = true;
            }
            _ => {}
        }
        outputs_
    }
}
