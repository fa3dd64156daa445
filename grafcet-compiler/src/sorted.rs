//! Sets and maps in ascending order, each a sorted vector.
//!
//! The compiler has many of them, of many types and few entries. Whoever uses the macro builds it without optimisation, and there the
//! B-trees of the standard library were a quarter of all code. What may grow to very many entries in any order stays one.

use std::borrow::Borrow;
use std::cmp::Ordering;
use std::ops::Deref;
use std::{mem, slice, vec};

use crate::list::List;

/// The binary search of the standard library, as a loop of its own: half as much code for each type of key.
macro_rules! search {
    ($items:expr, |$known:pat_param| $order:expr) => {{
        let (mut from, mut to) = (0, $items.len());
        while from < to {
            let middle = usize::midpoint(from, to);
            let $known = &$items[middle];
            match $order {
                Ordering::Less => from = middle + 1,
                Ordering::Greater => to = middle,
                Ordering::Equal => return Ok(middle),
            }
        }
        Err(from)
    }};
}

/// Sorts by a key; what has the same key stays in its order.
///
/// Numbers are sorted in place of the items: so there is one sort for items of all types, of which each would be forty functions.
pub(crate) fn sort_by_key<T, K: Ord>(items: &mut [T], key: impl Fn(&T) -> K) {
    let order = order(items.len(), &|a, b| key(&items[a]).cmp(&key(&items[b])));
    put(items, order);
}

/// The same of what is its own key.
pub(crate) fn sort<T: Ord>(items: &mut [T]) {
    let order = order(items.len(), &|a, b| items[a].cmp(&items[b]));
    put(items, order);
}

/// The numbers of so many items in their order; none where they stand in order.
fn order(count: usize, compare: &dyn Fn(usize, usize) -> Ordering) -> Option<Vec<usize>> {
    if (1..count).all(|number| compare(number - 1, number) != Ordering::Greater) {
        return None;
    }
    let mut order = (0..count).list();
    sort_so(&mut order, &|a, b| compare(a, b).then(a.cmp(&b)) == Ordering::Less);
    Some(order)
}

/// Puts the items in that order, along the circles in which they change places.
fn put<T>(items: &mut [T], order: Option<Vec<usize>>) {
    let Some(mut order) = order else { return };
    for start in 0..items.len() {
        let mut place = start;
        while order[place] != start {
            let from = order[place];
            items.swap(place, from);
            order[place] = place;
            place = from;
        }
        order[place] = place;
    }
}

/// Sorts in place; what is equal stays in no order.
pub(crate) fn sort_unstable<T: Ord + Copy>(items: &mut [T]) {
    sort_so(items, &|a, b| a < b);
}

/// Shell's sort, with Knuth's gaps: one function for each type of item, where the sorts of the standard library are twenty. Lists are
/// short here, and mostly in order. (`swap` checks each time what it is given, without optimisation.)
fn sort_so<T: Copy>(items: &mut [T], before: &dyn Fn(T, T) -> bool) {
    let mut gap = 1;
    while gap < items.len() / 3 {
        gap = 3 * gap + 1;
    }
    while gap > 0 {
        for end in gap..items.len() {
            let (mut place, item) = (end, items[end]);
            while place >= gap && before(item, items[place - gap]) {
                items[place] = items[place - gap];
                place -= gap;
            }
            items[place] = item;
        }
        gap /= 3;
    }
}

/// A set: a slice in ascending order, each value once.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Set<T>(Vec<T>);

impl<T: Ord> Set<T> {
    /// The empty set.
    #[must_use]
    pub const fn new() -> Self {
        Self(Vec::new())
    }

    /// Where the value is, or where it would be.
    fn place<Q: Ord + ?Sized>(&self, value: &Q) -> Result<usize, usize>
    where
        T: Borrow<Q>,
    {
        search!(self.0, |known| known.borrow().cmp(value))
    }

    /// Whether the value was not there yet.
    pub fn insert(&mut self, value: T) -> bool {
        // What comes in order is not looked for.
        if self.0.last().is_none_or(|last| *last < value) {
            self.0.push(value);
            return true;
        }
        let place = self.place(&value);
        if let Err(place) = place {
            self.0.insert(place, value);
        }
        place.is_err()
    }

    /// Whether the value was there.
    pub fn remove(&mut self, value: &T) -> bool {
        let place = self.place(value);
        if let Ok(place) = place {
            self.0.remove(place);
        }
        place.is_ok()
    }

    /// Keeps some of the values.
    pub fn retain(&mut self, keep: impl FnMut(&T) -> bool) {
        self.0.retain(keep);
    }

    /// Whether the value is there.
    #[must_use]
    pub fn contains<Q: Ord + ?Sized>(&self, value: &Q) -> bool
    where
        T: Borrow<Q>,
    {
        self.place(value).is_ok()
    }

    /// Whether all values are in the other set, too.
    #[must_use]
    pub fn is_subset(&self, other: &Self) -> bool {
        self.0.iter().all(|value| other.contains(value))
    }

