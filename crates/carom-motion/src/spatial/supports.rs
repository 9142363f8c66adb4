//! Some of a body's supports.

/// A set of support points, by their numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Supports(u128);

impl Supports {
    /// How many supports a body may have.
    pub const MOST: usize = 128;
    /// None of them.
    pub const NONE: Self = Self(0);

    /// One support alone.
    #[must_use]
    pub const fn one(support: usize) -> Self {
        Self(1 << support)
    }

    /// These and one more.
    #[must_use]
    pub const fn with(self, support: usize) -> Self {
        Self(self.0 | 1 << support)
    }

    /// These and those.
    #[must_use]
    pub const fn and(self, others: Self) -> Self {
        Self(self.0 | others.0)
    }

    /// These but for those.
    #[must_use]
    pub const fn but(self, others: Self) -> Self {
        Self(self.0 & !others.0)
    }

    /// True where the support is one of them.
    pub const fn contains(self, support: usize) -> bool {
        self.0 >> support & 1 == 1
    }

    /// How many they are.
    pub const fn len(self) -> usize {
        self.0.count_ones() as usize
    }

    /// True where there is none.
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// Their numbers, the smallest first.
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
        assert_eq!(set.but(Supports::one(3)), Supports::NONE.with(127).with(0));
    }
}
