//! Properties over more than one cycle, and what is assumed to come one after the other: what has been seen so far is latches beside those of the chart.

use grafcet_compiler::analysis::combinational::written_out;
use grafcet_compiler::model::{Claim, Expr, Model, Remembers, TimeRef};
use grafcet_compiler::program::Role;

use super::{Bad, Deadline, Env, Field, Latch, Live, Lowering, Refused, Timer};
use crate::aig::Lit;
use crate::bits;

/// What has been added for the properties of a chart.
#[derive(Default)]
pub(super) struct Monitors {
    fields: Vec<(String, Vec<Latch>)>,
    pub(super) bad: Vec<Bad>,
    pub(super) live: Vec<Live>,
    /// By property, with the number of its first field; of an assumption without one.
    timers: Vec<(Option<usize>, usize)>,
    pub(super) refused: Vec<(usize, Refused)>,
}

/// What is assumed to come one after the other.
pub(super) struct Orders {
    /// It is so up to the end of this cycle.
    pub(super) hold: Lit,
    /// Nothing is waited for: that comes again and again.
    pub(super) often: Vec<Lit>,
    /// By assumption: it says something.
    pub(super) triggers: Vec<Lit>,
}

/// The same, once the latches have their numbers.
pub(super) struct Ended {
    pub(super) bad: Vec<Bad>,
    pub(super) live: Vec<Live>,
    pub(super) deadlines: Vec<Deadline>,
    /// The clocks of assumptions.
    pub(super) timers: Vec<Timer>,
}

/// Whose latches they are.
#[derive(Clone, Copy)]
enum Owner {
    Property(usize),
    Order(usize),
}

impl Monitors {
    fn field(&mut self, owner: Owner, what: &str, latches: Vec<Latch>) {
        let name = match owner {
            Owner::Property(number) => format!("property {}: {what}", number + 1),
            Owner::Order(number) => format!("assumption {}: {what}", number + 1),
        };
        self.fields.push((name, latches));
    }

    /// The latches, after those that are there.
    pub(super) fn finish(self, latches: &mut Vec<Latch>, fields: &mut Vec<Field>) -> Ended {
        let (mut deadlines, mut timers) = (Vec::new(), Vec::new());
        for (number, (name, new)) in self.fields.into_iter().enumerate() {
            let first = latches.len();
            match self.timers.iter().find(|(_, field)| field + 1 == number) {
                Some((Some(property), _)) => {
                    deadlines.push(Deadline { property: *property, waits: first - 1, width: new.len() });
                }
                Some((None, _)) => timers.push(Timer { of: first - 1, first, width: new.len() }),
                None => {}
            }
            fields.push(Field { place: None, plant: None, name, first, width: new.len(), signed: false });
            latches.extend(new);
        }
        Ended { bad: self.bad, live: self.live, deadlines, timers }
    }
}

/// The longest time after which something has to have come.
fn deadline(model: &Model) -> Option<u32> {
    let within = |claim: &Claim| if let Claim::LeadsTo { within, .. } = claim { *within } else { None };
    let claims = model.properties.iter().map(|property| &property.claim);
    claims.chain(model.orders.iter().map(|order| &order.claim)).filter_map(within).max()
}

/// The longest time that a property remembers.
fn delay(model: &Model) -> Option<u32> {
    let times = model.memories.values().filter_map(|memory| match memory.kind {
        Remembers::Delay(on, off) => Some([on, off]),
        Remembers::Rise | Remembers::Fall => None,
    });
    let ticks = |time| if let TimeRef::Ticks(ticks) = time { ticks } else { 0 };
    times.flatten().map(ticks).max()
}

/// The longest of these, or the longest time between two cycles.
pub(super) fn longest(model: &Model) -> u32 {
    deadline(model).max(delay(model)).max(model.longest_cycle).unwrap_or(0)
}

impl Lowering<'_, '_> {
    /// Whether a property asks how long something takes.
    pub(super) fn has_deadline(&self) -> bool {
        deadline(self.program.model).or(delay(self.program.model)).is_some()
    }

    /// `broken`: arithmetic has left its type in this cycle or before.
    pub(super) fn monitors(&mut self, end: &Env, broken: Lit) -> Monitors {
        let mut monitors = Monitors::default();
        for (number, property) in self.program.model.properties.iter().enumerate() {
            let watched = match &property.claim {
                Claim::LeadsTo { from, to, within } => self.both(from, to, end).map(|(from, to)| match within {
                    Some(ticks) => self.in_time(&mut monitors, number, (from, to), *ticks, broken),
                    None => self.at_last(&mut monitors, number, (from, to), broken),
                }),
                Claim::Before { first, then } => self
                    .both(first, then, end)
                    .map(|(first, then)| self.precedes(&mut monitors, number, (first, then), broken)),
                Claim::Never(_) | Claim::Always { .. } | Claim::Home(..) => continue,
            };
            if let Err(refused) = watched {
                monitors.refused.push((number, refused));
            }
        }
        monitors
    }

    /// Both conditions at the end of the cycle.
    fn both(&mut self, one: &Expr, other: &Expr, end: &Env) -> Result<(Lit, Lit), Refused> {
        let (overflow, panics, path) = (self.overflow, self.panics, self.path);
        (self.overflow, self.panics) = (Lit::FALSE, Lit::FALSE);
        let result = self.side(one, end).and_then(|one| Ok((one, self.side(other, end)?)));
        let fits = (self.overflow, self.panics) == (Lit::FALSE, Lit::FALSE);
        (self.overflow, self.panics, self.path) = (overflow, panics, path);
        if fits {
            result
        } else {
            result.and(Err(Refused("arithmetic that can leave its type in a property over several cycles".to_owned())))
        }
    }

