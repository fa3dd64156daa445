//! What is known grows until no cycle leads beyond it.

use std::collections::BTreeMap;

use super::domain::{Domain, Grown, Noise};
use crate::aig::Lit;
use crate::bits::{self, Bits};
use crate::circuit::{Circuit, Condition, Field, Latch};
use crate::limit::{Limit, Over};
use crate::sat::{Sat, Term, Wires};

/// What has grown more often is given up.
const GROWS: u32 = 24;

/// So many sentences are asked about at once.
const AT_ONCE: usize = 40;

/// A place, and which of its clocks; none for that it is never reached.
type Key = (usize, Option<usize>);

/// A sentence in the solver.
struct Lemma {
    said: Condition,
    now: Term,
    end: Term,
}

pub(super) struct Growth<'c> {
    domain: Domain,
    noise: Noise,
    limit: Limit,
    circuit: &'c mut Circuit,
    sat: Sat,
    wires: Wires,
    lemmas: BTreeMap<Key, Lemma>,
    /// By two clocks: by how much the first is ahead, before the cycle and at its end.
    differences: BTreeMap<(usize, usize), (Bits, Bits)>,
    /// By latch, at the end of the cycle.
    latches: Vec<Term>,
    constraint: Term,
    bad: Term,
}

impl<'c> Growth<'c> {
    pub(super) fn new(mut domain: Domain, circuit: &'c mut Circuit, bad: Lit, limit: &Limit) -> Self {
        let mut noise = Noise::new();
        domain.look_around(circuit, &mut noise, limit);
        let (mut sat, mut wires) = (Sat::new(limit), Wires::new(&circuit.aig));
        let constraint = wires.term(&mut sat, &circuit.aig, circuit.constraint);
        let bad = wires.term(&mut sat, &circuit.aig, bad);
        let latches = circuit.latches.iter().map(|latch| wires.term(&mut sat, &circuit.aig, latch.next)).collect();
        let (lemmas, differences) = (BTreeMap::new(), BTreeMap::new());
        let limit = limit.clone();
        Self { domain, noise, limit, circuit, sat, wires, lemmas, differences, latches, constraint, bad }
    }

    /// A number, before the cycle and at its end.
    fn number(&self, field: &Field) -> (Bits, Bits) {
        let latches = &self.circuit.latches[field.first..field.first + field.width];
        let of = |of: fn(&Latch) -> Lit| bits::unsigned(&latches.iter().map(of).collect::<Vec<Lit>>());
        (of(|latch| latch.now), of(|latch| latch.next))
    }

    fn difference(&mut self, clock: usize, of: usize) -> (Bits, Bits) {
        if let Some(known) = self.differences.get(&(clock, of)) {
            return known.clone();
        }
        let number = |clock: usize| match &self.domain.clocks[clock] {
            Some(field) => self.number(field),
            None => (bits::constant(0), bits::constant(0)),
        };
        let (one, other) = (number(clock), number(of));
        let aig = &mut self.circuit.aig;
        let difference = (bits::sub(aig, &one.0, &other.0), bits::sub(aig, &one.1, &other.1));
        self.differences.insert((clock, of), difference.clone());
        difference
    }

    /// Before the cycle, and at its end.
    fn is_in(&mut self, place: usize) -> (Lit, Lit) {
        let (one, other) = (self.domain.places[place].one, self.domain.places[place].other);
        let mut both = (Lit::TRUE, Lit::TRUE);
        for (choice, value) in [one, other] {
            let Some(field) = self.domain.choices[choice].field.clone() else { continue };
            let (number, value) = (self.number(&field), bits::constant(i128::try_from(value).unwrap_or(0)));
            let aig = &mut self.circuit.aig;
            let has = (bits::equal(aig, &number.0, &value), bits::equal(aig, &number.1, &value));
            both = (aig.and(both.0, has.0), aig.and(both.1, has.1));
        }
        both
    }

