// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __WashRegion0 {
    Idle,
    Left1,
    Left2,
}
struct __WashRegion0Mark(u8);
impl __WashRegion0Mark {
    const fn of(state_: __WashRegion0) -> Self {
        Self(state_ as u8)
    }
    const fn state(self) -> __WashRegion0 {
        let number_ = self.0 & 3u8;
        if number_ >= 2u8 {
            __WashRegion0::Left2
        } else {
            match number_ {
                0u8 => __WashRegion0::Idle,
                _ => __WashRegion0::Left1,
            }
        }
    }
    /// Another state, and the mark as it is.
    const fn with(self, state_: __WashRegion0) -> Self {
        Self(self.0 & 4u8 | state_ as u8)
    }
    const fn unmarked(self) -> Self {
        Self(self.0 & 3u8)
    }
    const fn marked(self) -> Self {
        Self(self.0 | 4u8)
    }
    const fn is_marked(self) -> bool {
        self.0 & 4u8 != 0
    }
}
enum __WashRegion1 {
    Right1,
    Right2,
    NONE,
}
enum __WashRegion2 {
    Top1,
    Top2,
    NONE,
}
enum __WashRegion3 {
    Back1,
    Back2,
    NONE,
}
impl Wash {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &WashInputs,
        #[cfg(doc)]
        inputs: &WashInputs,
    ) -> WashOutputs {
        let mut outputs_ = const {
            WashOutputs {
                water: false,
                brush: false,
                foam: false,
                lamp: false,
            }
        };
        let inputs_ = core::hint::black_box(inputs_);
        let mut evolutions_: u32 = 0;
        loop {
            let mut moves_25__: bool = false;
            match self.region_0.state() {
                __WashRegion0::Idle => {
                    if inputs_.start {
                        self.region_0 = self.region_0.with(__WashRegion0::Left1);
                        self.region_1 = __WashRegion1::Right1;
                        self.region_2 = __WashRegion2::Top1;
                        core::sync::atomic::compiler_fence(
                            core::sync::atomic::Ordering::SeqCst,
                        );
                        self.region_3 = __WashRegion3::Back1;
                        moves_25__ = true;
                    }
                }
                _ => {
                    if self.region_0.state() == __WashRegion0::Left2
                        && self.region_1 == __WashRegion1::Right2
                        && self.region_2 == __WashRegion2::Top2
                        && self.region_3 == __WashRegion3::Back2 && inputs_.off
                    {
                        moves_25__ = true;
                        self.region_1 = __WashRegion1::NONE;
                        self.region_2 = __WashRegion2::NONE;
                        self.region_3 = __WashRegion3::NONE;
                        core::sync::atomic::compiler_fence(
                            core::sync::atomic::Ordering::SeqCst,
                        );
                        self.region_0 = self.region_0.with(__WashRegion0::Idle);
                    } else {
                        match self.region_0.state() {
                            __WashRegion0::Left1 => {
                                if inputs_.a {
                                    self.region_0 = self.region_0.with(__WashRegion0::Left2);
                                    moves_25__ = true;
                                }
                            }
                            _ => {}
                        }
                        core::sync::atomic::compiler_fence(
                            core::sync::atomic::Ordering::SeqCst,
                        );
                        match self.region_1 {
                            __WashRegion1::Right1 => {
                                if inputs_.b {
                                    self.region_1 = __WashRegion1::Right2;
                                    moves_25__ = true;
                                }
                            }
                            _ => {}
                        }
                        core::sync::atomic::compiler_fence(
                            core::sync::atomic::Ordering::SeqCst,
                        );
                        match self.region_2 {
                            __WashRegion2::Top1 => {
                                if inputs_.c {
                                    self.region_2 = __WashRegion2::Top2;
                                    moves_25__ = true;
                                }
                            }
                            _ => {}
                        }
                        core::sync::atomic::compiler_fence(
                            core::sync::atomic::Ordering::SeqCst,
                        );
                        match self.region_3 {
                            __WashRegion3::Back1 => {
                                if inputs_.a && inputs_.c {
                                    self.region_3 = __WashRegion3::Back2;
                                    moves_25__ = true;
                                }
                            }
                            _ => {}
                        }
                    }
                }
            }
            if !moves_25__ {
                self.region_0 = self.region_0.unmarked();
                break;
            }
            evolutions_ = evolutions_.wrapping_add(1);
            if evolutions_ == 20 {
                self.region_0 = self.region_0.marked();
                break;
            }
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.region_0.state() {
            __WashRegion0::Idle => {}
            _ => {
                match self.region_0.state() {
                    __WashRegion0::Left1 => {
                        outputs_.water = true;
                        outputs_.brush = true;
                    }
                    __WashRegion0::Left2 => {
                        outputs_.foam = true;
                        outputs_.lamp = true;
                    }
                    _ => {}
                }
                core::sync::atomic::compiler_fence(
                    core::sync::atomic::Ordering::SeqCst,
                );
                match self.region_1 {
                    __WashRegion1::Right1 => {
                        outputs_.water = true;
                        outputs_.foam = true;
                    }
                    __WashRegion1::Right2 => {
                        outputs_.brush = true;
                    }
                    _ => {}
                }
                core::sync::atomic::compiler_fence(
                    core::sync::atomic::Ordering::SeqCst,
                );
                match self.region_3 {
                    __WashRegion3::Back1 => {
                        outputs_.lamp = true;
                    }
                    __WashRegion3::Back2 => {
                        outputs_.water = true;
                    }
                    _ => {}
                }
                core::sync::atomic::compiler_fence(
                    core::sync::atomic::Ordering::SeqCst,
                );
                match self.region_2 {
                    __WashRegion2::Top1 => {
                        outputs_.brush = true;
                        outputs_.lamp = true;
                    }
                    __WashRegion2::Top2 => {
                        outputs_.foam = true;
                    }
                    _ => {}
                }
            }
        }
        outputs_
    }
}
