//! Who looks on while a body moves.

use super::run::Closing;
use super::run::Impact;
use super::run::Piece;
use crate::spatial::geometry::state::State;
use crate::spatial::modes::mode::Mode;
use std::ops::ControlFlow;

/// Who looks on. `()` looks at nothing.
///
/// # Example
/// Somebody who notes what part of the energy each impact leaves: of a cube that rocks, 1/16.
/// ```
/// use carom_motion::spatial::{Impact, Observer, Options, examples, run};
/// let (world, start) = examples::rocking_cube();
/// struct Left(Vec<f64>);
/// impl Observer for Left {
///     fn impact(&mut self, impact: &Impact) -> std::ops::ControlFlow<()> {
///         self.0.push(impact.kinetic_after / impact.kinetic_before);
///         std::ops::ControlFlow::Continue(())
///     }
/// }
/// let mut left = Left(vec![]);
/// run(&world, &start, &Options::default(), &mut left)?;
/// assert!(left.0.len() > 2 && left.0[..3].iter().all(|part| (part - 1.0 / 16.0).abs() < 1e-12));
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
pub trait Observer {
    /// True: samples are made and handed over.
    ///
    /// # Example
    /// Who looks at nothing wants no samples.
    /// ```
    /// use carom_motion::spatial::{Observer, Samples};
    /// assert!(!().is_dense() && Samples::default().is_dense());
    /// ```
    fn is_dense(&self) -> bool {
        false
    }

    /// An instant of the present stretch; only where [`Observer::is_dense`].
    ///
    /// # Example
    /// In a fall the energy stays what it was: `m g` times 0.7 m, 7 J.
    /// ```
    /// use carom_motion::spatial::{Mode, Observer, Options, State, World, examples, run};
    /// let (world, start) = examples::falling_cube();
    /// struct Fall<'w>(&'w World);
    /// impl Observer for Fall<'_> {
    ///     fn is_dense(&self) -> bool {
    ///         true
    ///     }
    ///     fn sample(&mut self, _: f64, mode: Mode, state: &State) {
    ///         let energy = state.kinetic(self.0.body()) + state.potential(self.0);
    ///         assert!(mode != Mode::Flight || (energy - 7.0).abs() < 1e-12);
    ///     }
    /// }
    /// run(&world, &start, &Options::default(), &mut Fall(&world))?;
    /// # Ok::<(), carom_motion::MotionError>(())
    /// ```
    fn sample(&mut self, time: f64, mode: Mode, state: &State) {
        let _ = (time, mode, state);
    }

    /// The time at which the state is wanted next, whatever the steps of the run are \[s\]; infinite where none is. Asked again after each.
    fn next_instant(&self) -> f64 {
        f64::INFINITY
    }

    /// The state at the time that [`Observer::next_instant`] has named: not interpolated, but from the formula or the dense output of the step
    /// that holds there. At an event it is the state after it.
    ///
    /// # Example
    /// A cube that is let go has fallen 5 cm after 0.1 s.
    /// ```
    /// # use {carom_motion::spatial::*, carom_num::{Mat3, Rotation, Vec3}};
    /// # let moment = 1.0 / 6.0;
    /// # let corner = |x: f64, y: f64| Vec3::new(x, y, -0.5);
    /// # let corners = vec![corner(-0.5, -0.5), corner(0.5, -0.5), corner(0.5, 0.5), corner(-0.5, 0.5)];
    /// # let cube = Body::new(1.0, Mat3::diagonal(moment, moment, moment), corners).unwrap();
    /// # let world = World::new(cube, Vec3::Z * -10.0).unwrap();
    /// # let (attitude, still) = (Rotation::NONE, Vec3::ZERO);
    /// # let start = State { centre: Vec3::Z * 0.7, attitude, velocity: still, spin: still };
    /// struct Asks(Option<State>);
    /// impl Observer for Asks {
    ///     fn next_instant(&self) -> f64 {
    ///         if self.0.is_some() { f64::INFINITY } else { 0.1 }
    ///     }
    ///     fn instant(&mut self, _: f64, state: &State) {
    ///         self.0 = Some(*state);
    ///     }
    /// }
    /// let mut asks = Asks(None);
    /// run(&world, &start, &Options::default(), &mut asks)?;
    /// assert!((asks.0.unwrap().centre.z - 0.65).abs() < 1e-15);
    /// # Ok::<(), carom_motion::MotionError>(())
    /// ```
    fn instant(&mut self, time: f64, state: &State) {
        let _ = (time, state);
    }

