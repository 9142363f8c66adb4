//! How hard contacts can press on a body that they hardly move: a wedge, and what it lets an impact do.
//!
//! Contact i pushes with `p_i (n_i + s t_i)`, `p_i ≥ 0`, `|s| ≤ μ_i`. A push moves the body as fast as its wrench is large, moments
//! divided by the radius of gyration ρ:
//!
//! ```text
//! |Δv|² = v_x² + v_y² + ρ² ω² = (F_x² + F_y² + (M/ρ)²) / m²
//! z = min |Σ wrenches| over Σ p_i = 1,     Σ p_i ≤ m |Δv| / z
//! ```
//!
//! z is the distance of the origin from the convex hull of the edges of the friction cones, so it is a minimum over points, segments,
//! triangles and tetrahedra of them. Where z = 0 a load holds itself: no impulse need end, and a body that its obstacles squeeze jams.
//!
//! Source: for z = 0, Nguyen, "Constructing force-closure grasps", Int. J. Robotics Research 7(3) (1988) 3; that four edges are enough in the plane is
//! Carathéodory's theorem. The bound follows from the balance of momentum.

use crate::vectors::{V, dot, minus, times};

/// Below this share of its length the way to another corner depends on the others.
const DEPENDENT: f64 = 1e-14;

/// A wrench: force along x and y, moment by radius of gyration.
type Wrench = V;

/// A place where something may push on a body, in any frame with its origin at the mass centre.
///
/// # Example
/// A foot below the mass centre, on a floor: a push of 1 N moves the body up, and turns it by the friction there.
/// ```
/// use carom_theory::wedging::{PushedPoint, least_wrench};
/// let foot = PushedPoint { arm: [0.0, -0.5], normal: [0.0, 1.0], friction: 0.3 };
/// assert_eq!(least_wrench(&[foot], 1.0), 1.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PushedPoint {
    /// From the mass centre \[m\].
    pub arm: [f64; 2],
    /// Unit normal into the body.
    pub normal: [f64; 2],
    /// Coulomb's coefficient, ≥ 0.
    pub friction: f64,
}

impl PushedPoint {
    /// The edges of its friction cone, each with a normal part of 1.
    fn edges(&self, radius_of_gyration: f64) -> [Wrench; 2] {
        let ([x, y], [n_x, n_y]) = (self.arm, self.normal);
        [self.friction, -self.friction].map(|s| {
            let (f_x, f_y) = (n_x + s * n_y, n_y - s * n_x);
            [f_x, f_y, (x * f_y - y * f_x) / radius_of_gyration]
        })
    }
}

/// z of these contacts: the least wrench of pushes whose normal parts add up to 1 N, with moments divided by ρ = √(J/m).
///
/// Zero where a load holds itself, up to rounding: some 10⁻¹⁶ times the largest single wrench. Infinite without contacts.
///
/// # Limits
/// `radius_of_gyration` \[m\] is above 0. For n contacts some n⁴ tetrahedra are looked at.
///
/// # Example
/// A body gripped between two opposite plates at ±0.5 m: the pushes cancel. Let one plate be turned by 0.2 rad, and friction has to make up for it.
/// ```
/// use carom_theory::wedging::{PushedPoint, least_wrench};
/// let grip = |turn: f64, friction: f64| {
///     let left = PushedPoint { arm: [-0.5, 0.0], normal: [1.0, 0.0], friction };
///     let right = PushedPoint { arm: [0.5, 0.0], normal: [-turn.cos(), turn.sin()], friction };
///     least_wrench(&[left, right], 1.0)
/// };
/// assert_eq!(grip(0.0, 0.0), 0.0);
/// assert!(grip(0.2, 0.1) > 0.01);
/// // Each cone holds the line between the points as soon as the angle of friction is 0.2 at the right.
/// assert!(grip(0.2, 1.001 * 0.2f64.tan()) < 1e-15);
/// ```
pub fn least_wrench(points: &[PushedPoint], radius_of_gyration: f64) -> f64 {
    let edges: Vec<Wrench> = points.iter().flat_map(|p| p.edges(radius_of_gyration)).collect();
    let mut least = f64::INFINITY;
    let mut corners = Vec::with_capacity(4);
    simplices(&edges, &mut corners, &mut least);
    least
}

