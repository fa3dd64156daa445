//! `diff`: what has changed, in a person's words.

mod common;

use std::fs;
use std::path::Path;

use common::{Done, folder, tool};
use serde_json::Value;

/// The old version in all tests.
const BASE: &str = "sfc Motor {
    input on, off, hot: bool; input level: u8; output relay, lamp: bool;
    initial step Off { N lamp if hot; } step On { N relay; } step Cool within 9s { N lamp; }
    Off -[on]-> On -[off]-> Off;
    On -[hot]-> Cool -[5s/Cool && level < 10]-> Off;
    never relay && lamp;
}";

fn diff(old: &str, new: &str, more: &[&str]) -> Done {
    let folder = folder(&[("old.rs", old), ("new.rs", new)]);
    tool(folder.path(), &[&["diff", "old.rs", "new.rs"], more].concat())
}

/// What is said where some words of the chart are others.
fn said(replaced: &[(&str, &str)]) -> Vec<String> {
    let new = replaced.iter().fold(BASE.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    });
    let done = diff(BASE, &new, &[]);
    assert_eq!(done.code, Some(i32::from(!done.out.contains("nothing has changed"))), "{done:?}");
    let mut lines = done.out.lines().map(str::to_owned);
    let count = lines.next().expect("a line");
    let lines: Vec<String> = lines.map(|line| line.trim_start().to_owned()).collect();
    let counted = match lines.len() {
        0 => "Motor: nothing has changed".to_owned(),
        1 => "Motor: 1 change".to_owned(),
        count => format!("Motor: {count} changes"),
    };
    assert_eq!(count, counted);
    lines
}

#[test]
fn blanks_and_comments_are_no_change() {
    let nothing: [String; 0] = [];
    assert_eq!(said(&[]), nothing);
    let replaced =
        [("5s/Cool && level < 10", "5s/Cool&&level<10"), ("N lamp if hot", "N lamp // soon\n /* ! */ if hot")];
    assert_eq!(said(&replaced), nothing);
    assert_eq!(said(&[("output relay, lamp: bool", "output relay: bool; output lamp: bool")]), nothing);
}

#[test]
fn conditions_and_ends() {
    assert_eq!(
        said(&[("level < 10", "level < 9")]),
        ["`Cool → Off` clears on `5s/Cool && level < 9` instead of `5s/Cool && level < 10`"]
    );
    assert_eq!(said(&[("-[off]-> Off", "-[off]-> Cool")]), ["the transition `On → Off` on `off` is now `On → Cool`"]);
    assert_eq!(said(&[("-[on]->", "-[go: on]->")]), ["the transition `Off → On` on `on` is now `go: Off → On`"]);
    assert_eq!(
        said(&[("On -[hot]->", "On -[!on]-> Off; On -[hot]->")]),
        ["there is a new transition `On → Off` on `!on`, with priority over `On → Cool`"]
    );
    assert_eq!(
        said(&[("On -[off]-> Off", "On"), ("On -[hot]->", "On -[hot || off]->")]),
        ["the transition `On → Off` on `off` is gone", "`On → Cool` clears on `hot || off` instead of `hot`",]
    );
}

#[test]
fn what_any_leaves() {
    let chart = "sfc C { input a, stop: bool; initial step X; step Y; step Z; any -[stop]-> Z; X -[a]-> Y -[!a]-> X; Z -[!stop]-> X; }";
    let done = diff(chart, &chart.replace("any -", "any except Y -"), &[]);
    assert_eq!(done.out, "C: 1 change\n  the transition `any → Z` on `stop` is now `any except Y → Z`\n");
}

#[test]
fn order_is_priority() {
    let both = "Off -[on]-> On -[off]-> Off;\n    On -[hot]-> Cool";
    let turned = "On -[hot]-> Cool;\n    Off -[on]-> On -[off]-> Off;\n    Cool";
    assert_eq!(said(&[(both, turned)]), ["`On → Cool` on `hot` now has priority over `On → Off` on `off`"]);
    // In a grafcet all of them clear.
    let grafcet = |text: &str| text.replace("sfc", "grafcet").replace("N relay", "relay").replace("N lamp", "lamp");
    let done = diff(&grafcet(BASE), &grafcet(&BASE.replace(both, turned)), &[]);
    assert_eq!((done.code, done.out.as_str()), (Some(0), "Motor: nothing has changed\n"), "{done:?}");
}

