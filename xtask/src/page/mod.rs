//! The page of a replay in a browser: buttons, keys, the slider, dragging along the time, and addresses. What it shows is compared with the data in it.

mod browser;

use std::fs;

use serde_json::{Value, json};

pub(crate) use self::browser::find_browser;

use self::browser::Browser;
use crate::command::{Result, capture};
use crate::project::{self, cargo};

/// A window in which all of the chronogram is to be seen, and one in which it has to be scrolled.
const WINDOWS: [(u32, u32); 2] = [(1400, 900), (800, 600)];

/// Runs the script of the page, in both windows.
///
/// # Errors
/// Chromium is missing, or the page shows something else than its data says, or throws.
pub(crate) fn run() -> Result {
    let folder = project::target("page");
    fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let page = folder.join("cell");
    let run = ["run", "--quiet", "--package", "grafcet-sim", "--example", "replay", "--"];
    let script = ["examples/charts/cell.rs", "Cell", "examples/charts/cell.script"];
    capture(cargo(&run).args(script).arg(&page))?;
    let url = format!("file://{}.html", page.display());
    for window in WINDOWS {
        let browser = Browser::start(&folder.join("profile"), window)?;
        let mut visit = Visit { browser, url: url.clone(), data: Value::Null, checks: 0 };
        visit.all().map_err(|error| format!("{}×{}: {error}", window.0, window.1))?;
        println!("page: {} checks in a window of {}×{}", visit.checks, window.0, window.1);
    }
    Ok(())
}

/// A page that is being tried.
struct Visit {
    browser: Browser,
    url: String,
    /// What the page has been made of.
    data: Value,
    checks: usize,
}

/// All that can be seen: the texts beside the chart, the marks in it, and where the time stands.
const SHOWN: &str = r##"(() => {
  const at = id => document.getElementById(id), list = query => [...document.querySelectorAll(query)];
  return {
    now: at("now").textContent, which: at("which").textContent, slider: Number(at("time").value),
    disabled: ["back", "on", "up", "down"].map(id => at(id).disabled),
    marks: list(".chart [data-steps]").map(mark => [mark.dataset.steps, mark.classList.contains("on")]),
    span: Number(at("span").getAttribute("x")),
    inputs: list("#inputs dd").map(value => value.textContent), outputs: list("#outputs dd").map(value => value.textContent),
  };
})()"##;

impl Visit {
    fn all(&mut self) -> Result {
        self.browser.open(&self.url.clone())?;
        self.data = self.browser.value("JSON.parse(document.getElementById('data').textContent)")?;
        if self.last() < 10 {
            return Err(format!("only {} cycles to look at", self.last() + 1));
        }
        self.shows("opened", 0, None)?;
        self.buttons()?;
        self.keys()?;
        self.slider()?;
        self.drags()?;
        self.addresses()?;
        self.covered()?;
        match self.browser.problems.first() {
            Some(problem) => Err(format!("the page has an error: {problem}")),
            None => Ok(()),
        }
    }

    fn last(&self) -> usize {
        self.data["cycles"].as_array().map_or(0, Vec::len) - 1
    }

    fn evolutions(&self, cycle: usize) -> usize {
        self.data["cycles"][cycle]["evolutions"].as_array().map_or(0, Vec::len)
    }

    /// The first cycle from one on with so many evolutions or more.
    fn busy(&self, from: usize, evolutions: usize) -> Result<usize> {
        let found = (from..=self.last()).find(|cycle| self.evolutions(*cycle) >= evolutions);
        found.ok_or_else(|| format!("no cycle has {evolutions} evolutions"))
    }

