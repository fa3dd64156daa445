//! From the naive program of a chart, with times counted (`program::counted`), to a circuit: one cycle is one step of it.
//!
//! - `assemble`: the cycle as a whole, from what the latches hold to what they hold next
//! - `run`, `eval`, `tree`: statements, expressions of the program and of the user
//! - `evolutions`: the same of one evolution of a search after the other
//! - `given`: inputs, params and what places begin with
//! - `sym`: values as wires; `free`: Rust that is not looked into; `clock`: how exactly times are counted
//! - `plants`: what the chart moves, and what it sees of that
//! - `claims`: properties at the end of a cycle; `remembered`: their edges and delays; `monitors`: those over several; `homes`: ways back
//!
//! What a chart remembers is latches, what it is given is inputs; what has passed since the cycle before is one of them, and so are
//! params, as they can be exchanged.

mod assemble;
mod claims;
mod clock;
mod eval;
mod evolutions;
mod free;
mod given;
mod homes;
mod monitors;
mod plants;
mod remembered;
mod run;
mod sym;
mod tree;

use std::collections::BTreeMap;
use std::fmt;
use std::rc::Rc;

use grafcet_compiler::analysis::Change;
use grafcet_compiler::model::{InputId, Name, ParamId};
use grafcet_compiler::program::{Mark, PlaceId, Program};

use crate::aig::{Aig, Lit};
use crate::bits::{self, Bits};
use clock::Clock;
pub use free::As;
use free::Origin;
pub use homes::{Condition, Home};
use remembered::Memories;
use sym::{FreeId, Sym};

/// So many gates and no more.
const LARGEST: usize = 4_000_000;

/// Why a chart has no circuit: what in it is not modelled.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Refused(pub String);

const TOO_LARGE: &str = "a search whose circuit is too large";

impl Refused {
    fn too_large() -> Self {
        Self(TOO_LARGE.to_owned())
    }

    /// Everything is modelled, and takes more gates than are wanted.
    #[must_use]
    pub(crate) fn is_too_large(&self) -> bool {
        self.0 == TOO_LARGE
    }
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

/// What drives an input of the circuit.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Source {
    Input(InputId),
    /// Ticks since the cycle before; those that are longer than it can tell are those that are as far in all periods.
    Elapsed,
    Param(ParamId),
    /// An input of a plant that nobody drives: a choice or a fault.
    Plant(usize, InputId),
    /// The value of Rust that is not looked into.
    Rust(Outside),
    /// Where the cycles begin that come again and again: a choice of the search, not of the chart.
    Again,
}

/// A value of Rust that is not looked into.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Outside {
    pub text: String,
    pub used: As,
    /// Whether its own text stands in the chart, and not what something else is made of.
    pub can_be_asked: bool,
    /// What it is computed of, where it has one value for each of that.
    pub of: Option<Vec<Name>>,
}

/// A constant of the program, `MOST`: any value, and the same in all cycles.
#[derive(Clone, Debug)]
pub struct Constant {
    pub text: String,
    pub used: As,
    /// In this cycle, as in all others.
    pub bits: Vec<Lit>,
}

/// Some inputs of the circuit that are one value, the lowest bit first.
#[derive(Clone, Debug)]
pub struct Wire {
    pub source: Source,
    pub bits: Vec<Lit>,
}

/// One bit of what a chart remembers.
#[derive(Clone, Copy, Debug)]
pub struct Latch {
    /// Its value in this cycle.
    pub now: Lit,
    /// Its value in the next one.
    pub next: Lit,
    /// None for any value.
    pub initial: Option<bool>,
}

/// A place that outlives a cycle: some latches, the lowest bit first.
#[derive(Clone, Debug)]
pub struct Field {
    /// None for what only the circuit knows: whether arithmetic has left its type so far.
    pub place: Option<PlaceId>,
    /// Of which plant's program that place is; none for the chart's.
    pub plant: Option<usize>,
    pub name: String,
    /// The first of its latches.
    pub first: usize,
    pub width: usize,
    pub signed: bool,
}

/// A property: where it does not hold at the end of a cycle.
#[derive(Clone, Copy, Debug)]
pub struct Bad {
    /// Its number in the chart.
    pub property: usize,
    /// Arithmetic that leaves its type goes on at the other end.
    pub possible: Lit,
    /// The same in cycles up to which all arithmetic has stayed in its type.
    pub certain: Lit,
}

