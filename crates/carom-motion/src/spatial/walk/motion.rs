//! A stretch of motion as its integration and the search for its events see it.

use crate::spatial::geometry::posture::{Bend, Height, Most, Moving, Posture};
use crate::spatial::geometry::state::State;
use crate::spatial::geometry::world::World;
use crate::spatial::modes::bounds::Bounds;
use crate::spatial::modes::capacity::Capacity;
use crate::spatial::modes::mode::{Mode, Vector, normalised};
use crate::spatial::modes::stretch::Stretch;
use crate::spatial::record::run::Budget;
use carom_num::Vec3;
use carom_num::ode8::{self, Step};

/// What ends a stretch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::spatial) enum Event {
    /// A support comes down on the plane.
    Touches(usize),
    /// The normal force on a held support falls to zero: the foot's, or that on the other end of an edge.
    Lets {
        /// The support.
        support: usize,
        /// Its place among the normal forces.
        place: usize,
    },
    /// The friction that a support takes, one end of an edge or both of them, has come to the edge of its cone: the first end's, the second's, or that along
    /// the edge. Of a body that slides, that of the support of this number.
    Slips(usize),
    /// Supports of several planes can no longer all do what they do: no forces within their cones are left.
    Gives,
    /// The slip of a support comes to zero.
    Stops,
    /// The place where a support touches comes to the end of a face or an edge: to this limit of it.
    Leaves {
        /// The support.
        support: usize,
        /// Which limit.
        limit: usize,
    },
    /// A circle that touches comes to lie flat.
    Flattens(usize),
    /// Friction presses a sliding body on the plane without bound.
    Jams,
    /// It leans over too far.
    Overturns,
}

/// What a stretch ended with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stop {
    Event(Event),
    Spent(Budget),
    /// It flies, and nothing can carry it any more.
    Away,
    /// Nothing moves, and nothing makes it move.
    Still,
}

/// A stretch of motion.
pub(in crate::spatial) trait Motion {
    /// What is integrated.
    type Y: ode8::Vector;
    /// What is worked out of an instant once, for its posture and for all events.
    type Known;

    /// Its derivative.
    fn rate(&self, y: &Self::Y) -> Self::Y;

    /// The same motion, with what the integration has let drift taken back.
    fn tidied(&self, y: &Self::Y) -> Self::Y;

    /// What the error of a step may be, where the spin's size is at least `spin` \[rad/s\].
    fn tolerance(&self, y: &Self::Y, relative: f64, spin: f64) -> Self::Y;

    /// The longest step to try from here \[s\].
    fn longest(&self, y: &Self::Y, rate: &Self::Y) -> f64;

    /// True where explicit steps would be far shorter than what the motion needs.
    fn is_stiff(&self, _y: &Self::Y, _rate: &Self::Y) -> bool {
        false
    }

    /// An implicit step from here, where explicit steps would be short, and the length of the next one. The step has the hinted length or less, and
    /// at most the other length.
    fn stiff_step(
        &self,
        _at: (&Self::Y, &Self::Y),
        _lengths: (f64, f64),
        _tolerance: &Self::Y,
    ) -> Option<(Step<Self::Y>, f64)> {
        None
    }

    /// The end of such a step of another length from the same start.
    fn stiff_end(&self, _step: &Step<Self::Y>, _length: f64) -> Option<Self::Y> {
        None
    }

    /// How long a slip that comes to its end still takes \[s\], and the motion where it ends; `None` where no slip comes to its end.
    fn stops(&self, y: &Self::Y, rate: &Self::Y) -> Option<(f64, Self::Y)>;

    /// Places of a step that are looked at before events are searched in it.
    const LOOKED_AT: &'static [f64];

    /// Looks at a step, which has these postures there.
    fn look(&mut self, step: &Step<Self::Y>, at: &[Posture]);

    fn known(&self, y: &Self::Y) -> Self::Known;

    fn posture_at(&self, y: &Self::Y, elapsed: f64, known: &Self::Known) -> Posture;

    fn posture(&self, y: &Self::Y, elapsed: f64) -> Posture {
        self.posture_at(y, elapsed, &self.known(y))
    }

    fn state(&self, y: &Self::Y, elapsed: f64) -> State;

    /// The height of a point of the body over the plane of a face.
    fn height(&self, world: &World, support: usize, at: &Posture) -> Height;

    /// The height of any support.
    fn gap(&self, world: &World, support: usize, at: &Posture, moving: &Moving) -> Height {
        match world.pair(support) {
            Some(pair) => pair.height(moving),
            None => self.height(world, support, at),
        }
    }

    /// The body at an instant.
    fn moving(&self, at: &Posture) -> Moving;

    /// What the motion does not exceed in the time that follows.
    fn most(&self, at: &Posture, time: f64) -> Most;

    /// What the acceleration of such a height does not exceed in the time that follows, or for a part of it.
    fn bend(&self, world: &World, support: usize, at: &Posture, time: f64) -> Bend;

    /// Events whose functions are looked at at nodes, but for overturning.
    fn smooth_events(&self) -> Vec<Event>;

    /// The value of such a function: positive as long as the mode holds.
    fn value(&self, event: &Event, y: &Self::Y, at: &Posture, known: &Self::Known) -> f64;

    /// The edge, or zero for a point, that the body turns about and may lean over.
    fn leans_over(&self) -> Option<Vec3>;

    /// Work of friction since the start of the stretch \[J\].
    fn work(&self, y: &Self::Y) -> f64;
}

