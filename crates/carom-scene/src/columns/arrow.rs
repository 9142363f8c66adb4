//! Units as Arrow keeps them: the schema that readers of Parquet look for, with a field's metadata.

use super::Column;

/// The key under which readers look for it.
pub(super) const KEY: &str = "ARROW:schema";

/// Numbers of Arrow's format: version 5 of its messages, a schema as one; integers, floating-point numbers and texts as types; double precision.
const VERSION_5: i16 = 4;
const SCHEMA: u8 = 1;
const INTEGER: u8 = 2;
const FLOATING: u8 = 3;
const TEXT: u8 = 5;
const DOUBLE: i16 = 2;

/// The schema of these columns, each with its unit, as an Arrow message in base 64.
///
/// # Source
/// Apache Arrow, *Columnar Format*: encapsulated message format, `Schema.fbs`, `Message.fbs`; *FlatBuffers internals*.
pub(super) fn schema(columns: &[(&str, Column)], units: &[&str]) -> String {
    let mut flat = Flat::default();
    let root = flat.offset();
    let (message, at) =
        flat.table(&[Slot::Short(VERSION_5), Slot::Byte(SCHEMA), Slot::Offset, Slot::Long(0)]);
    flat.link(root, message);
    let (schema, fields) = flat.table(&[Slot::Nothing, Slot::Offset]);
    flat.link(at[2], schema);
    let (list, each) = flat.list(columns.len());
    flat.link(fields[1], list);
    for (i, (name, column)) in columns.iter().enumerate() {
        let field = flat.field(name, column, units.get(i).copied().unwrap_or_default());
        flat.link(each[i], field);
    }
    flat.align(8);
    let length = flat.bytes.len() as u32;
    let message = [&u32::MAX.to_le_bytes()[..], &length.to_le_bytes(), &flat.bytes].concat();
    base64(&message)
}

/// A value in a table.
#[derive(Clone, Copy)]
enum Slot {
    Nothing,
    Byte(u8),
    Short(i16),
    Int(i32),
    Long(i64),
    /// Of something that is written later.
    Offset,
}

impl Slot {
    fn bytes(self) -> Vec<u8> {
        match self {
            Self::Nothing => vec![],
            Self::Byte(value) => vec![value],
            Self::Short(value) => value.to_le_bytes().to_vec(),
            Self::Int(value) => value.to_le_bytes().to_vec(),
            Self::Long(value) => value.to_le_bytes().to_vec(),
            Self::Offset => vec![0; 4],
        }
    }
}

/// Bytes of a FlatBuffer, written from the front: what points to another thing is written before it, and linked afterwards.
#[derive(Default)]
struct Flat {
    bytes: Vec<u8>,
}

impl Flat {
    fn align(&mut self, size: usize) {
        self.bytes.resize(self.bytes.len().next_multiple_of(size), 0);
    }

    /// Room for an offset.
    fn offset(&mut self) -> usize {
        self.bytes.extend([0; 4]);
        self.bytes.len() - 4
    }

    /// Lets an offset point to what stands at a place behind it.
    fn link(&mut self, offset: usize, to: usize) {
        self.bytes[offset..offset + 4].copy_from_slice(&((to - offset) as u32).to_le_bytes());
    }

    /// A table: its place, and those of its values. Before it stands where each value is within it.
    fn table(&mut self, slots: &[Slot]) -> (usize, Vec<usize>) {
        let mut inside = vec![];
        let mut end = 4_usize;
        for slot in slots {
            let size = slot.bytes().len();
            end = end.next_multiple_of(size.max(1));
            inside.push(if size > 0 { end } else { 0 });
            end += size;
        }
        self.align(8);
        let map = self.bytes.len();
        let size = 4 + 2 * slots.len();
        for number in [size, end].iter().chain(&inside) {
            self.bytes.extend((*number as u16).to_le_bytes());
        }
        self.align(8);
        let place = self.bytes.len();
        self.bytes.extend(((place - map) as i32).to_le_bytes());
        for (slot, at) in slots.iter().zip(&inside).filter(|(_, at)| **at > 0) {
            self.bytes.resize(place + at, 0);
            self.bytes.extend(slot.bytes());
        }
        (place, inside.into_iter().map(|at| place + at).collect())
    }

    /// A list of so many offsets: its place, and theirs.
    fn list(&mut self, length: usize) -> (usize, Vec<usize>) {
        self.align(4);
        let place = self.bytes.len();
        self.bytes.extend((length as u32).to_le_bytes());
        (place, (0..length).map(|_| self.offset()).collect())
    }

    fn text(&mut self, text: &str) -> usize {
        self.align(4);
        let place = self.bytes.len();
        self.bytes.extend((text.len() as u32).to_le_bytes());
        self.bytes.extend(text.as_bytes());
        self.bytes.push(0);
        place
    }

