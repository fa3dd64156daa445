use grafcet::grafcet;

grafcet! {
    sfc Oven {
        input start, done: bool;
        output horn: bool;

        initial step Idle;
        step Bake { L 5s horn; }
        step Turn { L 2s horn; }

        Idle -[start]-> Bake -[done]-> Turn -[!done]-> Idle;
    }
}

fn main() {}
