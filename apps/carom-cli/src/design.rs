//! `carom design`: which layout makes drops end as wanted.

mod report;

use crate::args::{DesignOptions, Format, Output};
use crate::failure::Failure;
use crate::progress::Progress;
use carom::tasks::design::{DesignPlan, DesignStudy, design_space};
use carom_scene::{DesignSpace, Scene};
use std::io::Write;

/// A search, and how long it took.
struct Searched<'s> {
    study: DesignStudy<'s>,
    seconds: f64,
}

pub(crate) fn design(options: &DesignOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    let scene = Scene::read(&options.scene)?;
    let space = design_space(&scene)?;
    let searched = searched(&scene, &space, options)?;
    report::deliver(&searched, output, output.format == Format::Json, out)
}

fn searched<'s>(
    scene: &'s Scene,
    space: &'s DesignSpace<'s>,
    options: &DesignOptions,
) -> Result<Searched<'s>, Failure> {
    let plan = DesignPlan { scan: options.scan, samples: options.samples, seed: options.seed };
    let progress = Progress::new("drops", None);
    let study = DesignStudy::searched(scene, space, plan, || progress.step(), |_| {})?;
    Ok(Searched { study, seconds: progress.seconds() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::broken_calls::{every_call_of_part_fails, printed};
    use std::path::Path;

    #[test]
    fn every_call_of_a_result_may_fail() {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/design_turn_once.toml");
        let options = DesignOptions { scene: file.clone(), scan: 16, samples: 16, seed: 1 };
        let scene = Scene::read(&file).unwrap_or_else(|problems| panic!("{problems}"));
        let space = design_space(&scene).unwrap_or_else(|problems| panic!("{problems}"));
        let found = searched(&scene, &space, &options).unwrap_or_else(|failure| panic!("{failure}"));
        assert!(found.study.winner.is_some(), "there is a layout to write");
        let nothing =
            Searched { study: DesignStudy { winner: None, ..found.study.clone() }, seconds: found.seconds };
        let deliver = |designed: &Searched<'_>, out: &Path| {
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
