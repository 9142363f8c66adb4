//! Records of a CSV file (RFC 4180), one a line.

use std::ops::Range;

/// The cells of a line, without the blanks around them; a cell in quotes may hold commas, and quotes as `""`.
///
/// # Errors
/// Quotes that are not closed on the line, or with more than blanks beside them.
pub fn cells(line: &str) -> Result<Vec<String>, String> {
    Ok(placed(line)?.into_iter().map(|(cell, _)| cell).collect())
}

/// As [`cells`], each with the bytes of the line on which it stands.
///
/// # Errors
/// As [`cells`].
pub fn placed(line: &str) -> Result<Vec<(String, Range<usize>)>, String> {
    let mut found = vec![];
    let mut start = 0;
    loop {
        let (cell, after) = cell(&line[start..])?;
        let end = line.len() - after.map_or(0, |after| after.len() + 1);
        let written = &line[start..end];
        let from = start + written.len() - written.trim_start().len();
        found.push((cell, from..from + written.trim().len()));
        match after {
            Some(after) => start = line.len() - after.len(),
            None => return Ok(found),
        }
    }
}

/// The first cell, and what follows its comma; nothing follows the last one.
fn cell(text: &str) -> Result<(String, Option<&str>), String> {
    let Some(quoted) = text.trim_start().strip_prefix('"') else {
        return Ok(match text.split_once(',') {
            Some((cell, after)) => (cell.trim().to_owned(), Some(after)),
            None => (text.trim().to_owned(), None),
        });
    };
    let (mut cell, mut rest) = (String::new(), quoted);
    loop {
        let Some((inside, after)) = rest.split_once('"') else {
            return Err(format!("the quotes of \"{} are not closed on the line", quoted.trim_end()));
        };
        cell += inside;
        match after.strip_prefix('"') {
            Some(after) => {
                cell.push('"');
                rest = after;
            }
            None => {
                let cell = cell.trim().to_owned();
                let (beside, after) = after.split_once(',').map_or((after, None), |(b, a)| (b, Some(a)));
                if beside.trim().is_empty() {
                    return Ok((cell, after));
                }
                return Err(format!("\"{}\" stands beside the quotes of \"{cell}\"", beside.trim()));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(line: &str) -> Vec<String> {
        cells(line).unwrap()
    }

    #[test]
    fn quotes_are_taken_off() {
        assert_eq!(of(r#""plate.1.slope", "15 deg" ,0.2"#), ["plate.1.slope", "15 deg", "0.2"]);
        assert_eq!(of(r#""a,b","say ""no""","#), ["a,b", "say \"no\"", ""]);
        assert_eq!(of(""), [""]);
        assert_eq!(of(" 1 , 2"), ["1", "2"]);
    }

    #[test]
    fn cells_know_where_they_stand() {
        let line = "a,  \"b c\" ,, d ";
        let places: Vec<&str> = placed(line).unwrap().into_iter().map(|(_, place)| &line[place]).collect();
        assert_eq!(places, ["a", "\"b c\"", "", "d"]);
    }

    #[test]
    fn broken_quotes_are_told() {
        assert!(cells("\"15 deg,2").unwrap_err().contains("not closed"));
        assert!(cells("\"15\" deg,2").unwrap_err().contains("beside"));
    }
}
