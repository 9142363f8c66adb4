//! One contact: Routh's walk in impulse space.
//!
//! The normal impulse is the clock. While the contact slips, `dp_t = −μ sign(u_t) dp_n`; where the slip stops it sticks if
//! `|W_tn| ≤ μ W_tt`, else it slips on in the direction `sign(W_tn)`. Velocities are linear in the impulse, so the walk is a few
//! straight stages, each ended by a slip stop, the end of compression or the end of restitution.
//!
//! Source: Routh 1860; Wang and Mason, J. Appl. Mech. 59 (1992) 635; Stronge, J. Appl. Mech. 58 (1991) 1049.

use super::error::{outside, require};
use super::{ContactState, ImpactError, ImpactType, Law, Phase, Slip, StageEnd};

/// One contact just before an impact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// `W_tt` [1/kg], > 0.
    pub w_tt: f64,
    /// `W_tn` [1/kg], with `W_tn² < W_tt W_nn`.
    pub w_tn: f64,
    /// `W_nn` [1/kg], > 0.
    pub w_nn: f64,
    /// Slip velocity `u_t` [m/s].
    pub slip: f64,
    /// Normal velocity `u_n` [m/s]; an approach is negative.
    pub normal: f64,
    /// Coulomb friction coefficient, ≥ 0.
    pub friction: f64,
    /// Coefficient of restitution, in [0, 1].
    pub restitution: f64,
}

impl Contact {
    /// Whether the contact is one of a rigid body.
    ///
    /// # Errors
    /// [`ImpactError::OutsideDomain`] names the first quantity that is not finite or violates `W_tt > 0`, `W_nn > 0`,
    /// `W_tt W_nn > W_tn²`, `μ ≥ 0` or `0 ≤ e ≤ 1`.
    #[inline]
    pub fn check(&self) -> Result<(), ImpactError> {
        let Self { w_tt, w_tn, w_nn, slip, normal, friction, restitution: e } = *self;
        // Zero times a number is zero only where the number is finite.
        let finite = (w_tt.abs() + w_nn.abs() + slip.abs() + normal.abs() + friction.abs()) * 0.0 == 0.0;
        let positive = w_tt > 0.0 && w_nn > 0.0 && w_tt * w_nn > w_tn * w_tn;
        if finite && positive && friction >= 0.0 && (0.0..=1.0).contains(&e) {
            Ok(())
        } else {
            self.complain()
        }
    }

    #[cold]
    fn complain(&self) -> Result<(), ImpactError> {
        let Self { w_tt, w_tn, w_nn, slip, normal, friction, restitution: e } = *self;
        let data =
            [("W_tt", w_tt), ("W_tn", w_tn), ("W_nn", w_nn), ("slip", slip), ("normal velocity", normal)];
        for (quantity, value) in data.into_iter().chain([("friction", friction)]) {
            require(value.is_finite(), || outside(Some(0), quantity, value, "finite"))?;
        }
        require(w_tt > 0.0, || outside(Some(0), "W_tt", w_tt, "> 0"))?;
        require(w_nn > 0.0, || outside(Some(0), "W_nn", w_nn, "> 0"))?;
        require(friction >= 0.0, || outside(Some(0), "friction", friction, ">= 0"))?;
        require((0.0..=1.0).contains(&e), || outside(Some(0), "restitution", e, "0 to 1"))?;
        let determinant = w_tt * w_nn - w_tn * w_tn;
        require(determinant > 0.0, || outside(Some(0), "W_tt W_nn - W_tn^2", determinant, "> 0"))?;
        // Each number is finite, but a sum of them is not.
        Err(ImpactError::Overflow)
    }
}

