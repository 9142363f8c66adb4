//! The cylinder, the prism and the rod: outcomes of the engine, closed forms over them.

use super::study::{Curve, Label, Study};
use crate::tasks::axes::{Key, Plane};
use crate::tasks::tolerance::REGION_ACCURACY;
use carom_figure::RegionName;
use carom_impact::ImpactError;
use carom_impact::planar::{ContactState, Slip};
use carom_scene::unit::Dimension;
use carom_study::rocking::{Rolling, Struck};
use carom_theory::rocking::{Border, Cylinder, Prism, SupportedRod};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

/// The smallest length, mass or inertia that a diagram reaches: zero is no body.
const LEAST: f64 = 1e-9;
const ANY: f64 = f64::INFINITY;

/// A body that rocks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Cylinder,
    Prism,
    Rod,
}

impl Kind {
    pub(super) fn keys(self) -> Vec<Key> {
        let friction = Key::new("friction", "friction f", Dimension::Number, 0.3, [0.0, ANY]);
        let length = |name, words, value| Key::new(name, words, Dimension::Length, value, [LEAST, ANY]);
        match self {
            Self::Cylinder => vec![
                friction,
                Key::new("gamma", "half angle γ", Dimension::Angle, FRAC_PI_4, [LEAST, FRAC_PI_2 - LEAST]),
                Key::new("inertia_ratio", "b = J/(m a²)", Dimension::Number, 1.0, [LEAST, 1.0]),
            ],
            Self::Prism => vec![
                friction,
                Key::new("inertia", "inertia J (m = 1 kg)", Dimension::Inertia, 0.2, [LEAST, ANY]),
                length("to_centre", "d_A", 0.5),
                length("to_k", "d_K", 0.5),
                length("height", "h", 0.3),
            ],
            Self::Rod => vec![
                length("to_a", "support behind the middle a", 0.3),
                length("to_b", "support before the middle b", 0.3),
                length("length", "length l", 1.0),
            ],
        }
    }

    /// Default axes.
    pub(super) fn axes(self) -> [&'static str; 2] {
        match self {
            Self::Cylinder => ["friction=0..1.5:75", "gamma=1..89 deg:87"],
            Self::Prism => ["inertia=0.01..0.4 kg m^2:78", "friction=0..1.2:80"],
            Self::Rod => ["to_a=10..500 mm:70", "to_b=10..500 mm:70"],
        }
    }

