//! One to four contacts: what an impact obeys, and what must not matter to it: the side it is seen from, the frame and the units.

use carom_impact::planar::{ContactSet6, Touch, staged};
use carom_impact::{ImpactError, Law};
use carom_num::Vec2;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

/// Differences that rounding may make, against all terms of a quantity.
const ROUNDING: f64 = 1e-12;
/// The same where stages accumulate at a limit: each adds its rounding.
const SERIES_ROUNDING: f64 = 1e-9;

/// A body and where it is touched.
#[derive(Clone, Debug)]
struct Scene {
    mass: f64,
    inertia: f64,
    velocity: Vec2,
    spin: f64,
    touches: Vec<Touch>,
}

impl Scene {
    fn random(rng: &mut Pcg64) -> Self {
        let mut touches: Vec<Touch> = (0..rng.random_range(1..5)).map(|_| touch(rng)).collect();
        if rng.random_bool(0.5) {
            let restitution = touches[0].restitution;
            touches.iter_mut().for_each(|t| t.restitution = restitution);
        }
        let inertia = rng.random_range(0.05..1.0) * [1.0, 0.1][rng.random_range(0..2)];
        let velocity = Vec2::new(rng.random_range(-1.0..1.0), rng.random_range(-1.0..1.0));
        Self { mass: 1.0, inertia, velocity, spin: rng.random_range(-2.0..2.0), touches }
    }

    fn set(&self) -> ContactSet6 {
        ContactSet6::of_free_body(self.mass, self.inertia, self.velocity, self.spin, &self.touches).unwrap()
    }

    fn resolve(&self) -> Resolved {
        let set = self.set();
        let mut stages = 0;
        let out = staged::resolve_observed(&set, Law::Poisson, &mut |_| stages += 1);
        (out.unwrap_or_else(|e| panic!("{e}: {self:?}")), stages)
    }

    /// With every vector mapped: `turn` keeps or reverses the sense of spins.
    fn mapped(&self, map: impl Fn(Vec2) -> Vec2, turn: f64) -> Self {
        let touches = self.touches.iter();
        let touches = touches.map(|t| Touch { arm: map(t.arm), normal: map(t.normal), ..*t }).collect();
        Self { velocity: map(self.velocity), spin: turn * self.spin, touches, ..*self }
    }
}

type Resolved = (staged::StagedOutcome<6>, usize);

fn touch(rng: &mut Pcg64) -> Touch {
    let normal = Vec2::at_angle(rng.random_range(-3.2..3.2));
    let arm = Vec2::new(rng.random_range(-1.0..1.0), rng.random_range(-1.0..1.0))
        - normal * rng.random_range(0.0..1.0);
    Touch { arm, normal, friction: rng.random_range(0.0..2.0), restitution: rng.random_range(0.0..1.0) }
}

/// Largest difference `u⁺ − u⁻ − W p` against the sum of its terms.
fn balance(set: &ContactSet6, out: &staged::StagedOutcome<6>) -> f64 {
    let mut worst = 0.0f64;
    for i in 0..set.count {
        for axis in 0..2 {
            let before = [set.slip[i], set.normal[i]][axis];
            let (mut sum, mut terms) = (before, before.abs());
            for j in 0..set.count {
                let b = &set.operator[i][j];
                let [to_q, to_r] = [[b.tt, b.tn], [b.nt, b.nn]][axis];
                let added = [to_q * out.impulse[j][0], to_r * out.impulse[j][1]];
                sum += added[0] + added[1];
                terms += added[0].abs() + added[1].abs();
            }
            worst = worst.max((sum - out.velocity[i][axis]).abs() / terms);
        }
    }
    worst
}

