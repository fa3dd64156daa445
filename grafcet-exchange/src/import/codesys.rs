//! What CODESYS says of a step beside the words of PLCopen: actions that belong to the step itself, times, a comment.

use std::collections::BTreeMap;

use roxmltree::Node;

use super::source::{Block, Piece, Span, Step, What};
use super::xml::{head, is, one_line, words};

/// The attributes of a step, by which its tool knows them.
mod guid {
    pub(super) const COMMENT: &str = "7d894980-aeea-405c-a0f6-e2b26429c58f";
    pub(super) const EXCLUDED: &str = "01580b27-6378-448b-8ecb-0e4b795b58d6";
    pub(super) const LEAST: &str = "cacf1a68-236e-47c2-b7b1-1cf9199718cb";
    pub(super) const MOST: &str = "b693554c-1b01-4a8d-afde-9e3a46f7465d";
    pub(super) const MAIN: &str = "700a583f-b4d4-43e4-8c14-629c7cd3bec8";
    pub(super) const ENTRY: &str = "a6b08bd8-b696-47e3-9cbf-7408b61c9ff8";
    pub(super) const EXIT: &str = "a2621e18-7de3-4ea6-ae6d-89e9e0b7befd";
}

/// With all that the tool says of it.
pub(super) fn step(element: Node<'_, '_>, mut step: Step, lost: &mut Vec<(Span, String)>) -> Step {
    let mut said = BTreeMap::new();
    let data = element.children().filter(|child| is(child, "addData"));
    for one in data.flat_map(|data| data.descendants().collect::<Vec<_>>()).filter(|node| is(node, "attribute")) {
        let text = words(one);
        if let (Some(guid), false) = (one.attribute("guid"), text.is_empty()) {
            said.insert(guid.to_lowercase(), (text, head(one)));
        }
    }
    for (guid, qualifier) in [(guid::ENTRY, "P1"), (guid::MAIN, "N"), (guid::EXIT, "P0")] {
        if let Some((name, at)) = said.get(guid) {
            let what = What::Named(name.clone());
            step.blocks.push(Block { at: at.clone(), qualifier: qualifier.to_owned(), time: None, what });
        }
    }
    if let (true, Some((text, _))) = (step.note.is_empty(), said.get(guid::COMMENT)) {
        step.note = one_line(text);
    }
    if let Some((text, at)) = said.get(guid::MOST) {
        step.within = Some(Piece { text: text.clone(), at: at.clone(), language: None });
    }
    if let Some((text, at)) = said.get(guid::LEAST) {
        lost.push((
            at.clone(),
            format!("that the step `{}` takes {text} at least: say so in what leaves it", step.name),
        ));
    }
    if let Some((text, at)) = said.get(guid::EXCLUDED) {
        if text.eq_ignore_ascii_case("true") {
            lost.push((at.clone(), format!("that the step `{}` is excluded from the program", step.name)));
        }
    }
    step
}
