// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

impl Cell {
    /// One cycle: evaluates the transition conditions on `inputs`, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        inputs: &CellInputs,
        now: impl core::convert::Into<Ticks>,
    ) -> CellOutputs {
        let now: Ticks = core::convert::Into::into(
            now,
        );
        let mut outputs = CellOutputs {
            alarm: false,
            valve: false,
            mixer: false,
            batches: 0,
        };
        let first: bool = self.region_0 == __CellRegion0::INIT;
        if first {
            self.region_0 = __CellRegion0::Idle;
        }
        let edge0_now: bool = inputs.ack;
        if first {
            self.edge0_before = edge0_now;
        }
        let inputs = core::hint::black_box(inputs);
        loop {
            let mut moves_39_: bool = false;
            match self.region_0 {
                __CellRegion0::Stopped => {
                    if !inputs.estop && !self.edge0_before && edge0_now {
                        moves_39_ = true;
                        self.region_0 = __CellRegion0::Restart;
                    }
                }
                __CellRegion0::Restart => {
                    self.region_0 = __CellRegion0::Idle;
                    moves_39_ = true;
                }
                _ => {
                    if inputs.estop {
                        moves_39_ = true;
                        self.region_0 = __CellRegion0::Stopped;
                        self.region_3 = __CellRegion3::NONE;
                    } else {
                        match self.region_0 {
                            __CellRegion0::Idle => {
                                if inputs.start {
                                    moves_39_ = true;
                                    self.region_0 = __CellRegion0::Fill;
                                    self.region_3 = __CellRegion3::Mix;
                                    self.since_mix = now;
                                }
                            }
                            _ => {
                                if self.region_0 == __CellRegion0::Filled && !inputs.start {
                                    moves_39_ = true;
                                    self.region_0 = __CellRegion0::Idle;
                                    self.region_3 = __CellRegion3::NONE;
                                } else {
                                    match self.region_0 {
                                        __CellRegion0::Fill => {
                                            if inputs.full {
                                                self.region_0 = __CellRegion0::Settle;
                                                let next_batches: core::primitive::u16 = {
                                                    #[allow(unused_variables)]
                                                    let batches = self.batches;
                                                    batches.wrapping_add(1)
                                                };
                                                moves_39_ = true;
                                                self.batches = next_batches;
                                                self.since_fill = now;
                                            }
                                        }
                                        __CellRegion0::Settle => {
                                            if now.since(self.since_fill)
                                                >= Ticks::new(5000u32)
                                            {
                                                self.region_0 = __CellRegion0::Filled;
                                                moves_39_ = true;
                                            }
                                        }
                                        _ => {}
                                    }
                                    core::sync::atomic::compiler_fence(
                                        core::sync::atomic::Ordering::SeqCst,
                                    );
                                    match self.region_3 {
                                        __CellRegion3::Mix => {
                                            if now.since(self.since_mix)
                                                >= Ticks::new(10000u32)
                                            {
                                                self.region_3 = __CellRegion3::Rest;
                                                moves_39_ = true;
                                                self.since_mix = now;
                                            }
                                        }
                                        __CellRegion3::Rest => {
                                            if inputs.start
                                                && now.since(self.since_mix)
                                                    >= Ticks::new(2000u32)
                                            {
                                                self.region_3 = __CellRegion3::Mix;
                                                moves_39_ = true;
                                                self.since_mix = now;
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
            if !moves_39_ {
                break;
            }
            self.edge0_before = edge0_now;
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        self.edge0_before = edge0_now;
        match self.region_0 {
            __CellRegion0::Stopped => {
                outputs.alarm = true;
            }
            _ => {
                match self.region_0 {
                    __CellRegion0::Fill => {
                        outputs.valve = true;
                    }
                    _ => {}
                }
                core::sync::atomic::compiler_fence(
                    core::sync::atomic::Ordering::SeqCst,
                );
                match self.region_3 {
                    __CellRegion3::Mix => {
                        outputs.mixer = true;
                    }
                    __CellRegion3::Rest => {
                        self.passed_mix = now.since(self.since_mix)
                            >= Ticks::new(2000u32);
                        if now.since(self.since_mix)
                            >= Ticks::new(2000u32)
                        {
                            self.since_mix = now
                                .since(Ticks::new(2000u32));
                        }
                    }
                    _ => {}
                }
            }
        }
        outputs.batches = self.batches;
        outputs
    }
}
