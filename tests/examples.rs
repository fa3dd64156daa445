//! The examples: their scripts against lines worked out by hand, and their command lines.

// Each example brings along what they share; here they stand side by side.
#![allow(clippy::duplicate_mod)]

use std::ffi::OsString;
use std::io;
use std::path::Path;

#[path = "../examples/branch_on_result.rs"]
#[allow(dead_code, reason = "`main` is for the process")]
pub mod branch_on_result_example;
#[path = "../examples/cell.rs"]
#[allow(dead_code, reason = "`main` is for the process")]
pub mod cell_example;
#[path = "../examples/controller.rs"]
#[allow(dead_code, reason = "`main` is for the process")]
pub mod controller_example;
#[path = "../examples/line24v.rs"]
#[allow(dead_code, reason = "`main` is for the process")]
pub mod line24v_example;
#[path = "../examples/motor.rs"]
#[allow(dead_code, reason = "`main` is for the process")]
pub mod motor_example;
#[path = "../examples/pick_and_place.rs"]
#[allow(dead_code, reason = "`main` is for the process")]
pub mod pick_and_place_example;
#[path = "../examples/recipe.rs"]
#[allow(dead_code, reason = "`main` is for the process")]
pub mod recipe_example;
#[path = "../examples/stroke.rs"]
#[allow(dead_code, reason = "`main` is for the process")]
pub mod stroke_example;
#[path = "../examples/tickless.rs"]
#[allow(dead_code, reason = "`main` is for the process")]
pub mod tickless_example;

/// What an example prints with these arguments.
macro_rules! run {
    ($example:ident, $($argument:expr),*) => {{
        let mut out = Vec::new();
        let arguments: Vec<OsString> = vec![$(OsString::from($argument)),*];
        let result = $example::EXAMPLE.run(arguments, &mut anstream::StripStream::new(&mut out));
        (String::from_utf8(out).expect("the examples print text"), result.map_err(|failure| format!("{failure:?}")))
    }};
}

/// A file of the project.
fn file(path: &str) -> OsString {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path).into()
}

#[test]
fn the_motor_answers_its_script_as_worked_out_by_hand() {
    let (printed, result) = run!(motor_example, "--script", file("examples/charts/motor.script"));
    assert_eq!(result, Ok(()));
    assert_eq!(printed, include_str!("examples/motor.expected"));
}

#[test]
fn the_line_answers_its_script_as_worked_out_by_hand() {
    let (printed, result) = run!(line24v_example, "--script", file("examples/charts/line24v.script"));
    assert_eq!(result, Ok(()));
    assert_eq!(printed, include_str!("examples/line24v.expected"));
}

#[test]
fn the_dyeing_machine_answers_its_script_as_worked_out_by_hand() {
    let (printed, result) = run!(recipe_example, "--script", file("examples/charts/recipe.script"));
    assert_eq!(result, Ok(()));
    assert_eq!(printed, include_str!("examples/recipe.expected"));
}

#[test]
fn the_sorter_answers_its_script_as_worked_out_by_hand() {
    let (printed, result) = run!(branch_on_result_example, "--script", file("examples/charts/branch_on_result.script"));
    assert_eq!(result, Ok(()));
    assert_eq!(printed, include_str!("examples/branch_on_result.expected"));
}

#[test]
fn the_press_answers_its_script_as_worked_out_by_hand() {
    let (printed, result) = run!(stroke_example, "--script", file("examples/charts/stroke.script"));
    assert_eq!(result, Ok(()));
    assert_eq!(printed, include_str!("examples/stroke.expected"));
}

#[test]
fn the_arm_answers_its_script_as_worked_out_by_hand() {
    let (printed, result) = run!(pick_and_place_example, "--script", file("examples/charts/pick_and_place.script"));
    assert_eq!(result, Ok(()));
    assert_eq!(printed, include_str!("examples/pick_and_place.expected"));
}

