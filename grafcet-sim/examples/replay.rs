//! What a chart does with a script, as a table, a waveform, a chronogram and a page.
//!
//! `cargo run -p grafcet-sim --example replay -- examples/charts/cell.rs Cell examples/charts/cell.script target/cell` writes
//! `target/cell.vcd`, `.svg`, `.html` and `.info`, and prints the table and what was covered.

use std::error::Error;
use std::fs;

use grafcet_sim::{Chart, Simulation, Trace, chronogram, page, script, table, vcd};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [file, name, cycles, out] = &arguments[..] else {
        return Err("usage: replay FILE.rs CHART FILE.script OUT".into());
    };
    let chart = Chart::in_file(&fs::read_to_string(file)?, name)?;
    let cycles = script(chart.names(), &fs::read_to_string(cycles)?)?;
    let trace = Trace::play(&mut Simulation::new(&chart)?, &cycles)?;
    print!("{}\n{}", table(&trace), trace.coverage);
    vcd(&trace, fs::File::create(format!("{out}.vcd"))?)?;
    fs::write(format!("{out}.svg"), chronogram(&trace))?;
    fs::write(format!("{out}.html"), page(&chart, &trace))?;
    fs::write(format!("{out}.info"), trace.coverage.lcov(file))?;
    Ok(())
}
