//! Roll files: the strikes they lead to, against the derivation's own numbers, and what a bad file is told.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]
#![allow(clippy::approx_constant, reason = "six printed digits are no constant")]

use carom_scene::{RollEnd, RollKind, RollProblem, RollReport, RollStrikeReport};

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

/// The strike of a cylinder without restitution, m = a = ω₀ = 1: b, f, γ [deg]; state; velocity and roll rate after; impulses (normal,
/// tangential) at A, at K; energy left; how many end states there are.
///
/// Source: derived from impulse and momentum with a contact law of its own, apart from this engine; printed to six digits.
type CylinderRow = (f64, f64, f64, u8, [f64; 3], [f64; 4], f64, usize);
#[rustfmt::skip]
const CYLINDERS: &[CylinderRow] = &[
    (1.0, 0.3, 20.0, 1, [0.676434, 0.567596, 0.883022], [0.0, 0.0, 0.642788, 0.116978], 0.779728, 1),
    (1.0, 0.3, 40.0, 2, [0.081457, 0.461964, 0.704558], [0.0, 0.0, 0.984808, 0.295442], 0.358224, 1),
    (1.0, 0.3, 60.0, 3, [0.0, 0.0, 0.605858], [0.25445, 0.076335, 1.059358, 0.317807], 0.183532, 1),
    (1.0, 0.3, 80.0, 4, [0.0, 0.0, 0.0], [1.812017, 0.350599, 2.164671, 0.649401], 0.0, 1),
    (1.0, 0.1, 5.0, 1, [0.977327, 0.172329, 0.992404], [0.0, 0.0, 0.173648, 0.007596], 0.984865, 1),
    (1.0, 0.1, 30.0, 2, [0.293301, 0.508013, 0.913397], [0.0, 0.0, 0.866025, 0.086603], 0.589199, 1),
    (1.0, 0.1, 50.0, 3, [0.0, 0.0, 0.891906], [0.075571, 0.007557, 1.005373, 0.100537], 0.397748, 1),
    (1.0, 0.1, 88.0, 4, [0.0, 0.0, 0.0], [7.350954, 0.25792, 7.420796, 0.74208], 0.0, 1),
    (1.0, 0.7, 45.0, 1, [0.0, 0.5, 0.5], [0.0, 0.0, 1.0, 0.5], 0.25, 1),
    (1.0, 0.7, 60.0, 2, [-0.053109, 0.091987, 0.393782], [0.0, 0.0, 0.866025, 0.606218], 0.083173, 2),
    (1.0, 0.7, 70.0, 3, [0.0, 0.0, 0.038098], [0.330036, 0.231025, 1.04411, 0.730877], 0.000726, 2),
    (1.0, 0.7, 75.0, 4, [0.0, 0.0, 0.0], [0.571388, 0.2249, 1.107286, 0.7751], 0.0, 1),
    (1.0, 1.0, 60.0, 1, [-0.125, 0.216506, 0.25], [0.0, 0.0, 0.866025, 0.75], 0.0625, 2),
    (1.0, 1.0, 65.0, 2, [-0.079228, 0.09442, 0.233956], [0.0, 0.0, 0.766044, 0.766044], 0.034964, 2),
    (1.0, 1.0, 70.0, 3, [0.0, 0.0, 0.126261], [0.095877, 0.095877, 0.777862, 0.777862], 0.007971, 2),
    (1.0, 1.0, 75.0, 4, [0.0, 0.0, 0.0], [0.309401, 0.154701, 0.845299, 0.845299], 0.0, 1),
    (0.5, 0.3, 30.0, 1, [0.333333, 0.57735, 0.666667], [0.0, 0.0, 0.866025, 0.166667], 0.444444, 1),
    (0.5, 0.3, 50.0, 2, [-0.021149, 0.119944, 0.409115], [0.0, 0.0, 0.984808, 0.295442], 0.065681, 1),
    (0.5, 0.3, 60.0, 3, [0.0, 0.0, 0.211715], [0.25445, 0.076335, 1.059358, 0.317807], 0.014941, 1),
    (0.5, 0.3, 70.0, 4, [0.0, 0.0, 0.0], [0.733252, 0.116238, 1.279208, 0.383762], 0.0, 1),
    (0.5, 0.8, 55.0, 1, [-0.036022, 0.098968, 0.10532], [0.0, 0.0, 0.939693, 0.44734], 0.011092, 2),
    (0.5, 0.8, 62.0, 4, [0.0, 0.0, 0.0], [0.028508, -0.022806, 0.826072, 0.522806], 0.0, 1),
    (0.5, 0.8, 63.5, 4, [0.0, 0.0, 0.0], [0.048947, -0.039158, 0.79682, 0.539158], 0.0, 1),
    (0.5, 0.8, 66.0, 4, [0.0, 0.0, 0.0], [0.081373, -0.065099, 0.749216, 0.565099], 0.0, 1),
    (0.5, 0.8, 70.0, 4, [0.0, 0.0, 0.0], [0.18375, -0.083765, 0.729706, 0.583765], 0.0, 1),
    (0.4, 0.2, 20.0, 1, [0.63803, 0.535371, 0.832889], [0.0, 0.0, 0.642788, 0.066844], 0.693704, 1),
    (0.4, 0.2, 40.0, 2, [0.064356, 0.364979, 0.507596], [0.0, 0.0, 0.984808, 0.196962], 0.171724, 1),
    (0.4, 0.2, 60.0, 3, [0.0, 0.0, 0.263437], [0.362837, 0.072567, 1.110289, 0.222058], 0.019828, 1),
    (0.4, 0.2, 75.0, 4, [0.0, 0.0, 0.0], [1.22816, 0.079342, 1.603289, 0.320658], 0.0, 1),
    (0.4, 0.6, 50.0, 1, [-0.028075, 0.159224, 0.16168], [0.0, 0.0, 0.984808, 0.335328], 0.02614, 1),
    (0.4, 0.6, 58.0, 4, [0.0, 0.0, 0.0], [0.021779, -0.013068, 0.896596, 0.413068], 0.0, 1),
    (0.4, 0.6, 62.0, 4, [0.0, 0.0, 0.0], [0.090217, -0.05413, 0.83461, 0.45413], 0.0, 1),
    (0.4, 0.6, 70.0, 4, [0.0, 0.0, 0.0], [0.312803, -0.093417, 0.822362, 0.493417], 0.0, 1),
];

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
        let outcome = if *ends == 1 { "unique" } else { "several" };
        assert_eq!(strike.outcome, outcome, "{text}");
    }
}

