use grafcet::grafcet;

// Delays of inputs, with and without a time to fall.
grafcet! {
    grafcet Debounce {
        input btn, sensor: bool;
        output lamp, pump: bool;
        initial step Off; step On { lamp; } step Pump { pump if 3s/sensor/2s; }
        Off -[50ms/btn]-> On -[100ms/!btn]-> Pump -[5s/Pump && !(50ms/btn)]-> Off;
    }
}
