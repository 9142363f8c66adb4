//! Some of a body's supports.

use std::fmt;

/// A set of support points, by their numbers.
///
/// # Example
/// Of four legs two stand, two more strike, and the first two open.
/// ```
/// use carom_motion::spatial::Supports;
/// let (held, striking) = (Supports::one(0).with(1), Supports::one(2).with(3));
/// let touching = held.union(striking);
/// assert_eq!((touching.len(), touching.difference(held)), (4, striking));
/// ```
#[derive(Clone, Copy)]
pub struct Supports {
    /// How many there are; one more than it holds where some had no room.
    count: u16,
    /// Their numbers, the smallest first.
    numbers: [u16; Supports::TOGETHER],
}

impl Supports {
    /// How many supports a body may have, of all obstacles together.
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::Supports;
    /// let last = Supports::one(Supports::MOST - 1);
    /// assert!(last.contains(65_535) && last.len() == 1);
    /// ```
    pub const MOST: usize = 1 << u16::BITS;
    /// How many of them one set holds: so many may touch at once.
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::Supports;
    /// let all: Supports = (0..Supports::TOGETHER).collect();
    /// assert_eq!((all.len(), all.is_overfull()), (95, false));
    /// ```
    pub const TOGETHER: usize = 95;
    /// None of them.
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::Supports;
    /// assert!(Supports::NONE.is_empty() && Supports::NONE == Supports::default());
    /// ```
    pub const NONE: Self = Self { count: 0, numbers: [0; Self::TOGETHER] };

    /// One support alone.
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::Supports;
    /// assert_eq!(Supports::one(5).iter().collect::<Vec<_>>(), [5]);
    /// ```
    #[must_use]
    pub fn one(support: usize) -> Self {
        Self::NONE.with(support)
    }

    /// These and one more. A number that no support has, and one for which there is no room, makes the set overfull.
    ///
    /// # Example
    /// A support that is in the set already changes nothing.
    /// ```
    /// use carom_motion::spatial::Supports;
    /// let pair = Supports::one(2).with(0);
    /// assert_eq!((pair.len(), pair.with(2)), (2, pair));
    /// ```
    #[must_use]
    pub fn with(mut self, support: usize) -> Self {
        self.insert(support);
        self
    }

    fn insert(&mut self, support: usize) {
        let count = self.len();
        let number = u16::try_from(support);
        let place = number.map_or(Ok(count), |number| self.numbers[..count].binary_search(&number));
        match (place, number) {
            (Err(place), Ok(number)) if count < Self::TOGETHER => {
                self.numbers.copy_within(place..count, place + 1);
                self.numbers[place] = number;
                self.count += 1;
            }
            (Ok(_), Ok(_)) => {}
            _ => self.count = OVERFULL,
        }
    }

    /// True where some had no room: more than [`Supports::TOGETHER`] were put in.
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::Supports;
    /// let all: Supports = (0..100).collect();
    /// assert!(all.is_overfull() && all.union(Supports::one(7)).is_overfull());
    /// ```
    pub const fn is_overfull(&self) -> bool {
        self.count == OVERFULL
    }

    /// These and those.
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::Supports;
    /// let (left, right) = (Supports::one(0).with(1), Supports::one(1).with(2));
    /// assert_eq!(left.union(right).iter().collect::<Vec<_>>(), [0, 1, 2]);
    /// ```
    #[must_use]
    pub fn union(mut self, others: Self) -> Self {
        others.iter().for_each(|support| self.insert(support));
        if others.is_overfull() {
            self.count = OVERFULL;
        }
        self
    }

    /// These but for those.
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::Supports;
    /// let (left, right) = (Supports::one(0).with(1), Supports::one(1).with(2));
    /// assert_eq!((left.difference(right), right.difference(left)), (Supports::one(0), Supports::one(2)));
    /// ```
    #[must_use]
    pub fn difference(self, others: Self) -> Self {
        self.those(|support| !others.contains(support))
    }

