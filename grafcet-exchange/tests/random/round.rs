//! There and back: a chart is exported as SFC of IEC 61131-3, imported again, and does what it did.
//!
//! The import has a grammar of its own and knows nothing of the export but the standard.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use grafcet_compiler::model::{Id, Model, Name, StepId};
use grafcet_exchange::Refused;
use grafcet_exchange::import::{Wrong, import};
use grafcet_exchange::plcopen::{Edition, Options, plcopen};
use grafcet_exchange::sfc::{Exported, textual};
use grafcet_sim::Chart;
use grafcet_sim::interp::{self, Interpreter};

use crate::drawn::{names, rust_files, timeline};
use crate::reader::{Kind, Line};
use crate::{CYCLES, chart, play, random, reader, resolved};

type Export = fn(&Model) -> Result<Exported, Vec<Refused>>;

const FORMS: [(&str, Export); 4] =
    [("textual", textual), ("PLCopen", drawn), ("PLCopen of Beremiz", beremiz), ("IEC 61131-10", part10)];

fn drawn(model: &Model) -> Result<Exported, Vec<Refused>> {
    plcopen(model, Options::default())
}

fn beremiz(model: &Model) -> Result<Exported, Vec<Refused>> {
    plcopen(model, Options { scan_step: true, ..Options::default() })
}

fn part10(model: &Model) -> Result<Exported, Vec<Refused>> {
    plcopen(model, Options { edition: Edition::Iec61131Part10, ..Options::default() })
}

/// A chart that has been out of the house, and the names by which it knows what it had.
struct Back {
    model: Model,
    names: BTreeMap<String, String>,
    text: String,
}

/// `allowed` are the rules that the chart may break.
fn back(original: &Model, export: Export, allowed: &str) -> Option<Result<Back, String>> {
    let exported = export(original).ok()?;
    let come = || {
        let imported = import(&exported.text, "there").map_err(|wrong| format!("{wrong}\n{}", exported.text))?;
        let [one] = &imported.charts[..] else { return Err("not one chart".to_owned()) };
        let text = format!("{}\n{}", exported.text, imported.rust);
        // Of a variable that no action writes the import says so.
        let told = |note: &&Wrong| !note.message.starts_with("nothing that is translated writes");
        if one.notes.iter().any(|note| told(&note)) {
            return Err(format!("{:?}\n{text}", one.notes));
        }
        let model = chart::resolve(&body(&imported.rust, allowed)).map_err(|error| format!("{error:?}\n{text}"))?;
        let (there, here): (BTreeMap<String, String>, BTreeMap<String, String>) =
            (exported.renamed.iter().cloned().collect(), one.renamed.iter().cloned().collect());
        let named = |name: &str| {
            let there = there.get(name).map_or(name, String::as_str);
            here.get(there).map_or(there, String::as_str).to_owned()
        };
        let originals = names_of(original).into_iter().map(|name| (name.clone(), named(&name)));
        Ok(Back { names: originals.collect(), model, text })
    };
    Some(come())
}

/// Of everything that is declared.
fn names_of(model: &Model) -> Vec<String> {
    let steps = model.steps.values().map(|step| play::plain(&step.name));
    steps.chain(values_of(model).into_iter().map(|name| play::plain(model.value_name(name)))).collect()
}

fn values_of(model: &Model) -> Vec<Name> {
    let inputs = model.inputs.ids().map(Name::Input).chain(model.params.ids().map(Name::Param));
    inputs.chain(model.outputs.ids().map(Name::Output)).chain(model.vars.ids().map(Name::Var)).collect()
}

/// What stands between the braces of the call.
fn body(rust: &str, allowed: &str) -> String {
    let begin = rust.find("grafcet! {").expect("a call") + "grafcet! {".len();
    let end = begin + rust[begin..].find("\n}\n").expect("an end");
    let header = begin + rust[begin..].find(" {\n").expect("a header") + 3;
    format!("{}{allowed}\n{}", &rust[begin..header], &rust[header..end])
}

