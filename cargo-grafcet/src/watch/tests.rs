//! What is shown of bytes that came whole, in pieces, damaged, and not at all.

#[path = "../../tests/common/motor.rs"]
pub(super) mod motor;

use grafcet_sim::{Chart, calls};
use serde_json::{Value as Json, json};

use super::follow::Follower;
use super::kept::{FEW, Kept, MOST_BYTES, Moment, Seen};

use motor::{OTHER, SOURCE, frames};

fn chart(file: &str) -> Chart {
    let (_, tokens) = calls(&file.parse().expect("Rust")).remove(0);
    Chart::of_tokens(tokens).expect("a chart")
}

fn kept(most: usize) -> Kept {
    Kept::new("test".to_owned(), most, None)
}

/// What a viewer gets that looks only now.
fn all(kept: &Kept) -> Vec<Json> {
    let (mut seen, mut moments) = (Seen::default(), Vec::new());
    while let Some((text, more)) = kept.news(0, &mut seen) {
        let news: Json = serde_json::from_str(&text).expect("JSON");
        moments.extend(news["moments"].as_array().expect("moments").clone());
        if !more {
            break;
        }
    }
    moments
}

fn follow(pieces: &[&[u8]], source: &str) -> Kept {
    let (charts, kept) = ([chart(source)], kept(10_000));
    let mut follower = Follower::new(&charts);
    for piece in pieces {
        follower.bytes(piece, &kept);
    }
    kept
}

/// The number of a moment, its steps and the relay.
fn seen(moment: &Json) -> (u64, u64, bool) {
    let number = moment["number"].as_u64().expect("a number");
    // Of a state that came alone nobody knows the outputs that no state holds.
    let relay = moment["outputs"][0].as_bool().unwrap_or_else(|| {
        assert_eq!(moment["outputs"][0], "?");
        moment["steps"][0] == 1
    });
    (number, moment["steps"][0].as_u64().expect("a step"), relay)
}

#[test]
fn each_cycle_is_a_moment() {
    let kept = follow(&[&frames(4, 100)], SOURCE);
    let moments = all(&kept);
    // In the first cycle of an `sfc` nothing clears: it makes the initial situation.
    let shown: Vec<_> = moments.iter().map(seen).collect();
    assert_eq!(shown, [(1, 0, false), (2, 0, false), (3, 1, true), (4, 0, false)]);
    assert_eq!(moments[2]["time"], "20 ms");
    assert_eq!(moments[2]["said"][0], "`On → Off` waits for `off` (false) or 10 s of `10s/On` still to go");
    assert!(moments.iter().all(|moment| moment["gap"].is_null()));
    let line = kept.line_now();
    assert_eq!((line.damaged, line.lost, line.unknown), (0, 0, None));
}

#[test]
fn pieces_show_the_same_wherever_they_are_cut() {
    let bytes = frames(12, 4);
    let whole = all(&follow(&[&bytes], SOURCE));
    assert_eq!(whole.len(), 12);
    for cut in 0..=bytes.len() {
        let (a, b) = bytes.split_at(cut);
        assert_eq!(all(&follow(&[a, b], SOURCE)), whole, "cut at {cut}");
    }
}

#[test]
fn who_comes_late_sees_what_is_true_or_nothing() {
    let bytes = frames(12, 4);
    let truth: Vec<_> = all(&follow(&[&bytes], SOURCE)).iter().map(seen).collect();
    for cut in 1..bytes.len() {
        let kept = follow(&[&bytes[cut..]], SOURCE);
        let shown: Vec<_> = all(&kept).iter().map(seen).collect();
        for one in &shown {
            assert!(truth.contains(one), "cut at {cut}: {one:?}");
        }
        // Where nothing is shown, it is said.
        assert!(!shown.is_empty() || kept.line_now().unknown.is_some(), "cut at {cut}");
    }
}

