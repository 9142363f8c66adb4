//! Words that a key may hold, with what each stands for.

use crate::drawing::{ShapeWord, Side, Want};
use carom_feeder::Stop;
use carom_impact::planar::Law;
use carom_motion::spatial::Choice;
use carom_study::design::Aim;

/// A type whose values are words in files.
pub(crate) trait Word: Copy + 'static {
    const WORDS: &'static [(&'static str, Self)];
}

/// Every word of a type, in order.
pub(crate) fn words<T: Word>() -> Vec<&'static str> {
    T::WORDS.iter().map(|(word, _)| *word).collect()
}

impl Word for Side {
    const WORDS: &'static [(&'static str, Self)] = &[("left", Self::Left), ("right", Self::Right)];
}

impl Word for Stop {
    const WORDS: &'static [(&'static str, Self)] =
        &[("landed", Self::Landed), ("delivered", Self::Delivered)];
}

impl Word for Law {
    const WORDS: &'static [(&'static str, Self)] =
        &[("poisson", Self::Poisson), ("stronge", Self::Stronge), ("newton", Self::Newton)];
}

impl Word for ShapeWord {
    const WORDS: &'static [(&'static str, Self)] = &[
        ("rod", Self::Rod),
        ("box", Self::Box),
        ("polygon", Self::Polygon),
        ("disc", Self::Disc),
        ("outline", Self::Outline),
    ];
}

impl Word for Aim {
    const WORDS: &'static [(&'static str, Self)] =
        &[("yield", Self::Yield), ("height", Self::Height), ("time", Self::Time)];
}

impl Word for Want {
    const WORDS: &'static [(&'static str, Self)] =
        &[("same", Self::Same), ("turned", Self::Turned), ("any", Self::Any)];
}

impl Word for Choice {
    const WORDS: &'static [(&'static str, Self)] =
        &[("keep most", Self::KeepMost), ("keep fewest", Self::KeepFewest), ("end", Self::End)];
}
