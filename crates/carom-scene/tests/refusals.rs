//! Where a problem is, and that it is told once: files of another kind, of the plane among those of space, and keys that miss others.

use carom_scene::{
    AnyImpact, Form, ImpactProblem, ImpactTemplate, Problem, Problems, RollKind, Scene, SpatialRollKind,
};

/// Lines and paths of the problems of an impact.
fn places(text: &str) -> Vec<(usize, String)> {
    let found = AnyImpact::parse("impact.toml", text).unwrap_err();
    lines(&found)
}

fn lines(found: &Problems) -> Vec<(usize, String)> {
    let line =
        |problem: &Problem| problem.span.as_ref().map_or(0, |span| found.line_and_column(span.start).0);
    found.list.iter().map(|problem| (line(problem), problem.path.clone())).collect()
}

/// The same of the form of a file.
fn form(form: Form, text: &str) -> Vec<(usize, String)> {
    lines(&Problems::new("a.toml", text, form.problems(text)))
}

const BODY: &str = "[body]\nmass = 1\ninertia = 1\nvelocity = [0, -1]\n";

fn contact(more: &str) -> String {
    format!("[[contact]]\npoint = [0, 0]\nnormal = [0, 1]\nfriction = 0.3\n{more}\n")
}

#[test]
fn the_second_of_two_contacts_with_one_name_is_pointed_at() {
    let text =
        format!("{BODY}{}{}", contact("name = \"K\""), contact("name = \"K\"").replace("[0, 0]", "[1, 0]"));
    assert_eq!(places(&text), [(14, "contact.1.name".to_owned())], "{text}");
    let text = format!("{BODY}{}{}", contact("name = \"B\""), contact("").replace("[0, 0]", "[1, 0]"));
    assert_eq!(
        places(&text),
        [(10, "contact.1.name".to_owned())],
        "B is what the second is called without a name"
    );
    let bodies = "[[body]]\nname = \"a\"\nkind = \"fixed\"\n[[body]]\nmass = 1\ninertia = 1\ncentre = [0, 1]\nname = \"a\"\n";
    let text = format!("{bodies}{}", contact("between = [\"a\", \"a\"]"));
    assert!(places(&text).contains(&(8, "body.1.name".to_owned())), "{:?}", places(&text));
}

#[test]
fn an_approach_under_forces_has_its_line_and_its_unit() {
    let text = format!("{BODY}{}", contact(""));
    let impact = ImpactProblem::parse("block.toml", &text).unwrap();
    let found = impact.under_forces("block.toml").unwrap_err();
    assert_eq!(lines(&found), [(5, "contact.0".to_owned())]);
    assert!(found.to_string().contains("normal velocity of A is -1 m/s, allowed is 0 or more"), "{found}");
}

#[test]
fn what_a_rule_misses_has_the_line_that_asks_for_it() {
    let stool = Form::SpatialRoll(SpatialRollKind::Stool);
    assert_eq!(form(stool, "supports = 4\nrestitution = 0.5\n"), [(2, "friction".to_owned())]);
    let prism = Form::Roll(RollKind::Prism);
    let found = form(prism, "strikes = 1\na_to_centre = 0.1\nheight = 0.1\n");
    assert_eq!(found, [(2, "centre_to_k".to_owned())], "an irregular prism");
    let scene =
        "[part]\nshape = \"rod\"\nlength = 0.1\nmass = 1\n[start]\nto_edge = 0.1\n[[plate]]\nslope = 0.2\n";
    assert_eq!(
        form(Form::Scene, scene),
        [(7, "contact.friction".to_owned())],
        "no [contact]: the plate lacks it"
    );
    let scene = format!("{scene}[contact]\nrestitution = 0.1\n");
    assert_eq!(form(Form::Scene, &scene), [(9, "contact.friction".to_owned())], "a [contact] without it");
}

#[test]
fn one_vector_of_three_numbers_in_a_plane_file_is_blamed_alone() {
    let text = format!("{BODY}{}{}", contact(""), contact("").replace("[0, 0]", "[1, 0, 0]"));
    assert_eq!(places(&text), [(11, "contact.1.point".to_owned())]);
    let said = AnyImpact::parse("a.toml", &text).unwrap_err().to_string();
    assert!(said.contains("this file is in the plane, where a vector has two numbers"), "{said}");
    let space = "[body]\nmass = 1\ninertia = [1, 1, 1]\nvelocity = [0, 0, -1]\n[[contact]]\npoint = [0, 0]\nnormal = [0, 0, 1]\nfriction = 0.3\n";
    assert_eq!(places(space), [(6, "contact.0.point".to_owned())], "and the other way round");
}

