// Recorded by `cargo xtask bless`: state and cycle of the program, without the facade's path.

pub struct Dyer {
    situation: __DyerState,
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
            situation: __DyerState::INIT,
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
        match self.situation {
            __DyerState::INIT => {
                self.time = Ticks::ZERO;
                self.situation = __DyerState::Idle;
            }
            __DyerState::Idle => {
                if !self.edge0_before && inputs.start {
                    self.situation = __DyerState::Fill;
                    self.time = Ticks::ZERO;
                    self.settled = false;
                } else {
                    self.settled = true;
                }
            }
            __DyerState::Fill => {
                if inputs.full {
                    self.situation = __DyerState::Wash;
                    self.time = Ticks::ZERO;
                    actions
                        .heat(
                            Phase::First,
                            {
                                let wash_at = self.params.wash_at;
                                wash_at
                            },
                        );
                    actions
                        .drum(
                            Phase::First,
                            {
                                let wash_rpm = self.params.wash_rpm;
                                wash_rpm
                            },
                        );
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
                    self.situation = __DyerState::Dye;
                    self.time = Ticks::ZERO;
                } else {
                    actions
                        .heat(
                            Phase::Repeated,
                            {
                                let wash_at = self.params.wash_at;
                                wash_at
                            },
                        );
                    actions
                        .drum(
                            Phase::Repeated,
                            {
                                let wash_rpm = self.params.wash_rpm;
                                wash_rpm
                            },
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
                    self.situation = __DyerState::Drain;
                    self.time = Ticks::ZERO;
                    actions
                        .heat(
                            Phase::Final,
                            {
                                let dye_at = self.params.dye_at;
                                dye_at
                            },
                        );
                }
            }
            __DyerState::Drain => {
                if inputs.empty {
                    self.situation = __DyerState::Idle;
                    self.time = Ticks::ZERO;
                    actions
                        .drum(
                            Phase::Final,
                            {
                                let wash_rpm = self.params.wash_rpm;
                                wash_rpm
                            },
                        );
                }
            }
        }
        match self.situation {
            __DyerState::Idle => {
                outputs.ready = true;
            }
            __DyerState::Fill => {
                outputs.inlet = true;
            }
            __DyerState::Dye => {
                actions
                    .heat(
                        Phase::Repeated,
                        {
                            let dye_at = self.params.dye_at;
                            dye_at
                        },
                    );
                actions
                    .drum(
                        Phase::Repeated,
                        {
                            let dye_rpm = self.params.dye_rpm;
                            dye_rpm
                        },
                    );
            }
            __DyerState::Drain => {
                actions
                    .drum(
                        Phase::Repeated,
                        {
                            let wash_rpm = self.params.wash_rpm;
                            wash_rpm
                        },
                    );
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
        if self.situation == __DyerState::Wash && self.time < self.params.wash {
            soonest = sooner(
                soonest,
                Option::Some(self.params.wash - self.time),
            );
        }
        if self.situation == __DyerState::Dye && self.time < self.params.dye {
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
