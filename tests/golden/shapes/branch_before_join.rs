// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __BranchBeforeJoinRegion0 {
    Idle,
    A,
    B,
    INIT,
}
enum __BranchBeforeJoinRegion1 {
    C,
    E,
    NONE,
}
impl BranchBeforeJoin {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &BranchBeforeJoinInputs,
        #[cfg(doc)]
        inputs: &BranchBeforeJoinInputs,
    ) -> BranchBeforeJoinOutputs {
        let mut outputs_ = const {
            BranchBeforeJoinOutputs {
                p: false,
                q: false,
                r: false,
            }
        };
        match self.region_0 {
            __BranchBeforeJoinRegion0::INIT => {
                self.region_0 = __BranchBeforeJoinRegion0::Idle;
            }
            __BranchBeforeJoinRegion0::Idle => {
                if inputs_.a {
                    self.region_0 = __BranchBeforeJoinRegion0::A;
                    self.region_1 = __BranchBeforeJoinRegion1::C;
                    outputs_.p = true;
                }
            }
            _ => {
                if self.region_0 == __BranchBeforeJoinRegion0::B
                    && self.region_1 == __BranchBeforeJoinRegion1::E && inputs_.c
                {
                    self.region_1 = __BranchBeforeJoinRegion1::NONE;
                    self.region_0 = __BranchBeforeJoinRegion0::Idle;
                } else {
                    match self.region_0 {
                        __BranchBeforeJoinRegion0::A => {
                            if inputs_.b {
                                self.region_0 = __BranchBeforeJoinRegion0::B;
                                outputs_.q = true;
                            } else {
                                outputs_.p = true;
                            }
                        }
                        __BranchBeforeJoinRegion0::B => {
                            if !inputs_.c {
                                self.region_0 = __BranchBeforeJoinRegion0::A;
                                outputs_.p = true;
                            } else {
                                outputs_.q = true;
                            }
                        }
                        _ => {}
                    }
                    core::sync::atomic::compiler_fence(
                        core::sync::atomic::Ordering::SeqCst,
                    );
                    match self.region_1 {
                        __BranchBeforeJoinRegion1::C => {
                            if inputs_.c {
                                self.region_1 = __BranchBeforeJoinRegion1::E;
                                outputs_.r = true;
                            }
                        }
                        __BranchBeforeJoinRegion1::E => {
                            outputs_.r = true;
                        }
                        _ => {}
                    }
                }
            }
        }
        outputs_
    }
}
