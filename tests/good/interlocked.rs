use grafcet::grafcet;

grafcet! {
    /// A lathe and a robot wait for each other through their step variables.
    pub grafcet Interlocked {
        input blank, turned, gripped, placed, home: bool;
        output chuck, lathe, robot_in, robot_out: bool;

        partial Lathe {
            initial step Ask;
            step Clamp { S chuck; }
            step Turn { lathe; }
            step Offer { R chuck; }
            Ask -[Robot::Loaded.X]-> Clamp -[200ms/Clamp]-> Turn -[turned]-> Offer -[Robot::Taken.X]-> Ask;
        }

        partial Robot {
            initial step Fetch;
            step Load { robot_in; }
            step Loaded;
            step Away;
            step Take { robot_in; }
            step Taken;
            step Drop { robot_out; }
            Fetch -[blank && gripped]-> Load -[placed]-> Loaded -[Lathe::Clamp.X]-> Away;
            Away -[home && Lathe::Offer.X]-> Take -[gripped && !home]-> Taken -[Lathe::Ask.X]-> Drop;
            Drop -[home && !gripped]-> Fetch;
        }
    }
}
