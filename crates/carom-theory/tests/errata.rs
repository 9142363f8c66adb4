//! Formulas on simultaneous collisions as printed (Polukoshko, Viba and others), beside the right ones, at an example where they differ.
//!
//! C: the cylinder's, P: the prism's, R: the rod's, in the order of print.

use carom_theory::rocking::{Cylinder, Prism, Strike, SupportedRod, Tangential};

/// Half a unit of the sixth decimal: as the examples are printed.
const PRINTED: f64 = 5e-7;
const ROUNDING: f64 = 1e-13;

fn near(ours: f64, expected: f64, within: f64, what: &str) {
    assert!((ours - expected).abs() <= within, "{what}: {ours} is not {expected}");
}

/// A cylinder with m = a = 1.
fn cylinder(b: f64, f: f64, degrees: f64) -> Cylinder {
    Cylinder { mass: 1.0, radius: 1.0, inertia_ratio: b, friction: f, half_angle: degrees.to_radians() }
}

/// sin 2γ, cos 2γ, tan γ.
fn angles(c: &Cylinder) -> (f64, f64, f64) {
    let (s, cos) = libm::sincos(2.0 * c.half_angle);
    (s, cos, libm::tan(c.half_angle))
}

fn tangential(strike: &Strike) -> [f64; 2] {
    let Tangential::Each(each) = strike.tangential else { panic!("determined: {strike:?}") };
    each
}

/// Slip at A and K in units a = 1.
fn slips(c: &Cylinder, strike: &Strike) -> [f64; 2] {
    let (s, cos, _) = angles(c);
    let [x, y] = strike.velocity;
    [x - strike.roll_rate, cos * x + s * y - strike.roll_rate]
}

fn plastic(c: &Cylinder) -> (&'static str, Strike) {
    let (state, strike) = c.strike(1.0).expect("in the domain");
    (state.label(), strike)
}

fn elastic(c: &Cylinder, restitution: f64) -> (&'static str, Strike) {
    let (end, strike) = c.elastic_strike(1.0, restitution).expect("in the domain");
    (end.label(), strike)
}

#[test]
fn c3_the_third_row_is_the_fourth_with_the_factor_of_an_impulse() {
    let c = Cylinder { mass: 2.0, radius: 0.5, ..cylinder(1.0, 0.3, 60.0) };
    let (s, cos, tau) = angles(&c);
    let (b, f, rate) = (1.0, 0.3, 3.0);
    let (_, strike) = c.strike(rate).expect("in the domain");
    let cone = 1.0 + f * f;
    let row_3 = 2.0 * rate * 0.5 * (-f + f * cos + f * f * s + b * s * cone) / (b * s * cone);
    let row_4 = rate * (1.0 - f * (tau - f) / (b * cone));
    near(strike.roll_rate, row_4, ROUNDING, "row 4 is the roll rate");
    near(row_3, 2.0 * 0.5 * row_4, ROUNDING, "row 3 is m a times it");
    for impulse in strike.normal.into_iter().chain(tangential(&strike)) {
        assert!((row_3 - impulse).abs() > 0.1, "and no impulse of this strike: {row_3} {strike:?}");
    }
}

#[test]
fn c5_the_fifth_row_is_the_moment_of_inertia_m_a_a_b() {
    let c = Cylinder { mass: 2.0, radius: 0.5, ..cylinder(0.4, 0.2, 60.0) };
    let (_, strike) = c.strike(3.0).expect("in the domain");
    let torque = 0.5 * tangential(&strike).iter().sum::<f64>();
    let slowed = 3.0 - strike.roll_rate;
    near(2.0 * 0.5 * 0.5 * 0.4 * slowed, torque, ROUNDING, "J = m a² b balances the spin");
    assert!((2.0 * 0.5 * 0.4 * slowed - torque).abs() > 0.1, "m a b, the letters that are legible, does not");
}

#[test]
fn c7_four_states_are_not_all_where_b_is_below_one() {
    let c = cylinder(0.5, 0.8, 62.0);
    let (s, cos, tau) = angles(&c);
    assert!(cos + 0.8 * s > 0.0, "by the printed test A separates at the beginning");
    assert!(tau <= 0.8 * 1.5 / 0.5, "and K sticks: state 1");
    let rate = (0.5 + cos) / 1.5;
    assert!(rate * s < 0.0, "but then A sinks in: v_nA = {}", rate * s);
    let (state, strike) = plastic(&c);
    assert_eq!(
        (state, strike.velocity, strike.roll_rate),
        ("4r", [0.0, 0.0], 0.0),
        "A closes again, it stops"
    );
    let (state, strike) = plastic(&cylinder(0.5, 0.8, 66.0));
    assert!(state == "4s" && tangential(&strike)[0] < 0.0, "beyond, A slips forward: {strike:?}");
}

