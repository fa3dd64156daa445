// Recorded by `cargo xtask bless`: state and cycle of the program, without the facade's path.

pub struct Dyer {
    state: __DyerState,
    reading: Ticks,
    settled: bool,
    time: Ticks,
    edge0_before: bool,
    params: DyerParams,
}
impl Dyer {
    pub const fn new() -> Self {
        Self::with_params(DyerParams::new())
    }
    pub const fn with_params(params: DyerParams) -> Self {
        Self {
            state: __DyerState::INIT,
            reading: Ticks::ZERO,
            settled: false,
            time: Ticks::ZERO,
            edge0_before: false,
            params,
        }
    }
}
impl Dyer {
    pub fn cycle(
        &mut self,
        inputs: &DyerInputs,
        now: impl core::convert::Into<Ticks>,
        actions: &mut (impl DyerActions + ?core::marker::Sized),
    ) -> DyerOutputs {
        let now: Ticks = core::convert::Into::into(
            now,
        );
        let mut outputs = const {
            DyerOutputs {
                inlet: false,
                outlet: false,
                ready: false,
            }
        };
        let elapsed: Ticks = now.since(self.reading);
        self.reading = now;
        self.time = self.time + elapsed;
        match self.state {
            __DyerState::INIT => {
                self.time = Ticks::ZERO;
                self.state = __DyerState::Idle;
            }
            __DyerState::Idle => {
                if !self.edge0_before && inputs.start {
                    self.state = __DyerState::Fill;
                    self.time = Ticks::ZERO;
                    self.settled = false;
                } else {
                    self.settled = true;
                }
            }
            __DyerState::Fill => {
                if inputs.full {
                    self.state = __DyerState::Wash;
                    self.time = Ticks::ZERO;
                    actions
                        .heat(Phase::First, self.params.wash_at);
                    actions
                        .drum(Phase::First, self.params.wash_rpm);
                    self.settled = false;
                } else {
                    self.settled = true;
                }
            }
            __DyerState::Wash => {
                if ({
                    let temperature = inputs.temperature;
                    let wash_at = self.params.wash_at;
                    temperature >= wash_at
                }) && self.time >= self.params.wash
                {
                    self.state = __DyerState::Dye;
                    self.time = Ticks::ZERO;
                } else {
                    actions
                        .heat(
                            Phase::Repeated,
                            self.params.wash_at,
                        );
                    actions
                        .drum(
                            Phase::Repeated,
                            self.params.wash_rpm,
                        );
                }
            }
            __DyerState::Dye => {
                if ({
                    let temperature = inputs.temperature;
                    let dye_at = self.params.dye_at;
                    temperature >= dye_at
                }) && self.time >= self.params.dye
                {
                    self.state = __DyerState::Drain;
                    self.time = Ticks::ZERO;
                    actions.heat(Phase::Final, self.params.dye_at);
                }
            }
            __DyerState::Drain => {
                if inputs.empty {
                    self.state = __DyerState::Idle;
                    self.time = Ticks::ZERO;
                    actions
                        .drum(Phase::Final, self.params.wash_rpm);
                }
            }
        }
        match self.state {
            __DyerState::Idle => {
                outputs.ready = true;
            }
            __DyerState::Fill => {
                outputs.inlet = true;
            }
            __DyerState::Dye => {
                actions.heat(Phase::Repeated, self.params.dye_at);
                actions.drum(Phase::Repeated, self.params.dye_rpm);
            }
            __DyerState::Drain => {
                actions
                    .drum(Phase::Repeated, self.params.wash_rpm);
                outputs.outlet = true;
            }
            _ => {}
        }
        self.edge0_before = inputs.start;
        outputs
    }
    pub fn next_deadline(
        &self,
    ) -> Option<Ticks> {
        if !self.settled {
            return Option::Some(self.reading);
        }
        let mut soonest = Option::None;
        if self.state == __DyerState::Wash && self.time < self.params.wash {
            soonest = sooner(
                soonest,
                Option::Some(self.params.wash - self.time),
            );
        }
        if self.state == __DyerState::Dye && self.time < self.params.dye {
            soonest = sooner(
                soonest,
                Option::Some(self.params.dye - self.time),
            );
        }
        match soonest {
            Option::Some(time) => {
                Option::Some(self.reading.after(time))
            }
            Option::None => Option::None,
        }
    }
}
