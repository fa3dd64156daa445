//! `input mode: Mode in {Off, Auto, Manual};`: the variants exclude each other, and there are no others.

mod judged;

use judged::said;

use quote::quote;

fn fine(chart: &str) {
    assert_eq!(said(chart), Vec::<String>::new(), "{chart}");
}

fn refused(chart: &str, words: &str) {
    let said = said(chart);
    assert!(said.iter().any(|one| one.contains(words)), "{chart}: {said:#?}");
}

/// A chart of two steps that reads `mode`.
fn press(dialect: &str, declaration: &str, items: &str) -> String {
    format!(
        "{dialect} Press {{ #![allow(grafcet::unused_input, grafcet::undriven_output)] {declaration} input go: bool; output q, r: bool; initial step A; step B {{ q; }} {items} }}"
    )
}

const MODE: &str = "input mode: Mode in {Off, Auto, Manual};";

#[test]
fn they_exclude_each_other() {
    for dialect in ["sfc", "grafcet"] {
        for items in [
            "step C { r; } A -[mode == Mode::Auto]-> B -[mode != Mode::Auto]-> A; A -[Mode::Manual == mode]-> C -[mode != Mode::Manual]-> A; home A;",
            "step C { r; } A -[matches!(mode, Mode::Auto)]-> B -[!matches!(mode, Mode::Auto)]-> A; A -[mode == Mode::Manual]-> C -[mode != Mode::Manual]-> A; home A; never q && r;",
            "step C { r if mode == Mode::Manual; } A -[mode == Mode::Auto]-> B -[matches!(mode, Mode::Off | Mode::Manual)]-> C -[mode == Mode::Auto || mode == Mode::Off]-> A; never r && mode == Mode::Auto;",
        ] {
            fine(&press(dialect, MODE, items));
        }
    }
    let auto = "A -[mode == Mode::Auto && go]-> B -[mode == Mode::Manual]-> A; home A; home B;";
    fine(&press("sfc", MODE, auto));
    fine(&press("grafcet", MODE, auto));
}

#[test]
fn there_are_no_others() {
    let all = "A -[go]-> B -[mode == Mode::Auto || mode == Mode::Off || mode == Mode::Manual]-> A;";
    refused(&press("sfc", MODE, all), "always_true");
    let none = "A -[mode != Mode::Auto && mode != Mode::Off && !matches!(mode, Mode::Manual)]-> B -[go]-> A;";
    refused(&press("sfc", MODE, none), "never_true");
    let both = "A -[mode == Mode::Auto && mode == Mode::Off]-> B -[go]-> A;";
    refused(&press("sfc", MODE, both), "never_true");
    // Without the list nothing is known.
    for items in [all, none, both] {
        let said = said(&press("sfc", "input mode: Mode;", items));
        assert!(!said.iter().any(|one| one.contains("_true")), "{said:#?}");
    }
    let step = "step C { r; } A -[mode == Mode::Auto]-> B -[mode != Mode::Auto]-> A; A -[mode == Mode::Off]-> C -[mode == Mode::Manual]-> A; A -[mode == Mode::Manual]-> B;";
    fine(&press("grafcet", MODE, step));
    refused(
        &press("grafcet", MODE, &step.replace("A -[mode == Mode::Off]", "A -[mode != Mode::Manual && go]")),
        "mode = Auto",
    );
}

#[test]
fn counterexamples_name_them() {
    let chart =
        press("sfc", MODE, "A -[mode == Mode::Auto]-> B -[mode == Mode::Off]-> A; never q && mode == Mode::Manual;");
    let said = said(&chart);
    assert!(said.len() == 1 && said[0].starts_with("property_violated"), "{said:#?}");
    assert!(said[0].contains("mode = Auto") && said[0].contains("mode = Manual"), "{said:#?}");
    let chart = press("sfc", MODE, "A -[mode != Mode::Auto && go]-> B -[!go]-> A; never q;");
    refused(&chart, "mode = Off");
}

#[test]
fn assumptions_are_about_them() {
    let items = "A -[mode == Mode::Auto]-> B -[mode == Mode::Off]-> A; never q && mode == Mode::Manual;";
    fine(&press("sfc", MODE, &format!("assume never mode == Mode::Manual; {items}")));
    refused(
        &press("sfc", MODE, &format!("assume never mode != Mode::Auto; assume never mode == Mode::Auto; {items}")),
        "assumption",
    );
}

