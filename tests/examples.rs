//! The examples: their scripts against lines worked out by hand, and their command lines.

// Both examples bring along what they share; here they stand side by side.
#![allow(clippy::duplicate_mod)]

use std::ffi::OsString;
use std::io;
use std::path::Path;

#[path = "../examples/line24v.rs"]
#[allow(dead_code, reason = "`main` is for the process")]
pub mod line24v_example;
#[path = "../examples/motor.rs"]
#[allow(dead_code, reason = "`main` is for the process")]
pub mod motor_example;

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

/// The steps and outputs of a shown run, without the cycles that repeat the one before.
fn story(timeline: &str, words: &[&str]) -> Vec<String> {
    let lines = timeline.lines().skip_while(|line| !line.starts_with("cycle")).skip(1);
    let mut story: Vec<String> = lines
        .map(|line| line.split_whitespace().filter(|word| words.contains(word)).collect::<Vec<_>>().join(" "))
        .collect();
    story.dedup();
    story
}

#[test]
fn the_motor_on_its_plant_runs_trips_and_runs_again() {
    let (printed, result) = run!(motor_example,);
    assert_eq!(result, Ok(()));
    assert_eq!(
        story(&printed, &["Off", "On", "over_temp", "relay", "green", "red"]),
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
    assert_eq!(story(&printed, &["S1", "S2", "S3", "S4", "b5", "q1", "q2", "q3"]), expected);
}

#[test]
fn an_unknown_input_is_shown_at_its_line_behind_the_cycles_before() {
    let script = std::env::temp_dir().join(format!("grafcet-examples-{}.script", std::process::id()));
    std::fs::write(&script, "# start\non\noff overtemp\n").expect("the temporary directory can be written");
    let (printed, result) = run!(motor_example, "--script", &script);
    std::fs::remove_file(&script).expect("it was written above");
    assert_eq!(printed, "0 Off | on | red\n");
    let message = result.expect_err("there is no such input");
    assert!(message.contains("line 3: there is no input `overtemp`; the inputs are on, off, over_temp"), "{message}");
}

#[test]
fn a_bad_command_line_is_an_error_that_shows_the_right_one() {
    for (arguments, error) in [
        (&["--scirpt", "x"][..], "unexpected argument `--scirpt`"),
        (&["--script"], "`--script` needs a file behind it"),
        (&["--script", "x", "y"], "unexpected argument `y`"),
        (&["--help", "y"], "unexpected argument `y`"),
    ] {
        let arguments = arguments.iter().map(OsString::from).collect();
        let failure = motor_example::EXAMPLE.run(arguments, &mut Vec::new()).expect_err(error);
        let motor_example::shared::Failure::Usage(message) = failure else { panic!("{failure:?}") };
        assert!(message.starts_with(error), "{message}");
        assert!(message.contains("Usage: cargo run --example motor"), "{message}");
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

/// A closed pipe.
struct Closed;

impl io::Write for Closed {
    fn write(&mut self, _: &[u8]) -> io::Result<usize> {
        Err(io::ErrorKind::BrokenPipe.into())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn nothing_panics_where_nobody_reads() {
    for arguments in [vec![], vec!["--help".into()], vec!["--script".into(), file("examples/charts/motor.script")]] {
        let failure = motor_example::EXAMPLE.run(arguments, &mut Closed).expect_err("nothing can be written");
        assert_eq!(failure.verdict(), (0, None));
    }
}
