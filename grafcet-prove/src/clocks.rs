//! How clocks and what they count since go together, where a property depends on several: IC3 sees single bits, and would find out value by
//! value that one clock is never ahead of another.
//!
//! Sentences of a few kinds are candidates, each at the beginning of a cycle: what a clock counts is on or off in a step, or where something
//! else is; one clock is no more than another there. What the others do not make certain of the next cycle goes, until nothing does (Houdini).
//! What is left always holds, and is checked like any proof. How far clocks are apart by more than nothing, `differences` finds out.

use grafcet_compiler::model::{Id, StepId};
use grafcet_compiler::program::{Program, Role, Type};

use crate::aig::Lit;
use crate::bits::{self, Bits};
use crate::circuit::{Circuit, Condition, Field, Latch};
use crate::lemmas::{always, assume, limits};
use crate::limit::{At, Limit, Over};
use crate::task::Task;

/// So many candidates, and no more.
const MOST: usize = 3_000;

/// So many steps of the solver may that take.
const STEPS: u64 = 100_000;

/// Something that is so at the beginning of a cycle, and at that of the next one.
#[derive(Clone)]
struct Said<T> {
    text: String,
    now: T,
    next: T,
}

/// Whether more than one clock decides about it.
pub(crate) fn are_several(program: &Program<'_>, circuit: &Circuit, bad: Lit) -> bool {
    fields(circuit, bad).iter().filter(|field| is_clock(program, circuit, field)).count() > 1
}

/// What decides about it.
fn fields(circuit: &Circuit, bad: Lit) -> Vec<Field> {
    let relevant = Task::new(circuit, bad).latches;
    let is_relevant = |field: &&Field| relevant.binary_search(&field.first).is_ok();
    circuit.fields.iter().filter(is_relevant).cloned().collect()
}

/// Whether it counts time.
pub(crate) fn is_clock(program: &Program<'_>, circuit: &Circuit, field: &Field) -> bool {
    match field.place.map(|place| &field.program(program).places[place.0]) {
        Some(place) => matches!(place.ty, Type::Ticks) && !matches!(place.role, Role::Output(_) | Role::Var(_)),
        None => circuit.timers.iter().any(|timer| timer.first == field.first),
    }
}

/// The circuit in which such sentences are known, and these; none where there are none.
///
/// # Errors
/// The limit is reached.
pub(crate) fn known(
    program: &Program<'_>,
    circuit: &Circuit,
    bad: Lit,
    limit: &Limit,
) -> Result<Option<(Circuit, Vec<String>)>, Over> {
    limit.tell(At::Lemmas);
    let fields = fields(circuit, bad);
    let mut circuit = circuit.clone();
    let mut candidates = Candidates::of(program, &mut circuit, &fields);
    candidates.all();
    let limit = &limit.part(STEPS);
    let mut all = candidates.found;
    all.truncate(MOST);
    let conditions: Vec<Condition> =
        all.iter().map(|one| Condition { now: one.said.now, end: one.said.next }).collect();
    let left = always(&circuit, &conditions, limit)?;
    let left = without_repeats(&all, &left);
    let kept: Vec<Condition> = left.iter().map(|index| conditions[*index]).collect();
    let is_known = !kept.is_empty() && assume(&mut circuit, &kept, limit)?;
    let said = left.into_iter().map(|index| all[index].said.text.clone()).collect();
    Ok(is_known.then_some((circuit, said)))
}

/// Those of which none says more that is left, too.
fn without_repeats(all: &[Candidate], left: &[usize]) -> Vec<usize> {
    let is_left = |index: &usize| left.binary_search(index).is_ok();
    left.iter().copied().filter(|index| !all[*index].less_than.iter().any(is_left)).collect()
}

/// A sentence, and the numbers of those that say it, too, and more.
struct Candidate {
    said: Said<Lit>,
    less_than: Vec<usize>,
}

