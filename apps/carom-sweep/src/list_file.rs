//! The file of a list of designs: read several times, whatever it is.

use crate::disk;
use carom::tasks::StudyError;
use carom_scene::input;
use std::io::{BufRead, BufReader, Cursor, Error, ErrorKind, Read, Result as Done};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Longest line [bytes]: what is longer is no list.
const LONGEST_LINE: u64 = 1 << 20;

/// A list, which may be a pipe or a device: then it is read once, and kept.
pub(crate) struct ListFile {
    path: PathBuf,
    kept: Option<Arc<[u8]>>,
}

impl ListFile {
    pub(crate) fn new(path: &Path) -> Result<Self, StudyError> {
        let unread = |error: Error| disk::unread(path, &error);
        let lasting = input::is_lasting(path);
        let kept = if lasting { None } else { Some(disk::read_input(path).map_err(unread)?.into()) };
        Ok(Self { path: path.to_owned(), kept })
    }

    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    fn open(&self) -> Result<Box<dyn BufRead>, StudyError> {
        match &self.kept {
            Some(bytes) => Ok(Box::new(Cursor::new(Arc::clone(bytes)))),
            None => {
                let opened = disk::open(&self.path).map_err(|error| disk::unread(&self.path, &error))?;
                Ok(Box::new(BufReader::new(opened)))
            }
        }
    }

    /// Its lines from the first on.
    pub(crate) fn lines(&self) -> Result<Lines, StudyError> {
        Ok(Lines { from: self.open()?, path: self.path.clone(), over: false })
    }

    /// Its length and fingerprint.
    pub(crate) fn fingerprint(&self) -> Result<String, StudyError> {
        fingerprint_of(self.open()?).map_err(|error| disk::unread(&self.path, &error))
    }
}

/// Lines of a list; after one that cannot be read there are no more.
pub(crate) struct Lines {
    from: Box<dyn BufRead>,
    path: PathBuf,
    over: bool,
}

impl Lines {
    fn read(&mut self) -> Done<Option<String>> {
        let mut bytes = vec![];
        (&mut self.from).take(LONGEST_LINE + 1).read_until(b'\n', &mut bytes)?;
        if bytes.len() as u64 > LONGEST_LINE {
            let why = format!("has a line of more than {} MiB: it is no list", LONGEST_LINE >> 20);
            return Err(Error::new(ErrorKind::InvalidData, why));
        }
        let text = String::from_utf8(bytes);
        let text = text.map_err(|_| Error::new(ErrorKind::InvalidData, "is not UTF-8 text"))?;
        Ok((!text.is_empty()).then_some(text))
    }
}

impl Iterator for Lines {
    type Item = Result<String, StudyError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.over {
            return None;
        }
        let found = self.read();
        self.over = !matches!(found, Ok(Some(_)));
        found.map_err(|error| disk::unread(&self.path, &error)).transpose()
    }
}

/// Length and fingerprint of what can be read to its end.
pub(crate) fn fingerprint_of(mut from: impl BufRead) -> Done<String> {
    let (mut hash, mut length) = (EMPTY, 0);
    loop {
        let bytes = from.fill_buf()?;
        if bytes.is_empty() {
            return Ok(format!("{length} bytes, {hash:016x}"));
        }
        let count = bytes.len();
        hash = hashed(hash, bytes);
        length += count as u64;
        from.consume(count);
    }
}

/// The fingerprint of a text.
pub(crate) fn fingerprint(bytes: &[u8]) -> String {
    format!("{:016x}", hashed(EMPTY, bytes))
}

/// The hash of nothing.
const EMPTY: u64 = 0xcbf2_9ce4_8422_2325;

/// Fowler, Noll and Vo's hash (FNV-1a, 64 bits) of what was hashed before and these bytes: tells two sweeps apart, not two authors.
fn hashed(before: u64, bytes: &[u8]) -> u64 {
    bytes.iter().fold(before, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3))
}
