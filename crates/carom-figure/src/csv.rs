//! Every sample of a run as CSV.

use carom_feeder::{Feeder, Run};
use carom_motion::planar::trace::{ContactSample, Sample};
use carom_motion::planar::{Feature, Obstacle};
use carom_words::Words;

const FIRST: [&str; 9] =
    ["time_s", "stage", "x_m", "y_m", "angle_rad", "vx_m_s", "vy_m_s", "spin_rad_s", "contacts"];
const EACH: [&str; 9] = [
    "obstacle",
    "feature",
    "x_m",
    "y_m",
    "normal_x",
    "normal_y",
    "normal_force_N",
    "tangential_force_N",
    "slip_m_s",
];

/// Every sample of a run, one line each, in order of time: stage, pose, velocity, and for each contact that transmits force its obstacle
/// (number: plates first, then walls), features, point, normal, forces and slip.
///
/// World frame, x right, y up, angle and spin counter-clockwise; the unit stands in the column's name. Contacts fill the columns
/// `contact_1_…`, `contact_2_…`; fields that do not apply are empty. Numbers have all their digits. A run without a trace gives the head line alone.
pub fn trace_csv(feeder: &Feeder, run: &Run) -> String {
    let pieces = || run.trace.pieces.iter();
    let most = pieces().flat_map(|p| p.samples.iter()).map(|s| s.contacts.len()).max().unwrap_or(0);
    let mut head: Vec<String> = FIRST.map(str::to_owned).to_vec();
    for k in 1..=most {
        head.extend(EACH.map(|name| format!("contact_{k}_{name}")));
    }
    let mut out = head.join(",") + "\n";
    for (i, piece) in pieces().enumerate() {
        let stage = run.stages.iter().find(|s| s.pieces.contains(&i)).map_or("", |s| s.name.word());
        for sample in &piece.samples {
            out += &line(feeder, sample, stage, most);
        }
    }
    out
}

fn line(feeder: &Feeder, sample: &Sample, stage: &str, most: usize) -> String {
    let (pose, twist) = (sample.state.pose, sample.state.twist);
    let mut fields = vec![number(sample.time), stage.to_owned()];
    let state = [pose.centre.x, pose.centre.y, pose.angle, twist.velocity.x, twist.velocity.y, twist.spin];
    fields.extend(state.map(number));
    fields.push(sample.contacts.len().to_string());
    for k in 0..most {
        match sample.contacts.get(k) {
            Some(contact) => fields.extend(contact_fields(feeder, contact)),
            None => fields.extend(EACH.map(|_| String::new())),
        }
    }
    fields.join(",") + "\n"
}

fn contact_fields(feeder: &Feeder, c: &ContactSample) -> [String; EACH.len()] {
    [
        c.obstacle.to_string(),
        feature(c.feature, is_bent(feeder, c.obstacle)),
        number(c.point.x),
        number(c.point.y),
        number(c.normal.x),
        number(c.normal.y),
        number(c.normal_force),
        number(c.tangential_force),
        number(c.slip),
    ]
}

/// All digits of a number; nothing where it is not finite.
fn number(x: f64) -> String {
    if x.is_finite() { format!("{x:?}") } else { String::new() }
}

/// True for a plate or wall with more sides than two.
fn is_bent(feeder: &Feeder, obstacle: usize) -> bool {
    let walls = || feeder.walls.get(obstacle.checked_sub(feeder.plates.len())?).map(|wall| &wall.form);
    let form = feeder.plates.get(obstacle).map(|plate| &plate.form).or_else(walls);
    form.is_some_and(|form| !form.course.is_empty())
}

/// Of what is bent sides and ends go by number.
fn feature(feature: Feature, bent: bool) -> String {
    let end = |end: usize| match end {
        _ if bent => end.to_string(),
        Obstacle::TO => "to".to_owned(),
        _ => "from".to_owned(),
    };
    match feature {
        Feature::VertexOnFace { vertex, face } if bent => format!("vertex {vertex} on side {face}"),
        Feature::VertexOnFace { vertex, face } => {
            format!("vertex {vertex} on {} side", if face == Obstacle::LEFT { "left" } else { "right" })
        }
        Feature::FaceOnEnd { face, end: at } => format!("face {face} on end {}", end(at)),
        Feature::VertexOnEnd { vertex, end: at } => format!("vertex {vertex} on end {}", end(at)),
    }
}

/// A text as a cell of CSV: in quotes where it needs them.
///
/// # Example
/// ```
/// use carom_figure::csv_cell;
/// assert_eq!(["rod", "rod, long", "2\" rod"].map(csv_cell), ["rod", "\"rod, long\"", "\"2\"\" rod\""]);
/// ```
pub fn csv_cell(text: &str) -> String {
    if text.contains([',', '"', '\n']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}