    /// What is known of a place, as it now is.
    fn said(&mut self, place: usize, ahead: Option<usize>) -> Option<Condition> {
        let is_in = self.is_in(place);
        let Some(ahead) = ahead else { return Some(Condition { now: !is_in.0, end: !is_in.1 }) };
        let ahead = self.domain.places[place].ahead[ahead];
        let most = bits::constant(i128::from(ahead.most?));
        let difference = self.difference(ahead.clock, ahead.of);
        let aig = &mut self.circuit.aig;
        let (now, end) = (bits::less(aig, &most, &difference.0), bits::less(aig, &most, &difference.1));
        Some(Condition { now: !aig.and(is_in.0, now), end: !aig.and(is_in.1, end) })
    }

    fn term(&mut self, lit: Lit) -> Term {
        self.wires.term(&mut self.sat, &self.circuit.aig, lit)
    }

    /// A lemma as it now is, instead of what it was.
    fn renew(&mut self, place: usize, ahead: Option<usize>) {
        self.lemmas.remove(&(place, ahead));
        let Some(said) = self.said(place, ahead) else { return };
        // Of what holds of every cycle nothing is asked.
        if said.now == Lit::TRUE && said.end == Lit::TRUE {
            return;
        }
        let (now, end) = (self.term(said.now), self.term(said.end));
        self.lemmas.insert((place, ahead), Lemma { said, now, end });
    }

    fn begin(&mut self) {
        for place in 0..self.domain.places.len() {
            if self.domain.is_news_that_never(place) {
                self.renew(place, None);
            }
            for ahead in 0..self.domain.places[place].ahead.len() {
                self.renew(place, Some(ahead));
            }
        }
    }

    fn absorb(&mut self) -> Grown {
        let moment = self.domain.moment(&|latch| self.sat.holds(self.latches[latch]));
        self.domain.absorb(&moment)
    }

    /// Until no cycle leads beyond what is known.
    pub(super) fn run(&mut self) -> Result<(), Over> {
        self.begin();
        // From the first part that has not been asked since it last grew.
        let mut from = 0;
        loop {
            // Not as assumptions: each would be a step of the solver in each question.
            let known = self.sat.term();
            for lemma in self.lemmas.values() {
                self.sat.clause(&[!known, lemma.now]);
            }
            let assumed = [self.constraint, known];
            let ends: Vec<Term> = self.lemmas.values().map(|lemma| !lemma.end).collect();
            let parts: Vec<&[Term]> = ends.chunks(AT_ONCE).collect();
            let mut order = (from..parts.len()).chain(0..from.min(parts.len()));
            let found = loop {
                let Some(part) = order.next() else { break None };
                let ask = self.sat.term();
                self.sat.clause(&[parts[part], &[!ask]].concat());
                if self.sat.solve(&[self.constraint, known, ask])? {
                    break Some((part, ask));
                }
                self.sat.clause(&[!ask]);
            };
            let Some((part, ask)) = found else { return Ok(()) };
            from = part;
            let mut changed = BTreeMap::new();
            let mut grown = self.absorb();
            // What a cycle leads to from there has to be allowed for, too.
            let state: Vec<bool> = self.latches.iter().map(|term| self.sat.holds(*term)).collect();
            grown.extend(self.domain.go_on(self.circuit, state, &mut self.noise, &self.limit));
            self.sat.clause(&[!ask]);
            note(grown, &mut changed);
            self.farthest(&assumed, &mut changed)?;
            self.sat.clause(&[!known]);
            self.renew_all(changed.into_keys());
        }
    }

    /// What has changed, as it now is.
    fn renew_all(&mut self, changed: impl Iterator<Item = Key>) {
        for (place, ahead) in changed {
            let Some(which) = ahead else {
                self.lemmas.remove(&(place, None));
                for other in self.domain.inside(place) {
                    self.renew(other, None);
                }
                continue;
            };
            let known = &mut self.domain.places[place].ahead[which];
            known.grown += 1;
            if known.grown > GROWS {
                known.most = None;
            }
            self.renew(place, ahead);
        }
    }

