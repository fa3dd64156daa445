//! A chart with a mistake that is recorded, sent, stored and steered: its mistake is all that there is to be said.

use grafcet::{Chart, grafcet};
use grafcet::record::steer::{Commands, command_len};
use grafcet::record::wire::{Follow, Wire, frame_len, wire_len};
use grafcet::record::{Blocked, Recordable, Recorder, Records, Stored, replay, restore, snapshot, snapshot_len};

grafcet! {
    #[derive(Debug)]
    sfc Motor {
        forceable;
        input on, off: bool;
        input level: u16;
        param hold: time = 10s;
        output relay: bool;
        initial step Off;
        step On { N rellay; }
        Off -[on && level > 3]-> On -[off || hold/On]-> Off;
    }
}

fn main() {
    let mut motor = Recorder::new(Motor::new(), [0; 512]).unwrap();
    let outputs = motor.cycle(&MotorInputs { on: true, off: false, level: 7 }, 0, &mut ());
    motor.change(Motor::init);
    motor.flush();
    let records = Records::of(motor.record()).unwrap();
    replay::<Motor>(&records, &mut (), |moment| assert_eq!(moment.outputs.relay, outputs.relay)).unwrap();
    let mut bytes = [0; snapshot_len::<Motor>()];
    snapshot(&Motor::new(), &mut bytes).unwrap();
    let restored: Motor = restore(&bytes, 500).unwrap();
    let _ = (restored.blocked().count(), Motor::FINGERPRINT, Stored::<{ snapshot_len::<Motor>() }>::of(&restored));
    let wire = Wire::new(Vec::new(), [0; wire_len::<Motor>()]);
    let sent = Recorder::over(Motor::new(), wire).unwrap();
    Follow::<Motor, _>::new([0; frame_len::<Motor>()]).bytes(sent.keep().writer(), &mut (), |_| {});
    let mut commands = Commands::<Motor, _, _>::new([0; command_len::<Motor>()], [Motor::STEPS[0]; Motor::STEPS.len()], 300);
    let _ = commands.push(0, 0);
}
