//! Standard function blocks that know no time, written out as the statements that the standard gives for them, over variables of their own.

use super::parser::{Arguments, Expr, Op, Statement};
use super::source::{Section, Variable, same};
use super::walk::{each, names};

/// Their inputs in order, each with the other name that some tools have.
fn inputs(ty: &str) -> Option<&'static [&'static [&'static str]]> {
    Some(match ty {
        "R_TRIG" | "F_TRIG" => &[&["CLK"]],
        "SR" => &[&["S1", "SET1"], &["R", "RESET"]],
        "RS" => &[&["S", "SET"], &["R1", "RESET1"]],
        "CTU" => &[&["CU"], &["R", "RESET"], &["PV"]],
        "CTD" => &[&["CD"], &["LD", "LOAD"], &["PV"]],
        "CTUD" => &[&["CU"], &["CD"], &["R", "RESET"], &["LD", "LOAD"], &["PV"]],
        _ => return None,
    })
}

/// What an instance keeps and gives, with types.
fn parts(ty: &str) -> &'static [(&'static str, bool)] {
    match ty {
        "R_TRIG" | "F_TRIG" => &[("Q", true), ("CLK_before", true)],
        "SR" | "RS" => &[("Q1", true)],
        "CTU" => &[("Q", true), ("CV", false), ("CU_before", true)],
        "CTD" => &[("Q", true), ("CV", false), ("CD_before", true)],
        _ => &[("QU", true), ("QD", true), ("CV", false), ("CU_before", true), ("CD_before", true)],
    }
}

/// `CTU_DINT` counts in `DINT`.
fn counts_in(ty: &str) -> (&str, &str) {
    match ty.split_once('_') {
        Some((block @ ("CTU" | "CTD" | "CTUD"), count)) => (block, count),
        _ => (ty, "INT"),
    }
}

/// Whether an instance of this type can be written out.
pub(super) fn is_one(ty: &str) -> bool {
    inputs(counts_in(&ty.to_uppercase()).0).is_some()
}

/// The calls of an instance become statements; what it keeps becomes variables. False where a call says something else, and nothing is changed.
pub(super) fn written_out(
    instance: &Variable,
    bodies: &mut [&mut Vec<Statement>],
    conditions: &[Expr],
    added: &mut Vec<Variable>,
) -> bool {
    let upper = instance.ty.to_uppercase();
    let (ty, count) = counts_in(&upper);
    let Some(inputs) = inputs(ty) else { return false };
    let calls = bodies.iter().flat_map(|body| calls(body, &instance.name)).collect::<Vec<_>>();
    let values = calls.iter().map(|arguments| values(inputs, arguments)).collect::<Option<Vec<_>>>();
    // An input that is not given keeps its value: that is told where no call gives it.
    let Some(values) = values.filter(|all| {
        !all.is_empty()
            && (0..inputs.len()).all(|input| all.iter().all(|one| one[input].is_some() == all[0][input].is_some()))
    }) else {
        return false;
    };
    // Nor is one written by name.
    let mut written = false;
    for body in &*bodies {
        each(body, &mut |one| {
            let Statement::Assign(target, _) = one else { return };
            written |= target.split_once('.').is_some_and(|(of, _)| same(of, &instance.name));
        });
    }
    if written {
        return false;
    }
    let mut read: Vec<String> = Vec::new();
    for condition in conditions {
        names(condition, &mut read);
    }
    for body in &*bodies {
        each(body, &mut |one| super::walk::expressions(one).into_iter().for_each(|expr| names(expr, &mut read)));
    }
    let is_read = |part: &str| read.iter().any(|name| same(name, &format!("{}.{part}", instance.name)));
    let mut values = values.into_iter();
    for body in &mut *bodies {
        replaced(body, &instance.name, &mut || {
            let given = values.next().unwrap_or_default();
            let mut done = Written { name: &instance.name, given }.statements(ty);
            let unread = |part: &str| part.starts_with('Q') && part != "Q1" && !is_read(part);
            let last = |target: &String| target.rsplit('.').next().is_some_and(unread);
            done.retain(|one| !matches!(one, Statement::Assign(target, _) if last(target)));
            done
        });
    }
    let kept = parts(ty).iter().filter(|(part, _)| !part.starts_with('Q') || *part == "Q1" || is_read(part));
    added.extend(kept.map(|(part, is_bool)| Variable {
        name: format!("{}.{part}", instance.name),
        section: Section::Local,
        constant: false,
        ty: if *is_bool { "BOOL".to_owned() } else { count.to_owned() },
        init: None,
        address: None,
        ..instance.clone()
    }));
    true
}

fn calls<'s>(body: &'s [Statement], name: &str) -> Vec<&'s Arguments> {
    let mut found = Vec::new();
    each(body, &mut |one| {
        if let Statement::Call(of, arguments) = one {
            found.extend(same(of, name).then_some(arguments));
        }
    });
    found
}

