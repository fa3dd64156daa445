//! The linker script of the image for the board; the source of the charts that follow a rule, as each author writes them;
//! under the features `c` and `tables`, the charts in C, compiled as for a controller (`-Os`).

mod machines;
mod par8;
mod rings;

use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Who writes charts: the name, what is written of a ring of so many steps, and of Par8.
type Author = (&'static str, fn(usize) -> String, fn() -> String);

/// The charts that are built, where not all are.
const CHARTS: &str = "GRAFCET_CHARTS";

fn main() {
    let folder = PathBuf::from(variable("CARGO_MANIFEST_DIR"));
    println!("cargo:rerun-if-changed=c");
    if variable("CARGO_CFG_TARGET_OS") == "none" {
        let firmware = folder.join("../examples/firmware");
        println!("cargo:rerun-if-changed={}", firmware.join("memory.x").display());
        println!("cargo:rustc-link-search={}", firmware.display());
        println!("cargo:rustc-link-arg-bins=-Tlink.x");
    }
    println!("cargo:rerun-if-env-changed={CHARTS}");
    match env::var(CHARTS) {
        Err(_) => println!("cargo:rustc-cfg=every_chart"),
        Ok(charts) => charts.split_whitespace().for_each(|chart| println!("cargo:rustc-cfg={chart}")),
    }
    let out = PathBuf::from(variable("OUT_DIR"));
    let authors: [Author; 4] = [
        ("generated", rings::generated, par8::generated),
        ("hand", rings::hand, par8::hand),
        ("smlang", rings::smlang, par8::smlang),
        ("statig", rings::statig, par8::statig),
    ];
    for (author, ring, par8) in authors {
        let rings: String = rings::STEPS.into_iter().map(ring).collect();
        write(&out.join(format!("{author}.rs")), &format!("{rings}{}", par8()));
    }
    write(&out.join("flags.rs"), &rings::flags(100));
    let headers = folder.join("c");
    if env::var_os("CARGO_FEATURE_C").is_some() {
        let mut sources = files(&headers);
        sources.extend(in_c(&out, rings::c, &par8::c()));
        compile(&sources, &headers, &out);
    }
    if env::var_os("CARGO_FEATURE_TABLES").is_some() {
        compile(&in_c(&out, rings::c_tables, &par8::c_tables()), &headers, &out);
    }
}

/// The charts that follow a rule.
fn in_c(out: &Path, ring: fn(usize) -> String, par8: &str) -> Vec<PathBuf> {
    let rings = rings::STEPS.into_iter().map(|steps| (format!("chain{steps}"), ring(steps)));
    let all = rings.chain([("par8".to_owned(), par8.to_owned())]);
    all.map(|(name, text)| write(&out.join(format!("{name}.c")), &text)).collect()
}

fn write(path: &Path, text: &str) -> PathBuf {
    fs::write(path, text).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    path.to_owned()
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = folder.read_dir().expect("benches/c is a folder");
    entries.map(|entry| entry.expect("benches/c is readable").path()).collect()
}

fn compile(sources: &[PathBuf], headers: &Path, out: &Path) {
    let compiler = Compiler::of(&variable("TARGET"));
    let mut objects = Vec::new();
    for source in sources {
        if source.extension().is_some_and(|extension| extension == "c") {
            let object = out.join(source.with_extension("o").file_name().expect("a file"));
            let flags = ["-Os", "-std=c11", "-Wall", "-Wextra", "-Werror", "-ffunction-sections", "-fdata-sections"];
            let mut cc = Command::new(compiler.cc);
            cc.args(compiler.flags).args(flags).arg("-I").arg(headers);
            run(cc.arg("-c").arg(source).arg("-o").arg(&object));
            objects.push(object);
        }
    }
    let library = out.join("libcharts.a");
    _ = std::fs::remove_file(&library);
    run(Command::new(compiler.ar).arg("crs").arg(library).args(objects));
    println!("cargo:rustc-link-search=native={}", out.display());
    println!("cargo:rustc-link-lib=static=charts");
    if variable("CARGO_CFG_TARGET_OS") == "none" {
        // gcc's helpers for a `switch` on Cortex-M0.
        let libgcc = Command::new(compiler.cc).args(compiler.flags).arg("-print-libgcc-file-name").output();
        let libgcc = String::from_utf8(libgcc.expect("gcc has just run").stdout).expect("a path");
        println!("cargo:rustc-link-arg-bins={}", libgcc.trim_end());
    }
}

/// What compiles C for a target.
struct Compiler {
    cc: &'static str,
    ar: &'static str,
    flags: &'static [&'static str],
}

impl Compiler {
    fn of(target: &str) -> Self {
        let arm = |flags| Self { cc: "arm-none-eabi-gcc", ar: "arm-none-eabi-ar", flags };
        match target {
            "thumbv6m-none-eabi" => arm(&["-mthumb", "-mcpu=cortex-m0"]),
            "thumbv7m-none-eabi" => arm(&["-mthumb", "-mcpu=cortex-m3"]),
            // As Rust's programs are there, wherever they are loaded to.
            host if host == variable("HOST") => Self { cc: "cc", ar: "ar", flags: &["-fPIE"] },
            other => panic!("no compiler flags for {other}"),
        }
    }
}

fn run(command: &mut Command) {
    let status = command.status().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    assert!(status.success(), "{command:?} ended with {status}");
}

fn variable(name: &str) -> String {
    env::var(name).unwrap_or_else(|_| panic!("cargo sets {name}"))
}
