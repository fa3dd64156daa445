//! What associations are, and what effects do.

use std::collections::BTreeMap;

use grafcet_compiler::model::{
    ActionId, Association, AssociationId, Effect, Expr, Model, Name, Place, Qualifier, Read, Tree,
};

use super::expr::{At, Kind, Scope, kind, plain};
use super::names::Names;
use super::syntax::{Statement, Stub, Variable};
use super::{own_writes, variants};
use crate::Refused;

/// What an association is for a program.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Role {
    /// As long as something holds the place is true, or has a value: N, L, D, P of a place; in an `sfc` SD, DS and SL, too.
    Continuous(Place),
    /// S
    Set(Place),
    /// R
    Reset(Place),
    /// P1: what is done once on activation.
    Activation,
    /// P0
    Deactivation,
    /// `on`
    Event,
    /// What runs in each scan in which its qualifier drives it: an assignment to a variable, a block, a call; of an `sfc` that of an output, too,
    /// after another qualifier than N.
    Body,
    /// It has no effect.
    Nothing,
}

/// What it is; refused where neither form knows it.
pub(crate) fn role(model: &Model, association: &Association) -> Result<Role, Refused> {
    use Qualifier::{D, Ds, L, N, On, P, P0, P1, R, S, Sd, Sl};
    let qualifier = association.qualifier;
    let role = match (&association.effect, qualifier) {
        (Effect::Control(place), S) => Role::Set(*place),
        (Effect::Control(place), R) => Role::Reset(*place),
        (_, P1) => Role::Activation,
        (_, P0) => Role::Deactivation,
        (_, On) => Role::Event,
        // A block and an assignment have an action control of their own, which nothing else drives.
        (Effect::Assign(..) | Effect::Block(_), R) if !model.is_grafcet() => Role::Nothing,
        (Effect::Call(..), R) if !model.is_grafcet() => Role::Body,
        (Effect::Assign(..) | Effect::Block(_) | Effect::Call(..), R) => return Err(runs(association)),
        // In an `sfc` what is assigned after another qualifier than N is written, and so runs.
        (Effect::Assign(Place::Output(_), _), _) if qualifier != N && !model.is_grafcet() => Role::Body,
        (Effect::Control(place) | Effect::Assign(place @ Place::Output(_), _), N | S | L | D | P | Sd | Ds | Sl) => {
            Role::Continuous(*place)
        }
        (Effect::Assign(Place::Var(_), _) | Effect::Block(_) | Effect::Call(..), N | S | L | D | P | Sd | Ds | Sl) => {
            Role::Body
        }
    };
    Ok(role)
}

/// What runs is not ended by another step.
fn runs(association: &Association) -> Refused {
    let word = association.qualifier.word();
    let message = format!(
        "`{word}` of what runs has no translation into structured text, only `{word}` of a boolean has: set a boolean and ask for it"
    );
    Refused::at(association.mark, message)
}

/// How a place is written.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub(crate) struct Written {
    pub(crate) continuous: bool,
    pub(crate) set_or_reset: bool,
    /// By assignments and blocks.
    pub(crate) otherwise: bool,
}

/// Of each place that is written.
pub(crate) fn written(model: &Model) -> Result<BTreeMap<Place, Written>, Vec<Refused>> {
    let mut all = BTreeMap::<Place, Written>::new();
    let mut refused = Vec::new();
    for association in model.associations.values() {
        match role(model, association) {
            Ok(Role::Continuous(place)) => all.entry(place).or_default().continuous = true,
            Ok(Role::Set(place) | Role::Reset(place)) => all.entry(place).or_default().set_or_reset = true,
            Ok(Role::Nothing) => {}
            Ok(_) => {
                for place in association.effect.writes() {
                    all.entry(*place).or_default().otherwise = true;
                }
            }
            Err(error) => refused.push(error),
        }
    }
    for effect in model.transitions.values().flat_map(|transition| &transition.clearing) {
        for place in effect.writes() {
            all.entry(*place).or_default().otherwise = true;
        }
    }
    if refused.is_empty() { Ok(all) } else { Err(refused) }
}

/// What an effect does once.
pub(crate) fn run(
    scope: &mut Scope<'_>,
    effect: &Effect,
    phase: Phase,
    at: &At<'_>,
) -> Result<Vec<Statement>, Refused> {
    match effect {
        Effect::Control(place) => Ok(vec![Statement::assign(scope.place(*place), "TRUE")]),
        Effect::Assign(place, value) => {
            let text = assigned(scope, *place, value, at)?;
            Ok(vec![Statement::assign(scope.place(*place), text)])
        }
        Effect::Call(action, arguments) => call(scope, *action, arguments, phase, at).map(|call| vec![call]),
        Effect::Block(code) => {
            let Some(statements) = &code.statements else {
                let message = format!(
                    "this Rust has no translation into structured text: assignments and `if` have one, `{}` is more",
                    code.text
                );
                return Err(Refused::at(at.mark, message));
            };
            own_writes::block(scope, code, statements, at)
        }
    }
}

/// The value that is assigned to a place.
pub(crate) fn assigned(scope: &mut Scope<'_>, place: Place, value: &Expr, at: &At<'_>) -> Result<String, Refused> {
    valued(scope, place, &value.tree, &At { mark: value.mark, ..*at })
}