    /// Whether no value is in the other set.
    #[must_use]
    pub fn is_disjoint(&self, other: &Self) -> bool {
        let (few, many) = if self.0.len() < other.0.len() { (self, other) } else { (other, self) };
        let (Some(first), Some(last)) = (many.0.first(), many.0.last()) else { return true };
        // Most of what is compared is far apart.
        !few.0.iter().any(|value| first <= value && value <= last && many.contains(value))
    }

    /// What is in both sets.
    pub fn intersection<'a>(&'a self, other: &'a Self) -> impl Iterator<Item = &'a T> {
        self.0.iter().filter(|value| other.contains(value))
    }

    /// What is in this set alone.
    pub fn difference<'a>(&'a self, other: &'a Self) -> impl Iterator<Item = &'a T> {
        self.0.iter().filter(|value| !other.contains(value))
    }
}

impl<T> Default for Set<T> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<T> Deref for Set<T> {
    type Target = [T];
    fn deref(&self) -> &[T] {
        &self.0
    }
}

impl<T: Ord> Extend<T> for Set<T> {
    fn extend<I: IntoIterator<Item = T>>(&mut self, values: I) {
        for value in values {
            self.insert(value);
        }
    }
}

impl<'a, T: Ord + Copy> Extend<&'a T> for Set<T> {
    fn extend<I: IntoIterator<Item = &'a T>>(&mut self, values: I) {
        for value in values {
            self.insert(*value);
        }
    }
}

impl<T: Ord> FromIterator<T> for Set<T> {
    fn from_iter<I: IntoIterator<Item = T>>(values: I) -> Self {
        let mut set = Self::new();
        for value in values {
            set.insert(value);
        }
        set
    }
}

impl<T: Ord, const N: usize> From<[T; N]> for Set<T> {
    fn from(values: [T; N]) -> Self {
        Self::from_iter(values)
    }
}

impl<T> IntoIterator for Set<T> {
    type Item = T;
    type IntoIter = vec::IntoIter<T>;
    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}

impl<'a, T> IntoIterator for &'a Set<T> {
    type Item = &'a T;
    type IntoIter = slice::Iter<'a, T>;
    fn into_iter(self) -> Self::IntoIter {
        self.0.iter()
    }
}

/// A map: a slice of keys with their values, the keys in ascending order, each once.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Map<K, V>(Vec<(K, V)>);

impl<K: Ord, V> Map<K, V> {
    /// The empty map.
    #[must_use]
    pub const fn new() -> Self {
        Self(Vec::new())
    }

    /// Where the key is, or where it would be.
    fn place<Q: Ord + ?Sized>(&self, key: &Q) -> Result<usize, usize>
    where
        K: Borrow<Q>,
    {
        search!(self.0, |(known, _)| known.borrow().cmp(key))
    }

    /// Sets the key's value; the one that it had.
    pub fn insert(&mut self, key: K, value: V) -> Option<V> {
        match self.place(&key) {
            Ok(place) => Some(mem::replace(&mut self.0[place].1, value)),
            Err(place) => {
                self.0.insert(place, (key, value));
                None
            }
        }
    }

    /// Takes a key out, with its value.
    pub fn remove<Q: Ord + ?Sized>(&mut self, key: &Q) -> Option<V>
    where
        K: Borrow<Q>,
    {
        match self.place(key) {
            Ok(place) => Some(self.0.remove(place).1),
            Err(_) => None,
        }
    }

    /// The key's value.
    #[must_use]
    pub fn get<Q: Ord + ?Sized>(&self, key: &Q) -> Option<&V>
    where
        K: Borrow<Q>,
    {
        match self.place(key) {
            Ok(place) => Some(&self.0[place].1),
            Err(_) => None,
        }
    }

    /// The key's value, to be changed.
    #[must_use]
    pub fn get_mut<Q: Ord + ?Sized>(&mut self, key: &Q) -> Option<&mut V>
    where
        K: Borrow<Q>,
    {
        match self.place(key) {
            Ok(place) => Some(&mut self.0[place].1),
            Err(_) => None,
        }
    }

    /// Whether the key has a value.
    #[must_use]
    pub fn contains_key<Q: Ord + ?Sized>(&self, key: &Q) -> bool
    where
        K: Borrow<Q>,
    {
        self.place(key).is_ok()
    }

    /// The key's value; where it has none, it gets one.
    pub fn or_insert_with(&mut self, key: K, value: impl FnOnce() -> V) -> &mut V {
        let place = match self.place(&key) {
            Ok(place) => place,
            Err(place) => {
                self.0.insert(place, (key, value()));
                place
            }
        };
        &mut self.0[place].1
    }

    /// The key's value; where it has none, it gets the default one.
    pub fn or_default(&mut self, key: K) -> &mut V
    where
        V: Default,
    {
        self.or_insert_with(key, V::default)
    }

