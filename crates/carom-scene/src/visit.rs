//! Every quantity of a drawing under its path.

use crate::chain::{ArcDrawing, ChainDrawing};
use crate::drawing::{
    Drawing, Level, MassSpec, Outline, PartDrawing, Place, PlateDrawing, Reach, Surface, WallCourse,
};
use crate::label::{label_beside, labelled};
use crate::library::LibraryPart;
use crate::problem::{Problem, ProblemKind};
use crate::quantity::Quantity;
use crate::suggest::nearest;
use std::fmt;

/// Called with the path of a quantity, written out only where somebody reads it, and the quantity.
type Visitor<'v> = dyn FnMut(fmt::Arguments<'_>, &mut Quantity) + 'v;

impl Drawing {
    /// Calls `visitor` with every quantity, in the order of a scene.
    pub(crate) fn visit(&mut self, visitor: &mut Visitor<'_>) {
        visitor(format_args!("gravity"), &mut self.gravity);
        visit_part(&mut self.part, visitor);
        // It may be left out where every surface has its own: then there is no number to vary.
        if let Some(friction) = &mut self.contact.friction {
            visitor(format_args!("contact.friction"), friction);
        }
        visitor(format_args!("contact.restitution"), &mut self.contact.restitution);
        visitor(format_args!("start.to_edge"), &mut self.start.to_edge);
        visitor(format_args!("start.speed"), &mut self.start.speed);
        let start = [("turn", &mut self.start.turn), ("aside", &mut self.start.aside)];
        for (key, quantity) in start {
            if let Some(quantity) = quantity {
                visitor(format_args!("start.{key}"), quantity);
            }
        }
        if let Some(channel) = &mut self.channel {
            visitor(format_args!("channel.width"), &mut channel.width);
            visit_surface(format_args!("channel"), &mut channel.surface, visitor);
        }
        if let Some(groove) = &mut self.groove {
            visitor(format_args!("groove.width"), &mut groove.width);
            visit_surface(format_args!("groove"), &mut groove.surface, visitor);
        }
        self.plates.iter_mut().for_each(|plate| visit_plate(plate, visitor));
        if let Some(zigzag) = &mut self.zigzag {
            visitor(format_args!("zigzag.plates"), &mut zigzag.plates);
            visitor(format_args!("zigzag.drop"), &mut zigzag.drop);
            visitor(format_args!("zigzag.slope"), &mut zigzag.slope);
            visitor(format_args!("zigzag.gap"), &mut zigzag.gap);
            visitor(format_args!("zigzag.height"), &mut zigzag.height);
            visit_surface(format_args!("zigzag"), &mut zigzag.surface, visitor);
        }
        for wall in &mut self.walls {
            let name = &wall.name;
            match &mut wall.course {
                WallCourse::Ends { from, to } => {
                    visit_pair(format_args!("wall.{name}.from"), from, visitor);
                    visit_pair(format_args!("wall.{name}.to"), to, visitor);
                }
                WallCourse::Chain { chain } => visit_bent(format_args!("wall.{name}"), chain, visitor),
            }
            if let Some(radius) = &mut wall.edge_radius {
                visitor(format_args!("wall.{name}.edge_radius"), radius);
            }
            visit_surface(format_args!("wall.{name}"), &mut wall.surface, visitor);
        }
        for pin in &mut self.pins {
            let name = &pin.name;
            for (end, places) in ["from", "to"].into_iter().zip(&mut pin.ends) {
                for (axis, place) in ["x", "y", "z"].into_iter().zip(places) {
                    visitor(format_args!("pin.{name}.{end}.{axis}"), place);
                }
            }
            visitor(format_args!("pin.{name}.radius"), &mut pin.radius);
            visit_surface(format_args!("pin.{name}"), &mut pin.surface, visitor);
        }
        if let Some(feed) = &mut self.feed {
            visitor(format_args!("feed.parts"), &mut feed.parts);
            visitor(format_args!("feed.interval"), &mut feed.interval);
            visit_surface(format_args!("feed"), &mut feed.surface, visitor);
        }
    }
}

