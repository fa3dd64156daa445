//! What a chart assumes that excludes everything or nothing, and plants in which nothing moves: then what is proved says nothing.

use grafcet_compiler::analysis::Question;
use grafcet_prove::{Internal, is_so};

use super::{Asked, Said, text};

impl Asked<'_> {
    /// Each with what it is about.
    pub(super) fn says_nothing(&self) -> Result<Vec<(String, Said)>, Internal> {
        let model = self.program.model;
        let mut all = Vec::new();
        for question in Question::of_assumptions(model) {
            if is_so(self.circuit, question, &self.limit(None))?.is_none() {
                continue;
            }
            let (what, verdict, line) = match question {
                Question::NoCycle => {
                    let line = "with what is assumed no cycle comes to its end, so that every property holds: correct the assumptions";
                    return Ok(vec![("assume".to_owned(), said("excludes everything", line))]);
                }
                Question::NeverComes(number) => (
                    format!("assume often {}", model.often[number].text),
                    "excludes everything",
                    "it never comes, so that every `leads_to` holds: correct it",
                ),
                Question::SaysNothing(number) => (
                    text(model.orders[number].mark, self.chart),
                    "excludes nothing",
                    "what it is about holds at the end of no cycle: correct it, or leave it out",
                ),
                Question::StandsStill(number) => (
                    format!("plant {}", model.plants.list[number].model.name),
                    "stands still",
                    "it stays where it begins, whatever the chart does, so what is proved says nothing of it: look at what its transitions wait for",
                ),
                _ => continue,
            };
            all.push((what, said(verdict, line)));
        }
        Ok(all)
    }
}

fn said(verdict: &'static str, line: &str) -> Said {
    Said { lines: vec![line.to_owned()], ..Said::of(verdict) }
}
