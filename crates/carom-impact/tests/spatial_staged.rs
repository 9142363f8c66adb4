//! Several contacts with friction in space: laws, limits and symmetries.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test fails by panicking, and says what it measured"
)]

use crate::random;

use carom_impact::Law;
use carom_impact::planar;
use carom_impact::spatial::{Contact, ContactSet, RigidBody, Touch, staged};
use carom_num::elementary::exp;
use carom_num::{Mat3, Rotation, Vec2, Vec3};
use random::numbers;

/// Walks of several stages with slips that turn: a thousand steps of rounding, and the slack that a hypothesis is allowed.
const ROUNDING: f64 = 1e-10;

/// Independent numbers in [0, 1) beyond those of one case.
fn many(case: u32) -> impl Fn(usize) -> f64 {
    let all: Vec<f64> = (0..4)
        .flat_map(|k| {
            let random = numbers(4 * case + k);
            (0..16).map(random).collect::<Vec<_>>()
        })
        .collect();
    move |k| all[k]
}

fn vector(random: &impl Fn(usize) -> f64, k: usize) -> Vec3 {
    Vec3::new(random(k), random(k + 1), random(k + 2)) * 2.0 - Vec3::new(1.0, 1.0, 1.0)
}

/// A random free body that moves.
fn random_body(random: &impl Fn(usize) -> f64) -> RigidBody {
    let [a, b] = [0.3 + random(0), 0.3 + random(1)];
    let third = (a - b).abs() + (a + b - (a - b).abs()) * (0.05 + 0.9 * random(2));
    let turned = Rotation::by(vector(random, 3) * 3.0);
    RigidBody {
        mass: 0.5 + random(9),
        inertia: turned.turn(Mat3::diagonal(a, b, third)) * 0.3,
        velocity: vector(random, 6),
        spin: vector(random, 10) * 3.0,
    }
}

/// Contacts on one plane below the body.
fn on_a_floor(random: &impl Fn(usize) -> f64, count: usize, friction: f64) -> Vec<Touch> {
    let depth = 0.2 + 0.5 * random(13);
    let touch = |i: usize| Touch {
        arm: Vec3::new(2.0 * random(16 + 4 * i) - 1.0, 2.0 * random(17 + 4 * i) - 1.0, -depth),
        normal: Vec3::Z,
        friction: friction * random(18 + 4 * i),
        restitution: random(19 + 4 * i),
    };
    (0..count).map(touch).collect()
}

/// Kinetic energy of a body after impulses less that before.
fn gained(body: &RigidBody, set: &ContactSet<4>, touches: &[Touch], impulse: &[Vec3; 4]) -> f64 {
    let after = touches
        .iter()
        .enumerate()
        .fold(*body, |b, (i, touch)| b.pushed(touch.arm, set.frame[i].transposed() * impulse[i]).unwrap());
    (after.energy() - body.energy()) / body.energy()
}

#[test]
fn one_contact_is_the_walk_of_one_contact() {
    let mut worst = 0.0_f64;
    for case in 0..3000 {
        let random = many(case);
        let mut body = random_body(&random);
        body.spin = Vec3::ZERO;
        body.velocity.z = -body.velocity.z.abs() - 0.05;
        let touches = on_a_floor(&random, 1, 1.5);
        let set = ContactSet::<4>::of_free_body(&body, &touches).unwrap();
        let one = Contact {
            operator: set.operator[0][0],
            velocity: set.velocity[0],
            friction: set.friction[0],
            restitution: set.restitution[0],
        };
        for law in [Law::Poisson, Law::Stronge, Law::Newton] {
            let (alone, out) = (one.resolve(law).unwrap(), staged::resolve(&set, law).unwrap());
            let off = (alone.velocity - out.velocity[0]).norm() / one.velocity.norm();
            worst = worst.max(off);
            assert!(off < 1e-9, "case {case} {law:?}: {alone:?} {out:?}");
        }
    }
    println!("3000 contacts under three laws: {worst:.1e}");
}

