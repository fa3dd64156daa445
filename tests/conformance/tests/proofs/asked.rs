//! What the macro's feature `prove` says of what the exploration leaves open.

use grafcet_compiler::analysis::Prover;
use grafcet_compiler::{Wanted, compile_with};
use grafcet_conformance::chart;
use proc_macro2::TokenStream;
use quote::quote;

/// The errors of a chart's macro.
fn errors(chart: &str, prover: Option<&Prover>) -> Vec<String> {
    let tokens: TokenStream = chart.parse().expect("tokens");
    chart::errors(&compile_with(&quote!(::grafcet), tokens, Wanted { recorded: false, prover }).to_string())
}

/// What the exploration leaves open, the macro's feature `prove` decides: numbers and times, proved, or refuted by a way that is as short
/// as can be and shows no more than it needs.
#[test]
fn the_compiler_asks_for_what_is_left_open() {
    let chart = |property: &str| {
        format!(
            "sfc Press {{ input start, down: bool; output lower: bool; var parts: u8 = 0; \
             initial step Rest; step Press {{ lower; P1 parts = parts + 1; }} step Full {{ P1 parts = 0; }} \
             Rest -[start && parts < 3]-> Press -[10s/Press || down]-> Rest; Rest -[parts >= 3]-> Full -[!start]-> Rest; {property} }}"
        )
    };
    let said = |property: &str, prover: Option<&Prover>| errors(&chart(property), prover);
    let prover: Option<&Prover> = Some(&grafcet_prove::rule);
    for property in
        ["always parts <= 3;", "never Press.T > 10s;", "always Full.X => parts == 0;", "never 1s/Full && parts > 0;"]
    {
        assert_eq!(said(property, prover), Vec::<String>::new(), "{property}");
        let open = said(property, None);
        assert!(matches!(&open[..], [one] if one.contains("grafcet's feature `prove`")), "{property}: {open:?}");
    }
    let broken = said("never parts > 2;", prover);
    let [message] = &broken[..] else { panic!("{broken:?}") };
    assert!(message.contains("at the end of cycle 6 `parts > 2` holds"), "{message}");
    assert!(message.contains("Rest → Press | Press"), "{message}");
    assert!(!message.contains("start, down"), "one of them is enough: {message}");
    let asked = said("never near(parts);", prover);
    assert!(
        matches!(&asked[..], [one] if one.contains("if the program ever comes to these values of `near(parts)`")),
        "{asked:?}"
    );
    let unknown = said("never parts.count_ones() > 3;", prover);
    assert!(matches!(&unknown[..], [one] if one.contains("a solver was asked, too")), "{unknown:?}");
}

/// What is about several cycles, the macro's feature `prove` decides alone.
#[test]
fn the_compiler_asks_for_what_takes_several_cycles() {
    let said = |property: &str| {
        let chart = format!(
            "sfc Press {{ input start, down, closed: bool; output lower: bool; initial step Rest; step Press {{ lower; }} step Full; \
             Rest -[start]-> Press -[10s/Press || down]-> Full -[closed]-> Rest; {property} }}"
        );
        errors(&chart, Some(&grafcet_prove::rule))
    };
    for property in [
        "Press leads_to Full;",
        "Press leads_to Full within 10s;",
        "assume often closed; Press leads_to Rest;",
        "Press before Full;",
    ] {
        assert_eq!(said(property), Vec::<String>::new(), "{property}");
    }
    for (property, what) in [
        (
            "Press leads_to Full within 9s;",
            "at the end of cycle 3 it is too late: `Press.X` has held, and `Full.X` not since",
        ),
        ("Full before Press;", "at the end of cycle 2 `Press.X` holds, and `Full.X` has not held yet"),
        ("Press leads_to Rest;", "`Press.X` has held, and `Rest.X` never follows where"),
    ] {
        let said = said(property);
        assert!(matches!(&said[..], [one] if one.starts_with(what)), "{property}: {said:?}");
    }
}

