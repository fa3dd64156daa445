//! Settings, and words of the notation that mean something only elsewhere.

use super::Resolver;
use super::declare::Where;
use crate::ast::{self, Property, Setting, StepKind};
use crate::diagnostic::{Mark, rules};
use crate::model::{Dialect, PartialId};

impl Resolver<'_> {
    /// A statement about the chart as a whole.
    pub(super) fn setting(&mut self, setting: &Setting, place: Where) {
        let (word, keyword) = match setting {
            Setting::Clock { keyword, .. } => ("clock", *keyword),
            Setting::MaxEvolutions { keyword, .. } => ("max_evolutions", *keyword),
            Setting::Budget { keyword, .. } => ("budget", *keyword),
            Setting::AssumeNever { keyword, .. }
            | Setting::AssumeOften { keyword, .. }
            | Setting::AssumeCycle { keyword, .. }
            | Setting::AssumeOrder { keyword, .. }
            | Setting::AssumePure { keyword, .. } => ("assume", *keyword),
            Setting::OptimizeSize { keyword } => ("optimize", *keyword),
            Setting::EncodingFlags { keyword } => ("encoding", *keyword),
            Setting::Forceable { keyword } => ("forceable", *keyword),
            // It is about a partial grafcet, too: see `declare_modes`.
            Setting::Modes { .. } => return,
        };
        if place != Where::Chart {
            let message =
                format!("`{word}` is about the whole chart and stands directly in it, not in {}", place.text());
            return self.sink.notation(keyword, message);
        }
        // What the plant excludes may be said in several lines.
        if word != "assume" && !self.is_first(word, keyword.into()) {
            return;
        }
        match setting {
            Setting::AssumeCycle { longest, .. } if longest.nanos == 0 => {
                let message = "between two cycles some time passes; write `assume cycle within 100ms;`".to_owned();
                self.sink.rule(&rules::BAD_TIME, &[], vec![(longest.span.into(), message)]);
            }
            Setting::Clock { unit, .. } if unit.nanos == 0 => {
                let message = "a clock unit cannot be zero; write `clock 1ms;`".to_owned();
                self.sink.rule(&rules::BAD_TIME, &[], vec![(unit.span.into(), message)]);
            }
            Setting::Clock { unit, .. } => self.model.clock_nanos = unit.nanos,
            Setting::MaxEvolutions { .. } if self.model.dialect == Dialect::Sfc => {
                let message =
                    "an `sfc` makes one evolution a cycle (IEC 61131-3), so it has nothing to bound; remove this";
                self.sink.notation(keyword, message);
            }
            Setting::MaxEvolutions { count, .. } => match count.base10_parse() {
                Ok(0) => self.sink.notation(count.span(), "a cycle has at least one evolution; write 1 or more"),
                Ok(count) => self.model.max_evolutions = Some(count),
                Err(_) => self.sink.notation(count.span(), "more than 4_294_967_295 evolutions cannot be counted"),
            },
            Setting::Budget { count, .. } => match count.base10_parse() {
                Ok(0) => {
                    self.sink.notation(count.span(), "with a budget of 0 nothing can be explored; write 1 or more");
                }
                Ok(count) => self.model.budget = Some(count),
                Err(_) => self
                    .sink
                    .notation(count.span(), "more than 18_446_744_073_709_551_615 situations cannot be counted"),
            },
            Setting::OptimizeSize { .. } => self.model.optimize_size = true,
            Setting::EncodingFlags { .. } => self.model.flags = true,
            Setting::Forceable { .. } => self.model.forceable = true,
            // Names are known only later.
            Setting::AssumeNever { .. }
            | Setting::AssumeOften { .. }
            | Setting::AssumeCycle { .. }
            | Setting::AssumeOrder { .. }
            | Setting::Modes { .. } => {}
            Setting::AssumePure { paths, .. } => self.assume_pure(paths, place),
        }
    }

    /// Properties are about the chart as a whole.
    pub(super) fn refuse_property(&mut self, property: &Property, place: Where) {
        let (word, keyword) = match property {
            Property::Never { keyword, .. } => ("never", *keyword),
            Property::Always { keyword, .. } => ("always", *keyword),
            Property::Home { keyword, .. } => ("home", *keyword),
            Property::LeadsTo { keyword, .. } => ("leads_to", *keyword),
            Property::Before { keyword, .. } => ("before", *keyword),
        };
        if place != Where::Chart {
            let message =
                format!("`{word}` is about the whole chart and stands directly in it, not in {}", place.text());
            self.sink.notation(keyword, message);
        }
    }

    /// Whether this setting stands here for the first time; both places of a second one are reported.
    pub(super) fn is_first(&mut self, word: &'static str, mark: Mark) -> bool {
        let Some((_, first)) = self.settings.iter().find(|(other, _)| *other == word) else {
            self.settings.push((word, mark));
            return true;
        };
        self.sink.notation(*first, format!("`{word}` stands here first, and again further down; keep one of them"));
        self.sink.notation(mark, format!("`{word}` stands here a second time; keep one of them"));
        false
    }

    /// Words in front of a step that mean nothing where it stands.
    pub(super) fn refuse_words(&mut self, step: &ast::Step, partial: PartialId, place: Where) {
        let name = &step.name;
        if let Some(span) = step.linked {
            if self.model.partials[partial].enclosed_by.is_none() {
                let message = format!(
                    "only a step of an enclosure carries an activation link, and `{name}` is in none; \
                     remove `linked`, or put the partial grafcet into an `enclosing step`"
                );
                self.sink.notation(span, message);
            }
        }
        let ends = [("entry", step.entry), ("exit", step.exit)];
        for (word, span) in ends.into_iter().filter_map(|(word, span)| span.map(|span| (word, span))) {
            if !matches!(place, Where::Expansion(_)) {
                let message = format!(
                    "only the expansion of a macro-step has an {word} step, and `{name}` is in none; remove `{word}`, \
                     or put the step into a `macro step`"
                );
                self.sink.notation(span, message);
            }
        }
        let (kind, keyword) = match &step.kind {
            StepKind::Macro(keyword, _) => ("macro-steps", *keyword),
            StepKind::Enclosing(keyword, ..) => ("enclosing steps", *keyword),
            StepKind::Plain(_) => return,
        };
        self.only_in_grafcet(keyword, kind);
    }

    /// Partial grafcets stand directly in a chart, or in an enclosing step.
    pub(super) fn refuse_partial(&mut self, partial: &ast::Partial, place: Where) {
        if place != Where::Chart {
            let message = format!(
                "partial grafcet `{}` stands in {}; write it directly in the chart, or in an `enclosing step`",
                partial.name,
                place.text()
            );
            self.sink.notation(&partial.name, message);
        }
        self.only_in_grafcet(&partial.name, "partial charts");
        if place != Where::Chart || self.model.dialect == Dialect::Sfc {
            // Its steps are missing from where they were meant to be.
            self.lose();
        }
    }

    /// Reports a form of IEC 60848 in an `sfc`.
    pub(super) fn only_in_grafcet(&mut self, mark: impl Into<Mark>, what: &str) {
        if self.model.dialect == Dialect::Sfc {
            let (who, mend) = if self.model.is_plant {
                ("a plant is an `sfc` and", "write it without them")
            } else {
                ("an `sfc`", "make the chart a `grafcet`")
            };
            let message = format!("{who} has no {what}, they are a form of IEC 60848; {mend}");
            self.sink.notation(mark, message);
        }
    }
}
