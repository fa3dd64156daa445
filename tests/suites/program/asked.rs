//! A chart that asks its program, in `tests/suites.rs`.

use std::cell::Cell;

use grafcet::grafcet;

grafcet! {
    pub sfc Asked {
        input on: bool;
        output relay: bool;

        initial step Off;
        step On { N relay; }

        Off -[on && is_calm(3)]-> On -[!is_calm(3)]-> Off;
    }
}

thread_local! {
    static CALM: Cell<bool> = const { Cell::new(false) };
}

fn is_calm(_: u8) -> bool {
    CALM.get()
}

/// What the program says from now on.
pub fn answer(is_calm_3: bool) {
    CALM.set(is_calm_3);
}
