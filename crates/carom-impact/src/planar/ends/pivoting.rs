//! One end state of any number of contacts, by complementary pivoting. Whether it is the only one is not examined.
//!
//! The laws of [`end_states`](super::end_states) as one linear complementarity problem: per contact the normal impulse against the normal
//! velocity, forward and backward friction against the slip, and the slip speed λ against what is left of the friction cone.
//!
//! Source: Stewart and Trinkle, Int. J. Numer. Methods Eng. 39 (1996) 2673, for the formulation and why Lemke's method ends in a solution;
//! Glocker and Pfeiffer, Nonlinear Dynamics 7 (1995) 471, for the two phases.

use super::end_states::EndState;
use crate::planar::contacts::names::Slip;
use crate::planar::contacts::set::ContactSet;
use crate::planar::rates::answer::Guess;
use crate::tolerance::{PIVOTING_RANK, PIVOTING_REST, SPECK};
use crate::{ImpactError, Law};
use carom_num::lemke::lemke;
use carom_num::solve::solve_any;

/// Up to 24 contacts: as many as pivoting is meant for.
///
/// # Example
/// ```
/// use carom_impact::{ImpactError, planar::{Touch, pivoting::ContactSet24}};
/// use carom_num::Vec2;
/// let leg = Touch { arm: Vec2::ZERO, normal: Vec2::new(0.0, 1.0), friction: 0.3, restitution: 0.0 };
/// let table = |legs| ContactSet24::of_free_body(1.0, 1.0, Vec2::ZERO, 0.0, &vec![leg; legs]).map(|set| set.count);
/// assert_eq!((table(24), table(25)), (Ok(24), Err(ImpactError::TooMany { count: 25, most: 24 })));
/// ```
pub type ContactSet24 = ContactSet<24, 48>;

/// One consistent end state: Newton's law in one step, else Poisson's two phases (Stronge's measure of work is not known at the end).
///
/// # Errors
/// As [`ContactSet::check`]; [`ImpactError::Jammed`] where the pivoting ends without a solution.
///
/// # Limits
/// Others may exist: [`end_states::enumerate`](super::end_states::enumerate) lists all of them, for up to six contacts in reasonable time.
///
/// # Example
/// A table on four legs lands flat: the normal impulses are not determined, their sum is.
/// ```
/// use carom_impact::planar::pivoting::{ContactSet24, one_end_state};
/// use carom_impact::{Law, planar::Touch};
/// use carom_num::Vec2;
/// let leg = |x| Touch { arm: Vec2::new(x, -0.5), normal: Vec2::new(0.0, 1.0), friction: 0.3, restitution: 0.0 };
/// let table = ContactSet24::of_free_body(2.0, 1.0, Vec2::new(0.0, -1.0), 0.0, &[leg(-0.6), leg(-0.2), leg(0.2), leg(0.6)])?;
/// let end = one_end_state(&table, Law::Poisson)?;
/// let sum: f64 = end.impulse.iter().map(|p| p[1]).sum();
/// assert!((sum - 2.0).abs() < 1e-12);
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
pub fn one_end_state<const N: usize, const M: usize>(
    set: &ContactSet<N, M>,
    law: Law,
) -> Result<EndState<N>, ImpactError> {
    set.check()?;
    let before: [[f64; 2]; N] = std::array::from_fn(|i| [set.slip[i], set.normal[i]]);
    let none = [0.0; N];
    if law == Law::Newton {
        let bounce = std::array::from_fn(|i| set.restitution[i] * set.normal[i].min(0.0));
        let impulse = solve(set, &before, &bounce, &none)?;
        return Ok(ended(set, &impulse));
    }
    let first = solve(set, &before, &none, &none)?;
    let debt: [f64; N] = std::array::from_fn(|i| set.restitution[i] * first[i][1]);
    if debt.iter().all(|d| *d == 0.0) {
        return Ok(ended(set, &first));
    }
    let compressed = velocities(set, &before, &first);
    let second = solve(set, &compressed, &none, &debt)?;
    let total = std::array::from_fn(|i| [first[i][0] + second[i][0], first[i][1] + second[i][1]]);
    Ok(ended(set, &total))
}

