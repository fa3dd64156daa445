//! What is said of a condition repeats it as a person would write it.
use grafcet::grafcet;

grafcet! {
    sfc Balance {
        input level: i8;
        output left, right: bool;

        initial step Even;
        step Left { left; }
        step Right { right; }

        Even -[level > -3 && level + -1 < -5 - 2]-> Left -[level - -2 > -(1)]-> Even;
        Even -[level > 3]-> Right -[level * -1 > -2]-> Even;
    }
}

fn main() {}
