//! What keeps the optimiser from making more of generated code than it has to, where that depends on the processor.

/// No access to memory is moved across it on ARMv6-M (Cortex-M0, M0+, M1); on all other processors it is nothing.
///
/// A jump table takes a word for each step there, or a byte, if nothing after the jump asks for the step that it went by. What is after this
/// reads the step anew.
// Of the processors of this architecture only these, and some that are older, cannot exchange a word in one instruction.
#[inline(always)]
pub fn fence_on_armv6m() {
    #[cfg(all(target_arch = "arm", not(target_has_atomic = "32")))]
    core::sync::atomic::compiler_fence(core::sync::atomic::Ordering::SeqCst);
}

/// No access to memory is moved across it but on ARMv6-M, where it is nothing.
///
/// A function that needs four arguments to its end fills the registers that short instructions name, and LLVM saves a further one last. What is read anew after
/// this, as the clock is from where it is kept, leaves its register to others.
#[inline]
pub fn fence_beyond_armv6m() {
    #[cfg(not(all(target_arch = "arm", not(target_has_atomic = "32"))))]
    core::sync::atomic::compiler_fence(core::sync::atomic::Ordering::SeqCst);
}
