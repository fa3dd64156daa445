use grafcet::grafcet;

// A stop from wherever the machine is, in parallel branches too, and names for what is asked in several places.
grafcet! {
    sfc FillAndHeat {
        input auto, next, full, hot, empty, stop, guard, ack: bool;
        output inlet, heater, outlet, lamp: bool;
        /// Somebody wants the next batch.
        let go = auto || rising(next);
        /// Nothing may move any more.
        let halt = stop || !guard;

        initial step Ready;
        step Fill { inlet; }
        step Filled;
        step Heat { heater; }
        step Heated;
        step Check;
        step Drain { outlet; }
        step Stopped { lamp if blink(500ms); }

        Ready -[go && !halt]-> (Fill, Heat);
        Fill -[full]-> Filled;
        Heat -[hot]-> Heated;
        (Filled, Heated) -[true]-> Check;
        Check -[empty]-> Ready;
        Check -[else]-> Drain -[empty]-> Ready;

        any except Ready -[halt]-> Stopped -[ack && !halt]-> Drain;

        never halt && (inlet || heater);
        home Ready;
    }
}

// The same thing where partial grafcets are stopped each by itself, one with a macro-step that is left as a whole.
grafcet! {
    grafcet TwoStations {
        input start, there, down, up, stop, reset: bool;
        output belt, lower, raise, alarm: bool;

        partial Feeder {
            initial step Rest;
            step Move { belt; }
            Rest -[start]-> Move -[there]-> Rest;
            any -[halted: stop]-> Rest;
        }

        partial Press {
            initial step Open;
            macro step Stroke {
                entry step Lower { lower; }
                exit step Raise { raise; }
                Lower -[down]-> Raise;
            }
            step Stopped { alarm; }
            step Faulty { alarm; }
            Open -[Feeder::Move.X && !stop]-> Stroke -[up]-> Open;
            any except (Faulty, Open) -[stop]-> Stopped -[reset && !stop]-> Open;
            any except (Stopped, Open) -[5s/Stroke]-> Faulty -[reset]-> Open;
        }
    }
}
