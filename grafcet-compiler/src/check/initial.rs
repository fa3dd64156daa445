//! What a chart remembers has an initial value that is a constant, since `new` is `const`.

use crate::analysis::remembered;
use crate::diagnostic::Sink;
use crate::model::{Expr, Model, Ty};

/// Reports remembered values of a user's own type that state no initial value: `Default` is not `const`.
pub(crate) fn initial_values(model: &Model, sink: &mut Sink) {
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
