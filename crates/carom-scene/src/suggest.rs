//! The word that was probably meant.

/// So many names are told where one is wrong.
const LIKEST: usize = 3;

/// The allowed word nearest to `word`, where it is near enough to be a slip of the pen: at most every third letter is wrong.
///
/// # Example
/// A letter that is left out is a slip of the pen.
/// ```
/// assert_eq!(carom_scene::nearest("fricton", &["friction", "restitution"]), Some("friction"));
/// assert_eq!(carom_scene::nearest("colour", &["friction", "restitution"]), None);
/// ```
pub fn nearest<'a>(word: &str, allowed: &[&'a str]) -> Option<&'a str> {
    let by_distance = allowed.iter().map(|candidate| (distance(word, candidate), *candidate));
    let (distance, candidate) = by_distance.min_by_key(|(distance, _)| *distance)?;
    (3 * distance <= word.chars().count()).then_some(candidate)
}

/// The allowed names that are most like `name`, the likest first: those with most of its words, and of these the nearest.
pub(crate) fn likest<'a>(name: &str, allowed: &[&'a str]) -> Vec<&'a str> {
    let words = |text: &str| -> Vec<String> {
        let parts = text.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
        parts.map(str::to_lowercase).collect()
    };
    let written = words(name);
    let strange = |candidate: &str| {
        let known: Vec<String> = words(candidate);
        let known: Vec<&str> = known.iter().map(String::as_str).collect();
        written.iter().filter(|word| nearest(word, &known).is_none()).count()
    };
    let mut near: Vec<&str> = allowed.to_vec();
    near.sort_by_key(|candidate| (strange(candidate), distance(name, candidate)));
    near.truncate(LIKEST);
    near
}

/// Insertions, deletions, replacements and swaps of neighbours that lead from one word to the other.
fn distance(a: &str, b: &str) -> usize {
    let a: Vec<char> = a.to_lowercase().chars().collect();
    let b: Vec<char> = b.to_lowercase().chars().collect();
    let width = b.len() + 1;
    let mut table = vec![0; (a.len() + 1) * width];
    for i in 0..=a.len() {
        for j in 0..=b.len() {
            table[i * width + j] = if i == 0 || j == 0 {
                i + j
            } else {
                let replaced = table[(i - 1) * width + j - 1] + usize::from(a[i - 1] != b[j - 1]);
                let shorter = table[(i - 1) * width + j].min(table[i * width + j - 1]) + 1;
                let swapped = if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                    table[(i - 2) * width + j - 2] + 1
                } else {
                    usize::MAX
                };
                replaced.min(shorter).min(swapped)
            };
        }
    }
    table[a.len() * width + b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slips_of_the_pen_are_understood() {
        let keys = ["friction", "restitution", "law"];
        assert_eq!(nearest("fricton", &keys), Some("friction"));
        assert_eq!(nearest("firction", &keys), Some("friction"));
        assert_eq!(nearest("Restitution", &keys), Some("restitution"));
        assert_eq!(nearest("colour", &keys), None);
        assert_eq!(nearest("x", &keys), None);
    }

    #[test]
    fn a_short_word_is_not_turned_into_another() {
        let keys = ["name", "wall", "slope", "gap", "want", "mass"];
        for word in ["wind", "tall", "cap!", "gear", "ab"] {
            assert_eq!(nearest(word, &keys).filter(|near| distance(word, near) > 1), None, "{word}");
        }
        assert_eq!((nearest("wind", &keys), nearest("height", &keys)), (None, None));
        assert_eq!((nearest("gpa", &keys), nearest("mas", &keys)), (Some("gap"), Some("mass")));
    }

    #[test]
    fn a_swap_of_neighbours_is_one_slip() {
        assert_eq!(distance("lsope", "slope"), 1);
        assert_eq!(distance("", "abc"), 3);
    }
}
