::grafcet::grafcet! {
    /// One active step.
    pub sfc Motor {
        input on, off: bool;
        output relay: bool;
        output speed: u16;
        initial step Off;
        step On { N relay; speed = 3; }
        Off -[on]-> On -[off]-> Off;
    }
}

::grafcet::grafcet! {
    /// Everything at once.
    pub sfc Batch {
        input start, full, empty: bool;
        input level: u16;
        output valve, pump, lamp: bool;
        output speed: u16 = 0;
        var count: u16 = 0;
        param soak: time = 5s;
        param hot: i16 = 80;
        action heat(setpoint: i16);

        initial step Idle { lamp; }
        step Fill { N valve; P1 count = count + 1; }
        step Heat { N heat(hot); L 3s lamp; D 1s pump; speed = 10; }
        step Stir { N heat(40); SD 2s pump; P0 { if count > 3 { count = 0; } } }
        step Drain { R pump; N pump if level > 3; }

        Idle -[rising(start)]-> (Fill, Heat);
        (Fill, Heat) -[full && soak/Heat]-> Stir -[Stir.T >= 2s && 1s/empty/500ms]-> Drain -[level == 0]-> Idle;
    }
}

::grafcet::grafcet! {
    /// Everything at once.
    pub grafcet Oven {
        input door, start: bool;
        output lamp, fan: bool;
        output burner: bool;
        output power: u8;
        #[allow(grafcet::unused_variable)]
        var runs: u16 = 0;
        var hot: bool;
        param bake: time = 10s;
        action beep(times: u8);
        max_evolutions 8;

        partial Safety {
            initial step Ready;
            step Stopped { force Main {}; }
            Ready -[door && start]-> Stopped -[!door]-> Ready;
        }
        partial Main {
            initial step Off { P1 beep(1); lamp if door; }
            step Bake { S burner; hot; N beep(2); power = 80; L 2s fan; P0 { runs += 1; } }
            macro step Cool {
                entry step Begin { R burner; D 1s fan; }
                exit step End { on falling(door) beep(3); }
                Begin -[door]-> End;
            }

            Off -[begin: rising(start) && !door => beep(4)]-> Bake -[bake/Bake || 1s/door/200ms]-> Cool;
            Cool -[Cool.T >= 3s && !hot]-> Off;
        }
    }
}

::grafcet::grafcet! {
    /// A step for each name.
    #[allow(non_snake_case)]
    pub sfc Named {
        input Vec, Box, Clone: bool;
        input bool: bool;
        output usize, heapless: bool;
        initial step Option { usize; }
        step Some { heapless; }
        step None;
        step Copy;
        step core;
        Option -[Vec]-> Some -[Box]-> None -[Clone]-> Copy -[bool]-> core -[true]-> Option;
    }
}
