//! The page's server: on this machine alone, for whoever has the token, and nothing but the page, its files and its socket.

use std::sync::Arc;

use axum::Router;
use axum::body::Body;
use axum::extract::State;
use axum::extract::ws::WebSocketUpgrade;
use axum::extract::ws::rejection::WebSocketUpgradeRejection;
use axum::http::{HeaderMap, HeaderValue, StatusCode, Uri, header};
use axum::response::{IntoResponse, Response};
use axum::routing::get;
use constant_time_eq::constant_time_eq;
use tokio::net::TcpListener;
use tokio::sync::Semaphore;

use super::kept::Kept;
use super::viewer;

/// So many viewers at once.
pub(crate) const VIEWERS: usize = 64;
/// The page and its files, with what they are.
const FILES: [(&str, &str, &str); 10] = [
    ("", "text/html; charset=utf-8", include_str!("page/index.html")),
    ("live.js", JAVASCRIPT, include_str!("page/live.js")),
    ("chronogram.js", JAVASCRIPT, include_str!("page/chronogram.js")),
    ("drawing.js", JAVASCRIPT, include_str!("page/drawing.js")),
    ("rich.js", JAVASCRIPT, include_str!("page/rich.js")),
    ("signals.js", JAVASCRIPT, include_str!("page/signals.js")),
    ("steering.js", JAVASCRIPT, include_str!("page/steering.js")),
    ("theme.js", JAVASCRIPT, include_str!("page/theme.js")),
    ("style.css", "text/css; charset=utf-8", include_str!("page/style.css")),
    ("icon.svg", "image/svg+xml", include_str!("page/icon.svg")),
];
const JAVASCRIPT: &str = "text/javascript; charset=utf-8";
/// What every answer says of itself: the page may load its own files and open its own socket, nothing may frame it, and nobody learns its address from it.
const HEADERS: [(header::HeaderName, &str); 5] = [
    (
        header::CONTENT_SECURITY_POLICY,
        "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; connect-src 'self'; base-uri 'none'; \
         form-action 'none'; frame-ancestors 'none'",
    ),
    (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
    (header::REFERRER_POLICY, "no-referrer"),
    (header::CACHE_CONTROL, "no-store"),
    (header::HeaderName::from_static("cross-origin-resource-policy"), "same-origin"),
];

/// What is served.
pub(crate) struct Site {
    pub(crate) sources: Vec<Arc<Kept>>,
    pub(crate) token: String,
    pub(crate) port: u16,
    /// Whether a page may steer.
    pub(crate) steers: bool,
    pub(crate) seats: Arc<Semaphore>,
}

impl Site {
    pub(crate) fn new(sources: Vec<Arc<Kept>>, token: String, port: u16, steers: bool) -> Self {
        Self { sources, token, port, steers, seats: Arc::new(Semaphore::new(VIEWERS)) }
    }

    /// Whether this is how the browser calls this server: any other name is a foreign page's, which has let it lead here.
    fn is_own(&self, host: &[u8]) -> bool {
        ["127.0.0.1", "localhost"].iter().any(|name| host == format!("{name}:{}", self.port).as_bytes())
    }

    /// What stands after the token in a path.
    fn after_token<'p>(&self, path: &'p str) -> Option<&'p str> {
        let (token, rest) = path.strip_prefix('/')?.split_once('/')?;
        // How long it takes says nothing of where they differ.
        constant_time_eq(token.as_bytes(), self.token.as_bytes()).then_some(rest)
    }
}

/// A word that nobody can guess: 128 bits.
///
/// # Errors
/// The system has no randomness.
pub(crate) fn token() -> Result<String, getrandom::Error> {
    let mut bytes = [0; 16];
    getrandom::fill(&mut bytes)?;
    Ok(format!("{:032x}", u128::from_ne_bytes(bytes)))
}

/// Serves until the program ends.
///
/// # Errors
/// The system takes the port away.
pub(crate) async fn serve(listener: TcpListener, site: Arc<Site>) -> std::io::Result<()> {
    axum::serve(listener, Router::new().fallback_service(get(answer).with_state(site))).await
}

async fn answer(
    State(site): State<Arc<Site>>,
    uri: Uri,
    headers: HeaderMap,
    socket: Result<WebSocketUpgrade, WebSocketUpgradeRejection>,
) -> Response {
    let mut response = answered(site, &uri, &headers, socket);
    for (name, value) in HEADERS {
        response.headers_mut().insert(name, HeaderValue::from_static(value));
    }
    response
}

fn answered(
    site: Arc<Site>,
    uri: &Uri,
    headers: &HeaderMap,
    socket: Result<WebSocketUpgrade, WebSocketUpgradeRejection>,
) -> Response {
    let refused = |status: StatusCode, text: &'static str| (status, text).into_response();
    let mut hosts = headers.get_all(header::HOST).iter();
    let is_own = hosts.next().is_some_and(|host| site.is_own(host.as_bytes())) && hosts.next().is_none();
    if !is_own {
        return refused(StatusCode::FORBIDDEN, "this server answers for 127.0.0.1 alone\n");
    }
    let origin = headers.get(header::ORIGIN).map(HeaderValue::as_bytes);
    let is_same = origin.map(|origin| origin.strip_prefix(b"http://").is_some_and(|host| site.is_own(host)));
    if is_same == Some(false) {
        return refused(StatusCode::FORBIDDEN, "this server answers its own page alone\n");
    }
    let Some(path) = site.after_token(uri.path()) else {
        return refused(StatusCode::NOT_FOUND, "there is nothing here\n");
    };
    if path == "socket" {
        // Every browser says which page opens a socket.
        let (Ok(socket), Some(true)) = (socket, is_same) else {
            return refused(StatusCode::FORBIDDEN, "the socket is for the page alone\n");
        };
        let Ok(seat) = Arc::clone(&site.seats).try_acquire_owned() else {
            return refused(StatusCode::SERVICE_UNAVAILABLE, "too many pages look at this\n");
        };
        return viewer::limited(socket).on_upgrade(move |socket| async move {
            viewer::show(socket, &site).await;
            drop(seat);
        });
    }
    let file = FILES.iter().find(|(name, ..)| *name == path);
    file.map_or_else(
        || refused(StatusCode::NOT_FOUND, "there is nothing here\n"),
        |(_, kind, text)| ([(header::CONTENT_TYPE, *kind)], Body::from(*text)).into_response(),
    )
}