/// The same steps, transitions in the order of their priorities, and declarations.
fn same_structure(original: &Model, back: &Back) -> Result<(), String> {
    let named = |name: &syn::Ident| back.names.get(&play::plain(name)).cloned().unwrap_or_default();
    let own = |name: &syn::Ident| play::plain(name);
    let steps = |model: &Model, named: &dyn Fn(&syn::Ident) -> String| {
        model.steps.values().map(|step| (named(&step.name), step.initial)).collect::<BTreeSet<_>>()
    };
    let transitions = |model: &Model, named: &dyn Fn(&syn::Ident) -> String| {
        let set =
            |steps: &[StepId]| steps.iter().map(|step| named(&model.steps[*step].name)).collect::<BTreeSet<String>>();
        let mut all = BTreeMap::<_, Vec<_>>::new();
        for transition in model.transitions.values() {
            all.entry(set(&transition.sources)).or_default().push(set(&transition.targets));
        }
        all
    };
    let declared = |model: &Model, named: &dyn Fn(&syn::Ident) -> String| {
        let ty = |name: Name| match model.ty(name) {
            grafcet_compiler::model::Ty::Bool(_) => "bool".to_owned(),
            grafcet_compiler::model::Ty::Int { signed, bits, .. } => format!("{signed} {bits}"),
            grafcet_compiler::model::Ty::Time(_) => "time".to_owned(),
            grafcet_compiler::model::Ty::Other(_) => "other".to_owned(),
        };
        let kind = |name: Name| match name {
            Name::Input(_) => 0,
            Name::Param(_) => 1,
            Name::Output(_) => 2,
            Name::Var(_) => 3,
        };
        values_of(model)
            .into_iter()
            .map(|name| (named(model.value_name(name)), kind(name), ty(name)))
            .collect::<BTreeSet<_>>()
    };
    let (was, is) = (steps(original, &named), steps(&back.model, &own));
    if was != is {
        return Err(format!("steps {was:?}, {is:?}"));
    }
    let (was, is) = (transitions(original, &named), transitions(&back.model, &own));
    if was != is {
        return Err(format!("transitions {was:?}, {is:?}"));
    }
    let (was, is) = (declared(original, &named), declared(&back.model, &own));
    // A variable that nobody writes is a param then.
    let as_param = |one: &(String, i32, String)| (one.0.clone(), 1, one.2.clone());
    let was: BTreeSet<_> = was
        .into_iter()
        .map(|one| if one.1 == 3 && is.contains(&as_param(&one)) { as_param(&one) } else { one })
        .collect();
    if was == is { Ok(()) } else { Err(format!("declarations {was:?}, {is:?}")) }
}

/// Cycle by cycle the same steps are active, and the same outputs and variables shown.
fn same_behaviour(original: &Model, back: &Back, lines: &[Line]) -> Result<usize, String> {
    let (Ok(mut was), Ok(mut is)) = (Interpreter::new(original), Interpreter::new(&back.model)) else { return Ok(0) };
    let there = |name: &syn::Ident| back.names.get(&play::plain(name)).cloned().unwrap_or_default();
    let mut cycles = 0;
    for line in lines {
        let at = |what: String| format!("line {}, {}: {what}", line.number, line.text());
        match &line.kind {
            Kind::Init => {
                was.init().map_err(|error| at(error.to_string()))?;
                is.init().map_err(|error| at(error.to_string()))?;
            }
            Kind::Params(changed) => {
                let mut new = was.params().to_vec();
                for (id, param) in original.params.iter() {
                    if let Some(value) = changed.get(&play::plain(&param.name)) {
                        new[id.index()] = play::value(*value, &param.ty);
                    }
                }
                let mut other = is.params().to_vec();
                for (id, param) in back.model.params.iter() {
                    let from = original.params.iter().find(|(_, from)| there(&from.name) == play::plain(&param.name));
                    if let Some((from, _)) = from {
                        other[id.index()] = new[from.index()];
                    }
                }
                was.set_params(&new).map_err(|error| at(error.to_string()))?;
                is.set_params(&other).map_err(|error| at(error.to_string()))?;
            }
            Kind::Cycle { inputs, now, .. } => {
                let given = |model: &Model, named: &dyn Fn(&syn::Ident) -> String| -> Vec<interp::Value> {
                    let inputs: BTreeMap<String, i128> = inputs
                        .iter()
                        .map(|(name, value)| {
                            (
                                back.names.get(name).filter(|_| !std::ptr::eq(model, original)).unwrap_or(name).clone(),
                                *value,
                            )
                        })
                        .collect();
                    model
                        .inputs
                        .values()
                        .map(|input| {
                            play::value(inputs.get(&named(&input.name)).copied().unwrap_or_default(), &input.ty)
                        })
                        .collect()
                };
                let own = |name: &syn::Ident| play::plain(name);
                let one = was.cycle(&given(original, &own), *now);
                // What is imported counts milliseconds, whatever the chart has counted.
                let finer = u32::try_from(original.clock_nanos / back.model.clock_nanos).unwrap_or(1).max(1);
                let other = is.cycle(&given(&back.model, &own), now.wrapping_mul(finer));
                // The arithmetic of both has failed.
                let (Ok(one), Ok(other)) = (&one, &other) else {
                    return if one.is_err() == other.is_err() {
                        Ok(cycles)
                    } else {
                        Err(at("one of both fails".to_owned()))
                    };
                };
                shown(original, back, (&was, &is)).map_err(at)?;
                let calls = [one, other].map(|cycle| {
                    cycle.calls.iter().map(|call| (call.phase as i128, call.args.clone())).collect::<Vec<_>>()
                });
                if calls[0] != calls[1] {
                    return Err(at(format!("calls {:?}, {:?}", calls[0], calls[1])));
                }
                cycles += 1;
            }
            _ => {}
        }
    }
    Ok(cycles)
}

