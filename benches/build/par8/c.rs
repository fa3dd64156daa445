//! The fork in C.

use super::{acting, branches, joined, moving, signals};

/// As an engineer writes it in C: a function says whether anything has moved.
pub(crate) fn by_switch() -> String {
    let next = branches(|b| {
        let cases =
            moving(b, |s, x| format!("case S{s}: if (i->x{x}) {{ c->b{b} = S{}; moved = true; }} break;\n", s + 1));
        format!("switch (c->b{b}) {{ {cases} }}\n")
    });
    let act = branches(|b| {
        let cases = acting(b, |s, q| format!("case S{s}: q->q{q} = true; break;\n"));
        format!("switch (c->b{b}) {{ {cases} }}\n")
    });
    let fields = joined(", ", |b| format!("b{b}"));
    let all_last = joined(" && ", |b| format!("c->b{b} == S3"));
    let all_first = branches(|b| format!("c->b{b} = S0; "));
    program(&fields, &all_last, &all_first, &next, &act)
}

/// The same as tables: numbers of bytes in the records of the signals, which a cast turns into arrays of bytes.
pub(crate) fn by_tables() -> String {
    let table = |row: &dyn Fn(usize) -> String| joined(", ", |b| format!("{{ {} }}", row(b)));
    let inputs = table(&|b| moving(b, |_, x| format!("{x}, ")));
    let outputs = table(&|b| acting(b, |_, q| format!("{q}, ")));
    let next = "for (int b = 0; b < 8; b++) {
            uint8_t step = c->b[b];
            if (step != S3 && ((const bool *)i)[INPUTS[b][step]]) { c->b[b] = step + 1; moved = true; }
        }\n";
    let act = "for (int b = 0; b < 8; b++) ((bool *)q)[OUTPUTS[b][c->b[b]]] = true;\n";
    let tables = format!(
        "static const uint8_t INPUTS[8][3] = {{ {inputs} }};
static const uint8_t OUTPUTS[8][4] = {{ {outputs} }};
static inline bool all_last(const uint8_t *b) {{
    for (int n = 0; n < 8; n++) if (b[n] != S3) return false;
    return true;
}}
static inline void all_first(uint8_t *b) {{ for (int n = 0; n < 8; n++) b[n] = S0; }}\n"
    );
    let text = program("b[8]", "all_last(c->b)", "all_first(c->b);", next, act);
    text.replacen("typedef struct { uint8_t main", &format!("{tables}typedef struct {{ uint8_t main"), 1)
}

fn program(fields: &str, all_last: &str, all_first: &str, next: &str, act: &str) -> String {
    let (inputs, outputs) = (signals("x"), signals("q"));
    let clear: String = (0..16).map(|i| format!("q->q{i} = ")).collect();
    format!(
        "#include \"chart.h\"
typedef struct {{ bool {inputs}; }} inputs_t;
typedef struct {{ bool {outputs}; }} outputs_t;
enum {{ S0, S1, S2, S3 }};
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
            if (i->x15) {{ c->main = START; return true; }}
        }} else {{ {next} }}
        break;
    }}
    return moved;
}}
static inline void act(const chart_t *c, outputs_t *q) {{
    {clear} false;
    if (c->main == START) q->q15 = true;
    if (c->main != BRANCHES) return;
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
