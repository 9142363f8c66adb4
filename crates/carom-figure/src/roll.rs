//! The report of a body that rolls, rocks or pivots: what it does at each strike, the animation, and what rejects the other ends.

use crate::impact_page::{contacts_table, hypotheses};
use crate::markup::{Markup, html, table};
use crate::page::{Page, law_and_input};
use crate::report::REPORT_CSS;
use crate::text::{fixed, significant};
use crate::{FIGURE_CSS, player, roll_scene};
use carom_motion::planar::{State, World, trace::Trace};
use carom_num::Vec2;

/// Strikes shown with their contacts and hypotheses.
const MOST_IN_FULL: usize = 12;
/// Strikes in the table.
const MOST_ROWS: usize = 200;

/// One contact at the end of a strike.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RollContact {
    /// Its name.
    pub name: String,
    /// separates, sticks or slips.
    pub state: String,
    /// Impulse on the body, normal and tangential [N s].
    pub impulse: [f64; 2],
    /// Velocity after, normal and tangential [m/s].
    pub velocity: [f64; 2],
}

/// One strike in words and numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RollStrike {
    /// When [s].
    pub time: f64,
    /// What happens: "1: separates at A, sticks at K".
    pub state: String,
    /// The literature's words for it.
    pub words: Option<String>,
    /// Roll rate before and after, > 0 forward [rad/s].
    pub roll_rate: [f64; 2],
    /// Velocity of the mass centre before and after [m/s].
    pub velocity: [[f64; 2]; 2],
    /// Angle of the body, counter-clockwise [rad].
    pub tilt: f64,
    /// Kinetic energy before and after [J].
    pub energy: [f64; 2],
    /// Its contacts.
    pub contacts: Vec<RollContact>,
    /// The end states that the laws allow.
    pub found: Vec<String>,
    /// The other hypotheses, each with what rejects it.
    pub rejected: Vec<[String; 2]>,
}

/// What the report of a roll shows.
#[derive(Clone, Copy, Debug)]
pub struct RollFigure<'a> {
    /// Heading of the page.
    pub title: &'a str,
    /// The end in a word or two.
    pub verdict: &'a str,
    /// The sentence below it.
    pub lead: &'a str,
    /// Sentences on the law and the model.
    pub notes: &'a [String],
    /// The body among its obstacles.
    pub world: &'a World,
    /// Names of the obstacles.
    pub obstacles: &'a [String],
    /// Segments that are drawn and never reached.
    pub unreached: &'a [[Vec2; 2]],
    /// Where it starts.
    pub start: State,
    /// Its motion.
    pub trace: &'a Trace,
    /// Its strikes, in the order of the trace's impacts.
    pub strikes: &'a [RollStrike],
    /// The file as written; empty where there is none.
    pub source: &'a str,
    /// What made the report, with its version.
    pub made_by: &'a str,
}

/// One self-contained HTML page on a roll: the end, the table of strikes, the animation, every strike with its contacts and hypotheses.
///
/// It needs no network and prints. Every name is escaped; a number that is not finite shows as a dash.
///
/// # Example
/// ```
/// # use carom_figure::RollFigure;
/// # use carom_impact::Law;
/// # use carom_num::Vec2;
/// # use carom_motion::planar::{Body, Obstacle, Pose, Shape, State, Twist, World, trace::Trace};
/// # let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Vec2::new(x, y));
/// # let body = Body { shape: Shape::new(corners.to_vec(), 0.0).unwrap(), mass: 1.0, inertia: 2.0 / 3.0 };
/// # let plane = Obstacle::new(Vec2::new(-9.0, 0.0), Vec2::new(9.0, 0.0), 0.9, 0.0);
/// # let world = World::of_one(Vec2::new(0.0, -10.0), body, vec![plane], Law::Poisson);
/// # let pose = Pose { centre: Vec2::new(0.0, 1.0), angle: 0.0 };
/// # let (start, trace) = (State { pose, twist: Twist::default() }, Trace::default());
/// # let figure = RollFigure {
/// #     title: "a prism", verdict: "at rest", lead: "", notes: &[], world: &world, obstacles: &[],
/// #     unreached: &[], start, trace: &trace, strikes: &[], source: "", made_by: "",
/// # };
/// use carom_figure::{RollStrike, roll_report};
/// assert!(roll_report(&figure).contains("Nothing was struck."));
/// let found = vec!["K sticks".to_owned(), "K slips".to_owned()];
/// let strikes = [RollStrike { found, ..RollStrike::default() }];
/// let page = roll_report(&RollFigure { strikes: &strikes, ..figure });
/// assert!(page.contains("2 end states are consistent, 0 hypotheses are rejected"));
/// ```
pub fn roll_report(figure: &RollFigure<'_>) -> String {
    let body = html! {
        section id="verdict" class="verdict" {
            p.headline { strong { (figure.verdict) } }
            p.lead { (figure.lead) }
        }
        (roll_scene::section(figure))
        (strikes_table(figure.strikes))
        (in_full(figure.strikes))
        (law_and_input(figure.notes, figure.source))
    };
    Page {
        title: figure.title,
        heading: figure.title,
        styles: &[FIGURE_CSS, REPORT_CSS],
        body,
        script: roll_scene::moves(figure).then_some(player::SCRIPT),
        made_by: figure.made_by,
    }
    .html()
}

