//! Impacts in space of several bodies, and of the operator alone, against closed forms and against each other.

use carom_impact::spatial::RigidBody;
use carom_num::Vec3;
use carom_scene::{
    AnyImpact, ImpactAnswerReport, ImpactAxes, ImpactProblem, SpatialImpactProblem, SpatialImpactReport,
};

/// What rounding leaves of numbers of order one after a few stages of a walk.
const ROUNDING: f64 = 1e-13;

fn example(name: &str) -> String {
    std::fs::read_to_string(format!("../../examples/{name}")).unwrap()
}

fn read(text: &str) -> SpatialImpactProblem {
    match AnyImpact::parse("test.toml", text).unwrap_or_else(|problems| panic!("{problems}")) {
        AnyImpact::Spatial(problem) => *problem,
        AnyImpact::Planar(_) => panic!("it is in space: {text}"),
    }
}

fn problems(text: &str) -> String {
    AnyImpact::parse("test.toml", text).map(|_| ()).unwrap_err().to_string()
}

/// The bodies after, and the impulses, each in the frame of its contact.
fn after(text: &str) -> (Vec<RigidBody>, Vec<Vec3>) {
    let problem = read(text);
    let end = problem.solve().outcome.unwrap();
    let bodies = problem.group.unwrap().after(&end.impulse).unwrap();
    (bodies, end.impulse[..problem.contacts.count].to_vec())
}

fn near(ours: Vec3, exact: Vec3, what: &str) {
    assert!((ours - exact).norm() <= ROUNDING, "{what}: {ours:?} is not {exact:?}");
}

/// A solid ball of radius 1 m: J = 2/5 m.
fn ball(name: &str, mass: f64, centre: &str, moves: &str) -> String {
    let j = 0.4 * mass;
    format!(
        "[[body]]\nname = '{name}'\nmass = {mass}\ninertia = [{j}, {j}, {j}]\ncentre = {centre}\n{moves}\n"
    )
}

fn contact(between: &str, point: &str, normal: &str, friction: f64, restitution: f64) -> String {
    format!(
        "[[contact]]\nbetween = {between}\npoint = {point}\nnormal = {normal}\nfriction = {friction}\nrestitution = {restitution}\n"
    )
}

#[test]
fn two_balls_head_on_share_their_momentum() {
    for e in [0.0, 0.5, 1.0] {
        let text = ball("a", 1.0, "[0, 0, 0]", "velocity = [3, 0, 0]")
            + &ball("b", 2.0, "[2, 0, 0]", "")
            + &contact("['b', 'a']", "[1, 0, 0]", "[1, 0, 0]", 0.3, e);
        let (bodies, impulses) = after(&text);
        // p = (1 + e) u/(1/m₁ + 1/m₂)
        let p = (1.0 + e) * 3.0 / 1.5;
        near(impulses[0], Vec3::Z * p, "impulse");
        near(bodies[0].velocity, Vec3::X * (3.0 - p), "first");
        near(bodies[1].velocity, Vec3::X * (0.5 * p), "second");
    }
}

/// W of two equal solid balls is 2 · 7/2 across the normal and 2 along it: an oblique contact sticks where μ ≥ |u_t|/(7 p).
#[test]
fn two_balls_that_meet_obliquely_slide_or_stick() {
    let normal = Vec3::new(1.0, 2.0, 2.0) / 3.0;
    let velocity = Vec3::new(2.0, -1.0, 0.5);
    let (rises, slip) = (velocity.dot(normal), velocity - normal * velocity.dot(normal));
    for (friction, e) in [(0.05, 0.5), (0.4, 0.5), (2.0, 0.25)] {
        let text = ball("a", 1.0, "[0, 0, 0]", "velocity = [2, -1, 0.5]")
            + &ball("b", 1.0, "[2, 4, 4]", "").replace("[0.4, 0.4, 0.4]", "[3.6, 3.6, 3.6]")
            + &contact("['b', 'a']", "[1, 2, 2]", "[1, 2, 2]", friction, e);
        // Balls of radius 3 m: J = 2/5 · 9.
        let text = text.replace("[0.4, 0.4, 0.4]", "[3.6, 3.6, 3.6]");
        let (bodies, _) = after(&text);
        let p = (1.0 + e) * rises / 2.0;
        let drag = (friction * p).min(slip.norm() / 7.0);
        let impulse = normal * p + slip.unit().unwrap() * drag;
        near(bodies[0].velocity, velocity - impulse, "first");
        near(bodies[1].velocity, impulse, "second");
        let turned = (normal * 3.0).cross(impulse) / 3.6;
        near(bodies[0].spin, -turned, "spin of the first");
        near(bodies[1].spin, -turned, "spin of the second: friction turns both alike");
    }
}

