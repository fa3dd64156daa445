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

fn main() {}
