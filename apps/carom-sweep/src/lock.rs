//! Who may write to the folder of a sweep.

use crate::disk;
use carom::tasks::StudyError;
use std::fs::{File, TryLockError};
use std::path::{Path, PathBuf};

/// Keeps other processes out, or only those that want the folder for themselves; the system lets go of it when this one ends, whichever way.
pub(crate) struct Lock {
    path: PathBuf,
    file: File,
}

impl Lock {
    /// Takes a lock, shared or alone.
    pub(crate) fn take(path: PathBuf, shared: bool) -> Result<Self, StudyError> {
        loop {
            let file = disk::open_lock(&path).map_err(|error| disk::undone("open", &path, &error))?;
            let locked = if shared { file.try_lock_shared() } else { file.try_lock() };
            match locked {
                Ok(()) if is_at(&file, &path) => return Ok(Self { path, file }),
                // Whoever held it removed it in between.
                Ok(()) => {}
                Err(TryLockError::WouldBlock) => {
                    return Err(StudyError::Undone(format!(
                        "another process is sweeping into {}",
                        path.parent().unwrap_or(&path).display()
                    )));
                }
                Err(TryLockError::Error(error)) => return Err(disk::undone("lock", &path, &error)),
            }
        }
    }

    /// Lets go of it. Where nobody else holds it, `tidy` is done first, and the file is removed; a file that is open is removed on Unix alone.
    pub(crate) fn release(self, tidy: impl FnOnce()) {
        if self.file.try_lock().is_ok() {
            tidy();
            if cfg!(unix) {
                // A lock file that stays is in nobody's way.
                let _ = disk::remove(&self.path);
            }
        }
    }
}

/// True where this file is still the one of that name.
#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let place = |metadata: std::fs::Metadata| (metadata.dev(), metadata.ino());
    match (file.metadata().map(place), std::fs::metadata(path).map(place)) {
        (Ok(held), Ok(named)) => held == named,
        _ => false,
    }
}

/// Lock files are not removed here.
#[cfg(not(unix))]
fn is_at(_: &File, _: &Path) -> bool {
    true
}
