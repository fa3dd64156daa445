//! Arithmetic in conditions: what is said about random charts beside what happens under all values, in a program that panics
//! where a result does not fit into its type, and in one that goes on.

mod judged;

use judged::said;

/// The chart is right.
fn holds(chart: &str) {
    assert_eq!(said(chart), Vec::<String>::new(), "{chart}");
}

/// Something is said by this rule, in which this stands.
fn fails(chart: &str, rule: &str, word: &str) {
    let said = said(chart);
    assert!(said.iter().any(|one| one.starts_with(rule) && one.contains(word)), "{chart}: {said:#?}");
}

/// From `B` there is one way back.
fn back(condition: &str) -> String {
    format!(
        "sfc Chart {{ #![allow(grafcet::unused_input, grafcet::unused_param, grafcet::never_true, grafcet::dead_transition, grafcet::deadlock)] input go: bool; input lv, lw: u8; input big: u32; input sg: i16; \
         input n: usize; input x: f32; param hi: u8 = 9; initial step A; step B; A -[go]-> B; B -[{condition}]-> A; home A; }}"
    )
}

#[test]
fn a_way_home_needs_values() {
    for condition in [
        "lv * 2 == 6",
        "lv + lw > 8 && lv < 5 && lw < 6",
        "lv.wrapping_mul(2) == 6 && lv > 3",
        "lv as u16 * 4 > 1019",
        "u16::from(lv) + u16::from(lw) == 510",
        "big % 10 == 3 && big / 10 == 2 && big & 1 == 1",
        "big & 0x30 == 0x10 && big & 0x10 != 0",
        "sg.abs() > 5 && sg < 5",
        "big & 0x8000_0000 != 0 && big & 0xF == 5 && big >> 8 & 1 == 1",
        "(big | 0xFF) == 0x1FF && big & 0x10 == 0 && big ^ 3 == 0x100",
        "rising(lv * 2 == 6) && lv < 4",
        "lv.saturating_sub(lw) > 3 && lw.abs_diff(lv) < 5",
        "hi - 1 > lv && lv > 3",
        "lv > 0 && 100 / lv > 30",
        "big * big == 81 && big > 8",
        "lv - lw == 1 && lw << 1 == 4",
        "n - 5 > 7 && n < 14",
        "(go as u8) + lv == 1 && lv == 0",
    ] {
        holds(&back(condition));
    }
    for condition in [
        "lv < 1 && lv * 2 > 5",
        "lv * 2 == 5",
        "lv + lw > 8 && lv < 4 && lw < 6",
        "lv as u16 > 300",
        "(lv as u16) * 4 > 1019 && lv < 255",
        "big % 10 == 3 && big / 10 == 2 && big & 1 == 0",
        "big & 0x10 != 0 && big & 0x30 == 0",
        "big & 1 == 1 && big & 3 == 2",
        "(big << 4) & 0xF != 0 || (big >> 4) & 0xF000_0000 != 0",
        "rising(lv * 2 == 5)",
        "lv >= lw && lv - lw > 200 && lv < 150",
        "sg.abs() == 5 && sg > 5",
        "lv.min(3) > 3",
        "lv.clamp(3, 5) == 6",
        "lv.saturating_add(lw) < lv",
        "lv >> 3 == 31 && lv < 248",
        "(go as u8) + lv == 1 && lv == 1 && go",
    ] {
        fails(&back(condition), "not_home", "no way back");
    }
    // Only where a result does not fit into its type, or nobody knows.
    for (condition, word) in [
        ("lv * 2 == 6 && lv > 3", "`lv * 2`"),
        ("sg.abs() < 5 && sg < -5", "`sg.abs()`"),
        ("lv - 1 > 250 && lv < 200", "`lv - 1`"),
        ("lv.ilog2() > 20", "`lv.ilog2()`"),
        ("lv << lw == 4 && lw > 1", "`lv << lw`"),
        ("rising(lv * 2 == 6) && lv > 4", "`lv * 2`"),
        ("x * 2.0 > 3.0 && x < 1.0", "`x * 2.0`"),
        ("lv / (lw - lw) > 3", "`lv / (lw - lw)`"),
        ("n + 5 > 5_000_000_000", "`n + 5`"),
    ] {
        fails(&back(condition), "property_undecided", word);
    }
}

