//! Published results beside what the engine computes.
//!
//! Every result is a folder of `validation/`: its table says what is printed, as it is printed, and what is known of it; a module here lets
//! the engine compute each row. No closed form of the literature takes part in that: where a source prints a formula, the *printed* entry is
//! the formula's value and ours comes from a run or an impact.
//!
//! - [`validate`]: some results or all, as a [`ValidationReport`];
//! - [`table`]: a table as it stands in its file;
//! - [`compare`]: one printed entry against a value;
//! - [`feeder_paper`]: the quantities of the feeder paper's Table 1, of any run.

mod catalogue;
mod failure;
mod judge;
mod report;
mod results;
mod table;
mod value;

pub use catalogue::{names, table, validate};
pub use failure::ValidationError;
pub use judge::{Compared, compare};
pub use report::{OursReport, ResultReport, RowReport, ValidationReport, schema};
pub use results::feeder_paper;
pub use table::{Coarse, Row, Table, Tolerance, Verdict};
pub use value::{Value, Values};
