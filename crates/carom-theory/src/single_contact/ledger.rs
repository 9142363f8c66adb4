//! Velocities after an impact and the works of its impulses, leg by leg.

use super::classify::{Legs, Numbers};
use super::contact::{Contact, Impact, ImpactType, Law, Work};
use super::{poisson, stronge};

/// A contact that transmits nothing.
pub(super) fn nothing(contact: &Contact, law: Law, numbers: Numbers) -> Impact {
    Impact {
        law,
        kind: None,
        tangential_impulse: 0.0,
        normal_impulse: 0.0,
        compression_impulse: 0.0,
        slip_stop_impulse: None,
        slip_after: contact.slip,
        normal_velocity_after: contact.approach,
        work: Work::default(),
        numbers,
    }
}

/// The impact of the type in `numbers`, given its normal impulse and that of its compression.
pub(super) fn close(legs: &Legs, law: Law, numbers: Numbers, compression: f64, normal: f64) -> Impact {
    let Some(kind) = numbers.kind else {
        return nothing(&legs.contact, law, numbers);
    };
    let stop = stops(kind).then(|| legs.slip_stop());
    let slip_speed = slip_speed_after(legs, kind, normal);
    let rising = normal_velocity_after(legs, law, kind, compression, normal);
    Impact {
        law,
        kind: Some(kind),
        tangential_impulse: poisson::tangential_impulse(legs, kind, normal),
        normal_impulse: normal,
        compression_impulse: compression,
        slip_stop_impulse: stop,
        slip_after: slip_direction_after(legs, kind) * slip_speed,
        normal_velocity_after: rising,
        work: Work {
            compression: compression_work(legs, kind, compression),
            restitution: restitution_work(legs, kind, rising, normal - compression),
            tangential: tangential_work(legs, kind, normal, slip_speed),
        },
        numbers,
    }
}

fn stops(kind: ImpactType) -> bool {
    kind >= ImpactType::ReversesInRestitution
}

fn stops_in_compression(kind: ImpactType) -> bool {
    matches!(kind, ImpactType::ReversesInCompression | ImpactType::StopsInCompression)
}

fn stops_in_restitution(kind: ImpactType) -> bool {
    matches!(kind, ImpactType::ReversesInRestitution | ImpactType::StopsInRestitution)
}

fn slip_direction_after(legs: &Legs, kind: ImpactType) -> f64 {
    match kind {
        ImpactType::SlidesThroughout => legs.s,
        ImpactType::SlipsFromRest => -legs.b3.signum(),
        _ => -legs.s,
    }
}

fn slip_speed_after(legs: &Legs, kind: ImpactType, normal: f64) -> f64 {
    match kind {
        ImpactType::SlidesThroughout => (legs.slip - legs.k * normal).max(0.0),
        ImpactType::SlipsFromRest => -legs.cone() * normal,
        kind if kind.sticks() => 0.0,
        _ => (-legs.cone() * (normal - legs.slip_stop())).max(0.0),
    }
}

fn normal_velocity_after(legs: &Legs, law: Law, kind: ImpactType, compression: f64, normal: f64) -> f64 {
    match law {
        Law::Newton => legs.contact.restitution * legs.closing,
        Law::Stronge => stronge::final_normal_velocity(legs, kind),
        Law::Poisson if stops_in_restitution(kind) => {
            legs.normal_velocity_at_stop() + legs.last_response(kind) * (normal - legs.slip_stop())
        }
        Law::Poisson if stops_in_compression(kind) => {
            legs.last_response(kind) * (legs.contact.restitution * compression)
        }
        Law::Poisson => legs.contact.restitution * legs.closing,
    }
}

fn compression_work(legs: &Legs, kind: ImpactType, compression: f64) -> f64 {
    if stops_in_compression(kind) {
        let (stop, at_stop) = (legs.slip_stop(), legs.normal_velocity_at_stop().abs());
        let second = at_stop * at_stop / legs.last_response(kind);
        -0.5 * ((legs.closing + at_stop) * stop + second)
    } else {
        -0.5 * legs.closing * compression
    }
}

fn restitution_work(legs: &Legs, kind: ImpactType, rising: f64, returned: f64) -> f64 {
    if stops_in_restitution(kind) {
        let at_stop = legs.normal_velocity_at_stop();
        let second = (rising - at_stop) * (rising + at_stop) / legs.last_response(kind);
        0.5 * (at_stop * at_stop / legs.a1 + second)
    } else {
        0.5 * rising * returned
    }
}

fn tangential_work(legs: &Legs, kind: ImpactType, normal: f64, slip_speed: f64) -> f64 {
    let mu = legs.contact.friction;
    if stops(kind) {
        let stop = legs.slip_stop();
        -0.5 * mu * (legs.slip * stop + slip_speed * (normal - stop))
    } else {
        -0.5 * mu * (legs.slip + slip_speed) * normal
    }
}
