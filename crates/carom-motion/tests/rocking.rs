//! Bodies that rock and roll over their corners, strike after strike, against the closed forms.

use carom_impact::Law;
use carom_motion::planar::trace::Trace;
use carom_motion::planar::{
    Body, Happening, Obstacle, Options, Pose, Recorder, Shape, State, Twist, Walker, World,
};
use carom_num::Vec2;
use carom_num::elementary::{cos, sin, sin_cos};
use carom_theory::rocking::{
    Pivoting, housner_ratio, rimless_wheel_ratio, rimless_wheel_speed, solid_polygon_inertia_ratio,
};

use std::f64::consts::{FRAC_PI_2, PI};

const G: f64 = 9.81;
/// The block below: J = mR²/3.
const PIVOT: Pivoting = Pivoting { mass: 3.0, inertia: 1.0, reach: 1.0, gravity: G };
/// Relative: what a strike makes of the spin, and what a swing conserves.
const SPIN: f64 = 1e-10;
/// Relative: time between strikes.
const TIME: f64 = 1e-9;
/// In √(R/g)/(1 − ratio): the walk closes a series of strikes at its limit once its times are this short.
const LIMIT: f64 = 1e-5;

fn walk(world: &World, start: State, most_impacts: usize) -> (Trace, Happening) {
    let mut walker = Walker::new(world, start, vec![true], Options::default()).unwrap();
    let mut recorder = Recorder::default();
    loop {
        let happening = walker.advance(&mut recorder).unwrap();
        if happening != Happening::Moves || recorder.trace().impacts.len() >= most_impacts {
            return (recorder.into_trace(), happening);
        }
    }
}

/// A block R = 1 m from centre to corner, α its angle, that starts from rest on its right lower corner, tilted clockwise.
fn block(alpha: f64, tilt: f64, friction: f64) -> (World, State) {
    let (half_width, half_height) = (sin(alpha), cos(alpha));
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    let shape =
        Shape::new(corners.map(|(x, y)| Vec2::new(x * half_width, y * half_height)).to_vec(), 0.0).unwrap();
    let floor = Obstacle::new(Vec2::new(-20.0, 0.0), Vec2::new(20.0, 0.0), friction, 0.0);
    let world =
        World::of_one(Vec2::new(0.0, -G), Body { shape, mass: 3.0, inertia: 1.0 }, vec![floor], Law::Poisson);
    // The corner is at the origin, the centre 1 m from it, α − tilt from the upright.
    let (s, c) = sin_cos(alpha - tilt);
    let pose = Pose { centre: Vec2::new(-s, c), angle: -tilt };
    (world, State { pose, twist: Twist::default() })
}

/// The largest of relative differences, and how far each may be.
struct Worst {
    what: &'static str,
    allowed: f64,
    found: f64,
}

impl Worst {
    fn new(what: &'static str, allowed: f64) -> Self {
        Self { what, allowed, found: 0.0 }
    }

    fn compare(&mut self, ours: f64, theory: f64, case: &str) {
        let off = (ours / theory - 1.0).abs();
        assert!(off <= self.allowed, "{} in {case}: {ours} is not {theory} by {off:e}", self.what);
        self.found = self.found.max(off);
    }
}

#[test]
#[allow(clippy::print_stdout, reason = "the worst differences are a measurement")]
fn a_block_rocks_as_housner_says() {
    let mut ratios = Worst::new("spin ratio", SPIN);
    let mut swings = Worst::new("spin at the end of a swing", SPIN);
    let mut times = Worst::new("time between strikes", TIME);
    for degrees in [10.0, 20.0, 30.0] {
        let alpha = f64::to_radians(degrees);
        let (world, start) = block(alpha, 0.6 * alpha, 1.5);
        let (trace, _) = walk(&world, start, 14);
        assert_eq!(trace.impacts.len(), 14, "α = {degrees}°");
        let mut rate = PIVOT.falling_rate(alpha, 0.6 * alpha);
        let (mut time, mut last) = (0.5 * PIVOT.swing_time(alpha, rate).unwrap(), 0.0);
        for (n, impact) in trace.impacts.iter().enumerate() {
            let case = format!("strike {n}, α = {degrees}°");
            let [before, after] = [impact.before.spin, impact.after.spin];
            // It rocks to and fro: struck on the left corner first, each time with a spin of the other sign.
            assert_eq!(before > 0.0, n % 2 == 0, "{case}");
            swings.compare(before.abs(), rate, &case);
            ratios.compare(after / before, housner_ratio(alpha), &case);
            times.compare(impact.time - last, time, &case);
            last = impact.time;
            rate = after.abs();
            time = PIVOT.swing_time(alpha, rate).unwrap();
        }
    }
    for worst in [ratios, swings, times] {
        println!("{}: {:e}", worst.what, worst.found);
    }
}

