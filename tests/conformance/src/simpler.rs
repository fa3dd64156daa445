//! What could be left out of a chart whose lines are single declarations, associations and transitions.

use std::collections::BTreeSet;

/// Charts with something left out, the boldest first.
#[must_use]
pub fn simpler(text: &str) -> Vec<String> {
    let lines: Vec<&str> = text.lines().collect();
    let mut charts = Vec::new();
    let units = units(&lines);
    let mut size = units.len() / 2;
    while size > 1 {
        for chunk in units.chunks(size) {
            charts.push(without(&lines, &chunk.iter().flatten().copied().collect()));
        }
        size /= 2;
    }
    for unit in &units {
        charts.push(without(&lines, unit));
        charts.push(without(&lines, &with_arrows(&lines, unit)));
    }
    for (index, line) in lines.iter().enumerate() {
        for simpler in simpler_line(line) {
            let mut changed: Vec<&str> = lines.clone();
            changed[index] = &simpler;
            charts.push(changed.iter().map(|line| format!("{line}\n")).collect());
        }
    }
    charts
}

fn without(lines: &[&str], gone: &BTreeSet<usize>) -> String {
    let kept = lines.iter().enumerate().filter(|(index, _)| !gone.contains(index));
    kept.map(|(_, line)| format!("{line}\n")).collect()
}

/// Single lines and whole blocks, the chart's own braces excepted.
fn units(lines: &[&str]) -> Vec<BTreeSet<usize>> {
    let mut units = Vec::new();
    for (index, line) in lines.iter().enumerate().take(lines.len() - 1).skip(1) {
        if *line == "}" {
            continue;
        }
        let mut end = index;
        if line.ends_with('{') {
            let mut depth = 1;
            while depth > 0 && end + 1 < lines.len() {
                end += 1;
                depth += i32::from(lines[end].ends_with('{')) - i32::from(lines[end] == "}");
            }
        }
        units.push((index..=end).collect());
    }
    units
}

/// A block of steps with the transitions that touch them.
fn with_arrows(lines: &[&str], unit: &BTreeSet<usize>) -> BTreeSet<usize> {
    let steps: Vec<&str> =
        unit.iter().filter_map(|index| lines[*index].split("step ").nth(1)?.split(' ').next()).collect();
    let touches = |line: &str| {
        let outside = format!("{} {}", line.split("-[").next().unwrap_or(""), line.split("]->").nth(1).unwrap_or(""));
        let mut words = outside.split(|c: char| !c.is_alphanumeric());
        line.contains("]->") && words.any(|word| steps.contains(&word))
    };
    let arrows = lines.iter().enumerate().filter(|(_, line)| touches(line)).map(|(index, _)| index);
    unit.iter().copied().chain(arrows).collect()
}

/// A line with an operand, a condition or an action on clearing left out.
fn simpler_line(line: &str) -> Vec<String> {
    let mut found = Vec::new();
    if let (Some(start), Some(end)) = (line.find(" => "), line.find("]->")) {
        found.push(format!("{}{}", &line[..start], &line[end..]));
    }
    if let (Some(start), Some(end)) = (line.find("-["), line.find("]->")) {
        let clearing = line.find(" => ").unwrap_or(end);
        found.extend(["true", "a", "b"].map(|c| format!("{}{c}{}", &line[..start + 2], &line[clearing..])));
    }
    if let Some(start) = line.find(" if ").filter(|_| !line.contains('{')) {
        found.push(format!("{};", &line[..start]));
    }
    for (start, _) in line.match_indices("frag_") {
        // What is meant, without the macro.
        found.push(format!("{}{}", &line[..start], &line[start + "frag_e!".len()..]));
    }
    for (start, _) in line.match_indices('(') {
        let Some(end) = closing(line, start) else { continue };
        let inside = &line[start + 1..end];
        let mut put = |by: &str| found.push(format!("{}{by}{}", &line[..start], &line[end + 1..]));
        for operator in [" && ", " || ", " ^ ", " != ", " + "] {
            if let Some((left, right)) = split(inside, operator) {
                put(left);
                put(right);
            }
        }
        if !line.contains("/(") || inside.starts_with('(') {
            put(inside);
        }
        if line[..start].ends_with(['(', ' ', '[', '!']) {
            put("a");
        }
    }
    found
}

fn closing(line: &str, start: usize) -> Option<usize> {
    let mut depth = 0;
    line[start..].char_indices().find_map(|(index, c)| {
        depth += i32::from(c == '(') - i32::from(c == ')');
        (depth == 0).then_some(start + index)
    })
}

/// At an operator outside all parentheses.
fn split<'t>(text: &'t str, operator: &str) -> Option<(&'t str, &'t str)> {
    let outside = |index: &usize| text[..*index].matches('(').count() == text[..*index].matches(')').count();
    let index = text.match_indices(operator).map(|(index, _)| index).find(outside)?;
    Some((&text[..index], &text[index + operator.len()..]))
}
