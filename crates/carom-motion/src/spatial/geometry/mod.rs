//! Bodies, the plane under them, and where they are.

mod aligned;
pub(in crate::spatial) mod body;
pub(in crate::spatial) mod clear;
pub(in crate::spatial) mod crossing;
pub(in crate::spatial) mod cut;
pub(in crate::spatial) mod feature;
pub(in crate::spatial) mod form;
pub(in crate::spatial) mod friction;
pub(in crate::spatial) mod hull;
pub(in crate::spatial) mod named;
pub(in crate::spatial) mod nearest;
pub(in crate::spatial) mod obstacle;
pub(in crate::spatial) mod overlap;
pub(in crate::spatial) mod pair;
pub(in crate::spatial) mod pieces;
pub(in crate::spatial) mod plane;
pub(in crate::spatial) mod polyhedron;
pub(in crate::spatial) mod posture;
pub(in crate::spatial) mod rest;
pub(in crate::spatial) mod rounding;
pub(in crate::spatial) mod solid;
pub(in crate::spatial) mod state;
pub(in crate::spatial) mod supports;
pub(in crate::spatial) mod surface;
pub(in crate::spatial) mod touch;
pub(in crate::spatial) mod world;
