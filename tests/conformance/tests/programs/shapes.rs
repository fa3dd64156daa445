//! The charts of `tests/golden/shapes`: the pseudo-code of each beside its Rust, and which parts, passes and forms of Rust none of them shows.
//!
//! The Rust is recorded by `tests/shapes.rs` of the root package, which is built without the printer of pseudo-code.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use grafcet_compiler::model::Model;
use grafcet_compiler::program::passes::Pass;
use grafcet_compiler::program::{Comparison, Expr, Fence, PlaceId, Program, Statement, Type};
use grafcet_conformance::program::program as optimised;
use grafcet_conformance::reader;

use super::{corpus, read, recorded, resolved};

/// What no optimised program has, and why.
const NEVER: &[(&str, &str)] = &[("Statement::Mark", "nobody observes generated code, and `marks` leaves none")];

/// How a place is stored: each `Kind` of `codegen/program/layout.rs`, and what shows it in Rust without white space.
const KINDS: &[(&str, &str)] = &[
    ("Local", "letmutevolutions_:"),
    ("Asked", "forced0_"),
    ("Result", "outputs_."),
    ("Field", "self.since="),
    ("Param", "self.params."),
    ("Unpacked", "Self::situation_(self)"),
    ("Unset", "self.situation[0usize]|="),
    ("Marked", "self.situation.state()"),
    ("Mark", "self.situation.marked()"),
];

/// The same of those that no chart shows, and why.
const KINDS_NEVER: &[(&str, Option<&str>, &str)] = &[
    ("Unused", None, "nothing reads or writes it, so nothing is printed"),
    (
        "Late",
        Some(".unwrap_or_else(||"),
        "what is remembered states a constant (`check/initial.rs`), and `outputs` leaves no field of the rest",
    ),
];

