use grafcet::grafcet;

grafcet! {
    sfc Sorter {
        input part: bool;
        input size: u16;
        output left, right: bool;

        initial step Wait;
        step Left { N left; }
        step Right { N right; }

        Wait -[part && size > 40]-> Right -[!part]-> Wait;
        Wait -[part]-> Left -[!part]-> Wait;
    }
}

fn main() {}
