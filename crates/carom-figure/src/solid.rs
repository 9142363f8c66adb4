//! The report of a body in space: what it does at each strike, the tilt against time, an animation that can be turned, and what refuses the other states.

#[cfg(test)]
mod tests;

use crate::markup::html;
use crate::page::{Page, law_and_input};
use crate::report::REPORT_CSS;
use crate::text::capitalised;
use crate::{FIGURE_CSS, solid_scene, solid_tables, tilt_chart};
use carom_num::{Rotation, Vec3};

pub(crate) const SOLID_CSS: &str = include_str!("solid.css");

/// The body, in its own axes from its mass centre.
#[derive(Clone, Copy, Debug)]
pub struct SolidDrawing<'a> {
    /// Corners [m].
    pub corners: &'a [Vec3],
    /// The corners of each plane face, counter-clockwise as seen from outside.
    pub faces: &'a [Vec<usize>],
    /// The numbers of the first of them, where not each has its own: the others are facets of round edges, or in a hollow.
    pub numbers: Option<&'a [usize]>,
    /// Sides of faces that are no edges, by their corners: another face goes on there, on the same plane.
    pub seams: &'a [[usize; 2]],
    /// Lines beside the faces, between corners.
    pub lines: &'a [[usize; 2]],
    /// The points on which it stands [m].
    pub points: &'a [Vec3],
    /// Their names.
    pub names: &'a [String],
}

/// A plate or wall among which the body moves: a convex polygon.
///
/// # Example
/// A strip of 0.2 m that goes on beyond the picture to either side of it.
/// ```
/// use carom_figure::SolidPlate;
/// use carom_num::Vec3;
/// let at = |x: f64, y: f64| Vec3::new(x, y, 0.0);
/// let corners = vec![at(0.0, -1.0), at(0.2, -1.0), at(0.2, 1.0), at(0.0, 1.0)];
/// let strip = SolidPlate { name: "track".to_owned(), corners, cut: vec![true, false, true, false] };
/// assert!(strip.corners.len() == strip.cut.len());
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SolidPlate {
    /// Its name; empty where it is a piece of the plate before it.
    pub name: String,
    /// Its corners in their order, world axes [m].
    pub corners: Vec<Vec3>,
    /// For each side, from its corner to the next: it is cut there, and goes on beyond the picture.
    pub cut: Vec<bool>,
}

/// The body at one instant.
#[derive(Clone, Debug, PartialEq)]
pub struct SolidInstant {
    /// [s].
    pub time: f64,
    /// Mass centre, world axes: z is up; without plates it is the plane's normal, and the plane is z = 0 [m].
    pub centre: Vec3,
    /// The rotation of the body's axes into the world's.
    pub attitude: Rotation,
    /// Angle from flat [rad].
    pub tilt: f64,
    /// The points that are held on the plane.
    pub held: Vec<usize>,
    /// Where else it touches, in its own axes [m]: an edge on an edge, a face on a corner.
    pub places: Vec<Vec3>,
}

/// What it does between two events.
#[derive(Clone, Debug, PartialEq)]
pub struct SolidStage {
    /// flight, pivot, edge or rest.
    pub name: &'static str,
    /// On which points.
    pub on: String,
    /// Start [s].
    pub start: f64,
    /// End [s].
    pub end: f64,
}

/// Infinitely many strikes, closed at their limit.
#[derive(Clone, Debug, PartialEq)]
pub struct SolidSeries {
    /// The last strike that was resolved [s].
    pub from: f64,
    /// The limit [s].
    pub to: f64,
    /// Strikes of a period.
    pub period: usize,
    /// Ratio of successive periods.
    pub ratio: f64,
    /// The points that stay.
    pub kept: String,
}

/// One contact at a strike.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SolidContact {
    /// Its name.
    pub name: String,
    /// It comes down in this strike.
    pub strikes: bool,
    /// keeps, slides or opens.
    pub state: String,
    /// Normal impulse and size of the tangential one [N s].
    pub impulse: [f64; 2],
    /// Velocity after, world axes [m/s].
    pub velocity: [f64; 3],
}

