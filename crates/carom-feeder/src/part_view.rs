//! What a verdict looks at: a part on its way, alone or among others.

use carom_motion::planar::observer::HeldContact;
use carom_motion::planar::{Effort, Feature, Margin, Member, Outlook, State, Walker};

/// A part on its way.
pub(crate) trait PartView {
    /// Time [s].
    fn time(&self) -> f64;
    /// Pose and velocity.
    fn state(&self) -> State;
    /// Hands over every contact that is held.
    fn each_held(&self, look: &mut dyn FnMut(HeldContact));
    /// Hands over every contact that is in touch, held or not: obstacle and features.
    fn each_in_touch(&self, look: &mut dyn FnMut(usize, Feature)) {
        self.each_held(&mut |h| look(h.obstacle, h.feature));
    }
    /// The face that lies on an obstacle.
    fn flat_on(&self, obstacle: usize) -> Option<usize>;
    /// The obstacle it meets next, if it flies.
    fn outlook(&self) -> Outlook;
    /// Counts of the work done.
    fn effort(&self) -> Effort;
    /// How certain its way is so far.
    fn margin(&self) -> Margin;

    /// True where it holds a contact on an obstacle.
    fn holds(&self, obstacle: usize) -> bool {
        let mut found = false;
        self.each_held(&mut |h| found |= h.obstacle == obstacle);
        found
    }

    /// True where it holds any contact.
    fn holds_any(&self) -> bool {
        let mut found = false;
        self.each_held(&mut |_| found = true);
        found
    }
}

impl PartView for Walker<'_> {
    fn time(&self) -> f64 {
        self.time()
    }

    fn state(&self) -> State {
        *self.state()
    }

    fn each_held(&self, look: &mut dyn FnMut(HeldContact)) {
        self.held().for_each(look);
    }

    fn each_in_touch(&self, look: &mut dyn FnMut(usize, Feature)) {
        self.in_touch().into_iter().for_each(|(obstacle, feature)| look(obstacle, feature));
    }

    fn flat_on(&self, obstacle: usize) -> Option<usize> {
        self.flat_on(obstacle)
    }

    fn outlook(&self) -> Outlook {
        self.outlook()
    }

    fn effort(&self) -> Effort {
        self.effort()
    }

    fn margin(&self) -> Margin {
        self.margin()
    }
}

impl PartView for Member<'_> {
    fn time(&self) -> f64 {
        self.time()
    }

    fn state(&self) -> State {
        *self.state()
    }

    fn each_held(&self, look: &mut dyn FnMut(HeldContact)) {
        self.held().into_iter().for_each(look);
    }

    fn flat_on(&self, obstacle: usize) -> Option<usize> {
        self.flat_on(obstacle)
    }

    fn outlook(&self) -> Outlook {
        self.outlook()
    }

    fn effort(&self) -> Effort {
        self.effort()
    }

    fn margin(&self) -> Margin {
        self.margin()
    }
}
