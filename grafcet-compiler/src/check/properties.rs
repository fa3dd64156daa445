//! `property_violated`, `property_undecided`, `not_home`: what the chart itself says that it does.

use super::rivals;

use super::vacuous;
use crate::analysis::explore::{Answer, Doubt, Given, Limits, Path, Stay};
use crate::analysis::{Claims, Facts, Prover, Question, Ruling, Rulings, unlisted_of};
use crate::diagnostic::{Mark, Rule, Sink, rules};
use crate::list::{List, PushAll};
use crate::model::{Claim, How, LevelAttr, Model, Name, Property, Read, StepId, TransitionId, Tree, Ty};
use crate::sorted::Set;

/// Reports what is violated, and what is not decided, by the prover either, where there is one.
pub(super) fn check(model: &Model, claims: &Claims<'_>, limits: Limits, told: &Rulings<'_>, sink: &mut Sink) {
    let report = Report { model, limits };
    for (property, answer) in &claims.open {
        match (answer, told.about(property)) {
            (Answer::Never, _) | (Answer::Unknown(_), Some(Ruling::Holds)) => {}
            (Answer::Possible(path), _) => {
                let cycles = path.cycles.len() + usize::from(path.skips_first);
                report.violated(property, (cycles, None), &path.table(model), sink);
            }
            (Answer::Unknown(_), Some(Ruling::Broken { cycles, again, way })) => {
                report.violated(property, (*cycles, *again), way.trim_end(), sink);
            }
            (Answer::Unknown(doubt), open) => report.undecided(property, doubt, &by_solver(open), sink),
        }
    }
    for (property, answer) in &claims.away {
        match (answer, told.about(property)) {
            (Answer::Never | Answer::Possible(_), _) | (_, Some(Ruling::Holds | Ruling::Broken { .. })) => {}
            (Answer::Unknown(doubt), open) => report.undecided(property, doubt, &by_solver(open), sink),
        }
    }
}

/// What a solver says of what it leaves open, or could say.
fn by_solver(ruling: Option<&Ruling>) -> String {
    match ruling {
        Some(Ruling::Open(why)) => format!("; a solver was asked, too: {why}"),
        _ => "; `cargo grafcet prove` asks a solver, too, and so does the macro with grafcet's feature `prove`"
            .to_owned(),
    }
}

/// The same of a chart with its plants, which nobody but a prover looks at. Ways home are a matter of the chart alone.
pub(super) fn with_plants(model: &Model, prover: Option<(&Prover, &Facts<'_>)>, sink: &mut Sink) {
    let report = Report { model, limits: Limits::default() };
    let mut open = Vec::new();
    for (number, property) in model.properties.iter().enumerate() {
        if !matches!(property.claim, Claim::Home(..)) {
            open.push(number);
        }
    }
    if open.is_empty() {
        return;
    }
    let mut asked = open.iter().map(|number| Question::Holds(*number)).list();
    asked.push_all(vacuous::questions(model, &open));
    let rulings = prover.map(|(prover, facts)| prover(model, facts, &asked)).unwrap_or_default();
    for (index, number) in open.iter().enumerate() {
        let property = &model.properties[*number];
        match rulings.get(index) {
            Some(Ruling::Holds) => {}
            Some(Ruling::Broken { cycles, again, way }) => {
                report.violated(property, (*cycles, *again), way.trim_end(), sink);
            }
            Some(Ruling::Open(why)) => {
                report.undecided(property, &Doubt::Plants, &format!(": {why}"), sink);
            }
            None => report.undecided(
                property,
                &Doubt::Plants,
                ": only a solver looks at plants, which `cargo grafcet prove` asks, and the macro with grafcet's feature `prove`",
                sink,
            ),
        }
    }
    vacuous::with_plants(model, &asked, &rulings, sink);
}

/// What other errors tell of why there is no way home.
pub(super) struct Told<'c> {
    /// Where the chart stays.
    pub(super) stays: &'c [Stay],
    /// By these two ways part and never meet again.
    pub(super) partings: &'c Set<TransitionId>,
    /// What a solver says.
    pub(super) rulings: &'c Rulings<'c>,
}

