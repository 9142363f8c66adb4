//! The walk of several contacts through one impact, ready to be drawn as one picture.

use carom_impact::Phase;
use carom_impact::planar::{Slip, StageEnd, staged};
use carom_motion::planar::trace::Impact;

/// A contact of a joint walk.
#[derive(Clone, Debug, PartialEq)]
pub struct JointContact {
    /// Its name.
    pub name: String,
    /// Coulomb friction coefficient.
    pub friction: f64,
}

/// One contact during one stage: pairs are (tangential, normal), at the stage's start and end.
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
#[derive(Clone, Debug, PartialEq)]
pub struct JointWalk {
    /// The contacts.
    pub contacts: Vec<JointContact>,
    /// The stages, in order.
    pub stages: Vec<JointStage>,
}

impl JointWalk {
    /// The walk of a staged impact.
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
}
