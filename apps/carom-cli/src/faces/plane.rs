//! The faces of a part in the plane.

use super::Told;
use crate::pipeline::draft;
use crate::table::fixed;
use carom_figure::PoseBody;
use carom_motion::planar::RestKind;
use carom_scene::{FaceReport, PartThrows, Thrown};
use carom_study::poses::Poses;

/// The faces of a part as rows of a table: lengths in millimetres, angles in degrees.
pub(crate) fn table(faces: &[FaceReport]) -> Vec<Vec<String>> {
    let heads =
        ["face", "lies on", "width", "centre above", "inside the ends", "tips after", "tips onto it gently"];
    let millimetres = |length: f64| fixed(1e3 * length, 2);
    let row = |face: &FaceReport| {
        let [first, second] = face.inside_m.map(millimetres);
        let [clockwise, counter] = face.tips_after_rad.map(|angle| fixed(angle.to_degrees(), 1));
        let arc = face.kind.0 == RestKind::Arc;
        let dash = || "–".to_owned();
        vec![
            face.face.to_string(),
            face.kind.to_string(),
            if arc { dash() } else { format!("{} mm", millimetres(face.width_m)) },
            format!("{} mm", millimetres(face.centre_height_m)),
            if arc { dash() } else { format!("{first} | {second} mm") },
            if face.stable { format!("{clockwise} | {counter} deg") } else { "does not stay".to_owned() },
            format!("{} %", fixed(100.0 * face.quasi_static_share, 2)),
        ]
    };
    std::iter::once(heads.map(str::to_owned).to_vec()).chain(faces.iter().map(row)).collect()
}

/// What the two numbers of a column mean.
pub(crate) const TABLE_NOTE: &str = "two numbers: towards the end that comes first counter-clockwise and the other one; tilted clockwise and counter-clockwise\n\
     tips onto it gently: the share of all attitudes from which it tips onto the face too slowly to swing on\n";

impl Told for PartThrows<'_> {
    const THROWS: u64 = 4096;
    const NO_FACES: &'static str = "a disc lies alike on all its rim: it has no faces";
    const WAYS: [&'static str; 2] = ["to either side", "in either sense"];
    const MODEL: &'static str = "The model: plane motion, rigid part, level ground, dry friction after Coulomb; tolerances of the scene are not used. A part that rolls to and fro for ever, because nothing takes energy from it, counts as being on the face of that arc.";
    const NOTE: &'static str = TABLE_NOTE;

    fn table(faces: &[FaceReport]) -> Vec<Vec<String>> {
        table(faces)
    }

    fn on_page(_: &FaceReport) -> (String, Option<[f64; 2]>) {
        // The page draws them.
        (String::new(), None)
    }

    fn is_minor(_: &FaceReport) -> bool {
        false
    }

    fn page(&self, _: &Poses, page: impl Fn(PoseBody<'_>) -> String) -> String {
        page(PoseBody::Part(self.scene().feeder(), &draft(self.scene())))
    }
}
