//! Every message of the parser, at its tokens. Each case has one mistake and must give one message.

use crate::run;

/// `(item, marked text, part of the message)`; the item stands in a chart's body.
fn check(before: &str, after: &str, cases: &[(&str, &str, &str)]) {
    for (text, marked, message) in cases {
        let (_, errors) = run(&format!("{before}{text}{after}"));
        assert_eq!(errors.len(), 1, "{text}: {errors:#?}");
        assert!(errors[0].1.contains(message), "{text}: {errors:#?}");
        assert_eq!(errors[0].0, *marked, "{text}: {errors:#?}");
    }
}

fn in_chart(cases: &[(&str, &str, &str)]) {
    check("sfc C { ", " }", cases);
}

fn in_step(cases: &[(&str, &str, &str)]) {
    check("sfc C { step A { ", " } }", cases);
}

#[test]
fn an_empty_call() {
    let (chart, errors) = run("");
    assert!(chart.is_none());
    assert!(errors[0].1.contains("grafcet! { pub sfc Motor { initial step Off; } }"), "{errors:?}");
}

#[test]
fn headers() {
    for (text, marked, message, some) in [
        ("pub Motor { }", "Motor", "begins with its dialect, `sfc` (IEC 61131-3) or `grafcet` (IEC 60848)", false),
        ("chart Motor { }", "chart", "begins with its dialect", true),
        ("{ }", "{", "begins with its dialect", false),
        ("Sfc Motor { }", "Sfc", "written `sfc`", true),
        ("GRAFCET Motor { }", "GRAFCET", "written `grafcet`", true),
        ("sfc { }", "{", "expected the name of the chart", false),
        ("sfc match { }", "match", "`match` is a keyword of Rust", false),
        ("sfc _ { }", "_", "`_` is a keyword of Rust", false),
        ("sfc Motor", "Motor", "expected `{` after the name", false),
        ("sfc Motor; step A;", ";", "expected `{` after the name", false),
        ("sfc Motor<T> { }", "<", "no generic parameters", false),
        ("pub(in a b) sfc Motor { }", "b", "unexpected token", false),
        ("sfc Motor { } pub sfc Other { }", "pub", "one chart", true),
        ("sfc Motor { } ;", ";", "ends with its `}`", true),
        (
            "#![allow(grafcet::several_initial_steps)] sfc Motor { }",
            "#![allow(grafcet::several_initial_steps)]",
            "at the beginning of the braces",
            true,
        ),
        ("#[cfg(test)] sfc Motor { }", "#[cfg(test)]", "`#[cfg(…)] grafcet! { … }`", true),
        ("#[repr(C)] sfc Motor { }", "#[repr(C)]", "doc comments, the lint attributes", true),
    ] {
        let (chart, errors) = run(text);
        assert_eq!(chart.is_some(), some, "{text}");
        assert_eq!(errors.len(), 1, "{text}: {errors:?}");
        assert!(errors[0].1.contains(message), "{text}: {errors:?}");
        assert_eq!(errors[0].0, marked, "{text}");
        assert!(chart.is_none_or(|chart| chart.incomplete), "{text}");
    }
}

#[test]
fn declarations() {
    in_chart(&[
        ("input a, b bool;", "bool", "expected `:` and a type, as in `input a, b: bool;`"),
        ("input ;", ";", "expected a name"),
        ("input a,: bool;", ":", "expected a name after `,`"),
        ("input a: ;", ";", "expected a type"),
        ("var a = 0;", "=", "expected `:` and a type"),
        ("var a: u16 := 0;", ":", "not `:=`"),
        ("var a: u16 = ;", ";", "expected a value"),
        ("var a: u16 = 1 +;", ";", "expected an expression"),
        ("var a: (u8 u8);", "u8", "unexpected token"),
        ("input a: bool = true;", "= true", "no initial value"),
        ("param a: time = T#5s;", "#", "not `T#5s`"),
        ("input a: bool", "bool", "`;` is missing"),
        ("input a: bool output b: bool;", "bool", "`;` is missing"),
        ("action heat;", ";", "arguments in parentheses"),
        ("action heat(i16);", ")", "expected `:` and the type of `i16`"),
        ("action heat(a: i16 b: i16);", "b", "expected `,`"),
        ("action heat() -> bool;", "-", "no result"),
        ("action heat() { }", "{", "a method of the chart's trait"),
        ("a: bool;", "a", "say what `a` is: `input a: bool;`"),
        ("Input a: bool;", "Input", "write `input`"),
        ("intput a: bool;", "intput", "write `input`"),
        ("inputs a: bool;", "inputs", "write `input`"),
        ("in a: bool;", "in", "write `input`"),
        ("let a: bool = true;", ": bool", "has the type of its expression"),
        ("let mut a = true;", "mut", "never written"),
        ("let a;", ";", "expected `=` and a condition"),
        ("let a = ;", ";", "expected a condition"),
        ("const a: bool = true;", "const", "write `param`"),
        ("fn a() { }", "fn", "code is declared `action"),
    ]);
}