/// Impulses of one phase from these velocities: `0 ≤ p_n − debt ⊥ u_n⁺ + bounce ≥ 0`, with friction.
fn solve<const N: usize, const M: usize>(
    set: &ContactSet<N, M>,
    before: &[[f64; 2]; N],
    bounce: &[f64; N],
    debt: &[f64; N],
) -> Result<[[f64; 2]; N], ImpactError> {
    let n = set.count;
    // Unknowns: normal excess, forward and backward friction, slip speed.
    let [forward, backward, speed] = [n, 2 * n, 3 * n];
    let mut m = vec![vec![0.0; 4 * n]; 4 * n];
    let mut q = vec![0.0; 4 * n];
    for i in 0..n {
        let [u_t, u_n] = before[i];
        (q[i], q[forward + i], q[backward + i]) = (u_n + bounce[i], u_t, -u_t);
        q[speed + i] = set.friction[i] * debt[i];
        for j in 0..n {
            let b = &set.operator[i][j];
            for (column, t, nn) in [(j, b.tn, b.nn), (forward + j, b.tt, b.nt), (backward + j, -b.tt, -b.nt)]
            {
                m[i][column] = nn;
                m[forward + i][column] = t;
                m[backward + i][column] = -t;
            }
            q[i] += b.nn * debt[j];
            q[forward + i] += b.tn * debt[j];
            q[backward + i] -= b.tn * debt[j];
        }
        (m[forward + i][speed + i], m[backward + i][speed + i]) = (1.0, 1.0);
        m[speed + i][i] = set.friction[i];
        (m[speed + i][forward + i], m[speed + i][backward + i]) = (-1.0, -1.0);
    }
    // Contacts that can wedge leave the problem on the edge of having no solution, and rounding of the velocities puts it beyond: a speck of
    // separation brings it back.
    let speck = SPECK * q.iter().fold(0.0, |s: f64, v| s.max(v.abs()));
    let opened = |mut q: Vec<f64>| {
        q[..n].iter_mut().for_each(|v| *v += speck);
        lemke(&m, &q)
    };
    let z = lemke(&m, &q).or_else(|| opened(q)).ok_or(ImpactError::Jammed)?;
    Ok(std::array::from_fn(
        |i| {
            if i < n { [z[forward + i] - z[backward + i], z[i] + debt[i]] } else { [0.0; 2] }
        },
    ))
}

fn velocities<const N: usize, const M: usize>(
    set: &ContactSet<N, M>,
    before: &[[f64; 2]; N],
    impulse: &[[f64; 2]; N],
) -> [[f64; 2]; N] {
    std::array::from_fn(|i| {
        if i >= set.count {
            return [0.0; 2];
        }
        let ([mut u_t, mut u_n], mut terms) = (before[i], before[i][0].abs() + before[i][1].abs());
        for (b, [q, r]) in set.operator[i].iter().zip(impulse).take(set.count) {
            u_t += b.tt * q + b.tn * r;
            u_n += b.nt * q + b.nn * r;
            terms += (b.tt * q).abs() + (b.tn * r).abs() + (b.nt * q).abs() + (b.nn * r).abs();
        }
        let rest = |u: f64| if u.abs() <= PIVOTING_REST * terms { 0.0 } else { u };
        [rest(u_t), rest(u_n)]
    })
}

fn ended<const N: usize, const M: usize>(set: &ContactSet<N, M>, impulse: &[[f64; 2]; N]) -> EndState<N> {
    let before = std::array::from_fn(|i| [set.slip[i], set.normal[i]]);
    let velocity = velocities(set, &before, impulse);
    let guess = std::array::from_fn(|i| {
        let ([u_t, u_n], pushed) = (velocity[i], i < set.count && impulse[i][1] > 0.0);
        let slip = match (pushed, u_t.partial_cmp(&0.0)) {
            (false, _) => Slip::Open,
            (true, Some(std::cmp::Ordering::Greater)) => Slip::Forward,
            (true, Some(std::cmp::Ordering::Less)) => Slip::Backward,
            (true, _) => Slip::Sticks,
        };
        Guess { holds: pushed && u_n == 0.0, slip }
    });
    let indeterminate = impulses_are_open(set, &guess, impulse);
    EndState { guess, impulse: *impulse, velocity, margin: f64::INFINITY, indeterminate }
}

