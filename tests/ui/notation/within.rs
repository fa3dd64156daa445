use grafcet::grafcet;

struct Limits {
    late: bool,
}

static LIMITS: Limits = Limits { late: false };

grafcet! {
    grafcet Tank {
        input start, full, open: bool;
        param patience: u16 = 5;

        initial step Idle;
        step Fill within 10s;
        step Twice within 5s within 6s;
        step AtOnce within 0s;
        step Unit within 10;
        step Unknown within soon;
        step Number within patience;
        step Missing within { }
        macro step Clamp within 3s {
            entry step Close;
            exit step Open;
            Close -[open]-> Open;
        }

        Idle -[start && !LIMITS.late]-> Fill -[full || Fill.late]-> Twice -[Idle.late]-> AtOnce -[Clamp.late]-> Unit;
        Unit -[full.late]-> Unknown -[Fil.late]-> Number -[start]-> Missing -[start]-> Clamp -[open]-> Idle;
    }
}

fn main() {}