#[test]
fn c8_a_slip_may_stop_or_reverse_in_the_second_phase() {
    let c = cylinder(1.0, 0.3, 40.0);
    let before = slips(&c, &plastic(&c).1)[1];
    let (end, strike) = elastic(&c, 0.5);
    assert!(end == "5b" && before < -0.1, "K slips still after compression: {before}");
    near(slips(&c, &strike)[1], 0.0, ROUNDING, "and sticks in the end");
    let c = cylinder(1.0, 0.3, 60.0);
    let (end, strike) = elastic(&c, 0.9);
    let [_, reversed] = slips(&c, &strike);
    assert_eq!(end, "6b");
    near(slips(&c, &Strike { velocity: [1.0, 0.0], roll_rate: 1.0, ..strike })[1], -1.5, ROUNDING, "before");
    near(reversed, 0.040_522, PRINTED, "the slip at K reverses");
}

#[test]
fn c9_free_motion_after_state_1_may_sink_into_a() {
    let c = cylinder(1.0, 1.0, 60.0);
    let (s, cos, _) = angles(&c);
    let (_, first) = plastic(&c);
    let printed = first.velocity[1] + 0.8 * s * cos;
    near(printed, s * (0.25 - 0.4), ROUNDING, "with the impulse of K only");
    near(printed, -0.129_904, PRINTED, "A would sink in");
    let (end, strike) = elastic(&c, 0.8);
    assert_eq!(end, "5r", "A closes again");
    near(strike.velocity[1], 0.0, ROUNDING, "and stays");
}

#[test]
fn c10_rotation_about_a_after_state_3_slides() {
    let c = cylinder(1.0, 0.3, 60.0);
    let (state, first) = plastic(&c);
    let (end, strike) = elastic(&c, 0.5);
    assert_eq!((state, end), ("3", "6a"));
    let [slip, _] = slips(&c, &strike);
    near(slip, -1.5 * first.roll_rate, ROUNDING, "v_tA = −(1 + R) ω₁");
    near(slip, -0.908_786, PRINTED, "not zero, as printed");
}

#[test]
fn c11_rotation_about_a_after_state_4_does_not_occur() {
    // As printed it would turn back with −R ω₀.
    let (end, strike) = elastic(&cylinder(1.0, 0.3, 80.0), 0.5);
    assert_eq!((end, strike.velocity, strike.roll_rate), ("7jam", [0.0, 0.0], 0.0), "wedged: f tan γ > 1");
    let c = cylinder(0.5, 0.45, 64.0);
    let (end, strike) = elastic(&c, 0.5);
    assert_eq!(end, "7s");
    near(strike.roll_rate, 0.013_247, PRINTED, "it turns on, forward");
    near(slips(&c, &strike)[0], -0.050_049, PRINTED, "and slides at A");
    // Turning back about A, K slips forward. The balance then needs f tan γ < 1, and the cone of A f tan γ ≥ 1.
    for f in [0.1, 0.3, 0.5, 0.9, 1.5] {
        for tau in [0.3, 0.9, 1.1, 2.0, 9.0] {
            let turns_back = 1.0 - f * tau > 0.0;
            let within_cone = b_of_cone(0.5, f, tau) >= 0.0;
            assert!(!(turns_back && within_cone), "f {f}, tan γ {tau}");
        }
    }
}

/// b f τ² − (b − (1+b)f²)τ − (1+b)f: not negative where A can hold without slip while K slips forward.
fn b_of_cone(b: f64, f: f64, tau: f64) -> f64 {
    b * f * tau * tau - (b - (1.0 + b) * f * f) * tau - (1.0 + b) * f
}

fn prism_strike(prism: &Prism) -> (u8, Strike) {
    let (state, strike) = prism.strike(1.0).expect("in the domain");
    (state.number(), strike)
}

