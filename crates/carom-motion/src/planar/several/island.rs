//! Bodies that touch each other move as one; bodies that do not, each for itself.

use super::ahead::Ahead;
use super::outlook::Outlook;
use crate::MotionError;
use crate::planar::contact::{World, kinematics::Pairing};
use crate::planar::geometry::{State, Twist};
use crate::planar::record::{
    observer::{Observer, Observers},
    trace::HeldContact,
};
use crate::planar::walk::{
    accumulation::Recent,
    collide::Closed,
    terms::{Effort, Happening, Margin, Options},
    walker::Walker,
};
use std::borrow::Cow;

/// Most bodies that are walked together.
pub(super) const MOST_TOGETHER: usize = 4;

/// A walk of one body, or of several.
#[derive(Clone, Debug)]
enum Walk<'w> {
    Alone(Box<Walker<'w, 1>>),
    Together(Box<Walker<'w, MOST_TOGETHER>>),
}

/// Does the same for either kind of walk.
macro_rules! either {
    ($walk:expr, $walker:ident => $does:expr) => {
        match $walk {
            Walk::Alone($walker) => $does,
            Walk::Together($walker) => $does,
        }
    };
}

/// Bodies that are walked as one, and their numbers.
#[derive(Clone, Debug)]
pub(super) struct Island<'w> {
    pub(super) members: Vec<usize>,
    walk: Walk<'w>,
}

/// A pair of features with other numbers of the bodies. Of two bodies the one with the lower number comes first, as everywhere.
fn renumbered(pair: Pairing, obstacles: usize, number: impl Fn(usize) -> usize) -> Pairing {
    let body = number(pair.body);
    let Some(other) = pair.obstacle.checked_sub(obstacles).map(number) else {
        return Pairing { body, ..pair };
    };
    if body < other {
        Pairing { body, obstacle: obstacles + other, feature: pair.feature }
    } else {
        Pairing { body: other, obstacle: obstacles + body, feature: pair.feature.from_the_other_side() }
    }
}

impl<'w> Island<'w> {
    /// One body that starts.
    pub(super) fn of_one(
        world: &World,
        body: usize,
        state: State,
        sides: Vec<bool>,
        (time, options): (f64, Options),
    ) -> Result<Self, MotionError> {
        let own = Cow::Owned(world.of_some(&[body]));
        let mut walker = Walker::<1>::of_states(own, [body], [state], sides, options)?;
        walker.time = time;
        Ok(Self { members: vec![body], walk: Walk::Alone(Box::new(walker)) })
    }

    pub(super) fn time(&self) -> f64 {
        either!(&self.walk, w => w.time)
    }

    pub(super) fn ended(&self) -> Option<Happening> {
        either!(&self.walk, w => w.ended)
    }

    pub(super) fn effort(&self) -> Effort {
        either!(&self.walk, w => w.effort)
    }

    pub(super) fn margin(&self) -> Margin {
        either!(&self.walk, w => w.margin)
    }

    pub(super) fn place_of(&self, body: usize) -> Option<usize> {
        self.members.iter().position(|m| *m == body)
    }

    pub(super) fn state(&self, place: usize) -> &State {
        either!(&self.walk, w => &w.states[place])
    }

    pub(super) fn held(&self, place: usize) -> Vec<HeldContact> {
        either!(&self.walk, w => w.held_of(place).collect())
    }

    /// What a body that is walked alone meets next.
    pub(super) fn outlook(&self) -> Outlook {
        match &self.walk {
            Walk::Alone(walker) => walker.outlook(),
            Walk::Together(_) => Outlook::Bound,
        }
    }

    pub(super) fn flat_on(&self, place: usize, obstacle: usize) -> Option<usize> {
        either!(&self.walk, w => w.lies_flat(place, obstacle))
    }

    /// True where two members have just opened a contact that the walk of both watches.
    pub(super) fn watches(&self, a: usize, b: usize) -> bool {
        let (Some(a), Some(b)) = (self.place_of(a), self.place_of(b)) else { return false };
        either!(&self.walk, w => {
            let other = |p: &Pairing| w.world.other_body(*p).map(|o| (p.body, o));
            w.departing.iter().filter_map(other).any(|pair| pair == (a, b) || pair == (b, a))
        })
    }

    /// The next smooth piece, looked at beforehand.
    pub(super) fn ahead(&self) -> Result<Ahead, MotionError> {
        match &self.walk {
            Walk::Alone(walker) => Ahead::of_one(walker),
            Walk::Together(walker) => Ahead::of_several(walker),
        }
    }

