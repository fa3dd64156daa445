//! A chart in a recorder, and what its record shows afterwards.

use grafcet::{Chart, Ticks};
use grafcet_core::record::wire::{Follow, Seen, Wire, frame_len, wire_len};
use grafcet_core::record::{Blocked, Memory, Moment, Recordable, Recorder, Records, replay};
use grafcet_sim::{Replay, Trace, Value};

use super::{Recorded, Traces, once};
use crate::random::Rng;
use crate::{Shown, Subject, Values};

/// A recorder whose memory is soon full, and which also sends all over a wire.
type Both<S> = Recorder<<S as Recorded>::Chart, (Memory<Vec<u8>>, Wire<Vec<u8>, Vec<u8>>)>;

/// A recorded chart, and what it has shown in each cycle.
pub(super) struct Kept<S: Recorded> {
    recorder: Both<S>,
    recipe: Values,
    shown: Shown,
    cycles: Vec<(u32, Shown)>,
    /// For which transitions it has waited after each of them.
    blocked: Vec<Vec<usize>>,
    rng: Rng,
}

impl<S: Recorded> Kept<S> {
    /// From the least memory that it takes up to more than it needs.
    pub(super) fn new(size: usize) -> Result<Self, String> {
        let chart = S::make();
        let shown = S::begun(&chart);
        let wire = Wire::new(Vec::new(), vec![0; wire_len::<S::Chart>()]).every(9, 70);
        let least = Recorder::<S::Chart, Memory<Vec<u8>>>::LEAST;
        let memory = least + [0, 7, 300, 2_000, 1 << 17][size % 5];
        let recorder = Recorder::both(chart, vec![0; memory], wire).map_err(|error| error.to_string())?;
        let rng = Rng::new(size as u64);
        Ok(Self { recorder, recipe: Values::new(), shown, cycles: Vec::new(), blocked: Vec::new(), rng })
    }

    pub(super) fn flush(&mut self) {
        self.recorder.flush();
    }

    /// What is left in memory, run again with the compiled chart.
    pub(super) fn by_the_chart(&self) -> Result<(), String> {
        let records = Records::of(self.recorder.keep().0.bytes()).map_err(|damage| format!("{damage:?}"))?;
        let mut shown = Shows::new(&self.cycles, "the record");
        let mut ended = None;
        let calls = S::called(&mut |actions| {
            ended = Some(replay::<S::Chart>(&records, actions, |moment| shown.moment::<S>(&moment)));
        });
        match ended {
            Some(Ok(())) => shown.ends(&calls),
            ended => Err(format!("the replay of the record ends with {ended:?}")),
        }
    }

    /// The frames, followed by the compiled chart.
    pub(super) fn over_the_wire(&self) -> Result<(), String> {
        let mut follow = Follow::<S::Chart, _>::new(vec![0; frame_len::<S::Chart>()]);
        let mut shown = Shows::new(&self.cycles, "the frames");
        let mut trouble = None;
        let calls = S::called(&mut |actions| {
            follow.bytes(self.recorder.keep().1.writer(), actions, |seen| match seen {
                Seen::Cycle(moment) => shown.moment::<S>(&moment),
                Seen::Begins => {}
                Seen::Trouble(found) => trouble = Some(found),
            });
        });
        match trouble {
            None => shown.ends(&calls),
            Some(trouble) => Err(format!("the frames show {trouble:?}")),
        }
    }

    /// Frames and record, run again from the chart's source. A record whose beginning was overwritten begins with a state.
    pub(super) fn by_the_source(&self, text: &str) -> Result<Traces, String> {
        let plain = crate::fragments::plain(text);
        let chart = grafcet_sim::Chart::parse(&plain).map_err(|refused| refused.to_string())?;
        // Fragments of macros are other tokens, and so the chart has another fingerprint.
        let is_same = plain == text;
        let run = if is_same { Replay::new() } else { Replay::new().even_if_changed() };
        let (memory, wire) = self.recorder.keep();
        let mut traces = vec![("the frames from source", run.frames(&chart, wire.writer()))];
        // The state at the beginning of another chart is not looked at.
        if is_same || is_whole(memory.bytes()) {
            traces.push(("the record from source", run.run(&chart, memory.bytes())));
        }
        let mut told = Traces::default();
        for (name, trace) in traces {
            let trace = trace.map_err(|error| format!("{name}: {error}"))?;
            // What a field does not tell is said, and nothing is shown up to the next state.
            let untold = |text: &String| text.contains("does not tell");
            let is_untold = trace.gaps().any(|(_, gap)| untold(&gap.reason)) || trace.warnings.iter().any(untold);
            let said = trace.warnings.iter().skip(usize::from(!is_same)).find(|text| !untold(text));
            if let Some(warning) = said {
                return Err(format!("{name}: {warning}"));
            }
            self.trace(&trace, name, !is_untold)?;
            told.all += 1;
            told.untold += u32::from(is_untold);
        }
        Ok(told)
    }

