use grafcet::grafcet;

grafcet! {
    /// A conductor over two machines: it holds one, initialises the other, and enclosures stand inside enclosures.
    pub grafcet Hierarchy {
        input run, pause, fault, quit, a, b, c: bool;
        output feed, saw, lift, alarm: bool;

        partial Conductor {
            initial step Normal;
            step Paused { force Saw {*}; }
            step Fault { force Saw {SawOff}; force Feeder {}; alarm; }
            step Reset { force Saw {INIT}; force Feeder {INIT}; }
            Normal -[fault]-> Fault -[quit && !fault]-> Reset -[true]-> Normal;
            Normal -[pause && !fault]-> Paused;
            Paused -[!pause && !fault]-> Normal;
            Paused -[fault]-> Fault;
        }

        partial Feeder {
            initial step FeederIdle;
            enclosing step Feeding {
                partial Belt {
                    linked step BeltWait;
                    enclosing step BeltOn {
                        feed;
                        partial Lift {
                            linked step Low;
                            step High { lift; }
                            Low -[a && !b]-> High -[b]-> Low;
                        }
                    }
                    BeltWait -[a]-> BeltOn -[!a && c]-> BeltWait;
                }
            }
            FeederIdle -[run]-> Feeding -[!run]-> FeederIdle;
        }

        partial Saw {
            initial step SawOff;
            step Sawing { saw; }
            SawOff -[run && c]-> Sawing -[b && !c]-> SawOff;
        }
    }
}
