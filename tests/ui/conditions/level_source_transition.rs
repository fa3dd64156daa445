use grafcet::grafcet;

grafcet! {
    grafcet Belt {
        input part, gone: bool;
        output belt: bool;

        step Moving { belt; }

        () -[part]-> Moving -[gone]-> ();
    }
}

// An edge is no event where a level does, too.
grafcet! {
    grafcet Either {
        input part, manual, gone: bool;
        output belt: bool;

        step Moving { belt; }

        () -[rising(part) || manual]-> Moving -[gone]-> ();
    }
}

fn main() {}
