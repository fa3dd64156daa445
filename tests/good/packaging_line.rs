use grafcet::grafcet;

grafcet! {
    /// A packaging line: a conductor starts and ends five machines by their step variables; faults hold the line.
    pub grafcet PackagingLine {
        input start, stop, fault, quit, door: bool;
        input carton, squared, glued, bottle, six, lowered, raised, gripped, placed: bool;
        input flap1, flap2, taped, pressed, scanned, readable, layer_full, pallet_full, pallet, lifted: bool;
        output run_lamp, fault_lamp, erect, glue, suction, feed, gate, lower, raise, hold: bool;
        output fold1, fold2, tape, press, scan, reject, push, lift, clear, call_truck: bool;
        var layers: u8 = 0;

        partial Guard {
            initial step Free;
            step Held {
                fault_lamp;
                force Erector {*};
                force Packer {*};
                force Closer {*};
                force Palletiser {*};
            }
            step Again { fault_lamp if door; }

            Free -[fault || door]-> Held -[!fault && !door && rising(quit)]-> Again -[1s/Again]-> Free;
        }

        partial Conductor {
            initial step Rest;
            step Warming { fault_lamp if fault; }
            step Running { run_lamp; }
            step Emptying { run_lamp if !door; }

            Rest -[start && !stop && Guard::Free.X]-> Warming -[10s/Warming]-> Running;
            Running -[stop]-> Emptying;
            Emptying -[Erector::Flat.X && Packer::Loose.X && Closer::Gap.X && !start]-> Rest;
        }

        partial Erector {
            initial step Flat;
            step Draw { suction; }
            step Square { erect; suction; }
            step GlueLeft { glue; erect; }
            step LeftDry;
            step GlueRight { glue; erect; }
            step RightDry;
            step Upright;
            step Handed;

            Flat -[Conductor::Running.X && carton]-> Draw -[squared]-> Square -[500ms/Square]-> (GlueLeft, GlueRight);
            GlueLeft -[glued]-> LeftDry;
            GlueRight -[glued && 200ms/GlueRight]-> RightDry;
            (LeftDry, RightDry) -[true]-> Upright -[Packer::Empty.X]-> Handed -[!squared]-> Flat;
        }

        partial Packer {
            initial step Loose;
            step Empty;
            step Collect { feed; }
            step Line { gate; }
            macro step Put {
                entry step Lower { lower; }
                step Grip { S hold; }
                step Raise { raise; }
                step Over;
                step Lower2 { lower; }
                exit step Release { R hold; }
                Lower -[lowered]-> Grip -[gripped]-> Raise -[raised && !lowered]-> Over;
                Over -[placed]-> Lower2 -[lowered]-> Release;
            }
            step Check;
            step Packed;

            Loose -[Erector::Upright.X]-> Empty -[Erector::Handed.X]-> Collect;
            Collect -[six]-> Line -[bottle && 300ms/Line]-> Put;
            Put -[!gripped && !placed]-> Check;
            Check -[!bottle && six && 500ms/Check]-> Packed;
            Check -[!six && 500ms/Check]-> Collect;
            Packed -[Closer::Take.X]-> Loose;
        }

        partial Closer {
            initial step Gap;
            step Take;
            step Fold1 { fold1; }
            step Folded1 { fold1; }
            step Fold2 { fold2; }
            step Folded2 { fold2; }
            step Tape { tape; }
            step Press { press; }
            step Scan { scan; }
            step Rejected { reject; }
            step Closed;

            Gap -[Packer::Packed.X]-> Take -[Packer::Loose.X]-> (Fold1, Fold2);
            Fold1 -[flap1]-> Folded1;
            Fold2 -[flap2]-> Folded2;
            (Folded1, Folded2) -[true]-> Tape -[taped]-> Press -[pressed && !taped]-> Scan;
            Scan -[scanned && readable]-> Closed -[Palletiser::Push.X]-> Gap;
            Scan -[scanned && !readable]-> Rejected -[!scanned && 1s/Rejected]-> Gap;
        }

        partial Palletiser {
            initial step NoPallet;
            step Place;
            step Push { push; }
            step Pushed;
            enclosing step Layer {
                partial Lifting {
                    linked step Lift { lift; }
                    step Settle;
                    step Shift { lift; push; }
                    step Shifted;
                    Lift -[lifted]-> Settle -[200ms/Settle]-> Shift -[!lifted]-> Shifted;
                }
            }
            step Counted { P1 layers = (layers + 1) % 100; }
            step Leave { clear; }
            step Truck { call_truck; P1 layers = 0; }

            NoPallet -[pallet]-> Place -[Closer::Closed.X]-> Push -[Closer::Gap.X]-> Pushed;
            Pushed -[layer_full && !pallet_full]-> Layer -[Lifting::Shifted.X]-> Counted;
            Pushed -[!layer_full && !pallet_full]-> Place;
            Pushed -[pallet_full]-> Leave;
            Counted -[layers < 5]-> Place;
            Counted -[layers >= 5]-> Leave -[!pallet]-> Truck -[rising(quit) || 30s/Truck]-> NoPallet;
        }
    }
}
