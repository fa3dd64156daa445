//! Random conditions: each verdict is that of all valuations.

use crate::ask;

/// A condition of a random chart: its text, and its value under a valuation.
enum Random {
    Name(usize),
    Compare(usize, &'static str, i64),
    /// `level` with `other`, or the other way round.
    Order(usize, &'static str),
    Not(Box<Random>),
    Pair(&'static str, Box<Random>, Box<Random>),
}

/// Values of `a`, `b`, `c` and of `level`, `other`.
type Valuation = ([bool; 3], [i64; 2]);

impl Random {
    fn make(random: &mut u64, depth: u32) -> Self {
        let mut draw = |below: u64| {
            *random ^= *random << 13;
            *random ^= *random >> 7;
            *random ^= *random << 17;
            usize::try_from(*random % below).unwrap_or_default()
        };
        let operators = ["<", "<=", ">", ">=", "==", "!="];
        match draw(if depth == 0 { 3 } else { 7 }) {
            0 => Self::Name(draw(3)),
            1 => Self::Compare(draw(2), operators[draw(6)], [0, 1, 2, 3, 4, 65_534, 65_535][draw(7)]),
            2 => Self::Order(draw(2), operators[draw(6)]),
            3 => Self::Not(Box::new(Self::make(random, depth - 1))),
            _ => {
                let operator = ["&&", "||", "^", "=="][draw(4)];
                Self::Pair(operator, Box::new(Self::make(random, depth - 1)), Box::new(Self::make(random, depth - 1)))
            }
        }
    }

    fn text(&self) -> String {
        match self {
            Self::Name(index) => ["a", "b", "c"][*index].to_owned(),
            Self::Compare(index, operator, value) => format!("{} {operator} {value}", ["level", "other"][*index]),
            Self::Order(first, operator) => {
                format!("{} {operator} {}", ["level", "other"][*first], ["level", "other"][1 - *first])
            }
            Self::Not(inner) => format!("!({})", inner.text()),
            Self::Pair(operator, a, b) => format!("(({}) {operator} ({}))", a.text(), b.text()),
        }
    }

    fn holds(&self, valuation: &Valuation) -> bool {
        match self {
            Self::Name(index) => valuation.0[*index],
            Self::Compare(index, operator, value) => compare(valuation.1[*index], operator, *value),
            Self::Order(first, operator) => compare(valuation.1[*first], operator, valuation.1[1 - *first]),
            Self::Not(inner) => !inner.holds(valuation),
            Self::Pair(operator, a, b) => match (*operator, a.holds(valuation), b.holds(valuation)) {
                ("&&", a, b) => a && b,
                ("||", a, b) => a || b,
                ("^", a, b) => a != b,
                (_, a, b) => a == b,
            },
        }
    }
}

fn compare(left: i64, operator: &str, right: i64) -> bool {
    match operator {
        "<" => left < right,
        "<=" => left <= right,
        ">" => left > right,
        ">=" => left >= right,
        "==" => left == right,
        _ => left != right,
    }
}

#[test]
fn verdicts_equal_those_of_all_valuations() {
    // The values at the limits of the type, and enough between the constants.
    let value = |number: i64| if number < 7 { number } else { 65_524 + number };
    let bits = (0..8).map(|bits| [bits & 1 == 1, bits & 2 == 2, bits & 4 == 4]);
    let valuations: Vec<Valuation> =
        bits.flat_map(|bits| (0..144).map(move |number| (bits, [value(number % 12), value(number / 12)]))).collect();
    let mut random = 0x9E37_79B9_7F4A_7C15;
    for round in 0..600 {
        let all: Vec<Random> = (0..3).map(|_| Random::make(&mut random, round % 4)).collect();
        let texts: Vec<String> = all.iter().map(Random::text).collect();
        let holds = |wanted: &dyn Fn(&Valuation) -> bool| valuations.iter().any(wanted);
        let expected = [
            !holds(&|v| all[0].holds(v)),
            !holds(&|v| !all[0].holds(v)),
            !holds(&|v| all[0].holds(v) && all[1].holds(v)),
            !holds(&|v| all[0].holds(v) && !all[1].holds(v) && !all[2].holds(v)),
            !holds(&|v| all[0].holds(v) != all[1].holds(v)),
        ];
        let names: Vec<&str> = texts.iter().map(String::as_str).collect();
        let [first, second, third] = names[..] else { unreachable!() };
        let found = ask(&names, &[], |logic, all| {
            [
                logic.never(&all[0]),
                logic.always(&all[0]),
                logic.exclusive(&all[0], &all[1]),
                logic.implies(&all[0], &[&all[1], &all[2]]),
                logic.equivalent(&all[0], &all[1]),
            ]
        });
        assert_eq!(found, expected, "{names:?}");
        // An assumption that leaves no valuation at all is no reason to call everything proved.
        if holds(&|v| !all[2].holds(v)) {
            let assumed = ask(&[first, second], &[third], |logic, all| logic.implies(&all[0], &[&all[1]]));
            assert_eq!(assumed, expected[3], "{names:?}");
        }
    }
}
