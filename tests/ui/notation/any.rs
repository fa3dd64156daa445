use grafcet::grafcet;

grafcet! {
    sfc Sequence {
        input start, stop, ack: bool;
        output motor, lamp: bool;

        initial step Idle;
        step Run { motor; }
        step Stopped { lamp; }

        Idle -[start]-> Run -[ack]-> Idle;
        any -[stop]-> (Idle, Run, Stopped);
        any except (Idle, Run) -[stop]-> Stopped;
        any except (Idle, Runn) -[stop]-> Stopped;
        any except () -[stop]-> Stopped;
        any except (Idle, Idle) -[stop]-> Stopped;
        any -[stop]-> ();
        any -> Stopped;
        any -[else]-> Stopped;
        any -[stop && blink(1s)]-> Stopped;
        any -[stop => motor = true]-> Stopped;
        Run -[stop]-> any;
    }
}

grafcet! {
    grafcet Nets {
        input start, stop, ack: bool;
        output motor, lamp: bool;

        partial Main {
            initial step Idle;
            macro step Work {
                entry step First { motor; }
                exit step Last;
                First -[ack]-> Last;
                any -[stop]-> Last;
            }
            Idle -[start]-> Work -[ack]-> Idle;
            any except Off -[stop]-> Idle;
            any -[stop]-> Last;
            any -[stop]-> Off;
        }
        partial Power {
            initial step Off;
            step On { lamp; }
            Off -[start]-> On -[!start]-> Off;
        }
    }
}

grafcet! {
    sfc Names {
        input except: bool;
        output q: bool;

        initial step A { q; }
        step any;

        any -[except]-> A;
    }
}

fn main() {}
