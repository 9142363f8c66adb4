//! What one impact costs: at one contact, a mix of all types under all laws, at two contacts, a box that lands on its
//! second corner; every end state of four; and bodies in space that fall on one, two and four supports.

use carom_impact::Law;
use carom_impact::planar::{ContactSet2, ContactSet6, Touch, end_states, single, staged};
use carom_impact::spatial;
use carom_num::{Mat3, Vec2, Vec3};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;

/// Impacts of one timed pass.
const PASS: usize = 1000;
const LAWS: [Law; 3] = [Law::Poisson, Law::Stronge, Law::Newton];

/// The i-th point of the golden-ratio sequence in [0, 1): evenly spread, and the same in every run.
fn spread(i: usize) -> f64 {
    (i as f64 * 0.618_033_988_749_894_9).fract()
}

/// Contacts of a free body of 1 kg.
fn contacts() -> Vec<single::Contact> {
    let contact = |i: usize| {
        let [t, n] = [7, 11].map(|k| 2.0 * spread(k * i + 1) - 1.0);
        let inertia = 0.05 + spread(13 * i);
        single::Contact {
            w_tt: 1.0 + n * n / inertia,
            w_tn: -t * n / inertia,
            w_nn: 1.0 + t * t / inertia,
            slip: if i.is_multiple_of(10) { 0.0 } else { 4.0 * spread(17 * i) - 2.0 },
            normal: -0.1 - spread(19 * i),
            friction: 1.5 * spread(23 * i),
            restitution: spread(29 * i),
        }
    };
    (0..PASS).map(contact).collect()
}

/// Landings of a box: one lower corner touches, the other closes.
fn landings() -> Vec<ContactSet2> {
    let landing = |i: usize| {
        let (friction, restitution) = (0.8 * spread(7 * i + 1), 0.9 * spread(11 * i));
        let corners = [-0.5, 0.5].map(|x| Touch {
            arm: Vec2::new(x, -0.2 - 0.5 * spread(13 * i)),
            normal: Vec2::new(0.0, 1.0),
            friction,
            restitution,
        });
        let spin = -0.5 - spread(17 * i);
        let velocity = Vec2::new(2.0 * spread(19 * i) - 1.0, 0.5 * spin);
        let set = ContactSet2::of_free_body(1.0, 0.1, velocity, spin, &corners);
        set.map(|mut set| {
            set.snap(1e-14);
            set
        })
    };
    (0..PASS).filter_map(|i| landing(i).ok()).collect()
}

fn time_single(c: &mut Criterion) {
    let contacts = contacts();
    let mut group = c.benchmark_group("one contact");
    group.throughput(Throughput::Elements(PASS as u64));
    group.bench_function("mixed types and laws", |b| {
        b.iter(|| {
            let resolve = |(i, contact)| single::resolve(black_box(contact), LAWS[i % 3]);
            contacts.iter().enumerate().filter_map(|x| resolve(x).ok()).map(|out| out.normal).sum::<f64>()
        })
    });
    group.finish();
}

fn time_two(c: &mut Criterion) {
    let landings = landings();
    let mut group = c.benchmark_group("two contacts");
    group.throughput(Throughput::Elements(PASS as u64));
    group.bench_function("landings of a box", |b| {
        b.iter(|| {
            let resolve = |set| staged::resolve(black_box(set), Law::Poisson);
            landings.iter().filter_map(|set| resolve(set).ok()).map(|out| out.velocity[1][1]).sum::<f64>()
        })
    });
    group.finish();
}

/// A body that is touched at four places at once.
fn fours(restitution: f64) -> Vec<ContactSet6> {
    let touch = |i: usize| {
        let normal = Vec2::at_angle(std::f64::consts::TAU * spread(5 * i + 1));
        let aside = Vec2::new(spread(7 * i) - 0.5, spread(11 * i) - 0.5);
        Touch { arm: aside - normal * spread(13 * i), normal, friction: spread(17 * i), restitution }
    };
    let set = |i: usize| {
        let touches: Vec<Touch> = (4 * i..4 * i + 4).map(touch).collect();
        let velocity = Vec2::new(spread(23 * i) - 0.5, spread(29 * i) - 0.5);
        ContactSet6::of_free_body(1.0, 0.1 + 0.5 * spread(i), velocity, 2.0 * spread(31 * i) - 1.0, &touches)
    };
    (0..50).filter_map(|i| set(i).ok()).collect()
}

