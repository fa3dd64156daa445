use grafcet::grafcet;

grafcet! {
    /// A drive-through with three places. Every car is a token of its own, from a source transition to a sink; a car
    /// moves up only where the place in front is free.
    pub grafcet Parking {
        input arrive, paid, leave: bool;
        output print, barrier, lamp: bool;
        var cars: u16 = 0;

        step Ticket { print; P1 cars = (cars + 1) % 1000; }
        step Pass { barrier; }
        step Inside { lamp if cars > 100; }

        () -[rising(arrive) && !Ticket.X]-> Ticket;
        Ticket -[rising(paid) && !Pass.X]-> Pass -[2s/Pass && !Inside.X]-> Inside -[rising(leave)]-> ();
    }
}
