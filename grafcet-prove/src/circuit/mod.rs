//! From the naive program of a chart, with times counted (`program::counted`), to a circuit: one cycle is one step of it.
//!
//! - `run`, `eval`, `tree`: statements, expressions of the program and of the user
//! - `sym`: values as wires; `free`: Rust that is not looked into; `clock`: how exactly times are counted
//! - `claims`: properties at the end of a cycle
//!
//! What a chart remembers is latches, what it is given is inputs; what has passed since the cycle before is one of them, and so are
//! params, as they can be exchanged.

mod claims;
mod clock;
mod eval;
mod free;
mod run;
mod sym;
mod tree;

use std::collections::BTreeMap;
use std::fmt;
use std::rc::Rc;

use grafcet_compiler::model::{Expr as Written, InputId, Name, ParamId, Read, Tree, Ty, Variants};
use grafcet_compiler::program::{Initial, PlaceId, Program, Role, Type, Value};

use crate::aig::{Aig, Lit};
use crate::bits::{self, Bits};
use claims::Claims;
use clock::Clock;
use free::Origin;
use sym::{FreeId, Sym, Width};

/// So many gates and no more.
const LARGEST: usize = 4_000_000;

/// Why a chart has no circuit: what in it is not modelled.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Refused(pub String);

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

/// What drives an input of the circuit.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Source {
    Input(InputId),
    /// Ticks since the cycle before; the highest value stands for all that are longer.
    Elapsed,
    Param(ParamId),
    /// The value of Rust that is not looked into.
    Rust(String),
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

/// One cycle of a chart.
#[derive(Clone, Debug)]
pub struct Circuit {
    pub aig: Aig,
    pub inputs: Vec<Wire>,
    pub latches: Vec<Latch>,
    pub fields: Vec<Field>,
    /// Holds in every cycle: what is assumed, and that nothing panics.
    pub constraint: Lit,
    /// In this cycle arithmetic leaves its type.
    pub overflow: Lit,
    pub bad: Vec<Bad>,
    /// By property: what in it is not modelled.
    pub refused: Vec<(usize, Refused)>,
    /// The bits of a time.
    pub time_bits: usize,
}

/// What the places hold.
type Env = Rc<Vec<Sym>>;

/// What is made for one program, and what is known about it meanwhile.
pub(crate) struct Lowering<'p, 'm> {
    program: &'p Program<'m>,
    /// So many gates and no more.
    largest: usize,
    aig: Aig,
    clock: Clock,
    inputs: Vec<Wire>,
    /// By input of the chart.
    given: Vec<Sym>,
    elapsed: Bits,
    /// By place: what it begins with.
    initial: Vec<Sym>,
    /// Where the statement at hand is reached.
    path: Lit,
    overflow: Lit,
    panics: Lit,
    constraint: Lit,
    origins: Vec<Origin>,
    by_text: BTreeMap<(String, Vec<Sym>), FreeId>,
    as_bool: BTreeMap<FreeId, Sym>,
    as_bits: BTreeMap<(FreeId, usize, bool), Bits>,
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
        let violations = program.model.properties.iter().filter_map(|one| claims::violation(program.model, one)?.ok());
        let claims: Vec<Tree> = violations.collect();
        let clock = Clock::of(program, &claims);
        let lowering = Lowering {
            program,
            largest,
            aig: Aig::default(),
            clock,
            inputs: Vec::new(),
            given: Vec::new(),
            elapsed: bits::constant(0),
            initial: Vec::new(),
            path: Lit::TRUE,
            overflow: Lit::FALSE,
            panics: Lit::FALSE,
            constraint: Lit::TRUE,
            origins: Vec::new(),
            by_text: BTreeMap::new(),
            as_bool: BTreeMap::new(),
            as_bits: BTreeMap::new(),
        };
        lowering.circuit()
    }
}

/// A field under construction.
struct Kept {
    place: PlaceId,
    bits: Vec<Lit>,
    signed: bool,
}

impl Lowering<'_, '_> {
    fn circuit(mut self) -> Result<Circuit, Refused> {
        let program = self.program;
        self.initials()?;
        let (mut env, mut kept) = (Vec::new(), Vec::new());
        for index in 0..program.places.len() {
            let (sym, field) = self.place(PlaceId(index))?;
            env.push(sym);
            kept.extend(field);
        }
        let so_far = self.aig.free();
        self.given()?;
        let env = Rc::new(env);
        let (end, _) = self.block(env, &program.cycle)?;
        let constraint = self.assumptions()?;
        self.constraint = self.aig.and(self.constraint, constraint);
        let overflow = self.overflow;
        let broken = self.aig.or(so_far, overflow);
        let claims = self.claims(&end, broken);
        self.constraint = self.aig.and(self.constraint, !self.panics);
        self.finish(kept, &end, (so_far, broken), claims)
    }

