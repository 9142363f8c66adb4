//! # How motion is walked
//!
//! ## Two clocks, one question
//!
//! A contact is asked the same thing while its body moves and during an impact: does it separate, stick or slip, and how hard does it push?
//! While the body moves the clock is time, the drive are accelerations, and the answer are forces. During an impact the clock is an impulse,
//! the drive are velocities, and the answer are impulses. The question is the *rate problem*, and there is one implementation of it.
//!
//! Take the body of [the tutorial before](super::_02_one_impact): 1 kg, 1 kg m², touched one metre to the right of its mass centre and two
//! below it. Let it be at rest on that point and be pulled down at 6 m/s², with nothing else to hold it:
//!
//! ```
//! use carom::impact::{Load, planar::{Block, Slip, rate::RateProblem}};
//! let operator = [[Block { tt: 5.0, tn: 2.0, nt: 2.0, nn: 2.0 }]];
//! let ask = |friction: f64, drive: [f64; 2]| {
//!     let answer = RateProblem::<1, 2> {
//!         count: 1, operator: &operator, friction: &[friction],
//!         drive: [drive], slip: [0.0], load: [Load::Touching(0.0)],
//!     }.solve();
//!     assert_eq!(answer.count, 1);
//!     answer.solutions[0].map(|s| (s.guess[0].slip, s.rates[0]))
//! };
//! // Sticking: slip rate 2·5 − 5·2 = 0, normal rate −6 + 2·5 − 2·2 = 0, and 2 ≤ 0.5 · 5.
//! assert_eq!(ask(0.5, [0.0, -6.0]), Some((Slip::Sticks, [-2.0, 5.0])));
//! // Friction of 0.25 gives way: normal rate −6 + 2·4 − 2·1 = 0, and the slip starts forward at 2·4 − 5·1 = 3.
//! assert_eq!(ask(0.25, [0.0, -6.0]), Some((Slip::Forward, [-1.0, 4.0])));
//! ```
//!
//! Read the drive as 6 m/s² and the answers are forces of 5 N and 4 N. Read it as an approach of 6 m/s and the same numbers are the impulses,
//! in N s, of the end states of a plastic impact.
//!
//! ## Several answers, and none
//!
//! The answer is a set. Painlevé (1895) found that it need not have one member: a uniform rod of 1 kg with half length 1 m, at an angle of
//! tan θ = 2 to a rough floor, slides with its lower end so that friction digs it in. With J = 1/3 kg m², `cos²θ = 1/5` gives
//! `W_nn = 1 + 3/5 = 1.6`, `W_tt = 1 + 12/5 = 3.4` and `W_tn = −6/5 = −1.2`. Pressing the sliding end with N changes its normal
//! acceleration by `(W_nn + μW_tn) N`, which is −0.8 N at μ = 2: pressing pulls it in.
//!
//! ```
//! use carom::impact::{Load, planar::{Block, Condition, Slip, rate::RateProblem}};
//! let operator = [[Block { tt: 3.4, tn: -1.2, nt: -1.2, nn: 1.6 }]];
//! let ask = |normal_drive: f64| {
//!     let problem = RateProblem::<1, 2> {
//!         count: 1, operator: &operator, friction: &[2.0],
//!         drive: [[0.0, normal_drive]], slip: [-1.0], load: [Load::Touching(0.0)],
//!     };
//!     let mut rejected = vec![];
//!     let answer = problem.solve_observed(&mut |guess, broken| rejected.push((guess[0].slip, broken.condition)));
//!     (answer, rejected)
//! };
//! // Gravity alone: open it would fall through the floor, held it would have to be pulled. No motion is consistent.
//! let (none, rejected) = ask(-10.0);
//! assert_eq!(none.count, 0);
//! assert_eq!(rejected, [(Slip::Open, Condition::Opens(0)), (Slip::Backward, Condition::Pushes(0))]);
//! // It turns so fast that its end is driven up at 4 m/s²: it may leave, or stay with N = 4/0.8 = 5 N.
//! let (several, _) = ask(4.0);
//! assert_eq!(several.count, 2);
//! let forces: Vec<f64> = several.iter().map(|s| s.rates[0][1]).collect();
//! assert!(forces[0] == 0.0 && (forces[1] - 5.0).abs() < 1e-14, "{forces:?}");
//! ```
//!
//! Neither is an error. Where there is no motion, the slip is stopped by a finite impulse at that instant, an *impact without approach*, and
//! the trace marks it so. Where there are several, the contact goes on as it was if it can.
//!
//! ## A world and a walker
//!
//! Motion is a walk through *modes*: solve the rate problem, integrate the smooth equations of the answer until an event, resolve what the
//! event brings, ask again. A [`Walker`](crate::motion::planar::Walker) does this for any body among straight obstacles, and one call of
//! `advance` is one smooth piece and the event that ends it. A disc of radius 0.1 m is dropped from 1.25 m above a floor, with g = 10 m/s²
//! and e = 1/2: it arrives after 0.5 s at 5 m/s, its flights then last 0.5 s, 0.25 s, 0.125 s …, and infinitely many impacts end at 1.5 s.
//!
//! ```
//! use carom::motion::planar::{Body, Happening, Obstacle, Shape, Walker, World};
//! use carom::prelude::*;
//! let world = World::of_one(Vec2::new(0.0, -10.0), Body { shape: Shape::new(vec![Vec2::ZERO], 0.1)?, mass: 1.0, inertia: 0.005 }, vec![Obstacle::new(Vec2::new(-1.0, 0.0), Vec2::new(1.0, 0.0), 0.3, 0.5)], Law::Poisson);
//! let dropped = State { pose: Pose { centre: Vec2::new(0.0, 1.35), angle: 0.0 }, ..State::default() };
//! let mut walker = Walker::new(&world, dropped, vec![true], Options::default())?;
//! let mut recorder = Recorder::default();
//! while walker.advance(&mut recorder)? == Happening::Moves {}
//!
//! let trace = recorder.into_trace();
//! for (impact, time) in trace.impacts.iter().zip([0.5, 1.0, 1.25, 1.375]) {
//!     assert!((impact.time - time).abs() < 1e-14, "{} is not {time}", impact.time);
//! }
//! // The first bounce keeps e² of the 12.5 J.
//! assert!((trace.impacts[0].energy_before - 12.5).abs() < 1e-12);
//! assert!((trace.impacts[0].energy_after - 3.125).abs() < 1e-12);
//! // Once a flight lasts less than 1e-6 of √(size/g) the disc is taken to lie, and it rests.
//! let (_, limit) = trace.accumulations[0];
//! assert!((limit - 1.5).abs() < 1e-6, "{limit}");
//! assert_eq!(walker.state().twist, Twist::default());
//! # Ok::<(), carom::Error>(())
//! ```
//!
//! ## Observers
//!
//! The walk has one code path, and tells what happens to an [`Observer`](crate::motion::planar::Observer). `()` looks at nothing: that is
//! what a sweep over thousands of feeders uses. [`Recorder`](crate::motion::planar::Recorder) keeps everything. One of your own keeps what
//! you ask for; this one wants the blows of case 2 of the feeder's paper, and when a contact let go without one:
//!
//! ```
//! use carom::motion::planar::observer::{ImpactFacts, PieceFacts};
//! use carom::motion::planar::trace::{Impact, PieceEnd};
//! use carom::prelude::*;
//! use carom::tutorials::CASE_2;
//!
//! #[derive(Default)]
//! struct Blows { speeds: Vec<f64>, let_go: Vec<f64> }
//!
//! impl Observer for Blows {                               // no samples, no whole impacts: facts alone
//!     fn impact(&mut self, facts: &ImpactFacts, _whole: Option<Impact>) {
//!         self.speeds.push(facts.speed);
//!     }
//!     fn piece(&mut self, piece: &PieceFacts) {
//!         if matches!(piece.ended_by, PieceEnd::ForceZero(_)) {
//!             self.let_go.push(piece.end_time);
//!         }
//!     }
//! }
//!
//! let scene = Scene::parse("case_2.toml", CASE_2)?;
//! let mut blows = Blows::default();
//! let run = scene.feeder().prepare(Options::default())?.observed(&mut blows)?;
//! // Front, rear, lying down. An independent solution of 8 digits gives the front 0.8813396 m/s along the plate and 1.6474666 m/s into it.
//! assert_eq!((blows.speeds.len() as u64, run.effort.impacts), (3, 3));
//! let speed = (0.8813396_f64.powi(2) + 1.6474666_f64.powi(2)).sqrt();
//! assert!((blows.speeds[0] - speed).abs() < 1e-7, "{:?}", blows.speeds);
//! // At 0.8867562 s the rear end lets go of the plate, the centre being over the edge; the edge lets go 0.1167136 s later.
//! assert!((blows.let_go[0] - 0.8867562).abs() < 1e-7, "{:?}", blows.let_go);
//! assert!((blows.let_go[1] - 0.8867562 - 0.1167136).abs() < 1e-7, "{:?}", blows.let_go);
//! # Ok::<(), carom::Error>(())
//! ```
//!
//! ## The trace
//!
//! With a recorder, a run leaves its smooth *pieces*, each with the contacts held and why it ended, its *impacts* with every stage, and the
//! accumulations that were closed. Pieces join without a gap, and in flight the energy stays what it was:
//!
//! ```
//! use carom::prelude::*;
//! use carom::tutorials::CASE_2;
//! let scene = Scene::parse("case_2.toml", CASE_2)?;
//! let prepared = scene.feeder().prepare(Options::default())?;
//! let run = prepared.run()?;
//! let pieces = &run.trace.pieces;
//! assert_eq!((pieces[0].start_time, pieces.last().unwrap().end_time), (0.0, run.end_time));
//! for (one, next) in pieces.iter().zip(&pieces[1..]) {
//!     assert_eq!(one.end_time, next.start_time);
//! }
//! for flight in pieces.iter().filter(|piece| piece.held.is_empty()) {
//!     let change = prepared.world().energy(&[flight.end]) - prepared.world().energy(&[flight.start]);
//!     assert!(change.abs() < 1e-14, "{change} J");
//! }
//! // Momentum is what the impulses say, at every impact.
//! for impact in &run.trace.impacts {
//!     let mut momentum = impact.before.velocity * 0.3;
//!     for c in &impact.contacts {
//!         momentum += c.normal * c.normal_impulse + c.normal.turned_right() * c.tangential_impulse;
//!     }
//!     assert!((momentum - impact.after.velocity * 0.3).norm() < 1e-15);
//! }
//! // How certain is the verdict's course? The closest decision of the run, against the size of what was compared.
//! assert!(run.margin > 1e-3, "{} ({:?})", run.margin, run.margin_of);
//! # Ok::<(), carom::Error>(())
//! ```
//!
//! How events are found, and under which assumption none is missed, stands in decision note 3 of the repository (`docs/decisions`).
