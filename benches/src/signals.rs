//! The inputs and outputs of the charts written by hand, laid out as in C.

macro_rules! signals {
    ($(#[$attribute:meta])* $chart:ident: $($input:ident),* $({ $extra:ident: $type:ty })? => $($output:ident),*) => {
        $(#[$attribute])*
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
    };
}

signals!(motor: on, off, over_temp => relay, green, red);
signals!(line24v: b1, b2, b3, b4, b5 => q1, q2, q3);
signals!(seq4: x0, x1, x2, x3 => q0, q1, q2, q3);
signals!(seq16: x0, x1, x2, x3, x4, x5, x6, x7, x8, x9, x10, x11, x12, x13, x14, x15
    => q0, q1, q2, q3, q4, q5, q6, q7, q8, q9, q10, q11, q12, q13, q14, q15);
signals!(selection: start, done { recipe: u8 } => ready, pump, v1, v2, v3, v4, v5, v6, v7, v8);
signals!(washer: start, full, hot, washed, empty, again, spun => ready, locked, valve, heater, drum, pump, spin);
pub use seq16 as seq64;