/// In space the normals lie along 1, 2, 2 and the balls are 1/10 as far apart; head on no lever enters.
#[test]
fn a_cradle_in_space_ends_as_that_of_the_plane() {
    for e in ["1", "0.7"] {
        let spatial =
            example("impact_space_cradle.toml").replace("restitution = 1", &format!("restitution = {e}"));
        let planar = example("impact_cradle.toml")
            .replace("sharing = \"by stiffness\"", "")
            .replace("exponent = 1.5", "")
            .replace("restitution = 1", &format!("restitution = {e}"))
            .replace("\"1 m/s\"", "\"3 m/s\"");
        let planar = ImpactProblem::parse("planar.toml", &planar).unwrap();
        let planar = ImpactAnswerReport::new(&planar, &planar.solve());
        let report = SpatialImpactReport::new(&read(&spatial), &read(&spatial).solve());
        let (flat, deep) = (planar.staged.unwrap().end, report.end.unwrap());
        assert_eq!((flat.bodies.len(), deep.bodies.len()), (3, 3), "three balls");
        for (flat, deep) in flat.bodies.iter().zip(&deep.bodies) {
            let along = Vec3::new(1.0, 2.0, 2.0) / 3.0 * flat.velocity_m_s[0];
            near(Vec3::from_array(deep.velocity_m_s), along, &deep.name);
        }
        for (flat, deep) in flat.contacts.iter().zip(&deep.contacts) {
            let apart = (flat.normal_impulse - deep.normal_impulse).abs();
            assert!(apart <= ROUNDING, "{}: {apart:e}", deep.name);
        }
        let energies = [(flat.energy_before, deep.energy_before), (flat.energy_after, deep.energy_after)];
        for (flat, deep) in energies {
            assert!((flat.unwrap() - deep.unwrap()).abs() <= ROUNDING * 10.0, "{flat:?} {deep:?}");
        }
    }
}

#[test]
fn a_body_and_its_operator_take_the_same_impulses() {
    let operator = read(&example("impact_space_operator.toml"));
    let corner = |x: &str| {
        format!(
            "[[contact]]\npoint = [{x}, -0.5, 0]\nnormal = [0, 0, 1]\nfriction = 0.2\nrestitution = 0.5\n"
        )
    };
    let plate = format!(
        "[body]\nmass = 1\ninertia = [{0}, {0}, {1}]\nvelocity = [0.3, 0.1, -1]\n",
        1.0 / 12.0,
        1.0 / 6.0
    );
    let plate = read(&(plate + &corner("-0.5") + &corner("0.5")));
    let [body, alone] = [plate.solve().outcome.unwrap(), operator.solve().outcome.unwrap()];
    assert!(body.impulse[0].z > 0.0 && body.impulse[0].x < 0.0, "it is pushed and braked");
    for i in 0..2 {
        near(alone.impulse[i], body.impulse[i], "impulse");
        near(alone.velocity[i], body.velocity[i], "velocity after");
    }
    let report = SpatialImpactReport::new(&operator, &operator.solve());
    let end = report.end.unwrap();
    assert_eq!((report.axes, end.velocity_m_s, end.energy_before), (ImpactAxes::Contact, None, None));
    assert_eq!(end.contacts[0].impulse, body.impulse[0].to_array(), "tangent 1, tangent 2, normal");
}

