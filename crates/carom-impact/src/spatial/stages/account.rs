//! What a walk must account for: velocities are those that its impulses make of those before, works those of the impulses, and neither drowns in rounding.

use super::walk::Walk;
use crate::tolerance::{ACCOUNTED_IN_SPACE, BALANCE_IN_SPACE, DROWNED, LOST};
use carom_num::Vec3;

impl<const N: usize> Walk<'_, N> {
    /// True where the velocities and works are those of the impulses.
    pub(super) fn is_accounted_for(&self) -> bool {
        let (mut work, mut terms) = (0.0, 0.0);
        for i in self.contacts() {
            let (before, now) = (self.set.velocity[i].to_array(), self.place.at.velocity[i].to_array());
            let (made, sizes) = self.made(i);
            let impulse = self.place.at.impulse[i].to_array();
            for axis in 0..3 {
                let size = sizes[axis] + self.fastest;
                let open =
                    (made[axis] - now[axis]).abs() > (BALANCE_IN_SPACE * size).min(LOST * self.fastest);
                if open || DROWNED * size > self.fastest {
                    return false;
                }
                let done = 0.5 * (before[axis] + now[axis]) * impulse[axis];
                work += done;
                terms += done.abs();
            }
        }
        (work - self.total_work()).abs() <= ACCOUNTED_IN_SPACE * terms.max(self.work_terms)
    }

    /// What the impulses make of the velocity of a contact, and the sizes of what they add.
    fn made(&self, i: usize) -> ([f64; 3], [f64; 3]) {
        let (mut made, mut sizes) = (self.set.velocity[i].to_array(), [0.0; 3]);
        for (block, Vec3 { x, y, z }) in
            self.set.operator[i].iter().zip(self.place.at.impulse).take(self.set.count)
        {
            for ((made, size), row) in made.iter_mut().zip(&mut sizes).zip(block.rows) {
                let terms = [row.x * x, row.y * y, row.z * z];
                *made += terms.iter().sum::<f64>();
                *size += terms.iter().map(|term| term.abs()).sum::<f64>();
            }
        }
        (made, sizes)
    }
}
