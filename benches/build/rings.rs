//! Rings of many steps: each waits for one of the inputs and drives one of the outputs, of which there are 16 at most.

/// How many steps.
pub const STEPS: [usize; 3] = [10, 100, 1000];

fn signals(steps: usize) -> usize {
    steps.min(16)
}

/// The input that ends a step: another one in each round of the signals.
fn input(step: usize, steps: usize) -> usize {
    (step * 3 + step / signals(steps) * 5 + 3) % signals(steps)
}

/// The output of a step.
fn output(step: usize, steps: usize) -> usize {
    (step * 7 + step / signals(steps) + 1) % signals(steps)
}

/// `x0, x1, …`
fn names(name: &str, steps: usize) -> String {
    (0..signals(steps)).map(|i| format!("{name}{i}")).collect::<Vec<_>>().join(", ")
}

fn list(steps: usize, one: impl Fn(usize) -> String) -> String {
    (0..steps).map(one).collect()
}

/// As a user of the macro writes it.
pub fn generated(steps: usize) -> String {
    let (inputs, outputs) = (names("x", steps), names("q", steps));
    let declared = list(steps, |i| {
        let initial = if i == 0 { "initial " } else { "" };
        format!("{initial}step S{i} {{ q{}; }}\n", output(i, steps))
    });
    let ring = list(steps, |i| format!("S{i} -[x{}]-> S{};\n", input(i, steps), (i + 1) % steps));
    format!("both! {{ chain{steps} {{\ninput {inputs}: bool;\noutput {outputs}: bool;\n{declared}{ring}}} }}\n")
}

/// As an engineer writes it in Rust.
pub fn hand(steps: usize) -> String {
    let variants = list(steps, |i| format!("S{i}, "));
    let next = list(steps, |i| format!("S{i} if i.x{} => S{},\n", input(i, steps), (i + 1) % steps));
    let act = list(steps, |i| format!("S{i} => q.q{} = true,\n", output(i, steps)));
    format!(
        "pub mod chain{steps} {{
        pub use crate::signals::chain{steps}::{{ChartInputs, ChartOutputs}};
        use Step::*;
        #[derive(Clone, Copy, PartialEq, Eq)]
        enum Step {{ {variants} }}
        fn next(step: Step, i: &ChartInputs) -> Step {{ match step {{ {next} stay => stay }} }}
        fn act(step: Step) -> ChartOutputs {{
            let mut q = ChartOutputs::default();
            match step {{ {act} }}
            q
        }}
        super::dialects!(S0, {steps});
        }}\n"
    )
}

/// As an engineer writes it in C.
pub fn c(steps: usize) -> String {
    let (step, bound) = if steps < 256 { ("uint8_t", "uint8_t") } else { ("uint16_t", "uint16_t") };
    let (inputs, outputs) = (names("x", steps), names("q", steps));
    let variants = list(steps, |i| format!("S{i}, "));
    let next =
        list(steps, |i| format!("case S{i}: if (i->x{}) return S{}; break;\n", input(i, steps), (i + 1) % steps));
    let clear = list(signals(steps), |i| format!("q->q{i} = "));
    let act = list(steps, |i| format!("case S{i}: q->q{} = true; break;\n", output(i, steps)));
    let left = 2 * steps + 2;
    format!(
        "#include \"chart.h\"
typedef struct {{ bool {inputs}; }} inputs_t;
typedef struct {{ bool {outputs}; }} outputs_t;
enum {{ {variants} INIT }};
static inline {step} next({step} step, const inputs_t *i) {{ switch (step) {{ {next} }} return step; }}
static inline void act({step} step, outputs_t *q) {{ {clear} false; switch (step) {{ {act} }} }}
typedef struct {{ {step} step; }} sfc_t;
void chain{steps}_sfc_cycle(sfc_t *c, const inputs_t *i, outputs_t *q) {{
    c->step = c->step == INIT ? S0 : next(c->step, i);
    act(c->step, q);
}}
typedef struct {{ {step} step; bool stable; }} grafcet_t;
void chain{steps}_grafcet_cycle(grafcet_t *c, const inputs_t *i, outputs_t *q) {{
    c->stable = true;
    for ({bound} left = {left};; left--) {{
        {step} step = next(c->step, i);
        if (step == c->step)
            break;
        if (left == 0) {{
            c->stable = false;
            break;
        }}
        c->step = step;
    }}
    act(c->step, q);
}}
"
    )
}
