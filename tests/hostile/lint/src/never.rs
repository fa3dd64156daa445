//! Charts that are still to be written: what stands after `todo!()` is never reached.
#![allow(clippy::todo, clippy::panic, clippy::unimplemented, clippy::unreachable, reason = "this is what it is about")]

use grafcet::{Phase, grafcet};

fn stop() -> ! {
    panic!("stop")
}

grafcet! {
    /// Conditions, values, arguments and blocks.
    pub sfc Sfc {
        forceable;
        input a: bool;
        input n: u8;
        output q, r, s, k: bool;
        output v, w: u8 = 0;
        var m, l: u8 = 0;
        action act(n: u8);
        let later = n > 3 && todo!();
        initial step A { q if todo!() && l > 3; S k if unimplemented!("later"); }
        step B { P1 m = todo!(); N act(unreachable!()); v = stop(); R k; }
        step C { P1 { m = 3; todo!() } P0 { m = stop(); } N act(m); s if a || panic!("no"); w = m.max(todo!()); }
        step F { D 2s r if todo!(); D 1s l = todo!(); }
        A -[todo!()]-> B -[a && stop()]-> C -[later]-> A;
        B -[3s/stop() && !a]-> A;
        C -[if n > 3 { todo!() } else { false }]-> F -[loop { core::hint::spin_loop(); }]-> A;
    }
}

grafcet! {
    /// The same as a `grafcet`.
    pub grafcet Grafcet {
        #![allow(grafcet::write_race, grafcet::overlapping_branches)]
        forceable;
        max_evolutions 100;
        input a: bool;
        input n: u8;
        output q, r, s, k: bool;
        output v, w: u8 = 0;
        var m, l: u8 = 0;
        action act(n: u8);
        let later = n > 3 && todo!();
        initial step A { q if todo!() && l > 3; S k if unimplemented!("later"); }
        step B { P1 m = todo!(); N act(unreachable!()); v = stop(); R k; }
        step C { P1 { m = 3; todo!() } P0 { m = stop(); } N act(m); s if a || panic!("no"); w = m.max(todo!()); }
        step F { D 2s r if todo!(); on rising(todo!()) l = todo!(); on rising(a) { todo!() } }
        A -[todo!()]-> B -[a && stop()]-> C -[later]-> A;
        B -[3s/stop() && !a]-> A;
        C -[if n > 3 { todo!() } else { false }]-> F -[loop { core::hint::spin_loop(); }]-> A;
    }
}

/// Carries out no action.
#[derive(Clone, Copy, Debug)]
pub struct Silent;

impl SfcActions for Silent {
    fn act(&mut self, _: Phase, _: u8) {}
}

impl GrafcetActions for Silent {
    fn act(&mut self, _: Phase, _: u8) {}
}
