//! Routh's impulse plane of one contact, ready to be drawn.

use carom_impact::planar::{Phase, Slip, StageEnd};
use carom_motion::planar::Body;
use carom_motion::planar::trace::{Impact, ImpactContact};

/// A corner of the walked line in the impulse plane.
///
/// # Example
/// Corners are numbered, and explained with their labels.
/// ```
/// # use {carom_figure::{ImpulsePlane, ImpulsePoint}, carom_impact::planar::Phase};
/// # let point = |normal, tangential, label: &str| ImpulsePoint {
/// #     normal, tangential, phase: Phase::Compression, label: label.to_owned(),
/// # };
/// # let plane = ImpulsePlane {
/// #     operator: Some([3.5, 0.0, 1.0]), slip: 1.05, approach: -2.0, friction: 0.3,
/// #     points: vec![point(1.0, -0.3, "its slip stops"), point(2.0, -0.3, "compression ends")],
/// # };
/// let text = carom_figure::impulse_text(&plane, 40, 8);
/// assert!(text.ends_with("  1 its slip stops\n  2 compression ends\n"));
/// ```
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
/// use {carom_figure::{ImpulsePlane, ImpulsePoint}, carom_impact::planar::Phase};
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
    ///
    /// # Example
    /// A rod of 0.3 kg and 0.1 m that strikes with one end, however it is turned: `W_tt + W_nn = 2/m + r²/J`.
    /// ```
    /// # use {carom_feeder::{Feeder, Part, Plate, Start, Stop}, carom_impact::planar::Law, carom_num::Vec2};
    /// # let plate = |name: &str, uphill, edge| Plate {
    /// #     name: name.to_owned(), uphill, edge, friction: 0.5, restitution: 0.0, unbounded: false,
    /// # };
    /// # let lower = plate("lower", Vec2::new(1.0, -0.2), Vec2::new(-1.0, -0.5));
    /// # let plates = vec![plate("upper", Vec2::new(-0.8, 0.6), Vec2::ZERO), lower];
    /// # let start = Start { to_edge: 0.1, speed: 0.0, face: 0 };
    /// # let (part, law, stop) = (Part::rod(0.1, 0.3, 2.5e-4).unwrap(), Law::Poisson, Stop::Landed);
    /// # let feeder = Feeder { gravity: 10.0, stop, law, part, start, plates, walls: vec![] };
    /// let run = feeder.run().unwrap();
    /// let (impact, body) = (&run.trace.impacts[0], &feeder.part.body);
    /// let plane = carom_figure::ImpulsePlane::of_contact(impact, 0, body).unwrap();
    /// let [tt, _, nn] = plane.operator.unwrap();
    /// assert!((tt + nn - (2.0 / 0.3 + 0.05 * 0.05 / 2.5e-4)).abs() < 1e-10);
    /// assert_eq!(plane.points.last().unwrap().normal, impact.contacts[0].normal_impulse);
    /// assert_eq!(carom_figure::ImpulsePlane::of_contact(impact, 1, body), None, "one end strikes");
    /// ```
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
                phase(stage.phase),
                slip(c.slip),
                stage_end(stage.ended_by, contact)
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
        label: format!("the whole impact: {}", struck.state),
    }]
}

pub(crate) fn phase(phase: Phase) -> &'static str {
    match phase {
        Phase::Compression => "compression",
        Phase::Restitution => "restitution",
    }
}

fn slip(slip: Slip) -> &'static str {
    match slip {
        Slip::Open => "open",
        Slip::Sticks => "sticks",
        Slip::Forward => "slips along +t",
        Slip::Backward => "slips along −t",
    }
}

fn stage_end(end: StageEnd, contact: usize) -> &'static str {
    match end {
        StageEnd::SlipStops(i) if i == contact => "its slip stops",
        StageEnd::SlipStops(_) => "another contact's slip stops",
        StageEnd::Closes(i) if i == contact => "it closes again",
        StageEnd::Closes(_) => "another contact closes again",
        StageEnd::CompressionEnds => "compression ends",
        StageEnd::RestitutionEnds => "restitution ends",
    }
}
