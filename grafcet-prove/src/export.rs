//! Circuits for the checkers of the hardware model checking competition: AIGER 1.9, as text and binary, and BTOR2.
//!
//! A property is a bad state, in the order of the chart; what is assumed is a constraint. Names of inputs and latches are in the symbol
//! table: a bit of a number is `name[2]`.

use std::fmt::{self, Write as _};

use grafcet_compiler::analysis::Facts;
use grafcet_compiler::model::Model;
use grafcet_compiler::program::{Program, counted};

use crate::aig::{Lit, Node};
use crate::circuit::Circuit;
use crate::play::wire_name;

/// How a circuit is written as text.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Notation {
    /// AIGER, in its text form.
    Aiger,
    Btor2,
}

/// Why there is none.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum NoCircuit {
    /// It has more gates than are wanted.
    TooLarge,
    /// What in the chart is not modelled.
    Refused(String),
}

impl fmt::Display for NoCircuit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let why = match self {
            Self::TooLarge => "it is too large",
            Self::Refused(why) => why,
        };
        write!(f, "there is no circuit: {why}")
    }
}

/// The cycle of a chart as a circuit, as text; `model` is the chart with its plants. With `largest` it has so many gates at most.
///
/// # Errors
/// There is no circuit: why, as a sentence for the user.
pub fn text(model: &Model, notation: Notation, largest: Option<usize>) -> Result<String, NoCircuit> {
    let program = counted(model, &Facts::of(model));
    let program = program.map_err(|why| NoCircuit::Refused(why.to_string()))?;
    let circuit = match largest {
        Some(largest) => Circuit::within(&program, largest),
        None => Circuit::of(&program),
    };
    let circuit = match circuit {
        Ok(circuit) => circuit,
        Err(why) if why.is_too_large() => return Err(NoCircuit::TooLarge),
        Err(why) => return Err(NoCircuit::Refused(why.to_string())),
    };
    // Only a search asks for its bound while it is unrolled.
    if largest.is_some_and(|largest| circuit.aig.len() > largest) {
        return Err(NoCircuit::TooLarge);
    }
    Ok(match notation {
        Notation::Aiger => aiger_text(&program, &circuit),
        Notation::Btor2 => btor2(&program, &circuit),
    })
}

/// The circuit with the numbers of AIGER: inputs, latches, then gates.
struct Numbered {
    /// By node.
    of_node: Vec<u32>,
    /// The nodes of the gates.
    gates: Vec<usize>,
    inputs: Vec<(Lit, String)>,
    latches: Vec<String>,
}

impl Numbered {
    fn new(program: &Program<'_>, circuit: &Circuit) -> Self {
        let mut inputs = Vec::new();
        for wire in &circuit.inputs {
            let name = wire_name(program, wire).replace('\n', " ");
            for (index, bit) in wire.bits.iter().enumerate() {
                inputs.push((*bit, bit_name(&name, index, wire.bits.len())));
            }
        }
        let mut latches = Vec::new();
        for field in &circuit.fields {
            latches.extend((0..field.width).map(|index| bit_name(&field.name, index, field.width)));
        }
        let mut roots: Vec<Lit> = circuit.latches.iter().map(|latch| latch.next).collect();
        roots.push(circuit.constraint);
        roots.extend(circuit.bad.iter().map(|bad| bad.possible));
        let cone = circuit.aig.cone(&roots);
        let gates: Vec<usize> =
            cone.into_iter().filter(|node| matches!(circuit.aig.node(*node), Node::And(..))).collect();
        let mut of_node = vec![0; circuit.aig.len()];
        let free = inputs.iter().map(|(bit, _)| bit.node());
        let registers = circuit.latches.iter().map(|latch| latch.now.node());
        for (number, node) in (1..).zip(free.chain(registers).chain(gates.iter().copied())) {
            of_node[node] = number;
        }
        Self { of_node, gates, inputs, latches }
    }

    fn code(&self, lit: Lit) -> u32 {
        self.of_node[lit.node()] * 2 + u32::from(lit.is_negated())
    }

    fn header(&self, word: &str, circuit: &Circuit) -> String {
        let (inputs, latches, gates) = (self.inputs.len(), self.latches.len(), self.gates.len());
        let constraints = usize::from(circuit.constraint != Lit::TRUE);
        let most = inputs + latches + gates;
        format!("{word} {most} {inputs} {latches} 0 {gates} {} {constraints}\n", circuit.bad.len())
    }

    fn next(&self, circuit: &Circuit, index: usize, named: bool) -> String {
        let latch = circuit.latches[index];
        let now = self.code(latch.now);
        let initial = latch.initial.map_or(now, u32::from);
        let front = if named { format!("{now} ") } else { String::new() };
        format!("{front}{} {initial}\n", self.code(latch.next))
    }

