//! The course of each stage over time: the plots of the feeder paper's Figs. 5 to 7, for every stage of any run.

use crate::markup::{Markup, html, joined};
use crate::motion::refined;
use crate::plot::{Marker, Plot, Series};
use crate::senses::{forward_sense, obstacle_ends, tilt_in, upward};
use crate::text::{fixed, html_symbol};
use crate::tolerance::UNSEEN;
use carom_feeder::{Feeder, PartKind, Run, Stage, StageName};
use carom_motion::planar::trace::{Impact, Piece, PieceEnd, Sample};
use carom_motion::planar::{Feature, Options, Pairing};
use carom_num::Vec2;
use carom_words::{Words, part, run};

/// Stages that get plots; the rest of a long run is in the table.
const MOST_STAGES: usize = 18;
/// Points of one line.
const MOST_POINTS: usize = 160;
/// Points of a line of many pieces, which have eight each while that is enough for all.
const MOST_OF_MANY: usize = 1024;

/// The section with every stage's plots.
pub(crate) fn section(feeder: &Feeder, run: &Run) -> Markup {
    let course = |(i, stage): (usize, &Stage)| {
        let plots: Vec<Markup> = stage_plots(feeder, run, stage).iter().filter_map(Plot::svg).collect();
        let on = stage.obstacle.map(|o| format!(" on “{}”", part::obstacle(feeder, o))).unwrap_or_default();
        let (name, lasts) = (stage.name.word(), fixed(1e3 * (stage.end_time - stage.start_time), 1));
        (!plots.is_empty()).then(|| {
            html! {
                div.course {
                    h3 {
                        i class={ "key " (name) } {}
                        (i + 1) " " (name) (on) " "
                        small { (fixed(stage.start_time, 4)) " s, " (lasts) " ms" }
                    }
                    div.plots { (joined(plots)) }
                }
            }
        })
    };
    let courses: Vec<Markup> = run.stages.iter().enumerate().take(MOST_STAGES).filter_map(course).collect();
    if courses.is_empty() {
        return html! {};
    }
    html! {
        section id="course" {
            h2 { "Course over time" }
            p.note { (symbols()) }
            (joined(courses))
            @if run.stages.len() > MOST_STAGES {
                p.note { "The first " (MOST_STAGES) " of " (run.stages.len()) " stages." }
            }
        }
    }
}

fn symbols() -> Markup {
    let s = html_symbol;
    html! {
        (s("N")) " normal force; " (s("ω")) " spin and " (s("φ")) " tilt, forward positive; "
        (s("v_r")) ", " (s("v_φ"))
        " velocity of the mass centre along and across the line from the contact point to it; "
        (s("v_x")) ", " (s("v_y")) " its velocity to the right and up; "
        (s("g")) " gap between the part and what it touches next; "
        (s("τ_c")) ", " (s("n_c"))
        " the mass centre from the point last struck, down the plate and out of it. A click in a plot moves the animation to that instant."
    }
}

/// The samples of one stage, each with the number of its piece in the stage.
struct Course<'a> {
    feeder: &'a Feeder,
    run: &'a Run,
    stage: &'a Stage,
    pieces: &'a [Piece],
    samples: Vec<(usize, Sample)>,
}

fn stage_plots(feeder: &Feeder, run: &Run, stage: &Stage) -> Vec<Plot> {
    let pieces = run.trace.pieces.get(stage.pieces.clone()).unwrap_or_default();
    if stage.end_time <= stage.start_time || matches!(stage.name, StageName::Rest | StageName::Clatter) {
        return vec![];
    }
    let of = |points: usize| points / pieces.len().max(1);
    let each = of(MOST_POINTS).max(of(MOST_OF_MANY).clamp(2, 8));
    let samples: Vec<(usize, Sample)> =
        pieces.iter().enumerate().flat_map(|(i, p)| refined(p, each).map(move |s| (i, s))).collect();
    if samples.len() < 2 {
        return vec![];
    }
    let course = Course { feeder, run, stage, pieces, samples };
    let mut plots = match stage.name {
        StageName::Flight => vec![course.angle(), course.velocity(), course.gap()],
        StageName::Slide => vec![course.forces(), course.speed_along()],
        _ => vec![course.forces(), course.spin(), course.about_contact()],
    };
    if stage.name != StageName::Flight
        && stage.name != StageName::Slide
        && let Some(impact) = last_strike(run, stage)
    {
        plots.push(course.centre_from(impact));
    }
    plots.into_iter().filter(|p| !p.series.is_empty()).collect()
}

/// The last strike on this stage's obstacle before it began.
fn last_strike<'a>(run: &'a Run, stage: &Stage) -> Option<&'a Impact> {
    let on =
        |i: &&Impact| i.time <= stage.start_time && i.contacts.first().map(|c| c.obstacle) == stage.obstacle;
    run.trace.impacts.iter().rfind(on).filter(|i| !i.contacts.is_empty())
}

