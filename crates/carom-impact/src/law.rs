//! Laws of restitution, and the phases that they compare.

/// How restitution is measured.
///
/// # Example
/// A ball that falls straight leaves with e times its speed by each of the three.
/// ```
/// use carom_impact::{Law, planar::single};
/// let ball = single::Contact {
///     w_tt: 3.5, w_tn: 0.0, w_nn: 1.0, slip: 0.0, normal: -2.0, friction: 0.3, restitution: 0.5,
/// };
/// for law in [Law::Poisson, Law::Stronge, Law::Newton] {
///     assert_eq!(single::resolve(&ball, law)?.normal, 1.0);
/// }
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Law {
    /// Normal impulse of restitution = e × normal impulse of compression (Poisson).
    #[default]
    Poisson,
    /// Work of the normal impulse in restitution = −e² × its work in compression (Stronge 1990).
    Stronge,
    /// Normal velocity after = −e × normal velocity before (Newton). Can create energy where the slip stops or reverses.
    Newton,
}

/// The two phases of an impact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// Until no contact approaches any more.
    Compression,
    /// From there to the end.
    Restitution,
}