#[test]
fn the_cell_answers_its_script_as_worked_out_by_hand() {
    let (printed, result) = run!(cell_example, "--script", file("examples/charts/cell.script"));
    assert_eq!(result, Ok(()));
    assert_eq!(printed, include_str!("examples/cell.expected"));
}

#[test]
fn the_crossing_answers_its_script_as_worked_out_by_hand() {
    let (printed, result) = run!(tickless_example, "--script", file("examples/charts/tickless.script"));
    assert_eq!(result, Ok(()));
    assert_eq!(printed, include_str!("examples/tickless.expected"));
}

#[test]
fn both_ovens_answer_their_script_as_worked_out_by_hand() {
    let (printed, result) = run!(controller_example, "--script", file("examples/charts/controller.script"));
    assert_eq!(result, Ok(()));
    assert_eq!(printed, include_str!("examples/controller.expected"));
}

/// The steps and those of `words` that a shown run prints, without the cycles that repeat the one before.
fn story(timeline: &str, words: &[&str]) -> Vec<String> {
    let lines: Vec<&str> = timeline.lines().collect();
    let heading = lines.iter().position(|line| line.starts_with("     step")).expect("the columns have titles");
    let marks = marks(&lines[..heading]);
    let cycles = lines[heading + 1..].iter().filter(|line| !line.is_empty() && !line.starts_with(BELOW));
    let mut story: Vec<String> = cycles
        .map(|line| {
            let mut cells = line.split_whitespace().skip(1);
            let steps = cells.next().expect("some step is active");
            let marked = marks.iter().filter_map(|(name, column)| {
                let shown: String = line.chars().skip(*column).take_while(|char| *char != ' ').collect();
                match shown.as_str() {
                    "·" => None,
                    "●" => Some((*name).to_owned()),
                    number => Some(format!("{name}={number}")),
                }
            });
            let rest = marked.chain(cells.map(String::from)).filter(|word| words.contains(&word.as_str()));
            rest.fold(steps.to_owned(), |line, word| line + " " + &word)
        })
        .collect();
    story.dedup();
    story
}

/// What a remark begins with that stands below its cycle.
const BELOW: &str = "     └ ";

/// The signals whose names stand above the titles of the columns, each in a line of its own, and their columns.
fn marks<'t>(above: &[&'t str]) -> Vec<(&'t str, usize)> {
    let names = above.iter().rev().take_while(|line| !line.is_empty());
    let mut marks: Vec<(&str, usize)> = names
        .map(|line| {
            let name = line.split_whitespace().last().expect("a name");
            (name, line.chars().count() - name.chars().count())
        })
        .collect();
    marks.reverse();
    marks
}

/// All examples with what they print for each form of their command line.
fn everything() -> Vec<(&'static str, &'static str, String)> {
    let mut all = Vec::new();
    macro_rules! every {
        ($($name:literal: $example:ident),+) => {$(
            let script = file(concat!("examples/charts/", $name, ".script"));
            for (form, (printed, result)) in [
                ("", run!($example,)),
                ("--chart", run!($example, "--chart")),
                ("--help", run!($example, "--help")),
                ("--script", run!($example, "--script", &script)),
            ] {
                assert_eq!(result, Ok(()), "{} {form}", $name);
                all.push(($name, form, printed));
            }
        )+};
    }
    every!(
        "branch_on_result": branch_on_result_example, "cell": cell_example, "controller": controller_example,
        "line24v": line24v_example, "motor": motor_example, "pick_and_place": pick_and_place_example, "stroke": stroke_example, "recipe": recipe_example, "tickless": tickless_example
    );
    all
}

/// A terminal has 80 columns.
#[test]
fn no_line_of_an_example_is_wider_than_a_terminal() {
    let mut wide = Vec::new();
    for (example, form, printed) in everything() {
        assert!(!printed.is_empty(), "{example} {form}");
        let lines = printed.lines().filter(|line| line.chars().count() > 80);
        wide.extend(lines.map(|line| format!("{example} {form}: {line}")));
    }
    assert!(wide.is_empty(), "{}", wide.join("\n"));
}

