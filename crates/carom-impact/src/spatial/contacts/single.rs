//! One contact in space: Routh's walk in impulse space.
//!
//! The normal impulse N is the clock. While the contact slips, friction acts against the slip: `dp/dN = (−μ u_t/|u_t|, 1)`, `du = W dp`. In the plane that is a
//! few straight stages; in space the slip turns on its way (the *hodograph*), and no closed form is known. Where the slip stops it sticks if
//! `|W_tt⁻¹ w_tn| ≤ μ`, else it slips on along a direction that friction does not turn.
//!
//! # Source
//! Routh 1860; Keller, J. Appl. Mech. 53 (1986) 1; Bhatt and Koechling, J. Appl. Mech. 62 (1995) 893; Stronge, J. Appl. Mech. 58 (1991) 1049.

use super::hodograph::{Reached, Rough, slide};
use crate::{ImpactError, Law};
use carom_num::{Mat3, Vec3};

/// One contact just before an impact, in its own frame (t₁, t₂, n).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// Velocity to impulse, W [1/kg]: symmetric, positive definite.
    pub operator: Mat3,
    /// Velocity of the contact point [m/s]; an approach has a negative third component.
    pub velocity: Vec3,
    /// Coulomb friction coefficient, ≥ 0.
    pub friction: f64,
    /// Coefficient of restitution, in [0, 1].
    pub restitution: f64,
}

/// What the contact does in a stage.
///
/// # Example
/// A ball that comes down straight sticks; one that slips fast goes on to.
/// ```
/// use carom_impact::{Law, spatial::{Contact, Slip}};
/// use carom_num::{Mat3, Vec3};
/// let slip = |velocity| {
///     let operator = Mat3::diagonal(3.5, 3.5, 1.0);
///     let ball = Contact { operator, velocity, friction: 0.1, restitution: 0.0 };
///     ball.resolve(Law::Poisson).map(|out| out.stages[0].slip)
/// };
/// assert_eq!(slip(Vec3::new(0.0, 0.0, -2.0)), Ok(Slip::Sticks));
/// assert_eq!(slip(Vec3::new(3.0, 4.0, -2.0)), Ok(Slip::Slips));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slip {
    /// It slips, and friction may turn the slip.
    Slips,
    /// It sticks.
    Sticks,
    /// It had stopped, and slips on in one direction.
    SlipsOn,
}

/// What ends a stage.
///
/// # Example
/// A slip of 0.35 m/s stops after 0.35/(0.1 · 3.5) = 1 N s; compression takes 2 N s.
/// ```
/// use carom_impact::{Law, spatial::{Contact, StageEnd}};
/// use carom_num::{Mat3, Vec3};
/// let (operator, velocity) = (Mat3::diagonal(3.5, 3.5, 1.0), Vec3::new(0.21, 0.28, -2.0));
/// let out = Contact { operator, velocity, friction: 0.1, restitution: 0.5 }.resolve(Law::Poisson)?;
/// let ends: Vec<_> = out.stages.iter().map(|stage| stage.ended_by).collect();
/// assert_eq!(ends, [StageEnd::SlipStops, StageEnd::CompressionEnds, StageEnd::RestitutionEnds]);
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StageEnd {
    /// The slip comes to zero.
    SlipStops,
    /// The contact does not approach any more.
    CompressionEnds,
    /// The law's measure of restitution is used up.
    RestitutionEnds,
}

/// One stage of the walk.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stage {
    /// What the contact does in it.
    pub slip: Slip,
    /// What ends it.
    pub ended_by: StageEnd,
    /// Impulse up to its end [N s].
    pub impulse: Vec3,
    /// Velocity at its end [m/s].
    pub velocity: Vec3,
}

