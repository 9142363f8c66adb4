//! At which slopes of the lower plate does the rod turn over?
//!
//! ```sh
//! cargo run --release -p carom --example which_way_up
//! ```
//!
//! The lower plate of a two-plate feeder is turned about one of its points in steps of half a degree; where the verdict changes between two
//! steps, the slope is found by bisection. A window narrower than a step can be missed.
#![expect(clippy::print_stdout, reason = "a program that answers a question")]

use carom::feeder::Run;
use carom::prelude::*;

const SCENE: &str = r#"
[part]
shape   = "rod"
length  = "100 mm"
mass    = "0.3 kg"
inertia = "2.5e-4 kg m^2"

[contact]
friction = 0.15

[start]
to_edge = "100 mm"

[[plate]]
name  = "upper"
slope = "15 deg"

[[plate]]
name     = "lower"
downhill = "left"
slope    = "20 deg"
below    = { x = "-88 mm", y = "-328.4 mm" }
"#;

/// Bisections from half a degree: to 5e-10 degrees, far below what a workshop can set.
const BISECTIONS: u32 = 30;

fn main() -> Result<(), Error> {
    let scene = Scene::parse("which_way_up.toml", SCENE)?;
    let ask = |degrees: f64| -> Result<String, Error> {
        Ok(words(&scene.with("plate.lower.slope", degrees.to_radians())?.feeder().run_untraced()?))
    };
    let mut before = ask(0.0)?;
    println!("from  0.0000° {before}");
    for half_degrees in 1..=90 {
        let degrees = 0.5 * f64::from(half_degrees);
        let now = ask(degrees)?;
        if now != before {
            let (mut low, mut high) = (degrees - 0.5, degrees);
            for _ in 0..BISECTIONS {
                let middle = 0.5 * (low + high);
                if ask(middle)? == before {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            println!("from {high:>7.4}° {now}");
            before = now;
        }
    }
    Ok(())
}

fn words(run: &Run) -> String {
    match run.landings.last().and_then(|landing| landing.verdict) {
        Some(Verdict::Same) => "same".to_owned(),
        Some(Verdict::Turned) => "turned".to_owned(),
        Some(Verdict::Face(face)) => format!("face {face}"),
        None => format!("{:?}", run.outcome),
    }
}
