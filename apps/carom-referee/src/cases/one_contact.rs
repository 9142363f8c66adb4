//! A free body in the plane that is struck at one contact: Routh's walk in closed form, under three laws of restitution.

use super::engine::distinct;
use super::{Draw, named};
use crate::case::{Body, Case, Known, Spin};
use crate::motion::Bodies;
use carom_num::elementary::{cos, sin};
use carom_scene::ImpactProblem;
use carom_theory::free_body::{FreeBody, PlanarVelocity, contact_velocity, into_contact_frame};
use carom_theory::single_contact::{Contact, Law, resolve};
use serde_json::{Value, json};

/// Cases of bodies of any form, under each law.
const BODIES: usize = 80;
/// Of these, every so many starts without slip.
const WITHOUT_SLIP: usize = 8;
/// Cases of balls: all laws agree.
const BALLS: usize = 44;
const LAWS: [(Law, &str); 3] =
    [(Law::Poisson, "poisson"), (Law::Stronge, "stronge"), (Law::Newton, "newton")];
const SOURCE: &str = "Routh's walk in closed form (carom_theory::single_contact): Wang and Mason, J. Appl. Mech. 59 (1992) 635; Stronge, Proc. R. Soc. A 431 (1990) 169";

pub(super) fn cases() -> Vec<Case> {
    let bodies = LAWS.iter().flat_map(|law| (0..BODIES).filter_map(|i| body(*law, i)));
    bodies.chain((0..BALLS).filter_map(ball)).collect()
}

/// A body of any form: mass and gyration, where it is touched, how it comes.
fn body((law, word): (Law, &str), number: usize) -> Option<Case> {
    let draw = Draw::new(11, number)?;
    let (mass, gyration) = (draw.times(0.05, 5.0), draw.between(0.02, 0.1));
    let (arm, angle) = ([draw.between(-0.08, 0.08), draw.between(-0.08, -0.005)], draw.between(-3.1, 3.1));
    let (friction, restitution) = (draw.between(0.0, 1.0), draw.between(0.0, 1.0));
    let (approach, slip, spin) =
        (draw.between(-3.0, -0.3), draw.between(-3.0, 3.0), draw.between(-15.0, 15.0));
    let inertia = super::rounded(mass * gyration * gyration, 9);
    let file = if number.is_multiple_of(WITHOUT_SLIP) {
        // Without spin, straight down, on a level surface: exactly without slip.
        json!({ "law": word,
            "body": { "mass": mass, "inertia": inertia, "velocity": [0.0, approach], "spin": 0.0 },
            "contact": [{ "point": arm, "normal": [0, 1], "friction": friction, "restitution": restitution }] })
    } else {
        let turned = |v: [f64; 2]| {
            let (s, c) = (sin(angle), cos(angle));
            [c * v[0] - s * v[1], s * v[0] + c * v[1]].map(|x| super::rounded(x, 4))
        };
        let velocity = turned([slip + spin * arm[1], approach - spin * arm[0]]);
        json!({ "law": word,
            "body": { "mass": mass, "inertia": inertia, "velocity": velocity, "spin": spin },
            "contact": [{ "point": turned(arm), "normal": turned([0.0, 1.0]), "friction": friction,
                "restitution": restitution }] })
    };
    case(&format!("one contact, {word}"), number, (law, file))
}

/// A ball on a level surface: every law gives e times the approach, and friction turns it.
fn ball(number: usize) -> Option<Case> {
    let draw = Draw::new(13, number)?;
    let (mass, radius) = (draw.times(0.01, 10.0), draw.between(0.01, 0.1));
    let (approach, slip, spin) =
        (draw.between(-4.0, -0.5), draw.between(-2.0, 2.0), draw.between(-20.0, 20.0));
    let restitution = super::rounded((number % 11) as f64 / 10.0, 1);
    let friction = [0.0, 0.1, 0.3, 0.8][number / 11 % 4];
    let inertia = super::rounded(0.4 * mass * radius * radius, 9);
    let file = json!({ "law": "poisson",
        "body": { "mass": mass, "inertia": inertia, "velocity": [slip, approach], "spin": spin },
        "contact": [{ "point": [0.0, -radius], "normal": [0, 1], "friction": friction, "restitution": restitution }] });
    case("ball", number, (Law::Poisson, file))
}

fn case(group: &str, number: usize, (law, impact): (Law, Value)) -> Option<Case> {
    let name = named(group, number);
    let problem = ImpactProblem::parse_json(&name, &impact.to_string()).ok()?;
    let bodies = Bodies::of_plane(&problem)?;
    let known = |(law, word): &(Law, &str)| -> Option<Known> {
        Some(Known::after(word, vec![after(&problem, *law)?]))
    };
    let (asked, beside): (Vec<_>, Vec<_>) = LAWS.iter().partition(|(other, _)| *other == law);
    let answers = asked.into_iter().map(known).collect::<Option<Vec<_>>>()?;
    let others = beside.into_iter().map(known).collect::<Option<Vec<_>>>()?;
    let expected = distinct(&bodies, answers, others);
    Some(Case::of_impact((group, name), impact, expected, SOURCE))
}

/// The body after, by the closed forms.
fn after(problem: &ImpactProblem, law: Law) -> Option<Body> {
    let body = problem.body.as_ref()?;
    let [touch] = &body.touches[..] else { return None };
    let normal = [touch.normal.x, touch.normal.y];
    let within = |v: [f64; 2]| into_contact_frame(normal, v);
    let arm = within([touch.arm.x, touch.arm.y]);
    let [first, second] = within([body.velocity.x, body.velocity.y]);
    let (free, before) = (
        FreeBody { mass: body.mass, inertia: body.inertia },
        PlanarVelocity { first, second, spin: body.spin },
    );
    let [slip, approach] = contact_velocity(before, arm);
    let (friction, restitution) = (touch.friction, touch.restitution);
    let contact = Contact { w: free.operator(arm), slip, approach, friction, restitution };
    let impact = resolve(&contact, law).ok()?;
    let after = free.after_impulse(before, arm, [impact.tangential_impulse, impact.normal_impulse]);
    // Back into the file's axes: the tangent is (n_y, -n_x).
    let ([n_x, n_y], [t, n]) = (normal, [after.first, after.second]);
    let velocity_m_s = vec![n_y * t + n_x * n, -n_x * t + n_y * n];
    Some(Body { velocity_m_s, spin_rad_s: Spin::Plane(after.spin) })
}