/// Stored ones, too, and the macro gets no counterexample that is none.
#[test]
fn what_time_does_to_actions_is_left_to_the_solver() {
    let said = |property: &str| {
        let chart = format!(
            "sfc Oven {{ input start, door: bool; output heat, horn, fan, lamp, bell: bool;
             initial step Idle {{ D 5s horn; R lamp; R bell; }} step Bake {{ L 10s heat; SD 3s fan; DS 3s lamp; SL 3s bell; }}
             step Cool {{ R fan; }} Idle -[start]-> Bake -[30s/Bake]-> Cool -[door && 5s/Cool]-> Idle; {property} }}"
        );
        errors(&chart, Some(&grafcet_prove::rule))
    };
    assert_eq!(said("never horn && Idle.T < 5s;"), Vec::<String>::new());
    // Where thirty seconds pass at once, nobody has seen three.
    for (property, when) in [
        ("never heat;", "cycle 2"),
        ("never horn;", "cycle 2"),
        ("never fan && heat;", "cycle 3"),
        ("always Cool.X => lamp || bell;", "cycle 3"),
        ("never lamp && Cool.X;", "cycle 4"),
    ] {
        let errors = said(property);
        assert!(
            matches!(&errors[..], [one] if one.contains(&format!("at the end of {when} "))),
            "{property}: {errors:?}"
        );
    }
}

/// The page shows what the compiler says of its chart, word for word but for the mend.
#[test]
fn the_chart_of_the_page_is_judged_as_the_page_says() {
    let page = include_str!("../../../../docs/proof.md");
    let chart = page.split("```").find(|part| part.starts_with("text\nsfc Press")).expect("the chart");
    let said = errors(chart.trim_start_matches("text"), Some(&grafcet_prove::rule));
    let [message] = &said[..] else { panic!("{said:?}") };
    let (first, table) = message.split_once("\\n").expect("a table");
    assert!(first.starts_with("at the end of cycle 6 `parts > 2` holds"), "{first}");
    for row in table.split("\\n") {
        assert!(page.contains(&format!("       {row}\n")), "not on the page: {row}");
    }
}

/// So are the lines about several cycles: what stands after each of them is what it is.
#[test]
fn the_lines_of_the_page_about_several_cycles_are_what_it_says() {
    let page = include_str!("../../../../docs/proof.md");
    let block = |start: &str| page.split("```").find(|part| part.starts_with(start)).expect("a block").to_owned();
    let (chart, lines) = (block("text\nsfc Press"), block("text\nstart leads_to"));
    let (chart, _) = chart.trim_start_matches("text").split_once("always parts").expect("properties");
    let mut judged = 0;
    for (line, said) in lines.lines().filter_map(|line| line.split_once(" // ")) {
        let errors = errors(&format!("{chart} assume often down; {line} }}"), Some(&grafcet_prove::rule));
        assert_eq!(errors.is_empty(), said.starts_with("proved"), "{line}: {errors:?}");
        judged += 1;
    }
    assert_eq!(judged, 4);
}

/// What the cookbook allows to be undecided is proved where there is a solver.
#[test]
fn what_the_cookbook_leaves_to_the_solver_is_proved() {
    const ALLOWED: &str = "#![allow(grafcet::property_undecided)]";
    let blocks = include_str!("../../../../docs/cookbook.md").split("```").filter(|block| block.contains(ALLOWED));
    let mut judged = 0;
    for block in blocks {
        let chart = block.split_once("grafcet! {").and_then(|(_, rest)| rest.split_once("\n}")).expect("a chart").0;
        let said = |prover: Option<&Prover>| errors(&chart.replace(ALLOWED, ""), prover);
        assert_eq!(said(Some(&grafcet_prove::rule)), Vec::<String>::new());
        assert!(!said(None).is_empty(), "nothing is left to the solver");
        judged += 1;
    }
    assert_eq!(judged, 3);
}

