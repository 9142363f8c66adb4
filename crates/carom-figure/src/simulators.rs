//! A scene for simulators: MJCF for MuJoCo, URDF with meshes for Bullet, Drake and others.

use crate::blocks::{Block, Blocks, blocks};
use crate::markup::{Markup, document, html};
use carom_feeder::Feeder;
use carom_num::Vec2;
use carom_num::elementary::{cos, sin};
use std::fmt::Write as _;

/// Step [s] and softness of contacts with which MuJoCo gives the verdicts of the drops that were compared.
const STEP: &str = "0.00005";
const SOLREF: &str = "0.0008 3";
const SOLIMP: &str = "0.95 0.99 0.001";

/// A scene as files for simulators, by their names: `scene.mjcf.xml`, `part.urdf`, `plates.urdf`, and the meshes of the part, `part-0.obj` and on.
///
/// World: x to the right, z up, y into the page, SI. MJCF holds the whole scene, the part on two slides and a hinge so that it stays in the
/// plane, at its start. URDF has no world: the part is one file, what stands still the other, and comments say where the part starts.
///
/// # Limits
/// What differs from the scene is said at the head of each file. MJCF has no coefficient of restitution: where the scene has one, it is said.
/// Friction and restitution of URDF are in the elements that Bullet reads; other readers of URDF have their own.
pub fn simulator_files(feeder: &Feeder, name: &str) -> Vec<(String, String)> {
    let mut made = blocks(feeder);
    let restitution = made.standing.iter().map(|one| one.restitution).fold(0.0, f64::max);
    if restitution > 0.0 {
        made.notes.push(format!(
            "Restitution (up to {restitution}) is not written for MuJoCo, which has no coefficient"
        ));
    }
    let mut files = vec![
        ("scene.mjcf.xml".to_owned(), mjcf(feeder, &made, name)),
        ("part.urdf".to_owned(), part_urdf(feeder, &made, name)),
        ("plates.urdf".to_owned(), plates_urdf(&made, name)),
    ];
    for (i, block) in made.part.iter().enumerate() {
        if let Block::Prism(corners) = block {
            files.push((format!("part-{i}.obj"), obj(corners, made.half_width)));
        }
    }
    files
}

/// What a file says first.
fn head(made: &Blocks, what: &str) -> String {
    let ((centre, angle), notes) = (made.start, made.notes.join(". "));
    // Two hyphens end a comment.
    let notes = notes.replace("--", "- -");
    format!(
        "<!-- {what}. SI, x to the right, z up. The part starts with its mass centre at ({}, 0, {}), turned by {angle} rad about the axis -y. {notes}. -->\n",
        centre.x, centre.y
    )
}

fn numbers(all: &[f64]) -> String {
    all.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ")
}

fn mjcf(feeder: &Feeder, made: &Blocks, name: &str) -> String {
    let body = &feeder.part.body;
    let ((centre, angle), speed) = (made.start, feeder.start_state().twist.velocity);
    // Slides are along the axes of the world, seen from the body, which is turned.
    let (c, s) = (cos(angle), sin(angle));
    let inertia = numbers(&[body.inertia; 3]);
    let elements = html! {
        mujoco model=(name) {
            option timestep=(STEP) gravity=(numbers(&[0.0, 0.0, -feeder.gravity])) cone="elliptic" impratio="10" {}
            default { geom solref=(SOLREF) solimp=(SOLIMP) condim="3" {} }
            asset {
                @for (i, block) in made.part.iter().enumerate() {
                    @if let Block::Prism(corners) = block {
                        mesh name=(format!("part-{i}")) vertex=(prism(corners, made.half_width)) {}
                    }
                }
            }
            worldbody {
                @for (n, one) in made.standing.iter().enumerate() {
                    @for (i, block) in one.blocks.iter().enumerate() {
                        // Of two that touch the friction with the higher priority counts: that of what stands still.
                        (geom(block, &format!("{n}-{}-{i}", one.name), &format!("{} 0 0", one.friction), ("1", made.half_width)))
                    }
                }
                body name="part" pos=(numbers(&[centre.x, 0.0, centre.y])) quat=(turned(angle)) {
                    joint name="x" type="slide" axis=(numbers(&[c, 0.0, -s])) {}
                    joint name="z" type="slide" axis=(numbers(&[s, 0.0, c])) {}
                    joint name="angle" type="hinge" axis="0 -1 0" {}
                    inertial pos="0 0 0" mass=(body.mass) diaginertia=(inertia) {}
                    @for (i, block) in made.part.iter().enumerate() {
                        (geom(block, &format!("part-{i}"), "0 0 0", ("0", made.half_width)))
                    }
                }
            }
            keyframe { key name="start" qpos="0 0 0" qvel=(numbers(&[speed.x, speed.y, 0.0])) {} }
        }
    };
    head(made, "For MuJoCo: what stands still, and the part that moves in the plane") + &xml(elements)
}

/// A block of MuJoCo's.
fn geom(block: &Block, name: &str, friction: &str, (priority, half_width): (&str, f64)) -> Markup {
    match block {
        Block::Box { middle, angle, half } => html! {
            geom name=(name) type="box" size=(numbers(&[half[0], half_width, half[1]])) pos=(numbers(&[middle.x, 0.0, middle.y]))
                quat=(turned(*angle)) friction=(friction) priority=(priority) {}
        },
        Block::Prism(_) => {
            html! { geom name=(name) type="mesh" mesh=(name) friction=(friction) priority=(priority) {} }
        }
        Block::Disc(middle, radius) => html! {
            geom name=(name) type="cylinder" size=(numbers(&[*radius, half_width])) pos=(numbers(&[middle.x, 0.0, middle.y]))
                euler="90 0 0" friction=(friction) priority=(priority) {}
        },
    }
}

