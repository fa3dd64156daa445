use grafcet::grafcet;

grafcet! {
    sfc Belt {
        input part, gone: bool;
        output belt: bool;

        initial step Empty;
        step Moving { N belt; }
        final step Broken;

        Empty -[part]-> Moving -[gone]-> Empty;
        Moving -[!part]-> Broken;
    }
}

fn main() {}