/// Reports that there is no way home, where no other error tells why: that the chart stays where it is, now or later, or that two
/// ways part and never meet again.
pub(super) fn homes(model: &Model, claims: &Claims<'_>, limits: Limits, told: &Told<'_>, sink: &mut Sink) {
    let report = Report { model, limits };
    let parts =
        |path: &Path| path.cycles.last().is_some_and(|end| end.cleared.iter().any(|id| told.partings.contains(id)));
    for (property, answer) in &claims.away {
        let Claim::Home(home, mark) = &property.claim else { continue };
        let Answer::Possible(path) = answer else {
            // Where the chart stays has been told.
            if let (true, Some(Ruling::Broken { cycles, way, .. })) =
                (told.stays.is_empty(), told.rulings.about(property))
            {
                report.lost(property, (home, *mark), (*cycles, way.trim_end()), sink);
            }
            continue;
        };
        let is_lost = |step: &StepId| !claims.exploration.reachable(*step);
        if home.iter().any(is_lost) && sink.has_dead_ends() || parts(path) {
            continue;
        }
        if told.stays.is_empty() {
            report.not_home(property, (home, *mark), path, sink);
            continue;
        }
        // One that is no way to where the chart stays, either.
        if let Answer::Possible(path) = claims.away_from(home, told.stays, true) {
            if !parts(&path) {
                report.not_home(property, (home, *mark), &path, sink);
            }
        }
    }
}

struct Report<'m> {
    model: &'m Model,
    limits: Limits,
}

