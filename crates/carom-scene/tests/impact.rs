//! Impacts from files: answers that can be checked by hand, and problems.

use crate::held;

use carom_scene::{
    Form, ImpactAnswer, ImpactAnswerReport, ImpactOutcome, ImpactProblem, SharingVerdict, Uniqueness,
};

/// The strike of the feeder paper's case 2: printed state before, exact state after (ω 31.972, v_τ 0.408).
const CASE_2: &str = r#"
law = "poisson"
[body]
mass     = 0.3
inertia  = 2.5e-4
velocity = [0.558, -1.852]
spin     = "7.637 rad/s"
[[contact]]
name        = "K"
point       = [0.0266, -0.0423]
normal      = [0, 1]
friction    = 0.15
restitution = 0.0
"#;

fn report(text: &str) -> ImpactAnswerReport {
    let problem = problem_of(text);
    ImpactAnswerReport::new(&problem, &problem.solve())
}

#[test]
fn an_impact_of_the_feeder_slides_throughout() {
    let report = report(CASE_2);
    let staged = report.staged.as_ref().unwrap();
    assert_eq!((report.outcome, staged.kind), (ImpactOutcome::Unique, Some(1)));
    assert_eq!(staged.end.contacts[0].normal_velocity_m_s, 0.0);
    assert!(staged.end.energy_after < staged.end.energy_before, "{staged:?}");
    assert!(!staged.path_dependent, "it ends where the one-step law ends");
    insta::assert_snapshot!(serde_json::to_string_pretty(&report).unwrap());
}

#[test]
fn a_ball_dropped_straight_leaves_at_e_times_its_speed() {
    let text = "[body]\nmass = 2\ninertia = 1\nvelocity = [0, -3]\n[[contact]]\npoint = [0, -0.1]\nnormal = [0, 2]\nfriction = 0.3\nrestitution = 0.5\n";
    let report = report(text);
    let staged = report.staged.unwrap();
    assert_eq!(staged.end.velocity_m_s, Some([0.0, 1.5]));
    assert_eq!(staged.end.contacts[0].normal_impulse, 9.0);
    assert_eq!((staged.end.energy_before, staged.end.energy_after), (Some(9.0), Some(2.25)));
}

#[test]
fn the_operator_alone_gives_the_same_impact() {
    let operator = "[operator]\nw_tt = 3.5\nw_tn = 0\nw_nn = 1\nslip = 0\napproach = -2\nfriction = 0.3\nrestitution = 0.5\n";
    let matrix =
        "[operator]\nmatrix = [[3.5, 0], [0, 1]]\nvelocity = [0, -2]\nfriction = 0.3\nrestitution = [0.5]\n";
    let [one, other] = [operator, matrix].map(report);
    assert_eq!(one, other);
    let staged = one.staged.unwrap();
    assert_eq!((staged.end.contacts[0].normal_velocity_m_s, staged.end.velocity_m_s), (1.0, None));
}

#[test]
fn json_lines_have_the_same_keys() {
    let json = r#"{"law":"poisson","body":{"mass":0.3,"inertia":2.5e-4,"velocity":[0.558,-1.852],"spin":7.637},"contact":[{"name":"K","point":[0.0266,-0.0423],"normal":[0,1],"friction":0.15}]}"#;
    let problem = ImpactProblem::parse_json("line 1", json).unwrap();
    assert_eq!(ImpactAnswerReport::new(&problem, &problem.solve()), report(CASE_2));
}

macro_rules! says {
    ($($name:ident: $text:expr;)*) => { $(
        #[test]
        fn $name() {
            held::file(Form::Impact, $text);
            let problems = ImpactProblem::parse("impact.toml", $text).expect_err("it has problems");
            insta::assert_snapshot!(problems.to_string());
        }
    )* };
}

