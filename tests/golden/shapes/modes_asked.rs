// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __CellRegion0 {
    Off,
    Begin,
    Auto,
    Ending,
}
enum __CellRegion1 {
    Home,
    Idle,
    Enter,
    Grip,
    Drill,
    Release,
    Leave,
    NONE,
}
impl Cell {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &CellInputs,
        #[cfg(doc)]
        inputs: &CellInputs,
    ) -> CellOutputs {
        let mut outputs_ = const {
            CellOutputs {
                ready: false,
                enter: false,
                retract: false,
                grip: false,
                drill: false,
            }
        };
        let inputs_ = core::hint::black_box(inputs_);
        loop {
            let mut moves_30__: bool = false;
            let mut goes_31__: bool = false;
            match self.region_0 {
                __CellRegion0::Off => {
                    if inputs_.auto && !inputs_.stop {
                        self.region_0 = __CellRegion0::Begin;
                        moves_30__ = true;
                        self.region_1 = __CellRegion1::Home;
                    }
                }
                __CellRegion0::Begin => {
                    self.region_0 = __CellRegion0::Auto;
                    moves_30__ = true;
                }
                __CellRegion0::Auto => {
                    if inputs_.stop {
                        self.region_0 = __CellRegion0::Off;
                        moves_30__ = true;
                        self.region_1 = __CellRegion1::NONE;
                    } else {
                        if !inputs_.auto {
                            self.region_0 = __CellRegion0::Ending;
                            moves_30__ = true;
                            goes_31__ = true;
                        } else {
                            goes_31__ = true;
                        }
                    }
                }
                __CellRegion0::Ending => {
                    if inputs_.auto && !inputs_.stop
                        && self.region_1 != __CellRegion1::Idle
                    {
                        self.region_0 = __CellRegion0::Auto;
                        moves_30__ = true;
                        match self.region_1 {
                            __CellRegion1::Home => {
                                if inputs_.home {
                                    self.region_1 = __CellRegion1::Idle;
                                }
                            }
                            __CellRegion1::Enter => {
                                if inputs_.inside {
                                    self.region_1 = __CellRegion1::Grip;
                                    self.grip = true;
                                }
                            }
                            __CellRegion1::Grip => {
                                if inputs_.gripped {
                                    self.region_1 = __CellRegion1::Drill;
                                }
                            }
                            __CellRegion1::Drill => {
                                if inputs_.done {
                                    self.region_1 = __CellRegion1::Release;
                                    self.grip = false;
                                }
                            }
                            __CellRegion1::Release => {
                                if !inputs_.gripped {
                                    self.region_1 = __CellRegion1::Leave;
                                }
                            }
                            __CellRegion1::Leave => {
                                if inputs_.home {
                                    self.region_1 = __CellRegion1::Idle;
                                }
                            }
                            _ => {}
                        }
                    } else {
                        if inputs_.stop || self.region_1 == __CellRegion1::Idle {
                            self.region_0 = __CellRegion0::Off;
                            moves_30__ = true;
                            self.region_1 = __CellRegion1::NONE;
                        } else {
                            match self.region_1 {
                                __CellRegion1::Home => {
                                    if inputs_.home {
                                        self.region_1 = __CellRegion1::Idle;
                                        moves_30__ = true;
                                    }
                                }
                                __CellRegion1::Enter => {
                                    if inputs_.inside {
                                        self.region_1 = __CellRegion1::Grip;
                                        moves_30__ = true;
                                        self.grip = true;
                                    }
                                }
                                __CellRegion1::Grip => {
                                    if inputs_.gripped {
                                        self.region_1 = __CellRegion1::Drill;
                                        moves_30__ = true;
                                    }
                                }
                                __CellRegion1::Drill => {
                                    if inputs_.done {
                                        self.region_1 = __CellRegion1::Release;
                                        moves_30__ = true;
                                        self.grip = false;
                                    }
                                }
                                __CellRegion1::Release => {
                                    if !inputs_.gripped {
                                        self.region_1 = __CellRegion1::Leave;
                                        moves_30__ = true;
                                    }
                                }
                                __CellRegion1::Leave => {
                                    if inputs_.home {
                                        self.region_1 = __CellRegion1::Idle;
                                        moves_30__ = true;
                                    }
                                }
                                _ => {}
                            }
                        }
                    }
                }
            }
            if goes_31__ {
                match self.region_1 {
                    __CellRegion1::Home => {
                        if inputs_.home {
                            self.region_1 = __CellRegion1::Idle;
                            moves_30__ = true;
                        }
                    }
                    __CellRegion1::Idle => {
                        if inputs_.part {
                            self.region_1 = __CellRegion1::Enter;
                            moves_30__ = true;
                        }
                    }
                    __CellRegion1::Enter => {
                        if inputs_.inside {
                            self.region_1 = __CellRegion1::Grip;
                            moves_30__ = true;
                            self.grip = true;
                        }
                    }
                    __CellRegion1::Grip => {
                        if inputs_.gripped {
                            self.region_1 = __CellRegion1::Drill;
                            moves_30__ = true;
                        }
                    }
                    __CellRegion1::Drill => {
                        if inputs_.done {
                            self.region_1 = __CellRegion1::Release;
                            moves_30__ = true;
                            self.grip = false;
                        }
                    }
                    __CellRegion1::Release => {
                        if !inputs_.gripped {
                            self.region_1 = __CellRegion1::Leave;
                            moves_30__ = true;
                        }
                    }
                    __CellRegion1::Leave => {
                        if inputs_.home {
                            self.region_1 = __CellRegion1::Idle;
                            moves_30__ = true;
                        }
                    }
                    _ => {}
                }
            }
            if !moves_30__ {
                break;
            }
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.region_0 {
            __CellRegion0::Off => {
                outputs_.ready = true;
            }
            _ => {
                match self.region_1 {
                    __CellRegion1::Home | __CellRegion1::Leave => {
                        outputs_.retract = true;
                    }
                    __CellRegion1::Enter => {
                        outputs_.enter = true;
                    }
                    __CellRegion1::Drill => {
                        outputs_.drill = true;
                    }
                    _ => {}
                }
            }
        }
        outputs_.grip = self.grip;
        outputs_
    }
}