/// Homogeneous regular prisms of circumradius 1, m = ω₀ = 1: sides, f; without restitution the state, velocity and roll rate after, normal
/// impulses at A and K, slip at K; with restitution 0.5 the state, velocity and roll rate.
type PrismRow = (u32, f64, u8, [f64; 3], [f64; 2], f64, u8, [f64; 3]);
#[rustfmt::skip]
const PRISMS: &[PrismRow] = &[
    (3, 0.0, 2, [0.5, 0.0, 0.0], [0.288675, 0.57735], 0.5, 7, [0.5, 0.433013, -0.5]),
    (3, 0.1, 2, [0.413397, 0.0, 0.0], [0.263675, 0.60235], 0.413397, 7, [0.370096, 0.433013, -0.5]),
    (3, 0.2, 2, [0.326795, 0.0, 0.0], [0.238675, 0.62735], 0.326795, 7, [0.240192, 0.433013, -0.5]),
    (3, 0.3, 2, [0.240192, 0.0, 0.0], [0.213675, 0.65235], 0.240192, 7, [0.110289, 0.433013, -0.5]),
    (3, 0.5, 2, [0.066987, 0.0, 0.0], [0.163675, 0.70235], 0.066987, 7, [-0.149519, 0.433013, -0.5]),
    (3, 0.916, 1, [0.0, 0.0, 0.0], [0.144338, 0.721688], 0.0, 8, [-0.25, 0.433013, -0.5]),
    (4, 0.0, 2, [0.707107, 0.0, 0.0], [0.117851, 0.589256], 0.707107, 7, [0.707107, 0.353553, -0.5]),
    (4, 0.1, 2, [0.636396, 0.0, 0.0], [0.082496, 0.624611], 0.636396, 7, [0.601041, 0.353553, -0.5]),
    (4, 0.2, 2, [0.565685, 0.0, 0.0], [0.04714, 0.659966], 0.565685, 7, [0.494975, 0.353553, -0.5]),
    (4, 0.3, 2, [0.494975, 0.0, 0.0], [0.011785, 0.695322], 0.494975, 7, [0.388909, 0.353553, -0.5]),
    (4, 0.5, 4, [0.303046, 0.101015, 0.142857], [0.0, 0.808122], 0.202031, 6, [0.101015, 0.505076, -0.285714]),
    (4, 0.65, 3, [0.176777, 0.176777, 0.25], [0.0, 0.883883], 0.0, 5, [-0.088388, 0.618718, -0.125]),
    (5, 0.0, 4, [0.809017, 0.031666, 0.053873], [0.0, 0.619451], 0.765433, 6, [0.809017, 0.341391, -0.419191]),
    (5, 0.1, 4, [0.742758, 0.074808, 0.127271], [0.0, 0.662593], 0.639793, 6, [0.709628, 0.406105, -0.309093]),
    (5, 0.2, 4, [0.666578, 0.12441, 0.211659], [0.0, 0.712195], 0.495342, 6, [0.595358, 0.480507, -0.182512]),
    (5, 0.3, 4, [0.57807, 0.182039, 0.309703], [0.0, 0.769824], 0.327514, 6, [0.462596, 0.566951, -0.035445]),
    (5, 0.5, 3, [0.405347, 0.294502, 0.501036], [0.0, 0.882287], 0.0, 5, [0.203512, 0.735645, 0.251554]),
    (5, 0.508, 3, [0.405347, 0.294502, 0.501036], [0.0, 0.882287], 0.0, 5, [0.203512, 0.735645, 0.251554]),
    (6, 0.0, 4, [0.866025, 0.125, 0.25], [0.0, 0.625], 0.649519, 6, [0.866025, 0.4375, -0.125]),
    (6, 0.1, 4, [0.799184, 0.168415, 0.33683], [0.0, 0.668415], 0.507481, 6, [0.765763, 0.502622, 0.005244]),
    (6, 0.2, 4, [0.722363, 0.218311, 0.436623], [0.0, 0.718311], 0.344237, 6, [0.650532, 0.577467, 0.154934]),
    (6, 0.3, 4, [0.633148, 0.276258, 0.552517], [0.0, 0.776258], 0.154654, 6, [0.516709, 0.664388, 0.328775]),
    (6, 0.421, 3, [0.560369, 0.323529, 0.647059], [0.0, 0.823529], 0.0, 5, [0.407541, 0.735294, 0.470588]),
    (6, 0.5, 3, [0.560369, 0.323529, 0.647059], [0.0, 0.823529], 0.0, 5, [0.407541, 0.735294, 0.470588]),
    (7, 0.0, 4, [0.900969, 0.172715, 0.398069], [0.0, 0.606599], 0.542322, 6, [0.900969, 0.476015, 0.097103]),
    (7, 0.1, 4, [0.836265, 0.213153, 0.491267], [0.0, 0.647036], 0.393649, 6, [0.803913, 0.536671, 0.2369]),
    (7, 0.2, 4, [0.762319, 0.259366, 0.597779], [0.0, 0.69325], 0.223739, 6, [0.692994, 0.605992, 0.396668]),
    (7, 0.3, 4, [0.676997, 0.312689, 0.720675], [0.0, 0.746573], 0.027691, 6, [0.565011, 0.685976, 0.581013]),
    (7, 0.363, 3, [0.664946, 0.320221, 0.738034], [0.0, 0.754105], 0.0, 5, [0.546934, 0.697273, 0.607051]),
    (7, 0.5, 3, [0.664946, 0.320221, 0.738034], [0.0, 0.754105], 0.0, 5, [0.546934, 0.697273, 0.607051]),
    (8, 0.0, 4, [0.92388, 0.195134, 0.50991], [0.0, 0.577817], 0.452784, 6, [0.92388, 0.484043, 0.264864]),
    (8, 0.1, 4, [0.862465, 0.231467, 0.604851], [0.0, 0.61415], 0.303655, 6, [0.831757, 0.538542, 0.407277]),
    (8, 0.2, 4, [0.792808, 0.272675, 0.712534], [0.0, 0.655358], 0.134513, 6, [0.727272, 0.600354, 0.568801]),
    (8, 0.3, 3, [0.737413, 0.305446, 0.79817], [0.0, 0.68813], 0.0, 5, [0.644179, 0.649511, 0.697254]),
    (8, 0.321, 3, [0.737413, 0.305446, 0.79817], [0.0, 0.68813], 0.0, 5, [0.644179, 0.649511, 0.697254]),
    (8, 0.5, 3, [0.737413, 0.305446, 0.79817], [0.0, 0.68813], 0.0, 5, [0.644179, 0.649511, 0.697254]),
    (9, 0.0, 4, [0.939693, 0.203578, 0.595222], [0.0, 0.545598], 0.380367, 6, [0.939693, 0.476377, 0.392833]),
    (9, 0.1, 4, [0.88192, 0.235703, 0.689149], [0.0, 0.577723], 0.234332, 6, [0.853034, 0.524564, 0.533723]),
    (9, 0.2, 4, [0.816919, 0.271847, 0.794828], [0.0, 0.613867], 0.070025, 6, [0.755532, 0.578781, 0.692242]),
    (9, 0.289, 3, [0.789217, 0.287251, 0.839867], [0.0, 0.629272], 0.0, 5, [0.713979, 0.601887, 0.7598]),
    (9, 0.3, 3, [0.789217, 0.287251, 0.839867], [0.0, 0.629272], 0.0, 5, [0.713979, 0.601887, 0.7598]),
    (9, 0.5, 3, [0.789217, 0.287251, 0.839867], [0.0, 0.629272], 0.0, 5, [0.713979, 0.601887, 0.7598]),
    (10, 0.0, 4, [0.951057, 0.204314, 0.661174], [0.0, 0.513331], 0.322243, 6, [0.951057, 0.460979, 0.491761]),
    (10, 0.1, 4, [0.8969, 0.232551, 0.752552], [0.0, 0.541568], 0.18118, 6, [0.869821, 0.503336, 0.628828]),
    (10, 0.2, 4, [0.836438, 0.264076, 0.854568], [0.0, 0.573093], 0.023695, 6, [0.779129, 0.550623, 0.781852]),
    (10, 0.264, 3, [0.827341, 0.268819, 0.869918], [0.0, 0.577836], 0.0, 5, [0.765483, 0.557737, 0.804876]),
    (10, 0.3, 3, [0.827341, 0.268819, 0.869918], [0.0, 0.577836], 0.0, 5, [0.765483, 0.557737, 0.804876]),
    (10, 0.5, 3, [0.827341, 0.268819, 0.869918], [0.0, 0.577836], 0.0, 5, [0.765483, 0.557737, 0.804876]),
    (11, 0.0, 4, [0.959493, 0.200845, 0.712892], [0.0, 0.482577], 0.275478, 6, [0.959493, 0.442134, 0.569338]),
    (11, 0.1, 4, [0.908755, 0.225651, 0.80094], [0.0, 0.507383], 0.140258, 6, [0.883385, 0.479343, 0.70141]),
    (11, 0.2, 3, [0.856126, 0.251381, 0.892269], [0.0, 0.533114], 0.0, 5, [0.804442, 0.517938, 0.838403]),
    (11, 0.244, 3, [0.856126, 0.251381, 0.892269], [0.0, 0.533114], 0.0, 5, [0.804442, 0.517938, 0.838403]),
    (11, 0.3, 3, [0.856126, 0.251381, 0.892269], [0.0, 0.533114], 0.0, 5, [0.804442, 0.517938, 0.838403]),
    (11, 0.5, 3, [0.856126, 0.251381, 0.892269], [0.0, 0.533114], 0.0, 5, [0.804442, 0.517938, 0.838403]),
    (12, 0.0, 4, [0.965926, 0.195155, 0.754021], [0.0, 0.453974], 0.237598, 6, [0.965926, 0.422142, 0.631031]),
    (12, 0.1, 4, [0.918344, 0.216995, 0.838404], [0.0, 0.475814], 0.108508, 6, [0.894554, 0.454902, 0.757606]),
    (12, 0.2, 3, [0.878349, 0.235353, 0.909334], [0.0, 0.494172], 0.0, 5, [0.834561, 0.482439, 0.864001]),
    (12, 0.227, 3, [0.878349, 0.235353, 0.909334], [0.0, 0.494172], 0.0, 5, [0.834561, 0.482439, 0.864001]),
    (12, 0.3, 3, [0.878349, 0.235353, 0.909334], [0.0, 0.494172], 0.0, 5, [0.834561, 0.482439, 0.864001]),
    (12, 0.5, 3, [0.878349, 0.235353, 0.909334], [0.0, 0.494172], 0.0, 5, [0.834561, 0.482439, 0.864001]),
];

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

