//! # A first feeder
//!
//! A gravity-impact feeder turns parts over without a motor: a part slides down a plate, tips over the plate's edge, falls, strikes the next
//! plate and comes to lie on the same side, or on the other. Which of the two is a matter of millimetres and degrees. This tutorial runs a
//! published feeder from its drawing, reads the result, checks what can be checked by hand, and asks how far the verdict holds.
//!
//! ## From a drawing to a verdict
//!
//! A scene is what stands on the drawing, in TOML and with units. This is the second example of the feeder's paper: a rod of 0.1 m and 0.3 kg
//! lies on a plate that descends at 10° to the right, its mass centre 0.1 m before the edge. The lower plate descends to the left; its line
//! is `x/0.428 + y/0.3 = 1` in the upper plate's axes, x down along it and y down through it.
//!
//! ```
//! use carom::prelude::*;
//! let scene = Scene::parse("case_2.toml", r#"
//!     [part]
//!     shape   = "rod"
//!     length  = "100 mm"
//!     mass    = "0.3 kg"
//!     inertia = "2.5e-4 kg m^2"
//!
//!     [contact]
//!     friction    = 0.15
//!     restitution = 0.0
//!
//!     [start]
//!     to_edge = "100 mm"
//!
//!     [[plate]]
//!     name  = "upper"
//!     slope = "10 deg"
//!
//!     [[plate]]
//!     name     = "lower"
//!     downhill = "left"
//!     line     = { along = "428 mm", normal = "300 mm" }
//! "#)?;
//! let run = scene.feeder().run()?;
//!
//! assert_eq!(run.outcome, Outcome::Landed);
//! let landing = &run.landings[0];
//! assert_eq!(landing.verdict, Some(Verdict::Turned));
//! assert_eq!((landing.plate, landing.face), (1, Some(1)));
//! # Ok::<(), carom::Error>(())
//! ```
//!
//! The paper's first example has a steeper upper plate and a nearer lower one. Its rod lands on the side it started on:
//!
//! ```
//! use carom::prelude::*;
//! use carom::tutorials::CASE_2;
//! let case_1 = Scene::parse("case_2.toml", CASE_2)?
//!     .with("plate.upper.slope", 15_f64.to_radians())?
//!     .with("plate.lower.line.along", 0.347)?
//!     .with("plate.lower.line.normal", 0.2)?;
//! let run = case_1.feeder().run()?;
//! assert_eq!(run.landings[0].verdict, Some(Verdict::Same));
//! # Ok::<(), carom::Error>(())
//! ```
//!
//! ## How it came about
//!
//! Nobody told the engine to slide, tip and fly. It walked from event to event, and the feeder gave the pieces their names afterwards:
//!
//! ```
//! use carom::prelude::*;
//! use carom::tutorials::CASE_2;
//! let scene = Scene::parse("case_2.toml", CASE_2)?;
//! let run = scene.feeder().run()?;
//! use carom::num::elementary::{cos, sin};
//! let names: Vec<StageName> = run.stages.iter().map(|stage| stage.name).collect();
//! assert_eq!(names[..3], [StageName::Slide, StageName::Tip, StageName::Flight]);
//!
//! // By hand: down the plate a = g (sin α − μ cos α), over the 0.1 m until the centre is at the edge.
//! let alpha = 10_f64.to_radians();
//! let a = 9.81 * (sin(alpha) - 0.15 * cos(alpha));            // 0.2543 m/s²
//! let slide = &run.stages[0];
//! assert!((slide.end_time - (2.0 * 0.1 / a).sqrt()).abs() < 1e-9);                       // 0.8868 s
//! assert!((slide.end.twist.velocity.norm() - (2.0 * a * 0.1).sqrt()).abs() < 1e-9);      // 0.2255 m/s
//! assert!(matches!(slide.ended_by, carom::feeder::StageEnd::CentreAtEdge(_)));
//!
//! // Then it tips, and lifts off the edge when the normal force comes to zero, at 25.127° to the plate. Tipping has no closed
//! // form; these are the digits of an independent solution (Radau and DOP853). Our spins are counter-clockwise.
//! let tip = &run.stages[1];
//! assert!(matches!(tip.ended_by, carom::feeder::StageEnd::LiftsOff(_)));
//! assert!((tip.end_time - tip.start_time - 0.11671355).abs() < 1e-8);
//! assert!((-tip.end.pose.angle.to_degrees() - 10.0 - 25.12714143).abs() < 1e-6);
//! assert!((tip.end.twist.spin + 7.61525168).abs() < 1e-6);
//!
//! // In flight spin and horizontal velocity stay, and the rod falls freely for 0.14155608 s.
//! let flight = &run.stages[2];
//! let fall = flight.end_time - flight.start_time;
//! assert!((fall - 0.14155608).abs() < 1e-8);
//! assert_eq!(flight.end.twist.spin, flight.start.twist.spin);
//! let gained = flight.start.twist.velocity.y - flight.end.twist.velocity.y;
//! assert!((gained - 9.81 * fall).abs() < 1e-12);
//! # Ok::<(), carom::Error>(())
//! ```
//!
//! ## The strike
//!
//! The front end strikes first. With no restitution its normal velocity after is zero, and one would expect the rod to turn about that end.
//! It does not. The rod now spins so fast that its centre's path bends away from the plate: holding the end down would take a *pull* of
//! 6.27 N, so the end lifts off again at once. This is decided by asking the rate problem after every impact.
//!
//! ```
//! use carom::prelude::*;
//! use carom::tutorials::CASE_2;
//! let scene = Scene::parse("case_2.toml", CASE_2)?;
//! let run = scene.feeder().run()?;
//! let strike = &run.trace.impacts[0];
//! assert_eq!(carom::words::part::feature(scene.feeder(), strike.contacts[0].feature), "front");
//! assert_eq!(strike.kind, Some(ImpactType::SlidesThroughout));
//! assert!((strike.contacts[0].before.normal + 1.64746658).abs() < 1e-7);
//! assert!((strike.after.spin + 31.85795377).abs() < 1e-6);
//! assert!((strike.holding_would_need.unwrap() + 6.27).abs() < 0.005);
//!
//! // While it slides throughout, friction has one direction: p_t = 0.15 p_n.
//! let contact = &strike.contacts[0];
//! assert!((contact.tangential_impulse.abs() - 0.15 * contact.normal_impulse).abs() < 1e-15);
//! // Energy is lost to both impulses, and the books balance.
//! let lost = strike.energy_before - strike.energy_after;
//! assert!(lost > 0.0 && (lost + contact.normal_work + contact.tangential_work).abs() < 1e-14);
//! # Ok::<(), carom::Error>(())
//! ```
//!
//! ## How far does the verdict hold?
//!
//! A feeder's plates are never at the angle of the drawing. [`Scene::with`](crate::scene::Scene::with) changes one quantity by its path, and
//! a run that keeps no trace is quick, so one may simply ask. Here the upper plate descends at 15°, and the lower one is drawn by its slope and
//! a point 0.34 m under the edge, square to the upper plate:
//!
//! ```
//! use carom::prelude::*;
//! let scene = Scene::parse("which_way_up.toml", r#"
//!     [part]
//!     shape   = "rod"
//!     length  = "100 mm"
//!     mass    = "0.3 kg"
//!     inertia = "2.5e-4 kg m^2"
//!     [contact]
//!     friction = 0.15
//!     [start]
//!     to_edge = "100 mm"
//!     [[plate]]
//!     name  = "upper"
//!     slope = "15 deg"
//!     [[plate]]
//!     name     = "lower"
//!     downhill = "left"
//!     slope    = "20 ± 0.5 deg"
//!     below    = { x = "-88 mm", y = "-328.4 mm" }       # seen from the upper plate's edge
//! "#)?;
//! let verdict = |degrees: f64| -> Result<Option<Verdict>, Error> {
//!     let run = scene.with("plate.lower.slope", degrees.to_radians())?.feeder().run_untraced()?;
//!     Ok(run.landings.last().and_then(|landing| landing.verdict))
//! };
//! // Flat and steep plates turn the rod over, and those between do not. (An independent program says the same of these ten.)
//! for degrees in [2.0, 6.0, 10.0, 30.0, 34.0, 38.0] {
//!     assert_eq!(verdict(degrees)?, Some(Verdict::Turned), "{degrees}°");
//! }
//! for degrees in [14.0, 18.0, 22.0, 26.0] {
//!     assert_eq!(verdict(degrees)?, Some(Verdict::Same), "{degrees}°");
//! }
//! // The verdict flips between 26° and 30°; bisection says where, and how much room a drawing at 20° has.
//! let (mut same, mut turned) = (26.0, 30.0);
//! while turned - same > 1e-6 {
//!     let middle = 0.5 * (same + turned);
//!     if verdict(middle)? == Some(Verdict::Same) { same = middle } else { turned = middle }
//! }
//! assert!(verdict(same)? == Some(Verdict::Same) && verdict(turned)? == Some(Verdict::Turned));
//! # Ok::<(), carom::Error>(())
//! ```
//!
//! The command `carom run --limits` does this for every quantity of a scene. The example program `which_way_up` of this crate sweeps the slope.
//!
//! ## Without a file
//!
//! A program that makes its own feeders fills a [`Feeder`](crate::feeder::Feeder) in SI units. A drawing and a program meet here: a scene is
//! nothing but a checked way to get one.
//!
//! ```
//! use carom::prelude::*;
//! let plate = |name: &str, uphill: Vec2, edge: Vec2| Plate {
//!     name: name.into(), uphill, edge, friction: 0.15, restitution: 0.0, unbounded: false, form: Default::default(),
//! };
//! let downhill = Vec2::at_angle(-10_f64.to_radians());
//! let left = Vec2::at_angle(205_f64.to_radians());
//! let under = Vec2::new(0.0, -0.27);
//! let feeder = Feeder {
//!     gravity: 9.81,
//!     stop: Stop::Landed,
//!     law: Law::Poisson,
//!     part: Part::rod(0.1, 0.3, 2.5e-4).unwrap(),
//!     start: Start { to_edge: 0.1, speed: 0.0, face: 0 },
//!     plates: vec![
//!         plate("upper", downhill * -0.3, Vec2::ZERO),
//!         plate("lower", under - left * 0.4, under + left * 0.4),
//!     ],
//!     walls: vec![],
//! };
//! assert_eq!(feeder.run()?.landings[0].verdict, Some(Verdict::Turned));
//!
//! // What cannot be a feeder says so, all at once.
//! let mut wrong = feeder.clone();
//! wrong.gravity = -9.81;
//! wrong.plates[1].restitution = 1.5;
//! let error = Error::from(wrong.run().unwrap_err());
//! assert!(error.is_input());
//! assert_eq!(error.to_string(), "gravity = -9.81: above 0 m/s²; plate.lower.restitution = 1.5: 0 to 1");
//! # Ok::<(), carom::Error>(())
//! ```
//!
//! ## A picture
//!
//! [`figure::report`](crate::figure::report) makes one HTML page of a run, with layout, animation, plots and impulse diagrams; it needs no
//! network. The command `carom run` writes it to a file.
//!
//! ```
//! use carom::prelude::*;
//! use carom::tutorials::CASE_2;
//! let scene = Scene::parse("case_2.toml", CASE_2)?;
//! let run = scene.feeder().run()?;
//! let page = carom::figure::report(scene.feeder(), &run, scene.name(), &Default::default());
//! assert!(page.starts_with("<!DOCTYPE html>") && page.contains("case_2"));
//! # Ok::<(), carom::Error>(())
//! ```
