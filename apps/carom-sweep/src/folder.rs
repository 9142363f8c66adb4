//! The folder of a sweep: part files that are whole or not there, and who may write to it.

use crate::disk;
use crate::list_file::fingerprint;
use crate::lock::Lock;
use carom::tasks::StudyError;
use carom::tasks::axes::Asker;
use carom_scene::columns::{Column, about, is_sealed, read};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fs::{File, TryLockError};
use std::io::ErrorKind;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// How often each ending occurs.
pub(crate) type Counts = BTreeMap<String, u64>;
/// Columns by name.
pub(crate) type Rows = Vec<(String, Column)>;

/// The file that says what is swept.
const MANIFEST: &str = "_sweep.json";
/// How the lock file of a shard begins.
const SHARD: &str = ".shard-";
/// The folder of finished steps whose part is not finished.
const UNFINISHED: &str = "unfinished";
/// Where a file's metadata says of which sweep it is, which rows it holds, and how they end.
pub(crate) const FINGERPRINT: &str = "sweep";
pub(crate) const ROWS: &str = "rows";
pub(crate) const ENDINGS: &str = "endings";

/// What a file's metadata say of its rows: `0..1000000`.
pub(crate) fn rows(rows: &Range<u64>) -> String {
    format!("{}..{}", rows.start, rows.end)
}

/// What a file holds.
enum Held {
    Nothing,
    Rows(Counts),
    /// And why they are not the rows that they should be.
    Damaged(String),
    /// Rows of another sweep.
    Foreign,
}

/// Hears what is found on the way.
pub(crate) type Tell<'s> = Box<dyn Fn(&str) + Send + 's>;

/// A folder that is open for one shard.
pub(crate) struct Folder<'s> {
    path: PathBuf,
    /// Is told what is found damaged.
    tell: Tell<'s>,
    asker: Asker,
    fingerprint: String,
    /// The parts that were looked at.
    parts: RefCell<BTreeMap<u64, Option<Counts>>>,
    /// This shard's, and the folder's: held for as long as this process writes.
    locks: [Lock; 2],
}

impl<'s> Folder<'s> {
    /// Opens a folder for a sweep, anew or to go on with it.
    pub(crate) fn open(
        path: PathBuf,
        manifest: &str,
        (shard, of): (u64, u64),
        (force, asker): (bool, Asker),
        tell: Tell<'s>,
    ) -> Result<Self, StudyError> {
        disk::make_folder(&path).map_err(|error| disk::undone("make the folder", &path, &error))?;
        let whole = Lock::take(path.join(".sweep.lock"), of > 1)?;
        // Every process takes its own lock before it looks at others': of two that begin together one at least sees the other.
        let own = Lock::take(path.join(format!("{SHARD}{}-of-{of}.lock", shard + 1)), false)?;
        let folder = Self {
            path,
            tell,
            asker,
            fingerprint: fingerprint(manifest.as_bytes()),
            parts: RefCell::default(),
            locks: [own, whole],
        };
        folder.refuse_other_shards(of)?;
        folder.remove_rests((shard, of))?;
        folder.claim(manifest, of > 1, force)?;
        Ok(folder)
    }

    /// Lets others in; where nobody else is at work no lock file is left.
    pub(crate) fn close(self) {
        let [own, whole] = self.locks;
        own.release(|| {});
        // It stays where steps are left in it. Another shard may be about to write one.
        whole.release(|| {
            let _ = std::fs::remove_dir(self.path.join(UNFINISHED));
        });
    }

