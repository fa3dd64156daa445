//! A run of a chart as lines in the terminal, one a cycle.

use std::fmt::{Debug, Display};
use std::io::{self, Write};

use anstyle::{AnsiColor, Style};
use grafcet::Chart;

use super::super::script::{Named, Signals, Value};

const DIM: Style = Style::new().dimmed();
const BOLD: Style = Style::new().bold();
const REMARK: Style = AnsiColor::Cyan.on_default();

/// Shows the cycles of a chart `C`: active steps, inputs, outputs, a picture of the plant, and a remark.
pub(crate) struct Timeline<'o, C: Chart> {
    out: &'o mut dyn Write,
    /// The colour of an output that is true.
    colour: fn(&str) -> Style,
    cycle: usize,
    /// The steps on the line above.
    above: Vec<C::Step>,
    /// How wide the column of the steps is.
    width: usize,
}

impl<'o, C: Chart<Inputs: Signals, Outputs: Signals>> Timeline<'o, C> {
    /// Begins with a legend; `plant` stands above the pictures. Where steps can be active together, `widest` is the
    /// situation that takes the most room.
    pub(crate) fn new(
        out: &'o mut dyn Write,
        colour: fn(&str) -> Style,
        legend: &str,
        plant: &str,
        widest: &[C::Step],
    ) -> io::Result<Self> {
        writeln!(out, "{BOLD}{}{BOLD:#}  {legend}", C::NAME)?;
        writeln!(out, "One line is one cycle. A signal shows its name while it is true and · while it is false.\n")?;
        let longest = C::STEPS.iter().map(|step| names(&[step]).len()).max().unwrap_or(0);
        let steps = names(widest).len().max(longest).max("step".len());
        let (inputs, outputs) = (width_of_signals::<C::Inputs>(), width_of_signals::<C::Outputs>());
        let title = format!("cycle  {:steps$}  {:inputs$}  {:outputs$}  {plant}", "step", "inputs", "outputs");
        writeln!(out, "{DIM}{title}{DIM:#}")?;
        Ok(Self { out, colour, cycle: 0, above: Vec::new(), width: steps })
    }

    /// Shows the cycle that `chart` has just run.
    pub(crate) fn show(
        &mut self,
        chart: &C,
        inputs: &C::Inputs,
        outputs: &C::Outputs,
        plant: impl Display,
        remark: &str,
    ) -> io::Result<()> {
        let active: Vec<C::Step> = C::STEPS.iter().copied().filter(|step| chart.is_active(*step)).collect();
        let style = if active == self.above { Style::new() } else { BOLD };
        let width = self.width;
        write!(self.out, "{:5}  {style}{:width$}{style:#}  ", self.cycle, names(&active))?;
        show_signals(self.out, inputs, |_| BOLD)?;
        show_signals(self.out, outputs, self.colour)?;
        write!(self.out, "{plant}")?;
        if !remark.is_empty() {
            write!(self.out, "  {REMARK}{remark}{REMARK:#}")?;
        }
        writeln!(self.out)?;
        self.above = active;
        self.cycle += 1;
        Ok(())
    }
}

fn names(steps: &[impl Debug]) -> String {
    let names: Vec<String> = steps.iter().map(|step| format!("{step:?}")).collect();
    names.join("+")
}

/// How wide the column of a signal is: its name, and behind a number's name the number.
fn width_of(name: &str, value: Value) -> usize {
    const NUMBER: usize = "=9999".len();
    match value {
        Value::Flag(_) => name.len(),
        Value::Number(_) => name.len() + NUMBER,
    }
}

/// A group of columns is as wide as these and the blanks between them, at least as its title.
fn width_of_signals<T: Signals>() -> usize {
    let types = T::default();
    let columns = T::NAMES.iter().zip(types.values()).map(|(name, value)| width_of(name, value) + 1);
    columns.sum::<usize>().saturating_sub(1).max("outputs".len())
}

fn show_signals<T: Signals>(out: &mut dyn Write, signals: &T, colour: impl Fn(&str) -> Style) -> io::Result<()> {
    let mut rest = width_of_signals::<T>() + 2;
    for (name, value) in T::NAMES.iter().zip(signals.values()) {
        let raised = (colour(name), Named(name, value).to_string());
        let (style, text) = if value.is_raised() { raised } else { (DIM, "·".to_owned()) };
        let width = width_of(name, value);
        write!(out, "{style}{text:width$}{style:#} ")?;
        rest = rest.saturating_sub(width + 1);
    }
    write!(out, "{:rest$}", "")
}
