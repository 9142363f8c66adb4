//! Loads that hold themselves: against the condition for two contacts, and between bounds that a search over loads gives.

use crate::oracle;

use carom_theory::wedging::{PushedPoint, least_wrench, most_pressed};
use oracle::Stream;

fn random_point(stream: &mut Stream) -> PushedPoint {
    let (sin, cos) = libm::sincos(stream.within(-3.2, 3.2));
    PushedPoint {
        arm: [stream.within(-1.0, 1.0), stream.within(-1.0, 1.0)],
        normal: [cos, sin],
        friction: stream.one_of([0.0, 0.3, 1.0]) * stream.within(0.0, 2.0),
    }
}

/// Nguyen: two contacts hold a load between them where the line through them lies in both cones.
#[test]
fn two_contacts_hold_a_load_where_the_line_between_them_lies_in_both_cones() {
    let mut stream = Stream(1);
    let mut held = 0;
    for _ in 0..20_000 {
        let pair = [random_point(&mut stream), random_point(&mut stream)];
        let line = [pair[1].arm[0] - pair[0].arm[0], pair[1].arm[1] - pair[0].arm[1]];
        // How far the line lies within the cone, as a share of its length: n·l against the cone's edge.
        let inside = |point: &PushedPoint, way: f64| {
            let [x, y] = line.map(|l| way * l);
            let (along, up) =
                (point.normal[1] * x - point.normal[0] * y, point.normal[0] * x + point.normal[1] * y);
            (point.friction * up - along.abs()) / libm::hypot(x, y)
        };
        // They push the body together, or apart, as from within a ring.
        let margins = [1.0, -1.0].map(|way| inside(&pair[0], way).min(inside(&pair[1], -way)));
        let margin = margins[0].max(margins[1]);
        let z = least_wrench(&pair, stream.within(0.2, 1.0));
        if margin > 0.0 {
            held += 1;
            assert!(z < 1e-14, "{z:e} {margin:e} {pair:?}");
        } else if margin < -1e-3 {
            assert!(z > 1e-5, "{z:e} {margin:e} {pair:?}");
        }
    }
    assert!(held > 300, "{held}");
}

/// Any load is at least z; and where every edge lies beyond a plane, so does every load. Frank and Wolfe's search closes the gap.
#[test]
fn no_load_is_below_the_least_wrench_and_no_plane_beyond_it() {
    let mut stream = Stream(2);
    let mut close = 0;
    for case in 0..2000 {
        let points: Vec<PushedPoint> = (0..1 + case % 5).map(|_| random_point(&mut stream)).collect();
        let radius = stream.within(0.2, 1.0);
        let z = least_wrench(&points, radius);
        let edges: Vec<[f64; 3]> = points
            .iter()
            .flat_map(|p| {
                let tangent = [p.normal[1], -p.normal[0]];
                [p.friction, -p.friction].map(|s| {
                    let force = [0, 1].map(|k| p.normal[k] + s * tangent[k]);
                    [force[0], force[1], (p.arm[0] * force[1] - p.arm[1] * force[0]) / radius]
                })
            })
            .collect();
        let [above, below] = bounds(&edges);
        let largest = edges.iter().flatten().fold(0.0, |m: f64, w| m.max(w.abs()));
        assert!(
            z <= above + 1e-13 * largest && z >= below - 1e-13 * largest,
            "{below} {z} {above} {points:?}"
        );
        close += usize::from(above - below < 1e-3 * largest);
    }
    assert!(close > 1500, "bounds within a thousandth: {close} of 2000");
}

/// The size of some load, and of a plane that no load is before.
fn bounds(edges: &[[f64; 3]]) -> [f64; 2] {
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let mut load = edges[0];
    let [mut above, mut below] = [f64::INFINITY, 0.0_f64];
    for _ in 0..3000 {
        let size = libm::sqrt(dot(load, load));
        let nearest = edges.iter().copied().min_by(|a, b| dot(load, *a).total_cmp(&dot(load, *b)));
        let Some(nearest) = nearest.filter(|_| size > 0.0) else { return [size, below] };
        above = above.min(size);
        below = below.max(dot(load, nearest) / size);
        let way = [0, 1, 2].map(|k| nearest[k] - load[k]);
        let share = (-dot(load, way) / dot(way, way).max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
        load = [0, 1, 2].map(|k| load[k] + share * way[k]);
    }
    [above, below]
}

#[test]
fn without_contacts_nothing_presses() {
    assert_eq!(least_wrench(&[], 1.0), f64::INFINITY);
    assert_eq!(most_pressed(&[], 1.0, 5.0), 0.0);
    let grip = [-1.0, 1.0].map(|x| PushedPoint { arm: [x, 0.0], normal: [-x, 0.0], friction: 0.0 });
    assert_eq!(most_pressed(&grip, 1.0, 5.0), f64::INFINITY);
    assert_eq!(most_pressed(&grip, 1.0, 0.0), 0.0, "a body at rest takes nothing");
}
