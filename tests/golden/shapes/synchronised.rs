// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __StationsRegion0 {
    Start,
    Wait,
    Saw,
    INIT,
}
enum __StationsRegion1 {
    Empty,
    Full,
    NONE,
}
enum __StationsRegion2 {
    Idle,
    Bend,
    NONE,
}
enum __StationsRegion3 {
    Free,
    Taken,
    NONE,
}
impl Stations {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &StationsInputs,
        #[cfg(doc)]
        inputs: &StationsInputs,
    ) -> StationsOutputs {
        let mut outputs_ = const {
            StationsOutputs {
                saw: false,
                press: false,
            }
        };
        match self.region_0 {
            __StationsRegion0::INIT => {
                self.region_0 = __StationsRegion0::Start;
            }
            __StationsRegion0::Start => {
                self.region_0 = __StationsRegion0::Wait;
                self.region_1 = __StationsRegion1::Empty;
                self.region_2 = __StationsRegion2::Idle;
                core::sync::atomic::compiler_fence(
                    core::sync::atomic::Ordering::SeqCst,
                );
                self.region_3 = __StationsRegion3::Free;
            }
            _ => {
                let was_state_empty_: __StationsRegion1 = self.region_1;
                let was_state_free_: __StationsRegion3 = self.region_3;
                match self.region_0 {
                    __StationsRegion0::Wait => {
                        if inputs_.come {
                            self.region_0 = __StationsRegion0::Saw;
                        }
                    }
                    __StationsRegion0::Saw => {
                        if self.region_1 == __StationsRegion1::Empty && inputs_.cut {
                            self.region_0 = __StationsRegion0::Wait;
                            self.region_1 = __StationsRegion1::Full;
                        }
                    }
                    _ => {}
                }
                core::sync::atomic::compiler_fence(
                    core::sync::atomic::Ordering::SeqCst,
                );
                match self.region_2 {
                    __StationsRegion2::Idle => {
                        if was_state_empty_ == __StationsRegion1::Full {
                            self.region_1 = __StationsRegion1::Empty;
                            self.region_2 = __StationsRegion2::Bend;
                        }
                    }
                    __StationsRegion2::Bend => {
                        if self.region_3 == __StationsRegion3::Free && inputs_.bent {
                            self.region_2 = __StationsRegion2::Idle;
                            self.region_3 = __StationsRegion3::Taken;
                        }
                    }
                    _ => {}
                }
                if was_state_free_ == __StationsRegion3::Taken && inputs_.gone {
                    self.region_3 = __StationsRegion3::Free;
                }
                outputs_.saw = self.region_0 == __StationsRegion0::Saw;
                outputs_.press = self.region_2 == __StationsRegion2::Bend;
            }
        }
        outputs_
    }
}
