//! What is refused hides no mistake elsewhere in the same item: a condition none in the actions on clearing after it, one action
//! none in the next, one line of a step none in the others.
use grafcet::grafcet;

grafcet! {
    grafcet Press {
        input start, stop: bool;
        output ram: bool;
        var count: u8 = 0;

        initial step Idle { ram if start AND stop; P1 cont = 0; }
        step Down { L 5q ram if stp; rma if +; S q if start AND stop; }

        Idle -[start AND stop => cout = 0, count := 4]-> Down -[stop OR start => count = 3 +, count = cuont]-> Idle;
        Down -[5 s/Down => reset()]-> Idle;
        any -[NOT start => count == 0]-> Idle;
    }
}

// Another branch that could not be read is a branch all the same.
grafcet! {
    grafcet Sorter {
        input heavy, long: bool;

        initial step Wait;
        step Left;
        step Right;

        Wait -[heavy AND long]-> Left -[!heavy]-> Wait;
        Wait -[else]-> Right -[long =]-> Wait;
    }
}

fn main() {}