#[test]
fn energy_never_grows_and_no_contact_approaches_after() {
    let mut greatest = f64::NEG_INFINITY;
    let (mut stages, mut most, mut branches, mut refused, mut scaled) = (0, 0, 0, 0, 0);
    for case in 0..10_000 {
        let random = many(case);
        let body = random_body(&random);
        let count = 1 + case as usize % 4;
        let touches = on_a_floor(&random, count, 1.2);
        let set = ContactSet::<4>::of_free_body(&body, &touches).unwrap();
        for law in [Law::Poisson, Law::Stronge] {
            let out = match staged::resolve(&set, law) {
                Ok(out) => out,
                Err(why) => {
                    println!("case {case} {law:?} {count}: {why}");
                    refused += 1;
                    continue;
                }
            };
            stages += out.stages;
            most = most.max(out.stages);
            branches += usize::from(out.branches > 1);
            scaled += usize::from(out.restitution_scaled < 1.0);
            let gained = gained(&body, &set, &touches, &out.impulse);
            if out.impulse != [Vec3::ZERO; 4] {
                greatest = greatest.max(gained);
            }
            assert!(gained <= 1e-11, "case {case} {law:?}: {gained:e} {out:?}");
            let work = out.total_work() / body.energy();
            assert!((work - gained).abs() < ROUNDING, "case {case} {law:?}: {work:e} {gained:e}");
            let after = set.after(&out.impulse);
            for i in 0..count {
                let (u, p) = (out.velocity[i], out.impulse[i]);
                assert!(
                    u.z >= 0.0 && (after[i] - u).norm() < ROUNDING,
                    "case {case} {law:?}: {out:?} {after:?}"
                );
                let tangential = (p.x * p.x + p.y * p.y).sqrt();
                assert!(tangential <= set.friction[i] * p.z + ROUNDING, "case {case} {law:?}: {out:?}");
            }
        }
    }
    println!(
        "energy {greatest:.1e}, {stages} stages, most {most}, {branches} with branches, {refused} refused, {scaled} scaled"
    );
    assert!(refused == 0, "{refused} refused");
}

/// Two contacts of a body of the plane, with one of them touching or closing.
fn planar_set(random: &impl Fn(usize) -> f64, level: bool) -> (planar::ContactSet2, ContactSet<4>) {
    let (mass, inertia) = (0.5 + random(0), 0.05 + random(1));
    let (velocity, spin) = (Vec2::new(2.0 * random(2) - 1.0, -random(3)), 4.0 * random(4) - 2.0);
    let depth = 0.1 + 0.5 * random(5);
    let touch = |i: usize| {
        let slope = if level { 0.0 } else { 1.5 * (random(6 + i) - 0.5) };
        planar::Touch {
            arm: Vec2::new(
                (2.0 * random(8 + i) - 1.0) * 0.8,
                -depth * if level { 1.0 } else { 0.5 + random(14 + i) },
            ),
            normal: Vec2::at_angle(0.5 * std::f64::consts::PI + slope),
            friction: 1.2 * random(10 + i),
            restitution: if level { random(12 + i) } else { 0.0 },
        }
    };
    let touches = [touch(0), touch(1)];
    let set = planar::ContactSet2::of_free_body(mass, inertia, velocity, spin, &touches).unwrap();
    let third = Mat3::diagonal(0.7 * inertia, 0.7 * inertia, inertia);
    let along = |v: Vec2| Vec3::new(v.x, v.y, 0.0);
    let body = RigidBody { mass, inertia: third, velocity: along(velocity), spin: Vec3::Z * spin };
    let touches = touches.map(|t| Touch {
        arm: along(t.arm),
        normal: along(t.normal),
        friction: t.friction,
        restitution: t.restitution,
    });
    (set, ContactSet::<4>::of_free_body(&body, &touches).unwrap())
}

