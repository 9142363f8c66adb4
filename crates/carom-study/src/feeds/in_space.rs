//! How a solid part stands between two samples, and how far two of it are apart.

use super::path::{Leg, Passes};
use carom_motion::spatial::{Form, State};
use carom_num::{Rotation, Vec3};

/// The four numbers of an attitude, or their rates.
type Four = [f64; 4];

/// A cubic's ends: its values there, and its rates times the time between them.
fn attitudes([a, b]: &[State; 2], dt: f64) -> ([Four; 2], [Four; 2]) {
    let rate = |state: &State| state.attitude.rate(state.spin).map(|x| x * dt);
    let (p, q) = (a.attitude.to_array(), b.attitude.to_array());
    // One attitude has two quadruples: the nearer one.
    let near: f64 = (0..4).map(|i| p[i] * q[i]).sum();
    let side = if near < 0.0 { -1.0 } else { 1.0 };
    ([p, q.map(|x| side * x)], [rate(a), rate(b).map(|x| side * x)])
}

fn length(four: Four) -> f64 {
    four.iter().map(|x| x * x).sum::<f64>().sqrt()
}

impl Passes for Form {
    type State = State;
    type Pose = State;

    fn size(&self) -> f64 {
        self.reach()
    }

    fn pose(&self, leg: &Leg<State>, u: f64) -> State {
        let (dt, [a, b]) = (leg.lasts(), &leg.ends);
        // Shares of both ends and of their rates.
        let (rest, square) = (1.0 - u, u * u);
        let ends = [(1.0 + 2.0 * u) * rest * rest, square * (3.0 - 2.0 * u)];
        let rates = [u * rest * rest, -square * rest];
        let centre =
            a.centre * ends[0] + b.centre * ends[1] + (a.velocity * rates[0] + b.velocity * rates[1]) * dt;
        let ([p, q], [m, n]) = attitudes(&leg.ends, dt);
        let four = [0, 1, 2, 3].map(|i| p[i] * ends[0] + q[i] * ends[1] + m[i] * rates[0] + n[i] * rates[1]);
        let attitude = Rotation::of(four).unwrap_or(a.attitude);
        State { centre, attitude, velocity: Vec3::ZERO, spin: Vec3::ZERO }
    }

    fn speed(&self, ends: &[State; 2], dt: f64) -> f64 {
        let [a, b] = ends;
        // A cubic's rate is a quadratic, and lies among these three.
        let mean = (b.centre - a.centre) * (3.0 / dt) - a.velocity - b.velocity;
        let speed = [a.velocity, mean, b.velocity].iter().map(|v| v.norm()).fold(0.0, f64::max);
        let ([p, q], [m, n]) = attitudes(ends, dt);
        let turn = [0, 1, 2, 3].map(|i| 3.0 * (q[i] - p[i]) - m[i] - n[i]);
        let most = [m, turn, n].into_iter().map(length).fold(0.0, f64::max);
        // Between its ends the cubic is shorter than 1, by no more than it goes from the nearer one; a part turns twice as fast as its quadruple.
        let spin = 2.0 * most / (1.0 - 0.5 * most).max(0.5) / dt;
        speed + spin * self.size()
    }

    fn distance(&self, a: &State, b: &State) -> f64 {
        // Far apart the balls about them tell enough: it is no more than the distance.
        let (between, size) = ((b.centre - a.centre).norm(), self.size());
        if between > 4.0 * size { between - 2.0 * size } else { self.clearance([a, b]) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::feeds::path::Way;
    use carom_feeder::spatial::examples;

    /// Of a drop with slides, a tip, a tumbling flight and strikes, every other sample is where the cubics through the others have it.
    #[test]
    fn cubics_between_samples_are_the_motion() {
        let mut feeder = examples::two_plates();
        feeder.start.turn = 0.3;
        let run = feeder.run().unwrap();
        let body = &feeder.part.body;
        let (form, mut worst) = (Form::of(body).unwrap(), 0.0_f64);
        for piece in &run.samples.pieces {
            let inside = |time: f64| time > piece.start_time && time < piece.end_time;
            let inner = run.samples.instants.iter().filter(|(time, ..)| inside(*time));
            let mut all = vec![(piece.start_time, piece.start)];
            all.extend(inner.map(|(time, _, state)| (*time, *state)));
            all.push((piece.end_time, piece.end));
            all.dedup_by_key(|(time, _)| *time);
            let half = all.iter().copied().step_by(2);
            let Some(way) = Way::of(&form, std::iter::once(half), true) else { continue };
            for k in (1..all.len() - 1).step_by(2) {
                let (time, state) = &all[k];
                let found = way.pose(*time);
                let off = |r: &Vec3| (found.place(*r) - state.place(*r)).norm();
                let of_body = body.supports().iter().map(off);
                worst = of_body.fold(worst, f64::max);
            }
        }
        assert!(worst > 0.0 && worst < 1e-9, "{worst}");
    }
}