#[test]
fn a_wrong_byte_is_a_gap_and_nothing_untrue() {
    let bytes = frames(16, 4);
    let truth: Vec<_> = all(&follow(&[&bytes], SOURCE)).iter().map(seen).collect();
    for place in 0..bytes.len() {
        for flip in [0x01, bytes[place].max(2)] {
            let mut wrong = bytes.clone();
            wrong[place] ^= flip;
            let kept = follow(&[&wrong], SOURCE);
            let (moments, line) = (all(&kept), kept.line_now());
            let shown: Vec<_> = moments.iter().map(seen).collect();
            for one in &shown {
                assert!(truth.contains(one), "byte {place}: {one:?}");
            }
            // The states after it bring it back, unless it was at the end.
            let is_back = line.unknown.is_none() && shown.last() == truth.last();
            assert!(is_back || place + 120 > bytes.len(), "byte {place}: {:?}", line.unknown);
            // A byte between frames is not missed; without the last zero, the last frame is still to come.
            let says = line.damaged > 0 || line.lost > 0 || shown == truth || place + 1 == bytes.len();
            assert!(says, "byte {place}");
            let is_short = is_back && shown.len() < truth.len() && shown.first() == truth.first();
            assert!(!is_short || moments.iter().any(|moment| !moment["gap"].is_null()), "byte {place}");
        }
    }
}

#[test]
fn garbage_is_counted_and_forgotten() {
    let (charts, kept) = ([chart(SOURCE)], kept(100));
    let mut follower = Follower::new(&charts);
    // A generator of Lehmer: bytes without order, zeros among them.
    let mut state = 1_u64;
    let noise: Vec<u8> = std::iter::repeat_with(|| {
        state = state * 48_271 % 0x7fff_ffff;
        state.to_le_bytes()[1]
    })
    .take(1 << 20)
    .collect();
    follower.bytes(&noise, &kept);
    let line = kept.line_now();
    assert_eq!((kept.size(), line.frames, line.bytes), ((0, 0), 0, 1 << 20));
    // About one byte in 256 is a zero, and ends something.
    assert!((3_500..4_700).contains(&line.damaged), "{}", line.damaged);
    assert_eq!(line.unknown.as_deref(), Some("no state has come yet"));
    follower.bytes(&[0], &kept);
    follower.bytes(&frames(3, 100), &kept);
    let line = kept.line_now();
    assert_eq!((line.unknown, kept.size().0), (None, 3));
    follower.bytes(&noise, &kept);
    assert!(kept.line_now().unknown.expect("a reason").contains("a frame was damaged"));
}

#[test]
fn another_version_of_the_chart_is_said_and_not_shown() {
    let kept = follow(&[&frames(12, 4)], OTHER);
    assert_eq!(all(&kept), [] as [Json; 0]);
    let unknown = kept.line_now().unknown.expect("a reason");
    let (runs, here) = (chart(SOURCE).fingerprint().expect("one"), chart(OTHER).fingerprint().expect("one"));
    let expected = format!("its fingerprint is {runs:08x}, and here are `Motor` ({here:08x})");
    assert!(unknown.contains(&expected), "{unknown}");
}

#[test]
fn of_several_charts_the_fingerprint_tells_which() {
    let (charts, kept) = ([chart(OTHER), chart(SOURCE)], kept(100));
    Follower::new(&charts).bytes(&frames(3, 100), &kept);
    assert_eq!((kept.size().0, kept.line_now().unknown), (3, None));
}

#[test]
fn a_controller_that_starts_anew_shows_a_gap() {
    let (first, second) = (frames(5, 100), frames(2, 100));
    let moments = all(&follow(&[&first, &second], SOURCE));
    let gaps: Vec<&Json> = moments.iter().map(|moment| &moment["gap"]["reason"]).collect();
    assert_eq!(moments.len(), 7, "no cycle was made up: {moments:#?}");
    assert_eq!(gaps[5], "the chart began anew here");
    assert!(gaps.iter().enumerate().all(|(index, gap)| index == 5 || gap.is_null()));
    // Its clock begins anew; on the page a tenth of a second lies between.
    assert_eq!([&moments[4]["elapsed"], &moments[5]["elapsed"], &moments[6]["elapsed"]], [40, 140, 150]);
}

#[test]
fn after_init_the_time_goes_on() {
    let mut motor = motor::motor(100);
    let inputs = motor::MotorInputs { on: true, off: false };
    for now in [0, 10, 20] {
        motor.cycle(&inputs, 5_000 + now, &mut ());
    }
    motor.change(motor::Motor::init);
    for now in [30, 40] {
        motor.cycle(&inputs, 5_000 + now, &mut ());
    }
    let moments = all(&follow(&[motor.keep().writer()], SOURCE));
    let elapsed: Vec<u64> = moments.iter().filter_map(|moment| moment["elapsed"].as_u64()).collect();
    // The state after *Init* is a moment of its own.
    assert_eq!(elapsed, [0, 10, 20, 20, 30, 40]);
    assert_eq!(moments[3]["gap"]["reason"], "the chart began anew here");
}

