//! Why nothing moves: for the situation at hand the enabled transitions, and what each waits for.

use std::fmt;

use grafcet_compiler::model::{
    Binary, Blinker, DelayId, Model, Name, Read, TimeRef, Transition, TransitionId, Tree, Unary,
};

use crate::chart::Chart;
use crate::interp::{Error, Look, Mode};
use crate::names::{Names, plain};
use crate::value::{Value, outside};

/// What a chart waits for.
#[derive(Clone, PartialEq, Debug)]
pub struct Blocked {
    /// For each transition whose steps are all active, in source order.
    pub waiting: Vec<Waiting>,
    /// The chart has made no cycle since its start, so its initial situation is still to be entered.
    pub is_first: bool,
}

/// A transition whose steps are all active.
#[derive(Clone, PartialEq, Debug)]
pub struct Waiting {
    /// Its place in [`Names::transitions`].
    pub transition: usize,
    /// Its name there.
    pub name: String,
    pub why: Why,
}

/// Why a transition has not cleared.
#[derive(Clone, PartialEq, Debug)]
pub enum Why {
    /// Its condition holds: it clears in the next cycle, unless another one has priority.
    Holds,
    /// Its condition does not hold.
    Waits(Wait),
    /// An operating mode (`modes;`) holds it back.
    Held {
        by: HeldBack,
        /// What is false in its condition, too, where that is asked.
        wait: Option<Wait>,
    },
    /// The step of this name forces or does not enclose its partial grafcet: it is frozen.
    Frozen(Option<String>),
    /// Its condition cannot be told; why.
    Unknown(String),
}

/// An operating mode that holds a transition back.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum HeldBack {
    /// Nothing clears.
    Paused,
    /// It waits for the push button.
    SemiAutomatic,
    /// It waits for the push button, whatever its condition says.
    Manual,
    /// By hand the transition of this name goes before it.
    ByHand(String),
}

/// What is false now.
#[derive(Clone, PartialEq, Debug)]
pub enum Wait {
    Part(Part),
    /// All of it has to come true.
    All(Vec<Wait>),
    /// Any of it would do.
    Any(Vec<Wait>),
}

/// A part of a condition that is false now.
#[derive(Clone, PartialEq, Debug)]
pub struct Part {
    /// As the user would write it: `level > 10`.
    pub text: String,
    /// What it reads, and the values: `level`, 3.
    pub values: Vec<(String, Value)>,
    /// It comes true by itself after so many ticks.
    pub left: Option<u32>,
    /// The same as a person reads it, or what else is to be said of it.
    pub note: String,
}

impl fmt::Display for Part {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.left.is_some() {
            return write!(f, "{} of `{}` still to go", self.note, self.text);
        }
        write!(f, "`{}`", self.text)?;
        let alone = matches!(&self.values[..], [(name, _)] if *name == self.text);
        let mut said: Vec<String> = match &self.values[..] {
            [(_, value)] if alone => vec![value.to_string()],
            values => values.iter().map(|(name, value)| format!("{name} = {value}")).collect(),
        };
        if !self.note.is_empty() {
            said.push(self.note.clone());
        }
        if said.is_empty() { Ok(()) } else { write!(f, " ({})", said.join(", ")) }
    }
}

impl fmt::Display for Wait {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (parts, between) = match self {
            Self::Part(part) => return part.fmt(f),
            Self::All(parts) => (parts, "; "),
            Self::Any(parts) => (parts, " or "),
        };
        let text = |part: &Self| match (self, part) {
            (Self::Any(_), Self::All(_)) => format!("({part})"),
            _ => part.to_string(),
        };
        f.write_str(&parts.iter().map(text).collect::<Vec<_>>().join(between))
    }
}

impl fmt::Display for Waiting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = &self.name;
        match &self.why {
            Why::Holds => write!(f, "`{name}` clears in the next cycle"),
            Why::Waits(wait) => write!(f, "`{name}` waits for {wait}"),
            Why::Held { by: HeldBack::SemiAutomatic, wait: Some(wait) } => {
                write!(f, "`{name}` waits for {wait}, and then for the push button (semi-automatic)")
            }
            Why::Held { by, wait } => {
                match by {
                    HeldBack::Paused => write!(f, "`{name}` is held back: paused")?,
                    HeldBack::SemiAutomatic => write!(f, "`{name}` is held back: semi-automatic, until `push`")?,
                    HeldBack::Manual => write!(f, "`{name}` is held back: manual, until `push`")?,
                    HeldBack::ByHand(other) => write!(f, "`{name}` is held back: manual, and `{other}` goes first")?,
                }
                wait.as_ref().map_or(Ok(()), |wait| write!(f, "; it also waits for {wait}"))
            }
            Why::Frozen(Some(by)) => write!(f, "`{name}` is frozen: `{by}` forces its partial grafcet"),
            Why::Frozen(None) => write!(f, "`{name}` is frozen: the step that encloses it is not active"),
            Why::Unknown(why) => write!(f, "`{name}`: {why}"),
        }
    }
}

