//! What a macro of `macro_rules` was given: whatever stands around it, it stays together.

use grafcet_compiler::ast::{Arrow, Condition, Item, Transition};
use grafcet_compiler::compile;
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::parse;
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use quote::{ToTokens, quote};
use syn::visit_mut::{self, VisitMut};

use crate::random::Random;

/// The tokens, with each `⟨…⟩` in a group without delimiters; here `__{…}` stands for it.
fn with_fragments(text: &str, fragment: &dyn Fn(TokenStream) -> TokenStream) -> TokenStream {
    fn level(tokens: TokenStream, fragment: &dyn Fn(TokenStream) -> TokenStream) -> TokenStream {
        let mut out = TokenStream::new();
        let mut tokens = tokens.into_iter();
        while let Some(tree) = tokens.next() {
            match tree {
                TokenTree::Ident(mark) if mark == "__" => match tokens.next() {
                    Some(TokenTree::Group(group)) => out.extend(fragment(level(group.stream(), fragment))),
                    _ => panic!("braces after the mark"),
                },
                TokenTree::Group(group) => {
                    out.extend([TokenTree::from(Group::new(group.delimiter(), level(group.stream(), fragment)))]);
                }
                other => out.extend([other]),
            }
        }
        out
    }
    level(text.parse().expect("tokens"), fragment)
}

fn invisible(tokens: TokenStream) -> TokenStream {
    TokenTree::from(Group::new(Delimiter::None, tokens)).into()
}

fn has_invisible(tokens: TokenStream) -> bool {
    tokens.into_iter().any(|tree| match tree {
        TokenTree::Group(group) => group.delimiter() == Delimiter::None || has_invisible(group.stream()),
        _ => false,
    })
}

/// What a chart with fragments compiles to, and the same chart with what is meant in its place.
fn same(with: &str, meant: &str) {
    let out = compile(&quote!(::grafcet), with_fragments(with, &invisible));
    assert!(!has_invisible(out.clone()), "{with}\n{out}");
    let meant_out = compile(&quote!(::grafcet), meant.parse().expect("tokens"));
    assert_eq!(out.to_string(), meant_out.to_string(), "{with}\n{meant}");
    assert!(!out.to_string().contains("compile_error"), "{out}");
}

/// A chart that has everything in which an expression can stand.
fn chart(dialect: &str, place: &str) -> String {
    let level = if dialect == "sfc" { "N level = 0;" } else { "" };
    format!(
        "{dialect} Press {{
            #![allow(grafcet::undriven_output, grafcet::unused_variable, grafcet::unused_action, grafcet::unused_input)]
            #![allow(grafcet::unused_param, grafcet::deadlock)]
            input estop, door, go: bool;
            input n: i16;
            output motor, lamp: bool;
            output level: i16 = 0;
            var count: i16 = 0;
            param soak: time = 5s;
            action report(value: i16);
            initial step Off {{ {level} }}
            {place}
        }}"
    )
}

/// A chart with the expression at its place.
type Place<'p> = &'p dyn Fn(&str) -> String;

