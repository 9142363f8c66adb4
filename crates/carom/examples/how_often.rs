//! When two contacts close together, how often is the answer not simply one?
//!
//! ```sh
//! cargo run --release -p carom --example how_often
//! ```
//!
//! Random bodies strike with two contacts at once. Counted are walks with no consistent way at their start, walks that met several ways on,
//! long walks, scaled restitution, walks that end in no end state, and impacts with several end states or none. Decision note 4 of the repository quotes the counts.
#![expect(clippy::print_stdout, reason = "a program that answers a question")]

use carom::impact::Load;
use carom::impact::planar::rate::RateProblem;
use carom::impact::planar::{ContactSet2, Touch, end_states, staged};
use carom::impact::{ImpactError, Law};
use carom::num::Vec2;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

/// Impacts in each column.
const IMPACTS: u32 = 100_000;
/// Stages above which a walk counts as long: as many as are walked before series are looked for.
const LONG: usize = 12;
/// Velocities that differ by less than this fraction of the fastest before are the same end.
const SAME: f64 = 1e-9;

#[derive(Default)]
struct Counts {
    impacts: u32,
    no_way: u32,
    several_ways: u32,
    long: u32,
    most_stages: usize,
    scaled: u32,
    refused: u32,
    no_end: u32,
    several_ends: u32,
    path_dependent: u32,
}

fn main() -> Result<(), carom::Error> {
    println!("                  ways on:                     most                    ends:");
    println!(
        "friction e         none  several  long walks  stages  scaled  refused  none  several  path-dependent"
    );
    for friction in [0.3, 0.7, 1.5] {
        for (name, equal, most) in [("0", true, 0.0), ("equal", true, 1.0), ("unequal", false, 1.0)] {
            let c = count(friction, equal, most)?;
            print!("<= {friction:<5.1} {name:<8} {:>5} {:>8} {:>11}", c.no_way, c.several_ways, c.long);
            print!(" {:>7} {:>7} {:>8}", c.most_stages, c.scaled, c.refused);
            println!(" {:>5} {:>8} {:>15}", c.no_end, c.several_ends, c.path_dependent);
        }
    }
    println!("of {IMPACTS} impacts each");
    Ok(())
}

fn count(friction: f64, equal: bool, most: f64) -> Result<Counts, carom::Error> {
    let mut rng = Pcg64::seed_from_u64(4);
    let mut c = Counts::default();
    while c.impacts < IMPACTS {
        let mut touches = [touch(&mut rng, friction, most), touch(&mut rng, friction, most)];
        if equal {
            touches[1].restitution = touches[0].restitution;
        }
        let velocity = Vec2::new(rng.random_range(-1.0..1.0), rng.random_range(-1.0..1.0));
        let (spin, inertia) = (rng.random_range(-2.0..2.0), rng.random_range(0.05..1.0));
        let set = ContactSet2::of_free_body(1.0, inertia, velocity, spin, &touches)?;
        if set.normal.iter().all(|u| *u < 0.0) {
            c.impacts += 1;
            c.add(&set)?;
        }
    }
    Ok(c)
}

/// Consistent first stages of compression.
fn ways_at_start(set: &ContactSet2) -> usize {
    let drive = [[0.0, set.normal[0]], [0.0, set.normal[1]]];
    let load = [Load::Touching(0.0); 2];
    let (operator, friction) = (&set.operator, &set.friction);
    RateProblem::<2, 4> { count: 2, operator, friction, drive, slip: set.slip, load }.solve().count
}

/// A contact of a roughly convex body: its arm points roughly against its normal.
fn touch(rng: &mut Pcg64, friction: f64, restitution: f64) -> Touch {
    let normal = Vec2::at_angle(rng.random_range(-3.2..3.2));
    let aside = Vec2::new(rng.random_range(-1.0..1.0), rng.random_range(-1.0..1.0));
    Touch {
        arm: aside - normal * rng.random_range(0.0..1.0),
        normal,
        friction: rng.random_range(0.0..friction),
        restitution: restitution * rng.random_range(0.0..1.0),
    }
}

impl Counts {
    fn add(&mut self, set: &ContactSet2) -> Result<(), carom::Error> {
        self.no_way += u32::from(ways_at_start(set) == 0);
        let ends = end_states::enumerate(set, Law::Poisson);
        self.no_end += u32::from(ends.found.is_empty());
        self.several_ends += u32::from(ends.found.len() > 1);
        let mut stages = 0;
        let out = match staged::resolve_observed(set, Law::Poisson, &mut |_| stages += 1) {
            Err(ImpactError::Jammed | ImpactError::Circling { .. } | ImpactError::Unending { .. }) => {
                self.refused += 1;
                return Ok(());
            }
            other => other?,
        };
        self.several_ways += u32::from(out.branches > 1);
        self.long += u32::from(stages > LONG);
        self.most_stages = self.most_stages.max(stages);
        self.scaled += u32::from(out.restitution_scaled < 1.0);
        let fastest = set.slip.iter().chain(&set.normal).fold(0.0, |m: f64, u| m.max(u.abs()));
        let same = |end: &end_states::EndState<2>| {
            let pairs = end.velocity.iter().flatten().zip(out.velocity.iter().flatten());
            pairs.map(|(a, b)| (a - b).abs()).all(|off| off <= SAME * fastest)
        };
        self.path_dependent += u32::from(!ends.found.iter().any(same));
        Ok(())
    }
}
