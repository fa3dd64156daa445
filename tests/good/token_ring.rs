use grafcet::grafcet;

grafcet! {
    /// Three partial grafcets pass the right to send around; each hands it on by a step variable.
    pub grafcet TokenRing {
        input want_a, want_b, want_c, sent: bool;
        output send_a, send_b, send_c: bool;

        partial A {
            initial step HasA;
            step SendA { send_a; }
            step PassA;
            step WaitA;
            HasA -[want_a]-> SendA -[rising(sent)]-> PassA;
            HasA -[!want_a && 10ms/HasA]-> PassA -[B::HasB.X]-> WaitA -[C::PassC.X]-> HasA;
        }
        partial B {
            initial step WaitB;
            step HasB;
            step SendB { send_b; }
            step PassB;
            WaitB -[A::PassA.X]-> HasB -[want_b]-> SendB -[rising(sent)]-> PassB;
            HasB -[!want_b && 10ms/HasB]-> PassB -[C::HasC.X]-> WaitB;
        }
        partial C {
            initial step WaitC;
            step HasC;
            step SendC { send_c; }
            step PassC;
            WaitC -[B::PassB.X]-> HasC -[want_c]-> SendC -[rising(sent)]-> PassC;
            HasC -[!want_c && 10ms/HasC]-> PassC -[A::HasA.X]-> WaitC;
        }
    }
}
