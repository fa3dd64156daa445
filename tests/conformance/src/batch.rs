//! What the crates of `cargo xtask conformance` run.