/// A property that says until when something comes.
#[derive(Clone, Copy, Debug)]
pub struct Deadline {
    /// Its number in the chart.
    pub property: usize,
    /// The number of the latch that is set while it is waited for; those of the time since then stand after it.
    pub waits: usize,
    pub width: usize,
}

impl Deadline {
    /// The time since it has been waited for.
    #[must_use]
    pub fn field(&self, circuit: &Circuit) -> Field {
        let is_it = |field: &&Field| field.first == self.waits + 1;
        let name = circuit.fields.iter().find(is_it).map_or_else(String::new, |field| field.name.clone());
        Field { place: None, plant: None, name, first: self.waits + 1, width: self.width, signed: false }
    }
}

/// A clock of a property, by the numbers of its latches.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Timer {
    /// What it counts since it changed.
    pub of: usize,
    /// The first of its bits.
    pub first: usize,
    pub width: usize,
}

/// A property that says what comes some time: it is broken where the chart waits for ever.
#[derive(Clone, Copy, Debug)]
pub struct Live {
    /// Its number in the chart.
    pub property: usize,
    /// Set from the end of a cycle in which it is asked for to the next one in which it has come.
    pub waits: Latch,
    /// Arithmetic has left its type in this cycle or before.
    pub broken: Lit,
}

/// One cycle of a chart.
#[derive(Clone, Debug)]
pub struct Circuit {
    pub aig: Aig,
    pub inputs: Vec<Wire>,
    pub latches: Vec<Latch>,
    pub fields: Vec<Field>,
    /// Holds in every cycle: what is assumed, and that nothing panics.
    pub constraint: Lit,
    /// The same without what is assumed to come one after the other.
    pub without_orders: Lit,
    /// In this cycle arithmetic leaves its type.
    pub overflow: Lit,
    /// The program's constants, which latches hold.
    pub constants: Vec<Constant>,
    /// Rust that an interpreter computes and the circuit does not: there it is any value.
    pub uncomputed: Vec<String>,
    pub bad: Vec<Bad>,
    pub live: Vec<Live>,
    pub deadlines: Vec<Deadline>,
    pub homes: Vec<Home>,
    /// By property, where that is something: what it is about happens.
    pub triggers: Vec<(usize, Lit)>,
    /// What is taken to come again and again: what is assumed so, in the order of the chart, that time passes, and that nothing is waited for which
    /// is assumed to come some time.
    pub often: Vec<Lit>,
    /// By what is assumed to come one after the other: it is asked for in this cycle.
    pub orders: Vec<Lit>,
    /// By plant: its situation at the end of this cycle is not the initial one.
    pub moves: Vec<Lit>,
    /// By property: what in it is not modelled.
    pub refused: Vec<(usize, Refused)>,
    /// A search for stability gets to its first evolution, to its second one and so on.
    pub rounds: Vec<Lit>,
    /// By evolution of a cycle: what it does, and where.
    pub evolutions: Vec<Vec<(Mark, Lit)>>,
    /// A search for stability has not come to its end.
    pub unsettled: Lit,
    /// The clocks of delays in properties.
    pub timers: Vec<Timer>,
    /// The bits of a time.
    pub time_bits: usize,
    /// What all periods of what blinks divide, in ticks; one without any.
    pub period: u32,
}

/// What the places hold.
type Env = Rc<Vec<Sym>>;