/// The outcome of an impact at one contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// Normal impulse on the body [N s], ≥ 0.
    pub normal_impulse: f64,
    /// Tangential impulse on the body [N s].
    pub tangential_impulse: f64,
    /// Slip velocity after [m/s].
    pub slip: f64,
    /// Normal velocity after [m/s], ≥ 0.
    pub normal: f64,
    /// Work of the normal impulse [J].
    pub normal_work: f64,
    /// Work of the tangential impulse [J].
    pub tangential_work: f64,
    /// Type, `None` where nothing happens (no approach and no paradox).
    pub kind: Option<ImpactType>,
    /// What the contact does at the end.
    pub state: ContactState,
    /// True where the total work is positive (possible under Newton's law).
    pub gained_energy: bool,
    /// True where the contact did not approach: friction forced the impact (Painlevé's paradox).
    pub without_approach: bool,
    /// Smallest decided inequality of the walk (which of two events comes first, stick or slip) divided by the sum of its terms.
    pub margin: f64,
}

/// Work below this fraction of its terms is rounding.
const WORK_ROUNDING: f64 = 1e-12;

/// Position of the walk, handed to an observer at the end of each stage.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Station {
    /// Normal impulse so far [N s].
    pub normal_impulse: f64,
    /// Tangential impulse so far [N s].
    pub tangential_impulse: f64,
    /// Slip velocity [m/s].
    pub slip: f64,
    /// Normal velocity [m/s].
    pub normal: f64,
}

/// One straight stage of the walk.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stage {
    /// Compression or restitution.
    pub phase: Phase,
    /// What the contact does.
    pub slip: Slip,
    /// Where the stage starts.
    pub start: Station,
    /// Where it ends.
    pub end: Station,
    /// Why it ends.
    pub ended_by: StageEnd,
}

/// Resolves an impact at one contact.
///
/// ```text
/// u⁺ = u⁻ + W p;   while it slips dp_t = −μ sign(u_t) dp_n;   stopped, it sticks with dp_t = −(W_tn/W_tt) dp_n if |W_tn| ≤ μ W_tt
/// ```
///
/// Nothing happens where `u_n ≥ 0`, unless `u_n = 0` and `W_nn − sμW_tn < 0`: then friction drives the contact into the obstacle
/// and the impact without approach is resolved (its slip must stop first).
///
/// # Errors
/// [`ImpactError::OutsideDomain`] as [`Contact::check`]; [`ImpactError::Overflow`] where a result is not finite.
///
/// # Limits
/// Rigid bodies, dry friction with one coefficient. Under Newton's law energy can grow where the slip stops or reverses.
///
/// # Source
/// Routh 1860; Wang and Mason, J. Appl. Mech. 59 (1992) 635; Stronge, Proc. R. Soc. A 431 (1990) 169.
///
/// # Example
/// ```
/// use carom_impact::planar::{single, ImpactType, Law};
/// // A ball of 1 kg dropped straight on a floor: it leaves at e times its approach speed.
/// let ball = single::Contact { w_tt: 3.5, w_tn: 0.0, w_nn: 1.0, slip: 0.0, normal: -2.0, friction: 0.3, restitution: 0.5 };
/// let out = single::resolve(&ball, Law::Poisson)?;
/// assert_eq!((out.normal, out.normal_impulse), (1.0, 3.0));
/// assert_eq!(out.kind, Some(ImpactType::SticksFromRest));
/// // Thrown with a slip of 7 m/s it slips throughout and loses μ · W_tt · 3 N s of it.
/// let out = single::resolve(&single::Contact { slip: 7.0, ..ball }, Law::Poisson)?;
/// assert!((out.slip - (7.0 - 0.3 * 3.5 * 3.0)).abs() < 1e-15);
/// assert_eq!(out.kind, Some(ImpactType::SlidesThroughout));
/// # Ok::<(), carom_impact::planar::ImpactError>(())
/// ```
pub fn resolve(contact: &Contact, law: Law) -> Result<Outcome, ImpactError> {
    resolve_observed(contact, law, &mut |_: &Stage| {})
}