    /// The most that one cycle makes of each that has grown, from where it has been known to be before.
    fn farthest(&mut self, assumed: &[Term], changed: &mut BTreeMap<Key, bool>) -> Result<(), Over> {
        while let Some(((place, ahead), asked)) = changed.iter_mut().find(|(_, asked)| !**asked) {
            *asked = true;
            let (place, Some(ahead)) = (*place, *ahead) else { continue };
            let (mut step, mut beyond) = (1, None::<i64>);
            while let Some(most) = self.domain.places[place].ahead[ahead].most {
                let wanted = beyond.map_or(most + step, |beyond| most + (beyond - most + 1) / 2);
                if beyond.is_some_and(|beyond| wanted >= beyond || wanted <= most) {
                    break;
                }
                let pair = (self.domain.places[place].ahead[ahead].clock, self.domain.places[place].ahead[ahead].of);
                let (is_in, difference) = (self.is_in(place).1, self.difference(pair.0, pair.1).1);
                let farther = !bits::less(&mut self.circuit.aig, &difference, &bits::constant(i128::from(wanted)));
                let both = self.circuit.aig.and(is_in, farther);
                let term = self.term(both);
                if self.sat.solve(&[assumed, &[term]].concat())? {
                    let grown = self.absorb();
                    note(grown, changed);
                    step *= 2;
                } else {
                    beyond = Some(wanted);
                }
            }
        }
        Ok(())
    }

    /// What is enough for that nothing bad happens, and for itself; nothing where something bad may, all the same: a search gets no faster by
    /// a thousand sentences.
    pub(super) fn needed(&mut self) -> Result<Vec<(Condition, String)>, Over> {
        let assumed: Vec<Term> = self.lemmas.values().map(|lemma| lemma.now).chain([self.constraint]).collect();
        if self.sat.solve(&[assumed.clone(), vec![self.bad]].concat())? {
            return Ok(Vec::new());
        }
        let mut kept: BTreeMap<Key, bool> = BTreeMap::new();
        self.core(&mut kept);
        while let Some((key, asked)) = kept.iter_mut().find(|(_, asked)| !**asked) {
            *asked = true;
            let Some(end) = self.lemmas.get(key).map(|lemma| lemma.end) else { continue };
            // It is so, as nothing has grown by it.
            self.sat.solve(&[assumed.clone(), vec![!end]].concat())?;
            self.core(&mut kept);
        }
        Ok(kept.into_keys().filter_map(|key| self.in_words(key)).collect())
    }

    /// The lemmas on which the last answer relies.
    fn core(&self, kept: &mut BTreeMap<Key, bool>) {
        for (key, lemma) in &self.lemmas {
            if self.sat.in_core(lemma.now) {
                kept.entry(*key).or_insert(false);
            }
        }
    }

    fn in_words(&self, key: Key) -> Option<(Condition, String)> {
        let lemma = self.lemmas.get(&key)?;
        let place = &self.domain.places[key.0];
        let here: Vec<&str> = [place.one, place.other]
            .iter()
            .filter(|(choice, _)| *choice > 0)
            .map(|(choice, value)| self.domain.choices[*choice].values[*value].as_str())
            .collect();
        let here = here.join(" && ");
        let Some(ahead) = key.1.map(|ahead| place.ahead[ahead]) else {
            return Some((lemma.said, format!("never {here}")));
        };
        let (most, name) = (ahead.most?, |clock: usize| self.domain.clocks[clock].as_ref().map(|field| &field.name));
        let text = match (name(ahead.clock)?, name(ahead.of)) {
            (clock, None) => format!("{clock} <= {most} ticks"),
            (clock, Some(of)) if most == 0 => format!("{clock} <= {of}"),
            (clock, Some(of)) if most < 0 => format!("{clock} + {} ticks <= {of}", -most),
            (clock, Some(of)) => format!("{clock} <= {of} + {most} ticks"),
        };
        Some((lemma.said, format!("{here} => {text}")))
    }
}

/// What has grown, and whether it has been asked how far it does.
fn note(grown: Grown, changed: &mut BTreeMap<Key, bool>) {
    for (place, which) in grown {
        changed.entry((place, None)).or_insert(true);
        for ahead in which {
            changed.entry((place, Some(ahead))).or_insert(false);
        }
    }
}