/// By input; none where an argument is for another one.
fn values(inputs: &[&[&str]], arguments: &Arguments) -> Option<Vec<Option<Expr>>> {
    let mut values = vec![None; inputs.len()];
    for (index, (name, value)) in arguments.iter().enumerate() {
        let input = match name {
            Some(name) => inputs.iter().position(|names| names.iter().any(|one| same(one, name)))?,
            None => index,
        };
        *values.get_mut(input)? = Some(value.clone());
    }
    Some(values)
}

fn replaced(body: &mut Vec<Statement>, name: &str, with: &mut dyn FnMut() -> Vec<Statement>) {
    let mut done = Vec::new();
    for mut statement in std::mem::take(body) {
        if matches!(&statement, Statement::Call(of, _) if same(of, name)) {
            done.extend(with());
            continue;
        }
        for inner in statement.bodies_mut() {
            replaced(inner, name, with);
        }
        done.push(statement);
    }
    *body = done;
}

/// A call.
struct Written<'n> {
    name: &'n str,
    given: Vec<Option<Expr>>,
}

impl Written<'_> {
    fn part(&self, part: &str) -> Expr {
        Expr::Member(self.name.to_owned(), part.to_owned())
    }

    fn set(&self, part: &str, value: Expr) -> Statement {
        Statement::Assign(format!("{}.{part}", self.name), value)
    }

    /// An input that nobody gives is false.
    fn input(&self, index: usize) -> Expr {
        self.given.get(index).cloned().flatten().unwrap_or(Expr::Bool(false))
    }

    fn number(&self, index: usize) -> Expr {
        self.given.get(index).cloned().flatten().unwrap_or(Expr::Int(0))
    }

    /// It is true and was not.
    fn rises(&self, index: usize, before: &str) -> Expr {
        and(self.input(index), not(self.part(before)))
    }

    /// One more or less, where there is one.
    fn counted(&self, op: Op) -> Vec<Statement> {
        let method = Expr::Call(
            if op == Op::Add { "saturating_add" } else { "saturating_sub" }.to_owned(),
            vec![(None, self.part("CV")), (None, Expr::Int(1))],
        );
        vec![self.set("CV", method)]
    }

    fn statements(&self, ty: &str) -> Vec<Statement> {
        let compared = |op, value| Expr::Binary(op, Box::new(self.part("CV")), Box::new(value));
        let zero = || vec![self.set("CV", Expr::Int(0))];
        match ty {
            "R_TRIG" => vec![self.set("Q", self.rises(0, "CLK_before")), self.set("CLK_before", self.input(0))],
            "F_TRIG" => {
                let falls = and(not(self.input(0)), self.part("CLK_before"));
                vec![self.set("Q", falls), self.set("CLK_before", self.input(0))]
            }
            "SR" => vec![self.set("Q1", or(self.input(0), and(not(self.input(1)), self.part("Q1"))))],
            "RS" => vec![self.set("Q1", and(not(self.input(1)), or(self.input(0), self.part("Q1"))))],
            "CTU" => vec![
                Statement::If(
                    some([(self.given[1].clone(), zero()), (Some(self.rises(0, "CU_before")), self.counted(Op::Add))]),
                    Vec::new(),
                ),
                self.set("CU_before", self.input(0)),
                self.set("Q", compared(Op::AtLeast, self.number(2))),
            ],
            "CTD" => vec![
                Statement::If(
                    some([
                        (self.given[1].clone(), vec![self.set("CV", self.number(2))]),
                        (Some(self.rises(0, "CD_before")), self.counted(Op::Sub)),
                    ]),
                    Vec::new(),
                ),
                self.set("CD_before", self.input(0)),
                self.set("Q", compared(Op::AtMost, Expr::Int(0))),
            ],
            _ => {
                let (up, down) = (self.rises(0, "CU_before"), self.rises(1, "CD_before"));
                vec![
                    Statement::If(
                        some([
                            (self.given[2].clone(), zero()),
                            (self.given[3].clone(), vec![self.set("CV", self.number(4))]),
                            // Both at once are none.
                            (Some(and(up.clone(), not(down.clone()))), self.counted(Op::Add)),
                            (Some(and(down, not(up))), self.counted(Op::Sub)),
                        ]),
                        Vec::new(),
                    ),
                    self.set("CU_before", self.input(0)),
                    self.set("CD_before", self.input(1)),
                    self.set("QU", compared(Op::AtLeast, self.number(4))),
                    self.set("QD", compared(Op::AtMost, Expr::Int(0))),
                ]
            }
        }
    }
}

/// Without branches whose input nobody gives.
fn some<const N: usize>(branches: [(Option<Expr>, Vec<Statement>); N]) -> Vec<(Expr, Vec<Statement>)> {
    branches.into_iter().filter_map(|(condition, then)| Some((condition?, then))).collect()
}

fn not(of: Expr) -> Expr {
    Expr::Not(Box::new(of))
}

fn and(a: Expr, b: Expr) -> Expr {
    Expr::Binary(Op::And, Box::new(a), Box::new(b))
}

fn or(a: Expr, b: Expr) -> Expr {
    Expr::Binary(Op::Or, Box::new(a), Box::new(b))
}