    fn title(self) -> &'static str {
        match self {
            Self::Cylinder => "A rolling cylinder strikes a step",
            Self::Prism => "A prism rolls onto its next edge",
            Self::Rod => "A rod falls on its second support",
        }
    }

    fn slug(self) -> &'static str {
        match self {
            Self::Cylinder => "cylinder",
            Self::Prism => "prism",
            Self::Rod => "rod",
        }
    }

    /// The state in which it stops.
    fn stopped(self) -> u8 {
        if self == Self::Cylinder { 4 } else { 1 }
    }

    /// What a state of the plastic strike is.
    fn words(self, state: u8) -> &'static str {
        match (self, state) {
            (Self::Cylinder, 1) => "rolls over K",
            (Self::Cylinder, 2) => "leaves A, slips at K",
            (Self::Cylinder, 3) => "spins in the corner",
            (Self::Cylinder, 4) => "stops",
            (Self::Prism, 1) => "stops on both edges",
            (Self::Prism, 2) => "slides on flat",
            (Self::Prism, 3) => "rolls on over K",
            (Self::Prism, 4) => "turns and slides at K",
            (Self::Rod, 1) => "stops on both",
            (Self::Rod, 2) => "goes on about B",
            _ => "another state",
        }
    }

    fn strike(self, values: &[f64], restitution: f64) -> Result<Struck, ImpactError> {
        self.rolling(values, restitution).strike()
    }

    fn rolling(self, values: &[f64], restitution: f64) -> Rolling {
        match (self, values) {
            (Self::Cylinder, &[f, gamma, b]) => Rolling::cylinder(b, gamma, f, restitution),
            (Self::Prism, &[f, inertia, to_centre, to_k, height]) => {
                Rolling::prism(inertia, [to_centre, to_k, height], f, restitution)
            }
            (_, values) => Rolling::rod(values[2], [values[0], values[1]], restitution),
        }
    }

    fn state(self, struck: &Struck) -> u8 {
        let state = match self {
            Self::Cylinder => struck.cylinder_state(),
            Self::Prism => struck.prism_state(),
            Self::Rod => struck.rod_state(),
        };
        state.unwrap_or(0)
    }

    /// The closed forms at a point.
    fn borders(self, values: &[f64]) -> Vec<Border> {
        match (self, values) {
            (Self::Cylinder, &[friction, half_angle, inertia_ratio]) => {
                Cylinder { mass: 1.0, radius: 1.0, inertia_ratio, friction, half_angle }.borders().to_vec()
            }
            (Self::Prism, &[friction, inertia, to_centre, to_k, height]) => {
                Prism { mass: 1.0, inertia, to_centre, to_k, height, friction }.borders().to_vec()
            }
            (_, values) => vec![SupportedRod::uniform(1.0, values[2], [values[0], values[1]]).border()],
        }
    }

    fn curve_names(self) -> &'static [&'static str] {
        match self {
            Self::Cylinder => &[
                "1|2  tan γ = f(1+b)/b",
                "2|3  γ = 45° + atan(f)/2",
                "3|4  tan γ = (b + (1+b)f²)/f",
                "1|4  cos 2γ = −b, above f* = b/√(1−b²)",
            ],
            Self::Prism => &[
                "1|2  f = h/d_A",
                "1|3  J = m(d_A d_K − h²)",
                "2|4  f = (d_A d_K − J/m)/(d_A h)",
                "3|4  f = m h d_K/(J + m h²)",
            ],
            Self::Rod => &["1|2  12ab = l²"],
        }
    }

    /// The diagram of its strikes: plastic, or with a restitution as a whole.
    pub(super) fn study(self, plane: &Plane, elastic: Option<f64>) -> Study<'_> {
        let states = self.borders(&plane.at(plane.axes[0].range.from, plane.axes[1].range.from));
        let curve = |(k, name): (usize, &&str)| Curve {
            name: (*name).to_owned(),
            states: states.get(k).map(|border| border.states),
            border: Box::new(move |x, y| {
                let border = self.borders(&plane.at(x, y))[k];
                (border.residual, border.applies)
            }),
        };
        let law = elastic.map_or("end of compression, restitution 0".to_owned(), |restitution| {
            format!("whole impact, restitution {restitution} by Poisson's law")
        });
        Study {
            slug: format!("regions-{}", self.slug()),
            title: self.title().to_owned(),
            subtitle: format!("{};  {law}", plane.fixed()),
            plane,
            classify: Box::new(move |x, y| self.label(&plane.at(x, y), elastic)),
            name: Box::new(move |label| self.name(label)),
            state: Box::new(|label| (label % 8) as u8),
            curves: self.curve_names().iter().enumerate().map(curve).collect(),
            curves_are: "closed forms of the plastic strike".to_owned(),
            ends: Some(Box::new(move |x, y| {
                self.rolling(&plane.at(x, y), elastic.unwrap_or(0.0)).ends().ok()
            })),
            remarks: Box::new(|_| vec![]),
            thresholds: None,
            accuracy: REGION_ACCURACY,
        }
    }

    /// The state at the end of compression; for a whole impact also what the contacts do at its end, and the sense of the roll.
    fn label(self, values: &[f64], elastic: Option<f64>) -> Label {
        let Ok(plastic) = self.strike(values, 0.0) else { return 0 };
        let state = Label::from(self.state(&plastic));
        let Some(restitution) = elastic else { return state };
        let Ok(whole) = self.strike(values, restitution) else { return 0 };
        // A body at rest turns and slips by its rounding at most. Close to the border of rest a plastic strike that goes on is slower than
        // that: what comes of it goes on too.
        let stops = Label::from(self.stopped()) == state;
        let rests = whole.rests && (stops || !plastic.rests);
        let sense = match whole.roll_rate {
            rate if rests || rate == 0.0 => 3,
            rate if rate > 0.0 => 1,
            _ => 2,
        };
        let open = whole.state[0] == ContactState::Separates;
        let ends = match whole.slip {
            _ if rests => [Slip::Sticks; 2],
            [_, k] if open => [Slip::Open, k],
            both => both,
        };
        let [a, k] = ends.map(|slip| SLIPS.iter().position(|s| *s == slip).unwrap_or(0) as Label);
        let rebounds = Label::from(whole.state[1] == ContactState::Separates && !rests);
        state + 8 * (sense + 4 * (a + 4 * (k + 4 * rebounds)))
    }

    fn name(self, label: Label) -> RegionName {
        let (state, rest) = ((label % 8) as u8, label / 8);
        if state == 0 && rest == 0 {
            return RegionName { short: "?".to_owned(), long: "no state, or no walk".to_owned() };
        }
        if rest == 0 {
            return RegionName { short: state.to_string(), long: self.words(state).to_owned() };
        }
        let slips = [(rest / 4) % 4, (rest / 16) % 4].map(|k| SLIPS[k as usize]);
        let sense = ["", "rolls on", "turns back", "does not turn"][(rest % 4) as usize];
        let [a, k] = slips.map(words_of);
        let k = match (rest / 64, slips[1]) {
            (0, _) => k.to_owned(),
            (_, Slip::Sticks) => "rebounds without slip".to_owned(),
            _ => format!("rebounds and {k}"),
        };
        let signs: String = slips.map(sign_of).concat();
        let back = if rest % 4 == 2 { "↶" } else { "" };
        RegionName { short: format!("{state}{signs}{back}"), long: format!("A {a}, K {k}; {sense}") }
    }
}

const SLIPS: [Slip; 4] = [Slip::Open, Slip::Sticks, Slip::Forward, Slip::Backward];

fn words_of(slip: Slip) -> &'static str {
    match slip {
        Slip::Open => "open",
        Slip::Sticks => "sticks",
        Slip::Forward => "slips forward",
        Slip::Backward => "slips backward",
    }
}

fn sign_of(slip: Slip) -> &'static str {
    match slip {
        Slip::Open => "o",
        Slip::Sticks => "s",
        Slip::Forward => "+",
        Slip::Backward => "−",
    }
}
