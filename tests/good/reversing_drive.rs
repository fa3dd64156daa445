use grafcet::grafcet;

grafcet! {
    /// A drive with a pause between the directions and an assumption-free interlock of the buttons.
    pub sfc ReversingDrive {
        input left, right, stop: bool;
        output run_left, run_right: bool;

        initial step Stop;
        step Left { N run_left; }
        step Right { N run_right; }
        step PauseToRight;
        step PauseToLeft;

        Stop -[left && !right && !stop]-> Left;
        Stop -[right && !left && !stop]-> Right;
        Left -[stop]-> Stop;
        Left -[right]-> PauseToRight -[stop]-> Stop;
        PauseToRight -[500ms/PauseToRight]-> Right;
        Right -[stop]-> Stop;
        Right -[left]-> PauseToLeft -[stop]-> Stop;
        PauseToLeft -[500ms/PauseToLeft]-> Left;
    }
}