/// A variable that is not followed, with inputs that cannot be chosen whatever it is.
#[test]
fn what_is_tied_to_a_variable_cannot_be_chosen() {
    let chart = |ways: &str| {
        format!(
            "sfc Chart {{ input lv, new: u8; var c: u8; initial step A; step B {{ P1 c = new; }} A -[lv > 3]-> B; {ways} home A; }}"
        )
    };
    for ways in [
        "B -[lv < 3 && c > lv]-> A; B -[lv > 100 && c <= lv]-> A;",
        "B -[lv < 3 && c + lv > 5]-> A; B -[lv > 100 && c + lv <= 5]-> A;",
        "B -[lv < 3 && near(c, lv)]-> A; B -[lv > 100 && !near(c, lv)]-> A;",
    ] {
        let pure = if ways.contains("near") { "assume pure near;" } else { "" };
        fails(&chart(&format!("{pure} {ways}")), "property_undecided", "c");
    }
    holds(&chart("B -[c > lv]-> A; B -[c <= lv]-> A;"));
}

#[test]
fn two_floats() {
    let chart = |rest: &str| {
        format!(
            "sfc Heater {{ #![allow(grafcet::unused_input, grafcet::never_true, grafcet::dead_transition, grafcet::deadlock)] input t, u: f32; input p, hi, lo: f64; \
             output heat, cool: bool; initial step Rest; step Heat {{ N heat; }} step Cool {{ N cool; }} \
             Rest -[p < lo]-> Cool -[p >= lo]-> Rest; {rest} }}"
        )
    };
    let ring = "Rest -[p > hi]-> Heat -[p <= hi]-> Rest;";
    holds(&chart(&format!(
        "{ring} home Rest; never heat && cool; assume never lo > hi; never Rest.X && p > hi && p < lo;"
    )));
    fails(&chart(&format!("{ring} never Rest.X && p > hi && p < lo;")), "property_violated", "p > hi");
    // Which is no number is neither.
    fails(
        &chart(&format!("{ring} assume never lo > hi; always Rest.X => p <= hi || p > hi;")),
        "property_violated",
        "",
    );
    holds(&chart("Rest -[t > u && u > 3.0 && t > 3.5]-> Heat -[t < u]-> Rest; home Rest;"));
    fails(&chart("Rest -[t > u && u > 3.0]-> Heat -[t < u && u < 2.0 && t > 2.0]-> Rest; home Rest;"), "not_home", "");
    fails(&chart("Rest -[t > u]-> Heat -[t < t]-> Rest; home Rest;"), "not_home", "");
    holds(&chart("Rest -[t > u]-> Heat -[t != t && !(u < t) && u > 3.0]-> Rest; home Rest;"));
}

struct Random(u64);

impl Random {
    fn below(&mut self, bound: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        usize::try_from(self.0 % bound as u64).unwrap_or_default()
    }

    fn of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len())]
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Ty {
    U8,
    I8,
    U16,
    I16,
}

impl Ty {
    fn name(self) -> &'static str {
        match self {
            Self::U8 => "u8",
            Self::I8 => "i8",
            Self::U16 => "u16",
            Self::I16 => "i16",
        }
    }

    fn limits(self) -> (i64, i64) {
        match self {
            Self::U8 => (0, 255),
            Self::I8 => (-128, 127),
            Self::U16 => (0, 65_535),
            Self::I16 => (-32_768, 32_767),
        }
    }

    fn is_signed(self) -> bool {
        self.limits().0 < 0
    }

    fn fits(self, value: i64) -> bool {
        (self.limits().0..=self.limits().1).contains(&value)
    }

    fn wrapped(self, value: i64) -> i64 {
        let (low, high) = self.limits();
        (value - low).rem_euclid(high - low + 1) + low
    }
}

