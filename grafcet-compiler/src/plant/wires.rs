//! Whose outputs are whose inputs: they have the same name.

use proc_macro2::Ident;
use quote::ToTokens;

use crate::diagnostic::Sink;
use crate::list::List;
use crate::model::{Driven, Model, OutputId, Ty, Wire};
use crate::similar;

/// What the plants drive of the chart, and by plant what drives its inputs; of each plant the inputs are named that nobody drives.
pub(super) fn of(chart: &Model, plants: &[(Model, Vec<String>)], sink: &mut Sink) -> (Vec<Driven>, Vec<Vec<Wire>>) {
    let (mut driven, mut wires): (Vec<Driven>, Vec<Vec<Wire>>) = (Vec::new(), Vec::new());
    for (plant, (model, _)) in plants.iter().enumerate() {
        for (output, shown) in model.outputs.iter() {
            let input = chart.inputs.iter().find(|(_, input)| input.name == shown.name);
            if let Some((input, declared)) = input {
                same_type(&shown.name, &shown.ty, &declared.ty, sink);
                match driven.iter().find(|other| other.input == input) {
                    None => driven.push(Driven { input, plant, output }),
                    Some(other) => {
                        let first = &plants[other.plant].0.name;
                        let message = format!("the plant `{first}` drives the input `{}` already", shown.name);
                        sink.notation(&shown.name, message);
                    }
                }
            } else if !plants.iter().any(|(other, _)| other.inputs.values().any(|input| input.name == shown.name)) {
                let names = chart.inputs.values().map(|input| &input.name).list();
                let message = format!(
                    "what a plant shows is an input of the chart, or of another plant, and none is called `{}`{}",
                    shown.name,
                    hint(&shown.name, &names)
                );
                sink.notation(&shown.name, message);
            }
        }
    }
    for (number, (model, free)) in plants.iter().enumerate() {
        let mut of_plant = Vec::new();
        for input in model.inputs.values() {
            of_plant.push(wire(chart, plants, (number, free), (&input.name, &input.ty), &driven, sink));
        }
        wires.push(of_plant);
    }
    (driven, wires)
}

fn wire(
    chart: &Model,
    plants: &[(Model, Vec<String>)],
    (number, free): (usize, &[String]),
    (name, ty): (&Ident, &Ty),
    driven: &[Driven],
    sink: &mut Sink,
) -> Wire {
    if free.contains(&name.to_string()) {
        return Wire::Free;
    }
    if let Some((output, declared)) = chart.outputs.iter().find(|(_, output)| output.name == *name) {
        same_type(name, ty, &declared.ty, sink);
        return Wire::Output(output);
    }
    for (other, (model, _)) in plants.iter().enumerate() {
        let shown: Option<(OutputId, _)> = model.outputs.iter().find(|(_, output)| output.name == *name);
        if let Some((output, declared)) = shown.filter(|_| other != number) {
            same_type(name, ty, &declared.ty, sink);
            return Wire::Shown(other, output);
        }
    }
    if let Some((input, declared)) = chart.inputs.iter().find(|(_, input)| input.name == *name) {
        if driven.iter().all(|driven| driven.input != input) {
            same_type(name, ty, &declared.ty, sink);
            return Wire::Shared(input);
        }
    }
    let names = chart.outputs.values().map(|output| &output.name).list();
    let message = format!(
        "an input of a plant is an output of the chart, and none is called `{name}`{}",
        match hint(name, &names) {
            hint if hint.is_empty() => format!("; what happens by itself is a `choice {name};` or a `fault {name};`"),
            hint => hint,
        }
    );
    sink.notation(name, message);
    Wire::Free
}

fn same_type(name: &Ident, ty: &Ty, other: &Ty, sink: &mut Sink) {
    let (ours, theirs) = (text(ty), text(other));
    if matches!(ty, Ty::Other(_)) && ours == theirs {
        let message =
            format!("a chart and its plants exchange `bool`, integers and times; `{name}` is of type `{ours}`");
        sink.notation(name, message);
    }
    if ours != theirs {
        let message = format!("`{name}` is of type `{ours}` here and of type `{theirs}` on the other side");
        sink.notation(name, message);
    }
}

fn text(ty: &Ty) -> String {
    match ty {
        Ty::Bool(rust) | Ty::Int { rust, .. } | Ty::Other(rust) => rust.to_token_stream().to_string(),
        Ty::Time(_) => "time".to_owned(),
    }
}

fn hint(name: &Ident, known: &[&Ident]) -> String {
    similar::nearest(name, known).map_or_else(String::new, |near| format!("; did you mean `{near}`?"))
}