#[test]
fn steps_and_actions() {
    assert_eq!(said(&[("N relay;", "N relay; N lamp;")]), ["the step `On` also does `N lamp`"]);
    assert_eq!(said(&[(" { N relay; }", ";")]), ["the step `On` no longer does `N relay`"]);
    assert_eq!(
        said(&[("N relay;", "N relay if !off;")]),
        ["the step `On` does `N relay if !off` instead of `N relay`"]
    );
    assert_eq!(said(&[("within 9s ", "")]), ["the step `Cool` is no longer within 9s"]);
    assert_eq!(
        said(&[("initial step Off", "step Off"), ("step On", "initial step On")]),
        ["the step `Off` is no longer initial", "the step `On` is now initial",]
    );
    assert_eq!(
        said(&[
            ("step Cool", "step Rest { N lamp; } step Cool"),
            ("-> Off;\n    never", "-> Rest -[on]-> Off;\n    never")
        ]),
        [
            "there is a new step `Rest` with `N lamp`",
            "the transition `Cool → Off` on `5s/Cool && level < 10` is now `Cool → Rest`",
            "there is a new transition `Rest → Off` on `on`",
        ]
    );
    assert_eq!(
        said(&[(
            "step On { N relay; } step Cool within 9s { N lamp; }",
            "step Cool within 9s { N lamp; } step On { N relay; }"
        )]),
        ["the order of the steps is Off, Cool, On instead of Off, On, Cool"]
    );
}

#[test]
fn what_is_only_called_otherwise() {
    assert_eq!(said(&[("Cool", "Rest")]), ["the step `Cool` is now called `Rest`"]);
    assert_eq!(said(&[("hot", "warm")]), ["the input `hot` is now called `warm`"]);
    // Two that are neighbours, and a condition that is another one besides.
    assert_eq!(
        said(&[("On ", "Running "), ("Cool", "Rest"), ("level < 10", "level < 9")]),
        [
            "the step `On` is now called `Running`",
            "the step `Cool` is now called `Rest`",
            "`Rest → Off` clears on `5s/Rest && level < 9` instead of `5s/Cool && level < 10`",
        ]
    );
    // Neighbours of which nothing else tells.
    let chain = "sfc C { input a, b, c: bool; initial step X; step Y; step Z; X -[a]-> Y -[b]-> Z -[c]-> X; }";
    let done = diff(chain, &chain.replace('Y', "Two").replace('Z', "Three"), &[]);
    assert_eq!(done.out, "C: 2 changes\n  the step `Y` is now called `Two`\n  the step `Z` is now called `Three`\n");
    // Its transitions are the same, its action is not.
    assert_eq!(
        said(&[("On ", "Running "), ("N relay;", "N relay; N lamp;")]),
        ["the step `On` is now called `Running`", "the step `Running` also does `N lamp`",]
    );
    // Nothing is the same: one step is gone, another is there.
    let lines = said(&[
        ("step On { N relay; }", "step Run { N lamp; }"),
        ("On -[off]-> Off;\n    On -[hot]->", "Run -[!on]-> Off;\n    Run -[hot && on]->"),
    ]);
    assert!(lines.contains(&"the step `On` is gone".to_owned()), "{lines:?}");
    assert!(lines.contains(&"there is a new step `Run` with `N lamp`".to_owned()), "{lines:?}");
}

