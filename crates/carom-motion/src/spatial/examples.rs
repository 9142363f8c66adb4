//! Small bodies and worlds that the examples of this module share: every number in them is round, so that a result can be checked by hand.

use super::{Body, State, World};
use carom_num::{Rotation, Vec3};

/// A cube of 1 m and 1 kg that stands on the four corners of its lower face, counter-clockwise from (−½, −½): `J = m a²/6`.
pub fn cube() -> Body {
    let corner = |x: f64, y: f64| Vec3::new(x, y, -0.5);
    let corners = vec![corner(-0.5, -0.5), corner(0.5, -0.5), corner(0.5, 0.5), corner(-0.5, 0.5)];
    let moment = 1.0 / 6.0;
    Body::of_principal(1.0, [moment, moment, moment], corners)
}

/// A thin rod of 2 m and 1 kg along z that stands on its foot: `J = m ℓ²/12 = 1/3 kg m²` across.
pub fn rod() -> Body {
    Body::of_principal(1.0, [1.0 / 3.0, 1.0 / 3.0, 0.001], vec![-Vec3::Z])
}

/// The [`cube`] at rest with its lower face 0.2 m above the plane and parallel to it; g = 10 m/s². It strikes after 0.2 s with 2 m/s.
pub fn falling_cube() -> (World, State) {
    let (attitude, still) = (Rotation::NONE, Vec3::ZERO);
    let start = State { centre: Vec3::Z * 0.7, attitude, velocity: still, spin: still };
    (World::of_checked(cube(), Vec3::Z * -10.0), start)
}

/// The [`cube`] let go while it stands on the edge of its corners 0 and 1, tilted by 0.1 rad; g = 10 m/s². It rocks to rest.
pub fn rocking_cube() -> (World, State) {
    let cube = cube();
    let start = State::standing(&cube, 0, Rotation::by(Vec3::X * 0.1), Vec3::ZERO);
    (World::of_checked(cube, Vec3::Z * -10.0), start)
}

/// A cube of 1 m and 1 kg that may stand on any face.
pub fn block() -> Body {
    let corners = cube_corners().into_iter().map(|corner| corner - Vec3::new(0.5, 0.5, 0.5)).collect();
    let moment = 1.0 / 6.0;
    Body::of_principal(1.0, [moment; 3], corners)
}

/// The corners of a cube of 1 m with one corner at the origin and the others at x, y and z of 0 or 1 m.
pub fn cube_corners() -> Vec<Vec3> {
    let square = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)];
    [0.0, 1.0].iter().flat_map(|z| square.map(|(x, y)| Vec3::new(x, y, *z))).collect()
}
