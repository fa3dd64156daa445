//! What is there, but in another order or with signs of other languages: one message each, and nothing that follows from it.
use grafcet::grafcet;

// The type in front, lists in braces, a colon after the keyword.
grafcet! {
    sfc Declared {
        input bool start, stop;
        output { valve: bool, pump: bool }
        inputs: low, high: bool;
        var int count = 0;
        VAR_INPUT { full: bool }

        step initial Idle;
        step Last final { N pump; }
        step Fill { L valve 5s; };;

        Idle -[start && low && full]-> Fill -[stop || high]-> Last;
    }
}

grafcet! {
    sfc pub Late { initial step Idle; }
}

fn main() {}
