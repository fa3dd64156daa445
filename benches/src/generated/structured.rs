//! The charts with structure: parallel sections with times, and the hierarchy of IEC 60848.

use super::both;

both! { mixed: TimedCycle {
    input start, part, clamped, hot, filled, weighed, good, capped, printed, stuck, gone: bool;
    output ready, busy, belt, heater, valve, pump, stirrer, eject, alarm, capper, press, printer, labeler: bool;

    initial step Idle { ready; R busy; }
    step Load { S busy; belt; }
    step Clamp { R alarm; }

    step Heat { heater; }
    step Hold { heater if !hot; }
    step Heated;
    step Open { S valve; }
    step Dose { pump; D 500ms stirrer; }
    step Settle { stirrer; }
    step Dosed { R valve; }

    step Weigh;
    step Reject { eject; S alarm; }

    step Cap { capper; }
    step Press { press; }
    step Capped;
    step Print { L 1s printer; }
    step Label { labeler; }
    step Labelled;

    step Unclamp;
    step Deliver { belt; }

    Idle -[start]-> Load -[part]-> Clamp -[clamped]-> (Heat, Open);
    Heat -[hot]-> Hold -[5s/Hold]-> Heated;
    Open -[1s/Open]-> Dose -[filled]-> Settle -[2s/Settle]-> Dosed;
    (Heated, Dosed) -[true]-> Weigh;
    Weigh -[weighed && !good]-> Reject -[gone || 10s/Reject]-> Idle;
    Weigh -[weighed && good]-> (Cap, Print);
    Cap -[capped]-> Press -[3s/Press]-> Capped;
    Print -[printed]-> Label -[!stuck]-> Labelled;
    (Capped, Labelled) -[true]-> Unclamp -[!clamped]-> Deliver -[gone]-> Idle;
} }

#[cfg(any(every_chart, cell))]
pub mod cell {
    pub mod grafcet {
        crate::implementation::chart! {
            pub grafcet Chart {
                input estop, ack, auto, part, clamped, drilled, stamped: bool;
                output conveyor, clamp, drill, stamp, alarm: bool;
                output parts: u16 = 0;

                partial Safety {
                    initial step Ready;
                    step Stopped { force Modes {}; alarm; }
                    step Restart { force Modes {INIT}; }

                    Ready -[estop]-> Stopped -[!estop && rising(ack)]-> Restart -[true]-> Ready;
                }

                partial Modes {
                    initial step Manual { R clamp; }
                    enclosing step Auto {
                        partial Production {
                            linked step Feed { conveyor; }
                            macro step Clamp {
                                entry step Close { S clamp; }
                                exit step Closed;
                                Close -[clamped]-> Closed;
                            }
                            step Drill { drill; }
                            step Drilled;
                            step Stamp { stamp; }
                            step Stamped;
                            step Release { R clamp; P1 parts = parts.wrapping_add(1); }
                            step Deliver { conveyor; }

                            Feed -[part]-> Clamp -[true]-> (Drill, Stamp);
                            Drill -[drilled]-> Drilled;
                            Stamp -[stamped]-> Stamped;
                            (Drilled, Stamped) -[true]-> Release -[!clamped]-> Deliver -[!part]-> Feed;
                        }
                    }

                    Manual -[rising(auto)]-> Auto -[!auto && Production::Feed.X && !part]-> Manual;
                }
            }
        }
        pub const CYCLE: crate::Cycle<Chart, ChartInputs, ChartOutputs> = Chart::cycle;
    }
}
