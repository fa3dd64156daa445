//! What the screen looks like.

use grafcet_sim::{Signal, Value, happened};
use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::{Color, Style, Stylize};
use ratatui::text::{Line, Span};
use ratatui::widgets::{Block, Paragraph, Wrap};

use super::screen::Screen;
use super::session::Session;

/// Columns of what stands beside the drawing.
const BESIDE: u16 = 38;
/// An active step in the drawing, and a true signal.
const MARK: &str = "●";

pub(crate) fn draw(frame: &mut Frame<'_>, session: &Session<'_>, screen: &Screen) {
    let waits = waits(session);
    let below = u16::try_from(waits.len()).unwrap_or(u16::MAX).clamp(1, 5) + 2;
    let rows = [Constraint::Length(1), Constraint::Min(5), Constraint::Length(below), Constraint::Length(1)];
    let [head, body, foot, help] = Layout::vertical(rows).areas(frame.area());
    let [left, right] = Layout::horizontal([Constraint::Min(20), Constraint::Length(BESIDE)]).areas(body);
    frame.render_widget(Line::from(title(session, screen)).bold(), head);
    drawing(frame, left, session, screen);
    beside(frame, right, session, screen);
    let block = Block::bordered().title("Waits for");
    frame.render_widget(Paragraph::new(waits).wrap(Wrap { trim: false }).block(block), foot);
    frame.render_widget(keys(screen), help);
}

fn title(session: &Session<'_>, screen: &Screen) -> String {
    let names = session.names();
    let kind = if names.is_grafcet { "grafcet" } else { "sfc" };
    let cycles = match session.script().len() {
        0 => "before the first cycle".to_owned(),
        number => format!("cycle {}", number - 1),
    };
    let (time, step) = (names.time(session.elapsed()), names.time(session.step().into()));
    let runs = if screen.running { "running" } else { "stopped" };
    format!("{} · {kind} · {cycles} · {time} · time step {step} · {runs}", names.chart)
}

/// The chart, moved so that its first active step can be seen.
fn drawing(frame: &mut Frame<'_>, area: Rect, session: &Session<'_>, screen: &Screen) {
    let text = session.chart().text(&session.simulation().steps());
    let lines: Vec<&str> = text.lines().collect();
    let (columns, rows) = (i32::from(area.width) - 2, i32::from(area.height) - 2);
    let at = lines.iter().enumerate().find_map(|(row, line)| {
        let column = line.split_once(MARK)?.0.chars().count();
        Some((i32::try_from(column).ok()?, i32::try_from(row).ok()?))
    });
    let (column, row) = at.unwrap_or((0, 0));
    let width = lines.iter().map(|line| line.chars().count()).max().unwrap_or(0);
    // In the middle, where not all of it can be seen.
    let moved = |all: usize, room: i32, mark: i32, by: i32| {
        let most = i32::try_from(all).unwrap_or(i32::MAX).saturating_sub(room).max(0);
        u16::try_from((mark - room / 2 + by).clamp(0, most)).unwrap_or(0)
    };
    let scroll = (moved(lines.len(), rows, row, screen.scroll.1), moved(width, columns, column, screen.scroll.0));
    let marked = lines.iter().map(|line| {
        let parts = line.split_inclusive(MARK).flat_map(|part| match part.strip_suffix(MARK) {
            Some(before) => vec![Span::raw(before), Span::styled(MARK, lit())],
            None => vec![Span::raw(part)],
        });
        parts.collect::<Line<'_>>()
    });
    let shown = Paragraph::new(marked.collect::<Vec<_>>()).scroll(scroll);
    frame.render_widget(shown.block(Block::bordered().title("Chart")), area);
}

