//! Machines as they are automated: sequences by sensors and by time, analog values, partial grafcets above each other,
//! movements that are watched. The times are short, so that a run comes through all steps.

use super::both;

both! { laundry: TimedCycle {
    input start, door, full, hot, empty, balanced: bool;
    output ready, locked, valve, heater, left, right, pump, slow, fast, alarm: bool;
    var turns: u8 = 0;
    var rinses: u8 = 0;

    initial step Idle { ready; }
    step Lock { S locked; }
    step Fill { valve; }
    step NoWater { alarm; }
    step Heat { heater; left; }
    step WashLeft { left; heater if !hot; P1 turns = turns.wrapping_add(1); }
    step WashRest1;
    step WashRight { right; heater if !hot; }
    step WashRest2;
    step Drain { pump; P1 turns = 0; }
    step DrainMore { pump; }
    step RinseFill { valve; }
    step RinseLeft { left; P1 rinses = rinses.wrapping_add(1); }
    step RinseRest;
    step RinseRight { right; }
    step RinseDrain { pump; }
    step RinseMore { pump; }
    step Spread { left; pump; P1 rinses = 0; }
    step Ramp { slow; pump; }
    step SpinSlow { slow; pump; }
    step SpinFast { fast; pump; }
    step Coast { pump; }
    step Loosen { right; }
    step Unlock { R locked; }
    step Done { ready; alarm if door; }

    Idle -[start && door]-> Lock -[500ms/Lock]-> Fill -[full]-> Heat -[hot || 20s/Heat]-> WashLeft;
    Fill -[!full && 10s/Fill]-> NoWater -[!start]-> Unlock;
    WashLeft -[3s/WashLeft]-> WashRest1 -[1s/WashRest1]-> WashRight -[3s/WashRight]-> WashRest2;
    WashRest2 -[1s/WashRest2 && turns < 4]-> WashLeft;
    WashRest2 -[1s/WashRest2 && turns >= 4]-> Drain -[empty]-> DrainMore -[2s/DrainMore]-> RinseFill;
    RinseFill -[full]-> RinseLeft -[2s/RinseLeft]-> RinseRest -[500ms/RinseRest]-> RinseRight;
    RinseRight -[2s/RinseRight]-> RinseDrain -[empty]-> RinseMore;
    RinseMore -[2s/RinseMore && rinses < 3]-> RinseFill;
    RinseMore -[2s/RinseMore && rinses >= 3]-> Spread;
    Spread -[balanced && 2s/Spread]-> Ramp -[1s/Ramp]-> SpinSlow -[4s/SpinSlow]-> SpinFast;
    Spread -[!balanced && 8s/Spread]-> Coast;
    SpinFast -[6s/SpinFast]-> Coast -[2s/Coast]-> Loosen -[1s/Loosen]-> Unlock -[1s/Unlock]-> Done;
    Done -[!door && 1s/Done]-> Idle;
} }

