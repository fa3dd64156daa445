// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __LoggingState {
    S0,
    S1,
    S2,
    S3,
    S4,
    S5,
    S6,
    S7,
    INIT,
}
impl Logging {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &LoggingInputs,
        #[cfg(doc)]
        inputs: &LoggingInputs,
        #[cfg(not(doc))]
        actions_: &mut (impl LoggingActions + ?core::marker::Sized),
        #[cfg(doc)]
        actions: &mut (impl LoggingActions + ?core::marker::Sized),
    ) -> LoggingOutputs {
        let mut outputs_ = LoggingOutputs { lamp: false };
        let mut on_s0_0__: bool = false;
        let mut on_s1_1__: bool = false;
        let mut on_s2_3__: bool = false;
        let mut on_s3_4__: bool = false;
        let mut on_s4_6__: bool = false;
        let mut on_s5_7__: bool = false;
        let mut on_s6_9__: bool = false;
        let mut on_s7_10__: bool = false;
        let mut any_54__: bool = false;
        match self.situation {
            __LoggingState::INIT => {
                self.situation = __LoggingState::S0;
                on_s0_0__ = inputs_.loud;
            }
            __LoggingState::S0 => {
                if inputs_.next {
                    self.situation = __LoggingState::S1;
                    on_s1_1__ = true;
                    any_54__ = self.held_s0_0_ && !on_s1_1__;
                    self.held_s0_0_ = false;
                } else {
                    on_s0_0__ = inputs_.loud;
                    if on_s0_0__ {
                        self.acted_log = 0;
                    }
                }
            }
            __LoggingState::S1 => {
                if inputs_.back {
                    self.situation = __LoggingState::S2;
                    on_s2_3__ = true;
                    any_54__ = self.held_s1_1_ && !on_s2_3__;
                    self.held_s1_1_ = false;
                } else {
                    on_s1_1__ = inputs_.next;
                }
            }
            __LoggingState::S2 => {
                if inputs_.next {
                    self.situation = __LoggingState::S3;
                    on_s3_4__ = inputs_.loud;
                    any_54__ = self.held_s2_3_ && !on_s3_4__;
                    self.held_s2_3_ = false;
                } else {
                    on_s2_3__ = inputs_.back;
                }
            }
            __LoggingState::S3 => {
                if inputs_.back {
                    self.situation = __LoggingState::S4;
                    on_s4_6__ = inputs_.next;
                    any_54__ = self.held_s3_4_ && !on_s4_6__;
                    self.held_s3_4_ = false;
                } else {
                    on_s3_4__ = inputs_.loud;
                }
            }
            __LoggingState::S4 => {
                if inputs_.next {
                    self.situation = __LoggingState::S5;
                    on_s5_7__ = inputs_.back;
                    any_54__ = self.held_s4_6_ && !on_s5_7__;
                    self.held_s4_6_ = false;
                } else {
                    on_s4_6__ = false;
                }
            }
            __LoggingState::S5 => {
                if inputs_.back {
                    self.situation = __LoggingState::S6;
                    on_s6_9__ = inputs_.loud;
                    any_54__ = self.held_s5_7_ && !on_s6_9__;
                    self.held_s5_7_ = false;
                } else {
                    on_s5_7__ = false;
                }
            }
            __LoggingState::S6 => {
                if inputs_.next {
                    self.situation = __LoggingState::S7;
                    on_s7_10__ = true;
                    any_54__ = self.held_s6_9_ && !on_s7_10__;
                    self.held_s6_9_ = false;
                } else {
                    on_s6_9__ = inputs_.loud;
                }
            }
            __LoggingState::S7 => {
                if inputs_.back {
                    self.situation = __LoggingState::S0;
                    on_s0_0__ = inputs_.loud;
                    if on_s0_0__ {
                        self.acted_log = 0;
                    }
                    any_54__ = self.held_s7_10_ && !on_s0_0__;
                    self.held_s7_10_ = false;
                } else {
                    on_s7_10__ = inputs_.next;
                }
            }
        }
        let mut q_log_: bool = false;
        match self.situation {
            __LoggingState::S0 => {
                q_log_ = on_s0_0__;
                self.held_s0_0_ = q_log_ && on_s0_0__;
            }
            __LoggingState::S1 => {
                q_log_ = on_s1_1__;
                if on_s1_1__ {
                    self.acted_log = 1;
                }
                self.held_s1_1_ = q_log_ && on_s1_1__;
                outputs_.lamp = true;
            }
            __LoggingState::S2 => {
                q_log_ = on_s2_3__;
                if on_s2_3__ {
                    self.acted_log = 3;
                }
                self.held_s2_3_ = q_log_ && on_s2_3__;
            }
            __LoggingState::S3 => {
                q_log_ = on_s3_4__;
                if on_s3_4__ {
                    self.acted_log = 4;
                }
                self.held_s3_4_ = q_log_ && on_s3_4__;
                outputs_.lamp = true;
            }
            __LoggingState::S4 => {
                q_log_ = on_s4_6__;
                if on_s4_6__ {
                    self.acted_log = 6;
                }
                self.held_s4_6_ = q_log_ && on_s4_6__;
            }
            __LoggingState::S5 => {
                q_log_ = on_s5_7__;
                if on_s5_7__ {
                    self.acted_log = 7;
                }
                self.held_s5_7_ = q_log_ && on_s5_7__;
                outputs_.lamp = true;
            }
            __LoggingState::S6 => {
                q_log_ = on_s6_9__;
                if on_s6_9__ {
                    self.acted_log = 9;
                }
                self.held_s6_9_ = q_log_ && on_s6_9__;
            }
            __LoggingState::S7 => {
                q_log_ = on_s7_10__;
                if on_s7_10__ {
                    self.acted_log = 10;
                }
                self.held_s7_10_ = q_log_ && on_s7_10__;
                outputs_.lamp = true;
            }
            _ => {}
        }
        let by_leaving_log_: bool = self.was_q_log && !q_log_
            && any_54__;
        if by_leaving_log_ {
            match self.acted_log {
                0 => {
                    actions_.log(Phase::Final, 1);
                }
                1 => {
                    actions_.log(Phase::Final, 2);
                }
                3 => {
                    actions_.log(Phase::Final, 3);
                }
                4 => {
                    actions_.log(Phase::Final, 4);
                }
                6 => {
                    actions_.log(Phase::Final, 5);
                }
                7 => {
                    actions_.log(Phase::Final, 6);
                }
                9 => {
                    actions_.log(Phase::Final, 7);
                }
                _ => {
                    actions_.log(Phase::Final, 8);
                }
            }
        }
        if q_log_ {
            match self.acted_log {
                0 => {
                    actions_
                        .log(
                            if self.was_q_log {
                                Phase::Repeated
                            } else {
                                Phase::First
                            },
                            1,
                        );
                }
                1 => {
                    actions_
                        .log(
                            if self.was_q_log {
                                Phase::Repeated
                            } else {
                                Phase::First
                            },
                            2,
                        );
                }
                3 => {
                    actions_
                        .log(
                            if self.was_q_log {
                                Phase::Repeated
                            } else {
                                Phase::First
                            },
                            3,
                        );
                }
                4 => {
                    actions_
                        .log(
                            if self.was_q_log {
                                Phase::Repeated
                            } else {
                                Phase::First
                            },
                            4,
                        );
                }
                6 => {
                    actions_
                        .log(
                            if self.was_q_log {
                                Phase::Repeated
                            } else {
                                Phase::First
                            },
                            5,
                        );
                }
                7 => {
                    actions_
                        .log(
                            if self.was_q_log {
                                Phase::Repeated
                            } else {
                                Phase::First
                            },
                            6,
                        );
                }
                9 => {
                    actions_
                        .log(
                            if self.was_q_log {
                                Phase::Repeated
                            } else {
                                Phase::First
                            },
                            7,
                        );
                }
                _ => {
                    actions_
                        .log(
                            if self.was_q_log {
                                Phase::Repeated
                            } else {
                                Phase::First
                            },
                            8,
                        );
                }
            }
        } else {
            if self.was_q_log && !by_leaving_log_ {
                match self.acted_log {
                    0 => {
                        actions_.log(Phase::Final, 1);
                    }
                    1 => {
                        actions_.log(Phase::Final, 2);
                    }
                    3 => {
                        actions_.log(Phase::Final, 3);
                    }
                    4 => {
                        actions_.log(Phase::Final, 4);
                    }
                    6 => {
                        actions_.log(Phase::Final, 5);
                    }
                    7 => {
                        actions_.log(Phase::Final, 6);
                    }
                    9 => {
                        actions_.log(Phase::Final, 7);
                    }
                    _ => {
                        actions_.log(Phase::Final, 8);
                    }
                }
            }
        }
        self.was_q_log = q_log_;
        outputs_
    }
}
