use grafcet::grafcet;

grafcet! {
    sfc Mill {
        input start, done, jam, reset: bool;
        output spindle: bool;

        initial step Ready;
        step Mill { N spindle; }
        step Jammed;
        step Cleared;

        Ready -[start]-> Mill -[done]-> Ready;
        Mill -[jam]-> Jammed -[reset]-> Cleared;
        Cleared -[!jam]-> Ready;

        home Ready;
    }
}

grafcet! {
    grafcet Pair {
        input a, b: bool;

        partial Left {
            initial step Low;
            step High;
            Low -[a && Dark.X]-> High -[!a]-> Low;
        }
        partial Right {
            initial step Dark;
            step Lit;
            Dark -[b]-> Lit -[!b && Low.X]-> Dark;
        }

        home (Low, Lit);
        home (High, Dark);
    }
}

fn main() {}
