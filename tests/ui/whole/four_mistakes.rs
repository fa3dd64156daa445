use grafcet::grafcet;

// One mistake of notation, one of drawing, an unknown name and a wrong target: four errors, in source order.
grafcet! {
    pub sfc Motor {
        input on, off, over_temp: bool
        output relay, green, red: bool;
        output speed: u16;

        initial step Off { N red; }
        step On { N relay; N gren; S speed; }

        Off -[on && !over_temp]-> On -> Off;
    }
}

// The program around the chart gets no further errors: the chart still gives its types.
static MOTOR: Motor = Motor::new();

#[derive(Clone, Debug)]
struct Plant {
    temperature: i32,
    shown: MotorOutputs,
}

fn scan(motor: &mut Motor, plant: &mut Plant) {
    let inputs = MotorInputs { on: true, over_temp: plant.temperature > 90, ..Default::default() };
    let q: MotorOutputs = motor.cycle(&inputs);
    plant.shown = q;
    if q.relay && !q.red && motor.is_active(MotorStep::On) {
        plant.temperature += 1;
    }
    assert_eq!(plant.shown, q);
    println!("{:?} {:?} {:?}", q, motor.situation(), inputs);
    for step in motor.active_steps() {
        match step {
            MotorStep::Off => motor.init(),
            MotorStep::On => {}
        }
    }
}

fn generic<C: grafcet::Chart>(chart: &mut C) {
    chart.init();
}

fn main() {
    let mut motor = MOTOR;
    let mut plant = Plant { temperature: 20, shown: MotorOutputs::default() };
    scan(&mut motor, &mut plant);
    generic(&mut motor);
    let _ = MotorTransition::OffToOn;
}