/// Each place in which an expression can stand, with a fragment and as it is meant.
#[test]
fn every_place_keeps_what_belongs_together() {
    let step = |line: &str| format!("step On {{ {line} }} Off -[go]-> On -[door]-> Off;");
    let condition = |condition: &str| format!("step On {{ motor; }} Off -[{condition}]-> On -[door]-> Off;");
    let places: &[(Place<'_>, &str, &str)] = &[
        (&condition, "!__{estop || door}", "!(estop || door)"),
        (&condition, "__{estop || door}", "estop || door"),
        (&condition, "go && __{estop || door}", "go && (estop || door)"),
        (&condition, "__{estop || door} && go", "(estop || door) && go"),
        (&condition, "__{__{estop || door} && go} && n > 1", "((estop || door) && go) && n > 1"),
        (&condition, "go && rising(__{estop || door})", "go && rising(estop || door)"),
        (&condition, "go && !__{rising(door)}", "go && !rising(door)"),
        (&condition, "n == __{1 + 2}", "n == (1 + 2)"),
        (&condition, "__{n} < 3 && __{-1} < n", "n < 3 && (-1) < n"),
        (&condition, "3 * __{n + 1} > 30", "3 * (n + 1) > 30"),
        (&condition, "__{5s}/Off", "5s/Off"),
        (&condition, "__{5s}/__{Off}", "5s/Off"),
        (&condition, "__{3s}/__{estop || door}/__{2s}", "3s/(estop || door)/2s"),
        (&condition, "go && __{5s/Off}", "go && (5s/Off)"),
        (&condition, "!__{Off.X && go}", "!(Off.X && go)"),
        (&condition, "matches!(__{n + 1}, __{1 | 2}) && go", "matches!(n + 1, 1 | 2) && go"),
        (&condition, "go && matches!(3 * __{n + 1}, 3 | __{-1})", "go && matches!(3 * (n + 1), 3 | (-1))"),
        (&condition, "[1, 2].iter().any(|x| 3 * __{*x + n} > 1)", "[1, 2].iter().any(|x| 3 * (*x + n) > 1)"),
        (&condition, "n as __{i32} < 3", "n as (i32) < 3"),
        (&condition, "__{if go { 1 } else { 2 }} > n", "(if go { 1 } else { 2 }) > n"),
        (&condition, "__{{ n }} > 1", "({ n }) > 1"),
        (&condition, "__{match n { 1 => 2, _ => 3 } > 2}", "(match n { 1 => 2, _ => 3 } > 2)"),
        (&condition, "go => count = __{3 * __{n + 1}}", "go => count = 3 * (n + 1)"),
        (&condition, "go => __{count = n}", "go => count = n"),
        (&condition, "start: !__{estop || door}", "start: !(estop || door)"),
        (&step, "N motor if __{estop || door};", "N motor if estop || door;"),
        (&step, "N motor if !__{estop || door};", "N motor if !(estop || door);"),
        (&step, "N motor if go && __{estop || door}; N lamp;", "N motor if go && (estop || door); N lamp;"),
        (&step, "D __{5s} motor;", "D 5s motor;"),
        (&step, "P1 count = 3 * __{n + 1};", "P1 count = 3 * (n + 1);"),
        (&step, "P1 count = __{n + 1};", "P1 count = n + 1;"),
        (&step, "P1 count = __{n + 1} * 2;", "P1 count = (n + 1) * 2;"),
        (&step, "P1 __{count = n + 1};", "P1 count = n + 1;"),
        (&step, "P1 report(3 * __{n + 1});", "P1 report(3 * (n + 1));"),
        (&step, "P1 report(__{n + 1});", "P1 report(n + 1);"),
        (&step, "P1 { count = 3 * __{n + 1}; }", "P1 { count = 3 * (n + 1); }"),
        (&step, "P1 { count *= __{n + 1}; }", "P1 { count *= n + 1; }"),
        (&step, "P1 { __{count = n;} __{count += 1}; }", "P1 { count = n; count += 1; }"),
        (&step, "P1 { __{if go { count = n; }} __{count += 1}; }", "P1 { if go { count = n; } count += 1; }"),
        (&step, "P1 { __{let x = n}; count = x.pow(__{1 + 1}); }", "P1 { let x = n; count = x.pow(1 + 1); }"),
        (&step, "P1 __{{ count = n; }} P1 lamp = go;", "P1 { count = n; } P1 lamp = go;"),
        (&step, "P1 { count = __{-1}.abs(); }", "P1 { count = (-1).abs(); }"),
        (&step, "P1 { count = (__{|x| x + 1})(n); }", "P1 { count = (|x| x + 1)(n); }"),
        (&step, "P1 { count = [__{n + 1}; 3][__{0 + 1}] * 2; }", "P1 { count = [n + 1; 3][0 + 1] * 2; }"),
        (&step, "P1 { if !__{go || door} { count = 1; } }", "P1 { if !(go || door) { count = 1; } }"),
        (&step, "P1 { count = -__{n + 1}; }", "P1 { count = -(n + 1); }"),
        (&step, "P1 { let x: &'static __{dyn A + B} = f(); }", "P1 { let x: &'static (dyn A + B) = f(); }"),
    ];
    for dialect in ["sfc", "grafcet"] {
        for (place, with, meant) in places {
            if dialect == "grafcet" || !with.contains("=>") || with.contains("match") {
                same(&chart(dialect, &place(with)), &chart(dialect, &place(meant)));
            }
        }
    }
    let properties = [
        ("never __{motor && lamp};", "never motor && lamp;"),
        ("never motor && __{lamp && !__{estop || door}};", "never motor && (lamp && !(estop || door));"),
        ("always __{motor} => !__{lamp && go};", "always motor => !(lamp && go);"),
        ("assume never __{estop || go} && door;", "assume never (estop || go) && door;"),
        (
            "#[allow(grafcet::property_undecided)] __{estop || go} leads_to __{door} within 5s;",
            "#[allow(grafcet::property_undecided)] (estop || go) leads_to door within 5s;",
        ),
        (
            "#[allow(grafcet::property_undecided)] __{estop} before __{go || door};",
            "#[allow(grafcet::property_undecided)] estop before (go || door);",
        ),
        ("var other: i16 = 3 * __{1 + 1};", "var other: i16 = 3 * (1 + 1);"),
        ("input other: __{&'static [u8]};", "input other: &'static [u8];"),
        ("param other: __{time} = __{5s};", "param other: time = 5s;"),
    ];
    for (with, meant) in properties {
        let rest = condition("go");
        same(&chart("sfc", &format!("{with}{rest}")), &chart("sfc", &format!("{meant}{rest}")));
    }
}

/// The header, the names and whole items.
#[test]
fn all_that_is_no_expression_is_as_if_written_there() {
    same(
        "#[__{allow(missing_docs)}] __{pub(crate)} sfc __{M} { #[__{doc = \"An input.\"}] input a: __{bool};
         initial step A; step B; __{A} -[a]-> __{B} -[!a]-> A; }",
        "#[allow(missing_docs)] pub(crate) sfc M { #[doc = \"An input.\"] input a: bool;
         initial step A; step B; A -[a]-> B -[!a]-> A; }",
    );
    same(
        "__{} sfc M { input a: bool; __{initial step A; step B;} __{A -[a]-> B} -[!a]-> A; }",
        "sfc M { input a: bool; initial step A; step B; A -[a]-> B -[!a]-> A; }",
    );
}