    fn finish(
        mut self,
        kept: Vec<Kept>,
        end: &Env,
        (so_far, broken): (Lit, Lit),
        claims: Claims,
    ) -> Result<Circuit, Refused> {
        let (mut latches, mut fields) = (Vec::new(), Vec::new());
        for one in kept {
            let place = &self.program.places[one.place.0];
            let width = one.bits.len();
            let (initial, next) = (self.initial[one.place.0].clone(), end[one.place.0].clone());
            let initial = match initial {
                Sym::Free(_) => vec![None; width],
                sym => self.wires_of(sym, width, one.signed)?.into_iter().map(Lit::known).collect(),
            };
            let next = self.wires_of(next, width, one.signed)?;
            let (name, first, signed) = (place.name.clone(), latches.len(), one.signed);
            fields.push(Field { place: Some(one.place), name, first, width, signed });
            for ((now, next), initial) in one.bits.into_iter().zip(next).zip(initial) {
                latches.push(Latch { now, next, initial });
            }
        }
        fields.push(Field {
            place: None,
            name: "overflowed".to_owned(),
            first: latches.len(),
            width: 1,
            signed: false,
        });
        latches.push(Latch { now: so_far, next: broken, initial: Some(false) });
        Ok(Circuit {
            aig: self.aig,
            inputs: self.inputs,
            latches,
            fields,
            constraint: self.constraint,
            overflow: self.overflow,
            bad: claims.bad,
            refused: claims.refused,
            time_bits: self.clock.width,
        })
    }

    /// What a place holds at the beginning of a cycle.
    fn place(&mut self, id: PlaceId) -> Result<(Sym, Option<Kept>), Refused> {
        let place = &self.program.places[id.0];
        match place.role {
            Role::Param(param) => return Ok((self.param(param)?, None)),
            Role::Reading => return Ok((self.ticks(0), None)),
            _ if !place.is_field => return Ok((self.initial[id.0].clone(), None)),
            _ => {}
        }
        let Some((width, signed)) = self.shape(id)? else {
            let again = self.free(&place.name, Vec::new(), true);
            return Ok((Sym::Free(again), None));
        };
        let bits: Vec<Lit> = (0..width).map(|_| self.aig.free()).collect();
        let number: Bits = if signed { bits.clone().into() } else { bits::unsigned(&bits) };
        let sym = match place.ty {
            Type::Bool | Type::User(Ty::Bool(_)) => Sym::Bool(bits[0]),
            Type::Ticks | Type::User(Ty::Time(_)) => Sym::Ticks(number),
            Type::State(_) => Sym::State(number),
            Type::Phase => Sym::Phase,
            Type::Number => Sym::Int(number, None),
            Type::User(ty) => Sym::Int(number, Width::of(ty)?),
        };
        Ok((sym, Some(Kept { place: id, bits, signed })))
    }

    /// How many bits a field has, and whether the last one is a sign; none where nothing is known about its type.
    fn shape(&self, id: PlaceId) -> Result<Option<(usize, bool)>, Refused> {
        let place = &self.program.places[id.0];
        let bits = |most: usize| (usize::BITS - most.leading_zeros()).max(1) as usize;
        Ok(Some(match place.ty {
            Type::Bool | Type::Phase | Type::User(Ty::Bool(_)) => (1, false),
            Type::Ticks | Type::User(Ty::Time(_)) => (self.clock.width, false),
            Type::State(region) => (bits(self.program.regions[region].len()), false),
            Type::Number => (bits(self.program.model.associations.len()), false),
            Type::User(ty @ Ty::Int { .. }) => match Width::of(ty)? {
                Some(width) => (width.bits, width.signed),
                None => return Ok(None),
            },
            Type::User(Ty::Other(_)) => {
                let name = match place.role {
                    Role::Output(id) => Name::Output(id),
                    Role::Var(id) => Name::Var(id),
                    _ => return Ok(None),
                };
                match self.program.model.variants_of(name) {
                    Some(variants) => (bits(variants.list.len()), false),
                    None => return Ok(None),
                }
            }
        }))
    }

    fn variants(&self, name: grafcet_compiler::model::Place) -> Option<&Variants> {
        self.program.model.variants_of(name.into())
    }