#[test]
fn what_is_declared_and_claimed() {
    assert_eq!(said(&[("level: u8", "level: u16")]), ["the input `level` is `u16` instead of `u8`"]);
    assert_eq!(
        said(&[("input on, off", "input off, on")]),
        ["the order of the inputs is off, on, hot, level instead of on, off, hot, level"]
    );
    assert_eq!(said(&[("hot: bool", "hot, spare: bool")]), ["there is a new input `spare`: `bool`"]);
    assert_eq!(
        said(&[("never relay && lamp;", "always !relay || !lamp;")]),
        ["the property `never relay && lamp` is gone", "there is a new property `always !relay || !lamp`",]
    );
    assert_eq!(said(&[("sfc Motor {", "sfc Motor { forceable;")]), ["forceable: yes instead of no"]);
}

#[test]
fn files_and_formats() {
    let two = |first: &str, second: &str| format!("grafcet! {{ {first} }} grafcet! {{ {second} }}");
    let other = "sfc Lamp { input on: bool; output lit: bool; initial step Dark; step Lit { lit; } Dark -[on]-> Lit -[!on]-> Dark; }";
    let changed = BASE.replace("-[hot]->", "-[hot || off]->");
    let done = diff(&two(BASE, other), &two(&other.replace("Lamp", "Light"), &changed), &[]);
    assert_eq!(done.code, Some(1));
    assert_eq!(
        done.out,
        "Lamp: 1 change\n  the chart is gone\nLight: 1 change\n  the chart is new\n\
         Motor: 1 change\n  `On → Cool` clears on `hot || off` instead of `hot`\n"
    );
    // One in each file: they belong together, whatever they are called.
    let done = diff(other, &other.replace("Lamp", "Light"), &[]);
    assert_eq!(done.out, "Light: 1 change\n  the chart is called `Light` instead of `Lamp`\n");
    let done = diff(BASE, &changed, &["--draw"]);
    assert!(done.out.contains("~ hot || off"), "{}", done.out);
    assert_eq!(done.out.matches("━┿━  ~").count(), 1, "{}", done.out);
    let done = diff(BASE, &changed, &["--json"]);
    let line: Value = serde_json::from_str(done.out.trim_end()).expect("one object");
    assert_eq!(
        [&line["chart"], &line["kind"], &line["old"], &line["new"]],
        ["Motor", "condition", "hot", "hot || off"]
    );
    assert_eq!(line["steps"], serde_json::json!(["On"]));
    // What is no chart cannot be compared.
    let done = diff(BASE, &BASE.replace("-[hot]-> Cool", "-[hot]-> Cold"), &[]);
    assert_eq!((done.code, done.out.as_str()), (Some(2), ""));
    assert!(done.err.ends_with("error: new.rs: the chart Motor has mistakes\n"), "{}", done.err);
    let done = diff(BASE, BASE, &["--chart", "Pump"]);
    assert_eq!((done.code, done.err.as_str()), (Some(2), "error: there is no chart `Pump` in either file\n"));
}

#[test]
fn every_chart_is_the_same_as_itself() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    for folder in ["tests/good", "examples/charts"] {
        for entry in fs::read_dir(root.join(folder)).expect("a folder") {
            let file = entry.expect("an entry").path();
            if file.extension().is_none_or(|end| end != "rs") || file.ends_with("script.rs") {
                continue;
            }
            let file = file.display().to_string();
            let done = tool(&root, &["diff", &file, &file]);
            assert_eq!((done.code, done.err.as_str()), (Some(0), ""), "{file}: {done:?}");
            assert!(done.out.lines().all(|line| line.ends_with(": nothing has changed")), "{file}: {}", done.out);
        }
    }
}

/// Of the parameters of a code action the types count, too.
#[test]
fn types_of_parameters() {
    let declared = ("output relay, lamp: bool;", "output relay, lamp: bool; action tell(count: u8, late: bool);");
    assert_eq!(said(&[declared]), ["there is a new code action `tell`: `(count: u8, late: bool)`"]);
    let old = BASE.replace(declared.0, declared.1);
    let done = diff(&old, &old.replace("count: u8", "count: u16"), &[]);
    let sentence = "the code action `tell` is `(count: u16, late: bool)` instead of `(count: u8, late: bool)`";
    assert_eq!(done.out, format!("Motor: 1 change\n  {sentence}\n"));
    assert_eq!(diff(&old, &old, &[]).code, Some(0));
}

