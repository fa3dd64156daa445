//! One step forks into eight branches of four steps each, which join again.

mod c;

pub(crate) use self::c::{by_switch as c, by_tables as c_tables};

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

/// As a user of the macro writes it; with more branches under another name.
pub(crate) fn generated() -> String {
    [8, 16].into_iter().map(fork).collect()
}

fn fork(count: usize) -> String {
    let (inputs, outputs) = (signals("x"), signals("q"));
    let all = |one: &dyn Fn(usize) -> String| (0..count).map(one).collect::<String>();
    let steps = all(&|b| acting(b, |s, q| format!("step B{b}S{s} {{ q{q}; }}\n")));
    let chains = all(&|b| moving(b, |s, x| format!("B{b}S{s} -[x{x}]-> B{b}S{};\n", s + 1)));
    let list = |step| (0..count).map(|b| format!("B{b}S{step}")).collect::<Vec<_>>().join(", ");
    let (first, last) = (list(0), list(3));
    format!(
        "both! {{ par{count} {{
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

/// As an engineer writes it in Rust: an enum for the branches, which say whether they have moved.
pub(crate) fn hand() -> String {
    let fields = branches(|b| format!("b{b}: Branch,"));
    let (all_last, all_first) = (joined(" && ", |b| format!("c.b{b} == S3")), branches(|b| format!("c.b{b} = S0;")));
    let next = branches(|b| {
        let arms = moving(b, |s, x| format!("S{s} if i.x{x} => {{ c.b{b} = S{}; moved = true; }}", s + 1));
        format!("match c.b{b} {{ {arms} _ => {{}} }}\n")
    });
    let act = branches(|b| {
        let arms = acting(b, |s, q| format!("S{s} => q.q{q} = true,"));
        format!("match c.b{b} {{ {arms} }}\n")
    });
    let first = branches(|b| format!("b{b}: S0,"));
    format!(
        "pub mod par8 {{
        pub use crate::signals::par8::{{ChartInputs, ChartOutputs}};
        use Branch::*;
        #[derive(Clone, Copy, PartialEq, Eq)]
        enum Branch {{ S0, S1, S2, S3 }}
        #[derive(Clone, Copy, PartialEq, Eq)]
        enum Main {{ Init, Start, Branches }}
        /// The branches have a meaning in `Branches`.
        #[derive(Clone, Copy)]
        pub struct Situation {{ main: Main, {fields} }}
        impl Situation {{ fn new(main: Main) -> Self {{ Self {{ main, {first} }} }} }}
        fn next(c: &mut Situation, i: &ChartInputs) -> bool {{
            match c.main {{
                Main::Init => {{ c.main = Main::Start; true }}
                Main::Start => {{
                    if i.x14 {{ c.main = Main::Branches; {all_first} }}
                    i.x14
                }}
                Main::Branches if {all_last} => {{
                    if i.x15 {{ c.main = Main::Start; }}
                    i.x15
                }}
                Main::Branches => {{ let mut moved = false; {next} moved }}
            }}
        }}
        fn act(c: &Situation) -> ChartOutputs {{
            let mut q = ChartOutputs::default();
            match c.main {{
                Main::Init => {{}}
                Main::Start => q.q15 = true,
                Main::Branches => {{ {act} }}
            }}
            q
        }}
        pub mod sfc {{
            pub use super::{{ChartInputs, ChartOutputs}};
            use super::{{Situation, Main, act, next}};
            pub struct Chart(Situation);
            impl Chart {{
                pub(crate) fn new() -> Self {{ Self(Situation::new(Main::Init)) }}
                pub(crate) fn cycle(&mut self, inputs: &ChartInputs) -> ChartOutputs {{
                    next(&mut self.0, inputs);
                    act(&self.0)
                }}
            }}
            pub const CYCLE: crate::Cycle<Chart, ChartInputs, ChartOutputs> = Chart::cycle;
        }}
        pub mod grafcet {{
            pub use super::{{ChartInputs, ChartOutputs}};
            use super::{{Situation, Main, act, next}};
            pub struct Chart {{ situation: Situation, stable: bool }}
            impl Chart {{
                pub(crate) fn new() -> Self {{ Self {{ situation: Situation::new(Main::Start), stable: true }} }}
                pub(crate) fn is_stable(&self) -> bool {{ self.stable }}
                pub(crate) fn cycle(&mut self, inputs: &ChartInputs) -> ChartOutputs {{
                    // After the bound the situation stays, whatever would follow.
                    self.stable = (0..68).any(|_| !next(&mut self.situation, inputs))
                        || !next(&mut self.situation.clone(), inputs);
                    act(&self.situation)
                }}
            }}
            pub const CYCLE: crate::Cycle<Chart, ChartInputs, ChartOutputs> = Chart::cycle;
        }}
        }}\n"
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
