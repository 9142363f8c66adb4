//! All tests of this crate in one program: it is linked once.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod axial;
mod bodies;
mod chains;
mod chains_curved;
mod chains_random;
mod clattering;
mod crowd;
mod double_events;
mod flat_landings;
mod hollows;
mod hooks;
mod joint_corners;
mod joints;
mod narrow_corners;
mod on_edge;
mod polyhedra;
mod polyhedra_thrown;
mod rebound_series;
mod rests;
mod rocking;
mod spatial_balls;
mod spatial_blocks;
mod spatial_circles;
mod spatial_corners;
mod spatial_edges;
mod spatial_ends;
mod spatial_planar;
mod spatial_planes;
mod spatial_pyramids;
mod spatial_random;
mod spatial_renumbered;
mod spatial_rough_random;
mod spatial_rough_stools;
mod spatial_round;
mod spatial_sliding;
mod spatial_stools;
mod spatial_symmetries;
mod spatial_thrown;
mod starts;
mod stools;
mod theory;
mod thrown;
mod two_bodies;
mod walk;