/// A state that the law allows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SolidState {
    /// "O and K keep, A opens".
    pub hypothesis: String,
    /// The least friction with which nothing slides.
    pub friction: Option<f64>,
    /// Less may do.
    pub friction_is_bound: bool,
    /// It is the one that is followed.
    pub followed: bool,
}

/// A moment of a strike with friction at which several ways on are consistent.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SolidFork {
    /// "stage 2, compression".
    pub when: String,
    /// The way that is followed, where it is one of them.
    pub followed: Option<String>,
    /// The others.
    pub others: Vec<String>,
}

/// One strike in words and numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SolidStrike {
    /// When [s].
    pub time: f64,
    /// What happens.
    pub state: String,
    /// How many ways the law leaves: unique, several, none or forced.
    pub outcome: String,
    /// What comes down.
    pub struck: String,
    /// Where else than at its points it is struck, world axes [m].
    pub places: Vec<Vec3>,
    /// Angle from flat [rad].
    pub tilt: f64,
    /// Spin before and after, body axes; not finite where there is no way on [rad/s].
    pub spin: [[f64; 3]; 2],
    /// Kinetic energy before and after; not finite where there is no way on [J].
    pub energy: [f64; 2],
    /// The least friction with which nothing slides.
    pub friction: Option<f64>,
    /// Less may do.
    pub friction_is_bound: bool,
    /// Its contacts.
    pub contacts: Vec<SolidContact>,
    /// The states that the law allows.
    pub found: Vec<SolidState>,
    /// The other states, each with what refuses it.
    pub rejected: Vec<[String; 2]>,
    /// Refused states that are not listed.
    pub left_out: usize,
    /// How contacts share what they carry is open, and the motion depends on it.
    pub shared: bool,
    /// Moments with several ways on: when, what is followed, and the other ways.
    pub forks: Vec<SolidFork>,
    /// A closed form: its case, what the literature says, how it agrees.
    pub closed_form: Option<[String; 3]>,
}

/// What the report of a body in space shows.
#[derive(Clone, Copy, Debug)]
pub struct SolidFigure<'a> {
    /// Heading of the page.
    pub title: &'a str,
    /// The end in a word or two.
    pub verdict: &'a str,
    /// The sentence below it.
    pub lead: &'a str,
    /// Sentences on the law and the model.
    pub notes: &'a [String],
    /// The body.
    pub drawing: SolidDrawing<'a>,
    /// The plates and walls among which it moves; where there are none it moves on the plane z = 0.
    pub around: &'a [SolidPlate],
    /// Its motion: at least one instant.
    pub instants: &'a [SolidInstant],
    /// What it does between its strikes.
    pub stages: &'a [SolidStage],
    /// Its strikes.
    pub strikes: &'a [SolidStrike],
    /// Series of strikes closed at their limit.
    pub series: &'a [SolidSeries],
    /// The file as written; empty where there is none.
    pub source: &'a str,
    /// What made the report, with its version.
    pub made_by: &'a str,
}

/// One self-contained HTML page on a body in space: the end, the animation, the tilt against time, the strikes and their states.
///
/// It needs no network and prints. Every name is escaped; a number that is not finite shows as a dash.
pub fn solid_report(figure: &SolidFigure<'_>) -> String {
    let body = html! {
        section id="verdict" class="verdict" {
            p.headline { strong { (capitalised(figure.verdict)) } }
            p.lead { (figure.lead) }
        }
        (solid_scene::section(figure))
        (tilt_chart::section(figure))
        (solid_tables::strikes(figure.strikes))
        (solid_tables::series(figure.series))
        (solid_tables::in_full(figure.strikes))
        (law_and_input(figure.notes, figure.source))
    };
    Page {
        title: figure.title,
        heading: figure.title,
        styles: &[FIGURE_CSS, REPORT_CSS, SOLID_CSS],
        body,
        script: Some(solid_scene::SCRIPT),
        made_by: figure.made_by,
    }
    .html()
}
