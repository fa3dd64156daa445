// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __CellRegion0 {
    Stopped,
    Restart,
    Idle,
    Fill,
    Settle,
    Filled,
    INIT,
}
enum __CellRegion3 {
    Mix,
    Rest,
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
        let mut outputs_ = CellOutputs {
            alarm: false,
            valve: false,
            mixer: false,
            batches: 0,
        };
        let first_: bool = self.region_0 == __CellRegion0::INIT;
        if first_ {
            self.region_0 = __CellRegion0::Idle;
        }
        let inputs_ = core::hint::black_box(inputs_);
        loop {
            let mut moves_39__: bool = false;
            match self.region_0 {
                __CellRegion0::Stopped => {
                    if !inputs_.estop && !self.edge0_before && inputs_.ack {
                        moves_39__ = true;
                        self.region_0 = __CellRegion0::Restart;
                    }
                }
                __CellRegion0::Restart => {
                    self.region_0 = __CellRegion0::Idle;
                    moves_39__ = true;
                }
                _ => {
                    if inputs_.estop {
                        moves_39__ = true;
                        self.region_0 = __CellRegion0::Stopped;
                        self.region_3 = __CellRegion3::NONE;
                    } else {
                        match self.region_0 {
                            __CellRegion0::Idle => {
                                if inputs_.start {
                                    moves_39__ = true;
                                    self.region_0 = __CellRegion0::Fill;
                                    self.region_3 = __CellRegion3::Mix;
                                    self.since_mix = now_;
                                }
                            }
                            _ => {
                                if self.region_0 == __CellRegion0::Filled && !inputs_.start
                                {
                                    moves_39__ = true;
                                    self.region_0 = __CellRegion0::Idle;
                                    self.region_3 = __CellRegion3::NONE;
                                } else {
                                    match self.region_0 {
                                        __CellRegion0::Fill => {
                                            if inputs_.full {
                                                self.region_0 = __CellRegion0::Settle;
                                                let next_batches_: core::primitive::u16 = {
                                                    #[allow(unused_variables)]
                                                    let batches = self.batches;
                                                    batches.wrapping_add(1)
                                                };
                                                moves_39__ = true;
                                                self.batches = next_batches_;
                                                self.since_fill = now_;
                                            }
                                        }
                                        __CellRegion0::Settle => {
                                            if has_reached!(
                                                now_.since(self.since_fill),
                                                Ticks::new(5000u32)
                                            ) {
                                                self.region_0 = __CellRegion0::Filled;
                                                moves_39__ = true;
                                            }
                                        }
                                        _ => {}
                                    }
                                    core::sync::atomic::compiler_fence(
                                        core::sync::atomic::Ordering::SeqCst,
                                    );
                                    match self.region_3 {
                                        __CellRegion3::Mix => {
                                            if has_reached!(
                                                now_.since(self.since_mix),
                                                Ticks::new(10000u32)
                                            ) {
                                                self.region_3 = __CellRegion3::Rest;
                                                moves_39__ = true;
                                                self.since_mix = now_;
                                            }
                                        }
                                        __CellRegion3::Rest => {
                                            if inputs_.start
                                                && has_reached!(
                                                    now_.since(self.since_mix),
                                                    Ticks::new(2000u32)
                                                )
                                            {
                                                self.region_3 = __CellRegion3::Mix;
                                                moves_39__ = true;
                                                self.since_mix = now_;
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
            if !moves_39__ {
                break;
            }
            self.edge0_before = inputs_.ack;
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        self.edge0_before = inputs_.ack;
        match self.region_0 {
            __CellRegion0::Stopped => {
                outputs_.alarm = true;
            }
            _ => {
                match self.region_0 {
                    __CellRegion0::Fill => {
                        outputs_.valve = true;
                    }
                    _ => {}
                }
                core::sync::atomic::compiler_fence(
                    core::sync::atomic::Ordering::SeqCst,
                );
                match self.region_3 {
                    __CellRegion3::Mix => {
                        outputs_.mixer = true;
                    }
                    __CellRegion3::Rest => {
                        self.passed_mix = now_.since(self.since_mix)
                            >= Ticks::new(2000u32);
                        if has_reached!(
                            now_.since(self.since_mix),
                            Ticks::new(2000u32)
                        ) {
                            self.since_mix = now_
                                .since(Ticks::new(2000u32));
                        }
                    }
                    _ => {}
                }
            }
        }
        outputs_.batches = self.batches;
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
            return Option::Some(self.since_fill);
        }
        let mut soonest_ = Option::None;
        if self.region_0 == __CellRegion0::Settle {
            soonest_ = earlier(
                soonest_,
                self.since_fill.after(Ticks::new(5000u32)),
            );
        }
        if self.region_3 == __CellRegion3::Mix {
            soonest_ = earlier(
                soonest_,
                self.since_mix.after(Ticks::new(10000u32)),
            );
        }
        if self.region_3 == __CellRegion3::Rest && !self.passed_mix {
            soonest_ = earlier(
                soonest_,
                self.since_mix.after(Ticks::new(2000u32)),
            );
        }
        soonest_
    }
}
