//! A page needs memory for what it shows, not for every corner at every instant.

use carom_feeder::{Feeder, Part, PartKind, Plate, Start, Stop};
use carom_figure::{Draft, Extra, layout_svg, report};
use carom_impact::Law;
use carom_motion::planar::{Body, Shape};
use carom_num::Vec2;
use carom_num::elementary::{cos, sin};
use core::f64::consts::TAU;

/// A coin of so many corners that rolls off a gentle slope and down a steeper one: every corner is an event.
fn coin(corners: u32) -> Feeder {
    let at = |i: u32| TAU * f64::from(i) / f64::from(corners);
    let vertices = (0..corners).map(|i| Vec2::new(0.05 * cos(at(i)), 0.05 * sin(at(i)))).collect();
    let body = Body { shape: Shape::new(vertices, 0.0).unwrap(), mass: 0.3, inertia: 2.5e-4 };
    let plate = |name: &str, uphill, edge| Plate {
        name: name.to_owned(),
        uphill,
        edge,
        friction: 0.15,
        restitution: 0.0,
        unbounded: false,
        form: Default::default(),
    };
    Feeder {
        gravity: 9.81,
        stop: Stop::Landed,
        law: Law::Poisson,
        part: Part { kind: PartKind::Polygon, body },
        start: Start { to_edge: 0.1, speed: 0.0, face: 0 },
        plates: vec![
            plate("upper", Vec2::new(-1.0, 0.2), Vec2::ZERO),
            plate("lower", Vec2::new(0.5, -0.2), Vec2::new(-4.0, -1.9)),
        ],
        walls: vec![],
    }
}

/// The most memory that this process has had [bytes], where the system says so.
fn peak() -> Option<usize> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let kilobytes = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    Some(1024 * kilobytes.trim().trim_end_matches("kB").trim().parse::<usize>().ok()?)
}

#[test]
fn a_page_needs_memory_in_proportion_to_what_it_shows() {
    let feeder = coin(500);
    let run = feeder.run().unwrap();
    let pieces = run.trace.pieces.len();
    assert!(pieces > 1000, "{pieces} pieces are not many");
    let svg = layout_svg(&feeder, Some(&run), &Draft::default());
    let of = |class: &str| svg.matches(&format!("class=\"{class}\"")).count();
    // 2^16 corners of the part between its stages, and as many at their starts.
    let most = (1 << 16) / 500;
    assert!(of("ghost") > most / 2 && of("ghost") <= most, "{} of at most {most}", of("ghost"));
    assert!(of("ghost stage") <= most, "{} of at most {most}", of("ghost stage"));
    let before = peak();
    let page = report(&feeder, &run, "coin", &Extra::default());
    let Some((before, after)) = before.zip(peak()) else { return };
    // The page, the section and the picture it is put together from, each while it grows to twice its room.
    let most = 8 * page.len();
    assert!(after - before < most, "{} bytes for a page of {}", after - before, page.len());
}
