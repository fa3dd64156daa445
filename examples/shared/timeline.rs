//! A run of a chart as lines in the terminal, one a cycle.

use std::fmt::{Debug, Display};
use std::io::{self, Write};

use anstream::adapter::strip_str;
use anstyle::{AnsiColor, Style};
use grafcet::Chart;

use super::super::script::{Named, Signals, Value};
use super::{BOLD, COLUMNS};

const DIM: Style = Style::new().dimmed();
const REMARK: Style = AnsiColor::Cyan.on_default();

/// How signals are shown.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Look {
    /// By their names.
    Names,
    /// By a mark below their names, where all the names would make the line too long.
    Marks,
}

impl Look {
    /// The names of signals get so much of a line; the rest is for the steps, the picture and the remark.
    const NAMES: usize = 38;

    fn of<C: Chart<Inputs: Signals, Outputs: Signals>>() -> Self {
        let names = Self::Names.group::<C::Inputs>() + Self::Names.group::<C::Outputs>();
        if names <= Self::NAMES { Self::Names } else { Self::Marks }
    }

    /// How wide the column of a signal is: after a number's name is the number.
    fn column(self, name: &str, value: Value) -> usize {
        const NUMBER: usize = "9999".len();
        match (self, value) {
            (Self::Names, Value::Flag(_)) => name.len(),
            (Self::Names, Value::Number(_)) => name.len() + "=".len() + NUMBER,
            (Self::Marks, Value::Flag(_)) => 1,
            (Self::Marks, Value::Number(_)) => NUMBER,
        }
    }

    /// The signals with the widths of their columns.
    fn columns<T: Signals>(self) -> Vec<(&'static str, usize)> {
        let types = T::default();
        T::NAMES.iter().zip(types.values()).map(|(name, value)| (*name, self.column(name, value))).collect()
    }

    /// A group of columns is as wide as these with a blank after each and one more; of names, at least as its title.
    fn group<T: Signals>(self) -> usize {
        let columns: usize = self.columns::<T>().iter().map(|(_, width)| width + 1).sum();
        let title = if self == Self::Names { "outputs".len() } else { 0 };
        columns.max(title + 1) + 1
    }

    /// What stands there for a signal that is neither false nor zero.
    fn raised(self, name: &str, value: Value) -> String {
        match (self, value) {
            (Self::Names, _) => Named(name, value).to_string(),
            (Self::Marks, Value::Flag(_)) => "●".to_owned(),
            (Self::Marks, Value::Number(number)) => number.to_string(),
        }
    }
}

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
    look: Look,
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
        let look = Look::of::<C>();
        writeln!(out, "{BOLD}{}{BOLD:#}  {legend}", C::NAME)?;
        let shown = match look {
            Look::Names => "shows its name while true, · while false",
            Look::Marks => "shows ● while true, · while false",
        };
        writeln!(out, "A line is a cycle. A signal {shown}.\n")?;
        let longest = C::STEPS.iter().map(|step| names(&[step]).len()).max().unwrap_or(0);
        let title = if look == Look::Marks { "outputs" } else { "step" };
        let width = names(widest).len().max(longest).max(title.len());
        match look {
            Look::Names => {
                let (inputs, outputs) = (look.group::<C::Inputs>(), look.group::<C::Outputs>());
                let title = format!("     {:width$}  {:inputs$}{:outputs$}{plant}", "step", "inputs", "outputs");
                writeln!(out, "{DIM}{title}{DIM:#}")?;
            }
            Look::Marks => {
                let mut lines = String::new();
                below_each_other(out, "inputs", width, &look.columns::<C::Inputs>(), &mut lines)?;
                below_each_other(out, "outputs", width, &look.columns::<C::Outputs>(), &mut lines)?;
                writeln!(out, "{DIM}     {:width$}  {lines}{plant}{DIM:#}", "step")?;
            }
        }
        Ok(Self { out, colour, cycle: 0, above: Vec::new(), width, look })
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
        let mut line = format!("{:3}  {style}{:width$}{style:#}  ", self.cycle, names(&active));
        line += &signals(self.look, inputs, |_| BOLD);
        line += &signals(self.look, outputs, self.colour);
        line += &plant.to_string();
        if !remark.is_empty() {
            let shown = strip_str(&line).to_string().chars().count() + 2 + remark.chars().count();
            // Where it does not fit after, it stands below the steps.
            line += if shown <= COLUMNS.into() { "  " } else { "\n     └ " };
            let remark = format!("{REMARK}{remark}{REMARK:#}");
            line += &remark;
        }
        writeln!(self.out, "{line}")?;
        self.above = active;
        self.cycle += 1;
        Ok(())
    }
}

fn names(steps: &[impl Debug]) -> String {
    let names: Vec<String> = steps.iter().map(|step| format!("{step:?}")).collect();
    names.join("+")
}

/// The names of signals, each above its column in a line of its own; `lines` leads down from those before.
fn below_each_other(
    out: &mut dyn Write,
    title: &str,
    width: usize,
    columns: &[(&str, usize)],
    lines: &mut String,
) -> io::Result<()> {
    for (index, (name, column)) in columns.iter().enumerate() {
        let title = if index == 0 { title } else { "" };
        writeln!(out, "{DIM}     {title:width$}  {lines}{name}{DIM:#}")?;
        let down = format!("{:column$} ", "│");
        *lines += &down;
    }
    lines.push(' ');
    Ok(())
}

/// The columns of these signals.
fn signals<T: Signals>(look: Look, signals: &T, colour: impl Fn(&str) -> Style) -> String {
    let mut line = String::new();
    let mut rest = look.group::<T>();
    for ((name, width), value) in look.columns::<T>().into_iter().zip(signals.values()) {
        let raised = (colour(name), look.raised(name, value));
        let (style, text) = if value.is_raised() { raised } else { (DIM, "·".to_owned()) };
        let cell = format!("{style}{text:width$}{style:#} ");
        line += &cell;
        rest = rest.saturating_sub(width + 1);
    }
    line + &" ".repeat(rest)
}
