//! The signals of the charts: their names, and where a chart is written by hand, their types, laid out as in C.

/// Hands all charts with their inputs and outputs to a macro. Inputs that are one bit of a word come first; another one
/// says how the bits above become its value. Outputs that are not boolean stand after the others, with their type.
/// The records in C have the same fields in this order; a name that is a word of C has an underscore there (`auto_`).
macro_rules! with_signals {
    ($to:ident) => {
        $to! {
            motor (sfc grafcet) {
                on, off, over_temp => relay, green, red
            }
            line24v (sfc grafcet) {
                b1, b2, b3, b4, b5 => q1, q2, q3
            }
            seq4 (sfc grafcet) {
                x0, x1, x2, x3 => q0, q1, q2, q3
            }
            seq16 (sfc grafcet) {
                x0, x1, x2, x3, x4, x5, x6, x7, x8, x9, x10, x11, x12, x13, x14, x15
                    => q0, q1, q2, q3, q4, q5, q6, q7, q8, q9, q10, q11, q12, q13, q14, q15
            }
            seq64 (sfc grafcet) {
                x0, x1, x2, x3, x4, x5, x6, x7, x8, x9, x10, x11, x12, x13, x14, x15
                    => q0, q1, q2, q3, q4, q5, q6, q7, q8, q9, q10, q11, q12, q13, q14, q15
            }
            seq64_size (sfc grafcet) {
                x0, x1, x2, x3, x4, x5, x6, x7, x8, x9, x10, x11, x12, x13, x14, x15
                    => q0, q1, q2, q3, q4, q5, q6, q7, q8, q9, q10, q11, q12, q13, q14, q15
            }
            chain10 (sfc grafcet) {
                x0, x1, x2, x3, x4, x5, x6, x7, x8, x9
                    => q0, q1, q2, q3, q4, q5, q6, q7, q8, q9
            }
            chain100 (sfc grafcet) {
                x0, x1, x2, x3, x4, x5, x6, x7, x8, x9, x10, x11, x12, x13, x14, x15
                    => q0, q1, q2, q3, q4, q5, q6, q7, q8, q9, q10, q11, q12, q13, q14, q15
            }
            chain100_size (sfc grafcet) {
                x0, x1, x2, x3, x4, x5, x6, x7, x8, x9, x10, x11, x12, x13, x14, x15
                    => q0, q1, q2, q3, q4, q5, q6, q7, q8, q9, q10, q11, q12, q13, q14, q15
            }
            chain100_flags (sfc grafcet) {
                x0, x1, x2, x3, x4, x5, x6, x7, x8, x9, x10, x11, x12, x13, x14, x15
                    => q0, q1, q2, q3, q4, q5, q6, q7, q8, q9, q10, q11, q12, q13, q14, q15
            }
            chain1000 (sfc grafcet) {
                x0, x1, x2, x3, x4, x5, x6, x7, x8, x9, x10, x11, x12, x13, x14, x15
                    => q0, q1, q2, q3, q4, q5, q6, q7, q8, q9, q10, q11, q12, q13, q14, q15
            }
            chain5000 (sfc grafcet) {
                x0, x1, x2, x3, x4, x5, x6, x7, x8, x9, x10, x11, x12, x13, x14, x15
                    => q0, q1, q2, q3, q4, q5, q6, q7, q8, q9, q10, q11, q12, q13, q14, q15
            }
            par8 (sfc grafcet) {
                x0, x1, x2, x3, x4, x5, x6, x7, x8, x9, x10, x11, x12, x13, x14, x15
                    => q0, q1, q2, q3, q4, q5, q6, q7, q8, q9, q10, q11, q12, q13, q14, q15
            }
            par16 (sfc grafcet) {
                x0, x1, x2, x3, x4, x5, x6, x7, x8, x9, x10, x11, x12, x13, x14, x15
                    => q0, q1, q2, q3, q4, q5, q6, q7, q8, q9, q10, q11, q12, q13, q14, q15
            }
            selection (sfc grafcet) {
                start, done { recipe: u8 = |bits| 1 + (bits % 8) as u8 }
                    => ready, pump, v1, v2, v3, v4, v5, v6, v7, v8
            }
            washer (sfc grafcet) {
                start, full, hot, washed, empty, again, spun
                    => ready, locked, valve, heater, drum, pump, spin
            }
            crossing (sfc grafcet) {
                request => red, yellow, green, walk, wait
            }
            mixed (sfc grafcet) {
                start, part, clamped, hot, filled, weighed, good, capped, printed, stuck, gone
                    => ready, busy, belt, heater, valve, pump, stirrer, eject, alarm, capper, press, printer, labeler
            }
            cell (grafcet) {
                ack, auto, part, clamped, drilled, stamped { estop: bool = |bits| bits % 64 == 1 }
                    => conveyor, clamp, drill, stamp, alarm { parts: u16 }
            }
            laundry (sfc grafcet) {
                start, door, full, hot, empty, balanced
                    => ready, locked, valve, heater, left, right, pump, slow, fast, alarm
            }
            plating (sfc grafcet) {
                start, there, low, high, good, home { recipe: u8 = |bits| 1 + (bits % 3) as u8 }
                    => ready, grip, forward, backward, lower, lift, heat, water, current, air, reject { parts: u16 }
            }
            plating_size (sfc grafcet) {
                start, there, low, high, good, home { recipe: u8 = |bits| 1 + (bits % 3) as u8 }
                    => ready, grip, forward, backward, lower, lift, heat, water, current, air, reject { parts: u16 }
            }
            reactor (sfc grafcet) {
                start, good {
                    level: u16 = |bits: u32| (bits & 1023) as u16,
                    pressure: u16 = |bits: u32| (bits >> 7 & 1023) as u16,
                    temperature: i16 = |bits: u32| (bits >> 13 & 1023) as i16
                }
                    => ready, inlet_a, inlet_b, stirrer, dose, cooler, vent, drain, sampled { power: u16 }
            }
            packer (grafcet) {
                ack, auto, carton, erected, bottle, closed, out, jog {
                    estop: bool = |bits| bits % 64 == 1,
                    jam: bool = |bits: u32| (bits >> 6).is_multiple_of(16)
                }
                    => alarm, manual, erect, gate, push, close, tape, eject, belt, jammed, lamp { cartons: u16 }
            }
            picker (sfc grafcet) {
                start, part, left, right, up, down, vacuum, ack
                    => ready, go_left, go_right, lower, suck, blow, alarm { code: u8 }
            }
            picker_size (sfc grafcet) {
                start, part, left, right, up, down, vacuum, ack
                    => ready, go_left, go_right, lower, suck, blow, alarm { code: u8 }
            }
        }
    };
}

