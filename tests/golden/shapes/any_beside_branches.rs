// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __AnyBesideBranchesRegion0 {
    Idle,
    A,
    B,
    Stopped,
    INIT,
}
enum __AnyBesideBranchesRegion1 {
    C,
    E,
    NONE,
}
impl AnyBesideBranches {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &AnyBesideBranchesInputs,
        #[cfg(doc)]
        inputs: &AnyBesideBranchesInputs,
    ) -> AnyBesideBranchesOutputs {
        let mut outputs_ = const {
            AnyBesideBranchesOutputs {
                p: false,
                q: false,
                r: false,
                s: false,
            }
        };
        match self.region_0 {
            __AnyBesideBranchesRegion0::INIT => {
                self.region_0 = __AnyBesideBranchesRegion0::Idle;
            }
            __AnyBesideBranchesRegion0::Idle => {
                if inputs_.a {
                    self.region_0 = __AnyBesideBranchesRegion0::A;
                    self.region_1 = __AnyBesideBranchesRegion1::C;
                    outputs_.p = true;
                    outputs_.r = true;
                }
            }
            __AnyBesideBranchesRegion0::Stopped => {
                if !inputs_.stop {
                    self.region_0 = __AnyBesideBranchesRegion0::Idle;
                }
            }
            _ => {
                if inputs_.stop {
                    self.region_1 = __AnyBesideBranchesRegion1::NONE;
                    self.region_0 = __AnyBesideBranchesRegion0::Stopped;
                } else {
                    if self.region_0 == __AnyBesideBranchesRegion0::B
                        && self.region_1 == __AnyBesideBranchesRegion1::E && inputs_.d
                    {
                        self.region_1 = __AnyBesideBranchesRegion1::NONE;
                        self.region_0 = __AnyBesideBranchesRegion0::Idle;
                    } else {
                        match self.region_0 {
                            __AnyBesideBranchesRegion0::A => {
                                if inputs_.b {
                                    self.region_0 = __AnyBesideBranchesRegion0::B;
                                    outputs_.q = true;
                                } else {
                                    outputs_.p = true;
                                }
                            }
                            __AnyBesideBranchesRegion0::B => {
                                outputs_.q = true;
                            }
                            _ => {}
                        }
                        core::sync::atomic::compiler_fence(
                            core::sync::atomic::Ordering::SeqCst,
                        );
                        match self.region_1 {
                            __AnyBesideBranchesRegion1::C => {
                                if inputs_.c {
                                    self.region_1 = __AnyBesideBranchesRegion1::E;
                                    outputs_.s = true;
                                } else {
                                    outputs_.r = true;
                                }
                            }
                            __AnyBesideBranchesRegion1::E => {
                                outputs_.s = true;
                            }
                            _ => {}
                        }
                    }
                }
            }
        }
        outputs_
    }
}
