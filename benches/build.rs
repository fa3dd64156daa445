//! The linker script of the image; under the feature `c`, the charts in C, compiled as for a controller (`-Os`).

use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;

fn main() {
    let folder = PathBuf::from(variable("CARGO_MANIFEST_DIR"));
    let firmware = folder.join("../examples/firmware");
    println!("cargo:rerun-if-changed={}", firmware.join("memory.x").display());
    println!("cargo:rustc-link-search={}", firmware.display());
    println!("cargo:rustc-link-arg-bins=-Tlink.x");
    println!("cargo:rerun-if-changed=c");
    if env::var_os("CARGO_FEATURE_C").is_some() {
        compile(&folder.join("c"), &PathBuf::from(variable("OUT_DIR")));
    }
}

fn compile(sources: &Path, out: &Path) {
    let cpu = match variable("TARGET").as_str() {
        "thumbv6m-none-eabi" => "-mcpu=cortex-m0",
        "thumbv7m-none-eabi" => "-mcpu=cortex-m3",
        other => panic!("no compiler flags for {other}"),
    };
    let mut objects = Vec::new();
    for entry in sources.read_dir().expect("benches/c is a folder") {
        let source = entry.expect("benches/c is readable").path();
        if source.extension().is_some_and(|extension| extension == "c") {
            let object = out.join(source.with_extension("o").file_name().expect("a file"));
            let flags = ["-Os", "-std=c11", "-Wall", "-Wextra", "-Werror", "-mthumb", cpu];
            let sections = ["-ffunction-sections", "-fdata-sections", "-c"];
            let mut gcc = Command::new("arm-none-eabi-gcc");
            run(gcc.args(flags).args(sections).arg(&source).arg("-o").arg(&object));
            objects.push(object);
        }
    }
    let library = out.join("libcharts.a");
    _ = std::fs::remove_file(&library);
    run(Command::new("arm-none-eabi-ar").arg("crs").arg(library).args(objects));
    println!("cargo:rustc-link-search=native={}", out.display());
    println!("cargo:rustc-link-lib=static=charts");
    // gcc's helpers for a `switch` on Cortex-M0.
    let libgcc = Command::new("arm-none-eabi-gcc").args(["-mthumb", cpu, "-print-libgcc-file-name"]).output();
    let libgcc = String::from_utf8(libgcc.expect("gcc has just run").stdout).expect("a path");
    println!("cargo:rustc-link-arg-bins={}", libgcc.trim_end());
}

fn run(command: &mut Command) {
    let status = command.status().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    assert!(status.success(), "{command:?} ended with {status}");
}

fn variable(name: &str) -> String {
    env::var(name).unwrap_or_else(|_| panic!("cargo sets {name}"))
}
