//! One page that looks. It gets what it has not seen, a message at a time: where it is slow, there is less and less new for it to get, and in the end it is
//! let go. So nothing waits for it in memory but the one message.

use std::sync::Arc;
use std::time::Duration;

use axum::extract::ws::{CloseFrame, Message, WebSocket, WebSocketUpgrade, close_code};
use serde_json::json;
use tokio::time::{Instant, timeout, timeout_at};

use super::kept::Seen;
use super::server::Site;
use super::steer::Asked;

/// So often it gets what is new.
const TICK: Duration = Duration::from_millis(50);
/// Who does not take a message in this time, does not look any more.
const PATIENCE: Duration = Duration::from_secs(10);
/// A line that says nothing is asked whether it is still there.
const SILENCE: Duration = Duration::from_secs(15);
/// The page has little to say.
const LONGEST_WORD: usize = 4096;

/// With limits on what the page may send.
pub(crate) fn limited(socket: WebSocketUpgrade) -> WebSocketUpgrade {
    socket.max_message_size(LONGEST_WORD).max_frame_size(LONGEST_WORD)
}

/// Shows everything to a page, until it goes.
pub(crate) async fn show(mut socket: WebSocket, site: &Arc<Site>) {
    let labels: Vec<&str> = site.sources.iter().map(|source| &*source.label).collect();
    if !send(&mut socket, Message::from(json!({ "sources": labels, "steers": site.steers }).to_string())).await {
        return;
    }
    let mut seen: Vec<Seen> = site.sources.iter().map(|_| Seen::default()).collect();
    let mut said = Instant::now();
    loop {
        let next = Instant::now() + TICK;
        let mut more = false;
        for (place, (source, seen)) in site.sources.iter().zip(&mut seen).enumerate() {
            let Some((news, has_more)) = source.news(place, seen) else { continue };
            more |= has_more;
            said = Instant::now();
            if !send(&mut socket, Message::from(news)).await {
                return;
            }
        }
        if said.elapsed() > SILENCE {
            said = Instant::now();
            if !send(&mut socket, Message::Ping(Vec::new().into())).await {
                return;
            }
        }
        if !more && !listen(&mut socket, site, next).await {
            return;
        }
    }
}

/// Whether the page has taken it.
async fn send(socket: &mut WebSocket, message: Message) -> bool {
    matches!(timeout(PATIENCE, socket.send(message)).await, Ok(Ok(())))
}

/// Takes what the page says until then, and says whether it is still there.
async fn listen(socket: &mut WebSocket, site: &Arc<Site>, until: Instant) -> bool {
    loop {
        match timeout_at(until, socket.recv()).await {
            Err(_) => return true,
            Ok(Some(Ok(Message::Ping(_) | Message::Pong(_)))) => {}
            Ok(Some(Ok(Message::Text(text)))) if site.steers => match Asked::read(&text) {
                Some(asked) if asked.source < site.sources.len() => {
                    let source = asked.source;
                    if let Err(why) = steer(site, asked).await {
                        let refused = json!({ "source": source, "refused": why });
                        if !send(socket, Message::from(refused.to_string())).await {
                            return false;
                        }
                    }
                }
                _ => return hang_up(socket, "this is no command").await,
            },
            Ok(Some(Ok(Message::Text(_)))) => return hang_up(socket, "this page only looks").await,
            // Whatever else it says is none of ours.
            Ok(_) => return false,
        }
    }
}

/// Sends a command. The line may take its time: others are shown what happens meanwhile.
async fn steer(site: &Arc<Site>, asked: Asked) -> Result<(), String> {
    let site = Arc::clone(site);
    let done = tokio::task::spawn_blocking(move || match site.sources.get(asked.source) {
        Some(source) => source.steer(&asked),
        None => Err("there is no such source".to_owned()),
    });
    done.await.unwrap_or_else(|error| Err(error.to_string()))
}

/// Lets a page go that says what it may not.
async fn hang_up(socket: &mut WebSocket, reason: &'static str) -> bool {
    let close = CloseFrame { code: close_code::POLICY, reason: reason.into() };
    send(socket, Message::Close(Some(close))).await;
    false
}