fn beside(frame: &mut Frame<'_>, area: Rect, session: &Session<'_>, screen: &Screen) {
    let (inputs, outputs, cycle) = (inputs(session, screen), outputs(session), cycle(session));
    let room = area.height.saturating_sub(5);
    let rows = |lines: &[Line<'_>]| u16::try_from(lines.len()).unwrap_or(u16::MAX).saturating_add(2);
    // The inputs take what they need up to half, so that the rest can be seen.
    let first = rows(&inputs).min((room / 2).max(3)).max(room.saturating_sub(rows(&outputs)).min(rows(&inputs)));
    let parts = [Constraint::Length(first), Constraint::Max(rows(&outputs)), Constraint::Min(5)];
    let [top, middle, bottom] = Layout::vertical(parts).areas(area);
    let hidden = u16::try_from(screen.selected).unwrap_or(0).saturating_sub(first.saturating_sub(3));
    frame.render_widget(Paragraph::new(inputs).scroll((hidden, 0)).block(Block::bordered().title("Inputs")), top);
    frame.render_widget(Paragraph::new(outputs).block(Block::bordered().title("Outputs")), middle);
    let shown = Paragraph::new(cycle).wrap(Wrap { trim: false });
    frame.render_widget(shown.block(Block::bordered().title("Last cycle")), bottom);
}

fn inputs(session: &Session<'_>, screen: &Screen) -> Vec<Line<'static>> {
    let signals = session.signals().len();
    let all = session.shown().iter().zip(session.shown_values()).enumerate();
    let line = |(place, (signal, value)): (usize, (&Signal, &Value))| {
        let key = screen.keys.get(place).copied().flatten().unwrap_or(' ');
        let chosen = place == screen.selected;
        let typed = screen.typing.as_ref().filter(|_| chosen).map(|text| format!("{text}_"));
        let (mark, kind) = (if chosen { "›" } else { " " }, if place < signals { "" } else { "param " });
        let line = valued(&format!("{mark}{key} {kind}{}", signal.name), value, typed);
        if chosen { line.reversed() } else { line }
    };
    all.map(line).collect()
}

/// The outputs, and after them the variables.
fn outputs(session: &Session<'_>) -> Vec<Line<'static>> {
    let (names, simulation) = (session.names(), session.simulation());
    let outputs = names.outputs.iter().zip(simulation.outputs());
    let all = outputs.chain(names.variables.iter().zip(simulation.variables()));
    all.map(|(signal, value)| valued(&format!("  {}", signal.name), &value, None)).collect()
}

/// A name with its value at the right edge.
fn valued(name: &str, value: &Value, typed: Option<String>) -> Line<'static> {
    let value = typed.unwrap_or_else(|| match value {
        Value::Bool(true) => MARK.to_owned(),
        Value::Bool(false) => String::new(),
        value => value.to_string(),
    });
    let room = usize::from(BESIDE - 4).saturating_sub(value.chars().count());
    let name: String = name.chars().take(room).collect();
    let style = if value == MARK { lit() } else { Style::new() };
    Line::from(vec![Span::raw(format!("{name:<room$} ")), Span::styled(value, style)])
}

/// The active steps, and what the last cycle did.
fn cycle(session: &Session<'_>) -> Vec<Line<'static>> {
    let (names, simulation) = (session.names(), session.simulation());
    let steps: Vec<&str> = simulation.steps().into_iter().map(|step| names.steps[step].name.as_str()).collect();
    let active = if steps.is_empty() { "no active step".to_owned() } else { format!("in {}", steps.join(", ")) };
    let mut lines = vec![Line::from(active)];
    if let Some(cycle) = session.last() {
        lines.extend(happened(names, cycle).into_iter().map(Line::from));
        let ran = cycle.ran.iter().map(|ran| Line::from(format!("{}: {}", names.steps[ran.step].name, ran.text)));
        lines.extend(ran);
    }
    lines.extend(simulation.late_steps().into_iter().map(|step| Line::from(format!("{step} is late")).red()));
    lines
}

fn waits(session: &Session<'_>) -> Vec<Line<'static>> {
    let blocked = session.simulation().blocked();
    blocked.to_string().lines().map(|line| Line::from(line.to_owned())).collect()
}

fn keys(screen: &Screen) -> Line<'static> {
    if let Some(steps) = &screen.forcing {
        return Line::from(format!("steps by hand, with commas: {steps}_  Enter makes the cycle, Esc leaves it"));
    }
    match (&screen.message, &screen.typing) {
        (Some(message), _) => Line::from(message.clone()).fg(Color::Yellow),
        (None, Some(_)) => Line::from("type a value, Enter takes it, Esc leaves it"),
        (None, None) => Line::from("Enter cycle  Space run  Backspace back  + - step  letter input  ^S save  Esc end"),
    }
}

fn lit() -> Style {
    Style::new().fg(Color::Green).bold()
}
