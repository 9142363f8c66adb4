//! # One impact
//!
//! A rigid body strikes with one point. Rigid-body mechanics gives the impact no duration, friction decides along the way, and a
//! coefficient of restitution decides where it ends. This tutorial follows one strike by hand and lets the engine do the same.
//!
//! ## The contact and its operator
//!
//! In the contact frame `n` points out of the obstacle into the body and `t` is `n` turned a quarter clockwise: on a floor, `t` points to the
//! right. The contact point moves with `u = (u_t, u_n)`, *slip* and *normal velocity*; an approach has `u_n < 0`. An impulse `p` on the body
//! changes that by `u⁺ = u⁻ + W p`. For a free body of mass m and inertia J that is touched at ρ from its mass centre
//!
//! ```text
//! W_tt = 1/m + ρ_n²/J      W_nn = 1/m + ρ_t²/J      W_tn = −ρ_t ρ_n/J
//! ```
//!
//! Take 1 kg and 1 kg m², touched one metre to the right of the mass centre and two below it, and let it fall on a floor at 6 m/s while it
//! moves to the left at 4.5 m/s, without spin:
//!
//! ```
//! use carom::impact::planar::{ContactSet, Touch};
//! use carom::prelude::*;
//! let touch = Touch { arm: Vec2::new(1.0, -2.0), normal: Vec2::new(0.0, 1.0), friction: 0.5, restitution: 0.5 };
//! let set = ContactSet::<1, 2>::of_free_body(1.0, 1.0, Vec2::new(-4.5, -6.0), 0.0, &[touch])?;
//! let w = set.operator[0][0];
//! assert_eq!((w.tt, w.tn, w.nn), (5.0, 2.0, 2.0));
//! assert_eq!((set.slip[0], set.normal[0]), (-4.5, -6.0));
//! # Ok::<(), carom::Error>(())
//! ```
//!
//! These five numbers, friction and restitution are all that the impact depends on. `W_tn > 0` says that pressing this point upwards also
//! pushes it to the right.
//!
//! ## The walk in the impulse plane
//!
//! Routh (1860) let the normal impulse p_n be the clock. As long as the point slips to the left, friction pulls to the right, `dp_t = μ dp_n`:
//!
//! ```text
//! du_t/dp_n = W_tn + μW_tt = 2 + 0.5·5 = 4.5        the slip of −4.5 m/s is gone after 1 N s
//! du_n/dp_n = W_nn + μW_tn = 2 + 0.5·2 = 3          u_n is then −6 + 3 = −3 m/s: still compression
//! ```
//!
//! To stay stopped the point needs `dp_t/dp_n = −W_tn/W_tt = −0.4`, and friction can give 0.5: it sticks.
//!
//! ```text
//! du_n/dp_n = W_nn − W_tn²/W_tt = 2 − 4/5 = 1.2     compression ends after another 3/1.2 = 2.5 N s
//! ```
//!
//! By Poisson's law restitution then adds e times the 3.5 N s of compression, 1.75 N s, and the point leaves with 1.2 · 1.75 = 2.1 m/s. In the
//! plane of the two impulses the walk is a broken line, and its corners are what happens:
//!
//! ```text
//!   p_t
//!   0.5        ● slip stops (1, 0.5)
//!            ╱    ╲
//!    0  ●  ╱         ╲
//!  start (0, 0)         ╲
//!  −0.5                    ● compression ends (3.5, −0.5)
//!                              ╲
//!  −1.2                            ● restitution ends (5.25, −1.2)
//!                                                                   p_n
//! ```
//!
//! The engine hands over each straight piece, a *stage*:
//!
//! ```
//! use carom::impact::{Law, Phase, planar::{ImpactType, Slip, StageEnd, single}};
//! let contact = single::Contact {
//!     w_tt: 5.0, w_tn: 2.0, w_nn: 2.0, slip: -4.5, normal: -6.0, friction: 0.5, restitution: 0.5,
//! };
//! let mut stages = vec![];
//! let out = single::resolve_observed(&contact, Law::Poisson, &mut |stage: &single::Stage| stages.push(*stage))?;
//!
//! let told: Vec<_> = stages.iter().map(|s| (s.phase, s.slip, s.ended_by)).collect();
//! assert_eq!(told, [
//!     (Phase::Compression, Slip::Backward, StageEnd::SlipStops(0)),
//!     (Phase::Compression, Slip::Sticks, StageEnd::CompressionEnds),
//!     (Phase::Restitution, Slip::Sticks, StageEnd::RestitutionEnds),
//! ]);
//! for (stage, [p_n, p_t, u_t, u_n]) in stages.iter().zip([
//!     [1.0, 0.5, 0.0, -3.0],
//!     [3.5, -0.5, 0.0, 0.0],
//!     [5.25, -1.2, 0.0, 2.1],
//! ]) {
//!     let end = stage.end;
//!     for (ours, by_hand) in
//!         [(end.normal_impulse, p_n), (end.tangential_impulse, p_t), (end.slip, u_t), (end.normal, u_n)]
//!     {
//!         assert!((ours - by_hand).abs() < 1e-14, "{ours} is not {by_hand}");
//!     }
//! }
//! assert_eq!(out.kind, Some(ImpactType::StopsInCompression));
//! # Ok::<(), carom::Error>(())
//! ```
//!
//! ## Seven types
//!
//! Whether the slip stops, when, and what it does then makes seven qualitatively different impacts (Plavnieks 1969; Wang and Mason 1992 name
//! them by classes). With s the sign of the slip, S₀ the slip and C₀ the normal velocity before, two numbers decide:
//!
//! ```text
//! P_d = (W_nn − sμW_tn) |S₀|        the slip stops in compression where P_d < P_q,
//! P_q = (μW_tt − sW_tn) |C₀|        in restitution where P_q < P_d < (1 + e) P_q;
//!                                   stopped, it sticks where μ ≥ |W_tn|/W_tt = 0.4 and reverses else
//! ```
//!
//! Our body with e = 0.5 shows all seven, by its slip and its friction alone. With μ = 0.5, P_d = 3|S₀| stands against P_q = 27 and 40.5; with
//! μ = 0.25, P_d = 2.5|S₀| against 19.5 and 29.25:
//!
//! ```
//! use carom::impact::{Law, planar::{Class, single}};
//! let strike = |friction: f64, slip: f64| {
//!     let contact = single::Contact {
//!         w_tt: 5.0, w_tn: 2.0, w_nn: 2.0, slip, normal: -6.0, friction, restitution: 0.5,
//!     };
//!     single::resolve(&contact, Law::Poisson).map(|out| out.kind.map(|k| (k.number(), k.class())))
//! };
//! assert_eq!(strike(0.5, -15.0)?, Some((1, Class::Sliding)));           // 45 > 40.5
//! assert_eq!(strike(0.25, 0.0)?, Some((2, Class::SlidingFromRest)));    // 0.25 < 0.4
//! assert_eq!(strike(0.5, 0.0)?, Some((3, Class::Sticking)));            // 0.5 ≥ 0.4
//! assert_eq!(strike(0.25, -9.0)?, Some((4, Class::RReversed)));         // 19.5 < 22.5 < 29.25
//! assert_eq!(strike(0.25, -4.0)?, Some((5, Class::CReversed)));         // 10 < 19.5
//! assert_eq!(strike(0.5, -10.0)?, Some((6, Class::RSticking)));         // 27 < 30 < 40.5
//! assert_eq!(strike(0.5, -4.5)?, Some((7, Class::CSticking)));          // 13.5 < 27
//! # Ok::<(), carom::Error>(())
//! ```
//!
//! ## Three laws on one strike
//!
//! Up to the end of compression nobody disagrees: 3.5 N s, and −8.25 J of work by the normal impulse (−4.5 J while it slips, −3.75 J while it
//! sticks). Then the laws measure restitution by different things:
//!
//! | law | measures | condition | p_n [N s] | u_n⁺ [m/s] |
//! |---|---|---|---|---|
//! | Poisson | impulse | e · 3.5 = 1.75 more | 5.25 | 2.1 |
//! | Stronge | work | e² · 8.25 = 2.0625 J back: u_n²/(2 · 1.2) | 5.354 | √4.95 = 2.225 |
//! | Newton | velocity | e · 6 = 3 m/s | 6 | 3 |
//!
//! ```
//! use carom::impact::{Law, planar::single};
//! let strike = |law: Law, restitution: f64| {
//!     let contact = single::Contact {
//!         w_tt: 5.0, w_tn: 2.0, w_nn: 2.0, slip: -4.5, normal: -6.0, friction: 0.5, restitution,
//!     };
//!     single::resolve(&contact, law)
//! };
//! let near = |ours: f64, by_hand: f64| assert!((ours - by_hand).abs() < 1e-13, "{ours} is not {by_hand}");
//! for (law, normal) in [(Law::Poisson, 2.1), (Law::Stronge, 4.95_f64.sqrt()), (Law::Newton, 3.0)] {
//!     let out = strike(law, 0.5)?;
//!     near(out.normal, normal);
//!     near(out.normal_impulse, 3.5 + normal / 1.2);
//!     assert!(!out.gained_energy);
//! }
//!
//! // At e = 1 friction costs 1.125 J while the point slips. Stronge's law returns all the rest, Poisson's less,
//! // and Newton's more than there was: 5.625 J are made from nothing, and the outcome says so.
//! for (law, work) in [(Law::Stronge, -1.125), (Law::Poisson, -2.025), (Law::Newton, 5.625)] {
//!     let out = strike(law, 1.0)?;
//!     near(out.normal_work + out.tangential_work, work);
//!     assert_eq!(out.gained_energy, law == Law::Newton);
//! }
//! # Ok::<(), carom::Error>(())
//! ```
//!
//! The impulses of types 1, 2 and 3 are the same under the three laws: a straight walk has one slope, and work, velocity and impulse then say
//! the same. Where the slip stops on the way the coefficient means something else in each law, and a measured e belongs to the law it was
//! measured with.
//!
//! ## End states, and what rejects the others
//!
//! One may also skip the walk and ask which *end* is consistent with Signorini's and Coulomb's laws over the whole impact, as many papers and
//! most engines do. Every hypothesis is tried, and each that fails names the inequality that it violates. Without restitution, our strike:
//!
//! ```
//! use carom::impact::{Law, planar::{Block, Condition, ContactSet, Slip, end_states, single}};
//! let ends = |friction: f64, slip: f64| {
//!     let set = ContactSet::<1, 2> {
//!         count: 1,
//!         operator: [[Block { tt: 5.0, tn: 2.0, nt: 2.0, nn: 2.0 }]],
//!         slip: [slip], normal: [-6.0], friction: [friction], restitution: [0.0],
//!     };
//!     end_states::enumerate(&set, Law::Poisson)
//! };
//! let ours = ends(0.5, -4.5);
//! assert_eq!(ours.found.len(), 1);
//! assert_eq!(ours.found[0].guess[0].slip, Slip::Sticks);
//! let [p_t, p_n] = ours.found[0].impulse[0];
//! assert!((p_t + 0.5).abs() < 1e-14 && (p_n - 3.5).abs() < 1e-14);
//! let why: Vec<_> = ours.rejected.iter().map(|r| (r.guess[0].slip, r.broken.condition)).collect();
//! assert_eq!(why, [
//!     (Slip::Open, Condition::Opens(0)),                  // untouched, it would go on at −6 m/s into the floor
//!     (Slip::Forward, Condition::StartsForward(0)),       // p_n = 6, p_t = −3 would leave a slip of −7.5 m/s
//!     (Slip::Backward, Condition::StartsBackward(0)),     // p_n = 2, p_t = +1 would leave a slip of +4.5 m/s
//! ]);
//!
//! // Walk and end state need not agree. A slip of −4 m/s with μ = 0.25 reverses on the way and ends slipping forward,
//! // but over the whole impact only sticking is consistent: |p_t| = 2/3 ≤ 0.25 · 11/3.
//! let end = ends(0.25, -4.0);
//! assert_eq!((end.found.len(), end.found[0].guess[0].slip), (1, Slip::Sticks));
//! let contact = single::Contact {
//!     w_tt: 5.0, w_tn: 2.0, w_nn: 2.0, slip: -4.0, normal: -6.0, friction: 0.25, restitution: 0.0,
//! };
//! let walk = single::resolve(&contact, Law::Poisson)?;
//! assert!((walk.slip - 19.0 / 13.0).abs() < 1e-14, "{}", walk.slip);
//! # Ok::<(), carom::Error>(())
//! ```
//!
//! Such an answer depends on the path, and the engine reports both: the walk is what happens, the end states are what one cannot exclude
//! by looking at the end alone.
//!
//! ## Several contacts
//!
//! [`staged::resolve`](crate::impact::planar::staged::resolve) walks with up to six contacts. How contacts that *close together* share an
//! impact is not decided by rigid-body mechanics; the convention used here, and what happens where no motion is consistent, stand in
//! decision note 4 of the repository (`docs/decisions`). [The next tutorial](super::_03_how_motion_is_walked) meets the same question on
//! the clock of time.
