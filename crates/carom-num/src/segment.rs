//! Straight segments in the plane.

use crate::Vec2;

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

#[cfg(test)]
mod tests {
    use super::*;

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
