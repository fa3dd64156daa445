//! A crate of its own that passes the macro on: as it is, under another name, and inside a macro of its own.
#![deny(warnings)]

/// For the macros of this crate.
#[doc(hidden)]
pub use grafcet as again;
pub use grafcet::grafcet;
pub use grafcet::grafcet as chart;

/// A light that a condition switches on and another one off.
#[macro_export]
macro_rules! light {
    ($vis:vis $name:ident: $on:ident, $off:ident) => {
        $crate::again::grafcet! {
            /// A light.
            $vis sfc $name {
                input $on, $off: bool;
                output lamp: bool;
                initial step Dark;
                step Lit { N lamp; }
                Dark -[$on]-> Lit -[$off]-> Dark;
            }
        }
    };
}
