//! The sketch of bodies that are struck: where they are touched, the axes of each contact, and how they move before.

use crate::labels::Labels;
use crate::layout::scale_bar;
use crate::markup::{Markup, html, joined};
use crate::mechanism::{Drawn, obstacle_svg};
use crate::svg::{self, circle, line, text, xy};
use crate::text::{px, significant};
use crate::view::View;
use carom_num::Vec2;

/// The paper, and what of it is around the points of the body [px].
const WIDTH: f64 = 460.0;
const HEIGHT: f64 = 330.0;
const FRAME: f64 = 92.0;
/// Room for what the scale bar of a view stands in [px].
const FOOT: f64 = 46.0;
/// Arrows of axes, the arrow of a velocity, the head of each and half its width [px].
const AXIS: f64 = 44.0;
const VELOCITY: f64 = 66.0;
const HEAD: [f64; 2] = [8.0, 3.4];
/// Half of the line that a contact stands on, and the radius of a spin's arrow [px].
const GROUND: f64 = 34.0;
const SPIN: f64 = 17.0;
/// Where the arrow of a spin begins, and how far it turns [rad].
const TURN: [f64; 2] = [2.4, 4.2];
/// From the base line of a text to its middle [px].
const MIDDLE: f64 = 4.0;
const DIGITS: usize = 3;

/// Bodies that are struck, before the impact.
///
/// # Example
/// A ball that falls on a floor: the sketch names the contact and the speed.
/// ```
/// use carom_figure::{ImpactFigure, ImpactSketch, SketchBody, SketchContact, impact_report};
/// let ball = SketchBody { velocity: [0.0, -2.0], ..SketchBody::default() };
/// let floor =
///     SketchContact { name: "floor".to_owned(), point: [0.0, -0.1], normal: [0.0, 1.0], bodies: vec![0] };
/// let sketch = ImpactSketch { bodies: vec![ball], contacts: vec![floor] };
/// let page = impact_report(&ImpactFigure { sketch: Some(sketch), ..ImpactFigure::default() });
/// assert!(page.contains(">floor</text>") && page.contains(">2.00 m/s</text>"));
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ImpactSketch {
    /// The bodies.
    pub bodies: Vec<SketchBody>,
    /// Where they are touched, or touch each other.
    pub contacts: Vec<SketchContact>,
}

/// A body of a sketch.
///
/// # Example
/// A body that stands alone needs no name.
/// ```
/// assert!(carom_figure::SketchBody::default().name.is_empty());
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SketchBody {
    /// Its name; empty where it is the only one.
    pub name: String,
    /// Its mass centre [m].
    pub centre: [f64; 2],
    /// Velocity of its mass centre [m/s].
    pub velocity: [f64; 2],
    /// Spin, counter-clockwise [rad/s].
    pub spin: f64,
}

/// A contact of a sketch.
///
/// # Example
/// A contact below the mass centre has its normal upwards, into the body.
/// ```
/// use carom_figure::SketchContact;
/// let floor = SketchContact { point: [0.0, -0.1], normal: [0.0, 1.0], bodies: vec![0], ..SketchContact::default() };
/// assert!(floor.point[1] * floor.normal[1] < 0.0);
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SketchContact {
    /// Its name.
    pub name: String,
    /// Where it is [m]; of a body alone, from its mass centre.
    pub point: [f64; 2],
    /// Unit normal, into the first body.
    pub normal: [f64; 2],
    /// The body that is touched, by its number; or two that touch each other.
    pub bodies: Vec<usize>,
}

fn vector([x, y]: [f64; 2]) -> Vec2 {
    Vec2::new(x, y)
}

/// Where a sketch is drawn, and how long its arrows are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SketchView {
    /// The window.
    pub view: View,
    /// Pixels of an arrow for 1 m/s.
    pub speed: f64,
}

impl ImpactSketch {
    /// True where there is a contact, and every number is one.
    fn can_be_drawn(&self) -> bool {
        let contact = |c: &SketchContact| [c.point, c.normal].concat().iter().all(|v| v.is_finite());
        let body =
            |b: &SketchBody| [b.centre, b.velocity].concat().iter().chain([&b.spin]).all(|v| v.is_finite());
        !self.contacts.is_empty() && self.contacts.iter().all(contact) && self.bodies.iter().all(body)
    }

