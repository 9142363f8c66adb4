//! The rate problem in space against a search that knows no hypotheses.
//!
//! For given normal rates friction minimises a convex function over discs, so the motion is unique: what is left are the normal rates, and these are
//! scanned. The kernel guesses what each contact does and solves for directions instead.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test fails by panicking, and says what it measured"
)]

mod random;

use carom_impact::planar::rate::Load;
use carom_impact::spatial::{Condition, ContactSet, Mode, RateProblem, RigidBody, Touch};
use carom_num::{Mat3, Rotation, Vec3};
use random::numbers;

/// Motions that agree to this fraction of the largest are the same: the search bisects, and its discs are found by iteration.
const SAME: f64 = 1e-5;

fn many(case: u32) -> impl Fn(usize) -> f64 {
    let all: Vec<f64> = (0..4).flat_map(|k| (0..16).map(numbers(4 * case + k)).collect::<Vec<_>>()).collect();
    move |k| all[k]
}

/// A random body that touches with its contacts in any directions, and what drives it.
struct Case {
    set: ContactSet<2>,
    drive: [Vec3; 2],
    slip: [[f64; 2]; 2],
}

impl Case {
    fn of(case: u32, count: usize) -> Self {
        let random = many(case);
        let vector =
            |k: usize| Vec3::new(random(k), random(k + 1), random(k + 2)) * 2.0 - Vec3::new(1.0, 1.0, 1.0);
        let [a, b] = [0.3 + random(0), 0.3 + random(1)];
        let third = (a - b).abs() + (a + b - (a - b).abs()) * (0.05 + 0.9 * random(2));
        let inertia = Rotation::by(vector(3) * 3.0).turn(Mat3::diagonal(a, b, third)) * 0.3;
        let body = RigidBody { mass: 0.5 + random(9), inertia, velocity: vector(6), spin: vector(10) * 2.0 };
        let touch = |i: usize| Touch {
            arm: vector(16 + 3 * i),
            normal: if case.is_multiple_of(2) {
                Vec3::Z
            } else {
                (vector(24 + 3 * i) * 0.5 + Vec3::Z).unit().unwrap()
            },
            friction: if case.is_multiple_of(3) { 4.0 } else { 1.5 } * random(22 + i),
            restitution: 0.0,
        };
        let touches: Vec<Touch> = (0..count).map(touch).collect();
        let set = ContactSet::<2>::of_free_body(&body, &touches).unwrap();
        // Driven as by a force on the body: velocities stand for accelerations.
        let mut drive = set.velocity;
        drive.iter_mut().for_each(|d| d.z = -d.z.abs());
        let slips = |i: usize| random(30 + i) < 0.3;
        let slip = std::array::from_fn(|i| {
            if slips(i) { [random(34 + i) - 0.5, random(36 + i) - 0.5] } else { [0.0; 2] }
        });
        Self { set, drive, slip }
    }

