//! Choices of some of several contacts.

/// Every choice of so many of the members.
pub(crate) fn subsets<const N: usize>(members: &[usize], size: usize) -> impl Iterator<Item = [bool; N]> {
    let mut chosen: Option<Vec<usize>> = Some((0..size).collect());
    std::iter::from_fn(move || {
        let places = chosen.take()?;
        let mut clocks = [false; N];
        places.iter().for_each(|&place| clocks[members[place]] = true);
        // The last place that can move on does, and those behind it follow.
        let movable = (0..size).rev().find(|&k| places[k] + size - k < members.len());
        chosen = movable.map(|k| {
            let from = places[k] + 1;
            places[..k].iter().copied().chain(from..from + size - k).collect()
        });
        Some(clocks)
    })
}