#[test]
fn levels_of_rules() {
    let all = [
        ("sfc Motor {", "sfc Motor { #![warn(grafcet::deadlock)]"),
        ("step On {", "#[allow(grafcet::unreachable_step)] step On {"),
        ("input level: u8;", "#[allow(grafcet::unused_input)] input level: u8;"),
        ("On -[hot]->", "#[deny(grafcet::always_true)] On -[hot]->"),
        ("never relay", "#[allow(grafcet::property_undecided)] never relay"),
    ];
    let new = all.iter().fold(BASE.replace("hot: bool; input", "hot: bool;\n    input"), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replacen(from, to, 1)
    });
    let done = diff(BASE, &new, &[]);
    let expected = [
        "Motor: 6 changes",
        "  the chart now has `warn(grafcet::deadlock)`",
        "  the input `level` now has `allow(grafcet::unused_input)`",
        "  the step `On` now has `allow(grafcet::unreachable_step)`",
        "  the transition `On → Cool` now has `deny(grafcet::always_true)`",
        "  the transition `Cool → Off` now has `deny(grafcet::always_true)`",
        "  the property `never relay && lamp` now has `allow(grafcet::property_undecided)`",
    ];
    assert_eq!(done.out.lines().collect::<Vec<_>>(), expected, "{done:?}");
    let done = diff(&new, BASE, &["--json"]);
    let changes: Vec<Value> = done.out.lines().map(|line| serde_json::from_str(line).expect(line)).collect();
    assert_eq!(changes.len(), 6);
    assert_eq!((&changes[2]["kind"], &changes[2]["steps"][0]), (&"level".into(), &"On".into()));
    assert_eq!(changes[2]["sentence"], "the step `On` no longer has `allow(grafcet::unreachable_step)`");
    // Another level of the same rule, at a step that has another name now.
    let other =
        new.replace("allow(grafcet::unreachable_step)", "warn(grafcet::unreachable_step)").replace("On", "Runs");
    let done = diff(&new, &other, &[]);
    let expected = [
        "Motor: 2 changes",
        "  the step `On` is now called `Runs`",
        "  the step `Runs` has `warn(grafcet::unreachable_step)` instead of `allow(grafcet::unreachable_step)`",
    ];
    assert_eq!(done.out.lines().collect::<Vec<_>>(), expected, "{done:?}");
    // What goes with its step needs no word of its own.
    let with = BASE.replace("step Cool", "#[allow(grafcet::unreachable_step)] step Cool");
    let without = [("step Cool within 9s { N lamp; }", ""), ("On -[hot]-> Cool -[5s/Cool && level < 10]-> Off;", "")];
    let without = without.iter().fold(BASE.to_owned(), |text, (from, to)| text.replace(from, to));
    let done = diff(&with, &without, &[]);
    assert!(done.out.contains("the step `Cool` is gone") && !done.out.contains("grafcet::"), "{done:?}");
}

