use grafcet::grafcet;

grafcet! {
    sfc Oven {
        clock 10ms;
        input start: bool;
        param soak: time = 1h30m;
        output burner, lamp, horn: bool;

        initial step Idle { L 5s lamp; D soak horn; }
        step Heat { L 500ms burner; }

        Idle -[5s/Idle || Idle.T > 3s]-> Heat -[11000h/Heat]-> Idle;
        Heat -[1.5h/Heat]-> Idle;
        Heat -[soak/Heat && start]-> Idle;
        Heat -[20ms/Heat]-> Idle;
    }
}

grafcet! {
    sfc Kiln {
        input start: bool;
        param soak, rest: time = 5s;
        param late: time = 3s;

        initial step Idle;
        step Heat;

        Idle -[start && rest/Idle]-> Heat -[soak/Heat && !start || late/Heat && start]-> Idle;
    }
}

// A name is the time in front of what a macro passes on, and of what stands on the next line.
macro_rules! timed {
    ($block:block, $lamp:ident, $soak:ident) => {
        grafcet! {
            sfc Timed {
                input start: bool;
                param soak: time = 5s;
                output lamp, horn: bool;
                var count: u8 = 0;

                initial step Idle { SL soak $block N lamp if count > 3; }
                step Heat {
                    D $soak $lamp;
                    L soak
                        horn;
                }

                Idle -[start]-> Heat -[!start]-> Idle;
            }
        }
    };
}

timed!({ count = count.wrapping_add(1); }, lamp, soak);

fn main() {}
