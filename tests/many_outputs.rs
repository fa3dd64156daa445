//! More outputs than are cleared at once, large ones among them: each is what the steps say, and zero elsewhere.

use grafcet::grafcet;

grafcet! {
    grafcet Many {
        input go: bool;
        output a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14: bool;
        output n: u16;
        output b0, b1, b2, b3, b4, b5, b6, b7, b8, b9: bool;
        output kept: i32;
        output m: u8;
        initial step A { a0; a13; b0; b9; n = 7; }
        step B { a9; a10; a11; a12; a14; b7; b8; m = 3; P1 kept = -5; }
        step C { n = 65535; m = 255; a1; a2; a3; a4; a5; a6; a7; a8; b1; b2; b3; b4; b5; b6; }
        A -[go]-> B -[!go]-> C -[go]-> A;
    }
}

#[test]
fn each_is_what_the_steps_say() {
    let mut chart = Many::new();
    let none = ManyOutputs::default();
    let first = ManyOutputs { a0: true, a13: true, b0: true, b9: true, n: 7, ..none };
    assert_eq!(chart.cycle(&ManyInputs { go: false }), first);
    let bits = ManyOutputs { a9: true, a10: true, a11: true, a12: true, a14: true, b7: true, b8: true, ..none };
    let second = ManyOutputs { m: 3, kept: -5, ..bits };
    assert_eq!(chart.cycle(&ManyInputs { go: true }), second);
    let third = chart.cycle(&ManyInputs { go: false });
    assert_eq!(
        (third.n, third.m, third.kept, third.a8, third.a9, third.b6, third.b7),
        (65535, 255, -5, true, false, true, false)
    );
    assert_eq!(chart.cycle(&ManyInputs { go: true }), second);
}
