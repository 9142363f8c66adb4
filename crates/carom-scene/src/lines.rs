//! Lines of a text, found without reading it again for each place.

/// Where the lines of a text start.
pub(crate) struct Lines<'t> {
    text: &'t str,
    starts: Vec<usize>,
}

impl<'t> Lines<'t> {
    pub(crate) fn of(text: &'t str) -> Self {
        let ends = text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n');
        Self { text, starts: std::iter::once(0).chain(ends.map(|(at, _)| at + 1)).collect() }
    }

    /// The line of a byte, from 1.
    pub(crate) fn line_of(&self, byte: usize) -> usize {
        self.starts.partition_point(|start| *start <= byte).max(1)
    }

    /// The first byte of a line, from 1.
    pub(crate) fn start(&self, line: usize) -> usize {
        self.starts.get(line.saturating_sub(1)).copied().unwrap_or(self.text.len())
    }

    /// The text of a line, from 1, without its end.
    pub(crate) fn text(&self, line: usize) -> &'t str {
        let text = &self.text[self.start(line)..self.start(line + 1)];
        let text = text.strip_suffix('\n').unwrap_or(text);
        text.strip_suffix('\r').unwrap_or(text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_counted_from_one_and_have_no_ends() {
        let lines = Lines::of("a\r\nbc\n\nd");
        let found: Vec<usize> = (0..8).map(|byte| lines.line_of(byte)).collect();
        assert_eq!(found, [1, 1, 1, 2, 2, 2, 3, 4], "a line has its end");
        assert_eq!([1, 2, 3, 4, 5].map(|line| lines.text(line)), ["a", "bc", "", "d", ""]);
        assert_eq!((Lines::of("").line_of(0), Lines::of("").text(1)), (1, ""), "an empty text has one line");
    }
}
