//! Commands over a line: those that are whole, new and for this chart get to the program, and nothing else does, whatever comes.

use grafcet::record::steer::{Answer, Command, Commands, Mode, Refused, Request, Wanted, command_len, request_len};
use grafcet::record::wire::{Decoder, Frame, Wire, frame_len, wire_len};
use grafcet::record::{Recordable, Recorder};
use grafcet::{Chart, grafcet};
use grafcet_record::motor::Motor;
use grafcet_record::{Chance, wrong};

grafcet! {
    /// Two branches, so that a situation can be one that never is; nine steps, so that a situation takes two bytes.
    pub sfc Press {
        forceable;
        modes;
        input start, up, hot, cold: bool;
        output ram, heater: bool;
        initial step Rest;
        step Shut;
        step Down { N ram; }
        step Held { N ram; }
        step Warm { N heater; }
        step Soak { N heater; }
        step Cool;
        step Open;
        step Done;
        Rest -[start]-> Shut -[true]-> (Down, Warm);
        Down -[up]-> Held;
        Warm -[hot]-> Soak -[2s/Soak]-> Cool;
        (Held, Cool) -[cold]-> Open -[up]-> Done -[true]-> Rest;
    }
}

/// So many cycles there were, and so many old a command may be.
const CYCLES: u32 = 1_000;
const OLDEST: u32 = 300;

type Reading = Commands<Press, [u8; command_len::<Press>()], [PressStep; 9]>;

fn reading() -> Reading {
    Commands::new([0xaa; command_len::<Press>()], [Press::STEPS[0]; Press::STEPS.len()], OLDEST)
}

