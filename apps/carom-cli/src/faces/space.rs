//! The faces of a solid part.

use super::Told;
use crate::table::fixed;
use carom::tasks::solid::words::named;
use carom_feeder::spatial::Shown;
use carom_figure::{PoseBody, SolidDrawing, SolidInstant};
use carom_scene::{SolidFaceReport, SolidThrows, Thrown};
use carom_study::poses::{Pose, Poses};

/// What the columns mean.
pub(crate) const NOTE: &str = "inside: how far the mass centre is from the nearest side of the face; tips after: the least tilt, over the side that two corners name, onto the face beyond it\n\
     tips onto it gently: the share of all attitudes, by solid angles, from which it tips or rolls onto the face too slowly to swing on\n";

/// The faces of a solid part as rows of a table: lengths in millimetres, angles in degrees.
pub(crate) fn table(faces: &[SolidFaceReport]) -> Vec<Vec<String>> {
    let heads = [
        "face",
        "corners",
        "centre above",
        "inside",
        "tips after",
        "over",
        "onto face",
        "tips onto it gently",
    ];
    let millimetres = |length: f64| format!("{} mm", fixed(1e3 * length, 2));
    let row = |face: &SolidFaceReport| {
        // Where the part does not stay this is the side over which it rolls off.
        let [from, to] = face.tips_over;
        vec![
            face.face.to_string(),
            corners(face),
            millimetres(face.centre_height_m),
            millimetres(face.margin_m),
            if face.stable {
                format!("{} deg", fixed(face.tips_after_rad.to_degrees(), 1))
            } else {
                "does not stay".to_owned()
            },
            format!("{from}–{to}"),
            face.tips_onto.to_string(),
            format!("{} %", fixed(100.0 * face.quasi_static_share, 2)),
        ]
    };
    std::iter::once(heads.map(str::to_owned).to_vec()).chain(faces.iter().map(row)).collect()
}

/// The corners of a face, the first of many.
fn corners(face: &SolidFaceReport) -> String {
    named(&face.corners.iter().map(usize::to_string).collect::<Vec<_>>())
}

/// The part on the face that comes up most; on its first one where none does.
fn resting_instant(throws: &SolidThrows<'_>, found: &Poses) -> Option<SolidInstant> {
    let faces = found.ends.iter().filter_map(|end| match end.pose {
        Pose::Face(face) => Some((face, end.probability.count)),
        _ => None,
    });
    let (most, _) = faces.rev().max_by_key(|(_, count)| *count)?;
    let state = throws.resting_on(most)?;
    let (centre, attitude) = (state.centre, state.attitude);
    Some(SolidInstant { time: 0.0, centre, attitude, tilt: 0.0, held: vec![], places: vec![] })
}

impl Told for SolidThrows<'_> {
    /// A throw takes some 20 ms, a thousand times as long as in the plane.
    const THROWS: u64 = 512;
    const NO_FACES: &'static str = "its hull has no faces";
    const WAYS: [&'static str; 2] = ["level", "about any axis"];
    const MODEL: &'static str = "The model: rigid part, level ground, dry friction after Coulomb; tolerances of the scene are not used.";
    const NOTE: &'static str = NOTE;

    fn table(faces: &[SolidFaceReport]) -> Vec<Vec<String>> {
        table(faces)
    }

    fn on_page(face: &SolidFaceReport) -> (String, Option<[f64; 2]>) {
        (corners(face), Some([face.centre_height_m, face.margin_m]))
    }

    fn is_minor(face: &SolidFaceReport) -> bool {
        !face.stable
    }

    fn page(&self, found: &Poses, page: impl Fn(PoseBody<'_>) -> String) -> String {
        let part = &self.scene().feeder().part;
        let Shown { corners, faces, numbers, seams } = part.shown();
        let points = part.body.supports();
        let names: Vec<String> = (0..points.len()).map(|corner| corner.to_string()).collect();
        let drawing = SolidDrawing {
            corners: &corners,
            faces: &faces,
            numbers: Some(&numbers),
            seams: &seams,
            lines: &[],
            points,
            names: &names,
        };
        let instants: Vec<SolidInstant> = resting_instant(self, found).into_iter().collect();
        page(PoseBody::Solid(drawing, &instants))
    }
}
