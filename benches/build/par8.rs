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
pub(crate) fn generated() -> String {
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
pub(crate) fn hand() -> String {
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
                pub(crate) fn new() -> Self {{ Self(Situation {{ main: Main::Init, {off} }}) }}
                pub(crate) fn cycle(&mut self, inputs: &ChartInputs) -> ChartOutputs {{
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
                pub(crate) fn new() -> Self {{ Self {{ situation: Situation {{ main: Main::Start, {off} }}, stable: true }} }}
                pub(crate) fn is_stable(&self) -> bool {{ self.stable }}
                pub(crate) fn cycle(&mut self, inputs: &ChartInputs) -> ChartOutputs {{
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
pub(crate) fn c() -> String {
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

/// What an engineer writes around the nine machines of a crate that has no parallel branches.
struct Glue {
    /// The machines.
    fields: String,
    new: String,
    /// Moves the main machine: into its step, into the branches, out of them.
    main: [&'static str; 3],
    /// Moves a branch, by its number: into its first step, on if its input allows, out of its last.
    branch: [fn(usize) -> String; 3],
    /// Whether the main machine is in its step, in the branches.
    is: [&'static str; 2],
    /// Whether a branch is in a step of its own.
    is_in: fn(usize, usize) -> String,
}

impl Glue {
    fn write(&self) -> String {
        let [begin, on, end] = self.branch;
        let (begin, on, end) = (branches(begin), branches(on), branches(end));
        let all_last = joined(" && ", |b| (self.is_in)(b, 3));
        let act = branches(|b| acting(b, |s, q| format!("if {} {{ q.q{q} = true; }}\n", (self.is_in)(b, s))));
        let Self { fields, new, main: [first, start, join], is: [in_start, in_branches], .. } = self;
        format!(
            "pub struct Chart {{ {fields} }}
            impl Chart {{
                pub fn new() -> Self {{ Self {{ {new} }} }}
                pub fn cycle(&mut self, i: &ChartInputs) -> ChartOutputs {{
                    if {in_start} {{
                        if i.x14 {{ {start}; {begin} }}
                    }} else if {in_branches} {{
                        if {all_last} {{
                            if i.x15 {{ {join}; {end} }}
                        }} else {{ {on} }}
                    }} else {{ {first}; }}
                    let mut q = ChartOutputs::default();
                    if {in_start} {{ q.q15 = true; }}
                    {act}
                    q
                }}
            }}
            pub const CYCLE: crate::Cycle<Chart, ChartInputs, ChartOutputs> = Chart::cycle;\n"
        )
    }
}

/// As an engineer writes it with smlang: a machine for the forks, one for each branch.
pub(crate) fn smlang() -> String {
    let machines = branches(|b| {
        let chain = moving(b, |s, x| format!("S{s} + Cycle [x{x}] = S{},\n", s + 1));
        let mut guards: Vec<usize> = (0..3).map(|s| input(b, s)).collect();
        guards.sort_unstable();
        guards.dedup();
        let guards: String = guards
            .into_iter()
            .map(|x| format!("fn x{x}(&self, i: &ChartInputs) -> Result<bool, ()> {{ Ok(i.x{x}) }}\n"))
            .collect();
        format!(
            "smlang::statemachine! {{ name: B{b}, temporary_context: &ChartInputs, transitions: {{
                *Off + Begin = S0,\n{chain}S3 + End = Off,
            }} }}
            impl B{b}StateMachineContext for Context {{ {guards} }}\n"
        )
    });
    let glue = Glue {
        fields: format!(
            "main: MainStateMachine<Context>, {}",
            branches(|b| format!("b{b}: B{b}StateMachine<Context>,"))
        ),
        new: format!(
            "main: MainStateMachine::new(Context), {}",
            branches(|b| format!("b{b}: B{b}StateMachine::new(Context),"))
        ),
        main: [
            "_ = self.main.process_event(MainEvents::Enter)",
            "_ = self.main.process_event(MainEvents::Fork)",
            "_ = self.main.process_event(MainEvents::Join)",
        ],
        branch: [
            |b| format!("_ = self.b{b}.process_event(i, B{b}Events::Begin);"),
            |b| format!("_ = self.b{b}.process_event(i, B{b}Events::Cycle);"),
            |b| format!("_ = self.b{b}.process_event(i, B{b}Events::End);"),
        ],
        is: ["*self.main.state() == MainStates::Start", "*self.main.state() == MainStates::Branches"],
        is_in: |b, s| format!("*self.b{b}.state() == B{b}States::S{s}"),
    };
    format!(
        "pub mod par8 {{ pub mod sfc {{
        pub use crate::signals::par8::{{ChartInputs, ChartOutputs}};
        pub struct Context;
        smlang::statemachine! {{ name: Main, transitions: {{
            *Init + Enter = Start, Start + Fork = Branches, Branches + Join = Start,
        }} }}
        impl MainStateMachineContext for Context {{}}
        {machines}{}
        }} }}\n",
        glue.write()
    )
}

/// As an engineer writes it with statig: a machine for the forks, one for each branch.
pub(crate) fn statig() -> String {
    let machines = branches(|b| {
        let chain = moving(b, |s, x| {
            format!(
                "#[state] fn s{s}(event: &Event<'_>) -> Outcome<State> {{
                    match event {{ Event::Cycle(i) if i.x{x} => Transition(State::s{}()), _ => Super }}
                }}\n",
                s + 1
            )
        });
        format!(
            "mod b{b} {{
            use super::Event;
            use statig::prelude::*;
            pub struct Branch;
            #[state_machine(initial = \"State::off()\", state(derive(PartialEq)))]
            impl Branch {{
                #[state] fn off(event: &Event<'_>) -> Outcome<State> {{
                    match event {{ Event::Begin => Transition(State::s0()), _ => Super }}
                }}
                {chain}
                #[state] fn s3(event: &Event<'_>) -> Outcome<State> {{
                    match event {{ Event::End => Transition(State::off()), _ => Super }}
                }}
            }}
            }}\n"
        )
    });
    let glue = Glue {
        fields: format!(
            "main: InitializedStateMachine<Main>, {}",
            branches(|b| format!("b{b}: InitializedStateMachine<b{b}::Branch>,"))
        ),
        new: format!(
            "main: Main.uninitialized_state_machine().init(), {}",
            branches(|b| format!("b{b}: b{b}::Branch.uninitialized_state_machine().init(),"))
        ),
        main: [
            "self.main.handle(&MainEvent::Enter)",
            "self.main.handle(&MainEvent::Fork)",
            "self.main.handle(&MainEvent::Join)",
        ],
        branch: [
            |b| format!("self.b{b}.handle(&Event::Begin);"),
            |b| format!("self.b{b}.handle(&Event::Cycle(i));"),
            |b| format!("self.b{b}.handle(&Event::End);"),
        ],
        is: ["(*self.main.state() == State::Start {})", "(*self.main.state() == State::Branches {})"],
        is_in: |b, s| format!("(*self.b{b}.state() == b{b}::State::S{s} {{}})"),
    };
    format!(
        "pub mod par8 {{ pub mod sfc {{
        pub use crate::signals::par8::{{ChartInputs, ChartOutputs}};
        use statig::prelude::*;
        pub enum Event<'a> {{ Begin, Cycle(&'a ChartInputs), End }}
        pub enum MainEvent {{ Enter, Fork, Join }}
        pub struct Main;
        #[state_machine(initial = \"State::init()\", state(derive(PartialEq)))]
        impl Main {{
            #[state] fn init(event: &MainEvent) -> Outcome<State> {{
                match event {{ MainEvent::Enter => Transition(State::start()), _ => Super }}
            }}
            #[state] fn start(event: &MainEvent) -> Outcome<State> {{
                match event {{ MainEvent::Fork => Transition(State::branches()), _ => Super }}
            }}
            #[state] fn branches(event: &MainEvent) -> Outcome<State> {{
                match event {{ MainEvent::Join => Transition(State::start()), _ => Super }}
            }}
        }}
        {machines}{}
        }} }}\n",
        glue.write()
    )
}
