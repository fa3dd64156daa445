//! The live view: who may look at it, what comes of each kind of source, and what many viewers and many frames take.
#![cfg(feature = "watch")]

mod common;
#[path = "common/motor.rs"]
mod motor;
#[path = "common/watching.rs"]
mod watching;

use std::io::Write;
use std::net::{TcpListener, TcpStream};
use std::thread;
use std::time::{Duration, Instant};

use grafcet::record::Recordable;
use serde_json::Value as Json;
use tungstenite::Message;

use common::folder;
use motor::{Motor, OTHER, SOURCE, frames};
use watching::{LONG, Viewer, Watching};

/// The tool as it watches a motor, with some of its frames in a file.
fn begin(source: &str, arguments: &[&str]) -> Watching {
    let folder = folder(&[("chart.rs", source)]);
    std::fs::write(folder.path().join("motor.frames"), frames(4, 100)).expect("a file");
    Watching::begin(folder, arguments)
}

#[test]
fn only_who_has_the_token_is_answered() {
    let watching = begin(SOURCE, &["motor.frames"]);
    let (host, page) = (watching.host(), format!("/{}/", watching.token));
    assert_eq!(watching.token.len(), 32);
    let (status, text) = watching.ask(&page, &host);
    assert_eq!(status, 200);
    let text = text.to_lowercase();
    for header in [
        "content-security-policy: default-src 'none'; script-src 'self'",
        "x-content-type-options: nosniff",
        "referrer-policy: no-referrer",
        "cache-control: no-store",
    ] {
        assert!(text.contains(header), "{header}");
    }
    for file in [
        "live.js",
        "chronogram.js",
        "drawing.js",
        "rich.js",
        "signals.js",
        "steering.js",
        "theme.js",
        "style.css",
        "icon.svg",
    ] {
        assert_eq!(watching.ask(&format!("{page}{file}"), &host).0, 200, "{file}");
    }
    let last = if watching.token.ends_with('0') { '1' } else { '0' };
    let wrong = format!("/{}{last}/", &watching.token[..31]);
    for path in [
        "/",
        "/live.js",
        &wrong,
        &page[..33],
        "/x/",
        &format!("{page}Cargo.toml"),
        &format!("{page}../motor.rs"),
        &format!("{page}%2e%2e/motor.rs"),
    ] {
        let (status, text) = watching.ask(path, &host);
        assert_eq!(status, 404, "{path}: {text}");
    }
    assert!(TcpStream::connect(("127.0.0.1", watching.port)).is_ok());
}

#[test]
fn foreign_names_and_foreign_pages_are_refused() {
    let watching = begin(SOURCE, &["motor.frames"]);
    let (page, port) = (format!("/{}/", watching.token), watching.port);
    // A page whose name leads to this machine (DNS rebinding) says its own name here.
    for host in [
        "",
        "Host: evil.example\r\n",
        &format!("Host: evil.example:{port}\r\n"),
        "Host: 127.0.0.1\r\n",
        "Host: localhost:1\r\n",
    ] {
        let status = watching.ask(&page, host).0;
        assert!([400, 403].contains(&status), "{host}: {status}");
    }
    assert_eq!(watching.ask(&page, &format!("Host: localhost:{port}\r\n")).0, 200);
    let (host, socket) = (watching.host(), format!("{page}socket"));
    let [null, foreign, portless, secure, own] = [
        "null",
        "http://evil.example",
        "http://127.0.0.1",
        &format!("https://127.0.0.1:{port}"),
        &format!("http://127.0.0.1:{port}"),
    ]
    .map(|origin| format!("Origin: {origin}\r\n"));
    for origin in ["", &null, &foreign, &portless, &secure] {
        assert_eq!(watching.open(&socket, &format!("{host}{origin}")), 403, "{origin}");
    }
    // The same request is right where the page itself makes it.
    assert_eq!(watching.open(&socket, &format!("{host}{own}")), 101);
    assert_eq!(watching.open(&socket, &format!("Host: evil.example:{port}\r\n{own}")), 403);
    assert_eq!(watching.open("/x/socket", &format!("{host}{own}")), 404);
    assert_eq!(watching.ask(&socket, &format!("{host}{own}")).0, 403, "no upgrade");
    assert_eq!(watching.ask(&page, &format!("{host}{foreign}")).0, 403);
    watching.view().until("the moments", |viewer| viewer.moments.len() == 4);
}

