//! After a mistake the parser goes on: all mistakes of a chart in one run, in source order, and nothing else lost.

use crate::{run, show};

/// The messages' marked texts.
fn marks(text: &str) -> Vec<String> {
    run(text).1.into_iter().map(|(marked, _)| marked).collect()
}

fn body(text: &str) -> (String, Vec<String>) {
    let chart = run(text).0.expect("a chart");
    assert!(chart.incomplete);
    (show::body(&chart.body), chart.body.broken.iter().map(ToString::to_string).collect())
}

#[test]
fn every_mistake_of_a_chart_in_source_order() {
    let text = "sfc C {
        input a b: bool;
        output q: bool = ;
        initial step A { X q; S q; L r; }
        step B { q := 1; q; }
        A -[x y]-> B;
        A -[x = 1]-> B -[ok]-> A;
        clock soon;
    }";
    assert_eq!(marks(text), ["b", ";", "X", "L", ":", "y", "=", "soon"]);
    let (body, broken) = body(text);
    assert_eq!(body, "initial step A {S q; L r}; step B {q}; A -[BROKEN]-> B; A -[BROKEN]-> B -[ok]-> A");
    assert_eq!(broken, ["a", "b", "q"], "a comma may be what is missing");
}

#[test]
fn a_bad_line_does_not_lose_its_step() {
    let text = "sfc C { step A { N q; X 5s q { a; }; S r; P1 { let let; } R r; } step B; }";
    assert_eq!(body(text).0, "step A {N q; S r; R r}; step B {}");
}

#[test]
fn a_bad_item_in_a_nested_body_does_not_lose_the_rest() {
    let text = "grafcet C {
        partial P { step A { ( } }
        partial Q { foo bar; macro step M { step X { q } step Y: {} entry step Z; } step B; }
        step D;
    }";
    let text = text.replace("( }", "+ }");
    let chart = run(&text).0.expect("a chart");
    assert_eq!(
        show::body(&chart.body),
        "partial P {step A {}}; partial Q {macro step M {step X {q}; entry step Z {}}; step B {}}; step D {}"
    );
    assert!(chart.body.broken.is_empty(), "they stand in the bodies that they are missing in");
}

#[test]
fn without_a_semicolon_the_next_item_is_found() {
    for (text, expected) in [
        ("input a: bool\noutput b: bool;", "Input a: bool; Output b: bool"),
        ("input a: bool output b: bool;", "Input a: bool; Output b: bool"),
        ("input a b: bool\noutput b: bool;", "Output b: bool"),
        ("input a: bool\nA -[x]-> B\nB -[y]-> A\nstep C", "Input a: bool; A -[x]-> B; B -[y]-> A; step C {}"),
        ("step A\nstep B { N q\nS r if a\nr\n}", "step A {}; step B {N q; S r if a; r}"),
        ("step A { N q S r if a R r L 5s r }", "step A {N q; S r if a; R r; L 5000000000ns r}"),
        ("x y\n/// Doc.\nstep A;", "# [doc = \" Doc.\"] step A {}"),
        ("x { y } step A;", "step A {}"),
        ("x = { y } + z; step A;", "step A {}"),
    ] {
        assert_eq!(body(&format!("sfc C {{ {text} }}")).0, expected, "{text}");
    }
}

#[test]
fn a_misspelled_word_is_taken_for_what_it_means() {
    let text = "sfc C { Input a: bool; ouput q: bool; Initial State A { q; } init step B; initial D; }";
    let (body, broken) = body(text);
    assert_eq!(body, "Input a: bool; Output q: bool; initial step A {q}; initial step B {}; initial step D {}");
    assert!(broken.is_empty());
}

#[test]
fn names_of_broken_items_are_guessed() {
    for (text, names) in [
        ("input a, b bool;", "a b bool"),
        ("output a: ;", "a"),
        ("var a;", "a"),
        ("param a, b = 5;", "a b"),
        ("action heat;", "heat"),
        ("step X [ ]", "X"),
        ("initial linked step X + 3;", "X"),
        ("initial X: { }", "X"),
        ("partial P;", "P"),
        ("#[doc] macro step M;", "M"),
        ("kasten X { }", "X"),
        ("a: bool;", "a"),
        ("N q;", ""),
        ("clock x;", ""),
        ("A -[x]-> 5.5;", ""),
    ] {
        assert_eq!(body(&format!("sfc C {{ {text} }}")).1.join(" "), names, "{text}");
    }
}

#[test]
fn a_link_that_cannot_be_read_is_cut_out_of_its_chain_and_a_condition_is_not() {
    let text = "sfc C { A -[a]-> B -[b b]-> C -[c]-> D -[]-> E; F -x-> G -[g]- H; }";
    assert_eq!(body(text).0, "A -[a]-> B -[BROKEN]-> C -[c]-> D -[BROKEN]-> E; F; G -[g]-> H");
}

#[test]
fn a_broken_header_gives_no_chart_and_one_message() {
    let (chart, errors) = run("pub Motor { step A { X q; } }");
    assert!(chart.is_none());
    assert_eq!(errors.len(), 1);
}

/// What has a name that Rust reserves is mentioned in generated code all the same.
#[test]
fn reserved_names_leave_valid_rust() {
    for text in [
        "grafcet M { input a: bool; partial return { initial step A; step B { force Q {}; } A -[a]-> B -[!a]-> A; }
         partial Q { initial step E; } }",
        "grafcet M { input a: bool; partial F { initial step A; step B { force match {}; } A -[a]-> B -[!a]-> A; }
         partial match { initial step self; } partial self { initial step fn; } }",
        "grafcet M { input if: bool; output self: bool; var crate: u8 = 0; param super: time = 5s; action return(match: u8);
         initial step loop { P1 return(crate); self; P1 crate = 3; } enclosing step dyn { partial as { linked step _; } }
         macro step while { entry step for; exit step impl; for -[if]-> impl; }
         loop -[if && super/loop]-> while -[!if]-> loop -[if]-> dyn -[if]-> loop; never self; home loop; }",
    ] {
        let out = grafcet_compiler::compile(&quote::quote!(::grafcet), text.parse().expect("tokens"));
        assert!(syn::parse2::<syn::File>(out.clone()).is_ok(), "{text}\n{out}");
    }
}