/// As [`resolve`], handing every stage to `observe` in order.
///
/// # Errors
/// As [`resolve`].
pub fn resolve_observed(
    contact: &Contact,
    law: Law,
    observe: &mut impl FnMut(&Stage),
) -> Result<Outcome, ImpactError> {
    contact.check()?;
    let mut walk = Walk::new(contact);
    if contact.normal > 0.0 || (contact.normal == 0.0 && walk.rates().normal >= 0.0) {
        return Ok(walk.outcome(None, false));
    }
    walk.compress(observe);
    let stopped_in_compression = walk.stopped;
    let compression = Compression { impulse: walk.now.normal_impulse, work: walk.normal_work };
    walk.restitute(law, &compression, observe);
    let sticks = walk.slip == Slip::Sticks;
    let kind = match (walk.from_rest, stopped_in_compression, walk.stopped) {
        (true, _, _) if sticks => ImpactType::SticksFromRest,
        (true, _, _) => ImpactType::SlipsFromRest,
        (_, true, _) if sticks => ImpactType::StopsInCompression,
        (_, true, _) => ImpactType::ReversesInCompression,
        (_, _, true) if sticks => ImpactType::StopsInRestitution,
        (_, _, true) => ImpactType::ReversesInRestitution,
        _ => ImpactType::SlidesThroughout,
    };
    let out = walk.outcome(Some(kind), contact.normal == 0.0);
    let sum = out.slip + out.normal + out.normal_impulse + out.tangential_impulse;
    if (sum + walk.work_terms).is_finite() { Ok(out) } else { Err(ImpactError::Overflow) }
}

/// What compression leaves for restitution.
struct Compression {
    impulse: f64,
    work: f64,
}

/// Change of both velocities and of the tangential impulse with the normal impulse.
#[derive(Clone, Copy)]
struct Rates {
    slip: f64,
    normal: f64,
    tangential_impulse: f64,
}

struct Walk<'a> {
    contact: &'a Contact,
    slip: Slip,
    now: Station,
    normal_work: f64,
    tangential_work: f64,
    /// Magnitudes of the works of all stages: what rounding in their sum is measured against.
    work_terms: f64,
    from_rest: bool,
    /// The initial slip has come to zero.
    stopped: bool,
    margin: f64,
}

impl<'a> Walk<'a> {
    fn new(contact: &'a Contact) -> Self {
        let now = Station { slip: contact.slip, normal: contact.normal, ..Station::default() };
        let mut walk = Self {
            contact,
            slip: Slip::Open,
            now,
            normal_work: 0.0,
            tangential_work: 0.0,
            work_terms: 0.0,
            from_rest: contact.slip == 0.0,
            stopped: false,
            margin: f64::INFINITY,
        };
        walk.slip = if contact.slip > 0.0 {
            Slip::Forward
        } else if contact.slip < 0.0 {
            Slip::Backward
        } else {
            walk.slip_from_rest()
        };
        walk
    }

    /// Notes how clearly two magnitudes are told apart.
    fn decide(&mut self, a: f64, b: f64) {
        let sum = a + b;
        if sum > 0.0 && sum.is_finite() {
            self.margin = self.margin.min((a - b).abs() / sum);
        }
    }

    /// Stick where friction can hold, else slip the way a growing normal impulse alone pushes.
    fn slip_from_rest(&mut self) -> Slip {
        let c = self.contact;
        self.decide(c.w_tn.abs(), c.friction * c.w_tt);
        if c.w_tn.abs() <= c.friction * c.w_tt {
            Slip::Sticks
        } else if c.w_tn > 0.0 {
            Slip::Forward
        } else {
            Slip::Backward
        }
    }

    fn rates(&self) -> Rates {
        let c = self.contact;
        match self.slip {
            Slip::Sticks => {
                let q = -c.w_tn / c.w_tt;
                Rates { slip: 0.0, normal: c.w_nn + c.w_tn * q, tangential_impulse: q }
            }
            Slip::Forward | Slip::Backward | Slip::Open => {
                let q = if self.slip == Slip::Backward { c.friction } else { -c.friction };
                Rates { slip: c.w_tn + c.w_tt * q, normal: c.w_nn + c.w_tn * q, tangential_impulse: q }
            }
        }
    }

    /// Normal impulse until the slip stops, where it does.
    fn until_slip_stops(&self, rates: &Rates) -> f64 {
        let (speed, toward_zero) = match self.slip {
            Slip::Forward => (self.now.slip, -rates.slip),
            Slip::Backward => (-self.now.slip, rates.slip),
            Slip::Sticks | Slip::Open => return f64::INFINITY,
        };
        // A slip that stops together with compression may stand at zero, or a rounding beyond it, and must not run on.
        if toward_zero > 0.0 { speed.max(0.0) / toward_zero } else { f64::INFINITY }
    }

