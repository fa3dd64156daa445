//! A source in a thread of its own: opened, read, and opened again where it was lost.

use std::io::{ErrorKind, Read};
use std::sync::Arc;
use std::thread;
use std::time::{Duration, Instant};

use super::follow::Follower;
use super::kept::Kept;
use super::place::{Opened, Place};
use super::texts::Texts;
use crate::complain;

/// So long it waits before it tries again, the first time and at most.
const PAUSE: [Duration; 2] = [Duration::from_millis(250), Duration::from_secs(4)];
/// So much is read at once at most.
const CHUNK: usize = 1 << 14;

/// A controller that runs none of the charts is compared with their files this often: somebody may have changed one.
const LOOK: Duration = Duration::from_secs(2);

/// Reads a source, as long as the program runs or the source has an end. What its charts are compiled to stays in the thread.
pub(crate) fn begin(place: Place, texts: Texts, kept: Arc<Kept>) {
    let reading = Reading { place, texts, kept, pause: PAUSE[0], looked: None };
    thread::spawn(move || reading.run());
}

/// A source that is read.
struct Reading {
    place: Place,
    texts: Texts,
    kept: Arc<Kept>,
    pause: Duration,
    /// When the files of the charts were looked at last.
    looked: Option<Instant>,
}

/// Why reading has stopped.
enum End {
    /// The source has ended, and how.
    Source(String),
    /// The charts are other ones by now.
    Charts,
}

impl Reading {
    fn run(mut self) {
        let mut opened = None;
        // As long as the charts are what they were.
        while self.follow(&mut opened) {
            complain(&format!("{}: the charts have changed, and were read again", self.kept.label));
        }
    }

    /// Follows the charts as they are, and says whether they are other ones by now; then the source stays open.
    fn follow(&mut self, opened: &mut Option<Opened>) -> bool {
        let charts = self.texts.compiled();
        let mut follower = Follower::new(&charts);
        loop {
            let source = match opened.take() {
                Some(source) => Ok(source),
                None => self.place.open().inspect(|_| say(&self.kept, "connected")),
            };
            let ended = match source {
                Ok(mut source) => {
                    if let (Some(way), Some(line)) = (&self.kept.way, source.write.take()) {
                        way.open(Some(line));
                    }
                    match self.read(&mut *source.read, &mut follower) {
                        End::Charts => {
                            *opened = Some(source);
                            return true;
                        }
                        End::Source(ended) => ended,
                    }
                }
                Err(error) => format!("cannot be opened: {error}"),
            };
            if let Some(way) = &self.kept.way {
                way.close();
            }
            follower.interrupted(&format!("the source {ended}"), &self.kept);
            if !self.place.comes_again() {
                say(&self.kept, &ended);
                return false;
            }
            say(&self.kept, &format!("{ended}; trying again"));
            thread::sleep(self.pause);
            self.pause = (self.pause * 2).min(PAUSE[1]);
        }
    }

    /// Reads up to the end.
    fn read(&mut self, source: &mut dyn Read, follower: &mut Follower<'_>) -> End {
        let mut bytes = vec![0; CHUNK];
        loop {
            match source.read(&mut bytes) {
                Ok(0) => return End::Source("has ended".to_owned()),
                Ok(count) => {
                    self.pause = PAUSE[0];
                    follower.bytes(&bytes[..count], &self.kept);
                    if follower.is_foreign() && self.have_changed() {
                        return End::Charts;
                    }
                }
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(error) => return End::Source(format!("was lost: {error}")),
            }
        }
    }

    /// Whether the charts are other ones by now, looked at now and then.
    fn have_changed(&mut self) -> bool {
        if self.looked.is_some_and(|looked| looked.elapsed() < LOOK) {
            return false;
        }
        self.looked = Some(Instant::now());
        self.texts.changed()
    }
}

/// How the line does, on the page and in the terminal.
fn say(kept: &Kept, state: &str) {
    let mut is_news = false;
    kept.line(|line| {
        is_news = line.state != state;
        state.clone_into(&mut line.state);
    });
    if is_news {
        complain(&format!("{}: {state}", kept.label));
    }
}