#[test]
fn settings_and_properties() {
    in_chart(&[
        ("clock 1;", "1", "`1` has no unit of time"),
        ("clock 1min;", "1min", "`min` is no unit"),
        ("clock tick;", "tick", "the clock's unit is a time such as `1ms`"),
        ("max_evolutions x;", "x", "expected a number"),
        ("max_evolutions 1.5;", "1.5", "a whole number"),
        ("budget 5u8;", "5u8", "a plain number"),
        ("budget -5;", "-", "expected a number"),
        ("optimize speed;", "speed", "a chart can be optimized for `size`, found `speed`"),
        ("optimize;", ";", "write `optimize size;`"),
        ("encoding enums;", "enums", "the encoding that can be asked for is `flags`, found `enums`"),
        ("encoding = flags;", "=", "the encoding that can be asked for is `flags`, found `=`"),
        ("encoding;", ";", "write `encoding flags;`"),
        ("assume b1 && b2;", "b1", "written `assume never b1 && b3;`"),
        ("never ;", ";", "what must never hold"),
        ("never a = b;", "=", "compares with `==`"),
        ("always => a;", "=", "what must always hold"),
        ("always a => ;", ";", "what follows from it"),
        ("home ;", ";", "the step of the home situation"),
        ("home ();", ")", "at least one step"),
        ("home A, B;", ",", "in parentheses: `home (A, B);`"),
    ]);
}

#[test]
fn steps() {
    in_chart(&[
        ("Step A { }", "Step", "write `step`"),
        ("state A { }", "state", "write `step`"),
        ("stp A { }", "stp", "write `step`"),
        ("init step A;", "init", "write `initial`"),
        ("Initial step A;", "Initial", "write `initial`"),
        ("initial State A;", "State", "write `step`"),
        ("initial A { }", "initial", "`step` is missing"),
        ("initial A;", "initial", "`step` is missing"),
        ("initial initial step A;", "initial", "stands here twice"),
        ("macro enclosing step A { }", "enclosing", "not both"),
        ("step ;", ";", "expected the name of the step"),
        ("step { }", "{", "expected the name of the step"),
        ("step A: { }", ":", "stands in braces"),
        ("step A", "A", "`;` is missing"),
        ("step A step B;", "A", "`;` is missing"),
        ("macro step A;", ";", "the braces of the macro-step `A`"),
        ("enclosing step A;", ";", "the braces of the enclosing step `A`"),
        ("partial ;", ";", "the name of the partial grafcet"),
        ("partial A;", ";", "`partial A { … }`"),
        ("A { }", "A", "`step A { … }` or `partial A { … }`"),
        ("transition A to B;", "transition", "`A -[condition]-> B;`"),
        ("q = 1;", "q", "what a step does stands in its braces"),
        ("N q;", "N", "what a step does stands in its braces"),
        ("force G {};", "force", "what a step does stands in its braces"),
        ("5;", "5", "expected a declaration, a step or a chain"),
        ("a b c;", "a", "expected a declaration, a step or a chain"),
        ("step A { partial P { step B; } }", "P", "only an `enclosing step`"),
    ]);
}

