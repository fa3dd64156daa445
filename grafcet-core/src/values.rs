//! What a chart asks of the types of its values, in words: a type that lacks it is told so where the chart names it.

use crate::Chart;

/// A value that can be copied.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not `Copy`: a chart copies the values of its inputs, outputs, variables and params",
    label = "not `Copy`",
    note = "write `#[derive(Clone, Copy)]` where `{Self}` is declared; what cannot be copied stays outside the chart, after an `action`"
)]
pub trait Value: Copy {}

#[diagnostic::do_not_recommend]
impl<T: Copy> Value for T {}

/// A value that an input or output has before anybody has said which.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `Default`: that is the value of an input or output of which nothing else is said",
    label = "no `Default`",
    note = "write `#[derive(Default)]` where `{Self}` is declared, or `impl Default for {Self}`; an output can state its value: `output name: {Self} = …;`"
)]
pub trait DefaultValue: Default {}

#[diagnostic::do_not_recommend]
impl<T: Default> DefaultValue for T {}

/// A value of which a chart has to know whether it has changed.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not `PartialEq`: what a stored action sets is compared with what it was",
    label = "not `PartialEq`",
    note = "write `#[derive(PartialEq)]` where `{Self}` is declared"
)]
pub trait ComparedValue: PartialEq {}

#[diagnostic::do_not_recommend]
impl<T: PartialEq> ComparedValue for T {}

/// Asks that values of a type can be copied.
#[inline]
pub const fn copied<T: Value>() {}

/// The name that stands at a place of a list; there is one for each variant of an enum. rustc takes far longer for a `match` with an arm for each of thousands.
#[must_use]
#[inline]
pub const fn name_at(names: &[&'static str], place: usize) -> &'static str {
    // An index would be a panic where nothing is optimized.
    match names.split_at_checked(place) {
        Some((_, [name, ..])) => name,
        _ => "",
    }
}

/// The step of a chart at a place of its list. Were the list named in the chart's own code, a check would compute it, which takes rustc long where it has thousands.
#[must_use]
#[inline]
pub fn step_at<C: Chart>(place: usize) -> Option<C::Step> {
    C::STEPS.get(place).copied()
}

/// The default of a type.
#[must_use]
#[inline(always)]
#[expect(clippy::inline_always, reason = "it is the call after it, also where nothing is optimized")]
pub fn default_value<T: DefaultValue>() -> T {
    T::default()
}

/// Whether two values are the same.
#[inline(always)]
#[expect(clippy::inline_always, reason = "it is the comparison, also where nothing is optimized")]
pub fn is_same<T: ComparedValue>(one: &T, other: &T) -> bool {
    one == other
}
