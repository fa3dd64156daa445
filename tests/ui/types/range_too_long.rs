use grafcet::grafcet;

grafcet! {
    sfc Long {
        input a: bool;
        output q: bool;
        param t: time in 0s..=5000h = 1s;
        param fine: time in 1us..=5ms = 2ms;
        param both: time in 1us..=5000h = 2ms;
        initial step A { q; }
        step B;
        A -[t/A && fine/A && both/A && a]-> B -[!a]-> A;
    }
}

fn main() {}
