//! From what happens to a verdict.

use crate::drop::Prepared;
use crate::ending::{decided, jam, nearest_in_flight};
use crate::feeder::{PartKind, Stop};
use crate::part_view::PartView;
use crate::run::{Effort, Exit, JamKind, Landing, Outcome, Run, Verdict};
use crate::seen::{Seen, with_speeds};
use crate::tolerance::SAME_LENGTH;
use carom_motion::MotionError;
use carom_motion::planar::observer::{ContactSample, HeldContact, ImpactFacts, PieceFacts};
use carom_motion::planar::trace::{Impact, Trace};
use carom_motion::planar::{Happening, Observer, Outlook, State, Walker};
use carom_num::Vec2;

/// Passes everything on and notes what a verdict needs.
pub(crate) struct Watcher<'o> {
    inner: &'o mut dyn Observer,
    plates: Vec<Seen>,
    /// The last piece: its start, and how long it lasted [s].
    last_piece: Option<(State, f64)>,
    /// Whether it has touched each wall.
    walls: Vec<bool>,
}

impl Watcher<'_> {
    /// Notes that it touches an obstacle, where that is a wall.
    fn touch_wall(&mut self, obstacle: usize) {
        let wall = obstacle.checked_sub(self.plates.len());
        if let Some(touched) = wall.and_then(|wall| self.walls.get_mut(wall)) {
            *touched = true;
        }
    }
}

impl Observer for Watcher<'_> {
    fn is_dense(&self) -> bool {
        self.inner.is_dense()
    }

    fn wants_slips(&self) -> bool {
        true
    }

    fn starts(&mut self, time: f64, state: &State, held: &mut dyn Iterator<Item = HeldContact>) {
        self.inner.starts(time, state, held);
    }

    fn sample(&mut self, time: f64, state: &State, contacts: &mut dyn Iterator<Item = ContactSample>) {
        self.inner.sample(time, state, contacts);
    }

    fn piece(&mut self, piece: &PieceFacts) {
        self.last_piece = Some((piece.start, piece.end_time - piece.start_time));
        self.inner.piece(piece);
    }

    fn impact(&mut self, facts: &ImpactFacts, whole: Option<Impact>) {
        if let Some(seen) = self.plates.get_mut(facts.obstacle) {
            seen.touched(facts.time);
            seen.struck(facts.speed);
        }
        self.inner.impact(facts, whole);
    }

    fn lifts_off(&mut self, needed_force: f64) {
        self.inner.lifts_off(needed_force);
    }

    fn accumulation(&mut self, from: f64, to: f64) {
        self.inner.accumulation(from, to);
    }

    fn touches(&mut self, obstacle: usize) {
        self.touch_wall(obstacle);
        self.inner.touches(obstacle);
    }

    fn slips(&mut self, obstacle: usize, speed: f64) {
        if let Some(seen) = self.plates.get_mut(obstacle) {
            seen.slid(speed);
        }
        if self.inner.wants_slips() {
            self.inner.slips(obstacle, speed);
        }
    }
}

/// One part's run on its way.
pub(crate) struct Course<'p, 'f> {
    prepared: &'p Prepared<'f>,
    landings: Vec<Landing>,
    /// How it left the last plate over its edge, since when it has not touched that plate, and the impacts on the plate until then.
    left: Option<(Exit, u64)>,
    /// What keeps it, should it jam.
    kept_by: JamKind,
}

impl<'o> Watcher<'o> {
    /// Looks on a part that starts on the first plate at this time [s].
    pub(crate) fn new(prepared: &Prepared<'_>, time: f64, inner: &'o mut dyn Observer) -> Self {
        let mut plates = vec![Seen::default(); prepared.feeder.plates.len()];
        if let Some(plate) = plates.first_mut() {
            plate.first_touch = Some(time);
        }
        Self { inner, plates, last_piece: None, walls: vec![false; prepared.feeder.walls.len()] }
    }
}

impl<'p, 'f> Course<'p, 'f> {
    pub(crate) fn new(prepared: &'p Prepared<'f>) -> Self {
        Self { prepared, landings: vec![], left: None, kept_by: JamKind::Wedged }
    }

    /// Follows a part that is alone to its end.
    pub(crate) fn follow(
        mut self,
        mut walker: Walker<'p>,
        mut watcher: Watcher<'_>,
    ) -> Result<Run, MotionError> {
        loop {
            let happening = walker.advance(&mut watcher)?;
            if let Some(outcome) = self.note(happening, &walker, &mut watcher) {
                return Ok(self.finish(outcome, &walker, &watcher));
            }
        }
    }

