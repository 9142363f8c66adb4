//! The layouts that may be chosen.

use carom_feeder::{Feeder, Run};

/// A layout.
///
/// # Example
/// A plate from 4 m beside its edge and 3 m above it.
/// ```
/// # use {carom_feeder::*, carom_impact::planar::Law, carom_motion::planar::Options, carom_num::Vec2};
/// # let slope = |friction: f64| Feeder {
/// #     gravity: 10.0, stop: Stop::Delivered, law: Law::Poisson, walls: vec![],
/// #     part: Part::rod(0.1, 0.3, 2.5e-4).unwrap(),
/// #     start: Start { to_edge: 2.0, speed: 0.0, face: 0 },
/// #     plates: vec![Plate {
/// #         name: "slope".into(), uphill: Vec2::new(-4.0, 3.0), edge: Vec2::ZERO,
/// #         friction, restitution: 0.0, unbounded: false,
/// #     }],
/// # };
/// use carom_study::design::Layout;
/// let feeder = slope(0.5);
/// let [from, to] = [feeder.plates[0].uphill, feeder.plates[0].edge];
/// let layout = Layout { height: from.y - to.y, width: to.x - from.x, feeder };
/// assert_eq!((layout.height, layout.width), (3.0, 4.0));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Layout {
    /// The feeder where nothing varies.
    pub feeder: Feeder,
    /// How high it is [m].
    pub height: f64,
    /// How wide it is [m].
    pub width: f64,
}

/// What a layout's feeder may be: one for every point of the unit cube of what varies, or none where it cannot be drawn.
///
/// # Example
/// Friction that varies by a tenth about 3/4, over one dimension of the unit cube.
/// ```
/// # use {carom_feeder::*, carom_impact::planar::Law, carom_motion::planar::Options, carom_num::Vec2};
/// # let slope = |friction: f64| Feeder {
/// #     gravity: 10.0, stop: Stop::Delivered, law: Law::Poisson, walls: vec![],
/// #     part: Part::rod(0.1, 0.3, 2.5e-4).unwrap(),
/// #     start: Start { to_edge: 2.0, speed: 0.0, face: 0 },
/// #     plates: vec![Plate {
/// #         name: "slope".into(), uphill: Vec2::new(-4.0, 3.0), edge: Vec2::ZERO,
/// #         friction, restitution: 0.0, unbounded: false,
/// #     }],
/// # };
/// use carom_study::design::Varying;
/// let varying: Varying<'_> = Box::new(|u: &[f64]| Some(slope(0.65 + 0.2 * u[0])));
/// assert_eq!(varying(&[0.0]).unwrap().plates[0].friction, 0.65);
/// assert!((varying(&[0.5]).unwrap().plates[0].friction - 0.75).abs() < 1e-15);
/// ```
pub type Varying<'a> = Box<dyn Fn(&[f64]) -> Option<Feeder> + Sync + 'a>;

/// The layouts that may be chosen.
///
/// # Example
/// The friction of a plate of 3 in 4 may be chosen from 0 to 1. A rod is to be held: that takes 3/4, and a
/// quarter of the layouts do it.
/// ```
/// # use {carom_feeder::*, carom_impact::planar::Law, carom_motion::planar::Options, carom_num::Vec2};
/// # let slope = |friction: f64| Feeder {
/// #     gravity: 10.0, stop: Stop::Delivered, law: Law::Poisson, walls: vec![],
/// #     part: Part::rod(0.1, 0.3, 2.5e-4).unwrap(),
/// #     start: Start { to_edge: 2.0, speed: 0.0, face: 0 },
/// #     plates: vec![Plate {
/// #         name: "slope".into(), uphill: Vec2::new(-4.0, 3.0), edge: Vec2::ZERO,
/// #         friction, restitution: 0.0, unbounded: false,
/// #     }],
/// # };
/// # use carom_study::design::*;
/// struct Friction<F>(F);
/// impl<F: Fn(f64) -> Feeder + Sync> Space for Friction<F> {
///     fn dimensions(&self) -> usize {
///         1
///     }
///     fn varying(&self) -> usize {
///         1
///     }
///     fn layout(&self, point: &[f64]) -> Option<Layout> {
///         Some(Layout { feeder: (self.0)(point[0]), height: 3.0, width: 4.0 })
///     }
///     fn met(&self, _: &[f64], run: &Run) -> bool {
///         run.outcome == Outcome::Stuck
///     }
///     fn varied(&self, point: &[f64], _widened: f64) -> Option<Varying<'_>> {
///         let friction = point[0];
///         Some(Box::new(move |_| Some((self.0)(friction))))
///     }
/// }
/// let goal = Goal { limits: Limits::default(), aim: Aim::Yield, seed: 1, scanned: 16, confirming: 1 };
/// assert_eq!(search(&Friction(slope), &goal).unwrap().met, 4);
/// ```
pub trait Space: Sync {
    /// Quantities that may be chosen.
    ///
    /// # Example
    /// Of friction alone, one.
    /// ```
    /// # use {carom_feeder::*, carom_impact::planar::Law, carom_motion::planar::Options, carom_num::Vec2};
    /// # let slope = |friction: f64| Feeder {
    /// #     gravity: 10.0, stop: Stop::Delivered, law: Law::Poisson, walls: vec![],
    /// #     part: Part::rod(0.1, 0.3, 2.5e-4).unwrap(),
    /// #     start: Start { to_edge: 2.0, speed: 0.0, face: 0 },
    /// #     plates: vec![Plate {
    /// #         name: "slope".into(), uphill: Vec2::new(-4.0, 3.0), edge: Vec2::ZERO,
    /// #         friction, restitution: 0.0, unbounded: false,
    /// #     }],
    /// # };
    /// # use carom_study::design::*;
    /// # struct Friction<F>(F);
    /// # impl<F: Fn(f64) -> Feeder + Sync> Space for Friction<F> {
    /// #     fn dimensions(&self) -> usize { 1 }
    /// #     fn varying(&self) -> usize { 1 }
    /// #     fn layout(&self, point: &[f64]) -> Option<Layout> {
    /// #         Some(Layout { feeder: (self.0)(point[0]), height: 3.0, width: 4.0 })
    /// #     }
    /// #     fn met(&self, _: &[f64], run: &Run) -> bool { run.outcome == Outcome::Stuck }
    /// #     fn varied(&self, _: &[f64], _: f64) -> Option<Varying<'_>> { None }
    /// # }
    /// assert_eq!(Friction(slope).dimensions(), 1);
    /// ```
    fn dimensions(&self) -> usize;

