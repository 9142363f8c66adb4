//! Routh's impulse plane of one contact, ready to be drawn.

use carom_impact::Phase;
use carom_motion::planar::Body;
use carom_motion::planar::trace::{Impact, ImpactContact};
use carom_words::{
    Words,
    impact::{slip, stage_end_at},
};

/// A corner of the walked line in the impulse plane.
#[derive(Clone, Debug, PartialEq)]
pub struct ImpulsePoint {
    /// Normal impulse so far [N s].
    pub normal: f64,
    /// Tangential impulse so far [N s].
    pub tangential: f64,
    /// Phase of the stage that ends here.
    pub phase: Phase,
    /// What the contact did in the stage that ends here, and why the stage ended.
    pub label: String,
}

/// The impulse plane of one contact: the walked line, the friction cone and the two lines that decide.
///
/// ```text
/// u = u⁻ + W p,   line of sticking u_t = 0,   line of maximum compression u_n = 0,   cone |p_t| ≤ μ p_n
/// ```
///
/// *Source*: E. J. Routh, *Dynamics of a System of Rigid Bodies* (1860); Y. Wang and M. T. Mason, *J. Appl. Mech.* 59 (1992) 635.
///
/// # Example
/// A ball of 1 kg whose slip friction stops: on the last corner both lines meet, `u_t = 1.05 + 3.5 p_t` and
/// `u_n = p_n − 2` being zero.
/// ```
/// use carom_figure::{ImpulsePlane, ImpulsePoint};
/// use carom_impact::Phase;
/// let (phase, label) = (Phase::Compression, "compression ends".to_owned());
/// let plane = ImpulsePlane {
///     operator: Some([3.5, 0.0, 1.0]), slip: 1.05, approach: -2.0, friction: 0.3,
///     points: vec![ImpulsePoint { normal: 2.0, tangential: -0.3, phase, label }],
/// };
/// let ([tt, tn, nn], end) = (plane.operator.unwrap(), &plane.points[0]);
/// assert!((plane.slip + tt * end.tangential + tn * end.normal).abs() < 1e-15);
/// assert_eq!(plane.approach + tn * end.tangential + nn * end.normal, 0.0);
/// assert_eq!(carom_figure::impulse_svg(&plane).matches("<circle class=\"dot\"").count(), 2);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ImpulsePlane {
    /// `[W_tt, W_tn, W_nn]` [1/kg]; `None` where other contacts act too and the two lines move during the impact.
    pub operator: Option<[f64; 3]>,
    /// Slip velocity before [m/s].
    pub slip: f64,
    /// Normal velocity before [m/s]; an approach is negative.
    pub approach: f64,
    /// Coulomb friction coefficient.
    pub friction: f64,
    /// The walk from the origin, stage by stage.
    pub points: Vec<ImpulsePoint>,
}

impl ImpulsePlane {
    /// The plane of contact `contact` of an impact of `body`; `None` where the impact has no such contact.
    ///
    /// The line of sticking and the line of maximum compression are drawn only where this is the one contact.
    pub fn of_contact(impact: &Impact, contact: usize, body: &Body) -> Option<Self> {
        let struck = impact.contacts.get(contact)?;
        let points = walk(impact, contact, struck);
        let operator = (impact.contacts.len() == 1).then(|| operator_of(impact, struck, body));
        Some(Self {
            operator: operator.filter(|w| w.iter().all(|x| x.is_finite())),
            slip: struck.before.slip,
            approach: struck.before.normal,
            friction: struck.friction,
            points,
        })
    }

    /// True where every number that must be drawn is finite and there is something to draw.
    pub(crate) fn can_be_drawn(&self) -> bool {
        let points = self.points.iter().all(|p| p.normal.is_finite() && p.tangential.is_finite());
        let size = self.points.iter().map(|p| p.normal.abs().max(p.tangential.abs())).fold(0.0, f64::max);
        points && size > 0.0 && self.friction.is_finite()
    }

    /// Half of the shown height of the plane and its shown width: the largest |p_t| and p_n [N s].
    pub(crate) fn extent(&self) -> (f64, f64) {
        let normal = 1.22 * self.points.iter().map(|p| p.normal).fold(0.0, f64::max);
        let walked = self.points.iter().map(|p| p.tangential.abs()).fold(0.0, f64::max);
        let normal = if normal > 0.0 { normal } else { walked };
        let cone = self.friction * normal;
        let half = if walked > 0.0 { cone.min(2.5 * walked).max(1.3 * walked) } else { cone };
        (if half > 0.0 { 1.1 * half } else { 0.3 * normal }, normal)
    }

    /// Coefficients (a, b, c) of the line of sticking, `a p_t + b p_n + c = 0`.
    pub(crate) fn line_of_sticking(&self) -> Option<[f64; 3]> {
        self.operator.map(|[tt, tn, _]| [tt, tn, self.slip])
    }

    /// Coefficients (a, b, c) of the line of maximum compression.
    pub(crate) fn line_of_compression(&self) -> Option<[f64; 3]> {
        self.operator.map(|[_, tn, nn]| [tn, nn, self.approach])
    }
}

/// The inverse inertia `W` that the contact feels, `[W_tt, W_tn, W_nn]` [1/kg].
fn operator_of(impact: &Impact, contact: &ImpactContact, body: &Body) -> [f64; 3] {
    let arm = contact.point - impact.pose.centre;
    let (r_t, r_n) = (arm.dot(contact.normal.turned_right()), arm.dot(contact.normal));
    let (m, j) = (body.mass, body.inertia);
    [1.0 / m + r_n * r_n / j, -r_t * r_n / j, 1.0 / m + r_t * r_t / j]
}

/// The walked corners; where the impact kept no stages, its end alone.
fn walk(impact: &Impact, contact: usize, struck: &ImpactContact) -> Vec<ImpulsePoint> {
    let staged: Vec<ImpulsePoint> = impact
        .stages
        .iter()
        .filter_map(|stage| {
            let c = stage.contacts.get(contact)?;
            let label = format!(
                "{}: {}, until {}",
                stage.phase.word(),
                slip(c.slip),
                stage_end_at(stage.ended_by, contact)
            );
            let [_, normal] = c.normal_impulse;
            let [_, tangential] = c.tangential_impulse;
            Some(ImpulsePoint { normal, tangential, phase: stage.phase, label })
        })
        .collect();
    if !staged.is_empty() {
        return staged;
    }
    vec![ImpulsePoint {
        normal: struck.normal_impulse,
        tangential: struck.tangential_impulse,
        phase: Phase::Compression,
        label: format!("the whole impact: {}", struck.state.word()),
    }]
}