#[test]
fn associations() {
    in_step(&[
        ("X q;", "X", "`X` is no qualifier; the qualifiers are N, S, R, L"),
        ("s q;", "s", "write `S`"),
        ("p1 q;", "p1", "write `P1`"),
        ("sd 5s q;", "sd", "write `SD`"),
        ("X 5s q;", "X", "no qualifier"),
        ("run { x() }", "run", "no qualifier"),
        ("L q;", "L", "needs two things after it, a time and its target: `L 5s q;`"),
        ("L q = true;", "L", "needs a time"),
        ("SD heat(80);", "SD", "needs a time"),
        ("DS q if a;", "DS", "needs a time"),
        ("SL { x() }", "SL", "needs a time"),
        ("D 5 q;", "5", "`5` has no unit of time"),
        ("D 5min q;", "5min", "`min` is no unit"),
        ("D (t) q;", "(", "a literal such as `5s` or the name"),
        ("N 5s q;", "5s", "`N` takes no time"),
        ("S 5s q;", "5s", "`S` takes no time"),
        ("R 5s q;", "5s", "`R` takes no time"),
        ("P 5s q;", "5s", "`P` takes no time"),
        ("P1 5s { x() };", "5s", "`P1` takes no time"),
        ("S;", "S", "acts on something: `S q;`"),
        ("L;", "L", "acts on something: `L 5s q;`"),
        ("L 5s;", "L 5s", "acts on nothing"),
        ("N S q;", "N S", "one qualifier"),
        ("count += 1;", "+", "write `count = count + …`, or a block: `P1 { count += …; }`"),
        ("N count <<= 1;", "<", "write `count = count << …`"),
        ("q := true;", ":", "written `q = …`"),
        ("q == true;", "=", "an assignment is written `q = …`"),
        ("a.b = 1;", ".", "a whole output or variable"),
        ("a[0] = 1;", "[", "a whole output or variable"),
        ("q = ;", ";", "expected the value of `q`"),
        ("q = a b;", "b", "expected `;`, found `b`"),
        ("heat(a b);", "b", "expected `,`"),
        ("q if;", ";", "the condition of the action"),
        ("q if a = b;", "=", "compares with `==`"),
        ("q if a AND b;", "AND", "`AND` is written `&&`"),
        ("on { x() }", "{", "expected an event"),
        ("on rising(a) ;", "on rising(a)", "acts on nothing"),
        ("{ x() }", "{", "a block has a qualifier"),
        ("if a { x() }", "if", "the condition stands after the action"),
        ("P1 { let; }", ";", "expected"),
        (";", ";", "ends nothing"),
        ("q", "q", "`;` is missing"),
        ("q N r;", "q", "`;` is missing"),
        ("N q S r;", "q", "`;` is missing"),
        ("q if a N r;", "a", "`;` is missing"),
        ("/// Doc.\n q;", "/// Doc.", "nothing that an attribute or a doc comment could reach"),
        ("#[allow(dead_code)] q;", "#[allow(dead_code)]", "nothing that an attribute"),
        ("#[cfg(test)] q;", "#[cfg(test)]", "on the whole macro call"),
        ("force G;", ";", "`{S1, S2}`, `{*}`, `{}` or `{INIT}`"),
        ("force G {*, A};", ",", "stand alone"),
        ("force G {A, INIT};", "INIT", "stands alone"),
        ("force G {A B};", "B", "expected `,`"),
        ("force G::H {};", ":", "expected the situation"),
        ("A -[x]-> B;", "A", "transitions stand after the steps"),
        ("input a: bool;", "input", "declarations stand in front of the steps"),
        ("step B { }", "step", "beside this step, not in it"),
        ("Step B { }", "Step", "a step cannot stand in a step"),
    ]);
}

