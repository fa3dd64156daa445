//! Draws the charts in Rust files: `draw [svg|text|mermaid] FILE…`, to the standard output.

use std::process::ExitCode;

use grafcet_compiler::describe::with_description;
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::{model, parse};
use proc_macro2::{TokenStream, TokenTree};

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1);
    let how = arguments.next().unwrap_or_default();
    for file in arguments {
        match std::fs::read_to_string(&file).map_err(|error| error.to_string()).and_then(|rust| draw(&how, &rust)) {
            Ok(drawings) => print!("{drawings}"),
            Err(error) => {
                eprintln!("{file}: {error}");
                return ExitCode::FAILURE;
            }
        }
    }
    ExitCode::SUCCESS
}

/// Each chart of a file, one below the other.
fn draw(how: &str, rust: &str) -> Result<String, String> {
    let tokens: Vec<TokenTree> = rust.parse::<TokenStream>().map_err(|error| error.to_string())?.into_iter().collect();
    let mut drawings = String::new();
    for window in tokens.windows(3) {
        let [TokenTree::Ident(name), TokenTree::Punct(bang), TokenTree::Group(chart)] = window else { continue };
        if name != "grafcet" || bang.as_char() != '!' {
            continue;
        }
        let mut sink = Sink::new();
        let model = parse::chart(chart.stream(), &mut sink).map(|chart| model::resolve(&chart, &mut sink));
        let wrong = sink.has_errors();
        drop(sink.finish());
        let model = model.filter(|_| !wrong).ok_or("a chart cannot be read")?;
        drawings += &with_description(&model, |chart| match how {
            "svg" => Ok(grafcet_draw::svg(chart, &())),
            "text" => Ok(grafcet_draw::text(chart, &())),
            "mermaid" => Ok(grafcet_draw::mermaid(chart)),
            other => Err(format!("`{other}` is none of svg, text, mermaid")),
        })?;
        drawings.push('\n');
    }
    Ok(drawings)
}