#[test]
fn an_example_shows_its_chart_before_it_runs() {
    let all = everything();
    for (example, _, chart) in all.iter().filter(|(_, form, _)| *form == "--chart") {
        assert!(chart.contains('╔') && chart.contains('╝'), "{example} has an initial step:\n{chart}");
        assert!(!chart.contains("A line is a cycle."), "{example}");
        let (.., run) = all.iter().find(|(other, form, _)| other == example && form.is_empty()).expect("it runs");
        assert!(run.starts_with(chart) && run.contains("A line is a cycle."), "{example}:\n{run}");
    }
    let (printed, _) = run!(controller_example, "--chart");
    assert!(printed.starts_with("Called\n") && printed.contains("\nRemote\n"), "{printed}");
}

#[test]
fn the_motor_on_its_plant_runs_trips_and_runs_again() {
    let (printed, result) = run!(motor_example,);
    assert_eq!(result, Ok(()));
    assert_eq!(
        story(&printed, &["over_temp", "relay", "green", "red"]),
        [
            "Off red",
            "On relay green",
            "Off red",
            "On relay green",
            "Off over_temp red",
            "Off red",
            "On relay green",
            "Off red",
        ]
    );
}

#[test]
fn the_line_on_its_conveyor_sprays_exactly_while_b5() {
    let (printed, result) = run!(line24v_example,);
    assert_eq!(result, Ok(()));
    let piece = ["S1 q1", "S2 q2", "S3 q2", "S3 b5 q2 q3", "S3 q2", "S4"];
    let mut expected = [piece, piece].concat();
    expected.push("S1 q1");
    assert_eq!(story(&printed, &["b5", "q1", "q2", "q3"]), expected);
}

#[test]
fn the_second_batch_goes_on_with_the_other_recipe() {
    let (printed, result) = run!(recipe_example,);
    assert_eq!(result, Ok(()));
    let words = ["inlet", "outlet", "ready"];
    let speeds = ["0/min", "20/min", "25/min", "45/min", "55/min"];
    let begin = ["Idle ready 0/min", "Fill inlet 0/min", "Wash 45/min"];
    let cotton = ["Dye 55/min", "Drain outlet 45/min"];
    let wool = ["Wash 20/min", "Dye 25/min", "Drain outlet 20/min", "Idle ready 0/min"];
    let expected = [&begin[..], &cotton, &begin, &wool].concat();
    assert_eq!(story(&printed, &[&words[..], &speeds].concat()), expected);
}

/// The pieces are 50.1, 50.3, 48.9, 49.8 and 50.4 mm long. The gauge shows 0.1 mm more for the first and the fourth while
/// they are measured, and for the second one cycle later, which would be too long.
#[test]
fn the_sorter_branches_on_what_it_has_measured() {
    let (printed, result) = run!(branch_on_result_example,);
    assert_eq!(result, Ok(()));
    let keep = ["Feed feed", "Measure", "Keep keep"];
    let reject = ["Feed feed", "Measure", "Reject reject"];
    let expected = [&keep[..], &keep, &reject, &keep, &reject, &["Feed feed"]].concat();
    let words = ["feed", "keep", "reject"];
    assert_eq!(story(&printed, &words), expected);
}

/// The emergency stop comes while the second part is drilled; that part is finished afterwards, as the switch is back on
/// manual already.
#[test]
fn the_cell_stops_holds_its_part_and_finishes_it_later() {
    let (printed, result) = run!(cell_example,);
    assert_eq!(result, Ok(()));
    let words = ["conveyor", "clamp", "drill", "stamp", "alarm", "parts=1", "parts=2"];
    let feed_and_work = |parts| {
        let steps = ["Ready+Auto+Feed conveyor", "Ready+Auto+Close clamp", "Ready+Auto+Drill+Stamp clamp drill stamp"];
        steps.map(|line| format!("{line}{parts}"))
    };
    let mut expected = vec!["Ready+Manual".to_owned()];
    expected.extend(feed_and_work(""));
    expected.extend(
        ["Ready+Auto+Drill+Stamped clamp drill", "Ready+Auto+Release parts=1", "Ready+Auto+Deliver conveyor parts=1"]
            .map(String::from),
    );
    expected.extend(feed_and_work(" parts=1"));
    expected.extend(
        [
            "Stopped clamp alarm parts=1",
            "Ready+Manual parts=1",
            "Ready+Auto+Close clamp parts=1",
            "Ready+Auto+Drill+Stamped clamp drill parts=1",
            "Ready+Auto+Release parts=2",
            "Ready+Auto+Deliver conveyor parts=2",
            "Ready+Manual parts=2",
        ]
        .map(String::from),
    );
    assert_eq!(story(&printed, &words), expected);
}

