//! What one machine counts, as whole numbers: they can be sent to the machine that puts all counts together.

use crate::Ending;
use carom_feeder::{Outcome, Verdict};
use std::collections::BTreeMap;
use std::slice::Iter;

/// A value that can be written as whole numbers and read back.
pub(crate) trait Packed: Sized {
    /// Writes it.
    fn pack(&self, words: &mut Vec<u64>);

    /// Reads it; `None` where the numbers are no such value.
    fn unpack(words: &mut Iter<'_, u64>) -> Option<Self>;

    /// Reads one value that takes all of the numbers.
    fn unpack_all(words: &[u64]) -> Option<Self> {
        let mut words = words.iter();
        let value = Self::unpack(&mut words)?;
        words.as_slice().is_empty().then_some(value)
    }
}

impl Packed for u64 {
    fn pack(&self, words: &mut Vec<u64>) {
        words.push(*self);
    }

    fn unpack(words: &mut Iter<'_, u64>) -> Option<Self> {
        words.next().copied()
    }
}

impl Packed for f64 {
    fn pack(&self, words: &mut Vec<u64>) {
        words.push(self.to_bits());
    }

    fn unpack(words: &mut Iter<'_, u64>) -> Option<Self> {
        words.next().copied().map(f64::from_bits)
    }
}

macro_rules! packed_integers {
    ($($integer:ty),*) => {$(
        impl Packed for $integer {
            fn pack(&self, words: &mut Vec<u64>) {
                words.push(*self as u64);
            }

            fn unpack(words: &mut Iter<'_, u64>) -> Option<Self> {
                words.next().and_then(|word| Self::try_from(*word).ok())
            }
        }
    )*};
}
packed_integers!(u32, usize);

impl<T: Packed> Packed for Option<T> {
    fn pack(&self, words: &mut Vec<u64>) {
        words.push(u64::from(self.is_some()));
        self.iter().for_each(|value| value.pack(words));
    }

    fn unpack(words: &mut Iter<'_, u64>) -> Option<Self> {
        match words.next()? {
            0 => Some(None),
            1 => T::unpack(words).map(Some),
            _ => None,
        }
    }
}

impl<T: Packed> Packed for Vec<T> {
    fn pack(&self, words: &mut Vec<u64>) {
        words.push(self.len() as u64);
        self.iter().for_each(|value| value.pack(words));
    }

    fn unpack(words: &mut Iter<'_, u64>) -> Option<Self> {
        // A length that is not true ends with the numbers: nothing is reserved for it.
        let length = *words.next()?;
        (0..length).map(|_| T::unpack(words)).collect()
    }
}

impl<T: Packed, const N: usize> Packed for [T; N] {
    fn pack(&self, words: &mut Vec<u64>) {
        self.iter().for_each(|value| value.pack(words));
    }

    fn unpack(words: &mut Iter<'_, u64>) -> Option<Self> {
        let values: Option<Vec<T>> = (0..N).map(|_| T::unpack(words)).collect();
        values?.try_into().ok()
    }
}

impl<A: Packed, B: Packed> Packed for (A, B) {
    fn pack(&self, words: &mut Vec<u64>) {
        self.0.pack(words);
        self.1.pack(words);
    }

    fn unpack(words: &mut Iter<'_, u64>) -> Option<Self> {
        Some((A::unpack(words)?, B::unpack(words)?))
    }
}

impl<A: Packed, B: Packed, C: Packed> Packed for (A, B, C) {
    fn pack(&self, words: &mut Vec<u64>) {
        self.0.pack(words);
        self.1.pack(words);
        self.2.pack(words);
    }

    fn unpack(words: &mut Iter<'_, u64>) -> Option<Self> {
        Some((A::unpack(words)?, B::unpack(words)?, C::unpack(words)?))
    }
}

impl<K: Packed + Ord, V: Packed> Packed for BTreeMap<K, V> {
    fn pack(&self, words: &mut Vec<u64>) {
        words.push(self.len() as u64);
        for (key, value) in self {
            key.pack(words);
            value.pack(words);
        }
    }