    /// How who asks takes another folder.
    fn another(&self) -> &'static str {
        match self.asker {
            Asker::Command => "name another folder with --out",
            Asker::Call => "name another folder",
        }
    }

    /// The files of the folder, by name.
    fn files(&self) -> Result<Vec<(String, PathBuf)>, StudyError> {
        disk::list(&self.path).map_err(|error| disk::undone("read", &self.path, &error))
    }

    /// Shards of two counts would do the same parts twice.
    fn refuse_other_shards(&self, of: u64) -> Result<(), StudyError> {
        for (name, path) in self.files()? {
            let count = name.strip_prefix(SHARD).and_then(|name| name.strip_suffix(".lock"));
            let Some((_, count)) = count.and_then(|count| count.split_once("-of-")) else { continue };
            let Ok(file) = File::open(&path) else { continue };
            if count != of.to_string() && matches!(file.try_lock_shared(), Err(TryLockError::WouldBlock)) {
                return Err(StudyError::Undone(format!(
                    "another process is sweeping into {} as one of {count} shards: all of them must have one count",
                    self.path.display()
                )));
            }
        }
        Ok(())
    }

    /// Removes what writes left that were killed. Other shards may be at work: then only those of this shard's steps.
    fn remove_rests(&self, (shard, of): (u64, u64)) -> Result<(), StudyError> {
        for (name, path) in self.all_files()? {
            let Some(name) = name.strip_suffix(".part") else { continue };
            let step =
                name.strip_prefix("step-").and_then(|name| name.split('.').next()?.parse::<u64>().ok());
            let own = match step {
                Some(step) => step % of == shard,
                None => of == 1 && (name.starts_with("_sweep.") || name.starts_with("part-")),
            };
            if own {
                remove(&path)?;
            }
        }
        Ok(())
    }

    /// Sees to it that the folder is of this sweep.
    fn claim(&self, manifest: &str, shared: bool, force: bool) -> Result<(), StudyError> {
        let file = self.path.join(MANIFEST);
        let known = match disk::read(&file) {
            Ok(known) => Some(known),
            Err(error) if error.kind() == ErrorKind::NotFound => None,
            Err(error) => return Err(disk::undone("read", &file, &error)),
        };
        let folder = self.path.display();
        let refused = |why: &str| {
            let (another, force) = (self.another(), self.asker.option("force"));
            let what = format!("{folder} {why}: {another}, or replace it with {force}");
            Err(StudyError::Asked(what))
        };
        match known {
            Some(known) if known == manifest.as_bytes() && !force => return Ok(()),
            Some(_) if force && shared => {
                let [force, shard] = ["force", "shard"].map(|option| self.asker.option(option));
                return Err(StudyError::Asked(format!(
                    "{force} and {shard} exclude each other: other shards may be at work"
                )));
            }
            _ if force => self.clear()?,
            Some(known) if serde_json::from_slice::<serde_json::Value>(&known).is_ok() => {
                return refused("is of another sweep");
            }
            // It was not written to its end, or damaged: what it is of, the files beside it say.
            Some(_) if self.is_of_this_sweep()? => {
                (self.tell)(&format!(
                    "{} is damaged, the files beside it are of this sweep: it is written anew",
                    file.display()
                ));
            }
            Some(_) => {
                return refused(&format!("has a damaged {MANIFEST}, and files that are not of this sweep"));
            }
            None if self.tables()?.is_empty() => {}
            None => return refused(&format!("holds part files without a {MANIFEST}")),
        }
        whole_write(&file, manifest.as_bytes())
    }

    /// The files of the folder and of that of finished steps, by name.
    fn all_files(&self) -> Result<Vec<(String, PathBuf)>, StudyError> {
        let steps = self.path.join(UNFINISHED);
        let mut found = self.files()?;
        match disk::list(&steps) {
            Ok(more) => found.extend(more),
            Err(error) if error.kind() == ErrorKind::NotFound => {}
            Err(error) => return Err(disk::undone("read", &steps, &error)),
        }
        Ok(found)
    }

    /// The part files, and the finished steps of those that are not finished.
    fn tables(&self) -> Result<Vec<PathBuf>, StudyError> {
        let table =
            |(name, path): (String, PathBuf)| (name.ends_with(".parquet") && path.is_file()).then_some(path);
        Ok(self.all_files()?.into_iter().filter_map(table).collect())
    }

    /// True where files that are whole are of this sweep, and of no other; and where there is none.
    fn is_of_this_sweep(&self) -> Result<bool, StudyError> {
        let tables = self.tables()?;
        let mut own = tables.is_empty();
        for path in tables {
            match self.look(&path, None)?.0 {
                Held::Foreign => return Ok(false),
                Held::Rows(_) => own = true,
                Held::Nothing | Held::Damaged(_) => {}
            }
        }
        Ok(own)
    }

    /// Removes every part file and every step.
    fn clear(&self) -> Result<(), StudyError> {
        self.tables()?.iter().try_for_each(|path| remove(path))
    }

    /// The name of a part file.
    pub(crate) fn part(&self, part: u64) -> PathBuf {
        self.path.join(format!("part-{part:08}.parquet"))
    }

    /// The name of a finished step of a part that is not finished.
    fn step(&self, step: u64) -> PathBuf {
        self.path.join(UNFINISHED).join(format!("step-{step:010}.parquet"))
    }

    /// The fingerprint of what is swept.
    pub(crate) fn fingerprint(&self) -> &str {
        &self.fingerprint
    }

    /// What a file holds, and its bytes where it is whole; `rows` are those that it should hold.
    fn look(&self, path: &Path, rows: Option<&Range<u64>>) -> Result<(Held, Vec<u8>), StudyError> {
        if !path.is_file() {
            return Ok((Held::Nothing, vec![]));
        }
        let bytes = match disk::read(path) {
            Ok(bytes) => bytes,
            // Another shard has put it into a part meanwhile.
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok((Held::Nothing, vec![])),
            Err(error) => return Err(disk::undone("read", path, &error)),
        };
        let told = if is_sealed(&bytes) { about(bytes.clone()).unwrap_or_default() } else { vec![] };
        let of = |wanted: &str| told.iter().find(|(key, _)| key == wanted).map(|(_, value)| value.as_str());
        let held = match (of(FINGERPRINT), of(ROWS)) {
            (Some(sweep), _) if sweep != self.fingerprint => Held::Foreign,
            (Some(_), Some(found)) if rows.is_none_or(|rows| found == self::rows(rows)) => {
                Held::Rows(serde_json::from_str(of(ENDINGS).unwrap_or("{}")).map_err(crate::no_json)?)
            }
            (Some(_), Some(found)) => {
                Held::Damaged(format!("holds the designs {found}, which belong elsewhere"))
            }
            _ => Held::Damaged("is damaged: its bytes are not those that were written".to_owned()),
        };
        Ok((held, bytes))
    }

    /// How often each ending occurs in a file that should hold these rows; `None` where they must be swept.
    ///
    /// # Errors
    /// The file is of another sweep, or cannot be read.
    fn counts(&self, path: &Path, rows: &Range<u64>) -> Result<Option<Counts>, StudyError> {
        match self.look(path, Some(rows))?.0 {
            Held::Nothing => Ok(None),
            Held::Rows(counts) => Ok(Some(counts)),
            Held::Damaged(why) => {
                (self.tell)(&format!("{} {why}: they are swept again", path.display()));
                Ok(None)
            }
            Held::Foreign => Err(StudyError::Asked(format!(
                "{} is of another sweep: remove it, {}, or replace all with {}",
                path.display(),
                self.another(),
                self.asker.option("force")
            ))),
        }
    }

    /// The endings of a part, where it is there as a whole: each part is read once.
    pub(crate) fn of_part(&self, part: u64, rows: &Range<u64>) -> Result<Option<Counts>, StudyError> {
        if let Some(known) = self.parts.borrow().get(&part) {
            return Ok(known.clone());
        }
        let found = self.counts(&self.part(part), rows)?;
        self.parts.borrow_mut().insert(part, found.clone());
        Ok(found)
    }

    /// The endings of a step, where it is there as a whole.
    pub(crate) fn of_step(&self, step: u64, rows: &Range<u64>) -> Result<Option<Counts>, StudyError> {
        self.counts(&self.step(step), rows)
    }

    /// True where there is a file of a step.
    pub(crate) fn has_step(&self, step: u64) -> bool {
        self.step(step).is_file()
    }

    /// The columns of a step; `None` where it is no longer there as a whole.
    pub(crate) fn columns(&self, step: u64, rows: &Range<u64>) -> Result<Option<Rows>, StudyError> {
        match self.look(&self.step(step), Some(rows))? {
            (Held::Rows(_), bytes) => {
                Ok(Some(read(bytes).map_err(|error| StudyError::Undone(error.to_string()))?))
            }
            _ => Ok(None),
        }
    }

    /// Writes a step: it is there as a whole afterwards, or not at all.
    pub(crate) fn write_step(&self, step: u64, bytes: &[u8]) -> Result<(), StudyError> {
        let place = self.path.join(UNFINISHED);
        disk::make_folder(&place).map_err(|error| disk::undone("make the folder", &place, &error))?;
        whole_write(&self.step(step), bytes)
    }

    /// Writes a part, as a step is written.
    pub(crate) fn write_part(&self, part: u64, bytes: &[u8], counts: Counts) -> Result<(), StudyError> {
        whole_write(&self.part(part), bytes)?;
        self.parts.borrow_mut().insert(part, Some(counts));
        Ok(())
    }

    /// Removes a step whose part is finished.
    pub(crate) fn drop_step(&self, step: u64) -> Result<(), StudyError> {
        let path = self.step(step);
        if path.is_file() { remove(&path) } else { Ok(()) }
    }

    /// Forgets what is not known to be there: others may have finished parts since.
    pub(crate) fn look_again(&self) {
        self.parts.borrow_mut().retain(|_, known| known.is_some());
    }

    pub(crate) fn path(&self) -> &Path {
        &self.path
    }
}

