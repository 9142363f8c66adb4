//! An edge of an outline: a straight line, an arc of a circle or an ellipse, a cubic Bézier curve.

use crate::tolerance::ROUND_EDGE;
use carom_num::Vec2;
use carom_num::elementary::{acos, atan, sin, sin_cos};

/// Most chords of one edge: an arc of a measureless radius has no more.
const MOST_CHORDS: usize = 100_000;

/// One edge, from one point to another [m]; y up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Edge {
    Line { from: Vec2, to: Vec2 },
    Arc(Arc),
    Cubic([Vec2; 4]),
}

/// An arc of an ellipse with conjugate half-diameters u, from the centre to where the arc starts, and v.
///
/// ```text
/// p(α) = from + u (cos α − 1) + v sin α,   α from 0 to `sweep`
/// ```
///
/// A circle has |u| = |v| and u ⟂ v. The form is kept by every linear map and loses no digits where a flat arc's centre is far away.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Arc {
    pub(crate) from: Vec2,
    pub(crate) to: Vec2,
    pub(crate) u: Vec2,
    pub(crate) v: Vec2,
    pub(crate) sweep: f64,
}

/// A linear map of the plane and a shift.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Placement {
    /// Image of (1, 0).
    pub(crate) x: Vec2,
    /// Image of (0, 1).
    pub(crate) y: Vec2,
    /// Image of the origin.
    pub(crate) origin: Vec2,
}

impl Placement {
    pub(crate) fn scaled(x: f64, y: f64) -> Self {
        Self { x: Vec2::new(x, 0.0), y: Vec2::new(0.0, y), origin: Vec2::ZERO }
    }

    pub(crate) fn shifted(by: Vec2) -> Self {
        Self { origin: by, ..Self::scaled(1.0, 1.0) }
    }

    pub(crate) fn turn(self, direction: Vec2) -> Vec2 {
        self.x * direction.x + self.y * direction.y
    }

    pub(crate) fn place(self, point: Vec2) -> Vec2 {
        self.origin + self.turn(point)
    }

    /// First `inner`, then this.
    pub(crate) fn after(self, inner: Self) -> Self {
        Self { x: self.turn(inner.x), y: self.turn(inner.y), origin: self.place(inner.origin) }
    }
}

impl Arc {
    /// A whole circle, counter-clockwise from its rightmost point.
    pub(crate) fn circle(centre: Vec2, radius: f64) -> Self {
        Self::about(centre, Vec2::new(radius, 0.0), Vec2::new(0.0, radius), [0.0, std::f64::consts::TAU])
    }

    /// The arc of centre + u cos α + v sin α from one α, by a sweep.
    pub(crate) fn about(centre: Vec2, u: Vec2, v: Vec2, [start, sweep]: [f64; 2]) -> Self {
        let at = |angle: f64| {
            let (sin, cos) = sin_cos(angle);
            (u * cos + v * sin, v * cos - u * sin)
        };
        let (u, v) = at(start);
        let (end, _) = if sweep.abs() == std::f64::consts::TAU { (u, v) } else { at(start + sweep) };
        Self { from: centre + u, to: centre + end, u, v, sweep }
    }

    /// The circular arc between two points whose bulge is the tangent of a quarter of its sweep, positive to the right of the way.
    pub(crate) fn bulged(from: Vec2, to: Vec2, bulge: f64) -> Self {
        let chord = to - from;
        // From the chord's middle to the centre: chord/2 · cot(sweep/2), to the left.
        let away = chord.turned_left() * ((1.0 - bulge * bulge) / (4.0 * bulge));
        let u = chord * -0.5 - away;
        Self { from, to, u, v: u.turned_left(), sweep: 4.0 * atan(bulge) }
    }

    /// The radius, if it is an arc of a circle.
    pub(crate) fn radius(&self) -> Option<f64> {
        let (u, v) = (self.u.norm(), self.v.norm());
        let round = (u - v).abs() <= ROUND_EDGE * u && self.u.dot(self.v).abs() <= ROUND_EDGE * u * v;
        round.then_some(u)
    }

    /// True where it turns left on its way.
    pub(crate) fn turns_left(&self) -> bool {
        self.u.cross(self.v) * self.sweep > 0.0
    }

    fn offset(&self, angle: f64) -> Vec2 {
        let (half, _) = sin_cos(0.5 * angle);
        self.u * (-2.0 * half * half) + self.v * sin(angle)
    }

    fn reversed(&self) -> Self {
        let (sin, cos) = sin_cos(self.sweep);
        let (u, v) = (self.u * cos + self.v * sin, self.u * sin - self.v * cos);
        Self { from: self.to, to: self.from, u, v, sweep: self.sweep }
    }
}

impl Edge {
    pub(crate) fn from(&self) -> Vec2 {
        match self {
            Self::Line { from, .. } => *from,
            Self::Arc(arc) => arc.from,
            Self::Cubic(points) => points[0],
        }
    }

    pub(crate) fn to(&self) -> Vec2 {
        match self {
            Self::Line { to, .. } => *to,
            Self::Arc(arc) => arc.to,
            Self::Cubic(points) => points[3],
        }
    }