    fn compress(&mut self, observe: &mut impl FnMut(&Stage)) {
        loop {
            let rates = self.rates();
            let stop = self.until_slip_stops(&rates);
            let end = if rates.normal > 0.0 { -self.now.normal / rates.normal } else { f64::INFINITY };
            self.decide(stop, end);
            if stop < end {
                self.advance(Phase::Compression, stop, &rates, StageEnd::SlipStops(0), observe);
            } else {
                self.advance(Phase::Compression, end, &rates, StageEnd::CompressionEnds, observe);
                return;
            }
        }
    }

    fn restitute(&mut self, law: Law, compression: &Compression, observe: &mut impl FnMut(&Stage)) {
        let e = self.contact.restitution;
        if e <= 0.0 {
            return;
        }
        // What is left of the law's measure: counted down, since e² of a work is lost in its sum with that work where e is small.
        let mut impulse_left = e * compression.impulse;
        let mut work_left = -e * e * compression.work;
        let normal_at_end = -e * self.contact.normal;
        loop {
            let rates = self.rates();
            let stop = self.until_slip_stops(&rates);
            let u = self.now.normal;
            let end = match law {
                Law::Poisson => impulse_left,
                Law::Newton => (normal_at_end - u) / rates.normal,
                Law::Stronge => {
                    let root = (u * u + 2.0 * rates.normal * work_left).sqrt();
                    if root > 0.0 { 2.0 * work_left / (u + root) } else { 0.0 }
                }
            };
            self.decide(stop, end);
            if stop < end {
                self.advance(Phase::Restitution, stop, &rates, StageEnd::SlipStops(0), observe);
                impulse_left = (impulse_left - stop).max(0.0);
                work_left = (work_left - 0.5 * (u + self.now.normal) * stop).max(0.0);
            } else {
                self.advance(Phase::Restitution, end.max(0.0), &rates, StageEnd::RestitutionEnds, observe);
                return;
            }
        }
    }

    fn advance(
        &mut self,
        phase: Phase,
        by: f64,
        rates: &Rates,
        why: StageEnd,
        observe: &mut impl FnMut(&Stage),
    ) {
        let start = self.now;
        let end = Station {
            normal_impulse: start.normal_impulse + by,
            tangential_impulse: start.tangential_impulse + rates.tangential_impulse * by,
            slip: if matches!(why, StageEnd::SlipStops(_)) { 0.0 } else { start.slip + rates.slip * by },
            normal: if matches!(why, StageEnd::CompressionEnds) {
                0.0
            } else {
                start.normal + rates.normal * by
            },
        };
        let normal_work = 0.5 * (start.normal + end.normal) * by;
        let tangential_work = 0.5 * (start.slip + end.slip) * rates.tangential_impulse * by;
        self.normal_work += normal_work;
        self.tangential_work += tangential_work;
        self.work_terms += normal_work.abs() + tangential_work.abs();
        observe(&Stage { phase, slip: self.slip, start, end, ended_by: why });
        self.now = end;
        if matches!(why, StageEnd::SlipStops(_)) {
            self.stopped = true;
            self.slip = self.slip_from_rest();
        }
    }

    fn outcome(&self, kind: Option<ImpactType>, without_approach: bool) -> Outcome {
        let state = if self.now.normal > 0.0 {
            ContactState::Separates
        } else if self.now.slip == 0.0 && (self.slip == Slip::Sticks || kind.is_none()) {
            ContactState::Sticks
        } else {
            ContactState::Slips
        };
        let work = self.normal_work + self.tangential_work;
        let gained_energy = work > WORK_ROUNDING * self.work_terms;
        Outcome {
            normal_impulse: self.now.normal_impulse,
            tangential_impulse: self.now.tangential_impulse,
            slip: self.now.slip,
            normal: self.now.normal,
            normal_work: self.normal_work,
            tangential_work: self.tangential_work,
            kind,
            state,
            gained_energy,
            without_approach: without_approach && kind.is_some(),
            margin: self.margin,
        }
    }
}
