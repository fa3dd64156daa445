use grafcet::grafcet;

grafcet! {
    /// Parts are told apart by a code and pushed out at one of three gates; the rest runs through.
    pub grafcet SortingLine {
        input part, read, at1, at2, at3, end: bool;
        input code: u8;
        output belt, push1, push2, push3: bool;

        initial step Wait;
        step Read;
        step To1 { belt; }
        step To2 { belt; }
        step To3 { belt; }
        step Through { belt; }
        step Push1 { push1; }
        step Push2 { push2; }
        step Push3 { push3; }

        Wait -[rising(part)]-> Read;
        Read -[read && code == 1]-> To1 -[at1]-> Push1 -[300ms/Push1]-> Wait;
        Read -[read && code == 2]-> To2 -[at2]-> Push2 -[300ms/Push2]-> Wait;
        Read -[read && code >= 3 && code < 10]-> To3 -[at3]-> Push3 -[300ms/Push3]-> Wait;
        Read -[read && (code == 0 || code >= 10)]-> Through -[end]-> Wait;
    }
}
