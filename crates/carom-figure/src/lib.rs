//! Pictures of what a part does: the HTML report, the layout drawing, the impulse diagram, plots and the trace as CSV.
//!
//! Everything here turns a finished [`Run`](carom_feeder::Run) or [`Impact`](carom_motion::planar::trace::Impact) into text: nothing is
//! computed that the engine has not decided, nothing is read or written. Every picture is plain SVG with its style inside, every
//! report one HTML file that needs no network.
//!
//! - [`report`]: one self-contained page with verdict, layout, animation, stages, plots and strikes;
//! - [`roll_report`]: the same for a body that rolls, rocks or pivots through its strikes;
//! - [`solid_report`]: the same for a body in space, with an animation that can be turned;
//! - [`space_report`]: the same for a run of a solid part through a feeder; [`space_rows`]: the rows of its table;
//! - [`space_layout_svg`]: the layout of a feeder in space, seen from the side;
//! - [`space_glb`]: such a run as glTF 2.0, with the motion;
//! - [`impact_report`]: the same for one impact;
//! - [`yield_report`]: a page of its own for a yield study; [`pose_report`]: one for many throws of a body; [`validation_report`]: one for published results;
//! - [`layout_svg`]: the plates with their dimensions, with or without a run; [`drawing_svg`] and [`layout_dxf`]: the same one to one, for a workshop;
//! - [`ImpulsePlane`], [`impulse_svg`], [`impulse_text`]: Routh's diagram, as SVG or for a terminal;
//! - [`JointWalk`], [`joint_svg`]: the same for several contacts that are struck at once;
//! - [`regions_svg`], [`regions_csv`]: region diagrams;
//! - [`live_scene`], [`live_sections`]: the report piece by piece, for a page that stays open while its scene changes;
//! - `png`: any of the drawings as PNG, with the feature of that name;
//! - [`intervals_svg`]: what happens in a feed at which interval;
//! - [`trace_csv`]: every sample of a run; [`csv_cell`]: a text in such a file;
//! - [`rows`]: the rows of the stage table, for any output;
//! - [`senses`]: senses, slopes and tilts as the pictures count them.

mod after_strike;
mod bars;
mod blocks;
mod course;
mod csv;
mod draft;
mod dxf;
mod dxf_dimension;
mod dxf_file;
mod feed;
mod glb;
mod histogram;
mod impact_page;
mod impact_sketch;
mod impulse;
mod impulse_drawing;
mod impulse_terminal;
mod intervals;
mod joint;
mod joint_drawing;
mod joint_planes;
mod joint_strips;
mod labels;
mod layout;
mod live;
mod live_impact;
mod live_roll;
mod live_solid;
mod markup;
mod measures;
mod measures_svg;
mod mechanism;
mod motion;
mod outline;
mod page;
mod part_faces;
mod part_picture;
mod player;
mod plot;
#[cfg(feature = "png")]
mod png;
mod pose_page;
mod regions;
mod regions_legend;
mod report;
mod roll;
mod roll_scene;
pub mod senses;
mod sheet;
mod sight;
mod simulators;
mod solid;
mod solid_scene;
mod solid_tables;
mod space_layout;
mod space_plates;
mod space_report;
mod space_rows;
mod space_scene;
mod space_tables;
mod stage_table;
mod strikes;
mod svg;
mod text;
mod ticks;
mod tilt_chart;
mod timeline;
mod tolerance;
mod validation_page;
mod verdict;
mod view;
mod yield_page;
mod yield_tables;

pub use csv::{csv_cell, trace_csv};
pub use draft::{Axis, Draft, Measure};
pub use dxf::layout_dxf;
pub use feed::feed_report;
pub use glb::space_glb;
pub use impact_page::{ImpactFigure, ImpactPicture, ImpactShared, ImpactedBody, impact_report};
pub use impact_sketch::{ImpactSketch, SketchBody, SketchContact, SketchView, live_sketch};
pub use impulse::{ImpulsePlane, ImpulsePoint};
pub use impulse_drawing::impulse_svg;
pub use impulse_terminal::impulse_text;
pub use intervals::{IntervalFill, IntervalPiece, IntervalStrips, intervals_svg};
pub use joint::{JointContact, JointPiece, JointStage, JointWalk};
pub use joint_drawing::joint_svg;
pub use layout::layout_svg;
pub use live::{
    LiveScene, LiveSections, live_controls, live_ends, live_scene, live_sections, live_small, live_strike,
    live_view,
};
pub use live_impact::{LiveImpact, LiveWalk, live_impact, live_walk};
pub use live_roll::{LiveRoll, live_roll, live_roll_view};
pub use live_solid::{LiveSolid, live_solid, live_space};
#[cfg(feature = "png")]
pub use png::{PngError, png};
pub use pose_page::{PoseBody, PoseEnd, PoseFigure, pose_report};
pub use regions::{
    RegionAxis, RegionCurve, RegionDiagram, RegionName, live_regions, regions_csv, regions_svg,
};
pub use report::{Extra, QuantityLimit, Wish, report};
pub use roll::{RollContact, RollFigure, RollStrike, roll_report};
pub use sheet::drawing_svg;
pub use simulators::simulator_files;
pub use solid::{
    SolidContact, SolidDrawing, SolidFigure, SolidFork, SolidInstant, SolidPlate, SolidSeries, SolidStage,
    SolidState, SolidStrike, solid_report,
};
pub use space_layout::space_layout_svg;
pub use space_report::{SpaceFigure, space_report};
pub use space_rows::{SpaceRow, space_contacts, space_energy_change, space_rows, space_tilt};
pub use stage_table::{Row, milliseconds, rows, shown_tilt};
pub use validation_page::{
    ValidatedResult, ValidatedRow, ValidatedValue, ValidationFigure, validation_report,
};
pub use view::View;
pub use yield_page::{YieldFigure, YieldQuantity, YieldWorst, live_yield, yield_report};

/// The style of every drawing: plain colours by class, so that programs without CSS variables read it too.
const FIGURE_CSS: &str = include_str!("figure.css");
