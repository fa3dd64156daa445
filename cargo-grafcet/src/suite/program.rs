//! Functions and constants of the program in a Rust test: what they have to answer in each cycle is known, how they are told is not.

use std::fmt::Write as _;

use grafcet_sim::{Kind, Signal, Value};

/// The function that is to be written.
pub(super) const STUB: &str = "the_program_answers";

/// What it is told, and itself; nothing where the chart asks its program for nothing.
pub(super) fn stub(chart: &str, outside: &[Signal]) -> String {
    if outside.is_empty() {
        return String::new();
    }
    let mut text = format!(
        "\n/// What the program around `{chart}` answers in a cycle.\n#[derive(Clone, Copy, Debug)]\nstruct Answers {{\n"
    );
    for (field, signal) in fields(outside).iter().zip(outside) {
        _ = writeln!(text, "    /// `{}`\n    {field}: {},", signal.name, ty(&signal.kind));
    }
    text += "}\n";
    _ = write!(
        text,
        "\n/// To be written by you: after this, the functions and constants of the program that the chart asks give these answers. What they look at, as a
/// `thread_local!` that they read under `cfg(test)`, can be set here; of what cannot change it can be asserted that it is so.
fn {STUB}(answers: Answers) {{
    todo!(\"let the program answer {{answers:?}}\")
}}
"
    );
    text
}

/// The call in front of a cycle.
pub(super) fn told(outside: &[Signal], values: &[Value]) -> String {
    if outside.is_empty() {
        return String::new();
    }
    let names = fields(outside);
    let answers = names.iter().zip(outside).zip(values).map(|((field, signal), value)| {
        let value = match (&signal.kind, value) {
            (Kind::Float(_), Value::Float(value)) => format!("{value:?}"),
            (Kind::Time, Value::Ticks(ticks)) => format!("Ticks::new({ticks})"),
            (Kind::Bool | Kind::Int { .. }, value) => value.to_string(),
            (_, value) => format!("{:?}", value.to_string()),
        };
        format!("{field}: {value}")
    });
    format!("    {STUB}(Answers {{ {} }});\n", answers.collect::<Vec<_>>().join(", "))
}

/// The type of an answer; what is not known here is text.
fn ty(kind: &Kind) -> String {
    match kind {
        Kind::Bool => "bool".to_owned(),
        Kind::Int { signed, bits } => format!("{}{bits}", if *signed { "i" } else { "u" }),
        Kind::Float(bits) => format!("f{bits}"),
        Kind::Time => "Ticks".to_owned(),
        Kind::Listed(..) | Kind::Other(_) => "&'static str".to_owned(),
    }
}

/// `near(x, 3)` is `near_x_3`; each name once.
fn fields(outside: &[Signal]) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for signal in outside {
        let words = signal.name.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
        let name = words.collect::<Vec<_>>().join("_").to_lowercase();
        let is_name = syn::parse_str::<syn::Ident>(&name).is_ok();
        let plain = if is_name { name } else { format!("answer_{name}").trim_end_matches('_').to_owned() };
        let taken = |name: &str| names.iter().any(|other| other == name);
        let mut name = plain.clone();
        let mut number = 2;
        while taken(&name) {
            name = format!("{plain}_{number}");
            number += 1;
        }
        names.push(name);
    }
    names
}

#[cfg(test)]
mod tests {
    use grafcet_sim::{Kind, Signal};

    use super::fields;

    #[test]
    fn each_answer_has_a_name_of_its_own() {
        let texts = ["near(x, 3)", "near(x , 3.0)", "near (x,3)", "LIMIT", "self", "1 + a()", "!"];
        let signals = texts.map(|name| Signal { name: name.to_owned(), kind: Kind::Bool });
        let expected = ["near_x_3", "near_x_3_0", "near_x_3_2", "limit", "answer_self", "answer_1_a", "answer"];
        assert_eq!(fields(&signals), expected);
    }
}