impl Course<'_> {
    fn ms(&self, sample: &Sample) -> f64 {
        1e3 * (sample.time - self.stage.start_time)
    }

    /// A line of a quantity of each sample; a gap where it has none and between pieces.
    fn line(&self, name: &str, value: impl Fn(&Sample) -> Option<f64>) -> Series {
        let mut points: Vec<(f64, f64)> = vec![];
        let mut piece = 0;
        for (i, sample) in &self.samples {
            if *i != piece {
                points.push((f64::NAN, f64::NAN));
                piece = *i;
            }
            points.push((self.ms(sample), value(sample).unwrap_or(f64::NAN)));
        }
        Series { name: name.to_owned(), points }
    }

    fn plot(&self, title: &str, unit: &str, with_zero: bool, series: Vec<Series>) -> Plot {
        let ends = self.pieces.split_last().map(|(_, before)| before).unwrap_or_default();
        let mark = |p: &Piece| Marker {
            at: 1e3 * (p.end_time - self.stage.start_time),
            label: run::piece_end(p.ended_by).to_owned(),
        };
        let drawn = |s: &Series| s.points.iter().any(|p| p.1.is_finite());
        Plot {
            remark: String::new(),
            title: format!("{title} in stage {}", self.stage.name.word()),
            unit: unit.to_owned(),
            from_time: self.stage.start_time,
            series: series.into_iter().filter(drawn).collect(),
            markers: ends.iter().take(6).map(mark).collect(),
            with_zero,
        }
    }

    /// N(t): one line, or one for each contact.
    fn forces(&self) -> Plot {
        let mut keys: Vec<(usize, Feature)> = vec![];
        for c in self.samples.iter().flat_map(|(_, s)| &s.contacts) {
            if !keys.contains(&(c.obstacle, c.feature)) {
                keys.push((c.obstacle, c.feature));
            }
        }
        let force = |s: &Sample, key: (usize, Feature)| {
            s.contacts.iter().find(|c| (c.obstacle, c.feature) == key).map(|c| c.normal_force)
        };
        let names = force_names(self.feeder, &keys);
        let each = names.iter().zip(&keys).take(4);
        let series = each.map(|(name, key)| self.line(name, |s| force(s, *key))).collect();
        self.plot("Normal force", "N", true, series)
    }

    fn spin(&self) -> Plot {
        let sense = forward_sense(self.feeder);
        let line = self.line("ω", |s| Some(sense * s.state.twist.spin));
        self.plot("Spin", "1/s", true, vec![line])
    }

    fn angle(&self) -> Plot {
        if self.feeder.part.kind == PartKind::Disc {
            return Plot::default();
        }
        let line = self.line("φ", |s| Some(tilt_in(self.feeder, self.run, s.state.pose).to_degrees()));
        self.plot("Tilt", "°", false, vec![line])
    }

    fn velocity(&self) -> Plot {
        let x = self.line("v_x", |s| Some(s.state.twist.velocity.x));
        let y = self.line("v_y", |s| Some(s.state.twist.velocity.y));
        self.plot("Velocity of the mass centre", "m/s", true, vec![x, y])
    }

    /// Speed down the plate.
    fn speed_along(&self) -> Plot {
        let ends = self.stage.obstacle.and_then(|o| obstacle_ends(self.feeder, o));
        let Some(along) = ends.and_then(|(a, b)| (b - a).unit()) else { return Plot::default() };
        let line = self.line("speed down the plate", |s| Some(s.state.twist.velocity.dot(along)));
        self.plot("Speed along the plate", "m/s", true, vec![line])
    }

    /// v_r and v_φ about the first contact's point.
    fn about_contact(&self) -> Plot {
        let size = self.feeder.part.body.shape.size();
        let sense = forward_sense(self.feeder);
        let arm = |s: &Sample| Some(s.state.pose.centre - s.contacts.first()?.point);
        let clear = |r: Vec2| (r.norm() > UNSEEN * size).then(|| r.unit()).flatten();
        // Where the mass centre stands over the contact point the line has the direction that it takes next.
        let mut directions: Vec<Option<Vec2>> = vec![None; self.samples.len()];
        let mut next = None;
        for (place, (_, s)) in directions.iter_mut().zip(&self.samples).rev() {
            next = arm(s).and_then(clear).or(next);
            *place = arm(s).and(next);
        }
        let resolved = |turn: fn(Vec2) -> Vec2, factor: f64, name: &str| {
            let mut series = self.line(name, |_| None);
            let finite = self.samples.iter().zip(&directions);
            let values: Vec<f64> = finite
                .map(|((_, s), d)| d.map_or(f64::NAN, |d| factor * s.state.twist.velocity.dot(turn(d))))
                .collect();
            for (point, value) in series.points.iter_mut().filter(|p| p.0.is_finite()).zip(values) {
                point.1 = value;
            }
            series
        };
        let radial = resolved(|d| d, 1.0, "v_r");
        let transverse = resolved(Vec2::turned_left, sense, "v_φ");
        self.plot(
            "Velocity of the mass centre about the contact point",
            "m/s",
            true,
            vec![radial, transverse],
        )
    }

    /// The gap to what is touched at the end of the stage.
    fn gap(&self) -> Plot {
        let Some(PieceEnd::Closes { obstacle, feature }) = self.pieces.last().map(|p| p.ended_by) else {
            return Plot::default();
        };
        // Another part of a feed moves itself: its gap is none of this part's samples.
        let fixed = self.feeder.plates.len() + self.feeder.walls.len();
        let prepared = self.feeder.prepare(Options::default());
        let Some(prepared) = prepared.ok().filter(|_| obstacle < fixed) else { return Plot::default() };
        let pair = Pairing { body: 0, obstacle, feature };
        let gap = |s: &Sample| prepared.world().kinematics(&[s.state], pair).gap;
        // The part's side is where it is farthest: a bounce starts and ends at the plate.
        let gaps = self.samples.iter().map(|(_, s)| gap(s));
        let Some(side) = gaps.max_by(|a, b| a.abs().total_cmp(&b.abs())) else { return Plot::default() };
        let sign = if side < 0.0 { -1.0 } else { 1.0 };
        let line = self.line("g", |s| Some(1e3 * sign * gap(s)));
        let to =
            format!("{} to “{}”", part::feature(self.feeder, feature), part::obstacle(self.feeder, obstacle));
        Plot { remark: to, ..self.plot("Gap", "mm", true, vec![line]) }
    }

    /// τ_c and n_c: the mass centre from the struck point, in the struck plate's axes.
    fn centre_from(&self, impact: &Impact) -> Plot {
        let Some((contact, (from, to))) =
            impact.contacts.first().and_then(|c| Some((c, obstacle_ends(self.feeder, c.obstacle)?)))
        else {
            return Plot::default();
        };
        let along = (to - from).unit().unwrap_or_default();
        let out = upward(along);
        let arm = |s: &Sample| s.state.pose.centre - contact.point;
        let tau = self.line("τ_c", |s| Some(1e3 * arm(s).dot(along)));
        let n = self.line("n_c", |s| Some(1e3 * arm(s).dot(out)));
        self.plot("Mass centre from the struck point", "mm", true, vec![tau, n])
    }
}

