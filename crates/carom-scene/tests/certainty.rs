//! What an answer says of itself: that it is the only one, or why it is not.

use carom_scene::{
    AnyImpact, ImpactAnswerReport, ImpactOutcome, ImpactProblem, InequalityKind, InequalityReport, RollKind,
    RollProblem, RollReport, ShareTaken, SharingVerdict, SpatialImpactReport,
};

/// What six digits of a number leave out, at most, as a share of it.
const SIX_DIGITS: f64 = 5e-6;

fn report(text: &str) -> ImpactAnswerReport {
    let problem = ImpactProblem::parse("impact.toml", text).unwrap_or_else(|problems| panic!("{problems}"));
    let answer = problem.solve();
    let report = ImpactAnswerReport::new(&problem, &answer);
    assert_eq!(report.outcome, answer.certainty().outcome(), "report and answer are of one mind");
    report
}

#[test]
fn an_open_share_is_told_with_the_motions_that_its_ends_leave() {
    let report = report(include_str!("open_share.toml"));
    assert_eq!(report.outcome, ImpactOutcome::Several, "what is taken is one of many");
    assert_eq!(report.end_states.len(), 1, "one hypothesis is consistent");
    // Source: an independent enumeration of the impulses that stop the body, to five digits.
    let expected = [
        (ShareTaken::Least, [-0.25886, -0.31383], 0.13185),
        (ShareTaken::Most, [-0.28579, -0.34326], 0.14279),
    ];
    let shares = report.staged.unwrap().open_shares;
    assert_eq!(shares.len(), expected.len(), "{shares:?}");
    for (share, (takes, velocity, spin)) in shares.iter().zip(expected) {
        assert_eq!(share.takes, takes, "{share:?}");
        let [x, y] = share.end.velocity_m_s.unwrap();
        let off = (x - velocity[0]).abs().max((y - velocity[1]).abs());
        assert!(off.max((share.end.spin_rad_s.unwrap() - spin).abs()) < 6e-6, "{share:?}");
    }
}

#[test]
fn a_cylinder_that_ends_elsewhere_than_every_end_state_is_path_dependent() {
    let set = ["inertia_ratio=1", "friction=0.3", "restitution=0.5", "gamma=70 deg"].map(str::to_owned);
    let cylinder = RollProblem::parse(RollKind::Cylinder, "cylinder.toml", "", &set).unwrap();
    let report = RollReport::new(&cylinder, &cylinder.follow().unwrap());
    let strike = &report.strikes[0];
    assert!(strike.path_dependent && strike.end_states.len() == 1, "{strike:?}");
    assert_eq!(strike.outcome, ImpactOutcome::PathDependent, "one word for it");
    assert!(strike.certainty().words().contains("the end depends on the way there"), "{strike:?}");
}

#[test]
fn a_convention_that_does_not_apply_does_not_disagree() {
    // A smooth step: K slides along it, and neither contact returns anything.
    let step = report(&std::fs::read_to_string("../../examples/impact_step.toml").unwrap());
    let verdicts: Vec<SharingVerdict> = step.sharing.iter().map(|shared| shared.verdict).collect();
    assert_eq!(verdicts, [SharingVerdict::Agrees, SharingVerdict::Agrees, SharingVerdict::DoesNotApply]);
    assert!(step.sharing[2].because.as_ref().unwrap().contains("restitution"), "{:?}", step.sharing[2]);
}

#[test]
fn what_rounding_leaves_is_at_rest() {
    // A body wedged between two steep walls: both conventions end in rest, one of them after many impacts.
    let text = r#"
        body = { mass = 1, inertia = 0.01, velocity = [0, -1] }
        contact = [
            { name = "L", point = [-0.1, 0], normal = [0.985, 0.174], friction = 0.5, restitution = 0.5 },
            { name = "R", point = [0.1, 0], normal = [-0.985, 0.174], friction = 0.5, restitution = 0.5 },
        ]
    "#;
    let report = report(text);
    let sequence = report.sharing.iter().find(|shared| shared.sharing == "in sequence").unwrap();
    assert_eq!(sequence.verdict, SharingVerdict::Agrees, "both end in rest: {sequence:?}");
    for contact in &sequence.end.as_ref().unwrap().contacts {
        let velocities = (contact.normal_velocity_m_s, contact.slip_m_s);
        assert_eq!((contact.state.as_str(), velocities), ("sticks", (0.0, 0.0)), "{contact:?}");
    }
}

#[test]
fn a_walk_that_chose_is_not_unique() {
    // A rod that is Painlevé's: without approach it may slide on or be stopped by an impact.
    let text = r#"
        body = { mass = 1, inertia = 0.3333333333333333, velocity = [1, 0] }
        contact = [{ name = "K", point = [0.5, -0.8660254037844386], normal = [0, 1], friction = 1.6 }]
    "#;
    let report = report(text);
    assert_eq!(report.outcome, ImpactOutcome::Several, "{report:?}");
    assert!(report.staged.unwrap().without_approach, "friction forces it");
}

