//! Roll files: the strikes they lead to, against the derivation's own numbers, and what a bad file is told.

use crate::derived;
use crate::held;

use carom_scene::{
    Form, ImpactOutcome, RollEnd, RollKind, RollProblem, RollReport, RollStrikeReport, SpatialRollKind,
    SpatialRollProblem, SpatialRollReport, Word,
};
use carom_words::Words;
use derived::{CYLINDERS, ELASTIC_CYLINDERS, PRISMS, RODS};

/// Half a unit of the last digit printed, and the rounding of the motion.
const PRINTED: f64 = 0.5e-6 + 1e-9;

fn read(kind: RollKind, text: &str) -> RollProblem {
    RollProblem::parse(kind, "roll.toml", text, &[]).unwrap_or_else(|problems| panic!("{text}\n{problems}"))
}

fn report(kind: RollKind, text: &str) -> RollReport {
    let problem = read(kind, text);
    RollReport::new(&problem, &problem.follow().unwrap())
}

/// The first strike.
fn strike(kind: RollKind, text: &str) -> RollStrikeReport {
    report(kind, text).strikes.into_iter().next().unwrap_or_else(|| panic!("no strike: {text}"))
}

/// Velocity and roll rate after.
fn after(strike: &RollStrikeReport) -> [f64; 3] {
    let [x, y] = strike.velocity_m_s;
    [x, y, strike.roll_rate_rad_s]
}

fn same(found: &[f64], printed: &[f64], what: &str) {
    for (found, printed) in found.iter().zip(printed) {
        assert!((found - printed).abs() <= PRINTED, "{what}: {found} instead of {printed}");
    }
}

#[test]
fn cylinders_strike_as_derived() {
    for (b, f, gamma, state, q, p, energy, ends) in CYLINDERS {
        let text = format!(
            "radius = 1\nmass = 1\ninertia_ratio = {b}\nroll_rate = 1\nfriction = {f}\ngamma = \"{gamma} deg\"\n"
        );
        let strike = strike(RollKind::Cylinder, &text);
        assert_eq!(strike.number, Some(*state), "{text}{}", strike.state);
        same(&after(&strike), q, &text);
        let impulses: Vec<f64> =
            strike.contacts.iter().flat_map(|c| [c.normal_impulse, c.tangential_impulse]).collect();
        same(&impulses, p, &text);
        same(&[strike.energy_after / strike.energy_before], &[*energy], &text);
        assert_eq!(strike.end_states.len(), *ends, "{text}");
        let outcome = if *ends == 1 { ImpactOutcome::Unique } else { ImpactOutcome::Several };
        assert_eq!(strike.outcome, outcome, "{text}");
    }
}

#[test]
fn elastic_cylinders_strike_as_derived() {
    for ([b, f, gamma, e], state, q, path_dependent) in ELASTIC_CYLINDERS {
        let text = format!(
            "radius = 1\nmass = 1\ninertia_ratio = {b}\nroll_rate = 1\nfriction = {f}\ngamma = \"{gamma} deg\"\nrestitution = {e}\n"
        );
        let strike = strike(RollKind::Cylinder, &text);
        assert_eq!(strike.number, *state, "{text}{}", strike.state);
        same(&after(&strike), q, &text);
        assert_eq!(strike.path_dependent, *path_dependent, "{text}");
    }
}

#[test]
fn prisms_strike_as_derived() {
    for (n, f, state, q, p, slip, elastic, q_elastic) in PRISMS {
        let text = format!("sides = {n}\ncircumradius = 1\nmass = 1\nroll_rate = 1\nfriction = {f}\n");
        let plastic = strike(RollKind::Prism, &text);
        assert_eq!(plastic.number, Some(*state), "{text}{}", plastic.state);
        same(&after(&plastic), q, &text);
        let impulses: Vec<f64> = plastic.contacts.iter().map(|c| c.normal_impulse).collect();
        same(&impulses, p, &text);
        same(&[plastic.contacts[1].slip_m_s], &[*slip], &text);
        let text = format!("{text}restitution = 0.5\n");
        let bounces = strike(RollKind::Prism, &text);
        assert_eq!(bounces.number, Some(*elastic), "{text}{}", bounces.state);
        same(&after(&bounces), q_elastic, &text);
    }
}