    /// Moves through one smooth piece and resolves the event that ends it.
    pub(super) fn advance(&mut self, observers: &mut [&mut dyn Observer]) -> Result<Happening, MotionError> {
        let members = &self.members;
        either!(&mut self.walk, w => w.advance_all(&mut chosen(observers, members)))
    }

    /// Moves up to a time within the piece that is ahead, and stays there.
    pub(super) fn advance_to(
        &mut self,
        time: f64,
        observers: &mut [&mut dyn Observer],
    ) -> Result<(), MotionError> {
        let members = &self.members;
        either!(&mut self.walk, w => halt(w, time, &mut chosen(observers, members)))
    }

    /// Both islands as one, which nothing has been asked yet.
    pub(super) fn merged(&self, other: &Self, world: &World) -> Result<Self, MotionError> {
        let members: Vec<usize> = self.members.iter().chain(&other.members).copied().collect();
        let time = self.time();
        if members.len() > MOST_TOGETHER {
            return Err(MotionError::TooManyTogether { time, most: MOST_TOGETHER });
        }
        let own = Cow::Owned(world.of_some(&members));
        let names = std::array::from_fn(|i| members.get(i).copied().unwrap_or_default());
        let mut states = [State::default(); MOST_TOGETHER];
        for (i, state) in states.iter_mut().enumerate().take(members.len()) {
            let own = i.checked_sub(self.members.len());
            *state = own.map_or_else(|| *self.state(i), |j| *other.state(j));
        }
        let options = either!(&self.walk, w => w.options);
        let mut walker = Walker::of_states(own, names, states, vec![], options)?;
        (walker.time, walker.begun) = (time, true);
        either!(&self.walk, w => walker.take_over(w, 0));
        either!(&other.walk, w => walker.take_over(w, self.members.len()));
        walker.note_sides();
        Ok(Self { members, walk: Walk::Together(Box::new(walker)) })
    }

    /// Resolves what happens where members touch, and where two meet with these features, numbered as in the crowd.
    pub(super) fn collide(
        &mut self,
        pair: Option<Pairing>,
        observers: &mut [&mut dyn Observer],
    ) -> Result<Happening, MotionError> {
        let members = &self.members;
        either!(&mut self.walk, w => {
            let place = |body: usize| members.iter().position(|m| *m == body).unwrap_or_default();
            let pair = pair.map(|p| renumbered(p, w.world.obstacles.len(), place));
            let happening = w.meet(pair, &mut chosen(observers, members))?;
            w.ended = (happening != Happening::Moves).then_some(happening);
            Ok(happening)
        })
    }

    /// Bodies that no impact could resolve stand where they are, for all that come after them.
    pub(super) fn stand_unresolved(&mut self) {
        if matches!(self.ended(), Some(Happening::Jams | Happening::GivenUp)) {
            either!(&mut self.walk, w => w.states.iter_mut().for_each(|state| state.twist = Twist::default()));
        }
    }

    /// True where nothing moves until another body comes.
    pub(super) fn stands(&self) -> bool {
        matches!(self.ended(), Some(Happening::Rests | Happening::Jams | Happening::GivenUp))
    }

    /// The islands into which this one falls apart, with the pairs of bodies that have just parted, numbered as in the crowd.
    pub(super) fn parted(self, world: &World) -> Result<(Vec<Self>, Vec<Pairing>), MotionError> {
        let Walk::Together(walker) = &self.walk else { return Ok((vec![self], vec![])) };
        let groups = walker.groups(self.members.len());
        if groups.len() == 1 {
            return Ok((vec![self], vec![]));
        }
        let obstacles = walker.world.obstacles.len();
        let between = walker.departing.iter().filter(|p| p.obstacle >= obstacles);
        let parted = between.map(|p| renumbered(*p, obstacles, |b| self.members[b])).collect();
        let islands = groups.iter().map(|group| {
            let members: Vec<usize> = group.iter().map(|&g| self.members[g]).collect();
            let own = Cow::Owned(world.of_some(&members));
            let walk = if members.len() == 1 {
                Walk::Alone(Box::new(walker.part::<1>(own, group)?))
            } else {
                Walk::Together(Box::new(walker.part::<MOST_TOGETHER>(own, group)?))
            };
            Ok(Self { members, walk })
        });
        Ok((islands.collect::<Result<_, MotionError>>()?, parted))
    }
}

/// Those who look on the members, out of all.
fn chosen<'o, 'x: 'o, const B: usize>(
    observers: &'o mut [&'x mut dyn Observer],
    members: &[usize],
) -> Observers<'o, B> {
    let mut out = [const { None }; B];
    for (body, observer) in observers.iter_mut().enumerate() {
        if let Some(place) = members.iter().position(|m| *m == body) {
            let observer: &'o mut dyn Observer = &mut **observer;
            out[place] = Some(observer);
        }
    }
    out
}