/// The description shows what runs.
#[test]
fn texts_have_the_same_parentheses() {
    let out = compile(
        &quote!(::grafcet),
        with_fragments(
            "sfc M { input estop, door: bool; output q: bool; initial step A; step B { q if __{estop && !__{door}}; }
             A -[!__{estop || door}]-> B -[estop]-> A; }",
            &invisible,
        ),
    );
    let text = out.to_string();
    assert!(text.contains("\"!(estop || door)\"") && text.contains("\"estop && !door\""), "{text}");
}

/// Attributes, statements, items and other fragments where nothing of the kind stands: messages, and an end.
#[test]
fn no_fragment_is_looked_at_for_ever() {
    let fragments = [
        "#[allow(unused)] q",
        "#[allow(unused)]",
        "#![allow(unused)]",
        "#",
        "# !",
        "let x = 1",
        "let x = 1;",
        "x = 1;",
        "fn f() {}",
        "#[inline] fn f() {}",
        "struct A;",
        "{ a = 1; }",
        "{}",
        "allow(unused)",
        "doc = \"text\"",
        "pub",
        "pub(crate)",
        "",
        "'a",
        "A | B",
        "Vec<u8>",
        "5s",
        "-5",
        "-",
        "->",
        "- [a] ->",
        "A -[a]-> B",
        "A",
        "step A;",
        "N q",
        "if a { b }",
        ";",
    ];
    let places = [
        "@ sfc M { input a: bool; initial step A; }",
        "@; sfc M { input a: bool; initial step A; }",
        "#[@] sfc M { input a: bool; initial step A; }",
        "# @ sfc M { input a: bool; initial step A; }",
        "pub @ M { input a: bool; initial step A; }",
        "sfc @ { input a: bool; initial step A; }",
        "sfc M @",
        "sfc M { @ }",
        "sfc M { @; }",
        "sfc M { @ input a: bool; initial step A; }",
        "sfc M { @; input a: bool; initial step A; }",
        "sfc M { #![@] initial step A; }",
        "sfc M { #[@] initial step A; }",
        "sfc M { # @ initial step A; }",
        "sfc M { input @; initial step A; }",
        "sfc M { input a: @; initial step A; }",
        "sfc M { input @: bool = @; initial step A; }",
        "sfc M { initial step A; @ }",
        "sfc M { initial step A; @; step B; }",
        "sfc M { initial @ A; }",
        "sfc M { initial step @; }",
        "sfc M { initial step A @ }",
        "sfc M { initial step A { @ } }",
        "sfc M { initial step A { @; } }",
        "sfc M { output q: bool; initial step A { @ N q; @ } }",
        "sfc M { output q: bool; initial step A { @; N q; @; N q if @; N @ q; } }",
        "sfc M { output q: bool; initial step A { P1 { @ } P1 { @; } P1 @ } }",
        "sfc M { output q: bool; initial step A { on @ q; q = @; f(@); force @; force A @; } }",
        "sfc M { initial step A; @ A -[true]-> A; }",
        "sfc M { initial step A; A @ A; }",
        "sfc M { initial step A; A -[@]-> A; @ -[a]-> @; }",
        "sfc M { initial step A; A -[a => @]-> A; A -@[a]-> A; A -[a]@-> A; }",
        "sfc M { initial step A; never @; always @ => @; home @; clock @; assume @; @ never; partial @ }",
        "sfc M { initial step A; } @",
    ];
    let mut failed = Vec::new();
    for place in places {
        for fragment in fragments {
            for group in [&invisible as &dyn Fn(TokenStream) -> TokenStream, &|tokens| invisible(invisible(tokens))] {
                let text = place.replace('@', &format!("__{{{fragment}}}"));
                let out = compile(&quote!(::grafcet), with_fragments(&text, group));
                if syn::parse2::<syn::File>(out.clone()).is_err() {
                    failed.push(format!("{text}\n{out}"));
                }
            }
        }
    }
    assert!(failed.is_empty(), "{}", failed.join("\n\n"));
}

