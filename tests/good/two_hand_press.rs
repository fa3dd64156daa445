use grafcet::grafcet;

grafcet! {
    /// Both hands within half a second; who lets go stops the press.
    pub sfc TwoHandPress {
        input left, right, bottom, top: bool;
        output down, up: bool;

        initial step Wait;
        step OneHand;
        step Tied;
        step Press { N down; }
        step Back { N up; }

        Wait -[left && right]-> Press;
        Wait -[left || right]-> OneHand;
        OneHand -[left && right]-> Press;
        OneHand -[!left && !right]-> Wait;
        OneHand -[500ms/OneHand]-> Tied -[!left && !right]-> Wait;
        Press -[bottom || !left || !right]-> Back -[top]-> Tied;
    }
}
