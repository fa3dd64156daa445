//! The rows of lines between two layers.

use super::{Channel, Net, Purpose};

fn rows(nets: Vec<(Vec<i32>, Vec<i32>)>) -> Channel {
    let net = |(uppers, lowers)| Net::new(uppers, lowers, false, Purpose::Spread);
    let nets: Vec<Net> = nets.into_iter().map(net).collect();
    let count = nets.len();
    let mut channel = Channel { nets, ways: Vec::new(), ranks: Vec::new(), rank_row: 0, height: 0 };
    channel.rows(count, true, true);
    channel
}

/// The horizontal lines of a net: the row, from where to where.
fn lines(net: &Net) -> Vec<(i32, (i32, i32))> {
    let upper = net.upper_span().map(|span| (net.top(), span));
    [Some((net.row, net.span())), upper].into_iter().flatten().collect()
}

/// Where lines of two nets run on one stretch.
fn shared(channel: &Channel) -> Vec<String> {
    let mut shared = Vec::new();
    for (number, net) in channel.nets.iter().enumerate() {
        for other in channel.nets.iter().enumerate().filter(|(other, _)| *other != number).map(|(_, other)| other) {
            let down = net.lowers.iter().filter(|x| other.uppers.contains(x) && net.row <= other.top());
            shared.extend(down.map(|x| format!("{number} goes down at {x}, where another comes down")));
            let bend = net.bend.filter(|(x, _)| other.uppers.contains(x) || other.lowers.contains(x));
            shared.extend(bend.map(|(x, _)| format!("{number} bends at {x}, where another is")));
            for (row, (left, right)) in lines(net) {
                let touching =
                    lines(other).into_iter().filter(|(r, (from, to))| *r == row && left <= *to && *from <= right);
                shared.extend(touching.map(|_| format!("{number} and another in row {row}")));
            }
        }
    }
    shared
}

#[test]
fn nets_that_hold_each_other_in_a_circle_do_not_touch() {
    let two = rows(vec![(vec![0], vec![20]), (vec![20], vec![0])]);
    assert_eq!(shared(&two), Vec::<String>::new());
    assert_eq!(two.nets.iter().filter(|net| net.bend.is_some()).count(), 1);
    let three = rows(vec![(vec![0], vec![4, 8]), (vec![4], vec![10]), (vec![10], vec![0, 2])]);
    assert_eq!(shared(&three), Vec::<String>::new());
    assert_eq!(rows(vec![(vec![0], vec![4]), (vec![4], vec![8])]).nets[0].bend, None, "one after the other");
}

/// From every place at most one line comes down, and to every place at most one goes down, as between two layers.
#[test]
fn nets_of_any_kind_do_not_touch() {
    let mut seed = 1_u32;
    let mut random = |below: usize| {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        usize::try_from(seed >> 8).unwrap_or(0) % below
    };
    let mut bends = 0;
    for _ in 0..3000 {
        let mut places = || {
            let mut places: Vec<i32> = (0..12).map(|place| place * 2).collect();
            (0..places.len()).for_each(|at| places.swap(at, random(12)));
            places
        };
        let (mut above, mut below) = (places(), places());
        let nets = (0..2 + random(4)).map(|_| {
            let count = 1 + random(2);
            (above.split_off(above.len() - 1), below.split_off(below.len() - count))
        });
        let channel = rows(nets.collect());
        assert_eq!(shared(&channel), Vec::<String>::new());
        bends += channel.nets.iter().filter(|net| net.bend.is_some()).count();
    }
    assert!(bends > 20, "only {bends} circles");
}
