//! Section 5 of the paper on simultaneous collisions: the rolling pyramid, and bodies on n supports.

use super::rolling::{border, keys};
use crate::failure::ValidationError;
use crate::value::Values;
use carom_scene::{SpatialRollKind, SpatialRollProblem, SpatialRollReport, SpatialStrikeReport};

fn follow(kind: SpatialRollKind, keys: &[String]) -> Result<SpatialRollReport, ValidationError> {
    let what = keys.join(" ");
    let problem =
        SpatialRollProblem::parse(kind, &what, "", keys).map_err(|e| ValidationError::input(&what, e))?;
    let run = problem.follow().map_err(|e| ValidationError::engine(&what, e))?;
    Ok(SpatialRollReport::new(&problem, &run))
}

/// The strike of a pyramid of circumradius 1 m and mass 1 kg that turns about OA at 1 rad/s.
fn pyramid(sides: u32, height: f64) -> Result<SpatialStrikeReport, ValidationError> {
    let keys = keys(&[
        ("sides", sides.to_string()),
        ("circumradius", "1 m".to_owned()),
        ("height", format!("{height} m")),
        ("mass", "1 kg".to_owned()),
        ("roll_rate", "1 rad/s".to_owned()),
        ("strikes", "1".to_owned()),
    ]);
    let report = follow(SpatialRollKind::Pyramid, &keys)?;
    let missing = || ValidationError::missing(format!("a strike of the pyramid {}", keys.join(" ")));
    report.strikes.into_iter().next().ok_or_else(missing)
}

/// Heights over circumradius.
const HEIGHTS: [f64; 9] = [0.25, 0.5, 0.7, 0.8, 0.9, 1.0, 1.5, 2.0, 3.0];
const SIDES: [u32; 5] = [3, 4, 5, 6, 8];

/// What keeps, as the paper says it: "O and K".
fn kept(strike: &SpatialStrikeReport) -> String {
    match strike.kept.as_slice() {
        [] => "none".to_owned(),
        [one] => one.clone(),
        [most @ .., last] => format!("{} and {last}", most.join(", ")),
    }
}

/// Section 5.1: 45 shapes, and where the long pyramid begins.
pub(crate) fn compute_pyramid() -> Result<Values, ValidationError> {
    let mut values = Values::default();
    for (sides, height) in SIDES.into_iter().flat_map(|n| HEIGHTS.map(|h| (n, h))) {
        let strike = pyramid(sides, height)?;
        values.put(format!("kept.{sides}.{height}"), kept(&strike));
    }
    for sides in [4, 5, 6, 8, 12] {
        let short = |height: f64| Ok(!pyramid(sides, height)?.kept.iter().any(|name| name == "O"));
        values.put(format!("border.{sides}"), border([0.3, 1.5], short)?);
    }
    let short = pyramid(4, 0.5)?;
    let separated = |name: &str| short.struck.iter().chain(&short.kept).all(|kept| kept != name);
    values.put("also", if separated("O") { "O is also separated" } else { "A is also separated" });
    Ok(values)
}

/// A stool let go standing on support 0, tilted by 0.1 rad: supports, a, c, J across, J along, mass, axis and spin.
struct Stool {
    name: &'static str,
    supports: u32,
    numbers: [f64; 5],
    axis: &'static str,
    spin: &'static str,
}

/// Tripods with a low mass centre and cubes, some with a spin.
const STOOLS: [Stool; 5] = [
    Stool { name: "tripod", supports: 3, numbers: TRIPOD, axis: "[0.3, 1, 0]", spin: "[0, 0, 0]" },
    Stool { name: "tripod_spinning", supports: 3, numbers: TRIPOD, axis: "[0, 1, 0]", spin: "[0, 0, 1]" },
    Stool { name: "cube", supports: 4, numbers: CUBE, axis: "[0.3, 1, 0]", spin: "[0, 0, 0]" },
    Stool { name: "cube_spinning", supports: 4, numbers: CUBE, axis: "[0, 1, 0]", spin: "[0, 0, 2]" },
    Stool { name: "hexagon", supports: 6, numbers: HEXAGON, axis: "[0.3, 1, 0]", spin: "[0, 0, 0]" },
];
/// a, c [m], J across and along the axis [kg m²], mass [kg].
const TRIPOD: [f64; 5] = [0.25, 0.05, 0.04, 0.07, 2.0];
const CUBE: [f64; 5] = [0.141_421_356_237_309_5, 0.1, 2.0 / 300.0, 2.0 / 300.0, 1.0];
const HEXAGON: [f64; 5] = [0.2, 0.15, 0.0475, 0.05, 3.0];

fn stool(stool: &Stool) -> Result<SpatialRollReport, ValidationError> {
    let [a, c, across, along, mass] = stool.numbers;
    follow(
        SpatialRollKind::Stool,
        &keys(&[
            ("supports", stool.supports.to_string()),
            ("circle_radius", format!("{a} m")),
            ("centre_height", format!("{c} m")),
            ("inertia_transverse", format!("{across} kg m^2")),
            ("inertia_axial", format!("{along} kg m^2")),
            ("mass", format!("{mass} kg")),
            ("tilt", "0.1 rad".to_owned()),
            ("axis", stool.axis.to_owned()),
            ("spin", stool.spin.to_owned()),
        ]),
    )
}

/// Section 5.2: the spin where both supports stay, and which of two lift.
pub(crate) fn compute_supports() -> Result<Values, ValidationError> {
    let mut values = Values::default();
    let mut only_the_struck = 0;
    for of in &STOOLS {
        let report = stool(of)?;
        let first = report
            .strikes
            .first()
            .ok_or_else(|| ValidationError::missing(format!("a strike of the {}", of.name)))?;
        let spin = first.spin_rad_s.map_or(f64::NAN, |[x, y, z]| (x * x + y * y + z * z).sqrt());
        let stays = first.kept.len() == 2;
        values.put(format!("stays.{}", of.name), if stays { "both stay" } else { "O separates" });
        if stays {
            values.put(format!("spin.{}", of.name), spin);
        }
        only_the_struck += report.strikes.iter().filter(|strike| loses_the_struck_one(strike)).count();
    }
    values.put("only_k", only_the_struck as f64);
    Ok(values)
}

/// Of two supports the one that comes down lifts, and the other stays.
fn loses_the_struck_one(strike: &SpatialStrikeReport) -> bool {
    let lifts = |name: &String| !strike.kept.contains(name);
    strike.contacts.len() == 2 && strike.kept.len() == 1 && strike.struck.iter().any(lifts)
}
