//! How a field of a chart is written down.

use core::marker::PhantomData;

use super::bits::{Reader, Writer};
use super::value::Record;

/// A way to write values of a type, which need not be the one that [`Record`] says of it: an enum whose variants the chart lists is written by that list,
/// and needs no `Record`.
pub trait Coding<T> {
    /// As [`Record::BITS`].
    const BITS: usize;
    /// As [`Record::IS_WORD`].
    const IS_WORD: bool = false;

    /// As [`Record::word`].
    fn word(value: &T) -> u32 {
        _ = value;
        0
    }

    /// As [`Record::write`].
    fn write(value: &T, to: &mut Writer<'_>);

    /// As [`Record::read`].
    fn read(from: &mut Reader<'_>) -> Option<T>;

    /// As [`Record::is_same`].
    fn is_same(one: &T, other: &T) -> bool;
}

/// As [`Record`] says of the type.
#[derive(Debug)]
pub struct Own;

impl<T: Record> Coding<T> for Own {
    const BITS: usize = T::BITS;
    const IS_WORD: bool = T::IS_WORD;

    #[inline]
    fn word(value: &T) -> u32 {
        value.word()
    }

    #[inline]
    fn write(value: &T, to: &mut Writer<'_>) {
        value.write(to);
    }

    #[inline]
    fn read(from: &mut Reader<'_>) -> Option<T> {
        T::read(from)
    }

    #[inline]
    fn is_same(one: &T, other: &T) -> bool {
        one.is_same(other)
    }
}

/// The same of what may be missing, as wide with a value as without one.
#[derive(Debug)]
pub struct Optional<C>(PhantomData<C>);

impl<T, C: Coding<T>> Coding<Option<T>> for Optional<C> {
    const BITS: usize = 1 + C::BITS;

    fn write(value: &Option<T>, to: &mut Writer<'_>) {
        to.put(u32::from(value.is_some()), 1);
        match value {
            Some(value) => C::write(value, to),
            None => to.skip(C::BITS),
        }
    }

    fn read(from: &mut Reader<'_>) -> Option<Option<T>> {
        if from.take(1)? != 0 { C::read(from).map(Some) } else { from.is_empty(C::BITS).then_some(None) }
    }

    fn is_same(one: &Option<T>, other: &Option<T>) -> bool {
        match (one, other) {
            (Some(one), Some(other)) => C::is_same(one, other),
            (one, other) => one.is_some() == other.is_some(),
        }
    }
}
