use grafcet::grafcet;

// Two lanes share a robot that fills cartons: sixty steps, a supervisor that forces, a macro-step with branches, an enclosure.
grafcet! {
    /// A packaging line: two lanes share a robot, which fills cartons; supervision commands all.
    grafcet Line {
        input estop, reset, run, pause, maintenance, door: bool;
        input a_present, a_at_stop, a_taken, b_present, b_at_stop, b_taken, robot_home, over_a, over_b, over_box, closed_grip, open_grip: bool;
        input box_in, box_open, box_full_ack, flaps, glued, taped, weight_ok, weight_bad, out_gone, in_print, printed, applied, tray, tray_gone, code_ok: bool;
        input layers: u8;
        output belt_a, stop_a, belt_b, stop_b, move_a, move_b, move_box, close, open, erect, flap, glue, tape, weigh, kick, release, print, apply, lamp, siren, idle_lamp, tray_belt, verify: bool;
        var packed: u8 = 0; var trays: u8 = 0;

        partial Supervisor {
            initial step V1 { idle_lamp; }
            step V2;
            step V3 { force LaneA {*}; force LaneB {*}; force Robot {*}; force Carton {*}; force Label {*}; lamp; }
            step V4 { force LaneA {}; force LaneB {}; force Robot {}; force Carton {}; force Label {}; siren; }
            step V5 { force LaneA {INIT}; force LaneB {INIT}; force Robot {Home}; force Carton {INIT}; force Label {INIT}; }
            V1 -[run && !estop && !door]-> V2;
            V2 -[pause && !estop]-> V3 -[!pause && !estop]-> V2;
            V2 -[estop]-> V4; V3 -[estop]-> V4;
            V4 -[!estop && reset]-> V5 -[!reset]-> V1;
        }
        partial LaneA {
            initial step A1;
            step A2 { belt_a; } step A3 { stop_a; } step A4 { stop_a; } step A5 { belt_a; } step A6;
            A1 -[Supervisor::V2.X && a_present]-> A2 -[a_at_stop]-> A3 -[Robot::GripA.X]-> A4 -[a_taken]-> A5 -[!a_at_stop && !a_taken]-> A6 -[1s/A6]-> A1;
        }
        partial LaneB {
            initial step B1;
            step B2 { belt_b; } step B3 { stop_b; } step B4 { stop_b; } step B5 { belt_b; } step B6;
            B1 -[Supervisor::V2.X && b_present]-> B2 -[b_at_stop]-> B3 -[Robot::GripB.X]-> B4 -[b_taken]-> B5 -[!b_at_stop && !b_taken]-> B6 -[1s/B6]-> B1;
        }
        partial Robot {
            initial step Home;
            step ToA { move_a; } step GripA { close; } step ToB { move_b; } step GripB { close; }
            step LiftA { move_box; } step LiftB { move_box; } step OverBox; step Drop { open; } step Back;
            Home -[LaneA::A3.X && Carton::C3.X]-> ToA -[over_a && !over_box]-> GripA -[closed_grip && LaneA::A4.X]-> LiftA -[over_box]-> OverBox;
            Home -[LaneB::B3.X && Carton::C3.X && !LaneA::A3.X]-> ToB -[over_b && !over_box]-> GripB -[closed_grip && LaneB::B4.X]-> LiftB -[over_box]-> OverBox;
            OverBox -[Carton::C3.X]-> Drop -[open_grip && !closed_grip]-> Back -[robot_home && !over_box]-> Home;
        }
        partial Carton {
            initial step C1;
            step C2 { erect; } step C3 { on rising(open_grip) packed = packed + 1; }
            macro step Close {
                entry step K1;
                step K2 { flap; } step K3; step K4 { glue; } step K5; step K6;
                exit step K7 { tape; }
                K1 -[flaps]-> (K2, K4);
                K2 -[2s/K2 && flaps]-> K3;
                K4 -[glued]-> K5;
                K4 -[5s/K4 && !glued]-> K6 -[glued]-> K5;
                (K3, K5) -[box_full_ack]-> K7;
            }
            step C4 { weigh; } step C5 { kick; } step C6 { release; } step C7 { P1 packed = 0; }
            C1 -[Supervisor::V2.X && box_in]-> C2 -[box_open]-> C3;
            C3 -[packed >= layers && Robot::Home.X]-> Close -[taped]-> C4;
            C4 -[weight_ok && !weight_bad]-> C6;
            C4 -[weight_bad]-> C5 -[out_gone]-> C7;
            C6 -[Label::Q7.X]-> C7 -[!box_in && !out_gone]-> C1;
        }
        partial Label {
            initial step Q1;
            step Q2 { print; } step Q3; step Q4 { verify; } step Q5; step Q6 { apply; } step Q7;
            step Q8 { tray_belt; } step Q9; 
            Q1 -[Carton::C4.X && in_print]-> (Q2, Q4, Q8);
            Q2 -[printed]-> Q3; Q4 -[code_ok]-> Q5; Q8 -[tray && !tray_gone]-> Q9;
            (Q3, Q5, Q9) -[Carton::C6.X]-> Q6 -[applied]-> Q7 -[Carton::C7.X || Carton::C1.X]-> Q1;
            (Q3, Q5, Q9) -[Carton::C7.X && !Carton::C6.X]-> Q1;
        }
        partial Service {
            initial step M1;
            enclosing step M2 {
                partial Trays {
                    linked step W1;
                    step W2 { P1 trays = trays + 1; } step W3; step W4 { P1 trays = 0; }
                    W1 -[tray && trays < 10]-> W2 -[tray_gone && !tray]-> W3 -[!tray_gone]-> W1;
                    W1 -[trays >= 10]-> W4 -[!tray]-> W1;
                }
            }
            step M3;
            M1 -[maintenance && Supervisor::V1.X]-> M2 -[!maintenance]-> M3 -[reset]-> M1;
        }
    }
}