    fn problem(&self) -> RateProblem<'_, 2> {
        RateProblem {
            count: self.set.count,
            operator: &self.set.operator,
            friction: &self.set.friction,
            drive: self.drive,
            slip: self.slip,
            load: [Load::Touching(0.0); 2],
        }
    }

    /// The motion with these normal rates.
    fn motion(&self, normal: [f64; 2]) -> [Vec3; 2] {
        let mut rates = normal.map(|r| Vec3::Z * r);
        for i in 0..self.set.count {
            let [x, y] = self.slip[i];
            let length = (x * x + y * y).sqrt();
            if length > 0.0 {
                let bound = self.set.friction[i] * normal[i] / length;
                (rates[i].x, rates[i].y) = (-bound * x, -bound * y);
            }
        }
        let still = |i: usize| self.slip[i] == [0.0; 2];
        // One contact after another minimises on its own disc, until nothing changes.
        for _ in 0..3000 {
            let mut change = 0.0_f64;
            for i in (0..self.set.count).filter(|i| still(*i)) {
                let bound = self.set.friction[i] * normal[i];
                let before = rates[i];
                (rates[i].x, rates[i].y) = (0.0, 0.0);
                let w = self.response(&rates)[i];
                let q = on_disc(&self.set.operator[i][i], [w.x, w.y], bound);
                (rates[i].x, rates[i].y) = (q[0], q[1]);
                change = change.max((rates[i] - before).norm());
            }
            if self.set.count == 1 || change <= 1e-13 * (1.0 + normal[0] + normal[1]) {
                break;
            }
        }
        self.response(&rates)
    }

    fn response(&self, rates: &[Vec3; 2]) -> [Vec3; 2] {
        std::array::from_fn(|i| {
            (0..self.set.count).fold(self.drive[i], |w, j| w + self.set.operator[i][j] * rates[j])
        })
    }

    /// Normal rates at which contact i does not move along its normal, the other's fixed: a scan of the whole half-axis and bisection.
    fn holding(&self, i: usize, steps: u32, with: impl Fn(f64) -> [f64; 2]) -> Vec<f64> {
        let unit = self.drive[i].norm() / self.set.operator[i][i].rows[2].z;
        let rate = |x: f64| unit * x / (1.0 - x);
        let f = |x: f64| self.motion(with(rate(x)))[i].z;
        let mut found = vec![];
        let mut before = (0.0, f(0.0));
        for k in 1..steps {
            let x = f64::from(k) / f64::from(steps);
            let now = (x, f(x));
            if (before.1 > 0.0) != (now.1 > 0.0) {
                let (mut low, mut high) = (before.0, x);
                for _ in 0..50 {
                    let middle = 0.5 * (low + high);
                    if (f(middle) > 0.0) == (before.1 > 0.0) { low = middle } else { high = middle }
                }
                found.push(rate(0.5 * (low + high)));
            }
            before = now;
        }
        found
    }

    /// All motions that a scan finds.
    fn search(&self, steps: u32) -> Vec<[Vec3; 2]> {
        let mut found: Vec<[f64; 2]> = vec![[0.0; 2]];
        for i in 0..self.set.count {
            let alone = |r: f64| std::array::from_fn(|j| if j == i { r } else { 0.0 });
            found.extend(self.holding(i, steps, alone).into_iter().map(alone));
        }
        if self.set.count == 2 {
            found.extend(self.both(steps));
        }
        let consistent = |normal: &[f64; 2]| {
            let w = self.motion(*normal);
            let largest = w.iter().map(|w| w.norm()).fold(1.0, f64::max);
            let opens = (0..self.set.count)
                .all(|i| if normal[i] > 0.0 { w[i].z.abs() <= SAME * largest } else { w[i].z >= 0.0 });
            opens.then_some(w)
        };
        found.iter().filter_map(consistent).collect()
    }

    /// Normal rates of both contacts: at each of the first one those of the second, and between neighbours where the first one changes sides.
    fn both(&self, steps: u32) -> Vec<[f64; 2]> {
        let unit = self.drive[0].norm() / self.set.operator[0][0].rows[2].z;
        let second = |x: f64| self.holding(1, steps, |r| [unit * x / (1.0 - x), r]);
        let first = |x: f64, r: f64| self.motion([unit * x / (1.0 - x), r])[0].z;
        // A branch of second rates is followed by the nearest.
        let nearest =
            |all: &[f64], r: f64| all.iter().copied().min_by(|a, b| (a - r).abs().total_cmp(&(b - r).abs()));
        let mut out = vec![];
        let step = 1.0 / f64::from(steps);
        let mut before = (1e-9, second(1e-9));
        for k in 1..steps {
            let x = step * f64::from(k);
            let now = (x, second(x));
            for r in &before.1 {
                let Some(near) = nearest(&now.1, *r) else { continue };
                let sign = first(before.0, *r) > 0.0;
                if sign == (first(x, near) > 0.0) {
                    continue;
                }
                let (mut low, mut high) = ((before.0, *r), (x, near));
                for _ in 0..45 {
                    let middle = 0.5 * (low.0 + high.0);
                    let Some(at) = nearest(&second(middle), 0.5 * (low.1 + high.1)) else { break };
                    if (first(middle, at) > 0.0) == sign { low = (middle, at) } else { high = (middle, at) }
                }
                if high.0 - low.0 < 1e-9 {
                    out.push([unit * low.0 / (1.0 - low.0), low.1]);
                }
            }
            before = now;
        }
        out
    }
}

/// The vector on a disc that minimises ½ q·W q + q·w: inside where it can be, else on the edge, found by its multiplier.
fn on_disc(operator: &Mat3, w: [f64; 2], bound: f64) -> [f64; 2] {
    if bound <= 0.0 {
        return [0.0; 2];
    }
    let [a, b, _] = operator.rows;
    let at = |multiplier: f64| {
        let (xx, xy, yy) = (a.x + multiplier, a.y, b.y + multiplier);
        let determinant = xx * yy - xy * xy;
        [(xy * w[1] - yy * w[0]) / determinant, (xy * w[0] - xx * w[1]) / determinant]
    };
    let length = |q: [f64; 2]| (q[0] * q[0] + q[1] * q[1]).sqrt();
    if length(at(0.0)) <= bound {
        return at(0.0);
    }
    let (mut low, mut high) = (0.0, length(w) / bound);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if length(at(middle)) > bound {
            low = middle
        } else {
            high = middle
        }
        if high - low <= 4.0 * f64::EPSILON * high {
            break;
        }
    }
    at(high)
}