#[test]
fn impacts_keep_out_push_stay_in_the_cone_balance_and_lose_energy() {
    let mut rng = Pcg64::seed_from_u64(1);
    for _ in 0..5_000 {
        let scene = Scene::random(&mut rng);
        let (set, (out, stages)) = (scene.set(), scene.resolve());
        let tolerance = if stages > 12 { SERIES_ROUNDING } else { ROUNDING };
        for (i, t) in scene.touches.iter().enumerate() {
            let [q, r] = out.impulse[i];
            assert!(out.velocity[i][1] >= 0.0, "sinks in: {scene:?} {out:?}");
            assert!(r >= 0.0 && q.abs() <= t.friction * r * (1.0 + ROUNDING), "cone: {scene:?} {out:?}");
        }
        let off = balance(&set, &out);
        assert!(off <= tolerance, "balance {off} in {stages} stages: {scene:?} {out:?}");
        let (work, terms) = out.work.iter().flatten().fold((0.0, 0.0), |(s, t), w| (s + w, t + w.abs()));
        assert!(!out.gained_energy && work <= SERIES_ROUNDING * terms, "energy: {scene:?} {out:?}");
    }
}

/// Compares outcomes whose slips and tangential impulses differ by `sign`, speeds by `speed` and impulses by `impulse`; not those that
/// chose among several ways, nor those that rounding may send another way.
fn assert_alike(a: &Resolved, b: &Resolved, sign: f64, speed: f64, impulse: f64, scene: &Scene) -> bool {
    let ((a, stages), (b, _)) = (a, b);
    if a.branches > 1 || b.branches > 1 || a.margin.min(b.margin) < 1e-9 || *stages > 12 {
        return false;
    }
    let largest = |x: &[[f64; 2]; 6]| x.iter().flatten().fold(1e-300, |m: f64, v| m.max(v.abs()));
    for (x, y, unit) in [(&a.velocity, &b.velocity, speed), (&a.impulse, &b.impulse, impulse)] {
        let scale = largest(x).max(largest(&a.velocity));
        for i in 0..6 {
            let off = (x[i][0] - sign * y[i][0] / unit).abs().max((x[i][1] - y[i][1] / unit).abs());
            // The condition of a set of contacts may be some thousands.
            assert!(off <= 1e-8 * scale, "{off}: {scene:?}\n{a:?}\n{b:?}");
        }
    }
    true
}

#[test]
fn a_mirror_image_strikes_as_the_mirror_image() {
    let mut rng = Pcg64::seed_from_u64(2);
    let mut compared = 0;
    for _ in 0..2_000 {
        let scene = Scene::random(&mut rng);
        let mirrored = scene.mapped(|v| Vec2::new(-v.x, v.y), -1.0);
        compared += usize::from(assert_alike(&scene.resolve(), &mirrored.resolve(), -1.0, 1.0, 1.0, &scene));
    }
    assert!(compared > 1_400, "{compared}");
}

#[test]
fn the_frame_does_not_matter() {
    let mut rng = Pcg64::seed_from_u64(3);
    let mut compared = 0;
    for _ in 0..2_000 {
        let scene = Scene::random(&mut rng);
        let direction = Vec2::at_angle(rng.random_range(-3.0..3.0));
        let turned = scene.mapped(|v| v.rotated(direction.x, direction.y), 1.0);
        compared += usize::from(assert_alike(&scene.resolve(), &turned.resolve(), 1.0, 1.0, 1.0, &scene));
    }
    assert!(compared > 1_400, "{compared}");
}

#[test]
fn units_scale_out() {
    let mut rng = Pcg64::seed_from_u64(4);
    let mut compared = 0;
    for _ in 0..2_000 {
        let scene = Scene::random(&mut rng);
        // Powers of two: the digits stay the same, and so must every decision.
        let [mass, length, time] = [0; 3].map(|_| 2f64.powi(rng.random_range(-20..20)));
        let mut other = scene.clone();
        other.mass *= mass;
        other.inertia *= mass * length * length;
        other.velocity = other.velocity * (length / time);
        other.spin /= time;
        other.touches.iter_mut().for_each(|t| t.arm = t.arm * length);
        let (speed, impulse) = (length / time, mass * length / time);
        let (a, b) = (scene.resolve(), other.resolve());
        assert_eq!(a.0.velocity.map(|u| u.map(|x| x * speed)), b.0.velocity, "{scene:?}");
        compared += usize::from(assert_alike(&a, &b, 1.0, speed, impulse, &scene));
    }
    assert!(compared > 1_400, "{compared}");
}

