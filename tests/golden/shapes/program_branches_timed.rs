// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

impl Kettle {
    /// One cycle: evaluates the transition conditions on `inputs`, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        inputs: &KettleInputs,
        now: impl core::convert::Into<Ticks>,
    ) -> KettleOutputs {
        let now: Ticks = core::convert::Into::into(
            now,
        );
        let mut outputs = const {
            KettleOutputs {
                heater: false,
                valve: false,
                stirrer: false,
                ready: false,
            }
        };
        self.before_state_idle = self.region_0;
        self.before_state_fill = self.region_1;
        let was_state_idle: __KettleRegion0 = self.region_0;
        match self.region_0 {
            __KettleRegion0::INIT => {
                self.region_0 = __KettleRegion0::Idle;
                self.since_fill = now;
            }
            __KettleRegion0::Idle => {
                if inputs.start {
                    self.region_0 = __KettleRegion0::Heat;
                    self.region_1 = __KettleRegion1::Fill;
                    self.since_fill = now;
                    outputs.valve = true;
                    outputs.ready = self.s_ff_ready;
                    outputs.heater = true;
                } else {
                    self.s_ff_ready = false;
                }
            }
            _ => {
                if self.region_0 == __KettleRegion0::Heated
                    && self.region_1 == __KettleRegion1::Stirred && !inputs.start
                {
                    self.s_ff_ready = false;
                    self.region_1 = __KettleRegion1::NONE;
                    self.region_0 = __KettleRegion0::Idle;
                } else {
                    match self.region_1 {
                        __KettleRegion1::Fill => {
                            if inputs.full
                                && now.since(self.since_fill)
                                    >= Ticks::new(1000u32)
                            {
                                self.region_1 = __KettleRegion1::Stir;
                                self.since_fill = now;
                            }
                        }
                        __KettleRegion1::Stir => {
                            if now.since(self.since_fill)
                                >= Ticks::new(3000u32)
                            {
                                self.region_1 = __KettleRegion1::Rest;
                                self.since_fill = now;
                            }
                        }
                        __KettleRegion1::Rest => {
                            if now.since(self.since_fill)
                                >= Ticks::new(2000u32)
                            {
                                self.region_1 = __KettleRegion1::Stirred;
                                self.since_fill = now;
                            }
                        }
                        _ => {}
                    }
                    let mut on_stirred_5_: bool = false;
                    match self.region_1 {
                        __KettleRegion1::Fill => {
                            outputs.valve = true;
                            if now.since(self.since_fill)
                                >= Ticks::new(1000u32)
                            {
                                self.since_fill = now
                                    .since(Ticks::new(1000u32));
                                self.before_state_fill = __KettleRegion1::Stir;
                            }
                        }
                        __KettleRegion1::Stir => {
                            outputs.stirrer = true;
                        }
                        __KettleRegion1::Stirred => {
                            on_stirred_5_ = true;
                        }
                        _ => {}
                    }
                    core::sync::atomic::compiler_fence(
                        core::sync::atomic::Ordering::SeqCst,
                    );
                    match self.region_0 {
                        __KettleRegion0::Heat => {
                            if inputs.hot {
                                self.region_0 = __KettleRegion0::Hold;
                                outputs.heater = false;
                            } else {
                                outputs.heater = true;
                            }
                        }
                        __KettleRegion0::Hold => {
                            if now.since(self.since_idle)
                                >= Ticks::new(5000u32)
                            {
                                self.region_0 = __KettleRegion0::Heated;
                            } else {
                                outputs.heater = !inputs.hot;
                            }
                        }
                        _ => {}
                    }
                    self.s_ff_ready = on_stirred_5_ || self.s_ff_ready;
                    outputs.ready = self.s_ff_ready;
                }
            }
        }
        if was_state_idle != self.region_0 {
            self.since_idle = now;
        }
        outputs
    }
}