impl Report<'_> {
    fn say(&self, rule: &'static Rule, property: &Property, notes: Vec<(Mark, String)>, sink: &mut Sink) {
        let scopes: [&[LevelAttr]; 2] = [&property.levels, &self.model.levels];
        sink.rule(rule, &scopes, notes);
    }

    /// `count` cycles lead there; from the cycle `again` on they go on for ever.
    fn violated(&self, property: &Property, (count, again): (usize, Option<usize>), table: &str, sink: &mut Sink) {
        let when = if count == 1 { "the first cycle".to_owned() } else { format!("cycle {count}") };
        let what = match &property.claim {
            Claim::Always { premise: Some(premise), condition } => {
                format!("at the end of {when} `{}` holds and `{}` does not", premise.text, condition.text)
            }
            Claim::Always { premise: None, condition } => {
                format!("at the end of {when} `{}` does not hold", condition.text)
            }
            Claim::Never(condition) => format!("at the end of {when} `{}` holds", condition.text),
            Claim::LeadsTo { from, to, .. } => match again {
                None => format!(
                    "at the end of {when} it is too late: `{}` has held, and `{}` not since",
                    from.text, to.text
                ),
                Some(again) if again == count => {
                    format!(
                        "`{}` has held, and `{}` never follows where {when} comes again and again",
                        from.text, to.text
                    )
                }
                Some(again) => format!(
                    "`{}` has held, and `{}` never follows where the cycles {again} to {count} come again and again",
                    from.text, to.text
                ),
            },
            Claim::Before { first, then } => {
                format!("at the end of {when} `{}` holds, and `{}` has not held yet", then.text, first.text)
            }
            Claim::Home(..) => return,
        };
        let with = self.with_plants();
        let often = if again.is_some() { "say what comes again and again, `assume often …;`, " } else { "" };
        let message = format!(
            "{what}{with}: mend the chart on this way, exclude its inputs by `assume never …;`, {often}or correct the property\n{table}"
        );
        self.say(&rules::PROPERTY_VIOLATED, property, vec![(property.mark, message)], sink);
    }

    fn with_plants(&self) -> String {
        let plants = &self.model.plants;
        match plants.list.len() {
            0 => String::new(),
            1 => format!(" with the plant {}", plants.names()),
            _ => format!(" with the plants {}", plants.names()),
        }
    }

    /// `solver` tells what one says of it, or would.
    fn undecided(&self, property: &Property, doubt: &Doubt, solver: &str, sink: &mut Sink) {
        let mut message = match doubt {
            Doubt::Budget(situations) => format!(
                "whether this holds is not decided: the budget ran out after {situations} situations; let more be explored, \
                 `budget {};`, or divide the chart",
                grouped(self.limits.more())
            ),
            Doubt::Plants => format!("whether this holds{} is not decided", self.with_plants()),
            Doubt::Inputs { at, inputs } => self.too_many(at, inputs),
            Doubt::Cycles => {
                "whether this holds is not decided: it is about more than one cycle, which only a solver looks at"
                    .to_owned()
            }
            Doubt::Unfollowed(values) => {
                let mut texts: Vec<String> = Vec::new();
                for text in values.iter().map(|tree| format!("`{}`", self.model.tree_text(tree))) {
                    if !texts.contains(&text) {
                        texts.push(text);
                    }
                }
                let what = if texts.is_empty() { "values".to_owned() } else { texts.join(", ") };
                if !values.is_empty() && values.iter().all(|tree| is_arithmetic(self.model, tree)) {
                    let message = format!(
                        "whether this holds is not decided: no values were found for {what} with which every result fits into \
                         its type, nor that there are none; compute in a wider type, or say what happens at its ends, as \
                         `saturating_sub` does, or allow this{solver}"
                    );
                    return self.say(&rules::PROPERTY_UNDECIDED, property, vec![(property.mark, message)], sink);
                }
                // What a call does is not seen.
                let pure = if values.iter().any(Tree::may_differ) {
                    ", or, where such a call has no state, `assume pure …;`"
                } else {
                    ""
                };
                let list = unlisted_of(self.model, values);
                let list = list.map_or_else(String::new, |name| rivals::list_them(self.model, name));
                format!(
                    "whether this holds is not decided: it depends on {what}, and the checker follows steps and plain boolean \
                     outputs and variables only; state it of steps, or allow this{pure}{list}"
                )
            }
        };
        message.push_str(solver);
        self.say(&rules::PROPERTY_UNDECIDED, property, vec![(property.mark, message)], sink);
    }

    fn too_many(&self, at: &[StepId], inputs: &[Tree]) -> String {
        const SHOWN: usize = 8;
        let names: Vec<String> =
            inputs.iter().take(SHOWN).map(|input| format!("`{}`", self.model.tree_text(input))).list();
        let rest = inputs.len().saturating_sub(SHOWN);
        let more = if rest > 0 { format!(" and {rest} more") } else { String::new() };
        format!(
            "whether this holds is not decided: in `{}` one cycle asks for {} inputs, {}{more}, and the budget ran out over \
             their combinations; exclude those that the plant excludes, `assume never …;`, let fewer decide in one situation, \
             or let more be tried, `budget {};`",
            self.model.steps_text(at),
            inputs.len(),
            names.join(", "),
            grouped(self.limits.more())
        )
    }

    fn too_late(&self, property: &Property, home: (&str, Mark), times: &[&Given], path: &Path, sink: &mut Sink) {
        let (model, (home, mark)) = (self.model, home);
        let texts: Vec<String> = times.iter().map(|given| given.text(model)).list();
        let (late, lost) = (texts.join(" && "), model.steps_text(path.end()));
        let message = format!(
            "who waits in `{lost}` until `{late}` has no way back to exactly {home}; draw one, or correct the property\n{}",
            path.table(model)
        );
        let mut notes = vec![(mark, message)];
        for transition in model.transitions.values() {
            let leaves = transition.sources.iter().all(|source| path.end().contains(source));
            let reads = |given: &&&Given| transition.condition.reads.iter().any(|read| is_time_of(*read, &given.what));
            if let Some(time) = times.iter().find(reads).filter(|_| leaves) {
                let message = format!(
                    "this condition reads `{}`: once it is too late, it needs another way beside it",
                    model.tree_text(&time.what)
                );
                notes.push((transition.condition.mark, message));
            }
        }
        self.say(&rules::NOT_HOME, property, notes, sink);
    }

    /// The same as a solver finds it.
    fn lost(
        &self,
        property: &Property,
        (home, mark): (&[StepId], Mark),
        (count, table): (usize, &str),
        sink: &mut Sink,
    ) {
        let home = place(self.model, home);
        let when = if count == 1 { "the first cycle".to_owned() } else { format!("cycle {count}") };
        let message = format!(
            "from the end of {when} on there is no way back to exactly {home}, whatever comes; draw one, or correct the property\n{table}"
        );
        self.say(&rules::NOT_HOME, property, vec![(mark, message)], sink);
    }

    fn not_home(&self, property: &Property, (home, mark): (&[StepId], Mark), path: &Path, sink: &mut Sink) {
        let model = self.model;
        let (home, lost, table) = (place(model, home), model.steps_text(path.end()), path.table(model));
        let Some(end) = path.cycles.last().filter(|end| !end.cleared.is_empty()) else {
            let times = times(path);
            if !times.is_empty() {
                return self.too_late(property, (&home, mark), &times, path, sink);
            }
            let message = format!(
                "exactly {home} is never reached: from `{lost}` on there is no way to it; draw one, or correct the property\n{table}"
            );
            return self.say(&rules::NOT_HOME, property, vec![(mark, message)], sink);
        };
        let message = format!(
            "from `{lost}`, reached so, there is no way back to exactly {home}; draw one, or correct the property\n{table}"
        );
        let mut notes = vec![(mark, message)];
        for id in &end.cleared {
            let transition = &model.transitions[*id];
            let message =
                format!("once this transition has cleared on the way to `{lost}`, there is no way back to {home}");
            notes.push((transition.mark, message));
        }
        self.say(&rules::NOT_HOME, property, notes, sink);
    }
}

