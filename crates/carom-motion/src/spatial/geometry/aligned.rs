//! Pieces of one body whose faces lie on the same planes.

use super::hull::welded;
use super::plane::Plane;
use super::polyhedron::{Face, Polyhedron};
use carom_num::Vec3;

/// How far corners of faces on one plane may be from it, in units of the flatness that they were told apart with.
const ON_PLANE: f64 = 4.0;

/// A plane says where a corner is along its normal where so much of that, as a sine, is beside what others say: 3°, so that corners move by twenty times the digits of a file at most.
const INDEPENDENT: f64 = 0.05;

/// The same pieces, moved by little more than the flatness \[m\]: faces that lie on one plane do so to the last digits, and corners in one place too. What slides from a face of one piece
/// to that of another meets no step. So do the faces of their hull, which may go over a hollow: the body may lie on these.
pub(super) fn aligned(hull: &Polyhedron, pieces: &[Polyhedron], flatness: f64) -> Vec<Polyhedron> {
    let near = ON_PLANE * flatness;
    let pieces = [std::slice::from_ref(hull), pieces].concat();
    let (planes, on) = planes(&pieces, near);
    let places: Vec<Vec3> = pieces.iter().flat_map(Polyhedron::vertices).copied().collect();
    let stands = welded(&places, near);
    let moved = |k: usize| {
        let place = places[stands[k]];
        let mut own: Vec<usize> = pieces
            .iter()
            .zip(&on)
            .flat_map(|(piece, on)| faces_at(piece, place, near).map(|face| on[face]))
            .collect();
        own.sort_unstable();
        own.dedup();
        let (mut by, mut along): (Vec3, Vec<Vec3>) = (Vec3::ZERO, vec![]);
        for plane in own {
            let normal = planes[plane].normal();
            let free = along.iter().fold(normal, |free, fixed| free - *fixed * fixed.dot(normal));
            // Where the planes before it leave no way to it, it has to be there already, but for digits.
            if let Some(direction) = free.unit().filter(|_| free.norm() > INDEPENDENT) {
                by += direction * (-planes[plane].height(place + by) / free.norm());
                along.push(direction);
            }
        }
        place + by
    };
    let mut from = 0;
    let placed = |(piece, on): (&Polyhedron, &Vec<usize>)| {
        let vertices = (from..from + piece.vertices().len()).map(moved).collect();
        from += piece.vertices().len();
        let turned = |(face, plane): (&Face, &usize)| {
            let normal = planes[*plane].normal();
            if normal.dot(face.normal) < 0.0 { -normal } else { normal }
        };
        piece.placed(vertices, piece.faces().iter().zip(on).map(turned))
    };
    pieces.iter().zip(&on).map(placed).skip(1).collect()
}

/// The faces of a piece that a place is on: it may be none of its corners, but within an edge.
fn faces_at(piece: &Polyhedron, place: Vec3, near: f64) -> impl Iterator<Item = usize> {
    let heights: Vec<f64> = piece.faces().iter().map(|face| piece.height(face, place)).collect();
    let has = heights.iter().all(|height| *height <= near);
    (0..heights.len()).filter(move |face| has && heights[*face] >= -near)
}

/// The planes of all faces, those first that count most, and of each piece on which of them each face lies.
fn planes(pieces: &[Polyhedron], near: f64) -> (Vec<Plane>, Vec<Vec<usize>>) {
    let mut all: Vec<(usize, usize, f64)> = vec![];
    for (k, piece) in pieces.iter().enumerate() {
        all.extend((0..piece.faces().len()).map(|face| (k, face, piece.area(face))));
    }
    // On faces of the hull, the first piece, the body lies; of others the plane of the largest one is known best.
    all.sort_by(|a, b| (a.0 > 0).cmp(&(b.0 > 0)).then(b.2.total_cmp(&a.2)));
    let mut planes: Vec<Plane> = vec![];
    let mut on: Vec<Vec<usize>> = pieces.iter().map(|piece| vec![0; piece.faces().len()]).collect();
    for (k, face, _) in all {
        let (piece, own) = (&pieces[k], &pieces[k].faces()[face]);
        let places: Vec<Vec3> = own.corners.iter().map(|i| piece.vertices()[*i]).collect();
        let found = planes.iter().position(|plane| places.iter().all(|r| plane.height(*r).abs() <= near));
        on[k][face] = found.unwrap_or_else(|| {
            #[expect(clippy::cast_precision_loss, reason = "a handful")]
            let count = places.len() as f64;
            let offset = places.iter().map(|r| own.normal.dot(*r)).sum::<f64>() / count;
            planes.push(Plane::of_unit(own.normal, offset));
            planes.len() - 1
        });
    }
    (planes, on)
}
