//! What no impact can be computed from is refused with its name, wherever it comes in; nothing panics and nothing is NaN.

use carom_impact::Law;
use carom_impact::planar::{ContactSet2, Meeting, RigidBody, Touch, single, struck};
use carom_num::Vec2;

fn ball() -> RigidBody {
    RigidBody { mass: 1.0, inertia: 1.0, velocity: Vec2::new(3.0, 0.0), ..RigidBody::FIXED }
}

fn meeting() -> Meeting {
    let (point, normal) = (Vec2::new(1.0, 0.0), Vec2::new(1.0, 0.0));
    Meeting { into: 1, out_of: 0, point, normal, friction: 0.0, restitution: 1.0 }
}

/// Bodies after an impulse; the words of the refusal where there is one.
fn after(bodies: [RigidBody; 2], meeting: Meeting, impulse: [f64; 2]) -> Result<Vec<RigidBody>, String> {
    struck(&bodies, &[meeting], &[impulse]).map_err(|error| error.to_string())
}

#[test]
fn bodies_are_struck_only_by_what_is_an_impulse_between_them() {
    let other = RigidBody { centre: Vec2::new(2.0, 0.0), ..ball() };
    let good = after([ball(), other], meeting(), [0.0, 4.0]).unwrap();
    assert_eq!(good[0].velocity.x, -1.0, "a good impulse acts");
    let refused = [
        (after([ball(), other], Meeting { into: 7, ..meeting() }, [0.0, 4.0]), "body of contact 0 is 7"),
        (after([ball(), other], Meeting { into: 0, ..meeting() }, [0.0, 4.0]), "two different bodies"),
        (
            after([ball(), other], Meeting { normal: Vec2::ZERO, ..meeting() }, [0.0, 4.0]),
            "length of the normal",
        ),
        (
            after([ball(), other], Meeting { point: Vec2::new(f64::NAN, 0.0), ..meeting() }, [0.0, 4.0]),
            "point",
        ),
        (after([ball(), other], meeting(), [f64::NAN, 4.0]), "impulse of contact 0 is NaN"),
        (after([RigidBody { mass: -1.0, ..ball() }, other], meeting(), [0.0, 4.0]), "mass is -1"),
        (after([RigidBody { spin: f64::INFINITY, ..ball() }, other], meeting(), [0.0, 4.0]), "spin is inf"),
    ];
    for (found, words) in refused {
        let error = found.expect_err(words);
        assert!(error.contains(words), "{error} names {words}");
    }
}

/// Three things are wrong with each, and each is said.
#[test]
fn all_that_is_wrong_is_said_at_once() {
    let touch = Touch { arm: Vec2::ZERO, normal: Vec2::ZERO, friction: 0.3, restitution: 0.0 };
    let free = ContactSet2::of_free_body(-1.0, 1.0, Vec2::new(f64::NAN, 0.0), 0.0, &[touch])
        .unwrap_err()
        .to_string();
    assert_eq!(
        free,
        "mass is -1, allowed is > 0; velocity x is NaN, allowed is a finite number; \
         length of the normal of contact 0 is 0, allowed is > 0"
    );
    let light = RigidBody { mass: 0.0, inertia: f64::NAN, ..ball() };
    let bodies = ContactSet2::of_bodies(&[ball(), light], &[Meeting { into: 7, ..meeting() }])
        .unwrap_err()
        .to_string();
    for words in ["mass is 0", "inertia is NaN", "body of contact 0 is 7"] {
        assert!(bodies.contains(words), "{bodies} names {words}");
    }
    let good = Touch { normal: Vec2::new(0.0, 1.0), ..touch };
    let mut set = ContactSet2::of_free_body(1.0, 1.0, Vec2::ZERO, 0.0, &[good, good]).unwrap();
    (set.friction[0], set.restitution[1], set.slip[1]) = (-0.5, 1.5, f64::INFINITY);
    let set = set.check().unwrap_err().to_string();
    for words in
        ["friction of contact 0 is -0.5", "restitution of contact 1 is 1.5", "slip of contact 1 is inf"]
    {
        assert!(set.contains(words), "{set} names {words}");
    }
    let contact = single::Contact {
        w_tt: -1.0,
        w_tn: f64::NAN,
        w_nn: 1.0,
        slip: 0.0,
        normal: -1.0,
        friction: -0.5,
        restitution: 2.0,
    };
    let one = single::resolve(&contact, Law::Poisson).unwrap_err().to_string();
    for words in ["W_tn of contact 0 is NaN", "W_tt of contact 0 is -1", "friction of contact 0 is -0.5"] {
        assert!(one.contains(words), "{one} names {words}");
    }
    let all = ContactSet2::of_free_body(
        f64::NAN,
        f64::NAN,
        Vec2::new(f64::NAN, f64::NAN),
        f64::NAN,
        &[touch, touch],
    );
    let all = all.unwrap_err().to_string();
    assert!(all.ends_with("; and 1 more"), "what is not named is counted: {all}");
}

#[test]
fn a_free_body_needs_numbers_and_normals() {
    let touch =
        Touch { arm: Vec2::new(0.5, -1.0), normal: Vec2::new(0.0, 1.0), friction: 0.3, restitution: 0.0 };
    let set = |mass, velocity, touch: Touch| {
        ContactSet2::of_free_body(mass, 1.0, velocity, 0.0, &[touch])
            .map(drop)
            .map_err(|error| error.to_string())
    };
    let down = Vec2::new(0.0, -1.0);
    assert_eq!(set(1.0, down, touch), Ok(()), "a good body");
    for (found, words) in [
        (set(-1.0, down, touch), "mass"),
        (set(1.0, Vec2::new(f64::NAN, 0.0), touch), "velocity x"),
        (set(1.0, down, Touch { normal: Vec2::ZERO, ..touch }), "length of the normal"),
        (set(1.0, down, Touch { arm: Vec2::new(f64::INFINITY, 0.0), ..touch }), "arm"),
    ] {
        let error = found.expect_err(words);
        assert!(error.contains(words), "{error} names {words}");
    }
}
