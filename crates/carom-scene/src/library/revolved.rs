//! Bodies of revolution by their profile.

use super::{Made, revolved};
use crate::chain::{ChainDrawing, corners_of};
use crate::problem::{Problem, ProblemKind};
use crate::tolerance::OUTLINE_ROUNDING;
use carom_motion::planar::ChainPoint;
use carom_num::Vec2;
use carom_num::elementary::sin_cos;
use std::f64::consts::PI;

/// A body of revolution about the x axis.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Revolved {
    pub(crate) profile: ChainDrawing,
    pub(crate) bore: Option<ChainDrawing>,
}

impl Revolved {
    pub(super) fn make(&self) -> Result<Made, Vec<Problem>> {
        let points = |chain: &ChainDrawing| {
            let points = chain.points(false)?;
            let problems = forward(chain, &points);
            if problems.is_empty() { Ok(points) } else { Err(problems) }
        };
        let mut problems = vec![];
        let mut read = |chain: &ChainDrawing| points(chain).map_err(|found| problems.extend(found)).ok();
        let (profile, bore) = (read(&self.profile), self.bore.as_ref().map(&mut read));
        let (Some(profile), Some(bore)) = (profile, bore.map_or(Some(vec![]), |bore| bore)) else {
            return Err(problems);
        };
        let ends = [profile.first(), profile.last()].map(|end| end.map_or(0.0, |end| end.at.y));
        if ends != [0.0, 0.0] {
            let message = "starts and ends on the axis, where the radius is 0";
            return Err(vec![whole(&self.profile, message)]);
        }
        if let Some(chain) = &self.bore
            && !lies_within(&corners_of(&bore), &corners_of(&profile))
        {
            return Err(vec![whole(chain, "leaves no wall: it reaches out of the profile")]);
        }
        Ok(revolved(&profile, &bore, vec![]))
    }
}

fn whole(chain: &ChainDrawing, message: &str) -> Problem {
    Problem::new(ProblemKind::Geometry, &chain.path, message, Some(chain.span.clone()))
}

/// What is wrong with a profile: it lies on one side of the axis and never runs back along it, so that its shadow is its outline.
fn forward(chain: &ChainDrawing, points: &[ChainPoint]) -> Vec<Problem> {
    let mut found = vec![];
    let at = |i: usize, message: &str| {
        let path = format!("{}.{}", chain.path, chain.stops[i].number);
        Problem::new(ProblemKind::Geometry, path, message, Some(chain.span.clone()))
    };
    for (i, point) in points.iter().enumerate() {
        if point.at.y < 0.0 {
            found.push(at(i, "lies below the axis: a radius is 0 or more"));
        }
    }
    for (i, pair) in points.windows(2).enumerate() {
        let chord = pair[1].at - pair[0].at;
        let (sin, cos) = sin_cos(0.5 * pair[0].sweep);
        // An arc of at most half a turn runs backwards nowhere if it does so at neither end.
        let [leaves, arrives] = [-sin, sin].map(|sin| chord.rotated(cos, sin).x);
        let back = -OUTLINE_ROUNDING * chord.norm();
        if leaves < back || arrives < back || pair[0].sweep.abs() > PI * (1.0 + OUTLINE_ROUNDING) {
            found.push(at(i + 1, "the way to here runs back along the axis: from one end to the other, points and arcs only run forward"));
        }
    }
    if found.is_empty() && corners_of(points).iter().any(|p| p.y < 0.0) {
        found.push(whole(chain, "an arc of it dips below the axis"));
    }
    found
}

/// True where one profile is nowhere farther from the axis than another, and within its length; both run forward.
fn lies_within(inner: &[Vec2], outer: &[Vec2]) -> bool {
    let (Some(first), Some(last), Some(from), Some(to)) =
        (inner.first(), inner.last(), outer.first(), outer.last())
    else {
        return true;
    };
    if first.x < from.x || last.x > to.x {
        return false;
    }
    let mut places: Vec<f64> = inner.iter().chain(outer).map(|p| p.x).collect();
    places.retain(|z| (first.x..=last.x).contains(z));
    places.sort_by(f64::total_cmp);
    places.dedup();
    // Between two neighbouring places both are straight.
    let radii = |corners: &[Vec2], [low, high]: [f64; 2]| {
        let middle = 0.5 * (low + high);
        let edge = corners.windows(2).find(|edge| edge[0].x < middle && middle < edge[1].x);
        let at = |edge: &[Vec2], z: f64| {
            edge[0].y + (edge[1].y - edge[0].y) * (z - edge[0].x) / (edge[1].x - edge[0].x)
        };
        edge.map_or([0.0; 3], |edge| [low, middle, high].map(|z| at(edge, z)))
    };
    places.windows(2).all(|pair| {
        let [a, b] = [inner, outer].map(|corners| radii(corners, [pair[0], pair[1]]));
        a[0] <= b[0] && a[1] < b[1] && a[2] <= b[2]
    })
}
