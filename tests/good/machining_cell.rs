use grafcet::grafcet;

grafcet! {
    /// A machining cell of sixty steps: safety above all, modes with enclosures, a mill, a robot and two belts that
    /// hand parts over by their step variables.
    pub grafcet MachiningCell {
        input estop, acknowledge, power, auto, jog_left, jog_right: bool;
        input part_in, at_stop, part_out, out_free: bool;
        input clamped, released, spindle_up, spindle_down, at_speed, wide: bool;
        input at_home, at_infeed, at_mill, at_outfeed, gripped, turned, measured, good: bool;
        output siren, ready_lamp, in_belt, in_stop, out_belt, out_stop, label: bool;
        output clamp, spindle, plunge, retract, coolant, chips: bool;
        output to_home, to_infeed, to_mill, to_outfeed, grip, turn, probe, left, right: bool;
        var parts, scrap: u16 = 0;

        partial Safety {
            initial step Secure;
            step Stopped {
                siren;
                force Infeed {};
                force Mill {};
                force Robot {};
                force Outfeed {};
            }
            step Cleared { siren if !acknowledge; force Infeed {}; force Mill {}; force Robot {}; force Outfeed {}; }
            step Restart { force Infeed {INIT}; force Mill {INIT}; force Robot {INIT}; force Outfeed {INIT}; }

            Secure -[estop]-> Stopped -[!estop]-> Cleared;
            Cleared -[estop]-> Stopped;
            Cleared -[!estop && rising(acknowledge)]-> Restart -[true]-> Secure;
        }

        partial Panel {
            initial step Off;
            step Ready { ready_lamp; }
            enclosing step Manual {
                partial Jog {
                    linked step Still;
                    step JogLeft { left; }
                    step JogRight { right; }
                    Still -[jog_left && !jog_right]-> JogLeft -[!jog_left]-> Still;
                    Still -[jog_right && !jog_left]-> JogRight -[!jog_right]-> Still;
                }
            }
            step Automatic;
            step Ending;

            Off -[power]-> Ready;
            Ready -[!power]-> Off;
            Ready -[power && auto]-> Automatic;
            Ready -[power && !auto && (jog_left || jog_right)]-> Manual;
            Manual -[auto || !power]-> Ready;
            Automatic -[!auto || !power]-> Ending -[Robot::Waiting.X && Mill::MillEmpty.X]-> Ready;
        }

        partial Infeed {
            initial step InEmpty;
            step InFeed { in_belt; }
            step InStop { in_stop; in_belt; }
            step InSettle { in_stop; }
            step InOffer { in_stop; }
            step InTaken;

            InEmpty -[Panel::Automatic.X && part_in]-> InFeed -[at_stop]-> InStop -[1s/InStop]-> InSettle;
            InSettle -[at_stop && 300ms/InSettle]-> InOffer -[Robot::PickUp.X]-> InTaken;
            InTaken -[!at_stop && Robot::ToMill.X]-> InEmpty;
        }

        partial Robot {
            initial step Waiting;
            step ToInfeed { to_infeed; }
            step PickDown;
            step PickUp { S grip; }
            step ToMill { to_mill; }
            step Place;
            step LetGo { R grip; }
            step Aside { to_home; }
            step Fetch { to_mill; }
            step Take { S grip; }
            step Turn { turn; }
            step Turned;
            step Carry { to_outfeed; }
            step Carried;
            step Probe { probe; }
            step Lay;
            step Scrap { P1 scrap = (scrap + 1) % 10_000; }
            step Drop { R grip; }
            step Back { to_home; }

            Waiting -[Infeed::InOffer.X && Mill::MillEmpty.X && Panel::Automatic.X]-> ToInfeed -[at_infeed]-> PickDown;
            PickDown -[200ms/PickDown]-> PickUp -[gripped && Infeed::InTaken.X]-> ToMill;
            ToMill -[at_mill && Mill::MillOpen.X]-> Place -[200ms/Place]-> LetGo -[!gripped && Mill::Work.X]-> Aside;
            Aside -[at_home && Mill::MillDone.X]-> Fetch -[at_mill && !at_home]-> Take -[gripped]-> (Turn, Carry);
            Turn -[turned]-> Turned;
            Carry -[at_outfeed && !at_mill]-> Carried;
            (Turned, Carried) -[true]-> Probe;
            Probe -[measured && good && Outfeed::OutFree.X]-> Lay -[200ms/Lay]-> Drop;
            Probe -[measured && !good]-> Scrap -[200ms/Scrap]-> Drop;
            Drop -[!gripped && 100ms/Drop]-> Back -[at_home && !at_outfeed]-> Waiting;
        }

        partial Mill {
            initial step MillEmpty;
            step MillOpen { R clamp; }
            macro step Work {
                entry step Clamp { S clamp; }
                step Spin { spindle; }
                step Flush { coolant; }
                step Wet { coolant; }
                step Rough { spindle; plunge; coolant; }
                step Fine { spindle; plunge; coolant; }
                step Lift { spindle; retract; }
                exit step Blow { chips; }

                Clamp -[clamped]-> (Spin, Flush);
                Flush -[500ms/Flush]-> Wet;
                (Spin, Wet) -[at_speed && wide]-> Rough;
                (Spin, Wet) -[at_speed && !wide]-> Fine;
                Rough -[spindle_down && !wide]-> Fine;
                Rough -[spindle_down && wide]-> Lift;
                Fine -[spindle_down && 1s/Fine]-> Lift -[spindle_up && !spindle_down]-> Blow;
            }
            step MillDone { R clamp; }
            step MillLeft;

            MillEmpty -[Robot::ToMill.X]-> MillOpen -[Robot::LetGo.X && released]-> Work;
            Work -[1s/Blow && !clamped || 3s/Blow]-> MillDone -[Robot::Take.X && released]-> MillLeft;
            MillLeft -[Robot::Probe.X]-> MillEmpty;
        }

        partial Outfeed {
            initial step OutFree;
            step OutTake;
            step Label { label; }
            step OutWait { out_stop; }
            step OutRun { out_belt; P1 parts = (parts + 1) % 10_000; }
            step Full { out_stop; siren if parts > 1000 && scrap > 10; }

            OutFree -[Robot::Lay.X]-> OutTake -[Robot::Back.X]-> Label -[400ms/Label]-> OutWait;
            OutWait -[out_free]-> OutRun -[part_out && !out_free]-> Full -[!part_out && out_free]-> OutFree;
        }
    }
}
