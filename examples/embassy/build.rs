//! Hands the board's memory map and the linker script of cortex-m-rt to the linker.

fn main() {
    println!("cargo:rerun-if-changed=memory.x");
    let folder = std::env::var("CARGO_MANIFEST_DIR").expect("cargo sets CARGO_MANIFEST_DIR");
    println!("cargo:rustc-link-search={folder}");
    println!("cargo:rustc-link-arg-bins=-Tlink.x");
}
