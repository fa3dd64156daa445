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

fn main() {
    let mut toggle = Toggle::new();
    let mut press = |button| toggle.cycle(&ToggleInputs { button }).lamp;
    assert!(!press(false));
    assert!(press(true));
    assert!(press(true));
    assert!(press(false));
    assert!(!press(true));
}
