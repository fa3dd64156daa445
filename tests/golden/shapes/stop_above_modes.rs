// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __CellRegion0 {
    Stopped,
    Restart,
    Manual,
    Wait,
    Close,
    Drill,
    Open,
    INIT,
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
        #[cfg(not(doc))]
        now_: impl core::convert::Into<
            Ticks,
        >,
        #[cfg(doc)]
        now: impl core::convert::Into<Ticks>,
    ) -> CellOutputs {
        let now_: Ticks = core::convert::Into::into(
            now_,
        );
        let mut outputs_ = const {
            CellOutputs {
                alarm: false,
                manual: false,
                feed: false,
                clamp: false,
                drill: false,
            }
        };
        let first_: bool = self.region_0 == __CellRegion0::INIT;
        if first_ {
            self.region_0 = __CellRegion0::Manual;
        }
        let inputs_ = core::hint::black_box(inputs_);
        loop {
            let mut moves_33__: bool = false;
            match self.region_0 {
                __CellRegion0::Stopped => {
                    if !inputs_.stop && inputs_.ack {
                        moves_33__ = true;
                        self.region_0 = __CellRegion0::Restart;
                        self.clamp = false;
                    }
                }
                __CellRegion0::Restart => {
                    self.region_0 = __CellRegion0::Manual;
                    moves_33__ = true;
                }
                _ => {
                    if inputs_.stop {
                        moves_33__ = true;
                        self.region_0 = __CellRegion0::Stopped;
                    } else {
                        match self.region_0 {
                            __CellRegion0::Manual => {
                                if inputs_.auto {
                                    moves_33__ = true;
                                    self.region_0 = __CellRegion0::Wait;
                                }
                            }
                            _ => {
                                fence_on_armv6m();
                                match self.region_0 {
                                    __CellRegion0::Wait => {
                                        if !inputs_.auto {
                                            self.clamp = false;
                                            moves_33__ = true;
                                            self.region_0 = __CellRegion0::Manual;
                                        } else {
                                            if inputs_.part {
                                                self.region_0 = __CellRegion0::Close;
                                                self.clamp = true;
                                                moves_33__ = true;
                                                self.since_wait = now_;
                                            }
                                        }
                                    }
                                    __CellRegion0::Close => {
                                        if has_reached!(
                                            now_.since(self.since_wait),
                                            Ticks::new(1000u32)
                                        ) {
                                            self.region_0 = __CellRegion0::Drill;
                                            moves_33__ = true;
                                        }
                                    }
                                    __CellRegion0::Drill => {
                                        if inputs_.down {
                                            self.region_0 = __CellRegion0::Open;
                                            self.clamp = false;
                                            moves_33__ = true;
                                        }
                                    }
                                    __CellRegion0::Open => {
                                        if !inputs_.part {
                                            self.region_0 = __CellRegion0::Wait;
                                            moves_33__ = true;
                                        }
                                    }
                                    _ => {}
                                }
                            }
                        }
                    }
                }
            }
            if !moves_33__ {
                break;
            }
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.region_0 {
            __CellRegion0::Stopped => {
                outputs_.alarm = true;
            }
            __CellRegion0::Restart | __CellRegion0::Manual => {
                outputs_.manual = true;
            }
            __CellRegion0::Wait => {
                outputs_.feed = true;
            }
            __CellRegion0::Drill => {
                outputs_.drill = true;
            }
            _ => {}
        }
        outputs_.clamp = self.clamp;
        outputs_
    }
    /// The reading of the clock before which nothing changes unless an input does (or the recipe): a controller
    /// that sleeps until then behaves like one that scans all the time. The reading of the last cycle means
    /// "scan again at once"; `None` means "only an input can change anything".
    #[must_use]
    fn next_deadline(
        &self,
    ) -> Option<Ticks> {
        if self.region_0 == __CellRegion0::INIT {
            return Option::Some(self.since_wait);
        }
        let mut soonest_ = Option::None;
        if self.region_0 == __CellRegion0::Close {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(1000u32),
                ),
            );
        }
        match soonest_ {
            Option::Some(time_) => {
                Option::Some(self.since_wait.after(time_))
            }
            Option::None => Option::None,
        }
    }
}
