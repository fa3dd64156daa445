//! What is said of a text, at places of JavaScript.

use grafcet_web::{check, look, translate};
use serde_json::{Value, json};

/// All that the page knows of a text.
fn looked(text: &str) -> Value {
    let mut all: Value = serde_json::from_str(&look(text)).expect("JSON");
    let said: Value = serde_json::from_str(&check(text)).expect("JSON");
    for (name, value) in said.as_object().expect("an object") {
        all[name] = value.clone();
    }
    all
}

fn translated(text: &str, form: &str) -> Value {
    serde_json::from_str(&translate(text, form).expect("a form")).expect("JSON")
}

/// The texts that the notes of a message mark.
fn marked<'t>(text: &'t str, message: &Value) -> Vec<&'t str> {
    let place = |note: &Value, end: &str| usize::try_from(note[end].as_u64().expect("a place")).expect("small");
    // These texts have no character beyond ASCII, so that units are bytes.
    message["notes"]
        .as_array()
        .expect("notes")
        .iter()
        .map(|note| &text[place(note, "from")..place(note, "to")])
        .collect()
}

const MOTOR: &str = "sfc Motor { input on, off: bool; output relay: bool;
    initial step Off; step On { N relay; } Off -[on]-> On -[off]-> Off; }";

#[test]
fn a_good_chart_has_a_drawing_and_runs() {
    let said = looked(MOTOR);
    assert_eq!((&said["name"], &said["runs"], &said["messages"]), (&json!("Motor"), &json!(true), &json!([])));
    assert!(said["drawing"].as_str().expect("a drawing").starts_with("<svg"));
    let found = |list: &str, place: usize| {
        let at = &said[list][place];
        &MOTOR[usize::try_from(at[0].as_u64().expect("a place")).expect("small")
            ..usize::try_from(at[1].as_u64().expect("a place")).expect("small")]
    };
    assert_eq!((found("steps", 0), found("steps", 1)), ("Off", "On"));
    assert!(found("transitions", 1).contains("off"), "{}", found("transitions", 1));
    let words = said["words"].as_array().expect("words");
    for word in [json!(["on", "input"]), json!(["relay", "output"]), json!(["Off", "step"])] {
        assert!(words.contains(&word), "{word} of {words:?}");
    }
}

#[test]
fn a_mistake_is_marked_at_its_token() {
    let text = MOTOR.replace("-[on]->", "-[onn]->");
    let said = looked(&text);
    assert_eq!(said["runs"], json!(false));
    assert!(said["drawing"].as_str().is_some_and(|svg| svg.contains(">onn<")), "the drawing says what is written");
    let message = &said["messages"][0];
    assert_eq!((message["level"].as_str(), marked(&text, message)), (Some("error"), vec!["onn"]));
}

#[test]
fn a_rule_has_its_name_and_its_drawing() {
    let text = MOTOR.replace("-[off]-> Off;", "-[off]-> Off; On -[off]-> Off;");
    let said = looked(&text);
    let rules: Vec<&Value> = said["messages"].as_array().expect("messages").iter().map(|one| &one["rule"]).collect();
    assert!(!rules.is_empty() && rules.iter().all(|rule| rule.is_string()), "{said}");
    assert!(said["drawing"].is_string(), "what breaks a rule can be drawn");
}

#[test]
fn what_cannot_be_read_ends_at_its_place() {
    let said = looked("sfc Motor { ) }");
    assert_eq!((&said["messages"][0]["notes"][0]["from"], &said["runs"]), (&json!(12), &json!(false)));
    assert_eq!(looked("")["runs"], json!(false));
    let half = looked(&MOTOR.replace("-[off]-> Off;", "-[off]-> ;"));
    assert_eq!((&half["drawing"], &half["runs"]), (&Value::Null, &json!(false)), "half a chart would be another one");
    assert!(looked("/* open")["messages"][0]["level"] == "error");
}

