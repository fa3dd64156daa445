//! Tasks of the project: `cargo xtask <task>`.

mod bench;
mod bless;
mod ci;
mod command;
mod conformance;
mod debian;
mod firmware;
mod first_chart;
mod fuzz;
mod image;
mod interface;
mod msrv;
mod packages;
mod page;
mod plant;
mod processor;
mod project;
mod record;
mod record_cost;
mod release;
mod screenshots;
mod toolchain;
mod web;

use std::process::ExitCode;

const USAGE: &str = "\
Usage: cargo xtask <task>

  bench     what generated charts cost on a controller, on the host and while building, beside hand-written ones and other
            crates: writes docs/cost.md, the README's table and the figures that CI compares with
  bench charts, bench builds
            the first half of it alone, and the second: how long building takes
  bench generated
            the generated charts alone measured anew, beside what is recorded of all others; writes the same
  bench cost
            the costs on a controller and on the host, shown and not written
  bench host
            the instructions on the host alone, counted by callgrind, shown and not written
  bench pinned
            whether the generated charts cost more than is recorded
  bench check [NAME]
            how long charts take to compile in a compiler without optimisation; only those whose name holds NAME
  bench through [CHART…] [--target m3|m0]
            the charts of the benches by way of a program and its passes: their costs beside those recorded; all but the longest
  bench beside CHART… [--target m3|m0]
            the same charts as the macro and as C have them, measured now
  brute [--charts N] [--first N] [--cycles N] [--shrink N]
            what the checker says about random charts, beside a naive exploration
  bless     record the expansions and messages anew that the tests compare with
  ci [STEP] every check that CI runs, with a summary; or one step of it
  conformance [--charts N] [--cycles N] [--seed N] [--dialect sfc|grafcet] [--number N] [--shrink N] [--recorded N]
            random charts, compiled through the macro, beside the interpreter; one in N also in a recorder, and restored at random moments
  conformance --program [--charts N] [--cycles N] [--seed N] [--dialect sfc|grafcet] [--number N]
            their programs beside the interpreter, without rustc
  firmware  build or check the example charts for all bare-metal targets, run them in QEMU, compare with the host
  first-chart
            follow docs/first-chart.md in a clean folder, command by command
  fuzz TARGET SECONDS [merge]
            the fuzzer of the folder `fuzz`, on stable Rust; with `merge` what it has found goes to the corpus
  interface [record]
            the public interfaces beside those in tests/interface (cargo-public-api), or records them anew
  packages  pack what is published, build it with the oldest dependencies allowed, and check sets of features
  packages all
            the same with all sets of features, and with lints
  page      the page of a replay in headless Chromium: its buttons, keys, slider and dragging show what its data says
  plant [WORD]
            plants faults into the runtime and the code generator, one by one, and tells which test of CI finds each; only
            those whose name holds WORD. An hour, or more
  prove FILE [--why] [--seconds N] [--aiger FILE] [--btor2 FILE]
            what the charts of a file claim, proved or refuted
  prove --random N [--first N] [--kind KIND] [--abc]
            the same of random charts, beside a naive exploration, and beside abc (berkeley-abc)
  record    run a chart with the flight recorder in QEMU, reset the board in the middle, and show from its record what happened
  record test RECORD SOURCE CHART FOLDER
            writes FOLDER/RECORD.rs, a test that replays this record of the chart CHART in the Rust file SOURCE
  record cost
            what the flight recorder costs in each example on both targets; writes the table of docs/record.md
  release   before a release: licences and advisories (cargo-deny), all sets of features, the interfaces as `interface` does and
            beside the last release (cargo-semver-checks)
  screenshots
            what rustdoc shows of the example charts, light and dark, for tests/screenshots (Chromium)
  soak CYCLES [--charts N] [--seconds N] [--seed N] [--dialect sfc|grafcet]
            random charts for a long time, with clocks that wrap around, on stretches of it beside the interpreter
  msrv      check the crates that ship with the oldest supported Rust
  web       the playground, as a folder that any web server can show: target/web (Node.js with npm)
  web test  builds it, plays the conformance corpus on its WebAssembly, and uses the page in headless Chromium
  web live  the live view of the emulated board in headless Chromium, which `web test` does, too
  web show  builds it and shows it on this machine, until Ctrl-C
";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let result = match arguments[..] {
        ["bench"] => bench::run(),
        ["bench", "builds"] => bench::builds(),
        ["bench", "charts"] => bench::charts(),
        ["bench", "generated"] => bench::generated(),
        ["bench", "cost"] => bench::cost(),
        ["bench", "host"] => bench::on_host(),
        ["bench", "pinned"] => bench::pinned(),
        ["bench", "check"] => bench::check(None),
        ["bench", "check", name] => bench::check(Some(name)),
        ["bench", "through", ref rest @ ..] => bench::through(rest),
        ["bench", "beside", ref rest @ ..] => bench::beside(rest),
        ["bless"] => bless::run(),
        ["brute", ref rest @ ..] => conformance::brute(rest),
        ["ci"] => ci::run(),
        ["ci", step] => ci::one(step),
        ["conformance", ref rest @ ..] => conformance::run(rest),
        ["firmware"] => firmware::run(),
        ["first-chart"] => first_chart::run(),
        ["fuzz", target, seconds] => fuzz::run(target, seconds, false),
        ["fuzz", target, seconds, "merge"] => fuzz::run(target, seconds, true),
        ["interface"] => interface::compare(),
        ["interface", "record"] => interface::record(),
        ["msrv"] => msrv::run(),
        ["packages"] => packages::run(),
        ["packages", "all"] => packages::all(),
        ["page"] => page::run(),
        ["plant"] => plant::run(None),
        ["plant", word] => plant::run(Some(word)),
        ["prove", ref rest @ ..] => conformance::prove(rest),
        ["record"] => record::run(),
        ["record", "test", record, source, chart, folder] => record::test(&[record, source, chart, folder]),
        ["record", "cost"] => record_cost::run(),
        ["release"] => release::run(),
        ["soak", cycles, ref rest @ ..] => conformance::run(&[&["--soak", cycles, "--shrink", "0"], rest].concat()),
        ["screenshots"] => screenshots::run(),
        ["web"] => web::run(),
        ["web", "test"] => web::test(),
        ["web", "live"] => web::live(),
        ["web", "show"] => web::show(),
        [] | ["help" | "-h" | "--help"] => {
            print!("{USAGE}");
            Ok(())
        }
        _ => Err(format!("there is no task `{}`\n\n{USAGE}", arguments.join(" "))),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}