    /// That a cycle is shown, after so many of its evolutions or after all.
    fn shows(&mut self, what: &str, cycle: usize, done: Option<usize>) -> Result {
        let (all, last) = (self.evolutions(cycle), self.last());
        let done = done.unwrap_or(all);
        let here = &self.data["cycles"][cycle];
        let steps = match done {
            _ if done == all => &here["steps"],
            0 => &self.data["cycles"][cycle - 1]["steps"],
            _ => &here["evolutions"][done - 1]["steps"],
        };
        let active: Vec<u64> = steps.as_array().into_iter().flatten().filter_map(Value::as_u64).collect();
        let time = here["time"].as_str().unwrap_or_default();
        let found = self.browser.value(SHOWN)?;
        let is_active = |ids: &str| ids.split(' ').any(|id| id.parse().is_ok_and(|id| active.contains(&id)));
        let marks = found["marks"].as_array().into_iter().flatten();
        let marks: Vec<Value> =
            marks.map(|mark| json!([mark[0], is_active(mark[0].as_str().unwrap_or_default())])).collect();
        let texts = |kind: &str| -> Vec<String> {
            let values = here[kind].as_array().into_iter().flatten();
            let text = |value: &Value| match value {
                Value::Bool(value) => u8::from(*value).to_string(),
                value => value.as_str().unwrap_or_default().to_owned(),
            };
            values.map(text).collect()
        };
        let number = |value: &Value| value.as_f64().unwrap_or(f64::NAN);
        let starts = &self.data["starts"];
        let end = number(&starts[last + 1]);
        let span = number(&self.data["left"]) + number(&starts[cycle]) * number(&self.data["length"]) / end;
        let expected = json!({
            "now": if time.is_empty() { format!("cycle {cycle}") } else { format!("cycle {cycle} · {time}") },
            "which": if all == 0 { "no evolution".to_owned() } else { format!("evolution {done} of {all}") },
            "slider": cycle,
            "disabled": [cycle == 0, cycle == last, cycle == 0 && done == 0, cycle == last && done == all],
            "marks": marks,
            "inputs": texts("inputs"),
            "outputs": texts("outputs"),
        });
        self.checks += 1;
        for (name, value) in expected.as_object().into_iter().flatten() {
            if found[name] != *value {
                return Err(format!("{what}: `{name}` is {}, not {value}", found[name]));
            }
        }
        if (number(&found["span"]) - span).abs() > 0.01 {
            return Err(format!("{what}: the mark of the time is at {}, not {span}", found["span"]));
        }
        if marks_on(&found) == 0 {
            return Err(format!("{what}: no step is marked"));
        }
        Ok(())
    }

    fn buttons(&mut self) -> Result {
        for cycle in 1..=3 {
            self.browser.click("#on")?;
            self.shows("▶", cycle, None)?;
        }
        self.browser.click("#back")?;
        self.shows("◀", 2, None)?;
        let busy = self.busy(3, 2)?;
        for cycle in 3..busy {
            self.browser.click("#on")?;
            self.shows("▶", cycle, None)?;
        }
        for done in 1..=self.evolutions(busy) {
            self.browser.click("#down")?;
            self.shows("›", busy, Some(done))?;
        }
        for done in (0..self.evolutions(busy)).rev() {
            self.browser.click("#up")?;
            self.shows("‹", busy, Some(done))?;
        }
        self.browser.click("#up")?;
        self.shows("‹ over the begin of a cycle", busy - 1, None)
    }

    fn keys(&mut self) -> Result {
        let last = self.last();
        self.browser.key("End")?;
        self.shows("End", last, None)?;
        self.browser.key("ArrowRight")?;
        self.shows("→ at the end", last, None)?;
        self.browser.key("ArrowLeft")?;
        self.shows("←", last - 1, None)?;
        self.browser.key("Home")?;
        self.shows("Home", 0, None)?;
        self.browser.key("ArrowLeft")?;
        self.shows("← at the begin", 0, None)?;
        // Every evolution of the run, one after the other.
        for cycle in 1..=last {
            for done in 1..=self.evolutions(cycle).max(1) {
                self.browser.key(".")?;
                self.shows(".", cycle, Some(done.min(self.evolutions(cycle))))?;
            }
        }
        self.browser.key(".")?;
        self.shows(". at the end", last, None)?;
        for done in (0..self.evolutions(last)).rev() {
            self.browser.key(",")?;
            self.shows(",", last, Some(done))?;
        }
        self.browser.key(",")?;
        self.shows(", over the begin of a cycle", last - 1, None)
    }

    /// The slider has keys of its own.
    fn slider(&mut self) -> Result {
        self.browser.key("Home")?;
        self.browser.value("document.getElementById('time').focus()")?;
        for cycle in 1..=3 {
            self.browser.key("ArrowRight")?;
            self.shows("→ on the slider", cycle, None)?;
        }
        self.browser.key("ArrowLeft")?;
        self.shows("← on the slider", 2, None)?;
        self.browser.value("document.getElementById('time').blur()").map(|_| ())
    }