/// The parentheses away, which say nothing that the tree does not say.
struct Bare;

impl VisitMut for Bare {
    fn visit_expr_mut(&mut self, expr: &mut syn::Expr) {
        while let syn::Expr::Paren(paren) = expr {
            *expr = (*paren.expr).clone();
        }
        visit_mut::visit_expr_mut(self, expr);
    }
}

/// An expression of random parts, each in what `around` puts around it.
fn expression(random: &mut Random, depth: usize, around: &dyn Fn(String, bool) -> String) -> String {
    let patterns = [
        "@ && @",
        "@ || @",
        "!@",
        "-@",
        "*@",
        "@ + @",
        "@ * @",
        "@ == @",
        "@ < @",
        "@ & @",
        "@ >> @",
        "@ as u8",
        "@.m(@)",
        "@.f",
        "@[@]",
        "@(@)",
        "f(@, @)",
        "(@, @)",
        "[@, @]",
        "@?",
        "&@",
        "if @ { @ } else { @ }",
        "match @ { x if @ => @, _ => @ }",
        "{ @; @ }",
        "{ let x = @; @ }",
        "|x| @",
        "@..@",
        "S { x: @ }",
        "x = @",
        "loop { @ }",
        "unsafe { @ }",
    ];
    if depth == 0 {
        return ["a", "b", "7", "a::b", "f()", "\"t\""][random.below(6)].to_owned();
    }
    let pattern = patterns[random.below(patterns.len())];
    let mut text = String::new();
    for char in pattern.chars() {
        if char == '@' {
            let fragment = random.below(2) == 0;
            let deeper = depth - 1 - random.below(depth.min(2));
            let part = expression(random, deeper, around);
            text += &around(part, fragment);
        } else {
            text.push(char);
        }
    }
    text
}

/// Parses the condition and shows its tree, fully bracketed by its debug form of tokens without parentheses.
fn tree(tokens: &TokenStream) -> Result<String, String> {
    let mut sink = Sink::new();
    let chart = quote!(sfc M { initial step A; A -[#tokens]-> A; });
    let parsed = parse::chart(chart, &mut sink);
    let errors: Vec<String> = sink.finish().into_iter().flat_map(|d| d.notes).map(|(_, message)| message).collect();
    let body = parsed.ok_or("no chart")?.body;
    let condition = body.items.into_iter().find_map(|item| match item {
        Item::Chain(chain) => chain.rest.into_iter().find_map(|(arrow, _)| match arrow {
            Arrow::Transition(Transition { condition: Condition::Holds(condition), .. }) => Some(condition),
            _ => None,
        }),
        _ => None,
    });
    let mut condition = condition.ok_or_else(|| errors.join("; "))?;
    assert!(!has_invisible(condition.to_token_stream()));
    Bare.visit_expr_mut(&mut condition);
    // `syn` prints the parentheses that the tree needs, and no others.
    Ok(condition.to_token_stream().to_string())
}

#[test]
fn random_parts_in_fragments_keep_their_tree() {
    let mut random = Random(7);
    let mut read = 0;
    for _ in 0..3000 {
        let state = random.0;
        let bracketed = expression(&mut random, 4, &|part, _| format!("({part})"));
        let mut again = Random(state);
        // Not only where a macro would: also the parts that hold together without.
        let with = expression(&mut again, 4, &|part, fragment| {
            if fragment { format!("__{{{part}}}") } else { format!("({part})") }
        });
        let meant = tree(&bracketed.parse().expect("tokens"));
        let Ok(meant) = meant else { continue };
        assert_eq!(tree(&with_fragments(&with, &invisible)), Ok(meant), "{with}");
        read += 1;
    }
    assert!(read > 1500, "only {read} expressions were right");
}
