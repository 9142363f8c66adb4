//! Angles of flat bar.

use super::{Course, Made, problem, shown};
use crate::problem::Problem;
use crate::quantity::Quantity;
use std::f64::consts::FRAC_PI_2;

/// An angle: the outside of its corner at the origin, its legs along x and along y.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Bracket {
    pub(crate) legs: [Quantity; 2],
    pub(crate) thickness: Quantity,
    pub(crate) inner_radius: Quantity,
    pub(crate) outer_radius: Quantity,
}

impl Bracket {
    pub(super) fn dimensions(&mut self) -> Vec<(&'static str, &mut Quantity)> {
        let [x, y] = &mut self.legs;
        vec![
            ("legs.x", x),
            ("legs.y", y),
            ("thickness", &mut self.thickness),
            ("inner_radius", &mut self.inner_radius),
            ("outer_radius", &mut self.outer_radius),
        ]
    }

    pub(super) fn make(&self) -> Result<Made, Vec<Problem>> {
        let [a, b] = [self.legs[0].value, self.legs[1].value];
        let [thick, inner, outer] =
            [&self.thickness, &self.inner_radius, &self.outer_radius].map(|quantity| quantity.value);
        let shorter = a.min(b);
        if thick >= shorter {
            let message = format!("{} must be less than the shorter leg, {}", shown(thick), shown(shorter));
            return Err(vec![problem("thickness", &self.thickness, message)]);
        }
        if thick + inner >= shorter {
            let message = format!(
                "{} leaves nothing straight of the shorter leg inside, {}",
                shown(inner),
                shown(shorter - thick)
            );
            return Err(vec![problem("inner_radius", &self.inner_radius, message)]);
        }
        if outer > thick + inner {
            let message = format!(
                "{} must be at most the thickness and the inner radius together, {}",
                shown(outer),
                shown(thick + inner)
            );
            return Err(vec![problem("outer_radius", &self.outer_radius, message)]);
        }
        let mut outline = Course::default();
        outline.to(outer, 0.0);
        outline.to(a, 0.0);
        outline.to(a, thick);
        outline.to(thick + inner, thick);
        outline.bend_to(-FRAC_PI_2, thick, thick + inner);
        outline.to(thick, b);
        outline.to(0.0, b);
        if outer > 0.0 {
            outline.to(0.0, outer);
        }
        let mut outline = outline.0;
        if let Some(last) = outline.last_mut().filter(|_| outer > 0.0) {
            last.sweep = FRAC_PI_2;
        }
        Ok(Made { outline, hollow: vec![], axial: None, zero: 0.0, notes: vec![] })
    }
}