    /// A window of so many pixels around all points, with room for arrows and names.
    ///
    /// # Example
    /// ```
    /// use carom_figure::{ImpactSketch, SketchBody};
    /// let ball = SketchBody { velocity: [0.0, -2.0], ..SketchBody::default() };
    /// let seen = ImpactSketch { bodies: vec![ball], contacts: vec![] }.view([460.0, 330.0]);
    /// assert_eq!(seen.speed * 2.0, 66.0, "the fastest has an arrow of 66 pixels");
    /// ```
    pub fn view(&self, [width, height]: [f64; 2]) -> SketchView {
        let points = self.contacts.iter().map(|c| c.point).chain(self.bodies.iter().map(|b| b.centre));
        let points = points.map(vector).filter(|point| point.is_finite()).collect();
        let room = |size: f64| (size - 2.0 * FRAME).max(FRAME);
        let view = View::around(&points, 0.0, room(width), room(height)).filling(width, height);
        let fastest = self.bodies.iter().map(|b| vector(b.velocity).norm()).fold(0.0, f64::max);
        SketchView { view, speed: if fastest > 0.0 { VELOCITY / fastest } else { VELOCITY } }
    }

    /// The children of an SVG in a window: with how the bodies move, or without where a page draws that itself.
    fn drawn(&self, seen: &SketchView, moving: bool) -> Markup {
        let SketchView { view, .. } = seen;
        let mut labels = Labels::within(Vec2::ZERO, Vec2::new(view.width(), view.height()));
        keep_off_marks(self, view, &mut labels);
        let centre = |body: usize| self.bodies.get(body).map_or(Vec2::ZERO, |body| vector(body.centre));
        let arms = self.contacts.iter().flat_map(|c| {
            c.bodies
                .iter()
                .map(move |body| line("thin", xy(view.at(centre(*body))), xy(view.at(vector(c.point)))))
        });
        html! {
            (joined(self.contacts.iter().map(|c| ground(c, view))))
            (joined(arms))
            (joined(self.contacts.iter().enumerate().map(|(i, c)| contact(i, c, view, &mut labels))))
            @if moving { (joined(self.bodies.iter().map(|body| motion(body, seen, &mut labels)))) }
            (joined(self.bodies.iter().map(|body| name(body, view, &mut labels))))
        }
    }
}

/// The drawing; `None` where there is no contact, or a number that is none.
pub(crate) fn sketch(bodies: &ImpactSketch) -> Option<Markup> {
    if !bodies.can_be_drawn() {
        return None;
    }
    // The paper has one size; the bodies stand in its middle.
    let seen = bodies.view([WIDTH, HEIGHT]);
    let inside = html! { (bodies.drawn(&seen, true)) (bar(&seen.view, 14.0, HEIGHT)) };
    let box_of = [0.0, 0.0, WIDTH, HEIGHT + FOOT].map(px).join(" ");
    Some(html! {
        svg class="fig sketch" viewBox=(box_of) width=(px(WIDTH)) height=(px(HEIGHT + FOOT)) role="img"
            aria-label="The bodies before the impact" { (inside) }
    })
}

/// What is struck, in a window of a page that stays open, as the children of an SVG of the class `fig sketch`; the page draws how the bodies
/// move. Empty where a number is none.
///
/// # Example
/// ```
/// use carom_figure::{ImpactSketch, SketchBody, SketchContact, live_sketch};
/// let floor = SketchContact { point: [0.0, -0.1], normal: [0.0, 1.0], bodies: vec![0], ..SketchContact::default() };
/// let sketch = ImpactSketch { bodies: vec![SketchBody::default()], contacts: vec![floor] };
/// assert!(live_sketch(&sketch, &sketch.view([600.0, 400.0])).contains("axis-arrow"));
/// ```
pub fn live_sketch(bodies: &ImpactSketch, seen: &SketchView) -> String {
    if bodies.can_be_drawn() { bodies.drawn(seen, false).into_string() } else { String::new() }
}

/// Names stand off points and the arrows of velocities.
fn keep_off_marks(bodies: &ImpactSketch, view: &View, labels: &mut Labels) {
    let room = Vec2::new(5.0, 5.0);
    let spin = Vec2::new(SPIN + 4.0, SPIN + 4.0);
    for body in &bodies.bodies {
        let centre = view.at(vector(body.centre));
        labels.keep_off(centre - spin, centre + spin);
    }
    for c in &bodies.contacts {
        let at = view.at(vector(c.point));
        labels.keep_off(at - room, at + room);
    }
}

