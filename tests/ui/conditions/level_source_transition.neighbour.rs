use grafcet::grafcet;

grafcet! {
    grafcet Belt {
        input part, gone: bool;
        output belt: bool;

        step Moving { belt; }

        () -[rising(part)]-> Moving -[gone]-> ();
    }
}

grafcet! {
    grafcet Either {
        input part, manual, gone: bool;
        output belt: bool;

        step Moving { belt; }

        () -[(rising(part) || falling(manual)) && !gone]-> Moving -[gone]-> ();
    }
}

fn main() {}
