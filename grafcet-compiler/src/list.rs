//! What comes one by one, put together: what the standard library does, as loops.
//!
//! Whoever uses the macro builds it without optimisation, and there each `collect` into a vector is a dozen functions of its own, one
//! into tokens thirty, and each `flat_map` that somebody asks for something twenty.

use proc_macro2::TokenStream;

/// What others build upon, as loops: the standard library's own go through four functions more, for each closure anew, and whoever
/// uses the macro builds it without optimisation.
macro_rules! searches {
    () => {
        fn fold<B, F: FnMut(B, Self::Item) -> B>(mut self, begin: B, mut join: F) -> B {
            let mut joined = begin;
            while let Some(item) = self.next() {
                joined = join(joined, item);
            }
            joined
        }

        fn any<F: FnMut(Self::Item) -> bool>(&mut self, mut test: F) -> bool {
            while let Some(item) = self.next() {
                if test(item) {
                    return true;
                }
            }
            false
        }

        fn all<F: FnMut(Self::Item) -> bool>(&mut self, mut test: F) -> bool {
            while let Some(item) = self.next() {
                if !test(item) {
                    return false;
                }
            }
            true
        }

        fn find<P: FnMut(&Self::Item) -> bool>(&mut self, mut test: P) -> Option<Self::Item> {
            while let Some(item) = self.next() {
                if test(&item) {
                    return Some(item);
                }
            }
            None
        }

        fn find_map<B, F: FnMut(Self::Item) -> Option<B>>(&mut self, mut look: F) -> Option<B> {
            while let Some(item) = self.next() {
                let found = look(item);
                if found.is_some() {
                    return found;
                }
            }
            None
        }
    };
}
pub(crate) use searches;

/// Puts together what an iterator yields.
pub(crate) trait List: Iterator + Sized {
    /// All of it, as a vector.
    fn list(mut self) -> Vec<Self::Item> {
        let mut all = Vec::new();
        fill(&mut all, &mut self);
        all
    }

    /// All tokens, one after the other.
    fn tokens(mut self) -> TokenStream
    where
        Self: Iterator<Item = TokenStream>,
    {
        join(&mut self)
    }

    /// What `make` finds in each item, as one sequence: `flat_map`.
    fn flat<J: IntoIterator, M: FnMut(Self::Item) -> J>(self, make: M) -> Flat<Self, J::IntoIter, M> {
        Flat { outer: self, make, inner: None }
    }

    /// And after it what another yields: `chain`.
    fn and<J: IntoIterator<Item = Self::Item>>(self, other: J) -> And<Self, J::IntoIter> {
        And { first: Some(self), second: other.into_iter() }
    }
}

impl<I: Iterator> List for I {}

/// Puts what an iterator yields after what is there: `extend`.
pub(crate) trait PushAll<T> {
    fn push_all(&mut self, items: impl IntoIterator<Item = T>);
}

impl<T> PushAll<T> for Vec<T> {
    fn push_all(&mut self, items: impl IntoIterator<Item = T>) {
        fill(self, &mut items.into_iter());
    }
}

/// An iterator behind a pointer. With that of the standard library goes a table of all that it could do beside, and with a closure one
/// function more.
trait Source<T> {
    fn take(&mut self) -> Option<T>;
}

impl<I: Iterator> Source<I::Item> for I {
    fn take(&mut self) -> Option<I::Item> {
        self.next()
    }
}

/// One for each type of item, not one for each iterator.
fn fill<T>(all: &mut Vec<T>, from: &mut dyn Source<T>) {
    while let Some(item) = from.take() {
        all.push(item);
    }
}

fn join(from: &mut dyn Source<TokenStream>) -> TokenStream {
    let mut all = TokenStream::new();
    while let Some(tokens) = from.take() {
        all.extend(tokens);
    }
    all
}

/// See [`List::flat`].
#[derive(Clone)]
pub(crate) struct Flat<I, J, M> {
    outer: I,
    make: M,
    inner: Option<J>,
}

impl<I: Iterator, J: IntoIterator, M: FnMut(I::Item) -> J> Iterator for Flat<I, J::IntoIter, M> {
    type Item = J::Item;

    fn next(&mut self) -> Option<J::Item> {
        loop {
            if let Some(inner) = &mut self.inner {
                let item = inner.next();
                if item.is_some() {
                    return item;
                }
            }
            self.inner = match self.outer.next() {
                Some(item) => Some((self.make)(item).into_iter()),
                None => return None,
            };
        }
    }

    searches!();
}

/// See [`List::and`].
#[derive(Clone)]
pub(crate) struct And<I, J> {
    first: Option<I>,
    second: J,
}

impl<I: Iterator, J: Iterator<Item = I::Item>> Iterator for And<I, J> {
    type Item = I::Item;

    fn next(&mut self) -> Option<I::Item> {
        if let Some(first) = &mut self.first {
            let item = first.next();
            if item.is_some() {
                return item;
            }
            self.first = None;
        }
        self.second.next()
    }

    searches!();
}

#[cfg(test)]
mod tests {
    use super::{List, PushAll};

    #[test]
    fn sequences_of_sequences() {
        let rows = [vec![], vec![1, 2], vec![], vec![3], vec![]];
        assert_eq!(rows.iter().flat(|row| row).copied().list(), [1, 2, 3]);
        let mut rest = rows.iter().flat(|row| row);
        assert!(
            rest.find(|number| **number == 2).is_some() && rest.any(|number| *number == 3) && rest.next().is_none()
        );
        assert_eq!(rows.iter().flat(Vec::clone).fold(0, |sum, number| 10 * sum + number), 123);
    }

    #[test]
    fn one_after_the_other() {
        assert_eq!([1, 2].into_iter().and([3]).and([]).and(Some(4)).list(), [1, 2, 3, 4]);
        let none: [u8; 0] = [];
        assert_eq!(none.into_iter().and(none).next(), None);
        let mut both = [1, 2].iter().and(&[3, 4]);
        assert!(both.all(|number| *number < 3) || both.next() == Some(&4));
    }

    #[test]
    fn after_what_is_there() {
        let mut all = vec![1];
        all.push_all([2, 3].into_iter().filter(|number| number % 2 == 1));
        all.push_all(vec![4]);
        assert_eq!(all, [1, 3, 4]);
    }
}
