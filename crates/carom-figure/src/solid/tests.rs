//! The page of a body in space.

use super::*;

/// A tetrahedron that is turned about z; its contact and its title have names that need escaping.
fn page(times: &[f64]) -> String {
    let at = Vec3::new;
    let corners = [at(0.0, 0.0, 1.0), at(1.0, 0.0, -0.3), at(-0.5, 0.9, -0.3), at(-0.5, -0.9, -0.3)];
    let faces = [vec![0, 1, 2], vec![0, 2, 3], vec![0, 3, 1], vec![1, 3, 2]];
    let names = ["</script><A>", "B", "C", "D"].map(str::to_owned);
    let instants: Vec<SolidInstant> = times
        .iter()
        .map(|t| SolidInstant {
            time: *t,
            centre: at(0.0, 0.0, 0.3),
            attitude: Rotation::by(Vec3::Z * *t),
            tilt: *t,
            held: vec![1, 2, 3],
            places: vec![],
        })
        .collect();
    let contact = SolidContact { name: names[0].clone(), ..SolidContact::default() };
    let strike = SolidStrike { friction: Some(f64::NAN), contacts: vec![contact], ..SolidStrike::default() };
    solid_report(&SolidFigure {
        title: "a <stool>",
        verdict: "at rest",
        lead: "",
        notes: &[],
        drawing: SolidDrawing {
            corners: &corners,
            faces: &faces,
            numbers: None,
            seams: &[],
            lines: &[],
            points: &corners,
            names: &names,
        },
        around: &[],
        instants: &instants,
        stages: &[],
        strikes: &[strike],
        series: &[],
        source: "",
        made_by: "test",
    })
}

#[test]
fn a_body_that_moves_is_played_and_one_at_rest_can_be_turned() {
    let (moves, rests) = (page(&[0.0, 0.5, 1.0]), page(&[0.0]));
    for part in ["id=\"player\"", "id=\"solid-numbers\"", "id=\"scrub\"", "class=\"fig tilt\""] {
        assert!(moves.contains(part), "{part} in the one that moves");
    }
    assert!(rests.contains("id=\"solid\"") && !rests.contains("id=\"scrub\""), "a picture only");
}

#[test]
fn names_are_escaped_and_numbers_are_numbers() {
    let page = page(&[0.0, 1.0]);
    assert!(page.contains("a &lt;stool&gt;") && page.contains("&lt;A&gt;"), "escaped");
    assert_eq!(page.matches("</script>").count(), 2, "the numbers and the player");
    assert!(!page.contains("NaN") && !page.contains("inf,"), "no number that is none");
    assert!(!page.contains("http"), "nothing from the network");
}
