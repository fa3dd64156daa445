//! Builds the charts of every author and measures them.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use super::{AUTHORS, Cost, Row};
use crate::command::{Result, capture, capture_within, find, run};
use crate::project;
use crate::toolchain::BareMetal;

/// The root that keeps nothing.
const NOTHING: &str = "nothing_root";

/// An image ends within seconds; one that has not by then hangs.
const LIMIT: Duration = Duration::from_secs(120);

/// What the image prints about one chart.
#[derive(Debug, PartialEq, Eq)]
struct Count {
    chart: String,
    dialect: String,
    hash: u32,
    busy: u32,
    idle: u32,
    ram: u32,
}

/// All charts, as every author wrote them, for one target.
pub(super) fn all(target: &str) -> Result<Vec<Row>> {
    let toolchain = BareMetal::find(target)?;
    println!("size: {target}, {}", toolchain.describe());
    let mut rows: Vec<Row> = Vec::new();
    for (author, name) in AUTHORS.into_iter().enumerate() {
        for (i, (chart, cost)) in costs(&toolchain, target, name)?.into_iter().enumerate() {
            if author == 0 {
                rows.push(Row { name: chart, costs: [cost; AUTHORS.len()] });
                continue;
            }
            let row = rows.get_mut(i).filter(|row| row.name == chart);
            row.ok_or_else(|| format!("only `{name}` has the chart {chart}"))?.costs[author] = cost;
        }
    }
    Ok(rows)
}

/// Every chart of one author.
fn costs(toolchain: &BareMetal, target: &str, author: &str) -> Result<Vec<(String, Cost)>> {
    let linker = Linker::new(target, author)?;
    build(toolchain, target, author, &["--bin", "count"])?;
    let counts = count(&linker.folder.join("count"))?;
    build(toolchain, target, author, &["--lib", "--crate-type", "staticlib"])?;
    let nothing = linker.bytes(NOTHING)?;
    let cost = |count: Count| {
        let Count { chart, dialect, hash, busy, idle, ram } = count;
        let flash = linker.bytes(&format!("{chart}_{dialect}"))? - nothing;
        Ok((format!("{chart} {dialect}"), Cost { hash, flash, busy, idle, ram }))
    };
    counts.into_iter().map(cost).collect()
}

fn build(toolchain: &BareMetal, target: &str, author: &str, what: &[&str]) -> Result {
    let mut command = toolchain.cargo("rustc", target);
    command.args(["--quiet", "--locked", "--release", "--manifest-path", "benches/Cargo.toml", "--features", author]);
    run(command.args(what).arg("--target-dir").arg(project::target("size")))
}

/// Runs the image that counts.
fn count(image: &Path) -> Result<Vec<Count>> {
    let qemu = tool("qemu-system-arm", "qemu-system-arm")?;
    let mut command = Command::new(qemu);
    // Without counters of time, every instruction takes the same time.
    command.args(["-cpu", "cortex-m3", "-machine", "lm3s6965evb", "-nographic", "-icount", "shift=0"]);
    command.args(["-semihosting-config", "enable=on,target=native", "-kernel"]).arg(image);
    let lines = capture_within(&mut command, LIMIT)?;
    let counts: Vec<Count> = lines.lines().map(parse).collect::<Result<_>>()?;
    match counts.len() {
        0 => Err(format!("{} counted nothing", image.display())),
        _ => Ok(counts),
    }
}

/// `motor sfc 811c9dc5 53248 49152 1`
fn parse(line: &str) -> Result<Count> {
    let count = || {
        let [chart, dialect, hash, busy, idle, ram] = line.split(' ').collect::<Vec<_>>()[..] else { return None };
        Some(Count {
            chart: chart.to_owned(),
            dialect: dialect.to_owned(),
            hash: u32::from_str_radix(hash, 16).ok()?,
            busy: busy.parse().ok()?,
            idle: idle.parse().ok()?,
            ram: ram.parse().ok()?,
        })
    };
    count().ok_or_else(|| format!("not a count: {line}"))
}

/// Links the cycle function of one chart with all it needs and nothing else.
struct Linker {
    /// Where the build puts its results.
    folder: PathBuf,
    image: PathBuf,
    libgcc: String,
}

