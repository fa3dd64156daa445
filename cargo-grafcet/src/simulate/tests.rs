//! Sessions without a terminal.

use std::fs;
use std::path::{Path, PathBuf};

use grafcet_sim::{Chart, Kind, Value};
use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

use super::screen::{Next, Screen};
use super::session::Session;
use super::{screen_of, script, terminal};
use crate::args::Charts;
use crate::find;

const LIFT: &str =
    "sfc Lift { input up: bool; input level: u8; input mode: Mode in {Off, Auto}; output motor: bool; var n: u16 = 0;
  initial step Wait; step Run { N motor; P { n = n + 1; } }
  Wait -[up && level > 2 && mode == Mode::Auto && clear(level)]-> Run -[5s/Run || level > LIMIT]-> Wait; }";

fn chart(source: &str) -> Chart {
    Chart::parse(source).unwrap_or_else(|refused| panic!("{refused}"))
}

fn press(screen: &mut Screen, session: &mut Session<'_>, keys: &str) {
    for key in keys.chars() {
        let code = match key {
            '\n' => KeyCode::Enter,
            '<' => KeyCode::Backspace,
            '^' => KeyCode::Up,
            '_' => KeyCode::Down,
            '\t' => KeyCode::Tab,
            key => KeyCode::Char(key),
        };
        assert_eq!(screen.press(KeyEvent::new(code, KeyModifiers::NONE), session), Next::Go);
    }
}

#[test]
fn keys_set_inputs_by_name_and_cycles_go_on_and_back() {
    let chart = chart(LIFT);
    let mut session = Session::new(&chart, 1000).expect("understood");
    let mut screen = Screen::of(&session);
    // `clear(level)` finds `c` free; `level` takes `l`, so `LIMIT` has `i`.
    assert_eq!(screen.keys, ['u', 'l', 'm', 'c', 'i'].map(Some));
    press(&mut screen, &mut session, "\n");
    assert!(session.simulation().is_active("Wait"));
    assert_eq!(
        session.simulation().blocked().to_string(),
        "`Wait → Run` waits for `up` (false); `level > 2` (level = 0); `mode == Mode::Auto` (mode = Off); `clear(level)` (level = 0)"
    );
    // A truth, a number, the next variant, a function of the program, and a constant of it.
    press(&mut screen, &mut session, "ul7\nmci9\n\n");
    assert!(session.simulation().is_active("Run"), "{}", session.simulation().blocked());
    assert_eq!(session.simulation().variable("n"), Some(Value::Int(1)));
    // Four seconds more, in which nothing moves, and one.
    press(&mut screen, &mut session, "\n\n\n\n");
    assert_eq!(session.simulation().blocked().waiting[0].name, "Run → Wait");
    assert!(session.simulation().is_active("Run"));
    press(&mut screen, &mut session, "\n");
    assert!(session.simulation().is_active("Wait"));
    assert_eq!(session.elapsed(), 6000);
    // Back to the beginning: nothing is left of it.
    press(&mut screen, &mut session, "<<<<<");
    assert!(session.simulation().is_active("Run"));
    assert_eq!((session.script().len(), session.elapsed(), session.values()[1].clone()), (2, 1000, Value::Int(7)));
    press(&mut screen, &mut session, "<");
    assert!(session.simulation().is_active("Wait"));
    assert_eq!((session.simulation().variable("n"), session.values()[1].clone()), (Some(Value::Int(0)), Value::Int(0)));
    press(&mut screen, &mut session, "<<");
    assert_eq!((session.script(), screen.message.as_deref()), (&[][..], Some("there is no earlier cycle")));
}

