// Recorded by `cargo xtask bless`: state and cycle of the program, without the facade's path.

pub struct Dyer {
    first: bool,
    situation: __DyerState,
    inlet: bool,
    outlet: bool,
    ready: bool,
    reading: Ticks,
    settled: bool,
    time: Ticks,
    edge0_before: bool,
    was_q_heat: bool,
    acted_heat: u8,
    was_q_drum: bool,
    acted_drum: u8,
    held_wash_2_: bool,
    held_dye_4_: bool,
    held_wash_3_: bool,
    held_dye_5_: bool,
    held_drain_7_: bool,
    params: DyerParams,
}
impl Dyer {
    pub const fn new() -> Self {
        Self::with_params(DyerParams::new())
    }
    pub const fn with_params(params: DyerParams) -> Self {
        Self {
            first: true,
            situation: __DyerState::Idle,
            inlet: false,
            outlet: false,
            ready: false,
            reading: Ticks::ZERO,
            settled: false,
            time: Ticks::ZERO,
            edge0_before: false,
            was_q_heat: false,
            acted_heat: 0,
            was_q_drum: false,
            acted_drum: 0,
            held_wash_2_: false,
            held_dye_4_: false,
            held_wash_3_: false,
            held_dye_5_: false,
            held_drain_7_: false,
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
        let elapsed: Ticks = if self.first {
            Ticks::ZERO
        } else {
            now.since(self.reading)
        };
        self.reading = now;
        self.time = self.time + elapsed;
        let was_state: __DyerState = self.situation;
        let edge0_now: bool = inputs.start;
        if self.first {
            self.edge0_before = edge0_now;
        }
        let mut clears_idle_fill: bool = false;
        let mut clears_fill_wash: bool = false;
        let mut clears_wash_dye: bool = false;
        let mut clears_dye_drain: bool = false;
        let mut clears_drain_idle: bool = false;
        let entered_idle: bool;
        let mut entered_fill: bool = false;
        let mut entered_wash: bool = false;
        let mut entered_dye: bool = false;
        let mut entered_drain: bool = false;
        if self.first {
            entered_idle = true;
        } else {
            clears_idle_fill = was_state == __DyerState::Idle
                && ({
                    let rising_0 = !self.edge0_before && edge0_now;
                    rising_0
                });
            clears_fill_wash = was_state == __DyerState::Fill && inputs.full;
            clears_wash_dye = was_state == __DyerState::Wash
                && ({
                    let temperature = inputs.temperature;
                    let wash_at = self.params.wash_at;
                    let elapsed_param_1_2 = was_state == __DyerState::Wash
                        && self.time >= self.params.wash;
                    temperature >= wash_at && elapsed_param_1_2
                });
            clears_dye_drain = was_state == __DyerState::Dye
                && ({
                    let temperature = inputs.temperature;
                    let dye_at = self.params.dye_at;
                    let elapsed_param_4_3 = was_state == __DyerState::Dye
                        && self.time >= self.params.dye;
                    temperature >= dye_at && elapsed_param_4_3
                });
            clears_drain_idle = was_state == __DyerState::Drain && inputs.empty;
            let left_idle: bool = clears_idle_fill;
            let left_fill: bool = clears_fill_wash;
            let left_wash: bool = clears_wash_dye;
            let left_dye: bool = clears_dye_drain;
            let left_drain: bool = clears_drain_idle;
            entered_idle = clears_drain_idle
                && !(was_state == __DyerState::Idle && !left_idle);
            entered_fill = clears_idle_fill
                && !(was_state == __DyerState::Fill && !left_fill);
            entered_wash = clears_fill_wash
                && !(was_state == __DyerState::Wash && !left_wash);
            entered_dye = clears_wash_dye
                && !(was_state == __DyerState::Dye && !left_dye);
            entered_drain = clears_dye_drain
                && !(was_state == __DyerState::Drain && !left_drain);
            if left_idle {
                self.situation = __DyerState::NONE;
            }
            if left_fill {
                self.situation = __DyerState::NONE;
            }
            if left_wash {
                self.situation = __DyerState::NONE;
            }
            if left_dye {
                self.situation = __DyerState::NONE;
            }
            if left_drain {
                self.situation = __DyerState::NONE;
            }
            if entered_idle {
                self.situation = __DyerState::Idle;
            }
            if entered_fill {
                self.situation = __DyerState::Fill;
            }
            if entered_wash {
                self.situation = __DyerState::Wash;
            }
            if entered_dye {
                self.situation = __DyerState::Dye;
            }
            if entered_drain {
                self.situation = __DyerState::Drain;
            }
        }
        let reached_time: Ticks = self.time;
        if entered_idle || entered_fill || entered_wash || entered_dye || entered_drain {
            self.time = Ticks::ZERO;
        }
        let on_idle_0_: bool = self.situation == __DyerState::Idle;
        let on_fill_1_: bool = self.situation == __DyerState::Fill;
        let on_wash_2_: bool = self.situation == __DyerState::Wash;
        let on_wash_3_: bool = self.situation == __DyerState::Wash;
        let on_dye_4_: bool = self.situation == __DyerState::Dye;
        let on_dye_5_: bool = self.situation == __DyerState::Dye;
        let on_drain_6_: bool = self.situation
            == __DyerState::Drain;
        let on_drain_7_: bool = self.situation
            == __DyerState::Drain;
        let q_ready: bool = on_idle_0_;
        let q_inlet: bool = on_fill_1_;
        let q_heat: bool = on_wash_2_ || on_dye_4_;
        if q_heat {
            if on_wash_2_ {
                self.acted_heat = 2;
            }
            if on_dye_4_ {
                self.acted_heat = 4;
            }
        }
        let by_leaving_heat: bool = self.was_q_heat && !q_heat
            && (self.held_wash_2_ && self.situation != __DyerState::Wash
                && !(on_wash_2_ || on_dye_4_)
                || self.held_dye_4_ && self.situation != __DyerState::Dye
                    && !(on_wash_2_ || on_dye_4_));
        self.held_wash_2_ = q_heat && on_wash_2_;
        self.held_dye_4_ = q_heat && on_dye_4_;
        let q_drum: bool = on_wash_3_ || on_dye_5_ || on_drain_7_;
        if q_drum {
            if on_wash_3_ {
                self.acted_drum = 3;
            }
            if on_dye_5_ {
                self.acted_drum = 5;
            }
            if on_drain_7_ {
                self.acted_drum = 7;
            }
        }
        let by_leaving_drum: bool = self.was_q_drum && !q_drum
            && (self.held_wash_3_ && self.situation != __DyerState::Wash
                && !(on_wash_3_ || on_dye_5_ || on_drain_7_)
                || self.held_dye_5_ && self.situation != __DyerState::Dye
                    && !(on_wash_3_ || on_dye_5_ || on_drain_7_)
                || self.held_drain_7_ && self.situation != __DyerState::Drain
                    && !(on_wash_3_ || on_dye_5_ || on_drain_7_));
        self.held_wash_3_ = q_drum && on_wash_3_;
        self.held_dye_5_ = q_drum && on_dye_5_;
        self.held_drain_7_ = q_drum && on_drain_7_;
        let q_outlet: bool = on_drain_6_;
        let mut opaque_ran: bool = false;
        if by_leaving_heat {
            match self.acted_heat {
                2 => {
                    actions
                        .heat(
                            Phase::Final,
                            {
                                let wash_at = self.params.wash_at;
                                wash_at
                            },
                        );
                    opaque_ran = true;
                }
                4 => {
                    actions
                        .heat(
                            Phase::Final,
                            {
                                let dye_at = self.params.dye_at;
                                dye_at
                            },
                        );
                    opaque_ran = true;
                }
                _ => {}
            }
        }
        if by_leaving_drum {
            match self.acted_drum {
                3 => {
                    actions
                        .drum(
                            Phase::Final,
                            {
                                let wash_rpm = self.params.wash_rpm;
                                wash_rpm
                            },
                        );
                    opaque_ran = true;
                }
                5 => {
                    actions
                        .drum(
                            Phase::Final,
                            {
                                let dye_rpm = self.params.dye_rpm;
                                dye_rpm
                            },
                        );
                    opaque_ran = true;
                }
                7 => {
                    actions
                        .drum(
                            Phase::Final,
                            {
                                let wash_rpm = self.params.wash_rpm;
                                wash_rpm
                            },
                        );
                    opaque_ran = true;
                }
                _ => {}
            }
        }
        self.ready = q_ready;
        self.inlet = q_inlet;
        if q_heat {
            match self.acted_heat {
                2 => {
                    actions
                        .heat(
                            if self.was_q_heat {
                                Phase::Repeated
                            } else {
                                Phase::First
                            },
                            {
                                let wash_at = self.params.wash_at;
                                wash_at
                            },
                        );
                    opaque_ran = true;
                }
                4 => {
                    actions
                        .heat(
                            if self.was_q_heat {
                                Phase::Repeated
                            } else {
                                Phase::First
                            },
                            {
                                let dye_at = self.params.dye_at;
                                dye_at
                            },
                        );
                    opaque_ran = true;
                }
                _ => {}
            }
        }
        if self.was_q_heat && !q_heat && !by_leaving_heat {
            match self.acted_heat {
                2 => {
                    actions
                        .heat(
                            Phase::Final,
                            {
                                let wash_at = self.params.wash_at;
                                wash_at
                            },
                        );
                    opaque_ran = true;
                }
                4 => {
                    actions
                        .heat(
                            Phase::Final,
                            {
                                let dye_at = self.params.dye_at;
                                dye_at
                            },
                        );
                    opaque_ran = true;
                }
                _ => {}
            }
        }
        if q_drum {
            match self.acted_drum {
                3 => {
                    actions
                        .drum(
                            if self.was_q_drum {
                                Phase::Repeated
                            } else {
                                Phase::First
                            },
                            {
                                let wash_rpm = self.params.wash_rpm;
                                wash_rpm
                            },
                        );
                    opaque_ran = true;
                }
                5 => {
                    actions
                        .drum(
                            if self.was_q_drum {
                                Phase::Repeated
                            } else {
                                Phase::First
                            },
                            {
                                let dye_rpm = self.params.dye_rpm;
                                dye_rpm
                            },
                        );
                    opaque_ran = true;
                }
                7 => {
                    actions
                        .drum(
                            if self.was_q_drum {
                                Phase::Repeated
                            } else {
                                Phase::First
                            },
                            {
                                let wash_rpm = self.params.wash_rpm;
                                wash_rpm
                            },
                        );
                    opaque_ran = true;
                }
                _ => {}
            }
        }
        if self.was_q_drum && !q_drum && !by_leaving_drum {
            match self.acted_drum {
                3 => {
                    actions
                        .drum(
                            Phase::Final,
                            {
                                let wash_rpm = self.params.wash_rpm;
                                wash_rpm
                            },
                        );
                    opaque_ran = true;
                }
                5 => {
                    actions
                        .drum(
                            Phase::Final,
                            {
                                let dye_rpm = self.params.dye_rpm;
                                dye_rpm
                            },
                        );
                    opaque_ran = true;
                }
                7 => {
                    actions
                        .drum(
                            Phase::Final,
                            {
                                let wash_rpm = self.params.wash_rpm;
                                wash_rpm
                            },
                        );
                    opaque_ran = true;
                }
                _ => {}
            }
        }
        self.outlet = q_outlet;
        self.was_q_heat = q_heat;
        self.was_q_drum = q_drum;
        self.settled = !(self.first || clears_idle_fill || clears_fill_wash
            || clears_wash_dye || clears_dye_drain || clears_drain_idle || opaque_ran);
        self.edge0_before = edge0_now;
        self.first = false;
        outputs.inlet = self.inlet;
        outputs.outlet = self.outlet;
        outputs.ready = self.ready;
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