#[test]
fn chains() {
    in_chart(&[
        ("A --[x]-> B;", "--", "single dashes"),
        ("A -[x]--> B;", "-->", "single dashes"),
        ("A -[x]- B;", "-[x]-", "the head of this arrow is missing"),
        ("A -[x] B;", "-[x]", "the head of this arrow is missing"),
        ("A -[x]> B;", ">", "`-[x]->`"),
        ("A [x]-> B;", "[", "in front of this `-` is missing"),
        ("A ->[x] B;", "->", "stands after its condition"),
        ("A -x-> B;", "-x->", "stands in brackets: `-[x]->`"),
        ("A -x && !y-> B;", "-x && !y->", "stands in brackets"),
        ("A -(x)-> B;", "-(x)->", "stands in brackets"),
        ("A --> B;", "-->", "`-[true]->` for always"),
        ("A <-[x]- B;", "<", "arrows point forward"),
        ("A -[]-> B;", "-[]->", "write `-[true]->`"),
        ("A -[x]-> B, C;", "B", "parallel steps stand in parentheses"),
        ("A, B -[x]-> C;", "A", "parallel steps stand in parentheses"),
        ("(A B) -[x]-> C;", "B", "expected `,`"),
        ("(A | B) -[x]-> C;", "|", "expected `,`"),
        ("A.X -[x]-> B;", ".", "without `.X`"),
        ("P::A -[x]-> B;", ":", "stays inside its partial grafcet"),
        ("A -[x]-> step B;", "step", "declare the step on a line of its own"),
        ("A;", "A", "a step alone says nothing"),
        ("A -[x]-> B", "B", "`;` is missing"),
        ("A -[x]-> B B -[y]-> C;", "B", "`;` is missing"),
        ("A -[x]-> B step C;", "B", "`;` is missing"),
        ("A -[x] ;", "-[x]", "has no head and leads nowhere"),
        ("A - B;", "A", "`A -[condition]-> B;`"),
        ("A => B;", "=>", "drawn with its condition"),
    ]);
}

#[test]
fn conditions() {
    let condition = |cases: &[(&str, &str, &str)]| check("sfc C { A -[", "]-> B; }", cases);
    condition(&[
        ("x y", "y", "expected `]` after the condition"),
        ("x, y", ",", "combined with `&&` or `||`"),
        ("x;", ";", "ends with its bracket"),
        ("x AND y", "AND", "`AND` is written `&&`"),
        ("x or y", "or", "`or` is written `||`"),
        ("NOT x", "NOT", "`NOT` is written `!`"),
        ("NOT (x) AND", "NOT", "`NOT` is written `!`"),
        ("x && NOT y", "NOT", "`NOT` is written `!`"),
        ("(x AND y) || z", "AND", "`AND` is written `&&`"),
        ("x XOR y", "XOR", "`XOR` is written `^`"),
        ("x = 1", "=", "compares with `==`"),
        ("a && (x = 1)", "=", "compares with `==`"),
        ("x += 1", "+=", "a condition changes nothing"),
        ("x := 1", ":", "compares with `==`"),
        ("x <> y", "<>", "`<>` is written `!=`"),
        ("/x", "/", "a negation is written `!a`"),
        ("else if x", "if", "`else` has no condition of its own"),
        ("go:", "]", "expected a condition"),
        ("=> x = 1", "=", "expected a condition"),
        ("x =>", "]", "expected a name, an assignment, a call or a block"),
        ("x => y += 1", "+", "write `y = y + …`"),
        ("x => y = 1 z", "z", "expected `]`"),
        ("x &&", "]", "expected an expression"),
        ("(a b)", "b", "expected `,`"),
    ]);
}

