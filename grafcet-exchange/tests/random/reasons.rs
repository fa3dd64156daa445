//! How often each reason refuses a random chart: `ST_CHARTS=600 cargo test -p grafcet-exchange --test random -- reasons --nocapture`.

use std::collections::BTreeMap;

use grafcet_exchange::st::{Form, Options, Order, structured_text};

use crate::{CYCLES, FORMS, random, resolved, seeds};

/// Flip-flops can say four charts in five. It prints a table for each dialect and form: how many of the charts each reason refuses, and how many
/// of them by itself alone.
#[test]
fn reasons_are_rare() {
    let (wanted, first) = seeds(60);
    for (grafcet, form, order) in FORMS {
        let taken = printed(grafcet, form, order, wanted, first);
        assert!(form == Form::Case || taken * 5 >= wanted * 4, "{form:?}, grafcet: {grafcet}: {taken} of {wanted}");
    }
}

/// How many of the charts have a translation.
fn printed(grafcet: bool, form: Form, order: Option<Order>, wanted: usize, first: u64) -> usize {
    let (mut all, mut taken, mut seed) = (0, 0, first);
    let mut reasons = BTreeMap::<String, [usize; 2]>::new();
    while all < wanted {
        let made = random::chart(seed, grafcet, CYCLES);
        seed += 1;
        let Some(model) = resolved(&made.chart) else { continue };
        all += 1;
        let Err(refused) = structured_text(&model, &Options { form, order, ..Options::default() }) else {
            taken += 1;
            continue;
        };
        let mut each: Vec<String> = refused.iter().map(|one| without_names(&one.to_string())).collect();
        each.sort();
        each.dedup();
        let alone = each.len() == 1;
        for reason in each {
            let [count, by_itself] = reasons.entry(reason).or_default();
            *count += 1;
            *by_itself += usize::from(alone);
        }
    }
    let dialect = if grafcet { "grafcet" } else { "sfc" };
    println!(
        "\n{dialect}, {form:?}, {order:?}: {taken} of {all} charts have a translation\n| charts | alone | reason |"
    );
    let mut rows: Vec<(String, [usize; 2])> = reasons.into_iter().collect();
    rows.sort_by(|(_, a), (_, b)| b.cmp(a));
    for (reason, [count, alone]) in rows {
        println!("| {count} | {alone} | {reason} |");
    }
    taken
}

/// A message with `_` for what the chart has named.
pub(crate) fn without_names(message: &str) -> String {
    message.split('`').step_by(2).collect::<Vec<_>>().join("_")
}