#[test]
fn p1_the_printed_impulses_belong_to_the_stop_without_sliding() {
    let printed = |p: &Prism| {
        let (d, h) = (p.to_centre, p.height);
        [(d * d - h * h - p.inertia) / (2.0 * d), (p.inertia + d * d + h * h) / (2.0 * d)]
    };
    let rough = Prism::regular(3, 1.0, 1.0, 0.6);
    let (state, strike) = prism_strike(&rough);
    assert_eq!(state, 1);
    let smooth = Prism::regular(3, 1.0, 1.0, 0.2);
    let (sliding_state, sliding) = prism_strike(&smooth);
    assert_eq!(sliding_state, 2);
    let half_moment = smooth.inertia / smooth.to_centre;
    let right = [-1.0, 1.0].map(|sign| 0.5 * (smooth.to_centre + sign * (0.2 * smooth.height + half_moment)));
    for i in 0..2 {
        near(strike.normal[i], printed(&rough)[i], ROUNDING, "not sliding");
        near(sliding.normal[i], right[i], ROUNDING, "sliding");
        near(sliding.normal[i], [0.238_675, 0.627_350][i], PRINTED, "sliding, by numbers");
        assert!((sliding.normal[i] - printed(&smooth)[i]).abs() > 0.05, "not as printed");
    }
}

#[test]
fn p2_the_hexagon_sticks_with_far_less_friction_than_printed() {
    let hexagon = |f| Prism::regular(6, 1.0, 1.0, f);
    let printed = 1.0 / libm::tan(core::f64::consts::PI / 6.0);
    near(printed, 1.732_051, PRINTED, "f ≥ 1/tan(π/n) as printed");
    near(hexagon(0.0).sticking_friction(), 0.371_154, PRINTED, "the threshold");
    let (state, strike) = prism_strike(&hexagon(0.5));
    assert_eq!(state, 3, "f = 0.5 sticks");
    near(strike.roll_rate, 0.647_059, PRINTED, "and rolls on");
    let triangle = Prism::regular(3, 1.0, 1.0, 0.0);
    let exact = 1.0 / libm::tan(core::f64::consts::PI / 3.0);
    for (f, state) in [(exact * (1.0 + 1e-12), 1), (exact * (1.0 - 1e-12), 2)] {
        assert_eq!(
            prism_strike(&Prism { friction: f, ..triangle }).0,
            state,
            "right where both edges stay: f = {f}"
        );
    }
}

#[test]
fn p3_a_sliding_square_keeps_a_too() {
    let (state, strike) = prism_strike(&Prism::regular(4, 1.0, 1.0, 0.2));
    assert_eq!((state, strike.roll_rate), (2, 0.0), "not only the triangle");
    near(strike.normal[0], 0.047_140, PRINTED, "A pushes");
    near(strike.normal[1], 0.659_966, PRINTED, "K pushes");
}

#[test]
fn p4_the_condition_for_a_to_stay_has_lost_a_minus() {
    let prism = Prism { mass: 1.0, inertia: 0.1, to_centre: 0.5, to_k: 0.5, height: 0.3, friction: 0.7 };
    // m r_A r_K cos γ_i with an obtuse angle A–C–K.
    let cosine_term = prism.height * prism.height - prism.to_centre * prism.to_k;
    assert!(
        cosine_term < 0.0 && prism.inertia > cosine_term,
        "as printed A would leave: J ≤ m r_A r_K cos γ_i"
    );
    assert!(prism.inertia <= -cosine_term, "J ≤ −m r_A r_K cos γ_i");
    let (state, strike) = prism_strike(&prism);
    assert_eq!(state, 1);
    near(strike.normal[0], 0.06, ROUNDING, "A stays");
    // Where both slide the condition is another one: J ≤ m d_A(d_K − f h).
    for (inertia, stays) in [(0.2, true), (0.25, false)] {
        let slides = Prism { inertia, friction: 0.1, ..prism };
        assert_eq!(inertia <= 0.5 * (0.5 - 0.1 * 0.3), stays, "the condition at J = {inertia}");
        assert_eq!(prism_strike(&slides).0 == 2, stays, "the strike at J = {inertia}");
    }
}

#[test]
fn p5_in_the_fifth_state_k_sticks() {
    let hexagon = Prism::regular(6, 1.0, 1.0, 0.5);
    let (state, strike) = prism_strike(&hexagon);
    assert_eq!(state, 3);
    for restitution in [0.0, 0.5, 1.0] {
        let after = strike.with_restitution(restitution);
        let slip = after.velocity[0] - hexagon.height * after.roll_rate;
        near(slip, 0.0, ROUNDING, "\"non-sliding\" is right, \"K slips\" is not");
    }
}

