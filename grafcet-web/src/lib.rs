#![doc = include_str!("../README.md")]

mod forms;
pub mod gallery;
mod look;
mod play;
mod text;

use wasm_bindgen::prelude::wasm_bindgen;

pub use forms::Form;
pub use play::Play;

/// What can be seen of a text at once: its drawing, and the names in it; as JSON.
#[wasm_bindgen]
#[must_use]
pub fn look(text: &str) -> String {
    // Nothing of the texts before is asked for any more, and lexers keep every one of them.
    proc_macro2::extra::invalidate_current_thread_spans();
    look::look(text).to_string()
}

/// What the compiler says of a text, at its places, and whether the chart can run; as JSON.
#[wasm_bindgen]
#[must_use]
pub fn check(text: &str) -> String {
    proc_macro2::extra::invalidate_current_thread_spans();
    look::check(text).to_string()
}

/// The same chart in another notation: `rust`, `case`, `flip-flops`, `sfc`, `plcopen`, `pnml`, `aiger`, `btor2`; as JSON.
///
/// # Errors
/// There is no notation of that name.
#[wasm_bindgen]
pub fn translate(text: &str, form: &str) -> Result<String, String> {
    let form = Form::named(form).ok_or_else(|| format!("there is no notation `{form}`"))?;
    proc_macro2::extra::invalidate_current_thread_spans();
    Ok(forms::translate(text, form).to_string())
}

/// A chart that runs, one for each instance of this module.
#[wasm_bindgen]
pub struct Session(Play);

#[wasm_bindgen]
impl Session {
    /// The chart of this text before its first cycle; from one cycle to the next there are `step` ticks of its clock.
    ///
    /// # Errors
    /// It is no chart that can be run: why.
    #[wasm_bindgen(constructor)]
    pub fn new(text: &str, step: u32) -> Result<Self, String> {
        Ok(Self(Play::new(text, step)?))
    }

    /// The names of everything, and what kind of value each has; as JSON.
    #[must_use]
    pub fn names(&self) -> String {
        self.0.names().to_string()
    }

    /// The present moment; as JSON.
    #[must_use]
    pub fn now(&self) -> String {
        self.0.now().to_string()
    }

    /// Ticks from one cycle to the next.
    pub fn step_by(&mut self, step: u32) {
        self.0.step_by(step);
    }

    /// Sets the signal in this place of `names().signals` to a value, as JSON.
    ///
    /// # Errors
    /// It cannot have this value.
    pub fn set(&mut self, signal: usize, value: &str) -> Result<(), String> {
        self.0.set(signal, value)
    }

    /// The same for a parameter, in its place of `names().params`.
    ///
    /// # Errors
    /// As of [`Session::set`].
    pub fn set_param(&mut self, param: usize, value: &str) -> Result<(), String> {
        self.0.set_param(param, value)
    }

    /// So many cycles: those in which something changed, and the last one; as JSON.
    ///
    /// # Errors
    /// The chart's own arithmetic fails; the cycles before that one are made.
    pub fn advance(&mut self, cycles: u32) -> Result<String, String> {
        Ok(self.0.advance(cycles)?.to_string())
    }

    /// Cycles until something changes, at most so many: the last one; as JSON.
    ///
    /// # Errors
    /// As of [`Session::advance`].
    pub fn skip(&mut self, most: u32) -> Result<String, String> {
        Ok(self.0.skip(most)?.to_string())
    }

    /// A cycle at this time of the chart's clock; as JSON.
    ///
    /// # Errors
    /// As of [`Session::advance`].
    pub fn cycle_at(&mut self, now: u32) -> Result<String, String> {
        Ok(self.0.cycle_at(now)?.to_string())
    }

    /// A cycle that leads into the situation of these steps, by their places; as JSON.
    ///
    /// # Errors
    /// As of [`Session::advance`].
    pub fn force(&mut self, now: u32, steps: &[usize]) -> Result<String, String> {
        Ok(self.0.force(now, steps)?.to_string())
    }

    /// The next cycle, which leads into the situation of these steps, as the compiled chart lets itself be put into it; as JSON.
    ///
    /// # Errors
    /// The chart is not `forceable;` or is never in exactly these steps, or as of [`Session::advance`].
    pub fn by_hand(&mut self, steps: &[usize]) -> Result<String, String> {
        Ok(self.0.by_hand(steps)?.to_string())
    }

    /// The classic *Init*: the next cycle starts like a first one.
    ///
    /// # Errors
    /// An initial value is not understood.
    pub fn init(&mut self) -> Result<(), String> {
        self.0.init()
    }

    /// Back to the end of the cycle of this number.
    ///
    /// # Errors
    /// Its time is forgotten.
    pub fn rewind(&mut self, cycle: u32) -> Result<String, String> {
        Ok(self.0.rewind(cycle)?.to_string())
    }
}
