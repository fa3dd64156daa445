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
        Cleared -[jam]-> Jammed;

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
        home (Low);
    }
}

grafcet! {
    sfc TwoHands {
        input left, right: bool;
        output press: bool;

        initial step Released;
        step One;
        step Pressed { N press; }

        Released -[left || right]-> One;
        One -[left && right && One.T < 500ms]-> Pressed;
        Pressed -[!left || !right]-> Released;

        home Released;
    }
}

fn main() {}