/// The same of a tree. Of listed variants it is a number, or what has the same list.
pub(super) fn valued(scope: &mut Scope<'_>, place: Place, value: &Tree, at: &At<'_>) -> Result<String, Refused> {
    let wanted = kind_of(scope.model, place, at)?;
    if let Some(listed) = scope.model.variants_of(place.into()) {
        if let Some(number) = variants::listed_value(listed, value) {
            return Ok(number.to_string());
        }
        let same = scope.model.variants_of_tree(value).is_some_and(|other| variants::same_list(other, listed));
        if !same {
            let name = scope.model.place_name(place);
            let message = format!("what `{name}` gets is neither a variant that it lists nor a value of the same list");
            return Err(Refused::at(at.mark, message));
        }
    }
    let text = scope.tree(value, &wanted, at)?.text;
    scope.tells(&wanted, &text);
    Ok(text)
}

fn kind_of(model: &Model, place: Place, at: &At<'_>) -> Result<Kind, Refused> {
    let name = Name::from(place);
    super::expr::kind_of(model, name)
        .ok_or_else(|| Refused::at(at.mark, format!("`{}` is of no type of structured text", model.place_name(place))))
}

/// Which call of a code action it is; the number is what the function block is told.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Phase {
    First = 0,
    Repeated = 1,
    Final = 2,
}

fn call(
    scope: &mut Scope<'_>,
    id: ActionId,
    arguments: &[Expr],
    phase: Phase,
    at: &At<'_>,
) -> Result<Statement, Refused> {
    let phase =
        (format!("phase := {}", phase as u8), Variable::new("phase", "INT").note("0 first, 1 repeated, 2 final"));
    scope.call(id, arguments, phase, at)
}

impl Scope<'_> {
    /// A call of the function block that stands for an action, told which call it is.
    pub(crate) fn call(
        &mut self,
        id: ActionId,
        arguments: &[Expr],
        (told, which): (String, Variable),
        at: &At<'_>,
    ) -> Result<Statement, Refused> {
        let scope = self;
        let action = &scope.model.actions[id];
        // Each block has names of its own.
        let mut names = Names::new();
        names.own(&which.name);
        let mut given = vec![told];
        let rust = which.name.clone();
        let mut inputs = vec![which];
        let params = action.params.clone();
        for ((name, ty), argument) in params.iter().zip(arguments) {
            let name = names.own(&plain(name));
            let Some(kind) = kind(ty) else {
                let message = format!("the parameter `{name}` of `{}` is of no type of structured text", action.name);
                return Err(Refused::at(at.mark, message));
            };
            let value = scope.expr(argument, &kind, at)?.text;
            scope.tells(&kind, &value);
            given.push(format!("{name} := {value}"));
            inputs.push(Variable::new(name, kind.name()));
        }
        let name = scope.action(id, inputs, rust);
        Ok(Statement::Call(format!("{name}({})", given.join(", "))))
    }

    /// What is stored or told may be the time of a step.
    fn tells(&mut self, kind: &Kind, text: &str) {
        let reached = |name: &String| text.contains(&**name);
        self.tells_times |= *kind == Kind::Time && (text.contains(".ET") || self.reached.values().any(reached));
    }

    /// The instance of the function block that stands for an action.
    fn action(&mut self, id: ActionId, inputs: Vec<Variable>, told: String) -> String {
        if let Some((instance, _)) = self.instances.get(&id) {
            return instance.clone();
        }
        let action = &self.model.actions[id];
        let written = plain(&action.name);
        let instance = self.names.of_chart(&written);
        let block = self.names.own(&format!("FB_{written}"));
        let parameters: Vec<String> = action.params.iter().map(|(name, _)| plain(name)).collect();
        self.stubs.push(Stub {
            name: block.clone(),
            ty: None,
            inputs,
            rust: format!("fn {written}({})", [told].into_iter().chain(parameters).collect::<Vec<_>>().join(", ")),
        });
        self.instances.insert(id, (instance.clone(), block));
        instance
    }
}

/// What an effect reads of places.
pub(crate) fn reads(effect: &Effect) -> Vec<Place> {
    let all = effect.reads().into_iter().flatten().copied();
    all.filter_map(read_place).collect()
}

pub(crate) fn read_place(read: Read) -> Option<Place> {
    match read {
        Read::Name(Name::Output(id)) => Some(Place::Output(id)),
        Read::Name(Name::Var(id)) => Some(Place::Var(id)),
        _ => None,
    }
}

/// The places that a condition reads.
pub(crate) fn places(tree: &Tree) -> Vec<Place> {
    let mut places = Vec::new();
    tree.each_read(&mut |read| places.extend(read_place(read)));
    places
}

/// Actions that associations of several kinds, or several steps at once, act on: the calls of both would be one.
pub(crate) fn shared_calls(model: &Model, refused: &mut Vec<Refused>) {
    let mut kinds = BTreeMap::<ActionId, (Qualifier, AssociationId)>::new();
    for (id, association) in model.associations.iter() {
        let Effect::Call(action, _) = association.effect else { continue };
        let (qualifier, first) = *kinds.entry(action).or_insert((association.qualifier, id));
        let same_step = first != id && model.associations[first].step == association.step;
        if qualifier != association.qualifier || same_step {
            let name = &model.actions[action].name;
            refused.push(Refused::at(association.mark, format!("`{name}` is called by two kinds of associations, or twice by one step, and the CASE form has one kind of call for an action: use the form of flip-flops")));
        }
    }
}
