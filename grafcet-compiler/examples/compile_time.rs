//! How long one chart takes to compile, and how much memory: `cargo xtask bench check` runs this once a chart.
//!
//! The argument is a file with the tokens of one macro call. Prints the milliseconds, the peak of the memory in KiB (0 where
//! the system does not tell it) and the names of the rules that spoke, or `-`.

use std::process::ExitCode;
use std::time::Instant;

use proc_macro2::TokenStream;
use quote::quote;

fn main() -> ExitCode {
    let Some(file) = std::env::args().nth(1) else {
        eprintln!("usage: compile_time FILE");
        return ExitCode::FAILURE;
    };
    let tokens = std::fs::read_to_string(&file)
        .map_err(|error| error.to_string())
        .and_then(|text| text.parse::<TokenStream>().map_err(|error| error.to_string()));
    let tokens = match tokens {
        Ok(tokens) => tokens,
        Err(error) => {
            eprintln!("{file}: {error}");
            return ExitCode::FAILURE;
        }
    };
    // rustc hands the macro tokens: making them of text is not its work.
    let start = Instant::now();
    let code = grafcet_compiler::compile(&quote!(::grafcet), tokens);
    let time = start.elapsed();
    println!("{} {} {}", time.as_millis(), peak(), said(&code.to_string()));
    ExitCode::SUCCESS
}

fn peak() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    line.and_then(|line| line.split_whitespace().next()).and_then(|kib| kib.parse().ok()).unwrap_or(0)
}

fn said(code: &str) -> String {
    let mut rules: Vec<&str> =
        code.split("[grafcet::").skip(1).filter_map(|rest| rest.split_once(']').map(|(rule, _)| rule)).collect();
    if rules.is_empty() && code.contains("compile_error") {
        rules.push("notation");
    }
    rules.sort_unstable();
    rules.dedup();
    if rules.is_empty() { "-".to_owned() } else { rules.join(",") }
}