/// The mass centre of a body, with its name where it has one.
fn name(body: &SketchBody, view: &View, labels: &mut Labels) -> Markup {
    let centre = view.at(vector(body.centre));
    let off = [SPIN + 12.0, -SPIN - 12.0, SPIN + 28.0, -SPIN - 28.0];
    let places = off.map(|y| centre + Vec2::new(0.0, y));
    html! {
        (circle("centre", xy(centre), 3.2))
        @if !body.name.is_empty() { (named("body-name", &body.name, &places, labels)) }
    }
}

/// The scale, below the sketch.
fn bar(view: &View, x: f64, y: f64) -> Markup {
    // A view's bar stands below the view's own height.
    let up = y - view.height() - 24.0;
    html! { g transform=(format!("translate({} {})", px(x), px(up))) { (scale_bar(view)) } }
}

/// What is touched: a line along the tangent, hatched away from the body; the line alone between two bodies.
fn ground(c: &SketchContact, view: &View) -> Markup {
    let (at, normal) = (view.at(vector(c.point)), vector(c.normal));
    let along = on_paper(normal.turned_right());
    if c.bodies.len() > 1 {
        return line("thin", xy(at - along * (0.5 * GROUND)), xy(at + along * (0.5 * GROUND)));
    }
    let back = on_paper(-normal);
    obstacle_svg(&Drawn { from: at - along * GROUND, to: at + along * GROUND, cut: [false; 2], back })
}

/// A direction on paper, where y is down.
fn on_paper(d: Vec2) -> Vec2 {
    Vec2::new(d.x, -d.y)
}

/// The point of a contact with its name and its axes.
fn contact(i: usize, c: &SketchContact, view: &View, labels: &mut Labels) -> Markup {
    let (at, normal) = (view.at(vector(c.point)), vector(c.normal));
    let axes = [(normal, "n"), (normal.turned_right(), "t")].map(|(direction, letter)| {
        let direction = on_paper(direction);
        let aside = direction.turned_left() * 9.0;
        let tip = at + direction * AXIS;
        let beyond = [tip + direction * 9.0, tip + aside, tip - aside, tip + direction * 22.0];
        html! { (arrow("axis-arrow", at, direction * AXIS)) (named("axis-name", letter, &beyond, labels)) }
    });
    // Behind what is touched, nearer or farther, or beside it.
    let (back, along) = (on_paper(-normal), on_paper(normal.turned_right()));
    let half = Labels::room(&c.name, Vec2::new(1.0, 0.0)) * 0.5;
    let out = 17.0 + half.x * back.x.abs();
    let side = GROUND + 6.0 + half.x * along.x.abs() + half.y * along.y.abs();
    let places = [
        at + back * out,
        at + back * (out + 14.0),
        at - along * side,
        at + along * side,
        at + back * (out + 28.0),
    ];
    html! {
        (joined(axes))
        (circle(&format!("k{}", i % 6), xy(at), 3.6))
        (named(&format!("contact k{}", i % 6), &c.name, &places, labels))
    }
}

/// The velocity of a body and its spin.
fn motion(body: &SketchBody, seen: &SketchView, labels: &mut Labels) -> Markup {
    let (centre, velocity) = (seen.view.at(vector(body.centre)), vector(body.velocity));
    let length = velocity.norm() * seen.speed;
    let direction = velocity.unit().map(on_paper);
    let speed = direction.map(|direction| {
        let words = format!("{} m/s", significant(velocity.norm(), DIGITS));
        let half = Labels::room(&words, Vec2::new(1.0, 0.0)) * 0.5;
        let tip = centre + direction * length;
        let aside = direction.turned_left();
        let away = |d: Vec2| d * (7.0 + half.x * d.x.abs() + half.y * d.y.abs());
        let places =
            [tip + away(direction), tip + away(aside), tip + away(-aside), tip + away(direction) * 1.8];
        html! {
            (arrow("velocity-arrow", centre, direction * length))
            (named("velocity-name", &words, &places, labels))
        }
    });
    html! {
        @if let Some(speed) = speed { (speed) }
        @if body.spin != 0.0 { (spin(body.spin, centre, labels)) }
    }
}

