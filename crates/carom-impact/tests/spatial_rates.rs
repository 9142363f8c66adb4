//! The rate problem in space against a search that knows no hypotheses.
//!
//! For given normal rates friction minimises a convex function over discs, so the motion is unique: what is left are the normal rates, and these are
//! scanned. The kernel guesses what each contact does and solves for directions instead.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test fails by panicking, and says what it measured"
)]

use crate::random;

use carom_impact::Load;
use carom_impact::spatial::{Condition, ContactSet, Mode, RateProblem, RigidBody, Solution, Touch};
use carom_num::solve::solve_any;
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

    /// The motion with these normal rates; the search for friction begins with `guess`, and leaves what it finds there.
    fn motion(&self, normal: [f64; 2], guess: &mut [[f64; 2]; 2]) -> [Vec3; 2] {
        let mut rates = normal.map(|r| Vec3::Z * r);
        for i in 0..self.set.count {
            let [x, y] = self.slip[i];
            let length = (x * x + y * y).sqrt();
            if length > 0.0 {
                let bound = self.set.friction[i] * normal[i] / length;
                (rates[i].x, rates[i].y) = (-bound * x, -bound * y);
            } else {
                (rates[i].x, rates[i].y) = (guess[i][0], guess[i][1]);
            }
        }
        let still = |i: usize| self.slip[i] == [0.0; 2];
        // One contact after another minimises on its own disc, until nothing changes.
        for sweep in 0..3000 {
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
            // Where they hold each other that is slow.
            if sweep % 8 == 7
                && let Some(better) = self.newton(&rates)
            {
                rates = better;
                break;
            }
        }
        *guess = rates.map(|p| [p.x, p.y]);
        self.response(&rates)
    }

    /// Newton's method for what each contact at rest does now: inside of its disc its response vanishes, on the rim it is along its friction. `None` where
    /// that is not what comes out.
    fn newton(&self, near: &[Vec3; 2]) -> Option<[Vec3; 2]> {
        let bound = |i: usize| self.set.friction[i] * near[i].z;
        let size = |p: Vec3| (p.x * p.x + p.y * p.y).sqrt();
        let still: Vec<usize> = (0..2).filter(|i| self.slip[*i] == [0.0; 2] && bound(*i) > 0.0).collect();
        let rim = |i: usize| size(near[i]) >= bound(i) * (1.0 - 1e-9);
        let mut rates = *near;
        for _ in 0..20 {
            // Unknowns: a vector inside, a turn on the rim.
            let w = self.response(&rates);
            let (mut columns, mut residual): (Vec<(usize, Vec3)>, Vec<f64>) = (vec![], vec![]);
            for i in &still {
                let p = rates[*i];
                if rim(*i) {
                    columns.push((*i, Vec3::new(-p.y, p.x, 0.0)));
                    residual.push(p.x * w[*i].y - p.y * w[*i].x);
                } else {
                    columns.extend([(*i, Vec3::X), (*i, Vec3::Y)]);
                    residual.extend([w[*i].x, w[*i].y]);
                }
            }
            let n = columns.len();
            let (mut matrix, mut right) = ([[0.0; 4]; 4], [0.0; 4]);
            for (k, (j, d)) in columns.iter().enumerate() {
                let mut row = 0;
                for i in &still {
                    let (by, p) = (self.set.operator[*i][*j] * *d, rates[*i]);
                    if rim(*i) {
                        let turned = if i == j { d.x * w[*i].y - d.y * w[*i].x } else { 0.0 };
                        matrix[row][k] = p.x * by.y - p.y * by.x + turned;
                        row += 1;
                    } else {
                        (matrix[row][k], matrix[row + 1][k]) = (by.x, by.y);
                        row += 2;
                    }
                }
            }
            right[..n].iter_mut().zip(&residual).for_each(|(r, f)| *r = -f);
            let step = solve_any(matrix, right, n, 1e-12)?.point;
            let mut change = 0.0_f64;
            for ((i, d), x) in columns.iter().zip(step) {
                if rim(*i) {
                    let (sin, cos) = carom_num::elementary::sin_cos(x);
                    rates[*i] = Vec3::new(
                        cos * rates[*i].x - sin * rates[*i].y,
                        sin * rates[*i].x + cos * rates[*i].y,
                        rates[*i].z,
                    );
                } else {
                    rates[*i] += *d * x;
                }
                change = change.max(x.abs());
            }
            if change <= 1e-14 {
                let w = self.response(&rates);
                let holds = |i: &usize| {
                    let (p, w) = (rates[*i], w[*i]);
                    if rim(*i) { p.x * w.x + p.y * w.y <= 0.0 } else { size(p) <= bound(*i) }
                };
                return still.iter().all(holds).then_some(rates);
            }
        }
        None
    }

    fn response(&self, rates: &[Vec3; 2]) -> [Vec3; 2] {
        std::array::from_fn(|i| {
            (0..self.set.count).fold(self.drive[i], |w, j| w + self.set.operator[i][j] * rates[j])
        })
    }

    /// Normal rates at which contact i does not move along its normal, the other's fixed: a scan of the whole half-axis, and false position.
    fn holding(&self, i: usize, steps: u32, with: impl Fn(f64) -> [f64; 2]) -> Vec<f64> {
        let unit = self.drive[i].norm() / self.set.operator[i][i].rows[2].z;
        let rate = |x: f64| unit * x / (1.0 - x);
        let mut guess = [[0.0; 2]; 2];
        let mut f = |x: f64| self.motion(with(rate(x)), &mut guess)[i].z;
        let mut found = vec![];
        let mut before = (0.0, f(0.0));
        for k in 1..steps {
            let x = f64::from(k) / f64::from(steps);
            let now = (x, f(x));
            if (before.1 > 0.0) != (now.1 > 0.0) {
                found.push(rate(root(before, now, &mut f)));
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
            let w = self.motion(*normal, &mut [[0.0; 2]; 2]);
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
        let rate = |x: f64| unit * x / (1.0 - x);
        // Where the second contact separates by itself, it takes nothing: a branch ends there.
        let second = |x: f64| {
            let mut all = self.holding(1, steps, |r| [rate(x), r]);
            let parts = self.motion([rate(x), 0.0], &mut [[0.0; 2]; 2])[1].z >= 0.0;
            all.extend(parts.then_some(0.0));
            all
        };
        // A branch of second rates is followed by the nearest.
        let nearest =
            |all: &[f64], r: f64| all.iter().copied().min_by(|a, b| (a - r).abs().total_cmp(&(b - r).abs()));
        let mut guess = [[0.0; 2]; 2];
        let mut first = |x: f64, r: f64| self.motion([rate(x), r], &mut guess)[0].z;
        let mut out = vec![];
        let step = 1.0 / f64::from(steps);
        let mut before = (1e-9, second(1e-9));
        for k in 1..steps {
            let x = step * f64::from(k);
            let now = (x, second(x));
            // Branches begin and end: each end is followed to the nearest other one.
            let onwards = before.1.iter().filter_map(|r| Some([*r, nearest(&now.1, *r)?]));
            let back = now.1.iter().filter_map(|r| Some([nearest(&before.1, *r)?, *r]));
            for [r, near] in onwards.chain(back) {
                let (at_low, at_high) = (first(before.0, r), first(x, near));
                if (at_low > 0.0) == (at_high > 0.0) {
                    continue;
                }
                let (mut last, mut lost) = (r, false);
                let between = root((before.0, at_low), (x, at_high), &mut |middle| {
                    let share = (middle - before.0) / (x - before.0);
                    let likely = r + share * (near - r);
                    let of = self.near(rate(middle), likely).or_else(|| nearest(&second(middle), likely));
                    lost |= of.is_none();
                    last = of.unwrap_or(last);
                    first(middle, last)
                });
                if !lost {
                    out.push([rate(between), self.near(rate(between), last).unwrap_or(last)]);
                }
            }
            out.extend(self.arcs(&now, before.0, rate));
            out.extend(self.arcs(&before, now.0, rate));
            before = now;
        }
        out
    }

    /// Where two branches of second rates join before the next place: the arc between them is walked over the second rate.
    fn arcs(&self, (x, all): &(f64, Vec<f64>), towards: f64, rate: impl Fn(f64) -> f64) -> Vec<[f64; 2]> {
        let mut sorted = all.clone();
        sorted.sort_by(f64::total_cmp);
        let mut out = vec![];
        for pair in sorted.windows(2) {
            let mut guess = [[0.0; 2]; 2];
            let mut at = |x: f64, r: f64| self.motion([rate(x), r], &mut guess);
            let middle = 0.5 * (pair[0] + pair[1]);
            let firsts = [0, 1].map(|k| at(*x, pair[k])[0].z);
            let joins = (at(*x, middle)[1].z > 0.0) != (at(towards, middle)[1].z > 0.0);
            if !joins || (firsts[0] > 0.0) == (firsts[1] > 0.0) {
                continue;
            }
            let mut arc = |r: f64| {
                let ends = [*x, towards].map(|x| (x, at(x, r)[1].z));
                if (ends[0].1 > 0.0) == (ends[1].1 > 0.0) {
                    // At its feet the arc is where it starts, but for rounding.
                    return *x;
                }
                root(ends[0], ends[1], &mut |x| at(x, r)[1].z)
            };
            let mut guess = [[0.0; 2]; 2];
            let r = root((pair[0], firsts[0]), (pair[1], firsts[1]), &mut |r| {
                self.motion([rate(arc(r)), r], &mut guess)[0].z
            });
            out.push([rate(arc(r)), r]);
        }
        out
    }

    /// The second rate next to a likely one at which the second contact does not move along its normal, by the secant.
    fn near(&self, first: f64, likely: f64) -> Option<f64> {
        let mut guess = [[0.0; 2]; 2];
        let mut f = |r: f64| self.motion([first, r], &mut guess)[1].z;
        let (mut a, mut b) = (likely, likely * (1.0 + 1e-4) + 1e-12);
        let (mut at_a, mut at_b) = (f(a), f(b));
        for _ in 0..12 {
            let next = b - at_b * (b - a) / (at_b - at_a);
            // Far from where it was thought to be it may be another one.
            if !(next >= 0.0 && (next - likely).abs() <= 0.2 * likely) {
                return None;
            }
            (a, at_a, b) = (b, at_b, next);
            at_b = f(b);
            if (b - a).abs() <= 1e-13 * (1.0 + b) || at_b == 0.0 {
                return Some(b);
            }
        }
        None
    }
}

/// The root of a continuous function between two places where its signs differ: false position, the end that stays taken for half.
fn root(low: (f64, f64), high: (f64, f64), f: &mut impl FnMut(f64) -> f64) -> f64 {
    let ((mut a, mut at_a), (mut b, mut at_b)) = (low, high);
    for _ in 0..60 {
        let c = (a * at_b - b * at_a) / (at_b - at_a);
        let c = if c > a.min(b) && c < a.max(b) { c } else { 0.5 * (a + b) };
        let at_c = f(c);
        if at_c == 0.0 {
            return c;
        }
        if (at_c > 0.0) == (at_b > 0.0) {
            at_a *= 0.5
        } else {
            (a, at_a) = (b, at_b)
        }
        (b, at_b) = (c, at_c);
        if (b - a).abs() <= 1e-14 || at_c.abs() <= 1e-15 * (low.1 - high.1).abs() {
            return b;
        }
    }
    b
}

/// The vector on a disc that minimises ½ q·W q + q·w: inside where it can be, else on the edge, found by its multiplier λ: q = −(W + λ)⁻¹ w. Newton's
/// method on 1/|q| comes up to it from zero.
fn on_disc(operator: &Mat3, w: [f64; 2], bound: f64) -> [f64; 2] {
    if bound <= 0.0 {
        return [0.0; 2];
    }
    let [a, b, _] = operator.rows;
    let solved = |multiplier: f64, v: [f64; 2]| {
        let (xx, xy, yy) = (a.x + multiplier, a.y, b.y + multiplier);
        let determinant = xx * yy - xy * xy;
        [(yy * v[0] - xy * v[1]) / determinant, (xx * v[1] - xy * v[0]) / determinant]
    };
    let mut multiplier = 0.0;
    for _ in 0..60 {
        let q = solved(multiplier, w).map(|x| -x);
        let square = q[0] * q[0] + q[1] * q[1];
        let length = square.sqrt();
        if length <= bound * (1.0 + 4.0 * f64::EPSILON) {
            return q;
        }
        let slope = solved(multiplier, q);
        let more = (length - bound) / bound * square / (q[0] * slope[0] + q[1] * slope[1]);
        if more <= f64::EPSILON * multiplier {
            return q.map(|x| x * bound / length);
        }
        multiplier += more;
    }
    solved(multiplier, w).map(|x| -x)
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
            let w = of.motion(std::array::from_fn(|i| solution.rates[i].z), &mut [[0.0; 2]; 2]);
            assert!(alike(&w, &solution.response, count), "case {case}: {solution:?} moves {w:?}");
            for i in 0..count {
                let r = solution.rates[i].z;
                assert!(
                    r >= 0.0 && (r == 0.0 || w[i].z.abs() < SAME * (1.0 + r)),
                    "case {case}: {solution:?} {w:?}"
                );
            }
        }
        let mut by_scan = [vec![], vec![]];
        for finer in [1, 4, 16] {
            let found = of.search(finer * steps);
            let unknown = |w: &&[Vec3; 2]| !answer.iter().any(|s| alike(w, &s.response, count));
            let unseen = |s: &&Solution<2>| !found.iter().any(|w| alike(w, &s.response, count));
            by_scan = [
                found.iter().filter(unknown).map(|w| format!("{w:?}")).collect(),
                answer.iter().filter(unseen).map(|s| format!("{s:?}")).collect(),
            ];
            // What the kernel knows and the scan does not see may lie between its steps.
            if by_scan[1].is_empty() {
                break;
            }
        }
        for (k, list) in by_scan.iter().enumerate() {
            for motion in list {
                let who = ["the search", "the kernel"][k];
                println!("case {case}, {count} contacts: {who} alone finds {motion}");
            }
            missing[k] += list.len();
        }
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

/// As many pairs as `CAROM_PAIRS` says: `CAROM_PAIRS=10000 cargo test -p carom-impact --test all spatial_rates:: -- --nocapture` takes a minute.
fn pairs() -> u32 {
    std::env::var("CAROM_PAIRS").ok().and_then(|pairs| pairs.parse().ok()).unwrap_or(1000)
}

#[test]
fn two_contacts_have_the_motions_that_a_search_finds() {
    let pairs = pairs();
    let (numbers, missing, starts) = compare(20_000..20_000 + pairs, 2, 24);
    println!(
        "{pairs} pairs: {numbers:?} have no, one, several motions; {starts} start to slip; {missing:?} found by one alone"
    );
    assert_eq!(missing[0], 0, "the kernel finds every motion that the search finds");
    // Of the kernel's motions each was confirmed by friction's minimum; the scan does not see those on the narrowest folds.
    assert!(missing[1] as u32 * 500 <= pairs, "{missing:?}");
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