both! { plating, plating_size: TimedCycle {
    input start, there, low, high, good, home: bool;
    input recipe: u8;
    output ready, grip, forward, backward, lower, lift, heat, water, current, air, reject: bool;
    output parts: u16 = 0;
    var dips: u8 = 0;
    var tries: u8 = 0;

    initial step Idle { ready; }
    step Grip { S grip; }
    step Raise { lift; }

    step ToDegrease { forward; }
    step LowerDegrease { lower; }
    step Degrease { heat; }
    step LiftDegrease { lift; }
    step DripDegrease;

    step ToRinse { forward; }
    step LowerRinse { lower; }
    step Rinse { water; P1 dips = dips.wrapping_add(1); }
    step LiftRinse { lift; }
    step DripRinse { P1 dips = 0; }

    step ToNickel { forward; }
    step LowerNickel { lower; }
    step Nickel { current; }
    step LiftNickel { lift; }
    step DripNickel;

    step ToChrome { forward; }
    step LowerChrome { lower; }
    step Chrome { current; heat; }
    step LiftChrome { lift; }
    step DripChrome;

    step ToZinc { forward; }
    step LowerZinc { lower; }
    step Zinc { current; air; }
    step LiftZinc { lift; }
    step DripZinc;

    step ToClean { forward; }
    step LowerClean { lower; }
    step Clean { water; P1 dips = dips.wrapping_add(1); }
    step LiftClean { lift; }
    step DripClean { P1 dips = 0; }

    step ToDryer { forward; }
    step Dry { air; heat; }
    step Inspect;
    step Rework { backward; P1 tries = tries.wrapping_add(1); }
    step Reject { reject; R grip; P1 tries = 0; }
    step Unload { lower; R grip; P1 tries = 0; P1 parts = parts.wrapping_add(1); }
    step Return { backward; }

    Idle -[start && home]-> Grip -[500ms/Grip]-> Raise -[high]-> ToDegrease;
    ToDegrease -[there]-> LowerDegrease -[low]-> Degrease -[3s/Degrease]-> LiftDegrease -[high]-> DripDegrease;
    DripDegrease -[1s/DripDegrease]-> ToRinse -[there]-> LowerRinse -[low]-> Rinse -[1s/Rinse]-> LiftRinse;
    LiftRinse -[high && dips < 3]-> LowerRinse;
    LiftRinse -[high && dips >= 3]-> DripRinse;
    DripRinse -[1s/DripRinse && recipe == 1]-> ToNickel;
    DripRinse -[1s/DripRinse && recipe == 2]-> ToChrome;
    DripRinse -[1s/DripRinse && recipe == 3]-> ToZinc;
    ToNickel -[there]-> LowerNickel -[low]-> Nickel -[3s/Nickel]-> LiftNickel -[high]-> DripNickel;
    ToChrome -[there]-> LowerChrome -[low]-> Chrome -[5s/Chrome]-> LiftChrome -[high]-> DripChrome;
    ToZinc -[there]-> LowerZinc -[low]-> Zinc -[2s/Zinc]-> LiftZinc -[high]-> DripZinc;
    DripNickel -[1s/DripNickel]-> ToClean;
    DripChrome -[1s/DripChrome]-> ToClean;
    DripZinc -[1s/DripZinc]-> ToClean;
    ToClean -[there]-> LowerClean -[low]-> Clean -[1s/Clean]-> LiftClean;
    LiftClean -[high && dips < 2]-> LowerClean;
    LiftClean -[high && dips >= 2]-> DripClean -[1s/DripClean]-> ToDryer -[there]-> Dry -[4s/Dry]-> Inspect;
    Inspect -[good]-> Unload -[low]-> Return -[home]-> Idle;
    Inspect -[!good && tries < 2]-> Rework -[there && 500ms/Rework]-> LowerRinse;
    Inspect -[!good && tries >= 2]-> Reject -[1s/Reject]-> Return;
} }

both! { reactor: TimedCycle {
    input start, good: bool;
    input level, pressure: u16;
    input temperature: i16;
    output ready, inlet_a, inlet_b, stirrer, dose, cooler, vent, drain, sampled: bool;
    output power: u16 = 0;

    initial step Idle { ready; }
    step FillA { inlet_a; }
    step FillB { inlet_b; }

    step Heat { power = 1000; }
    step Hold { power = if temperature < 780 { 400 } else { 100 }; }
    step Cool { cooler; }
    step Cooled;

    step Stir { stirrer; }
    step Dose { dose; stirrer; }
    step Mix { stirrer; }
    step Vent { vent; }
    step Rest;
    step Mixed;

    step Sample { sampled; }
    step Drain { drain; }
    step Rinse { inlet_a; drain; }

    Idle -[start && level < 50]-> FillA -[level >= 400]-> FillB -[level >= 700]-> (Heat, Stir);
    Heat -[temperature >= 780]-> Hold -[5s/Hold]-> Cool -[temperature < 400]-> Cooled;
    Stir -[2s/Stir]-> Dose -[level >= 900 || 3s/Dose]-> Mix;
    Mix -[pressure >= 950]-> Vent -[pressure < 300 && 1s/Vent]-> Mix;
    Mix -[pressure < 950 && 4s/Mix]-> Rest -[1s/Rest]-> Mixed;
    (Cooled, Mixed) -[true]-> Sample;
    Sample -[good && 2s/Sample]-> Drain -[level < 20]-> Rinse -[3s/Rinse]-> Idle;
    Sample -[!good && 2s/Sample]-> (Heat, Stir);
} }

