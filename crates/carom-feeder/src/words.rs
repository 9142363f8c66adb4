//! What ends a stage and what decides a margin, in words: for a person, in text, on pages and beside the data in JSON.

use crate::{Decided, Feeder, StageEnd, Touch};
use carom_motion::planar::Feature;

/// Why a stage ended: `front touches`, `6 strikes`.
///
/// # Example
/// A part that comes to rest.
/// ```
/// # use {carom_feeder::{Feeder, Part, Plate, Start, Stop}, carom_impact::planar::Law, carom_num::Vec2};
/// # let (friction, restitution, unbounded) = (0.9, 0.0, false);
/// # let (uphill, edge) = (Vec2::new(-0.8, 0.6), Vec2::ZERO);
/// # let plates = vec![Plate { name: "upper".to_owned(), uphill, edge, friction, restitution, unbounded }];
/// # let start = Start { to_edge: 0.1, speed: 0.0, face: 0 };
/// # let (part, law, stop) = (Part::rod(0.1, 0.3, 2.5e-4).unwrap(), Law::Poisson, Stop::Landed);
/// # let feeder = Feeder { gravity: 10.0, stop, law, part, start, plates, walls: vec![] };
/// use carom_feeder::words::stage_end;
/// let run = feeder.run().unwrap();
/// assert_eq!(stage_end(&feeder, &run.stages[0].ended_by), "rests");
/// ```
pub fn stage_end(feeder: &Feeder, end: &StageEnd) -> String {
    let feature = |touch: &Touch| feeder.feature_name(touch.feature);
    match end {
        StageEnd::Touches(touch) => format!("{} touches", feature(touch)),
        StageEnd::LiesDown(_) => "lies down".to_owned(),
        StageEnd::CentreAtEdge(_) => "centre at edge".to_owned(),
        StageEnd::LiftsOff(_) => "lift-off, N = 0".to_owned(),
        StageEnd::SlipStops(_) => "slip comes to zero".to_owned(),
        StageEnd::FrictionGivesWay(_) => "friction gives way".to_owned(),
        StageEnd::RunsOff(Touch { feature: Feature::FaceOnEnd { .. }, .. }) => {
            "trailing end at the edge".to_owned()
        }
        StageEnd::RunsOff(touch) => format!("{} runs off", feature(touch)),
        StageEnd::Painleve(_) => "Painlevé's paradox".to_owned(),
        StageEnd::Rests => "rests".to_owned(),
        StageEnd::FliesAway => "meets nothing more".to_owned(),
        StageEnd::OtherPart => "the other part".to_owned(),
        StageEnd::TimeUp => "time is up".to_owned(),
        StageEnd::Strikes { count, obstacles, limit } => strikes(feeder, *count, obstacles, *limit),
    }
}

/// `6 strikes, ever smaller, then their limit`; on what, where that is several obstacles.
fn strikes(feeder: &Feeder, count: usize, obstacles: &[usize], limit: bool) -> String {
    let on = match obstacles {
        [_, _, ..] => {
            let names: Vec<String> = obstacles.iter().map(|o| feeder.obstacle_label(*o)).collect();
            format!(" on {}", names.join(" and "))
        }
        _ => String::new(),
    };
    match (limit, count) {
        (true, 1) => "one strike, then the limit of ever smaller ones".to_owned(),
        (true, _) => format!("{count} strikes{on}, ever smaller, then their limit"),
        (false, _) => format!("{count} strikes{on}"),
    }
}

/// What the tightest decision was about.
///
/// # Example
/// ```
/// use carom_feeder::Decided;
/// use carom_feeder::words::decided;
/// assert_eq!(decided(Decided::Impact { time: 0.5 }), "the course of the impact at t = 0.500000 s");
/// ```
pub fn decided(what: Decided) -> String {
    match what {
        Decided::Nothing => "nothing was decided".to_owned(),
        Decided::Contacts { time } => format!("which contacts hold, stick or slip at t = {time:.6} s"),
        Decided::Impact { time } => format!("the course of the impact at t = {time:.6} s"),
    }
}
