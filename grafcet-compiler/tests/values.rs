//! Numbers that are compared with each other: what is said about random charts equals what happens under all values.

mod judged;

use judged::names;

struct Random(u64);

impl Random {
    fn below(&mut self, bound: u64) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        usize::try_from(self.0 % bound).unwrap_or_default()
    }
}

/// Names of values.
const NAMES: [&str; 3] = ["lv", "lw", "lx"];

/// What they can be: enough around the constants and at the limits.
const VALUES: [i32; 9] = [0, 1, 2, 3, 4, 5, 253, 254, 255];

const CONSTANTS: [i32; 6] = [0, 1, 2, 3, 254, 255];

#[derive(Clone, Copy)]
enum Side {
    Name(usize),
    Constant(i32),
}

impl Side {
    fn text(self) -> String {
        match self {
            Self::Name(index) => NAMES[index].to_owned(),
            Self::Constant(value) => value.to_string(),
        }
    }

    fn value(self, values: &[i32; 3]) -> i32 {
        match self {
            Self::Name(index) => values[index],
            Self::Constant(value) => value,
        }
    }
}

/// Comparisons that all hold.
struct All(Vec<(Side, &'static str, Side)>);

impl All {
    fn random(random: &mut Random, most: u64) -> Self {
        let one = |random: &mut Random| {
            let first = random.below(3);
            let second = match random.below(5) {
                0 | 1 => Side::Constant(CONSTANTS[random.below(6)]),
                _ => Side::Name((first + 1 + random.below(2)) % 3),
            };
            (Side::Name(first), ["<", "<=", ">", ">=", "==", "!="][random.below(6)], second)
        };
        let count = 1 + random.below(most);
        Self((0..count).map(|_| one(random)).collect())
    }

    fn text(&self) -> String {
        let texts: Vec<String> =
            self.0.iter().map(|(a, sign, b)| format!("{} {sign} {}", a.text(), b.text())).collect();
        texts.join(" && ")
    }

    fn holds(&self, values: &[i32; 3]) -> bool {
        self.0.iter().all(|(a, sign, b)| {
            let (a, b) = (a.value(values), b.value(values));
            match *sign {
                "<" => a < b,
                "<=" => a <= b,
                ">" => a > b,
                ">=" => a >= b,
                "==" => a == b,
                _ => a != b,
            }
        })
    }
}

/// All values that count.
fn valuations(never: &All) -> Vec<[i32; 3]> {
    let all = VALUES.iter().flat_map(|a| VALUES.iter().flat_map(|b| VALUES.iter().map(|c| [*a, *b, *c])));
    all.filter(|values| !never.holds(values)).collect()
}

/// A ring of three steps: which situations can be reached, and from which of them the first.
#[test]
fn properties_equal_those_under_all_values() {
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    let (mut proved, mut violated) = (0, 0);
    for _ in 0..1500 {
        let conditions: Vec<All> = (0..3).map(|_| All::random(&mut random, 3)).collect();
        let (assumed, watched) = (All::random(&mut random, 2), All::random(&mut random, 3));
        let valuations = valuations(&assumed);
        if valuations.is_empty() {
            continue;
        }
        let clears: Vec<bool> = conditions.iter().map(|c| valuations.iter().any(|values| c.holds(values))).collect();
        let far = clears.iter().position(|clears| !clears);
        let reached = far.map_or(2, |far| far);
        // The step in which a value is looked at: as it is entered.
        let at = random.below(3);
        let enters = |values: &&[i32; 3]| at == 0 || conditions[at - 1].holds(values) || !conditions[at].holds(values);
        let seen = at <= reached && valuations.iter().filter(enters).any(|values| watched.holds(values));
        let text: Vec<String> = conditions.iter().map(All::text).collect();
        let shared = format!(
            "sfc C {{ #![allow(grafcet::never_true, grafcet::always_true, grafcet::dead_transition, grafcet::deadlock, \
             grafcet::unreachable_step)] input lv, lw, lx: u8; output q, r: bool; assume never {}; \
             initial step A; step B {{ N q; }} step C {{ N r; }} A -[{}]-> B -[{}]-> C -[{}]-> A;",
            assumed.text(),
            text[0],
            text[1],
            text[2]
        );
        let step = ["A", "B", "C"][at];
        let chart = format!("{shared} never {step}.X && {}; }}", watched.text());
        let found = names(&chart);
        let rules = ["property_violated", "property_undecided"];
        let about: Vec<&&str> = found.iter().filter(|rule| rules.contains(rule)).collect();
        let expected: &[&&str] = if seen { &[&"property_violated"] } else { &[] };
        assert_eq!(about, expected, "{chart}\n{found:?}");
        *(if seen { &mut violated } else { &mut proved }) += 1;
        let chart = format!("{shared} home A; }}");
        let found = names(&chart);
        assert_eq!(
            found.contains(&"not_home"),
            reached < 2 && reached > 0 || clears == [true, true, false],
            "{chart}\n{found:?}"
        );
        assert!(!found.contains(&"property_undecided"), "{chart}");
    }
    assert!(proved > 300 && violated > 300, "{proved}, {violated}");
}
