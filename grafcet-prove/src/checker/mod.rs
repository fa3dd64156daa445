//! Other checkers: a question in their formats, and what they say of it, which counts only as far as it is confirmed here.
//!
//! A counterexample is gone by the circuit and by the interpreter of the model. A proof has no certificate in these formats: it is the
//! checker's word; only that no way of a few cycles speaks against it is looked at.

mod witness;

use grafcet_compiler::program::Program;

use crate::aig::Lit;
use crate::bmc;
use crate::circuit::{Bad, Circuit, Latch};
use crate::export;
use crate::goal::Goal;
use crate::limit::Limit;
use crate::live::{self, Lasso};
use crate::play::Player;
use crate::task::{Task, Way};
use crate::verdict::{self, FIRST_CYCLES, Internal, Verdict};

/// Whether something can happen at the end of a cycle: a circuit with one bad state, and without constraints. What is assumed is a latch of its own, the
/// last one, which the bad state asks for: so checkers that know no constraints can be asked, too.
pub struct Question<'p, 'm> {
    program: &'p Program<'m>,
    circuit: Circuit,
    bad: Lit,
}

/// What a checker says.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Answer {
    /// It never happens.
    Never,
    /// It does so, as it says.
    Way(Way),
    /// It has found nothing out, and why.
    Open(String),
}

/// What has come of it.
#[derive(Clone, Debug)]
pub enum Told {
    /// The property holds, as the checker says.
    Holds,
    /// It is broken, which has been confirmed; or that is open.
    Found(Verdict),
}

/// Why there is no verdict.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Trouble<E> {
    /// The checker could not be asked.
    Asked(E),
    /// It says what is not so.
    Wrong(String),
    Internal(Internal),
}

impl<E> From<Internal> for Trouble<E> {
    fn from(internal: Internal) -> Self {
        Self::Internal(internal)
    }
}

impl<'p, 'm> Question<'p, 'm> {
    fn new(program: &'p Program<'m>, circuit: &Circuit, property: usize, bad: Lit) -> Self {
        let mut circuit = circuit.clone();
        let now = circuit.aig.free();
        let next = circuit.aig.and(now, circuit.constraint);
        live::extend(&mut circuit, "assumed", vec![Latch { now, next, initial: Some(true) }]);
        let bad = circuit.aig.and(bad, next);
        circuit.constraint = Lit::TRUE;
        circuit.bad = vec![Bad { property, possible: bad, certain: bad }];
        Self { program, circuit, bad }
    }

    /// AIGER 1.9, binary.
    #[must_use]
    pub fn aiger(&self) -> Vec<u8> {
        export::aiger(self.program, &self.circuit)
    }

    /// The same as text.
    #[must_use]
    pub fn aiger_text(&self) -> String {
        export::aiger_text(self.program, &self.circuit)
    }

    #[must_use]
    pub fn btor2(&self) -> String {
        export::btor2(self.program, &self.circuit)
    }

    /// Reads what a checker has written: a witness of AIGER or of BTOR2, or one of their words.
    ///
    /// # Errors
    /// It is none of that, or not whole; and where.
    pub fn read(&self, text: &str) -> Result<Answer, String> {
        witness::read(&self.circuit, text)
    }

    /// The way up to where it happens; none where it does not.
    fn confirmed(&self, mut way: Way) -> Option<Way> {
        let mut player = Player::beginning(&self.circuit, &way.initial);
        for cycle in 0..way.inputs.len() {
            player.cycle_on(&way.inputs[cycle]);
            if player.holds(self.bad) {
                way.inputs.truncate(cycle + 1);
                return Some(way);
            }
        }
        None
    }

    /// Asks, and looks at what is said.
    fn asked<E>(&self, limit: &Limit, ask: Asking<'_, 'p, 'm, E>) -> Result<Answer, Trouble<E>> {
        match ask(self).map_err(Trouble::Asked)? {
            Answer::Way(way) => {
                let cycles = way.inputs.len();
                let none = || {
                    let plural = if cycles == 1 { "" } else { "s" };
                    Trouble::Wrong(format!("the circuit does not break the property in its {cycles} cycle{plural}"))
                };
                self.confirmed(way).map(Answer::Way).ok_or_else(none)
            }
            Answer::Never => match bmc::shortest(&Task::new(&self.circuit, self.bad), FIRST_CYCLES, limit) {
                Ok(Some(way)) => {
                    let cycle = way.inputs.len();
                    Err(Trouble::Wrong(format!("it says that the property holds, which is broken in cycle {cycle}")))
                }
                Ok(None) | Err(_) => Ok(Answer::Never),
            },
            open @ Answer::Open(_) => Ok(open),
        }
    }
}

/// How a checker is asked.
pub type Asking<'a, 'p, 'm, E> = &'a mut dyn FnMut(&Question<'p, 'm>) -> Result<Answer, E>;

/// What a checker says of a property of the chart. None of one that is no question for it: `home`, or one that is not modelled.
///
/// # Errors
/// It could not be asked, or says what is not so.
pub fn decide_by<'p, 'm, E>(
    program: &'p Program<'m>,
    circuit: &Circuit,
    property: usize,
    limit: &Limit,
    ask: Asking<'_, 'p, 'm, E>,
) -> Result<Option<Told>, Trouble<E>> {
    let Some(goal) = Goal::of(&program.model.properties[property].claim) else { return Ok(None) };
    if let Some(bad) = circuit.bad.iter().find(|bad| bad.property == property) {
        return at_ends(program, circuit, *bad, &goal, limit, ask).map(Some);
    }
    let Some(live) = circuit.live.iter().find(|live| live.property == property) else { return Ok(None) };
    // A way that comes back to where it was is the end of a longer one.
    let lasso = Lasso::new(circuit, *live);
    let question = Question::new(program, &lasso.circuit, property, lasso.bad);
    Ok(Some(match question.asked(limit, ask)? {
        Answer::Never => Told::Holds,
        Answer::Open(why) => Told::Found(Verdict::Undecided(why)),
        Answer::Way(way) => Told::Found(live::shown(program, circuit, &goal, &lasso, &way)?),
    }))
}

fn at_ends<'p, 'm, E>(
    program: &'p Program<'m>,
    circuit: &Circuit,
    bad: Bad,
    goal: &Goal<'_>,
    limit: &Limit,
    ask: Asking<'_, 'p, 'm, E>,
) -> Result<Told, Trouble<E>> {
    let mut way = match Question::new(program, circuit, bad.property, bad.possible).asked(limit, ask)? {
        Answer::Never => return Ok(Told::Holds),
        Answer::Open(why) => return Ok(Told::Found(Verdict::Undecided(why))),
        Answer::Way(way) => way,
    };
    if bad.certain != bad.possible {
        // It may rely on arithmetic that leaves its type.
        let certain = Question::new(program, circuit, bad.property, bad.certain);
        way = match certain.confirmed(way) {
            Some(way) => way,
            None => match certain.asked(limit, ask)? {
                Answer::Never => return Ok(Told::Found(Verdict::Undecided(verdict::uncertain(circuit)))),
                Answer::Open(why) => return Ok(Told::Found(Verdict::Undecided(why))),
                Answer::Way(way) => way,
            },
        };
    }
    Ok(Told::Found(verdict::gone(program, circuit, goal, &way)?))
}