#[test]
fn stronge_and_newton_restitute_the_one_contact_that_closes() {
    let mut rng = Pcg64::seed_from_u64(5);
    let mut newton = 0;
    for _ in 0..2_000 {
        let mut scene = Scene::random(&mut rng);
        scene.touches.truncate(2);
        let Some(second) = scene.touches.get(1) else { continue };
        // The second contact touches.
        let (_, approach) = second.velocity(scene.velocity, scene.spin);
        scene.velocity -= second.normal * approach;
        let mut set = scene.set();
        set.normal[1] = 0.0;
        if set.normal[0] >= 0.0 {
            continue;
        }
        for law in [Law::Stronge, Law::Newton] {
            let out = staged::resolve(&set, law).unwrap_or_else(|e| panic!("{e}: {law:?} {set:?}"));
            assert_eq!(out.law, law, "one contact closes");
            assert!(out.velocity[..2].iter().all(|u| u[1] >= 0.0), "{law:?} {set:?} {out:?}");
            assert!(law == Law::Newton || !out.gained_energy, "{law:?} {set:?} {out:?}");
            let aimed = -set.restitution[0] * set.normal[0];
            newton += usize::from(law == Law::Newton && (out.velocity[0][1] - aimed).abs() <= 1e-9);
        }
    }
    assert!(newton > 200, "Newton's law sets the velocity after: {newton}");
}

#[test]
fn extremes_give_numbers_and_nonsense_a_typed_error() {
    let mut rng = Pcg64::seed_from_u64(6);
    let mut given_up = 0;
    for _ in 0..2_000 {
        let mut scene = Scene::random(&mut rng);
        scene.mass = 10f64.powi(rng.random_range(-9..7));
        scene.inertia = scene.mass * 10f64.powi(rng.random_range(-6..1));
        let speed = 10f64.powi(rng.random_range(-12..4));
        scene.velocity = scene.velocity * speed;
        scene.spin *= speed;
        match staged::resolve(&scene.set(), Law::Poisson) {
            Ok(out) => {
                let all = out.velocity.iter().chain(&out.impulse).chain(&out.work).flatten();
                assert!(all.chain([&out.margin]).all(|x| !x.is_nan()), "{scene:?} {out:?}");
            }
            // J down to 1e-6 m r²: the operators of several contacts have no digit to spare.
            Err(ImpactError::Jammed | ImpactError::Circling { .. } | ImpactError::Unending { .. }) => {
                given_up += 1
            }
            Err(error) => panic!("{error}: {scene:?}"),
        }
        let mut set = scene.set();
        let bad = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY][rng.random_range(0..3)];
        match rng.random_range(0..5) {
            0 => set.slip[0] = bad,
            1 => set.normal[0] = bad,
            2 => set.friction[0] = bad,
            3 => set.restitution[0] = bad,
            _ => set.operator[0][0].tn = bad,
        }
        let refused = staged::resolve(&set, Law::Poisson);
        assert!(matches!(refused, Err(ImpactError::OutsideDomain { contact: Some(0), .. })), "{refused:?}");
    }
    assert!(given_up < 20, "{given_up} of 2000");
    let nowhere = ContactSet6::of_free_body(0.0, 1.0, Vec2::ZERO, 0.0, &[]);
    assert!(matches!(nowhere, Err(ImpactError::OutsideDomain { quantity: "mass", .. })), "{nowhere:?}");
}