#[test]
fn what_is_fixed_is_an_obstacle_and_may_move() {
    let moves = "velocity = [1, 0.5, -2]\nspin = [0.3, -1, 2]";
    let alone = "[body]\nmass = 1\ninertia = [0.4, 0.4, 0.4]\n".to_owned()
        + moves
        + "\n[[contact]]\npoint = [0, 0, -1]\nnormal = [0, 0, 1]\nfriction = 0.2\nrestitution = 0.5\n";
    let alone = read(&alone);
    let alone = alone.after(&alone.solve().outcome.unwrap()).unwrap();
    let floor = |more: &str| format!("[[body]]\nname = 'floor'\nkind = 'fixed'\n{more}\n");
    let ball = |moves: &str| ball("ball", 1.0, "[0, 0, 5]", moves);
    let onto = contact("['ball', 'floor']", "[0, 0, 4]", "[0, 0, 1]", 0.2, 0.5);
    let (bodies, _) = after(&(ball(moves) + &floor("") + &onto));
    near(bodies[0].velocity, alone.velocity, "on a floor");
    near(bodies[0].spin, alone.spin, "on a floor");
    // The other way round: the normal points into the floor, and what is said of the contact is about the floor.
    let other = contact("['floor', 'ball']", "[0, 0, 4]", "[0, 0, -1]", 0.2, 0.5);
    let [ways, turned] = [onto.as_str(), &other].map(|c| {
        let problem = read(&(ball(moves) + &floor("") + c));
        SpatialImpactReport::new(&problem, &problem.solve()).end.unwrap()
    });
    assert_eq!(ways.bodies, turned.bodies, "the ball does the same");
    assert_eq!(turned.contacts[0].impulse, ways.contacts[0].impulse.map(|p| -p), "on the floor");
    assert_eq!(turned.contacts[0].normal_impulse, ways.contacts[0].normal_impulse, "it pushes");
    // A floor that moves and turns is the same impact, seen by somebody else.
    let lift = "centre = [1, 0, 4]\nvelocity = [1, 0, 3]\nspin = [0, 2, 1]";
    // v + ω × (−1, 0, 0) at the point of contact.
    let there = Vec3::new(1.0, 0.0, 3.0) + Vec3::new(0.0, 2.0, 1.0).cross(-Vec3::X);
    let hurried = Vec3::new(1.0, 0.5, -2.0) + there;
    let moves = format!("velocity = [{}, {}, {}]\nspin = [0.3, -1, 2]", hurried.x, hurried.y, hurried.z);
    let (bodies, _) = after(&(ball(&moves) + &floor(lift) + &onto));
    near(bodies[0].velocity, alone.velocity + there, "on a floor that moves");
    near(bodies[0].spin, alone.spin, "on a floor that moves");
    near(bodies[1].velocity, Vec3::new(1.0, 0.0, 3.0), "which nothing moves");
}

#[test]
fn momentum_and_angular_momentum_are_kept_and_energy_is_not_made() {
    let text = example("impact_space_balls.toml");
    let problem = read(&text);
    let (bodies, impulses) = after(&text);
    let group = problem.group.as_ref().unwrap();
    let cushion = problem.contacts.frame[1].transposed() * impulses[1];
    let momentum = |bodies: &[RigidBody]| (bodies[0].velocity + bodies[1].velocity) * bodies[0].mass;
    near(momentum(&bodies), momentum(&group.bodies) + cushion, "momentum, with what the cushion gives");
    let report = SpatialImpactReport::new(&problem, &problem.solve());
    let end = report.end.unwrap();
    assert!(end.energy_after < end.energy_before && end.energy_after > Some(0.3), "{end:?}");
    assert_eq!(bodies[2].velocity, Vec3::ZERO, "the cushion");
}

#[test]
fn every_problem_of_a_file_in_space_is_told() {
    let told = |text: &str, wanted: &[&str]| {
        let said = problems(text);
        for what in wanted {
            assert!(said.contains(what), "{what}: {said}");
        }
    };
    told(
        &example("impact_space_balls.toml")
            .replace("\"170 g\"", "\"-170 g\"")
            .replace("\"red\", \"cue\"", "\"red\", \"blue\"")
            .replace("[0, -1, 0]", "[0, 0, 0]"),
        &[
            "body.0.mass",
            "body.1.mass",
            "contact.0.between",
            "no body is called \"blue\"",
            "contact.1.normal",
        ],
    );
    told(
        &example("impact_space_balls.toml").replace("\"red\", \"cushion\"", "\"cushion\", \"cushion\""),
        &["twice"],
    );
    told(
        &example("impact_space_balls.toml").replace("between     = [\"red\", \"cushion\"]", ""),
        &["contact.1.between", "missing: two names [into, out_of]"],
    );
    told(
        &example("impact_space_cradle.toml").replace("inertia  = [4e-4, 4e-4, 4e-4]", "inertia = [1, 1, 3]"),
        &["body.0", "principal moments"],
    );
    let two = ball("a", 1.0, "[0, 0, 0]", "velocity = [0, 0]") + &ball("a", 1.0, "[2, 0, 0]", "");
    told(
        &(two + &contact("['a', 'a']", "[1, 0]", "[1, 0, 0]", 0.3, 1.0)),
        &["body.0.velocity", "mixes plane and space", "contact.0.point", "two bodies are called \"a\""],
    );
    told(
        "[operator]\nmatrix = [[1, 0, 0], [0, 1, 0], [0, 0, -1]]\nvelocity = [[0, 0, -1]]\nfriction = [1, 2]",
        &["operator.matrix", "no negative eigenvalue", "operator.friction", "expected 1 number, found 2"],
    );
    told(
        "[operator]\nmatrix = [[1, 0], [0, 1]]\nvelocity = [[0, -1, 2], [1, 2]]\n[body]\nmass = 1",
        &[
            "three rows for each contact",
            "operator.velocity.1",
            "mixes plane and space",
            "friction",
            "does not go together with [operator]",
        ],
    );
}