fn visit_plate(plate: &mut PlateDrawing, visitor: &mut Visitor<'_>) {
    let name = &plate.name;
    visit_place(format_args!("plate.{name}"), &mut plate.place, visitor);
    if let Some(radius) = &mut plate.edge_radius {
        visitor(format_args!("plate.{name}.edge_radius"), radius);
    }
    let wide = [
        ("width", &mut plate.width),
        ("roll", &mut plate.roll),
        ("side_walls", &mut plate.side_walls),
        ("v_angle", &mut plate.v_angle),
    ];
    for (key, quantity) in wide {
        if let Some(quantity) = quantity {
            visitor(format_args!("plate.{name}.{key}"), quantity);
        }
    }
    visit_surface(format_args!("plate.{name}"), &mut plate.surface, visitor);
}

fn visit_part(part: &mut PartDrawing, visitor: &mut Visitor<'_>) {
    match &mut part.outline {
        Outline::Rod { length } => visitor(format_args!("part.length"), length),
        Outline::Box { length, height } => {
            visitor(format_args!("part.length"), length);
            visitor(format_args!("part.height"), height);
        }
        Outline::Polygon { vertices } => {
            for (i, vertex) in vertices.iter_mut().enumerate() {
                visit_pair(format_args!("part.vertices.{i}"), vertex, visitor);
            }
        }
        Outline::Chain { chain } => visit_chain(format_args!("part.points"), chain, visitor),
        Outline::Disc { radius } => visitor(format_args!("part.radius"), radius),
        Outline::File { scale, .. } => visitor(format_args!("part.scale"), scale),
        Outline::Library(part) => visit_library(part, visitor),
        Outline::Solid(_) => {}
    }
    if let Some(radius) = &mut part.corner_radius {
        visitor(format_args!("part.corner_radius"), radius);
    }
    match &mut part.mass {
        MassSpec::Mass(mass) => visitor(format_args!("part.mass"), mass),
        MassSpec::Density { density, depth } => {
            visitor(format_args!("part.density"), density);
            if let Some(depth) = depth {
                visitor(format_args!("part.depth"), depth);
            }
        }
    }
    if let Some(given) = &mut part.mass_centre {
        visit_pair(format_args!("part.mass_centre"), &mut given.at, visitor);
    }
    if let Some(inertia) = &mut part.inertia {
        visitor(format_args!("part.inertia"), inertia);
    }
}

fn visit_library(part: &mut LibraryPart, visitor: &mut Visitor<'_>) {
    match part {
        LibraryPart::Revolved(part) => {
            visit_chain(format_args!("part.profile"), &mut part.profile, visitor);
            if let Some(bore) = &mut part.bore {
                visit_chain(format_args!("part.bore"), bore, visitor);
            }
        }
        other => {
            for (name, quantity) in other.dimensions() {
                visitor(format_args!("part.{name}"), quantity);
            }
        }
    }
}

fn visit_place(path: fmt::Arguments<'_>, place: &mut Place, visitor: &mut Visitor<'_>) {
    match place {
        Place::Origin { slope, length, .. } => {
            visitor(format_args!("{path}.slope"), slope);
            if let Some(length) = length {
                visitor(format_args!("{path}.length"), length);
            }
        }
        Place::Hinged { level, slope, reach, .. } => {
            match level {
                Level::Height(height) => visitor(format_args!("{path}.height"), height),
                Level::Drop(drop) => visitor(format_args!("{path}.drop"), drop),
            }
            visitor(format_args!("{path}.slope"), slope);
            match reach {
                Reach::Gap(gap) => visitor(format_args!("{path}.gap"), gap),
                Reach::Length(length) => visitor(format_args!("{path}.length"), length),
            }
        }
        Place::Line { along, normal, .. } => {
            visitor(format_args!("{path}.line.along"), along);
            visitor(format_args!("{path}.line.normal"), normal);
        }
        Place::Through { slope, below, .. } => {
            visitor(format_args!("{path}.slope"), slope);
            visit_pair(format_args!("{path}.below"), below, visitor);
        }
        Place::Edge { edge, slope, length, .. } => {
            visit_pair(format_args!("{path}.edge"), edge, visitor);
            visitor(format_args!("{path}.slope"), slope);
            visitor(format_args!("{path}.length"), length);
        }
        Place::Ends { from, to } => {
            visit_pair(format_args!("{path}.from"), from, visitor);
            visit_pair(format_args!("{path}.to"), to, visitor);
        }
        Place::Chain { chain } => visit_bent(path, chain, visitor),
    }
}

