//! An impact on the bench: its answer, its pictures and its words.

use crate::answer::named;
use crate::fields::{fields, moved, written};
use crate::reply::{BesideShown, Failure, ForcesShown, Headline, LabGrip, LabShown, Reply};
use crate::request::{Change, Frame, Pulled, PulledKey, Window, point};
use carom::tasks::impact::space::SpatialImpactStudy;
use carom::tasks::impact::{Beside, ImpactStudy, words};
use carom_figure::{ImpactSketch, SketchView, live_impact, live_sketch, live_walk};
use carom_num::Vec2;
use carom_scene::{AnyImpact, Form, SpatialWalkStageReport, editing};
use std::path::Path;

/// Pixels from a contact to the grip of its normal.
const NORMAL: f64 = 72.0;
/// The least length of the arrow that a velocity is pulled by, from its mass centre [px].
const LEAST_ARROW: f64 = 26.0;
/// A pulled point moves in steps of about so many pixels.
const STEP: f64 = 3.0;
/// Steps of a normal, in small and in large [rad].
const TURNS: [f64; 2] = [0.1_f64.to_radians(), 1.0_f64.to_radians()];
/// Components of a direction are written in steps of this.
const WRITTEN: f64 = 1e-9;
/// Where no body is known there is nothing to draw: the window of the picture.
const EMPTY: ImpactSketch = ImpactSketch { bodies: vec![], contacts: vec![] };

/// Everything about an impact after a change.
pub(crate) fn shown(name: &str, text: &str, change: Option<&Change>, frame: Frame) -> Result<Reply, Failure> {
    let text = match change {
        Some(change) => changed(name, text, change, frame)?,
        None => text.to_owned(),
    };
    match AnyImpact::parse(name, &text)? {
        AnyImpact::Planar(problem) => in_the_plane(ImpactStudy::of(*problem), name, text, frame),
        AnyImpact::Spatial(problem) => in_space(&SpatialImpactStudy::of(*problem), name, text, frame),
    }
}

/// The window of a sketch.
fn seen(sketch: &ImpactSketch, frame: Frame) -> Result<SketchView, Failure> {
    Ok(match frame {
        Frame::Size(size) => sketch.view(size.map(|side| side.max(1.0))),
        Frame::Window(window) => SketchView { view: window.view()?, speed: window.speed },
    })
}

/// An impact in space: what is said of it, and no picture.
fn in_space(study: &SpatialImpactStudy, name: &str, text: String, frame: Frame) -> Result<Reply, Failure> {
    let figure = study.figure(name, "");
    let sections = live_impact(&figure);
    let states = |stage: &SpatialWalkStageReport| {
        let does: Vec<String> =
            stage.contacts.iter().map(|c| format!("{} {}", c.name, c.state.as_str())).collect();
        format!("{}: {}, until {}", stage.phase, does.join(", "), stage.ended_by)
    };
    let shown = LabShown {
        lead: figure.lead.clone(),
        unseen: "In space: an impact is drawn and pulled in the plane only.",
        stages: study.report.stages.iter().map(states).collect(),
        after: format!("{}{}", sections.notes, sections.after),
        hypotheses: sections.hypotheses,
        words: format!("An impact in space: {}.", figure.verdict),
        ..LabShown::default()
    };
    let seen = seen(&EMPTY, frame)?;
    Ok(reply(shown, figure.verdict, &seen, text))
}

fn reply(lab: LabShown, verdict: String, seen: &SketchView, text: String) -> Reply {
    Reply {
        kind: Some("impact"),
        window: Some(Window { speed: seen.speed, ..Window::of(&seen.view) }),
        lab: Some(Box::new(lab)),
        headline: Some(Headline { word: verdict, plate: None, wanted: None }),
        quantities: Some(fields(Form::Impact, &text)),
        text: Some(text),
        ..Reply::default()
    }
}

fn in_the_plane(study: ImpactStudy, name: &str, text: String, frame: Frame) -> Result<Reply, Failure> {
    let sketch = study.sketch().unwrap_or(EMPTY);
    let seen = seen(&sketch, frame)?;
    let report = &study.report;
    let verdict = words::shown(report).map_or_else(
        || format!("no answer: {}", report.not_staged.clone().unwrap_or_default()),
        |end| words::states(end, report.staged.as_ref()),
    );
    let said = format!("An impact: {verdict}.");
    let lab = lab(&study, name, (&sketch, &seen), said)?;
    Ok(reply(lab, verdict, &seen, text))
}