#[test]
fn r1_the_sine_belongs_under_the_root() {
    let rod = SupportedRod::uniform(2.0, 1.0, [0.3, 0.3]);
    let (g, alpha) = (9.81, 30f64.to_radians());
    let level = rod.release_rate(g, core::f64::consts::FRAC_PI_2);
    near(level * libm::sin(alpha), 2.9137, 5e-5, "√(2mga/(J + ma²)) sin α as printed");
    let right = rod.release_rate(g, alpha);
    near(right, 4.1205, 5e-5, "√(2mga sin α/(J + ma²))");
    near(right, (24.0 * g * 0.3 * 0.5 / (1.0 + 12.0 * 0.09)).sqrt(), ROUNDING, "for a uniform rod");
    let energy = 0.5 * (rod.inertia + 2.0 * 0.09) * right * right;
    near(energy, 2.0 * g * 0.3 * 0.5, ROUNDING, "energy is kept on the way down");
}

#[test]
fn r2_the_letters_t_and_1_are_the_length() {
    let (m, l) = (3.0, 2.0);
    let rod = SupportedRod::uniform(m, l, [0.5, 0.5]);
    near(rod.inertia, m * l * l / 12.0, ROUNDING, "J = m l²/12");
    near(rod.k(), (l * l - 3.0) / (l * l + 3.0), ROUNDING, "k has l²");
    assert!((rod.k() - (1.0 - 3.0) / (1.0 + 3.0)).abs() > 0.5, "not 1²");
}

#[test]
fn r3_the_impulse_at_a_has_twelve_a_b_minus_l_l() {
    let (a, b, l) = (0.3, 0.3, 1.0);
    let (_, strike) = SupportedRod::uniform(1.0, l, [a, b]).strike(1.0).expect("in the domain");
    let printed = (a * b - 1.0) / (12.0 * (a + b));
    assert!(printed < 0.0, "1²·a·b − 1² would pull: {printed}");
    near(strike.normal[0], (12.0 * a * b - l * l) / (12.0 * (a + b)), ROUNDING, "12ab − l²");
    near(strike.normal[0], 0.011_111, PRINTED, "it pushes");
}

#[test]
fn c1_c2_c4_c6_and_r4_are_right_as_printed() {
    for (b, f, degrees) in [(1.0, 0.3, 60.0), (0.4, 0.2, 60.0), (1.0, 0.1, 50.0)] {
        let c = cylinder(b, f, degrees);
        let (s, cos, tau) = angles(&c);
        let (state, strike) = plastic(&c);
        let [t_a, t_k] = tangential(&strike);
        let [n_a, n_k] = strike.normal;
        assert_eq!(state, "3");
        near(1.0 + t_a - s * n_k + cos * t_k, 0.0, ROUNDING, "C1: momentum along x");
        near(n_a + cos * n_k + s * t_k, 0.0, ROUNDING, "C1: momentum along y");
        near(b * (1.0 - strike.roll_rate), t_a + t_k, ROUNDING, "C1: spin");
        near(n_a, -(cos + f * s) / (s * (1.0 + f * f)), ROUNDING, "C2: S_NA");
        near(n_k, 1.0 / (s * (1.0 + f * f)), ROUNDING, "C2: S_NK");
        near(strike.roll_rate, 1.0 - f * (tau - f) / (b * (1.0 + f * f)), ROUNDING, "C4");
        assert_eq!(n_a > 0.0, 2.0 * degrees > 90.0 + libm::atan(f).to_degrees(), "C6: the sign of S_NA");
    }
    for (a, l) in [(0.288_67, 1.0), (0.288_68, 1.0), (0.5, 1.0), (0.1, 1.0)] {
        let rod = SupportedRod::uniform(1.0, l, [a, a]);
        let (_, strike) = rod.strike(1.0).expect("in the domain");
        assert_eq!(strike.normal[0] > 0.0, 12.0 * a * a > l * l, "R4: A stays where 12ab > l²");
        near(rod.k(), (l * l - 12.0 * a * a) / (l * l + 12.0 * a * a), ROUNDING, "R4: k");
        assert!(strike.normal[1] > 0.0, "R4: B does not separate");
    }
}