#[test]
fn a_chart_that_rests_is_shown_by_its_state() {
    let mut motor = motor::motor(100);
    motor.cycle(&motor::MotorInputs { on: true, off: false }, 0, &mut ());
    let before = motor.keep().writer().len();
    motor.cycle(&motor::MotorInputs { on: true, off: false }, 2_000, &mut ());
    motor.tell_state();
    let line = motor.keep().writer();
    let kept = follow(&[&line[before..]], SOURCE);
    let moments = all(&kept);
    assert_eq!(moments.iter().map(seen).collect::<Vec<_>>(), [(2, 1, true)]);
    assert_eq!((&moments[0]["values"], &moments[0]["outputs"]), (&json!([true, false]), &json!(["?"])));
    assert_eq!(moments[0]["said"][0], "`On → Off` waits for `off` (false) or 10 s of `10s/On` still to go");
    // It is told again half a second later, and of the cycles in between all is known.
    motor.cycle(&motor::MotorInputs { on: true, off: false }, 2_500, &mut ());
    motor.tell_state();
    let kept = follow(&[&motor.keep().writer()[before..]], SOURCE);
    let last = all(&kept).pop().expect("a moment");
    assert_eq!((seen(&last), &last["outputs"]), ((3, 1, true), &json!([true])));
    assert_eq!(last["said"][0], "`On → Off` waits for `off` (false) or 9.5 s of `10s/On` still to go");
}

fn moment(text: &str, is_new: bool) -> Moment {
    Moment { text: text.into(), is_new }
}

#[test]
fn no_more_is_kept_than_was_said() {
    let few = kept(3);
    few.add((0..10).map(|number| moment(&number.to_string(), true)).collect());
    assert_eq!(few.size(), (3, 3));
    assert_eq!(all(&few), [7, 8, 9]);
    let large = kept(usize::MAX);
    let text = format!("\"{}\"", "x".repeat(1 << 20));
    for _ in 0..40 {
        large.add(vec![moment(&text, true)]);
    }
    let (count, bytes) = large.size();
    assert!(bytes <= MOST_BYTES && count == 31, "{count} moments, {bytes} bytes");
}

#[test]
fn a_time_that_goes_on_takes_the_place_of_another() {
    let kept = kept(100);
    let mut seen = Seen::default();
    kept.add(vec![moment("1", true), moment("2", false)]);
    let mut news = || {
        kept.news(0, &mut seen).map(|(text, _)| serde_json::from_str::<Json>(&text).expect("JSON")["moments"].clone())
    };
    assert_eq!(news(), Some(json!([1, 2])));
    kept.add(vec![moment("3", false), moment("4", false)]);
    assert_eq!((kept.size().0, news()), (2, Some(json!([4]))));
    kept.add(vec![moment("5", true)]);
    assert_eq!((kept.size().0, news(), news()), (3, Some(json!([5])), None));
}

#[test]
fn who_is_slow_gets_the_last_and_hears_what_is_missing() {
    let (kept, mut seen) = (kept(1000), Seen::default());
    let get = |seen: &mut Seen| {
        kept.news(0, seen).map(|(text, more)| (serde_json::from_str::<Json>(&text).expect("JSON"), more))
    };
    kept.add((0..700).map(|number| moment(&number.to_string(), true)).collect());
    // What was before it came, it gets whole, in parts.
    let (news, more) = get(&mut seen).expect("news");
    assert_eq!((news["moments"][0].as_u64(), news["moments"][499].as_u64(), more), (Some(0), Some(499), true));
    let (news, more) = get(&mut seen).expect("news");
    assert_eq!((news["moments"][0].as_u64(), news["moments"][199].as_u64(), more), (Some(500), Some(699), false));
    assert_eq!(news["missed"], 0);
    // Of what happens then, the last.
    kept.add((700..900).map(|number| moment(&number.to_string(), true)).collect());
    let (news, more) = get(&mut seen).expect("news");
    assert_eq!(news["moments"].as_array().map(Vec::len), Some(FEW));
    assert_eq!((news["moments"][0].as_u64(), news["missed"].as_u64(), more), (Some(850), Some(150), false));
    // And where even that is forgotten, too.
    kept.add((900..3000).map(|number| moment(&number.to_string(), true)).collect());
    let (news, _) = get(&mut seen).expect("news");
    assert_eq!((news["moments"][0].as_u64(), news["missed"].as_u64()), (Some(2950), Some(2050)));
}
