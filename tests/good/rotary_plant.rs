use grafcet::grafcet;

// Four stations around a turntable, with modes and safety: sixty steps in eight partial grafcets.
grafcet! {
    /// A drilling and pressing plant with turntable: safety, modes, four stations, transport.
    grafcet Plant {
        input estop, ack, auto, manual, start, stop, init_done, jog: bool;
        input part_in, loaded, gripper_up, gripper_down, clamped, released, drill_up, drill_down, hole_ok, hole_bad: bool;
        input press_up, press_down, force_ok, out_free, pushed, push_back, table_locked, table_unlocked, indexed, ejected, bin_full: bool;
        input count_reset: bool; input depth: u16;
        output horn, lamp_red, lamp_green, feeder, lower, lift, grip, unlock, turn, spindle, down, up, clamp, ram, push, retract, eject, vacuum, busy, jog_table, mark, full: bool;
        var good: u16 = 0; var bad: u16 = 0;

        partial Safety {
            initial step S1;
            step S2 { force Operation {}; force Load {}; force Drill {}; force Press {}; force Unload {}; force Table {}; force Reject {}; horn; lamp_red; }
            step S3 { lamp_red; force Operation {INIT}; force Load {INIT}; force Drill {INIT}; force Press {INIT}; force Unload {INIT}; force Table {INIT}; force Reject {INIT}; }
            S1 -[estop]-> S2 -[!estop && ack]-> S3 -[!ack]-> S1;
        }
        partial Operation {
            initial step O1;
            step O2 { lamp_green; busy; }
            step O3 { busy; }
            enclosing step O4 {
                partial Jog { linked step J1; step J2 { jog_table; } step J3; J1 -[jog && !stop]-> J2 -[!jog]-> J3 -[start]-> J1; }
            }
            step O5 { lamp_green; }
            O1 -[auto && !manual && start && !stop]-> O2;
            O1 -[manual && !auto && start && !stop]-> O4;
            O2 -[stop]-> O3;
            O3 -[Load::L1.X && Drill::D1.X && Press::P10.X && Unload::U1.X && Table::T1.X]-> O5;
            O4 -[!manual || stop]-> O5;
            O5 -[!start && init_done && !stop]-> O1;
        }
        partial Load {
            initial step L1;
            step L2 { feeder; } step L3 { lower; } step L4 { S grip; } step L5 { lift; } step L6 { lower; } step L7 { R grip; } step L8 { lift; } step L9;
            L1 -[Operation::O2.X && Table::T1.X && !indexed]-> L2;
            L2 -[part_in]-> L3 -[gripper_down]-> L4 -[clamped && 300ms/L4]-> L5 -[gripper_up && !gripper_down]-> L6 -[gripper_down && loaded]-> L7 -[released]-> L8 -[gripper_up && !gripper_down]-> L9;
            L9 -[Table::T4.X]-> L1;
        }
        partial Drill {
            initial step D1;
            step D2 { clamp; } step D3 { clamp; spindle; down; } step D4 { clamp; spindle; up; } step D5 { clamp; } step D6 { mark; } step D7;
            D1 -[Operation::O2.X && Table::T1.X && !indexed]-> D2 -[clamped]-> D3 -[drill_down && depth >= 120]-> D4 -[drill_up && !drill_down]-> D5;
            D3 -[10s/D3 && depth < 120]-> D4;
            D5 -[hole_ok && !hole_bad]-> D7;
            D5 -[hole_bad]-> D6 -[2s/D6]-> D7;
            D7 -[Table::T4.X]-> D1;
        }
        partial Press {
            initial step P10;
            macro step PM {
                entry step P11;
                step P12 { ram; } step P13 { ram; } step P14; step P15;
                exit step P16 { P1 good = good + 1; }
                P11 -[press_up]-> (P12, P14);
                P12 -[press_down]-> P13;
                P14 -[force_ok]-> P15;
                (P13, P15) -[1s/P13]-> P16;
            }
            step P17 { retract; } step P18;
            P10 -[Operation::O2.X && Table::T1.X && !indexed]-> PM -[!press_down]-> P17 -[press_up && !press_down]-> P18;
            P18 -[Table::T4.X]-> P10;
        }
        partial Unload {
            initial step U1;
            step U2 { vacuum; } step U3 { push; } step U4 { retract; } step U5; step U6 { full; }
            U1 -[Operation::O2.X && Table::T1.X && !indexed]-> U2;
            U2 -[out_free && !bin_full]-> U3 -[pushed]-> U4 -[push_back && !pushed]-> U5;
            U2 -[bin_full]-> U6 -[!bin_full && ack]-> U2;
            U5 -[Table::T4.X]-> U1;
        }
        partial Table {
            initial step T1;
            step T2 { unlock; } step T3 { turn; } step T4;
            T1 -[Load::L9.X && Drill::D7.X && Press::P18.X && Unload::U5.X]-> T2;
            T2 -[table_unlocked && !table_locked]-> T3 -[indexed && table_locked]-> T4;
            T4 -[Load::L1.X && Drill::D1.X && Press::P10.X && Unload::U1.X]-> T1;
        }
        partial Reject {
            initial step R1;
            step R2 { P1 bad = bad + 1; } step R3 { eject; } step R4; step R5 { P1 bad = 0; }
            R1 -[Drill::D6.X && !count_reset]-> R2;
            R1 -[count_reset && bad > 0]-> R5 -[!count_reset]-> R1;
            R2 -[Table::T4.X]-> R3 -[ejected]-> R4 -[!ejected && good < 60000]-> R1;
        }
    }
}
