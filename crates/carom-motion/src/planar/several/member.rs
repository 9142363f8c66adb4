//! The bodies of a crowd, each by itself.

use super::crowd::Crowd;
use super::island::Island;
use super::meeting::Approach;
use super::outlook::Outlook;
use crate::MotionError;
use crate::planar::geometry::State;
use crate::planar::record::trace::HeldContact;
use crate::planar::walk::terms::{Effort, Happening, Margin};
use crate::tolerance::MET_GAP;

impl<'w> Crowd<'w> {
    /// The bodies on their way.
    pub fn bodies(&self) -> impl Iterator<Item = usize> + '_ {
        self.islands.iter().flat_map(|i| i.members.iter().copied())
    }

    pub(super) fn island_of(&self, body: usize) -> Option<(&Island<'w>, usize)> {
        self.islands.iter().find_map(|i| Some((i, i.place_of(body)?)))
    }

    /// What is known of a body on its way.
    ///
    /// # Example
    /// Balls of 1 kg and 3 kg meet: `m₁ v₁ + m₂ v₂` stays 2 kg m/s.
    /// ```
    /// use carom_motion::planar::{Crowd, Options, examples};
    /// let (world, at) = (examples::two_balls(), examples::on_the_axis);
    /// let mut crowd = Crowd::new(&world, Options::default());
    /// crowd.enter(0, at(0.0, 2.0), vec![])?;
    /// crowd.enter(1, at(1.2, 0.0), vec![])?;
    /// crowd.advance(9.0, &mut [(), ()])?;
    /// let speed = |body| crowd.member(body).map(|m| m.state().twist.velocity.x);
    /// assert_eq!(speed(0).zip(speed(1)).map(|(v, w)| v + 3.0 * w), Some(2.0));
    /// assert!(crowd.member(2).is_none());
    /// # Ok::<(), carom_motion::MotionError>(())
    /// ```
    pub fn member(&self, body: usize) -> Option<Member<'_>> {
        self.island_of(body).map(|(island, place)| Member { island, place })
    }

    /// True where a body in this state overlaps no body that is on its way.
    ///
    /// # Errors
    /// [`MotionError`]: a fault of the numbers, in looking ahead.
    ///
    /// # Example
    /// Balls of radius 0.1 m overlap where their centres are less than 0.2 m apart.
    /// ```
    /// use carom_motion::planar::{Crowd, Options, examples};
    /// let (world, at) = (examples::two_balls(), examples::on_the_axis);
    /// let mut crowd = Crowd::new(&world, Options::default());
    /// crowd.enter(1, at(1.2, 0.0), vec![])?;
    /// assert!(crowd.has_room(0, &at(0.9, 0.0))?);
    /// assert!(!crowd.has_room(0, &at(1.1, 0.0))?);
    /// # Ok::<(), carom_motion::MotionError>(())
    /// ```
    pub fn has_room(&mut self, body: usize, state: &State) -> Result<bool, MotionError> {
        self.watching(|crowd| {
            crowd.look_ahead()?;
            let mut others = crowd.bodies().filter(|b| *b != body);
            Ok(others.all(|other| {
                let pair = crowd.world.of_some(&[body, other]);
                let here = crowd.state_at(other, crowd.time);
                let approach =
                    Approach { world: &pair, scales: crowd.scales, at: |_| [*state, here], parting: false };
                approach.distance(crowd.time) > -MET_GAP * crowd.scales.length
            }))
        })
    }

    /// Pose and velocity of a body at a time [s] that is known and not before the body's last event, to the accuracy of the dense output. A body that
    /// is not on its way rests at the origin.
    pub fn state_at(&self, body: usize, time: f64) -> State {
        let found = self.islands.iter().zip(&self.ahead).find_map(|(island, ahead)| {
            let place = island.place_of(body)?;
            Some(ahead.as_ref().map_or_else(|| *island.state(place), |a| a.state(place, time)))
        });
        found.unwrap_or_default()
    }
}

/// What is known of a body on its way.
///
/// # Example
/// A ball on its way, before it meets any other.
/// ```
/// use carom_motion::planar::{Crowd, Options, examples};
/// let (world, at) = (examples::two_balls(), examples::on_the_axis);
/// let mut crowd = Crowd::new(&world, Options::default());
/// crowd.enter(0, at(0.0, 2.0), vec![])?;
/// let ball = crowd.member(0).unwrap();
/// assert_eq!((ball.time(), ball.state().twist.velocity.x, ball.ended()), (0.0, 2.0, None));
/// assert!(ball.held().is_empty());
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Member<'c> {
    pub(super) island: &'c Island<'c>,
    pub(super) place: usize,
}

impl Member<'_> {
    /// Time up to which the body was moved [s].
    pub fn time(&self) -> f64 {
        self.island.time()
    }

    /// Pose and velocity.
    pub fn state(&self) -> &State {
        self.island.state(self.place)
    }

    /// The contacts held at present.
    pub fn held(&self) -> Vec<HeldContact> {
        self.island.held(self.place)
    }

    /// The face that lies on an obstacle, as [`Walker::flat_on`](crate::planar::Walker::flat_on).
    pub fn flat_on(&self, obstacle: usize) -> Option<usize> {
        self.island.flat_on(self.place, obstacle)
    }

    /// Which obstacle it meets next, as [`Walker::outlook`](crate::planar::Walker::outlook); other bodies are not looked at.
    pub fn outlook(&self) -> Outlook {
        self.island.outlook()
    }

    /// Counts of the work done for it and for those it met.
    pub fn effort(&self) -> Effort {
        self.island.effort()
    }

    /// How certain its way is so far.
    pub fn margin(&self) -> Margin {
        self.island.margin()
    }

    /// How its way has ended, where it has.
    pub fn ended(&self) -> Option<Happening> {
        self.island.ended()
    }
}
