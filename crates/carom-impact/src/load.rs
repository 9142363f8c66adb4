//! What a contact may be loaded with.

/// How a contact takes part in a rate problem.
///
/// # Example
/// A block of 1 kg is pressed down by 8 N. A base load of 3 N is part of the 8 N that the floor answers with;
/// where 3 N are prescribed it gives no more, and the block sinks in with 5 m/s².
/// ```
/// use carom_impact::{Load, planar::{Block, rate::RateProblem}};
/// let operator = [[Block { tt: 1.0, tn: 0.0, nt: 0.0, nn: 1.0 }]];
/// let ask = |load| RateProblem::<1, 2> {
///     count: 1, operator: &operator, friction: &[0.0], drive: [[0.0, -8.0]], slip: [0.0], load: [load],
/// }.solve().solutions[0].map(|s| (s.rates[0][1], s.response[0][1]));
/// assert_eq!(ask(Load::Touching(3.0)), Some((8.0, 0.0)));
/// assert_eq!(ask(Load::Prescribed(3.0)), Some((3.0, -5.0)));
/// assert_eq!(ask(Load::Absent), Some((0.0, -8.0)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Load {
    /// It does not touch.
    Absent,
    /// It touches. Its normal rate is at least the base load β, and more only while the contact does not open.
    Touching(f64),
    /// Its normal rate is β whatever its normal velocity does.
    Prescribed(f64),
}
