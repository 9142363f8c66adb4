//! One impact of the body: from touching pairs to the impact kernel and back.

use super::question::Posed;
use crate::planar::contact::{
    World,
    kinematics::{Kinematics, Pairing},
    touching::{Few, MOST_TOUCHING},
};
use crate::planar::geometry::{Feature, State, Twist};
use crate::planar::record::trace::{ContactStage, ContactVelocity, Impact, ImpactContact, ImpactStage};
use crate::tolerance::PAINLEVE_EDGE;
use carom_impact::planar::{
    Block, ContactSet, ContactState, ImpactType, Slip, StageEnd, share, single, staged,
};
use carom_impact::{ImpactError, Law, Phase};

/// The friction with which a contact is on the far side of Painlevé's edge, where it is at the edge within the rounding of the motion that
/// has run into it: which side the last step fell on decides nothing.
fn friction_at_edge(friction: f64, operator: &Block) -> f64 {
    let edge = operator.nn / operator.nt.abs();
    let at_edge = (friction - edge).abs() <= PAINLEVE_EDGE * friction;
    if at_edge { friction.max(edge * (1.0 + PAINLEVE_EDGE)) } else { friction }
}

/// A pair that takes part in an impact.
#[derive(Clone, Copy, Debug)]
pub(in crate::planar) struct Struck {
    pub(in crate::planar) pair: Pairing,
    /// Slip before [m/s].
    pub(in crate::planar) slip: f64,
    /// Normal velocity before, ≤ 0 [m/s].
    pub(in crate::planar) normal: f64,
    /// What it did before.
    pub(in crate::planar) present: Slip,
}

/// A stage of the walk, contact by contact.
#[derive(Clone, Debug)]
struct Walked {
    phase: Phase,
    ended_by: StageEnd,
    contacts: Vec<ContactStage>,
}

/// One of the bodies, to which an impact is told.
pub(in crate::planar) struct Witness<'a, const B: usize> {
    pub(in crate::planar) world: &'a World,
    /// The states of all bodies before.
    pub(in crate::planar) before: &'a [State; B],
    pub(in crate::planar) body: usize,
    /// What a pair is to this body: the number of what it meets, and the features; `None` where it takes no part.
    pub(in crate::planar) sees: &'a dyn Fn(Pairing) -> Option<(usize, Feature)>,
}

/// An impact resolved.
#[derive(Clone, Debug)]
pub(in crate::planar) struct Strike<const B: usize> {
    pub(in crate::planar) twists: [Twist; B],
    /// Slip and normal velocity of each contact after.
    pub(in crate::planar) after: [[f64; 2]; MOST_TOUCHING],
    pub(in crate::planar) kind: Option<ImpactType>,
    pub(in crate::planar) margin: f64,
    impulse: [[f64; 2]; MOST_TOUCHING],
    work: [[f64; 2]; MOST_TOUCHING],
    state: [ContactState; MOST_TOUCHING],
    law: Law,
    gained_energy: bool,
    restitution_scaled: f64,
    without_approach: bool,
    branches: usize,
    open_share: bool,
    stages: Vec<Walked>,
}

impl<const B: usize> Strike<B> {
    /// An impact at one contact.
    pub(in crate::planar) fn at_one(
        world: &World,
        posed: Posed<'_, B>,
        struck: &Few<Struck>,
        forced: bool,
        dense: bool,
    ) -> Result<Self, ImpactError> {
        let (set, seen): (ContactSet<1, 2>, _) = world.contact_set(posed, struck.iter().map(|s| s.pair))?;
        let (Some(s), b) = (struck.iter().next(), set.operator[0][0]) else {
            return Err(ImpactError::Jammed);
        };
        // A motion that ran into Painlevé's edge stands on it within rounding: the impact is that of the far side, wherever the last step fell.
        let friction = if forced { friction_at_edge(set.friction[0], &b) } else { set.friction[0] };
        let contact = single::Contact { slip: s.slip, normal: s.normal, friction, ..set.alone(0) };
        let mut stages = vec![];
        let out = single::resolve_observed(&contact, world.law, &mut |stage: &single::Stage| {
            if dense {
                stages.push(walked_single(stage));
            }
        })?;
        let mut strike = Self::empty(posed.0.map(|s| s.twist), world.law);
        strike.after[0] = [out.slip, out.normal];
        strike.impulse[0] = [out.tangential_impulse, out.normal_impulse];
        strike.work[0] = [out.tangential_work, out.normal_work];
        strike.state[0] = out.state;
        strike.kind = out.kind;
        strike.margin = out.margin;
        strike.gained_energy = out.gained_energy;
        strike.without_approach = out.without_approach;
        strike.stages = stages;
        strike.apply(world, struck, &seen);
        Ok(strike)
    }

