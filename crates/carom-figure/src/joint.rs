//! The walk of several contacts through one impact, ready to be drawn as one picture.

use carom_impact::planar::{Phase, Slip, StageEnd, staged};
use carom_motion::planar::trace::Impact;

/// A contact of a joint walk.
///
/// # Example
/// A name is written as it is, whatever its letters.
/// ```
/// # use carom_figure::{JointContact, JointWalk};
/// # use {carom_impact::planar::{Law, ContactSet2, Touch, staged}, carom_num::Vec2};
/// # let normal = Vec2::new(0.0, 1.0);
/// # let end = |x| Touch { arm: Vec2::new(x, 0.0), normal, friction: 0.2, restitution: 0.0 };
/// # let velocity = Vec2::new(0.0, -3.0);
/// # let rod = ContactSet2::of_free_body(1.0, 1.0 / 12.0, velocity, -6.0, &[end(-0.5), end(0.5)]).unwrap();
/// # let mut stages = vec![];
/// # staged::resolve_observed(&rod, Law::Poisson, &mut |stage| stages.push(*stage)).unwrap();
/// # let contact = |name: &str| JointContact { name: name.to_owned(), friction: 0.2 };
/// # let contacts = vec![contact("A"), contact("B")];
/// let odd = |c: JointContact| JointContact { name: format!("<{}>", c.name), ..c };
/// let walk = JointWalk::of_stages(contacts.into_iter().map(odd).collect(), &stages);
/// assert!(carom_figure::joint_svg(&walk).contains("&lt;A&gt;"));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct JointContact {
    /// Its name.
    pub name: String,
    /// Coulomb friction coefficient.
    pub friction: f64,
}

/// One contact during one stage: pairs are (tangential, normal), at the stage's start and end.
///
/// # Example
/// A rod of 1 kg and 1 m turns about A with 6 rad/s and falls flat: A takes 1 N s, B takes 2 N s.
/// ```
/// # use carom_figure::{JointContact, JointWalk};
/// # use {carom_impact::planar::{Law, ContactSet2, Touch, staged}, carom_num::Vec2};
/// # let normal = Vec2::new(0.0, 1.0);
/// # let end = |x| Touch { arm: Vec2::new(x, 0.0), normal, friction: 0.2, restitution: 0.0 };
/// # let velocity = Vec2::new(0.0, -3.0);
/// # let rod = ContactSet2::of_free_body(1.0, 1.0 / 12.0, velocity, -6.0, &[end(-0.5), end(0.5)]).unwrap();
/// # let mut stages = vec![];
/// # staged::resolve_observed(&rod, Law::Poisson, &mut |stage| stages.push(*stage)).unwrap();
/// # let contact = |name: &str| JointContact { name: name.to_owned(), friction: 0.2 };
/// # let contacts = vec![contact("A"), contact("B")];
/// let walk = JointWalk::of_stages(contacts, &stages);
/// let taken = |contact: usize| walk.stages[0].pieces[contact].impulse[1][1];
/// assert!((taken(0) - 1.0).abs() < 1e-14 && (taken(1) - 2.0).abs() < 1e-14);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointPiece {
    /// What it does.
    pub slip: Slip,
    /// Impulses so far [N s].
    pub impulse: [[f64; 2]; 2],
    /// Velocities [m/s].
    pub velocity: [[f64; 2]; 2],
}

/// One straight stage of all contacts.
///
/// # Example
/// A rod that falls flat on two supports, without restitution.
/// ```
/// # use carom_figure::{JointContact, JointWalk};
/// # use {carom_impact::planar::{Law, ContactSet2, Touch, staged}, carom_num::Vec2};
/// # let normal = Vec2::new(0.0, 1.0);
/// # let end = |x| Touch { arm: Vec2::new(x, 0.0), normal, friction: 0.2, restitution: 0.0 };
/// # let velocity = Vec2::new(0.0, -3.0);
/// # let rod = ContactSet2::of_free_body(1.0, 1.0 / 12.0, velocity, -6.0, &[end(-0.5), end(0.5)]).unwrap();
/// # let mut stages = vec![];
/// # staged::resolve_observed(&rod, Law::Poisson, &mut |stage| stages.push(*stage)).unwrap();
/// # let contact = |name: &str| JointContact { name: name.to_owned(), friction: 0.2 };
/// # let contacts = vec![contact("A"), contact("B")];
/// use carom_impact::planar::{Phase, StageEnd};
/// let walk = JointWalk::of_stages(contacts, &stages);
/// let last = walk.stages.last().unwrap();
/// assert_eq!((last.phase, last.ended_by), (Phase::Compression, StageEnd::CompressionEnds));
/// assert_eq!(last.pieces.len(), 2);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct JointStage {
    /// Compression or restitution.
    pub phase: Phase,
    /// Why it ended.
    pub ended_by: StageEnd,
    /// The contacts, in order.
    pub pieces: Vec<JointPiece>,
}

