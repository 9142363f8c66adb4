//! Area, centroid and second moment of the rounded hull, exactly.

use super::Shape;
use carom_num::{Vec2, elementary::atan2};

/// Area, centroid and polar second moment of a shape of uniform thickness.
///
/// # Example
/// A square of side 2 m has the polar second moment `a⁴/6` and the area `a²`.
/// ```
/// use carom_motion::planar::{MassProperties, Shape};
/// use carom_num::Vec2;
/// let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Vec2::new(x, y));
/// let square = MassProperties::of(&Shape::new(corners.to_vec(), 0.0).unwrap());
/// assert_eq!((square.area, square.centroid), (4.0, Vec2::ZERO));
/// assert!((square.gyration_squared - 2.0 / 3.0).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassProperties {
    /// Area \[m²\]; 0 for a thin rod.
    pub area: f64,
    /// Centroid, in the frame the vertices are given in [m].
    pub centroid: Vec2,
    /// Polar second moment about the centroid divided by the area: the square of the radius of gyration \[m²\].
    pub gyration_squared: f64,
}

/// Area and moments about the frame's origin, summed piece by piece.
#[derive(Clone, Copy, Default)]
struct Moments {
    area: f64,
    first: Vec2,
    polar: f64,
}

impl Moments {
    /// Adds a piece of this area, with its first and polar second moments about a point.
    fn add_about(&mut self, point: Vec2, area: f64, first: Vec2, polar: f64) {
        self.area += area;
        self.first += area * point + first;
        self.polar += polar + 2.0 * point.dot(first) + area * point.dot(point);
    }

    /// Adds a piece of this area, with its centroid and its polar second moment about that centroid.
    fn add(&mut self, area: f64, centroid: Vec2, polar: f64) {
        self.area += area;
        self.first += area * centroid;
        self.polar += polar + area * centroid.dot(centroid);
    }
}

impl MassProperties {
    /// Of the region within the outline: the polygon of the vertices, a piece on each face and a sector about each vertex, each counted negative
    /// where a radius is.
    ///
    /// ```text
    /// face of length ℓ between radii r and s = r − q, about the first vertex, along the face and out of it:
    ///     A = ℓ(r − q/2),  S = (ℓ²(r/2 − q/3), ℓ(r² − q²/3)/2),  J = ℓ³(r/3 − q/4) + ℓ(r³ − q³/4)/3
    /// sector of angle θ about its vertex:
    ///     A = r²θ/2,       S = r³/3 (sin φ, −cos φ) from φ₁ to φ₂,  J = r⁴θ/4
    /// ```
    ///
    /// A thin rod (two vertices, radius 0) has its length ℓ in place of an area: centroid in the middle, ℓ²/12.
    ///
    /// # Example
    /// ```
    /// use carom_motion::planar::{MassProperties, Shape};
    /// use carom_num::Vec2;
    /// let rod = Shape::new(vec![Vec2::new(-0.3, 0.0), Vec2::new(0.3, 0.0)], 0.0).unwrap();
    /// assert!((MassProperties::of(&rod).gyration_squared - 0.03).abs() < 1e-17);
    /// ```
    pub fn of(shape: &Shape) -> Self {
        let vertices = shape.vertices();
        let radius = shape.radius_of(0);
        let origin = vertices.iter().fold(Vec2::ZERO, |sum, v| sum + *v) / vertices.len() as f64;
        if let [a, b] = vertices
            && shape.is_thin_rod()
        {
            let length = (*b - *a).norm();
            return Self { area: 0.0, centroid: origin, gyration_squared: length * length / 12.0 };
        }
        let mut sum = polygon(vertices, origin);
        if vertices.len() == 1 {
            let area = std::f64::consts::PI * radius * radius;
            sum.add(area, Vec2::ZERO, 0.5 * area * radius * radius);
        } else {
            add_rounding(&mut sum, shape, origin);
        }
        let centroid = sum.first / sum.area;
        let gyration_squared = sum.polar / sum.area - centroid.dot(centroid);
        Self { area: sum.area, centroid: origin + centroid, gyration_squared }
    }
}

fn polygon(vertices: &[Vec2], origin: Vec2) -> Moments {
    let mut sum = Moments::default();
    if vertices.len() < 3 {
        return sum;
    }
    for (i, a) in vertices.iter().enumerate() {
        let (a, b) = (*a - origin, vertices[(i + 1) % vertices.len()] - origin);
        let doubled = a.cross(b);
        sum.area += 0.5 * doubled;
        sum.first += (a + b) * (doubled / 6.0);
        sum.polar += doubled * (a.dot(a) + a.dot(b) + b.dot(b)) / 12.0;
    }
    sum
}

