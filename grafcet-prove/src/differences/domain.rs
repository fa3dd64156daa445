//! What is told apart: where a chart can be, the clocks that matter there, and what has been seen of them so far.

use grafcet_compiler::program::{Program, Role};

use crate::aig::{Lit, value};
use crate::circuit::{Circuit, Field, Source};
use crate::clocks::is_clock;
use crate::limit::Limit;
use crate::task::Task;

/// More pairs than these are not looked at.
const MOST: usize = 8_000;

/// So many cycles at random in a row, and so often from the beginning on.
const ROW: usize = 200;
const ROWS: usize = 40;

/// What has one of several values: the state of a region, or a bit. The first one has one value and is everywhere.
pub(super) struct Choice {
    pub(super) field: Option<Field>,
    /// What each value is called.
    pub(super) values: Vec<String>,
    /// The clocks that matter while it has one.
    clocks: Vec<usize>,
    is_state: bool,
}

/// One clock is ahead of another by so much at most; the one of number 0 always stands at zero.
#[derive(Clone, Copy)]
pub(super) struct Ahead {
    pub(super) clock: usize,
    pub(super) of: usize,
    /// None where it has been given up.
    pub(super) most: Option<i64>,
    /// How often it has grown.
    pub(super) grown: u32,
}

/// Two choices have these values.
pub(super) struct ChoicePair {
    pub(super) one: (usize, usize),
    pub(super) other: (usize, usize),
    /// It has been seen.
    pub(super) is_reached: bool,
    pub(super) ahead: Vec<Ahead>,
}

pub(super) struct Domain {
    pub(super) choices: Vec<Choice>,
    /// None for the one that always stands at zero.
    pub(super) clocks: Vec<Option<Field>>,
    pub(super) places: Vec<ChoicePair>,
    /// By two choices, the first one in front of the other: the number of their first place.
    first: Vec<Vec<usize>>,
}

/// The value of each choice and of each clock.
pub(super) struct Moment {
    choices: Vec<usize>,
    clocks: Vec<i64>,
}

impl Domain {
    /// None where it would be too much.
    pub(super) fn of(program: &Program<'_>, circuit: &Circuit, bad: Lit) -> Option<Self> {
        let relevant = Task::new(circuit, bad).latches;
        let begins = |field: &Field| {
            let latches = &circuit.latches[field.first..field.first + field.width];
            latches.iter().all(|latch| latch.initial.is_some())
        };
        let fields: Vec<&Field> = circuit
            .fields
            .iter()
            .filter(|field| relevant.binary_search(&field.first).is_ok() && begins(field))
            .collect();
        let everywhere = Choice { field: None, values: vec![String::new()], clocks: Vec::new(), is_state: true };
        let mut all = Self { choices: vec![everywhere], clocks: vec![None], places: Vec::new(), first: Vec::new() };
        let mut of_regions = Vec::new();
        for field in &fields {
            let is_deadline = circuit.deadlines.iter().any(|deadline| deadline.waits + 1 == field.first);
            if !is_deadline && !is_clock(program, circuit, field) {
                continue;
            }
            match field.place.map(|place| field.program(program).places[place.0].role) {
                Some(Role::Time(region) | Role::Phase { region, .. }) => {
                    of_regions.push((field.plant, region, all.clocks.len()));
                }
                // Those of properties and actions matter everywhere.
                _ => all.choices[0].clocks.push(all.clocks.len()),
            }
            all.clocks.push(Some((*field).clone()));
        }
        for field in fields {
            let place = field.place.map(|place| &field.program(program).places[place.0]);
            match place.map(|place| place.role) {
                Some(Role::State(region)) => {
                    let is_its = |(plant, of, _): &&(_, usize, _)| *plant == field.plant && *of == region;
                    let clocks = of_regions.iter().filter(is_its).map(|(.., clock)| *clock).collect();
                    let values = states(program, field, region);
                    all.choices.push(Choice { field: Some(field.clone()), values, clocks, is_state: true });
                }
                _ if field.width == 1 && field.name != "overflowed" => {
                    let values = vec![format!("not {}", field.name), field.name.clone()];
                    all.choices.push(Choice {
                        field: Some(field.clone()),
                        values,
                        clocks: Vec::new(),
                        is_state: false,
                    });
                }
                _ => {}
            }
        }
        (all.clocks.len() > 1 && all.pairs()).then_some(all)
    }

