//! Step chains written inline in Rust: GRAFCET (IEC 60848) and SFC (IEC 61131-3) charts, checked at compile time,
//! zero-allocation at run time.
//!
//! [`grafcet!`] turns a chart in the source into a type that holds its state and a function that runs one cycle. The
//! generated code is `no_std` and has no heap, no `unsafe` and no panic; a chart that breaks a rule of drawing does not
//! compile, and the error stands at the tokens of the chart.
//!
//! ```
//! use grafcet::grafcet;
//!
//! grafcet! {
//!     /// A motor that can be switched on and off, guarded against over-temperature.
//!     pub sfc Motor {
//!         input on, off, over_temp: bool;
//!         output relay, green, red: bool;
//!
//!         initial step Off { N red; }
//!         step On { N relay; N green; }
//!
//!         Off -[on && !over_temp]-> On -[off || over_temp]-> Off;
//!     }
//! }
//!
//! let mut motor = Motor::new();
//! let q = motor.cycle(&MotorInputs::default());
//! assert!(q.red && !q.relay);
//! let q = motor.cycle(&MotorInputs { on: true, ..Default::default() });
//! assert!(q.relay && q.green && !q.red);
//! assert_eq!(motor.situation(), MotorStep::On);
//! assert_eq!(size_of::<Motor>(), 1);
//! ```
//!
//! # Dialects
//!
//! The first keyword of a chart says by whose rules it evolves. An `sfc` makes one evolution per cycle, the first branch
//! in the source has priority, and actions carry the qualifiers of IEC 61131-3. A `grafcet` clears everything that is
//! fireable until the situation is stable, and knows the continuous and stored actions of IEC 60848.
//!
//! # In a program
//!
//! A controller calls `cycle` in its loop or timer interrupt: read the inputs, run the chart, write the outputs. `new` is
//! a `const fn`, so a chart may be a `static` after whatever lock the target offers. `init` is the classic *Init*: back
//! to the initial situation, stored outputs reset.
//!
//! Code for any chart is generic over the trait [`Chart`]:
//!
//! ```
//! use grafcet::{Chart, Ticks, grafcet};
//!
//! /// Runs a chart on recorded inputs and counts the cycles in which `step` was active.
//! fn cycles_in<C>(mut chart: C, step: C::Step, inputs: &[C::Inputs]) -> usize
//! where
//!     C: for<'a> Chart<Actions<'a> = ()>,
//! {
//!     let mut active = |inputs| {
//!         chart.scan(inputs, Ticks::ZERO, &mut ());
//!         chart.is_active(step)
//!     };
//!     inputs.iter().filter(|inputs| active(inputs)).count()
//! }
//!
//! grafcet! {
//!     grafcet Light {
//!         input button: bool;
//!         output lamp: bool;
//!         initial step Dark;
//!         step Lit { lamp; }
//!         Dark -[button]-> Lit -[!button]-> Dark;
//!     }
//! }
//!
//! let recorded = [false, true, true, false].map(|button| LightInputs { button });
//! assert_eq!(cycles_in(Light::new(), LightStep::Lit, &recorded), 2);
//! ```
//!
//! # The manual
//!
//! [First chart](manual::first_chart), from `cargo new` to an emulated controller; [the language](manual::language), all that a
//! chart may hold; [the meaning](manual::semantics), what one cycle does exactly; [the rules](manual::rules) that the compiler
//! checks; [the names](manual::names); [the cookbook](manual::cookbook); [porting](manual::porting) of CASE and flip-flop
//! programs; [the tool](manual::tool) `cargo grafcet`; [the playground](manual::playground) in the browser.
#![no_std]