impl fmt::Display for Blocked {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_first {
            return f.write_str("the next cycle is the first");
        }
        if self.waiting.is_empty() {
            return f.write_str("no transition is enabled");
        }
        f.write_str(&self.waiting.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"))
    }
}

/// What the chart waits for.
pub(crate) fn blocked(chart: &Chart, look: &Look<'_>) -> Blocked {
    let (model, names) = (chart.model(), chart.names());
    let mut waiting: Vec<Waiting> = Vec::new();
    for (id, transition) in model.transitions.iter().filter(|(id, _)| look.follows(*id)) {
        let place = names.transition(id);
        if waiting.last().is_some_and(|last| last.transition == place) {
            continue;
        }
        let why = Asking { model, names, look }.why(id, transition);
        waiting.push(Waiting { transition: place, name: names.transitions[place].name.clone(), why });
    }
    Blocked { waiting, is_first: look.is_first() }
}

struct Asking<'a> {
    model: &'a Model,
    names: &'a Names,
    look: &'a Look<'a>,
}

impl Asking<'_> {
    fn why(&self, id: TransitionId, transition: &Transition) -> Why {
        if !self.look.is_free(transition.partial) {
            let by = self.look.forced_by(transition.partial);
            return Why::Frozen(by.map(|step| plain(&self.model.steps[step].name)));
        }
        self.look
            .mode(id)
            .and_then(|mode| self.in_mode(mode, id, transition))
            .unwrap_or_else(|error| Why::Unknown(error.to_string()))
    }

    fn in_mode(&self, mode: Option<Mode>, id: TransitionId, transition: &Transition) -> Result<Why, Error> {
        if let Some(Mode::Manual { pushed }) = mode {
            let before = self
                .look
                .goes_before(id)
                .map(|other| HeldBack::ByHand(self.names.transitions[self.names.transition(other)].name.clone()));
            let by = before.or_else(|| (!pushed).then_some(HeldBack::Manual));
            return Ok(by.map_or(Why::Holds, |by| Why::Held { by, wait: None }));
        }
        let tree = written(transition);
        let wait = if self.look.holds(tree)? { None } else { Some(self.wait(tree, true)?) };
        let by = match mode {
            Some(Mode::Paused) => Some(HeldBack::Paused),
            Some(Mode::SemiAutomatic { pushed: false }) => Some(HeldBack::SemiAutomatic),
            _ => None,
        };
        Ok(match (by, wait) {
            (Some(by), wait) => Why::Held { by, wait },
            (None, Some(wait)) => Why::Waits(wait),
            (None, None) => Why::Holds,
        })
    }

    /// What stands between a condition and the value that is wanted, which it has not.
    fn wait(&self, tree: &Tree, wanted: bool) -> Result<Wait, Error> {
        match (tree, wanted) {
            (Tree::Unary(Unary::Not, inner), _) => self.wait(inner, !wanted),
            (Tree::Binary(Binary::And, a, b), true) | (Tree::Binary(Binary::Or, a, b), false) => {
                let mut all = Vec::new();
                for part in [a, b] {
                    // A part after one that is false need not make sense yet.
                    if self.look.holds(part).is_ok_and(|holds| holds != wanted) {
                        match self.wait(part, wanted)? {
                            Wait::All(parts) => all.extend(parts),
                            part => all.push(part),
                        }
                    }
                }
                Ok(if all.len() == 1 { all.remove(0) } else { Wait::All(all) })
            }
            (Tree::Binary(Binary::And | Binary::Or, a, b), _) => {
                let mut any = Vec::new();
                for part in [a, b] {
                    match self.wait(part, wanted)? {
                        Wait::Any(parts) => any.extend(parts),
                        part => any.push(part),
                    }
                }
                Ok(Wait::Any(any))
            }
            _ => self.part(tree, wanted).map(Wait::Part),
        }
    }

    fn part(&self, tree: &Tree, wanted: bool) -> Result<Part, Error> {
        let text = if wanted { self.model.tree_text(tree) } else { format!("!{}", self.model.operand_text(tree)) };
        let mut part = Part { text, values: Vec::new(), left: None, note: String::new() };
        match tree {
            Tree::Bool(_) => "never".clone_into(&mut part.note),
            Tree::Elapsed(time, step) if wanted => self.time(&mut part, *time, Blinker::Step(*step))?,
            Tree::MacroElapsed(time, id) if wanted => self.time(&mut part, *time, Blinker::Macro(*id))?,
            Tree::Elapsed(..) | Tree::MacroElapsed(..) => "the time is over".clone_into(&mut part.note),
            Tree::Read(Read::Delay(id)) => self.delay(&mut part, *id, wanted)?,
            Tree::Read(Read::Rising(edge) | Read::Falling(edge)) => {
                let of = &self.model.edges[*edge].of;
                part.note = format!("{} is {}", of.text, self.look.holds(&of.tree)?);
                if !plain_read(&of.tree) {
                    self.values(&mut part, &of.tree)?;
                }
            }
            Tree::Binary(Binary::Ge | Binary::Gt, a, b) if wanted => {
                self.values(&mut part, tree)?;
                if let (Tree::Read(Read::Since(step)), Tree::Read(Read::Ticks(ticks))) = (&**a, &**b) {
                    let more = u32::from(matches!(tree, Tree::Binary(Binary::Gt, ..)));
                    if self.look.holds(&Tree::Read(Read::Active(*step)))? {
                        let left = ticks.saturating_add(more).saturating_sub(self.look.since(Blinker::Step(*step)));
                        self.left(&mut part, left);
                    }
                }
            }
            _ => self.values(&mut part, tree)?,
        }
        Ok(part)
    }

    fn left(&self, part: &mut Part, ticks: u32) {
        part.left = Some(ticks);
        part.note = self.names.time(ticks.into());
    }

    /// `4s/Fill`
    fn time(&self, part: &mut Part, time: TimeRef, of: Blinker) -> Result<(), Error> {
        if self.look.holds(&Tree::Read(of.active()))? {
            self.left(part, self.look.ticks(time)?.saturating_sub(self.look.since(of)));
        } else {
            let name = match of {
                Blinker::Step(step) => &self.model.steps[step].name,
                Blinker::Macro(id) => &self.model.macros[id].name,
            };
            part.note = format!("{} is not active", plain(name));
        }
        Ok(())
    }

    /// `3s/level_ok/1s`
    fn delay(&self, part: &mut Part, id: DelayId, wanted: bool) -> Result<(), Error> {
        let delay = &self.model.delays[id];
        let counted = self.look.delay(id);
        if counted.signal == wanted {
            let time = self.look.ticks(if wanted { delay.on } else { delay.off })?;
            self.left(part, time.saturating_sub(counted.ticks));
        } else {
            part.note = format!("{} is {}", delay.of.text, counted.signal);
        }
        Ok(())
    }

    /// What is read, each name once.
    fn values(&self, part: &mut Part, tree: &Tree) -> Result<(), Error> {
        let mut reads = Vec::new();
        tree.each_read(&mut |read| {
            if !reads.contains(&read) {
                reads.push(read);
            }
        });
        for read in reads {
            let value = match read {
                Read::Name(name) => self.name(name)?,
                Read::Since(step) => Value::Name(self.names.time(self.look.since(Blinker::Step(step)).into())),
                Read::MacroSince(id) => Value::Name(self.names.time(self.look.since(Blinker::Macro(id)).into())),
                Read::Ticks(_) => continue,
                other => Value::Bool(self.look.holds(&Tree::Read(other))?),
            };
            part.values.push((self.model.read_text(read), value));
        }
        Ok(())
    }

    fn name(&self, name: Name) -> Result<Value, Error> {
        let value = outside(self.look.name(name)?, name, self.model);
        Ok(match value {
            Value::Ticks(ticks) => Value::Name(self.names.time(ticks.into())),
            value => value,
        })
    }
}

/// The condition as it was written, without what `modes;` makes of it.
pub(crate) fn written(transition: &Transition) -> &Tree {
    transition.held.as_ref().unwrap_or_else(|| transition.own_condition())
}

fn plain_read(tree: &Tree) -> bool {
    matches!(tree, Tree::Read(Read::Name(_)))
}