/// The files that `carom impact` writes.
pub(crate) fn files(name: &str, text: &str) -> Result<Reply, Failure> {
    let title = Path::new(name).file_stem().unwrap_or_default().to_string_lossy();
    let files = match AnyImpact::parse(name, text)? {
        AnyImpact::Planar(problem) => ImpactStudy::of(*problem).files(&title, text)?,
        AnyImpact::Spatial(problem) => {
            let study = SpatialImpactStudy::of(*problem);
            let json = format!("{}\n", serde_json::to_string_pretty(&study.report)?);
            let page = study.page(&title, text);
            vec![("impact.json".to_owned(), json), ("report.html".to_owned(), page)]
        }
    };
    Ok(Reply { files: Some(named(files)), ..Reply::default() })
}

fn lab(
    study: &ImpactStudy,
    name: &str,
    (sketch, seen): (&ImpactSketch, &SketchView),
    words: String,
) -> Result<LabShown, Failure> {
    let figure = study.figure(name, "");
    let sections = live_impact(&figure);
    let walk = study.picture().and_then(|picture| live_walk(&picture)).unwrap_or_default();
    let stage = |stage: &carom_scene::WalkStageReport| {
        let slips = stage.contacts.iter().zip(&study.problem.names);
        let slips: Vec<String> = slips.map(|(c, name)| format!("{name} {}", c.slip)).collect();
        format!("{}: {}, until {}", stage.phase, slips.join(", "), stage.ended_by)
    };
    let stages = study.report.staged.iter().flat_map(|staged| &staged.stages);
    let motion = study.motion().into_iter();
    let forces = study.under_forces(name)?.map(|found| ForcesShown {
        headline: found.headline,
        motions: found.motions,
        rejected: found.rejected,
    });
    Ok(LabShown {
        lead: figure.lead.clone(),
        sketch: live_sketch(sketch, seen),
        unseen: "Only the operator is known: there is no body to draw.",
        centres: sketch.bodies.iter().map(|body| pair(seen.view.at(point(body.centre)))).collect(),
        motion: motion
            .map(|bodies| bodies.into_iter().map(|([x, y], spin)| [x, y, spin]).collect())
            .collect(),
        grips: grips(sketch, seen),
        walk: walk.svg,
        tracks: walk.tracks,
        stages: stages.map(stage).collect(),
        after: format!("{}{}", sections.notes, sections.after),
        hypotheses: sections.hypotheses,
        laws: study.laws().into_iter().map(beside).collect(),
        sharings: study.sharings().into_iter().map(beside).collect(),
        forces,
        words,
    })
}

fn beside(one: Beside) -> BesideShown {
    let Beside { name, said, energy, asked } = one;
    BesideShown { name, said, energy, asked }
}

fn pair(v: Vec2) -> [f64; 2] {
    [v.x, v.y]
}

/// The places where something can be pulled.
fn grips(sketch: &ImpactSketch, seen: &SketchView) -> Vec<LabGrip> {
    let mut all = vec![];
    let mut add = |label: String, at: Vec2, table: String, key, from: [f64; 2], contact| {
        all.push(LabGrip { label, at: pair(at), pulled: Pulled { table, key, from }, contact });
    };
    let several = sketch.bodies.len() > 1;
    for (i, body) in sketch.bodies.iter().enumerate() {
        let table = if several { format!("body.{i}") } else { "body".to_owned() };
        let centre = seen.view.at(point(body.centre));
        let velocity = point(body.velocity);
        let along = velocity.unit().unwrap_or(Vec2::new(1.0, 0.0));
        let length = (velocity.norm() * seen.speed).max(LEAST_ARROW);
        let tip = centre + Vec2::new(along.x, -along.y) * length;
        let name = if body.name.is_empty() { "the body" } else { &body.name };
        add(format!("velocity of {name}"), tip, table.clone(), PulledKey::Velocity, body.centre, None);
        if several {
            add(format!("mass centre of {name}"), centre, table, PulledKey::Centre, body.centre, None);
        }
    }
    for (i, contact) in sketch.contacts.iter().enumerate() {
        let (table, name) = (format!("contact.{i}"), &contact.name);
        let at = seen.view.at(point(contact.point));
        let normal = point(contact.normal).unit().unwrap_or_default();
        add(format!("contact {name}"), at, table.clone(), PulledKey::Point, contact.point, Some(i));
        let tip = at + Vec2::new(normal.x, -normal.y) * NORMAL;
        add(format!("normal of {name}"), tip, table, PulledKey::Normal, contact.point, Some(i));
    }
    all
}

