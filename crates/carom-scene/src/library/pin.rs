//! Parallel pins with chamfered or rounded ends.

use super::{Course, Made, problem, revolved, shown};
use crate::problem::Problem;
use crate::quantity::Quantity;
use carom_num::elementary::tan;
use std::f64::consts::FRAC_PI_2;

/// How the ends of a pin are.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum PinEnds {
    /// Length along the axis, and the angle to it.
    Chamfered {
        chamfer: Quantity,
        angle: Quantity,
    },
    Rounded {
        radius: Quantity,
    },
    Sharp,
}

/// A pin: its axis along x, from x = 0.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Pin {
    /// What it is called, with its standard; `None` where its dimensions are written.
    pub(crate) called: Option<String>,
    pub(crate) diameter: Quantity,
    pub(crate) length: Quantity,
    pub(crate) ends: PinEnds,
}

impl Pin {
    pub(super) fn dimensions(&mut self) -> Vec<(&'static str, &mut Quantity)> {
        let mut all = vec![("diameter", &mut self.diameter), ("length", &mut self.length)];
        match &mut self.ends {
            PinEnds::Chamfered { chamfer, angle } => {
                all.extend([("chamfer", chamfer), ("chamfer_angle", angle)]);
            }
            PinEnds::Rounded { radius } => all.push(("corner_radius", radius)),
            PinEnds::Sharp => {}
        }
        all
    }

    pub(super) fn make(&self) -> Result<Made, Vec<Problem>> {
        let (radius, length) = (0.5 * self.diameter.value, self.length.value);
        // How long an end is, by how much it is narrower, and by how much its outline turns.
        let (long, narrower, sweep) = match &self.ends {
            PinEnds::Sharp => (0.0, 0.0, 0.0),
            PinEnds::Chamfered { chamfer, angle } => (chamfer.value, chamfer.value * tan(angle.value), 0.0),
            PinEnds::Rounded { radius } => (radius.value, radius.value, -FRAC_PI_2),
        };
        let (key, quantity) = match &self.ends {
            PinEnds::Chamfered { chamfer, .. } => ("chamfer", chamfer),
            PinEnds::Rounded { radius } => ("corner_radius", radius),
            PinEnds::Sharp => ("length", &self.length),
        };
        if 2.0 * long >= length {
            let message =
                format!("{} at both ends leaves nothing of the length, {}", shown(long), shown(length));
            return Err(vec![problem(key, quantity, message)]);
        }
        if narrower > radius {
            let message = format!("takes {} off the radius, which is {}", shown(narrower), shown(radius));
            return Err(vec![problem(key, quantity, message)]);
        }
        let mut profile = Course::default();
        profile.to(0.0, 0.0);
        profile.to(0.0, radius - narrower);
        profile.bend_to(sweep, long, radius);
        profile.to(length - long, radius);
        profile.bend_to(sweep, length, radius - narrower);
        profile.to(length, 0.0);
        let called = self.called.as_ref().map_or("pin".to_owned(), |called| format!("pin {called}"));
        let ends = match &self.ends {
            PinEnds::Sharp => String::new(),
            PinEnds::Chamfered { .. } => format!(", chamfers {} long", shown(long)),
            PinEnds::Rounded { .. } => format!(", ends rounded by {}", shown(long)),
        };
        let told = format!("part: {called}, {} × {}{ends}", shown(2.0 * radius), shown(length));
        Ok(revolved(&profile.0, &[], vec![told]))
    }
}