#[test]
fn in_a_plane_two_contacts_are_the_walk_of_the_plane() {
    let (mut worst, mut compared, mut chose, mut more, mut paradox) = (0.0_f64, 0, 0, 0, 0);
    let mut together = 0;
    for case in 0..10_000 {
        let random = many(case);
        let (mut flat, mut space) = planar_set(&random, case.is_multiple_of(2));
        // Some contacts only touch; where both do, friction may drive one in.
        let touching = [[false, true], [true, true], [false; 2], [false; 2], [false; 2]][case as usize % 5];
        for i in (0..2).filter(|i| touching[*i]) {
            flat.normal[i] = 0.0;
            space.velocity[i].z = 0.0;
            flat.friction[i] *= 4.0;
            space.friction[i] *= 4.0;
        }
        let (Ok(plane), Ok(out)) =
            (planar::staged::resolve(&flat, Law::Poisson), staged::resolve(&space, Law::Poisson))
        else {
            panic!("case {case}: {:?}", staged::resolve(&space, Law::Poisson));
        };
        if plane.branches > 1 || out.branches > 1 {
            // Where there are several ways on, those aside of the plane count as well.
            chose += 1;
            more += usize::from(out.branches > plane.branches);
            continue;
        }
        // Two contacts that rest and drive each other in are loaded together in the plane; in space one contact is loaded at a time.
        if touching == [true, true] && plane.without_approach && !out.without_approach {
            together += 1;
            continue;
        }
        compared += 1;
        paradox += usize::from(plane.without_approach);
        assert_eq!(plane.without_approach, out.without_approach, "case {case}: {plane:?} {out:?}");
        let largest = flat.slip.iter().chain(&flat.normal).fold(0.0, |m: f64, u| m.max(u.abs()));
        for i in 0..2 {
            let world = space.frame[i].transposed() * out.velocity[i];
            let n = space.frame[i].rows[2];
            let (t, [slip, normal]) = (Vec3::new(n.y, -n.x, 0.0), plane.velocity[i]);
            for off in [world.dot(t) - slip, world.dot(n) - normal, world.z] {
                worst = worst.max(off.abs() / largest);
                assert!(off.abs() < ROUNDING * largest, "case {case}: {plane:?} {out:?}");
            }
        }
    }
    println!(
        "{compared} impacts of the plane: {worst:.1e}; {paradox} without approach; {chose} had several ways on, {more} more in space; {together} drive each other in"
    );
    assert!(compared > 9000 && together < 100, "{compared}, {together} loaded together in the plane alone");
}

