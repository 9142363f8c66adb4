//! Files that people write: whatever stands in them, they are answered or everything wrong with them is listed.

use carom_feeder::RunError;
use carom_motion::planar::Options;
use carom_scene::{AnyImpact, ImpactAnswerReport, Problems, Scene, SpatialImpactReport};

/// Longest text that is tried [bytes]: longer ones show nothing that these do not.
const LONGEST: usize = 8192;
/// Parts and walls that are run: more take time, and find nothing more.
const MOST_OBSTACLES: usize = 24;

/// A run that a fuzzer can wait for.
pub(crate) const SHORT: Options = Options { tolerance: 1e-9, most_time: 20.0, most_events: 200 };

/// Problems are listed, each with words, and can be shown.
pub(crate) fn check_problems(problems: &Problems) {
    assert!(!problems.list.is_empty(), "a refusal without a problem: {:?}", problems.source);
    for problem in &problems.list {
        assert!(!problem.message.is_empty(), "a problem without words: {problem:?}");
    }
    assert!(problems.to_string().len() > problems.file.len(), "the list can be shown: {problems:?}");
}

/// No number of a result is `NaN`; a text that contains the word itself says nothing about that.
pub(crate) fn check_numbers(result: &impl std::fmt::Debug, source: &str) {
    if source.to_lowercase().contains("nan") {
        return;
    }
    let shown = format!("{result:?}");
    if let Some(at) = shown.find("NaN") {
        let near: String =
            shown[..at].chars().rev().take(200).collect::<Vec<_>>().into_iter().rev().collect();
        assert!(at == usize::MAX, "a result that is not a number: …{near}NaN");
    }
}

fn text(bytes: &[u8]) -> Option<&str> {
    bytes.get(..LONGEST.min(bytes.len())).and_then(|bytes| std::str::from_utf8(bytes).ok())
}

/// A scene: parsed, its quantities taken out and put back, and run.
pub fn scene(bytes: &[u8]) {
    let Some(source) = text(bytes) else { return };
    match Scene::parse("scene.toml", source) {
        Ok(scene) => run(&scene),
        Err(problems) => check_problems(&problems),
    }
}

/// Runs a scene that was accepted.
pub(crate) fn run(scene: &Scene) {
    for quantity in scene.quantities().iter().take(4) {
        if let Err(problems) = scene.with(&quantity.path, quantity.value) {
            check_problems(&problems);
        }
    }
    let feeder = scene.feeder();
    if feeder.plates.len() + feeder.walls.len() > MOST_OBSTACLES {
        return;
    }
    match feeder.prepare(SHORT).and_then(|prepared| prepared.run()) {
        Ok(run) => check_numbers(&run, scene.source()),
        Err(RunError::Problems(list)) => assert!(!list.is_empty(), "a refusal without a problem"),
        Err(error) => assert!(!error.to_string().is_empty(), "a fault of the numbers has words"),
    }
}

/// An impact in the plane or in space: parsed, solved and reported.
pub fn impact_file(bytes: &[u8]) {
    let Some(source) = text(bytes) else { return };
    let report = match AnyImpact::parse("impact.toml", source) {
        Ok(AnyImpact::Planar(problem)) => {
            let answer = problem.solve();
            check_numbers(&answer, source);
            serde_json::to_string(&ImpactAnswerReport::new(&problem, &answer))
        }
        Ok(AnyImpact::Spatial(problem)) => {
            let answer = problem.solve();
            check_numbers(&answer, source);
            serde_json::to_string(&SpatialImpactReport::new(&problem, &answer))
        }
        Err(problems) => return check_problems(&problems),
    };
    assert!(report.is_ok(), "a report that is no JSON: {report:?}");
}
