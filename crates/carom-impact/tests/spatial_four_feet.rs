//! Rocking impacts of four feet with unequal friction, against a search by the exact law that knows no hypotheses.
//!
//! Where all four stay on the plane, how they share the load is open, and with it what friction does: such motions come in families, of which the kernel
//! may know one member. It says then that others may exist. A motion in which a foot leaves the plane is one by itself, and none of these is missed.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test fails by panicking, and says what it measured"
)]

use crate::exact_law;
use crate::unequal_feet;

use exact_law::{EXACT, ExactLaw, SAME};
use unequal_feet::{first_question, rocking};

const IMPACTS: u64 = 600;
/// Rates that come from curves and from polishing agree to this share.
const AGREES: f64 = 1e-8;

#[test]
fn no_motion_of_four_rocking_feet_is_missed_and_none_is_false() {
    let (mut found, mut of_families) = (0, 0);
    for seed in 0..IMPACTS {
        let set = rocking::<4>(seed);
        let question = first_question(&set);
        let (law, answer) = (ExactLaw::of(&question), question.solve());
        for solution in answer.iter() {
            let violation = law.violation(&solution.rates);
            assert!(violation < AGREES, "seed {seed}: {:?} is no solution, by {violation:e}", solution.guess);
        }
        let fastest = question.drive.iter().map(|u| u.norm()).fold(0.0, f64::max);
        for rates in law.search(40, seed) {
            let after = law.response(&rates);
            let stays = (0..4).filter(|&i| rates[i].z > EXACT || after[i].z <= SAME * fastest).count();
            let is_known = answer.iter().any(|solution| law.same(&solution.rates, &rates));
            assert!(
                is_known || (stays == 4 && !answer.examined),
                "seed {seed}: {rates:?} is missed, {:?} is found",
                answer.solutions
            );
            found += u64::from(stays < 4);
            of_families += u64::from(stays == 4);
        }
    }
    println!("{found} motions by themselves, none missed; {of_families} members of families");
    assert!(found > IMPACTS / 2, "{found}");
}
