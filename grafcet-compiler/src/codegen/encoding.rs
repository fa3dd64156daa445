//! What the documentation of a chart's type says about its encoding.

use super::{Cx, names};
use crate::list::{List, PushAll};
use crate::plan::{Region, RegionId};

/// How many sets of steps, and of each how many steps, are named.
const NAMED: usize = 8;

impl Cx<'_> {
    /// How the situation is stored and in how many bytes; nothing for a chart without steps.
    pub(super) fn encoding(&self) -> Option<String> {
        let regions = self.plan.regions.all();
        if regions.is_empty() {
            return None;
        }
        if self.plan.shape.is_flags() {
            return Some(self.encoding_of_flags());
        }
        let bytes = bytes((0..regions.len()).map(|region| self.region_bytes(region)).sum());
        let [region] = regions else {
            let mut sets: Vec<_> = regions.iter().take(named(regions.len())).map(|region| self.set(region)).list();
            sets.push_all(more(regions.len()));
            let sets = sets.join("\n- ");
            return Some(format!(
                "The situation takes {bytes}: for each of these sets of steps, which of them is active, if any. No two of \
                 a set are active together.\n\n- {sets}"
            ));
        };
        let active = if region.may_be_empty { "is active, if any" } else { "is active" };
        Some(match region.steps.len() {
            1 => format!("The situation takes {bytes}: whether its step {active}."),
            count => format!("The situation takes {bytes}: which of its {count} steps {active}."),
        })
    }

    fn encoding_of_flags(&self) -> String {
        let mut bits = vec![match self.model.steps.len() {
            1 => "a bit for its step".to_owned(),
            count => format!("a bit for each of its {count} steps"),
        }];
        if self.plan.has_start {
            bits.push("one for the first cycle, as long as it is still to come".to_owned());
        }
        if self.plan.may_be_unstable {
            bits.push("one for a search that did not become stable".to_owned());
        }
        let last = bits.pop().unwrap_or_default();
        let first = if bits.is_empty() { String::new() } else { format!("{} and ", bits.join(", ")) };
        format!("The situation takes {} (`encoding flags;`): {first}{last}.", bytes(self.flag_bytes()))
    }

    /// The size of a region's field.
    fn region_bytes(&self, region: RegionId) -> usize {
        let states = self.states(region);
        // The mark of an unstable search stands above the states.
        let values = if self.is_marked(region) { 2 * states.next_power_of_two() } else { states };
        if values > 256 { 2 } else { 1 }
    }

    /// `` `Fill`, `Heat` ``
    fn set(&self, region: &Region) -> String {
        let named = region.steps.iter().take(named(region.steps.len()));
        let named = named.map(|step| format!("`{}`", names::private_variant(self.model, *step)));
        named.and(more(region.steps.len())).list().join(", ")
    }
}

/// How many of so many are named: a last single one takes no more room than the words that there is one more.
fn named(count: usize) -> usize {
    if count == NAMED + 1 { count } else { NAMED }
}

/// What is not named of so many.
fn more(count: usize) -> Option<String> {
    (count > named(count)).then(|| format!("{} more", count - NAMED))
}

fn bytes(count: usize) -> String {
    if count == 1 { "one byte".to_owned() } else { format!("{count} bytes") }
}
