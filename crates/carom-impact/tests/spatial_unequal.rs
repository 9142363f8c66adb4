//! Rocking impacts of feet with unequal friction, against a search by the exact law that knows no hypotheses.
//!
//! Where three feet start to slip together the kernel looks for the motion that follows itself; the search takes rates at random and polishes them. What one
//! finds and the other does not, is missed; what the law does not allow, is not accepted.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test fails by panicking, and says what it measured"
)]

use crate::exact_law;
use crate::unequal_feet;

use carom_impact::Law;
use carom_impact::Load;
use carom_impact::spatial::{
    ContactSet, Ground, Mode, Preference, RateProblem, RigidBody, StageEvent, Touch, staged,
};
use carom_num::elementary::exp;
use carom_num::{Mat3, Vec3};
use exact_law::{EXACT, ExactLaw};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use std::f64::consts::LN_10;
use unequal_feet::{ROUNDING, first_question, on_feet, rocking, without_rounding};

/// Rates that come from curves and from polishing agree to this share.
const AGREES: f64 = 1e-8;
/// Of so many motions the search may itself miss one: else it would be no judge.
const ONE_IN: usize = 50;

/// Two feet rest, the third strikes, and all three begin to slip.
fn all_three_slip() -> ContactSet<3> {
    on_feet(
        0.730_007_626_378_885_3,
        [
            [0.154_956_049_283_156_76, 0.104_341_126_808_389_6, 0.141_985_061_422_742_95],
            [0.129_999_635_707_895_2, -0.023_280_523_307_671_32, -0.187_860_106_342_226_33],
            [0.026_022_119_363_157_754, 0.145_308_848_639_289_9, 0.0],
        ],
        0.894_643_629_243_819_5,
        &[
            [-0.729_306_557_039_194_1, 3.146_761_764_136_329, 0.528_702_981_997_356_9],
            [-1.313_524_253_579_197, -0.115_539_805_316_789_42, 0.435_665_110_683_663_37],
            [1.741_572_901_628_971_2, -0.885_886_553_640_574_2, 0.364_991_396_271_76],
        ],
    )
}

/// Two of four feet rest, the second but for a rounding error in its height's rate; the fourth rises.
fn rests_but_for_rounding() -> ContactSet<4> {
    on_feet(
        0.587_890_875_148_534_6,
        [
            [0.045_958_629_634_894_39, 0.041_616_068_846_370_216, 0.053_304_952_381_874_17],
            [4.609_160_454_252_326, 1.362_590_469_686_38, -8.142_623_127_957_451],
            [-4.601_228_400_284_824, 15.564_324_318_558_414, 0.0],
        ],
        0.296_136_238_227_605_3,
        &[
            [-0.440_909_473_271_027_9, -0.278_222_461_367_746_25, 0.424_141_991_329_005_9],
            [-0.664_799_580_551_634_6, 0.479_118_391_613_275_35, 0.544_515_119_461_711_5],
            [1.607_940_531_301_383_3, 0.298_940_120_450_731_65, 0.297_006_699_501_582_37],
            [-1.068_111_281_261_398_4, -0.429_166_950_999_842_4, 0.376_736_863_553_467_36],
        ],
    )
}

#[test]
fn three_feet_of_unequal_friction_start_to_slip_together() {
    let set = without_rounding(all_three_slip());
    let question = first_question(&set);
    let law = ExactLaw::of(&question);
    let exact = law.search(200, 198);
    assert_eq!(exact.len(), 1, "the law allows one motion");
    let answer = question.solve();
    let solution = answer.solutions[0].unwrap();
    assert!(answer.count == 1 && law.same(&solution.rates, &exact[0]), "and it is found");
    assert!(law.violation(&solution.rates) < EXACT, "{:e}", law.violation(&solution.rates));
    for i in 0..3 {
        let (p, w) = (solution.rates[i], solution.response[i]);
        let bound = set.friction[i] * p.z;
        assert!(solution.guess[i].mode == Mode::Starts && p.z > 0.0, "foot {i} slips: {:?}", solution.guess);
        let against = p.x * w.x + p.y * w.y + bound * (w.x * w.x + w.y * w.y).sqrt();
        assert!(against.abs() < EXACT * bound, "foot {i}: friction is against its slip");
    }
    // No slip turns, so the one stage is the answer of the whole impact, by the velocity with which the third foot strikes.
    let out = staged::resolve(&set, Law::Poisson).unwrap();
    for i in 0..3 {
        assert!(
            (out.impulse[i] - exact[0][i]).norm() < AGREES * exact[0][i].norm(),
            "foot {i}: {:?}",
            out.impulse[i]
        );
    }
}