#[test]
fn rods_strike_as_derived() {
    for ([a, b, l], restitution, variant, q, energy) in RODS {
        let text = format!(
            "length = {l}\nto_a = {a}\nto_b = {b}\nmass = 1\nroll_rate = 1\nrestitution = {restitution}\nstrikes = 1\n"
        );
        let strike = strike(RollKind::Rod, &text);
        assert_eq!(strike.number, Some(*variant), "{text}{}", strike.state);
        let [x, y, spin] = after(&strike);
        same(&[x, y, spin], &[0.0, q[0], q[1]], &text);
        same(&[strike.energy_after / strike.energy_before], &[*energy], &text);
    }
}

/// Irregular prisms, m = ω₀ = 1: d_A, d_K, h, J, f; state; velocity and roll rate after.
#[test]
fn irregular_prisms_strike_as_derived() {
    let rows: [([f64; 5], u8, [f64; 3]); 4] = [
        ([0.5, 0.5, 0.3, 0.1, 0.4], 2, [0.1, 0.0, 0.0]),
        ([0.5, 0.5, 0.3, 0.2, 0.4], 4, [0.094872, 0.012821, 0.025641]),
        ([0.7, 0.3, 0.2, 0.25, 0.6], 3, [0.042105, 0.063158, 0.210526]),
        ([0.2, 0.4, 0.8, 0.3, 0.1], 4, [0.757944, 0.220561, 0.551402]),
    ];
    for ([d_a, d_k, h, inertia, f], state, q) in rows {
        let text = format!(
            "a_to_centre = {d_a}\ncentre_to_k = {d_k}\nheight = {h}\nmass = 1\ninertia = {inertia}\nroll_rate = 1\nfriction = {f}\n"
        );
        let strike = strike(RollKind::Prism, &text);
        assert_eq!(strike.number, Some(state), "{text}{}", strike.state);
        same(&after(&strike), &q, &text);
    }
}

#[test]
fn a_released_rod_arrives_with_the_energy_of_its_fall() {
    // ω₀² = 2 m g a sin α/(Jc + m a²): the angle stands under the root.
    let text = "length = 1\nto_a = 0.3\nto_b = 0.3\nrelease = \"30 deg\"\ngravity = 9.81\n";
    let strike = strike(RollKind::Rod, text);
    let exact = (2.0f64 * 9.81 * 0.3 * 0.5 / (1.0 / 12.0 + 0.09)).sqrt();
    assert!((strike.roll_rate_before_rad_s - exact).abs() < 1e-9, "{}", strike.roll_rate_before_rad_s);
}

#[test]
fn without_friction_written_what_keeps_does_not_slide() {
    // The hexagon's edge holds from f = 0.371 on; the non-sliding law says the same.
    let free = strike(RollKind::Prism, "circumradius = 1\nroll_rate = 1\n");
    let held = strike(RollKind::Prism, "circumradius = 1\nroll_rate = 1\nfriction = 0.5\n");
    assert_eq!((free.number, free.outcome), (Some(3), ImpactOutcome::Unique));
    same(&after(&free), &after(&held), "n = 6");
    assert_eq!(free.end_states.len() + free.rejected.len(), 4, "each contact separates or sticks");
    assert!(free.rejected.iter().all(|r| !r.hypothesis.contains("slips")), "{:?}", free.rejected);
}

#[test]
fn without_friction_written_a_cylinder_goes_on_or_stops_at_one_angle() {
    // cos 2γ = −b parts the two; what goes on leaves with ω₁ = (b + cos 2γ)/(1 + b) along K and rebounds with R sin 2γ.
    for (b, gamma) in
        [(0.4, 20.0), (0.4, 56.0), (0.4, 57.5), (0.5, 59.0), (0.5, 61.0), (0.5, 85.0), (1.0, 80.0)]
    {
        let (sin, cos) = carom_num::elementary::sin_cos(2.0 * gamma * std::f64::consts::PI / 180.0);
        let rate = (b + cos) / (1.0 + b);
        for e in [0.0, 0.3] {
            // With more restitution A closes again.
            if e > 0.0 && (rate < 0.0 || rate + e * cos < 0.0) {
                continue;
            }
            let text = format!(
                "radius = 1\nmass = 1\ninertia_ratio = {b}\nroll_rate = 1\ngamma = \"{gamma} deg\"\nrestitution = {e}\n"
            );
            let strike = strike(RollKind::Cylinder, &text);
            let leaves = [rate * cos - e * sin * sin, rate * sin + e * sin * cos, rate];
            let exact = if rate > 0.0 { leaves } else { [0.0; 3] };
            let number = if rate < 0.0 {
                4
            } else if e > 0.0 {
                5
            } else {
                1
            };
            assert_eq!(strike.number, Some(number), "{text}{}", strike.state);
            let found = after(&strike);
            assert!(found.iter().zip(exact).all(|(a, b)| (a - b).abs() < 1e-12), "{text}{found:?}");
        }
    }
}

