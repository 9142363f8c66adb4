//! The rows of the stage table of a run in space, for any output.

use carom_feeder::spatial::{Feeder, Run};
use carom_feeder::{Stage, StageName};
use carom_motion::spatial::{Impact, State, Touch};
use carom_num::Vec3;
use carom_num::elementary::atan2;

/// One row of the stage table of a run in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SpaceRow<'a> {
    /// A stage with its number from 0.
    Stage(usize, &'a Stage<State, Touch>),
    /// An impact with its number from 0.
    Strike(usize, &'a Impact),
}

/// Stages and the strikes between them, in order of time. Strikes within a stage of many are told by the stage.
///
/// # Example
/// A bar slides, tips, flies and strikes the lower plate.
/// ```
/// use carom_figure::{SpaceRow, space_rows};
/// let run = carom_feeder::spatial::examples::two_plates().run()?;
/// let rows = space_rows(&run);
/// assert!(matches!(rows[0], SpaceRow::Stage(0, _)));
/// assert!(rows.iter().any(|row| matches!(row, SpaceRow::Strike(0, _))));
/// # Ok::<(), carom_feeder::RunError>(())
/// ```
pub fn space_rows(run: &Run) -> Vec<SpaceRow<'_>> {
    let mut rows = vec![];
    let mut next = 0;
    for (i, stage) in run.stages.iter().enumerate() {
        while let Some(impact) = run.impacts.get(next).filter(|impact| impact.time <= stage.start_time) {
            rows.push(SpaceRow::Strike(next, impact));
            next += 1;
        }
        // The last strike of a stage of many may end it.
        let within = |impact: &Impact| {
            impact.time < stage.end_time || stage.name == StageName::Clatter && impact.time == stage.end_time
        };
        while run.impacts.get(next).is_some_and(within) {
            next += 1;
        }
        rows.push(SpaceRow::Stage(i, stage));
    }
    rows.extend((next..run.impacts.len()).map(|k| SpaceRow::Strike(k, &run.impacts[k])));
    rows
}

/// The angle between the face that was down at the start and level ground [rad].
///
/// # Example
/// A bar that lies on a plate that falls 8 in 29 is tilted by its slope.
/// ```
/// let feeder = carom_feeder::spatial::examples::two_plates();
/// let tilt = carom_figure::space_tilt(&feeder, &feeder.start_state());
/// assert!((tilt - (8.0_f64 / 29.0).atan()).abs() < 1e-12);
/// ```
pub fn space_tilt(feeder: &Feeder, state: &State) -> f64 {
    let down = feeder.part.faces.get(feeder.start.face).map_or(Vec3::Y, |face| face.normal);
    let down = state.attitude.apply(down);
    atan2(down.cross(-Vec3::Y).norm(), -down.y)
}

/// What the contacts of an impact do after it: `of 3 contacts 1 slips, 2 separate`.
///
/// # Example
/// ```
/// let run = carom_feeder::spatial::examples::two_plates().run()?;
/// assert!(carom_figure::space_contacts(&run.impacts[0]).starts_with("of "));
/// # Ok::<(), carom_feeder::RunError>(())
/// ```
pub fn space_contacts(impact: &Impact) -> String {
    let (slips, kept) = (impact.sliding.len(), impact.kept.len());
    let parts = [(slips, "slip"), (kept.saturating_sub(slips), "stick"), (impact.opened().len(), "separate")];
    let told: Vec<String> = parts
        .iter()
        .filter(|(number, _)| *number > 0)
        .map(|(number, does)| if *number == 1 { format!("1 {does}s") } else { format!("{number} {does}") })
        .collect();
    let count = impact.touching.len();
    let contacts = if count == 1 { "contact" } else { "contacts" };
    format!("of {count} {contacts} {}", told.join(", "))
}

/// Change of kinetic energy in an impact [%]; `None` where there was none to change.
///
/// # Example
/// Without restitution a strike takes energy.
/// ```
/// let run = carom_feeder::spatial::examples::two_plates().run()?;
/// assert!(carom_figure::space_energy_change(&run.impacts[0]).unwrap() < 0.0);
/// # Ok::<(), carom_feeder::RunError>(())
/// ```
pub fn space_energy_change(impact: &Impact) -> Option<f64> {
    let change = 100.0 * (impact.kinetic_after - impact.kinetic_before) / impact.kinetic_before;
    change.is_finite().then_some(change)
}
