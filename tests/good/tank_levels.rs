use grafcet::grafcet;

grafcet! {
    /// A tank between two levels, with alarms above and below; all conditions are comparisons of one number.
    pub grafcet TankLevels {
        input level: u16;
        input quit: bool;
        output inlet, outlet, high, low: bool;

        initial step Hold;
        step Filling { inlet; }
        step Emptying { outlet; }
        step Overfull { outlet; high; }
        step Dry { inlet; low; }

        Hold -[level < 200]-> Filling;
        Hold -[level > 800]-> Emptying;
        Filling -[level < 50]-> Dry;
        Filling -[level >= 400]-> Hold;
        Emptying -[level > 950]-> Overfull;
        Emptying -[level <= 600]-> Hold;
        Dry -[level >= 400 && quit]-> Hold;
        Overfull -[level <= 600 && quit]-> Hold;
    }
}
