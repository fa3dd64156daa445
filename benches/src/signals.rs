//! The signals of the charts: their names, and where a chart is written by hand, their types, laid out as in C.

/// Hands all charts with their inputs and outputs to a macro. The boolean inputs come first, one bit of a word each; an
/// input of another type says how the bits above become its value.
macro_rules! with_signals {
    ($to:ident) => {
        $to! {
            motor: on, off, over_temp => relay, green, red;
            line24v: b1, b2, b3, b4, b5 => q1, q2, q3;
            seq4: x0, x1, x2, x3 => q0, q1, q2, q3;
            seq16: x0, x1, x2, x3, x4, x5, x6, x7, x8, x9, x10, x11, x12, x13, x14, x15
                => q0, q1, q2, q3, q4, q5, q6, q7, q8, q9, q10, q11, q12, q13, q14, q15;
            seq64: x0, x1, x2, x3, x4, x5, x6, x7, x8, x9, x10, x11, x12, x13, x14, x15
                => q0, q1, q2, q3, q4, q5, q6, q7, q8, q9, q10, q11, q12, q13, q14, q15;
            chain10: x0, x1, x2, x3, x4, x5, x6, x7, x8, x9
                => q0, q1, q2, q3, q4, q5, q6, q7, q8, q9;
            chain100: x0, x1, x2, x3, x4, x5, x6, x7, x8, x9, x10, x11, x12, x13, x14, x15
                => q0, q1, q2, q3, q4, q5, q6, q7, q8, q9, q10, q11, q12, q13, q14, q15;
            chain1000: x0, x1, x2, x3, x4, x5, x6, x7, x8, x9, x10, x11, x12, x13, x14, x15
                => q0, q1, q2, q3, q4, q5, q6, q7, q8, q9, q10, q11, q12, q13, q14, q15;
            par8: x0, x1, x2, x3, x4, x5, x6, x7, x8, x9, x10, x11, x12, x13, x14, x15
                => q0, q1, q2, q3, q4, q5, q6, q7, q8, q9, q10, q11, q12, q13, q14, q15;
            selection: start, done { recipe: u8 = |bits| 1 + (bits % 8) as u8 }
                => ready, pump, v1, v2, v3, v4, v5, v6, v7, v8;
            washer: start, full, hot, washed, empty, again, spun
                => ready, locked, valve, heater, drum, pump, spin;
        }
    };
}

/// Makes words of one chart's signals.
macro_rules! words {
    ($signals:path: $($input:ident),* $({ $extra:ident: $type:ty = $value:expr })? => $($output:ident),*) => {
        const _: () = {
            use $signals::{ChartInputs, ChartOutputs};

            impl crate::Inputs for ChartInputs {
                fn from_word(mut bits: u32) -> Self {
                    $(let $input = crate::next_bit(&mut bits);)*
                    Self { $($input,)* $($extra: ($value)(bits))? }
                }
            }

            impl crate::Outputs for ChartOutputs {
                fn to_word(&self) -> u32 {
                    [$(self.$output),*].into_iter().fold(0, |word, bit| word << 1 | u32::from(bit))
                }
            }
        };
    };
}

#[cfg(feature = "generated")]
macro_rules! generated {
    ($($chart:ident: $($input:ident),* $({ $($extra:tt)* })? => $($output:ident),*;)*) => {
        $(
            words!(crate::generated::$chart::sfc: $($input),* $({ $($extra)* })? => $($output),*);
            words!(crate::generated::$chart::grafcet: $($input),* $({ $($extra)* })? => $($output),*);
        )*
    };
}
#[cfg(feature = "generated")]
with_signals!(generated);

#[cfg(not(feature = "generated"))]
macro_rules! by_hand {
    ($($chart:ident: $($input:ident),* $({ $extra:ident: $type:ty = $value:expr })? => $($output:ident),*;)*) => {
        $(
            pub mod $chart {
                #[derive(Clone, Copy)]
                #[repr(C)]
                pub struct ChartInputs {
                    $(pub $input: bool,)*
                    $(pub $extra: $type,)?
                }

                #[derive(Clone, Copy, Default)]
                #[repr(C)]
                pub struct ChartOutputs {
                    $(pub $output: bool,)*
                }
            }
            words!(crate::signals::$chart: $($input),* $({ $extra: $type = $value })? => $($output),*);
        )*
    };
}
#[cfg(not(feature = "generated"))]
with_signals!(by_hand);