    /// An impact at several contacts.
    pub(in crate::planar) fn at_several<const N: usize, const M: usize>(
        world: &World,
        posed: Posed<'_, B>,
        struck: &Few<Struck>,
        dense: bool,
    ) -> Result<Self, ImpactError> {
        let (mut set, seen): (ContactSet<N, M>, _) =
            world.contact_set(posed, struck.iter().map(|s| s.pair))?;
        for (i, s) in struck.iter().enumerate() {
            (set.slip[i], set.normal[i]) = (s.slip, s.normal);
        }
        let mut stages = vec![];
        // Showing the stages walks the impact again.
        let out = if dense {
            staged::resolve_observed(&set, world.law, &mut |stage: &staged::Stage<N>| {
                stages.push(walked_several(stage, set.count));
            })?
        } else {
            staged::resolve(&set, world.law)?
        };
        let mut strike = Self::empty(posed.0.map(|s| s.twist), out.law);
        for i in 0..set.count {
            strike.after[i] = out.velocity[i];
            strike.impulse[i] = out.impulse[i];
            strike.work[i] = out.work[i];
            strike.state[i] = out.state[i];
        }
        strike.margin = out.margin;
        strike.gained_energy = out.gained_energy;
        strike.restitution_scaled = out.restitution_scaled;
        strike.without_approach = out.without_approach;
        strike.branches = out.branches;
        // Whoever looks on is told; the motion goes on with the share that was taken.
        let is_open = out.open_share.contains(&true);
        strike.open_share = dense && is_open && !share::outcomes(&set, world.law)?.is_empty();
        strike.stages = stages;
        strike.apply(world, struck, &seen);
        Ok(strike)
    }

    fn empty(twists: [Twist; B], law: Law) -> Self {
        Self {
            twists,
            after: [[0.0; 2]; MOST_TOUCHING],
            kind: None,
            margin: f64::INFINITY,
            impulse: [[0.0; 2]; MOST_TOUCHING],
            work: [[0.0; 2]; MOST_TOUCHING],
            state: [ContactState::Separates; MOST_TOUCHING],
            law,
            gained_energy: false,
            restitution_scaled: 1.0,
            without_approach: false,
            branches: 1,
            open_share: false,
            stages: vec![],
        }
    }

    /// Adds the impulses to the bodies' momenta.
    fn apply(&mut self, world: &World, struck: &Few<Struck>, seen: &[Kinematics]) {
        for ((s, k), [tangential, normal]) in struck.iter().zip(seen).zip(self.impulse) {
            let p = k.normal * normal + k.tangent() * tangential;
            for (body, arm, p) in world.acts_on(s.pair, k, p) {
                self.twists[body].velocity += p / world.bodies[body].mass;
                self.twists[body].spin += arm.cross(p) / world.bodies[body].inertia;
            }
        }
    }

    /// True where any impulse is exchanged.
    pub(in crate::planar) fn acts(&self) -> bool {
        self.impulse.iter().any(|p| p[1] > 0.0)
    }

    /// The contact of a body that approaches fastest, with the number of the thing that it meets and the features, as the body sees them. `None`
    /// where the body takes no part.
    pub(in crate::planar) fn striking(
        &self,
        struck: &Few<Struck>,
        to: &Witness<'_, B>,
    ) -> Option<(Struck, usize, Feature)> {
        let seen = struck.iter().filter_map(|s| (to.sees)(s.pair).map(|(obstacle, f)| (*s, obstacle, f)));
        seen.min_by(|a, b| a.0.normal.total_cmp(&b.0.normal))
    }

