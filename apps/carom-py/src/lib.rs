//! Carom in Python: what the package `carom` calls.
//!
//! The engine's answers cross the bridge as the JSON that the command prints, byte for byte; the package makes objects of it. Arrays go in as
//! NumPy's and come out as tables that NumPy and Arrow read. Whatever takes long gives up the lock of the interpreter, uses all cores, tells
//! how far it is and stops when the interpreter is told to.
//!
//! Without the feature `python` the crate is empty.

#[cfg(feature = "python")]
mod answers;
#[cfg(feature = "python")]
mod batch;
#[cfg(feature = "python")]
mod drops;
#[cfg(feature = "python")]
mod failure;
#[cfg(feature = "python")]
mod given;
#[cfg(feature = "python")]
mod impacts;
#[cfg(feature = "python")]
mod referee;
#[cfg(feature = "python")]
mod scene;
#[cfg(feature = "python")]
mod studies;
#[cfg(feature = "python")]
mod sweep;
#[cfg(feature = "python")]
mod table;
#[cfg(feature = "python")]
mod tosses;
#[cfg(feature = "python")]
mod watch;
#[cfg(feature = "python")]
mod yields;

/// The module that the package imports.
#[cfg(feature = "python")]
#[pyo3::pymodule]
mod _carom {
    #[pymodule_export]
    use crate::answers::{contact, design, impact, roll, run, toml_of_json};
    #[pymodule_export]
    use crate::batch::impact_batch;
    #[pymodule_export]
    use crate::drops::drops;
    #[pymodule_export]
    use crate::impacts::impacts;
    #[pymodule_export]
    use crate::referee::{referee_cases, referee_judge};
    #[pymodule_export]
    use crate::scene::Scene;
    #[pymodule_export]
    use crate::studies::{feed, fit, map, regions};
    #[pymodule_export]
    use crate::sweep::sweep;
    #[pymodule_export]
    use crate::table::Table;
    #[pymodule_export]
    use crate::tosses::tosses;
    #[pymodule_export]
    use crate::watch::use_threads;
    #[pymodule_export]
    use crate::yields::{located, yield_joined, yield_portion, yields};

    /// The version of the engine.
    #[pymodule_export]
    #[expect(non_upper_case_globals, reason = "Python's own name for it")]
    const __version__: &str = env!("CARGO_PKG_VERSION");
}