    /// Quantities that vary.
    ///
    /// # Example
    /// The dimensions of the cube that [`Space::varied`] takes its points from.
    /// ```
    /// # use {carom_feeder::*, carom_impact::planar::Law, carom_motion::planar::Options, carom_num::Vec2};
    /// # let slope = |friction: f64| Feeder {
    /// #     gravity: 10.0, stop: Stop::Delivered, law: Law::Poisson, walls: vec![],
    /// #     part: Part::rod(0.1, 0.3, 2.5e-4).unwrap(),
    /// #     start: Start { to_edge: 2.0, speed: 0.0, face: 0 },
    /// #     plates: vec![Plate {
    /// #         name: "slope".into(), uphill: Vec2::new(-4.0, 3.0), edge: Vec2::ZERO,
    /// #         friction, restitution: 0.0, unbounded: false,
    /// #     }],
    /// # };
    /// # use carom_study::design::*;
    /// # struct Friction<F>(F);
    /// # impl<F: Fn(f64) -> Feeder + Sync> Space for Friction<F> {
    /// #     fn dimensions(&self) -> usize { 1 }
    /// #     fn varying(&self) -> usize { 1 }
    /// #     fn layout(&self, point: &[f64]) -> Option<Layout> {
    /// #         Some(Layout { feeder: (self.0)(point[0]), height: 3.0, width: 4.0 })
    /// #     }
    /// #     fn met(&self, _: &[f64], run: &Run) -> bool { run.outcome == Outcome::Stuck }
    /// #     fn varied(&self, _: &[f64], _: f64) -> Option<Varying<'_>> { None }
    /// # }
    /// assert_eq!(Friction(slope).varying(), 1);
    /// ```
    fn varying(&self) -> usize;

    /// The layout at a point of the unit cube; `None` where what is drawn cannot be.
    ///
    /// # Example
    /// The middle of the cube stands for a friction of 1/2.
    /// ```
    /// # use {carom_feeder::*, carom_impact::planar::Law, carom_motion::planar::Options, carom_num::Vec2};
    /// # let slope = |friction: f64| Feeder {
    /// #     gravity: 10.0, stop: Stop::Delivered, law: Law::Poisson, walls: vec![],
    /// #     part: Part::rod(0.1, 0.3, 2.5e-4).unwrap(),
    /// #     start: Start { to_edge: 2.0, speed: 0.0, face: 0 },
    /// #     plates: vec![Plate {
    /// #         name: "slope".into(), uphill: Vec2::new(-4.0, 3.0), edge: Vec2::ZERO,
    /// #         friction, restitution: 0.0, unbounded: false,
    /// #     }],
    /// # };
    /// # use carom_study::design::*;
    /// # struct Friction<F>(F);
    /// # impl<F: Fn(f64) -> Feeder + Sync> Space for Friction<F> {
    /// #     fn dimensions(&self) -> usize { 1 }
    /// #     fn varying(&self) -> usize { 1 }
    /// #     fn layout(&self, point: &[f64]) -> Option<Layout> {
    /// #         Some(Layout { feeder: (self.0)(point[0]), height: 3.0, width: 4.0 })
    /// #     }
    /// #     fn met(&self, _: &[f64], run: &Run) -> bool { run.outcome == Outcome::Stuck }
    /// #     fn varied(&self, _: &[f64], _: f64) -> Option<Varying<'_>> { None }
    /// # }
    /// assert_eq!(Friction(slope).layout(&[0.5]).unwrap().feeder.plates[0].friction, 0.5);
    /// ```
    fn layout(&self, point: &[f64]) -> Option<Layout>;