    fn claims(&self, circuit: &Circuit) -> String {
        let mut text = String::new();
        for bad in &circuit.bad {
            _ = writeln!(text, "{}", self.code(bad.possible));
        }
        if circuit.constraint != Lit::TRUE {
            _ = writeln!(text, "{}", self.code(circuit.constraint));
        }
        text
    }

    fn symbols(&self, circuit: &Circuit) -> String {
        let mut text = String::new();
        for (index, (_, name)) in self.inputs.iter().enumerate() {
            _ = writeln!(text, "i{index} {name}");
        }
        for (index, name) in self.latches.iter().enumerate() {
            _ = writeln!(text, "l{index} {name}");
        }
        for (index, bad) in circuit.bad.iter().enumerate() {
            _ = writeln!(text, "b{index} property {}", bad.property);
        }
        text
    }
}

fn bit_name(name: &str, index: usize, width: usize) -> String {
    if width == 1 { name.to_owned() } else { format!("{name}[{index}]") }
}

/// The text form of AIGER.
#[must_use]
pub fn aiger_text(program: &Program<'_>, circuit: &Circuit) -> String {
    let numbered = Numbered::new(program, circuit);
    let mut text = numbered.header("aag", circuit);
    for (bit, _) in &numbered.inputs {
        _ = writeln!(text, "{}", numbered.code(*bit));
    }
    for index in 0..circuit.latches.len() {
        text.push_str(&numbered.next(circuit, index, true));
    }
    text.push_str(&numbered.claims(circuit));
    for node in &numbered.gates {
        let Node::And(a, b) = circuit.aig.node(*node) else { continue };
        let (a, b) = (numbered.code(a), numbered.code(b));
        _ = writeln!(text, "{} {} {}", numbered.of_node[*node] * 2, a.max(b), a.min(b));
    }
    text.push_str(&numbered.symbols(circuit));
    text
}

/// The binary form.
#[must_use]
pub fn aiger(program: &Program<'_>, circuit: &Circuit) -> Vec<u8> {
    let numbered = Numbered::new(program, circuit);
    let mut bytes = numbered.header("aig", circuit).into_bytes();
    for index in 0..circuit.latches.len() {
        bytes.extend(numbered.next(circuit, index, false).bytes());
    }
    bytes.extend(numbered.claims(circuit).bytes());
    for node in &numbered.gates {
        let Node::And(a, b) = circuit.aig.node(*node) else { continue };
        let (a, b) = (numbered.code(a), numbered.code(b));
        differences(numbered.of_node[*node] * 2, a.max(b), a.min(b), &mut bytes);
    }
    bytes.extend(numbered.symbols(circuit).bytes());
    bytes
}

/// Seven bits a byte, the lowest first.
fn differences(gate: u32, high: u32, low: u32, bytes: &mut Vec<u8>) {
    for mut rest in [gate - high, high - low] {
        while rest >= 0x80 {
            bytes.push(rest.to_le_bytes()[0] | 0x80);
            rest >>= 7;
        }
        bytes.push(rest.to_le_bytes()[0]);
    }
}

/// BTOR2, each bit a vector of one: whoever reads it sees what AIGER says.
#[must_use]
pub fn btor2(program: &Program<'_>, circuit: &Circuit) -> String {
    let numbered = Numbered::new(program, circuit);
    let mut text = "1 sort bitvec 1\n2 zero 1\n3 one 1\n".to_owned();
    let mut line = 3_i64;
    let mut of_node = vec![2_i64; circuit.aig.len()];
    for (bit, name) in &numbered.inputs {
        line += 1;
        of_node[bit.node()] = line;
        _ = writeln!(text, "{line} input 1 {}", name.replace(' ', "_"));
    }
    for (latch, name) in circuit.latches.iter().zip(&numbered.latches) {
        line += 1;
        of_node[latch.now.node()] = line;
        _ = writeln!(text, "{line} state 1 {}", name.replace(' ', "_"));
        if let Some(initial) = latch.initial {
            line += 1;
            _ = writeln!(text, "{line} init 1 {} {}", line - 1, 2 + i64::from(initial));
        }
    }
    let operand = |of_node: &[i64], lit: Lit| of_node[lit.node()] * if lit.is_negated() { -1 } else { 1 };
    for node in &numbered.gates {
        let Node::And(a, b) = circuit.aig.node(*node) else { continue };
        line += 1;
        of_node[*node] = line;
        _ = writeln!(text, "{line} and 1 {} {}", operand(&of_node, a), operand(&of_node, b));
    }
    for latch in &circuit.latches {
        line += 1;
        _ = writeln!(text, "{line} next 1 {} {}", operand(&of_node, latch.now), operand(&of_node, latch.next));
    }
    line += 1;
    _ = writeln!(text, "{line} constraint {}", operand(&of_node, circuit.constraint));
    for bad in &circuit.bad {
        line += 1;
        _ = writeln!(text, "{line} bad {} property_{}", operand(&of_node, bad.possible), bad.property);
    }
    text
}
