//! A headless Chromium that is told what to do over pipes, by the protocol of its developer tools.

use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::thread;
use std::time::Duration;

use serde_json::{Value, json};

use crate::command::{Result, find};

/// What is not answered by then hangs.
const LIMIT: Duration = Duration::from_secs(60);

/// A program of the PATH.
///
/// # Errors
/// There is none; the message says what to install.
pub(crate) fn find_browser() -> Result<std::path::PathBuf> {
    let browsers = ["chromium", "chromium-browser", "google-chrome"];
    let found = browsers.iter().find_map(|name| find(name));
    found.ok_or_else(|| "no Chromium in the PATH; on Debian `apt-get install chromium`".to_owned())
}

/// A page in a browser of its own.
pub(super) struct Browser {
    process: Child,
    to: ChildStdin,
    from: Receiver<Value>,
    next: u64,
    session: Option<String>,
    /// What a script has thrown, and what the console says is an error.
    pub(super) problems: Vec<String>,
    /// Events that came while something else was waited for.
    loaded: bool,
}

impl Browser {
    /// With a window of this size.
    ///
    /// # Errors
    /// There is no Chromium, or it does not answer.
    pub(super) fn start(profile: &Path, (width, height): (u32, u32)) -> Result<Self> {
        // The browser reads and writes at the descriptors 3 and 4, which the shell makes of its own input and output.
        let mut command = Command::new("sh");
        command.args(["-c", "exec \"$@\" 3<&0 4>&1 </dev/null >/dev/null 2>&1", "sh"]).arg(find_browser()?);
        // Its sandbox does not work for root; the page is our own.
        command.args(["--headless", "--no-sandbox", "--disable-gpu", "--remote-debugging-pipe"]);
        command.arg(format!("--user-data-dir={}", profile.display())).arg(format!("--window-size={width},{height}"));
        command.stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut process = command.spawn().map_err(|error| format!("Chromium: {error}"))?;
        let (Some(to), Some(out)) = (process.stdin.take(), process.stdout.take()) else {
            return Err("Chromium has no pipes".to_owned());
        };
        let (sender, from) = channel();
        thread::spawn(move || {
            for message in BufReader::new(out).split(0) {
                let Ok(message) = message else { return };
                if serde_json::from_slice(&message).is_ok_and(|message| sender.send(message).is_err()) {
                    return;
                }
            }
        });
        let (next, session, problems) = (1, None, Vec::new());
        let mut browser = Self { process, to, from, next, session, problems, loaded: false };
        let target = browser.ask("Target.createTarget", &json!({ "url": "about:blank" }))?;
        let to = json!({ "targetId": target["targetId"], "flatten": true });
        let attached = browser.ask("Target.attachToTarget", &to)?;
        browser.session = attached["sessionId"].as_str().map(str::to_owned);
        for domain in ["Runtime.enable", "Page.enable", "Log.enable"] {
            browser.ask(domain, &json!({}))?;
        }
        let size = json!({ "width": width, "height": height, "deviceScaleFactor": 1, "mobile": false });
        browser.ask("Emulation.setDeviceMetricsOverride", &size)?;
        Ok(browser)
    }

    /// Sends a command, and waits for what it answers.
    ///
    /// # Errors
    /// The browser refuses it, or does not answer.
    pub(super) fn ask(&mut self, method: &str, params: &Value) -> Result<Value> {
        let id = self.next;
        self.next += 1;
        let mut message = json!({ "id": id, "method": method, "params": params });
        if let Some(session) = &self.session {
            message["sessionId"] = json!(session);
        }
        let sent = self.to.write_all(format!("{message}\0").as_bytes()).and_then(|()| self.to.flush());
        sent.map_err(|error| format!("Chromium does not take `{method}`: {error}"))?;
        loop {
            let mut answer = self.receive(method)?;
            if answer["id"] == id {
                return match answer.get("error") {
                    Some(error) => Err(format!("`{method}`: {error}")),
                    None => Ok(answer["result"].take()),
                };
            }
        }
    }