/// The walk of several contacts through one impact, stage by stage.
///
/// All contacts are walked at once: stage k ends at one instant for all of them. Its clock is the normal impulse of all contacts together,
/// over which every impulse and every velocity is piecewise linear.
///
/// # Example
/// In every stage each contact goes on from where it was.
/// ```
/// # use carom_figure::{JointContact, JointWalk};
/// # use {carom_impact::planar::{Law, ContactSet2, Touch, staged}, carom_num::Vec2};
/// # let normal = Vec2::new(0.0, 1.0);
/// # let end = |x| Touch { arm: Vec2::new(x, 0.0), normal, friction: 0.2, restitution: 0.0 };
/// # let velocity = Vec2::new(0.0, -3.0);
/// # let rod = ContactSet2::of_free_body(1.0, 1.0 / 12.0, velocity, -6.0, &[end(-0.5), end(0.5)]).unwrap();
/// # let mut stages = vec![];
/// # staged::resolve_observed(&rod, Law::Poisson, &mut |stage| stages.push(*stage)).unwrap();
/// # let contact = |name: &str| JointContact { name: name.to_owned(), friction: 0.2 };
/// # let contacts = vec![contact("A"), contact("B")];
/// let walk = JointWalk::of_stages(contacts, &stages);
/// assert!(walk.stages.windows(2).all(|pair| pair[0].pieces[1].impulse[1] == pair[1].pieces[1].impulse[0]));
/// assert_eq!(walk.stages[0].pieces[1].velocity[0], [0.0, -6.0]);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct JointWalk {
    /// The contacts.
    pub contacts: Vec<JointContact>,
    /// The stages, in order.
    pub stages: Vec<JointStage>,
}

impl JointWalk {
    /// The walk of a staged impact.
    ///
    /// # Example
    /// ```
    /// # use carom_figure::{JointContact, JointWalk};
    /// # use {carom_impact::planar::{Law, ContactSet2, Touch, staged}, carom_num::Vec2};
    /// # let normal = Vec2::new(0.0, 1.0);
    /// # let end = |x| Touch { arm: Vec2::new(x, 0.0), normal, friction: 0.2, restitution: 0.0 };
    /// # let velocity = Vec2::new(0.0, -3.0);
    /// # let rod = ContactSet2::of_free_body(1.0, 1.0 / 12.0, velocity, -6.0, &[end(-0.5), end(0.5)]).unwrap();
    /// # let mut stages = vec![];
    /// # staged::resolve_observed(&rod, Law::Poisson, &mut |stage| stages.push(*stage)).unwrap();
    /// # let contact = |name: &str| JointContact { name: name.to_owned(), friction: 0.2 };
    /// # let contacts = vec![contact("A"), contact("B")];
    /// let walk = JointWalk::of_stages(contacts, &stages);
    /// assert_eq!((walk.stages.len(), walk.contacts[1].name.as_str()), (stages.len(), "B"));
    /// ```
    pub fn of_stages<const N: usize>(contacts: Vec<JointContact>, stages: &[staged::Stage<N>]) -> Self {
        let stage = |stage: &staged::Stage<N>| {
            let piece = |i: usize| JointPiece {
                slip: stage.slip[i],
                impulse: [stage.start.impulse[i], stage.end.impulse[i]],
                velocity: [stage.start.velocity[i], stage.end.velocity[i]],
            };
            JointStage {
                phase: stage.phase,
                ended_by: stage.ended_by,
                pieces: (0..contacts.len().min(N)).map(piece).collect(),
            }
        };
        Self { stages: stages.iter().map(stage).collect(), contacts }
    }

