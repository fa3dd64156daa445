use grafcet::grafcet;

grafcet! {
    sfc Press {
        input closed, released: bool;
        output ram: bool;

        initial step Up;
        step Armed;
        step Down { N ram; }

        Up -[closed]-> Armed -[!released]-> Down -[released]-> Up;
    }
}

fn main() {}
