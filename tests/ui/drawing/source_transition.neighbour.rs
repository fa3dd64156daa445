use grafcet::grafcet;

grafcet! {
    sfc Belt {
        input part, gone: bool;
        output belt: bool;

        initial step Empty;
        step Moving { N belt; }

        Empty -[part]-> Moving -[gone]-> Empty;
        Empty -[!part && gone]-> Moving;
    }
}

fn main() {}