/// Flight, or a motion in which no support that touches slides.
#[derive(Clone, Debug)]
pub(super) struct Standing {
    pub(in crate::spatial) stretch: Stretch,
    bounds: Bounds,
    /// Friction coefficients of the foot and the other end of an edge; `None` where no support slides whatever that takes.
    friction: Option<[f64; 2]>,
    /// What the supports can take where they are of several planes.
    capacity: Option<Capacity>,
}

impl Standing {
    pub(in crate::spatial) fn of(world: &World, stretch: Stretch) -> Self {
        let first = stretch.first();
        let (at, pose) = (stretch.posture(&first, 0.0), stretch.state(&first, 0.0).pose());
        let ends = match stretch.equations.mode() {
            Mode::Pivot { support, .. } => [support; 2],
            Mode::Edge { ends, .. } => ends,
            _ => [0; 2],
        };
        let friction = world.friction().map(|friction| ends.map(|end| friction.coefficient(end)));
        let (bounds, held) =
            (Bounds::of(world, &stretch.equations, &at), stretch.equations.mode().held(world));
        let apart = !world.is_of_one_plane(held);
        let capacity = apart.then(|| Capacity::of(world, held, pose)).flatten();
        Self { stretch, bounds, friction, capacity }
    }

    /// What is left of the friction cones: at each end, and of both ends along the edge between them. The last counts with the largest friction along the edge
    /// that each end can take besides what it takes across it: how the ends share that, no rigid body says.
    fn grip(&self, [first, second]: [f64; 2], which: usize, at: &Posture) -> f64 {
        let forces = self.stretch.equations.end_forces(at);
        let cone = |end: usize, mu: f64| {
            let (normal, across) = (forces.normal[end], forces.across[end]);
            mu * mu * normal * normal - across * across
        };
        let [one, other] = [cone(0, first), cone(1, second)];
        match (which, self.stretch.equations.mode()) {
            (0, Mode::Pivot { .. }) => one - forces.along * forces.along,
            (0, _) => one,
            (1, _) => other,
            _ => one.max(0.0).sqrt() + other.max(0.0).sqrt() - forces.along.abs(),
        }
    }
}

impl Motion for Standing {
    type Y = Vector;
    type Known = ();

    fn rate(&self, y: &Vector) -> Vector {
        self.stretch.equations.rate(y)
    }

    fn tidied(&self, y: &Vector) -> Vector {
        normalised(y)
    }

    fn tolerance(&self, y: &Vector, relative: f64, spin: f64) -> Vector {
        let spin = (y[4] * y[4] + y[5] * y[5] + y[6] * y[6]).sqrt().max(spin);
        std::array::from_fn(|i| relative * if i < 4 { 1.0 } else { spin })
    }

    fn longest(&self, _: &Vector, _: &Vector) -> f64 {
        f64::INFINITY
    }

    fn stops(&self, _: &Vector, _: &Vector) -> Option<(f64, Vector)> {
        None
    }

    const LOOKED_AT: &'static [f64] = &[];

    fn look(&mut self, _: &Step<Vector>, _: &[Posture]) {}

    fn known(&self, _: &Vector) {}

    fn posture_at(&self, y: &Vector, elapsed: f64, (): &()) -> Posture {
        self.stretch.posture(y, elapsed)
    }

    fn state(&self, y: &Vector, elapsed: f64) -> State {
        self.stretch.state(y, elapsed)
    }

    fn height(&self, world: &World, support: usize, at: &Posture) -> Height {
        self.stretch.height(world, support, at)
    }

    fn moving(&self, at: &Posture) -> Moving {
        self.stretch.moving(at)
    }

    fn most(&self, at: &Posture, time: f64) -> Most {
        self.bounds.most(at.spin, time)
    }

    fn bend(&self, world: &World, support: usize, at: &Posture, time: f64) -> Bend {
        let up = self.stretch.up(world, support, at);
        self.bounds.bend([at.spin, up], &world.support(support), time)
    }

    fn smooth_events(&self) -> Vec<Event> {
        let (mut events, grips) = match self.stretch.equations.mode() {
            // Which of them slips, and whether one is let go, the rate problem says.
            _ if self.capacity.is_some() => (vec![Event::Gives], 0),
            Mode::Pivot { support, .. } => (vec![Event::Lets { support, place: 0 }], 1),
            Mode::Edge { ends: [a, b], .. } => {
                (vec![Event::Lets { support: a, place: 0 }, Event::Lets { support: b, place: 1 }], 3)
            }
            _ => (vec![], 0),
        };
        if self.friction.is_some() {
            events.extend((0..grips).map(Event::Slips));
        }
        events
    }

    fn value(&self, event: &Event, _: &Vector, at: &Posture, (): &()) -> f64 {
        match (*event, self.friction) {
            (Event::Lets { place, .. }, _) => self.stretch.equations.normal_forces(at)[place],
            (Event::Slips(which), Some(friction)) => self.grip(friction, which, at),
            (Event::Gives, _) => self.capacity.as_ref().map_or(f64::INFINITY, |capacity| capacity.left(at)),
            _ => f64::INFINITY,
        }
    }

    fn leans_over(&self) -> Option<Vec3> {
        match self.stretch.equations.mode() {
            Mode::Flight => None,
            Mode::Edge { along, .. } => Some(along),
            _ => Some(Vec3::ZERO),
        }
    }

    fn work(&self, _: &Vector) -> f64 {
        0.0
    }
}
