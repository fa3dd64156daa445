use grafcet::grafcet;

grafcet! {
    /// Two tools are changed one after the other, each by a macro-step of its own; a third holds another inside.
    pub grafcet MacroSteps {
        input go, out1, in1, out2, in2, locked, probed: bool;
        output open1, open2, lock, probe, ready: bool;

        initial step Idle { ready; }
        macro step First {
            entry step Open1 { open1; }
            exit step Set1;
            Open1 -[out1]-> Wait1 -[in1]-> Set1;
            step Wait1 { open1; }
        }
        macro step Second {
            entry step Open2 { open2; }
            step Wait2 { open2; }
            exit step Set2;
            Open2 -[out2]-> Wait2 -[in2]-> Set2;
        }
        macro step Prove {
            entry step Settle;
            macro step Probe {
                entry step Touch { probe; }
                exit step Lift;
                Touch -[probed]-> Lift;
            }
            exit step Proved { lock; }
            Settle -[100ms/Settle]-> Probe -[!probed]-> Proved;
        }

        Idle -[rising(go)]-> First -[!out1]-> Second -[!out2]-> Prove -[locked]-> Idle;
    }
}