#[test]
fn what_rests_but_for_rounding_rests() {
    let set = rests_but_for_rounding();
    let rounding = set.velocity[1].z;
    assert!(rounding < 0.0 && rounding > -ROUNDING, "the foot approaches by a rounding error: {rounding:e}");
    let still = without_rounding(set);
    let question = first_question(&still);
    let exact = ExactLaw::of(&question).search(200, 288);
    assert_eq!(exact.len(), 1, "the law allows one motion");
    // The four impulses are those of one straight stage.
    let energy: f64 = {
        let law = ExactLaw::of(&question);
        let after = law.response(&exact[0]);
        let work = |i: usize| {
            let p = exact[0][i];
            let mean = (still.velocity[i] + still.velocity[i] + after[i] - question.drive[i]) * 0.5;
            p.dot(mean)
        };
        (0..4).map(work).sum()
    };
    for shift in [0.0, 1e-15, -1e-15, 1e-9] {
        let mut moved = set;
        moved.velocity.iter_mut().for_each(|u| u.z += shift);
        let mut sinks = 0.0_f64;
        let out = staged::resolve_observed(&moved, Law::Poisson, Preference::MostOpen, &mut |stage| {
            sinks = sinks.min(stage.end.velocity[1].z.min(stage.end.velocity[0].z));
        });
        let out = out.unwrap();
        assert!(sinks >= -ROUNDING, "no foot that rests is driven in, {shift:e}: {sinks:e}");
        assert!(
            (out.total_work() - energy).abs() < AGREES * energy.abs(),
            "{shift:e}: {} J, {energy} J",
            out.total_work()
        );
    }
}

/// Contacts in any directions, some of which slip already, driven in by their velocities or loaded as in restitution.
fn in_any_directions(seed: u64) -> (ContactSet<3>, [[f64; 2]; 3], [Load; 3]) {
    let mut random = Pcg64::seed_from_u64(seed);
    let mut number = |low: f64, high: f64| random.random_range(low..high);
    let inertia = Mat3::diagonal(number(0.1, 0.2), number(0.1, 0.2), number(0.1, 0.2));
    let spin = Vec3::new(number(-1.0, 1.0), number(-1.0, 1.0), number(-1.0, 1.0));
    let body = RigidBody { mass: number(0.3, 1.0), inertia, velocity: -Vec3::Z, spin };
    let touches: Vec<Touch> = (0..3)
        .map(|_| Touch {
            arm: Vec3::new(number(-1.0, 1.0), number(-1.0, 1.0), number(-1.0, 0.0)),
            normal: Vec3::new(number(-0.7, 0.7), number(-0.7, 0.7), 1.0).unit().unwrap(),
            friction: exp(LN_10 * number(-1.0, 0.1)),
            restitution: 0.0,
        })
        .collect();
    let set = ContactSet::of_free_body(&body, &touches).unwrap();
    let slip = std::array::from_fn(|_| {
        if number(0.0, 1.0) < 0.75 { [0.0; 2] } else { [number(-1.0, 1.0), number(-1.0, 1.0)] }
    });
    let restitutes = number(0.0, 1.0) < 0.5;
    let load = std::array::from_fn(|_| match (restitutes, number(0.0, 1.0)) {
        (false, _) => Load::Touching(0.0),
        (true, kind) if kind < 0.15 => Load::Prescribed(number(0.1, 1.0)),
        _ => Load::Touching(number(0.1, 1.0)),
    });
    (set, slip, load)
}