/// Moves a walk within its next piece.
fn halt<const B: usize>(
    walker: &mut Walker<'_, B>,
    time: f64,
    observers: &mut Observers<'_, B>,
) -> Result<(), MotionError> {
    // Within rounding nothing moves.
    if walker.ended.is_some() || time - walker.time <= crate::tolerance::SAME_INSTANT * walker.scales.time {
        walker.time = walker.time.max(time);
        return Ok(());
    }
    let most_time = std::mem::replace(&mut walker.options.most_time, time);
    let happening = walker.advance_all(observers);
    walker.options.most_time = most_time;
    if happening? == Happening::BudgetSpent {
        walker.ended = None;
    }
    Ok(())
}

impl<const B: usize> Walker<'_, B> {
    /// Takes over what another walk knows of some of the bodies. The first of them has the number `first` here.
    fn take_over<const C: usize>(&mut self, other: &Walker<'_, C>, first: usize) {
        let obstacles = self.world.obstacles.len();
        for h in other.held.iter() {
            let mut held = *h;
            held.pair = renumbered(h.pair, obstacles, |b| b + first);
            self.held.push(held);
        }
        for pair in other.departing.iter() {
            self.departing.push(renumbered(*pair, obstacles, |b| b + first));
        }
        for (body, obstacle) in other.world.each_meeting() {
            let met = if obstacle < obstacles { obstacle } else { obstacle + first };
            let place = self.world.place(body + first, met);
            self.sides[place] = other.sides[other.world.place(body, obstacle)];
        }
        self.recent = Recent::of_both(&self.recent, &other.recent);
        self.effort = self.effort.at_least(&other.effort);
        (self.forced, self.stalls) = (self.forced.max(other.forced), self.stalls.max(other.stalls));
        if other.margin.value < self.margin.value {
            self.margin = other.margin;
        }
    }

    /// All contacts that touch meet, and this one.
    fn meet(
        &mut self,
        named: Option<Pairing>,
        observers: &mut Observers<'_, B>,
    ) -> Result<Happening, MotionError> {
        self.collide_here(&Closed { named, ..Default::default() }, observers)
    }

    /// The first `count` bodies by what holds them together.
    fn groups(&self, count: usize) -> Vec<Vec<usize>> {
        let mut label: Vec<usize> = (0..count).collect();
        for h in self.held.iter() {
            if let Some(other) = self.world.other_body(h.pair) {
                let (a, b) = (label[h.pair.body], label[other]);
                label.iter_mut().filter(|l| **l == b).for_each(|l| *l = a);
            }
        }
        let mut groups: Vec<Vec<usize>> = vec![];
        for (body, own) in label.iter().enumerate() {
            match groups.iter_mut().find(|g| label[g[0]] == *own) {
                Some(group) => group.push(body),
                None => groups.push(vec![body]),
            }
        }
        groups
    }

    /// The walk of some of the bodies, which hold no contact with the others.
    fn part<'v, const C: usize>(
        &self,
        world: Cow<'v, World>,
        group: &[usize],
    ) -> Result<Walker<'v, C>, MotionError> {
        let of = |i: usize| group.get(i).copied();
        let states = std::array::from_fn(|i| of(i).map_or_else(State::default, |b| self.states[b]));
        let names = std::array::from_fn(|i| of(i).map_or(0, |b| self.names[b]));
        let mut out = Walker::of_states(world, names, states, vec![], self.options)?;
        // What its contacts do was asked when it parted: it has begun, and none of them strikes again.
        (out.time, out.begun, out.recent) = (self.time, true, self.recent);
        (out.effort, out.margin, out.ended) = (self.effort, self.margin, self.ended);
        (out.forced, out.stalls) = (self.forced, self.stalls);
        let obstacles = self.world.obstacles.len();
        let own = |pair: Pairing| {
            let inside = |b: usize| group.contains(&b);
            inside(pair.body) && self.world.other_body(pair).is_none_or(inside)
        };
        let number = |b: usize| group.iter().position(|g| *g == b).unwrap_or_default();
        for h in self.held.iter().filter(|h| own(h.pair)) {
            let mut held = *h;
            held.pair = renumbered(h.pair, obstacles, number);
            out.held.push(held);
        }
        for pair in self.departing.iter().filter(|p| own(**p)) {
            out.departing.push(renumbered(*pair, obstacles, number));
        }
        for (body, obstacle) in out.world.each_meeting() {
            let met = if obstacle < obstacles { obstacle } else { obstacles + group[obstacle - obstacles] };
            let place = out.world.place(body, obstacle);
            out.sides[place] = self.sides[self.world.place(group[body], met)];
        }
        out.note_sides();
        Ok(out)
    }
}
