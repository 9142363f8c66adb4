//! What is found within a step, and how courses end.

use super::*;
use crate::elementary::sin_cos;

use crate::falls::first_fall;
use crate::ode8::step_plain;

/// An oscillator (position, velocity, time) whose events are these functions of it.
struct Oscillator<E> {
    events: E,
    tolerance: f64,
}

impl<const K: usize, E: Fn(&[f64; 3]) -> [f64; K]> Oscillator<E> {
    fn watching(events: E) -> Self {
        Self { events, tolerance: 1e-9 }
    }

    fn follow(mut self, first: f64) -> Result<Option<Reached<[f64; 3], usize>>, Lost> {
        let start = [0.0, 1.0, 0.0];
        let rate = self.rate(&start);
        Ok(match follow(&mut self, (start, rate), first, 100)? {
            Stop::Event { event, .. } => Some(event),
            Stop::End(()) => None,
        })
    }
}

impl<const K: usize, E: Fn(&[f64; 3]) -> [f64; K]> Course for Oscillator<E> {
    type Y = [f64; 3];
    type Event = usize;
    type End = ();

    fn rate(&mut self, y: &[f64; 3]) -> [f64; 3] {
        [y[1], -y[0], 1.0]
    }

    fn first_event(&mut self, step: &Step<[f64; 3]>) -> Result<Option<Found<usize>>, Lost> {
        let fall = first_fall(&mut |x| (self.events)(&step.at(x)));
        Ok(fall.map(|fall| placed(self, step, fall.of, fall.at)))
    }

    fn value(&mut self, event: &usize, _: f64, y: &[f64; 3]) -> f64 {
        (self.events)(y)[*event]
    }

    fn pace(&self, _: &[f64; 3], _: &[f64; 3]) -> Pace<[f64; 3]> {
        Pace { shortest: 1e-6, ..Pace::within([self.tolerance; 3]) }
    }
}

/// Nothing limits its steps, and nothing ends it.
struct Still;

impl Course for Still {
    type Y = [f64; 1];
    type Event = ();
    type End = ();

    fn rate(&mut self, _: &[f64; 1]) -> [f64; 1] {
        [1.0]
    }

    fn first_event(&mut self, _: &Step<[f64; 1]>) -> Result<Option<Found<()>>, Lost> {
        Ok(None)
    }

    fn value(&mut self, (): &(), _: f64, _: &[f64; 1]) -> f64 {
        1.0
    }

    fn pace(&self, _: &[f64; 1], _: &[f64; 1]) -> Pace<[f64; 1]> {
        Pace::within([1e300])
    }
}

/// Both ends of the step see the function positive: only what happens between tells.
#[test]
fn a_function_that_falls_and_rises_within_one_step_is_found() {
    for depth in [1e-2, 1e-4, 1e-6] {
        let dips = Oscillator::watching(|y: &[f64; 3]| [1.0 - depth - y[0]]);
        let Ok(Some(Reached { event: 0, y, .. })) = dips.follow(2.5) else { panic!("it dips by {depth}") };
        // sin t = 1 − depth, on the way up.
        let (sin, _) = sin_cos(y[2]);
        assert!((sin - 1.0 + depth).abs() < 1e-8 && y[2] < std::f64::consts::FRAC_PI_2, "{depth}: {y:?}");
    }
}

#[test]
fn of_two_events_in_one_step_the_first_ends_the_course() {
    let both = Oscillator::watching(|y: &[f64; 3]| [0.9 - y[2], 0.8 - y[2]]);
    let Ok(Some(Reached { event, y, .. })) = both.follow(1.0) else { panic!("both fall") };
    assert!(event == 1 && (y[2] - 0.8).abs() < 1e-12, "{event} at {y:?}");
}

/// It begins at zero and hardly rises: near its fall the secants follow the last digits.
#[test]
fn an_event_near_rounding_is_not_taken_for_the_zero_where_it_began() {
    let fall = 1e-3;
    for noise in [1e-12, 1e-10, 1e-8] {
        let mut rises =
            Oscillator::watching(
                |y: &[f64; 3]| [y[2] * (fall - y[2]) + noise * ((y[2] * 1e9).fract() - 0.5)],
            );
        let start = [0.0, 1.0, 0.0];
        let rate = rises.rate(&start);
        let plain = step_plain(start, rate, 1.0, |y| rises.rate(y));
        let end_rate = rises.rate(&plain.end);
        let step = plain.with_dense(end_rate, |y| rises.rate(y));
        for i in 0..1000 {
            let at = fall * (0.9 + 2e-4 * f64::from(i));
            let found = placed(&mut rises, &step, 0, at);
            assert!((found.at - fall).abs() < 0.1 * fall, "noise {noise}, from {at}: {}", found.at);
        }
    }
}

/// x′ = 10⁶ u and u′ = 10⁻³, but whoever goes on from a step takes u back to 0.
struct Drifting;

impl Course for Drifting {
    type Y = [f64; 2];
    type Event = ();
    type End = ();

    fn rate(&mut self, y: &[f64; 2]) -> [f64; 2] {
        [1e6 * y[1], 1e-3]
    }

    fn first_event(&mut self, _: &Step<[f64; 2]>) -> Result<Option<Found<()>>, Lost> {
        Ok(None)
    }

    fn value(&mut self, (): &(), _: f64, _: &[f64; 2]) -> f64 {
        1.0
    }

    fn end(&mut self, y: &[f64; 2], _: &[f64; 2]) -> Option<()> {
        (y[0] > 100.0).then_some(())
    }

    fn pace(&self, _: &[f64; 2], _: &[f64; 2]) -> Pace<[f64; 2]> {
        Pace { longest: 0.1, ..Pace::within([1e-9; 2]) }
    }

    fn passed(&mut self, step: Step<[f64; 2]>) -> [f64; 2] {
        [step.end[0], 0.0]
    }
}

/// Steps of 0.1 go 5 each. With the derivative of what was taken back the next step would be refused until it is a billion times shorter.
#[test]
fn what_has_drifted_is_taken_back_with_its_derivative() {
    let end = follow(&mut Drifting, ([0.0; 2], [0.0, 1e-3]), 0.1, 25);
    assert!(matches!(end, Ok(Stop::End(()))));
}

#[test]
fn budgets_end_by_name() {
    let none = || Oscillator::watching(|_: &[f64; 3]| [1.0]);
    assert!(matches!(none().follow(0.1), Err(Lost::Steps)), "100 steps");
    assert!(
        matches!(follow(&mut Still, ([0.0], [1.0]), 0.1, 1000), Err(Lost::Steps)),
        "steps that grow without end"
    );
    let tight = Oscillator { tolerance: 1e-60, ..none() };
    assert!(matches!(tight.follow(0.1), Err(Lost::Short(_))), "steps of a millionth");
}
