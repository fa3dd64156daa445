use grafcet::grafcet;

struct Motor;

impl Motor {
    fn cycle(&self) {
        grafcet! {
            sfc Drive {
                input motor: Self;
                input last: Option<Self>;
                output q: bool;
                action drive(motor: &'static Self);
                initial step Off { N drive(&motor); }
                step On { q if last.is_some(); }
                Off -[motor.is_on()]-> On -[last.is_none()]-> Off;
            }
        }
    }
}

fn main() {}