#[test]
fn a_rejection_is_data_that_its_words_repeat() {
    let report = report(include_str!("open_share.toml"));
    assert!(report.rejected.len() > 20, "{}", report.rejected.len());
    for rejected in &report.rejected {
        let InequalityReport { kind, contact, amount, unit, share, phase } = &rejected.inequality;
        assert!(phase.is_some(), "{rejected:?}");
        if *kind == InequalityKind::Equations {
            assert_eq!((contact, amount, *unit, *share), (&None, &None, "", Some(1.0)), "{rejected:?}");
            continue;
        }
        let name = contact.as_deref().unwrap();
        assert!(["A", "B", "C"].contains(&name) && rejected.because.contains(name), "{rejected:?}");
        let (amount, share) = (amount.unwrap(), share.unwrap());
        assert!(amount > 0.0 && share > 0.0 && share <= 1.0, "{rejected:?}");
        assert!(rejected.because.contains(&format!("by {share:.3} of")), "{rejected:?}");
        let velocity = matches!(kind, InequalityKind::NormalVelocity | InequalityKind::SlipDirection);
        assert_eq!(*unit, if velocity { "m/s" } else { "N s" }, "{rejected:?}");
    }
}

#[test]
fn a_rejection_in_space_is_data_that_its_words_repeat() {
    // A plate falls flat on three feet while it slides and spins.
    let text = r#"
        body = { mass = 1, inertia = [0.02, 0.02, 0.04], velocity = [0.6, 0.1, -1], spin = [0, 0, 2] }
        contact = [
            { point = [0.2, 0, -0.1], normal = [0, 0, 1], friction = 0.3, restitution = 0.5 },
            { point = [-0.1, 0.17, -0.1], normal = [0, 0, 1], friction = 0.4, restitution = 0.5 },
            { point = [-0.1, -0.17, -0.1], normal = [0, 0, 1], friction = 0.5, restitution = 0.5 },
        ]
    "#;
    let AnyImpact::Spatial(problem) = AnyImpact::parse("plate.toml", text).unwrap() else {
        panic!("it is in space")
    };
    let report = SpatialImpactReport::new(&problem, &problem.solve());
    let stages =
        report.stages.iter().flat_map(|stage| stage.rejected.iter().map(|r| (stage.phase.as_str(), r)));
    let stages: Vec<_> = stages.collect();
    assert!(stages.len() > 5, "{}", stages.len());
    for (of, rejected) in stages {
        let InequalityReport { kind, contact, amount, share, phase, .. } = &rejected.inequality;
        let (share, phase) = (share.unwrap(), phase.unwrap());
        assert!(share > 0.0 && share <= 1.0 && amount.is_none() && phase == of, "{rejected:?}");
        let says = format!("by {share:.3} of");
        let told = matches!(kind, InequalityKind::SlipDirection | InequalityKind::Equations);
        assert!(told || rejected.because.contains(&says), "{rejected:?}");
        let named = contact.as_ref().is_none_or(|name| rejected.because.contains(name.as_str()));
        assert!(named && (contact.is_none() == (*kind == InequalityKind::Equations)), "{rejected:?}");
    }
    for rejected in &report.non_sliding_rejected {
        let InequalityReport { kind, contact, amount, unit, .. } = &rejected.inequality;
        if *kind != InequalityKind::Equations {
            // Six digits are told.
            let (_, told) = rejected.because.split_once(" = ").unwrap();
            let (number, rest) = told.split_once(&format!(" {unit} < 0")).unwrap();
            let off = number.parse::<f64>().unwrap() + amount.unwrap();
            assert!(off.abs() <= SIX_DIGITS * amount.unwrap(), "{number}, {rest}: {rejected:?}");
            assert!(contact.is_some(), "{rejected:?}");
        }
    }
}

/// Source: the file of a reader, whose walk by Stronge's law was told as one that depends on its way; end states obey Poisson's law.
#[test]
fn what_end_states_of_another_law_say_is_not_held_against_a_walk() {
    let text = |law: &str, more: &str| {
        format!(
            "law = \"{law}\"\n{more}body = {{ mass = 1, inertia = 5e-4, velocity = [0.3, -1] }}\n\
             contact = [{{ point = [\"10 mm\", \"-30 mm\"], normal = [0, 1], friction = 0.6, restitution = 0.5 }}]"
        )
    };
    let stronge = report(&text("stronge", ""));
    let staged = stronge.staged.as_ref().unwrap();
    assert!(!staged.path_dependent && !staged.end_states_compared, "{staged:?}");
    assert_eq!(stronge.outcome, ImpactOutcome::Unique, "one contact: its walk chose nothing");
    let poisson = report(&text("poisson", ""));
    assert!(poisson.staged.as_ref().unwrap().end_states_compared, "its own law");
    assert_eq!(poisson.outcome, ImpactOutcome::Unique, "and the same end");
    let springs =
        AnyImpact::parse("cradle.toml", include_str!("../../../examples/impact_cradle.toml")).unwrap();
    let AnyImpact::Planar(springs) = springs else { panic!("it lies in the plane") };
    let shared = ImpactAnswerReport::new(&springs, &springs.solve());
    assert_eq!(shared.outcome, ImpactOutcome::Found, "of several contacts others were not searched for");
}