    /// A stretch of motion starts in a mode; the answer may end the run.
    ///
    /// # Example
    /// The run ends once the body has touched something and moves on.
    /// ```
    /// use carom_motion::spatial::{End, Mode, Observer, Options, State, examples, run};
    /// use std::ops::ControlFlow;
    /// let (world, start) = examples::rocking_cube();
    /// struct Stops;
    /// impl Observer for Stops {
    ///     fn starts(&mut self, time: f64, mode: Mode, _: &State) -> ControlFlow<()> {
    ///         if time > 0.0 && mode != Mode::Flight { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    ///     }
    /// }
    /// let stopped = run(&world, &start, &Options::default(), &mut Stops)?;
    /// assert!(stopped.end == End::Stopped && stopped.time > 0.0);
    /// # Ok::<(), carom_motion::MotionError>(())
    /// ```
    fn starts(&mut self, time: f64, mode: Mode, state: &State) -> ControlFlow<()> {
        let _ = (time, mode, state);
        ControlFlow::Continue(())
    }

    /// A stretch of motion has ended.
    fn piece(&mut self, piece: &Piece) {
        let _ = piece;
    }

    /// An impact; the answer may end the run.
    ///
    /// # Example
    /// The run ends with the first impact where the observer has seen enough.
    /// ```
    /// use carom_motion::spatial::{End, Impact, Observer, Options, examples, run};
    /// let (world, start) = examples::rocking_cube();
    /// struct Stops;
    /// impl Observer for Stops {
    ///     fn impact(&mut self, _: &Impact) -> std::ops::ControlFlow<()> {
    ///         std::ops::ControlFlow::Break(())
    ///     }
    /// }
    /// let stopped = run(&world, &start, &Options::default(), &mut Stops)?;
    /// assert_eq!((stopped.end, stopped.impacts.len()), (End::Stopped, 1));
    /// # Ok::<(), carom_motion::MotionError>(())
    /// ```
    fn impact(&mut self, impact: &Impact) -> ControlFlow<()> {
        let _ = impact;
        ControlFlow::Continue(())
    }

    /// A series of impacts was closed at its limit.
    fn closing(&mut self, closing: &Closing) {
        let _ = closing;
    }
}

impl Observer for () {}

/// Keeps the stretches and the samples.
///
/// # Example
/// At every instant of a fall from rest the speed is `g t`.
/// ```
/// use carom_motion::spatial::{Mode, Options, Samples, examples, run};
/// let (world, start) = examples::falling_cube();
/// let mut samples = Samples::default();
/// run(&world, &start, &Options::default(), &mut samples)?;
/// let (time, mode, state) = &samples.instants[1];
/// assert!(*time > 0.0 && *mode == Mode::Flight);
/// assert!((state.velocity.z + 10.0 * time).abs() < 1e-13);
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Samples {
    /// Time \[s\], what the body does and its state, in the order of time.
    pub instants: Vec<(f64, Mode, State)>,
    /// The stretches between events.
    pub pieces: Vec<Piece>,
}

impl Observer for Samples {
    fn is_dense(&self) -> bool {
        true
    }

    fn sample(&mut self, time: f64, mode: Mode, state: &State) {
        self.instants.push((time, mode, *state));
    }

    fn piece(&mut self, piece: &Piece) {
        self.pieces.push(*piece);
    }
}
