// Recorded by `cargo xtask bless`: state and cycle of the program, without the facade's path.

pub struct Dyer {
    situation: __DyerState,
    reading: Ticks,
    time: Ticks,
    edge0_before: bool,
    before_state: __DyerState,
    params: DyerParams,
}
impl Dyer {
    pub const fn new() -> Self {
        Self::with_params(DyerParams::new())
    }
    pub const fn with_params(
        #[cfg(not(doc))]
        params_: DyerParams,
        #[cfg(doc)]
        params: DyerParams,
    ) -> Self {
        #[cfg(doc)]
        let params_ = params;
        Self {
            situation: __DyerState::INIT,
            reading: Ticks::ZERO,
            time: Ticks::ZERO,
            edge0_before: true,
            before_state: __DyerState::Idle,
            params: params_,
        }
    }
}
impl Dyer {
    pub fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &DyerInputs,
        #[cfg(doc)]
        inputs: &DyerInputs,
        #[cfg(not(doc))]
        now_: impl core::convert::Into<
            Ticks,
        >,
        #[cfg(doc)]
        now: impl core::convert::Into<Ticks>,
        #[cfg(not(doc))]
        actions_: &mut (impl DyerActions + ?core::marker::Sized),
        #[cfg(doc)]
        actions: &mut (impl DyerActions + ?core::marker::Sized),
    ) -> DyerOutputs {
        let now_: Ticks = core::convert::Into::into(
            now_,
        );
        let mut outputs_ = const {
            DyerOutputs {
                inlet: false,
                outlet: false,
                ready: false,
            }
        };
        self.before_state = self.situation;
        let elapsed_: Ticks = now_.since(self.reading);
        self.reading = now_;
        self.time = self.time + elapsed_;
        match self.situation {
            __DyerState::INIT => {
                self.time = Ticks::ZERO;
                self.situation = __DyerState::Idle;
            }
            __DyerState::Idle => {
                if !self.edge0_before && inputs_.start {
                    self.situation = __DyerState::Fill;
                    self.time = Ticks::ZERO;
                }
            }
            __DyerState::Fill => {
                if inputs_.full {
                    self.situation = __DyerState::Wash;
                    self.time = Ticks::ZERO;
                    actions_
                        .heat(
                            Phase::First,
                            {
                                let wash_at = self.params.wash_at;
                                wash_at
                            },
                        );
                    actions_
                        .drum(
                            Phase::First,
                            {
                                let wash_rpm = self.params.wash_rpm;
                                wash_rpm
                            },
                        );
                }
            }
            __DyerState::Wash => {
                if ({
                    let temperature = inputs_.temperature;
                    let wash_at = self.params.wash_at;
                    temperature >= wash_at
                }) && self.time >= self.params.wash
                {
                    self.situation = __DyerState::Dye;
                    self.time = Ticks::ZERO;
                } else {
                    actions_
                        .heat(
                            Phase::Repeated,
                            {
                                let wash_at = self.params.wash_at;
                                wash_at
                            },
                        );
                    actions_
                        .drum(
                            Phase::Repeated,
                            {
                                let wash_rpm = self.params.wash_rpm;
                                wash_rpm
                            },
                        );
                    self.before_state = __DyerState::Idle;
                }
            }
            __DyerState::Dye => {
                if ({
                    let temperature = inputs_.temperature;
                    let dye_at = self.params.dye_at;
                    temperature >= dye_at
                }) && self.time >= self.params.dye
                {
                    self.situation = __DyerState::Drain;
                    self.time = Ticks::ZERO;
                    actions_
                        .heat(
                            Phase::Final,
                            {
                                let dye_at = self.params.dye_at;
                                dye_at
                            },
                        );
                } else {
                    self.before_state = __DyerState::Idle;
                }
            }
            __DyerState::Drain => {
                if inputs_.empty {
                    self.situation = __DyerState::Idle;
                    self.time = Ticks::ZERO;
                    actions_
                        .drum(
                            Phase::Final,
                            {
                                let wash_rpm = self.params.wash_rpm;
                                wash_rpm
                            },
                        );
                } else {
                    self.before_state = __DyerState::Idle;
                }
            }
        }
        match self.situation {
            __DyerState::Idle => {
                outputs_.ready = true;
            }
            __DyerState::Fill => {
                outputs_.inlet = true;
            }
            __DyerState::Dye => {
                actions_
                    .heat(
                        Phase::Repeated,
                        {
                            let dye_at = self.params.dye_at;
                            dye_at
                        },
                    );
                actions_
                    .drum(
                        Phase::Repeated,
                        {
                            let dye_rpm = self.params.dye_rpm;
                            dye_rpm
                        },
                    );
            }
            __DyerState::Drain => {
                actions_
                    .drum(
                        Phase::Repeated,
                        {
                            let wash_rpm = self.params.wash_rpm;
                            wash_rpm
                        },
                    );
                outputs_.outlet = true;
            }
            _ => {}
        }
        self.edge0_before = inputs_.start;
        outputs_
    }
    pub fn next_deadline(
        &self,
    ) -> Option<Ticks> {
        if self.before_state != self.situation {
            return Option::Some(self.reading);
        }
        let mut soonest_ = Option::None;
        if self.situation == __DyerState::Wash && self.time < self.params.wash {
            soonest_ = sooner(
                soonest_,
                Option::Some(self.params.wash - self.time),
            );
        }
        if self.situation == __DyerState::Dye && self.time < self.params.dye {
            soonest_ = sooner(
                soonest_,
                Option::Some(self.params.dye - self.time),
            );
        }
        match soonest_ {
            Option::Some(time_) => {
                Option::Some(self.reading.after(time_))
            }
            Option::None => Option::None,
        }
    }
}
