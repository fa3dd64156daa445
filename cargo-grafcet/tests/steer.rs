//! Steering: what of a page's words gets to a controller, what became of it, and who may say anything.
#![cfg(feature = "watch")]

mod common;
#[path = "common/motor.rs"]
mod motor;
#[path = "common/watching.rs"]
mod watching;

use std::io::{ErrorKind, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::sync::mpsc::{Receiver, channel};
use std::thread;
use std::time::Duration;

use grafcet::record::steer::{Answer, Command, Commands, Mode, Refused, Wanted, command_len};
use grafcet::record::wire::{Wire, wire_len};
use grafcet::record::{Recordable, Recorder};
use grafcet::{Chart, grafcet};
use serde_json::{Value as Json, json};
use tungstenite::Message;

use common::folder;
use watching::{LONG, Viewer, Watching};

/// The same as below, as a user's file.
const SOURCE: &str = "grafcet! { pub(crate) sfc Press { forceable; modes; input start: bool; output ram: bool; initial step Rest; step Down { N ram; } \
                      step Up; Rest -[start]-> Down -[5s/Down]-> Up -[2s/Up]-> Rest; } }\n";

grafcet! {
    pub(crate) sfc Press {
        forceable;
        modes;
        input start: bool;
        output ram: bool;
        initial step Rest;
        step Down { N ram; }
        step Up;
        Rest -[start]-> Down -[5s/Down]-> Up -[2s/Up]-> Rest;
    }
}

/// A port to which the tool connects.
fn port() -> (TcpListener, String) {
    let listener = TcpListener::bind("127.0.0.1:0").expect("a port");
    let address = listener.local_addr().expect("an address");
    (listener, format!("tcp:{address}"))
}

fn begin(source: &str, arguments: &[&str]) -> Watching {
    Watching::begin(folder(&[("chart.rs", source)]), arguments)
}

/// The line of a controller.
struct Line(TcpStream);

impl embedded_io::ErrorType for Line {
    type Error = embedded_io::ErrorKind;
}

impl embedded_io::Write for Line {
    fn write(&mut self, bytes: &[u8]) -> Result<usize, Self::Error> {
        self.0.write(bytes).map_err(|_| embedded_io::ErrorKind::Other)
    }

    fn flush(&mut self) -> Result<(), Self::Error> {
        Ok(())
    }
}

type Running = Recorder<Press, Wire<Line, [u8; wire_len::<Press>()]>>;

/// A controller that takes commands, in a thread of its own: a cycle each 5 ms. What it hears, it tells.
fn controller(mut line: TcpStream) -> Receiver<String> {
    let (tell, told) = channel();
    line.set_read_timeout(Some(Duration::from_millis(5))).expect("a timeout");
    thread::spawn(move || {
        let wire = Wire::new(Line(line.try_clone().expect("a line")), [0; wire_len::<Press>()]);
        let mut press = Recorder::over(Press::new(), wire).expect("as many bytes as it takes");
        let mut commands = Commands::<Press, _, _>::new([0; command_len::<Press>()], [Press::STEPS[0]; 3], 2_000);
        let (mut inputs, mut bytes) = (PressInputs::default(), [0; 64]);
        for now in (0..).step_by(5) {
            inputs.push = false;
            let count = match line.read(&mut bytes) {
                Ok(0) => return,
                Ok(count) => count,
                Err(error) if [ErrorKind::WouldBlock, ErrorKind::TimedOut].contains(&error.kind()) => 0,
                Err(_) => return,
            };
            for byte in &bytes[..count] {
                let Some(command) = commands.push(*byte, press.cycles()) else { continue };
                let answer = command.map_or_else(
                    |refused| refused,
                    |command| {
                        _ = tell.send(format!("{:?}", command.wanted));
                        carry_out(&command, &mut press, &mut inputs, now)
                    },
                );
                press.answer(answer);
            }
            press.cycle(&inputs, now, &mut ());
            if now % 100 == 0 {
                press.tell_state();
            }
        }
    });
    told
}

/// Where it is paused, *Init* is not taken.
fn carry_out(command: &Command<'_, PressStep>, press: &mut Running, inputs: &mut PressInputs, now: u32) -> Answer {
    match command.wanted {
        Wanted::Init if inputs.paused => return command.refused(Refused::NotNow),
        Wanted::Init => press.change(Press::init),
        Wanted::Push => inputs.push = true,
        Wanted::Mode(mode) => {
            inputs.semi_automatic = mode == Mode::SemiAutomatic;
            inputs.manual = mode == Mode::Manual;
            inputs.paused = mode == Mode::Paused;
        }
        Wanted::Force(steps) => {
            if let Err(error) = press.change(|press| press.force(steps, inputs, now)) {
                return command.not_forced(error);
            }
        }
    }
    command.accepted()
}

/// A page that steers a press.
struct Page {
    viewer: Viewer,
    told: Receiver<String>,
    watching: Watching,
    /// How often it was refused to send.
    refusals: usize,
}

impl Page {
    fn open() -> Self {
        let (listener, address) = port();
        let watching = begin(SOURCE, &["--steer", &address]);
        let told = controller(listener.accept().expect("the tool").0);
        let mut viewer = watching.view();
        viewer.until("the chart", |viewer| viewer.charts == 1 && !viewer.moments.is_empty());
        Self { viewer, told, watching, refusals: 0 }
    }

    /// Says something, and waits for what comes of it: of the command, what the tool tells last; where it is not sent, why.
    fn say(&mut self, words: &Json) -> String {
        let last = |viewer: &Viewer| viewer.steered.as_array().and_then(|all| all.last()).cloned();
        let before = last(&self.viewer).map(|last| last["number"].clone());
        self.viewer.socket.send(Message::from(words.to_string())).expect("a socket");
        let known = self.refusals;
        self.viewer.until("an outcome", |viewer| {
            let is_answered = last(viewer).is_some_and(|last| {
                before.as_ref().is_none_or(|before| last["number"] != *before) && !last["outcome"].is_null()
            });
            viewer.refused.len() > known || is_answered
        });
        self.refusals = self.viewer.refused.len();
        if self.refusals > known {
            return format!("not sent: {}", self.viewer.refused[known]);
        }
        let last = last(&self.viewer).expect("a command");
        let why = last["outcome"]["why"].as_str().map_or_else(String::new, |why| format!(": {why}"));
        let is_accepted = last["outcome"]["accepted"] == true;
        format!("{}: {}{why}", last["what"].as_str().unwrap_or("?"), if is_accepted { "accepted" } else { "refused" })
    }

    /// What the controller has heard since.
    fn heard(&self) -> Vec<String> {
        self.told.try_iter().collect()
    }
}

fn words(what: &Json) -> Json {
    let mut words = json!({ "source": 0, "chart": Press::FINGERPRINT });
    for (name, value) in what.as_object().expect("words") {
        words[name] = value.clone();
    }
    words
}

#[test]
fn a_page_steers_and_sees_what_became_of_it() {
    let mut page = Page::open();
    assert_eq!(page.say(&words(&json!({ "do": "force", "steps": [1] }))), "force `Down`: accepted");
    page.viewer.until("the step", |viewer| viewer.moments.last().is_some_and(|last| last["steps"] == json!([1])));
    assert_eq!(
        page.say(&words(&json!({ "do": "force", "steps": [0, 2] }))),
        "force `Rest`, `Up`: refused: `Rest` and `Up` are never active together"
    );
    assert_eq!(
        page.say(&words(&json!({ "do": "force", "steps": [] }))),
        "force no step: refused: the chart has no situation of exactly these steps"
    );
    assert_eq!(page.say(&words(&json!({ "do": "mode", "mode": "manual" }))), "manual: accepted");
    assert_eq!(page.say(&words(&json!({ "do": "push" }))), "push: accepted");
    page.viewer.until("the next step", |viewer| viewer.moments.last().is_some_and(|last| last["steps"] == json!([2])));
    assert_eq!(page.say(&words(&json!({ "do": "mode", "mode": "paused" }))), "paused: accepted");
    assert_eq!(
        page.say(&words(&json!({ "do": "init" }))),
        "init: refused: the program on the controller does not take it now"
    );
    assert_eq!(page.say(&words(&json!({ "do": "mode", "mode": "semi-automatic" }))), "semi-automatic: accepted");
    assert_eq!(page.say(&words(&json!({ "do": "mode", "mode": "automatic" }))), "automatic: accepted");
    assert_eq!(page.say(&words(&json!({ "do": "init" }))), "init: accepted");
    page.viewer.until("the first step", |viewer| viewer.moments.last().is_some_and(|last| last["steps"] == json!([0])));
    let heard = [
        "Force([Down])",
        "Force([Rest, Up])",
        "Force([])",
        "Mode(Manual)",
        "Push",
        "Mode(Paused)",
        "Init",
        "Mode(SemiAutomatic)",
        "Mode(Automatic)",
        "Init",
    ];
    assert_eq!(page.heard(), heard);
    // Another page is told of the last five of them, too.
    let mut other = page.watching.view();
    other.until("the commands", |viewer| viewer.steered.as_array().is_some_and(|all| all.len() == 5));
    assert_eq!(other.steered[4]["what"], "init");
    assert_eq!(page.viewer.line["damaged"], 0);
}

#[test]
fn what_the_chart_has_not_is_not_sent() {
    let mut page = Page::open();
    let step = words(&json!({ "do": "force", "steps": [3] }));
    assert_eq!(page.say(&step), "not sent: the chart has no such step");
    let mut other = words(&json!({ "do": "init" }));
    other["chart"] = json!(Press::FINGERPRINT ^ 1);
    assert_eq!(page.say(&other), "not sent: the controller runs another chart by now");
    assert_eq!(page.heard(), [] as [&str; 0]);

    // A chart without the words, and a controller that sends but never answers.
    let (listener, address) = port();
    let watching = begin(motor::SOURCE, &["--steer", &address]);
    let (mut line, _) = listener.accept().expect("the tool");
    line.write_all(&motor::frames(3, 100)).expect("a line");
    let mut viewer = watching.view();
    viewer.until("the moments", |viewer| viewer.moments.len() == 3);
    let chart = motor::Motor::FINGERPRINT;
    let say = |viewer: &mut Viewer, what: &Json, expected: &str| {
        let mut words = json!({ "source": 0, "chart": chart });
        for (name, value) in what.as_object().expect("words") {
            words[name] = value.clone();
        }
        let known = viewer.refused.len();
        viewer.socket.send(Message::from(words.to_string())).expect("a socket");
        viewer.until("a refusal", |viewer| viewer.refused.len() > known);
        assert_eq!(viewer.refused[known], expected);
    };
    say(&mut viewer, &json!({ "do": "push" }), "the chart has no `modes;`");
    say(&mut viewer, &json!({ "do": "mode", "mode": "paused" }), "the chart has no `modes;`");
    say(&mut viewer, &json!({ "do": "force", "steps": [1] }), "the chart is not `forceable;`");
    // *Init* every chart has. While nobody has answered, the next one waits.
    let init = json!({ "source": 0, "chart": chart, "do": "init" }).to_string();
    let sent = |viewer: &Viewer| viewer.steered.as_array().map_or(0, Vec::len);
    viewer.socket.send(Message::from(init.clone())).expect("a socket");
    viewer.until("the command", |viewer| sent(viewer) == 1);
    assert_eq!(viewer.steered[0]["outcome"], Json::Null);
    viewer.socket.send(Message::from(init.clone())).expect("a socket");
    viewer.until("a refusal", |viewer| viewer.refused.len() == 4);
    assert_eq!((&*viewer.refused[3], sent(&viewer)), ("the last command was not answered yet", 1));
    thread::sleep(Duration::from_millis(3_100));
    viewer.socket.send(Message::from(init)).expect("a socket");
    viewer.until("the next command", |viewer| sent(viewer) == 2);
    // Where the line is lost, nobody knows what became of it; and nothing is sent.
    drop(line);
    viewer.until("the loss", |viewer| !viewer.steered[1]["outcome"].is_null());
    assert_eq!(viewer.steered[1]["outcome"]["why"], "the line was lost, and nobody knows");
    say(&mut viewer, &json!({ "do": "init" }), "what the chart does now is not known");
}

#[test]
fn what_is_no_command_ends_it() {
    let page = Page::open();
    let init = words(&json!({ "do": "init" })).to_string();
    for said in [
        "",
        "init",
        "[]",
        "null",
        "{}",
        &init[..init.len() - 1],
        &format!("{init}{init}"),
        &words(&json!({ "do": "init", "now": true })).to_string(),
        &words(&json!({ "do": "force" })).to_string(),
        &words(&json!({ "do": "force", "steps": 1 })).to_string(),
        &words(&json!({ "do": "force", "steps": [-1] })).to_string(),
        &words(&json!({ "do": "force", "steps": [0.5] })).to_string(),
        &words(&json!({ "do": "force", "steps": [1, 0] })).to_string(),
        &words(&json!({ "do": "force", "steps": [1, 1] })).to_string(),
        &words(&json!({ "do": "force", "steps": ["Down"] })).to_string(),
        &words(&json!({ "do": "mode" })).to_string(),
        &words(&json!({ "do": "mode", "mode": "fast" })).to_string(),
        &words(&json!({ "do": "push", "mode": "paused" })).to_string(),
        &words(&json!({ "do": "stop" })).to_string(),
        &words(&json!({ "do": 1 })).to_string(),
        &words(&json!({ "source": 1, "do": "init" })).to_string(),
        &words(&json!({ "source": -1, "do": "init" })).to_string(),
        &words(&json!({ "source": "0", "do": "init" })).to_string(),
        &words(&json!({ "chart": u64::MAX, "do": "init" })).to_string(),
        &json!({ "source": 0, "do": "init" }).to_string(),
        &json!({ "chart": Press::FINGERPRINT, "do": "init" }).to_string(),
    ] {
        let end = page.watching.view().ends_by(Message::from(said));
        assert!(end.contains("this is no command"), "{said}: {end}");
    }
    // In bytes, and longer than any command.
    page.watching.view().ends_by(Message::from(init.into_bytes()));
    page.watching.view().ends_by(Message::from("1".repeat(5_000)));
    assert_eq!(page.heard(), [] as [&str; 0]);
}

#[test]
fn nobody_else_says_anything() {
    let page = Page::open();
    let (port, token) = (page.watching.port, &page.watching.token);
    let (host, own) = (page.watching.host(), format!("Origin: http://127.0.0.1:{port}\r\n"));
    let last = if token.ends_with('0') { '1' } else { '0' };
    let wrong = format!("/{}{last}/socket", &token[..31]);
    assert_eq!(page.watching.open(&wrong, &format!("{host}{own}")), 404);
    assert_eq!(page.watching.open("/socket", &format!("{host}{own}")), 404);
    let right = format!("/{token}/socket");
    for origin in
        ["", "Origin: null\r\n", "Origin: http://evil.example\r\n", &format!("Origin: https://127.0.0.1:{port}\r\n")]
    {
        assert_eq!(page.watching.open(&right, &format!("{host}{origin}")), 403, "{origin}");
    }
    assert_eq!(page.watching.open(&right, &format!("Host: evil.example:{port}\r\n{own}")), 403);
    // Nothing but the socket takes words.
    for path in ["", "socket", "steer"] {
        let mut stream = TcpStream::connect(("127.0.0.1", port)).expect("the server");
        let body = words(&json!({ "do": "init" })).to_string();
        write!(
            stream,
            "POST /{token}/{path} HTTP/1.1\r\n{host}{own}Connection: close\r\nContent-Length: {}\r\n\r\n{body}",
            body.len()
        )
        .expect("a request");
        let mut text = String::new();
        _ = stream.read_to_string(&mut text);
        assert!(text.starts_with("HTTP/1.1 405"), "{path}: {text}");
    }
    assert_eq!(page.watching.open(&right, &format!("{host}{own}")), 101);
    assert_eq!(page.heard(), [] as [&str; 0]);
}

#[test]
fn without_the_word_nothing_gets_to_the_controller() {
    let (listener, address) = port();
    let watching = begin(SOURCE, &[&address]);
    let (mut line, _) = listener.accept().expect("the tool");
    let mut press = Recorder::over(Press::new(), Wire::new(Vec::new(), [0; wire_len::<Press>()])).expect("enough");
    press.cycle(&PressInputs::default(), 0, &mut ());
    line.write_all(press.keep().writer()).expect("a line");
    let mut viewer = watching.view();
    viewer.until("the chart", |viewer| viewer.charts == 1 && !viewer.moments.is_empty());
    assert!(viewer.steered.is_null());
    let end = viewer.ends_by(Message::from(words(&json!({ "do": "init" })).to_string()));
    assert!(end.contains("this page only looks"), "{end}");
    drop(watching);
    // The line has ended, and not a byte has come over it.
    let mut bytes = Vec::new();
    line.set_read_timeout(Some(LONG)).expect("a timeout");
    line.read_to_end(&mut bytes).expect("the end");
    assert!(bytes.is_empty(), "{bytes:?}");
}

#[test]
fn what_leads_nowhere_is_not_steered() {
    let folder = folder(&[("chart.rs", SOURCE), ("press.frames", "")]);
    for (source, name) in [("press.frames", "press.frames"), ("-", "standard input"), ("Press=-", "standard input")] {
        for more in [&[][..], &["tcp:127.0.0.1:9"]] {
            let arguments = [&["watch", "--steer", "--file", "chart.rs"], more, &[source]].concat();
            let done = common::tool_within(LONG, folder.path(), &arguments);
            let expected = format!(
                "error: --steer needs a line that leads back to the controller, and {name} does not: give tcp:HOST:PORT or serial:PORT\n"
            );
            assert_eq!((done.code, done.err), (Some(2), expected), "{source}");
        }
    }
}

/// A tool that begins where it should not is a failure, and no test that hangs.
#[test]
#[should_panic(expected = "goes on and on; so far it says:\nhttp://127.0.0.1:")]
fn what_does_not_end_is_ended() {
    let folder = folder(&[("chart.rs", SOURCE)]);
    common::tool_within(Duration::from_secs(3), folder.path(), &["watch", "--file", "chart.rs", "-"]);
}