/// An expression with its text and its type.
enum Expr {
    Name(usize, Ty),
    Constant(i64, Ty),
    Binary(&'static str, Box<Expr>, Box<Expr>),
    Method(&'static str, Box<Expr>, Option<Box<Expr>>),
    Unary(&'static str, Box<Expr>),
    As(Ty, Box<Expr>),
}

/// How a program is built: one that panics has no value then.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Build {
    Checked,
    Wrapping,
}

const NAMES: [&str; 2] = ["lv", "lw"];

impl Expr {
    /// What is computed of constants alone does not compile where it does not fit.
    fn random(random: &mut Random, names: &[Ty], ty: Ty, depth: usize) -> Self {
        let made = Self::any(random, names, ty, depth);
        if made.is_constant() { Self::constant(random, ty) } else { made }
    }

    fn is_constant(&self) -> bool {
        match self {
            Self::Name(..) => false,
            Self::Constant(..) => true,
            Self::As(_, a) | Self::Unary(_, a) | Self::Method(_, a, None) => a.is_constant(),
            Self::Binary(_, a, b) | Self::Method(_, a, Some(b)) => a.is_constant() && b.is_constant(),
        }
    }

    fn any(random: &mut Random, names: &[Ty], ty: Ty, depth: usize) -> Self {
        let own: Vec<usize> = (0..names.len()).filter(|name| names[*name] == ty).collect();
        let kind = random.below(if depth == 0 { 3 } else { 12 });
        let make = |random: &mut Random| Box::new(Self::random(random, names, ty, depth.saturating_sub(1)));
        match kind {
            0..=2 if !own.is_empty() => Self::Name(random.of(&own), ty),
            0..=2 if random.below(3) > 0 => {
                let name = random.below(names.len());
                Self::As(ty, Box::new(Self::Name(name, names[name])))
            }
            0..=2 => Self::constant(random, ty),
            3 => {
                let other = random.of(&[Ty::U8, Ty::I8, Ty::U16, Ty::I16]);
                Self::As(ty, Box::new(Self::random(random, names, other, depth - 1)))
            }
            4 => match random.below(if ty.is_signed() { 4 } else { 1 }) {
                0 => Self::Unary("!", make(random)),
                1 => Self::Unary("-", make(random)),
                2 => Self::Method("abs", make(random), None),
                _ => Self::Method("signum", make(random), None),
            },
            5 | 6 => {
                let methods = [
                    "wrapping_add",
                    "wrapping_sub",
                    "wrapping_mul",
                    "saturating_add",
                    "saturating_sub",
                    "saturating_mul",
                    "min",
                    "max",
                ];
                let other = if random.below(2) == 0 { make(random) } else { Box::new(Self::constant(random, ty)) };
                Self::Method(random.of(&methods), make(random), Some(other))
            }
            7 => {
                let by = Self::Constant(random.of(&[1, 2, 3, 5, 10, 100]), ty);
                let (operator, a) = (random.of(&["/", "%", "div_euclid", "rem_euclid"]), make(random));
                if operator.len() == 1 {
                    Self::Binary(operator, a, Box::new(by))
                } else {
                    Self::Method(operator, a, Some(Box::new(by)))
                }
            }
            8 => {
                let by = Self::Constant(random.of(&[1, 2, 3, 7]), ty);
                Self::Binary(random.of(&["<<", ">>"]), make(random), Box::new(by))
            }
            9 => {
                let mask = Self::Constant(random.of(&[1, 2, 6, 15, 64]), ty);
                Self::Binary(random.of(&["&", "|", "^"]), make(random), Box::new(mask))
            }
            _ => {
                let other = if random.below(2) == 0 { make(random) } else { Box::new(Self::constant(random, ty)) };
                Self::Binary(random.of(&["+", "-", "*"]), make(random), other)
            }
        }
    }

    fn constant(random: &mut Random, ty: Ty) -> Self {
        let (low, high) = ty.limits();
        Self::Constant(random.of(&[0, 1, 2, 3, 5, 10, 100, high, high - 1, low, low + 1]), ty)
    }

    fn ty(&self) -> Ty {
        match self {
            Self::Name(_, ty) | Self::Constant(_, ty) | Self::As(ty, _) => *ty,
            Self::Binary(_, a, _) | Self::Method(_, a, _) | Self::Unary(_, a) => a.ty(),
        }
    }

    /// In parentheses that are always right.
    fn text(&self) -> String {
        match self {
            Self::Name(name, _) => NAMES[*name].to_owned(),
            // What a method is called on has to have a type.
            Self::Constant(value, ty) if *value < 0 => format!("({value}{})", ty.name()),
            Self::Constant(value, ty) => format!("{value}{}", ty.name()),
            Self::Binary(operator, a, b) => format!("({} {operator} {})", a.text(), b.text()),
            Self::Method(name, a, None) => format!("{}.{name}()", a.text()),
            Self::Method(name, a, Some(b)) => format!("{}.{name}({})", a.text(), b.text()),
            Self::Unary(operator, a) => format!("({operator}{})", a.text()),
            Self::As(ty, a) => format!("({} as {})", a.text(), ty.name()),
        }
    }

    fn value(&self, values: &[i64], build: Build) -> Option<i64> {
        let ty = self.ty();
        let fit = |value: i64| match build {
            Build::Checked if !ty.fits(value) => None,
            _ => Some(ty.wrapped(value)),
        };
        match self {
            Self::Name(name, _) => Some(values[*name]),
            Self::Constant(value, _) => Some(*value),
            Self::As(ty, a) => Some(ty.wrapped(a.value(values, build)?)),
            Self::Unary("-", a) => fit(-a.value(values, build)?),
            Self::Unary(_, a) => Some(ty.wrapped(!a.value(values, build)?)),
            Self::Method("abs", a, _) => fit(a.value(values, build)?.abs()),
            Self::Method("signum", a, _) => Some(a.value(values, build)?.signum()),
            Self::Method(name, a, b) => {
                let (a, b) = (a.value(values, build)?, b.as_ref()?.value(values, build)?);
                let (low, high) = ty.limits();
                Some(match *name {
                    "wrapping_add" => ty.wrapped(a + b),
                    "wrapping_sub" => ty.wrapped(a - b),
                    "wrapping_mul" => ty.wrapped(a * b),
                    "saturating_add" => (a + b).clamp(low, high),
                    "saturating_sub" => (a - b).clamp(low, high),
                    "saturating_mul" => (a * b).clamp(low, high),
                    "min" => a.min(b),
                    "max" => a.max(b),
                    "div_euclid" => a.div_euclid(b),
                    _ => a.rem_euclid(b),
                })
            }
            Self::Binary(operator, a, b) => {
                let (a, b) = (a.value(values, build)?, b.value(values, build)?);
                match *operator {
                    "+" => fit(a + b),
                    "-" => fit(a - b),
                    "*" => fit(a * b),
                    "/" => Some(a / b),
                    "%" => Some(a % b),
                    "<<" => Some(ty.wrapped(a << b)),
                    ">>" => Some(a >> b),
                    "&" => Some(a & b),
                    "|" => Some(a | b),
                    _ => Some(a ^ b),
                }
            }
        }
    }
}

/// Comparisons that all hold, looked at one after the other.
struct All(Vec<(Expr, &'static str, Expr)>);

impl All {
    fn random(random: &mut Random, names: &[Ty], most: usize) -> Self {
        let count = 1 + random.below(most);
        let one = |random: &mut Random| {
            let ty =
                if random.below(3) > 0 { random.of(names) } else { random.of(&[Ty::U8, Ty::I8, Ty::U16, Ty::I16]) };
            let depth = random.below(3);
            let first = Expr::random(random, names, ty, depth);
            let second =
                if random.below(3) > 0 { Expr::constant(random, ty) } else { Expr::random(random, names, ty, 1) };
            (first, random.of(&["<", "<=", ">", ">=", "==", "!="]), second)
        };
        Self((0..count).map(|_| one(random)).collect())
    }

    fn text(&self) -> String {
        let texts: Vec<String> =
            self.0.iter().map(|(a, sign, b)| format!("({}) {sign} ({})", a.text(), b.text())).collect();
        texts.join(" && ")
    }

    /// One that is `said` is not run: what does not hold anyway asks for no result.
    fn holds(&self, values: &[i64], build: Build, said: bool) -> Option<bool> {
        let mut open = false;
        for (a, sign, b) in &self.0 {
            let (low, high) = a.ty().limits();
            let holds = match (a.value(values, build), b.value(values, build)) {
                (Some(a), Some(b)) => compare(a, sign, b),
                // No value of the type is beyond its end.
                (None, Some(b)) if !matches!(*sign, "==" | "!=") && compare(low, sign, b) == compare(high, sign, b) => {
                    compare(low, sign, b)
                }
                _ if !said => return None,
                _ => {
                    open = true;
                    continue;
                }
            };
            if !holds {
                return Some(false);
            }
        }
        (!open).then_some(true)
    }
}

fn compare(a: i64, sign: &str, b: i64) -> bool {
    match sign {
        "<" => a < b,
        "<=" => a <= b,
        ">" => a > b,
        ">=" => a >= b,
        "==" => a == b,
        _ => a != b,
    }
}

/// What happens under some values: the assumption, the three conditions, the property; none where the program panics.
type Case = [Option<bool>; 5];

fn cases(names: &[Ty], all: &[All; 5], build: Build) -> Vec<Case> {
    let range = |name: usize| names.get(name).map_or(0..=0, |ty| ty.limits().0..=ty.limits().1);
    let mut cases: Vec<Case> = Vec::new();
    for a in range(0) {
        for b in range(1) {
            let case = [0, 1, 2, 3, 4].map(|which: usize| all[which].holds(&[a, b], build, which % 4 == 0));
            if case[0] == Some(false) && !cases.contains(&case) {
                cases.push(case);
            }
        }
    }
    cases
}

/// A ring of three steps: how far it comes, and whether the property holds at the end of a cycle in the step `at`.
fn seen(cases: &[Case], at: usize) -> (usize, bool) {
    let far = (1..=3).position(|which| !cases.iter().any(|case| case[which] == Some(true))).unwrap_or(3);
    let enters = |case: &&Case| at > 0 && case[at] == Some(true) || at == 0 || case[at + 1] == Some(false);
    (far, at <= far && cases.iter().filter(enters).any(|case| case[4] == Some(true)))
}

#[test]
fn properties_are_sound_under_all_values() {
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    let (mut proved, mut violated, mut open, mut given_up) = (0, 0, 0, 0);
    for round in 0..400 {
        let count = if round % 10 == 0 { 2 } else { 1 };
        let names: Vec<Ty> = (0..count).map(|_| random.of(&[Ty::U8, Ty::I8])).collect();
        let all = [2, 3, 3, 3, 2].map(|most| All::random(&mut random, &names, most));
        let (checked, wrapping) = (cases(&names, &all, Build::Checked), cases(&names, &all, Build::Wrapping));
        if checked.is_empty() || wrapping.is_empty() {
            continue;
        }
        let at = random.below(3);
        let inputs: Vec<String> =
            names.iter().zip(NAMES).map(|(ty, name)| format!("input {name}: {};", ty.name())).collect();
        let shared = format!(
            "sfc Chart {{ #![allow(grafcet::never_true, grafcet::always_true, grafcet::dead_transition, grafcet::deadlock, \
             grafcet::unreachable_step, grafcet::unused_input)] {} \
             output q, r: bool; assume never {}; \
             initial step A; step B {{ N q; }} step C {{ N r; }} A -[{}]-> B -[{}]-> C -[{}]-> A;",
            inputs.join(" "),
            all[0].text(),
            all[1].text(),
            all[2].text(),
            all[3].text()
        );
        let chart = format!("{shared} never {}.X && {}; }}", ["A", "B", "C"][at], all[4].text());
        let found = said(&chart);
        let has = |rule: &str| found.iter().any(|one| one.starts_with(rule));
        assert!(!has("notation"), "{chart}\n{found:?}");
        let ((sure, certain), (far, possible)) = (seen(&checked, at), seen(&wrapping, at));
        match (has("property_violated"), has("property_undecided")) {
            (true, false) => assert!(certain, "{chart}\n{found:?}"),
            (false, false) => assert!(!possible, "{chart}\n{found:?}"),
            _ if certain == possible && sure == far => given_up += 1,
            _ => open += 1,
        }
        *(if certain { &mut violated } else { &mut proved }) += 1;
        let chart = format!("{shared} home A; }}");
        let found = said(&chart);
        let has = |rule: &str| found.iter().any(|one| one.starts_with(rule));
        match (has("not_home"), has("property_undecided")) {
            (true, false) => assert!(sure > 0 && far < 3, "{chart}\n{found:?}"),
            // Wherever it can come to, it can go on without a panic.
            (false, false) => {
                let leaves = |step: &usize| checked.iter().any(|case| case[*step + 1] == Some(true));
                assert!((1..=far.min(2)).all(|step| leaves(&step)), "{chart}\n{found:?}");
            }
            _ if sure == far => given_up += 1,
            _ => open += 1,
        }
    }
    assert!(proved > 150 && violated > 80 && given_up < 15, "{proved}, {violated}, {open}, {given_up}");
}