pub(crate) fn strikes_table(strikes: &[RollStrike]) -> Markup {
    if strikes.is_empty() {
        return html! { section id="strikes" { h2 { "Strikes" } p.note { "Nothing was struck." } } };
    }
    let pair = |values: [f64; 2]| values.map(|value| significant(value, 4)).join(" → ");
    let speed = |[x, y]: [f64; 2]| (x * x + y * y).sqrt();
    let row = |(i, s): (usize, &RollStrike)| {
        html! {
            tr.stage data-stage="-2" data-t=(s.time) {
                td { (i + 1) }
                td.words { (s.state) }
                td { (fixed(s.time, 4)) }
                td { (pair(s.roll_rate)) }
                td { (pair(s.velocity.map(speed))) }
                td { (fixed(s.tilt.to_degrees(), 2)) }
                td { (pair(s.energy)) }
                td { (s.found.len()) }
            }
        }
    };
    let heads =
        ["#", "state", "at [s]", "roll rate [1/s]", "speed [m/s]", "tilt [°]", "energy [J]", "end states"];
    html! {
        section id="strikes" {
            h2 { "Strikes" }
            (table("stages", &heads, strikes.iter().enumerate().take(MOST_ROWS).map(row)))
            @if strikes.len() > MOST_ROWS { p.note { "and " (strikes.len() - MOST_ROWS) " after them." } }
            p.note { "Roll rates are positive forward (clockwise). A row moves the animation to its strike." }
        }
    }
}

pub(crate) fn in_full(strikes: &[RollStrike]) -> Markup {
    html! {
        @if !strikes.is_empty() {
            section id="hypotheses" {
                h2 { "Each strike" }
                @for (i, strike) in strikes.iter().enumerate().take(MOST_IN_FULL) { (one(i, strike)) }
            }
        }
    }
}

fn one(i: usize, strike: &RollStrike) -> Markup {
    html! {
        article.strike {
            h3 { i.key.strike {} "Strike " (i + 1) " " small { (fixed(strike.time, 4)) " s" } }
            p.kind { (strike.state) }
            @if let Some(words) = &strike.words { p.note { "In the literature: " (words) "." } }
            (contacts_table(&strike.contacts))
            (hypotheses(&strike.found, None, (&strike.rejected, 0)))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom_impact::Law;
    use carom_motion::planar::{Body, Happening, Obstacle, Options, Pose, Recorder, Shape, Twist, Walker};

    /// A square prism turns about its left edge with 1 rad/s; its face is this far from flat.
    fn page(tilt: f64, names: &[String]) -> String {
        let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Vec2::new(x, y));
        let body = Body { shape: Shape::new(corners.to_vec(), 0.0).unwrap(), mass: 1.0, inertia: 0.6 };
        let plane = Obstacle::new(Vec2::new(-9.0, 0.0), Vec2::new(9.0, 0.0), 0.9, 0.0);
        let world = World::of_one(Vec2::new(0.0, -9.81), body, vec![plane], Law::Poisson);
        let turn = Vec2::at_angle(tilt);
        let centre = Vec2::new(1.0, 1.0).rotated(turn.x, turn.y);
        let spin = if tilt > 0.0 { -1.0 } else { 0.0 };
        let twist = Twist { velocity: centre.turned_left() * spin, spin };
        let start = State { pose: Pose { centre, angle: tilt }, twist };
        let mut walker = Walker::new(&world, start, vec![true], Options::default()).unwrap();
        let mut recorder = Recorder::default();
        while walker.advance(&mut recorder).unwrap() == Happening::Moves {}
        let contacts = vec![RollContact { name: "<A>".to_owned(), ..RollContact::default() }];
        let strikes = vec![RollStrike { contacts, ..RollStrike::default() }];
        roll_report(&RollFigure {
            title: "a <prism>",
            verdict: "at rest",
            lead: "",
            notes: &[],
            world: &world,
            obstacles: names,
            unreached: &[],
            start,
            trace: recorder.trace(),
            strikes: if tilt > 0.0 { &strikes } else { &[] },
            source: "",
            made_by: "test",
        })
    }

    #[test]
    fn a_body_that_moves_is_played_and_one_at_rest_is_drawn() {
        let names = vec!["<plane>".to_owned()];
        let (moves, rests) = (page(0.2, &names), page(0.0, &names));
        for part in ["id=\"player\"", "id=\"motion-numbers\"", "id=\"part\"", "id=\"scrub\""] {
            assert!(moves.contains(part), "{part} in the one that moves");
        }
        assert!(rests.contains("id=\"part\"") && !rests.contains("id=\"player\""), "a picture only");
    }

    #[test]
    fn names_are_escaped_and_numbers_are_numbers() {
        let page = page(0.2, &["</script><plane>".to_owned()]);
        assert!(page.contains("a &lt;prism&gt;") && page.contains("&lt;A&gt;"), "escaped");
        assert_eq!(page.matches("</script>").count(), 2, "the numbers and the player");
        assert!(!page.contains("NaN") && !page.contains("inf"), "no number that is none");
    }
}