/// Where something may be so.
struct Situation {
    said: Said<Lit>,
    /// The numbers of larger ones.
    inside: Vec<usize>,
    /// The number of the candidate that there is none.
    never: Option<usize>,
}

struct Candidates<'c, 'p, 'm> {
    program: &'p Program<'m>,
    circuit: &'c mut Circuit,
    clocks: Vec<(Option<Role>, Said<Bits>)>,
    /// Steps that are active, each with its region.
    steps: Vec<(usize, Said<Lit>)>,
    /// What clocks count since, and that the first cycle is still to come.
    signals: Vec<Said<Lit>>,
    found: Vec<Candidate>,
}

impl<'c, 'p, 'm> Candidates<'c, 'p, 'm> {
    fn of(program: &'p Program<'m>, circuit: &'c mut Circuit, fields: &[Field]) -> Self {
        let mut all =
            Self { program, circuit, clocks: Vec::new(), steps: Vec::new(), signals: Vec::new(), found: Vec::new() };
        for field in fields {
            let role = field.place.map(|place| field.program(program).places[place.0].role);
            if is_clock(program, all.circuit, field) {
                let clock = all.bits(field);
                all.clocks.push((role.filter(|_| field.plant.is_none()), clock));
            }
            match role {
                Some(Role::State(region)) => all.steps_of(field, region),
                Some(
                    Role::First
                    | Role::TimerInput(..)
                    | Role::DelayInput(_)
                    | Role::FlipFlop(..)
                    | Role::DelayOutput(_),
                ) => all.signal(field),
                None if all.circuit.timers.iter().any(|timer| timer.of == field.first) => all.signal(field),
                _ => {}
            }
        }
        all
    }

    fn latches(&self, field: &Field) -> Vec<Latch> {
        self.circuit.latches[field.first..field.first + field.width].to_vec()
    }

    fn bits(&self, field: &Field) -> Said<Bits> {
        let latches = self.latches(field);
        let of = |of: fn(&Latch) -> Lit| bits::unsigned(&latches.iter().map(of).collect::<Vec<Lit>>());
        Said { text: field.name.clone(), now: of(|latch| latch.now), next: of(|latch| latch.next) }
    }

    fn signal(&mut self, field: &Field) {
        let [latch] = self.latches(field)[..] else { return };
        self.signals.push(Said { text: field.name.clone(), now: latch.now, next: latch.next });
    }

    fn steps_of(&mut self, field: &Field, region: usize) {
        let state = self.bits(field);
        let program = field.program(self.program);
        for (code, step) in (1..).zip(&program.regions[region]) {
            let code = bits::constant(code);
            let aig = &mut self.circuit.aig;
            let (now, next) = (bits::equal(aig, &state.now, &code), bits::equal(aig, &state.next, &code));
            let text = format!("{}.X", program.model.steps[*step].name);
            // Those of a plant have no limits of the chart's.
            let region = if field.plant.is_none() { step.index() } else { usize::MAX };
            self.steps.push((region, Said { text, now, next }));
        }
    }

    fn all(&mut self) {
        self.signals();
        self.limits();
        self.pairs();
    }

    fn note(&mut self, said: Said<Lit>, less_than: Vec<usize>) -> usize {
        self.found.push(Candidate { said, less_than });
        self.found.len() - 1
    }

    /// That one implies the other.
    fn implies(&mut self, one: &Said<Lit>, other: &Said<Lit>) -> usize {
        let aig = &mut self.circuit.aig;
        let now = !aig.and(one.now, !other.now);
        let next = !aig.and(one.next, !other.next);
        self.note(Said { text: format!("{} => {}", one.text, other.text), now, next }, Vec::new())
    }

    /// What is on goes with what else is.
    fn signals(&mut self) {
        let signals = self.signals.clone();
        for (index, one) in signals.iter().enumerate() {
            for (number, other) in signals.iter().enumerate() {
                if number != index {
                    self.implies(one, other);
                    self.implies(one, &not(other));
                    self.implies(&not(one), other);
                }
            }
        }
    }