fn add_rounding(sum: &mut Moments, shape: &Shape, origin: Vec2) {
    let faces = shape.faces();
    for i in 0..faces {
        let next = (i + 1) % faces;
        let (r, s, length) = (shape.radius_of(i), shape.radius_of(next), shape.face_length(i));
        let (normal, after) = (shape.face_normal(i), shape.face_normal(next));
        if r != 0.0 || s != 0.0 {
            // Along the face x = 0…ℓ, outwards from the line between the vertices, y = q x/ℓ, to the face, y = r.
            let (q, along) = (r - s, normal.turned_left());
            let area = length * 0.5 * (r + s);
            let first = along * (length * length * (r / 2.0 - q / 3.0))
                + normal * (0.5 * length * (r * r - q * q / 3.0));
            let polar =
                length * (length * length * (r / 3.0 - q / 4.0) + (r * r * r - q * q * q / 4.0) / 3.0);
            sum.add_about(shape.vertices()[i] - origin, area, first, polar);
        }
        if s != 0.0 {
            // By the lesser angle, to the right about a hollow; a rod's end turns by half a turn to the left.
            let turn = atan2(normal.cross(after).abs(), normal.dot(after)).copysign(s);
            let area = 0.5 * s * s * turn;
            let first = (normal - after).turned_left() * (s * s * s / 3.0);
            sum.add_about(shape.vertices()[next] - origin, area, first, 0.5 * area * s * s);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// What 2000 chords leave out of an arc, as a share: a chord over the angle φ, here some 1e-3, leaves out φ²/6 of its sector.
    const OF_ARCS: f64 = 1e-6;

    fn of(vertices: &[(f64, f64)], radius: f64) -> MassProperties {
        let vertices = vertices.iter().map(|(x, y)| Vec2::new(*x, *y)).collect();
        MassProperties::of(&Shape::new(vertices, radius).unwrap())
    }

    fn close(a: f64, b: f64) {
        assert!((a - b).abs() <= 1e-14 * (1.0 + b.abs()), "{a} is not {b}");
    }

    #[test]
    fn a_rectangle_has_a_twelfth_of_its_sides_squared() {
        let found = of(&[(1.0, 2.0), (4.0, 2.0), (4.0, 3.0), (1.0, 3.0)], 0.0);
        close(found.area, 3.0);
        close(found.centroid.x, 2.5);
        close(found.centroid.y, 2.5);
        close(found.gyration_squared, (9.0 + 1.0) / 12.0);
    }

    #[test]
    fn a_right_triangle_has_its_textbook_moment() {
        let found = of(&[(0.0, 0.0), (3.0, 0.0), (0.0, 6.0)], 0.0);
        close(found.area, 9.0);
        close(found.centroid.x, 1.0);
        close(found.centroid.y, 2.0);
        close(found.gyration_squared, (9.0 + 36.0) / 18.0);
    }

    #[test]
    fn a_disc_has_half_its_radius_squared() {
        let found = of(&[(0.5, -1.0)], 2.0);
        close(found.area, 4.0 * PI);
        close(found.centroid.x, 0.5);
        close(found.gyration_squared, 2.0);
    }

    #[test]
    fn a_stadium_is_a_rectangle_and_two_half_discs() {
        let (half, r) = (1.5, 0.5);
        let found = of(&[(-half, 0.0), (half, 0.0)], r);
        let (sides, ends) = (4.0 * half * r, PI * r * r);
        close(found.area, sides + ends);
        // Half discs: centroid 4r/3π from the diameter.
        let c = 4.0 * r / (3.0 * PI);
        let own = 0.5 * r * r - c * c;
        let polar = sides * (9.0 + 1.0) / 12.0 + ends * (own + (half + c) * (half + c));
        close(found.gyration_squared, polar / found.area);
        close(found.centroid.x, 0.0);
    }

    #[test]
    fn rounding_is_the_limit_of_many_corners() {
        let sharp = [(0.0, 0.0), (2.0, 0.3), (1.2, 1.1)];
        let radius = 0.4;
        let mut outline = vec![];
        let shape = Shape::new(sharp.iter().map(|(x, y)| Vec2::new(*x, *y)).collect(), radius).unwrap();
        for i in 0..3 {
            let corner = shape.vertices()[(i + 1) % 3];
            let (a, b) = (shape.face_normal(i), shape.face_normal((i + 1) % 3));
            let turn = atan2(a.cross(b), a.dot(b));
            for step in 0..=2000 {
                let (sin, cos) = carom_num::elementary::sin_cos(turn * f64::from(step) / 2000.0);
                let at = corner + radius * a.rotated(cos, sin);
                outline.push((at.x, at.y));
            }
        }
        let (exact, many) = (of(&sharp, radius), of(&outline, 0.0));
        assert!((exact.area - many.area).abs() < OF_ARCS * exact.area, "{exact:?} {many:?}");
        assert!((exact.centroid - many.centroid).norm() < OF_ARCS, "{exact:?} {many:?}");
        let gyration = (exact.gyration_squared - many.gyration_squared).abs();
        assert!(gyration < OF_ARCS * exact.gyration_squared, "{exact:?} {many:?}");
    }
}
