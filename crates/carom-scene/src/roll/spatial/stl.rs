//! Surfaces from STL files, binary and ASCII.

use crate::input::Beside;
use carom_motion::spatial::{Mesh, MeshProblem};
use carom_num::Vec3;
use std::collections::BTreeMap;
use std::io::{Cursor, ErrorKind};

/// Bytes of a binary file before its facets, and of a facet.
const HEAD: usize = 84;
const FACET: usize = 50;
/// What the first bytes of a binary file become that begins as an ASCII one does: the header means nothing.
const HEADER: &[u8; 5] = b"STL  ";
/// Problems of a surface that are told.
const MOST_TOLD: usize = 8;

/// Reads a file's surface; corners at the same place are one vertex. A length of 1 in the file is `unit` \[m\].
///
/// # Errors
/// Why it could not be read.
pub(super) fn read(beside: Beside<'_>, name: &str, unit: f64) -> Result<Mesh, String> {
    let bytes = beside.files.bytes(&beside.folder.join(name)).map_err(|error| match error.kind() {
        ErrorKind::NotFound => "there is no such file".to_owned(),
        _ => error.to_string(),
    })?;
    surface(bytes, unit)
}

fn surface(mut bytes: Vec<u8>, unit: f64) -> Result<Mesh, String> {
    if bytes.is_empty() {
        return Err("the file is empty".to_owned());
    }
    let facets = bytes.get(HEAD - 4..HEAD).and_then(|count| <[u8; 4]>::try_from(count).ok());
    let facets = facets.map(|count| u32::from_le_bytes(count) as usize);
    if facets.and_then(|n| n.checked_mul(FACET)).is_some_and(|length| bytes.len() == HEAD + length) {
        bytes[..HEADER.len()].copy_from_slice(HEADER);
    }
    let mut cursor = Cursor::new(bytes);
    let triangles = stl_io::create_stl_reader(&mut cursor).map_err(|error| unreadable(&error))?;
    let mut known: BTreeMap<[u32; 3], usize> = BTreeMap::new();
    let mut mesh = Mesh::default();
    for triangle in triangles {
        let triangle = triangle.map_err(|error| unreadable(&error))?;
        let facet = triangle.vertices.map(|vertex| {
            // −0 and 0 are one place.
            let place = vertex.0.map(|x| x + 0.0);
            *known.entry(place.map(f32::to_bits)).or_insert_with(|| {
                mesh.vertices.push(Vec3::from_array(place.map(|x| f64::from(x) * unit)));
                mesh.vertices.len() - 1
            })
        });
        mesh.facets.push(facet);
    }
    if mesh.facets.is_empty() { Err("it has no facets".to_owned()) } else { Ok(mesh) }
}

fn unreadable(error: &std::io::Error) -> String {
    match error.kind() {
        ErrorKind::UnexpectedEof => "it ends within a facet, or is no STL file".to_owned(),
        _ => format!("it is no STL file that can be read: {error}"),
    }
}

/// The problems of a surface in words, not more than one can read.
pub(super) fn in_words(problems: &[MeshProblem]) -> Vec<String> {
    let mut words: Vec<String> = problems.iter().take(MOST_TOLD).map(ToString::to_string).collect();
    if let Some(more) = problems.len().checked_sub(MOST_TOLD).filter(|more| *more > 0) {
        words.push(format!("and {more} more problems of the surface"));
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;
    use stl_io::{Normal, Triangle, Vertex};

    /// A tetrahedron, as STL has it.
    fn triangles() -> Vec<Triangle> {
        let corners = [[0.0, 0.0, 0.0], [10.0, 0.0, 0.0], [0.0, 10.0, 0.0], [0.0, 0.0, 10.0_f32]];
        let facet = |f: [usize; 3]| Triangle {
            normal: Normal::new([0.0; 3]),
            vertices: f.map(|i| Vertex::new(corners[i])),
        };
        [[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3]].map(facet).to_vec()
    }

    fn ascii() -> String {
        let mut text = "solid tetrahedron\n".to_owned();
        for triangle in triangles() {
            text += " facet normal 0 0 0\n  outer loop\n";
            for vertex in triangle.vertices {
                let [x, y, z] = vertex.0;
                text += &format!("   vertex {x} {y} {z}\n");
            }
            text += "  endloop\n endfacet\n";
        }
        text + "endsolid tetrahedron\n"
    }

    fn binary() -> Vec<u8> {
        let mut bytes = vec![];
        stl_io::write_stl(&mut bytes, triangles().iter()).unwrap();
        bytes
    }

    #[test]
    fn binary_and_ascii_are_one_surface() {
        let (of_text, of_bytes) = (surface(ascii().into(), 1e-3).unwrap(), surface(binary(), 1e-3).unwrap());
        assert_eq!(of_text, of_bytes);
        assert_eq!((of_text.vertices.len(), of_text.facets.len()), (4, 4));
        let solid = of_text.solid().unwrap();
        assert!((solid.volume - 1e-6 / 6.0).abs() < 1e-20, "{solid:?}");
    }

    #[test]
    fn a_binary_file_may_begin_as_an_ascii_one() {
        let mut bytes = binary();
        bytes[..6].copy_from_slice(b"solid ");
        assert_eq!(surface(bytes, 1e-3), surface(binary(), 1e-3));
    }

    #[test]
    fn what_is_no_stl_says_so() {
        let cut = binary()[..120].to_vec();
        for bytes in [vec![], b"solid nothing\nendsolid nothing\n".to_vec(), b"PK".to_vec(), cut] {
            let shown = format!("{:?}", bytes.get(..8));
            assert!(surface(bytes, 1.0).is_err(), "{shown}");
        }
        let text = ascii().replace("vertex 10 0 0", "vertex 10 zero 0");
        assert!(surface(text.into(), 1.0).unwrap_err().contains("no STL file"), "a word for a number");
    }
}