    /// Those that are among these and those.
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::Supports;
    /// let (left, right) = (Supports::one(0).with(1), Supports::one(1).with(2));
    /// assert_eq!(left.common(right), Supports::one(1));
    /// ```
    #[must_use]
    pub fn common(self, others: Self) -> Self {
        self.those(|support| others.contains(support))
    }

    /// Those of which this is true.
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::Supports;
    /// let all: Supports = (0..6).collect();
    /// assert_eq!(all.those(|support| support > 3), Supports::one(4).with(5));
    /// ```
    #[must_use]
    pub fn those(&self, are: impl Fn(usize) -> bool) -> Self {
        let mut some = Self::NONE;
        for support in self.numbers[..self.len()].iter().filter(|support| are(usize::from(**support))) {
            some.numbers[usize::from(some.count)] = *support;
            some.count += 1;
        }
        if self.is_overfull() {
            some.count = OVERFULL;
        }
        some
    }

    /// True where the support is one of them.
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::Supports;
    /// let pair = Supports::one(0).with(3);
    /// assert!(pair.contains(3) && !pair.contains(2));
    /// ```
    pub fn contains(&self, support: usize) -> bool {
        u16::try_from(support).is_ok_and(|number| self.numbers[..self.len()].binary_search(&number).is_ok())
    }

    /// How many they are.
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::Supports;
    /// assert_eq!(Supports::one(0).with(3).with(127).len(), 3);
    /// ```
    pub fn len(&self) -> usize {
        usize::from(self.count).min(Self::TOGETHER)
    }

    /// True where there is none.
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::Supports;
    /// assert!(Supports::one(4).difference(Supports::one(4)).is_empty());
    /// ```
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// Their numbers, the smallest first.
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::Supports;
    /// let set: Supports = [7, 0, 3].into_iter().collect();
    /// assert_eq!(set.iter().collect::<Vec<_>>(), [0, 3, 7]);
    /// ```
    pub fn iter(self) -> impl Iterator<Item = usize> {
        self.numbers.into_iter().take(self.len()).map(usize::from)
    }
}

/// The count of a set in which some had no room.
const OVERFULL: u16 = 96;

impl Default for Supports {
    fn default() -> Self {
        Self::NONE
    }
}

impl PartialEq for Supports {
    fn eq(&self, other: &Self) -> bool {
        self.count == other.count && self.numbers[..self.len()] == other.numbers[..other.len()]
    }
}

impl Eq for Supports {}

impl std::hash::Hash for Supports {
    fn hash<H: std::hash::Hasher>(&self, state: &mut H) {
        self.numbers[..self.len()].hash(state);
    }
}

impl fmt::Debug for Supports {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_set().entries(self.iter()).finish()
    }
}

impl FromIterator<usize> for Supports {
    fn from_iter<I: IntoIterator<Item = usize>>(supports: I) -> Self {
        let mut all = Self::NONE;
        supports.into_iter().for_each(|support| all.insert(support));
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_set_holds_what_was_put_in() {
        let set: Supports = [3, 0, 127, 60_000].into_iter().collect();
        assert_eq!(set.iter().collect::<Vec<_>>(), [0, 3, 127, 60_000]);
        assert_eq!((set.len(), set.contains(3), set.contains(4)), (4, true, false));
        assert_eq!(set.difference(Supports::one(3)), Supports::NONE.with(127).with(0).with(60_000));
    }

    #[test]
    fn a_set_says_that_it_is_overfull() {
        let full: Supports = (0..Supports::TOGETHER).collect();
        assert!(!full.is_overfull() && full.with(900).is_overfull() && Supports::one(70_000).is_overfull());
        assert_eq!(full.with(900).len(), Supports::TOGETHER);
        assert!(full.with(900).difference(Supports::one(0)).is_overfull());
    }
}