    /// Where a cycle is on the chronogram, in the window: its middle, and a place in its height that is to be seen.
    fn place(&mut self, cycle: usize) -> Result<(f64, f64)> {
        let at = format!(
            "(() => {{ const waves = document.querySelector('.waves').getBoundingClientRect(); \
             const box = document.getElementById('chronogram').getBoundingClientRect(); \
             const tick = (data.starts[{cycle}] + data.starts[{cycle} + 1]) / 2; \
             return [box.left + data.left + tick * data.length / data.starts[data.starts.length - 1], waves.top + 40, waves.left, waves.right]; }})()"
        );
        let at = self.browser.value(&at)?;
        let [x, y, left, right] = [0, 1, 2, 3].map(|part| at[part].as_f64().unwrap_or(f64::NAN));
        if (left..right).contains(&x) { Ok((x, y)) } else { Err(format!("cycle {cycle} is not to be seen")) }
    }

    fn drags(&mut self) -> Result {
        self.browser.key("Home")?;
        let from = self.place(3)?;
        self.browser.mouse("mouseMoved", from, false)?;
        self.shows("the mouse comes", 0, None)?;
        self.browser.mouse("mousePressed", from, true)?;
        self.shows("pressed", 3, None)?;
        for cycle in [4, 5, 7, 6] {
            let to = self.place(cycle)?;
            self.browser.mouse("mouseMoved", to, true)?;
            self.shows("dragged", cycle, None)?;
        }
        // Before the first cycle there is nothing.
        self.browser.mouse("mouseMoved", (2.0, from.1), true)?;
        self.shows("dragged out to the left", 0, None)?;
        // At the right edge of what is to be seen the pointer stays at its cycle: nothing scrolls under it.
        let edge = "(() => { const waves = document.querySelector('.waves'); const box = waves.getBoundingClientRect(); \
                    const x = box.left + waves.clientWidth - 3; \
                    const tick = (x - document.getElementById('chronogram').getBoundingClientRect().left - data.left) \
                    * data.starts[data.starts.length - 1] / data.length; \
                    return [x, data.starts.slice(0, -1).findLastIndex(start => start <= tick)]; })()";
        let edge = self.browser.value(edge)?;
        let (x, cycle) = (edge[0].as_f64().unwrap_or(f64::NAN), edge[1].as_u64().unwrap_or(0));
        let cycle = usize::try_from(cycle).unwrap_or(0);
        for round in 0..3 {
            self.browser.mouse("mouseMoved", (x - f64::from(round % 2) * 0.5, from.1), true)?;
            self.shows("dragged to the right edge", cycle, None)?;
        }
        self.browser.mouse("mouseReleased", (x, from.1), true)?;
        self.browser.mouse("mouseMoved", (from.0 + 60.0, from.1), false)?;
        self.shows("released, and the mouse goes", cycle, None)
    }

    fn addresses(&mut self) -> Result {
        let busy = self.busy(1, 2)?;
        let url = format!("{}#{busy}.1", self.url);
        self.browser.open(&url)?;
        self.shows("another address of the same page", busy, Some(1))?;
        self.browser.open("about:blank")?;
        self.browser.open(&url)?;
        self.shows("opened at an evolution", busy, Some(1))?;
        let beyond = format!("{}#99999", self.url);
        self.browser.open(&beyond)?;
        self.shows("an address beyond the end", self.last(), None)
    }

    /// What was never reached is marked while one asks for it.
    fn covered(&mut self) -> Result {
        let count = "document.querySelectorAll('.chart.covered rect.never[data-steps]').length";
        let never = |visit: &mut Self| visit.browser.value(count).map(|count| count.as_u64().unwrap_or(0));
        let before = never(self)?;
        self.browser.click("#covered")?;
        let (during, marks) = (never(self)?, self.browser.value(SHOWN)?);
        let entered = &self.data["entered"];
        let is_never = |ids: &str| ids.split(' ').all(|id| id.parse::<usize>().is_ok_and(|id| entered[id] == 0));
        let marks = marks["marks"].as_array().into_iter().flatten();
        let expected = marks.filter(|mark| is_never(mark[0].as_str().unwrap_or_default())).count();
        self.browser.click("#covered")?;
        self.checks += 1;
        let found = (before, usize::try_from(during).unwrap_or(0), never(self)?);
        if found == (0, expected, 0) { Ok(()) } else { Err(format!("never reached: {found:?}, not {expected}")) }
    }
}

fn marks_on(shown: &Value) -> usize {
    shown["marks"].as_array().into_iter().flatten().filter(|mark| mark[1] == true).count()
}
