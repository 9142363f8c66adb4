//! Caps and cups: a bottom and a wall.

use super::{Course, Made, problem, revolved, shown};
use crate::problem::Problem;
use crate::quantity::Quantity;
use std::f64::consts::FRAC_PI_2;

/// A cap: its axis along x, its closed end from x = 0, open at its other end.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Cap {
    pub(crate) diameter: Quantity,
    pub(crate) height: Quantity,
    pub(crate) wall: Quantity,
    /// Thickness of the closed end: that of the wall where it is not written.
    pub(crate) base: Option<Quantity>,
    /// Of the closed end's edge, outside.
    pub(crate) corner_radius: Option<Quantity>,
}

impl Cap {
    pub(super) fn dimensions(&mut self) -> Vec<(&'static str, &mut Quantity)> {
        let mut all =
            vec![("diameter", &mut self.diameter), ("height", &mut self.height), ("wall", &mut self.wall)];
        all.extend(self.base.as_mut().map(|base| ("base", base)));
        all.extend(self.corner_radius.as_mut().map(|radius| ("corner_radius", radius)));
        all
    }

    fn problems(&self) -> Vec<Problem> {
        let mut found = vec![];
        let (radius, height, wall) = (0.5 * self.diameter.value, self.height.value, self.wall.value);
        if wall >= radius {
            let message = format!("{} must be less than the radius, {}", shown(wall), shown(radius));
            found.push(problem("wall", &self.wall, message));
        }
        let (key, base) = self.base.as_ref().map_or(("wall", &self.wall), |base| ("base", base));
        if base.value >= height {
            let message = format!("{} must be less than the height, {}", shown(base.value), shown(height));
            found.push(problem(key, base, message));
        }
        if let Some(corner) = self.corner_radius.as_ref().filter(|corner| corner.value >= radius.min(height))
        {
            let message = format!("{} must be less than {}", shown(corner.value), shown(radius.min(height)));
            found.push(problem("corner_radius", corner, message));
        }
        found
    }

    pub(super) fn make(&self) -> Result<Made, Vec<Problem>> {
        let problems = self.problems();
        if !problems.is_empty() {
            return Err(problems);
        }
        let (radius, height, wall) = (0.5 * self.diameter.value, self.height.value, self.wall.value);
        let base = self.base.as_ref().map_or(wall, |base| base.value);
        let corner = self.corner_radius.as_ref().map_or(0.0, |corner| corner.value);
        let mut profile = Course::default();
        profile.to(0.0, 0.0);
        profile.to(0.0, radius - corner);
        profile.bend_to(-FRAC_PI_2, corner, radius);
        profile.to(height, radius);
        profile.to(height, 0.0);
        // The inside is rounded about the same centre as far as both walls allow.
        let inside = (corner - wall.max(base)).max(0.0);
        let mut bore = Course::default();
        bore.to(base, 0.0);
        bore.to(base, radius - wall - inside);
        bore.bend_to(-FRAC_PI_2, base + inside, radius - wall);
        bore.to(height, radius - wall);
        let told = format!(
            "part: cap, {} × {}, wall {}; its open end touches as a flat one: no plate as wide as the part reaches into it",
            shown(2.0 * radius),
            shown(height),
            shown(wall)
        );
        Ok(revolved(&profile.0, &bore.0, vec![told]))
    }
}
