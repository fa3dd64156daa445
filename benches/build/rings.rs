//! Rings of many steps, with all that stands around their machines.

use crate::machines::{chart, input, list, names, output, signals, smlang_machine, statig_machine};

/// How many steps.
pub(crate) const STEPS: [usize; 3] = [10, 100, 1000];

/// How many steps a chart has that nobody else writes: it shows what grows with them.
const LONG: usize = 5000;

/// As a user of the macro writes it.
pub(crate) fn generated(steps: usize) -> String {
    let ring = chart(steps);
    let with = |name: &str, setting: &str| format!("both! {{ chain{steps}{name} {{\n{setting}{ring} }} }}\n");
    let mut all = with("", "");
    if steps == 100 {
        all += &with("_size", "optimize size;\n");
        all += &with("_flags", "encoding flags;\n");
    }
    if steps == 1000 && std::env::var_os("CARGO_FEATURE_LONG").is_some() {
        let long = chart(LONG);
        all += &format!("both! {{ chain{LONG} {{\n{long} }} }}\n");
    }
    all
}

/// As an engineer writes it in Rust.
pub(crate) fn hand(steps: usize) -> String {
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
pub(crate) fn c(steps: usize) -> String {
    let next =
        list(steps, |i| format!("case S{i}: if (i->x{}) return S{}; break;\n", input(i, steps), (i + 1) % steps));
    let act = list(steps, |i| format!("case S{i}: q->q{} = true; break;\n", output(i, steps)));
    let (next, act) = (format!("switch (step) {{ {next} }} return step;"), format!("switch (step) {{ {act} }}"));
    c_of(steps, "", &next, &act)
}

/// The same as a table: for each step the numbers of two bytes in the records of the signals, which a cast turns into arrays
/// of bytes. Safe Rust has no such cast.
pub(crate) fn c_tables(steps: usize) -> String {
    let rows = list(steps, |i| format!("{{ {}, {} }},\n", input(i, steps), output(i, steps)));
    let table = format!("static const struct {{ uint8_t input, output; }} STEPS[] = {{ {rows} }};");
    let next = format!(
        "if (!((const bool *)i)[STEPS[step].input]) return step;
        return step == S{} ? S0 : step + 1;",
        steps - 1
    );
    c_of(steps, &table, &next, "((bool *)q)[STEPS[step].output] = true;")
}

fn c_of(steps: usize, table: &str, next: &str, act: &str) -> String {
    let (step, bound) = if steps < 256 { ("uint8_t", "uint8_t") } else { ("uint16_t", "uint16_t") };
    let (inputs, outputs) = (names("x", steps), names("q", steps));
    let variants = list(steps, |i| format!("S{i}, "));
    let clear = list(signals(steps), |i| format!("q->q{i} = "));
    let left = 2 * steps + 2;
    format!(
        "#include \"chart.h\"
typedef struct {{ bool {inputs}; }} inputs_t;
typedef struct {{ bool {outputs}; }} outputs_t;
enum {{ {variants} INIT }};
{table}
static inline {step} next({step} step, const inputs_t *i) {{ {next} }}
static inline void act({step} step, outputs_t *q) {{ {clear} false; {act} }}
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

/// The arms that act on the situation of another crate's machine, whose states are those of `states`.
fn acts(steps: usize, state: impl Fn(usize) -> String) -> String {
    list(steps, |i| format!("{} => q.q{} = true,\n", state(i), output(i, steps)))
}

/// As an engineer writes it with smlang: one event per cycle, the inputs as its temporary context.
pub(crate) fn smlang(steps: usize) -> String {
    let act = acts(steps, |i| format!("States::S{i}"));
    format!(
        "pub mod chain{steps} {{ pub mod sfc {{
        pub use crate::signals::chain{steps}::{{ChartInputs, ChartOutputs}};
        {}
        pub struct Chart(StateMachine<Context>);
        impl Chart {{
            pub fn new() -> Self {{ Self(StateMachine::new(Context)) }}
            pub fn cycle(&mut self, inputs: &ChartInputs) -> ChartOutputs {{
                // A cycle without a transition is none of its errors that matter.
                _ = self.0.process_event(inputs, Events::Cycle);
                let mut q = ChartOutputs::default();
                match self.0.state() {{ {act} States::Init => {{}} }}
                q
            }}
        }}
        pub const CYCLE: crate::Cycle<Chart, ChartInputs, ChartOutputs> = Chart::cycle;
        }} }}\n",
        smlang_machine(steps)
    )
}

/// As an engineer writes it with statig: the inputs are the event.
pub(crate) fn statig(steps: usize) -> String {
    let act = acts(steps, |i| format!("State::S{i} {{}}"));
    format!(
        "pub mod chain{steps} {{ pub mod sfc {{
        pub use crate::signals::chain{steps}::{{ChartInputs, ChartOutputs}};
        {}
        pub struct Chart(InitializedStateMachine<Machine>);
        impl Chart {{
            pub fn new() -> Self {{ Self(Machine.uninitialized_state_machine().init()) }}
            pub fn cycle(&mut self, inputs: &ChartInputs) -> ChartOutputs {{
                self.0.handle(inputs);
                let mut q = ChartOutputs::default();
                match self.0.state() {{ {act} State::Init {{}} => {{}} }}
                q
            }}
        }}
        pub const CYCLE: crate::Cycle<Chart, ChartInputs, ChartOutputs> = Chart::cycle;
        }} }}\n",
        statig_machine(steps)
    )
}

/// As step chains are written where there is nothing but bits: one for each step; a step is set by the one before it with
/// its condition and reset by the one after it. All of them are looked at in every cycle.
pub(crate) fn flags(steps: usize) -> String {
    let bit = |i: usize| format!("[{}] & 1 << {}", i / 32, i % 32);
    let ring = list(steps, |i| {
        let (input, next) = (input(i, steps), (i + 1) % steps);
        let (word, bit_here) = (i / 32, i % 32);
        let (next_word, next_bit) = (next / 32, next % 32);
        format!(
            "if old{} != 0 && i.x{input} {{ new[{word}] &= !(1 << {bit_here}); new[{next_word}] |= 1 << {next_bit}; }}\n",
            bit(i)
        )
    });
    let act: String = (0..signals(steps))
        .map(|q| {
            let of = (0..steps).filter(|i| output(*i, steps) == q).map(|i| format!("new{} != 0", bit(i)));
            format!("q{q}: {},\n", of.collect::<Vec<_>>().join(" || "))
        })
        .collect();
    let words = steps.div_ceil(32);
    format!(
        "pub mod chain{steps} {{ pub mod sfc {{
        pub use crate::signals::chain{steps}::{{ChartInputs, ChartOutputs}};
        /// All false before the first cycle.
        pub struct Chart([u32; {words}]);
        impl Chart {{
            pub fn new() -> Self {{ Self([0; {words}]) }}
            pub fn cycle(&mut self, i: &ChartInputs) -> ChartOutputs {{
                let old = self.0;
                let mut new = old;
                {ring}
                if old == [0; {words}] {{ new[0] = 1; }}
                self.0 = new;
                ChartOutputs {{ {act} }}
            }}
        }}
        pub const CYCLE: crate::Cycle<Chart, ChartInputs, ChartOutputs> = Chart::cycle;
        }} }}\n"
    )
}
