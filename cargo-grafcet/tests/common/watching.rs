//! The tool as it watches, and a page that looks.
#![allow(dead_code, reason = "each test needs a part of it")]

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, ChildStdin, Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::Value as Json;
use tempfile::TempDir;
use tungstenite::client::IntoClientRequest;
use tungstenite::{Message, WebSocket};

/// No machine takes as long as this.
pub(crate) const LONG: Duration = Duration::from_secs(120);

/// The tool as it watches.
pub(crate) struct Watching {
    pub(crate) child: Child,
    pub(crate) input: Option<ChildStdin>,
    pub(crate) port: u16,
    pub(crate) token: String,
    pub(crate) folder: TempDir,
}

impl Watching {
    /// With the sources and options `arguments`, in a folder that has the chart as `chart.rs`.
    pub(crate) fn begin(folder: TempDir, arguments: &[&str]) -> Self {
        let mut command = Command::new(env!("CARGO_BIN_EXE_cargo-grafcet"));
        command.args(["grafcet", "watch", "--file", "chart.rs"]).args(arguments).current_dir(folder.path());
        let mut child =
            command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::null()).spawn().expect("the tool");
        let mut line = String::new();
        BufReader::new(child.stdout.as_mut().expect("its output")).read_line(&mut line).expect("a line");
        let (port, token) =
            line.trim().strip_prefix("http://127.0.0.1:").and_then(|rest| rest.split_once('/')).expect(&line);
        let (port, token) = (port.parse().expect("a port"), token.trim_end_matches('/').to_owned());
        Self { input: child.stdin.take(), child, port, token, folder }
    }

    /// The status and the text of an answer to a request with these lines in its head.
    pub(crate) fn ask(&self, path: &str, head: &str) -> (u16, String) {
        let mut text = String::new();
        let mut stream = self.send(path, &format!("Connection: close\r\n{head}"));
        stream.read_to_string(&mut text).expect("an answer");
        (text.get(9..12).and_then(|status| status.parse().ok()).expect(&text), text)
    }

    /// The status of an answer to a browser that would open a socket.
    pub(crate) fn open(&self, path: &str, head: &str) -> u16 {
        let upgrade = "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n\
                       Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n";
        let mut line = [0; 12];
        self.send(path, &format!("{upgrade}{head}")).read_exact(&mut line).expect("an answer");
        String::from_utf8_lossy(&line[9..]).parse().expect("a status")
    }

    pub(crate) fn send(&self, path: &str, head: &str) -> TcpStream {
        let mut stream = TcpStream::connect(("127.0.0.1", self.port)).expect("the server");
        write!(stream, "GET {path} HTTP/1.1\r\n{head}\r\n").expect("a request");
        stream
    }

    pub(crate) fn host(&self) -> String {
        format!("Host: 127.0.0.1:{}\r\n", self.port)
    }

    pub(crate) fn view(&self) -> Viewer {
        self.viewer().expect("a socket")
    }

    pub(crate) fn viewer(&self) -> Result<Viewer, Box<tungstenite::Error>> {
        let mut request =
            format!("ws://127.0.0.1:{}/{}/socket", self.port, self.token).into_client_request().map_err(Box::new)?;
        let origin = format!("http://127.0.0.1:{}", self.port).parse().expect("a header");
        request.headers_mut().insert("Origin", origin);
        let stream = TcpStream::connect(("127.0.0.1", self.port)).expect("the server");
        stream.set_read_timeout(Some(LONG)).expect("a timeout");
        match tungstenite::client(request, stream) {
            Ok((socket, _)) => Ok(Viewer {
                socket,
                moments: Vec::new(),
                line: Json::Null,
                missed: 0,
                charts: 0,
                steered: Json::Null,
                refused: Vec::new(),
            }),
            Err(tungstenite::HandshakeError::Failure(error)) => Err(Box::new(error)),
            Err(error) => panic!("{error}"),
        }
    }

    /// Bytes of memory that it takes now, where the system tells.
    pub(crate) fn memory(&self) -> Option<usize> {
        let status =
            std::fs::read_to_string(Path::new("/proc").join(self.child.id().to_string()).join("status")).ok()?;
        let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"))?;
        line.trim().strip_suffix(" kB")?.parse::<usize>().ok().map(|kilobytes| kilobytes * 1024)
    }
}

impl Drop for Watching {
    fn drop(&mut self) {
        _ = self.child.kill();
        _ = self.child.wait();
    }
}

/// A page that looks.
pub(crate) struct Viewer {
    pub(crate) socket: WebSocket<TcpStream>,
    pub(crate) moments: Vec<Json>,
    pub(crate) line: Json,
    pub(crate) missed: u64,
    pub(crate) charts: usize,
    /// The last commands, as the tool tells of them, and why others were not sent.
    pub(crate) steered: Json,
    pub(crate) refused: Vec<String>,
}

impl Viewer {
    /// Reads on until this holds.
    pub(crate) fn until(&mut self, what: &str, holds: impl Fn(&Self) -> bool) {
        let end = Instant::now() + LONG;
        while !holds(self) {
            assert!(
                Instant::now() < end,
                "{what}: {} with {} moments, {}",
                self.line,
                self.moments.len(),
                self.steered
            );
            let Message::Text(text) = self.socket.read().expect(what) else { continue };
            let news: Json = serde_json::from_str(&text).expect("JSON");
            if news.get("sources").is_some() {
                continue;
            }
            if let Some(why) = news.get("refused") {
                self.refused.push(why.as_str().expect("a reason").to_owned());
                continue;
            }
            self.steered = news["steered"].clone();
            if news.get("chart").is_some_and(|chart| !chart.is_null()) {
                self.charts += 1;
                self.moments.clear();
            }
            self.line = news["line"].clone();
            self.missed += news["missed"].as_u64().expect("a number");
            self.moments.extend(news["moments"].as_array().expect("moments").iter().cloned());
        }
    }

    /// Says something, and reads on until the tool hangs up; with which words it does.
    pub(crate) fn ends_by(mut self, said: Message) -> String {
        self.socket.send(said).expect("a socket");
        let end = Instant::now() + LONG;
        loop {
            assert!(Instant::now() < end, "it goes on");
            match self.socket.read() {
                Ok(Message::Close(close)) => return close.map(|close| close.to_string()).unwrap_or_default(),
                Ok(_) => {}
                Err(error) => return error.to_string(),
            }
        }
    }

    pub(crate) fn last(&self) -> Option<u64> {
        self.moments.last()?["number"].as_u64()
    }
}