#[test]
fn attributes() {
    in_chart(&[
        ("#[cfg(x)] step A;", "#[cfg(x)]", "on the whole macro call"),
        ("#[cfg_attr(x, y)] input a: bool;", "#[cfg_attr(x, y)]", "on the whole macro call"),
        ("#[cfg_attr(x, derive(Hash))] step A;", "#[cfg_attr(x, derive(Hash))]", "derives stand in front of the chart"),
        ("#[derive(Hash)] step A;", "#[derive(Hash)]", "derives stand in front of the chart"),
        ("#[inline] action a();", "#[inline]", "possible here are doc comments"),
        ("#[allow] step A;", "#[allow]", "lists its lints"),
        ("#[allow(rustfmt::skip)] step A;", "rustfmt::skip", "possible are lints of rustc"),
        ("#[allow(grafcet::a::b)] step A;", "grafcet::a::b", "a rule is named `grafcet::…`"),
        ("#[allow(grafcet::a)] step A;", "a", "no rule is called `a`"),
        (
            "#[expect(grafcet::several_initial_steps)] step A;",
            "grafcet::several_initial_steps",
            "`expect` is for lints of rustc",
        ),
        ("#[allow(a b)] step A;", "b", "expected `,`"),
        ("#[doc a b] step A;", "a", "unexpected token"),
        ("# step A;", "#", "a comment is written"),
        (
            "#[allow(grafcet::several_initial_steps)] clock 1ms;",
            "#[allow(grafcet::several_initial_steps)]",
            "a setting has nothing",
        ),
        ("#[allow(dead_code)] never A.X;", "#[allow(dead_code)]", "nothing is generated for a property"),
        (
            "step A; #![allow(grafcet::several_initial_steps)]",
            "#![allow(grafcet::several_initial_steps)]",
            "at the beginning of the braces",
        ),
        ("#![allow(dead_code)]", "#![allow(dead_code)]", "only the levels of rules"),
        ("#![doc = \"x\"]", "#![doc = \"x\"]", "only the levels of rules"),
        ("#![cfg(x)]", "#![cfg(x)]", "on the whole macro call"),
        ("step A; #[doc(hidden)]", "}", "expected an item after its attributes"),
    ]);
}

/// `return`, `break`, `continue` and `?` leave something of the user's own, or are refused.
#[test]
fn nothing_of_the_user_leaves_the_cycle() {
    in_chart(&[
        ("A -[a || return]-> B;", "return", "would leave the chart's cycle half-way"),
        ("A -[{ break }]-> B;", "break", "there is no loop around this `break`"),
        ("A -[if a { continue } else { b }]-> B;", "continue", "there is no loop around this `continue`"),
        ("A -[f()?]-> B;", "?", "`.unwrap_or(…)`"),
        ("A -[!rising(f()?)]-> B;", "?", "would leave the chart's cycle"),
        ("A -[a => n = return]-> B;", "return", "would leave"),
        ("A -[a => { return; }]-> B;", "return", "would leave"),
        ("never a && f()?;", "?", "would leave"),
        ("var n: u8 = break;", "break", "no loop"),
        ("A -['x: { break 'y }]-> B;", "break", "nothing called `'y`"),
        ("A -['x: { break }]-> B;", "break", "no loop"),
        ("A -[{ for x in (return) { } a }]-> B;", "return", "would leave"),
        ("A -[{ for x in { break } { } a }]-> B;", "break", "no loop"),
        ("A -[matches!(f()?, 1)]-> B;", "?", "would leave"),
        ("A -[m!(a; return)]-> B;", "return", "would leave"),
        ("A -[m! { a => [f()?] }]-> B;", "?", "would leave"),
    ]);
    in_step(&[
        ("q if { return };", "return", "would leave"),
        ("f(a, return);", "return", "would leave"),
        ("q = loop { return };", "return", "would leave"),
        ("P1 { continue; }", "continue", "no loop"),
        ("on { return } q;", "{", "expected an event"),
        ("on a || return q;", "return", "would leave"),
        ("P1 { let Some(x) = y else { return }; }", "return", "would leave"),
    ]);
}

/// The same inside something that may be left.
#[test]
fn what_is_left_may_be_the_users_own() {
    for text in [
        "A -[(|| { return a })()]-> B;",
        "A -[(|| Some(f()? > 1))().is_some()]-> B;",
        "A -[loop { if a { break b } else { continue } }]-> B;",
        "A -['x: { if a { break 'x b } c }]-> B;",
        "A -['x: loop { loop { break 'x a } }]-> B;",
        "A -[{ while a { break } b }]-> B;",
        "A -[{ for x in y { if x { continue } } b }]-> B;",
        "A -[{ fn f() -> bool { return true } f() }]-> B;",
        "A -[{ async { return f()? }; a }]-> B;",
        "A -[loop { m!(a; break) }]-> B;",
        "step C { P1 { 'x: { let Some(n) = y else { break 'x }; q = n; } } }",
        "input x: Foo<dyn Bar + ?Sized>;",
    ] {
        let (_, errors) = run(&format!("sfc C {{ {text} }}"));
        assert!(errors.is_empty(), "{text}: {errors:?}");
    }
}
