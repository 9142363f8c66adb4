//! What is watched during an impact and falls below zero and rises again within one step: both ends of the step see nothing.

use carom_impact::Law;
use carom_impact::planar::{self, Block, stiffness::by_stiffness};
use carom_impact::spatial::{Contact, ContactSet, Outcome, Preference, StageEvent, staged};
use carom_num::elementary::{cos, sin};
use carom_num::{Mat3, Vec3};

/// How deep a dip is, as a fraction of what it is of. The slips of the tests are integrated to about 1e-12.
const DEPTHS: [f64; 4] = [1e-2, 1e-4, 1e-6, 1e-8];

/// The impulse per normal impulse of a contact that slips with this velocity.
fn pushed(slip: [f64; 2], friction: f64) -> Vec3 {
    let speed = (slip[0] * slip[0] + slip[1] * slip[1]).sqrt();
    Vec3::new(-friction * slip[0] / speed, -friction * slip[1] / speed, 1.0)
}

/// The largest rise along a normal while a contact slips in this way from this velocity: small steps of the classical method, down to a slip of a
/// thousandth. `normal` is the response of the normal in question to its impulse.
fn largest_rise(operator: &Mat3, friction: f64, slip: [f64; 2], normal: Vec3) -> f64 {
    let rate = |[x, y, _]: [f64; 3]| {
        let impulse = pushed([x, y], friction);
        let u = *operator * impulse;
        [u.x, u.y, normal.dot(impulse)]
    };
    let after = |y: [f64; 3], f: [f64; 3], h: f64| std::array::from_fn(|i| y[i] + h * f[i]);
    let (mut y, mut largest) = ([slip[0], slip[1], 0.0], 0.0_f64);
    let first = (slip[0] * slip[0] + slip[1] * slip[1]).sqrt();
    loop {
        let speed = (y[0] * y[0] + y[1] * y[1]).sqrt();
        if speed < 1e-3 * first {
            return largest;
        }
        let step = 1e-4 * speed;
        let a = rate(y);
        let b = rate(after(y, a, 0.5 * step));
        let c = rate(after(y, b, 0.5 * step));
        let d = rate(after(y, c, step));
        y = std::array::from_fn(|i| y[i] + step * (a[i] + 2.0 * (b[i] + c[i]) + d[i]) / 6.0);
        largest = largest.max(y[2]);
    }
}

/// The end of compression, of one contact: as its slip turns, friction first lifts it and then drives it in again.
#[test]
fn compression_ends_at_the_first_of_two_crossings() {
    let (w, friction, slip) = (1.5, 0.8, [-1.0, 0.3]);
    let operator = Mat3 { rows: [Vec3::new(3.5, 0.0, w), Vec3::new(0.0, 3.5, 0.0), Vec3::new(w, 0.0, 1.0)] };
    let rise = largest_rise(&operator, friction, slip, operator.rows[2]);
    let ends = |depth: f64| -> Outcome {
        let velocity = Vec3::new(slip[0], slip[1], -rise * (1.0 - depth));
        Contact { operator, velocity, friction, restitution: 0.0 }.resolve(Law::Newton).unwrap()
    };
    for depth in DEPTHS {
        let (above, below) = (ends(depth), ends(-depth));
        let slips = |out: &Outcome| Vec3::new(out.velocity.x, out.velocity.y, 0.0).norm();
        assert!(slips(&above) > 1e-3, "{depth:e}: it has come to rest along the normal: {above:?}");
        assert!(slips(&below) < 1e-9, "{depth:e}: it is driven in until it sticks: {below:?}");
    }
}

/// Another contact that comes down, and goes up again, as the slip of the first one turns.
#[test]
fn an_open_contact_that_another_pulls_down_for_a_moment_closes() {
    let (friction, slip) = (0.4, [-1.0, 0.4]);
    let own = Mat3 { rows: [Vec3::new(3.5, 0.0, 0.5), Vec3::new(0.0, 3.5, 0.0), Vec3::new(0.5, 0.0, 1.0)] };
    // The other's velocity along its normal, to the impulse of the first: down while that slips to the left.
    let pull = Vec3::new(-1.0, 0.0, -0.1);
    let across = Mat3 { rows: [Vec3::ZERO, Vec3::ZERO, pull] };
    let fall = largest_rise(&own, friction, slip, -pull);
    let closes = |depth: f64| {
        let set = ContactSet::<2> {
            count: 2,
            frame: [Mat3::IDENTITY; 2],
            velocity: [Vec3::new(slip[0], slip[1], -5.0), Vec3::Z * (fall * (1.0 - depth))],
            operator: [[own, across.transposed()], [across, Mat3::diagonal(9.0, 9.0, 4.0)]],
            friction: [friction; 2],
            restitution: [0.0; 2],
        };
        let mut closed = false;
        let preference = Preference::MostOpen;
        staged::resolve_observed(&set, Law::Poisson, preference, &mut |stage| {
            closed |= stage.ended_by == StageEvent::Closes(1);
        })
        .unwrap();
        closed
    };
    for depth in DEPTHS {
        assert!(closes(depth) && !closes(-depth), "{depth:e}");
    }
}

/// A contact between two springs: the stiff one pushes it down, the soft one up again.
#[test]
fn a_contact_that_springs_press_down_for_a_moment_takes_an_impulse() {
    let (down, up, soft) = (0.5, 0.6, 0.5_f64);
    // Both strike with 1 m/s; the impulse of each is 1 − cos ωt.
    let fallen = |t: f64| down * (1.0 - cos(t)) - up * (1.0 - cos(soft.sqrt() * t));
    let rate = |t: f64| down * sin(t) - up * soft.sqrt() * sin(soft.sqrt() * t);
    let (mut low, mut high) = (0.1, 3.0);
    while high - low > 1e-15 {
        let middle = 0.5 * (low + high);
        if rate(middle) > 0.0 { low = middle } else { high = middle }
    }
    let fall = fallen(low);
    assert!(rate(0.1) > 0.0 && rate(3.0) < 0.0 && fall > 0.01, "{fall}");
    let block = |nn: f64| Block { tt: 1.0, tn: 0.0, nt: 0.0, nn };
    let none = Block { tt: 0.0, tn: 0.0, nt: 0.0, nn: 0.0 };
    let beside = |nn: f64| Block { nn, ..none };
    let presses = |depth: f64| {
        let set = planar::ContactSet::<3, 6> {
            count: 3,
            operator: [
                [block(1.0), beside(-down), beside(up)],
                [beside(-down), block(1.0), none],
                [beside(up), none, block(1.0)],
            ],
            slip: [0.0; 3],
            normal: [fall * (1.0 - depth), -1.0, -1.0],
            friction: [0.0; 3],
            restitution: [1.0; 3],
        };
        by_stiffness(&set, &[1.0, 1.0, soft], 1.0).unwrap().impulse[0][1] > 0.0
    };
    for depth in DEPTHS {
        assert!(presses(depth) && !presses(-depth), "{depth:e}");
    }
}