/// The outcome of an impact at one contact.
///
/// # Example
/// The work is the change of energy, here that of a ball of 1 kg that falls with 2 m/s and rises with 1 m/s.
/// ```
/// use carom_impact::{Law, spatial::Contact};
/// use carom_num::{Mat3, Vec3};
/// let operator = Mat3::diagonal(3.5, 3.5, 1.0);
/// let ball = Contact { operator, velocity: Vec3::Z * -2.0, friction: 0.1, restitution: 0.5 };
/// let out = ball.resolve(Law::Stronge)?;
/// assert!((out.velocity.z - 1.0).abs() < 1e-15 && (out.normal_work + 1.5).abs() < 1e-15);
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// Impulse on the body, in the contact's frame [N s].
    pub impulse: Vec3,
    /// Velocity after, in the contact's frame [m/s].
    pub velocity: Vec3,
    /// Work of the normal impulse [J].
    pub normal_work: f64,
    /// The stages; none where nothing happens.
    pub stages: Vec<Stage>,
}

/// Stages after which the walk is given up: slip stops once, and each phase ends once.
const MOST_STAGES: usize = 8;

/// Where the walk is.
#[derive(Clone, Copy, Debug)]
pub(in crate::spatial) struct Place {
    pub(in crate::spatial) impulse: Vec3,
    pub(in crate::spatial) velocity: Vec3,
    /// Work of the normal impulse so far [J].
    pub(in crate::spatial) work: f64,
}

/// Up to where a phase goes: what is left of it falls through zero.
#[derive(Clone, Copy, Debug)]
pub(in crate::spatial) enum Goal {
    /// The normal velocity comes to this.
    Velocity(f64),
    /// The normal impulse comes to this.
    Impulse(f64),
    /// The work of the normal impulse comes to this.
    Work(f64),
}

impl Goal {
    /// What is left, and its rate with the normal impulse where the normal velocity grows by `growth` per impulse.
    pub(in crate::spatial) fn left(self, impulse: f64, velocity: f64, work: f64, growth: f64) -> (f64, f64) {
        match self {
            Self::Velocity(end) => (end - velocity, -growth),
            Self::Impulse(end) => (end - impulse, -1.0),
            Self::Work(end) => (end - work, -velocity),
        }
    }

    /// The normal impulse still to come where the normal velocity grows steadily.
    pub(in crate::spatial) fn straight(self, at: &Place, growth: f64) -> f64 {
        let (left, _) = self.left(at.impulse.z, at.velocity.z, at.work, growth);
        match self {
            Self::Velocity(_) => left / growth,
            Self::Impulse(_) => left,
            // left = u N + growth N²/2, u not negative in restitution.
            Self::Work(_) => {
                let u = at.velocity.z;
                2.0 * left / (u + (u * u + 2.0 * growth * left).sqrt())
            }
        }
    }
}

impl Contact {
    /// Checks that the numbers are those of a contact of a rigid body.
    ///
    /// # Errors
    /// [`ImpactError::OutsideDomain`] with the first quantity that no contact of a rigid body has.
    ///
    /// # Example
    /// ```
    /// use carom_impact::spatial::Contact;
    /// use carom_num::{Mat3, Vec3};
    /// let operator = Mat3::diagonal(3.5, 3.5, 1.0);
    /// let ball = Contact { operator, velocity: -Vec3::Z, friction: 0.1, restitution: 1.5 };
    /// let message = "restitution of contact 0 is 1.5, allowed is 0 to 1";
    /// assert_eq!(ball.check().unwrap_err().to_string(), message);
    /// assert_eq!(Contact { restitution: 1.0, ..ball }.check(), Ok(()));
    /// ```
    pub fn check(&self) -> Result<(), ImpactError> {
        let outside = |quantity, value, allowed| {
            Err(ImpactError::OutsideDomain { contact: Some(0), quantity, value, allowed })
        };
        let [a, b, _] = self.operator.rows;
        if !self.operator.is_finite() || !self.velocity.is_finite() {
            return outside("operator or velocity", f64::NAN, "finite");
        }
        for minor in [a.x, a.x * b.y - a.y * b.x, self.operator.determinant()] {
            if minor <= 0.0 {
                return outside("least principal minor of W", minor, "> 0");
            }
        }
        if !(self.friction >= 0.0 && self.friction.is_finite()) {
            return outside("friction", self.friction, "finite and >= 0");
        }
        if !(0.0..=1.0).contains(&self.restitution) {
            return outside("restitution", self.restitution, "0 to 1");
        }
        Ok(())
    }

