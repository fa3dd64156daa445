//! The charts as a user of the macro writes them.

mod plants;
mod sequences;
mod structured;

// Where only some charts are built, files can be empty.
#[allow(unused_imports)]
pub use {plants::*, sequences::*, structured::*};

#[cfg(not(feature = "through"))]
use ::grafcet::grafcet as chart;
// The same macro by way of a program and its passes.
#[cfg(feature = "through")]
use grafcet_conformance_printed::optimised as chart;

/// A chart in both dialects; one with time names the shape of its function. Of two names the second one is the chart with `optimize size;`.
macro_rules! both {
    ($chart:ident, $small:ident $(: $function:ident)? { $($body:tt)* }) => {
        both! { $chart $(: $function)? { $($body)* } }
        both! { $small $(: $function)? { optimize size; $($body)* } }
    };
    ($chart:ident { $($body:tt)* }) => {
        both! { $chart: Cycle { $($body)* } }
    };
    ($chart:ident: $function:ident { $($body:tt)* }) => {
        #[cfg(any(every_chart, $chart))]
        pub mod $chart {
            pub mod sfc {
                crate::implementation::chart! { pub sfc Chart { $($body)* } }
                pub const CYCLE: crate::$function<Chart, ChartInputs, ChartOutputs> = Chart::cycle;
            }
            pub mod grafcet {
                crate::implementation::chart! { pub grafcet Chart { $($body)* } }
                pub const CYCLE: crate::$function<Chart, ChartInputs, ChartOutputs> = Chart::cycle;
            }
        }
    };
}
use both;

include!(concat!(env!("OUT_DIR"), "/generated.rs"));

both! { motor {
    input on, off, over_temp: bool;
    output relay, green, red: bool;

    initial step Off { N red; }
    step On { N relay; N green; }

    Off -[on && !over_temp]-> On -[off || over_temp]-> Off;
} }

both! { line24v {
    input b1, b2, b3, b4, b5: bool;
    output q1, q2, q3: bool;

    initial step S1 { q1; }
    step S2 { S q2; }
    step S3 { q3 if b5; }
    step S4 { R q2; }

    S1 -[b1]-> S2 -[b2]-> S3 -[b3]-> S4 -[b4]-> S1;
} }

both! { selection {
    input start, done: bool;
    input recipe: u8;
    output ready, pump, v1, v2, v3, v4, v5, v6, v7, v8: bool;

    initial step Idle { ready; }
    step A1 { pump; v1; }
    step A2 { pump; v2; }
    step A3 { pump; v3; }
    step A4 { pump; v4; }
    step A5 { pump; v5; }
    step A6 { pump; v6; }
    step A7 { pump; v7; }
    step A8 { pump; v8; }

    Idle -[start && recipe == 1]-> A1 -[done]-> Idle;
    Idle -[start && recipe == 2]-> A2 -[done]-> Idle;
    Idle -[start && recipe == 3]-> A3 -[done]-> Idle;
    Idle -[start && recipe == 4]-> A4 -[done]-> Idle;
    Idle -[start && recipe == 5]-> A5 -[done]-> Idle;
    Idle -[start && recipe == 6]-> A6 -[done]-> Idle;
    Idle -[start && recipe == 7]-> A7 -[done]-> Idle;
    Idle -[start && recipe == 8]-> A8 -[done]-> Idle;
} }

both! { washer {
    input start, full, hot, washed, empty, again, spun: bool;
    output ready, locked, valve, heater, drum, pump, spin: bool;

    initial step Idle { ready; }
    step Fill { S locked; valve; }
    step Heat { heater; }
    step Wash { drum; heater if !hot; }
    step Drain { pump; }
    step Spin { pump; spin; }
    step Done { R locked; }

    Idle -[start]-> Fill -[full]-> Heat -[hot]-> Wash -[washed]-> Drain;
    Wash -[!washed && !full]-> Fill;
    Drain -[empty && again]-> Fill;
    Drain -[empty && !again]-> Spin -[spun]-> Done -[!start]-> Idle;
} }

both! { crossing: TimedCycle {
    input request: bool;
    output red, yellow, green, walk, wait: bool;

    initial step Green { green; }
    step Asked { green; S wait; }
    step Yellow { yellow; }
    step Clear { red; }
    step Walk { red; walk; R wait; }
    step RedYellow { red; yellow; }

    Green -[request && 10s/Green]-> Asked -[5s/Asked]-> Yellow -[3s/Yellow]-> Clear;
    Clear -[2s/Clear]-> Walk -[8s/Walk]-> RedYellow -[1s/RedYellow]-> Green;
} }
