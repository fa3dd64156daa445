//! The second half of the conformance corpus on a Cortex-M, with the host's console after semihosting.
#![no_std]
#![no_main]

#[path = "../check.rs"]
#[allow(dead_code, reason = "the other half may need it")]
mod check;
#[path = "../run.rs"]
mod run;

#[allow(warnings, clippy::all, clippy::pedantic, missing_docs, reason = "written by the build script")]
mod corpus {
    include!(concat!(env!("OUT_DIR"), "/second_half.rs"));
}

#[cortex_m_rt::entry]
fn main() -> ! {
    run::all(corpus::ALL)
}
