//! The sketch of a free body that is struck: where it is touched, the axes of each contact, and how it moves before.

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

/// A free body that is struck, before the impact.
///
/// # Example
/// A ball that falls on a floor: the sketch names the contact and the speed.
/// ```
/// use carom_figure::{ImpactFigure, ImpactSketch, SketchContact, impact_report};
/// let floor = SketchContact { name: "floor".to_owned(), point: [0.0, -0.1], normal: [0.0, 1.0] };
/// let sketch = ImpactSketch { velocity: [0.0, -2.0], spin: 0.0, contacts: vec![floor] };
/// let page = impact_report(&ImpactFigure { sketch: Some(sketch), ..ImpactFigure::default() });
/// assert!(page.contains(">floor</text>") && page.contains(">2.00 m/s</text>"));
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ImpactSketch {
    /// Velocity of its mass centre [m/s].
    pub velocity: [f64; 2],
    /// Spin, counter-clockwise [rad/s].
    pub spin: f64,
    /// Where it is touched.
    pub contacts: Vec<SketchContact>,
}

/// A contact of a sketch.
///
/// # Example
/// A contact below the mass centre has its normal upwards, into the body.
/// ```
/// use carom_figure::SketchContact;
/// let floor = SketchContact { name: "floor".to_owned(), point: [0.0, -0.1], normal: [0.0, 1.0] };
/// assert!(floor.point[1] * floor.normal[1] < 0.0);
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SketchContact {
    /// Its name.
    pub name: String,
    /// Where it is, from the mass centre [m].
    pub point: [f64; 2],
    /// Unit normal, into the body.
    pub normal: [f64; 2],
}

fn vector([x, y]: [f64; 2]) -> Vec2 {
    Vec2::new(x, y)
}

/// The drawing; `None` where there is no contact, or a number that is none.
pub(crate) fn sketch(body: &ImpactSketch) -> Option<Markup> {
    let finite = |c: &SketchContact| [c.point, c.normal].concat().iter().all(|v| v.is_finite());
    let moves = body.velocity.iter().chain([&body.spin]).all(|v| v.is_finite());
    if body.contacts.is_empty() || !moves || !body.contacts.iter().all(finite) {
        return None;
    }
    let points = body.contacts.iter().map(|c| vector(c.point)).chain([Vec2::ZERO]);
    let view = View::around(&points.collect(), 0.0, WIDTH - 2.0 * FRAME, HEIGHT - 2.0 * FRAME);
    // The paper has one size; the body stands in its middle.
    let low = Vec2::new(0.5 * (view.width() - WIDTH), 0.5 * (view.height() - HEIGHT));
    let high = Vec2::new(low.x + WIDTH, low.y + HEIGHT);
    let mut labels = Labels::within(low, high);
    keep_off_marks(body, &view, &mut labels);
    let inside = html! {
        (joined(body.contacts.iter().map(|c| ground(c, &view))))
        (joined(body.contacts.iter().map(|c| line("thin", xy(view.at(Vec2::ZERO)), xy(view.at(vector(c.point)))))))
        (joined(body.contacts.iter().enumerate().map(|(i, c)| contact(i, c, &view, &mut labels))))
        (motion(body, &view, &mut labels))
        (bar(&view, low.x + 14.0, high.y))
    };
    let box_of = [low.x, low.y, WIDTH, HEIGHT + FOOT].map(px).join(" ");
    Some(html! {
        svg class="fig sketch" viewBox=(box_of) width=(px(WIDTH)) height=(px(HEIGHT + FOOT)) role="img"
            aria-label="The body before the impact" { (inside) }
    })
}

/// Names stand off points and the arrows of velocities.
fn keep_off_marks(body: &ImpactSketch, view: &View, labels: &mut Labels) {
    let room = Vec2::new(5.0, 5.0);
    let centre = view.at(Vec2::ZERO);
    let spin = Vec2::new(SPIN + 4.0, SPIN + 4.0);
    labels.keep_off(centre - spin, centre + spin);
    for c in &body.contacts {
        let at = view.at(vector(c.point));
        labels.keep_off(at - room, at + room);
    }
}

/// The scale, below the sketch.
fn bar(view: &View, x: f64, y: f64) -> Markup {
    // A view's bar stands below the view's own height.
    let up = y - view.height() - 24.0;
    html! { g transform=(format!("translate({} {})", px(x), px(up))) { (scale_bar(view)) } }
}

/// What is touched: a line along the tangent, hatched away from the body.
fn ground(c: &SketchContact, view: &View) -> Markup {
    let (at, normal) = (view.at(vector(c.point)), vector(c.normal));
    let along = on_paper(normal.turned_right());
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

/// The mass centre, its velocity and the spin.
fn motion(body: &ImpactSketch, view: &View, labels: &mut Labels) -> Markup {
    let (centre, velocity) = (view.at(Vec2::ZERO), vector(body.velocity));
    let direction = velocity.unit().map(on_paper);
    let speed = direction.map(|direction| {
        let words = format!("{} m/s", significant(velocity.norm(), DIGITS));
        let half = Labels::room(&words, Vec2::new(1.0, 0.0)) * 0.5;
        let tip = centre + direction * VELOCITY;
        let aside = direction.turned_left();
        let away = |d: Vec2| d * (7.0 + half.x * d.x.abs() + half.y * d.y.abs());
        let places =
            [tip + away(direction), tip + away(aside), tip + away(-aside), tip + away(direction) * 1.8];
        html! {
            (arrow("velocity-arrow", centre, direction * VELOCITY))
            (named("velocity-name", &words, &places, labels))
        }
    });
    html! {
        @if let Some(speed) = speed { (speed) }
        @if body.spin != 0.0 { (spin(body.spin, centre, labels)) }
        (circle("centre", xy(centre), 3.2))
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
        let contact = |name: &str, point, normal| SketchContact { name: name.to_owned(), point, normal };
        let contacts =
            vec![contact("floor", [0.0, -0.1], [0.0, 1.0]), contact("<K>", [0.1, 0.0], [-1.0, 0.0])];
        ImpactSketch { velocity: [1.0, 0.0], spin: -10.0, contacts }
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
        let floor = SketchContact { name: "A".to_owned(), point: [0.0, -0.1], normal: [0.0, 1.0] };
        let mut labels = Labels::within(Vec2::new(-200.0, -200.0), Vec2::new(200.0, 200.0));
        let drawn = contact(0, &floor, &view, &mut labels).into_string();
        // Upwards to y 100 − 44, and to the right to x 44, less the heads.
        assert!(drawn.contains("x1=\"0\" y1=\"100\" x2=\"0\" y2=\"64\""), "the normal: {drawn}");
        assert!(drawn.contains("x1=\"0\" y1=\"100\" x2=\"36\" y2=\"100\""), "the tangent: {drawn}");
    }

    #[test]
    fn nothing_is_drawn_of_numbers_that_are_none() {
        assert_eq!(sketch(&ImpactSketch { spin: f64::NAN, ..step() }).map(Markup::into_string), None, "NaN");
        assert_eq!(sketch(&ImpactSketch::default()).map(Markup::into_string), None, "no contact");
    }
}
