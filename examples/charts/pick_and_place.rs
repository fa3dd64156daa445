//! A controller with what the machine does, written beside it: a line, its belt, a lift, an arm and a clamp.

use core::fmt::Write;

use grafcet::grafcet;

use super::script::{self, Notes, PlayError, signals};

grafcet! {
    /// An arm with a lift and a clamp takes a part from a belt and places it outside.
    pub sfc PickAndPlace {
        // For builds without the feature `prove`; `cargo grafcet prove` decides them all.
        #![allow(grafcet::property_undecided)]
        clock 500ms;
        input start, arrived, up, down, back, out, gripped: bool;
        output belt, dip, push, grip, done, alarm: bool;

        initial step Ready;
        step Feed { belt; }
        step Dip { dip; }
        step Grip { dip; grip; }
        step Lift { grip; }
        step Carry { grip; push; }
        step Place { grip; push; dip; }
        step Drop { push; dip; }
        step Rise { push; }
        step Done { done; }
        step Lost { alarm; }
        step Jam { alarm; grip; push; }

        Ready -[start && up && back]-> Feed -[arrived]-> Dip -[down]-> Grip -[gripped]-> Lift -[up]-> Carry
            -[out]-> Place -[down]-> Drop -[!gripped]-> Rise -[up]-> Done -[back && !start]-> Ready;
        Dip -[3s/Dip]-> Lost -[up && !start]-> Ready;
        Grip -[1s/Grip]-> Lost;
        Place -[3s/Place]-> Jam -[up && !start]-> Carry;

        assume cycle within 500ms;

        // Nothing collides.
        never !Tower::Top.X && (Arm::Going.X || Arm::Coming.X);
        never Jaw::Open.X && Carry.X;
        never Tower::Bottom.X && belt;
        never Belt::Moving.X && dip;
        // Nothing waits for ever.
        Lift leads_to Carry within 2s;
        Carry leads_to Place within 3s;
        Rise leads_to Done within 2s;
        Feed leads_to Dip within 4s;
        Dip leads_to Grip.X || alarm within 5s;
        start leads_to done || alarm within 20s;
    }

    /// Asks for a part, until it is answered.
    #[cfg(not(target_os = "none"))]
    pub plant Line {
        input done, alarm: bool;
        output start: bool;
        choice part_wanted;
        initial step Quiet;
        step Asks { start; }
        Quiet -[part_wanted && !done && !alarm]-> Asks -[done || alarm]-> Quiet;
    }

    /// Brings a part in one to three seconds; it stays until the lift comes for it.
    #[cfg(not(target_os = "none"))]
    pub plant Belt {
        input belt, dip: bool;
        output arrived: bool;
        initial step Empty;
        step Moving;
        step There { arrived; }
        Empty -[belt]-> Moving -[1s..3s/Moving]-> There -[!belt && dip]-> Empty;
    }

    /// The lift: a cylinder that a spring lifts.
    #[cfg(not(target_os = "none"))]
    pub plant Tower {
        input dip: bool;
        output up, down: bool;
        fault jammed;
        initial step Top { up; }
        step Going;
        step Bottom { down; }
        step Coming;
        Top -[dip && !jammed]-> Going -[!dip]-> Coming;
        Going -[500ms..1s/Going && !jammed]-> Bottom -[!dip]-> Coming -[500ms..1s/Coming]-> Top;
    }

    /// A cylinder, which turns round where it is told to.
    #[cfg(not(target_os = "none"))]
    pub plant Arm {
        input push: bool;
        output back, out: bool;
        initial step In { back; }
        step Going;
        step Far { out; }
        step Coming;
        In -[push]-> Going -[500ms..2s/Going]-> Far -[!push]-> Coming -[500ms..2s/Coming]-> In;
        Going -[!push]-> Coming -[push]-> Going;
    }

    /// The clamp. Without a part it shuts, and feels none.
    #[cfg(not(target_os = "none"))]
    pub plant Jaw {
        input grip: bool;
        output gripped: bool;
        fault empty;
        initial step Open;
        step Shut { gripped; }
        Open -[grip && !empty]-> Shut -[!grip]-> Open;
    }
}

signals!(PickAndPlaceInputs: start, arrived, up, down, back, out, gripped);
signals!(PickAndPlaceOutputs: belt, dip, push, grip, done, alarm);

/// Plays a script on a controller of its own, without the machine; one plain line per cycle goes to `out`.
///
/// # Errors
/// As [`script::play`].
pub fn play<'s>(script: &'s str, out: &mut dyn Write) -> Result<(), PlayError<'s>> {
    let mut cell = PickAndPlace::new();
    script::play(script, out, |inputs, now| (cell.cycle(inputs, now), cell.active_steps(), Notes::new()))
}
