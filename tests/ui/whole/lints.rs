//! What rustc's own lints say of generated code stands at the names that it is about, never at the whole chart.
#![warn(missing_docs, unreachable_pub, missing_debug_implementations, missing_copy_implementations)]
#![warn(unused, nonstandard_style, private_interfaces, private_bounds, deprecated, non_ascii_idents)]
#![deny(non_snake_case, dead_code)]

use grafcet::grafcet;

// Nobody uses it.
grafcet! {
    sfc Unused {
        input go: bool;
        output lamp: bool;
        param limit: u8 = 3;
        var count: u8 = 0;
        action report(value: u8);

        initial step Dark { N report(limit); }
        step Lit { N lamp; P1 count = count.wrapping_add(1); }

        Dark -[go]-> Lit -[!go && count < limit]-> Dark;
    }
}

// Names that are not written as Rust's are.
grafcet! {
    pub grafcet press_one {
        input Start, größe: bool;
        output Ram: bool;
        param T_max: time = 5s;
        var Count: u8 = 0;
        action heat_It(Setpoint: u8);

        initial step idle { P1 heat_It(Count); }
        step press_Down { Ram; P1 Count = 3; }

        idle -[go_down: Start && größe]-> press_Down -[T_max/press_Down]-> idle;
    }
}

#[derive(Clone, Copy, Default, PartialEq)]
struct Hidden;

/// Of no use any more.
#[deprecated]
#[derive(Clone, Copy, Default, PartialEq)]
pub struct Old;

// Types that are less public than the chart, or deprecated.
grafcet! {
    pub sfc Types {
        input hidden: Hidden;
        input old: Old;
        output shown: Hidden;
        param same: Hidden = Hidden;
        var kept: Hidden = Hidden;
        action report(value: Hidden);

        initial step One { shown = hidden; P1 kept = hidden; N report(kept); }
        step Two;

        One -[hidden == same]-> Two -[old == old]-> One;
    }
}

mod inside {
    use grafcet::grafcet;

    grafcet! {
        pub grafcet Far {
            input go, stop: bool;
            output lamp: bool;

            initial step Dark;
            step Left { lamp; }
            step Right;

            Dark -[go]-> (Left, Right);
            (Left, Right) -[stop]-> Dark;
        }
    }
}

fn main() {}
