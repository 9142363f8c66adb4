//! Plain washers, seen edge on.

use super::{Course, Made, problem, revolved, shown};
use crate::problem::Problem;
use crate::quantity::Quantity;
use carom_motion::planar::ChainPoint;
use carom_num::Vec2;

/// A washer: its axis along x, from x = 0.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Washer {
    /// What it is called, with its standard; `None` where its dimensions are written.
    pub(crate) called: Option<String>,
    pub(crate) inner_diameter: Quantity,
    pub(crate) outer_diameter: Quantity,
    pub(crate) thickness: Quantity,
}

impl Washer {
    pub(super) fn dimensions(&mut self) -> Vec<(&'static str, &mut Quantity)> {
        vec![
            ("inner_diameter", &mut self.inner_diameter),
            ("outer_diameter", &mut self.outer_diameter),
            ("thickness", &mut self.thickness),
        ]
    }

    pub(super) fn make(&self) -> Result<Made, Vec<Problem>> {
        let [inner, outer, thickness] =
            [&self.inner_diameter, &self.outer_diameter, &self.thickness].map(|quantity| quantity.value);
        if inner >= outer {
            let message = format!("{} must be less than the outer diameter, {}", shown(inner), shown(outer));
            return Err(vec![problem("inner_diameter", &self.inner_diameter, message)]);
        }
        let mut profile = Course::default();
        for (z, r) in [(0.0, 0.0), (0.0, outer), (thickness, outer), (thickness, 0.0)] {
            profile.to(z, 0.5 * r);
        }
        let hole = [0.0, thickness].map(|z| ChainPoint::straight(Vec2::new(z, 0.5 * inner)));
        let called = self.called.as_ref().map_or("washer".to_owned(), |called| format!("washer {called}"));
        let [inner_told, outer, thick] = [inner, outer, thickness].map(shown);
        let told = format!("part: {called}, {inner_told} × {outer} × {thick}, seen edge on");
        Ok(revolved(&profile.0, if inner > 0.0 { &hole } else { &[] }, vec![told]))
    }
}