/// A cube of edge 0.2 m and 1 kg, and a tripod, that turn about one support strike with a second: their kinetic energies after, as fractions, of an
/// independent integration in 20, 40 and 80 small plastic impacts at both supports. It errs by the first order of its step, so its limit is
/// extrapolated.
#[test]
fn two_supports_of_a_cube_and_of_a_tripod_end_where_small_impacts_tend() {
    let third = 0.02 / 3.0;
    let cube = (
        1.0,
        Mat3::diagonal(third, third, third),
        Vec3::new(-0.139_069_480_670_103_6, -0.020_258_199_379_466_105, 0.101_238_751_987_810_93),
        Vec3::new(-0.120_568_168_235_857_76, -0.159_572_292_604_679_9, 0.0),
        Vec3::new(0.341_575_856_878_327_8, -2.609_971_720_628_026_4, 1.922_479_739_356_104),
    );
    let [xx, xy, xz, yy, yz, zz] = [
        0.040_000_708_543_23,
        -1.024_694_308e-6,
        0.000_145_790_071_189,
        0.040_001_481_911_59,
        -0.000_210_841_413_499,
        0.069_997_809_545_18,
    ];
    let inertia = Mat3 { rows: [Vec3::new(xx, xy, xz), Vec3::new(xy, yy, yz), Vec3::new(xz, yz, zz)] };
    let tripod = (
        2.0,
        inertia,
        Vec3::new(-0.248_927_072_162_745_9, -0.020_677_214_116_339_2, 0.051_066_285_951_400_09),
        Vec3::new(-0.356_159_582_406_978_15, -0.246_272_921_490_948_8, 0.0),
        Vec3::new(0.261_903_951_967_353, -2.330_520_614_578_684, 0.971_667_067_913_838_9),
    );
    let cases = [
        (cube, 1.5, [0.414_040_247, 0.414_464_905, 0.414_692_66]),
        (cube, 0.6, [0.698_679_134, 0.699_258_618, 0.699_559_18]),
        (cube, 0.3, [0.809_147_622, 0.809_331_624, 0.809_427_32]),
        (tripod, 0.8, [0.402_039_230, 0.402_423_300, 0.402_622_70]),
        (tripod, 0.4, [0.501_164_937, 0.501_334_010, 0.501_421_64]),
    ];
    for ((mass, inertia, centre, struck, spin), friction, [_, coarse, fine]) in cases {
        let body = RigidBody { mass, inertia, velocity: spin.cross(centre), spin };
        let touches = [Vec3::ZERO, struck].map(|at| Touch {
            arm: at - centre,
            normal: Vec3::Z,
            friction,
            restitution: 0.0,
        });
        let mut set = ContactSet::<4>::of_free_body(&body, &touches).unwrap();
        set.snap(1e-12);
        let out = staged::resolve(&set, Law::Poisson).unwrap();
        let kept = 1.0 + gained(&body, &set, &touches, &out.impulse);
        let limit = 2.0 * fine - coarse;
        println!(
            "friction {friction}: energy {kept:.9}, small impacts tend to {limit:.6}; demand {:.6}, branches {}",
            out.friction_demand(),
            out.branches
        );
        assert!((kept - limit).abs() < 0.3 * (fine - coarse).abs(), "{kept} {limit} {out:?}");
    }
}

/// What a spin of up to 1e-6 rad/s changes of an impulse, as a fraction of it.
const TWIST_GROWS: f64 = 2e-6;

/// A box strikes with both ends of an edge at once. But for a spin across the edge that is nearly nothing this is one contact of the plane, under every law: also where the
/// slip stops, and the ends come to nothing one a moment before the other.
#[test]
fn an_edge_that_hardly_turns_strikes_as_one_contact_of_the_plane() {
    let (mut worst, mut stopped) = (0.0_f64, 0);
    for case in 0..4000 {
        let random = many(case);
        let [a, b, c] = [0, 1, 2].map(|k| 0.1 + random(k));
        let moment = |a: f64, b: f64| (a * a + b * b) / 3.0;
        let turned = Rotation::by(Vec3::Z * (1.5 * random(3)));
        // However far it is turned this corner is below the mass centre.
        let corner = turned.apply(Vec3::new(-a, -b, 0.0));
        let arm = Vec2::new(corner.x, corner.y);
        let (velocity, spin) = (Vec2::new(2.0 * random(4) - 1.0, -random(5)), 8.0 * random(6) - 4.0);
        let (friction, restitution) = (0.1 + 0.5 * random(7), random(8));
        let touch = planar::Touch { arm, normal: Vec2::new(0.0, 1.0), friction, restitution };
        let flat = planar::ContactSet2::of_free_body(1.0, moment(a, b), velocity, spin, &[touch]).unwrap();
        if flat.normal[0] >= 0.0 {
            continue;
        }
        let body = RigidBody {
            mass: 1.0,
            inertia: turned.turn(Mat3::diagonal(moment(b, c), moment(a, c), moment(a, b))),
            velocity: Vec3::new(velocity.x, velocity.y, 0.0),
            spin: Vec3::new(0.0, exp(-14.0 - 18.0 * random(9)), spin),
        };
        let touches = [-c, c].map(|z| Touch {
            arm: Vec3::new(arm.x, arm.y, z),
            normal: Vec3::Y,
            friction,
            restitution,
        });
        let space = ContactSet::<4>::of_free_body(&body, &touches).unwrap();
        for law in [Law::Poisson, Law::Stronge] {
            let plane = planar::staged::resolve(&flat, law).unwrap();
            let out = staged::resolve(&space, law).unwrap_or_else(|error| panic!("case {case}: {error:?}"));
            let pushed = (0..2).map(|i| space.frame[i].transposed() * out.impulse[i]);
            let sum = pushed.fold(Vec3::ZERO, |sum, p| sum + p);
            let [slip, normal] = plane.impulse[0];
            let off = (sum - Vec3::new(slip, normal, 0.0)).norm() / normal;
            worst = worst.max(off);
            stopped += usize::from(plane.velocity[0][0] == 0.0);
            assert!(off < TWIST_GROWS, "case {case} {law:?}: {off:e} {plane:?} {out:?}");
        }
    }
    println!("edges that strike: {worst:.1e}, {stopped} slips stop");
    assert!(stopped > 300, "{stopped}");
}

