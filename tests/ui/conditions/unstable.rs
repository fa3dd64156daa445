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

// Commanded by others, entered only in a search, through the steps of others, and where only an assumption decides a condition.
grafcet! {
    grafcet Forced {
        input busy, low, back: bool;

        partial Mode {
            initial step Held { force Pump {*}; }
            step Free;
            Held -[busy]-> Free -[back]-> Held;
        }
        partial Pump {
            initial step Off;
            step On;
            Off -[low]-> On -[low]-> Off;
        }
    }
}

grafcet! {
    grafcet Enclosed {
        input stop, aside: bool;

        initial enclosing step Auto {
            partial Work {
                initial linked step Run;
                step Done;
                Run -[stop || aside]-> Done -[!stop]-> Run;
            }
        }
        step Manual;
        Auto -[stop]-> Manual -[!stop]-> Auto;
    }
}

grafcet! {
    grafcet Waits {
        input open, shut: bool;

        partial Gate {
            initial step Shut;
            step Open;
            Shut -[open]-> Open -[shut]-> Shut;
        }
        partial Sign {
            initial step Dark;
            step Lit;
            Dark -[Open.X]-> Lit -[open]-> Dark;
        }
    }
}

grafcet! {
    grafcet Assumed {
        #![allow(grafcet::never_true)]
        input a, b, c: bool;
        assume never !c || !b;

        partial Work {
            initial step One;
            step Two;
            step Three;
            One -[a]-> Two -[a]-> Three -[Spare.X ^ c]-> One;
        }
        partial Other {
            initial step Usual;
            step Spare;
            Usual -[b && !c]-> Spare -[a]-> Usual;
        }
    }
}

grafcet! {
    grafcet Fork {
        input a, hold: bool;

        initial step Ready;
        step Left;
        step Right;
        step Out;

        Ready -[a]-> (Left, Right) -[a]-> Out -[true]-> Ready;
        any -[!hold]-> Out;
    }
}

fn main() {}
