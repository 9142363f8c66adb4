//! What a contact is said to do is what it does: a slip goes the way it is called, and what takes an impulse is not open.

use carom_impact::planar::staged;
use carom_impact::planar::{ContactSet6, Slip, Touch, end_states};
use carom_impact::{ImpactError, Law};
use carom_num::Vec2;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

const BODIES: u32 = 20_000;
/// Slips and impulses that rounding may leave, against velocities and momenta of about 1.
const ROUNDING: f64 = 1e-9;

fn stages(set: &ContactSet6, law: Law) -> Result<Vec<staged::Stage<6>>, ImpactError> {
    let mut stages = vec![];
    staged::resolve_observed(set, law, &mut |stage| stages.push(*stage))?;
    Ok(stages)
}

fn hold_to_labels(set: &ContactSet6, stages: &[staged::Stage<6>], of: &str) {
    for stage in stages {
        for i in 0..set.count {
            let slip = 0.5 * (stage.start.velocity[i][0] + stage.end.velocity[i][0]);
            let pushed = stage.end.impulse[i][1] - stage.start.impulse[i][1];
            match stage.slip[i] {
                Slip::Forward => {
                    assert!(slip > -ROUNDING, "{of}: contact {i} slips forward with {slip}: {stage:?}")
                }
                Slip::Backward => {
                    assert!(slip < ROUNDING, "{of}: contact {i} slips backward with {slip}: {stage:?}")
                }
                Slip::Sticks => {
                    assert!(slip.abs() < ROUNDING, "{of}: contact {i} sticks at {slip}: {stage:?}")
                }
                Slip::Open => {
                    assert!(pushed < ROUNDING, "{of}: contact {i} is open and takes {pushed}: {stage:?}")
                }
            }
        }
    }
}

#[test]
fn a_slip_without_friction_is_called_by_the_way_it_goes() {
    let touch = Touch {
        arm: Vec2::new(-0.684_423_191_639_757_3, 0.009_042_108_474_508_46),
        normal: Vec2::new(0.547_594_855_620_686_4, 0.836_743_613_120_386_8),
        friction: 0.0,
        restitution: 1.0,
    };
    let velocity = Vec2::new(-0.724_185_765_587_793, -1.175_053_200_171_214_2);
    let set =
        ContactSet6::of_free_body(1.0, 0.905_505_996_662_722_2, velocity, 1.163_518_426_717_375, &[touch])
            .unwrap();
    let before = touch.velocity(velocity, 1.163_518_426_717_375).0;
    let ends = end_states::enumerate(&set, Law::Poisson);
    let after = ends.found[0].velocity[0][0];
    assert!(before * after < 0.0, "the slip turns round: {before} {after}");
    let called = ends.found[0].guess[0].slip;
    assert_eq!(called, if after > 0.0 { Slip::Forward } else { Slip::Backward }, "{after}");
    hold_to_labels(&set, &stages(&set, Law::Poisson).unwrap(), "one contact");
}

#[test]
fn rounds_that_are_passed_over_say_who_takes_the_impulse() {
    let touch = |arm: (f64, f64), normal: (f64, f64), friction, restitution| Touch {
        arm: Vec2::new(arm.0, arm.1),
        normal: Vec2::new(normal.0, normal.1),
        friction,
        restitution,
    };
    let touches = [
        touch(
            (0.725_581_973_645_804_5, 0.457_097_443_831_829_8),
            (0.286_492_990_127_765_7, -0.958_082_338_114_867_9),
            0.955_380_371_416_113_4,
            1.0,
        ),
        touch(
            (0.039_779_856_474_789_02, -0.356_906_578_561_069_1),
            (-0.075_793_374_409_431_25, 0.997_123_545_201_712_5),
            0.378_674_064_492_834_86,
            0.0,
        ),
        touch(
            (-0.361_539_368_675_610_7, -0.785_212_373_561_423),
            (-0.401_268_450_465_392_17, 0.915_960_496_233_927_7),
            0.736_662_905_839_632_3,
            0.537_568_357_079_449_4,
        ),
    ];
    let velocity = Vec2::new(-0.368_065_244_414_182_5, -0.767_083_807_959_762);
    let set =
        ContactSet6::of_free_body(1.0, 0.484_450_510_358_904_46, velocity, 0.660_076_226_169_427_5, &touches)
            .unwrap();
    let stages = stages(&set, Law::Poisson).unwrap();
    assert!(stages.len() > 12, "the load goes to and fro: {} stages", stages.len());
    hold_to_labels(&set, &stages, "three contacts");
}

#[test]
fn contacts_of_random_bodies_do_what_they_are_said_to() {
    let mut rng = Pcg64::seed_from_u64(63);
    let mut smooth = 0;
    for body in 0..BODIES {
        let touch = |rng: &mut Pcg64| {
            let normal = Vec2::at_angle(rng.random_range(-3.2..3.2));
            let arm = Vec2::new(rng.random_range(-1.0..1.0), rng.random_range(-1.0..1.0));
            let friction = [0.0, rng.random_range(0.0..2.0)][rng.random_range(0..2)];
            Touch { arm: arm - normal * 0.5, normal, friction, restitution: rng.random_range(0.0..1.0) }
        };
        let touches: Vec<Touch> = (0..rng.random_range(1..4)).map(|_| touch(&mut rng)).collect();
        let velocity = Vec2::new(rng.random_range(-1.0..1.0), rng.random_range(-1.0..1.0));
        let set = ContactSet6::of_free_body(
            1.0,
            rng.random_range(0.1..1.0),
            velocity,
            rng.random_range(-2.0..2.0),
            &touches,
        )
        .unwrap();
        if let Ok(stages) = stages(&set, Law::Poisson) {
            hold_to_labels(&set, &stages, &format!("body {body}"));
        }
        for end in end_states::enumerate(&set, Law::Newton).found {
            for i in (0..set.count).filter(|&i| set.friction[i] == 0.0 && end.impulse[i][1] > 0.0) {
                let (slip, called) = (end.velocity[i][0], end.guess[i].slip);
                let as_called = if called == Slip::Forward { slip > -ROUNDING } else { slip < ROUNDING };
                assert!(as_called, "body {body}: contact {i} is said to go {called:?} and goes with {slip}");
                smooth += 1;
            }
        }
    }
    assert!(smooth > 1000, "{smooth}");
}
