//! The runs of `data/stools.txt`.

use carom_motion::spatial::{Body, State, Supports};
use carom_num::elementary::sin_cos;
use carom_num::{Mat3, Rotation, Vec3};

/// One impact of the other program.
#[derive(Clone, Debug)]
pub(crate) struct Struck {
    pub(crate) time: f64,
    /// `None` where nothing moves after it.
    pub(crate) kept: Option<Supports>,
    pub(crate) spin: Vec3,
    pub(crate) kinetic: f64,
    /// Above the flat position.
    pub(crate) energy: f64,
    pub(crate) touching: Supports,
    /// A chatter was closed here.
    pub(crate) closes: bool,
}

/// A body on n supports on a circle, how it starts, and what the other program says.
#[derive(Clone, Debug)]
pub(crate) struct Stool {
    pub(crate) name: String,
    pub(crate) count: usize,
    pub(crate) mass: f64,
    pub(crate) radius: f64,
    pub(crate) height: f64,
    pub(crate) across: f64,
    pub(crate) axial: f64,
    pub(crate) g: f64,
    pub(crate) attitude: [f64; 4],
    pub(crate) spin: Vec3,
    pub(crate) impacts: Vec<Struck>,
    pub(crate) rest: f64,
}

impl Stool {
    pub(crate) fn body(&self) -> Body {
        #[allow(clippy::cast_precision_loss, reason = "a handful")]
        let support = |j: usize| {
            let (sin, cos) = sin_cos(std::f64::consts::TAU * j as f64 / self.count as f64);
            Vec3::new(self.radius * cos, self.radius * sin, -self.height)
        };
        let inertia = Mat3::diagonal(self.across, self.across, self.axial);
        Body::new(self.mass, inertia, (0..self.count).map(support).collect()).unwrap()
    }

    pub(crate) fn theory(&self) -> carom_theory::spatial::Stool {
        carom_theory::spatial::Stool {
            supports: u32::try_from(self.count).unwrap(),
            circle_radius: self.radius,
            centre_height: self.height,
            mass: self.mass,
            inertia_transverse: self.across,
            inertia_axial: self.axial,
        }
    }

    pub(crate) fn gravity(&self) -> Vec3 {
        Vec3::Z * -self.g
    }

    pub(crate) fn start(&self) -> State {
        State::standing(&self.body(), 0, Rotation::of(self.attitude).unwrap(), self.spin)
    }
}

fn supports(digits: &str) -> Supports {
    digits.chars().map(|c| c.to_digit(10).unwrap() as usize).collect()
}

pub(crate) fn runs() -> Vec<Stool> {
    let mut out: Vec<Stool> = vec![];
    for line in include_str!("../data/stools.txt").lines().filter(|l| !l.starts_with('#')) {
        let words: Vec<&str> = line.split_whitespace().collect();
        let number = |i: usize| words[i].parse::<f64>().unwrap();
        let vector = |i: usize| Vec3::new(number(i), number(i + 1), number(i + 2));
        match words[0] {
            "run" => out.push(Stool {
                name: words[1].to_string(),
                count: words[2].parse().unwrap(),
                mass: number(3),
                radius: number(4),
                height: number(5),
                across: number(6),
                axial: number(7),
                g: number(8),
                attitude: [1.0, 0.0, 0.0, 0.0],
                spin: Vec3::ZERO,
                impacts: vec![],
                rest: 0.0,
            }),
            "start" => {
                let stool = out.last_mut().unwrap();
                stool.attitude = [1, 2, 3, 4].map(number);
                stool.spin = vector(5);
            }
            "rest" => out.last_mut().unwrap().rest = number(1),
            _ => out.last_mut().unwrap().impacts.push(Struck {
                time: number(1),
                kept: (words[2] != "-").then(|| supports(words[2])),
                spin: vector(3),
                kinetic: number(6),
                energy: number(7),
                touching: supports(words[8]),
                closes: words.get(9) == Some(&"edge"),
            }),
        }
    }
    out
}
