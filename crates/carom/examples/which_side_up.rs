//! On which side does the part land, at three frictions?
//!
//! ```sh
//! cargo run --release -p carom --example which_side_up examples/designer.toml
//! ```
#![expect(clippy::print_stdout, reason = "a program that answers a question")]

use carom::prelude::*;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let file = std::env::args().nth(1).unwrap_or("examples/designer.toml".to_owned());
    let scene = Scene::read(std::path::Path::new(&file))?;
    for friction in [0.1, 0.2, 0.3] {
        let run = scene.with("contact.friction", friction)?.feeder().run_untraced()?;
        let side = run.landings.last().and_then(|landing| landing.verdict);
        println!("friction {friction}: {:?} on {side:?}", run.outcome);
    }
    Ok(())
}
