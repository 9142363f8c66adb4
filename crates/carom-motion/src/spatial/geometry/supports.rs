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
#[derive(Clone, Copy, Default, PartialEq, Eq, Hash)]
pub struct Supports([u64; WORDS]);

/// Words of a set.
const WORDS: usize = 16;
/// Supports in a word.
const IN_WORD: usize = u64::BITS as usize;

impl Supports {
    /// How many supports a body may have.
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::Supports;
    /// let all: Supports = (0..Supports::MOST).collect();
    /// assert_eq!(all.len(), 1024);
    /// ```
    pub const MOST: usize = WORDS * IN_WORD;
    /// None of them.
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::Supports;
    /// assert!(Supports::NONE.is_empty() && Supports::NONE == Supports::default());
    /// ```
    pub const NONE: Self = Self([0; WORDS]);

    /// One support alone.
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::Supports;
    /// assert_eq!(Supports::one(5).iter().collect::<Vec<_>>(), [5]);
    /// ```
    #[must_use]
    pub const fn one(support: usize) -> Self {
        Self::NONE.with(support)
    }

    /// These and one more.
    ///
    /// # Example
    /// A support that is in the set already changes nothing.
    /// ```
    /// use carom_motion::spatial::Supports;
    /// let pair = Supports::one(2).with(0);
    /// assert_eq!((pair.len(), pair.with(2)), (2, pair));
    /// ```
    #[must_use]
    pub const fn with(mut self, support: usize) -> Self {
        self.0[support / IN_WORD] |= 1 << (support % IN_WORD);
        self
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
    pub fn union(self, others: Self) -> Self {
        Self(std::array::from_fn(|word| self.0[word] | others.0[word]))
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
        Self(std::array::from_fn(|word| self.0[word] & !others.0[word]))
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
        Self(std::array::from_fn(|word| self.0[word] & others.0[word]))
    }

    /// True where the support is one of them.
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::Supports;
    /// let pair = Supports::one(0).with(3);
    /// assert!(pair.contains(3) && !pair.contains(2));
    /// ```
    pub const fn contains(self, support: usize) -> bool {
        self.0[support / IN_WORD] >> (support % IN_WORD) & 1 == 1
    }

    /// How many they are.
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::Supports;
    /// assert_eq!(Supports::one(0).with(3).with(127).len(), 3);
    /// ```
    pub fn len(self) -> usize {
        self.0.iter().map(|word| word.count_ones() as usize).sum()
    }

    /// True where there is none.
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::Supports;
    /// assert!(Supports::one(4).difference(Supports::one(4)).is_empty());
    /// ```
    pub fn is_empty(self) -> bool {
        self == Self::NONE
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
        let of = |(word, mut left): (usize, u64)| {
            std::iter::from_fn(move || {
                let next = (left != 0).then(|| left.trailing_zeros() as usize);
                left &= left.wrapping_sub(1);
                next.map(|bit| word * IN_WORD + bit)
            })
        };
        self.0.into_iter().enumerate().flat_map(of)
    }
}

impl fmt::Debug for Supports {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_set().entries(self.iter()).finish()
    }
}

impl FromIterator<usize> for Supports {
    fn from_iter<I: IntoIterator<Item = usize>>(supports: I) -> Self {
        supports.into_iter().fold(Self::NONE, Self::with)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_set_holds_what_was_put_in() {
        let set: Supports = [3, 0, 127, 900].into_iter().collect();
        assert_eq!(set.iter().collect::<Vec<_>>(), [0, 3, 127, 900]);
        assert_eq!((set.len(), set.contains(3), set.contains(4)), (4, true, false));
        assert_eq!(set.difference(Supports::one(3)), Supports::NONE.with(127).with(0).with(900));
    }
}
