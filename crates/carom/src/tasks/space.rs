//! A part in space on its way through a feeder: the files of its run.

use carom_feeder::spatial::Run;
use carom_scene::{SpaceRunReport, SpaceScene};
use std::fmt::Write as _;

/// The files of a run, the one to look at last: the result as JSON, the way as CSV.
///
/// # Errors
/// None in practice: what is written are numbers and names.
///
/// # Example
/// ```
/// use carom::{scene::SpaceScene, tasks::space::run_files};
/// let text = "part = { box = [0.04, 0.01, 0.02], mass = 0.06 }\ncontact = { friction = 0.5 }\nstart = { to_edge = 0.1 }\n[[plate]]\nslope = \"15 deg\"";
/// let scene = SpaceScene::parse("stays.toml", text)?;
/// let files = run_files(&scene, &scene.feeder().run()?).unwrap();
/// assert!(files.iter().any(|(name, text)| *name == "run.json" && text.contains("stuck")));
/// # Ok::<(), carom::Error>(())
/// ```
pub fn run_files(scene: &SpaceScene, run: &Run) -> Result<Vec<(&'static str, String)>, serde_json::Error> {
    let result = serde_json::to_string_pretty(&SpaceRunReport::new(scene, run))?;
    Ok(vec![("trace.csv", trace(run)), ("run.json", format!("{result}\n"))])
}

/// Time, place, attitude, velocity and spin at every sample.
fn trace(run: &Run) -> String {
    let mut text = String::from(
        "t_s,x_m,y_m,z_m,qw,qx,qy,qz,vx_m_s,vy_m_s,vz_m_s,spin_x_rad_s,spin_y_rad_s,spin_z_rad_s\n",
    );
    for (time, _, state) in &run.samples.instants {
        let numbers = [
            &state.centre.to_array()[..],
            &state.attitude.to_array()[..],
            &state.velocity.to_array()[..],
            &state.spin.to_array()[..],
        ];
        let cells: Vec<String> = numbers.iter().flat_map(|of| of.iter()).map(ToString::to_string).collect();
        // Writing to a String cannot fail.
        let _ = writeln!(text, "{time},{}", cells.join(","));
    }
    text
}
