//! No loop of the parser can turn for ever: each asks whether its last turn has moved on, or moves in its condition.

use std::path::Path;

use quote::ToTokens;
use syn::visit_mut::{self, VisitMut};

/// What moves a cursor, or asks whether it has moved.
const MOVES: [&str; 3] = ["turns . more (", ". eat", ". bump ("];

/// Files that go through tokens with a number of their own, or not through tokens.
const OTHERS: [&str; 4] = ["buffer.rs", "input.rs", "time.rs", "fragments.rs"];

#[derive(Default)]
struct Loops {
    seen: usize,
    unsure: Vec<String>,
}

impl VisitMut for Loops {
    fn visit_expr_while_mut(&mut self, repeated: &mut syn::ExprWhile) {
        self.note(&repeated.cond.to_token_stream().to_string());
        visit_mut::visit_expr_while_mut(self, repeated);
    }

    fn visit_expr_loop_mut(&mut self, repeated: &mut syn::ExprLoop) {
        self.note("loop");
        visit_mut::visit_expr_loop_mut(self, repeated);
    }
}

impl Loops {
    fn note(&mut self, condition: &str) {
        self.seen += 1;
        if !MOVES.iter().any(|moves| condition.contains(moves)) {
            self.unsure.push(condition.to_owned());
        }
    }
}

#[test]
fn no_loop_of_the_parser_turns_without_progress() {
    let mut loops = Loops::default();
    for entry in Path::new(env!("CARGO_MANIFEST_DIR")).join("src/parse").read_dir().expect("a folder") {
        let path = entry.expect("a file").path();
        if OTHERS.iter().any(|other| path.ends_with(other)) {
            continue;
        }
        let text = std::fs::read_to_string(&path).expect("a text");
        loops.visit_file_mut(&mut syn::parse_file(&text).expect("Rust"));
    }
    assert!(loops.seen > 10, "{} loops", loops.seen);
    assert!(loops.unsure.is_empty(), "{:?}", loops.unsure);
}
