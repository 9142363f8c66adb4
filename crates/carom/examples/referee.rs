//! What do three laws of restitution make of one strike?
//!
//! ```sh
//! cargo run -p carom --example referee
//! ```
//!
//! The strike is that of the tutorial `_02_one_impact`: every number of the table can be checked by hand.
#![expect(clippy::print_stdout, reason = "a program that answers a question")]

use carom::impact::Law;
use carom::impact::planar::single;
use carom_words::Words;

fn main() -> Result<(), carom::Error> {
    println!("law        e    p_n N s   p_t N s   u_n m/s    work J");
    for restitution in [0.0, 0.5, 1.0] {
        for law in [Law::Poisson, Law::Stronge, Law::Newton] {
            let contact = single::Contact {
                w_tt: 5.0,
                w_tn: 2.0,
                w_nn: 2.0,
                slip: -4.5,
                normal: -6.0,
                friction: 0.5,
                restitution,
            };
            let out = single::resolve(&contact, law)?;
            let work = out.normal_work + out.tangential_work;
            let note = if out.gained_energy { "   made from nothing" } else { "" };
            println!(
                "{:<8} {restitution:>3.1} {:>10.4} {:>9.4} {:>9.4} {work:>9.4}{note}",
                law.word(),
                out.normal_impulse,
                out.tangential_impulse,
                out.normal
            );
        }
    }
    Ok(())
}
