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
    pub const fn with_params(
        #[cfg(not(doc))]
        params_: DyerParams,
        #[cfg(doc)]
        params: DyerParams,
    ) -> Self {
        #[cfg(doc)]
        let params_ = params;
        Self {
            first: true,
            situation: __DyerState::Idle,
            inlet: false,
            outlet: false,
            ready: false,
            reading: Ticks::ZERO,
            settled: false,
            time: Ticks::ZERO,
            edge0_before: true,
            was_q_heat: false,
            acted_heat: 0,
            was_q_drum: false,
            acted_drum: 0,
            held_wash_2_: false,
            held_dye_4_: false,
            held_wash_3_: false,
            held_dye_5_: false,
            held_drain_7_: false,
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
        let elapsed_: Ticks = if self.first {
            Ticks::ZERO
        } else {
            now_.since(self.reading)
        };
        self.reading = now_;
        self.time = self.time + elapsed_;
        let was_state_: __DyerState = self.situation;
        let edge0_now_: bool = inputs_.start;
        let mut clears_idle_fill_: bool = false;
        let mut clears_fill_wash_: bool = false;
        let mut clears_wash_dye_: bool = false;
        let mut clears_dye_drain_: bool = false;
        let mut clears_drain_idle_: bool = false;
        let entered_idle_: bool;
        let mut entered_fill_: bool = false;
        let mut entered_wash_: bool = false;
        let mut entered_dye_: bool = false;
        let mut entered_drain_: bool = false;
        if self.first {
            entered_idle_ = true;
        } else {
            clears_idle_fill_ = was_state_ == __DyerState::Idle
                && ({
                    let rising_0_ = !self.edge0_before && edge0_now_;
                    rising_0_
                });
            clears_fill_wash_ = was_state_ == __DyerState::Fill && inputs_.full;
            clears_wash_dye_ = was_state_ == __DyerState::Wash
                && ({
                    let temperature = inputs_.temperature;
                    let wash_at = self.params.wash_at;
                    let elapsed_param_1_2_ = was_state_ == __DyerState::Wash
                        && self.time >= self.params.wash;
                    temperature >= wash_at && elapsed_param_1_2_
                });
            clears_dye_drain_ = was_state_ == __DyerState::Dye
                && ({
                    let temperature = inputs_.temperature;
                    let dye_at = self.params.dye_at;
                    let elapsed_param_4_3_ = was_state_ == __DyerState::Dye
                        && self.time >= self.params.dye;
                    temperature >= dye_at && elapsed_param_4_3_
                });
            clears_drain_idle_ = was_state_ == __DyerState::Drain && inputs_.empty;
            let left_idle_: bool = clears_idle_fill_;
            let left_fill_: bool = clears_fill_wash_;
            let left_wash_: bool = clears_wash_dye_;
            let left_dye_: bool = clears_dye_drain_;
            let left_drain_: bool = clears_drain_idle_;
            entered_idle_ = clears_drain_idle_
                && !(was_state_ == __DyerState::Idle && !left_idle_);
            entered_fill_ = clears_idle_fill_
                && !(was_state_ == __DyerState::Fill && !left_fill_);
            entered_wash_ = clears_fill_wash_
                && !(was_state_ == __DyerState::Wash && !left_wash_);
            entered_dye_ = clears_wash_dye_
                && !(was_state_ == __DyerState::Dye && !left_dye_);
            entered_drain_ = clears_dye_drain_
                && !(was_state_ == __DyerState::Drain && !left_drain_);
            if left_idle_ {
                self.situation = __DyerState::NONE;
            }
            if left_fill_ {
                self.situation = __DyerState::NONE;
            }
            if left_wash_ {
                self.situation = __DyerState::NONE;
            }
            if left_dye_ {
                self.situation = __DyerState::NONE;
            }
            if left_drain_ {
                self.situation = __DyerState::NONE;
            }
            if entered_idle_ {
                self.situation = __DyerState::Idle;
            }
            if entered_fill_ {
                self.situation = __DyerState::Fill;
            }
            if entered_wash_ {
                self.situation = __DyerState::Wash;
            }
            if entered_dye_ {
                self.situation = __DyerState::Dye;
            }
            if entered_drain_ {
                self.situation = __DyerState::Drain;
            }
        }
        let reached_time_: Ticks = self.time;
        if entered_idle_ || entered_fill_ || entered_wash_ || entered_dye_
            || entered_drain_
        {
            self.time = Ticks::ZERO;
        }
        let on_idle_0__: bool = self.situation
            == __DyerState::Idle;
        let on_fill_1__: bool = self.situation
            == __DyerState::Fill;
        let on_wash_2__: bool = self.situation
            == __DyerState::Wash;
        let on_wash_3__: bool = self.situation
            == __DyerState::Wash;
        let on_dye_4__: bool = self.situation == __DyerState::Dye;
        let on_dye_5__: bool = self.situation == __DyerState::Dye;
        let on_drain_6__: bool = self.situation
            == __DyerState::Drain;
        let on_drain_7__: bool = self.situation
            == __DyerState::Drain;
        let q_ready_: bool = on_idle_0__;
        let q_inlet_: bool = on_fill_1__;
        let q_heat_: bool = on_wash_2__ || on_dye_4__;
        if q_heat_ {
            if on_wash_2__ {
                self.acted_heat = 2;
            }
            if on_dye_4__ {
                self.acted_heat = 4;
            }
        }
        let by_leaving_heat_: bool = self.was_q_heat && !q_heat_
            && (self.held_wash_2_ && self.situation != __DyerState::Wash
                && !(on_wash_2__ || on_dye_4__)
                || self.held_dye_4_ && self.situation != __DyerState::Dye
                    && !(on_wash_2__ || on_dye_4__));
        self.held_wash_2_ = q_heat_ && on_wash_2__;
        self.held_dye_4_ = q_heat_ && on_dye_4__;
        let q_drum_: bool = on_wash_3__ || on_dye_5__
            || on_drain_7__;
        if q_drum_ {
            if on_wash_3__ {
                self.acted_drum = 3;
            }
            if on_dye_5__ {
                self.acted_drum = 5;
            }
            if on_drain_7__ {
                self.acted_drum = 7;
            }
        }
        let by_leaving_drum_: bool = self.was_q_drum && !q_drum_
            && (self.held_wash_3_ && self.situation != __DyerState::Wash
                && !(on_wash_3__ || on_dye_5__ || on_drain_7__)
                || self.held_dye_5_ && self.situation != __DyerState::Dye
                    && !(on_wash_3__ || on_dye_5__ || on_drain_7__)
                || self.held_drain_7_ && self.situation != __DyerState::Drain
                    && !(on_wash_3__ || on_dye_5__ || on_drain_7__));
        self.held_wash_3_ = q_drum_ && on_wash_3__;
        self.held_dye_5_ = q_drum_ && on_dye_5__;
        self.held_drain_7_ = q_drum_ && on_drain_7__;
        let q_outlet_: bool = on_drain_6__;
        let mut opaque_ran_: bool = false;
        if by_leaving_heat_ {
            match self.acted_heat {
                2 => {
                    actions_
                        .heat(
                            Phase::Final,
                            {
                                let wash_at = self.params.wash_at;
                                wash_at
                            },
                        );
                    opaque_ran_ = true;
                }
                4 => {
                    actions_
                        .heat(
                            Phase::Final,
                            {
                                let dye_at = self.params.dye_at;
                                dye_at
                            },
                        );
                    opaque_ran_ = true;
                }
                _ => {}
            }
        }
        if by_leaving_drum_ {
            match self.acted_drum {
                3 => {
                    actions_
                        .drum(
                            Phase::Final,
                            {
                                let wash_rpm = self.params.wash_rpm;
                                wash_rpm
                            },
                        );
                    opaque_ran_ = true;
                }
                5 => {
                    actions_
                        .drum(
                            Phase::Final,
                            {
                                let dye_rpm = self.params.dye_rpm;
                                dye_rpm
                            },
                        );
                    opaque_ran_ = true;
                }
                7 => {
                    actions_
                        .drum(
                            Phase::Final,
                            {
                                let wash_rpm = self.params.wash_rpm;
                                wash_rpm
                            },
                        );
                    opaque_ran_ = true;
                }
                _ => {}
            }
        }
        self.ready = q_ready_;
        self.inlet = q_inlet_;
        if q_heat_ {
            match self.acted_heat {
                2 => {
                    actions_
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
                    opaque_ran_ = true;
                }
                4 => {
                    actions_
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
                    opaque_ran_ = true;
                }
                _ => {}
            }
        }
        if self.was_q_heat && !q_heat_ && !by_leaving_heat_ {
            match self.acted_heat {
                2 => {
                    actions_
                        .heat(
                            Phase::Final,
                            {
                                let wash_at = self.params.wash_at;
                                wash_at
                            },
                        );
                    opaque_ran_ = true;
                }
                4 => {
                    actions_
                        .heat(
                            Phase::Final,
                            {
                                let dye_at = self.params.dye_at;
                                dye_at
                            },
                        );
                    opaque_ran_ = true;
                }
                _ => {}
            }
        }
        if q_drum_ {
            match self.acted_drum {
                3 => {
                    actions_
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
                    opaque_ran_ = true;
                }
                5 => {
                    actions_
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
                    opaque_ran_ = true;
                }
                7 => {
                    actions_
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
                    opaque_ran_ = true;
                }
                _ => {}
            }
        }
        if self.was_q_drum && !q_drum_ && !by_leaving_drum_ {
            match self.acted_drum {
                3 => {
                    actions_
                        .drum(
                            Phase::Final,
                            {
                                let wash_rpm = self.params.wash_rpm;
                                wash_rpm
                            },
                        );
                    opaque_ran_ = true;
                }
                5 => {
                    actions_
                        .drum(
                            Phase::Final,
                            {
                                let dye_rpm = self.params.dye_rpm;
                                dye_rpm
                            },
                        );
                    opaque_ran_ = true;
                }
                7 => {
                    actions_
                        .drum(
                            Phase::Final,
                            {
                                let wash_rpm = self.params.wash_rpm;
                                wash_rpm
                            },
                        );
                    opaque_ran_ = true;
                }
                _ => {}
            }
        }
        self.outlet = q_outlet_;
        self.was_q_heat = q_heat_;
        self.was_q_drum = q_drum_;
        self.settled = !(self.first || clears_idle_fill_ || clears_fill_wash_
            || clears_wash_dye_ || clears_dye_drain_ || clears_drain_idle_
            || opaque_ran_);
        self.edge0_before = edge0_now_;
        self.first = false;
        outputs_.inlet = self.inlet;
        outputs_.outlet = self.outlet;
        outputs_.ready = self.ready;
        outputs_
    }
    pub fn next_deadline(
        &self,
    ) -> Option<Ticks> {
        if !self.settled {
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
