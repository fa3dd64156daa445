//! What a chart remembers has an initial value that is a constant, since `new` is `const`.

use crate::diagnostic::Sink;
use crate::model::{Association, Effect, Expr, Model, Name, OutputId, Place, Qualifier, Read, Ty};
use crate::sorted::Set;

/// Reports remembered values of a user's own type that state no initial value: `Default` is not `const`.
pub fn initial_values(model: &Model, sink: &mut Sink) {
    let remembered = remembered(model);
    for (_, output) in model.outputs.iter().filter(|(id, _)| remembered.contains(id)) {
        require("output", &output.name, &output.ty, output.init.as_ref(), sink);
    }
    for var in model.vars.values() {
        require("var", &var.name, &var.ty, var.init.as_ref(), sink);
    }
    for param in model.params.values() {
        require("param", &param.name, &param.ty, param.init.as_ref(), sink);
    }
}

/// The outputs that keep their value from cycle to cycle: an action stores it, or, in an `sfc`, an expression reads what it was in the cycle before.
fn remembered(model: &Model) -> Set<OutputId> {
    let output = |place: &Place| if let Place::Output(id) = place { Some(*id) } else { None };
    let mut found = Set::new();
    let lasts = |association: &&Association| match association.effect {
        // What is controlled may be an alias of `bool`.
        Effect::Control(_) => association.qualifier == Qualifier::S,
        Effect::Assign(..) => association.qualifier != Qualifier::N,
        Effect::Call(..) | Effect::Block(_) => true,
    };
    for association in model.associations.values().filter(lasts) {
        found.extend(association.effect.writes().iter().filter_map(output));
    }
    for effect in model.transitions.values().flat_map(|transition| &transition.clearing) {
        found.extend(effect.writes().iter().filter_map(output));
    }
    // In a `grafcet` only stored outputs can be read (A22).
    for read in model.expressions().into_iter().flatten() {
        if let (Read::Name(Name::Output(id)), false) = (read, model.is_grafcet()) {
            found.insert(*id);
        }
    }
    found
}

fn require(keyword: &str, name: &syn::Ident, ty: &Ty, init: Option<&Expr>, sink: &mut Sink) {
    let Ty::Other(rust) = ty else { return };
    if init.is_some() || ty.is_float() {
        return;
    }
    let rust = quote::ToTokens::to_token_stream(rust);
    let message = format!(
        "`{name}` keeps its value from cycle to cycle, and the default of its type is not a constant; \
         state its initial value: `{keyword} {name}: {rust} = …;`"
    );
    sink.notation(name, message);
}