    /// What a trace shows; with `whole` up to the last cycle, and all calls.
    fn trace(&self, trace: &Trace, name: &'static str, whole: bool) -> Result<(), String> {
        let mut shown = Shows::new(&self.cycles, name);
        let (mut number, mut calls) = (0, Vec::new());
        for cycle in &trace.cycles {
            // What was overwritten.
            let missing = cycle.gap.as_ref().and_then(|gap| gap.cycles).unwrap_or(0);
            number += cycle.skipped + u32::try_from(missing).unwrap_or(u32::MAX);
            let steps = cycle.steps.iter().map(|step| trace.names.steps[*step].name.clone()).collect();
            let outputs = trace.names.outputs.iter().zip(&cycle.outputs);
            let outputs: Values = outputs.map(|(output, value)| (output.name.clone(), number_of(value))).collect();
            let found = Shown { steps, stable: cycle.is_stable, outputs, calls: Vec::new() };
            shown.cycle(number, S::Chart::TIMED.then_some(cycle.now), found, true);
            let waiting: Vec<usize> = cycle.blocked.waiting.iter().map(|waiting| waiting.transition).collect();
            if self.blocked.get(number as usize).is_some_and(|blocked| *blocked != waiting) {
                let blocked = &self.blocked[number as usize];
                return Err(format!(
                    "{name}, cycle {number}: the chart waits for {blocked:?}, its source for {waiting:?}"
                ));
            }
            calls.extend(cycle.calls.iter().map(|call| {
                let args: Vec<String> = call.args.iter().map(|arg| number_of(arg).to_string()).collect();
                format!("{} {}({})", format!("{:?}", call.phase).to_lowercase(), call.action, args.join(","))
            }));
            number += 1;
        }
        if whole { shown.ends(&calls) } else { shown.wrong.map_or(Ok(()), Err) }
    }
}

fn number_of(value: &Value) -> i128 {
    match value {
        Value::Bool(value) => i128::from(*value),
        Value::Int(value) => *value,
        Value::Ticks(value) => i128::from(*value),
        other => unreachable!("no chart of the comparison has a {other}"),
    }
}

/// Whether the beginning was not overwritten.
fn is_whole(record: &[u8]) -> bool {
    let first = Records::of(record).ok().and_then(|records| records.blocks().next()?.ok());
    first.is_some_and(|block| block.key.fresh && block.key.cycle == 0)
}

impl<S: Recorded> Subject for Kept<S> {
    fn cycle(&mut self, inputs: &Values, now: u32) -> Result<Shown, String> {
        // The program may look at the record, or tell that it runs, at any time.
        if self.rng.chance(10) {
            self.recorder.flush();
        }
        if self.rng.chance(10) {
            self.recorder.tell_state();
        }
        let (inputs, recorder) = (S::inputs(inputs), &mut self.recorder);
        let mut outputs = None;
        let calls = S::called(&mut |actions| outputs = Some(recorder.cycle(&inputs, Ticks::new(now), actions)));
        self.shown = S::shown(self.recorder.chart(), &outputs.ok_or("no cycle")?);
        let shown = Shown { calls, ..self.shown.clone() };
        self.cycles.push((now, shown.clone()));
        self.blocked.push(self.recorder.chart().blocked().collect());
        Ok(shown)
    }

    fn init(&mut self) -> Result<(), String> {
        self.recorder.change(S::Chart::init);
        self.shown = S::begun(self.recorder.chart());
        Ok(())
    }

    fn set_params(&mut self, changed: &Values) -> Result<(), String> {
        self.recipe.extend(changed.clone());
        let recipe = &self.recipe;
        self.recorder.change(|chart| S::set_params(chart, recipe));
        Ok(())
    }

    fn shown(&self) -> Shown {
        self.shown.clone()
    }

    fn next_deadline(&self) -> Option<u32> {
        self.recorder.chart().wakes_at().map(Ticks::get)
    }
}

/// What a replay shows, beside what was seen.
struct Shows<'s> {
    seen: &'s [(u32, Shown)],
    who: &'static str,
    /// The cycle after the last one that was shown.
    next: usize,
    calls: Vec<String>,
    wrong: Option<String>,
}

impl<'s> Shows<'s> {
    fn new(seen: &'s [(u32, Shown)], who: &'static str) -> Self {
        Self { seen, who, next: 0, calls: Vec::new(), wrong: None }
    }

    fn moment<S: Recorded>(&mut self, moment: &Moment<'_, S::Chart>) {
        let now = S::Chart::TIMED.then_some(moment.now.get());
        self.cycle(moment.cycle, now, S::shown(moment.chart, &moment.outputs), false);
    }

    /// A cycle. A trace does not tell which steps are late.
    fn cycle(&mut self, number: u32, now: Option<u32>, found: Shown, is_trace: bool) {
        let number = number as usize;
        let Some((then, seen)) = self.seen.get(number) else {
            self.wrong.get_or_insert_with(|| format!("{} shows cycle {number}, which was none", self.who));
            return;
        };
        self.calls.extend(once(&seen.calls).cloned());
        self.next = number + 1;
        let mut expected = Shown { calls: Vec::new(), ..seen.clone() };
        let mut found = found;
        if is_trace {
            expected.outputs.retain(|name, _| !name.starts_with("late("));
            found.outputs.retain(|_, value| *value != 0);
        }
        if found != expected || now.is_some_and(|now| now != *then) {
            let who = self.who;
            let text = || format!("{who}, cycle {number}\n  expected @{then} {expected}\n  found    {now:?} {found}");
            self.wrong.get_or_insert_with(text);
        }
    }

    /// The last cycle was shown, and the same was called.
    fn ends(self, calls: &[String]) -> Result<(), String> {
        let who = self.who;
        if let Some(wrong) = self.wrong {
            return Err(wrong);
        }
        if self.next != self.seen.len() {
            return Err(format!("{who} ends with cycle {} of {}", self.next, self.seen.len()));
        }
        if !once(calls).eq(&self.calls) {
            return Err(format!("{who} calls\n  {calls:?}\nand not\n  {:?}", self.calls));
        }
        Ok(())
    }
}
