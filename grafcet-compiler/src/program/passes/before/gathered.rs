//! By what a way says whether it has moved: truths that are gathered, and fields that are compared with copies of them.

use super::super::super::{Expr, PlaceId, Program, Statement, Type};
use super::super::uses::{blocks, each_read};

/// The fields that what is gathered compares with copies of them, and the copies: no states, as these are followed by themselves.
pub(super) fn find_copied<'m>(
    program: &Program<'m>,
    statements: &[Statement<'m>],
    gathered: &[PlaceId],
    found: &mut Vec<(PlaceId, PlaceId)>,
) {
    for statement in statements {
        match statement {
            Statement::Set(to, value) if gathered.contains(to) => compared(program, value, found),
            _ => {}
        }
        for block in blocks(statement) {
            find_copied(program, block, gathered, found);
        }
    }
}

fn compared<'m>(program: &Program<'m>, expr: &Expr<'m>, found: &mut Vec<(PlaceId, PlaceId)>) {
    match expr {
        Expr::Not(inner) => compared(program, inner, found),
        Expr::All(parts) | Expr::Any(parts) => parts.iter().for_each(|part| compared(program, part, found)),
        Expr::Compare(_, a, b) => {
            let (Expr::Place(a), Expr::Place(b)) = (&**a, &**b) else { return };
            let is_field = |place: PlaceId| program.places[place.0].is_field;
            let pair = if is_field(*a) { (*a, *b) } else { (*b, *a) };
            let is_state = matches!(program.places[a.0].ty, Type::State(_));
            if is_field(pair.0) && !is_field(pair.1) && !is_state && !found.contains(&pair) {
                found.push(pair);
            }
        }
        _ => {}
    }
}

/// The truths of the cycle by which a place is set.
pub(super) fn find_gathered<'m>(
    program: &Program<'m>,
    statements: &[Statement<'m>],
    place: PlaceId,
    found: &mut dyn FnMut(PlaceId),
) {
    for statement in statements {
        match statement {
            Statement::Set(to, value) if *to == place => each_read(value, &mut |of| {
                let info = &program.places[of.0];
                if !info.is_field && matches!(info.ty, Type::Bool) {
                    found(of);
                }
            }),
            _ => {}
        }
        for block in blocks(statement) {
            find_gathered(program, block, place, found);
        }
    }
}
