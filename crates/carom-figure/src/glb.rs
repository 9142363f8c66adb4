//! A run in space as one binary file of glTF 2.0: the part, plates and walls as meshes, and the part's motion as an animation, for whatever shows models in space.

use crate::player::json_text;
use crate::solid::SolidInstant;
use crate::space_scene::SpaceScene;
use carom_feeder::spatial::{Feeder, Run, Shown};
use carom_num::Vec3;
use carom_num::solve::dot;
use std::f64::consts::FRAC_1_SQRT_2;

/// `glTF`, the version of the container, and the types of its two chunks.
const MAGIC: &[u8; 4] = b"glTF";
const VERSION: u32 = 2;
const JSON_CHUNK: &[u8; 4] = b"JSON";
const BINARY_CHUNK: &[u8; 4] = b"BIN\0";
/// Numbers of the format: 32-bit floats; what vertices read, and triangles.
const FLOAT: u32 = 5126;
const VERTICES: u32 = 34962;
const TRIANGLES: u32 = 4;
/// Materials by their numbers: the part, its face that was down at the start, plates and walls.
const PART: usize = 0;
const START_FACE: usize = 1;
const PLATE: usize = 2;

/// A run as a file of glTF 2.0 (`.glb`): lengths in metres, y upwards, as the drawing has it. Its animation goes at the speed of the run, linear between samples; numbers are of
/// single precision. What a plate has no end of is cut near the way of the part.
///
/// # Source
/// Khronos Group, glTF 2.0 specification (ISO/IEC 12113:2022).
///
/// # Example
/// ```
/// let feeder = carom_feeder::spatial::examples::two_plates();
/// let file = carom_figure::space_glb(&feeder, &feeder.run()?);
/// let length = u32::from_le_bytes([file[8], file[9], file[10], file[11]]);
/// assert_eq!((&file[..4], length as usize), (&b"glTF"[..], file.len()));
/// # Ok::<(), carom_feeder::RunError>(())
/// ```
pub fn space_glb(feeder: &Feeder, run: &Run) -> Vec<u8> {
    let scene = SpaceScene::new(feeder, run);
    let shown = scene.figure(feeder);
    let mut file = File::default();
    let part = file.mesh("part", &part_pieces(feeder));
    let placed = scene.instants.first().map_or(String::new(), |first| {
        format!(r#","translation":{:?},"rotation":{:?}"#, first.centre.to_array(), turn(first))
    });
    let mut nodes = vec![format!(r#"{{"name":"part","mesh":{part}{placed}}}"#)];
    for plate in shown.around {
        let mesh = file.mesh(&plate.name, &[(PLATE, fan(&plate.corners))]);
        nodes.push(format!(r#"{{"name":{},"mesh":{mesh}}}"#, json_text(&plate.name)));
    }
    let animation = file.animation(&scene);
    // The picture has z upwards, glTF has y.
    let children: Vec<usize> = (0..nodes.len()).collect();
    let turned = [-FRAC_1_SQRT_2, 0.0, 0.0, FRAC_1_SQRT_2];
    nodes.push(format!(r#"{{"name":"drawing","rotation":{turned:?},"children":{children:?}}}"#));
    file.whole(&nodes, &animation)
}

/// The triangles of the part by their materials.
fn part_pieces(feeder: &Feeder) -> [(usize, Vec<[Vec3; 3]>); 2] {
    let Shown { corners, faces, numbers, .. } = feeder.part.shown();
    let of = |face: &Vec<usize>| fan(&face.iter().map(|corner| corners[*corner]).collect::<Vec<_>>());
    let faces = faces.iter().enumerate();
    let (down, others): (Vec<_>, Vec<_>) =
        faces.partition(|(face, _)| numbers.get(*face) == Some(&feeder.start.face));
    let all = |faces: Vec<(usize, &Vec<usize>)>| faces.into_iter().flat_map(|(_, face)| of(face)).collect();
    [(PART, all(others)), (START_FACE, all(down))]
}

/// An attitude as the format has it: x, y, z, w.
fn turn(at: &SolidInstant) -> [f64; 4] {
    let [w, x, y, z] = at.attitude.to_array();
    [x, y, z, w]
}

/// The triangles of a convex polygon.
fn fan(corners: &[Vec3]) -> Vec<[Vec3; 3]> {
    let Some((first, others)) = corners.split_first() else { return vec![] };
    others.windows(2).map(|pair| [*first, pair[0], pair[1]]).collect()
}

/// What is written, piece by piece.
#[derive(Default)]
struct File {
    bytes: Vec<u8>,
    views: Vec<String>,
    accessors: Vec<String>,
    meshes: Vec<String>,
}

impl File {
    /// Rows of numbers, of a type that the format names; `vertices` where a mesh is made of them. Returns their number.
    fn rows<const N: usize>(&mut self, of: &str, vertices: bool, rows: &[[f64; N]]) -> usize {
        let offset = self.bytes.len();
        let single: Vec<[f32; N]> = rows.iter().map(|row| row.map(|x| x as f32)).collect();
        single.iter().flatten().for_each(|x| self.bytes.extend(x.to_le_bytes()));
        let target = if vertices { format!(r#","target":{VERTICES}"#) } else { String::new() };
        let length = self.bytes.len() - offset;
        self.views.push(format!(r#"{{"buffer":0,"byteOffset":{offset},"byteLength":{length}{target}}}"#));
        let end = |of: fn(f32, f32) -> f32| -> Vec<f32> {
            (0..N).filter_map(|k| single.iter().map(|row| row[k]).reduce(of)).collect()
        };
        let (view, count) = (self.views.len() - 1, rows.len());
        let (least, most) = (end(f32::min), end(f32::max));
        self.accessors.push(format!(
            r#"{{"bufferView":{view},"componentType":{FLOAT},"count":{count},"type":"{of}","min":{least:?},"max":{most:?}}}"#
        ));
        self.accessors.len() - 1
    }

    /// A mesh of triangles, flat ones, by their materials. Returns its number.
    fn mesh(&mut self, name: &str, pieces: &[(usize, Vec<[Vec3; 3]>)]) -> usize {
        let mut primitives = vec![];
        for (material, triangles) in pieces.iter().filter(|(_, triangles)| !triangles.is_empty()) {
            let places: Vec<[f64; 3]> = triangles.iter().flatten().map(|place| place.to_array()).collect();
            let normal = |[a, b, c]: &[Vec3; 3]| (*b - *a).cross(*c - *a).unit().unwrap_or(Vec3::Z);
            let normals: Vec<[f64; 3]> = triangles.iter().flat_map(|t| [normal(t).to_array(); 3]).collect();
            let (places, normals) = (self.rows("VEC3", true, &places), self.rows("VEC3", true, &normals));
            primitives.push(format!(
                r#"{{"attributes":{{"POSITION":{places},"NORMAL":{normals}}},"material":{material},"mode":{TRIANGLES}}}"#
            ));
        }
        self.meshes.push(format!(
            r#"{{"name":{},"primitives":[{}]}}"#,
            json_text(name),
            primitives.join(",")
        ));
        self.meshes.len() - 1
    }

    /// The motion of the part, which is the first node; nothing where it does not move.
    fn animation(&mut self, scene: &SpaceScene) -> String {
        // Before and after a strike the part is at the same place: times must rise, in single precision too.
        let mut kept: Vec<usize> = vec![];
        for (i, instant) in scene.instants.iter().enumerate() {
            let last = kept.last().map(|k| scene.instants[*k].time as f32);
            if last.is_none_or(|last| instant.time as f32 > last) {
                kept.push(i);
            }
        }
        if kept.len() < 2 {
            return String::new();
        }
        let instants = || kept.iter().map(|k| &scene.instants[*k]);
        let times: Vec<[f64; 1]> = instants().map(|at| [at.time]).collect();
        let places: Vec<[f64; 3]> = instants().map(|at| at.centre.to_array()).collect();
        let mut turns: Vec<[f64; 4]> = vec![];
        for at in instants() {
            let own = turn(at);
            // Of the two quaternions of an attitude the one that is nearer to that before.
            let back = turns.last().is_some_and(|last| dot(last, &own) < 0.0);
            turns.push(own.map(|part| if back { -part } else { part }));
        }
        let input = self.rows("SCALAR", false, &times);
        let outputs = [self.rows("VEC3", false, &places), self.rows("VEC4", false, &turns)];
        let sampler =
            |output: usize| format!(r#"{{"input":{input},"interpolation":"LINEAR","output":{output}}}"#);
        let channel =
            |k: usize, path: &str| format!(r#"{{"sampler":{k},"target":{{"node":0,"path":"{path}"}}}}"#);
        let (samplers, channels) =
            (outputs.map(sampler).join(","), [channel(0, "translation"), channel(1, "rotation")].join(","));
        format!(r#"{{"name":"motion","samplers":[{samplers}],"channels":[{channels}]}}"#)
    }

    /// The file as a whole; the last node holds all others.
    fn whole(self, nodes: &[String], animation: &str) -> Vec<u8> {
        let material = |name: &str, colour: [f64; 4]| {
            let mode = if colour[3] < 1.0 { "BLEND" } else { "OPAQUE" };
            format!(
                r#"{{"name":"{name}","doubleSided":true,"alphaMode":"{mode}","pbrMetallicRoughness":{{"baseColorFactor":{colour:?},"metallicFactor":0.1,"roughnessFactor":0.8}}}}"#
            )
        };
        let materials = [
            material("part", [0.55, 0.6, 0.68, 1.0]),
            material("face that was down at the start", [0.9, 0.45, 0.1, 1.0]),
            material("plates and walls", [0.75, 0.75, 0.72, 0.6]),
        ];
        let list = |name: &str, of: &[String]| format!(r#","{name}":[{}]"#, of.join(","));
        // A list without members is not allowed.
        let moves =
            if animation.is_empty() { String::new() } else { format!(r#","animations":[{animation}]"#) };
        let tree = [
            format!(r#"{{"asset":{{"version":"2.0","generator":"carom {}"}}"#, env!("CARGO_PKG_VERSION")),
            format!(r#","scene":0,"scenes":[{{"nodes":[{}]}}]"#, nodes.len() - 1),
            list("nodes", nodes),
            list("meshes", &self.meshes),
            list("materials", &materials),
            list("accessors", &self.accessors),
            list("bufferViews", &self.views),
            format!(r#","buffers":[{{"byteLength":{}}}]{moves}}}"#, self.bytes.len()),
        ];
        let text = padded(tree.concat().into_bytes(), b' ');
        let binary = padded(self.bytes, 0);
        let length = 12 + 8 + text.len() + 8 + binary.len();
        let number = |n: usize| u32::try_from(n).unwrap_or(u32::MAX).to_le_bytes();
        let head = [MAGIC.as_slice(), &VERSION.to_le_bytes(), &number(length)].concat();
        let chunk = |kind: &[u8; 4], bytes: &[u8]| [&number(bytes.len()), kind.as_slice(), bytes].concat();
        [head, chunk(JSON_CHUNK, &text), chunk(BINARY_CHUNK, &binary)].concat()
    }
}

/// To a whole number of four bytes.
fn padded(mut bytes: Vec<u8>, with: u8) -> Vec<u8> {
    bytes.resize(bytes.len().next_multiple_of(4), with);
    bytes
}
