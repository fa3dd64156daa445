//! For each step of a chart a latch that is true while it is active, beside the numbers by which regions remember it: a set of steps is a
//! cube of these, and most sets of numbers are none of bits.

use grafcet_compiler::model::StepId;
use grafcet_compiler::program::{Program, Role};

use crate::aig::Lit;
use crate::bits;
use crate::certificate;
use crate::circuit::{Circuit, Condition, Field, Latch};
use crate::limit::{Limit, Over};
use crate::pdr::code;
use crate::task::{Cube, entry};

/// What has been added to a circuit.
pub(crate) struct Steps {
    /// In every state each of these latches is what the region says, and one of its steps is active, or none.
    pub(crate) known: Lit,
    /// By region: the latches of its number, and those of its steps.
    of_regions: Vec<[std::ops::Range<usize>; 2]>,
}

impl Steps {
    /// Of the regions that are among the `relevant` latches; from then on what is known is assumed of each cycle.
    ///
    /// # Errors
    /// The limit is reached.
    pub(crate) fn add(
        program: &Program<'_>,
        circuit: &mut Circuit,
        relevant: &[usize],
        limit: &Limit,
    ) -> Result<Self, Over> {
        let mut steps = Self { known: Lit::TRUE, of_regions: Vec::new() };
        let mut end = Lit::TRUE;
        for field in circuit.fields.clone() {
            let (None, Some(place)) = (field.plant, field.place) else { continue };
            let Role::State(region) = program.places[place.0].role else { continue };
            if relevant.binary_search(&field.first).is_err() {
                continue;
            }
            let (numbers, first) = (field.first..field.first + field.width, circuit.latches.len());
            let name = |step: &StepId| program.model.steps[*step].name.to_string();
            let names: Vec<String> = program.regions[region].iter().map(name).collect();
            let known = region_of(circuit, &field, &names);
            steps.known = circuit.aig.and(steps.known, known.now);
            end = circuit.aig.and(end, known.end);
            steps.of_regions.push([numbers, first..circuit.latches.len()]);
        }
        let known = Condition { now: steps.known, end };
        // What is wrong here would be a false proof.
        if !certificate::is_inductive(circuit, &[known], limit)? {
            return Ok(Self { known: Lit::TRUE, of_regions: Vec::new() });
        }
        circuit.constraint = circuit.aig.and(circuit.constraint, steps.known);
        Ok(steps)
    }

    /// The latches that have been added, ascending.
    pub(crate) fn latches(&self) -> impl Iterator<Item = usize> + '_ {
        self.of_regions.iter().flat_map(|[_, steps]| steps.clone())
    }

    /// Whether another latch says what this one says with this value.
    pub(crate) fn is_told(&self, latch: usize, value: bool) -> bool {
        self.of_regions.iter().any(|[numbers, steps]| numbers.contains(&latch) || !value && steps.contains(&latch))
    }

    /// That a step is active, said by those of its region that are not; none of anything else.
    pub(crate) fn beside(&self, of: u32) -> Option<Cube> {
        let (latch, true) = entry(of) else { return None };
        let [_, steps] = self.of_regions.iter().find(|[_, steps]| steps.contains(&latch))?;
        Some(steps.clone().filter(|other| *other != latch).map(|other| code(other, false)).collect())
    }
}

/// The latches of one region, and that they are as they should be.
fn region_of(circuit: &mut Circuit, field: &Field, steps: &[String]) -> Condition {
    let latches = circuit.latches[field.first..field.first + field.width].to_vec();
    let bits_of = |of: fn(&Latch) -> Lit| bits::unsigned(&latches.iter().map(of).collect::<Vec<Lit>>());
    let (now, next) = (bits_of(|latch| latch.now), bits_of(|latch| latch.next));
    let initial = latches.iter().rev().try_fold(0, |number, latch| Some(number * 2 + usize::from(latch.initial?)));
    let mut known = Condition { now: Lit::TRUE, end: Lit::TRUE };
    let mut any = Condition { now: Lit::FALSE, end: Lit::FALSE };
    for step in 0..=steps.len() {
        let number = bits::constant(i128::try_from(step).unwrap_or(0));
        let aig = &mut circuit.aig;
        let (is, is_next) = (bits::equal(aig, &now, &number), bits::equal(aig, &next, &number));
        let latch = Latch { now: aig.free(), next: is_next, initial: initial.map(|initial| initial == step) };
        let same = aig.iff(latch.now, is);
        known.now = aig.and(known.now, same);
        any = Condition { now: aig.or(any.now, is), end: aig.or(any.end, is_next) };
        let name = match step.checked_sub(1) {
            Some(index) => steps[index].clone(),
            None => format!("none of {{{}}}", steps.join(", ")),
        };
        circuit.fields.push(Field {
            place: None,
            plant: None,
            name,
            first: circuit.latches.len(),
            width: 1,
            signed: false,
        });
        circuit.latches.push(latch);
    }
    known.now = circuit.aig.and(known.now, any.now);
    known.end = any.end;
    known
}