    fn side(&mut self, condition: &Expr, end: &Env) -> Result<Lit, Refused> {
        match written_out(self.program.model, &condition.tree) {
            Some(written) => self.at_end(&written, end),
            None => Err(Refused("a property over variables that stand for too much".to_owned())),
        }
    }

    fn bad(&mut self, monitors: &mut Monitors, property: usize, bad: Lit, broken: Lit) {
        let certain = self.aig.and(bad, !broken);
        monitors.bad.push(Bad { property, possible: bad, certain });
    }

    /// Waits from the end of a cycle where `from` holds and `to` does not to the next one where `to` does.
    fn waits(&mut self, from: Lit, to: Lit) -> Latch {
        let now = self.aig.free();
        let asked = self.aig.or(now, from);
        Latch { now, next: self.aig.and(asked, !to), initial: Some(false) }
    }

    /// `from leads_to to within ticks`: at the end of the first cycle so much later `to` has held.
    fn in_time(&mut self, monitors: &mut Monitors, property: usize, sides: (Lit, Lit), ticks: u32, broken: Lit) {
        let bad = self.late(monitors, Owner::Property(property), sides, ticks);
        self.bad(monitors, property, bad, broken);
    }

    /// Where it has not held in time.
    fn late(&mut self, monitors: &mut Monitors, owner: Owner, (from, to): (Lit, Lit), ticks: u32) -> Lit {
        let waits = self.waits(from, to);
        let width = self.clock.width;
        let now: Vec<Lit> = (0..width).map(|_| self.aig.free()).collect();
        let (sum, most) = (bits::add(&mut self.aig, &bits::unsigned(&now), &self.elapsed), (1_i128 << width) - 1);
        let most = bits::constant(most);
        let beyond = bits::less(&mut self.aig, &most, &sum);
        let passed = bits::mux(&mut self.aig, beyond, &most, &sum);
        let late = !bits::less(&mut self.aig, &passed, &bits::constant(i128::from(ticks)));
        let still = self.aig.and(waits.now, waits.next);
        let bad = self.aig.and(still, late);
        // It begins at the end of the cycle in which it is asked for.
        let next = bits::mux(&mut self.aig, waits.now, &passed, &bits::constant(0));
        let next = bits::low(&next, width);
        let timer = now.into_iter().zip(next).map(|(now, next)| Latch { now, next, initial: Some(false) });
        let property = if let Owner::Property(property) = owner { Some(property) } else { None };
        monitors.timers.push((property, monitors.fields.len()));
        monitors.field(owner, "waits", vec![waits]);
        monitors.field(owner, "time", timer.collect());
        bad
    }

    /// `from leads_to to`, some time.
    fn at_last(&mut self, monitors: &mut Monitors, property: usize, (from, to): (Lit, Lit), broken: Lit) {
        let waits = self.waits(from, to);
        monitors.live.push(Live { property, waits, broken });
        monitors.field(Owner::Property(property), "waits", vec![waits]);
    }

    /// `first before then`: as long as `first` has not held, `then` does not.
    fn precedes(&mut self, monitors: &mut Monitors, property: usize, sides: (Lit, Lit), broken: Lit) {
        let bad = self.early(monitors, Owner::Property(property), sides);
        self.bad(monitors, property, bad, broken);
    }

    fn early(&mut self, monitors: &mut Monitors, owner: Owner, (first, then): (Lit, Lit)) -> Lit {
        let now = self.aig.free();
        let next = self.aig.or(now, first);
        monitors.field(owner, "seen", vec![Latch { now, next, initial: Some(false) }]);
        self.aig.and(then, !next)
    }

    /// What is assumed to come one after the other.
    pub(super) fn orders(&mut self, monitors: &mut Monitors, end: &Env) -> Result<Orders, Refused> {
        let mut orders = Orders { hold: Lit::TRUE, often: Vec::new(), triggers: Vec::new() };
        for (number, order) in self.program.model.orders.iter().enumerate() {
            let owner = Owner::Order(number);
            let wrong = match &order.claim {
                Claim::LeadsTo { from, to, within } => {
                    let (from, to) = self.both(from, to, end)?;
                    orders.triggers.push(from);
                    match within {
                        Some(ticks) => self.late(monitors, owner, (from, to), *ticks),
                        None => {
                            let waits = self.waits(from, to);
                            orders.often.push(!waits.next);
                            monitors.field(owner, "waits", vec![waits]);
                            Lit::FALSE
                        }
                    }
                }
                Claim::Before { first, then } => {
                    let (first, then) = self.both(first, then, end)?;
                    orders.triggers.push(then);
                    self.early(monitors, owner, (first, then))
                }
                Claim::Never(_) | Claim::Always { .. } | Claim::Home(..) => continue,
            };
            orders.hold = self.aig.and(orders.hold, !wrong);
        }
        Ok(orders)
    }

    /// What comes again and again, by assumption; time that passes is one of it.
    pub(super) fn recurring(&mut self) -> Result<Vec<Lit>, Refused> {
        let mut all = Vec::new();
        for often in &self.program.model.often {
            let mut reads = Vec::new();
            for read in &often.reads {
                reads.push((*read, self.of_inputs(*read)?));
            }
            let often = self.tree(&often.tree, &reads)?;
            all.push(self.bool(&often)?);
        }
        if self.has_time() {
            let none = bits::equal(&mut self.aig, &self.elapsed.clone(), &bits::constant(0));
            all.push(!none);
        }
        Ok(all)
    }

    /// Not only where the chart uses time: a property may be all that asks for it.
    pub(super) fn has_time(&self) -> bool {
        self.program.place(Role::Reading).is_some()
            || self.has_deadline()
            || self.program.plants.iter().any(|plant| plant.place(Role::Reading).is_some())
    }
}
