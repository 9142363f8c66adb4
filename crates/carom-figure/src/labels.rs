//! Places for labels: within the paper, and clear of each other where there is room.

use carom_num::Vec2;

/// Width of a letter and height of a line [px], generous: fonts differ, and narrow screens show larger letters.
const LETTER: f64 = 7.4;
const LINE: f64 = 15.0;

/// Where labels may be and where there are some.
pub(crate) struct Labels {
    low: Vec2,
    high: Vec2,
    taken: Vec<[Vec2; 2]>,
}

impl Labels {
    /// Labels within a rectangle of the paper [px].
    pub(crate) fn within(low: Vec2, high: Vec2) -> Self {
        Self { low, high, taken: vec![] }
    }

    /// The room that a text takes, turned by an angle's direction on paper [px].
    pub(crate) fn room(text: &str, along: Vec2) -> Vec2 {
        let (w, h) = (LETTER * text.chars().count() as f64, LINE);
        let (x, y) = (along.x.abs(), along.y.abs());
        Vec2::new(w * x + h * y, w * y + h * x)
    }

    /// The middle of a label of this room: the first of the places that is within the paper and clear of other labels; else the first that is
    /// within; else the first one, moved there.
    pub(crate) fn place(&mut self, room: Vec2, places: impl IntoIterator<Item = Vec2>) -> Vec2 {
        let places: Vec<Vec2> = places.into_iter().collect();
        let inside = |p: &&Vec2| self.moved_in(**p, room) == **p;
        let clear = |p: &&Vec2| inside(p) && self.is_clear(**p, room);
        let found = places.iter().find(clear).or_else(|| places.iter().find(inside)).copied();
        let place = found.unwrap_or_else(|| self.moved_in(places.first().copied().unwrap_or(self.low), room));
        self.taken.push([place - room * 0.5, place + room * 0.5]);
        place
    }

    /// Takes the room around this middle, where it is within the paper and clear of other labels; false where it is not.
    pub(crate) fn take(&mut self, middle: Vec2, room: Vec2) -> bool {
        let free = self.moved_in(middle, room) == middle && self.is_clear(middle, room);
        if free {
            self.taken.push([middle - room * 0.5, middle + room * 0.5]);
        }
        free
    }

    /// True for a point of the paper.
    pub(crate) fn holds(&self, p: Vec2) -> bool {
        (self.low.x..=self.high.x).contains(&p.x) && (self.low.y..=self.high.y).contains(&p.y)
    }

    /// Keeps labels off a level or an upright line.
    pub(crate) fn keep_off(&mut self, a: Vec2, b: Vec2) {
        self.taken.push([Vec2::new(a.x.min(b.x), a.y.min(b.y)), Vec2::new(a.x.max(b.x), a.y.max(b.y))]);
    }

    fn moved_in(&self, p: Vec2, room: Vec2) -> Vec2 {
        let within = |x: f64, low: f64, high: f64, room: f64| {
            let (low, high) = (low + 0.5 * room, high - 0.5 * room);
            if low > high { 0.5 * (low + high) } else { x.clamp(low, high) }
        };
        Vec2::new(within(p.x, self.low.x, self.high.x, room.x), within(p.y, self.low.y, self.high.y, room.y))
    }

    fn is_clear(&self, p: Vec2, room: Vec2) -> bool {
        let (low, high) = (p - room * 0.5, p + room * 0.5);
        self.taken.iter().all(|[a, b]| b.x <= low.x || high.x <= a.x || b.y <= low.y || high.y <= a.y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_stay_within_and_clear_of_each_other() {
        let mut labels = Labels::within(Vec2::ZERO, Vec2::new(200.0, 100.0));
        let room = Labels::room("56.74 mm", Vec2::new(1.0, 0.0));
        let first = labels.place(room, [Vec2::new(-4.0, 50.0)]);
        assert_eq!(first, Vec2::new(0.5 * room.x, 50.0), "moved in whole");
        let second = labels.place(room, [first, first + Vec2::new(0.0, 20.0)]);
        assert_eq!(second, first + Vec2::new(0.0, 20.0), "the place that is free");
        let third = labels.place(room, [first]);
        assert_eq!(third, first, "where there is no free one the first within");
        let turned = Labels::room("56.74 mm", Vec2::new(0.0, 1.0));
        assert_eq!((turned.x, turned.y), (room.y, room.x), "upright");
    }
}