    /// The places; not where they are too many.
    fn pairs(&mut self) -> bool {
        for (index, one) in self.choices.iter().enumerate() {
            let mut first = Vec::new();
            for (number, other) in self.choices.iter().enumerate() {
                first.push(self.places.len());
                if number <= index {
                    continue;
                }
                for a in 0..one.values.len() {
                    for b in 0..other.values.len() {
                        let (one, other) = ((index, a), (number, b));
                        self.places.push(ChoicePair { one, other, is_reached: false, ahead: Vec::new() });
                    }
                }
                if self.places.len() > MOST {
                    return false;
                }
            }
            self.first.push(first);
        }
        true
    }

    fn place(&self, (one, a): (usize, usize), (other, b): (usize, usize)) -> usize {
        self.first[one][other] + a * self.choices[other].values.len() + b
    }

    /// It has never been seen, and neither says that of one of its two values alone.
    pub(super) fn is_news_that_never(&self, place: usize) -> bool {
        let (one, other) = (self.places[place].one, self.places[place].other);
        let is_reached = |value| self.places[self.place((0, 0), value)].is_reached;
        !self.places[place].is_reached && (one.0 == 0 || is_reached(one) && is_reached(other))
    }

    /// The places of which that is news, now that this one has been seen: those with its value, where it is one alone.
    pub(super) fn inside(&self, place: usize) -> Vec<usize> {
        let ChoicePair { one, other: value, .. } = self.places[place];
        if one.0 > 0 {
            return Vec::new();
        }
        let has = |number: &usize| [self.places[*number].one, self.places[*number].other].contains(&value);
        (0..self.places.len()).filter(|number| has(number) && self.is_news_that_never(*number)).collect()
    }

    /// What is compared in a place: the clocks of its steps and those that matter everywhere, each with the others and with zero.
    fn compared(&self, place: &ChoicePair) -> Vec<(usize, usize)> {
        let (one, other) = (&self.choices[place.one.0], &self.choices[place.other.0]);
        let mut pairs = Vec::new();
        if !one.is_state || !other.is_state {
            return pairs;
        }
        let own: Vec<usize> = one.clocks.iter().chain(&other.clocks).copied().collect();
        let everywhere = self.choices[0].clocks.iter().filter(|_| place.one.0 > 0);
        let all: Vec<usize> = [0].iter().chain(&own).chain(everywhere).copied().collect();
        for clock in &all {
            for of in &all {
                // Zero is ahead of none.
                if clock != of && *clock > 0 {
                    pairs.push((*clock, *of));
                }
            }
        }
        pairs
    }

    /// What is now known to happen.
    pub(super) fn absorb(&mut self, moment: &Moment) -> Grown {
        let mut grown = Grown::new();
        for one in 0..self.choices.len() {
            for other in one + 1..self.choices.len() {
                let number = self.place((one, moment.choices[one]), (other, moment.choices[other]));
                let before = |clock: usize, of: usize| moment.clocks[clock] - moment.clocks[of];
                if self.places[number].is_reached {
                    let mut which = Vec::new();
                    for (index, ahead) in self.places[number].ahead.iter_mut().enumerate() {
                        let now = before(ahead.clock, ahead.of);
                        if ahead.most.is_some_and(|most| most < now) {
                            ahead.most = Some(now);
                            which.push(index);
                        }
                    }
                    if !which.is_empty() {
                        grown.push((number, which));
                    }
                    continue;
                }
                let compared = self.compared(&self.places[number]);
                let ahead = compared.into_iter().map(|(clock, of)| Ahead {
                    clock,
                    of,
                    most: Some(before(clock, of)),
                    grown: 0,
                });
                let ahead: Vec<Ahead> = ahead.collect();
                let place = &mut self.places[number];
                (place.is_reached, place.ahead) = (true, ahead);
                grown.push((number, (0..place.ahead.len()).collect()));
            }
        }
        grown
    }

