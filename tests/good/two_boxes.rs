use grafcet::grafcet;

grafcet! {
    /// A gripper over two boxes; a part that was not gripped is tried again.
    pub sfc PickAndPlace {
        input part, left, right, up, down, gripped, good: bool;
        output go_left, go_right, lower, suck, blow: bool;

        initial step Reference { N go_left; R suck; }
        step Wait;
        step LowerToPart { N lower; }
        step Grip { S suck; }
        step Raise;
        step ToGood { N go_right; }
        step ToScrap { N go_right; }
        step LowerToBox { N lower; }
        step Release { R suck; P blow; }
        step RaiseEmpty;
        step Return { N go_left; }
        step Drop { R suck; }

        Reference -[left && up]-> Wait -[part]-> LowerToPart -[down]-> Grip -[gripped || 1s/Grip]-> Raise;
        Raise -[up && !gripped]-> Drop -[200ms/Drop]-> Wait;
        Raise -[up && good]-> ToGood -[right]-> LowerToBox;
        Raise -[up]-> ToScrap -[800ms/ToScrap]-> LowerToBox;
        LowerToBox -[down]-> Release -[!gripped]-> RaiseEmpty -[up]-> Return -[left]-> Wait;
    }
}
