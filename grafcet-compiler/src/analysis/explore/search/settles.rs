//! Whether every search for stability comes to its end (A30), found out by trying.

use super::Search;
use super::graph::{Graph, Seen};
use crate::analysis::Facts;
use crate::analysis::explore::net::Net;
use crate::analysis::explore::net::formula::Atom;
use crate::model::Model;

/// Whether every search for stability of a `grafcet` comes to its end before the bound, whatever the inputs are; `false` also
/// where so many units of work do not suffice to find out.
#[must_use]
pub fn settles(model: &Model, facts: &Facts<'_>, work: u64) -> bool {
    let net = Net::of(model, facts, &[], &[]);
    if !is_followed(&net) {
        return false;
    }
    let mut seen = Seen::nothing(&net);
    let (graph, _) = Search::new(&net, None, false, work, &mut seen).while_it_settles().run();
    settled(&net, &graph)
}

/// Whether what was tried in all combinations shows it.
pub(crate) fn settled(net: &Net, graph: &Graph) -> bool {
    graph.complete && !graph.unstable && is_followed(net)
}

/// Whether the values of all atoms are known at each moment of a cycle.
pub(crate) fn is_followed(net: &Net) -> bool {
    net.atoms.values().all(Atom::is_exact)
}
