use grafcet::grafcet;

grafcet! {
    sfc Oven {
        input start, done: bool;
        output horn: bool;

        initial step Idle;
        step Bake { L 5s horn; }
        step Turn { L 2s horn; }

        Idle -[start]-> (Bake, Turn);
        (Bake, Turn) -[done]-> Idle;
    }
}

// Three steps that are active together.
grafcet! {
    sfc Kiln {
        input start, done: bool;
        output horn: bool;

        initial step Idle;
        step Bake { L 5s horn; }
        step Turn { L 2s horn; }
        step Cool { D 1s horn; }

        Idle -[start]-> (Bake, Turn, Cool);
        (Bake, Turn, Cool) -[done]-> Idle;
    }
}

fn main() {}
