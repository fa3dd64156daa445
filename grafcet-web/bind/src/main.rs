//! Writes the JavaScript beside a module of WebAssembly, as the program `wasm-bindgen` does: `grafcet-web-bind MODULE.wasm FOLDER`.
#![forbid(unsafe_code)]

use std::process::ExitCode;

use wasm_bindgen_cli_support::Bindgen;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [module, folder] = &arguments[..] else {
        eprintln!("usage: grafcet-web-bind MODULE.wasm FOLDER");
        return ExitCode::FAILURE;
    };
    let written = Bindgen::new().input_path(module).out_name("grafcet").web(true).and_then(|to| {
        // No types: the page is JavaScript.
        to.typescript(false).remove_name_section(true).remove_producers_section(true).generate(folder)
    });
    match written {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:?}");
            ExitCode::FAILURE
        }
    }
}
