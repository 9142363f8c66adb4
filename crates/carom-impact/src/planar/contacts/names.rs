//! The words of impact in the plane: slips, states, types and classes.

/// What a contact does during one straight stage.
///
/// # Example
/// A ball whose slip of 1.05 m/s friction stops after 1.05/(0.3 · 3.5) = 1 N s, halfway through compression,
/// sticks from there on.
/// ```
/// use carom_impact::{Law, planar::{Slip, single}};
/// let ball = single::Contact {
///     w_tt: 3.5, w_tn: 0.0, w_nn: 1.0, slip: 1.05, normal: -2.0, friction: 0.3, restitution: 0.0,
/// };
/// let mut slips = vec![];
/// single::resolve_observed(&ball, Law::Poisson, &mut |stage| slips.push(stage.slip))?;
/// assert_eq!(slips, [Slip::Forward, Slip::Sticks]);
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slip {
    /// It transmits nothing.
    Open,
    /// It transmits an impulse and its slip velocity is zero.
    Sticks,
    /// It transmits an impulse and slips along +t.
    Forward,
    /// It transmits an impulse and slips along −t.
    Backward,
}

impl Slip {
    /// Friction of a slipping contact divided by its normal force (or impulse): −μ where it slips along +t, μ where it slips along −t.
    /// 0 where it sticks or is open: Coulomb's law gives no value there.
    ///
    /// # Example
    /// ```
    /// use carom_impact::planar::Slip;
    /// let slips = [Slip::Forward, Slip::Backward, Slip::Sticks];
    /// assert_eq!(slips.map(|slip| slip.pull(0.3)), [-0.3, 0.3, 0.0]);
    /// ```
    pub fn pull(self, friction: f64) -> f64 {
        match self {
            Self::Forward => -friction,
            Self::Backward => friction,
            Self::Sticks | Self::Open => 0.0,
        }
    }
}

/// Why a straight stage of an impact ended.
///
/// # Example
/// The ball of [`Slip`], with restitution.
/// ```
/// use carom_impact::{Law, planar::{StageEnd, single}};
/// let ball = single::Contact {
///     w_tt: 3.5, w_tn: 0.0, w_nn: 1.0, slip: 1.05, normal: -2.0, friction: 0.3, restitution: 0.5,
/// };
/// let mut ends = vec![];
/// single::resolve_observed(&ball, Law::Poisson, &mut |stage| ends.push(stage.ended_by))?;
/// assert_eq!(ends, [StageEnd::SlipStops(0), StageEnd::CompressionEnds, StageEnd::RestitutionEnds]);
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StageEnd {
    /// The slip of this contact came to zero.
    SlipStops(usize),
    /// This open contact closed again.
    Closes(usize),
    /// No contact approaches any more.
    CompressionEnds,
    /// The law's measure of restitution is used up.
    RestitutionEnds,
}

/// What a contact does at the end of an impact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactState {
    /// Normal velocity after > 0, or no impulse.
    Separates,
    /// Normal velocity and slip after are zero.
    Sticks,
    /// Normal velocity after is zero, slip is not.
    Slips,
}

impl ContactState {
    /// What a contact with this velocity (slip, normal) after an impact does.
    pub(in crate::planar) fn of([slip, normal]: [f64; 2]) -> Self {
        if normal > 0.0 {
            Self::Separates
        } else if slip == 0.0 {
            Self::Sticks
        } else {
            Self::Slips
        }
    }
}

/// The seven qualitatively different impacts at one contact (Plavnieks 1969).
///
/// # Example
/// Friction stops the slip of this ball after s/(0.3 · 3.5) N s; compression takes 2 N s, restitution 1 N s
/// more.
/// ```
/// use carom_impact::{Law, planar::{ImpactType, single}};
/// let kind = |slip| single::resolve(&single::Contact {
///     w_tt: 3.5, w_tn: 0.0, w_nn: 1.0, slip, normal: -2.0, friction: 0.3, restitution: 0.5,
/// }, Law::Poisson).map(|out| out.kind);
/// assert_eq!(kind(2.0)?, Some(ImpactType::StopsInCompression));
/// assert_eq!(kind(3.0)?, Some(ImpactType::StopsInRestitution));
/// assert_eq!(kind(4.0)?, Some(ImpactType::SlidesThroughout));
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum ImpactType {
    /// 1: slides throughout in the initial direction.
    SlidesThroughout = 1,
    /// 2: no initial slip, slips all the same.
    SlipsFromRest = 2,
    /// 3: no initial slip, sticks.
    SticksFromRest = 3,
    /// 4: the slip reverses in restitution.
    ReversesInRestitution = 4,
    /// 5: the slip reverses in compression.
    ReversesInCompression = 5,
    /// 6: the slip stops for good in restitution.
    StopsInRestitution = 6,
    /// 7: the slip stops for good in compression.
    StopsInCompression = 7,
}

/// The classes of Wang and Mason (1992).
///
/// # Example
/// ```
/// use carom_impact::planar::{Class, ImpactType};
/// let types = [ImpactType::StopsInCompression, ImpactType::ReversesInRestitution];
/// assert_eq!(types.map(|kind| kind.class()), [Class::CSticking, Class::RReversed]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// Type 1.
    Sliding,
    /// Type 2: no initial slip.
    SlidingFromRest,
    /// Type 3: no initial slip.
    Sticking,
    /// Type 4.
    RReversed,
    /// Type 5.
    CReversed,
    /// Type 6.
    RSticking,
    /// Type 7.
    CSticking,
}

impl ImpactType {
    /// The number 1…7.
    pub fn number(self) -> u8 {
        self as u8
    }

    /// The class of Wang and Mason that this type is.
    ///
    /// # Example
    /// ```
    /// use carom_impact::planar::{Class, ImpactType};
    /// assert_eq!(ImpactType::SticksFromRest.class(), Class::Sticking);
    /// ```
    pub fn class(self) -> Class {
        match self {
            Self::SlidesThroughout => Class::Sliding,
            Self::SlipsFromRest => Class::SlidingFromRest,
            Self::SticksFromRest => Class::Sticking,
            Self::ReversesInRestitution => Class::RReversed,
            Self::ReversesInCompression => Class::CReversed,
            Self::StopsInRestitution => Class::RSticking,
            Self::StopsInCompression => Class::CSticking,
        }
    }
}