    /// The time of a step stays below what leaves it.
    fn limits(&mut self) {
        let steps = self.steps.clone();
        for (id, clock) in self.steps_with_clocks() {
            let Some((_, step)) = steps.iter().find(|(step, _)| *step == id.index()) else { continue };
            for limit in limits(self.program.model, id) {
                let less = self.less(&clock, limit);
                self.implies(step, &less);
            }
        }
    }

    fn steps_with_clocks(&self) -> Vec<(StepId, Said<Bits>)> {
        let mut all = Vec::new();
        for (region, steps) in self.program.regions.iter().enumerate() {
            for (_, clock) in self.clocks.iter().filter(|(role, _)| *role == Some(Role::Time(region))) {
                all.extend(steps.iter().map(|step| (*step, clock.clone())));
            }
        }
        all
    }

    fn less(&mut self, clock: &Said<Bits>, limit: u32) -> Said<Lit> {
        let (aig, number) = (&mut self.circuit.aig, bits::constant(i128::from(limit)));
        let (now, next) = (bits::less(aig, &clock.now, &number), bits::less(aig, &clock.next, &number));
        Said { text: format!("{} < {limit} ticks", clock.text), now, next }
    }

    /// One clock is no more than another, or it stands at its beginning: everywhere, in a step, where something is on, and in both.
    fn pairs(&mut self) {
        let zero = Said { text: "0".to_owned(), now: bits::constant(0), next: bits::constant(0) };
        let clocks: Vec<Said<Bits>> = self.clocks.iter().map(|(_, clock)| clock.clone()).collect();
        let mut orders = Vec::new();
        for (index, one) in clocks.iter().enumerate() {
            let others = clocks.iter().enumerate().filter(|(number, _)| *number != index).map(|(_, other)| other);
            for other in others.chain([&zero]) {
                let aig = &mut self.circuit.aig;
                let text = format!("{} <= {}", one.text, other.text);
                let (now, next) = (!bits::less(aig, &other.now, &one.now), !bits::less(aig, &other.next, &one.next));
                orders.push(Said { text, now, next });
            }
        }
        let (places, mut numbers) = (self.places(), Vec::<Vec<usize>>::new());
        for place in &places {
            let mut here = Vec::new();
            for (order, said) in orders.iter().enumerate() {
                let number = self.implies(&place.said, said);
                let larger = place.inside.iter().map(|larger| numbers[*larger][order]);
                self.found[number].less_than = larger.chain(place.never).collect();
                here.push(number);
            }
            numbers.push(here);
        }
    }

    /// Everywhere, in a step, where something is on, and in both.
    fn places(&mut self) -> Vec<Situation> {
        let everywhere = Said { text: "always".to_owned(), now: Lit::TRUE, next: Lit::TRUE };
        let mut all = vec![Situation { said: everywhere, inside: Vec::new(), never: None }];
        let signals: Vec<Said<Lit>> = self.signals.iter().flat_map(|signal| [signal.clone(), not(signal)]).collect();
        let steps: Vec<Said<Lit>> = self.steps.iter().map(|(_, step)| step.clone()).collect();
        for said in signals.iter().chain(&steps) {
            all.push(Situation { said: said.clone(), inside: vec![0], never: None });
        }
        for (index, step) in steps.iter().enumerate() {
            for (number, signal) in signals.iter().enumerate() {
                let aig = &mut self.circuit.aig;
                let (now, next) = (aig.and(step.now, signal.now), aig.and(step.next, signal.next));
                let said = Said { text: format!("{} && {}", step.text, signal.text), now, next };
                let never = self.implies(step, &not(signal));
                all.push(Situation {
                    said,
                    inside: vec![0, 1 + number, 1 + signals.len() + index],
                    never: Some(never),
                });
            }
        }
        all
    }
}

fn not(said: &Said<Lit>) -> Said<Lit> {
    Said { text: format!("not {}", said.text), now: !said.now, next: !said.next }
}
