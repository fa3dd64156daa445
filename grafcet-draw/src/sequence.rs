//! The main sequence of a net: what goes on straight, whichever branch is written first.
//!
//! Of the branches after a step, the one with the longest way leads on. A step to which one goes from many places on a way, as
//! where a fault is dealt with, is no part of that way, however much follows it.

use crate::search::Search;
use crate::sorted::{List, sort_by_key};

/// From so many steps on one way a step is reached that is no part of it.
const MANY: usize = 3;

/// What leads on straight.
pub(crate) struct Sequence {
    /// After each node, the transition of the main branch.
    pub(crate) main: Vec<Option<usize>>,
    /// From a node to a transition, and from a transition to a node, with the number of the sequence they belong to: the main one
    /// of the net is the first.
    pub(crate) down: Vec<(usize, usize, usize)>,
    pub(crate) on: Vec<(usize, usize, usize)>,
}

impl Sequence {
    /// How many steps the sequence has that begins at a node.
    pub(crate) fn length(&self, mut node: usize) -> usize {
        let mut length = 1;
        let next = |node: usize| {
            let (_, link, number) = self.down.iter().find(|way| way.0 == node)?;
            self.on.iter().find(|way| (way.0, way.2) == (*link, *number)).map(|way| way.1)
        };
        // What leads down comes to an end.
        while let Some(lower) = next(node) {
            (node, length) = (lower, length + 1);
        }
        length
    }
}

/// The sequences of a net in which is known what leads down; `layers` are those of its nodes.
pub(crate) fn sequence(search: &Search<'_>, layers: &[usize]) -> Sequence {
    let lengths = Lengths::of(search, layers);
    let count = search.out.len();
    let main = (0..count).map(|node| lengths.main(node)).list();
    let mut sequence = Sequence { main, down: Vec::new(), on: Vec::new() };
    let mut starts = (0..count).list();
    sort_by_key(&mut starts, |node| search.node_key[*node]);
    let (mut nodes, mut links) = (vec![false; count], vec![false; search.sources.len()]);
    for (number, start) in starts.into_iter().enumerate() {
        let mut node = start;
        // Where another sequence has been before, this one ends.
        while let Some(link) = sequence.main[node].filter(|link| !nodes[node] && !links[*link]) {
            (nodes[node], links[link]) = (true, true);
            sequence.down.push((node, link, number));
            let Some(next) = search.forward[link].iter().copied().find(|next| !nodes[*next]) else { break };
            sequence.on.push((link, next, number));
            node = next;
        }
    }
    sequence
}

/// How many steps are on the longest way after each transition.
struct Lengths<'s> {
    search: &'s Search<'s>,
    /// Without what follows steps that are reached from everywhere.
    own: Vec<usize>,
    long: Vec<usize>,
}

impl<'s> Lengths<'s> {
    fn of(search: &'s Search<'s>, layers: &[usize]) -> Self {
        let links = search.sources.len();
        let mut order = (0..search.out.len()).list();
        sort_by_key(&mut order, |node| layers[*node]);
        let aside = aside(search, &order);
        let mut lengths = Self { search, own: vec![0; links], long: vec![0; links] };
        let mut before = vec![Vec::new(); search.out.len()];
        for (link, node) in
            search.forward.iter().enumerate().flat_map(|(link, nodes)| nodes.iter().map(move |n| (link, n)))
        {
            before[*node].push(link);
        }
        for node in order.into_iter().rev() {
            let most = |of: &[usize]| search.out[node].iter().map(|link| of[*link]).max().unwrap_or(0) + 1;
            let (own, long) = (most(&lengths.own), most(&lengths.long));
            for link in &before[node] {
                lengths.long[*link] = lengths.long[*link].max(long);
                if !aside[node] {
                    lengths.own[*link] = lengths.own[*link].max(own);
                }
            }
        }
        lengths
    }

    /// The main branch after a node: the longest; then one that begins anew; the first of those that are equal.
    fn main(&self, node: usize) -> Option<usize> {
        let merit = |link: &usize| {
            let anew = self.search.targets[*link].iter().any(|next| self.search.top[*next]);
            (self.own[*link], anew, self.long[*link])
        };
        self.search.out[node].iter().rev().max_by_key(|link| merit(link)).copied()
    }
}

/// The nodes that are reached from many nodes of which each leads to the next; `order` is that of the layers.
fn aside(search: &Search<'_>, order: &[usize]) -> Vec<bool> {
    let mut before = vec![Vec::new(); order.len()];
    for node in order {
        for next in search.out[*node].iter().flat_map(|link| &search.forward[*link]) {
            if before[*next].last() != Some(node) {
                before[*next].push(*node);
            }
        }
    }
    let chain = |nodes: &Vec<usize>| {
        // How many are on the longest way to each, itself included.
        let mut most = vec![1; nodes.len()];
        for (upper, node) in nodes.iter().enumerate().filter(|_| nodes.len() >= MANY) {
            let reached = reached(search, *node);
            for (lower, _) in nodes.iter().enumerate().skip(upper + 1).filter(|(_, lower)| reached[**lower]) {
                most[lower] = most[lower].max(most[upper] + 1);
            }
        }
        most.into_iter().max().unwrap_or(0)
    };
    before.iter().map(|nodes| chain(nodes) >= MANY).list()
}

/// What a node leads down to.
fn reached(search: &Search<'_>, node: usize) -> Vec<bool> {
    let mut reached = vec![false; search.out.len()];
    let mut next = vec![node];
    while let Some(node) = next.pop() {
        for lower in search.out[node].iter().flat_map(|link| &search.forward[*link]) {
            if !std::mem::replace(&mut reached[*lower], true) {
                next.push(*lower);
            }
        }
    }
    reached
}
