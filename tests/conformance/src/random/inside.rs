//! Steps with something in them: macro-steps and enclosing steps.

use super::Gen;
use super::structure::{Inner, Part, Room, Step};

impl Gen {
    /// A step that stands for a sequence.
    pub(super) fn macro_step(&mut self, part: &mut Part, room: &Room) -> String {
        self.note("macro-step");
        let mut body = Part::default();
        let entry = self.plain(&mut body, "entry ");
        let mut inner = Room { steps: self.rng.below(3), depth: room.depth - 1 };
        let mut last = entry.clone();
        while inner.steps > 0 {
            last = self.grow(&mut body, last, &mut inner);
        }
        let exit = self.plain(&mut body, "exit ");
        body.arrow(&[last], &[&exit], None);
        if self.rng.chance(25) {
            body.arrow(&[exit], &[entry], None);
        }
        let name = self.fresh('M');
        let inner = Inner::Macro(Box::new(body));
        part.steps.push(Step { words: "macro ".to_owned(), name: name.clone(), inner, forces: Vec::new() });
        name
    }

    /// A step with partial grafcets in it.
    pub(super) fn enclosing(&mut self, part: &mut Part, room: &Room) -> String {
        self.note("enclosing step");
        if room.depth == 1 {
            self.note("enclosing or macro-step inside another");
        }
        let name = self.fresh('S');
        let mut enclosed = Vec::new();
        for _ in 0..self.rng.between(1, 2) {
            let mut body = Part { name: Some(self.fresh('G')), ..Part::default() };
            let mut inner = Room { steps: self.rng.between(1, 3), depth: room.depth - 1 };
            // A macro-step cannot carry the link.
            let nested = inner.depth > 0 && self.rng.chance(20);
            let first = if nested { self.enclosing(&mut body, &inner) } else { self.plain(&mut body, "") };
            self.body(&mut body, &first, &mut inner);
            let count = body.steps.len();
            let carriers: Vec<usize> =
                (0..count).filter(|index| !matches!(body.steps[*index].inner, Inner::Macro(_))).collect();
            let linked = *self.rng.pick(&carriers);
            body.steps[linked].words.insert_str(0, "linked ");
            let initial = *self.rng.pick(&carriers);
            body.steps[initial].words.insert_str(0, "initial ");
            self.ends(&mut body);
            enclosed.push(body);
        }
        let inner = Inner::Enclosed(enclosed);
        part.steps.push(Step { words: "enclosing ".to_owned(), name: name.clone(), inner, forces: Vec::new() });
        name
    }
}
