//! From metres (y up) to pixels (y down), and what part of an endless plate a picture shows.

use crate::text::px;
use crate::tolerance::LEAST_WIDTH;
use carom_num::Vec2;

/// A rectangle of the world and its scale on paper.
///
/// # Example
/// ```
/// use carom_figure::View;
/// use carom_num::Vec2;
/// let view = View { low: Vec2::ZERO, high: Vec2::new(1.0, 2.0), scale: 100.0 };
/// assert_eq!(view.at(Vec2::new(0.5, 2.0)), Vec2::new(50.0, 0.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Lower left corner [m].
    pub low: Vec2,
    /// Upper right corner [m].
    pub high: Vec2,
    /// Pixels in a metre.
    pub scale: f64,
}

impl View {
    /// The view of an extent with `margin` [m] around, at most `width` × `height` pixels.
    pub(crate) fn around(extent: &Extent, margin: f64, width: f64, height: f64) -> Self {
        let (low, high) = extent.corners().unwrap_or((Vec2::ZERO, Vec2::ZERO));
        let pad = Vec2::new(margin, margin);
        let (low, high) = (low - pad, high + pad);
        let size = high - low;
        let scale = (width / size.x.max(LEAST_WIDTH)).min(height / size.y.max(LEAST_WIDTH));
        Self { low, high, scale }
    }

    /// A window of `width` × `height` pixels around the same middle, at the same scale.
    #[must_use]
    pub fn filling(&self, width: f64, height: f64) -> Self {
        let middle = (self.low + self.high) * 0.5;
        let half = Vec2::new(width, height) * (0.5 / self.scale);
        Self { low: middle - half, high: middle + half, scale: self.scale }
    }

    /// Width on paper.
    pub(crate) fn width(&self) -> f64 {
        (self.high.x - self.low.x) * self.scale
    }

    /// Height on paper.
    pub(crate) fn height(&self) -> f64 {
        (self.high.y - self.low.y) * self.scale
    }

    /// What an SVG of the view shows, with a frame of so many pixels around: the value of its `viewBox`.
    pub(crate) fn framed(&self, frame: f64) -> String {
        let size = [self.width(), self.height()].map(|size| px(size + 2.0 * frame));
        format!("{0} {0} {1} {2}", px(-frame), size[0], size[1])
    }

    /// A point on paper.
    pub fn at(&self, p: Vec2) -> Vec2 {
        Vec2::new((p.x - self.low.x) * self.scale, (self.high.y - p.y) * self.scale)
    }

    /// The point of the world at a place on paper [m].
    pub fn of(&self, p: Vec2) -> Vec2 {
        Vec2::new(self.low.x + p.x / self.scale, self.high.y - p.y / self.scale)
    }

    /// A direction on paper, scaled.
    pub(crate) fn along(&self, d: Vec2) -> Vec2 {
        Vec2::new(d.x * self.scale, -d.y * self.scale)
    }

    /// The piece of the segment inside this view, with `true` for each end that was cut; `None` where it is outside.
    pub(crate) fn clip(&self, from: Vec2, to: Vec2) -> Option<(Vec2, Vec2, [bool; 2])> {
        let d = to - from;
        let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
        for (p, q) in [
            (-d.x, from.x - self.low.x),
            (d.x, self.high.x - from.x),
            (-d.y, from.y - self.low.y),
            (d.y, self.high.y - from.y),
        ] {
            if p == 0.0 {
                if q < 0.0 {
                    return None;
                }
            } else if p < 0.0 {
                enter = enter.max(q / p);
            } else {
                leave = leave.min(q / p);
            }
        }
        (enter <= leave).then(|| (from + d * enter, from + d * leave, [enter > 0.0, leave < 1.0]))
    }
}

/// The smallest rectangle around points, none of which it keeps.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Extent {
    corners: Option<(Vec2, Vec2)>,
}

impl Extent {
    /// Its lower left and its upper right corner [m]; none around nothing.
    pub(crate) fn corners(&self) -> Option<(Vec2, Vec2)> {
        self.corners
    }
}

impl Extend<Vec2> for Extent {
    /// Points that are not finite are left out.
    fn extend<T: IntoIterator<Item = Vec2>>(&mut self, points: T) {
        for p in points.into_iter().filter(|p| p.is_finite()) {
            let (low, high) = self.corners.unwrap_or((p, p));
            let low = Vec2::new(low.x.min(p.x), low.y.min(p.y));
            self.corners = Some((low, Vec2::new(high.x.max(p.x), high.y.max(p.y))));
        }
    }
}

impl FromIterator<Vec2> for Extent {
    fn from_iter<T: IntoIterator<Item = Vec2>>(points: T) -> Self {
        let mut extent = Self::default();
        extent.extend(points);
        extent
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_plate_is_cut_at_the_view() {
        let view = View::around(
            &[Vec2::new(0.0, 0.0), Vec2::new(1.0, 1.0)].into_iter().collect(),
            0.0,
            100.0,
            200.0,
        );
        assert_eq!(view.scale, 100.0, "the width decides");
        let (a, b, cut) = view.clip(Vec2::new(-9.0, 0.5), Vec2::new(0.5, 0.5)).unwrap();
        assert!((a.x, b.x, cut) == (0.0, 0.5, [true, false]), "{a:?} {b:?} {cut:?}");
        assert_eq!(view.clip(Vec2::new(-9.0, 2.0), Vec2::new(9.0, 2.0)), None, "outside");
        assert_eq!(view.at(Vec2::new(0.0, 1.0)), Vec2::new(0.0, 0.0), "y is down on paper");
    }
}