    /// A field that may be empty, with its name, its type and its unit.
    fn field(&mut self, name: &str, column: &Column, unit: &str) -> usize {
        let (kind, about): (u8, &[Slot]) = match column {
            Column::Number(_) => (FLOATING, &[Slot::Short(DOUBLE)]),
            Column::Whole(_) => (INTEGER, &[Slot::Int(64), Slot::Byte(1)]),
            Column::Word(_) => (TEXT, &[]),
        };
        let slots =
            [Slot::Offset, Slot::Byte(1), Slot::Byte(kind), Slot::Offset, Slot::Nothing, Slot::Offset];
        let with_unit = [&slots[..], &[Slot::Offset]].concat();
        let (place, at) = self.table(if unit.is_empty() { &slots } else { &with_unit });
        let name = self.text(name);
        self.link(at[0], name);
        let (kind, _) = self.table(about);
        self.link(at[3], kind);
        let (children, _) = self.list(0);
        self.link(at[5], children);
        if let Some(metadata) = at.get(6) {
            let (list, each) = self.list(1);
            self.link(*metadata, list);
            let (entry, sides) = self.table(&[Slot::Offset, Slot::Offset]);
            self.link(each[0], entry);
            for (side, text) in sides.into_iter().zip(["unit", unit]) {
                let text = self.text(text);
                self.link(side, text);
            }
        }
        place
    }
}

/// RFC 4648, with padding.
fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let group = |three: &[u8]| {
        let at = |i: usize| u32::from(three.get(i).copied().unwrap_or(0));
        let bits = at(0) << 16 | at(1) << 8 | at(2);
        let digit = |i: usize| {
            if i > three.len() { '=' } else { char::from(DIGITS[(bits >> (18 - 6 * i) & 63) as usize]) }
        };
        [0, 1, 2, 3].map(digit)
    };
    bytes.chunks(3).flat_map(group).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base_64_is_that_of_the_standard() {
        // RFC 4648, 10.
        let known = [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foobar", "Zm9vYmFy")];
        for (text, coded) in known {
            assert_eq!(base64(text.as_bytes()), coded, "{text}");
        }
    }

    /// Reads a FlatBuffer by its rules: offsets are from where they stand, a table's map is so far before it.
    struct Read<'b>(&'b [u8]);

    impl Read<'_> {
        fn number(&self, at: usize) -> usize {
            u32::from_le_bytes(self.0[at..at + 4].try_into().unwrap()) as usize
        }

        fn follow(&self, at: usize) -> usize {
            at + self.number(at)
        }

        /// Where the value of a slot stands.
        fn slot(&self, table: usize, slot: usize) -> Option<usize> {
            let map = table - self.number(table);
            let short = |at: usize| usize::from(u16::from_le_bytes([self.0[at], self.0[at + 1]]));
            assert!(table.is_multiple_of(4) && map.is_multiple_of(2), "aligned");
            if 4 + 2 * slot >= short(map) {
                return None;
            }
            Some(short(map + 4 + 2 * slot)).filter(|inside| *inside > 0).map(|inside| table + inside)
        }

        fn text(&self, at: usize) -> &str {
            let place = self.follow(at);
            std::str::from_utf8(&self.0[place + 4..place + 4 + self.number(place)]).unwrap()
        }
    }

    #[test]
    fn a_reader_finds_names_types_and_units() {
        let columns = [
            ("design", Column::Whole(vec![])),
            ("plate.lower.slope", Column::Number(vec![])),
            ("ending", Column::Word(vec![])),
        ];
        let mut flat = Flat::default();
        let fields: Vec<usize> = columns
            .iter()
            .zip(["", "rad", ""])
            .map(|((name, column), unit)| flat.field(name, column, unit))
            .collect();
        let read = Read(&flat.bytes);
        for ((field, (name, _)), kind) in fields.iter().zip(&columns).zip([INTEGER, FLOATING, TEXT]) {
            assert_eq!(read.text(read.slot(*field, 0).unwrap()), *name);
            assert_eq!(read.0[read.slot(*field, 1).unwrap()], 1, "may be empty");
            assert_eq!(read.0[read.slot(*field, 2).unwrap()], kind, "{name}");
            let children = read.follow(read.slot(*field, 5).unwrap());
            assert_eq!(read.number(children), 0, "no children");
        }
        let list = read.follow(read.slot(fields[1], 6).unwrap());
        let entry = read.follow(list + 4);
        let sides = [0, 1].map(|side| read.text(read.slot(entry, side).unwrap()));
        assert_eq!((read.number(list), sides), (1, ["unit", "rad"]));
        assert!(
            read.slot(fields[0], 6).is_none() && read.slot(fields[2], 6).is_none(),
            "no unit, no metadata"
        );
    }
}
