//! Makes a test of a record: `record_test RECORD SOURCE CHART FOLDER` writes `FOLDER/RECORD.rs`, beside it the record and what the chart shows in it.
//! `cargo xtask record test` calls it.
//!
//! `RECORD` is the memory of a recorder, what came over a wire, or the text in which the emulated board sends its record.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use grafcet_sim::{Chart, Replay, test_of_record};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [record, source, chart, folder] = &arguments[..] else {
        return Err("record_test RECORD SOURCE CHART FOLDER".into());
    };
    let name = Path::new(record).file_stem().and_then(|stem| stem.to_str()).ok_or("the record has no name")?;
    if !name.chars().all(|letter| letter.is_ascii_alphanumeric() || letter == '_') {
        return Err(format!("`{name}` becomes the name of a function: letters, digits and `_`").into());
    }
    let read = fs::read(record).map_err(|error| format!("{record}: {error}"))?;
    let bytes = std::str::from_utf8(&read).ok().and_then(sent).unwrap_or(read);
    let text = fs::read_to_string(source).map_err(|error| format!("{source}: {error}"))?;
    let trace = Replay::new().run_any(&Chart::in_file(&text, chart)?, &bytes)?;
    if trace.cycles.is_empty() {
        return Err(format!("nothing of the record can be run from the source: {}", trace.warnings.join("; ")).into());
    }
    trace.warnings.iter().for_each(|warning| eprintln!("warning: {warning}"));
    let folder = Path::new(folder);
    fs::create_dir_all(folder)?;
    let file = |ending: &str| folder.join(format!("{name}.{ending}"));
    fs::write(file("record"), bytes)?;
    fs::write(file("expected"), trace.outside())?;
    fs::write(file("rs"), test_of_record(name, &from(folder, Path::new(source))?, chart))?;
    println!("{}: {} cycles", file("rs").display(), trace.cycles.len());
    Ok(())
}

/// The bytes in lines `record 4752…`.
fn sent(text: &str) -> Option<Vec<u8>> {
    let digits: Vec<u8> = text.lines().filter_map(|line| line.strip_prefix("record ")).flat_map(str::bytes).collect();
    let byte = |pair: &[u8]| u8::from_str_radix(std::str::from_utf8(pair).ok()?, 16).ok();
    let bytes: Option<Vec<u8>> = digits.chunks(2).map(byte).collect();
    bytes.filter(|bytes| !bytes.is_empty())
}

/// The way to a file from a folder.
fn from(folder: &Path, file: &Path) -> Result<String, Box<dyn Error>> {
    let (folder, file) = (folder.canonicalize()?, file.canonicalize()?);
    let same = folder.components().zip(file.components()).take_while(|(a, b)| a == b).count();
    let up = folder.components().skip(same).map(|_| Path::new(".."));
    let way: PathBuf =
        up.map(Path::to_owned).chain(file.components().skip(same).map(|one| one.as_os_str().into())).collect();
    Ok(way.to_str().ok_or("a path that is no text")?.replace('\\', "/"))
}
