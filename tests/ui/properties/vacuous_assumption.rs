use grafcet::grafcet;

grafcet! {
    sfc Tank {
        #![deny(grafcet::vacuous_assumption)]
        input level: u8;
        input opened, closed: bool;
        output pump: bool;

        assume never level < 5 && level > 100;
        assume never opened && closed;
        assume often opened && closed;
        assume often !opened || !closed;

        initial step Rest;
        step Pump { pump; }

        Rest -[level < 20 && closed]-> Pump -[level > 80 || opened]-> Rest;
    }
}

fn main() {}