/// Both versions in one drawing: each kind of change has its sign, what is gone is drawn, and what is the same has none.
#[test]
fn changes_are_marked_in_the_drawing() {
    let old = "sfc Motor {
        input on, off, hot: bool; input level: u8; output relay, lamp, horn: bool; var n: u8 = 0;
        initial step Off { N lamp if hot; } step On { N relay; N horn; } step Cool within 9s { N lamp; } step Rest { S horn; }
        Off -[on]-> On -[off]-> Off;
        On -[hot => n = 0]-> Cool -[5s/Cool && level < 10]-> Off;
        On -[level > 100]-> Rest -[on]-> Off;
    }";
    let new = "sfc Motor {
        input on, off, hot: bool; input level: u8; output relay, lamp, horn: bool; var n: u8 = 0;
        initial step Off { N lamp if hot; } step On { N horn; N relay; } step Cool within 10s { N lamp if level > 2; } step Fresh { R horn; }
        On -[hot => n = 1]-> Cool -[5s/Cool && level < 9]-> Off;
        Off -[on]-> On -[off]-> Off;
        On -[level > 200]-> Fresh -[on]-> Off;
    }";
    let folder = folder(&[("old.rs", old), ("new.rs", new)]);
    let run = |more: &[&str]| tool(folder.path(), &[&["diff", "old.rs", "new.rs"], more].concat());
    let done = run(&["--draw"]);
    assert_eq!(done.code, Some(1), "{done:?}");
    for marked in [
        "│ + new    − gone    ~ changed    ↕ order changed │",
        "━┿━  on\n",
        "┤ N │ ↕ horn  │",
        "│ N │ ↕ relay │",
        "━┿━  ~↕ hot ",
        " + ⇒ n := 1 ",
        " − ⇒ n := 0 ",
        "━┿━  ↕ off ",
        "━┿━  + level > 200 ",
        // It is gone, so it has no priority.
        "━┿━  − level > 100\n",
        "│1                            │2           │3                        │\n",
        "│ ~ Cool  ├",
        "┤ N │ + lamp   │",
        "│ N │ − lamp   │",
        "│ + Fresh ├",
        "│ − Rest  ├",
        "━┿━  ~ 5s/Cool && level < 9 ",
        " − 5s/Cool && level < 10 ",
    ] {
        assert!(done.out.contains(marked), "{marked}\n{}", done.out);
    }
    let (signs, colours) = (["+", "−", "~", "↕"], ["#0072b2", "#d55e00", "#cc79a7", "#009e73"]);
    assert_eq!(run(&["-o", "changes.svg"]).code, Some(1));
    let svg = fs::read_to_string(folder.path().join("changes.svg")).expect("the drawing");
    let rects: Vec<&str> =
        svg.split('<').filter(|tag| tag.starts_with("rect") && tag.contains("fill-opacity")).collect();
    // The lines differ where nobody sees the colours.
    let mut dashes: Vec<Option<&str>> = Vec::new();
    for (sign, colour) in signs.iter().zip(colours) {
        assert!(svg.contains(&format!(">{sign} ")), "{sign}");
        let of: Vec<&&str> = rects.iter().filter(|tag| tag.contains(colour)).collect();
        assert!(of.len() > 1, "{sign} in the legend and in the chart: {of:?}");
        let dash = of[0].split_once("stroke-dasharray=\"").map(|(_, rest)| rest.split('"').next().unwrap_or_default());
        assert!(!dashes.contains(&dash), "{sign}: {dash:?}");
        dashes.push(dash);
    }
    // What has changed stands there in words, too: for print.
    assert!(svg.contains("the step `Rest` is gone"), "{svg}");
    assert_eq!(run(&["-o", "changes.png"]).code, Some(1));
    assert!(fs::read(folder.path().join("changes.png")).expect("the picture").starts_with(b"\x89PNG"));
    let done = run(&["-o", "changes.doc"]);
    assert_eq!(
        (done.code, done.err.as_str()),
        (Some(2), "error: changes.doc: the drawing is written as .svg, .png or .txt\n")
    );
    let same = tool(folder.path(), &["diff", "old.rs", "old.rs", "--draw"]);
    assert!(same.code == Some(0) && !signs.iter().any(|sign| same.out.contains(&format!("{sign} "))), "{}", same.out);
}

/// Partial grafcets, macro-steps, forcing orders and `any` that are gone are drawn where they were.
#[test]
fn what_is_gone_is_drawn_where_it_was() {
    let old = "grafcet C { input a, b, stop: bool; output q, r: bool;
        partial One { initial step A; step B { q; force Two {V}; } A -[a]-> B -[!a]-> A; }
        partial Two { initial step V; step Y { r; } V -[b]-> Y -[!b]-> V; any -[stop]-> V; } }";
    let new = "grafcet C { input a, b, stop: bool; output q, r: bool;
        partial One { initial step A; step B { q; r; } A -[a]-> B -[!a]-> A; } }";
    let done = diff(old, new, &["--draw"]);
    for marked in ["│ Two ", "− V ", "− Y ", "║ − Two {V} ║", "│ + r ", "any", "− stop"] {
        assert!(done.out.contains(marked), "{marked}\n{}", done.out);
    }
    // The order that is gone stands after the action that is new.
    let back = diff(new, old, &["--draw"]);
    for marked in ["+ V ", "+ Y ", "+ Two {V}", "− r ", "+ stop"] {
        assert!(back.out.contains(marked), "{marked}\n{}", back.out);
    }
}

