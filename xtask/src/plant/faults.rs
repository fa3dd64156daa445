//! The list of faults.

use crate::command::Result;

/// A fault: a text that stands once in a file, and what stands there instead.
pub(super) struct Fault {
    pub(super) name: &'static str,
    /// How the names of the charts of the corpus begin that are asked first; none where the unit tests of the runtime are.
    pub(super) charts: Option<&'static str>,
    pub(super) file: &'static str,
    right: &'static str,
    wrong: &'static str,
}

impl Fault {
    /// The file with the fault.
    ///
    /// # Errors
    /// The place is not there any more, or not the only one.
    pub(super) fn plant(&self, sound: &str) -> Result<String> {
        match sound.matches(self.right).count() {
            1 => Ok(sound.replace(self.right, self.wrong)),
            count => Err(format!("{}: its place stands {count} times in {}", self.name, self.file)),
        }
    }
}

const MODES: &str = "grafcet-compiler/src/model/resolve/modes.rs";

/// What is planted.
pub(super) const FAULTS: [Fault; 34] = [
    Fault {
        name: "a partial grafcet evolves where the order that forced it ends (A13)",
        charts: Some("a13"),
        file: "grafcet-compiler/src/program/lower/hierarchy.rs",
        right: "parts.push(not(self.was(force.step)));",
        wrong: "continue;",
    },
    Fault {
        name: "a later one wins a contest for an AND-convergence, too (A28)",
        charts: Some("a28_convergence"),
        file: "grafcet-compiler/src/program/lower/decide.rs",
        right: "if *other < id && self",
        wrong: "if *other > id && self",
    },
    Fault {
        name: "an edge is sampled twice in an evolution",
        charts: Some("w_let"),
        file: "grafcet-compiler/src/program/lower/sample.rs",
        right: "hide(&mut body, edges, first_evolution);",
        wrong: "body.push(Statement::Set(edges.before, Expr::Place(edges.now)));",
    },
    Fault {
        name: "an `any` leaves its targets, too",
        charts: Some("any_"),
        file: "grafcet-compiler/src/model/resolve/any.rs",
        right: "filter(|step| !entered.contains(step) && !excepted.contains(step))",
        wrong: "filter(|step| !excepted.contains(step))",
    },
    Fault {
        name: "what blinks begins off",
        charts: Some("t_blink"),
        file: "grafcet-compiler/src/program/lower/view.rs",
        right: "all(vec![is, less(phase, ticks(blink.on))])",
        wrong: "all(vec![is, not(less(phase, ticks(blink.on)))])",
    },
    Fault {
        name: "`>` for `>=` in a timer",
        charts: Some("q_"),
        file: "grafcet-compiler/src/program/lower/timers.rs",
        right: "all(vec![is(RUNS), at_least(clock.passed(Expr::Now), time.clone())])",
        wrong: "all(vec![is(RUNS), not(at_least(time.clone(), clock.passed(Expr::Now)))])",
    },
    Fault {
        name: "`>` for `>=` in a timer that is counted",
        charts: Some("q_"),
        file: "grafcet-compiler/src/program/lower/timers.rs",
        right: "all(vec![Expr::Place(was), at_least(Expr::Place(held), time)])",
        wrong: "all(vec![Expr::Place(was), not(at_least(time, Expr::Place(held)))])",
    },
    Fault {
        name: "sleeping on `T > t` as on `T >= t`",
        charts: Some("t_deadline_sfc"),
        file: "grafcet-compiler/src/program/lower/changes.rs",
        right: "Binary::Gt | Binary::Le => _ = found.insert((of, Change::After(time)))",
        wrong: "Binary::Gt | Binary::Le => _ = found.insert((of, Change::At(time)))",
    },
    Fault {
        name: "how long a delay has waited is ignored while sleeping",
        charts: Some("t_deadline_sfc"),
        file: "grafcet-compiler/src/program/lower/deadline.rs",
        right: "clock => (reading, sub(time, clock.passed(Expr::Place(reading)))),",
        wrong: "_ => (reading, time),",
    },
    Fault {
        name: "what a timer has held is ignored while sleeping",
        charts: Some("t_deadline_timer"),
        file: "grafcet-compiler/src/program/lower/deadline.rs",
        right: "Clock::Began(began) if only_readings => (began, time),",
        wrong: "Clock::Began(_) if only_readings => (reading, time),",
    },
    Fault {
        name: "a delay forgets its time where its input stays",
        charts: Some("t_delay"),
        file: "grafcet-compiler/src/program/lower/delays.rs",
        right: "vec![Statement::If(is(stage, from), wait, go_on)]",
        wrong: "[wait, go_on].concat()",
    },
    Fault {
        name: "a step of flags is looked for in the wrong byte",
        charts: None,
        file: "grafcet-core/src/flags.rs",
        right: "byte.wrapping_mul(8)",
        wrong: "byte.wrapping_mul(9)",
    },
    Fault {
        name: "a deadline one tick early",
        charts: Some("t_deadline_sfc"),
        file: "grafcet-core/src/ticks.rs",
        right: "Self(self.0.wrapping_add(time.0))",
        wrong: "Self(self.0.wrapping_add(time.0).wrapping_sub(1))",
    },
    Fault {
        name: "a self-loop restarts the time in `grafcet`",
        charts: Some("a04g"),
        file: "grafcet-compiler/src/program/lower/time.rs",
        right: "return differ(self.was[region], self.state[region]);",
        wrong: "let entering = self.regions.all()[region].steps.iter().map(|step| &self.model.entering[step.index()]);\n            return any(entering.flatten().map(|id| Expr::Place(self.clears[id.index()])).list());",
    },
    Fault {
        name: "an edge of an input is seen by every evolution of a search (A2)",
        charts: Some("a02"),
        file: "grafcet-compiler/src/program/lower/grafcet.rs",
        right: "commit.push_all(self.use_up_edges());",
        wrong: "_ = self.use_up_edges();",
    },
    Fault {
        name: "the branches of an `any` have no priority",
        charts: Some("any_"),
        file: "grafcet-compiler/src/program/lower/decide.rs",
        right: "if one.partial == transition.partial {",
        wrong: "if one.partial != transition.partial {",
    },
    Fault {
        name: "no final call where a time has elapsed",
        charts: Some("a29_final_by_time"),
        file: "grafcet-compiler/src/program/lower/runs.rs",
        right: "when(into, all(ends), run);",
        wrong: "_ = (ends, run);",
    },
    Fault {
        name: "forcing one evolution late",
        charts: Some("a12"),
        file: "grafcet-compiler/src/program/lower/hierarchy.rs",
        right: "changes = vec![Statement::If(self.is(force.step), forced, changes)];",
        wrong: "changes = vec![Statement::If(self.was(force.step), forced, changes)];",
    },
    Fault {
        name: "P0 does not see the time reached (A34)",
        charts: Some("a34_time_in_actions_sfc"),
        file: "grafcet-compiler/src/program/lower/runs.rs",
        right: "let run = self.effect(&self.model.associations[id].effect, Moment::Leaving, phase);",
        wrong: "let run = self.effect(&self.model.associations[id].effect, Moment::After, phase);",
    },
    Fault {
        name: "an edge in the first cycle (A26)",
        charts: Some("a26"),
        file: "grafcet-compiler/src/program/lower/places.rs",
        right: "let begins = truth(asked == Asked::Rising && !is_hidden);",
        wrong: "let begins = truth(false);",
    },
    Fault {
        name: "activations before deactivations (A29)",
        charts: Some("a29_order"),
        file: "grafcet-compiler/src/program/lower/runs.rs",
        right: "part(cycle, \"deactivations (A29)\", leaving);\n        part(cycle, \"activations\", entering);",
        wrong: "part(cycle, \"activations\", entering);\n        part(cycle, \"deactivations (A29)\", leaving);",
    },
    Fault {
        name: "a self-loop lets a timer go on in `sfc` (A4s)",
        charts: Some("q_l_reentry"),
        file: "grafcet-compiler/src/program/lower/timers.rs",
        right: "any(vec![is(IDLE), again])",
        wrong: "any(vec![is(IDLE), all(vec![no(), again])])",
    },
    Fault {
        name: "an inner transition clears in an enclosing step that is left (A19)",
        charts: Some("a19"),
        file: "grafcet-compiler/src/program/lower/hierarchy.rs",
        right: "changes = vec![Statement::If(self.is(step), here, self.overwrite(*id, &[]))];",
        wrong: "changes = here;",
    },
    Fault {
        name: "S dominates R in a flip-flop",
        charts: Some("q_r_left"),
        file: "grafcet-compiler/src/program/lower/control.rs",
        right: "all(vec![not(reset.clone()), any(vec![set, Expr::Place(stored)])])",
        wrong: "any(vec![set, all(vec![not(reset.clone()), Expr::Place(stored)])])",
    },
    Fault {
        name: "time passes in the first cycle",
        charts: Some("t_first_cycle"),
        file: "grafcet-compiler/src/program/lower/time.rs",
        right: "choose(Expr::Place(self.first), zero(), since)",
        wrong: "since",
    },
    Fault {
        name: "an evolution that the bound stops consumes its edges (A30)",
        charts: Some("a30_edges"),
        file: "grafcet-compiler/src/program/lower/grafcet.rs",
        right: "when(&mut end, stable.map_or_else(yes, Expr::Place), self.use_up_edges());",
        wrong: "when(&mut end, yes(), self.use_up_edges());",
    },
    Fault {
        name: "what is paused clears by the push button (A39)",
        charts: Some("a39"),
        file: MODES,
        right: "let running = and(not(make.input(modes.paused)), or(make.pushed(modes.pushed), automatic));",
        wrong: "let running = or(make.pushed(modes.pushed), and(not(make.input(modes.paused)), automatic));",
    },
    Fault {
        name: "semi-automatic needs no push button (A39)",
        charts: Some("a39"),
        file: MODES,
        right: "let automatic = and(not(manual.clone()), not(make.input(modes.semi_automatic)));",
        wrong: "let automatic = not(manual.clone());",
    },
    Fault {
        name: "by hand a later branch of the same steps clears, too (A39)",
        charts: Some("a39"),
        file: MODES,
        right: "                return ByHand::Never;\n",
        wrong: "                continue;\n",
    },
    Fault {
        name: "an `any` is held back by the modes (A39)",
        charts: Some("a39_modes_any"),
        file: MODES,
        right: "if let (Some(around), false, None) = (around, transition.sources.is_empty(), transition.any) {",
        wrong: "if let (Some(around), false, _) = (around, transition.sources.is_empty(), transition.any) {",
    },
    Fault {
        name: "a cycle by hand uses up the edges of the steps that it enters (A38)",
        charts: Some("a38_force_edge"),
        file: "grafcet-compiler/src/program/lower/forced.rs",
        right: "round.look.clone());\n        part(&mut cycle, \"stable\"",
        wrong: "[round.look.clone(), self.use_up_edges()].concat());\n        part(&mut cycle, \"stable\"",
    },
    Fault {
        name: "a step that is entered by hand goes on with the time of another (A38)",
        charts: Some("a38_force_times"),
        file: "grafcet-compiler/src/program/lower/forced.rs",
        right: "        evolution.push_all(round.commit.clone());\n        let mut",
        wrong: "        let commit = round.commit.iter().filter(|one| matches!(one, Statement::Part(name, _) if name.is_empty()));\n        evolution.push_all(commit.cloned().list());\n        let mut",
    },
    Fault {
        name: "`restore` takes a situation that cannot be",
        charts: None,
        file: "grafcet-core/src/record/snapshot.rs",
        right: "(nothing_left && is_possible(&chart)).then_some(chart)",
        wrong: "nothing_left.then_some(chart)",
    },
    Fault {
        name: "after `restore` a time begins anew",
        charts: None,
        file: "grafcet-core/src/record/chart.rs",
        right: "$($($began: _now_.since(<__r::Ticks as __r::Record>::read(_state_)?),)*)?",
        wrong: "$($($began: { <__r::Ticks as __r::Record>::read(_state_)?; _now_ },)*)?",
    },
];