/// What never happens, and what the assumptions leave, where it takes values and times to see that.
#[test]
fn what_says_nothing_is_found_by_the_solver() {
    let said = |lines: &str, prover: Option<&Prover>| {
        let chart = format!(
            "sfc Press {{ #![deny(grafcet::vacuous_property, grafcet::vacuous_assumption)] \
             input start, down: bool; #[allow(grafcet::unused_input)] input x, y: u64; input level: u8; output lower: bool; var parts: u8 = 0; \
             initial step Rest; step Press {{ lower; P1 parts = parts + 1; }} step Full {{ P1 parts = 0; }} \
             Rest -[start && parts < 3]-> Press -[10s/Press || down && level > 0]-> Rest; \
             Rest -[parts >= 3]-> Full -[!start]-> Rest; {lines} }}"
        );
        errors(&chart, prover)
    };
    let prover: Option<&Prover> = Some(&grafcet_prove::rule);
    for (lines, what) in [
        ("always parts > 3 => start;", "`parts > 3` holds at the end of no cycle: nothing follows from it"),
        ("Press.T > 10s leads_to Rest;", "`Press.T > 10s` holds at the end of no cycle: nothing follows from it"),
        ("Press before parts > 3;", "`parts > 3` holds at the end of no cycle: nothing has to come before it"),
        (
            "assume never level < 9; assume often level > 3 && level / 3 < 3; Press before Full;",
            "`level > 3 && level/3 < 3` never holds, so it cannot come again and again",
        ),
    ] {
        let errors = said(lines, prover);
        assert!(matches!(&errors[..], [one] if one.starts_with(what)), "{lines}: {errors:?}");
    }
    for lines in
        ["always parts > 2 => !start || !lower || parts < 4;", "Press.T > 9s leads_to Rest;", "Press before parts > 2;"]
    {
        assert_eq!(said(lines, prover), Vec::<String>::new(), "{lines}");
    }
    // Without a solver nobody knows.
    let open = said("always parts > 3 => Full.X || !Full.X;", None);
    assert_eq!(open, Vec::<String>::new());
    // What leaves nothing, so that the conditions alone do not show it.
    let nothing = said("assume never (x ^ y) & y == y & !x; always parts <= 3;", prover);
    assert!(matches!(&nothing[..], [one] if one.contains("exclude every")), "{nothing:?}");
}

/// Ten stations that work side by side and wait for each other, with a way home that takes the solver long, and a claim that does not.
const STATIONS: &str = "
    grafcet Table {
        input start, locked, indexed, d0, d1, d2, d3, d4, d5, d6, d7, d8, d9: bool;
        output turn: bool;
        output w0, w1, w2, w3, w4, w5, w6, w7, w8, w9: bool;
        partial Drive {
            initial step Wait;
            step Work;
            step Unlock;
            step Turn { turn; }
            Wait -[start]-> Work -[E0.X && E1.X && E2.X && E3.X && E4.X && E5.X && E6.X && E7.X && E8.X && E9.X]-> Unlock;
            Unlock -[!locked]-> Turn -[indexed && locked]-> Wait;
        }
        STATIONS
        home Wait;
        never turn && (w0 || w1 || w2 || w3 || w4 || w5 || w6 || w7 || w8 || w9);
    }";

/// What the macro gives a chart is limited by the work it is, so that nobody waits for a build; what is hard is in the way of nothing, and what is
/// not decided says where it is.
#[test]
fn what_is_hard_neither_holds_up_a_build_nor_what_is_easy() {
    let station = |n: usize| {
        format!(
            "partial S{n} {{ initial step I{n}; step W{n} {{ w{n}; }} step E{n};
             I{n} -[Work.X]-> W{n} -[d{n}]-> E{n} -[Unlock.X]-> I{n}; }}"
        )
    };
    let chart = STATIONS.replace("STATIONS", &(0..10).map(station).collect::<String>());
    let said = errors(&chart, Some(&grafcet_prove::rule));
    let [one] = &said[..] else { panic!("{said:?}") };
    assert!(
        one.contains("the solver was stopped at its limit: `cargo grafcet prove` searches as long as you let it"),
        "{one}"
    );
    assert!(!one.contains("at the end of"), "{one}");
    // Who lets it search longer gets its answer.
    let longer = chart.replace("input start", "budget 40_000; input start");
    assert_eq!(errors(&longer, Some(&grafcet_prove::rule)), Vec::<String>::new());
}
