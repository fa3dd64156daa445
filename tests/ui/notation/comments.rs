//! Comments as IEC 61131-3 writes them, and times in words and quotes.
use grafcet::grafcet;

grafcet! {
    sfc Commented {
        (* what the plant says *)
        input a: bool;
        output q: bool;
        param soak: time = "5s";

        initial step Idle { (* nothing *) }
        step Run { L "2s" q; (* the horn *) }
        (* the way *)
        Idle -[a && 3sec/Idle]-> Run -[5min/Run || soak/Run || 250MS/Run]-> Idle;
        (* the end *)
    }
}

fn main() {}
