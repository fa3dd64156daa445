use grafcet::grafcet;

fn read(count: u16) -> Option<u16> {
    Some(count)
}

macro_rules! ratio {
    ($count:expr => $by:expr) => {
        $count / $by
    };
}

// What is left must be the user's own: here it would be the cycle.
grafcet! {
    sfc Press {
        input go, stop: bool;
        output motor: bool;
        output level: u16 = 0;
        var count: u16 = return;
        action report(value: u16, other: u16);

        initial step Idle {
            motor if { if stop { return Default::default() }; go };
            level = if go { break 3 } else { 4 };
            P1 report(read(count)?, if stop { continue } else { 0 });
        }
        step Work {
            P1 { if stop { return; } count += 1; }
            P1 { let Some(n) = read(count) else { break 'outer }; count = n; }
            P1 { loop { if go { break; } } while stop { break 'outer; } continue; }
            P1 { count = ratio!(count => return 5); assert!(read(count)? > 3); }
            P1 { 'outer: { (|| return)(); break; } }
        }
        Idle -[go && matches!(read(count)?, 0 | 1)]-> Work -[stop || return true => count = read(1)?]-> Idle;
    }
}

fn main() {}