fn shown(original: &Model, back: &Back, (was, is): (&Interpreter<'_>, &Interpreter<'_>)) -> Result<(), String> {
    let there = |name: &syn::Ident| back.names.get(&play::plain(name)).cloned().unwrap_or_default();
    let active: BTreeSet<String> = was.situation().iter().map(|step| there(&original.steps[*step].name)).collect();
    let found: BTreeSet<String> =
        is.situation().iter().map(|step| play::plain(&back.model.steps[*step].name)).collect();
    if active != found {
        return Err(format!("steps {active:?}, {found:?}"));
    }
    let values = |model: &Model, run: &Interpreter<'_>, named: &dyn Fn(&syn::Ident) -> String| {
        let outputs =
            model.outputs.iter().map(|(id, output)| (named(&output.name), play::number(run.outputs()[id.index()])));
        let vars = model.vars.iter().map(|(id, var)| (named(&var.name), play::number(run.vars()[id.index()])));
        outputs.chain(vars).collect::<BTreeMap<String, i128>>()
    };
    let (mut was, is) = (values(original, was, &there), values(&back.model, is, &|name| play::plain(name)));
    // A variable that nobody writes is a param.
    was.retain(|name, _| is.contains_key(name));
    if was == is { Ok(()) } else { Err(format!("values {was:?}, {is:?}")) }
}

#[test]
fn charts_of_the_examples_and_back() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut files: Vec<PathBuf> =
        ["examples/charts", "tests/good"].iter().flat_map(|folder| rust_files(&root.join(folder))).collect();
    files.sort();
    let mut done = BTreeMap::<&str, Vec<String>>::new();
    for file in files {
        let text = fs::read_to_string(&file).expect("a file of the project");
        for name in names(&text) {
            let Ok(chart) = Chart::in_file(&text, &name) else { continue };
            for (form, export) in FORMS {
                let Some(back) = back(chart.model(), export, "") else { continue };
                let back = back.unwrap_or_else(|error| panic!("{}, {name}, {form}: {error}", file.display()));
                let lines = timeline(chart.model(), 3);
                let same =
                    same_structure(chart.model(), &back).and_then(|()| same_behaviour(chart.model(), &back, &lines));
                let cycles =
                    same.unwrap_or_else(|error| panic!("{}, {name}, {form}: {error}\n{}", file.display(), back.text));
                if cycles > 0 {
                    done.entry(form).or_default().push(name.clone());
                }
            }
        }
    }
    println!("{done:#?}");
    assert!(done.values().all(|names| names.len() >= 20), "{done:?}");
    assert!(done.len() == FORMS.len() && done.values().all(|names| *names == done["textual"]), "{done:?}");
}

#[test]
fn random_charts_and_back() {
    let (wanted, first) = crate::seeds(60);
    let (mut seed, mut done, mut cycles) = (first, 0, 0);
    let mut refusals = BTreeMap::<String, usize>::new();
    while done < wanted {
        assert!(seed - first < 200_000, "only {done} charts have a translation: {refusals:#?}");
        let made = random::chart(seed, false, CYCLES);
        seed += 1;
        let Some(model) = resolved(&made.chart) else { continue };
        if let Err(refused) = textual(&model) {
            let first = refused.first().map(ToString::to_string).unwrap_or_default();
            *refusals.entry(crate::reasons::without_names(&first)).or_default() += 1;
            continue;
        }
        let Ok(model) = chart::resolve(&made.chart) else { continue };
        let lines = reader::read(&format!("{}\n---\n{}", made.chart, made.timeline)).expect("a timeline").lines;
        let allowed = made.chart.lines().find(|line| line.starts_with("#![allow")).unwrap_or_default();
        for (form, export) in FORMS {
            let Some(back) = back(&model, export, allowed) else { continue };
            let back = back.unwrap_or_else(|error| panic!("seed {}, {form}: {error}\n{}", seed - 1, made.chart));
            let same = same_structure(&model, &back).and_then(|()| same_behaviour(&model, &back, &lines));
            cycles += same
                .unwrap_or_else(|error| panic!("seed {}, {form}: {error}\n{}\n{}", seed - 1, made.chart, back.text));
        }
        done += 1;
    }
    println!("{done} charts of {}, {cycles} cycles; refused: {refusals:#?}", seed - first);
    assert!(cycles > 50 * done, "{cycles}");
}
