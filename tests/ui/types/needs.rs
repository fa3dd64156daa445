// What a chart needs of a type stands at the type, whatever the type is used for; nothing follows from it.
use grafcet::grafcet;

#[derive(Default)]
pub struct Moved(u16);

#[derive(Clone, Copy)]
pub struct Undefined(u16);

#[derive(Clone, Copy, Default)]
pub struct Unequal(u16);

grafcet! {
    pub sfc Inputs {
        input raw: Moved;
        input level: Undefined;
        output q: bool;
        initial step A { q; }
        step B;
        A -[raw.0 > 3]-> B -[raw.0 > 3 && level.0 > 2]-> A;
    }
}

grafcet! {
    pub grafcet Outputs {
        input a: bool;
        output raw: Moved;
        output level: Undefined;
        output known: Undefined = Undefined(1);
        initial step A { raw = Moved(1); level = Undefined(3); known = Undefined(2); }
        step B;
        A -[a]-> B -[!a]-> A;
    }
}

grafcet! {
    pub sfc Kept {
        input a: bool;
        var raw: Moved = Moved(1);
        param limits: [Moved; 2] = [Moved(1), Moved(2)];
        initial step A { P1 raw = Moved(2); }
        step B;
        A -[a && raw.0 == 1 && limits[0].0 == 1]-> B -[5s/B && !a]-> A;
    }
}

grafcet! {
    pub grafcet Parallel {
        input raw: Moved;
        input go: bool;
        output q: bool;
        var last: Moved = Moved(1);
        assume never raw.0 > 5;
        initial step A;
        step B1 { q if raw.0 > 1; }
        step B2;
        step C1 { on rising(raw.0 > 4) last = raw; }
        step C2;
        A -[raw.0 > 1 && go]-> (B1, C1);
        B1 -[raw.0 > 2]-> B2;
        C1 -[5s/C1 && last.0 > 1]-> C2;
        (B2, C2) -[!go]-> A;
    }
}

grafcet! {
    pub grafcet Stored {
        input a: bool;
        output level: Unequal = Unequal(1);
        initial step A { P1 level = Unequal(2); }
        step B;
        A -[a && level.0 > 1]-> B -[!a]-> A;
    }
}

// With mistakes of its own, too.
grafcet! {
    pub sfc Mistaken {
        input raw: Moved;
        param limit: Unequal;
        initial step A;
        A -[raw.0 > 3 && limit.0 > 3]-> C;
    }
}

fn main() {
    let before = Inputs::new();
    let mut after = before;
    after.cycle(&InputsInputs { raw: Moved(1), level: Undefined(2) });
    let _ = (before.clone(), OutputsOutputs::default(), Kept::with_params(KeptParams::new()), MistakenParams::new());
}
