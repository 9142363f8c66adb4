//! Fits: posteriors that have a closed form, ridges, and what is said of outcomes that never occur.

use carom_feeder::{Outcome, Verdict, examples};
use carom_motion::planar::Options;
use carom_num::elementary::pow;
use carom_num::normal::quantile;
use carom_study::fits::{Fit, FitError, Observation, Plan, Seen, Simulated, Timed, fit};
use carom_study::{Dropped, Ending};

const TURNED: Ending = Ending::Lies(Verdict::Turned);
const SAME: Ending = Ending::Lies(Verdict::Same);
const HELD: Ending = Ending::Otherwise(Outcome::Stuck);
const GONE: Ending = Ending::Otherwise(Outcome::Delivered);

fn plan(ranges: Vec<[f64; 2]>, dimensions: usize) -> Plan {
    Plan { ranges, conditions: 1, dimensions, samples: 4096, seed: 1, nodes: 3000, level: 0.95 }
}

fn seen(ending: Ending, count: u64) -> Observation {
    Observation { condition: 0, seen: Seen { ending: Some(ending), face: None }, time: None, count }
}

fn drop(ending: Ending, time: f64) -> Simulated {
    Simulated { ending, face: None, time: Some(time) }
}

/// The value below which this share of a Beta distribution lies, by the sum of its density over a fine grid.
fn beta_quantile(a: i32, b: i32, share: f64) -> f64 {
    let n = 200_000;
    let at = |k: usize| (k as f64 + 0.5) / n as f64;
    let density = |k: usize| at(k).powi(a - 1) * (1.0 - at(k)).powi(b - 1);
    let whole: f64 = (0..n).map(density).sum();
    let mut below = 0.0;
    let mut found = (0..n).skip_while(|k| {
        below += density(*k);
        below < share * whole
    });
    at(found.next().unwrap())
}

#[test]
fn a_share_that_is_the_parameter_has_a_beta_posterior() {
    let coin = |p: &[f64], _: usize, u: &[f64]| drop(if u[0] < p[0] { TURNED } else { SAME }, 1.0);
    for (turned, same) in [(3, 7), (0, 5), (20, 4)] {
        let observed: Vec<Observation> =
            [seen(TURNED, turned), seen(SAME, same)].into_iter().filter(|seen| seen.count > 0).collect();
        let found = fit(&plan(vec![[0.0, 1.0]], 1), &observed, coin).unwrap();
        let p = found.parameters[0];
        let (a, b) = (turned as i32 + 1, same as i32 + 1);
        // Samples are 4096: they widen a likelihood of ten drops by 10/4096, and the cells hold it to some thousandths.
        for (value, share) in [(p.low, 0.025), (p.median, 0.5), (p.high, 0.975)] {
            let exact = beta_quantile(a, b, share);
            assert!((value - exact).abs() < 0.004, "Beta({a}, {b}) at {share}: {value}, not {exact}");
        }
        let mode = f64::from(turned as i32) / (turned + same) as f64;
        assert!((p.best - mode).abs() < 0.03, "the likelihood is highest at {mode}: {p:?}");
        assert!(p.told && found.resolved, "it is told: {found:?}");
    }
}

#[test]
fn a_friction_is_between_the_slopes_that_hold_and_let_go() {
    // The rod on a slope of 3 in 4 that is held half of the time where its friction spreads evenly by 0.1 about the parameter.
    let slope = |p: &[f64], _: usize, u: &[f64]| {
        let friction = p[0] + 0.2 * (u[0] - 0.5);
        let feeder = examples::rod_on_a_slope(friction);
        Simulated::of(&Dropped::of(Some(&feeder), 0, &Options::default()), 0)
    };
    let asked = Plan { samples: 256, nodes: 300, ..plan(vec![[0.2, 1.2]], 1) };
    let found = fit(&asked, &[seen(HELD, 50), seen(GONE, 50)], slope).unwrap();
    let friction = found.parameters[0];
    // The probability is (μ − 0.65)/0.2 of a Beta(51, 51): 0.4034 to 0.5966, so 0.7307 to 0.7693.
    assert!((friction.low - 0.7307).abs() < 0.002 && (friction.high - 0.7693).abs() < 0.002, "{friction:?}");
}

#[test]
fn times_with_a_known_scatter_have_a_normal_posterior() {
    // Where the time is 2 θ and is measured n times with σ, θ is normal about half of the mean, with σ/(2 √n).
    let clock = |p: &[f64], _: usize, _: &[f64]| drop(TURNED, 2.0 * p[0]);
    let timed = |time: f64, count: u64| Observation {
        time: Some(Timed { time, scatter: Some(0.03) }),
        ..seen(TURNED, count)
    };
    let found = fit(&plan(vec![[0.1, 1.1]], 0), &[timed(1.01, 4), timed(0.99, 5)], clock).unwrap();
    let p = found.parameters[0];
    let (mean, deviation) = (0.5 * (4.0 * 1.01 + 5.0 * 0.99) / 9.0, 0.03 / (2.0 * 3.0));
    let half = quantile(0.975) * deviation;
    assert!((p.mean - mean).abs() < 0.05 * deviation, "the mean is {mean}: {p:?}");
    assert!((p.low - mean + half).abs() < 0.1 * deviation, "below it {half}: {p:?}");
    assert!((p.high - mean - half).abs() < 0.1 * deviation, "above it {half}: {p:?}");
}

