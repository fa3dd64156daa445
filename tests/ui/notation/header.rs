use grafcet::grafcet;

grafcet! {}

grafcet! {
    pub scf Motor {
        initial step Off;
    }
}

grafcet! {
    pub fn Motor() {}
}

grafcet! {
    GRAFCET Lamp {
        initial step Dark;
    }
}

grafcet! {
    sfc Pump<T> {
        initial step Idle;
    }
}

grafcet! {
    sfc Fan { initial step Idle; }
    sfc Belt { initial step Idle; }
}

fn main() {
    let _ = Lamp::new();
    let _ = Fan::new();
}