/// The attitude (w, x, y, z) of what is turned against the clock in the plane, about -y.
fn turned(angle: f64) -> String {
    numbers(&[cos(0.5 * angle), 0.0, -sin(0.5 * angle), 0.0])
}

fn part_urdf(feeder: &Feeder, made: &Blocks, name: &str) -> String {
    let body = &feeder.part.body;
    let i = body.inertia;
    let elements = html! {
        robot name=(format!("{name}-part")) {
            link name="part" {
                contact { lateral_friction value="1" {} restitution value="1" {} }
                inertial {
                    mass value=(body.mass) {}
                    inertia ixx=(i) ixy="0" ixz="0" iyy=(i) iyz="0" izz=(i) {}
                }
                @for (n, block) in made.part.iter().enumerate() {
                    (solid(block, &format!("part-{n}.obj"), made.half_width))
                }
            }
        }
    };
    head(made, "The part, free in space: hold it in the plane where that counts") + &xml(elements)
}

fn plates_urdf(made: &Blocks, name: &str) -> String {
    let elements = html! {
        robot name=(format!("{name}-plates")) {
            link name="plates" {}
            @for (n, one) in made.standing.iter().enumerate() {
                link name=(format!("{n}-{}", one.name)) {
                    contact { lateral_friction value=(one.friction) {} restitution value=(one.restitution) {} }
                    inertial { mass value="0" {} inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0" {} }
                    @for block in &one.blocks { (solid(block, "", made.half_width)) }
                }
                joint name=(format!("{n}-{}-stands", one.name)) type="fixed" {
                    parent link="plates" {}
                    child link=(format!("{n}-{}", one.name)) {}
                }
            }
        }
    };
    head(
        made,
        "What stands still; Bullet multiplies the coefficients of both that touch, so the part has ones",
    ) + &xml(elements)
}

/// A block of URDF: what is seen and what touches.
fn solid(block: &Block, mesh: &str, half_width: f64) -> Markup {
    let (origin, shape) = match block {
        Block::Box { middle, angle, half } => (
            html! { origin xyz=(numbers(&[middle.x, 0.0, middle.y])) rpy=(numbers(&[0.0, -angle, 0.0])) {} },
            html! { geometry { box size=(numbers(&[2.0 * half[0], 2.0 * half_width, 2.0 * half[1]])) {} } },
        ),
        Block::Prism(_) => {
            (html! { origin xyz="0 0 0" rpy="0 0 0" {} }, html! { geometry { mesh filename=(mesh) {} } })
        }
        Block::Disc(middle, radius) => (
            html! { origin xyz=(numbers(&[middle.x, 0.0, middle.y])) rpy=(numbers(&[std::f64::consts::FRAC_PI_2, 0.0, 0.0])) {} },
            html! { geometry { cylinder radius=(radius) length=(2.0 * half_width) {} } },
        ),
    };
    html! {
        visual { (origin) (shape) }
        collision { (origin) (shape) }
    }
}

/// The corners of a prism, near side first.
fn prism(corners: &[Vec2], half_width: f64) -> String {
    let side = |y: f64| corners.iter().flat_map(move |corner| [corner.x, y, corner.y]);
    numbers(&side(-half_width).chain(side(half_width)).collect::<Vec<_>>())
}

/// A prism as a Wavefront OBJ mesh of triangles that are seen from outside.
fn obj(corners: &[Vec2], half_width: f64) -> String {
    let count = corners.len();
    let mut text = String::new();
    // Writing to a String cannot fail.
    for y in [-half_width, half_width] {
        for corner in corners {
            let _ = writeln!(text, "v {} {y} {}", corner.x, corner.y);
        }
    }
    let mut face = |a: usize, b: usize, c: usize| {
        let _ = writeln!(text, "f {} {} {}", a + 1, b + 1, c + 1);
    };
    for i in 1..count - 1 {
        face(0, i, i + 1);
        face(count, count + i + 1, count + i);
    }
    for i in 0..count {
        let next = (i + 1) % count;
        face(i, count + i, count + next);
        face(i, count + next, next);
    }
    text
}

/// XML of elements, one a line.
fn xml(markup: Markup) -> String {
    document(markup).replace("><", ">\n<") + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeMap;

    #[test]
    fn a_prism_is_closed_and_seen_from_outside() {
        let corners = [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (0.0, 1.0)].map(|(x, y)| Vec2::new(x, y));
        let mesh = obj(&corners, 0.5);
        let rows = |kind: &str| -> Vec<Vec<f64>> {
            let own = mesh.lines().filter_map(|line| line.strip_prefix(kind));
            own.map(|line| line.split_whitespace().map(|word| word.parse().unwrap()).collect()).collect()
        };
        let (points, faces) = (rows("v "), rows("f "));
        let mut edges: BTreeMap<(usize, usize), i32> = BTreeMap::new();
        let mut volume = 0.0;
        for face in &faces {
            let at: Vec<usize> = face.iter().map(|n| *n as usize - 1).collect();
            for i in 0..3 {
                *edges.entry((at[i], at[(i + 1) % 3])).or_default() += 1;
            }
            let [a, b, c] = [&points[at[0]], &points[at[1]], &points[at[2]]];
            let cross = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
            volume += (a[0] * cross[0] + a[1] * cross[1] + a[2] * cross[2]) / 6.0;
        }
        assert!(
            edges.iter().all(|((a, b), n)| *n == 1 && edges.contains_key(&(*b, *a))),
            "each edge has two faces"
        );
        assert!((volume - 2.0).abs() < f64::EPSILON * 8.0, "its volume is positive, and right: {volume}");
    }
}