#[test]
fn a_scatter_that_is_not_known_gives_students_interval() {
    let clock = |p: &[f64], _: usize, _: &[f64]| drop(TURNED, p[0]);
    let timed = |time: f64| Observation { time: Some(Timed { time, scatter: None }), ..seen(TURNED, 1) };
    let times = [0.98, 1.01, 1.02, 0.99, 1.0, 1.03, 0.97, 1.0];
    let found = fit(&plan(vec![[0.5, 1.5]], 0), &times.map(timed), clock).unwrap();
    let (p, scatter) = (found.parameters[0], found.scatter.unwrap());
    let squares: f64 = times.iter().map(|time| (time - 1.0_f64).powi(2)).sum();
    // Student's 97.5 % point with 7 degrees of freedom.
    let half = 2.364_624 * (squares / 7.0 / 8.0).sqrt();
    assert!((p.low - 1.0 + half).abs() < 0.05 * half && (p.high - 1.0 - half).abs() < 0.05 * half, "{p:?}");
    let deviation = (squares / 7.0).sqrt();
    assert!(scatter.low < deviation && deviation < scatter.high, "{scatter:?} holds {deviation}");
}

fn of_a_product(ranges: Vec<[f64; 2]>) -> Fit {
    let clock = |p: &[f64], _: usize, _: &[f64]| drop(TURNED, p[0] * p[1]);
    let timed = Observation { time: Some(Timed { time: 0.25, scatter: Some(0.002) }), ..seen(TURNED, 4) };
    fit(&plan(ranges, 0), &[timed], clock).unwrap()
}

#[test]
fn what_only_a_product_tells_is_not_told_apart() {
    let ridge = of_a_product(vec![[0.3, 0.9], [0.3, 0.9]]);
    assert!(!ridge.pairs[0].told && ridge.pairs[0].correlation < -0.9, "{:?}", ridge.pairs);
    // All of the ridge is found: x from 0.25/0.9 on, at the density 1/x of ln x; its ends are 1/0.9 of the limits.
    let [a, b] = [ridge.parameters[0], ridge.parameters[1]];
    let at = |share: f64| 0.3 * pow(0.25 / 0.09, share);
    for (value, share) in [(a.low, 0.025), (a.high, 0.975), (b.low, 0.025), (b.high, 0.975)] {
        assert!((value - at(share)).abs() < 0.01, "{value}, not {}", at(share));
    }
    assert!((a.best * b.best - 0.25).abs() < 0.004, "the best point lies on the ridge: {a:?} {b:?}");
}

#[test]
fn a_parameter_that_nothing_depends_on_is_not_told() {
    let coin = |p: &[f64], _: usize, u: &[f64]| drop(if u[0] < p[0] { TURNED } else { SAME }, 1.0);
    let asked = Plan { samples: 256, ..plan(vec![[0.0, 1.0], [0.0, 2.0]], 1) };
    let found = fit(&asked, &[seen(TURNED, 30), seen(SAME, 10)], coin).unwrap();
    let [share, other] = [found.parameters[0], found.parameters[1]];
    assert!(share.told && !other.told && found.pairs[0].told, "{found:?}");
    assert!((other.low - 0.05).abs() < 0.02 && (other.high - 1.95).abs() < 0.02, "as before: {other:?}");
}

#[test]
fn outcomes_that_never_occur_are_named() {
    let slope = |p: &[f64], condition: usize, _: &[f64]| {
        drop(if p[0] > 0.3 + 0.1 * condition as f64 { HELD } else { GONE }, 1.0)
    };
    let under = |condition: usize, ending: Ending| Observation { condition, ..seen(ending, 1) };
    let asked = Plan { conditions: 2, ..plan(vec![[0.0, 1.0]], 0) };
    let never = fit(&asked, &[under(0, HELD), under(1, SAME)], slope);
    assert_eq!(never, Err(FitError::Never { observations: vec![1] }), "nothing lies on the same side");
    let both = fit(&asked, &[under(0, GONE), under(0, GONE), under(1, HELD)], slope);
    let Err(FitError::Contradiction { observations, at }) = both else {
        panic!("no friction does: {both:?}")
    };
    assert!(observations == [2] && at[0] < 0.3, "two drops against one: {observations:?} at {at:?}");
    // Between 0.3 and 0.4 both are as they were: a window of a tenth is found, its ends to a thousandth.
    let window = fit(&asked, &[under(0, HELD), under(1, GONE)], slope).unwrap().parameters[0];
    assert!((window.low - 0.3025).abs() < 0.002 && (window.high - 0.3975).abs() < 0.002, "{window:?}");
}

fn timed(time: f64, scatter: Option<f64>, count: u64) -> Observation {
    Observation { time: Some(Timed { time, scatter }), ..seen(TURNED, count) }
}

