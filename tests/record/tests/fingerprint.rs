//! The fingerprint of a chart is found in its source.

use std::fs;
use std::path::Path;

use grafcet::record::Recordable;
use grafcet_record::{cell::Cell, controller, motor::Motor, recipe::Dyer, tickless::Crossing};
use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// The charts in a file.
fn charts(tokens: TokenStream, found: &mut Vec<TokenStream>) {
    let mut tokens = tokens.into_iter().peekable();
    while let Some(token) = tokens.next() {
        let is_macro = matches!(&token, TokenTree::Ident(name) if name == "grafcet");
        if is_macro
            && tokens.next_if(|next| matches!(next, TokenTree::Punct(punct) if punct.as_char() == '!')).is_some()
        {
            if let Some(TokenTree::Group(group)) = tokens.next() {
                assert_eq!(group.delimiter(), Delimiter::Brace);
                found.push(group.stream());
            }
        }
    }
}

fn fingerprints(file: &str) -> Vec<u32> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/charts").join(file);
    let source = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let mut found = Vec::new();
    charts(source.parse().expect("tokens"), &mut found);
    found.iter().map(grafcet_compiler::fingerprint::of).collect()
}

#[test]
fn the_macro_and_the_library_agree() {
    assert_eq!(fingerprints("motor.rs"), [Motor::FINGERPRINT]);
    assert_eq!(fingerprints("cell.rs"), [Cell::FINGERPRINT]);
    assert_eq!(fingerprints("recipe.rs"), [Dyer::FINGERPRINT]);
    assert_eq!(fingerprints("tickless.rs"), [Crossing::FINGERPRINT]);
    assert_eq!(fingerprints("controller.rs"), [controller::Called::FINGERPRINT, controller::Remote::FINGERPRINT]);
}