/// Compares all motions; how many the search found, and how many of the kernel's it did not.
fn compare(question: &RateProblem<'_, 3>, seed: u64) -> [usize; 2] {
    let law = ExactLaw::of(question);
    let answer = question.solve();
    for solution in answer.iter() {
        let violation = law.violation(&solution.rates);
        assert!(violation < AGREES, "seed {seed}: {:?} is no solution, by {violation:e}", solution.guess);
    }
    let found = law.search(60, seed);
    for rates in &found {
        let is_known = answer.iter().any(|solution| law.same(&solution.rates, rates));
        assert!(is_known, "seed {seed}: {rates:?} is missed, {:?} is found", answer.solutions);
    }
    let left_out = answer.iter().filter(|s| !found.iter().any(|rates| law.same(&s.rates, rates)));
    [found.len(), left_out.count()]
}

fn judged(name: &str, counts: impl Iterator<Item = [usize; 2]>) {
    let [found, left_out] = counts.fold([0, 0], |sum, of| [sum[0] + of[0], sum[1] + of[1]]);
    println!("{name}: {found} motions, none missed; the search missed {left_out}");
    assert!(left_out * ONE_IN <= found, "{name}: the search misses {left_out} of {found}, it is no judge");
}

#[test]
fn no_motion_of_rocking_feet_is_missed_and_none_is_false() {
    judged(
        "rocking",
        (0..300).map(|seed| {
            let set = rocking::<3>(seed);
            compare(&first_question(&set), seed)
        }),
    );
}

#[test]
fn no_motion_of_contacts_in_any_directions_is_missed_and_none_is_false() {
    judged(
        "any directions",
        (0..300).map(|seed| {
            let (set, slip, load) = in_any_directions(seed);
            let driven = load.iter().all(|load| *load == Load::Touching(0.0));
            let drive = set.velocity.map(|u| if driven { Vec3::Z * u.z.min(0.0) } else { Vec3::ZERO });
            compare(&RateProblem { drive, slip, load, ..first_question(&set) }, seed)
        }),
    );
}

#[test]
fn rocking_feet_are_never_jammed_or_driven_in_and_lose_energy() {
    for seed in 1000..1300 {
        let set = rocking::<3>(seed);
        let out = staged::resolve_observed(&set, Law::Poisson, Preference::MostOpen, &mut |stage| {
            // The contact that is the clock of the paradox may be driven in: that is the paradox.
            let clock = match stage.ground {
                Ground::Consistent => None,
                Ground::DrivenIn(i) | Ground::FastestFirst(i) => Some(i),
            };
            for i in (0..3).filter(|&i| Some(i) != clock && stage.start.velocity[i].z >= 0.0) {
                let after = stage.end.velocity[i].z;
                assert!(after >= 0.0, "seed {seed}: foot {i} is driven in with {after:e} m/s");
            }
        });
        let out = out.unwrap_or_else(|error| panic!("seed {seed}: {error}"));
        assert!(out.total_work() < 0.0, "seed {seed}: {} J", out.total_work());
    }
}

#[test]
fn a_slip_that_stops_on_its_way_into_the_paradox_is_not_driven_in() {
    let set: ContactSet<3> = on_feet(
        0.531_693_368_979_085_8,
        [
            [0.130_495_720_069_708_33, 0.170_990_394_548_704_4, 0.103_669_216_451_972_63],
            [0.057_313_727_693_230_73, 1.206_001_268_098_572_8, -2.303_075_176_386_615_3],
            [-0.936_694_913_918_537_9, 0.824_840_505_034_377_4, 0.408_615_935_541_909_45],
        ],
        0.748_533_466_177_278_5,
        &[
            [-1.235_521_509_367_864_6, -1.370_741_926_255_888, 2.463_683_403_922_168_2],
            [0.393_220_269_003_919_93, -0.573_032_368_761_195_6, 2.275_593_664_580_455],
            [-0.431_466_712_894_730_26, -0.711_915_191_894_154_9, 0.510_671_171_172_548_3],
        ],
    );
    let mut driven_in = 0;
    staged::resolve_observed(&set, Law::Poisson, Preference::MostOpen, &mut |stage| {
        let still = |i: &usize| (stage.end.velocity[*i].x, stage.end.velocity[*i].y) == (0.0, 0.0);
        let stopped = (0..3).find(|i| matches!(stage.mode[*i], Mode::Slips | Mode::Starts) && still(i));
        if stage.ended_by == StageEvent::DrivenIn {
            driven_in += 1;
            assert_eq!(stopped, None, "what it does then is asked anew: {:?}", stage.mode);
        }
        // Where a stage of the clock follows, no hypothesis is consistent, or friction drives the contact in.
        let forced = stage.ground != Ground::Consistent;
        assert!(!forced || driven_in > 0, "one contact is loaded alone: {:?}", stage.ground);
    })
    .unwrap();
}

