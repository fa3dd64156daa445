use grafcet::grafcet;

// What could not be understood is one error; nothing is said about what seems to be missing because of it.
grafcet! {
    sfc Door {
        input open, closed: bool;
        output motr lamp: bool;
        output motor: boool;

        initial step Closed { N lamp; }
        Opening { N motor; }
        step Open { N motor if ; }
        step Closing { N motor; N horn }

        Closed -[open]-> Opening -[!closed &&]-> Open;
        Open -[=]-> Closing -[closed]-> Closed;
    }
}

fn main() {
    let mut door = Door::new();
    door.cycle(&DoorInputs { open: true, closed: false });
}
