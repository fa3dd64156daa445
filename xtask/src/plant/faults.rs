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

const TIME: &str = "grafcet-core/src/time.rs";
const CODE_TIME: &str = "grafcet-compiler/src/codegen/time.rs";
const MODES: &str = "grafcet-compiler/src/model/resolve/modes.rs";
const FORCE: &str = "grafcet-compiler/src/codegen/force.rs";

/// What is planted.
pub(super) const FAULTS: [Fault; 33] = [
    Fault {
        name: "a partial grafcet evolves where the order that forced it ends (A13, in place)",
        charts: Some("a13"),
        file: "grafcet-compiler/src/codegen/hierarchy.rs",
        right: "let frozen = forcing.iter().map(|step| self.in_step(At::Before, *step));",
        wrong: "let frozen = forcing.iter().map(|step| self.in_step(At::Now, *step));",
    },
    Fault {
        name: "the last one wins a contest for an AND-convergence (A28)",
        charts: Some("a28_convergence"),
        file: "grafcet-compiler/src/codegen/evolution.rs",
        right: "let transitions = contest.iter().map(|id| {",
        wrong: "let transitions = contest.iter().rev().map(|id| {",
    },
    Fault {
        name: "an edge is sampled twice in an evolution",
        charts: Some("w_let"),
        file: CODE_TIME,
        right: "quote!(#look self.#field = value_;)",
        wrong: "quote!(#look self.#field = value_; #look)",
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
        file: "grafcet-compiler/src/codegen/bind.rs",
        right: "quote!((#active && #reached < #p::Ticks::new(#on)))",
        wrong: "quote!((#active && #reached >= #p::Ticks::new(#on)))",
    },
    Fault {
        name: "`>` for `>=` in a timer",
        charts: None,
        file: TIME,
        right: "input && self.held >= time\n",
        wrong: "input && self.held > time\n",
    },
    Fault {
        name: "sleeping on `T > t` as on `T >= t`",
        charts: Some("t_deadline_sfc"),
        file: "grafcet-compiler/src/codegen/deadline.rs",
        right: "Binary::Gt | Binary::Le => vec![Threshold::Behind(time)]",
        wrong: "Binary::Gt | Binary::Le => vec![Threshold::At(time)]",
    },
    Fault {
        name: "what a delay has held is ignored while sleeping",
        charts: Some("t_deadline_sfc"),
        file: TIME,
        right: "(self.input != self.output).then(|| time - self.held)",
        wrong: "(self.input != self.output).then(|| time)",
    },
    Fault {
        name: "what a timer has held is ignored while sleeping",
        charts: Some("t_deadline_timer"),
        file: TIME,
        right: "(self.input && self.held < time).then(|| time - self.held)",
        wrong: "(self.input && self.held < time).then(|| time)",
    },
    Fault {
        name: "a delay forgets its time where its input stays",
        charts: None,
        file: TIME,
        right: "if input == self.input { self.held + elapsed }",
        wrong: "if input == self.input { elapsed }",
    },
    Fault {
        name: "16 bits for long times",
        charts: Some("t_long"),
        file: "grafcet-compiler/src/plan/memory.rs",
        right: "!matches!(time, TimeRef::Ticks(ticks) if u16::try_from(ticks).is_ok())",
        wrong: "!matches!(time, TimeRef::Ticks(_))",
    },
    Fault {
        name: "a deadline one tick early",
        charts: Some("t_deadline_sfc"),
        file: TIME,
        right: "(counted < threshold).then(|| threshold - counted)",
        wrong: "(counted < threshold).then(|| threshold - counted - Ticks::new(1))",
    },
    Fault {
        name: "a self-loop restarts the time in `grafcet`",
        charts: Some("a04g"),
        file: CODE_TIME,
        right: "let stays = self.model.is_grafcet() && transition.sources.contains(&step);",
        wrong: "let stays = false && transition.sources.contains(&step);",
    },
    Fault {
        name: "an edge of an input is seen by every evolution of a search (A2)",
        charts: Some("a02"),
        file: CODE_TIME,
        right: "into_iter().map(|local| quote!(#local = false;)).tokens()",
        wrong: "into_iter().map(|_| TokenStream::new()).tokens()",
    },
    Fault {
        name: "the last branch has priority",
        charts: Some("a28_priority"),
        file: "grafcet-compiler/src/codegen/evolution.rs",
        right: "let branches = leaving.iter().map(|id| self.a_branch(*id, self.clear_to(*id)));",
        wrong: "let branches = leaving.iter().rev().map(|id| self.a_branch(*id, self.clear_to(*id)));",
    },
    Fault {
        name: "no final call where a time has elapsed",
        charts: Some("a29_final_by_time"),
        file: "grafcet-compiler/src/codegen/control/runs.rs",
        right: "if #q #not_p1 { #run } else if self.#kept && !#q #not_p0 #not_left { #last }",
        wrong: "if #q #not_p1 { #run }",
    },
    Fault {
        name: "forcing one evolution late",
        charts: Some("a12"),
        file: "grafcet-compiler/src/codegen/hierarchy.rs",
        right: "let ordered = is_active(force.step);",
        wrong: "let ordered = bare(self.is_active(force.step, Moment::Condition));",
    },
    Fault {
        name: "P0 does not see the time reached (A34)",
        charts: Some("a34_time_in_actions_sfc"),
        file: "grafcet-compiler/src/codegen/sfc.rs",
        right: "if part == Part::Deactivation { Moment::Leaving }",
        wrong: "if part == Part::Deactivation { Moment::Action }",
    },
    Fault {
        name: "an edge in the first cycle (A26)",
        charts: Some("a26"),
        file: CODE_TIME,
        right: "|(_, rising, falling)| *rising && *falling).then(|| quote!(&& !#none))",
        wrong: "|_| false).then(|| quote!(&& !#none))",
    },
    Fault {
        name: "activations before deactivations (A29)",
        charts: Some("a29_order"),
        file: "grafcet-compiler/src/codegen/sfc.rs",
        right: "#q #left #leaving #entering #rest)",
        wrong: "#q #left #entering #leaving #rest)",
    },
    Fault {
        name: "a self-loop lets a timer go on in `sfc` (A4s)",
        charts: Some("q_l_reentry"),
        file: "grafcet-compiler/src/codegen/control/flags.rs",
        right: "quote!(#restart |= #again;)",
        wrong: "quote!(#restart |= false && #again;)",
    },
    Fault {
        name: "an inner transition clears in an enclosing step that is left (A19, in place)",
        charts: Some("a19"),
        file: "grafcet-compiler/src/codegen/hierarchy.rs",
        right: "let code = quote!(#evolve #frozen #(#below)*);",
        wrong: "let code = quote!(#(#below)* #evolve #frozen);",
    },
    Fault {
        name: "S dominates R in a flip-flop",
        charts: Some("q_r_left"),
        file: "grafcet-compiler/src/codegen/control/mod.rs",
        right: "(self.#memory || #input) && !#reset;",
        wrong: "self.#memory && !#reset || #input;",
    },
    Fault {
        name: "time passes in the first cycle",
        charts: Some("t_first_cycle"),
        file: CODE_TIME,
        right: "let elapsed = if self.counts_in_first() {",
        wrong: "let elapsed = if false && self.counts_in_first() {",
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
        right: "let running = make.and(not(make.input(modes.paused)), make.or(make.pushed(modes.pushed), automatic));",
        wrong: "let running = make.or(make.pushed(modes.pushed), make.and(not(make.input(modes.paused)), automatic));",
    },
    Fault {
        name: "semi-automatic needs no push button (A39)",
        charts: Some("a39"),
        file: MODES,
        right: "let automatic = make.and(not(manual.clone()), not(make.input(modes.semi_automatic)));",
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
        file: FORCE,
        right: "            { #look #combinational #edges }\n            #put_back\n",
        wrong: "            { #look #combinational #edges }\n",
    },
    Fault {
        name: "a step that is entered by hand goes on with the time of another (A38)",
        charts: Some("a38_force_times"),
        file: FORCE,
        right: "#declare #collect #stored #take_over #commit #restart #gone",
        wrong: "#declare #collect #stored #take_over #commit #gone",
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