    /// Notes what an advance has brought; the outcome, where it is one.
    pub(crate) fn note(
        &mut self,
        happening: Happening,
        part: &impl PartView,
        watcher: &mut Watcher<'_>,
    ) -> Option<Outcome> {
        note_touches(part, watcher);
        self.note_landings(part, watcher);
        self.note_leaving(part, watcher);
        match happening {
            Happening::Moves => self.reached_stop(part),
            Happening::Rests if self.left.is_some() && self.is_past(&part.state()) => {
                Some(Outcome::Delivered)
            }
            Happening::Rests => Some(self.resting(part)),
            Happening::FliesAway if self.left.is_some() => Some(Outcome::Delivered),
            Happening::FliesAway => Some(self.flown_away(watcher)),
            Happening::Jams => {
                self.kept_by = JamKind::Unresolved;
                Some(Outcome::Jammed)
            }
            Happening::GivenUp => Some(Outcome::Unresolved),
            Happening::Swings | Happening::BudgetSpent => Some(Outcome::NeverFlat),
        }
    }

    fn last(&self) -> usize {
        self.prepared.feeder.plates.len() - 1
    }

    /// Notes when the part first lies flat on each plate (a disc: when it first stays on it). A part that first stands on an end and then lies on a
    /// face has landed on the face.
    fn note_landings(&mut self, part: &impl PartView, watcher: &Watcher<'_>) {
        for plate in 0..self.prepared.feeder.plates.len() {
            let known = self.landings.iter().position(|l| l.plate == plate);
            if known.is_some_and(|i| self.landings[i].face.is_none_or(|f| !self.is_end(f)))
                || is_start(plate, watcher)
            {
                continue;
            }
            let Some(face) = self.lies_on(plate, part) else { continue };
            let landing = self.landing(plate, face, part.time(), watcher);
            match known {
                Some(i) if face.is_some_and(|f| !self.is_end(f)) => self.landings[i] = landing,
                Some(_) => {}
                None => self.landings.push(landing),
            }
        }
    }

    /// The face that lies on a plate; `Some(None)` for a disc that stays on it.
    fn lies_on(&self, plate: usize, part: &impl PartView) -> Option<Option<usize>> {
        if self.prepared.feeder.part.kind == PartKind::Disc {
            part.holds(plate).then_some(None)
        } else {
            part.flat_on(plate).map(Some)
        }
    }

    fn landing(&self, plate: usize, face: Option<usize>, time: f64, watcher: &Watcher<'_>) -> Landing {
        let before = self.landings.iter().rev().find(|l| l.plate != plate);
        let face_before = before.map_or(Some(self.prepared.feeder.start.face), |l| l.face);
        Landing {
            plate,
            verdict: face.map(|f| self.verdict(f)),
            turned_here: face.map(|f| Some(f) != face_before),
            face,
            first_touch: watcher.plates[plate].first_touch.unwrap_or(time),
            flat: face.map(|_| time),
            impact_speed: 0.0,
            max_impact_speed: 0.0,
            max_sliding_speed: 0.0,
        }
    }

    fn verdict(&self, face: usize) -> Verdict {
        let start = self.prepared.feeder.start.face;
        match self.prepared.feeder.part.kind {
            PartKind::Rod | PartKind::Box if face == start => Verdict::Same,
            PartKind::Rod => Verdict::Turned,
            PartKind::Box if face == (start + 2) % 4 => Verdict::Turned,
            PartKind::Box | PartKind::Polygon | PartKind::Disc => Verdict::Face(face),
        }
    }

    /// True for the short faces of a box.
    fn is_end(&self, face: usize) -> bool {
        let shape = &self.prepared.feeder.part.body.shape;
        let length = |f: usize| {
            let (a, b) = shape.face(f);
            (b - a).norm()
        };
        self.prepared.feeder.part.kind == PartKind::Box
            && length(face) < (1.0 - SAME_LENGTH) * length(face + 1)
    }

    fn reached_stop(&self, part: &impl PartView) -> Option<Outcome> {
        let last = self.last();
        match self.prepared.feeder.stop {
            Stop::Landed => {
                let landed = |l: &Landing| l.plate == last && l.face.is_none_or(|f| !self.is_end(f));
                self.landings.iter().any(landed).then_some(Outcome::Landed)
            }
            Stop::Delivered => self.is_delivered(part).then_some(Outcome::Delivered),
        }
    }

    /// Notes that the part leaves the last plate over its edge, and that it comes back to that plate.
    fn note_leaving(&mut self, part: &impl PartView, watcher: &Watcher<'_>) {
        if self.prepared.feeder.stop != Stop::Delivered {
            return;
        }
        let last = self.last();
        let impacts = watcher.plates[last].impacts;
        let came_back = |(_, before): (Exit, u64)| before != impacts || part.holds(last);
        if self.left.is_some_and(came_back) {
            self.left = None;
        }
        if self.left.is_none() && self.is_over_edge(part, watcher) {
            self.left = Some((Exit { time: part.time(), state: part.state() }, impacts));
        }
    }

