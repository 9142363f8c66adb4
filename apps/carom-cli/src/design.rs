//! `carom design`: which layout makes drops end as wanted.

mod report;

use crate::args::{DesignOptions, Format, Output};
use crate::failure::Failure;
use crate::progress::Progress;
use carom::tasks::design::{DesignPlan, DesignStudy, Designed, design_space};
use carom_scene::{AnyScene, DesignSpace};
use std::io::Write;

/// A search, and how long it took.
struct Searched<'s, S: Designed> {
    study: DesignStudy<'s, S>,
    seconds: f64,
}

pub(crate) fn design(options: &DesignOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    match AnyScene::read(&options.scene)? {
        AnyScene::Plane(scene) => designed(&*scene, options, output, out),
        AnyScene::Space(scene) => designed(&*scene, options, output, out),
    }
}

fn designed(
    scene: &impl Designed,
    options: &DesignOptions,
    output: &Output,
    out: &mut impl Write,
) -> Result<(), Failure> {
    let space = design_space(scene)?;
    let searched = searched(scene, &space, options)?;
    report::deliver(&searched, output, output.format == Format::Json, out)
}

fn searched<'s, S: Designed>(
    scene: &'s S,
    space: &'s DesignSpace<'s, S>,
    options: &DesignOptions,
) -> Result<Searched<'s, S>, Failure> {
    let usual = DesignPlan::usual(scene);
    let plan = DesignPlan {
        scan: options.scan.unwrap_or(usual.scan),
        samples: options.samples.unwrap_or(usual.samples),
        seed: options.seed,
    };
    let progress = Progress::new("drops", None);
    let study = DesignStudy::searched(scene, space, plan, || progress.step(), |_| {})?;
    Ok(Searched { study, seconds: progress.seconds() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::broken_calls::{every_call_of_part_fails, printed};
    use carom_scene::Scene;
    use std::path::Path;

    #[test]
    fn every_call_of_a_result_may_fail() {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/design_turn_once.toml");
        let options = DesignOptions { scene: file.clone(), scan: Some(16), samples: Some(16), seed: 1 };
        let scene = Scene::read(&file).unwrap_or_else(|problems| panic!("{problems}"));
        let space = design_space(&scene).unwrap_or_else(|problems| panic!("{problems}"));
        let found = searched(&scene, &space, &options).unwrap_or_else(|failure| panic!("{failure}"));
        assert!(found.study.winner.is_some(), "there is a layout to write");
        let nothing =
            Searched { study: DesignStudy { winner: None, ..found.study.clone() }, seconds: found.seconds };
        let deliver = |designed: &Searched<'_, Scene>, out: &Path| {
            let output = Output { format: Format::Text, out: Some(out.to_owned()) };
            printed(|out| report::deliver(designed, &output, false, out))
        };
        let (some, none) = (|out: &Path| deliver(&found, out), |out: &Path| deliver(&nothing, out));
        let first = every_call_of_part_fails("design", &none, &some);
        // Without a layout the files of an earlier one are obsolete.
        let second = every_call_of_part_fails("design-of-none", &some, &none);
        assert!(first >= 30 && second >= 10, "{first} and {second} calls");
    }
}
