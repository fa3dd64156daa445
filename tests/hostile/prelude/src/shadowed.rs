//! Beside the charts, the names of the prelude, of `core` and of grafcet mean something else.

macro_rules! types {
    ($($name:ident)*) => { $(pub(crate) struct $name;)* };
}
types! {
    Arguments Box Chart Delay Duration Err Formatter None Ok OnDelay Phase Some Some_ String Ticks Vec bool char f32 f64
    i16 i32 i64 i8 isize str u128 u16 u32 u64 u8 usize
}

macro_rules! enums {
    ($($name:ident)*) => { $(pub(crate) enum $name {})* };
}
enums! { Option Ordering Result }

macro_rules! traits {
    ($($name:ident)*) => { $(pub(crate) trait $name {})* };
}
traits! {
    Add Clone Copy Debug Default Display Drop Eq Fn FnMut FnOnce From Hash Hasher Into IntoIterator Iterator Not Ord
    PartialEq PartialOrd Send Sized Sync ToOwned ToString
}

macro_rules! modules {
    ($($name:ident)*) => { $(pub(crate) mod $name {})* };
}
modules! {
    __private alloc clone cmp convert core default fmt grafcet grafcet_core grafcet_macros hash heapless hint marker
    option std time
}

/// Macros get in the way of all that follows.
macro_rules! macros {
    ($dollar:tt $($name:ident)*) => {
        $(macro_rules! $name { ($dollar($dollar tokens:tt)*) => { compile_error!("not this one") }; })*
    };
}
macros! { $
    assert assert_eq chart concat debug_assert debug_assert_eq env file format include_bytes line matches panic
    stringify todo unimplemented unreachable vec write
}

include!("charts.rs");
