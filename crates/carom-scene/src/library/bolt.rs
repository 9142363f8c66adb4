//! Bolts with hexagon heads or socket heads.

use super::{Course, Made, mirrored, problem, shown};
use crate::problem::Problem;
use crate::quantity::Quantity;
use carom_motion::planar::AxialMoments;

/// The pitch diameter of a metric thread is d − 0.6495 P (ISO 724): 3√3/8.
const PITCH_DEPTH: f64 = 0.649_519_052_838_329;

/// What the head of a bolt looks like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum HeadWord {
    Hexagon,
    Socket,
}

carom_words::words! {
    HeadWord {
        Hexagon = "hexagon",
        Socket = "socket",
    }
}

/// A bolt: its head from x = 0, its axis along x.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Bolt {
    pub(crate) head: HeadWord,
    /// What it is called, with its standard; `None` where its dimensions are written.
    pub(crate) called: Option<String>,
    pub(crate) diameter: Quantity,
    pub(crate) length: Quantity,
    pub(crate) head_width: Quantity,
    pub(crate) head_height: Quantity,
    pub(crate) pitch: Option<Quantity>,
    /// Up to the head where there is none.
    pub(crate) thread_length: Option<Quantity>,
    /// Width and depth.
    pub(crate) socket: Option<(Quantity, Quantity)>,
}

impl Bolt {
    pub(super) fn dimensions(&mut self) -> Vec<(&'static str, &mut Quantity)> {
        let mut all = vec![
            ("diameter", &mut self.diameter),
            ("length", &mut self.length),
            ("head_width", &mut self.head_width),
            ("head_height", &mut self.head_height),
        ];
        all.extend(self.pitch.as_mut().map(|pitch| ("pitch", pitch)));
        all.extend(self.thread_length.as_mut().map(|length| ("thread_length", length)));
        if let Some((width, depth)) = &mut self.socket {
            all.extend([("socket_width", width), ("socket_depth", depth)]);
        }
        all
    }

    fn problems(&self) -> Vec<Problem> {
        let mut found = vec![];
        let told = |quantity: &Quantity| shown(quantity.value);
        if self.head_width.value <= self.diameter.value {
            let message = format!(
                "{} must be more than the diameter, {}",
                told(&self.head_width),
                told(&self.diameter)
            );
            found.push(problem("head_width", &self.head_width, message));
        }
        if let Some(thread) = self.thread_length.as_ref().filter(|thread| thread.value > self.length.value) {
            let message = format!("{} is more than the length, {}", told(thread), told(&self.length));
            found.push(problem("thread_length", thread, message));
        }
        if let Some(pitch) = self.pitch.as_ref().filter(|pitch| pitch.value >= self.diameter.value) {
            let message = format!("{} must be less than the diameter, {}", told(pitch), told(&self.diameter));
            found.push(problem("pitch", pitch, message));
        }
        if let Some((width, depth)) = &self.socket {
            if depth.value >= self.head_height.value {
                let message = format!(
                    "{} must be less than the height of the head, {}",
                    told(depth),
                    told(&self.head_height)
                );
                found.push(problem("socket_depth", depth, message));
            }
            // Across corners a hexagon is 2/√3 as wide as across flats.
            if 2.0 / 3f64.sqrt() * width.value >= self.head_width.value {
                let message = format!(
                    "{} across flats reaches through the head, {} wide",
                    told(width),
                    told(&self.head_width)
                );
                found.push(problem("socket_width", width, message));
            }
        }
        found
    }

    /// Seen across the flats of its head, as it lies on one of them.
    pub(super) fn make(&self) -> Result<Made, Vec<Problem>> {
        let problems = self.problems();
        if !problems.is_empty() {
            return Err(problems);
        }
        let [diameter, length, width, height] =
            [&self.diameter, &self.length, &self.head_width, &self.head_height]
                .map(|quantity| quantity.value);
        let end = height + length;
        let mut profile = Course::default();
        for (z, r) in
            [(0.0, 0.0), (0.0, width), (height, width), (height, diameter), (end, diameter), (end, 0.0)]
        {
            profile.to(z, 0.5 * r);
        }
        let cylinder = |from: f64, to: f64, diameter: f64| {
            let mut profile = Course::default();
            for (z, r) in [(from, 0.0), (from, diameter), (to, diameter), (to, 0.0)] {
                profile.to(z, 0.5 * r);
            }
            AxialMoments::of_revolution(&profile.0)
        };
        let thread = self.thread_length.as_ref().map_or(length, |thread| thread.value);
        let pitch_diameter = diameter - PITCH_DEPTH * self.pitch.as_ref().map_or(0.0, |pitch| pitch.value);
        let shank =
            cylinder(height, end - thread, diameter).with(cylinder(end - thread, end, pitch_diameter));
        let head = match self.head {
            HeadWord::Hexagon => AxialMoments::of_hexagonal_prism(0.0, height, width),
            HeadWord::Socket => cylinder(0.0, height, width),
        };
        let socket = self.socket.as_ref().map_or(AxialMoments::default(), |(width, depth)| {
            AxialMoments::of_hexagonal_prism(0.0, depth.value, width.value)
        });
        let axial = Some(shank.with(head).without(socket));
        let outline = mirrored(&profile.0);
        Ok(Made { outline, hollow: vec![], axial, zero: 0.0, notes: vec![self.told(pitch_diameter)] })
    }

    /// What it is, and what is left out of it.
    fn told(&self, pitch_diameter: f64) -> String {
        let [diameter, length, width, height] =
            [&self.diameter, &self.length, &self.head_width, &self.head_height]
                .map(|quantity| shown(quantity.value));
        let called = self.called.as_ref().map_or("bolt".to_owned(), |called| format!("bolt {called}"));
        let (head, seen) = match self.head {
            HeadWord::Hexagon => ("across flats", ", seen across the flats of its head"),
            HeadWord::Socket => ("wide", ""),
        };
        let pitch = if self.pitch.is_some() {
            format!(", its thread touches with {diameter} and weighs with {}", shown(pitch_diameter))
        } else {
            String::new()
        };
        format!(
            "part: {called}, {diameter} by {length}, head {width} {head} and {height} high{seen}{pitch}; chamfers and fillets are left out"
        )
    }
}
