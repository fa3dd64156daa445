//! `cargo grafcet watch`: controllers that run, in the browser.
//!
//! - `place`, `source`: where bytes come from; each source is read in a thread of its own
//! - `texts`: the charts that may run there, read again where their files have changed
//! - `follow`: from bytes to moments, by the decoder of the runtime and the interpreter
//! - `kept`: the last moments of a source, in bounded memory
//! - `steer`: the way back to the controller, with `--steer`
//! - `server`, `viewer`: the page on 127.0.0.1, and what each of those who look at it gets
//! - `page/`: the page, plain modules of JavaScript without a build; what it shares with the playground lies here, as an installed tool brings it along

pub(crate) mod args;
mod follow;
mod kept;
mod place;
mod server;
mod source;
mod steer;
#[cfg(test)]
mod tests;
mod texts;
mod viewer;

use std::net::Ipv4Addr;
use std::sync::Arc;

use crate::find::{self, Found};
use crate::{Failure, Outcome, complain, replay, say};

use args::Watch;
use kept::Kept;
use place::{Place, Wanted};
use server::Site;
use steer::Controller;
use texts::Texts;

pub(crate) fn run(options: &Watch) -> Result<Outcome, Failure> {
    if options.sources.iter().filter(|wanted| wanted.place == Place::Input).count() > 1 {
        return Err(Failure::Said("the input of the program can be one source alone".to_owned()));
    }
    if let Some(wanted) = options.sources.iter().find(|wanted| options.steer && !wanted.place.leads_back()) {
        return Err(Failure::Said(format!(
            "--steer needs a line that leads back to the controller, and {} does not: give tcp:HOST:PORT or serial:PORT",
            wanted.place
        )));
    }
    let found = find::charts(&options.charts())?;
    let chosen = options.sources.iter().map(|wanted| chosen(wanted, &found)).collect::<Result<Vec<_>, _>>()?;
    // A chart that cannot be run is said, and the others can.
    let running: Vec<&Found> = found.iter().filter(|chart| replay::chart(chart).is_some()).collect();
    if running.is_empty() {
        return Ok(Outcome::Wrong);
    }
    let failed = |error: std::io::Error| Failure::Said(format!("the page cannot be served: {error}"));
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().map_err(failed)?;
    let token = server::token().map_err(|error| Failure::Said(format!("there is no token for the page: {error}")))?;
    runtime.block_on(async {
        let listener = tokio::net::TcpListener::bind((Ipv4Addr::LOCALHOST, options.port)).await.map_err(failed)?;
        let port = listener.local_addr().map_err(failed)?.port();
        say(&format!("http://127.0.0.1:{port}/{token}/\n"))?;
        if options.steer {
            complain("steering: whoever has this address can move the machine");
        }
        let sources = options.sources.iter().zip(chosen).map(|(wanted, name)| {
            let texts = Texts::of(options.charts(), name, &found, &running);
            let kept = Arc::new(Kept::new(
                wanted.place.to_string(),
                options.keep as usize,
                options.steer.then(Controller::default),
            ));
            source::begin(wanted.place.clone(), texts, Arc::clone(&kept));
            kept
        });
        let site = Site::new(sources.collect(), token, port, options.steer);
        server::serve(listener, Arc::new(site)).await.map_err(failed)
    })?;
    Ok(Outcome::Well)
}

/// The chart that is said to run at a source.
fn chosen<'w>(wanted: &'w Wanted, charts: &[Found]) -> Result<Option<&'w str>, Failure> {
    let Some(name) = wanted.chart.as_deref() else { return Ok(None) };
    if charts.iter().any(|chart| chart.name == name) {
        return Ok(Some(name));
    }
    let mut others: Vec<String> = charts.iter().map(|chart| format!("`{}`", chart.name)).collect();
    others.truncate(8);
    Err(Failure::Said(format!("{name}={}: there is no chart `{name}`, but {}", wanted.place, others.join(", "))))
}
