//! The page of a yield study says what was found, is whole in itself and never shows NaN.

use crate::fixture;

use carom_feeder::{Feeder, Verdict};
use carom_figure::{YieldFigure, YieldQuantity, YieldWorst, yield_report};
use carom_impact::Law;
use carom_study::Ending;
use carom_study::yields::{Plan, Points, Sensitivity, Yield, sample};

const TURNED: Ending = Ending::Lies(Verdict::Turned);
const SAME: Ending = Ending::Lies(Verdict::Same);

/// The paper's second case, its friction anywhere from 0.1 to 0.2.
fn found() -> Yield {
    let plan = Plan { dimensions: 1, samples: 16, seed: 1, points: Points::Sobol, plates: 2, plate: 1 };
    let feeder = |point: &[f64]| {
        let mut feeder: Feeder = fixture::feeder();
        feeder.plates.iter_mut().for_each(|plate| plate.friction = 0.1 + 0.1 * point[0]);
        Some(feeder)
    };
    sample(&plan, feeder, |run| Ending::of(run, 1) == TURNED, |_| 0.0).unwrap()
}

fn page(found: &Yield, deciders: Result<&[(String, Sensitivity)], &str>) -> String {
    let quantity = YieldQuantity {
        path: "contact.friction".into(),
        middle: "0.15".into(),
        tolerance: "0.1 to 0.2, all alike".into(),
    };
    let worst = YieldWorst {
        ending: "stuck".into(),
        why: "the most probable of 256 drops that end so".into(),
        impact_speed: None,
        command: "carom run out/case/worst-stuck.toml".into(),
        values: vec!["0.1771".into()],
    };
    yield_report(&YieldFigure {
        motion: "plane motion",
        title: "case <2>",
        wanted: "turned on \"lower\"",
        limited: true,
        plate: "lower",
        plates: &["upper".to_owned(), "lower & last".to_owned()],
        found,
        deciders,
        laws: &[
            (Law::Poisson, 0.0, TURNED),
            (Law::Poisson, 0.9, SAME),
            (Law::Newton, 0.0, TURNED),
            (Law::Newton, 0.9, SAME),
        ],
        drawn: TURNED,
        law: Law::Poisson,
        quantities: &[quantity],
        worst: &[worst],
        notes: &["256 drops".to_owned()],
        live: false,
        source: "[part]\nshape = \"<rod>\"\n",
        made_by: "carom 0.1.0",
    })
}

fn assert_sound(html: &str) {
    for tag in
        ["svg", "section", "table", "tbody", "tr", "td", "th", "text", "figure", "div", "article", "dl", "ul"]
    {
        let open = html.matches(&format!("<{tag} ")).count() + html.matches(&format!("<{tag}>")).count();
        assert_eq!(open, html.matches(&format!("</{tag}>")).count(), "<{tag}> is closed as often as opened");
    }
    for odd in ["NaN", "inf ", "http://", "https://", "<rod>", "case <2>"] {
        assert!(!html.contains(odd), "{odd} is shown");
    }
}

#[test]
fn the_page_says_what_was_found() {
    let found = found();
    let decider = [(
        "contact.friction".to_owned(),
        Sensitivity { first: 0.91, first_error: 0.02, total: 0.97, total_error: 0.03 },
    )];
    let html = page(&found, Ok(&decider));
    std::fs::write(std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("yield.html"), &html).unwrap();
    assert_sound(&html);
    let share = 100.0 * found.wanted.count as f64 / 256.0;
    assert!(share > 1.0 && share < 99.0, "some end so, some do not: {share}");
    for what in [
        format!("<strong>{share:.2} %</strong> end as wanted"),
        format!("between {:.2} and {:.2} %", 100.0 * found.wanted.low, 100.0 * found.wanted.high),
        "Turned on &quot;lower&quot;".to_owned(),
        "0.91 ± 0.02 alone, 0.97 ± 0.03 with others".to_owned(),
        "carom run out/case/worst-stuck.toml".to_owned(),
        "From “upper” to “lower &amp; last”".to_owned(),
        "<td class=\"differs\">same side</td>".to_owned(),
        "Stuck <small>comes to lie on no further plate</small>".to_owned(),
        "end as wanted within the limits of [design]".to_owned(),
        "<div class=\"bar wanted\"><span class=\"what\">turned</span>".to_owned(),
        "<div class=\"bar unwanted\"><span class=\"what\">stuck</span>".to_owned(),
        "<span class=\"key unwanted\"></span>not as wanted</span>".to_owned(),
    ] {
        assert!(html.contains(&what), "{what}");
    }
    let speeds = found.plates[1].impact_speed.as_ref().unwrap();
    assert!(html.contains(&format!("% of {} drops", speeds.count)), "how many are in the picture");
    assert_eq!(html.matches("class=\"fig histogram\"").count(), 4, "speed, slip, flat, and time");
}

#[test]
fn what_is_not_known_is_said() {
    let mut found = found();
    assert!(page(&found, Err("too few")).contains("Not known: too few."), "no index");
    // None ends as wanted: how hard they strike is known all the same.
    found.time = None;
    let html = page(&found, Err("none ends as wanted"));
    assert!(html.contains("struck at up to") && !html.contains("parts a minute"), "speed without time");
    // Nothing came to lie anywhere.
    found.plates.clear();
    found.transitions.clear();
    let html = page(&found, Err("too few"));
    assert_sound(&html);
    assert!(
        !html.contains("id=\"distributions\"") && !html.contains("id=\"transitions\""),
        "no empty section"
    );
}

#[test]
fn no_failure_among_the_drops_is_no_certainty() {
    let mut found = found();
    found.wanted = carom_study::yields::Estimate { share: 1.0, low: 0.98, high: 1.0, count: found.drops };
    let html = page(&found, Err("all samples end alike"));
    assert!(html.contains("none of 256") && html.contains("at most 1 in 50"), "an upper limit stands there");
}

#[test]
fn a_layout_that_never_does_what_is_wanted_points_to_the_command_that_looks_for_others() {
    let mut found = found();
    assert!(!page(&found, Err("few")).contains("carom design"), "some drops do");
    found.kept = carom_study::yields::Estimate { share: 0.0, low: 0.0, high: 0.02, count: 0 };
    assert!(page(&found, Err("few")).contains("<code>carom design</code> looks for a layout"), "none does");
}