/// What is made for one program, and what is known about it meanwhile.
pub(crate) struct Lowering<'p, 'm> {
    program: &'p Program<'m>,
    /// So many gates and no more.
    largest: usize,
    /// What places of the program count with: the numbers of associations, as a rule.
    largest_number: usize,
    aig: Aig,
    clock: Clock,
    inputs: Vec<Wire>,
    /// By input of the chart.
    given: Vec<Sym>,
    elapsed: Bits,
    /// By plant, by output: at the end of the cycle before.
    shown: Vec<Vec<Sym>>,
    /// By plant: it is not where it began.
    moves: Vec<Lit>,
    /// By place: what it begins with.
    initial: Vec<Sym>,
    /// Where the statement at hand is reached.
    path: Lit,
    overflow: Lit,
    panics: Lit,
    constraint: Lit,
    rounds: Vec<Lit>,
    evolutions: Vec<Vec<(Mark, Lit)>>,
    memories: Memories,
    origins: Vec<Origin>,
    by_text: BTreeMap<(String, Vec<Sym>), FreeId>,
    constants: Vec<Constant>,
    /// Rust that the interpreter computes and the circuit does not.
    uncomputed: Vec<String>,
    /// Of a plant's program, whose Rust nobody is asked for.
    is_plant: bool,
    /// Where a step is one evolution: in the middle of a search, and what that was given.
    within: Option<Lit>,
    held: Vec<evolutions::Held>,
    as_bool: BTreeMap<FreeId, Sym>,
    as_bits: BTreeMap<(FreeId, usize, As), Bits>,
}

impl Circuit {
    /// The circuit of a naive program, with the properties of its chart.
    ///
    /// # Errors
    /// Something in the chart is not modelled.
    pub fn of(program: &Program<'_>) -> Result<Self, Refused> {
        Self::within(program, LARGEST)
    }

    /// The same with so many gates at most.
    ///
    /// # Errors
    /// It takes more, or something in the chart is not modelled.
    pub fn within(program: &Program<'_>, largest: usize) -> Result<Self, Refused> {
        if let Some(ty) = given::in_two_orders(program) {
            return Err(Refused(format!("the variants of `{ty}`, which are listed in two orders")));
        }
        let mut clock = Clock::of(program, &claims::conditions(program.model), monitors::longest(program.model));
        for plant in &program.plants {
            clock = clock.or(Clock::of(plant, &[], 0));
        }
        Lowering::new(program, largest, clock).circuit()
    }
}

impl Circuit {
    /// From here on all times are alike, but for how far periods are.
    #[must_use]
    pub fn long(&self) -> i128 {
        (1 << self.time_bits) - i128::from(self.period)
    }
}

/// What an evolution does, as a program tells its observers.
fn mark_of(change: Change) -> Mark {
    match change {
        Change::Clears(id) => Mark::Cleared(id),
        Change::Activates(step) => Mark::Activated(step),
        Change::Deactivates(step) => Mark::Deactivated(step),
    }
}

impl Circuit {
    /// The circuit with a wire that says whether two things happen in one evolution of a cycle.
    #[must_use]
    pub fn meeting(&self, one: Change, other: Change) -> (Self, Lit) {
        let (mut circuit, mut met) = (self.clone(), Lit::FALSE);
        for marks in &self.evolutions {
            let of = |aig: &mut Aig, change| {
                let is_it = marks.iter().filter(|(mark, _)| *mark == mark_of(change));
                is_it.fold(Lit::FALSE, |any, (_, path)| aig.or(any, *path))
            };
            let (one, other) = (of(&mut circuit.aig, one), of(&mut circuit.aig, other));
            let both = circuit.aig.and(one, other);
            met = circuit.aig.or(met, both);
        }
        (circuit, met)
    }
}

impl Field {
    /// The program whose place it is.
    #[must_use]
    pub fn program<'p, 'm>(&self, program: &'p Program<'m>) -> &'p Program<'m> {
        self.plant.map_or(program, |plant| &program.plants[plant])
    }
}

impl<'p, 'm> Lowering<'p, 'm> {
    fn new(program: &'p Program<'m>, largest: usize, clock: Clock) -> Self {
        Self {
            program,
            largest,
            largest_number: program.model.associations.len(),
            aig: Aig::default(),
            clock,
            inputs: Vec::new(),
            given: Vec::new(),
            elapsed: bits::constant(0),
            shown: Vec::new(),
            moves: Vec::new(),
            initial: Vec::new(),
            path: Lit::TRUE,
            overflow: Lit::FALSE,
            panics: Lit::FALSE,
            constraint: Lit::TRUE,
            rounds: Vec::new(),
            evolutions: vec![Vec::new()],
            memories: Memories::default(),
            origins: Vec::new(),
            by_text: BTreeMap::new(),
            constants: Vec::new(),
            uncomputed: Vec::new(),
            is_plant: false,
            within: None,
            held: Vec::new(),
            as_bool: BTreeMap::new(),
            as_bits: BTreeMap::new(),
        }
    }
}