impl Linker {
    fn new(target: &str, author: &str) -> Result<Self> {
        let cpu = if target.starts_with("thumbv6m") { "-mcpu=cortex-m0" } else { "-mcpu=cortex-m3" };
        let gcc = tool("arm-none-eabi-gcc", "gcc-arm-none-eabi")?;
        let libgcc = capture(Command::new(gcc).args(["-mthumb", cpu, "-print-libgcc-file-name"]))?;
        let folder = project::target("size").join(target).join("release");
        let image = folder.join(format!("{author}.elf"));
        Ok(Self { folder, image, libgcc: libgcc.trim_end().to_owned() })
    }

    /// The code and constants that a root keeps, in bytes.
    fn bytes(&self, root: &str) -> Result<u32> {
        let ld = tool("arm-none-eabi-ld", "binutils-arm-none-eabi")?;
        let mut command = Command::new(ld);
        // A file without a stack section is no concern of a controller.
        command.args(["--gc-sections", "--no-warn-execstack", "--entry", root, "--require-defined", root]);
        command.arg("-o").arg(&self.image).arg(self.folder.join("libgrafcet_benches.a")).arg(&self.libgcc);
        run(&mut command)?;
        let nm = tool("arm-none-eabi-nm", "binutils-arm-none-eabi")?;
        if let Some(symbol) = panics(&capture(Command::new(nm).arg(&self.image))?) {
            return Err(format!("{root} can panic: it reaches `{symbol}`"));
        }
        let size = tool("arm-none-eabi-size", "binutils-arm-none-eabi")?;
        sum(&capture(Command::new(size).arg("-A").arg(&self.image))?)
    }
}

/// The sizes of the sections of code and constants in what `size -A` prints.
fn sum(sections: &str) -> Result<u32> {
    let kept = |line: &&str| [".text", ".rodata"].iter().any(|name| line.starts_with(name));
    let bytes = |line: &str| line.split_whitespace().nth(1).and_then(|bytes| bytes.parse::<u32>().ok());
    let sizes: Option<Vec<u32>> = sections.lines().filter(kept).map(bytes).collect();
    match sizes {
        Some(sizes) if !sizes.is_empty() => Ok(sizes.iter().sum()),
        _ => Err(format!("no sections of code in\n{sections}")),
    }
}

/// The first symbol of the panic machinery in what `nm` prints.
fn panics(symbols: &str) -> Option<&str> {
    let mut names = symbols.lines().filter_map(|line| line.split_whitespace().last());
    names.find(|name| ["panic", "unwrap_failed", "expect_failed", "slice_index"].iter().any(|p| name.contains(p)))
}

fn tool(name: &str, package: &str) -> Result<PathBuf> {
    find(name).ok_or_else(|| format!("{name} is not in the PATH; on Debian `apt-get install {package}`"))
}

#[cfg(test)]
mod tests {
    use super::{Count, panics, parse, sum};

    #[test]
    fn a_line_of_the_image() {
        let count = Count {
            chart: "motor".to_owned(),
            dialect: "sfc".to_owned(),
            hash: 0x811c_9dc5,
            busy: 53248,
            idle: 49152,
            ram: 1,
        };
        assert_eq!(parse("motor sfc 811c9dc5 53248 49152 1"), Ok(count));
        assert_eq!(parse("panicked at 3"), Err("not a count: panicked at 3".to_owned()));
    }

    #[test]
    fn panic_machinery_is_found() {
        let cycle = "00008000 T _RNvMs0_5chart5cycle\n00010000 D motor_sfc\n";
        assert_eq!(panics(cycle), None);
        let reached = format!("{cycle}00008040 t _RNvNtCs4core9panicking18panic_bounds_check\n");
        assert_eq!(panics(&reached), Some("_RNvNtCs4core9panicking18panic_bounds_check"));
    }

    #[test]
    fn code_and_constants_are_summed() {
        let sections = "a.elf  :\nsection           size    addr\n.text               64   32768\n\
                        .rodata              8   32832\n.data                4   65536\n.comment            75       0\n";
        assert_eq!(sum(sections), Ok(72));
        assert!(sum("a.elf  :\n.data 4 0\n").is_err());
    }
}
