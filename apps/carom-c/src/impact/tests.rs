//! By structs as by a file, bit for bit.

use super::*;
use crate::plain::Status;
use carom::tasks::impact::ImpactStudy;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

const SEED: u64 = 20;
const IMPACTS: usize = 400;

fn random(seed: &mut Pcg64Mcg) -> (plain::ImpactProblem, Vec<Contact>) {
    let law = seed.random_range(0..3);
    // Mostly few contacts: of six every one of 4096 hypotheses is told.
    let count = [1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 4, 5, 6, 7][seed.random_range(0..14)];
    let mut any = |low: f64, high: f64| seed.random_range(low..high);
    // Round numbers among them: contacts at rest, ties, bodies that do not turn.
    let mut some = |low, high| if any(0.0, 1.0) < 0.3 { any(low, high).round() } else { any(low, high) };
    let contact = |some: &mut dyn FnMut(f64, f64) -> f64| Contact {
        point: [some(-1.0, 1.0), some(-2.0, -0.1)],
        normal: [some(-0.3, 0.3), 1.0 + some(0.0, 9.0)],
        friction: some(0.0, 1.5),
        restitution: some(0.0, 1.0),
    };
    let contacts = (0..count).map(|_| contact(&mut some)).collect();
    let body = plain::Body {
        mass: some(0.5, 3.0).max(0.5),
        inertia: some(0.5, 3.0).max(0.5),
        velocity: [some(-2.0, 2.0), some(-3.0, 0.5)],
        spin: some(-4.0, 4.0),
    };
    (plain::ImpactProblem { body, contacts: std::ptr::null(), contact_count: count, law }, contacts)
}

fn bits(numbers: &[f64]) -> Vec<u64> {
    numbers.iter().map(|number| number.to_bits()).collect()
}

#[test]
fn structs_say_what_the_command_says_of_the_same_file() {
    let mut seed = Pcg64Mcg::seed_from_u64(SEED);
    let (mut walked, mut several) = (0, 0);
    for k in 0..IMPACTS {
        let (given, contacts) = random(&mut seed);
        let text = file(&given, &contacts);
        let said = || format!("seed {SEED}, impact {k}\n{text}");
        let of_file = ImpactProblem::parse("impact.toml", &text).unwrap();
        let study = ImpactStudy::of(of_file.clone());
        let struck = Struck::of(&given, &contacts).unwrap();
        let same = ImpactProblem { places: of_file.places.clone(), ..struck.problem.clone() };
        assert_eq!(same, of_file, "{}", said());
        let result = struck.result();
        assert_eq!(result.end_state_count, study.report.end_states.len(), "{}", said());
        assert_eq!(result.walked, study.report.staged.is_some(), "{}", said());
        let states = struck.end_states();
        for (i, report) in study.report.end_states.iter().enumerate() {
            let (state, ends) = states.read(i).unwrap();
            let ours = [state.velocity[0], state.velocity[1], state.spin, ends[0].normal_impulse];
            let [x, y] = report.end.velocity_m_s.unwrap();
            let theirs = [x, y, report.end.spin_rad_s.unwrap(), report.end.contacts[0].normal_impulse];
            assert_eq!(bits(&ours), bits(&theirs), "end state {i}, {}", said());
        }
        several += usize::from(result.outcome == Outcome::Several);
        let Some(staged) = study.report.staged else { continue };
        walked += 1;
        let ours = [result.velocity[0], result.velocity[1], result.spin, result.energy_after];
        let [x, y] = staged.end.velocity_m_s.unwrap();
        let theirs = [x, y, staged.end.spin_rad_s.unwrap(), staged.end.energy_after.unwrap()];
        assert_eq!(bits(&ours), bits(&theirs), "{}", said());
        assert_eq!(result.energy_before.to_bits(), staged.end.energy_before.unwrap().to_bits(), "{}", said());
        for (ours, theirs) in struck.ends().iter().zip(&staged.end.contacts) {
            let of = |c: &ContactEnd| [c.normal_impulse, c.tangential_impulse, c.normal_velocity, c.slip];
            let report = [
                theirs.normal_impulse,
                theirs.tangential_impulse,
                theirs.normal_velocity_m_s,
                theirs.slip_m_s,
            ];
            assert_eq!(bits(&of(ours)), bits(&report), "{}", said());
            assert_eq!(ours.state, state(theirs.state.0), "{}", said());
        }
    }
    assert!(walked > IMPACTS / 2, "most impacts are walked, found {walked} of {IMPACTS}");
    assert!(several > 0, "some have several answers");
}

#[test]
fn numbers_are_refused_where_the_file_is() {
    let values = [
        0.0,
        -0.0,
        -1.0,
        0.5,
        2.0,
        1e6,
        1.1e6,
        1e31,
        1e300,
        1e-13,
        1e-31,
        5e-324,
        f64::MAX,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NAN,
    ];
    let mut seed = Pcg64Mcg::seed_from_u64(SEED);
    let mut refused = 0;
    for place in 0..11 {
        for value in values {
            let (mut given, mut contacts) = random(&mut seed);
            let (body, contact) = (&mut given.body, &mut contacts[0]);
            let [vx, vy] = &mut body.velocity;
            let ([px, py], [nx, ny]) = (&mut contact.point, &mut contact.normal);
            let (friction, restitution) = (&mut contact.friction, &mut contact.restitution);
            let all = [
                &mut body.mass,
                &mut body.inertia,
                vx,
                vy,
                &mut body.spin,
                px,
                py,
                nx,
                ny,
                friction,
                restitution,
            ];
            *all[place] = value;
            let text = file(&given, &contacts);
            let of_file = ImpactProblem::parse("impact.toml", &text);
            match Struck::of(&given, &contacts) {
                Ok(_) => assert!(of_file.is_ok(), "taken by structs alone: {text}"),
                Err(refusal) => {
                    refused += 1;
                    assert_eq!(refusal.status, Status::BadInput, "{text}\n{}", refusal.json);
                    assert!(of_file.is_err(), "refused by structs alone: {text}\n{}", refusal.json);
                }
            }
        }
    }
    assert!(refused > 60, "many of them are refused, found {refused}");
}

#[test]
fn a_refusal_tells_all_problems() {
    let (mut given, mut contacts) = random(&mut Pcg64Mcg::seed_from_u64(SEED));
    given.law = 7;
    given.body.mass = -1.0;
    given.body.spin = f64::NAN;
    contacts[0].restitution = 2.0;
    let refusal = Struck::of(&given, &contacts).err().unwrap();
    for path in ["\"law\"", "\"body.mass\"", "\"body.spin\"", "restitution\""] {
        assert!(refusal.json.contains(path), "{path} in {}", refusal.json);
    }
}

#[test]
fn the_header_has_the_limits_of_the_engine() {
    assert_eq!(plain::MOST_CONTACTS, carom_scene::MOST_PIVOTED, "contacts");
    assert_eq!(plain::MOST_WALKED, carom_impact::planar::MOST_CONTACTS, "contacts that are walked");
    for (number, law) in [plain::Law::Poisson, plain::Law::Stronge, plain::Law::Newton].iter().enumerate() {
        assert_eq!((*law as usize, super::law(LAWS[number])), (number, *law), "laws by their numbers");
    }
}