    /// Does a run of the layout at a point end as wanted?
    ///
    /// # Example
    /// On a plate of 3 in 4 friction of 1 holds a rod, and 1/2 does not.
    /// ```
    /// # use {carom_feeder::*, carom_impact::planar::Law, carom_motion::planar::Options, carom_num::Vec2};
    /// # let slope = |friction: f64| Feeder {
    /// #     gravity: 10.0, stop: Stop::Delivered, law: Law::Poisson, walls: vec![],
    /// #     part: Part::rod(0.1, 0.3, 2.5e-4).unwrap(),
    /// #     start: Start { to_edge: 2.0, speed: 0.0, face: 0 },
    /// #     plates: vec![Plate {
    /// #         name: "slope".into(), uphill: Vec2::new(-4.0, 3.0), edge: Vec2::ZERO,
    /// #         friction, restitution: 0.0, unbounded: false,
    /// #     }],
    /// # };
    /// # use carom_study::design::*;
    /// # struct Friction<F>(F);
    /// # impl<F: Fn(f64) -> Feeder + Sync> Space for Friction<F> {
    /// #     fn dimensions(&self) -> usize { 1 }
    /// #     fn varying(&self) -> usize { 1 }
    /// #     fn layout(&self, point: &[f64]) -> Option<Layout> {
    /// #         Some(Layout { feeder: (self.0)(point[0]), height: 3.0, width: 4.0 })
    /// #     }
    /// #     fn met(&self, _: &[f64], run: &Run) -> bool { run.outcome == Outcome::Stuck }
    /// #     fn varied(&self, _: &[f64], _: f64) -> Option<Varying<'_>> { None }
    /// # }
    /// let space = Friction(&slope);
    /// let holds = |friction: f64| space.met(&[friction], &slope(friction).verdict().unwrap());
    /// assert!(holds(1.0) && !holds(0.5));
    /// ```
    fn met(&self, point: &[f64], run: &Run) -> bool;

    /// What a layout's feeder may be, for points of the unit cube of what varies; tolerances are `widened` so many times.
    ///
    /// # Example
    /// Where nothing has a tolerance, every point gives the same feeder.
    /// ```
    /// # use {carom_feeder::*, carom_impact::planar::Law, carom_motion::planar::Options, carom_num::Vec2};
    /// # let slope = |friction: f64| Feeder {
    /// #     gravity: 10.0, stop: Stop::Delivered, law: Law::Poisson, walls: vec![],
    /// #     part: Part::rod(0.1, 0.3, 2.5e-4).unwrap(),
    /// #     start: Start { to_edge: 2.0, speed: 0.0, face: 0 },
    /// #     plates: vec![Plate {
    /// #         name: "slope".into(), uphill: Vec2::new(-4.0, 3.0), edge: Vec2::ZERO,
    /// #         friction, restitution: 0.0, unbounded: false,
    /// #     }],
    /// # };
    /// # use carom_study::design::*;
    /// # struct Friction<F>(F);
    /// # impl<F: Fn(f64) -> Feeder + Sync> Space for Friction<F> {
    /// #     fn dimensions(&self) -> usize { 1 }
    /// #     fn varying(&self) -> usize { 1 }
    /// #     fn layout(&self, point: &[f64]) -> Option<Layout> {
    /// #         Some(Layout { feeder: (self.0)(point[0]), height: 3.0, width: 4.0 })
    /// #     }
    /// #     fn met(&self, _: &[f64], run: &Run) -> bool { run.outcome == Outcome::Stuck }
    /// #     fn varied(&self, point: &[f64], _: f64) -> Option<Varying<'_>> {
    /// #         let friction = point[0];
    /// #         Some(Box::new(move |_| Some((self.0)(friction))))
    /// #     }
    /// # }
    /// let space = Friction(slope);
    /// let varied = space.varied(&[0.5], 1.0).unwrap();
    /// assert_eq!(varied(&[0.1]), varied(&[0.9]));
    /// ```
    fn varied(&self, point: &[f64], widened: f64) -> Option<Varying<'_>>;
}