/// The ram takes a cycle for each of its five steps. Paused for two cycles it stands still; held for two, which are a second, it goes up again. The stroke by hand
/// turns round half way.
#[test]
fn the_press_makes_a_stroke_in_each_mode() {
    let (printed, result) = run!(stroke_example,);
    assert_eq!(result, Ok(()));
    let words = ["lower", "lift", "lamp"];
    let (down, up) = (["Lower lower", "Lower", "Lower lower"], ["Hold", "Lift lift"]);
    let whole = [&["Rest lamp"][..], &down, &up, &["Rest lamp"]].concat();
    let by_hand = ["Lower lower", "Hold", "Lift lift", "Rest lamp"];
    assert_eq!(story(&printed, &words), [&whole[..], &by_hand].concat());
}

/// A part is placed; the lift is jammed, and nothing is gripped: two alarms; the lift is jammed half way, and the part is placed all the same.
#[test]
fn the_arm_answers_each_question_of_its_line() {
    let (printed, result) = run!(pick_and_place_example,);
    assert_eq!(result, Ok(()));
    let fetch = ["Ready", "Feed belt", "Dip dip"];
    let lift = ["Grip dip grip", "Lift grip", "Carry push grip", "Place dip push grip"];
    let place = ["Drop dip push", "Rise push", "Done done"];
    let expected = [
        &[&fetch[..], &lift, &place].concat()[..],
        &[&fetch[..], &["Lost alarm"]].concat(),
        &[&fetch[..], &["Grip dip grip", "Lost alarm"]].concat(),
        &[&fetch[..], &lift, &["Jam push grip alarm", "Carry push grip", "Place dip push grip"], &place, &["Ready"]]
            .concat(),
    ]
    .concat();
    assert_eq!(story(&printed, &["belt", "dip", "push", "grip", "done", "alarm"]), expected);
}

/// A round that begins with a button that is pressed and let go has 15 scans: six steps entered, each scanned once more,
/// the button let go, and the ends of the limit and the delay in Walk. There are two rounds; in the first one somebody
/// presses again where nothing asks for that edge, and lets go; and two scans at power-up.
#[test]
fn the_crossing_saves_all_scans_but_those_in_which_something_can_change() {
    let (printed, result) = run!(tickless_example,);
    assert_eq!(result, Ok(()));
    let scans = 2 + 15 + 2 + 15;
    assert!(printed.contains(&format!("\n{scans} scans instead of 120001: {} saved.\n", 120_001 - scans)), "{printed}");
    assert!(printed.ends_with(" in 0 ms.\n"), "{printed}");
}

/// How long the second oven takes is up to the threads. The last line shows how often its controller has computed: from
/// 20 °C to 98 °C, by 5 °C at most each time, at least 16 times.
#[test]
fn both_ovens_heat_up_hold_and_switch_off() {
    let (printed, result) = run!(controller_example,);
    assert_eq!(result, Ok(()));
    let (called, remote) = printed
        .split_once("\nRemote  ")
        .filter(|(called, _)| called.contains("\nCalled  "))
        .expect("one timeline for each");
    for timeline in [called, remote] {
        assert_eq!(story(timeline, &["ready", "hot"]), ["Off ready", "HeatUp", "Hold hot", "Off ready"]);
    }
    assert!(!remote.contains("a message is lost"), "{remote}");
    let last: Vec<&str> = remote.lines().last().expect("a timeline has lines").split_whitespace().collect();
    let [.., power, "%", computed] = last[..] else { panic!("{remote}") };
    assert_eq!(power, "0");
    assert!(computed.parse::<u32>().is_ok_and(|computed| computed >= 16), "{remote}");
}