/// Rods, m = ω₀ = 1: distances to A and B, length; restitution, variant; vertical velocity and roll rate after; energy left.
type RodRow = ([f64; 3], f64, u8, [f64; 2], f64);
#[rustfmt::skip]
const RODS: &[RodRow] = &[
    ([0.5, 0.5, 2.0], 0.0, 2, [0.071429, 0.142857], 0.020408),
    ([0.5, 0.5, 2.0], 0.3, 4, [0.242857, -0.114286], 0.108571),
    ([0.5, 0.5, 2.0], 0.6, 4, [0.414286, -0.371429], 0.373061),
    ([0.5, 0.5, 2.0], 1.0, 4, [0.642857, -0.714286], 1.0),
    ([0.25, 0.25, 1.0], 0.0, 2, [0.035714, 0.142857], 0.020408),
    ([0.25, 0.25, 1.0], 0.3, 4, [0.121429, -0.114286], 0.108571),
    ([0.25, 0.25, 1.0], 0.6, 4, [0.207143, -0.371429], 0.373061),
    ([0.25, 0.25, 1.0], 1.0, 4, [0.321429, -0.714286], 1.0),
    ([0.2, 0.3, 1.0], 0.0, 2, [0.040385, 0.134615], 0.025468),
    ([0.2, 0.3, 1.0], 0.3, 4, [0.1125, -0.125], 0.113176),
    ([0.2, 0.3, 1.0], 0.6, 4, [0.184615, -0.384615], 0.376299),
    ([0.2, 0.3, 1.0], 1.0, 4, [0.280769, -0.730769], 1.0),
    ([0.3, 0.3, 1.0], 0.0, 1, [0.0, 0.0], 0.0),
    ([0.3, 0.3, 1.0], 0.3, 3, [0.09, -0.3], 0.09),
    ([0.3, 0.3, 1.0], 0.6, 3, [0.18, -0.6], 0.36),
    ([0.3, 0.3, 1.0], 1.0, 3, [0.3, -1.0], 1.0),
    ([0.4, 0.4, 1.0], 0.0, 1, [0.0, 0.0], 0.0),
    ([0.4, 0.4, 1.0], 0.3, 3, [0.12, -0.3], 0.09),
    ([0.4, 0.4, 1.0], 0.6, 3, [0.24, -0.6], 0.36),
    ([0.4, 0.4, 1.0], 1.0, 3, [0.4, -1.0], 1.0),
    ([0.5, 0.5, 1.0], 0.0, 1, [0.0, 0.0], 0.0),
    ([0.5, 0.5, 1.0], 0.3, 3, [0.15, -0.3], 0.09),
    ([0.5, 0.5, 1.0], 0.6, 3, [0.3, -0.6], 0.36),
    ([0.5, 0.5, 1.0], 1.0, 3, [0.5, -1.0], 1.0),
    ([0.1, 0.1, 1.0], 0.0, 2, [0.078571, 0.785714], 0.617347),
    ([0.1, 0.1, 1.0], 0.3, 4, [0.132143, 0.721429], 0.651786),
    ([0.1, 0.1, 1.0], 0.6, 4, [0.185714, 0.657143], 0.755102),
    ([0.1, 0.1, 1.0], 1.0, 4, [0.257143, 0.571429], 1.0),
    ([0.1, 0.4, 1.0], 0.0, 2, [0.071233, 0.178082], 0.082681),
    ([0.1, 0.4, 1.0], 0.3, 4, [0.122603, -0.068493], 0.16524),
    ([0.1, 0.4, 1.0], 0.6, 4, [0.173973, -0.315068], 0.412916),
    ([0.1, 0.4, 1.0], 1.0, 4, [0.242466, -0.643836], 1.0),
    ([0.4, 0.1, 1.0], 0.0, 2, [0.046429, 0.464286], 0.082681),
    ([0.4, 0.1, 1.0], 0.3, 4, [0.180357, 0.303571], 0.16524),
    ([0.4, 0.1, 1.0], 0.6, 4, [0.314286, 0.142857], 0.412916),
    ([0.4, 0.1, 1.0], 1.0, 4, [0.492857, -0.071429], 1.0),
    ([0.05, 0.45, 1.0], 0.0, 2, [0.095773, 0.212828], 0.150839),
    ([0.05, 0.45, 1.0], 0.3, 4, [0.139504, -0.023324], 0.227264),
    ([0.05, 0.45, 1.0], 0.6, 4, [0.183236, -0.259475], 0.456537),
    ([0.05, 0.45, 1.0], 1.0, 4, [0.241545, -0.574344], 1.0),
    ([0.3, 0.5, 1.5], 0.0, 2, [0.042857, 0.085714], 0.011583),
    ([0.3, 0.5, 1.5], 0.3, 4, [0.145714, -0.188571], 0.100541),
    ([0.3, 0.5, 1.5], 0.6, 4, [0.248571, -0.462857], 0.367413),
    ([0.3, 0.5, 1.5], 1.0, 4, [0.385714, -0.828571], 1.0),
    ([0.5, 0.2, 1.0], 0.0, 1, [0.0, 0.0], 0.0),
    ([0.5, 0.2, 1.0], 0.3, 3, [0.15, -0.3], 0.09),
    ([0.5, 0.2, 1.0], 0.6, 3, [0.3, -0.6], 0.36),
    ([0.5, 0.2, 1.0], 1.0, 3, [0.5, -1.0], 1.0),
];

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
    assert_eq!((free.number, free.outcome), (Some(3), "unique"));
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
    assert_eq!((roll.strikes.len(), roll.end.state), (14, RollEnd::StrikesReached.word()));
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