    fn unpack(words: &mut Iter<'_, u64>) -> Option<Self> {
        let length = *words.next()?;
        (0..length).map(|_| <(K, V)>::unpack(words)).collect()
    }
}

/// Endings by number; a face of a part comes after them.
const ENDINGS: [Ending; 15] = [
    Ending::Lies(Verdict::Same),
    Ending::Lies(Verdict::Turned),
    Ending::Stays,
    Ending::Impossible,
    Ending::Failed,
    Ending::Otherwise(Outcome::Landed),
    Ending::Otherwise(Outcome::Delivered),
    Ending::Otherwise(Outcome::Stuck),
    Ending::Otherwise(Outcome::OnEnd),
    Ending::Otherwise(Outcome::Jammed),
    Ending::Otherwise(Outcome::Missed),
    Ending::Otherwise(Outcome::Escaped),
    Ending::Otherwise(Outcome::NeverFlat),
    Ending::Otherwise(Outcome::Unresolved),
    Ending::Otherwise(Outcome::Blocked),
];

impl Packed for Ending {
    fn pack(&self, words: &mut Vec<u64>) {
        let number = match self {
            Self::Lies(Verdict::Face(face)) => ENDINGS.len() + face,
            known => ENDINGS.iter().position(|ending| ending == known).unwrap_or(usize::MAX),
        };
        number.pack(words);
    }

    fn unpack(words: &mut Iter<'_, u64>) -> Option<Self> {
        let number = usize::unpack(words)?;
        let face = || Self::Lies(Verdict::Face(number - ENDINGS.len()));
        (number != usize::MAX).then(|| ENDINGS.get(number).copied().unwrap_or_else(face))
    }
}

/// A structure of values that can be packed, field by field.
macro_rules! packed {
    ($name:ty { $($field:ident),* $(,)? }) => {
        impl $crate::packed::Packed for $name {
            fn pack(&self, words: &mut Vec<u64>) {
                let Self { $($field),* } = self;
                $($crate::packed::Packed::pack($field, words);)*
            }

            fn unpack(words: &mut std::slice::Iter<'_, u64>) -> Option<Self> {
                $(let $field = $crate::packed::Packed::unpack(words)?;)*
                Some(Self { $($field),* })
            }
        }
    };
}
pub(crate) use packed;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_comes_back_as_it_was() {
        let face = Ending::Lies(Verdict::Face(7));
        let endings: BTreeMap<Ending, [u64; 2]> = ENDINGS
            .into_iter()
            .chain([face])
            .enumerate()
            .map(|(k, ending)| (ending, [k as u64, 1]))
            .collect();
        let value = (endings, vec![Some(-0.0), None, Some(f64::MIN_POSITIVE)], (3_usize, 5_u32, u64::MAX));
        let mut words = vec![];
        value.pack(&mut words);
        assert_eq!(Packed::unpack_all(&words).as_ref(), Some(&value), "every ending is numbered");
        for length in 0..words.len() {
            let cut: Option<(BTreeMap<Ending, [u64; 2]>, Vec<Option<f64>>, (usize, u32, u64))> =
                Packed::unpack_all(&words[..length]);
            assert_eq!(cut, None, "cut after {length} numbers");
        }
        words.push(0);
        assert_eq!(<(Vec<u64>, u64)>::unpack_all(&words), None, "more than one value");
    }

    #[test]
    fn a_length_that_is_not_true_takes_no_memory() {
        assert_eq!(Vec::<u64>::unpack_all(&[u64::MAX, 1, 2]), None, "numbers end first");
        assert_eq!(Option::<u64>::unpack_all(&[2, 2]), None, "neither there nor not");
        assert_eq!(Ending::unpack_all(&[u64::MAX]), None, "no ending");
    }
}