const IN_SPACE: &str = "[body]\nmass = 1\ninertia = [1, 1, 1]\nvelocity = [0, 0, -1]\n[[contact]]\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\nfriction = 0.3\n";

#[test]
fn keys_of_the_plane_are_told_as_such_in_space() {
    let text = format!("sharing = \"in sequence\"\ngravity = 9.81\n{IN_SPACE}stiffness = 2\n");
    let found = AnyImpact::parse("a.toml", &text).unwrap_err();
    assert_eq!(
        lines(&found),
        [(1, "sharing".to_owned()), (2, "gravity".to_owned()), (11, "contact.0.stiffness".to_owned())]
    );
    assert!(found.list.iter().all(|problem| problem.message.contains("for the plane only")), "{found}");
}

#[test]
fn what_is_asked_in_the_plane_only_refuses_an_impact_in_space_in_one_line() {
    for found in [
        ImpactTemplate::parse("a.toml", IN_SPACE).unwrap_err(),
        ImpactProblem::parse("a.toml", IN_SPACE).unwrap_err(),
    ] {
        assert_eq!(lines(&found), [(1, "body".to_owned())]);
        assert!(found.list[0].message.contains("in the plane only"), "{found}");
    }
}

#[test]
fn newtons_law_is_for_one_closing_contact_in_space() {
    let newton = |text: &str| format!("law = \"newton\"\n{text}");
    assert!(AnyImpact::parse("a.toml", &newton(IN_SPACE)).is_ok(), "one contact");
    let second = "[[contact]]\npoint = [1, 0, 0]\nnormal = [0, 0, 1]\nfriction = 0.3\n";
    let found = AnyImpact::parse("a.toml", &newton(&format!("{IN_SPACE}{second}"))).unwrap_err();
    assert_eq!(lines(&found), [(1, "law".to_owned())], "{found}");
    for kind in [SpatialRollKind::Stool, SpatialRollKind::Body] {
        let found = form(Form::SpatialRoll(kind), "friction = 0.3\nlaw = \"newton\"\n");
        assert_eq!(found, [(2, "law".to_owned())], "{kind:?}");
        let schema = carom_scene::schema::file(Form::SpatialRoll(kind)).to_value();
        assert_eq!(
            schema["properties"]["law"]["enum"],
            serde_json::json!(["poisson", "stronge"]),
            "{kind:?}"
        );
    }
}

#[test]
fn a_file_of_another_kind_is_told_in_one_line_with_its_command() {
    let prism = "sides = 4\nstrikes = 1\nslope = \"5 deg\"\n";
    let scene = "[part]\nshape = \"rod\"\n[[plate]]\nslope = 0.2\n";
    let rod = Form::Roll(RollKind::Rod);
    for (given, text, line, command) in [
        (Form::Scene, prism, 1, "`carom roll prism`"),
        (Form::Impact, prism, 1, "`carom roll prism`"),
        (Form::Scene, BODY, 1, "`carom impact`"),
        (rod, BODY, 1, "`carom impact`"),
        (Form::Impact, scene, 1, "`carom run`"),
        (rod, scene, 1, "`carom run`"),
        (Form::Scene, "supports = 5\ncircle_radius = 0.1\ntilt = 0.1", 1, "`carom roll stool`"),
    ] {
        let told = given.problems(text);
        assert_eq!(told.len(), 1, "{given:?}: {told:?}");
        let found = Problems::new("a.toml", text, told);
        assert_eq!(lines(&found)[0].0, line, "{given:?}");
        assert!(found.to_string().contains(command), "{given:?}: {found}");
    }
    let misspelt = Scene::parse("a.toml", "[prt]\nshape = \"rod\"\n").unwrap_err();
    assert!(misspelt.to_string().contains("did you mean \"part\"?"), "{misspelt}");
}

#[test]
fn a_missing_vector_says_what_it_is() {
    let text = format!("{}{}", BODY.replace("velocity = [0, -1]\n", ""), contact(""));
    let said = AnyImpact::parse("a.toml", &text).unwrap_err().to_string();
    assert!(said.contains("missing: two numbers [x, y], velocity of the mass centre before"), "{said}");
}
