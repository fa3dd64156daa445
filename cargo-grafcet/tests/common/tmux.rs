//! Terminals to play in.
#![allow(dead_code, reason = "each test needs a part of it")]

use std::path::{Path, PathBuf};
use std::process::Command;
use std::thread;
use std::time::{Duration, Instant};

/// A terminal with a program in it.
pub(crate) struct Tmux {
    socket: PathBuf,
}

impl Tmux {
    pub(crate) fn run(folder: &Path, columns: &str, rows: &str, command: &str) -> Self {
        let tmux = Self { socket: folder.join("socket") };
        let size = ["-x", columns, "-y", rows];
        let folder = folder.display().to_string();
        tmux.tell(&[&["-f", "/dev/null", "new-session", "-d", "-c", &folder], &size[..], &[command]].concat());
        tmux
    }

    /// # Panics
    /// There is no tmux, or it refuses.
    pub(crate) fn tell(&self, words: &[&str]) -> String {
        let mut command = Command::new("tmux");
        let done = command.arg("-u").arg("-S").arg(&self.socket).args(words).output();
        let done = done.unwrap_or_else(|error| panic!("tmux: {error}; on Debian `apt-get install tmux`"));
        assert!(done.status.success(), "tmux {words:?}: {}", String::from_utf8_lossy(&done.stderr));
        String::from_utf8_lossy(&done.stdout).into_owned()
    }

    /// Waits for this screen.
    pub(crate) fn shows(&self, wanted: &str) {
        let begin = Instant::now();
        loop {
            let screen = self.tell(&["capture-pane", "-p"]);
            if screen.trim_end() == wanted.trim_end() {
                return;
            }
            assert!(begin.elapsed() < Duration::from_secs(60), "wanted:\n{wanted}\nthere is:\n{screen}");
            thread::sleep(Duration::from_millis(50));
        }
    }

    /// Waits for a screen with these words.
    pub(crate) fn comes_to(&self, words: &str) -> String {
        let begin = Instant::now();
        loop {
            let screen = self.tell(&["capture-pane", "-p"]);
            if screen.contains(words) {
                return screen;
            }
            assert!(begin.elapsed() < Duration::from_secs(60), "wanted: {words}\nthere is:\n{screen}");
            thread::sleep(Duration::from_millis(50));
        }
    }

    pub(crate) fn keys(&self, keys: &[&str]) {
        self.tell(&[&["send-keys"], keys].concat());
    }
}

impl Drop for Tmux {
    fn drop(&mut self) {
        // It may have ended with its program.
        _ = Command::new("tmux").arg("-S").arg(&self.socket).arg("kill-server").output();
    }
}
