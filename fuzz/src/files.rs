//! Files that other programs write: outlines from DXF and SVG, bodies from STL.

use crate::texts::{check_numbers, check_problems, run};
use carom_scene::{Scene, SpatialRollKind, SpatialRollProblem};
use std::path::PathBuf;

/// Longest file that is tried [bytes].
const LONGEST: usize = 16_384;

/// A folder of this process for one file at a time; scenes name their drawings by file.
fn folder() -> PathBuf {
    let thread = format!("{:?}", std::thread::current().id());
    let number: String = thread.chars().filter(char::is_ascii_digit).collect();
    std::env::temp_dir().join(format!("carom-fuzz-{}-{number}", std::process::id()))
}

/// Writes the bytes to a file of this name; returns the name of a file beside it. `None` where the disk does not take it.
fn beside(name: &str, bytes: &[u8]) -> Option<String> {
    let folder = folder();
    std::fs::create_dir_all(&folder).ok()?;
    std::fs::write(folder.join(name), bytes.get(..LONGEST.min(bytes.len()))?).ok()?;
    Some(folder.join("scene.toml").display().to_string())
}

/// A part drawn in a file: SVG where it begins as one, else DXF.
pub fn outline(bytes: &[u8]) {
    let svg = bytes.iter().find(|byte| !byte.is_ascii_whitespace()) == Some(&b'<');
    let name = if svg { "part.svg" } else { "part.dxf" };
    let Some(file) = beside(name, bytes) else { return };
    let source = format!(
        "[part]\nshape = \"outline\"\nfile = \"{name}\"\nunit = \"mm\"\nmass = \"0.1 kg\"\n\
         [contact]\nfriction = 0.2\nrestitution = 0.1\n[start]\nto_edge = \"60 mm\"\n\
         [[plate]]\nslope = \"20 deg\"\n[[plate]]\nslope = \"12 deg\"\nbelow = {{ x = \"50 mm\", y = \"-90 mm\" }}\n"
    );
    match Scene::parse(&file, &source) {
        Ok(scene) => run(&scene),
        Err(problems) => check_problems(&problems),
    }
}

/// A body from an STL file, which falls and is followed for two strikes.
pub fn stl(bytes: &[u8]) {
    let Some(file) = beside("body.stl", bytes) else { return };
    let source = "file = \"body.stl\"\nunit = \"mm\"\ndensity = \"1000 kg/m^3\"\naxis = [1, 2, 0]\nturn = \"20 deg\"\n\
                  height = \"1 mm\"\nstrikes = 2\n";
    match SpatialRollProblem::parse(SpatialRollKind::Body, &file, source, &[]) {
        Ok(problem) => {
            check_numbers(&problem.world, "");
            if let Ok(run) = problem.follow() {
                check_numbers(&run, "");
            }
        }
        Err(refused) => {
            assert!(!refused.0.is_empty(), "a refusal without a list");
            refused.0.iter().for_each(check_problems);
        }
    }
}
