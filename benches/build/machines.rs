//! Rings of many steps: each waits for one of the inputs and drives one of the outputs, of which there are 16 at most. Here
//! are the machines alone, as they are written with each crate; `cargo xtask bench` measures how long they take to build.

/// How many inputs and outputs there are.
pub(crate) fn signals(steps: usize) -> usize {
    steps.min(16)
}

/// The input that ends a step: another one in each round of the signals.
pub(crate) fn input(step: usize, steps: usize) -> usize {
    (step * 3 + step / signals(steps) * 5 + 3) % signals(steps)
}

/// The output of a step.
pub(crate) fn output(step: usize, steps: usize) -> usize {
    (step * 7 + step / signals(steps) + 1) % signals(steps)
}

/// `x0, x1, …`
pub(crate) fn names(name: &str, steps: usize) -> String {
    let names: Vec<String> = (0..signals(steps)).map(|i| format!("{name}{i}")).collect();
    names.join(", ")
}

/// What is written for each step.
pub(crate) fn list(steps: usize, one: impl Fn(usize) -> String) -> String {
    (0..steps).map(one).collect()
}

/// The ring as a chart: what stands between its braces.
pub(crate) fn chart(steps: usize) -> String {
    let (inputs, outputs) = (names("x", steps), names("q", steps));
    let declared = list(steps, |i| {
        let initial = if i == 0 { "initial " } else { "" };
        format!("{initial}step S{i} {{ q{}; }}\n", output(i, steps))
    });
    let ring = list(steps, |i| format!("S{i} -[x{}]-> S{};\n", input(i, steps), (i + 1) % steps));
    format!("input {inputs}: bool;\noutput {outputs}: bool;\n{declared}{ring}")
}

/// The ring as a machine of smlang over a type `ChartInputs`.
pub(crate) fn smlang_machine(steps: usize) -> String {
    let ring = list(steps, |i| format!("S{i} + Cycle [x{}] = S{},\n", input(i, steps), (i + 1) % steps));
    let guards = list(signals(steps), |i| {
        format!("fn x{i}(&self, inputs: &ChartInputs) -> Result<bool, ()> {{ Ok(inputs.x{i}) }}\n")
    });
    format!(
        "smlang::statemachine! {{ temporary_context: &ChartInputs, transitions: {{ *Init + Cycle = S0,\n{ring} }} }}
        pub struct Context;
        impl StateMachineContext for Context {{ {guards} }}\n"
    )
}

/// The ring as a machine of statig over a type `ChartInputs`.
pub(crate) fn statig_machine(steps: usize) -> String {
    let states = list(steps, |i| {
        let (input, next) = (input(i, steps), (i + 1) % steps);
        format!(
            "#[state] fn s{i}(event: &ChartInputs) -> Outcome<State> {{
                if event.x{input} {{ Transition(State::s{next}()) }} else {{ Handled }}
            }}\n"
        )
    });
    format!(
        "use statig::prelude::*;
        pub struct Machine;
        #[state_machine(initial = \"State::init()\")]
        impl Machine {{
            #[state] fn init(event: &ChartInputs) -> Outcome<State> {{ _ = event; Transition(State::s0()) }}
            {states}
        }}\n"
    )
}