fn visit_bent(path: fmt::Arguments<'_>, chain: &mut ChainDrawing, visitor: &mut Visitor<'_>) {
    visit_chain(format_args!("{path}.chain"), chain, visitor);
    if let Some(radius) = &mut chain.bend_radius {
        visitor(format_args!("{path}.bend_radius"), radius);
    }
}

/// Points and arcs go by their number in the list.
fn visit_chain(path: fmt::Arguments<'_>, chain: &mut ChainDrawing, visitor: &mut Visitor<'_>) {
    for stop in &mut chain.stops {
        let number = stop.number;
        visit_pair(format_args!("{path}.{number}"), &mut stop.at, visitor);
        let path = format_args!("{path}.{}.arc", number + 1);
        match &mut stop.arc {
            Some((ArcDrawing::Through(point), _)) => {
                visit_pair(format_args!("{path}.through"), point, visitor)
            }
            Some((ArcDrawing::About { centre, .. }, _)) => {
                visit_pair(format_args!("{path}.centre"), centre, visitor);
            }
            Some((ArcDrawing::OfRadius { radius, .. }, _)) => visitor(format_args!("{path}.radius"), radius),
            None => {}
        }
    }
}

fn visit_surface(path: fmt::Arguments<'_>, surface: &mut Surface, visitor: &mut Visitor<'_>) {
    if let Some(friction) = &mut surface.friction {
        visitor(format_args!("{path}.friction"), friction);
    }
    if let Some(restitution) = &mut surface.restitution {
        visitor(format_args!("{path}.restitution"), restitution);
    }
}

fn visit_pair(path: fmt::Arguments<'_>, pair: &mut [Quantity; 2], visitor: &mut Visitor<'_>) {
    let [x, y] = pair;
    visitor(format_args!("{path}.x"), x);
    visitor(format_args!("{path}.y"), y);
}

pub(crate) fn unknown(path: &str, paths: &[&str]) -> Problem {
    let problem = Problem::new(ProblemKind::UnknownKey, path, "the scene has no such quantity", None);
    match nearest(path, paths) {
        Some(near) => problem.with_help(format!("did you mean \"{near}\"{}?", label_beside(near))),
        None => {
            let all: Vec<_> = paths.iter().map(|path| labelled(path)).collect();
            problem.with_help(format!("it has {}", all.join(", ")))
        }
    }
}

/// The path with a plate's number replaced by its name.
pub(crate) fn canonical(path: &str, paths: &[&str]) -> String {
    let parts: Vec<&str> = path.splitn(3, '.').collect();
    let [list @ ("plate" | "wall"), name, key] = parts[..] else { return path.to_owned() };
    if paths.contains(&path) {
        return path.to_owned();
    }
    let mut names: Vec<&str> = vec![];
    for known in paths {
        let mut pieces = known.splitn(3, '.');
        if pieces.next() == Some(list)
            && let Some(found) = pieces.next()
            && !names.contains(&found)
        {
            names.push(found);
        }
    }
    match name.parse::<usize>().ok().and_then(|number| names.get(number)) {
        Some(found) => format!("{list}.{found}.{key}"),
        None => path.to_owned(),
    }
}