/// What touches where, short enough for a legend: as few words as tell all of them apart.
fn force_names(feeder: &Feeder, keys: &[(usize, Feature)]) -> Vec<String> {
    if keys.len() == 1 {
        return vec!["N".to_owned()];
    }
    let part = |feature| part::feature(feeder, feature);
    let brief = |&(_, feature): &(usize, Feature)| match feature {
        Feature::VertexOnFace { .. } => part(feature),
        Feature::FaceOnEnd { .. } | Feature::VertexOnEnd { .. } => "edge".to_owned(),
    };
    let longer = |&(obstacle, feature): &(usize, Feature)| match feature {
        Feature::VertexOnFace { .. } => format!("{} on {}", part(feature), part::obstacle(feeder, obstacle)),
        Feature::FaceOnEnd { .. } | Feature::VertexOnEnd { .. } => format!("{} on edge", part(feature)),
    };
    let names: Vec<String> = keys.iter().map(brief).collect();
    let is_shared = |name: &String| names.iter().filter(|other| *other == name).count() > 1;
    let told_apart = |(name, key): (&String, _)| if is_shared(name) { longer(key) } else { name.clone() };
    names.iter().zip(keys).map(told_apart).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom_motion::planar::Obstacle;

    #[test]
    fn forces_of_one_plot_have_names_of_their_own() {
        let feeder = carom_feeder::examples::rod_on_a_slope(0.2);
        let (end, left) = (Obstacle::TO, Obstacle::LEFT);
        let edge = |face| (0, Feature::FaceOnEnd { face, end });
        let flat = |obstacle| (obstacle, Feature::VertexOnFace { vertex: 0, face: left });
        assert_eq!(force_names(&feeder, &[edge(0)]), ["N"], "one needs no name");
        let names = force_names(&feeder, &[flat(0), edge(0), edge(1)]);
        assert_eq!(names[1..], ["face 0 on edge", "face 1 on edge"], "{names:?}");
        let names = force_names(&carom_feeder::examples::disc_above_a_tray(), &[flat(0), flat(1)]);
        assert_ne!(names[0], names[1], "one corner on two plates");
        let alone = force_names(&feeder, &[flat(0), edge(0)]);
        assert_eq!(alone[1], "edge", "short where that is enough");
    }
}