#[test]
fn what_is_typed_and_chosen() {
    let chart = chart(LIFT);
    let mut session = Session::new(&chart, 1000).expect("understood");
    let mut screen = Screen::of(&session);
    press(&mut screen, &mut session, "l1x<2");
    assert_eq!(screen.typing.as_deref(), Some("12"));
    press(&mut screen, &mut session, "\n");
    assert_eq!(session.values()[1], Value::Int(12));
    press(&mut screen, &mut session, "lmany\n");
    assert_eq!(screen.message.as_deref(), Some("`level` cannot be `many`: it is a whole number"));
    assert_eq!(session.values()[1], Value::Int(12));
    // One up, and at the edges nowhere.
    press(&mut screen, &mut session, "^^^\t");
    assert_eq!((screen.selected, session.values()[0].clone()), (0, true.into()));
    press(&mut screen, &mut session, "______");
    assert_eq!(screen.selected, 4);
    // A list begins anew after its last.
    press(&mut screen, &mut session, "mm");
    assert_eq!(session.values()[2], "Off".into());
    // What does not fit into a byte is an error of the cycle, and leaves everything as it was.
    press(&mut screen, &mut session, "l300\n\n");
    assert_eq!(screen.message.as_deref(), Some("this cycle cannot be run: overflow: 300 in 8 bits"));
    assert_eq!(session.script().len(), 0);
    // Who runs by himself does not try it again and again.
    press(&mut screen, &mut session, " ");
    screen.cycle(&mut session);
    assert!(!screen.running);
    press(&mut screen, &mut session, "+-- z");
    assert_eq!((session.step(), screen.running), (500, true));
    assert_eq!(screen.message.as_deref(), Some("no input has the key z"));
    press(&mut screen, &mut session, "<");
    assert!(!screen.running, "who goes back does not run on");
    for (code, next) in [('c', Next::End), ('s', Next::Save)] {
        assert_eq!(screen.press(KeyEvent::new(KeyCode::Char(code), KeyModifiers::CONTROL), &mut session), next);
    }
    assert_eq!(screen.press(KeyEvent::new(KeyCode::Esc, KeyModifiers::NONE), &mut session), Next::End);
}

#[test]
fn the_active_step_is_in_view() {
    let steps: Vec<String> = (1..20).map(|step| format!("step S{step}; ")).collect();
    let chain: Vec<String> = (1..20).map(|step| format!(" -[a]-> S{step}")).collect();
    let (steps, chain) = (steps.concat(), chain.concat());
    let chart = chart(&format!("sfc C {{ input a: bool; initial step S0; {steps} S0{chain} -[!a]-> S0; }}"));
    let mut session = Session::new(&chart, 1000).expect("understood");
    session.set(0, true.into());
    for cycle in 0..20 {
        session.cycle().expect("understood");
        let frame = screen_of(&session, (60, 14));
        let step = format!("●S{cycle} ");
        assert!(frame.contains(&step), "{frame}");
    }
}

#[test]
fn a_session_is_saved_as_a_script() {
    let chart = chart(LIFT);
    let mut session = Session::new(&chart, 1000).expect("understood");
    let mut screen = Screen::of(&session);
    press(&mut screen, &mut session, "\nul3\nmc\n\n");
    assert_eq!(
        terminal::text(&session),
        "-\n@1000 up level=3 mode=Auto `clear(level)`\n@2000 up level=3 mode=Auto `clear(level)`\n"
    );
}

/// The charts of the examples, of the corpus, and those that people draw.
fn all() -> Vec<(String, Chart)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let files = |folder: &str, ending: &str| -> Vec<PathBuf> {
        let entries = fs::read_dir(root.join(folder)).expect("a folder");
        let mut files: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
        files.retain(|file| file.extension().is_some_and(|end| end == ending));
        files.sort();
        files
    };
    let mut charts = Vec::new();
    let mut rust = files("tests/good", "rs");
    rust.extend(files("examples/charts", "rs").into_iter().filter(|file| !file.ends_with("script.rs")));
    let none = Charts { files: rust, chart: Vec::new(), package: Vec::new(), workspace: false, manifest_path: None };
    for found in find::charts(&none).unwrap_or_else(|failure| panic!("{failure}")) {
        let chart = Chart::of_tokens(found.tokens).unwrap_or_else(|refused| panic!("{}: {refused}", found.name));
        charts.push((found.name, chart));
    }
    for file in files("tests/conformance", "chart") {
        let text = fs::read_to_string(&file).expect("a chart of the corpus");
        let source = text.split("\n---").next().unwrap_or_default();
        charts.push((file.display().to_string(), chart(source)));
    }
    charts
}

