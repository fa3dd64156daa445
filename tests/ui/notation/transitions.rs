use grafcet::grafcet;

grafcet! {
    sfc Belt {
        input a, b: bool;
        input n: u16;

        initial step One;
        step Two;
        step Three;

        One -[]-> Two;
        One -[a and b]-> Two;
        One -[a = b]-> Two;
        One -[a, b]-> Two;
        One -[not a]-> Two;
        One -[n := 1]-> Two;
        One -[else if a]-> Two;
        One --> Two;
        One -(a)-> Two;
        One -[b]- Two;
        One =[n > 3]=> Two;
        Two <-[a]- One;
        One, Two -[a]-> Three;
        One -[a]-> Two
        Two -[b]-> Three;
        Three;
        Three -[a]-> step Two;
    }
}

fn main() {}