/// A step that is only called otherwise is marked, and its transitions are what they were.
#[test]
fn another_name_is_marked() {
    let done = diff(BASE, &BASE.replace("Cool", "Rest"), &["--draw"]);
    assert!(done.out.contains("│ ~ Rest  ├"), "{}", done.out);
    assert_eq!(done.out.matches('~').count(), 2, "in the legend and there: {}", done.out);
}

/// Where several charts are in both files, nothing says whose drawing the file gets.
#[test]
fn one_file_takes_one_drawing() {
    let two = "grafcet! { sfc A { input x: bool; initial step S; step T; S -[x]-> T -[!x]-> S; } }
        grafcet! { sfc B { input x: bool; initial step S; step T; S -[x]-> T -[!x]-> S; } }";
    let done = diff(two, two, &["-o", "both.svg"]);
    let said = "error: 2 charts are in both files, and one goes to one file: say which one: --chart A, --chart B\n";
    assert_eq!((done.code, done.err.as_str()), (Some(2), said));
    assert_eq!(diff(two, two, &["--chart", "B", "-o", "b.svg"]).code, Some(0));
}

/// Versions that git keeps, by its own words; the file of the other side where no path stands there.
#[test]
fn versions_of_git() {
    let folder = folder(&[("src/motor.rs", BASE)]);
    let git = |arguments: &[&str]| {
        let mut command = std::process::Command::new("git");
        command.args(["-c", "user.name=A", "-c", "user.email=a@b.c", "-c", "commit.gpgsign=false"]).args(arguments);
        command.env("GIT_CONFIG_GLOBAL", folder.path().join("none")).env("GIT_CONFIG_NOSYSTEM", "1");
        let done = command.current_dir(folder.path()).output().expect("git is there");
        assert!(done.status.success(), "{done:?}");
    };
    git(&["init", "-q"]);
    git(&["add", "."]);
    git(&["commit", "-q", "-m", "one"]);
    fs::write(folder.path().join("src/motor.rs"), BASE.replace("level < 10", "level < 9")).expect("written");
    let run = |arguments: &[&str]| tool(folder.path(), &[&["diff"], arguments].concat());
    let changed =
        "Motor: 1 change\n  `Cool → Off` clears on `5s/Cool && level < 9` instead of `5s/Cool && level < 10`\n";
    for old in ["HEAD:src/motor.rs", "HEAD:"] {
        let done = run(&[old, "src/motor.rs"]);
        assert_eq!((done.code, done.out.as_str(), done.err.as_str()), (Some(1), changed, ""), "{done:?}");
    }
    git(&["commit", "-q", "-a", "-m", "two"]);
    let done = run(&["HEAD~1:", "HEAD:src/motor.rs"]);
    assert_eq!((done.code, done.out.as_str()), (Some(1), changed), "{done:?}");
    let done = run(&["HEAD:", "src/motor.rs"]);
    assert_eq!((done.code, done.out.as_str()), (Some(0), "Motor: nothing has changed\n"), "{done:?}");
    // What is not there, and what is no revision.
    let done = run(&["HEAD:src/press.rs", "src/motor.rs"]);
    assert_eq!(done.code, Some(2), "{done:?}");
    assert!(
        done.err.contains("HEAD:src/press.rs: git says: path 'src/press.rs' does not exist in 'HEAD'"),
        "{}",
        done.err
    );
    let done = run(&["--", "--help:src/motor.rs", "src/motor.rs"]);
    assert!(done.code == Some(2) && done.err.contains("a revision does not begin with `-`"), "{done:?}");
    let done = tool(tempfile::tempdir().expect("a folder").path(), &["diff", "HEAD:a.rs", "HEAD:b.rs"]);
    assert!(done.code == Some(2) && done.err.contains("git says: "), "{done:?}");
}