/// What a program does not tell of its Rust.
const FORMS: &[(&str, &str)] = &[
    ("a period that is counted", "phase("),
    ("a period that the time of its step tells", "rest("),
    ("a default of a type of the user", "default_value::<"),
    ("values of a type of the user that are compared", "is_same::<"),
    ("a constant of the user", "Code::NONE"),
    ("times of two bytes in a table", "constTABLE:[u16;"),
    ("times of four bytes in a table", "constTABLE:[u32;"),
    ("states in a table", "constTABLE:[__"),
    ("kinds in a table", "constKINDS:[__Kind"),
    ("a long sequence with few jumps", ",_=>{match"),
    ("outputs as one constant", "outputs_=const{"),
    ("a block that can be left", "'once:{"),
    ("a search", "loop{"),
    ("a state as wide as a register", "#[repr(u32)]enum__"),
    ("a deadline of one clock", "sooner(soonest_,"),
    ("a deadline of several clocks", "earlier(soonest_,"),
    ("a cycle by hand", "fnforce("),
    ("inputs that are found anew", "black_box(inputs_)"),
    ("a fence", "compiler_fence("),
    ("a fence on ARMv6-M", "fence_on_armv6m()"),
    ("a fence elsewhere", "fence_beyond_armv6m()"),
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The files of the folder with an extension, by name.
fn files(extension: &str) -> BTreeMap<String, String> {
    let entries = fs::read_dir(root().join("tests/golden/shapes")).expect("a folder of charts");
    let mut files = BTreeMap::new();
    for entry in entries {
        let path = entry.expect("a folder entry").path();
        if path.extension().is_some_and(|found| found == extension) {
            let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
            files.insert(name, fs::read_to_string(&path).expect("a file of the folder can be read"));
        }
    }
    files
}

fn models() -> BTreeMap<String, Model> {
    let model = |(name, text): (String, String)| {
        let tokens = text.parse().unwrap_or_else(|error| panic!("{name}: {error}"));
        (name, resolved(tokens))
    };
    files("chart").into_iter().map(model).collect()
}

/// The optimised program of each chart. `cargo xtask bless` records them anew.
#[test]
fn each_shape_is_as_recorded() {
    let charts = models();
    for (name, model) in &charts {
        let program = optimised(model, &Pass::ALL).expect("a program");
        recorded(&root().join(format!("tests/golden/shapes/{name}.txt")), &program.to_string());
    }
    let alone: Vec<String> = files("txt").into_keys().filter(|name| !charts.contains_key(name)).collect();
    assert!(alone.is_empty(), "pseudo-code without a chart: {alone:?}");
}

/// What can stand in a program stands in that of some chart, and what no chart can show is named with its reason.
#[test]
fn each_part_of_a_program_has_a_golden() {
    let mut shown = Shown::default();
    for model in models().values() {
        shown.program(&optimised(model, &Pass::ALL).expect("a program"));
    }
    let never: BTreeSet<&str> = NEVER.iter().map(|(name, _)| *name).collect();
    let all: BTreeSet<&str> = [STATEMENTS, EXPRESSIONS, COMPARISONS, FENCES, TYPES].concat().into_iter().collect();
    let missing: Vec<&str> = all.iter().filter(|name| !never.contains(*name) && !shown.has(name)).copied().collect();
    assert!(missing.is_empty(), "no chart of tests/golden/shapes shows {missing:?}: add a small one that does");
    for (_, text) in corpus() {
        let chart = reader::read(&text).expect("a chart and a timeline").chart;
        shown.program(&optimised(&read(&chart), &Pass::ALL).expect("a program"));
    }
    for (name, reason) in NEVER {
        assert!(all.contains(name), "{name} is no part of a program");
        assert!(!shown.has(name), "{name} does occur, so this is no reason: {reason}");
    }
}

/// Each pass makes something else of some chart.
#[test]
fn each_pass_has_a_golden() {
    let charts = models();
    let text = |model: &Model, passes: &[Pass]| optimised(model, passes).expect("a program").to_string();
    let whole: Vec<(&Model, String)> = charts.values().map(|model| (model, text(model, &Pass::ALL))).collect();
    let missing: Vec<Pass> = Pass::ALL
        .into_iter()
        .filter(|left_out| {
            let mut passes = Pass::ALL.to_vec();
            passes.retain(|pass| pass != left_out);
            whole.iter().all(|(model, whole)| text(model, &passes) == *whole)
        })
        .collect();
    assert!(
        missing.is_empty(),
        "without {missing:?} each program of tests/golden/shapes is the same: add a small chart whose is not"
    );
}

/// How places are stored, and what else a program does not tell.
#[test]
fn each_form_of_rust_has_a_golden() {
    let layout = root().join("grafcet-compiler/src/codegen/program/layout.rs");
    let layout = syn::parse_file(&fs::read_to_string(layout).expect("the layout of places")).expect("Rust");
    let variants = layout.items.into_iter().find_map(|item| match item {
        syn::Item::Enum(item) if item.ident == "Kind" => Some(item.variants),
        _ => None,
    });
    let kinds: BTreeSet<String> =
        variants.expect("the enum of the kinds").iter().map(|kind| kind.ident.to_string()).collect();
    let never = KINDS_NEVER.iter().map(|(kind, ..)| *kind);
    let listed: BTreeSet<String> = KINDS.iter().map(|(kind, _)| *kind).chain(never).map(str::to_owned).collect();
    assert_eq!(listed, kinds, "the lists here, and the kinds of places");
    let mut rust = String::new();
    for text in files("rs").values() {
        rust.extend(text.chars().filter(|c| !c.is_whitespace()));
    }
    let missing: Vec<_> = KINDS.iter().chain(FORMS).filter(|(_, sign)| !rust.contains(sign)).collect();
    assert!(missing.is_empty(), "no Rust of tests/golden/shapes shows {missing:?}: add a small chart whose does");
    for (kind, sign, reason) in KINDS_NEVER {
        assert!(sign.is_none_or(|sign| !rust.contains(sign)), "{kind} does occur, so this is no reason: {reason}");
    }
}

/// The names of all variants, and that of a value: a new variant does not compile until it stands here.
macro_rules! variants {
    ($all:ident, $of:ident: $ty:ty, $kind:ident { $($variant:ident)* }) => {
        const $all: &[&str] = &[$(concat!(stringify!($kind), "::", stringify!($variant))),*];

        fn $of(one: $ty) -> &'static str {
            match one {
                $($kind::$variant { .. } => concat!(stringify!($kind), "::", stringify!($variant)),)*
            }
        }
    };
}

