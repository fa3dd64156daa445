//! Runs on the host below callgrind, which counts, and prints one line for each chart: `chart dialect hash`, the hash as on
//! the board.
//!
//! Callgrind writes a count whenever [`bench_counted`] has run, four for each chart: of random inputs those of the chart
//! and of what returns at once, and the same of inputs that are all false.

use core::hint::black_box;

use grafcet_benches::{Bench, Function, Inputs, Outputs, Visitor, visit_all};

use crate::{counts, hash, idle, random};

core::arch::global_asm!(".global bench_nothing", "bench_nothing: ret");

pub fn run() {
    visit_all(&mut Counter);
}

struct Counter;

impl Visitor for Counter {
    fn visit<C, I: Inputs, O: Outputs, F: Function<C, I, O>>(&mut self, bench: &Bench<C, F>) {
        let inputs = random::<I>();
        println!("{} {} {:08x}", bench.chart, bench.dialect, hash(bench, &inputs));
        counts(bench, &inputs, |work| bench_counted(work));
        counts(bench, &idle(), |work| bench_counted(work));
    }
}

/// Callgrind finds it by its name: one function for all charts, which is neither inlined nor renamed.
#[unsafe(no_mangle)]
#[inline(never)]
fn bench_counted(work: &mut dyn FnMut()) {
    work();
    // With nothing after it the call would become a jump out of this function.
    black_box(());
}