says! {
    nothing: "";
    bad_body: "law = \"newtn\"\n[body]\nmass = -1\ninertia = \"1 kg\"\nvelocity = [1]\nspn = 3\n[[contact]]\npoint = [0, 0]\nnormal = [0, 0]\nfriction = -1\nrestitution = 2\n";
    impossible_operator: "[operator]\nw_tt = 1\nw_tn = 2\nw_nn = 1\nslip = 0\napproach = 1\nfriction = 0.3\n";
    skew_matrix: "[operator]\nmatrix = [[1, 0.5], [0, 1]]\nvelocity = [0, -2]\nfriction = 0.3\n";
    indefinite_matrix: "[operator]\nmatrix = [[1, 2], [2, 1]]\nvelocity = [0, -2]\nfriction = 0.3\n";
    lists_of_wrong_length: "[operator]\nmatrix = [[1, 0], [0]]\nvelocity = [0, -2, 1]\nfriction = [0.3, 0.2]\n";
    matrix_and_lists: "[operator]\nmatrix = [[1, 0, 0, 0], [0, 1, 0], [0, 0, 1, 0], [0, 0, 0, 1]]\nvelocity = [0, -2]\nfriction = -1\nrestitution = [0.5, 2]\n";
    operator_and_body: "[operator]\nw_tt = 1\nw_tn = 0\nw_nn = 1\nslip = 0\napproach = -1\nfriction = 0.3\n[body]\nmass = 1\n";
    too_many_contacts: &format!("[body]\nmass = 1\ninertia = 1\nvelocity = [0, 0]\n{}", "[[contact]]\npoint = [0, 0]\nnormal = [0, 1]\nfriction = 0\n".repeat(25));
    many_that_share_in_sequence: &format!("sharing = \"in sequence\"\n{}", feet(7));
    two_contacts_of_one_name: "[body]\nmass = 1\ninertia = 1\nvelocity = [0, -1]\n[[contact]]\npoint = [0, -1]\nnormal = [0, 1]\nfriction = 0\n[[contact]]\nname = \"A\"\npoint = [1, -1]\nnormal = [0, 1]\nfriction = 0\n";
}

/// A box of 2 kg that comes down flat on so many feet, with restitution 0.5.
fn feet(count: u32) -> String {
    let foot = |k: u32| {
        let x = 0.1 * f64::from(k) - 0.05 * f64::from(count - 1);
        format!("[[contact]]\npoint = [{x}, -0.2]\nnormal = [0, 1]\nfriction = 0.3\nrestitution = 0.5\n")
    };
    let feet: String = (0..count).map(foot).collect();
    format!("[body]\nmass = 2\ninertia = 0.1\nvelocity = [0, -1]\n{feet}")
}

#[test]
fn a_box_on_eight_feet_has_one_motion_and_many_impulses() {
    let report = report(&feet(8));
    assert_eq!(
        (report.outcome, report.uniqueness, report.end_states.len()),
        (ImpactOutcome::Found, Uniqueness::NotExamined, 1)
    );
    assert!(report.staged.is_none() && report.sharing.is_empty() && report.rejected.is_empty(), "{report:?}");
    let end = &report.end_states[0];
    let sum: f64 = end.end.contacts.iter().map(|c| c.normal_impulse).sum();
    assert!((sum - 3.0).abs() < 1e-12, "m v (1 + e) is 3 N s, found {sum}");
    assert!(end.indeterminate && !end.gained_energy, "{end:?}");
    let [_, up] = end.end.velocity_m_s.unwrap();
    assert!((up - 0.5).abs() < 1e-12, "{up}");
}

#[test]
fn of_many_hypotheses_the_first_are_told_and_the_rest_counted() {
    // What is told and what is left out are together what the library rejects.
    for (count, all) in [(4, true), (6, false)] {
        let problem = problem_of(&feet(count));
        let answer = problem.solve();
        let report = ImpactAnswerReport::new(&problem, &answer);
        let ImpactAnswer::Examined(examined) = answer else { panic!("{count} contacts are examined") };
        let rejected = examined.ends.rejected.len();
        assert_eq!(report.rejected.len() + report.rejected_left_out, rejected);
        assert_eq!(report.rejected_left_out == 0, all, "{rejected} at {count} contacts");
        assert!(report.rejected.len() <= 4096, "{}", report.rejected.len());
    }
}

