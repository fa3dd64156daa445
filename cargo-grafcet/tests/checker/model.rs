//! A small checker: it reads AIGER and BTOR2 as their papers say, goes through all states, and writes witnesses. It knows nothing of charts.

use std::collections::{BTreeMap, VecDeque};
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

/// A circuit by the numbers of AIGER: a literal is twice its variable, and one more where it is negated.
pub(crate) struct Model {
    inputs: Vec<usize>,
    /// Now, next, and what it begins with.
    latches: Vec<(usize, usize, bool)>,
    ands: Vec<(usize, usize, usize)>,
    constraints: Vec<usize>,
    bad: usize,
    /// How witnesses are written.
    is_btor2: bool,
}

type State = Vec<bool>;

pub(crate) fn read(file: &Path) -> Model {
    let bytes = fs::read(file).expect("a question");
    match file.extension().and_then(|end| end.to_str()) {
        Some("btor2") => btor2(&String::from_utf8(bytes).expect("text")),
        _ => aiger(&bytes),
    }
}

/// The bytes of a file that are still to come.
struct Rest<'b>(&'b [u8]);

impl Rest<'_> {
    fn line(&mut self) -> Vec<usize> {
        let end = self.0.iter().position(|byte| *byte == b'\n').expect("a line");
        let line = std::str::from_utf8(&self.0[..end]).expect("text");
        let numbers = line.split(' ').filter_map(|word| word.parse().ok()).collect();
        self.0 = &self.0[end + 1..];
        numbers
    }

    fn number(&mut self) -> usize {
        let (mut number, mut shift) = (0, 0);
        loop {
            let byte = self.0[0];
            self.0 = &self.0[1..];
            number |= usize::from(byte & 0x7f) << shift;
            shift += 7;
            if byte < 0x80 {
                return number;
            }
        }
    }
}

fn aiger(bytes: &[u8]) -> Model {
    let (is_text, mut rest) = (bytes.starts_with(b"aag "), Rest(bytes));
    let header = rest.line();
    let [most, inputs, latches, outputs, ands, bads] = header[..6] else { panic!("{header:?}") };
    let constraints = header.get(6).copied().unwrap_or(0);
    assert_eq!((outputs, bads, most), (0, 1, inputs + latches + ands), "{header:?}");
    let of_inputs = (1..=inputs).map(|number| if is_text { rest.line()[0] } else { number * 2 }).collect();
    let mut of_latches = Vec::new();
    for number in 0..latches {
        let line = rest.line();
        let (now, line) = if is_text { (line[0], &line[1..]) } else { ((inputs + number + 1) * 2, &line[..]) };
        of_latches.push((now, line[0], line.get(1) == Some(&1)));
    }
    let bad = rest.line()[0];
    let constraints = (0..constraints).map(|_| rest.line()[0]).collect();
    let mut of_ands = Vec::new();
    for number in 0..ands {
        let gate = (inputs + latches + number + 1) * 2;
        of_ands.push(if is_text {
            let line = rest.line();
            (line[0], line[1], line[2])
        } else {
            let high = gate - rest.number();
            (gate, high, high - rest.number())
        });
    }
    Model { inputs: of_inputs, latches: of_latches, ands: of_ands, constraints, bad, is_btor2: false }
}

