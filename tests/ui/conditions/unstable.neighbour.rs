use grafcet::grafcet;

grafcet! {
    grafcet Toggle {
        input button: bool;
        output lamp: bool;

        initial step Dark;
        step Lit { lamp; }

        Dark -[rising(button)]-> Lit -[rising(button)]-> Dark;
    }
}

// Nearly the same, and each of them comes to rest, or does unless further inputs coincide.
grafcet! {
    grafcet Kinds {
        input a, b: bool;
        input level: u16;
        output count: u16 = 0;

        partial Implied {
            initial step Idle;
            step Run;
            Idle -[a && level > 5]-> Run -[level > 7]-> Idle;
        }
        partial Parallel {
            initial step Start;
            step Left;
            step Right;
            Start -[b]-> (Left, Right);
            (Left, Right) -[b && 1s/Left]-> Start;
        }
        partial Steps {
            initial step One;
            step Two;
            One -[a && !Two.X]-> Two -[!a && !One.X]-> One;
        }
        partial Counts {
            initial step Ready;
            step Done;
            Ready -[5s/Ready]-> Ready;
            Ready -[a && !(5s/Ready) => count = count + 1]-> Done -[!a]-> Ready;
        }
    }
}

// Nearly those that are commanded, entered in a search, or decided by an assumption.
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
            Off -[low]-> On -[!low]-> Off;
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
                Run -[stop || aside]-> Done -[!aside]-> Run;
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
            Dark -[Open.X]-> Lit -[shut]-> Dark;
        }
    }
}

grafcet! {
    grafcet Assumed {
        #![allow(grafcet::never_true)]
        input a, b, c: bool;
        assume never b && !c;

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

        Ready -[a]-> (Left, Right) -[a]-> Out -[!a]-> Ready;
        any -[!hold]-> Out;
    }
}

fn main() {
    let mut toggle = Toggle::new();
    let mut press = |button| toggle.cycle(&ToggleInputs { button }).lamp;
    assert!(!press(false));
    assert!(press(true));
    assert!(press(true));
    assert!(press(false));
    assert!(!press(true));
}
