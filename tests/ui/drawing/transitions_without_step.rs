use grafcet::grafcet;

grafcet! {
    sfc Press {
        input closed, released: bool;
        output ram: bool;

        initial step Up;
        step Down { N ram; }

        Up -[closed]-[!released]-> Down -[released]-> Up;
    }
}

fn main() {}