    /// Walks through the impact.
    ///
    /// # Errors
    /// As [`Contact::check`]; [`ImpactError::Unending`] where a number leaves what can be computed with.
    ///
    /// # Limits
    /// A contact that does not approach is left alone, Painlevé's impact without approach included.
    ///
    /// # Example
    /// A ball (W_tt = 7/2, W_nn = 1) that strikes obliquely and rough enough stops slipping: the friction impulse is 2/7 of the slip.
    /// ```
    /// use carom_impact::Law;
    /// use carom_impact::spatial::Contact;
    /// use carom_num::{Mat3, Vec3};
    /// let ball = Contact {
    ///     operator: Mat3::diagonal(3.5, 3.5, 1.0), velocity: Vec3::new(0.3, 0.4, -1.0), friction: 0.5, restitution: 0.8,
    /// };
    /// let out = ball.resolve(Law::Poisson)?;
    /// assert!((out.velocity - Vec3::Z * 0.8).norm() < 1e-12);
    /// assert!((out.impulse - Vec3::new(-0.6 / 7.0, -0.8 / 7.0, 1.8)).norm() < 1e-12);
    /// # Ok::<(), carom_impact::ImpactError>(())
    /// ```
    pub fn resolve(&self, law: Law) -> Result<Outcome, ImpactError> {
        self.check()?;
        let mut at = Place { impulse: Vec3::ZERO, velocity: self.velocity, work: 0.0 };
        let mut stages = vec![];
        if self.velocity.z < 0.0 {
            self.follow(&mut at, Goal::Velocity(0.0), StageEnd::CompressionEnds, &mut stages)?;
            at.velocity.z = 0.0;
            let e = self.restitution;
            let goal = match law {
                Law::Poisson => Goal::Impulse((1.0 + e) * at.impulse.z),
                Law::Stronge => Goal::Work((1.0 - e * e) * at.work),
                Law::Newton => Goal::Velocity(-e * self.velocity.z),
            };
            if e > 0.0 {
                self.follow(&mut at, goal, StageEnd::RestitutionEnds, &mut stages)?;
            }
        }
        Ok(Outcome { impulse: at.impulse, velocity: at.velocity, normal_work: at.work, stages })
    }

    /// Walks to the end of a phase.
    fn follow(
        &self,
        at: &mut Place,
        goal: Goal,
        end: StageEnd,
        stages: &mut Vec<Stage>,
    ) -> Result<(), ImpactError> {
        while stages.len() < MOST_STAGES {
            let contact = Rough { operator: self.operator, friction: self.friction };
            let (slip, ended_by) = match contact.rest(&at.velocity) {
                None => match slide(&contact, at, goal)? {
                    Reached::Goal => (Slip::Slips, end),
                    Reached::Rest => (Slip::Slips, StageEnd::SlipStops),
                },
                Some(rest) => {
                    let growth = self.operator * rest.along;
                    let more = goal.straight(at, growth.z);
                    at.work += more * (at.velocity.z + 0.5 * growth.z * more);
                    at.impulse += rest.along * more;
                    at.velocity += growth * more;
                    // Exactly zero: any rounding of it would be a slip, with a friction of its own, in the next phase.
                    if rest.sticks {
                        (at.velocity.x, at.velocity.y) = (0.0, 0.0);
                    }
                    (if rest.sticks { Slip::Sticks } else { Slip::SlipsOn }, end)
                }
            };
            stages.push(Stage { slip, ended_by, impulse: at.impulse, velocity: at.velocity });
            if ended_by == end {
                return if at.velocity.is_finite() {
                    Ok(())
                } else {
                    Err(ImpactError::Unending { stages: stages.len() })
                };
            }
        }
        Err(ImpactError::Unending { stages: MOST_STAGES })
    }
}