    /// True where the part holds nothing and its centre moves downhill beyond the last plate's edge: it may still come back.
    fn is_over_edge(&self, part: &impl PartView, watcher: &Watcher<'_>) -> bool {
        let plate = &self.prepared.feeder.plates[self.last()];
        let touched = watcher.plates[self.last()].first_touch.is_some();
        let downhill = plate.arrives();
        let state = part.state();
        // A disc that rolls off has its centre exactly over the edge.
        let slack = SAME_LENGTH * self.prepared.feeder.part.body.shape.size() * downhill.norm();
        let beyond =
            downhill.dot(state.pose.centre - plate.edge) > -slack && downhill.dot(state.twist.velocity) > 0.0;
        touched && beyond && !part.holds_any()
    }

    /// True where the part has left over the edge and cannot come back to the plate: it is past the edge as a whole, or its flight leads past
    /// the plate.
    fn is_delivered(&self, part: &impl PartView) -> bool {
        self.left.is_some()
            && (self.is_past(&part.state())
                || match part.outlook() {
                    Outlook::Clear => true,
                    // What it strikes below the edge does not throw it back above.
                    Outlook::Meets { obstacle, state } => obstacle != self.last() && self.is_past(&state),
                    Outlook::Bound => false,
                })
    }

    /// True where every point of the part is beyond the last plate's edge and lower than that edge.
    fn is_past(&self, state: &State) -> bool {
        let plate = &self.prepared.feeder.plates[self.last()];
        let Some(downhill) = plate.arrives().unit() else { return false };
        let shape = self.prepared.feeder.part.body.shape.hull();
        let turn = Vec2::at_angle(state.pose.angle);
        shape.vertices().iter().all(|vertex| {
            let from_edge = state.pose.centre + vertex.rotated(turn.x, turn.y) - plate.edge;
            downhill.dot(from_edge) > shape.radius() && from_edge.y < -shape.radius()
        })
    }

    fn resting(&self, part: &impl PartView) -> Outcome {
        let mut obstacles = vec![];
        // What it leans on may be another part, which is no obstacle of its own.
        part.each_held(&mut |h| obstacles.extend(Some(h.obstacle).filter(|o| *o < self.fixed())));
        obstacles.dedup();
        let mut faces = obstacles.iter().map(|&o| part.flat_on(o));
        let flat = faces.next().flatten();
        let on_one_face = flat.is_some() && faces.all(|f| f == flat);
        match flat {
            _ if obstacles.len() > 1 && !on_one_face => Outcome::Jammed,
            Some(face) if self.is_end(face) => Outcome::OnEnd,
            _ => Outcome::Stuck,
        }
    }

    /// Number of the plates and walls.
    fn fixed(&self) -> usize {
        self.prepared.feeder.plates.len() + self.prepared.feeder.walls.len()
    }

    fn flown_away(&self, watcher: &Watcher<'_>) -> Outcome {
        if watcher.plates[self.last()].first_touch.is_some() { Outcome::Escaped } else { Outcome::Missed }
    }

    /// How near a part that missed the last plate came to it in its last flight [m].
    fn missed_by(&self, outcome: Outcome, watcher: &Watcher<'_>) -> Option<f64> {
        let (start, lasts) = watcher.last_piece.filter(|_| outcome == Outcome::Missed)?;
        nearest_in_flight(&self.prepared.world, self.last(), &start, lasts)
    }

    /// The run of a part that has come to its outcome; without a trace.
    pub(crate) fn finish(&self, outcome: Outcome, part: &impl PartView, watcher: &Watcher<'_>) -> Run {
        let effort = part.effort();
        let margin = part.margin();
        let exit = self.left.map(|(exit, _)| exit);
        Run {
            outcome,
            end_time: part.time(),
            landings: with_speeds(self.landings.clone(), &watcher.plates),
            walls_touched: (0..watcher.walls.len()).filter(|wall| watcher.walls[*wall]).collect(),
            exit: exit.filter(|_| outcome == Outcome::Delivered),
            margin: margin.value,
            margin_of: decided(&margin),
            jam: (outcome == Outcome::Jammed).then(|| jam(self.kept_by, part)),
            missed_by: self.missed_by(outcome, watcher),
            effort: Effort {
                rhs_evaluations: effort.evaluations,
                steps: effort.steps,
                event_evaluations: effort.event_evaluations,
                rate_problems: effort.rate_problems,
                events: effort.events,
                impacts: effort.impacts,
            },
            stages: vec![],
            trace: Trace::default(),
        }
    }
}

/// Notes plates and walls that the part came to touch without a strike.
fn note_touches(part: &impl PartView, watcher: &mut Watcher<'_>) {
    let time = part.time();
    part.each_held(&mut |h| {
        if let Some(seen) = watcher.plates.get_mut(h.obstacle) {
            seen.touched(time);
        }
        watcher.touch_wall(h.obstacle);
    });
}

/// The first plate carries the part from the start: that is no landing.
fn is_start(plate: usize, watcher: &Watcher<'_>) -> bool {
    plate == 0 && watcher.plates[0].impact_speed.is_none()
}

#[cfg(test)]
mod tests;