/// The operator of the two ends of an edge of a box of 42 × 16.2 × 27.9 mm and 0.1 kg \[1/kg\], row by row of ends.
const BOX_EDGE: [[[f64; 3]; 3]; 4] = [
    [
        [56.611_300_277_440_87, -3.958_476_743_738_98, -11.684_391_281_838_513],
        [-3.958_476_743_738_978_5, 38.690_004_447_286_505, 19.260_185_207_961_64],
        [-11.684_391_281_838_513, 19.260_185_207_961_644, 24.698_695_275_272_613],
    ],
    [
        [20.248_607_653_830_028, -2.370_847_297_100_756, -1.094_986_568_382_850_1],
        [3.954_035_943_087_179, 38.344_536_682_604_364, -18.702_225_521_237_146],
        [0.539_186_542_431_925_5, 18.726_492_274_438_783, -1.834_947_462_139_919],
    ],
    [
        [20.248_607_653_830_03, 3.954_035_943_087_178_8, 0.539_186_542_431_925_3],
        [-2.370_847_297_100_757, 38.344_536_682_604_364, 18.726_492_274_438_783],
        [-1.094_986_568_382_849_2, -18.702_225_521_237_143, -1.834_947_462_139_917_3],
    ],
    [
        [57.162_550_174_031_31, 2.342_338_406_185_617_4, -13.318_564_392_653_28],
        [2.342_338_406_185_617_4, 38.138_754_550_696_13, -18.168_532_587_714_285],
        [-13.318_564_392_653_277, -18.168_532_587_714_278, 24.698_695_275_272_556],
    ],
];

/// This box at one of its last small strikes. Its edge slips so much slower than it comes down, and its two ends so nearly alike, that one end stops while the other slips by
/// 1e-16 m/s: that one turns and stops within an impulse as small. Then both stick.
#[test]
fn an_end_that_slips_by_nearly_nothing_stops_with_the_other() {
    let block = |k: usize| Mat3 { rows: BOX_EDGE[k].map(|[x, y, z]| Vec3::new(x, y, z)) };
    let set = ContactSet::<2> {
        count: 2,
        frame: [Mat3::diagonal(1.0, 1.0, 1.0); 2],
        velocity: [
            Vec3::new(9.121_086_603_757_386e-07, -3.982_352_414_721_339e-08, -1.528_734_631_743_519_3e-05),
            Vec3::new(9.121_086_602_125_647e-07, -3.982_352_414_008_906_5e-08, -1.528_734_631_736_278_5e-05),
        ],
        operator: [[block(0), block(1)], [block(2), block(3)]],
        friction: [0.34; 2],
        restitution: [0.46; 2],
    };
    for law in [Law::Poisson, Law::Stronge] {
        let out = staged::resolve(&set, law).unwrap();
        let [one, other] = out.impulse;
        assert!((one - other).norm() < 1e-9 * one.norm(), "{law:?}: {out:?}");
        let slips = out.velocity.iter().map(|u| (u.x * u.x + u.y * u.y).sqrt()).fold(0.0, f64::max);
        assert!(slips < 1e-9 * out.velocity[0].z, "{law:?}: {out:?}");
    }
}
