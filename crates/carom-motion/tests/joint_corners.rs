//! Where a wall or plate starts at another's end the two are one corner: the same to a body as if each went on a little behind the other.

use carom_impact::Law;
use carom_motion::planar::trace::{Impact, Trace};
use carom_motion::planar::{
    Body, Happening, MassProperties, Obstacle, Options, Pose, Recorder, Shape, State, Twist, Walker, World,
};
use carom_num::Vec2;
use carom_num::elementary::{atan2, tan};
use std::f64::consts::{PI, TAU};

/// Gravity [m/s²].
const GRAVITY: f64 = 9.81;

/// Events after which a walk has gone astray: those that come to rest take some hundreds.
const MOST_EVENTS: u64 = 3000;

/// How a walk ends, and what was seen of it.
fn walked(world: &World, start: State) -> (Happening, Trace) {
    let options = Options { most_events: MOST_EVENTS, ..Options::default() };
    let mut walker = Walker::new(world, start, vec![true; world.obstacles.len()], options).unwrap();
    let mut recorder = Recorder::default();
    loop {
        let happening = walker.advance(&mut recorder).unwrap();
        if happening != Happening::Moves {
            return (happening, recorder.into_trace());
        }
    }
}

/// Numbers from a seed (Steele, Lea, Flood 2014, SplitMix64).
struct Numbers(u64);

impl Numbers {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }
}

/// A polygon about its mass centre, of 0.3 kg.
fn body(points: &[Vec2]) -> Body {
    let drawn = MassProperties::of(&Shape::new(points.to_vec(), 0.0).unwrap());
    let corners = points.iter().map(|p| *p - drawn.centroid).collect();
    Body { shape: Shape::new(corners, 0.0).unwrap(), mass: 0.3, inertia: 0.3 * drawn.gyration_squared }
}

/// A rod, or a polygon of three to five corners, on a circle of 3 to 8 cm.
fn polygon(numbers: &mut Numbers) -> Body {
    let corners = 2 + (4.0 * numbers.unit()) as u32;
    let (radius, turn) = (numbers.within(0.03, 0.08), numbers.within(0.0, TAU));
    let each = TAU / f64::from(corners);
    let corner = |i| Vec2::at_angle(turn + each * (f64::from(i) + 0.6 * numbers.unit())) * radius;
    body(&(0..corners).map(corner).collect::<Vec<_>>())
}

/// Friction and restitution.
fn surface(numbers: &mut Numbers) -> (f64, f64) {
    let bounces = numbers.unit() < 0.6;
    (numbers.within(0.0, 0.7), if bounces { numbers.within(0.1, 0.7) } else { 0.0 })
}

/// An obstacle from the origin to a point, begun this much before the origin [m].
fn from_origin(to: Vec2, before: f64, (friction, restitution): (f64, f64)) -> Obstacle {
    Obstacle::new(to * (-before / to.norm()), to, friction, restitution)
}

/// A polygon, two obstacles from the origin, and a start.
struct Case {
    body: Body,
    ends: [Vec2; 2],
    surfaces: [(f64, f64); 2],
    start: State,
}

impl Case {
    /// A pocket into which the polygon falls.
    fn pocket(seed: u64) -> Self {
        let mut numbers = Numbers(seed);
        let body = polygon(&mut numbers);
        let right = Vec2::at_angle(numbers.within(0.1, 1.3)) * 0.6;
        let left = Vec2::at_angle(PI - numbers.within(0.1, 1.3)) * 0.6;
        let surfaces = [surface(&mut numbers), surface(&mut numbers)];
        let pose =
            Pose { centre: Vec2::new(numbers.within(-0.02, 0.02), 0.6), angle: numbers.within(0.0, TAU) };
        let twist =
            Twist { velocity: Vec2::new(numbers.within(-0.2, 0.2), 0.0), spin: numbers.within(-8.0, 8.0) };
        Self { body, ends: [left, right], surfaces, start: State { pose, twist } }
    }

    /// A plate down to the origin, on which a face slides into what is joined there: a wall, a plate that leans over it, or a ramp.
    fn end_of_slide(seed: u64) -> Self {
        let mut numbers = Numbers(seed);
        let body = polygon(&mut numbers);
        let slope = numbers.within(0.3, 1.0);
        let plate = Vec2::at_angle(PI - slope);
        let wall = Vec2::at_angle(numbers.within(-0.9 * slope, 2.4 - slope)) * 0.4;
        let smooth = (numbers.within(0.0, 0.8) * tan(slope), numbers.within(0.0, 0.7));
        let surfaces = [smooth, surface(&mut numbers)];
        let (down, up) = (body.shape.face_normal(0), body.shape.face(0).0);
        // Face 0 down on the plate, whose normal is this.
        let normal = Vec2::at_angle(0.5 * PI - slope);
        let angle = atan2(down.cross(-normal), down.dot(-normal));
        let pose = Pose { centre: plate * 0.3 + normal * down.dot(up), angle };
        let twist = Twist { velocity: plate * -numbers.within(0.0, 1.0), spin: 0.0 };
        Self { body, ends: [plate, wall], surfaces, start: State { pose, twist } }
    }

    /// The obstacles begun this much before the origin [m].
    fn walked(&self, before: [f64; 2]) -> (Happening, Trace) {
        let each = |i: usize| from_origin(self.ends[i], before[i], self.surfaces[i]);
        let obstacles = vec![each(0), each(1)];
        let world = World::of_one(Vec2::new(0.0, -GRAVITY), self.body.clone(), obstacles, Law::Poisson);
        walked(&world, self.start)
    }
}