/// The text of an impact after a change.
fn changed(name: &str, text: &str, change: &Change, frame: Frame) -> Result<String, Failure> {
    let lost = || Failure::of_page("the file has no such table");
    match change {
        Change::Write { path, value } => written(text, path, value),
        Change::Move { values } => moved(Form::Impact, text, values),
        Change::Pull { pulled, at, fine } => {
            let value = value_at(pulled, window_of(frame)?, point(*at), *fine)?;
            let key = match pulled.key {
                PulledKey::Point => "point",
                PulledKey::Normal => "normal",
                PulledKey::Centre => "centre",
                PulledKey::Velocity => "velocity",
            };
            editing::setting(text, &pulled.table, key, &value).ok_or_else(lost)
        }
        Change::AddContact { at } => {
            let alone =
                matches!(AnyImpact::parse(name, text)?, AnyImpact::Planar(problem) if problem.body.is_some());
            if !alone {
                let message = "contacts are added to one body in the plane: of several, write which two meet";
                return Err(Failure::of_page(message));
            }
            let window = window_of(frame)?;
            let there = window.view()?.of(point(*at));
            let step = step(STEP / window.scale);
            // Towards the mass centre: what stands there touches the body from outside.
            let normal = (-there).unit().unwrap_or(Vec2::new(0.0, 1.0));
            let lines = format!(
                "point = {}\nnormal = {}\nfriction = 0.3",
                metres(there, step),
                direction(normal, TURNS[1])
            );
            Ok(editing::adding(text, "contact", &lines))
        }
        Change::RemoveContact { contact } => editing::without(text, "contact", *contact).ok_or_else(lost),
        _ => Err(Failure::of_page("this is an impact: only a scene has plates")),
    }
}

fn window_of(frame: Frame) -> Result<Window, Failure> {
    match frame {
        Frame::Window(window) => Ok(window),
        Frame::Size(_) => Err(Failure::of_page("a point is pulled within a window that is there")),
    }
}

/// What is written where something is pulled to a place of the window.
fn value_at(pulled: &Pulled, window: Window, at: Vec2, fine: bool) -> Result<String, Failure> {
    let view = window.view()?;
    let step_of = |pixels: f64| if fine { 0.1 * step(pixels) } else { step(pixels) };
    let from = view.at(point(pulled.from));
    let off = Vec2::new(at.x - from.x, from.y - at.y);
    Ok(match pulled.key {
        PulledKey::Point | PulledKey::Centre => metres(view.of(at), step_of(STEP / window.scale)),
        PulledKey::Normal => direction(off.unit().unwrap_or(Vec2::new(0.0, 1.0)), TURNS[usize::from(!fine)]),
        PulledKey::Velocity => {
            let known = window.speed > 0.0;
            if !known {
                return Err(Failure::of_page("the window has no scale of speeds"));
            }
            let step = step_of(STEP / window.speed);
            // Near the mass centre it stands still.
            let velocity =
                if off.norm() < 0.5 * LEAST_ARROW { Vec2::ZERO } else { off * (1.0 / window.speed) };
            let part = |value: f64| format!("\"{} m/s\"", stepped(value, step));
            format!("[{}, {}]", part(velocity.x), part(velocity.y))
        }
    })
}

/// 1, 2 or 5 of a power of ten, at least so large.
fn step(least: f64) -> f64 {
    let power = 10_f64.powi(least.log10().floor() as i32);
    [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .map(|factor| factor * power)
        .find(|step| *step >= least)
        .unwrap_or(least)
}

/// A value in whole steps, as short as it can be written.
fn stepped(value: f64, step: f64) -> String {
    let digits = (-step.log10().floor()).max(0.0) as usize;
    let text = format!("{:.digits$}", (value / step).round() * step);
    if text.trim_start_matches('-').chars().all(|c| matches!(c, '0' | '.')) { "0".to_owned() } else { text }
}

fn metres(at: Vec2, step: f64) -> String {
    let part = |value: f64| format!("\"{} mm\"", stepped(1e3 * value, 1e3 * step));
    format!("[{}, {}]", part(at.x), part(at.y))
}

/// A direction in whole steps of an angle.
fn direction(along: Vec2, step: f64) -> String {
    let angle = (carom_num::elementary::atan2(along.y, along.x) / step).round() * step;
    let unit = Vec2::at_angle(angle);
    let part = |value: f64| stepped(value, WRITTEN).trim_end_matches('0').trim_end_matches('.').to_owned();
    let whole = |text: String| if text.is_empty() || text == "-" { "0".to_owned() } else { text };
    format!("[{}, {}]", whole(part(unit.x)), whole(part(unit.y)))
}
