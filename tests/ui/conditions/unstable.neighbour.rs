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

fn main() {
    let mut toggle = Toggle::new();
    let mut press = |button| toggle.cycle(&ToggleInputs { button }).lamp;
    assert!(!press(false));
    assert!(press(true));
    assert!(press(true));
    assert!(press(false));
    assert!(!press(true));
}