#[test]
fn a_claim_that_is_broken_lets_the_chart_run() {
    let text = MOTOR.replace("initial", "never On.X; initial");
    let said = looked(&text);
    assert_eq!((&said["messages"][0]["rule"], &said["runs"]), (&json!("property_violated"), &json!(true)));
    assert!(said["messages"][0]["notes"][0]["text"].is_string());
}

#[test]
fn other_notations() {
    assert!(translated(MOTOR, "rust")["text"].as_str().expect("Rust").contains("fn cycle("));
    assert!(translated(MOTOR, "case")["text"].as_str().expect("a program").contains("CASE StepNo OF"));
    assert!(translated(MOTOR, "flip-flops")["text"].as_str().expect("a program").contains("FUNCTION_BLOCK Motor"));
    assert!(translated(MOTOR, "sfc")["text"].as_str().expect("a program").contains("INITIAL_STEP OffStep:"));
    assert!(translated(MOTOR, "plcopen")["text"].as_str().expect("a project").contains("<SFC>"));
    assert!(translated(MOTOR, "pnml")["text"].as_str().expect("a net").contains("<pnml"));
    assert!(translated(MOTOR, "aiger")["text"].as_str().expect("a circuit").starts_with("aag "));
    assert!(translated(MOTOR, "btor2")["text"].as_str().expect("a circuit").starts_with("1 sort bitvec 1\n"));
    let files = ["rust", "case", "flip-flops", "sfc", "plcopen", "pnml", "aiger", "btor2"]
        .map(|form| translated(MOTOR, form)["file"].as_str().expect("a name").to_owned());
    assert_eq!(
        files,
        ["Motor.rs", "Motor.st", "Motor.st", "Motor.st", "Motor.xml", "Motor.pnml", "Motor.aag", "Motor.btor2"]
    );
    assert!(translate(MOTOR, "ladder").is_err());
    let broken = translated(&MOTOR.replace("-[on]->", "-[onn]->"), "rust");
    assert_eq!(broken["refused"][0]["text"], json!("the chart has an error: mend that first"));
}

#[test]
fn what_has_no_translation_says_where() {
    let text = "grafcet G { input go, more: bool; output y: bool;
        partial Top { initial step A; step B { force Low {*}; } A -[go]-> B -[!go]-> A; }
        partial Low { initial step C; step E { y; } C -[more]-> E -[!more]-> C; } }";
    assert_eq!(looked(text)["messages"], json!([]));
    for form in ["pnml", "sfc", "plcopen"] {
        let refused = &translated(text, form)["refused"][0];
        assert!(refused["from"].is_u64() && refused["to"].as_u64() > refused["from"].as_u64(), "{form}: {refused}");
    }
}

/// The circuit has the plant, whose step is asked for in the property.
#[test]
fn a_circuit_has_its_plants_and_its_bound() {
    let press = "sfc Press { input go, bottom: bool; output down: bool;
        initial step Up; step Down { down; } Up -[go]-> Down -[bottom]-> Up; never Up.X && Ram::Low.X; }
        plant Ram { input down: bool; output bottom: bool; initial step Top; step Low { bottom; }
        Top -[down]-> Low -[!down]-> Top; }";
    let text = translated(press, "btor2");
    let text = text["text"].as_str().unwrap_or_else(|| panic!("{text}"));
    assert!(text.contains(" bad ") && text.contains("Ram"), "{text}");
    // Each output is a number of its own that its step changes, so the circuit is large.
    let wide = |steps: usize| {
        let part = |step: usize| {
            let initial = if step == 0 { "initial " } else { "" };
            let next = (step + 1) % steps;
            format!(
                "output n{step}: u64; {initial}step S{step} {{ P1 {{ n{step} = n{step} * n{step} + 1; }} }} S{step} -[go]-> S{next}; "
            )
        };
        format!("sfc Wide {{ input go: bool; {}}}", (0..steps).map(part).collect::<Vec<_>>().concat())
    };
    assert!(translated(&wide(2), "aiger")["text"].is_string());
    let refused = &translated(&wide(60), "aiger")["refused"][0];
    let why = "there is no circuit: it is too large for this page; `cargo grafcet export` writes larger ones";
    assert_eq!(refused["text"], json!(why));
}