variants!(STATEMENTS, statement: &Statement<'_>, Statement { Part Set If Match Loop Break Run Call Mark Fence });
variants!(EXPRESSIONS, expression: &Expr<'_>, Expr {
    Value Place Initial Input Now Is Not All Any Compare Choose Table Add Sub Next Since Period User
});
variants!(COMPARISONS, comparison: Comparison, Comparison { Equal Differs Less AtLeast });
variants!(FENCES, fence: Fence, Fence { Memory Armv6m BeyondArmv6m Inputs });
variants!(TYPES, of_type: Type<'_>, Type { Bool Ticks State Number Kind User });

/// What has been seen in programs.
#[derive(Default)]
struct Shown {
    names: BTreeSet<&'static str>,
    /// Of the program that is looked at.
    places: BTreeSet<PlaceId>,
}

impl Shown {
    fn has(&self, name: &str) -> bool {
        self.names.contains(name)
    }

    /// What its pseudo-code shows: a cycle by hand is not printed.
    fn program(&mut self, program: &Program<'_>) {
        self.places.clear();
        self.block(&program.cycle);
        if let Some(deadline) = &program.deadline {
            self.expr(&deadline.at_once);
            self.expr(&deadline.reading);
            for wait in &deadline.waits {
                self.expr(&wait.condition);
                self.places.insert(wait.from);
                self.expr(&wait.time);
            }
            for (_, over) in &deadline.late {
                self.expr(over);
            }
        }
        self.names.extend(self.places.iter().map(|place| of_type(program.places[place.0].ty)));
    }

    fn block(&mut self, statements: &[Statement<'_>]) {
        for one in statements {
            self.statement(one);
        }
    }

    fn statement(&mut self, one: &Statement<'_>) {
        self.names.insert(statement(one));
        match one {
            Statement::Part(_, body) | Statement::Loop { rounds: _, body } => self.block(body),
            Statement::Set(place, value) => {
                self.places.insert(*place);
                self.expr(value);
            }
            Statement::If(condition, then, otherwise) => {
                self.expr(condition);
                self.block(then);
                self.block(otherwise);
            }
            Statement::Match(place, arms, otherwise) => {
                self.places.insert(*place);
                for (_, body) in arms {
                    self.block(body);
                }
                self.block(otherwise);
            }
            Statement::Run(run) => {
                for (_, value) in &run.binds {
                    self.expr(value);
                }
                for write in &run.writes {
                    self.places.extend([Some(write.to), write.noted].into_iter().flatten());
                }
            }
            Statement::Call(_, phase, args) => {
                self.expr(phase);
                self.exprs(args);
            }
            Statement::Fence(kind) => _ = self.names.insert(fence(*kind)),
            Statement::Break | Statement::Mark(_) => {}
        }
    }

    fn exprs(&mut self, all: &[Expr<'_>]) {
        for one in all {
            self.expr(one);
        }
    }

    fn expr(&mut self, one: &Expr<'_>) {
        self.names.insert(expression(one));
        match one {
            Expr::Value(_) | Expr::Input(_) | Expr::Now => {}
            Expr::Place(place)
            | Expr::Initial(place)
            | Expr::Is(place, _)
            | Expr::Table(place, _)
            | Expr::Next(place) => _ = self.places.insert(*place),
            Expr::Not(inner) => self.expr(inner),
            Expr::All(parts) | Expr::Any(parts) => self.exprs(parts),
            Expr::Choose(parts) => self.exprs(&parts[..]),
            Expr::Compare(kind, a, b) => {
                self.names.insert(comparison(*kind));
                self.expr(a);
                self.expr(b);
            }
            Expr::Add(a, b) | Expr::Sub(a, b) | Expr::Since(a, b) | Expr::Period(a, b, _) => {
                self.expr(a);
                self.expr(b);
            }
            Expr::User(user) => {
                for (_, value) in &user.binds {
                    self.expr(value);
                }
            }
        }
    }
}
