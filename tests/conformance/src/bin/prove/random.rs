//! Random charts of each kind, on all processors.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use grafcet_conformance::prove::{Bounds, Counts, Kind, number, remembering, text};
use grafcet_conformance::with_plants;

use super::Options;

/// What is drawn: the name, and whether it is a `grafcet`.
#[derive(Clone, Copy)]
enum Drawn {
    Plain {
        timed: bool,
    },
    /// Properties with edges and delays.
    Remembering,
    Plants,
}

const DRAWN: [(&str, Drawn); 4] = [
    ("plain", Drawn::Plain { timed: false }),
    ("remembering", Drawn::Remembering),
    ("times", Drawn::Plain { timed: true }),
    ("plants", Drawn::Plants),
];

/// So many charts of each kind; whether none differs.
pub(super) fn all(charts: u64, options: &Options) -> Result<bool, String> {
    let mut same = true;
    let mut found = false;
    for (kind, drawn) in DRAWN {
        for (grafcet, dialect) in [(false, "sfc"), (true, "grafcet")] {
            let name = format!("{dialect} {kind}");
            if options.kind.as_ref().is_none_or(|asked| asked == kind || *asked == name) {
                found = true;
                same &= of_kind(&name, drawn, grafcet, (charts, options));
            }
        }
    }
    let kinds = || DRAWN.map(|(kind, _)| kind).join(", ");
    if found { Ok(same) } else { Err(format!("--kind takes one of {}, with `sfc ` or `grafcet ` in front", kinds())) }
}

/// The charts of one kind; whether none differs.
fn of_kind(name: &str, drawn: Drawn, grafcet: bool, (charts, options): (u64, &Options)) -> bool {
    let bounds = Bounds { cycles: options.cycles, time: options.time.unwrap_or(Duration::from_secs(20)) };
    let (next, done, same) = (AtomicU64::new(options.first), AtomicUsize::new(0), AtomicBool::new(true));
    let (all, start) = (Mutex::new(Counts::default()), Instant::now());
    let work = || {
        while (done.load(Ordering::Relaxed) as u64) < charts {
            let (chart, mut counts, before) = (next.fetch_add(1, Ordering::Relaxed), Counts::default(), Instant::now());
            let compared = match drawn {
                Drawn::Plain { timed } => {
                    let kind = Kind { grafcet, timed, several: true, abc: options.abc };
                    number(chart, kind, bounds, &mut counts)
                }
                Drawn::Remembering => remembering(chart, grafcet, bounds, &mut counts),
                Drawn::Plants => with_plants::number(chart, grafcet, bounds, &mut counts),
            };
            if let Err(difference) = compared {
                println!("{name}: {difference}");
                same.store(false, Ordering::Relaxed);
            }
            if options.show && counts.charts > 0 {
                if let (Drawn::Plain { timed }, false) = (drawn, counts.undecided.is_empty()) {
                    let kind = Kind { grafcet, timed, several: true, abc: options.abc };
                    println!("{:?}\n{}", counts.undecided, text(chart, kind));
                }
                println!("{name} {chart}: {} properties, {:.1} s", counts.properties(), before.elapsed().as_secs_f64());
            }
            done.fetch_add(counts.charts, Ordering::Relaxed);
            all.lock().unwrap_or_else(std::sync::PoisonError::into_inner).add(counts);
        }
    };
    std::thread::scope(|scope| {
        let processors = std::thread::available_parallelism().map_or(1, usize::from);
        for _ in 0..options.jobs.unwrap_or(processors) {
            scope.spawn(work);
        }
    });
    let counts = all.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
    let (last, seconds) = (next.into_inner(), start.elapsed().as_secs_f64());
    println!("{name}: {} properties, the next chart is {last}, {seconds:.0} s: {counts:?}", counts.properties());
    same.into_inner()
}