#[test]
fn a_file_grows_and_a_pipe_ends() {
    let mut watching = begin(SOURCE, &["motor.frames", "Motor=-"]);
    // The first cycle of the pipe is the same as of the file: four moments of one and three of the other.
    let mut viewer = watching.view();
    viewer.until("the file", |viewer| viewer.moments.len() >= 4);
    let file = watching.folder.path().join("motor.frames");
    let more = &frames(6, 100)[frames(4, 100).len()..];
    std::fs::OpenOptions::new().append(true).open(file).and_then(|mut file| file.write_all(more)).expect("a file");
    viewer.until("what was added", |viewer| viewer.last() == Some(6));
    let mut input = watching.input.take().expect("its input");
    input.write_all(&frames(3, 100)).expect("a pipe");
    drop(input);
    viewer.until("the end of the pipe", |viewer| viewer.line["state"] == "has ended");
    assert_eq!((viewer.charts, viewer.last()), (2, Some(3)));
    assert_eq!(viewer.line["unknown"], "the source has ended");
}

#[test]
fn a_connection_is_made_again() {
    let listener = TcpListener::bind("127.0.0.1:0").expect("a port");
    let address = listener.local_addr().expect("an address").to_string();
    let watching = begin(SOURCE, &[&format!("tcp:{address}")]);
    let mut viewer = watching.view();
    let (mut stream, _) = listener.accept().expect("the tool");
    let bytes = frames(20, 4);
    // Half a frame, and nobody there any more.
    stream.write_all(&bytes[..bytes.len() / 2]).expect("a connection");
    viewer.until("the first half", |viewer| viewer.last().is_some_and(|last| last > 5));
    drop(stream);
    viewer.until("the loss", |viewer| {
        viewer.line["unknown"].as_str().is_some_and(|why| why.contains("the source has ended"))
    });
    let (mut stream, _) = listener.accept().expect("the tool again");
    stream.write_all(&bytes[bytes.len() / 2 + 1..]).expect("a connection");
    viewer.until("the second half", |viewer| viewer.last() == Some(20));
    let gaps: Vec<&Json> =
        viewer.moments.iter().map(|moment| &moment["gap"]["reason"]).filter(|gap| !gap.is_null()).collect();
    assert!(gaps.iter().any(|gap| gap.as_str().is_some_and(|gap| gap.starts_with("the source has ended"))), "{gaps:?}");
}

#[test]
fn another_version_shows_nothing_but_that() {
    let watching = begin(OTHER, &["motor.frames"]);
    let mut viewer = watching.view();
    viewer.until("the frames", |viewer| viewer.line["frames"].as_u64() > Some(0));
    assert!(viewer.line["unknown"].as_str().is_some_and(|why| why.contains("another version")), "{}", viewer.line);
    assert_eq!((viewer.moments.len(), viewer.charts), (0, 0));
}

/// Who changes a chart while he looks, and has loaded it already, needs no new start of the tool, nor who saves it with a mistake in between.
#[test]
fn a_chart_that_was_changed_is_read_again() {
    let listener = TcpListener::bind("127.0.0.1:0").expect("a port");
    let address = listener.local_addr().expect("an address");
    let watching = begin(OTHER, &[&format!("tcp:{address}")]);
    let (mut stream, _) = listener.accept().expect("the tool");
    let mut viewer = watching.view();
    stream.write_all(&frames(12, 4)).expect("a connection");
    viewer.until("another version", |viewer| {
        viewer.line["unknown"].as_str().is_some_and(|why| why.contains("another version"))
    });
    let (file, half) = (watching.folder.path().join("chart.rs"), SOURCE.len() / 2);
    // It does not end before it is seen; a state comes with each of them.
    let sender = thread::spawn(move || {
        while stream.write_all(&frames(12, 4)).is_ok() {
            thread::sleep(Duration::from_millis(50));
        }
    });
    std::fs::write(&file, &SOURCE[..half]).expect("a file");
    // Longer than the tool waits before it looks again.
    thread::sleep(Duration::from_millis(2_500));
    let frames = viewer.line["frames"].as_u64();
    viewer.until("more frames", |viewer| viewer.line["frames"].as_u64() > frames);
    assert_eq!((viewer.charts, viewer.moments.len()), (0, 0));
    std::fs::write(&file, SOURCE).expect("a file");
    viewer.until("the chart", |viewer| viewer.charts == 1 && viewer.moments.len() > 3);
    assert!(viewer.line["unknown"].is_null(), "{}", viewer.line);
    drop(watching);
    sender.join().expect("the line has ended");
}

