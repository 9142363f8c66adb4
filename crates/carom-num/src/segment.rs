//! Straight segments, in the plane and in space.

use crate::{Vec2, Vec3};

/// True where the segments a–b and c–d cross: the ends of each lie on different sides of the other, farther from its line than `slack`, in the unit of the
/// vectors. Segments that touch do not cross, nor does one without length.
///
/// # Example
/// The diagonals of a square cross; two of its sides only touch.
/// ```
/// use carom_num::{Vec2, segment::properly_cross};
/// let corner = |x, y| Vec2::new(x, y);
/// let [a, b, c, d] = [corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0)];
/// assert!(properly_cross((a, c), (b, d), 1e-9) && !properly_cross((a, b), (b, c), 1e-9));
/// ```
pub fn properly_cross((a, b): (Vec2, Vec2), (c, d): (Vec2, Vec2), slack: f64) -> bool {
    parts((a, b), (c, d), slack) && parts((c, d), (a, b), slack)
}

/// True where the line through a and b parts c from d.
fn parts((a, b): (Vec2, Vec2), (c, d): (Vec2, Vec2), slack: f64) -> bool {
    let along = (b - a) / (b - a).norm();
    let (c, d) = (along.cross(c - a), along.cross(d - a));
    c.abs() > slack && d.abs() > slack && (c > 0.0) != (d > 0.0)
}

/// How far two segments in space are from each other, each given by where it begins and where it ends; in the unit of the vectors.
///
/// # Example
/// ```
/// use carom_num::{Vec3, segment::distance};
/// let (crossing, beside) = ([Vec3::X * -1.0, Vec3::X], [Vec3::X * 2.0, Vec3::X * 3.0]);
/// assert_eq!(distance(crossing, [Vec3::Z * 0.5 - Vec3::Y, Vec3::Z * 0.5 + Vec3::Y]), 0.5);
/// assert_eq!(distance(crossing, beside), 1.0);
/// ```
pub fn distance([a, b]: [Vec3; 2], [c, d]: [Vec3; 2]) -> f64 {
    let (own, other, between) = (b - a, d - c, a - c);
    let to_point = |place: Vec3, from: Vec3, along: Vec3| {
        let size = along.dot(along);
        let share = if size > 0.0 { ((place - from).dot(along) / size).clamp(0.0, 1.0) } else { 0.0 };
        (from + along * share - place).norm()
    };
    // Where neither ends they are nearest where their common perpendicular stands; else an end of one is the nearest to the other.
    let [p, q, r] = [own.dot(own), own.dot(other), other.dot(other)];
    let across = p * r - q * q;
    let [s, t] =
        [q * other.dot(between) - r * own.dot(between), p * other.dot(between) - q * own.dot(between)];
    let inside = |share: f64| share > 0.0 && share < across;
    if inside(s) && inside(t) {
        return (between + own * (s / across) - other * (t / across)).norm();
    }
    let ends = [to_point(a, c, other), to_point(b, c, other), to_point(c, a, own), to_point(d, a, own)];
    ends.into_iter().fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn segments_in_space_are_as_far_apart_as_their_nearest_points() {
        let mut seed = 7_u64;
        let mut next = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 40) as f64 / f64::from(1 << 23) - 1.0
        };
        for _ in 0..50 {
            let [a, b, c, d] = std::array::from_fn(|_| Vec3::new(next(), next(), next()));
            let found = distance([a, b], [c, d]);
            let shares = || (0..=200).map(|i| f64::from(i) / 200.0);
            let apart = |s: f64, t: f64| (a + (b - a) * s - c - (d - c) * t).norm();
            let tried =
                shares().flat_map(|s| shares().map(move |t| apart(s, t))).fold(f64::INFINITY, f64::min);
            assert!(found <= tried + 1e-15 && tried - found < 0.02, "{found} {tried}");
        }
        let line = [Vec3::ZERO, Vec3::X];
        assert_eq!(distance(line, [Vec3::Y, Vec3::X + Vec3::Y]), 1.0, "parallel");
        assert_eq!(distance(line, [Vec3::X * 3.0; 2]), 2.0, "a point");
    }

    fn segment(from: (f64, f64), to: (f64, f64)) -> (Vec2, Vec2) {
        (Vec2::new(from.0, from.1), Vec2::new(to.0, to.1))
    }

    #[test]
    fn segments_cross_where_each_parts_the_other() {
        let line = segment((0.0, 0.0), (1.0, -0.5));
        let through = segment((0.5, 0.0), (0.5, -1.0));
        assert!(parts(line, through, 1e-9) && parts(through, line, 1e-9));
        assert!(properly_cross(line, through, 1e-9));
        let beyond = segment((1.5, 0.0), (1.5, -1.0));
        assert!(
            parts(line, beyond, 1e-9) && !parts(beyond, line, 1e-9),
            "the line goes on, the segment does not"
        );
        let touching = segment((0.5, -0.25), (0.5, -1.0));
        assert!(!parts(line, touching, 1e-9), "an end on the other segment does not cross it");
        let point = segment((0.5, -0.2), (0.5, -0.2));
        assert!(!properly_cross(line, point, 0.0) && !properly_cross(point, line, 0.0));
    }
}
