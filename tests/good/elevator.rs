use grafcet::grafcet;

grafcet! {
    /// Three floors: a partial grafcet keeps the call of each floor, another drives the cabin.
    pub grafcet Elevator {
        input call0, call1, call2, at0, at1, at2, shut, open: bool;
        output lamp0, lamp1, lamp2, up, down, opening, closing: bool;

        partial Ground {
            initial step Free0;
            step Called0 { lamp0; }
            Free0 -[call0 && !Cabin::Serve0.X]-> Called0 -[Cabin::Serve0.X]-> Free0;
        }
        partial First {
            initial step Free1;
            step Called1 { lamp1; }
            Free1 -[call1 && !Cabin::Serve1.X]-> Called1 -[Cabin::Serve1.X]-> Free1;
        }
        partial Second {
            initial step Free2;
            step Called2 { lamp2; }
            Free2 -[call2 && !Cabin::Serve2.X]-> Called2 -[Cabin::Serve2.X]-> Free2;
        }

        partial Cabin {
            initial step Home { down if !at0; }
            step Rest;
            step Down0 { down; }
            step Up1 { up; }
            step Down1 { down; }
            step Up2 { up; }
            step Serve0 { opening; }
            step Serve1 { opening; }
            step Serve2 { opening; }
            step Stay;
            step Shut { closing; }

            Home -[at0 && shut]-> Rest;

            Rest -[Ground::Called0.X]-> Down0 -[at0]-> Serve0;
            Rest -[First::Called1.X && !Ground::Called0.X && !at2]-> Up1 -[at1]-> Serve1;
            Rest -[First::Called1.X && !Ground::Called0.X && at2]-> Down1 -[at1]-> Serve1;
            Rest -[Second::Called2.X && !First::Called1.X && !Ground::Called0.X]-> Up2 -[at2]-> Serve2;

            Serve0 -[open]-> Stay;
            Serve1 -[open]-> Stay;
            Serve2 -[open]-> Stay;
            Stay -[5s/Stay]-> Shut -[shut]-> Rest;
        }
    }
}