/// No hypothesis is consistent where the impact of a falling body starts: two of three contacts slip into their lean.
fn none_is_consistent() -> ContactSet<3> {
    let normal = Vec3::new(-0.149_951_797_729_047_04, -0.796_249_508_662_668_1, -0.586_089_735_716_542_5)
        .unit()
        .unwrap();
    let touch = |[x, y, z]: [f64; 3]| Touch {
        arm: Vec3::new(x, y, z),
        normal,
        friction: 1.411_866_303_760_657,
        restitution: 0.782_085_036_968_612_9,
    };
    let body = RigidBody {
        mass: 0.342_205_901_900_291_1,
        inertia: Mat3::diagonal(
            0.019_897_331_714_858_964,
            0.037_672_025_830_495_26,
            0.035_001_269_687_660_014,
        ),
        velocity: Vec3::new(-0.377_662_744_328_299, -0.057_772_020_481_583_364, 1.024_207_317_916_725_6),
        spin: Vec3::new(-0.585_392_049_801_314_1, -0.098_767_499_709_332_25, 0.348_607_989_809_702_1),
    };
    let arms = [
        [-0.343_276_855_877_802_93, 0.353_978_571_613_729_3, 0.414_359_526_907_635_44],
        [0.316_080_449_489_840_27, 1.297_097_381_534_911_6, -1.035_639_765_362_907_7],
        [0.125_226_063_495_064_18, 0.054_958_893_304_289_19, 0.700_734_474_299_942_7],
    ];
    ContactSet::of_free_body(&body, &arms.map(touch)).unwrap()
}

#[test]
fn a_stage_without_a_consistent_hypothesis_says_so_and_no_other_does() {
    let set = none_is_consistent();
    let question = first_question(&set);
    let found = ExactLaw::of(&question).search(2000, 63);
    assert_eq!((found.len(), question.solve().count), (0, 0), "nothing is consistent: {found:?}");
    let (mut first, mut forced) = (None, 0);
    let out = staged::resolve_observed(&set, Law::Poisson, Preference::MostOpen, &mut |stage| {
        first.get_or_insert((stage.ground, stage.load, stage.drive));
        forced += usize::from(stage.ground != Ground::Consistent);
    })
    .unwrap();
    let expected = (Ground::DrivenIn(0), question.load, question.drive);
    assert_eq!(first, Some(expected), "the first stage is the paradox's, and says what had no answer");
    assert!(out.forced == forced && forced > 0, "{} stages, {forced} seen", out.forced);
    // A walk of consistent stages has none.
    for seed in 1000..1100 {
        let set = rocking::<3>(seed);
        let (mut forced, mut before) = (0, None);
        let out = staged::resolve_observed(&set, Law::Poisson, Preference::MostOpen, &mut |stage| {
            let loaded_alone = stage.ground != Ground::Consistent;
            forced += usize::from(loaded_alone);
            if loaded_alone && before != Some(StageEvent::DrivenIn) {
                let question = stage.question(&set);
                let found = ExactLaw::of(&question).search(100, seed);
                assert!(found.is_empty(), "seed {seed}: {found:?} is consistent, yet {:?}", stage.ground);
            }
            before = Some(stage.ended_by);
        });
        assert_eq!(out.unwrap().forced, forced, "seed {seed}");
    }
}
