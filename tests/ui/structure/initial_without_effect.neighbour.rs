use grafcet::grafcet;

grafcet! {
    grafcet Cell {
        #![deny(grafcet::initial_without_effect)]
        input auto, part: bool;

        initial step Manual;
        enclosing step Auto {
            partial Counting {
                linked step Wait;
                step Count;
                Wait -[part]-> Count -[!part]-> Wait;
            }
        }

        Manual -[auto]-> Auto -[!auto]-> Manual;
    }
}

fn main() {}
