//! `not_home` is left out where another error lies on every way that is lost: here a deadlock two steps further on, a transition that
//! never clears, a step that nothing leads to.
use grafcet::grafcet;

grafcet! {
    sfc Later {
        input start, fill, done: bool;

        initial step Idle;
        step Fill;
        step Full;

        Idle -[start]-> Fill -[fill]-> Full;
        Fill -[done && !fill]-> Full;
        home Idle;
    }
}

grafcet! {
    sfc After {
        input start, full, done: bool;

        initial step Idle;
        step Fill;
        step Full;

        Idle -[start]-> Fill -[full]-> Full -[done && Idle.X]-> Idle;
        home Idle;
    }
}

grafcet! {
    sfc Nowhere {
        input start, done: bool;

        initial step Idle;
        step Work;
        step Rest;

        Idle -[start]-> Work -[done]-> Idle;
        Rest -[done]-> Idle;
        home Rest;
    }
}

// A circle that is left by nothing is a mistake of its own beside the transition that never clears.
grafcet! {
    sfc Two {
        input start, full, jam, done: bool;

        initial step Idle;
        step Fill;
        step Full;
        step Jam;
        step Clear;

        Idle -[start]-> Fill -[full]-> Full -[done && Idle.X]-> Idle;
        Fill -[jam]-> Jam -[done]-> Clear -[full]-> Jam;
        home Idle;
    }
}

fn main() {}
