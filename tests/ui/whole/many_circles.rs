use grafcet::grafcet;

// Circles of many partial grafcets that keep each other turning: the message does not name all of them.
grafcet! {
    grafcet Rings {
        input a: bool;
        output q0, q1, q2, q3, q4, q5: bool;

        partial RingA {
            initial step A1;
            step A2 { q0; }
            A1 -[a && !B2.X]-> A2 -[C2.X]-> A1;
        }
        partial RingB {
            initial step B1;
            step B2 { q1; }
            B1 -[a && !C2.X]-> B2 -[E2.X]-> B1;
        }
        partial RingC {
            initial step C1;
            step C2 { q2; }
            C1 -[a && !E2.X]-> C2 -[F2.X]-> C1;
        }
        partial RingE {
            initial step E1;
            step E2 { q3; }
            E1 -[a && !F2.X]-> E2 -[G2.X]-> E1;
        }
        partial RingF {
            initial step F1;
            step F2 { q4; }
            F1 -[a && !G2.X]-> F2 -[A2.X]-> F1;
        }
        partial RingG {
            initial step G1;
            step G2 { q5; }
            G1 -[a && !A2.X]-> G2 -[B2.X]-> G1;
        }
    }
}

fn main() {}