#[test]
fn a_time_that_no_drop_takes_is_named() {
    let slow = |p: &[f64], _: usize, _: &[f64]| drop(TURNED, 1.0 + p[0]);
    let of = |observed: &[Observation]| fit(&plan(vec![[0.0, 1.0]], 0), observed, slow);
    let far = [timed(1.5, Some(0.01), 3), timed(99.0, Some(0.01), 1), timed(2.09, Some(0.01), 1)];
    let expected = FitError::Untimely { observations: vec![1, 2], spans: vec![[1.0, 2.0]; 2] };
    assert_eq!(of(&far), Err(expected), "by more than 8 standard deviations");
    assert!(of(&[timed(2.07, Some(0.01), 1)]).is_ok(), "a scatter explains 7 of them");
    let fitted = FitError::Untimely { observations: vec![0], spans: vec![[1.0, 2.0]] };
    assert_eq!(of(&[timed(4.1, None, 1), timed(1.5, None, 1)]), Err(fitted), "whatever the scatter");
    assert!(of(&[timed(3.9, None, 1), timed(1.5, None, 1)]).is_ok(), "less than twice the longest");
}

#[test]
fn a_search_that_ends_before_it_has_found_the_best_gives_no_interval() {
    // All values but those within a 10⁻⁵ of the range are out of the question.
    let slow = |p: &[f64], _: usize, _: &[f64]| drop(TURNED, 1.0 + (p[0] - 0.1).powi(2));
    let observed = [timed(1.0529, Some(1e-7), 50)];
    let few = Plan { nodes: 16, ..plan(vec![[0.0, 1.0]], 0) };
    assert_eq!(fit(&few, &observed, slow), Err(FitError::Lost { nodes: 16 }));
    let found = fit(&plan(vec![[0.0, 1.0]], 0), &observed, slow).unwrap();
    assert!((found.parameters[0].best - 0.33).abs() < 1e-5, "with more nodes it is found: {found:?}");
}

#[test]
fn times_that_scatter_more_than_is_said_are_a_misfit() {
    let slow = |p: &[f64], _: usize, _: &[f64]| drop(TURNED, 1.0 + p[0]);
    let pair = |off: f64| [timed(1.5 - off, Some(0.01), 10), timed(1.5 + off, Some(0.01), 10)];
    for off in [0.01, 0.06] {
        let found = fit(&plan(vec![[0.0, 1.0]], 0), &pair(off), slow).unwrap();
        assert!((found.misfit.unwrap() - 100.0 * off).abs() < 0.01, "{found:?}");
    }
    let counts = fit(&plan(vec![[0.0, 1.0]], 0), &[seen(TURNED, 3)], slow).unwrap();
    assert_eq!(counts.misfit, None, "nothing is timed");
}

#[test]
fn what_cannot_be_computed_with_is_refused() {
    let coin = |_: &[f64], _: usize, _: &[f64]| drop(SAME, 1.0);
    let of = |plan: Plan, observation: Observation| fit(&plan, &[observation], coin).unwrap_err();
    let one = || plan(vec![[0.0, 1.0]], 0);
    let good = seen(SAME, 1);
    let timed =
        |time: f64, scatter: f64| Observation { time: Some(Timed { time, scatter: Some(scatter) }), ..good };
    for bad in [
        seen(SAME, 0),
        Observation { condition: 1, ..good },
        Observation { seen: Seen { ending: None, face: None }, ..good },
        timed(f64::NAN, 0.1),
        timed(1.0, 0.0),
        timed(-1.0, 0.1),
        timed(f64::INFINITY, 0.1),
    ] {
        assert_eq!(of(one(), bad), FitError::Observation { observation: 0 }, "{bad:?}");
    }
    for range in [[1.0, 1.0], [0.0, f64::INFINITY], [f64::NAN, 1.0]] {
        assert_eq!(of(plan(vec![range], 0), good), FitError::Range { parameter: 0 }, "{range:?}");
    }
    assert_eq!(of(plan(vec![[0.0, 1.0]; 5], 0), good), FitError::Parameters { found: 5 }, "too many");
    for level in [0.0, 1.0, f64::NAN] {
        let refused = of(Plan { level, ..one() }, good);
        assert!(matches!(refused, FitError::Effort { .. }), "{level}: {refused:?}");
    }
    assert_eq!(fit(&one(), &[], coin), Err(FitError::Nothing), "no drops");
}

#[test]
fn the_number_of_threads_changes_nothing() {
    let coin =
        |p: &[f64], _: usize, u: &[f64]| drop(if u[0] < p[0] { TURNED } else { SAME }, 1.0 + p[0] * u[0]);
    let timed = Observation { time: Some(Timed { time: 1.2, scatter: None }), ..seen(TURNED, 3) };
    let found = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let asked = Plan { samples: 64, nodes: 200, ..plan(vec![[0.0, 1.0]], 1) };
        pool.install(|| fit(&asked, &[timed, seen(SAME, 5)], coin)).unwrap()
    };
    assert_eq!(found(1), found(3), "the same bytes");
}
