//! A checksum within a file of all its bytes.

/// The key of a file's metadata under which its seal stands: the last one, with [`OPEN`] as its value until the file is sealed.
const KEY: &str = "seal";
/// A seal that is not set yet; a file is summed with this in its place.
const OPEN: &str = "0000000000000000";
/// The entry of metadata that [`sealed`] fills in.
///
/// # Example
/// ```
/// # if !carom_scene::columns::HAS_PARQUET { return Ok(()); }
/// use carom_scene::columns::{Column, SEAL, parquet, sealed};
/// let bytes = parquet(&[("count", Column::Whole(vec![Some(1)]))], &[SEAL])?;
/// assert!(sealed(bytes).is_some());
/// # Ok::<(), carom_scene::columns::ColumnsError>(())
/// ```
pub const SEAL: (&str, &str) = (KEY, OPEN);

/// Sets the seal of a file that was written with [`SEAL`] as the last entry of its metadata; `None` where it has none.
///
/// The seal is Fowler, Noll and Vo's hash (FNV-1a, 64 bits) of all bytes, with zeros in its own place. Each step of it is a bijection of the
/// state: one byte that is another always gives another sum, and of any other damage one case in 2⁶⁴ passes.
///
/// # Source
/// Fowler, Noll, Vo, Eastlake, *The FNV Non-Cryptographic Hash Algorithm*, IETF draft.
///
/// # Example
/// ```
/// # if !carom_scene::columns::HAS_PARQUET { return Ok(()); }
/// use carom_scene::columns::{Column, SEAL, is_sealed, parquet, sealed};
/// let bytes = parquet(&[("count", Column::Whole(vec![Some(1)]))], &[SEAL])?;
/// assert!(!is_sealed(&bytes));
/// let mut whole = sealed(bytes).unwrap();
/// assert!(is_sealed(&whole));
/// whole[30] ^= 1;
/// assert!(!is_sealed(&whole));
/// # Ok::<(), carom_scene::columns::ColumnsError>(())
/// ```
pub fn sealed(mut file: Vec<u8>) -> Option<Vec<u8>> {
    let place = place(&file)?;
    let seal = sum(&file, place);
    file[place..place + OPEN.len()].copy_from_slice(seal.as_bytes());
    Some(file)
}

/// True where all bytes of a file are those that were sealed.
///
/// # Example
/// What has no seal is not sealed.
/// ```
/// assert!(!carom_scene::columns::is_sealed(b"PAR1"));
/// ```
pub fn is_sealed(file: &[u8]) -> bool {
    place(file).is_some_and(|place| file[place..place + OPEN.len()] == *sum(file, place).as_bytes())
}

/// Where the seal stands: the value of the last entry of that key, as Thrift's compact protocol writes keys and values.
fn place(file: &[u8]) -> Option<usize> {
    let entry = [&[0x18, KEY.len() as u8][..], KEY.as_bytes(), &[0x18, OPEN.len() as u8]].concat();
    let starts = file.len().checked_sub(entry.len() + OPEN.len())?;
    let at = (0..=starts).rev().find(|at| file[*at..].starts_with(&entry))?;
    Some(at + entry.len())
}

/// The sum of a file, with zeros in the place of the seal.
fn sum(file: &[u8], place: usize) -> String {
    let (before, rest) = file.split_at(place);
    let bytes = before.iter().chain(OPEN.as_bytes()).chain(&rest[OPEN.len()..]);
    let add = |sum: u64, byte: &u8| (sum ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
    format!("{:016x}", bytes.fold(0xcbf2_9ce4_8422_2325, add))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(feature = "parquet")]
    #[test]
    fn every_byte_is_sealed() {
        use crate::columns::{Column, parquet};
        let columns = [("x", Column::Number(vec![Some(1.0), None])), ("w", Column::Word(vec![None; 2]))];
        let whole = sealed(parquet(&columns, &[("about", "a table"), SEAL]).unwrap()).unwrap();
        assert!(is_sealed(&whole), "as it was written");
        for k in 0..whole.len() {
            let mut damaged = whole.clone();
            damaged[k] ^= 0x40;
            assert!(!is_sealed(&damaged), "byte {k} of {}", whole.len());
            assert!(!is_sealed(&whole[..k]), "cut at {k}");
        }
        assert_eq!(sealed(whole.clone()).as_deref(), Some(&whole[..]), "again");
    }

    #[test]
    fn the_sum_is_that_of_the_draft() {
        // FNV-1a of "foobar", 64 bits: 85944171f73967e8; the seal stands behind it here, and is summed as zeros.
        let sum_of = |text: &[u8]| {
            text.iter()
                .fold(0xcbf2_9ce4_8422_2325_u64, |s, b| (s ^ u64::from(*b)).wrapping_mul(0x0100_0000_01b3))
        };
        assert_eq!(sum_of(b"foobar"), 0x8594_4171_f739_67e8, "published");
        let file = [&b"foobar"[..], OPEN.as_bytes()].concat();
        assert_eq!(sum(&file, 6), format!("{:016x}", sum_of(&file)), "zeros in its place");
    }
}
