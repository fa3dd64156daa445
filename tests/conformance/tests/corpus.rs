//! The corpus against the generated code.

use std::fmt::Write as _;

use grafcet_conformance::{play, reader};

#[allow(clippy::pedantic, unused, missing_docs, reason = "written by the build script")]
mod corpus {
    use grafcet_conformance::Entry;
    include!(concat!(env!("OUT_DIR"), "/corpus.rs"));
    pub(super) const ALL: &[Entry] = CORPUS;
}

/// Every file of the corpus, and all differences at once.
#[test]
fn every_compiled_chart_behaves_as_worked_out_by_hand() {
    let mut failures = String::new();
    for entry in corpus::ALL {
        let played = reader::read(entry.text).and_then(|case| {
            let mut subject = (entry.subject)();
            play::against_the_file(&mut *subject, &case.lines).map_err(|difference| difference.to_string())
        });
        if let Err(error) = played {
            _ = writeln!(failures, "{}: {error}", entry.name);
        }
    }
    assert!(failures.is_empty(), "\n{failures}");
    assert!(corpus::ALL.len() > 200, "only {} charts", corpus::ALL.len());
}