    /// Where a state is, by the values of the latches.
    pub(super) fn moment(&self, latch: &dyn Fn(usize) -> bool) -> Moment {
        let number =
            |field: &Field| -> i64 { (0..field.width).map(|bit| i64::from(latch(field.first + bit)) << bit).sum() };
        let value = |choice: &Choice| {
            let number = choice.field.as_ref().map_or(0, number);
            usize::try_from(number).unwrap_or(0)
        };
        Moment {
            choices: self.choices.iter().map(value).collect(),
            clocks: self.clocks.iter().map(|clock| clock.as_ref().map_or(0, number)).collect(),
        }
    }

    /// Cycles at random from the beginning on: most of what can happen, and cheaper than by a solver.
    pub(super) fn look_around(&mut self, circuit: &Circuit, noise: &mut Noise, limit: &Limit) {
        let begin: Vec<bool> = circuit.latches.iter().map(|latch| latch.initial.unwrap_or(false)).collect();
        self.absorb(&self.moment(&|latch| begin[latch]));
        for _ in 0..ROWS {
            self.go_on(circuit, begin.clone(), noise, limit);
        }
    }

    /// The same from any state on that is allowed for.
    pub(super) fn go_on(&mut self, circuit: &Circuit, begin: Vec<bool>, noise: &mut Noise, limit: &Limit) -> Grown {
        let (mut state, mut free, mut grown) = (begin, vec![false; circuit.aig.len()], Grown::new());
        for _ in 0..ROW {
            for (latch, now) in circuit.latches.iter().zip(&state) {
                free[latch.now.node()] = *now;
            }
            for wire in &circuit.inputs {
                // What is given stays for a while; times are short, or all there is.
                let (keeps, most) = (noise.next() % 4 > 0, noise.next() % (wire.bits.len() as u64 + 1));
                for (bit, lit) in (0_u64..).zip(&wire.bits) {
                    match wire.source {
                        Source::Elapsed => free[lit.node()] = bit < most && noise.next() % 2 == 0,
                        _ if keeps => {}
                        _ => free[lit.node()] = noise.next() % 8 < 3,
                    }
                }
            }
            let values = circuit.aig.simulate(|node| free[node]);
            if value(&values, circuit.constraint) {
                state = circuit.latches.iter().map(|latch| value(&values, latch.next)).collect();
                grown.extend(self.absorb(&self.moment(&|latch| state[latch])));
            }
        }
        limit.spend(ROW as u64 / 4);
        grown
    }
}

/// The places whose lemmas have grown, each with the numbers of those.
pub(super) type Grown = Vec<(usize, Vec<usize>)>;

/// Numbers at random, the same on every machine.
pub(super) struct Noise(u64);

impl Noise {
    pub(super) fn new() -> Self {
        Self(0x9e37_79b9_7f4a_7c15)
    }

    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0 >> 32
    }
}

/// What the values of a region's state are called.
fn states(program: &Program<'_>, field: &Field, region: usize) -> Vec<String> {
    let (program, plant) = (field.program(program), field.plant);
    let prefix = plant.map_or_else(String::new, |_| format!("{}::", program.model.name));
    let step = |step| format!("{prefix}{}.X", program.model.steps[step].name);
    let none = format!("no step of {}", field.name);
    let mut all: Vec<String> = [none].into_iter().chain(program.regions[region].iter().map(|id| step(*id))).collect();
    // The solver may take it for a number that it never is.
    all.extend((all.len()..1 << field.width).map(|number| format!("{} = {number}", field.name)));
    all
}