/// True where other impulses give the same motion: the response to those that act, each slipping one with its friction, has a direction
/// that it does not answer to.
fn impulses_are_open<const N: usize, const M: usize>(
    set: &ContactSet<N, M>,
    guess: &[Guess; N],
    impulse: &[[f64; 2]; N],
) -> bool {
    // Contact, and whether along its tangent.
    let mut acting: Vec<(usize, bool)> = vec![];
    for i in (0..set.count).filter(|&i| impulse[i][1] > 0.0) {
        acting.push((i, false));
        if guess[i].slip == Slip::Sticks && set.friction[i] > 0.0 {
            acting.push((i, true));
        }
    }
    let mut rows = [[0.0; M]; M];
    for (row, &(i, along)) in rows.iter_mut().zip(&acting) {
        for (entry, &(j, tangential)) in row.iter_mut().zip(&acting) {
            let b = &set.operator[i][j];
            let [t, n] = if along { [b.tt, b.tn] } else { [b.nt, b.nn] };
            *entry = if tangential { t } else { n + guess[j].slip.pull(set.friction[j]) * t };
        }
    }
    solve_any(rows, [0.0; M], acting.len(), PIVOTING_RANK).is_none_or(|all| all.freedom > 0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::planar::contacts::set::ContactSet6;
    use crate::planar::contacts::set::Touch;
    use crate::planar::ends::end_states;
    use carom_num::Vec2;

    /// Contacts on a polygon's rim, each striking or leaving.
    fn rim(contacts: u32, seed: f64, restitution: f64) -> Vec<Touch> {
        let touch = |k: u32| {
            let angle = 6.2 * f64::from(k) / f64::from(contacts) + 0.3 * seed;
            let out = Vec2::at_angle(angle);
            let normal = Vec2::at_angle(angle + 3.1 + 0.2 * (seed - 0.5));
            let friction = 0.1 + 0.6 * ((f64::from(k) + seed) * 0.618_034).fract();
            Touch { arm: out, normal, friction, restitution }
        };
        (0..contacts).map(touch).collect()
    }

    #[test]
    fn it_is_one_of_the_end_states_that_enumeration_finds() {
        let mut unique = 0;
        for case in 0..300_u32 {
            let seed = (f64::from(case) * 0.754_877).fract();
            let touches = rim(1 + case % 4, seed, if case % 2 == 0 { 0.0 } else { 0.5 });
            let velocity = Vec2::new(seed - 0.5, (7.0 * seed).fract() - 0.5);
            let set = ContactSet6::of_free_body(1.0, 0.4, velocity, 2.0 * seed - 1.0, &touches).unwrap();
            for law in [Law::Poisson, Law::Newton] {
                let all = end_states::enumerate(&set, law);
                if law == Law::Newton && all.found.is_empty() {
                    // Newton's law may contradict itself at several contacts.
                    assert!(one_end_state(&set, law).is_err(), "case {case}: {all:?}");
                    continue;
                }
                let one = one_end_state(&set, law).unwrap();
                let same = |end: &end_states::EndState<6>| {
                    let pairs = end.velocity.iter().flatten().zip(one.velocity.iter().flatten());
                    pairs.map(|(a, b)| (a - b).abs()).all(|off| off < 1e-9)
                };
                // Where compression leaves forces open, restitution follows the member that was taken: then only the laws are asked.
                if law == Law::Newton || set.restitution[0] == 0.0 {
                    assert!(all.found.iter().any(same), "case {case} {law:?}: {one:?} {:?}", all.found);
                    unique += 1;
                }
            }
        }
        assert!(unique > 250, "{unique} compared");
    }

    #[test]
    fn twenty_contacts_obey_every_law() {
        for seed in [0.1, 0.37, 0.62, 0.9] {
            let set =
                ContactSet24::of_free_body(1.0, 0.4, Vec2::new(0.3, -0.8), 1.5, &rim(20, seed, 0.4)).unwrap();
            let end = one_end_state(&set, Law::Poisson).unwrap();
            for i in 0..20 {
                let ([p_t, p_n], [u_t, u_n]) = (end.impulse[i], end.velocity[i]);
                assert!(p_n >= 0.0 && u_n >= 0.0, "{i}: {p_n} {u_n}");
                assert!(p_t.abs() <= set.friction[i] * p_n + 1e-10, "{i}: {p_t} {p_n} slip {u_t}");
            }
        }
    }
}
