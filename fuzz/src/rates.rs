//! Rate problems: every solution pushes, stays within the cone, opens where it does not hold, and balances.

use crate::contacts::contact_set;
use crate::draw::signed;
use arbitrary::{Result, Unstructured};
use carom_impact::Load;
use carom_impact::planar::rate::RateProblem;
use carom_impact::planar::{ContactSet6, MOST_CONTACTS};

/// Residuals against the sum of their terms: a system of twelve equations whose entries differ by powers of ten.
const CLOSE: f64 = 1e-7;

type Drive = [[f64; 2]; MOST_CONTACTS];

/// The rate problem of a contact set under a drawn drive.
pub fn rate(bytes: &[u8]) {
    let mut u = Unstructured::new(bytes);
    let Ok((set, drive, load)) = contact_set(&mut u, MOST_CONTACTS).and_then(|set| question(&mut u, set))
    else {
        return;
    };
    let problem = RateProblem::<MOST_CONTACTS, { 2 * MOST_CONTACTS }> {
        count: set.count,
        operator: &set.operator,
        friction: &set.friction,
        drive,
        slip: set.slip,
        load,
    };
    let answer = problem.solve();
    for solution in answer.iter() {
        check(&problem, solution.rates, solution.response);
        assert!(!solution.margin.is_nan(), "margin: {problem:?} {solution:?}");
    }
}

fn question(
    u: &mut Unstructured<'_>,
    set: ContactSet6,
) -> Result<(ContactSet6, Drive, [Load; MOST_CONTACTS])> {
    let (mut drive, mut load) = ([[0.0; 2]; MOST_CONTACTS], [Load::Absent; MOST_CONTACTS]);
    for i in 0..set.count {
        drive[i] = [signed(u, 1e3, 9)?, signed(u, 1e3, 9)?];
        let base = signed(u, 1.0, 9)?.abs();
        load[i] = match u.int_in_range(0..=5)? {
            0 => Load::Absent,
            1 => Load::Touching(base),
            2 => Load::Prescribed(base),
            _ => Load::Touching(0.0),
        };
    }
    Ok((set, drive, load))
}

type Problem<'a> = RateProblem<'a, MOST_CONTACTS, { 2 * MOST_CONTACTS }>;

fn check(problem: &Problem<'_>, rates: Drive, response: Drive) {
    let n = problem.count;
    let said = || format!("{problem:?} {rates:?} {response:?}");
    let finite = rates[..n].iter().chain(&response[..n]).flatten().all(|x| x.is_finite());
    assert!(finite, "finite: {}", said());
    let total: f64 = rates[..n].iter().flatten().map(|p| p.abs()).sum();
    let entry = problem.operator[..n].iter().flatten().fold(0.0, |m: f64, b| m.max(b.tt).max(b.nn));
    let driven = problem.drive[..n].iter().flatten().fold(0.0, |m: f64, w| m.max(w.abs()));
    let scale = driven + entry * total;
    for i in 0..n {
        let ([q, r], w) = (rates[i], response[i]);
        assert!(r >= -CLOSE * total, "contact {i} pulls: {}", said());
        assert!(
            q.abs() <= problem.friction[i] * r + CLOSE * total,
            "contact {i} leaves the cone: {}",
            said()
        );
        if matches!(problem.load[i], Load::Touching(_)) {
            assert!(w[1] >= -CLOSE * scale, "contact {i} closes: {}", said());
        }
        let mut off = [problem.drive[i][0] - w[0], problem.drive[i][1] - w[1]];
        for (b, [q, r]) in problem.operator[i].iter().zip(rates).take(n) {
            off[0] += b.tt * q + b.tn * r;
            off[1] += b.nt * q + b.nn * r;
        }
        assert!(off[0].abs().max(off[1].abs()) <= CLOSE * scale, "balance of contact {i}: {}", said());
    }
}