/// Writes a file under another name, waits until it is on the disk, and renames it.
fn whole_write(path: &Path, bytes: &[u8]) -> Result<(), StudyError> {
    // Shards that begin together write the same manifest: each to a file of its own first.
    let part = path.with_extension(format!("{}.part", std::process::id()));
    disk::replace(path, &part, bytes).and_then(|()| disk::sync_folder_of(path)).map_err(|error| {
        match disk::undone("write", path, &error) {
            StudyError::Undone(text) => StudyError::Undone(format!(
                "{text}\nwhat was written before is whole: the same command goes on where this one stopped"
            )),
            other => other,
        }
    })
}

/// Removes a file, if another shard has not.
fn remove(path: &Path) -> Result<(), StudyError> {
    match disk::remove(path) {
        Err(error) if error.kind() != ErrorKind::NotFound => Err(disk::undone("remove", path, &error)),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a failure is a failed test")]

    use super::*;

    /// One shard may come to its end between the moment at which another has made the folder of steps and that at which it writes one.
    #[test]
    fn the_folder_of_steps_stays_while_another_shard_is_at_work() {
        let place = std::env::temp_dir().join(format!("carom-shards-{}", std::process::id()));
        let open = |shard| {
            Folder::open(place.clone(), "{}", (shard, 2), (false, Asker::Command), Box::new(|_| {})).unwrap()
        };
        let (first, second) = (open(0), open(1));
        let steps = place.join(UNFINISHED);
        disk::make_folder(&steps).unwrap();
        first.close();
        assert!(steps.is_dir());
        second.close();
        assert!(!steps.exists());
        std::fs::remove_dir_all(place).unwrap();
    }
}