    /// The walk of an impact of a trace; `names` are its contacts' in order.
    ///
    /// # Example
    /// One end of a rod strikes a plate: one contact, and what it takes in the end is the impact's.
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
    /// let impact = &run.trace.impacts[0];
    /// let walk = carom_figure::JointWalk::of_impact(impact, &["end".to_owned()]);
    /// let last = walk.stages.last().unwrap();
    /// assert_eq!((walk.contacts.len(), walk.contacts[0].friction), (1, 0.5));
    /// assert_eq!(last.pieces[0].impulse[1][1], impact.contacts[0].normal_impulse);
    /// ```
    pub fn of_impact(impact: &Impact, names: &[String]) -> Self {
        let contacts = impact.contacts.iter().zip(names);
        let contacts =
            contacts.map(|(c, name)| JointContact { name: name.clone(), friction: c.friction }).collect();
        let stages = impact.stages.iter().map(|stage| JointStage {
            phase: stage.phase,
            ended_by: stage.ended_by,
            pieces: stage
                .contacts
                .iter()
                .map(|c| JointPiece {
                    slip: c.slip,
                    impulse: [0, 1].map(|k| [c.tangential_impulse[k], c.normal_impulse[k]]),
                    velocity: [0, 1].map(|k| [c.slip_velocity[k], c.normal_velocity[k]]),
                })
                .collect(),
        });
        Self { contacts, stages: stages.collect() }
    }

    /// True where there is something to draw, and every number that must be drawn is finite.
    pub(crate) fn can_be_drawn(&self) -> bool {
        let pieces = || self.stages.iter().flat_map(|stage| &stage.pieces);
        let finite = pieces()
            .flat_map(|piece| piece.impulse.iter().chain(&piece.velocity).flatten())
            .all(|number| number.is_finite());
        let pushed = pieces().any(|piece| piece.impulse[1][1] > 0.0);
        let complete = self.stages.iter().all(|stage| stage.pieces.len() == self.contacts.len());
        finite && pushed && complete && self.contacts.iter().all(|c| c.friction.is_finite())
    }

    /// Largest |p_t| and p_n that every panel shows [N s].
    pub(crate) fn extent(&self) -> (f64, f64) {
        let pieces = || self.stages.iter().flat_map(|stage| &stage.pieces);
        let normal = 1.12 * pieces().map(|p| p.impulse[1][1]).fold(0.0, f64::max);
        let walked = pieces().map(|p| p.impulse[1][0].abs()).fold(0.0, f64::max);
        let cone = normal * self.contacts.iter().map(|c| c.friction).fold(0.0, f64::max);
        let half = if walked > 0.0 { cone.min(2.0 * walked).max(1.25 * walked) } else { cone };
        (if half > 0.0 { 1.08 * half } else { 0.3 * normal }, normal)
    }

    /// Normal impulse of all contacts at each instant: before the first stage, and at the end of each [N s].
    pub(crate) fn clock(&self) -> Vec<f64> {
        let sum = |stage: &JointStage, k: usize| stage.pieces.iter().map(|p| p.impulse[k][1]).sum::<f64>();
        let first = self.stages.first().map_or(0.0, |stage| sum(stage, 0));
        std::iter::once(first).chain(self.stages.iter().map(|stage| sum(stage, 1))).collect()
    }

    /// Why a stage ended, in words.
    pub(crate) fn end_words(&self, end: StageEnd) -> String {
        let name = |i: usize| self.contacts.get(i).map_or("?", |c| c.name.as_str());
        match end {
            StageEnd::SlipStops(i) => format!("slip stops at {}", name(i)),
            StageEnd::Closes(i) => format!("{} closes", name(i)),
            StageEnd::CompressionEnds => "compression ends".to_owned(),
            StageEnd::RestitutionEnds => "restitution ends".to_owned(),
        }
    }
}

/// What a contact does, as briefly as a table has room for.
pub(crate) fn slip_words(slip: Slip) -> &'static str {
    match slip {
        Slip::Open => "open",
        Slip::Sticks => "sticks",
        Slip::Forward => "slips +t",
        Slip::Backward => "slips −t",
    }
}