fn time_end_states(c: &mut Criterion) {
    let mut group = c.benchmark_group("every end state of four contacts");
    for (name, restitution) in [("plastic", 0.0), ("with restitution", 0.5)] {
        let sets = fours(restitution);
        group.throughput(Throughput::Elements(sets.len() as u64));
        group.bench_function(name, |b| {
            b.iter(|| {
                let count = |set| end_states::found(black_box(set), Law::Poisson).len();
                sets.iter().map(count).sum::<usize>()
            })
        });
        group.bench_function(format!("{name}, and why no other"), |b| {
            b.iter(|| {
                let count = |set| end_states::enumerate(black_box(set), Law::Poisson).rejected.len();
                sets.iter().map(count).sum::<usize>()
            })
        });
    }
    group.finish();
}

/// Bodies in space that fall on so many supports, every one of which slips at first and may turn.
fn falls<const N: usize>() -> Vec<spatial::ContactSet<N>> {
    let fall = |i: usize| {
        let side = |k: usize| 2.0 * spread(k * i + 1) - 1.0;
        let body = spatial::RigidBody {
            mass: 1.0,
            inertia: Mat3::diagonal(0.2 + 0.1 * spread(3 * i), 0.2, 0.2 + 0.1 * spread(5 * i)),
            velocity: Vec3::new(side(7), side(11), -1.0 - spread(13 * i)),
            spin: Vec3::new(0.0, 0.0, 4.0 * side(17)),
        };
        let touch = |k: usize| spatial::Touch {
            arm: Vec3::new(
                if k.is_multiple_of(2) { -0.5 } else { 0.5 },
                if k < 2 { -0.4 } else { 0.4 },
                -0.3,
            ),
            normal: Vec3::Z,
            friction: 0.8 * spread(19 * i),
            restitution: 0.5,
        };
        let touches: Vec<_> = (0..N).map(touch).collect();
        spatial::ContactSet::of_free_body(&body, &touches)
    };
    (0..PASS / 10).filter_map(|i| fall(i).ok()).collect()
}

/// Plates of N corners that tip over one edge and fall flat on all of them: each starts to slip from rest.
fn tips<const N: usize>() -> Vec<spatial::ContactSet<N>> {
    let tip = |i: usize| {
        let corner = |k: usize| {
            let (sin, cos) = carom_num::elementary::sin_cos(std::f64::consts::TAU * (k as f64) / N as f64);
            Vec3::new(cos, sin, -0.2 - 0.3 * spread(7 * i))
        };
        let spin = (corner(0) - corner(1)) * (0.5 + spread(11 * i));
        let body = spatial::RigidBody {
            mass: 1.0,
            inertia: Mat3::diagonal(0.2 + 0.1 * spread(3 * i), 0.3, 0.4),
            velocity: corner(0).cross(spin),
            spin,
        };
        let (normal, friction) = (Vec3::Z, 0.05 + 0.5 * spread(19 * i));
        let touch = |k: usize| spatial::Touch { arm: corner(k), normal, friction, restitution: 0.5 };
        let touches: Vec<_> = (0..N).map(touch).collect();
        spatial::ContactSet::of_free_body(&body, &touches)
    };
    (0..PASS / 100).filter_map(|i| tip(i).ok()).collect()
}

/// Walks through impacts in space; the longer they take, the fewer samples.
fn time_walks<const N: usize>(
    c: &mut Criterion,
    (name, samples): (&str, usize),
    sets: &[spatial::ContactSet<N>],
) {
    let mut group = c.benchmark_group("in space, with friction");
    group.throughput(Throughput::Elements(sets.len() as u64)).sample_size(samples);
    group.bench_function(name, |b| {
        b.iter(|| {
            let resolve = |set| spatial::staged::resolve(black_box(set), Law::Poisson);
            sets.iter().filter_map(|set| resolve(set).ok()).map(|out| out.velocity[0].z).sum::<f64>()
        })
    });
    group.finish();
}

fn time_space(c: &mut Criterion) {
    time_walks(c, ("1 contacts", 100), &falls::<1>());
    time_walks(c, ("2 contacts", 100), &falls::<2>());
    time_walks(c, ("4 contacts", 100), &falls::<4>());
    time_walks(c, ("6 contacts of a face, from rest", 10), &tips::<6>());
    time_walks(c, ("12 contacts of a face, from rest", 10), &tips::<12>());
}

criterion_group!(benches, time_single, time_two, time_end_states, time_space);
criterion_main!(benches);