#[test]
fn a_mistake_in_a_script_is_shown_at_its_line_after_the_cycles_before() {
    let script = std::env::temp_dir().join(format!("grafcet-examples-{}.script", std::process::id()));
    for (mistake, error) in [
        ("starting", "line 3: there is no input `starting`; the inputs are start, full, empty, temperature, wool"),
        ("start=1", "line 3: `start=1` is not of the type that is wanted there"),
        ("temperature", "line 3: `temperature` is not of the type that is wanted there"),
        ("temperature=40000", "line 3: `temperature=40000` is not of the type that is wanted there"),
        ("temperature=x", "line 3: `temperature=x` is not of the type that is wanted there"),
        ("@-1", "line 3: `@-1` is not of the type that is wanted there"),
    ] {
        std::fs::write(&script, format!("# at power-up\nfull\nfull {mistake}\n")).expect("it can be written");
        let (printed, result) = run!(recipe_example, "--script", &script);
        assert_eq!(printed, "0 Idle | full | ready\n");
        let message = result.expect_err(mistake);
        assert!(message.contains(error), "{message}");
    }
    std::fs::remove_file(&script).expect("it was written above");
}

#[test]
fn a_bad_command_line_is_an_error_that_shows_the_right_one() {
    for (arguments, error) in [
        (&["--scirpt", "x"][..], "unexpected argument `--scirpt`"),
        (&["--script"], "`--script` needs a file after it"),
        (&["--script", "x", "y"], "unexpected argument `y`"),
        (&["--help", "y"], "unexpected argument `y`"),
        (&["--chart", "y"], "unexpected argument `y`"),
    ] {
        let arguments = arguments.iter().map(OsString::from).collect();
        let failure = motor_example::EXAMPLE.run(arguments, &mut Vec::new()).expect_err(error);
        let motor_example::shared::Failure::Usage(message) = failure else { panic!("{failure:?}") };
        assert!(message.starts_with(error), "{message}");
        assert!(message.contains("Usage: cargo run --example motor"), "{message}");
        assert!(message.lines().all(|line| line.chars().count() <= 80), "{message}");
    }
    let (printed, result) = run!(line24v_example, "--help");
    assert_eq!(result, Ok(()));
    assert!(printed.contains("Usage: cargo run --example line24v"), "{printed}");
}

#[test]
fn the_exit_status_tells_what_went_wrong() {
    use motor_example::shared::Failure;
    assert_eq!(Failure::Usage("no such file".to_owned()).verdict(), (2, Some("no such file".to_owned())));
    // The reader has seen enough, as `head` has.
    assert_eq!(Failure::Output(io::ErrorKind::BrokenPipe.into()).verdict(), (0, None));
    assert_eq!(Failure::Output(io::ErrorKind::StorageFull.into()).verdict().0, 1);
}

/// A pipe whose reader goes away when it has seen a text.
struct ClosedAt(&'static str);

impl io::Write for ClosedAt {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if String::from_utf8_lossy(bytes).contains(self.0) {
            return Err(io::ErrorKind::BrokenPipe.into());
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn nothing_panics_where_nobody_reads() {
    let script = file("examples/charts/motor.script");
    for arguments in [vec![], vec!["--chart".into()], vec!["--help".into()], vec!["--script".into(), script]] {
        let failure = motor_example::EXAMPLE.run(arguments, &mut ClosedAt("")).expect_err("nothing can be written");
        assert_eq!(failure.verdict(), (0, None));
    }
}

#[test]
fn the_thread_of_the_controller_ends_where_nobody_reads() {
    let failure = controller_example::EXAMPLE.run(vec![], &mut ClosedAt("Remote")).expect_err("nobody reads the rest");
    assert_eq!(failure.verdict(), (0, None));
}