/// Makes inputs of a word and numbers of the outputs of one chart.
macro_rules! words {
    ($signals:path, { $($input:ident),* $({ $($extra:ident: $type:ty = $value:expr),* })?
        => $($output:ident),* $({ $number:ident: $of:ty })? }) => {
        const _: () = {
            use $signals::{ChartInputs, ChartOutputs};

            impl crate::Inputs for ChartInputs {
                fn from_word(mut bits: u32) -> Self {
                    $(let $input = crate::next_bit(&mut bits);)*
                    Self { $($input,)* $($($extra: ($value)(bits),)*)? }
                }
            }

            impl crate::Outputs for ChartOutputs {
                fn each(&self, see: &mut impl FnMut(u32)) {
                    $(see(self.$output.into());)*
                    $(see(self.$number.into());)?
                }
            }
        };
    };
}

#[cfg(feature = "generated")]
macro_rules! generated {
    ($($chart:ident ($($dialect:ident)*) $signals:tt)*) => {
        $(generated!(@chart $chart ($($dialect)*) $signals);)*
    };
    (@chart chain5000 $dialects:tt $signals:tt) => {
        #[cfg(all(feature = "long", any(every_chart, chain5000)))]
        words!(crate::implementation::chain5000::sfc, $signals);
        #[cfg(all(feature = "long", any(every_chart, chain5000)))]
        words!(crate::implementation::chain5000::grafcet, $signals);
    };
    (@chart $chart:ident (grafcet) $signals:tt) => {
        #[cfg(any(every_chart, $chart))]
        words!(crate::implementation::$chart::grafcet, $signals);
    };
    (@chart $chart:ident (sfc grafcet) $signals:tt) => {
        #[cfg(any(every_chart, $chart))]
        words!(crate::implementation::$chart::sfc, $signals);
        #[cfg(any(every_chart, $chart))]
        words!(crate::implementation::$chart::grafcet, $signals);
    };
}
#[cfg(feature = "generated")]
with_signals!(generated);

#[cfg(not(feature = "generated"))]
macro_rules! by_hand {
    ($($chart:ident $dialects:tt $signals:tt)*) => {
        $(
            // Not every author wrote every chart.
            #[allow(dead_code)]
            pub mod $chart {
                by_hand!(@types $signals);
            }
            words!(crate::signals::$chart, $signals);
        )*
    };
    (@types { $($input:ident),* $({ $($extra:ident: $type:ty = $value:expr),* })?
        => $($output:ident),* $({ $number:ident: $of:ty })? }) => {
        #[derive(Clone, Copy)]
        #[repr(C)]
        pub struct ChartInputs {
            $(pub $input: bool,)*
            $($(pub $extra: $type,)*)?
        }

        #[derive(Clone, Copy, Default)]
        #[repr(C)]
        pub struct ChartOutputs {
            $(pub $output: bool,)*
            $(pub $number: $of,)?
        }
    };
}
#[cfg(not(feature = "generated"))]
with_signals!(by_hand);