#[test]
fn a_rocking_block_comes_to_rest_at_the_limit_of_its_strikes() {
    for degrees in [20.0, 30.0] {
        let alpha = f64::to_radians(degrees);
        let (world, start) = block(alpha, 0.6 * alpha, 1.5);
        let (trace, end) = walk(&world, start, usize::MAX);
        assert_eq!(end, Happening::Rests, "α = {degrees}°");
        let mut rate = PIVOT.falling_rate(alpha, 0.6 * alpha);
        let mut limit = 0.5 * PIVOT.swing_time(alpha, rate).unwrap();
        while rate > 1e-15 {
            rate *= housner_ratio(alpha);
            limit += PIVOT.swing_time(alpha, rate).unwrap();
        }
        let rests = trace.pieces.last().unwrap().end_time;
        let allowed = LIMIT * (1.0 / G).sqrt() / (1.0 - housner_ratio(alpha));
        assert!((rests - limit).abs() < allowed, "α = {degrees}°: rests at {rests}, limit {limit}");
        assert!(!trace.accumulations.is_empty(), "the series is closed at its limit, and said to be");
    }
}

/// A solid regular polygon, circumradius 1 m, that leaves a plate of this slope, flat until then, over its front corner with this rate.
fn wheel(sides: u32, slope: f64, rate: f64) -> (World, State) {
    let half = PI / f64::from(sides);
    let corner = |i: u32| Vec2::at_angle(2.0 * half * (f64::from(i) - 0.5) - FRAC_PI_2);
    let shape = Shape::new((0..sides).map(corner).collect(), 0.0).unwrap();
    let along = Vec2::at_angle(-slope);
    let plate = Obstacle::new(along * -5.0, along * 200.0, 3.0, 0.0);
    let inertia = 2.0 * solid_polygon_inertia_ratio(sides);
    let world =
        World::of_one(Vec2::new(0.0, -G), Body { shape, mass: 2.0, inertia }, vec![plate], Law::Poisson);
    let centre = along.turned_left() * cos(half);
    let arm = centre - along * sin(half);
    let twist = Twist { velocity: arm.turned_right() * rate, spin: -rate };
    (world, State { pose: Pose { centre, angle: -slope }, twist })
}

#[test]
#[allow(clippy::print_stdout, reason = "the worst differences are a measurement")]
fn a_polygon_rolls_down_a_slope_as_mcgeers_wheel() {
    let mut ratios = Worst::new("spin ratio", SPIN);
    let mut steps = Worst::new("square of the spin, step by step", SPIN);
    let mut limits = Worst::new("spin of the fixed point", SPIN);
    for (sides, slope, strikes) in [(6, 0.25, 40), (8, 0.2, 70), (12, 0.1, 150)] {
        let inertia_ratio = solid_polygon_inertia_ratio(sides);
        let eta = rimless_wheel_ratio(sides, inertia_ratio);
        let speed = rimless_wheel_speed(sides, inertia_ratio, [1.0, G], slope).unwrap();
        // Much faster, its corner would slip or lift off at the end of a step.
        for faster in [0.9, 1.05] {
            let rate = faster * eta * speed;
            let (world, start) = wheel(sides, slope, rate);
            let (trace, _) = walk(&world, start, strikes);
            assert_eq!(trace.impacts.len(), strikes, "{sides} sides");
            let gained = (1.0 - eta * eta) * speed * speed;
            let mut square = rate * rate + gained;
            for (n, impact) in trace.impacts.iter().enumerate() {
                let case = format!("step {n} of {sides} sides from {faster}");
                let [before, after] = [impact.before.spin, impact.after.spin];
                steps.compare(before * before, square, &case);
                ratios.compare(after / before, eta, &case);
                square = after * after + gained;
            }
            limits.compare(-trace.impacts[strikes - 1].before.spin, speed, &format!("{sides} sides"));
        }
    }
    for worst in [ratios, steps, limits] {
        println!("{}: {:e}", worst.what, worst.found);
    }
}

#[test]
fn a_wheel_too_slow_for_the_next_spoke_rocks_and_stays() {
    // Just not enough to bring the centre over the front corner.
    let (sides, slope) = (8, 0.03);
    let half = PI / f64::from(sides);
    let inertia_ratio = solid_polygon_inertia_ratio(sides);
    assert!(rimless_wheel_speed(sides, inertia_ratio, [1.0, G], slope).is_err(), "no fixed point here");
    let needed = 2.0 * (G / (1.0 + inertia_ratio)).sqrt() * sin(0.5 * (half - slope));
    for (rate, steps_on) in [(0.999 * needed, false), (1.001 * needed, true)] {
        let (world, start) = wheel(sides, slope, rate);
        let (trace, end) = walk(&world, start, usize::MAX);
        assert_eq!(end, Happening::Rests, "on {slope} rad it stays in the end");
        assert_eq!(trace.impacts[0].before.spin < 0.0, steps_on, "{rate} of {needed} rad/s");
    }
}