    /// The whole record of the impact as one of the bodies sees it, the striking contact first.
    pub(in crate::planar) fn whole(&self, time: f64, struck: &Few<Struck>, to: &Witness<'_, B>) -> Impact {
        let Witness { world, before, body, sees: view } = *to;
        let all: Vec<Struck> = struck.iter().copied().collect();
        let mut order: Vec<usize> = (0..struck.len()).filter(|&i| view(all[i].pair).is_some()).collect();
        order.sort_by(|&a, &b| all[a].normal.total_cmp(&all[b].normal));
        let contacts = order.iter().filter_map(|&i| {
            let (obstacle, feature) = view(all[i].pair)?;
            Some(self.contact(&all[i], i, (obstacle, feature), to))
        });
        // Contacts between others are no part of this body's record: the numbers in the ends of stages count without them.
        let stages = self.stages.iter().map(|w| ImpactStage {
            phase: w.phase,
            ended_by: renumbered(w.ended_by, &order),
            contacts: order.iter().filter_map(|&i| w.contacts.get(i).copied()).collect(),
        });
        let kinetic = |twist: &Twist| world.bodies[body].kinetic_energy(twist);
        let (was, is) = (before[body].twist, self.twists[body]);
        Impact {
            time,
            pose: before[body].pose,
            before: was,
            after: is,
            law: self.law,
            kind: self.kind,
            without_approach: self.without_approach,
            branches: self.branches,
            open_share: self.open_share,
            contacts: contacts.collect(),
            stages: stages.collect(),
            energy_before: kinetic(&was),
            energy_after: kinetic(&is),
            gained_energy: self.gained_energy,
            restitution_scaled: self.restitution_scaled,
            holding_would_need: None,
        }
    }

    /// What one contact, the `i`-th of the impact, is to one of the bodies.
    fn contact(
        &self,
        s: &Struck,
        i: usize,
        (obstacle, feature): (usize, Feature),
        to: &Witness<'_, B>,
    ) -> ImpactContact {
        let Witness { world, before, body, .. } = *to;
        let (k, own) = (world.kinematics(before, s.pair), s.pair.body == body);
        let surface = world.surface(s.pair);
        ImpactContact {
            obstacle,
            feature,
            point: before[body].pose.centre + if own { k.arm } else { k.other_arm },
            normal: if own { k.normal } else { -k.normal },
            friction: surface.friction,
            restitution: surface.restitution,
            before: ContactVelocity { slip: s.slip, normal: s.normal },
            after: ContactVelocity { slip: self.after[i][0], normal: self.after[i][1] },
            state: self.state[i],
            normal_impulse: self.impulse[i][1],
            tangential_impulse: self.impulse[i][0],
            normal_work: self.work[i][1],
            tangential_work: self.work[i][0],
        }
    }
}

/// The contact that ends a stage, by its place in `order`.
fn renumbered(end: StageEnd, order: &[usize]) -> StageEnd {
    let place = |i: usize| order.iter().position(|&o| o == i).unwrap_or(i);
    match end {
        StageEnd::SlipStops(i) => StageEnd::SlipStops(place(i)),
        StageEnd::Closes(i) => StageEnd::Closes(place(i)),
        StageEnd::CompressionEnds | StageEnd::RestitutionEnds => end,
    }
}

fn walked_single(stage: &single::Stage) -> Walked {
    let (a, b) = (&stage.start, &stage.end);
    let contact = ContactStage {
        slip: stage.slip,
        normal_impulse: [a.normal_impulse, b.normal_impulse],
        tangential_impulse: [a.tangential_impulse, b.tangential_impulse],
        slip_velocity: [a.slip, b.slip],
        normal_velocity: [a.normal, b.normal],
    };
    Walked { phase: stage.phase, ended_by: stage.ended_by, contacts: vec![contact] }
}

fn walked_several<const N: usize>(stage: &staged::Stage<N>, count: usize) -> Walked {
    let contacts = (0..count).map(|i| {
        let (a, b) = (&stage.start, &stage.end);
        ContactStage {
            slip: stage.slip[i],
            normal_impulse: [a.impulse[i][1], b.impulse[i][1]],
            tangential_impulse: [a.impulse[i][0], b.impulse[i][0]],
            slip_velocity: [a.velocity[i][0], b.velocity[i][0]],
            normal_velocity: [a.velocity[i][1], b.velocity[i][1]],
        }
    });
    Walked { phase: stage.phase, ended_by: stage.ended_by, contacts: contacts.collect() }
}