both! { picker, picker_size: TimedCycle {
    input start, part, left, right, up, down, vacuum, ack: bool;
    output ready, go_left, go_right, lower, suck, blow, alarm: bool;
    output code: u8 = 0;
    var tries: u8 = 0;

    initial step Home { go_left; R suck; }
    step Wait { ready; }
    step LowerPick { lower; }
    step Grip { S suck; P1 tries = tries.wrapping_add(1); }
    step RaisePick;
    step Carry { go_right; }
    step LowerPlace { lower; }
    step Release { R suck; blow; P1 tries = 0; }
    step RaisePlace;
    step Back { go_left; }
    step NotMoved { alarm; code = 1; }
    step NotLowered { alarm; code = 2; }
    step NotGripped { alarm; code = 3; R suck; P1 tries = 0; }
    step NotRaised { alarm; code = 4; }
    step Lost { alarm; code = 5; R suck; P1 tries = 0; }
    step Recover { R suck; }

    Home -[left && up]-> Wait -[start && part]-> LowerPick -[down]-> Grip;
    Home -[!(left && up) && 4s/Home]-> NotMoved;
    LowerPick -[!down && 1s/LowerPick]-> NotLowered;
    Grip -[vacuum && 300ms/Grip]-> RaisePick;
    Grip -[!vacuum && 800ms/Grip && tries < 3]-> LowerPick;
    Grip -[!vacuum && 800ms/Grip && tries >= 3]-> NotGripped;
    RaisePick -[up]-> Carry;
    RaisePick -[!up && 500ms/RaisePick]-> NotRaised;
    Carry -[right]-> LowerPlace;
    Carry -[!right && !vacuum && 200ms/Carry]-> Lost;
    Carry -[!right && vacuum && 500ms/Carry]-> NotMoved;
    LowerPlace -[down]-> Release;
    LowerPlace -[!down && 500ms/LowerPlace]-> NotLowered;
    Release -[!vacuum && 200ms/Release]-> RaisePlace -[up]-> Back -[left]-> Wait;
    RaisePlace -[!up && 500ms/RaisePlace]-> NotRaised;
    Back -[!left && 500ms/Back]-> NotMoved;
    NotMoved -[ack]-> Recover;
    NotLowered -[ack]-> Recover;
    NotGripped -[ack]-> Recover;
    NotRaised -[ack]-> Recover;
    Lost -[ack]-> Recover;
    Recover -[!ack && 1s/Recover]-> Home;
} }

#[cfg(any(every_chart, packer))]
pub mod packer {
    pub mod grafcet {
        crate::implementation::chart! {
            pub grafcet Chart {
                input ack, auto, carton, erected, bottle, closed, out, jog: bool;
                input estop, jam: bool;
                output alarm, manual, erect, gate, push, close, tape, eject, belt, jammed, lamp: bool;
                output cartons: u16 = 0;
                var bottles: u8 = 0;

                partial Safety {
                    initial step Ready;
                    step Stopped { force Modes {}; force Outfeed {}; alarm; }
                    step Restart { force Modes {INIT}; }

                    Ready -[estop]-> Stopped -[!estop && rising(ack)]-> Restart -[true]-> Ready;
                }

                partial Modes {
                    initial step Manual { force Outfeed {INIT}; manual; }
                    enclosing step Auto {
                        partial Packing {
                            linked step Wait { lamp; P1 bottles = 0; }
                            step Erect { erect; }
                            step Collect { gate; }
                            step Push { push; P1 bottles = bottles.wrapping_add(1); }
                            step Close { close; P1 bottles = 0; }
                            step Tape { tape; close; }
                            step Eject { eject; P1 cartons = cartons.wrapping_add(1); }

                            Wait -[carton && auto]-> Erect -[erected]-> Collect -[bottle]-> Push;
                            Push -[!bottle && bottles < 3]-> Collect;
                            Push -[!bottle && bottles >= 3]-> Close -[closed]-> Tape -[1s/Tape]-> Eject;
                            Eject -[!carton && Outfeed::Free.X]-> Wait;
                        }
                    }

                    Manual -[rising(auto)]-> Auto -[!auto && Packing::Wait.X]-> Manual;
                }

                partial Outfeed {
                    initial step Free { belt if jog && Modes::Manual.X; }
                    step Move { belt; }
                    step Jammed { jammed; }

                    Free -[out && Modes::Auto.X]-> Move -[!jam && !out && 500ms/Move]-> Free;
                    Move -[jam]-> Jammed -[!jam]-> Move;
                }
            }
        }
        pub const CYCLE: crate::TimedCycle<Chart, ChartInputs, ChartOutputs> = Chart::cycle;
    }
}