#[test]
fn a_rod_clatters_to_rest_within_a_finite_time() {
    // Every strike leaves k² of the rate at equal arms, k = (l² − 12ab)/(l² + 12b²): the time to rest is a sum of a geometric series.
    let roll = report(RollKind::Rod, "length = 1\nto_a = 0.2\nto_b = 0.2\n");
    assert_eq!(roll.end.state, RollEnd::AtRest.word());
    let k = (1.0 - 12.0 * 0.04) / (1.0 + 12.0 * 0.04);
    for strike in &roll.strikes[..4] {
        let share = strike.roll_rate_rad_s / strike.roll_rate_before_rad_s;
        assert!((share - k).abs() < 1e-9, "{share} instead of {k}");
    }
    let limit = roll.accumulations.last().expect("it is closed at its limit").to_s;
    assert!(roll.end.t_s >= limit && roll.strikes.last().unwrap().t_s < limit, "{:?}", roll.end);
}

#[test]
fn a_prism_settles_into_the_same_turn_again_and_again() {
    // Energy of a turn: (1/k² − 1) E = m g l sin(slope), k = (j + cos 60°)/(1 + j), l the side.
    let text = "circumradius = 1\nmass = 1\nroll_rate = 3\nslope = \"12 deg\"\nstrikes = 14\n";
    let roll = report(RollKind::Prism, text);
    assert_eq!((roll.strikes.len(), roll.end.state), (14, Word(RollEnd::StrikesReached)));
    let k = 11.0f64 / 17.0;
    let slope = 12.0 * std::f64::consts::PI / 180.0;
    let energy = 9.81 * carom_num::elementary::sin(slope) / (1.0 - k * k);
    let last = roll.strikes.last().unwrap();
    assert!((last.energy_before - energy).abs() < 1e-4 * energy, "{} to {energy}", last.energy_before);
}

#[test]
fn a_step_is_the_corner_at_its_central_angle() {
    // cos 2γ = 1 − h/a: a step of half the radius is γ = 30°.
    let common = "radius = 1\ninertia_ratio = 1\nroll_rate = 1\nfriction = 0.6\n";
    let step = strike(RollKind::Cylinder, &format!("{common}step_height = 0.5\n"));
    let surface = strike(RollKind::Cylinder, &format!("{common}gamma = \"30 deg\"\n"));
    assert_eq!(step.number, surface.number);
    let (step, surface) = (after(&step), after(&surface));
    assert!(step.iter().zip(surface).all(|(a, b)| (a - b).abs() < 1e-12), "{step:?} {surface:?}");
}

#[test]
fn a_cylinder_may_slide_before_it_strikes() {
    // N_K = m V sin 2γ; T = b(ω₀ − V cos 2γ)/(1 + b) as long as friction holds, and ω₁ = ω₀ − T/b.
    let text = "radius = 1\nmass = 1\ninertia_ratio = 1\nspeed = 2\nroll_rate = 0.5\nfriction = 0.9\ngamma = \"20 deg\"\n";
    let strike = strike(RollKind::Cylinder, text);
    let (sin, cos) = carom_num::elementary::sin_cos(40.0 * std::f64::consts::PI / 180.0);
    let tangential = 0.5 * (0.5 - 2.0 * cos);
    let k = &strike.contacts[1];
    same(&[k.normal_impulse, k.tangential_impulse], &[2.0 * sin, tangential], text);
    same(&[strike.roll_rate_rad_s], &[0.5 - tangential], text);
}

