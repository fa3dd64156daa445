//! What checkers write: witnesses of AIGER 1.9 and of BTOR2.
//!
//! What stands around them is left out, as checkers tell of their work on the same output. ABC has its own ways: of a proof it says that there is one, and
//! its witnesses (`write_cex -a`) are those of AIGER without the lines in front, and end with `# DONE`.

use super::Answer;
use crate::circuit::Circuit;
use crate::task::Way;

/// It may have been cut off.
const NO_END: &str = "the witness does not end with a line `.`";

/// The lines that are left, each with its number.
type Lines<'t> = std::iter::Peekable<std::iter::Enumerate<std::str::Lines<'t>>>;

pub(super) fn read(circuit: &Circuit, text: &str) -> Result<Answer, String> {
    let mut lines: Lines<'_> = text.lines().enumerate().peekable();
    let is_state =
        |line: &str| line.len() == circuit.latches.len() && line.bytes().all(|byte| matches!(byte, b'0' | b'1'));
    if lines.peek().is_some_and(|(_, line)| is_state(line.trim())) {
        return aiger(circuit, lines).map(Answer::Way);
    }
    while let Some((_, line)) = lines.next() {
        match line.trim() {
            "0" | "unsat" => return Ok(Answer::Never),
            line if line.starts_with("Property proved") => return Ok(Answer::Never),
            "2" | "unknown" => return Ok(Answer::Open("the checker has not found it out".to_owned())),
            "1" if is_property(&mut lines) => return aiger(circuit, lines).map(Answer::Way),
            "sat" if is_property(&mut lines) => return btor2(circuit, lines).map(Answer::Way),
            _ => {}
        }
    }
    Err("there is no witness in it: no line `1` and after it the number of the property (`b0`), and no line `0`"
        .to_owned())
}

/// Whether the line after is the property, `b0`; it is taken, then.
fn is_property(lines: &mut Lines<'_>) -> bool {
    let is = |line: &str| {
        line.split_whitespace().all(|word| {
            word.strip_prefix('b')
                .is_some_and(|number| !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit()))
        }) && !line.trim().is_empty()
    };
    lines.next_if(|(_, line)| is(line)).is_some()
}

fn is_comment(line: &str) -> bool {
    line.starts_with('c') || line.starts_with(';')
}

/// The latches as they begin, then the inputs of each cycle, in the order of the circuit.
fn aiger(circuit: &Circuit, lines: Lines<'_>) -> Result<Way, String> {
    let mut lines = lines.filter(|(_, line)| !is_comment(line));
    let cut = || NO_END.to_owned();
    let (number, line) = lines.next().ok_or_else(cut)?;
    let latches = values(number, line, circuit.latches.len(), "latches")?;
    let mut way = Way { initial: Vec::new(), inputs: Vec::new() };
    for (index, (latch, value)) in circuit.latches.iter().zip(latches).enumerate() {
        match (latch.initial, value) {
            (Some(initial), Some(value)) if initial != value => {
                return Err(format!("line {}: latch {index} does not begin so", number + 1));
            }
            (None, value) => way.initial.push((index, value == Some(true))),
            _ => {}
        }
    }
    let nodes = nodes(circuit);
    for (number, line) in lines {
        if line.trim() == "." {
            return Ok(way);
        }
        let (line, done) = line.split_once('#').map_or((line, None), |(line, done)| (line, Some(done)));
        let values = values(number, line, nodes.len(), "inputs")?;
        way.inputs
            .push(sorted(nodes.iter().zip(values).filter(|(_, value)| *value == Some(true)).map(|(node, _)| *node)));
        if done.is_some_and(|done| done.trim() == "DONE") {
            return Ok(way);
        }
    }
    Err(cut())
}

/// So many values; none of a line is any.
fn values(number: usize, line: &str, count: usize, what: &str) -> Result<Vec<Option<bool>>, String> {
    let value = |letter: char| match letter {
        '0' => Ok(Some(false)),
        '1' => Ok(Some(true)),
        'x' | 'X' | '?' => Ok(None),
        _ => Err(format!("line {}: `{letter}` is none of `0`, `1` and `x`", number + 1)),
    };
    let values = line.trim().chars().map(value).collect::<Result<Vec<_>, _>>()?;
    if values.len() == count {
        Ok(values)
    } else {
        Err(format!("line {}: {} values, and the circuit has {count} {what}", number + 1, values.len()))
    }
}

/// By node, in the order in which the circuit is written.
fn nodes(circuit: &Circuit) -> Vec<usize> {
    circuit.inputs.iter().flat_map(|wire| wire.bits.iter().map(|bit| bit.node())).collect()
}

fn sorted(nodes: impl Iterator<Item = usize>) -> Vec<usize> {
    let mut nodes: Vec<usize> = nodes.collect();
    nodes.sort_unstable();
    nodes.dedup();
    nodes
}

/// `#0` and what some states begin with, then for each cycle `@n` and what some inputs are: number, value, and the name, which says nothing more.
fn btor2(circuit: &Circuit, lines: Lines<'_>) -> Result<Way, String> {
    let (mut way, nodes) = (Way { initial: Vec::new(), inputs: Vec::new() }, nodes(circuit));
    let mut in_inputs = false;
    for (number, line) in lines.filter(|(_, line)| !is_comment(line)) {
        let wrong = |what: &str| format!("line {}: {what}", number + 1);
        let line = line.trim();
        if line == "." {
            way.inputs.iter_mut().for_each(|on| on.sort_unstable());
            return Ok(way);
        }
        if let Some(cycle) = line.strip_prefix('@') {
            if cycle.parse() != Ok(way.inputs.len()) {
                return Err(wrong(&format!("cycle {} of the witness is missing", way.inputs.len())));
            }
            way.inputs.push(Vec::new());
            in_inputs = true;
            continue;
        }
        if line.starts_with('#') {
            in_inputs = false;
            continue;
        }
        let (index, value) = assigned(line).ok_or_else(|| wrong("that is no assignment: number, value, name"))?;
        if !in_inputs {
            let latch = circuit.latches.get(index).ok_or_else(|| wrong("the circuit has no such state"))?;
            match latch.initial {
                // Later ones follow.
                _ if !way.inputs.is_empty() => {}
                Some(initial) if initial != value => return Err(wrong("the state does not begin so")),
                Some(_) => {}
                None => way.initial.push((index, value)),
            }
            continue;
        }
        let node = *nodes.get(index).ok_or_else(|| wrong("the circuit has no such input"))?;
        if let (Some(on), true) = (way.inputs.last_mut(), value) {
            on.push(node);
        }
    }
    Err(NO_END.to_owned())
}

/// All of them are one bit wide; one that is left open is zero.
fn assigned(line: &str) -> Option<(usize, bool)> {
    let mut words = line.split_whitespace();
    let index = words.next()?.parse().ok()?;
    match words.next()? {
        "1" => Some((index, true)),
        "0" | "x" => Some((index, false)),
        _ => None,
    }
}