/// An arrow about the mass centre, and how fast it turns.
fn spin(spin: f64, centre: Vec2, labels: &mut Labels) -> Markup {
    let turned = spin.signum();
    let at = |angle: f64| centre + on_paper(Vec2::at_angle(angle)) * SPIN;
    let [from, by] = TURN;
    let (begin, end) = (from, from + turned * by);
    let (a, b) = (at(begin), at(end));
    // Counter-clockwise is sweep 0 where y is down.
    let sweep = if turned > 0.0 { "0 1 0" } else { "0 1 1" };
    let data = format!("M{} {}A{SPIN} {SPIN} {sweep} {} {}", px(a.x), px(a.y), px(b.x), px(b.y));
    let along = on_paper(Vec2::at_angle(end).turned_left() * turned);
    let words = format!("{} 1/s", significant(spin.abs(), DIGITS));
    let half = Labels::room(&words, Vec2::new(1.0, 0.0)) * 0.5;
    let (x, y) = (SPIN + 8.0 + half.x, SPIN + 5.0 + half.y);
    let places = [(0.0, -y), (x, 0.0), (-x, 0.0), (x, -y), (-x, -y), (0.0, y), (x, y), (-x, y)];
    let places = places.map(|(x, y)| centre + Vec2::new(x, y));
    html! {
        g.velocity-arrow { (svg::path("shaft", &data)) (head(b + along * (0.5 * HEAD[0]), along)) }
        (named("velocity-name", &words, &places, labels))
    }
}

/// A text whose middle is at the first of these places that is free.
fn named(class: &str, words: &str, places: &[Vec2], labels: &mut Labels) -> Markup {
    let room = Labels::room(words, Vec2::new(1.0, 0.0));
    let at = labels.place(room, places.iter().copied());
    text(class, [at.x, at.y + MIDDLE], "middle", words)
}

fn arrow(class: &str, from: Vec2, by: Vec2) -> Markup {
    let along = by.unit().unwrap_or_default();
    let tip = from + by;
    html! { g class=(class) { (line("shaft", xy(from), xy(tip - along * HEAD[0]))) (head(tip, along)) } }
}

fn head(tip: Vec2, along: Vec2) -> Markup {
    let (foot, aside) = (tip - along * HEAD[0], along.turned_left() * HEAD[1]);
    let mut data = String::new();
    for corner in [tip, foot + aside, foot - aside] {
        svg::to(&mut data, xy(corner));
    }
    svg::path("tip", &(data + "Z"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn step() -> ImpactSketch {
        let contact = |name: &str, point, normal| SketchContact {
            name: name.to_owned(),
            point,
            normal,
            bodies: vec![0],
        };
        let contacts =
            vec![contact("floor", [0.0, -0.1], [0.0, 1.0]), contact("<K>", [0.1, 0.0], [-1.0, 0.0])];
        let ring = SketchBody { velocity: [1.0, 0.0], spin: -10.0, ..SketchBody::default() };
        ImpactSketch { bodies: vec![ring], contacts }
    }

    #[test]
    fn a_sketch_shows_every_contact_with_its_axes_and_the_motion() {
        let drawing = sketch(&step()).map(Markup::into_string).unwrap_or_default();
        for part in [">floor</text>", ">&lt;K&gt;</text>", ">1.00 m/s</text>", ">10.0 1/s</text>"] {
            assert!(drawing.contains(part), "{part} in {drawing}");
        }
        for letter in [">n</text>", ">t</text>"] {
            assert_eq!(drawing.matches(letter).count(), 2, "each contact has its {letter}");
        }
        assert!(drawing.contains("A17 17 0 1 1"), "a negative spin turns clockwise: {drawing}");
    }

    #[test]
    fn the_tangent_is_the_normal_turned_clockwise() {
        let view = View::around(&[Vec2::ZERO, Vec2::new(0.0, -0.1)].into_iter().collect(), 0.0, 100.0, 100.0);
        let floor =
            SketchContact { name: "A".to_owned(), point: [0.0, -0.1], normal: [0.0, 1.0], bodies: vec![0] };
        let mut labels = Labels::within(Vec2::new(-200.0, -200.0), Vec2::new(200.0, 200.0));
        let drawn = contact(0, &floor, &view, &mut labels).into_string();
        // Upwards to y 100 − 44, and to the right to x 44, less the heads.
        assert!(drawn.contains("x1=\"0\" y1=\"100\" x2=\"0\" y2=\"64\""), "the normal: {drawn}");
        assert!(drawn.contains("x1=\"0\" y1=\"100\" x2=\"36\" y2=\"100\""), "the tangent: {drawn}");
    }

    #[test]
    fn nothing_is_drawn_of_numbers_that_are_none() {
        assert_eq!(
            sketch(&ImpactSketch {
                bodies: vec![SketchBody { spin: f64::NAN, ..SketchBody::default() }],
                ..step()
            })
            .map(Markup::into_string),
            None,
            "NaN"
        );
        assert_eq!(sketch(&ImpactSketch::default()).map(Markup::into_string), None, "no contact");
    }
}
