//! A run of a chart as lines in the terminal, one a cycle.

use std::fmt::{Debug, Display};
use std::io::{self, Write};

use anstyle::{AnsiColor, Style};
use grafcet::Chart;

use super::super::script::Signals;

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
}

impl<'o, C: Chart<Inputs: Signals, Outputs: Signals>> Timeline<'o, C> {
    /// Begins with a legend; `plant` stands above the pictures.
    pub(crate) fn new(
        out: &'o mut dyn Write,
        colour: fn(&str) -> Style,
        legend: &str,
        plant: &str,
    ) -> io::Result<Self> {
        writeln!(out, "{BOLD}{}{BOLD:#}  {legend}", C::NAME)?;
        writeln!(out, "One line is one cycle. A signal shows its name while it is true and · while it is false.\n")?;
        let (steps, inputs, outputs) =
            (Self::width_of_steps(), width_of_signals::<C::Inputs>(), width_of_signals::<C::Outputs>());
        let title = format!("cycle  {:steps$}  {:inputs$}  {:outputs$}  {plant}", "step", "inputs", "outputs");
        writeln!(out, "{DIM}{title}{DIM:#}")?;
        Ok(Self { out, colour, cycle: 0, above: Vec::new() })
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
        let width = Self::width_of_steps();
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

    /// The longest name of a step; in a chart with parallel branches more may stand there and moves the rest.
    fn width_of_steps() -> usize {
        C::STEPS.iter().map(|step| names(&[step]).len()).max().unwrap_or(0).max("step".len())
    }
}

fn names(steps: &[impl Debug]) -> String {
    let names: Vec<String> = steps.iter().map(|step| format!("{step:?}")).collect();
    names.join("+")
}

/// A group of columns is as wide as its names and the blanks between them, at least as its title.
fn width_of_signals<T: Signals>() -> usize {
    let names = T::NAMES.iter().map(|name| name.len() + 1).sum::<usize>();
    names.saturating_sub(1).max("outputs".len())
}

fn show_signals<T: Signals>(out: &mut dyn Write, signals: &T, colour: impl Fn(&str) -> Style) -> io::Result<()> {
    let mut rest = width_of_signals::<T>() + 2;
    for (name, value) in T::NAMES.iter().zip(signals.values()) {
        let (style, text) = if value { (colour(name), *name) } else { (DIM, "·") };
        let width = name.len();
        write!(out, "{style}{text:width$}{style:#} ")?;
        rest = rest.saturating_sub(width + 1);
    }
    write!(out, "{:rest$}", "")
}
