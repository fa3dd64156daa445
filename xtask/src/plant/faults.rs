//! The list of faults.

use crate::command::Result;

/// A fault: a text that stands once in a file, and what stands there instead.
pub(super) struct Fault {
    pub(super) name: &'static str,
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

/// What is planted.
pub(super) const FAULTS: [Fault; 20] = [
    Fault {
        name: "`>` for `>=` in a timer",
        file: TIME,
        right: "input && self.held >= time\n",
        wrong: "input && self.held > time\n",
    },
    Fault {
        name: "sleeping on `T > t` as on `T >= t`",
        file: "grafcet-compiler/src/codegen/deadline.rs",
        right: "Binary::Gt | Binary::Le => vec![Threshold::Behind(time)]",
        wrong: "Binary::Gt | Binary::Le => vec![Threshold::At(time)]",
    },
    Fault {
        name: "what a delay has held is ignored while sleeping",
        file: TIME,
        right: "(self.input != self.output).then(|| time - self.held)",
        wrong: "(self.input != self.output).then(|| time)",
    },
    Fault {
        name: "what a timer has held is ignored while sleeping",
        file: TIME,
        right: "(self.input && self.held < time).then(|| time - self.held)",
        wrong: "(self.input && self.held < time).then(|| time)",
    },
    Fault {
        name: "a delay forgets its time where its input stays",
        file: TIME,
        right: "if input == self.input { self.held + elapsed }",
        wrong: "if input == self.input { elapsed }",
    },
    Fault {
        name: "16 bits for long times",
        file: "grafcet-compiler/src/plan/memory.rs",
        right: "!matches!(time, TimeRef::Ticks(ticks) if u16::try_from(ticks).is_ok())",
        wrong: "!matches!(time, TimeRef::Ticks(_))",
    },
    Fault {
        name: "a deadline one tick early",
        file: TIME,
        right: "(counted < threshold).then(|| threshold - counted)",
        wrong: "(counted < threshold).then(|| threshold - counted - Ticks::new(1))",
    },
    Fault {
        name: "a self-loop restarts the time in `grafcet`",
        file: CODE_TIME,
        right: "let stays = self.model.is_grafcet() && transition.sources.contains(&step);",
        wrong: "let stays = false && transition.sources.contains(&step);",
    },
    Fault {
        name: "an edge of an input is seen by every evolution of a search (A2)",
        file: CODE_TIME,
        right: "into_iter().map(|local| quote!(#local = false;)).tokens()",
        wrong: "into_iter().map(|_| TokenStream::new()).tokens()",
    },
    Fault {
        name: "the last branch has priority",
        file: "grafcet-compiler/src/codegen/evolution.rs",
        right: "let branches = leaving.iter().map(|id| self.a_branch(*id, self.clear_to(*id)));",
        wrong: "let branches = leaving.iter().rev().map(|id| self.a_branch(*id, self.clear_to(*id)));",
    },
    Fault {
        name: "no final call where a time has elapsed",
        file: "grafcet-compiler/src/codegen/control/runs.rs",
        right: "if #q #not_p1 { #run } else if self.#kept && !#q #not_p0 #not_left { #last }",
        wrong: "if #q #not_p1 { #run }",
    },
    Fault {
        name: "forcing one evolution late",
        file: "grafcet-compiler/src/codegen/hierarchy.rs",
        right: "let ordered = is_active(force.step);",
        wrong: "let ordered = bare(self.is_active(force.step, Moment::Condition));",
    },
    Fault {
        name: "P0 does not see the time reached (A34)",
        file: "grafcet-compiler/src/codegen/sfc.rs",
        right: "if part == Part::Deactivation { Moment::Leaving }",
        wrong: "if part == Part::Deactivation { Moment::Action }",
    },
    Fault {
        name: "an edge in the first cycle (A26)",
        file: CODE_TIME,
        right: "|(_, rising, falling)| *rising && *falling).then(|| quote!(&& !#none))",
        wrong: "|_| false).then(|| quote!(&& !#none))",
    },
    Fault {
        name: "activations before deactivations (A29)",
        file: "grafcet-compiler/src/codegen/sfc.rs",
        right: "#q #left #leaving #entering #rest)",
        wrong: "#q #left #entering #leaving #rest)",
    },
    Fault {
        name: "a self-loop lets a timer go on in `sfc` (A4s)",
        file: "grafcet-compiler/src/codegen/control/flags.rs",
        right: "quote!(#restart |= #again;)",
        wrong: "quote!(#restart |= false && #again;)",
    },
    Fault {
        name: "an inner transition clears in an enclosing step that is left (A19, in place)",
        file: "grafcet-compiler/src/codegen/hierarchy.rs",
        right: "let code = quote!(#evolve #frozen #(#below)*);",
        wrong: "let code = quote!(#(#below)* #evolve #frozen);",
    },
    Fault {
        name: "S dominates R in a flip-flop",
        file: "grafcet-compiler/src/codegen/control/mod.rs",
        right: "(self.#memory || #input) && !#reset;",
        wrong: "self.#memory && !#reset || #input;",
    },
    Fault {
        name: "time passes in the first cycle",
        file: CODE_TIME,
        right: "let elapsed = if self.counts_in_first() {",
        wrong: "let elapsed = if false && self.counts_in_first() {",
    },
    Fault {
        name: "an evolution that the bound stops consumes its edges (A30)",
        file: "grafcet-compiler/src/codegen/grafcet.rs",
        right: "Undo::Nothing => self.keep_edges().1,",
        wrong: "Undo::Nothing => TokenStream::new(),",
    },
];
