//! What the notation has and the compiler does not compile yet: an error that says so, at its tokens.

use crate::ast::{self, Item, Property, Setting};
use crate::diagnostic::{Mark, Sink};

/// Reports everything in the chart that cannot be compiled yet.
pub fn not_yet(chart: &ast::Chart, sink: &mut Sink) {
    for item in &chart.body.items {
        match item {
            Item::Setting(Setting::Budget { keyword, .. }) => report(*keyword, "`budget`", sink),
            Item::Setting(Setting::AssumeNever { keyword, .. }) => report(*keyword, "`assume`", sink),
            Item::Property(
                Property::Never { keyword, .. } | Property::Always { keyword, .. } | Property::Home { keyword, .. },
            ) => report(*keyword, "a property", sink),
            _ => {}
        }
    }
}

fn report(mark: impl Into<Mark>, what: &str, sink: &mut Sink) {
    sink.notation(mark, format!("{what} cannot be compiled yet"));
}