fn request(number: u64, wanted: Wanted<'_, usize>) -> Request<'_> {
    Request { number, fingerprint: Press::FINGERPRINT, steps: Press::STEPS.len(), seen: CYCLES, wanted }
}

fn frame(request: &Request<'_>) -> Vec<u8> {
    let mut buffer = [0x55; request_len(Press::STEPS.len())];
    request.write(&mut buffer).expect("as many bytes as it takes").to_vec()
}

fn asked(number: u64, wanted: Wanted<'_, usize>) -> Vec<u8> {
    frame(&request(number, wanted))
}

/// What a program hears, as text with its number.
fn heard<C, B, S>(commands: &mut Commands<C, B, S>, bytes: &[u8]) -> Vec<Result<(u64, String), Answer>>
where
    C: Recordable,
    B: AsRef<[u8]> + AsMut<[u8]>,
    S: AsMut<[C::Step]>,
{
    let said = |command: Command<'_, C::Step>| (command.number, format!("{:?}", command.wanted));
    bytes.iter().filter_map(|byte| commands.push(*byte, CYCLES).map(|found| found.map(said))).collect()
}

#[expect(clippy::unnecessary_wraps, reason = "it stands beside what is refused")]
fn whole(number: u64, wanted: &str) -> Result<(u64, String), Answer> {
    Ok((number, wanted.to_owned()))
}

fn refused<T>(number: u64, why: Refused) -> Result<T, Answer> {
    Err(Answer { number, outcome: Err(why) })
}

/// One of each kind, as it is sent and as it is heard.
const ALL: [(Wanted<'static, usize>, &str); 9] = [
    (Wanted::Init, "Init"),
    (Wanted::Push, "Push"),
    (Wanted::Mode(Mode::Automatic), "Mode(Automatic)"),
    (Wanted::Mode(Mode::SemiAutomatic), "Mode(SemiAutomatic)"),
    (Wanted::Mode(Mode::Manual), "Mode(Manual)"),
    (Wanted::Mode(Mode::Paused), "Mode(Paused)"),
    (Wanted::Force(&[]), "Force([])"),
    (Wanted::Force(&[8, 0]), "Force([Rest, Done])"),
    (Wanted::Force(&[0, 1, 2, 3, 4, 5, 6, 7, 8]), "Force([Rest, Shut, Down, Held, Warm, Soak, Cool, Open, Done])"),
];

#[test]
fn what_is_asked_is_heard() {
    let (mut commands, mut bytes, mut expected) = (reading(), Vec::new(), Vec::new());
    for (number, (wanted, heard)) in (1..).zip(ALL) {
        // Numbers may leave others out.
        bytes.extend(asked(number << 40, wanted));
        expected.push(whole(number << 40, heard));
    }
    assert_eq!(heard(&mut commands, &bytes), expected);
    assert_eq!(commands.last(), 9 << 40);
}

/// Each single bit of each kind of command, with another command after it: that one alone is heard.
#[test]
fn no_wrong_bit_is_heard() {
    for (wanted, name) in ALL {
        let (bytes, next) = (asked(1, wanted), asked(2, Wanted::Init));
        for bit in 0..bytes.len() * 8 {
            let mut wrong = bytes.clone();
            wrong[bit / 8] ^= 1 << (bit % 8);
            wrong.extend(&next);
            assert_eq!(heard(&mut reading(), &wrong), [whole(2, "Init")], "{name}: bit {bit}");
        }
    }
}

#[test]
fn no_part_of_a_command_is_heard() {
    for (wanted, name) in ALL {
        let bytes = asked(1, wanted);
        for cut in 0..bytes.len() {
            assert_eq!(heard(&mut reading(), &bytes[..cut]), [], "{name} up to {cut}");
            // The rest is lost, and the next one comes whole: it begins with a zero.
            let mut cut_off = bytes[..cut].to_vec();
            cut_off.extend(asked(2, Wanted::Push));
            let mut expected = vec![whole(2, "Push")];
            // But for the zero at its end it was whole, and that of the next one stands for it.
            if cut == bytes.len() - 1 {
                expected.insert(0, whole(1, name));
            }
            assert_eq!(heard(&mut reading(), &cut_off), expected, "{name} up to {cut}");
            // Without its beginning; a zero alone is none of it.
            if cut > 1 {
                assert_eq!(heard(&mut reading(), &bytes[cut..]), [], "{name} from {cut}");
            }
            // A byte in the middle is missing.
            let gap = [&bytes[..cut], &bytes[cut + 1..], &asked(2, Wanted::Push)].concat();
            let kept: Vec<_> = heard(&mut reading(), &gap).into_iter().filter(|one| *one != whole(2, "Push")).collect();
            assert!(kept.is_empty() || [0, bytes.len() - 1].contains(&cut), "{name} without {cut}: {kept:?}");
        }
    }
}

#[test]
fn an_old_number_is_refused_and_changes_nothing() {
    let mut commands = reading();
    let first = asked(7, Wanted::Push);
    assert_eq!(heard(&mut commands, &first), [whole(7, "Push")]);
    assert_eq!(heard(&mut commands, &first), [refused(7, Refused::Old { last: 7 })], "the same once more");
    assert_eq!(heard(&mut commands, &asked(6, Wanted::Init)), [refused(6, Refused::Old { last: 7 })]);
    assert_eq!(heard(&mut commands, &asked(0, Wanted::Init)), [refused(0, Refused::Old { last: 7 })]);
    assert_eq!(heard(&mut commands, &asked(8, Wanted::Init)), [whole(8, "Init")]);
    // Over a restart, where the program has kept it.
    let mut again = reading().after(commands.last());
    assert_eq!(heard(&mut again, &asked(8, Wanted::Init)), [refused(8, Refused::Old { last: 8 })]);
    assert_eq!(heard(&mut again, &asked(9, Wanted::Init)), [whole(9, "Init")]);
}

#[test]
fn a_command_for_another_chart_is_refused_and_its_number_is_free() {
    let mut commands = reading();
    for bit in 0..32 {
        let foreign = Request { fingerprint: Press::FINGERPRINT ^ 1 << bit, ..request(1_000, Wanted::Init) };
        assert_eq!(heard(&mut commands, &frame(&foreign)), [refused(1_000, Refused::OtherChart)]);
    }
    assert_eq!(commands.last(), 0);
    assert_eq!(heard(&mut commands, &asked(1, Wanted::Init)), [whole(1, "Init")]);
}

#[test]
fn what_was_kept_back_comes_too_late() {
    let sent = |number, seen| frame(&Request { seen, ..request(number, Wanted::Push) });
    let mut commands = reading();
    assert_eq!(heard(&mut commands, &sent(1, CYCLES - OLDEST)), [whole(1, "Push")]);
    let late = |number, cycles| refused(number, Refused::Late { cycles });
    assert_eq!(heard(&mut commands, &sent(2, CYCLES - OLDEST - 1)), [late(2, OLDEST + 1)]);
    assert_eq!(heard(&mut commands, &sent(3, 0)), [late(3, CYCLES)]);
    // A cycle that this start has not made yet: there was another one in between.
    assert_eq!(heard(&mut commands, &sent(4, CYCLES + 1)), [late(4, u32::MAX)]);
    assert_eq!(heard(&mut commands, &sent(4, CYCLES)), [refused(4, Refused::Old { last: 4 })]);
    // The count of cycles begins anew.
    let mut bytes = sent(5, u32::MAX - 4).into_iter();
    assert!(bytes.any(|byte| commands.push(byte, 5).is_some_and(|found| found.is_ok())));
}

#[test]
fn what_is_whole_and_means_nothing_is_refused() {
    let content = |kind: u8, number: u64, what: &[u8]| {
        let bytes =
            [&[kind][..], &number.to_le_bytes(), &Press::FINGERPRINT.to_le_bytes(), &CYCLES.to_le_bytes(), what]
                .concat();
        wrong::frame(&bytes)
    };
    assert_eq!(content(0x15, 5, &[0]), asked(5, Wanted::Init)[1..], "as a request is written");
    for (what, why) in [
        (&[0, 0][..], "init with more after it"),
        (&[1], "no mode"),
        (&[1, 4], "no such mode"),
        (&[1, 0, 0], "two modes"),
        (&[2, 1], "push with more after it"),
        (&[3, 1], "too few steps"),
        (&[3], "no situation"),
        (&[3, 0, 2], "a tenth step"),
        (&[3, 1, 0x80], "a sixteenth step"),
        (&[4], "no such command"),
        (&[255, 1], "no such command"),
    ] {
        assert_eq!(heard(&mut reading(), &content(0x15, 5, what)), [refused(5, Refused::Unknown)], "{why}");
    }
    // Longer than any command, another kind of frame (its own ones, where a line echoes), and too short.
    assert_eq!(heard(&mut reading(), &content(0x15, 5, &[3, 1, 0, 0])), []);
    for kind in (0..=255).filter(|kind| *kind != 0x15) {
        assert_eq!(heard(&mut reading(), &content(kind, 5, &[0])), []);
    }
    assert_eq!(heard(&mut reading(), &wrong::frame(&[0x15, 1, 2, 3])), []);
    assert_eq!(heard(&mut reading(), &wrong::frame(&[])), []);
}

/// Other bits after a check sum that is right: nothing panics, and what is taken is what a request writes.
#[test]
fn there_is_one_way_to_write_a_command() {
    let (mut chance, mut taken) = (Chance::new(11), 0);
    for (wanted, _) in ALL.iter().cycle().take(20_000) {
        let content = wrong::content(&asked(1, *wanted)[1..]).expect("a frame");
        let spoilt = wrong::spoilt(&content, &mut chance);
        let sent = wrong::frame(&spoilt);
        let mut commands = reading();
        for byte in &sent {
            let Some(Ok(command)) = commands.push(*byte, CYCLES) else { continue };
            taken += 1;
            let place = |step: &PressStep| Press::STEPS.iter().position(|other| other == step);
            let steps: Vec<usize> = match command.wanted {
                Wanted::Force(steps) => steps.iter().filter_map(place).collect(),
                _ => Vec::new(),
            };
            let wanted = match command.wanted {
                Wanted::Init => Wanted::Init,
                Wanted::Push => Wanted::Push,
                Wanted::Mode(mode) => Wanted::Mode(mode),
                Wanted::Force(_) => Wanted::Force(&steps),
            };
            let seen = u32::from_le_bytes(spoilt[13..17].try_into().expect("four bytes"));
            assert!(CYCLES - seen <= OLDEST);
            assert_eq!(frame(&Request { seen, ..request(command.number, wanted) })[1..], sent);
        }
    }
    assert!(taken > 1_000, "{taken}");
}

#[test]
fn noise_is_never_a_command() {
    let mut commands = reading();
    let mut state = 1_u64;
    let noise = std::iter::repeat_with(|| {
        state = state * 48_271 % 0x7fff_ffff;
        // Many zeros, so that much of it has the length of a command.
        if state % 19 == 0 { 0 } else { state.to_le_bytes()[1] }
    });
    let noise: Vec<u8> = noise.take(1 << 20).collect();
    assert_eq!(heard(&mut commands, &noise), []);
    // A frame without an end takes no more memory, and ends with the next zero.
    assert_eq!(heard(&mut commands, &vec![1; 100_000]), []);
    assert_eq!(heard(&mut commands, &asked(1, Wanted::Init)), [whole(1, "Init")]);
}

#[test]
fn who_gives_no_room_for_steps_takes_no_situation() {
    let mut none = Commands::<Press, _, _>::new([0; command_len::<Press>()], [], OLDEST);
    assert_eq!(heard(&mut none, &asked(1, Wanted::Force(&[1]))), [refused(1, Refused::NotOffered)]);
    assert_eq!(heard(&mut none, &asked(2, Wanted::Force(&[]))), [refused(2, Refused::NotOffered)]);
    assert_eq!(heard(&mut none, &asked(3, Wanted::Init)), [whole(3, "Init")]);
    let mut one = Commands::<Press, _, _>::new([0; command_len::<Press>()], [PressStep::Rest], OLDEST);
    assert_eq!(heard(&mut one, &asked(1, Wanted::Force(&[8]))), [whole(1, "Force([Done])")]);
    assert_eq!(heard(&mut one, &asked(2, Wanted::Force(&[1, 2]))), [refused(2, Refused::NotOffered)]);
    // A buffer that is too short hears nothing, and is in no danger.
    let mut short = Commands::<Press, _, _>::new([0; 10], [], OLDEST);
    assert_eq!(heard(&mut short, &asked(1, Wanted::Init)), []);
}

#[test]
fn the_host_asks_for_no_step_that_there_is_not() {
    let mut buffer = [0; request_len(9)];
    assert_eq!(request(1, Wanted::Force(&[9])).write(&mut buffer), None);
    assert_eq!(request(1, Wanted::Force(&[usize::MAX])).write(&mut buffer), None);
    assert_eq!(request(1, Wanted::Init).write(&mut buffer[..20]), None);
    // The longest one has as many bytes as a reader has room for, one more for its encoding, and the zeros around it.
    let longest = Request { number: u64::MAX, ..request(0, Wanted::Force(&[0, 8])) };
    assert_eq!(longest.write(&mut buffer).map(<[u8]>::len), Some(command_len::<Press>() + 3));
}

#[test]
fn a_command_for_each_of_two_charts_on_one_line() {
    let (mut press, mut motor) = (reading(), Commands::<Motor, _, _>::new([0; command_len::<Motor>()], [], OLDEST));
    let steps = Motor::STEPS.len();
    let for_motor = Request { fingerprint: Motor::FINGERPRINT, steps, ..request(3, Wanted::Init) };
    let line = [asked(4, Wanted::Push), frame(&for_motor)].concat();
    assert_eq!(heard(&mut press, &line), [whole(4, "Push"), refused(3, Refused::OtherChart)]);
    assert_eq!(heard(&mut motor, &line), [refused(4, Refused::OtherChart), whole(3, "Init")]);
}

/// A program that takes commands, and what its host hears: the chart moves where a command was accepted, stays where it was refused, and the answers stand
/// between the frames.
#[test]
fn the_program_answers_in_the_stream() {
    let wire = Wire::new(Vec::new(), [0; wire_len::<Press>()]);
    let mut press = Recorder::over(Press::new(), wire).expect("as many bytes as it takes");
    let mut commands = reading();
    let inputs = PressInputs::default();
    press.cycle(&inputs, 0, &mut ());
    let asked = [
        (10, Wanted::Force(&[3, 5][..])),
        (20, Wanted::Force(&[0, 8])),
        (30, Wanted::Force(&[3])),
        (40, Wanted::Push),
        (40, Wanted::Init),
        (50, Wanted::Init),
    ];
    let mut situations = Vec::new();
    for (now, (number, wanted)) in (1..).zip(asked) {
        for byte in self::asked(number, wanted) {
            let answer = match commands.push(byte, press.cycles() + CYCLES - 1) {
                None => continue,
                Some(Err(refused)) => refused,
                Some(Ok(command)) => match command.wanted {
                    Wanted::Init => {
                        press.change(Press::init);
                        command.accepted()
                    }
                    Wanted::Force(steps) => match press.change(|press| press.force(steps, &inputs, now)) {
                        Ok(_) => command.accepted(),
                        Err(error) => command.not_forced(error),
                    },
                    Wanted::Push | Wanted::Mode(_) => command.refused(Refused::NotNow),
                },
            };
            press.answer(answer);
        }
        situations.push(press.chart().active_steps().iter().map(ToString::to_string).collect::<Vec<_>>().join(" "));
    }
    assert_eq!(situations, ["Held Soak", "Held Soak", "Held Soak", "Held Soak", "Held Soak", "Rest"]);
    let mut decoder = Decoder::new([0; frame_len::<Press>()]);
    let (mut answers, mut frames) = (Vec::new(), 0);
    for byte in press.keep().writer() {
        let Some(received) = decoder.byte(*byte) else { continue };
        let received = received.expect("no frame is damaged");
        assert_eq!(received.lost, 0, "answers are numbered with the other frames");
        frames += 1;
        if let Some(Frame::Answer(answer)) = received.frame {
            answers.push((answer.number, answer.outcome));
        }
    }
    assert!(frames > answers.len());
    let expected = [
        (10, Ok(())),
        (20, Err(Refused::NeverTogether { one: 0, other: 8 })),
        (30, Err(Refused::NoSituation)),
        (40, Err(Refused::NotNow)),
        (40, Err(Refused::Old { last: 40 })),
        (50, Ok(())),
    ];
    assert_eq!(answers, expected);
}
