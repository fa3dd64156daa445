//! Which parts of a round a part leads, and when the others are done.

use super::turn::Turn;

/// Of the parts after one that leads.
pub(super) struct Order {
    /// Done in front of it: it does not lead them, and those that it leads come after them.
    pub(super) before: Vec<usize>,
    /// They ask for the state that it leads to, or are led by one that does, or come between such parts.
    pub(super) led: Vec<usize>,
    /// Done after those.
    pub(super) beside: Vec<usize>,
}

impl Turn<'_, '_, '_> {
    /// Which of the parts after a part it leads.
    pub(super) fn order(&self, at: usize, next: &[usize]) -> Order {
        let mut regions = self.written[at].clone();
        let mut order = Order { before: Vec::new(), led: Vec::new(), beside: Vec::new() };
        for part in next {
            if self.asking[*part].iter().any(|(region, _)| regions.contains(region)) {
                regions.extend(self.written[*part].iter().copied());
                order.led.push(*part);
            } else {
                order.beside.push(*part);
            }
        }
        // What is beside is done afterwards, and must not be needed before.
        let may_swap = |one: usize, other: usize| self.effects[one].may_swap(&self.effects[other]);
        let is_needed = |part: usize, led: &[usize]| led.iter().any(|other| *other > part && !may_swap(part, *other));
        while let Some(place) = order.beside.iter().position(|part| is_needed(*part, &order.led)) {
            let part = order.beside.remove(place);
            let mut passed = order.led.iter().chain(&order.beside).filter(|other| **other < part);
            if may_swap(part, at) && passed.all(|other| may_swap(part, *other)) {
                order.before.push(part);
            } else {
                order.led.push(part);
                // These may have to come after it.
                order.beside.append(&mut order.before);
                order.led.sort_unstable();
                order.beside.sort_unstable();
            }
        }
        order.before.sort_unstable();
        if order.led.iter().all(|part| self.written[*part].is_empty()) {
            order.led.clear();
        }
        order
    }
}
