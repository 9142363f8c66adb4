//! Straight pieces, chained to polylines.

use super::Boundary;
use super::lattice::Crossing;
use super::refine::{Drawn, Link, Vertex};
use std::collections::BTreeMap;

/// Chains the links of every pair of labels: open lines first, then loops.
pub(super) fn boundaries<L: Copy + Ord>(crossings: &[Crossing<L>], drawn: &Drawn<L>) -> Vec<Boundary<L>> {
    let mut pairs: BTreeMap<[L; 2], Vec<&Link<L>>> = BTreeMap::new();
    for link in &drawn.links {
        pairs.entry(link.pair).or_default().push(link);
    }
    let mut found = vec![];
    for (pair, links) in pairs {
        let mut chains = Chains::new(&links);
        while let Some((vertices, closed)) = chains.next_chain() {
            let end = |vertex: Option<&Vertex>| match vertex {
                Some(Vertex::Junction(number)) => Some(*number),
                Some(Vertex::Crossing(_)) | None => None,
            };
            let ends = if closed { [None; 2] } else { [end(vertices.first()), end(vertices.last())] };
            let points = vertices.iter().map(|vertex| match *vertex {
                Vertex::Crossing(number) => crossings[number].at,
                Vertex::Junction(number) => drawn.junctions[number].at,
            });
            let points = points.collect();
            found.push(Boundary { pair, points, closed, ends });
        }
    }
    found
}

struct Chains {
    /// Links that are left at each vertex, with the vertex they lead to.
    left: BTreeMap<Vertex, Vec<Vertex>>,
}

impl Chains {
    fn new<L>(links: &[&Link<L>]) -> Self {
        let mut left: BTreeMap<Vertex, Vec<Vertex>> = BTreeMap::new();
        for Link { ends: [a, b], .. } in links {
            left.entry(*a).or_default().push(*b);
            left.entry(*b).or_default().push(*a);
        }
        Self { left }
    }

    fn next_chain(&mut self) -> Option<(Vec<Vertex>, bool)> {
        self.left.retain(|_, others| !others.is_empty());
        let is_end = |(vertex, others): &(&Vertex, &Vec<Vertex>)| {
            matches!(vertex, Vertex::Junction(_)) || others.len() != 2
        };
        let (end, _) = self.left.iter().find(is_end).or_else(|| self.left.iter().next())?;
        let start = *end;
        let mut chain = vec![start];
        let mut here = start;
        while let Some(next) = self.step(here) {
            if next == start && !matches!(start, Vertex::Junction(_)) {
                return Some((chain, true));
            }
            chain.push(next);
            here = next;
            if matches!(here, Vertex::Junction(_)) {
                break;
            }
        }
        Some((chain, false))
    }

    /// Takes the first link that is left here.
    fn step(&mut self, here: Vertex) -> Option<Vertex> {
        let others = self.left.get_mut(&here).filter(|others| !others.is_empty())?;
        let next = others.remove(0);
        if let Some(back) = self.left.get_mut(&next)
            && let Some(k) = back.iter().position(|vertex| *vertex == here)
        {
            back.remove(k);
        }
        Some(next)
    }
}
