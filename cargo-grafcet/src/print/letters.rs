//! Letters: the font `DejaVu Sans Mono` is part of the tool, so that a print looks the same on every machine.

use std::collections::BTreeSet;
use std::sync::Arc;

use resvg::usvg::fontdb::Database;
use resvg::usvg::{self, Group, Node, Options, Tree};

pub(super) struct Letters {
    options: Options<'static>,
    /// The signs that the font does not have.
    pub(super) missing: BTreeSet<char>,
}

impl Letters {
    pub(super) fn new() -> Self {
        let mut fonts = Database::new();
        fonts.load_font_data(dejavu::sans_mono::regular().to_vec());
        fonts.set_monospace_family("DejaVu Sans Mono");
        let options =
            Options { fontdb: Arc::new(fonts), font_family: "DejaVu Sans Mono".to_owned(), ..Options::default() };
        Self { options, missing: BTreeSet::new() }
    }

    /// A picture with its texts in place.
    pub(super) fn tree(&mut self, svg: &str) -> Result<Tree, usvg::Error> {
        let tree = Tree::from_str(svg, &self.options)?;
        missing(tree.root(), &mut self.missing);
        Ok(tree)
    }
}

fn missing(group: &Group, to: &mut BTreeSet<char>) {
    for node in group.children() {
        match node {
            Node::Group(group) => missing(group, to),
            Node::Text(text) => {
                // Glyph 0 of a font is the one of what it does not have.
                let glyphs = text.layouted().iter().flat_map(|span| &span.positioned_glyphs);
                to.extend(glyphs.filter(|glyph| glyph.id.0 == 0).flat_map(|glyph| glyph.text.chars()));
            }
            Node::Path(_) | Node::Image(_) => {}
        }
    }
}