    pub(crate) fn is_straight(&self) -> bool {
        matches!(self, Self::Line { .. })
    }

    /// The point at a share s of the parameter, 0 to 1; the ends are met exactly.
    pub(crate) fn point(&self, s: f64) -> Vec2 {
        if s == 0.0 {
            return self.from();
        }
        if s == 1.0 {
            return self.to();
        }
        match self {
            Self::Line { from, to } => *from + (*to - *from) * s,
            Self::Arc(arc) => arc.from + arc.offset(arc.sweep * s),
            Self::Cubic([a, b, c, d]) => {
                let r = 1.0 - s;
                *a * (r * r * r) + *b * (3.0 * r * r * s) + *c * (3.0 * r * s * s) + *d * (s * s * s)
            }
        }
    }

    /// Derivative of the point by s.
    pub(crate) fn velocity(&self, s: f64) -> Vec2 {
        match self {
            Self::Line { from, to } => *to - *from,
            Self::Arc(arc) => {
                let (sin, cos) = sin_cos(arc.sweep * s);
                (arc.v * cos - arc.u * sin) * arc.sweep
            }
            Self::Cubic([a, b, c, d]) => {
                let r = 1.0 - s;
                ((*b - *a) * (r * r) + (*c - *b) * (2.0 * r * s) + (*d - *c) * (s * s)) * 3.0
            }
        }
    }

    /// Moves where it starts.
    pub(crate) fn start_at(&mut self, point: Vec2) {
        match self {
            Self::Line { from, .. } => *from = point,
            Self::Arc(arc) => arc.from = point,
            Self::Cubic(points) => points[0] = point,
        }
    }

    /// Moves where it ends.
    pub(crate) fn end_at(&mut self, point: Vec2) {
        match self {
            Self::Line { to, .. } => *to = point,
            Self::Arc(arc) => arc.to = point,
            Self::Cubic(points) => points[3] = point,
        }
    }

    pub(crate) fn reversed(&self) -> Self {
        match self {
            Self::Line { from, to } => Self::Line { from: *to, to: *from },
            Self::Arc(arc) => Self::Arc(arc.reversed()),
            Self::Cubic([a, b, c, d]) => Self::Cubic([*d, *c, *b, *a]),
        }
    }

    pub(crate) fn placed(&self, by: Placement) -> Self {
        match self {
            Self::Line { from, to } => Self::Line { from: by.place(*from), to: by.place(*to) },
            Self::Arc(arc) => Self::Arc(Arc {
                from: by.place(arc.from),
                to: by.place(arc.to),
                u: by.turn(arc.u),
                v: by.turn(arc.v),
                sweep: arc.sweep,
            }),
            Self::Cubic(points) => Self::Cubic(points.map(|point| by.place(point))),
        }
    }

    pub(crate) fn is_finite(&self) -> bool {
        let rest = match self {
            Self::Line { .. } => true,
            Self::Arc(arc) => arc.u.is_finite() && arc.v.is_finite() && arc.sweep.is_finite(),
            Self::Cubic(points) => points.iter().all(|point| point.is_finite()),
        };
        rest && self.from().is_finite() && self.to().is_finite()
    }

    /// Into how many chords the share `part` of the parameter is cut so that none is farther than `within` from the edge.
    ///
    /// A chord over a step h of a parameter is at most max|p″| h²/8 off; for a circle max|p″| is its radius.
    pub(crate) fn chords(&self, part: f64, within: f64) -> usize {
        let (bend, span) = match self {
            Self::Line { .. } => return 1,
            Self::Arc(arc) => {
                let bend = arc.radius().unwrap_or_else(|| (arc.u.dot(arc.u) + arc.v.dot(arc.v)).sqrt());
                (bend, arc.sweep.abs() * part)
            }
            Self::Cubic([a, b, c, d]) => {
                let second = |p: Vec2, q: Vec2, r: Vec2| (p - q * 2.0 + r).norm();
                (6.0 * second(*a, *b, *c).max(second(*b, *c, *d)), part)
            }
        };
        // A chord of a circle is r(1 − cos(h/2)) off: exact, so that a disc gets no chord more than it needs.
        let step = match self {
            Self::Arc(arc) if arc.radius().is_some() && within < bend => 2.0 * acos(1.0 - within / bend),
            _ => (8.0 * within / bend).sqrt(),
        };
        // Chords of an arc span at most a quarter turn.
        let step = if matches!(self, Self::Arc(_)) { step.min(std::f64::consts::FRAC_PI_2) } else { step };
        // So much less, that rounding does not cost a chord. The cast saturates; a curve that bends nowhere gives 0 or NaN.
        let count = ((span / step - ROUND_EDGE).ceil() as usize).clamp(1, MOST_CHORDS);
        // A whole turn keeps the symmetry of its circle or ellipse.
        let whole = matches!(self, Self::Arc(_)) && span > std::f64::consts::TAU - ROUND_EDGE;
        if whole { count.next_multiple_of(4) } else { count }
    }
}