#[test]
fn every_chart_can_be_played_shown_saved_and_taken_back() {
    let charts = all();
    assert!(charts.len() > 200, "{}", charts.len());
    for (name, chart) in &charts {
        let mut session = Session::new(chart, 500).unwrap_or_else(|error| panic!("{name}: {error}"));
        let mut seen = Vec::new();
        for cycle in 0..10 {
            for place in 0..session.signals().len() {
                let number = i128::try_from(place + cycle).expect("small");
                match session.signals()[place].kind {
                    Kind::Int { .. } => session.set(place, Value::Int(number % 5 + 1)),
                    _ if (place + cycle).is_multiple_of(3) => _ = session.toggle(place),
                    _ => {}
                }
            }
            let steps = session.cycle().unwrap_or_else(|error| panic!("{name}, cycle {cycle}: {error}")).steps.clone();
            if cycle % 5 == 0 {
                let frame = screen_of(&session, (80, 24));
                assert!(frame.starts_with(&format!("{} · ", chart.names().chart)), "{name}: {frame}");
                assert!(frame.contains(&format!("cycle {cycle} · ")), "{name}: {frame}");
                let step = steps.first().map_or("no active step", |step| &chart.names().steps[*step].name);
                let step: String = step.chars().take(20).collect();
                assert!(frame.contains(&step), "{name}: {frame}");
            }
            seen.push((steps, session.simulation().outputs()));
        }
        // The script alone does the same.
        let text = terminal::text(&session);
        let cycles = script::read(session.signals(), &chart.names().params, &text)
            .unwrap_or_else(|error| panic!("{name}: {error}\n{text}"));
        let mut again = Session::new(chart, 1).expect("understood");
        for (cycle, seen) in cycles.iter().zip(&seen) {
            let steps = again.play(cycle).unwrap_or_else(|error| panic!("{name}: {error}")).steps.clone();
            assert_eq!((steps, again.simulation().outputs()), *seen, "{name}");
        }
        assert_eq!(cycles.len(), seen.len(), "{name}");
        for (steps, outputs) in seen.iter().rev() {
            assert_eq!(
                (session.simulation().steps(), session.simulation().outputs()),
                (steps.clone(), outputs.clone()),
                "{name}"
            );
            assert!(session.back(), "{name}");
        }
        assert!(!session.back(), "{name}");
    }
}

const PRESS: &str = "grafcet Press { forceable; input go: bool; param most: u8 in 1..9 = 3; param soft: bool; output down: bool; var n: u8 = 0;
  initial step Up; step Down { down; P1 n = n + 1; } step Light;
  Up -[go && n < most && !soft]-> (Down, Light); (Down, Light) -[!go]-> Up; }";

#[test]
fn parameters_are_exchanged_and_come_back() {
    let chart = chart(PRESS);
    let mut session = Session::new(&chart, 100).expect("understood");
    let mut screen = Screen::of(&session);
    assert_eq!(screen.keys, ['g', 'm', 's'].map(Some));
    // Of which none is left to press.
    press(&mut screen, &mut session, "\nm1\ng\ng\ng\n");
    assert!(session.simulation().is_active("Up"));
    assert_eq!(session.simulation().variable("n"), Some(Value::Int(1)));
    assert!(screen_of(&session, (100, 24)).contains("param most"), "{}", screen_of(&session, (100, 24)));
    // What is out of range is said when the cycle comes, and leaves everything as it was.
    press(&mut screen, &mut session, "m0\n\n");
    let said = screen.message.clone().unwrap_or_default();
    assert!(said.starts_with("this cycle cannot be run: ") && said.contains("most"), "{said}");
    assert_eq!(session.script().len(), 4);
    press(&mut screen, &mut session, "m2\n\n");
    assert!(session.simulation().is_active("Down"));
    let text = terminal::text(&session);
    assert_eq!(text, "-\n@100 most=1 go\n@200 -\n@300 go\n@400 most=2 go\n");
    let mut again = Session::new(&chart, 1).expect("understood");
    for cycle in script::read(again.signals(), &chart.names().params, &text).expect("a script") {
        again.play(&cycle).expect("as it was");
    }
    assert_eq!(again.simulation().params(), [Value::Int(2), false.into()]);
    press(&mut screen, &mut session, "<");
    assert_eq!(
        (session.simulation().params()[0].clone(), session.shown_values().nth(1)),
        (Value::Int(1), Some(&Value::Int(1)))
    );
    press(&mut screen, &mut session, "<<<");
    assert_eq!(session.simulation().params()[0], Value::Int(3));
}

