//! What a chart assumes that excludes everything or nothing, and plants in which nothing moves: then what is proved says nothing.

use grafcet_prove::aig::Lit;
use grafcet_prove::{Internal, never, says_nothing};

use super::{Asked, Said, text};

impl Asked<'_> {
    /// Each with what it is about.
    pub(super) fn says_nothing(&self) -> Result<Vec<(String, Said)>, Internal> {
        let (model, circuit) = (self.program.model, self.circuit);
        let holds = |wire: Lit| never(circuit, wire, &self.limit(None)).map(|proof| proof.is_some());
        let said = |verdict: &'static str, line: &str| Said { lines: vec![line.to_owned()], ..Said::of(verdict) };
        let plants = &model.plants.list;
        let assumes = !model.assumptions.is_empty() || !model.orders.is_empty();
        if (assumes || plants.iter().any(|plant| !plant.model.assumptions.is_empty())) && holds(Lit::TRUE)? {
            let line =
                "with what is assumed no cycle comes to its end, so that every property holds: correct the assumptions";
            return Ok(vec![("assume".to_owned(), said("excludes everything", line))]);
        }
        let mut all = Vec::new();
        for (often, comes) in model.often.iter().zip(&circuit.often) {
            if holds(*comes)? {
                let line = "it never comes, so that every `leads_to` holds: correct it";
                all.push((format!("assume often {}", often.text), said("excludes everything", line)));
            }
        }
        for (number, order) in model.orders.iter().enumerate() {
            if says_nothing(circuit, number, &self.limit(None))?.is_some() {
                let line = "what it is about holds at the end of no cycle: correct it, or leave it out";
                all.push((text(order.mark, self.chart), said("excludes nothing", line)));
            }
        }
        for (plant, moves) in plants.iter().zip(&circuit.moves) {
            if !plant.model.transitions.is_empty() && holds(*moves)? {
                let line = "it stays where it begins, whatever the chart does, so what is proved says nothing of it: look at what its \
                            transitions wait for";
                all.push((format!("plant {}", plant.model.name), said("stands still", line)));
            }
        }
        Ok(all)
    }
}