/// By how much the velocities after the first impacts differ [m/s]; infinite where other features meet.
fn difference(a: &Trace, b: &Trace) -> f64 {
    let meets = |i: &Impact| i.contacts.iter().map(|c| (c.obstacle, c.feature)).collect::<Vec<_>>();
    let each = a.impacts.iter().zip(&b.impacts).take(COMPARED).map(|(x, y)| {
        let differs = (x.after.velocity - y.after.velocity).norm();
        if meets(x) == meets(y) { differs } else { f64::INFINITY }
    });
    each.fold(0.0, f64::max)
}

/// Impacts that are compared: of those after them rounding may decide which is the last of a series.
const COMPARED: usize = 12;
/// Largest difference of velocities after so many impacts [m/s]: each multiplies rounding, of 1e-15, by what it turns speeds into, at most some tens.
const AMPLIFIED: f64 = 1e-8;

#[test]
fn a_joint_is_the_limit_of_joints_whose_ends_go_on() {
    for (name, case) in [("pocket", Case::pocket as fn(u64) -> Case), ("slide", Case::end_of_slide)] {
        for seed in 0..40 {
            let case = case(seed);
            let (end, exact) = case.walked([0.0; 2]);
            for before in [
                [1e-7, 0.0],
                [0.0, 1e-7],
                [1e-7; 2],
                [1e-9, 0.0],
                [0.0, 1e-9],
                [1e-9; 2],
                [0.01, 0.0],
                [0.0, 0.01],
            ] {
                let (near_end, near) = case.walked(before);
                let differs = difference(&exact, &near);
                assert!(differs < AMPLIFIED, "{name} {seed}, begun {before:?} m before: {differs:e} m/s");
                assert_eq!(end, near_end, "{name} {seed}, begun {before:?} m before");
            }
        }
    }
}

/// Corner 1 of a trapezium slides down a slope of 1 in 2 into an upright wall that starts where the slope ends, with μ = 0.2 and e = 1/2 on both.
///
/// The corner comes with `u = v d`, v² = 2 g (sin θ − μ cos θ) s. While it is stopped it slips down both: the impulse is
/// `a (−1, μ) + b (n − μ d)`, and `W (…) = −u` tells a and b. In restitution the wall owes e a; the corner goes back up the slope, which
/// keeps the impulse on its line while friction has turned round on both: `a' (−1, −μ) + b' (n + μ d)` is the same impulse for a' and b'
/// of their own, so that it comes `e a / a'` times again (b' of that is more than e b: the slope keeps pressing).
#[test]
fn a_corner_that_slides_into_a_joint_strikes_wall_and_slope_at_once() {
    let points = [(0.0, 0.0), (0.1, 0.0), (0.06, 0.05), (0.0, 0.05)].map(|(x, y)| Vec2::new(x, y));
    let body = body(&points);
    let (friction, restitution) = (0.2, 0.5);
    let root = 5f64.sqrt();
    let (down, normal) = (Vec2::new(2.0, -1.0) / root, Vec2::new(1.0, 2.0) / root);
    let corner = body.shape.vertices()[1];
    let arm = down * corner.x + normal * corner.y;
    // The corner starts this far up the slope [m].
    let way = 0.25;
    let pose = Pose { centre: down * -way - arm, angle: -atan2(1.0, 2.0) };
    let start = State { pose, twist: Twist::default() };

    let speed = (2.0 * GRAVITY * (1.0 - 2.0 * friction) / root * way).sqrt();
    // How an impulse at the corner changes its velocity.
    let changed = |p: Vec2| p / body.mass + arm.turned_left() * (arm.cross(p) / body.inertia);
    // The parts of `sum` along two directions.
    let parts = |a: Vec2, b: Vec2, sum: Vec2| (sum.cross(b) / a.cross(b), a.cross(sum) / a.cross(b));
    let slips_down = [Vec2::new(-1.0, friction), normal - down * friction];
    let slips_up = [Vec2::new(-1.0, -friction), normal + down * friction];
    let (a, b) = parts(changed(slips_down[0]), changed(slips_down[1]), down * -speed);
    let stopped = slips_down[0] * a + slips_down[1] * b;
    let (again, pressed) = parts(slips_up[0], slips_up[1], stopped);
    let share = restitution * a / again;
    assert!(share * pressed > restitution * b && b > 0.0, "the slope keeps pressing");
    let impulse = stopped * (1.0 + share);
    let velocity = down * speed + impulse / body.mass;
    let spin = arm.cross(impulse) / body.inertia;

    for before in [0.0, 1e-9, 1e-7, 1e-2] {
        let floor = Obstacle::new(Vec2::new(-1.0, 0.5), Vec2::ZERO, friction, restitution);
        let wall = from_origin(Vec2::new(0.0, 0.4), before, (friction, restitution));
        let gravity = Vec2::new(0.0, -GRAVITY);
        let world = World::of_one(gravity, body.clone(), vec![floor, wall], Law::Poisson);
        let (_, trace) = walked(&world, start);
        let after = trace.impacts[0].after;
        let off = (after.velocity - velocity).norm() + (after.spin - spin).abs() * 0.1;
        assert!(off < 1e-10, "wall from {before} m below: {off:e} m/s from what was derived");
    }
}
