//! Some of a body's supports.

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
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Supports(u128);

impl Supports {
    /// How many supports a body may have.
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::Supports;
    /// let all: Supports = (0..Supports::MOST).collect();
    /// assert_eq!(all.len(), 128);
    /// ```
    pub const MOST: usize = 128;
    /// None of them.
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::Supports;
    /// assert!(Supports::NONE.is_empty() && Supports::NONE == Supports::default());
    /// ```
    pub const NONE: Self = Self(0);

    /// One support alone.
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::Supports;
    /// assert_eq!(Supports::one(5).iter().collect::<Vec<_>>(), [5]);
    /// ```
    #[must_use]
    pub const fn one(support: usize) -> Self {
        Self(1 << support)
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
    pub const fn with(self, support: usize) -> Self {
        Self(self.0 | 1 << support)
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
    pub const fn union(self, others: Self) -> Self {
        Self(self.0 | others.0)
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
    pub const fn difference(self, others: Self) -> Self {
        Self(self.0 & !others.0)
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
    pub const fn common(self, others: Self) -> Self {
        Self(self.0 & others.0)
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
        self.0 >> support & 1 == 1
    }

    /// How many they are.
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::Supports;
    /// assert_eq!(Supports::one(0).with(3).with(127).len(), 3);
    /// ```
    pub const fn len(self) -> usize {
        self.0.count_ones() as usize
    }

    /// True where there is none.
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::Supports;
    /// assert!(Supports::one(4).difference(Supports::one(4)).is_empty());
    /// ```
    pub const fn is_empty(self) -> bool {
        self.0 == 0
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
        (0..Self::MOST).filter(move |i| self.contains(*i))
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
        let set: Supports = [3, 0, 127].into_iter().collect();
        assert_eq!(set.iter().collect::<Vec<_>>(), [0, 3, 127]);
        assert_eq!((set.len(), set.contains(3), set.contains(4)), (3, true, false));
        assert_eq!(set.difference(Supports::one(3)), Supports::NONE.with(127).with(0));
    }
}
