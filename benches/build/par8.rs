//! One step forks into eight branches of four steps each, which join again.

/// The input that ends a step of a branch.
fn input(branch: usize, step: usize) -> usize {
    (branch * 3 + step) * 5 % 14
}

/// The output of a step of a branch.
fn output(branch: usize, step: usize) -> usize {
    (branch * 4 + step) * 7 % 15
}

fn branches(one: impl Fn(usize) -> String) -> String {
    (0..8).map(one).collect()
}

fn joined(separator: &str, one: impl Fn(usize) -> String) -> String {
    (0..8).map(one).collect::<Vec<_>>().join(separator)
}

/// The steps that end by themselves: the last waits for the other branches.
fn moving(branch: usize, one: impl Fn(usize, usize) -> String) -> String {
    (0..3).map(|step| one(step, input(branch, step))).collect()
}

fn acting(branch: usize, one: impl Fn(usize, usize) -> String) -> String {
    (0..4).map(|step| one(step, output(branch, step))).collect()
}

fn signals(name: &str) -> String {
    (0..16).map(|i| format!("{name}{i}")).collect::<Vec<_>>().join(", ")
}

/// As a user of the macro writes it.
pub fn generated() -> String {
    let (inputs, outputs) = (signals("x"), signals("q"));
    let steps = branches(|b| acting(b, |s, q| format!("step B{b}S{s} {{ q{q}; }}\n")));
    let chains = branches(|b| moving(b, |s, x| format!("B{b}S{s} -[x{x}]-> B{b}S{};\n", s + 1)));
    let (first, last) = (joined(", ", |b| format!("B{b}S0")), joined(", ", |b| format!("B{b}S3")));
    format!(
        "both! {{ par8 {{
        input {inputs}: bool;
        output {outputs}: bool;
        initial step Start {{ q15; }}
        {steps}
        Start -[x14]-> ({first});
        {chains}
        ({last}) -[x15]-> Start;
        }} }}\n"
    )
}

/// As an engineer writes it in Rust: an enum for the branches, one function for each.
pub fn hand() -> String {
    let fields = branches(|b| format!("b{b}: Branch,"));
    let (all_last, all_first) = (joined(" && ", |b| format!("c.b{b} == S3")), branches(|b| format!("c.b{b} = S0;")));
    let all_off = branches(|b| format!("c.b{b} = Off;"));
    let next = branches(|b| {
        let arms = moving(b, |s, x| format!("S{s} if i.x{x} => S{},", s + 1));
        format!("c.b{b} = match c.b{b} {{ {arms} stay => stay }};\n")
    });
    let act = branches(|b| {
        let arms = acting(b, |s, q| format!("S{s} => q.q{q} = true,"));
        format!("match c.b{b} {{ {arms} Off => {{}} }}\n")
    });
    let off = branches(|b| format!("b{b}: Off,"));
    format!(
        "pub mod par8 {{
        pub use crate::signals::par8::{{ChartInputs, ChartOutputs}};
        use Branch::*;
        #[derive(Clone, Copy, PartialEq, Eq)]
        enum Branch {{ Off, S0, S1, S2, S3 }}
        #[derive(Clone, Copy, PartialEq, Eq)]
        enum Main {{ Init, Start, Branches }}
        #[derive(Clone, Copy, PartialEq, Eq)]
        pub struct Situation {{ main: Main, {fields} }}
        fn next(c: &mut Situation, i: &ChartInputs) {{
            match c.main {{
                Main::Init => c.main = Main::Start,
                Main::Start => if i.x14 {{ c.main = Main::Branches; {all_first} }},
                Main::Branches => if {all_last} {{
                    if i.x15 {{ c.main = Main::Start; {all_off} }}
                }} else {{ {next} }}
            }}
        }}
        fn act(c: &Situation) -> ChartOutputs {{
            let mut q = ChartOutputs::default();
            if c.main == Main::Start {{ q.q15 = true; }}
            {act}
            q
        }}
        pub mod sfc {{
            pub use super::{{ChartInputs, ChartOutputs}};
            use super::{{Situation, Main, Branch::Off, act, next}};
            pub struct Chart(Situation);
            impl Chart {{
                pub fn new() -> Self {{ Self(Situation {{ main: Main::Init, {off} }}) }}
                pub fn cycle(&mut self, inputs: &ChartInputs) -> ChartOutputs {{
                    next(&mut self.0, inputs);
                    act(&self.0)
                }}
            }}
            pub const CYCLE: crate::Cycle<Chart, ChartInputs, ChartOutputs> = Chart::cycle;
        }}
        pub mod grafcet {{
            pub use super::{{ChartInputs, ChartOutputs}};
            use super::{{Situation, Main, Branch::Off, act, next}};
            pub struct Chart {{ situation: Situation, stable: bool }}
            impl Chart {{
                pub fn new() -> Self {{ Self {{ situation: Situation {{ main: Main::Start, {off} }}, stable: true }} }}
                pub fn is_stable(&self) -> bool {{ self.stable }}
                pub fn cycle(&mut self, inputs: &ChartInputs) -> ChartOutputs {{
                    let mut left = 68;
                    self.stable = loop {{
                        let mut situation = self.situation;
                        next(&mut situation, inputs);
                        if situation == self.situation {{ break true; }}
                        if left == 0 {{ break false; }}
                        left -= 1;
                        self.situation = situation;
                    }};
                    act(&self.situation)
                }}
            }}
            pub const CYCLE: crate::Cycle<Chart, ChartInputs, ChartOutputs> = Chart::cycle;
        }}
        }}\n"
    )
}