/// Eight equal balls in a row: together they reach an eighth of the first one's velocity, and restitution repeats every impulse.
#[test]
fn a_row_of_eight_balls_is_resolved_by_its_bodies_and_by_its_matrix_alike() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/impact_row.toml");
    let bodies = report(&std::fs::read_to_string(path).unwrap());
    let end = &bodies.end_states[0];
    for (k, body) in end.end.bodies.iter().enumerate() {
        let speed = if k == 0 { -0.75 } else { 0.25 };
        assert!((body.velocity_m_s[0] - speed).abs() < 1e-14, "{k}: {body:?}");
    }
    assert!(!end.indeterminate && !end.gained_energy, "{end:?}");
    // A ball's J is 0.4 m r², so a rolling contact of two adds 2.5 to either tangential entry.
    let entry = |i: usize, j: usize| match (i / 2).abs_diff(j / 2) {
        _ if i % 2 != j % 2 => 0.0,
        0 => [7.0, 2.0][i % 2],
        1 => [1.5, -1.0][i % 2],
        _ => 0.0,
    };
    let matrix: Vec<Vec<f64>> = (0..14).map(|i| (0..14).map(|j| entry(i, j)).collect()).collect();
    let velocity: Vec<f64> = (0..14).map(|i| if i == 1 { -1.0 } else { 0.0 }).collect();
    let operator = report(&format!(
        "[operator]\nmatrix = {matrix:?}\nvelocity = {velocity:?}\nfriction = 0.1\nrestitution = 1\n"
    ));
    for (a, b) in end.end.contacts.iter().zip(&operator.end_states[0].end.contacts) {
        assert!((a.normal_impulse - b.normal_impulse).abs() < 1e-14, "{a:?} {b:?}");
        assert!((a.normal_velocity_m_s - b.normal_velocity_m_s).abs() < 1e-14, "{a:?} {b:?}");
    }
}

#[test]
fn few_contacts_are_examined_and_springs_count_whatever_is_asked_for() {
    let soft = CRADLE.replacen("restitution = 1\n", "restitution = 1\nstiffness = 0.1\n", 1);
    let [even, soft] = [CRADLE, soft.as_str()].map(report);
    assert_eq!((even.uniqueness, even.law.as_str()), (Uniqueness::Examined, "poisson"));
    let springs = |r: &ImpactAnswerReport| r.sharing[2].end.clone().unwrap().contacts[0].normal_velocity_m_s;
    assert!((springs(&even) - springs(&soft)).abs() > 1e-3, "{} {}", springs(&even), springs(&soft));
}

/// Newton's law says what one closing contact does; where two close the walk follows Poisson's, and the answer says so.
#[test]
fn the_law_that_was_used_is_named() {
    let law = |count| report(&format!("law = \"newton\"\n{}", feet(count))).law;
    assert_eq!([law(1), law(2), law(7)], ["newton", "poisson", "newton"]);
}

#[test]
fn broken_json_says_so() {
    let problems = ImpactProblem::parse_json("line 3", "{\"law\": ").expect_err("it is broken");
    insta::assert_snapshot!(problems.to_string());
}

/// Two balls that touch in a row of three, the first with 1 m/s.
const CRADLE: &str = r#"
[[body]]
name = "first"
mass = 1
inertia = 1
centre = [0, 0]
velocity = [1, 0]
[[body]]
name = "second"
mass = 1
inertia = 1
centre = [2, 0]
[[body]]
name = "wall"
kind = "fixed"
[[contact]]
between = ["second", "first"]
point = [1, 0]
normal = [3, 0]
friction = 0
restitution = 1
[[contact]]
between = ["second", "wall"]
point = [3, 0]
normal = [-1, 0]
friction = 0
restitution = 1
"#;

