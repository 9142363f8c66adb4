//! What is kept of each drop of many: the columns of the tables of `carom sweep`.

use carom_scene::columns::Column;
use carom_study::{Dropped, Landed};
use carom_words::{Words, study};

/// The columns, with their units.
pub const FOUND: [(&str, &str); 8] = [
    ("ending", ""),
    ("outcome", ""),
    ("impact_speed_m_s", "m/s"),
    ("max_sliding_speed_m_s", "m/s"),
    ("first_touch_s", "s"),
    ("flat_s", "s"),
    ("end_s", "s"),
    ("margin", ""),
];

/// These columns of some drops; `plate` is the number of the plate that was looked at.
///
/// # Example
/// ```
/// use carom::{scene::columns::Column, study::sweep, tasks::sweep::found};
/// let slope = |values: &[f64]| Some(carom::feeder::examples::rod_on_a_slope(values[0]));
/// let drops = sweep::drops(&[vec![0.5], vec![1.0]], 0, slope);
/// let [ending, ..] = found(&drops, 0);
/// assert_eq!(ending, Column::Word(["delivered", "stuck"].map(|word| Some(word.to_owned())).to_vec()));
/// ```
pub fn found<R: Landed>(drops: &[Dropped<R>], plate: usize) -> [Column; FOUND.len()] {
    let number = |of: &dyn Fn(&Dropped<R>) -> Option<f64>| Column::Number(drops.iter().map(of).collect());
    let word = |of: &dyn Fn(&Dropped<R>) -> Option<String>| Column::Word(drops.iter().map(of).collect());
    let landing = |dropped: &Dropped<R>| {
        let run = dropped.run.as_ref()?;
        run.landings().iter().find(|landing| landing.plate == plate).copied()
    };
    [
        word(&|d| Some(study::ending(d.ending))),
        word(&|d| d.run.as_ref().map(|run| run.outcome().word().to_owned())),
        number(&|d| landing(d).map(|l| l.impact_speed)),
        number(&|d| landing(d).map(|l| l.max_sliding_speed)),
        number(&|d| landing(d).map(|l| l.first_touch)),
        number(&|d| landing(d).and_then(|l| l.flat)),
        number(&|d| d.run.as_ref().map(|run| run.end_time())),
        number(&Dropped::<R>::margin),
    ]
}
