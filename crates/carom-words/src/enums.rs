//! The enums whose values have one word each.

use carom_feeder::{Outcome, StageName, Stop};
use carom_impact::{planar, spatial};
use carom_motion::planar::RestKind;
use carom_motion::spatial::Choice;
use carom_study::design::{Aim, Demand};
use carom_study::feeds;

/// An enum whose every value has one word, as files and tables have it: words of one enum differ.
///
/// # Example
/// ```
/// use carom_feeder::Outcome;
/// use carom_words::Words;
/// assert_eq!(Outcome::OnEnd.word(), "on_end");
/// assert_eq!(Outcome::of_word("on_end"), Some(Outcome::OnEnd));
/// ```
pub trait Words: Copy + 'static {
    /// All values, in their order.
    const ALL: &'static [Self];

    /// The word of this one.
    fn word(self) -> &'static str;

    /// The value whose word this is; `None` where there is none.
    fn of_word(word: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|value| value.word() == word)
    }

    /// All words, in the order of their values.
    fn words() -> Vec<&'static str> {
        Self::ALL.iter().map(|value| value.word()).collect()
    }
}

/// Gives each value of an enum its word; the compiler refuses a value that is left out.
///
/// # Example
/// ```
/// use carom_words::Words;
/// #[derive(Clone, Copy)]
/// enum Side { Left, Right }
/// carom_words::words! { Side { Left = "left", Right = "right", } }
/// assert_eq!(Side::words(), ["left", "right"]);
/// ```
#[macro_export]
macro_rules! words {
    ($($enum:ty { $($value:ident = $word:literal,)+ })+) => {
        $(impl $crate::Words for $enum {
            const ALL: &'static [Self] = &[$(Self::$value),+];

            fn word(self) -> &'static str {
                match self {
                    $(Self::$value => $word,)+
                }
            }
        })+
    };
}

words! {
    Outcome {
        Landed = "landed",
        Delivered = "delivered",
        Stuck = "stuck",
        OnEnd = "on_end",
        Jammed = "jammed",
        Missed = "missed",
        Escaped = "escaped",
        NeverFlat = "never_flat",
        Unresolved = "unresolved",
        Blocked = "blocked",
    }
    StageName {
        Slide = "slide",
        Tip = "tip",
        Flight = "flight",
        Swing = "swing",
        Stick = "stick",
        Roll = "roll",
        Wedge = "wedge",
        Push = "push",
        Rest = "rest",
        Clatter = "clatter",
    }
    RestKind {
        Face = "side",
        Across = "across a hollow",
        Arc = "arc",
    }
    Stop {
        Landed = "landed",
        Delivered = "delivered",
    }
    Aim {
        Yield = "yield",
        Height = "height",
        Time = "time",
    }
    Demand {
        Drawable = "it can be drawn",
        Clear = "no two plates cross",
        Wanted = "it ends as wanted",
        ImpactSpeed = "impact speed",
        SlidingSpeed = "sliding speed",
        Height = "height",
        Width = "width",
        Time = "time",
        Walls = "it touches no wall",
        ComesOut = "it does not jam afterwards",
    }
    Choice {
        KeepMost = "keep most",
        KeepFewest = "keep fewest",
        End = "end",
    }
    feeds::Kind {
        Free = "no_touch",
        Harmless = "as_wanted",
        Harmful = "otherwise",
        Touching = "touch",
        Blocked = "blocked",
        Unresolved = "unresolved",
    }
    carom_impact::Law {
        Poisson = "poisson",
        Stronge = "stronge",
        Newton = "newton",
    }
    carom_impact::Phase {
        Compression = "compression",
        Restitution = "restitution",
    }
    planar::Slip {
        Open = "open",
        Sticks = "sticks",
        Forward = "slips+",
        Backward = "slips-",
    }
    planar::ContactState {
        Separates = "separates",
        Sticks = "sticks",
        Slips = "slips",
    }
    planar::ImpactType {
        SlidesThroughout = "slides throughout",
        SlipsFromRest = "slips from rest",
        SticksFromRest = "sticks from rest",
        ReversesInRestitution = "slip reverses in restitution",
        ReversesInCompression = "slip reverses in compression",
        StopsInRestitution = "slip stops in restitution",
        StopsInCompression = "slip stops in compression",
    }
    planar::Class {
        Sliding = "sliding",
        SlidingFromRest = "sliding from rest",
        Sticking = "sticking",
        RReversed = "R-reversed",
        CReversed = "C-reversed",
        RSticking = "R-sticking",
        CSticking = "C-sticking",
    }
    spatial::Mode {
        Open = "open",
        Slips = "slips",
        Sticks = "sticks",
        Starts = "starts to slip",
    }
    spatial::Freedom {
        None = "nothing",
        Rates = "the rates",
        Motion = "the motion",
    }
    spatial::Conclusion {
        Unique = "unique",
        Several = "several",
        None = "none",
        Forced = "forced",
    }
}
