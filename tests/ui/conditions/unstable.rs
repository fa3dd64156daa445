use grafcet::grafcet;

grafcet! {
    grafcet Toggle {
        input button: bool;
        output lamp: bool;

        initial step Dark;
        step Lit { lamp; }

        Dark -[button]-> Lit -[button]-> Dark;
    }
}

// Conditions that imply each other where the circle can be entered, parallel branches, step variables, a loop that counts.
grafcet! {
    grafcet Kinds {
        input a, b: bool;
        input level: u16;
        output count: u16 = 0;

        partial Implied {
            initial step Idle;
            step Run;
            Idle -[a && level > 5]-> Run -[level > 3]-> Idle;
        }
        partial Parallel {
            initial step Start;
            step Left;
            step Right;
            Start -[b]-> (Left, Right);
            (Left, Right) -[b]-> Start;
        }
        partial Steps {
            initial step One;
            step Two;
            One -[a && !Two.X]-> Two -[a && !One.X]-> One;
        }
        partial Counts {
            initial step Ready;
            step Done;
            Ready -[5s/Ready => count = count + 1]-> Ready;
            Ready -[a && !(5s/Ready)]-> Done -[!a]-> Ready;
        }
    }
}

// Two transitions between the same steps are one way: whether they clear together or one in place of the other, the circle is one.
grafcet! {
    grafcet Ways {
        #![allow(grafcet::overlapping_branches)]
        input a, b: bool;

        initial step First;
        step Second;
        step Third;

        First -[a]-> Second -[a]-> Third -[a]-> First;
        First -[a && b]-> Second -[a && !b]-> Third;
    }
}

fn main() {}
