//! Statements and parts as they are before each region is looked at by itself.

use super::super::super::{Expr, PlaceInfo, Role, Statement};
use super::super::fold::initial;
use super::super::parts::Part;
use super::super::uses::{Effects, each_written};
use crate::sorted::Set;

/// What comes after a part and concerns some of its regions alone is looked at with it.
pub(super) fn join_wide(parts: &mut Vec<Part<'_>>, places: &[PlaceInfo<'_>]) {
    let mut at = 0;
    while at < parts.len() {
        let mut decides = false;
        each_written(&parts[at].statements, &mut |place| decides |= matches!(places[place.0].role, Role::State(_)));
        while decides && parts[at].regions.len() > 1 && at + 1 < parts.len() {
            let next = &parts[at + 1];
            if next.regions.is_empty() || !next.regions.is_subset(&parts[at].regions) {
                break;
            }
            let mut next = parts.remove(at + 1);
            parts[at].statements.append(&mut next.statements);
        }
        at += 1;
    }
}

/// A truth that is only there to be copied to a place is that place.
pub(super) fn direct(places: &[PlaceInfo<'_>], list: &mut Vec<Statement<'_>>) {
    let mut mentioned: Vec<Vec<usize>> = vec![Vec::new(); places.len()];
    for (at, statement) in list.iter().enumerate() {
        let effects = Effects::of(statement);
        for place in effects.reads.iter().chain(effects.writes.difference(&effects.reads)) {
            mentioned[place.0].push(at);
        }
    }
    let mut gone = Set::new();
    for at in (0..list.len()).rev() {
        let Statement::Set(to, Expr::Place(from)) = list[at] else { continue };
        let (here, there) = (&places[to.0], &places[from.0]);
        let alike = !here.is_field && !there.is_field && initial(here) == initial(there) && initial(here).is_some();
        let [set, copied] = mentioned[from.0][..] else { continue };
        if !alike || copied != at || mentioned[to.0].first() != Some(&at) {
            continue;
        }
        if let Statement::Set(place, _) = &mut list[set] {
            *place = to;
            gone.insert(at);
            mentioned[to.0][0] = set;
        }
    }
    let mut at = 0;
    list.retain(|_| {
        at += 1;
        !gone.contains(&(at - 1))
    });
}
