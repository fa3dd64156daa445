// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __LampState {
    Off,
    On,
}
#[allow(clippy::all, clippy::pedantic)]
impl Lamp {
    const fn situation_(&self) -> __LampState {
        match self.situation[0usize] & 1u8 {
            1u8 => __LampState::Off,
            _ => __LampState::On,
        }
    }
}
impl Lamp {
    #[allow(unused_assignments)]
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
        let before_ = Self::situation_(self);
        let mut situation_ = before_;
        let mut now_state_: __LampState = situation_;
        situation_ = now_state_;
        self.situation[0usize] &= !4u8;
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
            situation_ = now_state_;
            self.situation[0usize] &= !4u8;
            evolutions_ = evolutions_.wrapping_add(1);
            if evolutions_ == 6 {
                self.situation[0usize] |= 4u8;
                break;
            }
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match situation_ {
            __LampState::On => {
                outputs_.lamp = true;
            }
            _ => {}
        }
        if situation_ != before_ {
            self.situation[0usize] = self.situation[0usize] & 252u8
                | match situation_ {
                    __LampState::Off => 1u8,
                    __LampState::On => 2u8,
                };
        }
        outputs_
    }
}
