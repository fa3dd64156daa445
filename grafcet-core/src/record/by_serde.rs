//! Values of the program's own types as `serde` writes them, in the format of `postcard`: `recordable! { Target as serde in 6 bytes }`.
//!
//! A value takes a bit and a fixed number of bytes: the bit says that it fits into them, and what `postcard` does not use of them is zero.

use postcard::ser_flavors::Size;
use serde::Serialize;
use serde::de::DeserializeOwned;

use super::bits::{Reader, Writer};

/// How many bytes a value takes in the format of `postcard`: what to write after `in` of
/// [`recordable!`](crate::recordable) is the most of all values. `None` where the type refuses to be written.
///
/// A `u8`, an `i8`, a `bool` and the choice of a variant take one byte each, other integers at most 3 (16 bits), 5 (32 bits) or 10 (64 bits), floats as many as in memory.
pub fn postcard_len<T: Serialize>(value: &T) -> Option<usize> {
    postcard::serialize_with_flavor(value, Size::default()).ok()
}

/// Asks for what a type has to have, where it is named.
#[doc(hidden)]
pub const fn asked<T: Serialize + DeserializeOwned + Copy>() {}

#[doc(hidden)]
pub fn write<T: Serialize, const BYTES: usize>(value: &T, to: &mut Writer<'_>) {
    let encoded = encoded::<T, BYTES>(value);
    to.put(u32::from(encoded.is_some()), 1);
    for byte in encoded.unwrap_or([0; BYTES]) {
        to.put(u32::from(byte), 8);
    }
}

/// `None` also where another encoding of the same value stands there: what is read is written in the same way again.
#[doc(hidden)]
pub fn read<T: Serialize + DeserializeOwned, const BYTES: usize>(from: &mut Reader<'_>) -> Option<T> {
    let fits = from.take(1)? != 0;
    let mut bytes = [0; BYTES];
    for byte in &mut bytes {
        *byte = u8::try_from(from.take(8)?).ok()?;
    }
    let (value, _) = postcard::take_from_bytes(&bytes).ok()?;
    (fits && encoded(&value) == Some(bytes)).then_some(value)
}

#[doc(hidden)]
pub fn is_same<T: Serialize, const BYTES: usize>(one: &T, other: &T) -> bool {
    encoded::<T, BYTES>(one) == encoded::<T, BYTES>(other)
}

/// The bytes of a value; `None` where it takes more.
fn encoded<T: Serialize, const BYTES: usize>(value: &T) -> Option<[u8; BYTES]> {
    let mut bytes = [0; BYTES];
    postcard::to_slice(value, &mut bytes).ok()?;
    Some(bytes)
}

/// What [`recordable!`](crate::recordable) writes of a type with `serde`.
#[doc(hidden)]
#[macro_export]
macro_rules! __recordable_by_serde {
    ($name:ty, $bytes:tt) => {
        impl $crate::record::Record for $name {
            const BITS: $crate::record::names::usize = {
                $crate::record::by_serde::asked::<$name>();
                1 + 8 * $bytes
            };

            fn write(&self, to_: &mut $crate::record::Writer<'_>) {
                $crate::record::by_serde::write::<$name, $bytes>(self, to_);
            }

            fn read(from_: &mut $crate::record::Reader<'_>) -> $crate::record::names::Option<Self> {
                $crate::record::by_serde::read::<$name, $bytes>(from_)
            }

            fn is_same(&self, other_: &Self) -> $crate::record::names::bool {
                $crate::record::by_serde::is_same::<$name, $bytes>(self, other_)
            }
        }
    };
}