/// `` `(A, B)` ``, beside other partial grafcets with the one that it speaks of.
fn place(model: &Model, steps: &[StepId]) -> String {
    let text = format!("`{}`", model.steps_text(steps));
    let mut names: Vec<String> = Vec::new();
    for name in steps.iter().filter_map(|step| model.partials[model.steps[*step].partial].name.as_ref()) {
        let name = format!("`{name}`");
        if !names.contains(&name) {
            names.push(name);
        }
    }
    if names.is_empty() { text } else { format!("{text} in {}", names.join(" and ")) }
}

/// `1_000_000`
fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index) % 3 == 0 {
            text.push('_');
        }
        text.push(digit);
    }
    text
}

/// The times that have passed at the end of a way.
fn times(path: &Path) -> Vec<&Given> {
    let given = path.cycles.last().into_iter().flat(|cycle| &cycle.given);
    given.filter(|given| matches!(given.what, Tree::Read(Read::Since(_) | Read::MacroSince(_)))).list()
}

/// Whether something that is read is this time.
fn is_time_of(read: Read, time: &Tree) -> bool {
    match (read, time) {
        (Read::Since(step) | Read::Elapsed(_, step), Tree::Read(Read::Since(of))) => step == *of,
        (Read::MacroSince(id) | Read::MacroElapsed(_, id), Tree::Read(Read::MacroSince(of))) => id == *of,
        _ => false,
    }
}

/// Whether it is computed of integers that are inputs or params, in ways that are known.
fn is_arithmetic(model: &Model, tree: &Tree) -> bool {
    match tree {
        Tree::Int(_) | Tree::Read(Read::Ticks(_)) => true,
        Tree::Read(Read::Name(name @ (Name::Input(_) | Name::Param(_)))) => !matches!(model.ty(*name), Ty::Other(_)),
        Tree::Unary(_, inner) => is_arithmetic(model, inner),
        Tree::Binary(_, a, b) => is_arithmetic(model, a) && is_arithmetic(model, b),
        Tree::Opaque { of: Some(computed), .. } => {
            !matches!(computed.how, How::If | How::Other)
                && computed.operands.iter().all(|tree| is_arithmetic(model, tree))
        }
        _ => false,
    }
}
