//! A source in a thread of its own: opened, read, and opened again where it was lost.

use std::io::{ErrorKind, Read};
use std::sync::Arc;
use std::thread;
use std::time::Duration;

use grafcet_sim::Chart;

use super::follow::Follower;
use super::kept::Kept;
use super::place::Place;
use crate::complain;

/// So long it waits before it tries again, the first time and at most.
const PAUSE: [Duration; 2] = [Duration::from_millis(250), Duration::from_secs(4)];
/// So much is read at once at most.
const CHUNK: usize = 1 << 14;

/// Reads a source, as long as the program runs or the source has an end. `charts` are the texts of those that may run there: what they are compiled to
/// stays in the thread.
pub(crate) fn begin(place: Place, charts: Vec<String>, kept: Arc<Kept>) {
    thread::spawn(move || {
        let charts: Vec<Chart> = charts.iter().filter_map(|text| Chart::parse(text).ok()).collect();
        let mut follower = Follower::new(&charts);
        let mut pause = PAUSE[0];
        loop {
            let ended = match place.open() {
                Ok(mut opened) => {
                    if let Some(way) = &kept.way {
                        way.open(opened.write.take());
                    }
                    say(&kept, "connected");
                    read(&mut *opened.read, &mut follower, &kept, || pause = PAUSE[0])
                }
                Err(error) => format!("cannot be opened: {error}"),
            };
            if let Some(way) = &kept.way {
                way.close();
            }
            follower.interrupted(&format!("the source {ended}"), &kept);
            if !place.comes_again() {
                return say(&kept, &ended);
            }
            say(&kept, &format!("{ended}; trying again"));
            thread::sleep(pause);
            pause = (pause * 2).min(PAUSE[1]);
        }
    });
}

/// Reads up to the end, and says what that was.
fn read(source: &mut dyn Read, follower: &mut Follower<'_>, kept: &Kept, mut came: impl FnMut()) -> String {
    let mut bytes = vec![0; CHUNK];
    loop {
        match source.read(&mut bytes) {
            Ok(0) => return "has ended".to_owned(),
            Ok(count) => {
                came();
                follower.bytes(&bytes[..count], kept);
            }
            Err(error) if error.kind() == ErrorKind::Interrupted => {}
            Err(error) => return format!("was lost: {error}"),
        }
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
