//! The folder of a sweep: part files that are whole or not there, and who may write to it.

use super::designs::fingerprint;
use crate::failure::Failure;
use carom_scene::columns::about;
use std::fs::{File, OpenOptions, TryLockError};
use std::io::Write;
use std::path::{Path, PathBuf};

/// The file that says what is swept.
const MANIFEST: &str = "_sweep.json";
/// Where a part file's metadata says of which sweep it is.
pub(super) const FINGERPRINT: &str = "sweep";

/// A folder that is open for one shard.
pub(super) struct Folder {
    path: PathBuf,
    fingerprint: String,
    /// Held for as long as this process writes; the system lets go of them when it ends, whichever way.
    _locks: [File; 2],
}

impl Folder {
    /// Opens a folder for a sweep, anew or to go on with it.
    pub(super) fn open(
        path: PathBuf,
        manifest: &str,
        (shard, of): (u64, u64),
        force: bool,
    ) -> Result<Self, Failure> {
        std::fs::create_dir_all(&path).map_err(|error| Failure::file("make the folder", &path, &error))?;
        let whole = lock(&path.join(".sweep.lock"), of > 1)?;
        let own = lock(&path.join(format!(".shard-{}-of-{of}.lock", shard + 1)), false)?;
        let folder = Self { path, fingerprint: fingerprint(manifest.as_bytes()), _locks: [whole, own] };
        folder.claim(manifest, of > 1, force)?;
        Ok(folder)
    }

    /// Sees to it that the folder is of this sweep.
    fn claim(&self, manifest: &str, shared: bool, force: bool) -> Result<(), Failure> {
        let file = self.path.join(MANIFEST);
        let known = match std::fs::read_to_string(&file) {
            Ok(known) => Some(known),
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => None,
            Err(error) => return Err(Failure::file("read", &file, &error)),
        };
        match known {
            Some(known) if known == manifest && !force => return Ok(()),
            Some(_) if force && shared => {
                return Err(Failure::Usage(
                    "--force and --shard exclude each other: other shards may be at work".into(),
                ));
            }
            Some(_) if force => self.clear()?,
            Some(_) => {
                return Err(Failure::Usage(format!(
                    "{} is of another sweep: name another folder with --out, or replace it with --force",
                    self.path.display()
                )));
            }
            None if !force && self.holds_parts()? => {
                return Err(Failure::Usage(format!(
                    "{} holds part files without a {MANIFEST}: name another folder with --out, or replace them with --force",
                    self.path.display()
                )));
            }
            None if force => self.clear()?,
            None => {}
        }
        whole_write(&file, manifest.as_bytes())
    }

    /// True where there are part files.
    fn holds_parts(&self) -> Result<bool, Failure> {
        let read = |error: std::io::Error| Failure::file("read", &self.path, &error);
        for entry in std::fs::read_dir(&self.path).map_err(read)? {
            let path = entry.map_err(read)?.path();
            if path.is_file() && path.extension().is_some_and(|ending| ending == "parquet") {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Removes every part file.
    fn clear(&self) -> Result<(), Failure> {
        let read = |error: std::io::Error| Failure::file("read", &self.path, &error);
        for entry in std::fs::read_dir(&self.path).map_err(read)? {
            let path = entry.map_err(read)?.path();
            if path.extension().is_some_and(|ending| ending == "parquet") {
                std::fs::remove_file(&path).map_err(|error| Failure::file("remove", &path, &error))?;
            }
        }
        Ok(())
    }

    /// The name of a part file.
    pub(super) fn part(&self, part: u64) -> PathBuf {
        self.path.join(format!("part-{part:08}.parquet"))
    }

    /// The fingerprint of what is swept.
    pub(super) fn fingerprint(&self) -> &str {
        &self.fingerprint
    }

    /// True where a part is there as a whole; what is left of one that never was is written anew.
    ///
    /// # Errors
    /// The part is of another sweep, or cannot be opened.
    pub(super) fn has(&self, part: u64) -> Result<bool, Failure> {
        Ok(self.told_by(part)?.is_some())
    }

    /// What a part's metadata say; `None` where it is not there as a whole.
    ///
    /// # Errors
    /// As [`Folder::has`].
    pub(super) fn told_by(&self, part: u64) -> Result<Option<Vec<(String, String)>>, Failure> {
        let file = self.part(part);
        if !file.is_file() {
            return Ok(None);
        }
        File::open(&file).map_err(|error| Failure::file("read", &file, &error))?;
        // Metadata stand at a table's end: where they can be read it was written to its end.
        let Ok(told) = about(&file) else { return Ok(None) };
        if told.iter().any(|(key, value)| key == FINGERPRINT && *value == self.fingerprint) {
            return Ok(Some(told));
        }
        Err(Failure::Usage(format!(
            "{} is of another sweep: remove it, name another folder with --out, or replace all with --force",
            file.display()
        )))
    }

    /// Writes a part: it is there as a whole afterwards, or not at all.
    pub(super) fn write(&self, part: u64, bytes: &[u8]) -> Result<(), Failure> {
        whole_write(&self.part(part), bytes)
    }

    pub(super) fn path(&self) -> &Path {
        &self.path
    }
}

/// Keeps other processes out, or only those that want the folder for themselves.
fn lock(path: &Path, shared: bool) -> Result<File, Failure> {
    let opened = OpenOptions::new().create(true).truncate(false).write(true).read(true).open(path);
    let file = opened.map_err(|error| Failure::file("open", path, &error))?;
    let locked = if shared { file.try_lock_shared() } else { file.try_lock() };
    match locked {
        Ok(()) => Ok(file),
        Err(TryLockError::WouldBlock) => Err(Failure::Undone(format!(
            "another process is sweeping into {}",
            path.parent().unwrap_or(path).display()
        ))),
        Err(TryLockError::Error(error)) => Err(Failure::file("lock", path, &error)),
    }
}

/// Writes a file under another name, waits until it is on the disk, and renames it.
fn whole_write(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    // Shards that begin together write the same manifest: each to a file of its own first.
    let part = path.with_extension(format!("{}.part", std::process::id()));
    let written = File::create(&part).and_then(|mut file| {
        file.write_all(bytes)?;
        file.sync_all()
    });
    written.and_then(|()| std::fs::rename(&part, path)).map_err(|error| {
        // The write has failed already: whether its rest can be removed changes nothing.
        let _ = std::fs::remove_file(&part);
        match Failure::file("write", path, &error) {
            Failure::Undone(text) => Failure::Undone(format!(
                "{text}\nwhat was written before is whole: the same command goes on where this one stopped"
            )),
            other => other,
        }
    })
}
