//! Expressions.

use proc_macro2::{Ident, Literal, TokenStream};

use super::Printer;
use super::user::is_input;
use crate::codegen::names;
use crate::list::List;
use crate::model::StepId;
use crate::place::quote;
use crate::program::{Comparison, Expr, PlaceId, Type, Value};
use crate::sorted::Map;

/// How closely an expression binds.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binds {
    /// `if a { b } else { c }`: a statement, where one may stand.
    Block,
    Or,
    And,
    Compare,
    Sum,
    Unary,
    Term,
}

impl<'m> Printer<'_, 'm> {
    /// An expression where nothing stands beside it.
    pub(super) fn value(&self, expr: &Expr<'m>) -> TokenStream {
        self.expr(expr, Type::Bool).0
    }

    /// The same after `if`, where no struct may stand open.
    pub(super) fn condition(&self, expr: &Expr<'m>) -> TokenStream {
        self.value(expr)
    }

    /// The value that a place gets.
    pub(super) fn set_to(&self, place: PlaceId, value: &Expr<'m>) -> TokenStream {
        self.expr(value, self.program.places[place.0].ty).0
    }

    /// An operand, in parentheses where it binds less closely than what stands around it.
    fn operand(&self, expr: &Expr<'m>, around: Binds) -> TokenStream {
        self.typed(expr, Type::Bool, around)
    }

    /// The same of one whose constants are of a type.
    fn typed(&self, expr: &Expr<'m>, ty: Type<'m>, around: Binds) -> TokenStream {
        let (tokens, binds) = self.expr(expr, ty);
        if binds < around { quote!((#tokens)) } else { tokens }
    }

    fn list_of(&self, parts: &[Expr<'m>], around: Binds) -> Vec<TokenStream> {
        parts.iter().map(|part| self.operand(part, around)).list()
    }

    /// `ty` is the type that constants of a state have; all others tell their own.
    fn expr(&self, expr: &Expr<'m>, ty: Type<'m>) -> (TokenStream, Binds) {
        let p = &self.cx.p;
        match expr {
            Expr::Value(value) => (self.constant(*value, ty), Binds::Term),
            Expr::Place(place) => (self.get(*place), Binds::Term),
            Expr::Initial(place) => (self.initial(*place), Binds::Block),
            Expr::Input(id) => {
                let name = &self.cx.model.inputs[*id].name;
                (quote!(inputs_.#name), Binds::Term)
            }
            Expr::Now => (quote!(now_), Binds::Term),
            Expr::Is(place, steps) => self.is(*place, steps),
            Expr::Not(inner) => self.not(inner),
            Expr::All(parts) if self.program.asks_at_once(parts) => {
                let parts = self.list_of(parts, Binds::Unary);
                (quote!(#(#parts)&*), Binds::Compare)
            }
            Expr::Any(parts) if self.program.asks_at_once(parts) => {
                let parts = self.list_of(parts, Binds::Unary);
                (quote!(#(#parts)|*), Binds::Compare)
            }
            Expr::All(parts) => {
                let parts = self.list_of(parts, Binds::And);
                (quote!(#(#parts)&&*), Binds::And)
            }
            Expr::Any(parts) => {
                let parts = self.list_of(parts, Binds::Or);
                (quote!(#(#parts)||*), Binds::Or)
            }
            Expr::Compare(comparison, a, b) => (self.comparison(*comparison, a, b), Binds::Compare),
            Expr::Choose(parts) => {
                let [condition, then, otherwise] = &**parts;
                // What begins with a block would be a statement there.
                let [then, otherwise] = [then, otherwise].map(|part| self.typed(part, ty, Binds::Or));
                let condition = self.condition(condition);
                (quote!(if #condition { #then } else { #otherwise }), Binds::Block)
            }
            Expr::Add(a, b) => (self.sum(a, &quote!(+), b), Binds::Sum),
            Expr::Sub(a, b) => (self.sum(a, &quote!(-), b), Binds::Sum),
            Expr::Table(place, table) => (self.table(*place, table), Binds::Block),
            Expr::Next(place) => {
                let place = self.get(*place);
                (quote!(#place.wrapping_add(1)), Binds::Term)
            }
            Expr::Since(a, b) => {
                let (a, b) = (self.operand(a, Binds::Term), self.value(b));
                (quote!(#a.since(#b)), Binds::Term)
            }
            Expr::Period(reached, passed, period) if matches!(**reached, Expr::Value(Value::Ticks(0))) => {
                let passed = self.value(passed);
                (quote!(#p::rest(#passed, #p::Ticks::new(#period))), Binds::Term)
            }
            Expr::Period(reached, passed, period) => {
                let (reached, passed) = (self.value(reached), self.value(passed));
                (quote!(#p::phase(#reached, #passed, #p::Ticks::new(#period))), Binds::Term)
            }
            Expr::User(user) => {
                let binds = if is_input(user) { Binds::Term } else { Binds::Block };
                (self.user(user), binds)
            }
        }
    }

    /// Whether the state of a region is one of these.
    fn is(&self, place: PlaceId, steps: &[StepId]) -> (TokenStream, Binds) {
        let (p, state) = (&self.cx.p, self.get(place));
        let variants = steps.iter().map(|step| self.state(place, *step)).list();
        match &variants[..] {
            // What only a step does that is never entered.
            [] => (quote!(false), Binds::Term),
            [one] => (quote!(#state == #one), Binds::Compare),
            _ => (quote!(#p::core::matches!(#state, #(#variants)|*)), Binds::Term),
        }
    }

    fn not(&self, inner: &Expr<'m>) -> (TokenStream, Binds) {
        match inner {
            Expr::Is(place, steps) if steps.len() == 1 => {
                let (state, variant) = (self.get(*place), self.state(*place, steps[0]));
                (quote!(#state != #variant), Binds::Compare)
            }
            Expr::Compare(Comparison::Less, time, limit) if matches!(**limit, Expr::Value(Value::Ticks(_))) => {
                let (p, time, limit) = (&self.cx.p, self.value(time), self.value(limit));
                (quote!(#p::has_reached!(#time, #limit)), Binds::Term)
            }
            inner => {
                let inner = self.operand(inner, Binds::Unary);
                (quote!(!#inner), Binds::Unary)
            }
        }
    }

    /// The kind of each state, and the type of the kinds: LLVM knows by it how many there are.
    pub(super) fn kinds(&self, ty: Type<'m>, place: PlaceId, table: &[(Value, Value)]) -> (TokenStream, TokenStream) {
        let (p, state) = (&self.cx.p, self.get(place));
        let of_state: Map<Value, Value> = table.iter().copied().collect();
        let states = self.layout.states(self.program, self.program.places[place.0].ty);
        let Type::Kind { count, .. } = ty else { return Default::default() };
        let kind_of = |state: &Value| *of_state.get(state).unwrap_or(&Value::Int(count - 1));
        let (name, length) = (kind_type(ty), Literal::usize_suffixed(states.len()));
        let variants = (0..count).map(kind_variant).list();
        let kinds = states.iter().map(|state| self.constant(kind_of(state), ty)).list();
        let declared = quote! {
            #[derive(#p::core::clone::Clone, #p::core::marker::Copy)]
            enum #name { #(#variants,)* }
        };
        let found = quote!({
            const KINDS: [#name; #length] = [#(#kinds),*];
            match <[_]>::get(&KINDS, #state as #p::usize) { #p::Option::Some(found_) => *found_, #p::Option::None => KINDS[0] }
        });
        (declared, found)
    }

    /// A number for each state of a place. None is out of the table's bounds, which LLVM knows.
    pub(super) fn numbers(&self, number: PlaceId, place: PlaceId, table: &[(Value, Value)]) -> TokenStream {
        let (p, state, ty) = (&self.cx.p, self.get(place), self.ty(number));
        let of_state: Map<Value, Value> = table.iter().copied().collect();
        let states = self.layout.states(self.program, self.program.places[place.0].ty);
        let length = Literal::usize_suffixed(states.len());
        let mut numbers = Vec::new();
        for state in states {
            numbers.push(self.constant(*of_state.get(&state).unwrap_or(&Value::Int(0)), Type::Number));
        }
        quote!({
            const NUMBERS: [#ty; #length] = [#(#numbers),*];
            match <[_]>::get(&NUMBERS, #state as #p::usize) { #p::Option::Some(found_) => *found_, #p::Option::None => NUMBERS[0] }
        })
    }

    /// What a table has for the state of a place. None is out of its bounds, which LLVM knows.
    /// What it does not have is the state itself, or no time.
    fn table(&self, place: PlaceId, table: &[(Value, Value)]) -> TokenStream {
        let (p, ty, state) = (&self.cx.p, self.program.places[place.0].ty, self.get(place));
        let of_state: Map<Value, Value> = table.iter().copied().collect();
        let states = self.layout.states(self.program, ty);
        let length = Literal::usize_suffixed(states.len());
        let longest =
            of_state.values().filter_map(|value| if let Value::Ticks(time) = value { Some(*time) } else { None }).max();
        if let Some(longest) = longest {
            let is_short = u16::try_from(longest).is_ok();
            let held = if is_short { quote!(#p::u16) } else { quote!(#p::u32) };
            let mut times = Vec::new();
            for state in states {
                let time = if let Some(Value::Ticks(time)) = of_state.get(&state) { *time } else { 0 };
                times.push(Literal::u32_unsuffixed(time));
            }
            return quote!(#p::Ticks::new({
                const TABLE: [#held; #length] = [#(#times),*];
                match <[_]>::get(&TABLE, #state as #p::usize) { #p::Option::Some(found_) => #p::u32::from(*found_), #p::Option::None => 0 }
            }));
        }
        if let Some(jumps) = self.program.jumps(&states, &of_state) {
            return self.in_order(place, &states, &jumps);
        }
        let mut values = Vec::new();
        for from in states {
            values.push(self.constant(*of_state.get(&from).unwrap_or(&from), ty));
        }
        let held = self.ty(place);
        quote!({
            const TABLE: [#held; #length] = [#(#values),*];
            match <[_]>::get(&TABLE, #state as #p::usize) { #p::Option::Some(found_) => *found_, #p::Option::None => #state }
        })
    }

    /// The same as a match, after the few states that do not lead to the one after them.
    fn in_order(&self, place: PlaceId, states: &[Value], jumps: &[(Value, Value)]) -> TokenStream {
        let (ty, state) = (self.program.places[place.0].ty, self.get(place));
        let arm = |(from, to): (&Value, &Value)| {
            let (from, to) = (self.constant(*from, ty), self.constant(*to, ty));
            quote!(#from => #to,)
        };
        let following = states.iter().skip(1).and(states.last());
        let in_order = states.iter().zip(following).map(arm).tokens();
        let jumps = jumps.iter().map(|(from, to)| arm((from, to))).tokens();
        quote!(match #state { #jumps _ => match #state { #in_order } })
    }

    fn sum(&self, a: &Expr<'m>, sign: &TokenStream, b: &Expr<'m>) -> TokenStream {
        let (a, b) = (self.operand(a, Binds::Sum), self.operand(b, Binds::Unary));
        quote!(#a #sign #b)
    }

    fn comparison(&self, comparison: Comparison, a: &Expr<'m>, b: &Expr<'m>) -> TokenStream {
        let sign = match comparison {
            Comparison::Equal => quote!(==),
            Comparison::Differs => quote!(!=),
            Comparison::Less => quote!(<),
            Comparison::AtLeast => quote!(>=),
        };
        let place = [a, b].into_iter().find_map(|side| match side {
            Expr::Place(place) => Some(*place),
            _ => None,
        });
        let ty = place.map_or(Type::Bool, |place| self.program.places[place.0].ty);
        let side = |side: &Expr<'m>| self.typed(side, ty, Binds::Sum);
        let (left, right) = (side(a), side(b));
        match place {
            Some(place) if matches!(comparison, Comparison::Equal | Comparison::Differs) => {
                self.compared(place, &left, &sign, &right)
            }
            _ => quote!(#left #sign #right),
        }
    }
}

/// The name of the type of some kinds, which stands beside Rust of the user.
pub(super) fn kind_type(ty: Type<'_>) -> Ident {
    let Type::Kind { list, .. } = ty else { return names::own("__Kind") };
    names::own(&format!("__Kind{list}"))
}

/// The name of one of them.
pub(super) fn kind_variant(kind: i128) -> Ident {
    names::own(&format!("K{kind}"))
}