fn btor2(text: &str) -> Model {
    let mut model = Model {
        inputs: Vec::new(),
        latches: Vec::new(),
        ands: Vec::new(),
        constraints: Vec::new(),
        bad: 0,
        is_btor2: true,
    };
    // The literal of a line, which may be negated.
    let mut of: BTreeMap<i64, usize> = BTreeMap::new();
    let lit = |of: &BTreeMap<i64, usize>, word: &str| {
        let number: i64 = word.parse().expect("a number");
        of[&number.abs()] ^ usize::from(number < 0)
    };
    for line in text.lines() {
        let words: Vec<&str> = line.split(' ').collect();
        let number: i64 = words[0].parse().expect("a number");
        let fresh = (of.len() + 1) * 2;
        match words[1] {
            "sort" => assert_eq!(&words[2..], ["bitvec", "1"]),
            "zero" => _ = of.insert(number, 0),
            "one" => _ = of.insert(number, 1),
            "input" => {
                of.insert(number, fresh);
                model.inputs.push(fresh);
            }
            "state" => {
                of.insert(number, fresh);
                model.latches.push((fresh, fresh, false));
            }
            "and" => {
                model.ands.push((fresh, lit(&of, words[3]), lit(&of, words[4])));
                of.insert(number, fresh);
            }
            kind @ ("init" | "next") => {
                let (state, value) = (lit(&of, words[3]), lit(&of, words[4]));
                let latch = model.latches.iter_mut().find(|latch| latch.0 == state).expect("a state");
                if kind == "init" { latch.2 = value == 1 } else { latch.1 = value }
            }
            "constraint" => model.constraints.push(lit(&of, words[2])),
            "bad" => model.bad = lit(&of, words[2]),
            other => panic!("{other}"),
        }
    }
    model
}

impl Model {
    pub(crate) fn inputs(&self) -> usize {
        self.inputs.len()
    }

    /// The next state, and whether it is bad; none where a constraint does not hold.
    fn step(&self, state: &State, given: &[bool]) -> Option<(State, bool)> {
        let latches = self.latches.iter().map(|latch| latch.0);
        let mut values: BTreeMap<usize, bool> = self.inputs.iter().copied().zip(given.iter().copied()).collect();
        values.extend(latches.zip(state.iter().copied()));
        values.insert(0, false);
        let value = |values: &BTreeMap<usize, bool>, lit: usize| values[&(lit & !1)] ^ (lit & 1 == 1);
        for (gate, one, other) in &self.ands {
            let both = value(&values, *one) && value(&values, *other);
            values.insert(*gate, both);
        }
        let holds = self.constraints.iter().all(|lit| value(&values, *lit));
        let next = self.latches.iter().map(|latch| value(&values, latch.1)).collect();
        holds.then(|| (next, value(&values, self.bad)))
    }

    /// All states by breadth, so what is found first is shortest.
    pub(crate) fn check(&self) -> String {
        let first: State = self.latches.iter().map(|latch| latch.2).collect();
        let (mut before, mut open) = (BTreeMap::new(), VecDeque::from([first.clone()]));
        before.insert(first, None);
        while let Some(state) = open.pop_front() {
            for number in 0..1_usize << self.inputs.len() {
                let given: Vec<bool> = (0..self.inputs.len()).map(|bit| number >> bit & 1 == 1).collect();
                let Some((next, bad)) = self.step(&state, &given) else { continue };
                if bad {
                    return self.witness(&Self::way(&before, &state, given));
                }
                if !before.contains_key(&next) {
                    before.insert(next.clone(), Some((state.clone(), given)));
                    open.push_back(next);
                }
            }
        }
        if self.is_btor2 { "unsat\n".to_owned() } else { "0\nb0\n.\n".to_owned() }
    }

    fn way(before: &BTreeMap<State, Option<(State, Vec<bool>)>>, last: &State, given: Vec<bool>) -> Vec<Vec<bool>> {
        let (mut way, mut at) = (vec![given], last);
        while let Some((state, given)) = &before[at] {
            way.push(given.clone());
            at = state;
        }
        way.reverse();
        way
    }

    pub(crate) fn witness(&self, way: &[Vec<bool>]) -> String {
        let digits = |values: &mut dyn Iterator<Item = bool>| -> String {
            values.map(|value| if value { '1' } else { '0' }).collect()
        };
        if !self.is_btor2 {
            let mut text = format!("1\nb0\n{}\n", digits(&mut self.latches.iter().map(|latch| latch.2)));
            for given in way {
                _ = writeln!(text, "{}", digits(&mut given.iter().copied()));
            }
            return text + ".\n";
        }
        let mut text = "sat\nb0 \n#0\n".to_owned();
        for (cycle, given) in way.iter().enumerate() {
            _ = writeln!(text, "@{cycle}");
            for (input, value) in given.iter().enumerate() {
                _ = writeln!(text, "{input} {} in{input}@{cycle}", u8::from(*value));
            }
        }
        text + ".\n"
    }
}