/// As an engineer writes it in C: a function says whether anything has moved.
pub fn c() -> String {
    let (inputs, outputs) = (signals("x"), signals("q"));
    let fields = joined(", ", |b| format!("b{b}"));
    let all_last = joined(" && ", |b| format!("c->b{b} == S3"));
    let (all_first, all_off) = (branches(|b| format!("c->b{b} = S0; ")), branches(|b| format!("c->b{b} = OFF; ")));
    let next = branches(|b| {
        let cases =
            moving(b, |s, x| format!("case S{s}: if (i->x{x}) {{ c->b{b} = S{}; moved = true; }} break;\n", s + 1));
        format!("switch (c->b{b}) {{ {cases} }}\n")
    });
    let clear: String = (0..16).map(|i| format!("q->q{i} = ")).collect();
    let act = branches(|b| {
        let cases = acting(b, |s, q| format!("case S{s}: q->q{q} = true; break;\n"));
        format!("switch (c->b{b}) {{ {cases} }}\n")
    });
    format!(
        "#include \"chart.h\"
typedef struct {{ bool {inputs}; }} inputs_t;
typedef struct {{ bool {outputs}; }} outputs_t;
enum {{ OFF, S0, S1, S2, S3 }};
enum {{ INIT, START, BRANCHES }};
typedef struct {{ uint8_t main, {fields}; bool stable; }} chart_t;
static inline bool next(chart_t *c, const inputs_t *i) {{
    bool moved = false;
    switch (c->main) {{
    case INIT: c->main = START; return true;
    case START:
        if (i->x14) {{ c->main = BRANCHES; {all_first} return true; }}
        break;
    case BRANCHES:
        if ({all_last}) {{
            if (i->x15) {{ c->main = START; {all_off} return true; }}
        }} else {{ {next} }}
        break;
    }}
    return moved;
}}
static inline void act(const chart_t *c, outputs_t *q) {{
    {clear} false;
    if (c->main == START) q->q15 = true;
    {act}
}}
void par8_sfc_cycle(chart_t *c, const inputs_t *i, outputs_t *q) {{
    next(c, i);
    act(c, q);
}}
void par8_grafcet_cycle(chart_t *c, const inputs_t *i, outputs_t *q) {{
    c->stable = true;
    for (uint8_t left = 68;; left--) {{
        if (left == 0) {{
            chart_t probe = *c;
            c->stable = !next(&probe, i);
            break;
        }}
        if (!next(c, i))
            break;
    }}
    act(c, q);
}}
"
    )
}
