use grafcet::grafcet;

grafcet! {
    sfc Hoist {
        input up, down, top, bottom: bool;
        output raise, lower, brake: bool;

        initial step Wait { N brake; }
        step Up { S raise; }
        step Down { N lower; }
        step Stop { R raise; N brake; }

        Wait -[up]-> Up;
        Wait -[down]-> Down -[bottom || !down]-> Stop;
        Up -[top || !up]-> Stop -[!up && !down]-> Wait;
        
        never raise && lower;
        always raise || lower => !brake;
        home Wait;
    }
}

grafcet! {
    grafcet Doors {
        input inner, outer: bool;
        output open_inner, open_outer: bool;

        // The one who is inside has to wait.
        assume never inner && outer;

        partial Inside {
            initial step Shut;
            step Open { open_inner; }
            Shut -[inner && Locked.X]-> Open -[!inner]-> Shut;
        }
        partial Outside {
            initial step Locked;
            step Free { open_outer; }
            Locked -[outer && Shut.X]-> Free -[!outer]-> Locked;
        }

        never open_inner && open_outer;
    }
}

fn main() {}
