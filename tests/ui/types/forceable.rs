use grafcet::{Chart, Forceable, Ticks, grafcet};

grafcet! {
    sfc Motor {
        input on: bool;
        output relay: bool;
        initial step Off;
        step On { relay; }
        Off -[on]-> On -[!on]-> Off;
    }
}

fn by_hand<C: for<'a> Chart<Actions<'a> = ()> + Forceable>(chart: &mut C, step: C::Step, inputs: &C::Inputs) {
    _ = chart.force(&[step], inputs, Ticks::ZERO, &mut ());
}

fn main() {
    let mut motor = Motor::new();
    by_hand(&mut motor, MotorStep::On, &MotorInputs::default());
}
