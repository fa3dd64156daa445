// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __OvenState {
    Idle,
    Heat,
    INIT,
}
impl Oven {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &OvenInputs,
        #[cfg(doc)]
        inputs: &OvenInputs,
        #[cfg(not(doc))]
        actions_: &mut (impl OvenActions + ?core::marker::Sized),
        #[cfg(doc)]
        actions: &mut (impl OvenActions + ?core::marker::Sized),
    ) -> OvenOutputs {
        let outputs_ = OvenOutputs {};
        match self.situation {
            __OvenState::INIT => {
                self.situation = __OvenState::Idle;
            }
            __OvenState::Idle => {
                if inputs_.start {
                    self.situation = __OvenState::Heat;
                    actions_
                        .heat(
                            Phase::First,
                            {
                                let power = self.params.power;
                                power
                            },
                        );
                }
            }
            __OvenState::Heat => {
                if inputs_.hot {
                    self.situation = __OvenState::Idle;
                    actions_
                        .heat(
                            Phase::Final,
                            {
                                let power = self.params.power;
                                power
                            },
                        );
                } else {
                    actions_
                        .heat(
                            Phase::Repeated,
                            {
                                let power = self.params.power;
                                power
                            },
                        );
                }
            }
        }
        outputs_
    }
}