#[test]
fn a_lead_changes_when_it_strikes_and_nothing_else() {
    let common = "radius = 1\nroll_rate = 2\nfriction = 0.5\ngamma = \"25 deg\"\n";
    let (near, far) =
        (strike(RollKind::Cylinder, common), strike(RollKind::Cylinder, &format!("{common}distance = 3\n")));
    assert!((far.t_s - 1.5).abs() < 1e-9, "{}", far.t_s);
    same(&after(&far), &after(&near), common);
}

#[test]
fn a_result_repeats_byte_for_byte() {
    let text = || serde_json::to_string(&report(RollKind::Rod, "restitution = 0.4\n")).unwrap();
    assert_eq!(text(), text());
}

fn told(kind: RollKind, text: &str, overrides: &[&str]) -> String {
    let overrides: Vec<String> = overrides.iter().map(|o| (*o).to_owned()).collect();
    held::file(Form::Roll(kind), text);
    RollProblem::parse(kind, "roll.toml", text, &overrides).expect_err("it has problems").to_string()
}

macro_rules! says {
    ($($name:ident: $kind:ident, $text:expr, $overrides:expr;)*) => { $(
        #[test]
        fn $name() {
            insta::assert_snapshot!(told(RollKind::$kind, $text, &$overrides));
        }
    )* };
}

says! {
    bad_cylinder: Cylinder, "radius = \"-1 m\"\nfricton = 0.3\ngamma = \"95 deg\"\nstep_height = \"2 kg\"\nrestitution = 2\nstrikes = 1.5\n", [];
    bad_prism: Prism, "sides = 2\ncircumradius = 0\na_to_centre = 1\nroll_rate = \"-3 rad/s\"\ninertia = 1\ninertia_ratio = 1\nslope = 12\n", [];
    bad_rod: Rod, "length = \"1 m\"\nto_a = \"600 mm\"\nto_b = \"long\"\nroll_rate = 0\nspeed = 1\n", [];
    bad_overrides: Cylinder, "mass = 1\nradius = \"1 s\"\n", ["gamma", "mass=-2 kg", "speed = -1", "frction=0.3"];
    a_higher_step: Cylinder, "radius = 1\nstep_height = 1\n", [];
    a_scene: Rod, "[part]\nshape = \"rod\"\n", [];
    no_toml: Prism, "sides = = 3\n", ["mass=1"];
}

fn stool(text: &str) -> SpatialRollReport {
    let problem = SpatialRollProblem::parse(SpatialRollKind::Stool, "stool.toml", text, &[])
        .unwrap_or_else(|problems| panic!("{text}\n{problems}"));
    SpatialRollReport::new(&problem, &problem.follow().unwrap())
}

#[test]
fn a_stool_with_friction_slides_and_with_much_of_it_rocks_as_without() {
    // A cube that is let go on its edge.
    let edge = "axis = [1, 1, 0]\ntilt = 0.2\n";
    let (held, rough) = (stool(edge), stool(&format!("{edge}friction = 2\n")));
    let left = |report: &SpatialRollReport| {
        report.strikes[0].energy_after.unwrap() / report.strikes[0].energy_before
    };
    assert!((left(&held) - left(&rough)).abs() < 1e-9, "{} {}", left(&held), left(&rough));
    assert_eq!((held.friction, rough.friction), (None, Some(2.0)));
    let smooth = stool(&format!("{edge}friction = 0.1\nrestitution = 0.2\nlaw = \"stronge\"\n"));
    assert!((left(&smooth) - left(&held)).abs() > 1e-3, "{}", left(&smooth));
    assert!(smooth.stages.iter().any(|s| s.name == "slide") && (smooth.restitution - 0.2).abs() < 1e-15);
    assert_eq!(smooth.end.state, "at rest", "{}", smooth.end.words);
}

#[test]
fn a_stool_is_told_what_friction_does_not_allow() {
    for (text, word) in [
        ("restitution = 0.2\n", "missing: a friction"),
        ("friction = 0.3\nlaw = \"newton\"\n", "is none of poisson, stronge"),
    ] {
        let told = SpatialRollProblem::parse(SpatialRollKind::Stool, "stool.toml", text, &[]);
        let told = told.expect_err("it has a problem").to_string();
        assert!(told.contains(word), "{told}");
    }
}