/// Pictures of a chart, with the steps marked that are active: for the host, with the feature `std`.
///
/// ```
/// # use grafcet::grafcet;
/// grafcet! {
///     sfc Motor {
///         input on, off: bool;
///         output relay: bool;
///         initial step Off;
///         step On { N relay; }
///         Off -[on]-> On -[off]-> Off;
///     }
/// }
///
/// let mut motor = Motor::new();
/// motor.cycle(&MotorInputs::default());
/// motor.cycle(&MotorInputs { on: true, ..Default::default() });
/// let picture = grafcet::draw::svg(&Motor::CHART, &motor.situation());
/// assert!(picture.starts_with("<svg"));
/// let text = grafcet::draw::text(&Motor::CHART, &motor.situation());
/// assert!(text.contains("│●On  ├─┤ N │ relay │"), "{text}");
/// ```
#[cfg(feature = "std")]
pub use grafcet_draw as draw;

/// The flight recorder, with the feature `record`.
#[cfg(feature = "record")]
pub use grafcet_core::record;
#[cfg(feature = "record")]
pub use grafcet_core::recordable;
pub use grafcet_core::{ActiveSteps, Chart, ForceError, Forceable, OutOfRange, Phase, Ticks, description};
pub use heapless;

/// Turns a chart into a state enum and a cycle function.
///
/// For a chart `Motor` it generates, with the chart's visibility, these types:
///
/// | type | what it is |
/// | --- | --- |
/// | `Motor` | the state; it implements [`Chart`] |
/// | `MotorInputs`, `MotorOutputs` | plain structs with a field for each declared input and output. `MotorInputs::DEFAULT` is there where all defaults are constants |
/// | `MotorStep`, `MotorTransition` | the names of its steps and transitions; `name` gives one as text |
/// | `MotorSituation` | which steps are active, where that is not always one; elsewhere a situation is a `MotorStep` |
/// | `MotorParams` | the recipe, where the chart declares a `param` |
/// | `MotorVars` | the values of its variables, where it stores any |
/// | `MotorActions` | a trait for whoever carries out the code actions, where the chart declares an `action` |
///
/// and these items of `Motor`:
///
/// | item | where | what it does |
/// | --- | --- | --- |
/// | `new`, `init` | always | begins in the initial situation, and goes back there |
/// | `cycle` | always | one cycle. A chart that uses time takes the reading of its clock, too, and one that declares actions what carries them out |
/// | `situation`, `is_active`, `active_steps`, `is_exactly` | always | tell which steps are active |
/// | `CHART` | always | the chart's [`description`] as data. The documentation of `Motor` has its picture |
/// | `is_stable` | in a `grafcet` | whether the last search came to an end |
/// | `next_deadline`, `ticks` | with time | until when nothing changes unless an input does; and a `Duration` in ticks of the chart |
/// | `with_params`, `params`, `set_params` | with a `param` | begin with a recipe, show and exchange it; where a `param` has a range, what is out of it is [refused](OutOfRange) |
/// | `vars` | with stored variables | their values after the last cycle |
/// | `late_steps` | with `within` | the steps that take longer |
/// | `assumptions_hold` | with `assume never` | whether the plant keeps to that |
/// | `force` | with `forceable;` | into a situation by hand; `Motor` implements [`Forceable`] |
///
/// With the feature `record` a chart can be recorded, too (`record::Recordable`), and tells what it waits for (`record::Blocked`). A plant in the
/// same call becomes a chart of its own.
///
/// What is wrong with the chart is a compile error, all of it at once; where a rule is broken, the message ends with the
/// rule's name. The types are generated all the same, so that the rest of the program gets no errors that follow from it.
///
/// ```compile_fail
/// grafcet::grafcet! {
///     sfc Motor {
///         input on, off: bool;
///         initial step Off;
///         step On;
///         Off -> On -[off]-> Off;      // error: between two steps there is always a transition
///     }
/// }
/// ```
#[macro_export]
macro_rules! grafcet {
    ($($chart:tt)*) => { $crate::__private::chart! { [$crate] $($chart)* } };
}

/// In the edition 2015 the tokens without the path in front, in later ones those with it: `async` is the name of a type there
/// and a keyword here.
#[doc(hidden)]
#[macro_export]
macro_rules! __by_edition {
    ($since_2015:ty [$($path:tt)*] $($tokens:tt)*) => { $($tokens)* };
    (async [$($path:tt)*] $($tokens:tt)*) => { $($path)* $($tokens)* };
}