    /// The next message; what went wrong in the page is noted.
    fn receive(&mut self, waiting_for: &str) -> Result<Value> {
        let message = self.from.recv_timeout(LIMIT);
        let message = message.map_err(|_| format!("Chromium does not answer to `{waiting_for}`"))?;
        match message["method"].as_str() {
            Some("Runtime.exceptionThrown") => self.problems.push(message["params"]["exceptionDetails"].to_string()),
            Some("Log.entryAdded") if message["params"]["entry"]["level"] == "error" => {
                self.problems.push(message["params"]["entry"].to_string());
            }
            Some("Page.loadEventFired") => self.loaded = true,
            _ => {}
        }
        Ok(message)
    }

    /// Opens a page and waits until it is there; one that is open already and only goes to another place of itself is there at once.
    ///
    /// # Errors
    /// As of [`Browser::ask`].
    pub(super) fn open(&mut self, url: &str) -> Result {
        self.loaded = false;
        // After the page's own listener, which has then done its work.
        self.value("globalThis.heard = new Promise(heard => addEventListener('hashchange', () => heard(true), { once: true })), 0")?;
        let answer = self.ask("Page.navigate", &json!({ "url": url }))?;
        if let Some(error) = answer.get("errorText") {
            return Err(format!("{url}: {error}"));
        }
        if answer.get("loaderId").is_none() {
            // Nothing is loaded anew: the page is told some time later.
            self.ask("Runtime.evaluate", &json!({ "expression": "globalThis.heard", "awaitPromise": true }))?;
            return Ok(());
        }
        while !self.loaded {
            self.receive("Page.navigate")?;
        }
        Ok(())
    }

    /// The value of an expression in the page.
    ///
    /// # Errors
    /// It throws; or as of [`Browser::ask`].
    pub(super) fn value(&mut self, expression: &str) -> Result<Value> {
        let asked = json!({ "expression": expression, "returnByValue": true });
        let mut answer = self.ask("Runtime.evaluate", &asked)?;
        match answer.get("exceptionDetails") {
            Some(thrown) => Err(format!("{expression}: {thrown}")),
            None => Ok(answer["result"]["value"].take()),
        }
    }

    /// A key goes down and up.
    ///
    /// # Errors
    /// As of [`Browser::ask`].
    pub(super) fn key(&mut self, key: &str) -> Result {
        // What the browser itself does with a key, as in a slider, it does by this number.
        let code = match key {
            "End" => 35,
            "Home" => 36,
            "ArrowLeft" => 37,
            "ArrowRight" => 39,
            "," => 188,
            "." => 190,
            _ => return Err(format!("no key `{key}` is known here")),
        };
        for kind in ["rawKeyDown", "keyUp"] {
            let event = json!({ "type": kind, "key": key, "windowsVirtualKeyCode": code });
            self.ask("Input.dispatchKeyEvent", &event)?;
        }
        Ok(())
    }

    /// The mouse at a place of the window: `mousePressed`, `mouseMoved` or `mouseReleased`, with the left button held or not.
    ///
    /// # Errors
    /// As of [`Browser::ask`].
    pub(super) fn mouse(&mut self, kind: &str, (x, y): (f64, f64), held: bool) -> Result {
        let button = if kind == "mouseMoved" && !held { "none" } else { "left" };
        let buttons = u8::from(held && kind != "mouseReleased");
        let event = json!({ "type": kind, "x": x, "y": y, "button": button, "buttons": buttons, "clickCount": 1 });
        self.ask("Input.dispatchMouseEvent", &event).map(|_| ())
    }

    /// A click in the middle of what a selector finds.
    ///
    /// # Errors
    /// There is no such thing; or as of [`Browser::ask`].
    pub(super) fn click(&mut self, selector: &str) -> Result {
        let middle = format!(
            "(() => {{ const box = document.querySelector('{selector}').getBoundingClientRect(); \
             return [box.left + box.width / 2, box.top + box.height / 2]; }})()"
        );
        let at = self.value(&middle)?;
        let at = (at[0].as_f64().unwrap_or(-1.0), at[1].as_f64().unwrap_or(-1.0));
        self.mouse("mouseMoved", at, false)?;
        self.mouse("mousePressed", at, true)?;
        self.mouse("mouseReleased", at, true)
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        // It ends by itself when its pipe does; what is in its way is of no use to anybody.
        _ = self.process.kill();
        _ = self.process.wait();
    }
}
