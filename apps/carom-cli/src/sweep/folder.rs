//! The folder of a sweep: part files that are whole or not there, and who may write to it.

use super::designs::fingerprint;
use crate::disk;
use crate::failure::Failure;
use carom_scene::columns::about;
use std::fs::{File, TryLockError};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// The file that says what is swept.
const MANIFEST: &str = "_sweep.json";
/// How the lock file of a shard begins.
const SHARD: &str = ".shard-";
/// Where a part file's metadata says of which sweep it is.
pub(super) const FINGERPRINT: &str = "sweep";

/// A folder that is open for one shard.
pub(super) struct Folder {
    path: PathBuf,
    fingerprint: String,
    /// This shard's, and the folder's: held for as long as this process writes.
    locks: [Lock; 2],
}

impl Folder {
    /// Opens a folder for a sweep, anew or to go on with it.
    pub(super) fn open(
        path: PathBuf,
        manifest: &str,
        (shard, of): (u64, u64),
        force: bool,
    ) -> Result<Self, Failure> {
        disk::make_folder(&path).map_err(|error| Failure::file("make the folder", &path, &error))?;
        let whole = Lock::take(path.join(".sweep.lock"), of > 1)?;
        // Every process takes its own lock before it looks at others': of two that begin together one at least sees the other.
        let own = Lock::take(path.join(format!("{SHARD}{}-of-{of}.lock", shard + 1)), false)?;
        let folder = Self { path, fingerprint: fingerprint(manifest.as_bytes()), locks: [own, whole] };
        folder.refuse_other_shards(of)?;
        folder.remove_rests((shard, of))?;
        folder.claim(manifest, of > 1, force)?;
        Ok(folder)
    }

    /// Lets others in; where nobody else is at work no lock file is left.
    pub(super) fn close(self) {
        self.locks.into_iter().for_each(Lock::release);
    }

    /// The files of the folder, by name.
    fn files(&self) -> Result<Vec<(String, PathBuf)>, Failure> {
        disk::list(&self.path).map_err(|error| Failure::file("read", &self.path, &error))
    }

    /// Shards of two counts would do the same parts twice.
    fn refuse_other_shards(&self, of: u64) -> Result<(), Failure> {
        for (name, path) in self.files()? {
            let count = name.strip_prefix(SHARD).and_then(|name| name.strip_suffix(".lock"));
            let Some((_, count)) = count.and_then(|count| count.split_once("-of-")) else { continue };
            let Ok(file) = File::open(&path) else { continue };
            if count != of.to_string() && matches!(file.try_lock_shared(), Err(TryLockError::WouldBlock)) {
                return Err(Failure::Undone(format!(
                    "another process is sweeping into {} as one of {count} shards: all of them must have one count",
                    self.path.display()
                )));
            }
        }
        Ok(())
    }

    /// Removes what writes of this shard's parts left that were killed.
    fn remove_rests(&self, (shard, of): (u64, u64)) -> Result<(), Failure> {
        for (name, path) in self.files()? {
            let Some(name) = name.strip_suffix(".part") else { continue };
            let part =
                name.strip_prefix("part-").and_then(|name| name.split('.').next()?.parse::<u64>().ok());
            let own = match part {
                Some(part) => part % of == shard,
                // Other shards may be writing the manifest.
                None => of == 1 && name.starts_with("_sweep."),
            };
            if own {
                disk::remove(&path).map_err(|error| Failure::file("remove", &path, &error))?;
            }
        }
        Ok(())
    }

    /// Sees to it that the folder is of this sweep.
    fn claim(&self, manifest: &str, shared: bool, force: bool) -> Result<(), Failure> {
        let file = self.path.join(MANIFEST);
        let known = match disk::read_text(&file) {
            Ok(known) => Some(known),
            Err(error) if error.kind() == ErrorKind::NotFound => None,
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
        Ok(self.files()?.iter().any(|(name, path)| name.ends_with(".parquet") && path.is_file()))
    }

    /// Removes every part file.
    fn clear(&self) -> Result<(), Failure> {
        for (_, path) in self.files()?.iter().filter(|(name, _)| name.ends_with(".parquet")) {
            disk::remove(path).map_err(|error| Failure::file("remove", path, &error))?;
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
        disk::open(&file).map_err(|error| Failure::file("read", &file, &error))?;
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

/// Keeps other processes out, or only those that want the folder for themselves; the system lets go of it when this one ends, whichever way.
struct Lock {
    path: PathBuf,
    file: File,
}

impl Lock {
    fn take(path: PathBuf, shared: bool) -> Result<Self, Failure> {
        loop {
            let file = disk::open_lock(&path).map_err(|error| Failure::file("open", &path, &error))?;
            let locked = if shared { file.try_lock_shared() } else { file.try_lock() };
            match locked {
                Ok(()) if is_at(&file, &path) => return Ok(Self { path, file }),
                // Whoever held it removed it in between.
                Ok(()) => {}
                Err(TryLockError::WouldBlock) => {
                    return Err(Failure::Undone(format!(
                        "another process is sweeping into {}",
                        path.parent().unwrap_or(&path).display()
                    )));
                }
                Err(TryLockError::Error(error)) => return Err(Failure::file("lock", &path, &error)),
            }
        }
    }

    /// Removes the file, unless others hold it as well.
    #[cfg(unix)]
    fn release(self) {
        if self.file.try_lock().is_ok() {
            // A lock file that stays is in nobody's way.
            let _ = disk::remove(&self.path);
        }
    }

    /// Lets go of it; a file that is open stays.
    #[cfg(not(unix))]
    fn release(self) {
        drop((self.path, self.file));
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

/// Writes a file under another name, waits until it is on the disk, and renames it.
fn whole_write(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    // Shards that begin together write the same manifest: each to a file of its own first.
    let part = path.with_extension(format!("{}.part", std::process::id()));
    disk::replace(path, &part, bytes).and_then(|()| disk::sync_folder_of(path)).map_err(|error| {
        match Failure::file("write", path, &error) {
            Failure::Undone(text) => Failure::Undone(format!(
                "{text}\nwhat was written before is whole: the same command goes on where this one stopped"
            )),
            other => other,
        }
    })
}
