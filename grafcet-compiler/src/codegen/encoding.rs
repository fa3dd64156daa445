//! What the documentation of a chart's type says about its encoding.

use super::machine::Machine;
use super::program::Flags;
use super::state::StateEnum;
use super::{Cx, names, state};
use crate::list::{List, PushAll};
use crate::model::{Id, StepId};

/// How many sets of steps, and of each how many steps, are named.
const NAMED: usize = 8;

impl Cx<'_> {
    /// How the situation is stored and in how many bytes; nothing for a chart without steps.
    pub(super) fn encoding(&self, machine: &Machine<'_>) -> Option<String> {
        if self.plan.regions.all().is_empty() {
            return None;
        }
        if let Some(flags) = machine.flags {
            return Some(of_flags(flags));
        }
        let regions = &machine.regions;
        let bytes = bytes(regions.iter().map(|region| self.region_bytes(region)).sum());
        let sets = regions.iter().map(|StateEnum { region, .. }| {
            let homes = self.model.steps.ids().zip(&machine.homes);
            homes.filter(|(_, (home, _))| home == region).map(|(step, _)| step).list()
        });
        let sets: Vec<Vec<StepId>> = sets.list();
        let is_united = sets.iter().any(|steps| is_united(machine, steps));
        let [steps] = &sets[..] else {
            let all = sets.iter().zip(regions).take(named(sets.len()));
            let mut listed: Vec<_> = all.map(|(steps, region)| self.set(machine, steps, region)).list();
            listed.push_all(more(sets.len()));
            let (sets, unless) =
                (listed.join("\n- "), if is_united { ", unless it says in how many ways" } else { "" });
            return Some(format!(
                "The situation takes {bytes}: for each of these sets of steps, which of them is active, if any. No two of \
                 a set are active together{unless}.\n\n- {sets}"
            ));
        };
        let region = &self.plan.regions.all()[0];
        let active = if region.may_be_empty { "is active, if any" } else { "is active" };
        Some(match steps.len() {
            1 => format!("The situation takes {bytes}: whether its step {active}."),
            count if is_united => format!(
                "The situation takes {bytes}: in which of {} ways its {count} steps are active.",
                regions[0].states.len()
            ),
            count => format!("The situation takes {bytes}: which of its {count} steps {active}."),
        })
    }

    /// The size of a region's field.
    fn region_bytes(&self, region: &StateEnum) -> usize {
        let states = state::variants(self, region).len();
        // The mark of an unstable search stands above the states.
        let values = if region.marked { 2 * states.next_power_of_two() } else { states };
        if values > 256 { 2 } else { 1 }
    }

    /// `` `Fill`, `Heat` ``
    fn set(&self, machine: &Machine<'_>, steps: &[StepId], region: &StateEnum) -> String {
        let named = steps.iter().take(named(steps.len()));
        let named = named.map(|step| format!("`{}`", names::private_variant(self.model, *step)));
        let set = named.and(more(steps.len())).list().join(", ");
        if is_united(machine, steps) { format!("{set}: in {} ways", region.states.len()) } else { set }
    }
}

fn of_flags(flags: Flags) -> String {
    let mut bits = vec![match flags.steps {
        1 => "a bit for its step".to_owned(),
        count => format!("a bit for each of its {count} steps"),
    }];
    if flags.start {
        bits.push("one for the first cycle, as long as it is still to come".to_owned());
    }
    if flags.unstable {
        bits.push("one for a search that did not become stable".to_owned());
    }
    let last = bits.pop().unwrap_or_default();
    let first = if bits.is_empty() { String::new() } else { format!("{} and ", bits.join(", ")) };
    format!("The situation takes {} (`encoding flags;`): {first}{last}.", bytes(flags.bytes()))
}

/// Whether some of the steps are active together.
fn is_united(machine: &Machine<'_>, steps: &[StepId]) -> bool {
    steps.iter().any(|step| machine.homes[step.index()].1 != [*step])
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