    /// The lowest wires of a value; where it does not fit, which happens to nothing but numbers, the circuit would be wrong.
    fn wires_of(&mut self, sym: Sym, width: usize, signed: bool) -> Result<Vec<Lit>, Refused> {
        Ok(match sym {
            Sym::Bool(lit) => vec![lit],
            Sym::Phase => vec![Lit::FALSE],
            Sym::Int(bits, _) | Sym::Ticks(bits) | Sym::State(bits) => bits::low(&bits, width),
            Sym::Free(id) => bits::low(&self.free_bits(id, width, signed)?, width),
        })
    }

    /// What the chart is given in this cycle.
    fn given(&mut self) -> Result<(), Refused> {
        for (id, input) in self.program.model.inputs.iter() {
            let sym = self.declared(&input.ty, Name::Input(id), Source::Input(id), &input.name.to_string())?;
            self.given.push(sym);
        }
        // Not only where the chart uses time: a property may be all that asks for it.
        if self.program.place(Role::Reading).is_some() {
            let bits: Vec<Lit> = (0..self.clock.width).map(|_| self.aig.free()).collect();
            self.elapsed = bits::unsigned(&bits);
            self.inputs.push(Wire { source: Source::Elapsed, bits });
        }
        Ok(())
    }

    fn param(&mut self, id: ParamId) -> Result<Sym, Refused> {
        let param = &self.program.model.params[id];
        self.declared(&param.ty, Name::Param(id), Source::Param(id), &param.name.to_string())
    }

    fn declared(&mut self, ty: &Ty, name: Name, source: Source, text: &str) -> Result<Sym, Refused> {
        let (width, signed) = match ty {
            Ty::Bool(_) => (1, false),
            Ty::Time(_) => (self.clock.width, false),
            Ty::Int { .. } => match Width::of(ty)? {
                Some(width) => (width.bits, width.signed),
                None => return Err(Refused(text.to_owned())),
            },
            Ty::Other(_) => match self.program.model.variants_of(name) {
                Some(variants) => ((usize::BITS - (variants.list.len() - 1).leading_zeros()).max(1) as usize, false),
                None => return Ok(Sym::Free(self.free(text, Vec::new(), true))),
            },
        };
        let bits: Vec<Lit> = (0..width).map(|_| self.aig.free()).collect();
        self.inputs.push(Wire { source, bits: bits.clone() });
        let number: Bits = if signed { bits.clone().into() } else { bits::unsigned(&bits) };
        Ok(match ty {
            Ty::Bool(_) => Sym::Bool(bits[0]),
            Ty::Time(_) => Sym::Ticks(number),
            Ty::Int { .. } => Sym::Int(number, Width::of(ty)?),
            Ty::Other(_) => {
                let count = self.program.model.variants_of(name).map_or(0, |variants| variants.list.len());
                let most = bits::constant(i128::try_from(count).unwrap_or(0));
                let is_one = bits::below(&mut self.aig, &number, &most);
                self.constraint = self.aig.and(self.constraint, is_one);
                Sym::Int(number, None)
            }
        })
    }

    /// What the places begin with.
    fn initials(&mut self) -> Result<(), Refused> {
        for place in &self.program.places {
            let sym = match place.initial {
                Initial::Value(value) => self.value(value)?,
                Initial::Constant(expr) => {
                    let sym = self.constant(expr)?;
                    self.placed(sym, place.ty)?
                }
                Initial::Default => match place.ty {
                    Type::Bool | Type::User(Ty::Bool(_)) => Sym::bool(false),
                    Type::Ticks | Type::User(Ty::Time(_)) => self.ticks(0),
                    Type::State(_) => self.value(Value::Step(None))?,
                    Type::Phase => Sym::Phase,
                    Type::Number => Sym::int(0),
                    Type::User(ty @ Ty::Int { .. }) => Sym::Int(bits::constant(0), Width::of(ty)?),
                    // Which variant it is, the type says.
                    Type::User(Ty::Other(_)) => Sym::Free(self.free(&place.name, Vec::new(), false)),
                },
            };
            self.initial.push(sym);
        }
        Ok(())
    }

    fn constant(&mut self, expr: &Written) -> Result<Sym, Refused> {
        let mut reads = Vec::new();
        for read in &expr.reads {
            if let Read::Ticks(ticks) = read {
                reads.push((*read, self.ticks(*ticks)));
            }
        }
        self.tree(&expr.tree, &reads)
    }
}
