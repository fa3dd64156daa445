//! What is said of a name that Rust needs `r#` for can be written so.
#![deny(deprecated)]

use grafcet::grafcet;

grafcet! {
    sfc Raw {
        input a, r#mod: bool;
        output q, r#fn: bool;
        var r#match: bool;
        var r#loop: bool = false;
        var r#for: u8;
        param r#use: u8 = 3;
        action r#impl();
        let r#if = a && q;
        initial step A { q if r#loop; }
        step B { P1 r#for = 3; }
        A -[a]-> B -[!a]-> A;
    }
}

fn main() {
    let _ = Raw::new();
}
