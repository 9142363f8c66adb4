//! What may end a stretch in which supports slide or roll.

use super::super::motion::Event;
use super::carriers::Carrier;
use super::{Known, Sliding, Vector};
use crate::spatial::modes::grip::Bearing;
use crate::tolerance::{BEYOND_END, FLAT};

impl Sliding<'_> {
    /// What may end the stretch, but for touches.
    pub(super) fn events(&self) -> Vec<Event> {
        if self.redundant {
            let leaves = self.leaves();
            // How they share is open: they go on as long as some forces let them.
            let idle = self.carriers.iter().enumerate().filter(|(_, c)| c.spare > 0.0);
            let lets = idle.map(|(place, c)| Event::Lets { support: c.support, place });
            return lets.chain([Event::Gives]).chain(self.flattens()).chain(leaves).collect();
        }
        let lets = self.carriers.iter().enumerate();
        let mut events: Vec<Event> =
            lets.map(|(place, c)| Event::Lets { support: c.support, place }).collect();
        let slips = self.carriers.iter().filter(|c| c.sticks).map(|c| Event::Slips(c.support));
        events.extend(slips);
        events.extend(self.flattens());
        events.extend(self.leaves());
        if self.carriers.len() == 1 {
            events.push(Event::Jams);
        }
        events
    }

    /// The value of an event's function: positive as long as it has not come.
    pub(super) fn event_value(&self, event: &Event, y: &Vector, known: &Known) -> f64 {
        let Known { now, reactions, pose } = known;
        if let Event::Leaves { support, limit } = *event {
            let beyond = BEYOND_END * self.scales.length;
            let pose = pose.get_or_init(|| self.pose(y, now.turned, now.spin));
            return self.world.margin(support, limit, *pose) + beyond;
        }
        let Some(reactions) = reactions else { return f64::NAN };
        match *event {
            // One support that slides is left to itself where its force turns; where it grows without bound instead, the force has the sign of its regularity.
            Event::Lets { place, .. } if self.carriers.len() == 1 => {
                reactions.normals[place] * reactions.regularity
            }
            Event::Lets { place, .. } => reactions.normals[place] + self.carriers[place].spare,
            Event::Slips(support) => {
                let Some(k) = self.carriers.iter().position(|c| c.support == support) else {
                    return f64::INFINITY;
                };
                let normal = reactions.normals[k];
                let across = now.bearings[k].along(reactions.forces[k]);
                let most = self.carriers[k].friction * normal;
                most * most - across.dot(across)
            }
            Event::Gives => self.left(now),
            Event::Flattens(support) => {
                let carrier = self.carriers.iter().zip(&now.bearings).find(|(c, _)| c.support == support);
                let tilt = carrier.and_then(|(c, b)| c.feature.tilt(b.up()));
                tilt.map_or(f64::INFINITY, |sine| sine - FLAT)
            }
            Event::Jams => reactions.regularity,
            _ => f64::INFINITY,
        }
    }

    /// The places where supports touch may come to the ends of faces and edges.
    fn leaves(&self) -> impl Iterator<Item = Event> {
        let of = |support: usize| {
            (0..self.world.limits(support)).map(move |limit| Event::Leaves { support, limit })
        };
        self.carriers.iter().flat_map(move |c| of(c.support))
    }

    /// Circles that touch may come to lie flat.
    fn flattens(&self) -> impl Iterator<Item = Event> {
        let circles = self.carriers.iter().filter(|c| c.feature.circle > 0.0);
        circles.map(|c| Event::Flattens(c.support))
    }

    /// In what time the first of them would lie flat, were it to go on as it does \[s\].
    pub(super) fn flat_in(&self, y: &Vector) -> f64 {
        if self.flattens().next().is_none() {
            return f64::INFINITY;
        }
        let now = self.moment(y);
        let time = |(c, b): (&Carrier, &Bearing)| c.feature.flat_in(b.up(), now.spin);
        self.carriers.iter().zip(&now.bearings).filter_map(time).fold(f64::INFINITY, f64::min)
    }
}
