//! The grammar of what a scene says besides one part and its plates: several parts, and what a design may choose.

use super::kind::{LENGTH, MAX_SPEED, PARTS, TIME};
use super::scene::{OWN_SURFACE, SURFACE};
use super::{Holds, Table, key};
use carom_study::design::Aim;
use carom_words::Words;

pub(super) static FEED: Table = Table {
    rules: &[OWN_SURFACE],
    ..Table::plain(
        "Feed",
        "Several parts, one after another; friction and restitution are those between two parts.",
        &[
            &[
                key("parts", Holds::Quantity(PARTS), "How many parts there are.").needed(),
                key("interval", Holds::Quantity(TIME), "Time from one part's start to the next.").needed(),
            ],
            SURFACE,
        ],
    )
};

pub(super) static DESIGN: Table = Table::plain(
    "Design",
    "What a design may choose, must keep and aims at.",
    &[&[
        key("free", Holds::Ranges, "Paths with their ranges: \"plate.lower.slope\" = \"10..40 deg\"."),
        key("max_impact_speed", Holds::Quantity(MAX_SPEED), "Highest approach speed of an impact."),
        key("max_sliding_speed", Holds::Quantity(MAX_SPEED), "Highest speed of sliding."),
        key("max_height", Holds::Quantity(LENGTH), "Greatest height of the feeder."),
        key("max_width", Holds::Quantity(LENGTH), "Greatest width of the feeder."),
        key("max_time", Holds::Quantity(TIME), "Longest time of a drop."),
        key("forbid_walls", Holds::Flag, "True where the part may touch no wall on its way."),
        key("aim", Holds::Words(Aim::words), "What the design is to be best at.").or_word("yield"),
    ]],
);
