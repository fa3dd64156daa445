use grafcet::grafcet;

// A place of storage between two sequences, as steps that count its free and its full places.
grafcet! {
    grafcet Buffer {
        input machined, taken, start, ship: bool;
        output spindle, robot, truck: bool;
        initial step PIdle; initial step Slot; initial step CIdle;
        step Machining { spindle; } step Deposit { robot; } step Full; step Taking { robot; } step Shipping { truck; }
        PIdle -[start]-> Machining;
        (Machining, Slot) -[machined]-> Deposit -[!machined]-> (PIdle, Full);
        (CIdle, Full) -[ship]-> Taking -[taken]-> (Slot, Shipping);
        Shipping -[!ship && !taken]-> CIdle;
    }
}
