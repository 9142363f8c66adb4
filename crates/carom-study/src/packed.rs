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

    /// The value as numbers, with a seal behind it.
    fn sealed(&self) -> Vec<u64> {
        let mut words = vec![];
        self.pack(&mut words);
        words.push(seal(&words));
        words
    }

    /// Reads what [`Packed::sealed`] gave; `None` where a number of it was changed, or is not there.
    fn unsealed(words: &[u64]) -> Option<Self> {
        let (last, words) = words.split_last()?;
        let mut rest = words.iter();
        let value = Self::unpack(&mut rest).filter(|_| rest.as_slice().is_empty())?;
        (*last == seal(words)).then_some(value)
    }
}

/// After Fowler, Noll and Vo's FNV-1a, over whole numbers. It tells what was damaged, not what was forged.
fn seal(words: &[u64]) -> u64 {
    let mix = |hash: u64, word: &u64| (hash ^ word).wrapping_mul(0x100_0000_01b3).rotate_left(29);
    words.iter().fold(0xcbf2_9ce4_8422_2325, mix)
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
        let words = value.sealed();
        type Value = (BTreeMap<Ending, [u64; 2]>, Vec<Option<f64>>, (usize, u32, u64));
        assert_eq!(Value::unsealed(&words).as_ref(), Some(&value), "every ending is numbered");
        for length in 0..words.len() {
            assert_eq!(Value::unsealed(&words[..length]), None, "cut after {length} numbers");
            let mut wrong = words.clone();
            wrong[length] ^= 1 << (length % 64);
            assert_eq!(Value::unsealed(&wrong), None, "number {length} was changed");
        }
    }

    #[test]
    fn numbers_that_are_no_value_take_no_memory() {
        let read = |words: &[u64]| Vec::<u64>::unpack(&mut words.iter());
        assert_eq!(read(&[u64::MAX, 1, 2]), None, "numbers end first");
        assert_eq!(Option::<u64>::unpack(&mut [2, 2].iter()), None, "neither there nor not");
        assert_eq!(Ending::unpack(&mut [u64::MAX].iter()), None, "no ending");
    }
}