/// The most that contacts at rest can press in one impact, the sum of their normal impulses \[N s\].
///
/// ```text
/// Σ p_i ≤ 2 m |v| / z,     |v|² = v_x² + v_y² + ρ² ω²
/// ```
///
/// It holds under every law that adds no energy (Poisson, Stronge; Newton's may add some): the body is no faster afterwards than before.
/// Infinite where a load holds itself, up to the rounding of z. `momentum` is m |v| before, with the spin in |v| \[N s\]. Obstacles that move
/// against each other at up to u give energy to the body, and may press with some `2 m u/z²`:
/// `z Σ p ≤ m (|v⁻| + |v⁺|)`, and `½ m |v⁺|² ≤ ½ m |v⁻|² + u Σ p √(1+μ²)`.
///
/// # Example
/// A ball that falls straight and rebounds elastically takes exactly that.
/// ```
/// use carom_theory::wedging::{PushedPoint, most_pressed};
/// let floor = PushedPoint { arm: [0.0, 0.0], normal: [0.0, 1.0], friction: 0.0 };
/// assert_eq!(most_pressed(&[floor], 0.1, 2.0 * 3.0), 2.0 * 2.0 * 3.0); // 2 kg at 3 m/s
/// ```
pub fn most_pressed(points: &[PushedPoint], radius_of_gyration: f64, momentum: f64) -> f64 {
    if momentum == 0.0 { 0.0 } else { 2.0 * momentum / least_wrench(points, radius_of_gyration) }
}

/// Asks every simplex that has these corners and others of `edges` for its distance.
fn simplices(edges: &[Wrench], corners: &mut Vec<Wrench>, least: &mut f64) {
    for (i, edge) in edges.iter().enumerate() {
        corners.push(*edge);
        if let Some(near) = nearest(corners) {
            if near.within {
                *least = least.min(near.distance);
            }
            if corners.len() < 4 {
                simplices(&edges[i + 1..], corners, least);
            }
        }
        corners.pop();
    }
}

/// The point nearest to the origin of the plane through some corners.
struct Nearest {
    distance: f64,
    /// Whether it lies in the simplex of these corners.
    within: bool,
}

/// By orthogonal directions from the first corner to the others; `None` where those depend on each other: fewer corners say the same.
fn nearest(corners: &[Wrench]) -> Option<Nearest> {
    let first = corners[0];
    let mut directions = [[0.0; 3]; 3];
    // Row j: what of direction j is in the way to each corner; last, the way to the nearest point along it.
    let (mut parts, mut along) = ([[0.0; 3]; 3], [0.0; 3]);
    let mut point = first;
    let ways = corners.len() - 1;
    for (k, corner) in corners[1..].iter().enumerate() {
        let way = minus(*corner, first);
        let mut rest = way;
        // Twice is enough: what rounding leaves of the earlier directions is gone.
        for _ in 0..2 {
            for (j, direction) in directions[..k].iter().enumerate() {
                let part = dot(rest, *direction);
                parts[j][k] += part;
                rest = minus(rest, times(part, *direction));
            }
        }
        let size = libm::sqrt(dot(rest, rest));
        if size <= DEPENDENT * libm::sqrt(dot(way, way)) {
            return None;
        }
        directions[k] = rest.map(|x| x / size);
        parts[k][k] = size;
        along[k] = -dot(point, directions[k]);
        point = minus(point, times(-along[k], directions[k]));
    }
    let mut shares = [0.0; 3];
    for k in (0..ways).rev() {
        let others: f64 = (k + 1..ways).map(|j| parts[k][j] * shares[j]).sum();
        shares[k] = (along[k] - others) / parts[k][k];
    }
    let within = shares[..ways].iter().all(|s| *s >= 0.0) && shares[..ways].iter().sum::<f64>() <= 1.0;
    Some(Nearest { distance: libm::sqrt(dot(point, point)), within })
}