#[test]
fn edges_and_other_values() {
    let chart = "A -[rising(mode == Mode::Auto)]-> B -[falling(mode == Mode::Auto) && mode == Mode::Off]-> A; \
        B -[mode == Mode::Manual]-> A; home A;";
    fine(&press("sfc", MODE, chart));
    // Parameters and variables, too.
    fine(&press(
        "sfc",
        "param mode: Mode in {Off, Auto,} = Mode::Off;",
        "A -[go && mode == Mode::Auto]-> B -[!go]-> A; A -[go && mode == Mode::Off]-> B;",
    ));
    refused(
        &press(
            "sfc",
            "var mode: Mode in {Off, Auto} = Mode::Off;",
            "A -[go && mode == Mode::Auto && mode == Mode::Off]-> B { P1 mode = Mode::Auto; } B -[!go]-> A;",
        )
        .replace("B { P1 mode = Mode::Auto; } B", "B")
        .replace("B { q; }", "B { q; P1 { mode = Mode::Auto; } }"),
        "never_true",
    );
    // Two values, and what is computed: nothing is known.
    let two = "input mode, wanted: Mode in {Off, Auto};";
    fine(&press("sfc", two, "A -[mode == wanted && mode == Mode::Auto]-> B -[wanted != mode]-> A;"));
    fine(&press("sfc", two, "A -[mode == wanted]-> B -[mode == Mode::of(3)]-> A; B -[wanted == Mode::Off && go]-> A;"));
    // What is compared by its order, or with a constant of the type.
    fine(&press(
        "sfc",
        two,
        "A -[mode < wanted]-> B -[mode > Mode::Off && mode == Mode::DEFAULT]-> A; B -[wanted == Mode::Off]-> A;",
    ));
    // The same type by another path; another type of the same name.
    refused(&press("sfc", MODE, "A -[mode == crate::Mode::Auto && mode == Mode::Off]-> B -[go]-> A;"), "never_true");
    fine(&press("sfc", MODE, "A -[mode == Modus::Auto && mode == Mode::Off]-> B -[go]-> A;"));
    fine(&press(
        "sfc",
        "input mode: crate::modes::Mode in {Off, Auto};",
        "A -[mode == crate::modes::Mode::Auto]-> B -[mode == crate::modes::Mode::Off]-> A; home A;",
    ));
}

#[test]
fn variants_that_carry_something() {
    let data = "input mode: Mode in {Off, Auto(..), Jog {..}};";
    fine(&press(
        "sfc",
        data,
        "A -[matches!(mode, Mode::Auto(_))]-> B -[matches!(mode, Mode::Off | Mode::Jog { .. })]-> A; home A;",
    ));
    refused(
        &press("sfc", data, "A -[matches!(mode, Mode::Auto(..)) && mode == Mode::Off]-> B -[go]-> A;"),
        "never_true",
    );
    // What it carries may be anything.
    fine(&press(
        "sfc",
        data,
        "A -[matches!(mode, Mode::Auto(3)) && go]-> B -[matches!(mode, Mode::Auto(n) if n > 3)]-> A; B -[mode == Mode::Auto(7)]-> A;",
    ));
    refused(&press("sfc", "input mode: Mode in {Off, Auto(u8)};", "A -[go]-> B -[go]-> A;"), "write `Auto(..)`");
}

#[test]
fn what_is_refused() {
    let plain = "A -[go]-> B -[!go]-> A;";
    for (declaration, words) in [
        ("input mode: Mode in {Off, Off};", "listed twice"),
        ("input mode: Mode in {};", "expected the variants"),
        ("input mode: Mode in Off;", "in braces"),
        ("input mode: Mode in {Mode::Off};", "leave out `Mode::`"),
        ("input mode: Mode in {Off Auto};", "expected `,`"),
        ("input mode: u8 in {Off};", "only an enum"),
        ("input mode: bool in {Off};", "only an enum"),
        ("input wait: time in {Off};", "only an enum"),
        ("input mode: &'static Mode in {Off};", "only an enum"),
        ("output mode: Mode in {Off, Auto};", "leave this out"),
    ] {
        refused(&press("sfc", declaration, plain), words);
    }
}

#[test]
fn the_list_is_checked_by_rustc() {
    let text = |declaration: &str, items: &str| {
        let chart = press("pub sfc", declaration, items).parse().expect("tokens");
        grafcet_compiler::compile(&quote!(::grafcet), chart).to_string()
    };
    let chart = text(MODE, "A -[mode == Mode::Auto]-> B -[mode == crate::Mode::Off]-> A;");
    assert!(chart.contains("Mode :: Off { .. } | Mode :: Auto { .. } | Mode :: Manual { .. } => { }"), "{chart}");
    assert!(chart.contains("crate :: Mode :: Off { .. } | crate :: Mode :: Auto { .. }"), "{chart}");
    assert!(chart.contains("const VARIANT : Mode = Mode :: Auto"), "{chart}");
    // Patterns ask for no comparison.
    let chart = text(MODE, "A -[matches!(mode, Mode::Auto)]-> B -[matches!(mode, Mode::Off)]-> A;");
    assert!(chart.contains("match value") && !chart.contains("VARIANT"), "{chart}");
    assert!(
        !text("input mode: Mode;", "A -[mode == Mode::Auto]-> B -[mode == Mode::Off]-> A;").contains("match value")
    );
}