#[test]
fn several_bodies_share_an_impact_as_they_are_told() {
    // A ball strikes one that lies at a wall. Together: both stop, then each impulse is repeated: the first flies back, the second stays.
    let together = report(CRADLE);
    let speeds = |r: &ImpactAnswerReport| -> Vec<f64> {
        r.staged.as_ref().unwrap().end.bodies.iter().map(|b| b.velocity_m_s[0]).collect()
    };
    assert_eq!(speeds(&together), [-1.0, 0.0, 0.0]);
    // In sequence: the first stops, the second hits the wall and comes back, and gives its speed to the first again.
    let in_sequence = report(&format!("sharing = \"in sequence\"\n{CRADLE}"));
    assert_eq!(speeds(&in_sequence), [-1.0, 0.0, 0.0]);
    let verdicts: Vec<_> = together.sharing.iter().map(|s| (s.sharing.as_str(), s.verdict)).collect();
    let (agrees, differs) = (SharingVerdict::Agrees, SharingVerdict::Differs);
    assert_eq!(verdicts, [("together", agrees), ("in sequence", agrees), ("by stiffness", differs)]);
    let springs = &together.sharing[2].end.as_ref().unwrap();
    assert!((springs.energy_after.unwrap() - 0.5).abs() < 1e-9, "springs lose nothing: {springs:?}");
}

#[test]
fn an_answer_that_is_not_found_is_not_unique() {
    // A spring that returns nothing would let go at once: there is no such walk, though there is an end state.
    let dead = CRADLE.replace("restitution = 1", "restitution = 0");
    let problem = ImpactProblem::parse("dead.toml", &format!("sharing = \"by stiffness\"\n{dead}")).unwrap();
    let answer = problem.solve();
    let report = ImpactAnswerReport::new(&problem, &answer);
    assert!(report.staged.is_none() && report.end_states.len() == 1, "{report:?}");
    assert_eq!(
        (report.outcome, answer.undone().map(|why| carom_words::impact::failure(&problem.names, &why))),
        (ImpactOutcome::Unresolved, report.not_staged)
    );
    assert_eq!(problem_of(CRADLE).solve().undone(), None, "the same bodies that bounce");
}

fn problem_of(text: &str) -> ImpactProblem {
    ImpactProblem::parse("impact.toml", text).unwrap_or_else(|problems| panic!("{problems}"))
}

#[test]
fn what_is_wrong_with_several_bodies_is_said_all_at_once() {
    let text = r#"
sharing = "fair"
[[body]]
name = "a"
mass = -1
inertia = 1
[[body]]
kind = "loose"
[[contact]]
point = [0, 0]
normal = [0, 0]
friction = 0.1
between = ["a"]
"#;
    insta::assert_snapshot!(ImpactProblem::parse("bad.toml", text).unwrap_err().to_string());
    let himself = CRADLE.replace("\"second\", \"wall\"", "\"wall\", \"wall\"");
    let himself = himself.replacen("friction = 0\n", "friction = \"a lot\"\n", 1);
    insta::assert_snapshot!(ImpactProblem::parse("himself.toml", &himself).unwrap_err().to_string());
    let lost = CRADLE.replace("\"second\", \"wall\"", "\"second\", \"floor\"");
    insta::assert_snapshot!(ImpactProblem::parse("lost.toml", &lost).unwrap_err().to_string());
    let twice = CRADLE.replace("\"second\", \"wall\"", "\"second\", \"first\"");
    let twice = twice.replace("point = [3, 0]\nnormal = [-1, 0]", "point = [1, 0]\nnormal = [1, 0]");
    insta::assert_snapshot!(ImpactProblem::parse("twice.toml", &twice).unwrap_err().to_string());
}
