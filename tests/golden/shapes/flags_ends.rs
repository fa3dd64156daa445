// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __LampState {
    Off,
    On,
    INIT,
}
#[allow(clippy::all, clippy::pedantic)]
impl Lamp {
    const fn situation_(&self) -> __LampState {
        if self.situation[0usize] & 4u8 != 0 {
            return __LampState::INIT;
        }
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
        if before_ == __LampState::INIT {
            self.situation = [1u8];
        }
        match situation_ {
            __LampState::INIT => {
                situation_ = __LampState::Off;
                if inputs_.on {
                    situation_ = __LampState::On;
                }
            }
            __LampState::Off => {
                if inputs_.on {
                    situation_ = __LampState::On;
                }
            }
            __LampState::On => {
                if !inputs_.on {
                    situation_ = __LampState::Off;
                }
            }
        }
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
                    _ => 0u8,
                };
        }
        outputs_
    }
}