/// Items under an attribute: a plant that is a type only where it is wanted.
#[doc(hidden)]
#[macro_export]
macro_rules! __under {
    ([$when:meta] $($item:item)*) => { $(#[$when] $item)* };
}

/// What generated code names. Not for anybody else: it may change with every version.
#[doc(hidden)]
pub mod __private {
    pub extern crate core;
    pub use core::option::Option;
    pub use core::primitive::{bool, str, u8, u16, u32, usize};
    pub use core::result::Result;

    pub use __by_edition as by_edition;
    pub use __under as under;
    pub use grafcet_core::__has_reached as has_reached;
    pub use grafcet_core::fence::{fence_beyond_armv6m, fence_on_armv6m};
    #[cfg(feature = "record")]
    pub use grafcet_core::record::Blocked;
    pub use grafcet_core::values::{copied, default_value, is_same, name_at, step_at};
    #[cfg(feature = "record")]
    pub use grafcet_core::{__recorded as recorded, __recorded_stub as recorded_stub};
    pub use grafcet_core::{
        ActiveSteps, Chart, ForceError, Forceable, OutOfRange, Phase, Possible, Ticks, description, earlier, flags,
        phase, rest, situation, sooner,
    };
    pub use grafcet_macros::chart;
    pub use heapless;
}

/// The pages of the folder `docs`, part of the documentation alone.
// A link between pages leads from file to file in the repository and from module to module here: of two definitions of a
// link the first one counts.
#[cfg(all(doc, not(doctest)))]
pub mod manual {
    #[doc = "[language]: self::language\n[semantics]: self::semantics\n[cookbook]: self::cookbook\n"]
    #[doc = include_str!("../docs/first-chart.md")]
    pub mod first_chart {}

    #[doc = "[names]: self::names\n[semantics]: self::semantics\n"]
    #[doc = include_str!("../docs/language.md")]
    pub mod language {}

    #[doc = include_str!("../docs/semantics.md")]
    pub mod semantics {}

    #[doc = "[names]: self::names\n[semantics]: self::semantics\n"]
    #[doc = include_str!("../docs/rules.md")]
    pub mod rules {}

    #[doc = include_str!("../docs/names.md")]
    pub mod names {}

    #[doc = "[porting]: self::porting\n"]
    #[doc = include_str!("../docs/cookbook.md")]
    pub mod cookbook {}

    #[doc = "[semantics]: self::semantics\n"]
    #[doc = include_str!("../docs/porting.md")]
    pub mod porting {}

    #[doc = "[semantics]: self::semantics\n"]
    #[doc = include_str!("../docs/record.md")]
    pub mod record {}

    #[doc = "[record]: self::record\n"]
    #[doc = include_str!("../docs/tool.md")]
    pub mod tool {}

    #[doc = "[rules]: self::rules\n[cookbook]: self::cookbook\n[tool]: self::tool\n"]
    #[doc = include_str!("../docs/playground.md")]
    pub mod playground {}
}

/// The charts of the pages are tests. Those of the rules, half of which are wrong, have a test of their own, and the first
/// chart is followed from command to command: `cargo xtask first-chart`.
#[cfg(doctest)]
mod pages {
    #[doc = include_str!("../README.md")]
    struct Readme;
    #[doc = include_str!("../docs/language.md")]
    struct Language;
    #[doc = include_str!("../docs/semantics.md")]
    struct Semantics;
    #[doc = include_str!("../docs/names.md")]
    struct Names;
    #[doc = include_str!("../docs/drawing.md")]
    struct Drawing;
    #[doc = include_str!("../docs/cookbook.md")]
    struct Cookbook;
    #[doc = include_str!("../docs/porting.md")]
    struct Porting;
    #[doc = include_str!("../docs/tool.md")]
    struct Tool;
}