#[test]
fn init_starts_like_a_first_cycle() {
    let chart = chart(PRESS);
    let mut session = Session::new(&chart, 100).expect("understood");
    let mut screen = Screen::of(&session);
    press(&mut screen, &mut session, "\ng\n");
    assert!(session.simulation().is_active("Down"));
    assert_eq!(session.simulation().variable("n"), Some(Value::Int(1)));
    // The inputs stay: what is enabled in the initial situation clears as in a first cycle.
    press(&mut screen, &mut session, "g");
    let control = KeyEvent::new(KeyCode::Char('r'), KeyModifiers::CONTROL);
    assert_eq!(screen.press(control, &mut session), Next::Go);
    assert_eq!((screen.message.as_deref(), session.simulation().is_active("Up")), (None, true));
    assert_eq!(session.simulation().variable("n"), Some(Value::Int(0)));
    let text = terminal::text(&session);
    assert_eq!(text, "-\n@100 go\n@200 init{} -\n");
    let mut again = Session::new(&chart, 1).expect("understood");
    for cycle in script::read(again.signals(), &chart.names().params, &text).expect("a script") {
        again.play(&cycle).expect("as it was");
    }
    assert_eq!(again.simulation().steps(), session.simulation().steps());
    press(&mut screen, &mut session, "<");
    assert!(session.simulation().is_active("Down"));
}

#[test]
fn cycles_by_hand() {
    let by_hand = |screen: &mut Screen, session: &mut Session<'_>, steps: &str| {
        let control = KeyEvent::new(KeyCode::Char('f'), KeyModifiers::CONTROL);
        assert_eq!(screen.press(control, session), Next::Go);
        assert_eq!(screen.forcing.as_deref(), Some(""));
        press(screen, session, steps);
        press(screen, session, "\n");
    };
    let chart = chart(PRESS);
    let mut session = Session::new(&chart, 100).expect("understood");
    let mut screen = Screen::of(&session);
    press(&mut screen, &mut session, "\n");
    for (steps, why) in [
        ("Up, Light", "`Up` and `Light` are never active together"),
        ("Down", "the chart has no situation of exactly these steps"),
        ("Dawn", "there is no step `Dawn`"),
    ] {
        by_hand(&mut screen, &mut session, steps);
        assert_eq!(screen.message.as_deref(), Some(&*format!("no cycle by hand: {why}")));
        assert_eq!(session.script().len(), 1);
    }
    by_hand(&mut screen, &mut session, "Down,Light");
    assert_eq!(screen.message, None);
    assert_eq!(
        (session.simulation().output("down"), session.simulation().variable("n")),
        (Some(true.into()), Some(Value::Int(1)))
    );
    let text = terminal::text(&session);
    assert_eq!(text, "-\n@100 force{Down,Light} -\n");
    let mut again = Session::new(&chart, 1).expect("understood");
    for cycle in script::read(again.signals(), &chart.names().params, &text).expect("a script") {
        again.play(&cycle).expect("as it was");
    }
    assert!(again.simulation().is_active("Light"));
    press(&mut screen, &mut session, "<");
    assert!(session.simulation().is_active("Up"));
    // A chart that does not let itself be put anywhere says so.
    let chart = super::tests::chart(LIFT);
    let mut session = Session::new(&chart, 100).expect("understood");
    let mut screen = Screen::of(&session);
    by_hand(&mut screen, &mut session, "Run");
    let said = "no cycle by hand: the chart takes no cycle by hand: it does not say `forceable;`";
    assert_eq!((screen.message.as_deref(), session.script().len()), (Some(said), 0));
}