    /// All values, in the order of their keys.
    pub fn values(&self) -> impl Iterator<Item = &V> + Clone {
        self.0.iter().map(|(_, value)| value)
    }
}

impl<K, V> Default for Map<K, V> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<K, V> Deref for Map<K, V> {
    type Target = [(K, V)];
    fn deref(&self) -> &[(K, V)] {
        &self.0
    }
}

impl<K: Ord, V> Extend<(K, V)> for Map<K, V> {
    fn extend<I: IntoIterator<Item = (K, V)>>(&mut self, entries: I) {
        for (key, value) in entries {
            self.insert(key, value);
        }
    }
}

impl<K: Ord, V> FromIterator<(K, V)> for Map<K, V> {
    fn from_iter<I: IntoIterator<Item = (K, V)>>(entries: I) -> Self {
        let mut map = Self::new();
        map.extend(entries);
        map
    }
}

impl<K: Ord, V, const N: usize> From<[(K, V); N]> for Map<K, V> {
    fn from(entries: [(K, V); N]) -> Self {
        Self::from_iter(entries)
    }
}

impl<K, V> IntoIterator for Map<K, V> {
    type Item = (K, V);
    type IntoIter = vec::IntoIter<(K, V)>;
    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}

impl<'a, K, V> IntoIterator for &'a Map<K, V> {
    type Item = &'a (K, V);
    type IntoIter = slice::Iter<'a, (K, V)>;
    fn into_iter(self) -> Self::IntoIter {
        self.0.iter()
    }
}

#[cfg(test)]
mod tests {
    use super::{Map, Set, sort, sort_by_key, sort_unstable};

    #[test]
    fn a_set_holds_each_value_once_in_ascending_order() {
        let mut set = Set::from([5, 1, 3, 1]);
        assert_eq!(*set, [1, 3, 5]);
        assert!(set.insert(2) && !set.insert(2));
        assert!(set.remove(&5) && !set.remove(&5));
        set.extend(&[9, 0]);
        assert_eq!(*set, [0, 1, 2, 3, 9]);
        assert!(set.contains(&9) && !set.contains(&4));
        set.retain(|value| value % 2 == 1);
        assert_eq!(set, Set::from([9, 3, 1]));
    }

    #[test]
    fn two_sets() {
        let (few, many) = (Set::from([1, 3]), Set::from([1, 2, 3, 4]));
        assert!(few.is_subset(&many) && !many.is_subset(&few) && Set::new().is_subset(&few));
        assert!(few.is_disjoint(&Set::from([2, 4])) && !few.is_disjoint(&many));
        assert!(few.intersection(&many).eq(&[1, 3]) && many.difference(&few).eq(&[2, 4]));
    }

    #[test]
    fn a_map_holds_the_last_value_of_each_key() {
        let mut map = Map::from([("b", 1), ("a", 2), ("b", 3)]);
        assert_eq!(*map, [("a", 2), ("b", 3)]);
        assert_eq!((map.insert("c", 4), map.insert("a", 5)), (None, Some(2)));
        assert_eq!((*map.or_default("b"), *map.or_default("d"), *map.or_insert_with("e", || 7)), (3, 0, 7));
        assert_eq!((map.remove("b"), map.remove("b"), map.get("c"), map.get("a")), (Some(3), None, Some(&4), Some(&5)));
        if let Some(value) = map.get_mut("d") {
            *value = 6;
        }
        assert!(map.values().eq(&[5, 4, 6, 7]) && map.contains_key("d") && !map.contains_key("b"));
    }
    /// So many numbers below `span`, of which many are the same.
    fn mixed(count: usize, span: usize) -> Vec<usize> {
        (0..count).map(|number| number * number % 1009 * 7 % span).collect()
    }

    #[test]
    fn sorted_as_the_standard_library_does() {
        for count in (0..50).chain([100, 1000, 5000]) {
            let numbers = mixed(count, 300);
            let backwards = || numbers.iter().rev().copied().collect::<Vec<_>>();
            let mut expected = backwards();
            expected.sort_unstable();
            let (mut stable, mut unstable, mut again) = (backwards(), backwards(), expected.clone());
            sort(&mut stable);
            sort_unstable(&mut unstable);
            sort_unstable(&mut again);
            assert_eq!((&stable, &unstable, &again), (&expected, &expected, &expected), "{count}");
        }
    }

    #[test]
    fn what_has_the_same_key_stays_in_its_order() {
        for count in (0..50).chain([1000]) {
            let mut items: Vec<(usize, usize)> = mixed(count, 10).into_iter().zip(0..).collect();
            let mut expected = items.clone();
            expected.sort_unstable();
            sort_by_key(&mut items, |(key, _)| *key);
            assert_eq!(items, expected, "{count}");
        }
        // A circle of all of them.
        let mut turned: Vec<usize> = (1..100).chain([0]).collect();
        sort_by_key(&mut turned, |number| *number);
        assert!(turned.iter().copied().eq(0..100));
    }
}