#[test]
fn fifty_viewers_and_one_that_does_not_read() {
    const FRAMES: u32 = 20_000;
    let listener = TcpListener::bind("127.0.0.1:0").expect("a port");
    let address = listener.local_addr().expect("an address").to_string();
    let watching = begin(SOURCE, &["--keep", "500", &format!("tcp:{address}")]);
    let (mut stream, _) = listener.accept().expect("the tool");
    let mut viewers: Vec<Viewer> = (0..49).map(|_| watching.view()).collect();
    let stuck = watching.view();
    let bytes = frames(FRAMES, 256);
    let tenth = bytes.len() / 10;
    stream.write_all(&bytes[..tenth]).expect("a connection");
    viewers[0].until("some moments", |viewer| viewer.moments.len() >= 50);
    let (before, begin) = (watching.memory(), Instant::now());
    let sender = thread::spawn(move || {
        // As 10,000 frames a second come: a hundredth of a second's at once.
        for (number, piece) in bytes[tenth..].chunks(bytes.len() * 100 / FRAMES as usize).enumerate() {
            let at = begin + Duration::from_millis(10) * u32::try_from(number).expect("a few");
            thread::sleep(at.saturating_duration_since(Instant::now()));
            stream.write_all(piece).expect("a connection");
        }
        stream
    });
    thread::scope(|scope| {
        for viewer in &mut viewers {
            scope.spawn(move || viewer.until("the last moment", |viewer| viewer.last() == Some(u64::from(FRAMES))));
        }
    });
    let after = watching.memory();
    for viewer in &viewers {
        let line = &viewer.line;
        assert_eq!((&line["damaged"], &line["lost"], &line["unknown"]), (&Json::from(0), &Json::from(0), &Json::Null));
        // Every moment is either shown or said to be missing.
        assert!(viewer.moments.len() as u64 + viewer.missed <= u64::from(FRAMES));
    }
    // 500 moments of half a kilobyte, and for each viewer a message and what the library holds of it.
    if let (Some(before), Some(after)) = (before, after) {
        let seconds = begin.elapsed().as_secs_f32();
        println!("50 viewers: {} KB, {} KB after {FRAMES} frames and {seconds:.1} s", before / 1024, after / 1024);
        assert!(after < before + (32 << 20), "{before} bytes before, {after} after");
    }
    drop((sender.join(), stuck));
}

#[test]
fn there_are_seats_for_64() {
    let watching = begin(SOURCE, &["motor.frames"]);
    let mut viewers: Vec<Viewer> = (0..64).map(|_| watching.view()).collect();
    let refused = watching.viewer().err().map(|error| error.to_string());
    assert!(refused.as_ref().is_some_and(|error| error.contains("503")), "{refused:?}");
    // Who goes leaves a seat.
    viewers.pop();
    let end = Instant::now() + LONG;
    while watching.viewer().is_err() {
        assert!(Instant::now() < end, "no seat is left");
        thread::sleep(Duration::from_millis(50));
    }
}

#[test]
fn what_a_page_says_ends_it() {
    let watching = begin(SOURCE, &["motor.frames"]);
    let fingerprint = Motor::FINGERPRINT;
    let command = format!(r#"{{"source":0,"chart":{fingerprint},"do":"init"}}"#);
    for said in ["force".to_owned(), String::new(), command] {
        let mut viewer = watching.view();
        viewer.until("the moments", |viewer| viewer.moments.len() == 4);
        assert!(viewer.steered.is_null());
        let end = viewer.ends_by(Message::from(said.clone()));
        assert!(end.contains("this page only looks"), "{said}: {end}");
    }
    let end = watching.view().ends_by(Message::from(vec![0_u8; 10]));
    assert!(!end.is_empty());
}

#[test]
fn what_cannot_be_watched_is_said() {
    let folder = folder(&[("motor.rs", SOURCE)]);
    let done = |arguments: &[&str]| common::tool(folder.path(), arguments);
    let none = done(&["watch", "--file", "motor.rs", "Moter=-"]);
    assert_eq!(none.code, Some(2));
    assert_eq!(none.err, "error: Moter=standard input: there is no chart `Moter`, but `Motor`\n");
    let two = done(&["watch", "--file", "motor.rs", "-", "Motor=-"]);
    assert_eq!((two.code, &*two.err), (Some(2), "error: the input of the program can be one source alone\n"));
    assert_eq!(done(&["watch", "--file", "motor.rs", "tcp:nowhere"]).code, Some(2));
    let busy = TcpListener::bind("127.0.0.1:0").expect("a port");
    let port = busy.local_addr().expect("an address").port().to_string();
    let done = done(&["watch", "--file", "motor.rs", "--port", &port, "-"]);
    assert_eq!(done.code, Some(2));
    assert!(done.err.starts_with("error: the page cannot be served: "), "{}", done.err);
}
