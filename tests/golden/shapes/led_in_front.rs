// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __UnloadingRegion0 {
    Tripped,
    Stopped,
    Locked,
    Release,
    Index,
}
enum __UnloadingRegion3 {
    Empty,
    Test,
    Good,
    Scrap,
    Clear,
}
impl Unloading {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &UnloadingInputs,
        #[cfg(doc)]
        inputs: &UnloadingInputs,
    ) -> UnloadingOutputs {
        let mut outputs_ = const {
            UnloadingOutputs {
                turn: false,
                pin: false,
                test: false,
                bin: false,
            }
        };
        let inputs_ = core::hint::black_box(inputs_);
        loop {
            fence_on_armv6m();
            let mut moves_38__: bool = false;
            let was_state_empty_: __UnloadingRegion3 = self.region_3;
            match self.region_0 {
                __UnloadingRegion0::Tripped => {
                    if inputs_.guard {
                        self.region_0 = __UnloadingRegion0::Stopped;
                        moves_38__ = true;
                    }
                }
                _ => {
                    if !inputs_.guard {
                        moves_38__ = true;
                        self.region_3 = __UnloadingRegion3::Empty;
                        self.region_0 = __UnloadingRegion0::Tripped;
                    } else {
                        match self.region_3 {
                            __UnloadingRegion3::Empty => {
                                if self.region_0 == __UnloadingRegion0::Index {
                                    self.region_3 = __UnloadingRegion3::Test;
                                    moves_38__ = true;
                                }
                            }
                            __UnloadingRegion3::Test => {
                                if inputs_.good {
                                    if !self.bad {
                                        self.region_3 = __UnloadingRegion3::Good;
                                        moves_38__ = true;
                                    }
                                } else {
                                    if self.bad {
                                        self.region_3 = __UnloadingRegion3::Scrap;
                                        moves_38__ = true;
                                    }
                                }
                            }
                            __UnloadingRegion3::Good => {
                                if inputs_.away {
                                    self.region_3 = __UnloadingRegion3::Clear;
                                    moves_38__ = true;
                                }
                            }
                            __UnloadingRegion3::Scrap => {
                                if inputs_.away {
                                    self.region_3 = __UnloadingRegion3::Clear;
                                    moves_38__ = true;
                                }
                            }
                            __UnloadingRegion3::Clear => {
                                if !inputs_.away {
                                    self.region_3 = __UnloadingRegion3::Empty;
                                    moves_38__ = true;
                                }
                            }
                        }
                        core::sync::atomic::compiler_fence(
                            core::sync::atomic::Ordering::SeqCst,
                        );
                        match self.region_0 {
                            __UnloadingRegion0::Stopped => {
                                if inputs_.auto {
                                    moves_38__ = true;
                                    self.region_0 = __UnloadingRegion0::Locked;
                                }
                            }
                            _ => {
                                if !inputs_.auto
                                    && self.region_0 == __UnloadingRegion0::Locked
                                {
                                    moves_38__ = true;
                                    self.region_0 = __UnloadingRegion0::Stopped;
                                } else {
                                    match self.region_0 {
                                        __UnloadingRegion0::Locked => {
                                            if inputs_.auto
                                                && was_state_empty_ == __UnloadingRegion3::Empty
                                            {
                                                self.region_0 = __UnloadingRegion0::Release;
                                                moves_38__ = true;
                                                self.bad = self.failed;
                                            }
                                        }
                                        __UnloadingRegion0::Release => {
                                            if !inputs_.indexed {
                                                self.region_0 = __UnloadingRegion0::Index;
                                                let next_failed_: bool = !self.failed;
                                                moves_38__ = true;
                                                self.failed = next_failed_;
                                            }
                                        }
                                        __UnloadingRegion0::Index => {
                                            if inputs_.indexed {
                                                self.region_0 = __UnloadingRegion0::Locked;
                                                moves_38__ = true;
                                            }
                                        }
                                        _ => {}
                                    }
                                }
                            }
                        }
                    }
                }
            }
            if !moves_38__ {
                break;
            }
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.region_0 {
            __UnloadingRegion0::Locked => {
                outputs_.pin = true;
            }
            __UnloadingRegion0::Index => {
                outputs_.turn = true;
            }
            _ => {}
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.region_3 {
            __UnloadingRegion3::Test => {
                outputs_.test = true;
            }
            __UnloadingRegion3::Scrap => {
                outputs_.bin = true;
            }
            _ => {}
        }
        outputs_
    }
}