fn alike(a: &[Vec3; 2], b: &[Vec3; 2], count: usize) -> bool {
    let largest = a[..count].iter().chain(&b[..count]).map(|v| v.norm()).fold(0.0, f64::max);
    a[..count].iter().zip(b).all(|(a, b)| (*a - *b).norm() <= SAME * (1.0 + largest))
}

/// Compares the kernel with the search: how many answers have no, one and several motions, and how many motions each has that the other has not.
fn compare(cases: std::ops::Range<u32>, count: usize, steps: u32) -> ([usize; 3], [usize; 2], u32) {
    let (mut numbers, mut missing, mut starts) = ([0; 3], [0; 2], 0);
    for case in cases {
        let of = Case::of(case, count);
        let answer = of.problem().solve();
        numbers[answer.count.min(2)] += 1;
        starts += answer
            .iter()
            .map(|s| s.guess.iter().filter(|g| g.mode == Mode::Starts).count() as u32)
            .sum::<u32>();
        for solution in answer.iter() {
            // Its normal rates bring about its motion, whatever its hypothesis was.
            let w = of.motion(std::array::from_fn(|i| solution.rates[i].z));
            assert!(alike(&w, &solution.response, count), "case {case}: {solution:?} moves {w:?}");
            for i in 0..count {
                let r = solution.rates[i].z;
                assert!(
                    r >= 0.0 && (r == 0.0 || w[i].z.abs() < SAME * (1.0 + r)),
                    "case {case}: {solution:?} {w:?}"
                );
            }
        }
        let found = of.search(steps);
        for w in &found {
            if !answer.iter().any(|s| alike(w, &s.response, count)) {
                println!("case {case}, {count} contacts: the search finds {w:?} besides {answer:?}");
                missing[0] += 1;
            }
        }
        missing[1] += answer.iter().filter(|s| !found.iter().any(|w| alike(w, &s.response, count))).count();
    }
    (numbers, missing, starts)
}

#[test]
fn one_contact_has_the_motions_that_a_search_finds() {
    let (numbers, missing, starts) = compare(0..10_000, 1, 600);
    println!(
        "10000 contacts: {numbers:?} have no, one, several motions; {starts} start to slip; {missing:?} found by one alone"
    );
    assert_eq!(missing, [0; 2]);
    assert!(numbers[0] > 50 && numbers[2] >= 5 && starts > 1000, "{numbers:?} {starts}");
}

#[test]
fn two_contacts_have_the_motions_that_a_search_finds() {
    let (numbers, missing, starts) = compare(20_000..20_200, 2, 24);
    println!(
        "200 pairs: {numbers:?} have no, one, several motions; {starts} start to slip; {missing:?} found by one alone"
    );
    assert_eq!(missing[0], 0);
}

#[test]
fn every_rejected_hypothesis_names_its_inequality() {
    // A block of 1 kg on an incline of 3 in 4 that holds: it can neither fly off nor slide, in whatever direction.
    let block = [[Mat3::IDENTITY]];
    let problem = RateProblem::<1> {
        count: 1,
        operator: &block,
        friction: &[0.8],
        drive: [Vec3::new(3.6, 4.8, -8.0)],
        slip: [[0.0; 2]],
        load: [Load::Touching(0.0)],
    };
    let mut rejected = vec![];
    let answer = problem
        .solve_observed(&mut |guess, condition, slack| rejected.push((guess[0].mode, condition, slack)));
    assert_eq!(answer.count, 1);
    let named: Vec<_> = rejected.iter().map(|(mode, condition, _)| (*mode, *condition)).collect();
    assert_eq!(named, [(Mode::Open, Condition::Opens(0)), (Mode::Starts, Condition::Starts(0))]);
    // Friction of 0.8 · 8 N against 6 N downhill would start a slip of −0.4 m/s² of 12.4.
    assert!((rejected[1].2 + 0.4 / 12.4).abs() < 0.01, "{rejected:?}");
}
