//! Every quantity of a drawing under its path.

use crate::drawing::{Drawing, Heft, Level, Outline, PartDrawing, Place, Reach, Surface};
use crate::quantity::Quantity;

/// Called with the path of a quantity and the quantity.
type Visitor<'v> = dyn FnMut(&str, &mut Quantity) + 'v;

impl Drawing {
    /// Calls `visitor` with every quantity, in the order of a scene.
    pub(crate) fn visit(&mut self, visitor: &mut Visitor<'_>) {
        visitor("gravity", &mut self.gravity);
        visit_part(&mut self.part, visitor);
        if let Some(friction) = &mut self.contact.friction {
            visitor("contact.friction", friction);
        }
        visitor("contact.restitution", &mut self.contact.restitution);
        visitor("start.to_edge", &mut self.start.to_edge);
        visitor("start.speed", &mut self.start.speed);
        if let Some(channel) = &mut self.channel {
            visitor("channel.width", &mut channel.width);
            visit_surface("channel", &mut channel.surface, visitor);
        }
        for plate in &mut self.plates {
            let path = format!("plate.{}", plate.name);
            visit_place(&path, &mut plate.place, visitor);
            visit_surface(&path, &mut plate.surface, visitor);
        }
        if let Some(zigzag) = &mut self.zigzag {
            visitor("zigzag.plates", &mut zigzag.plates);
            visitor("zigzag.drop", &mut zigzag.drop);
            visitor("zigzag.slope", &mut zigzag.slope);
            visitor("zigzag.gap", &mut zigzag.gap);
            visitor("zigzag.height", &mut zigzag.height);
            visit_surface("zigzag", &mut zigzag.surface, visitor);
        }
        for wall in &mut self.walls {
            let path = format!("wall.{}", wall.name);
            visit_pair(&path, "from", &mut wall.from, visitor);
            visit_pair(&path, "to", &mut wall.to, visitor);
            visit_surface(&path, &mut wall.surface, visitor);
        }
        if let Some(feed) = &mut self.feed {
            visitor("feed.parts", &mut feed.parts);
            visitor("feed.interval", &mut feed.interval);
            visit_surface("feed", &mut feed.surface, visitor);
        }
    }
}

fn visit_part(part: &mut PartDrawing, visitor: &mut Visitor<'_>) {
    match &mut part.outline {
        Outline::Rod { length } => visitor("part.length", length),
        Outline::Box { length, height } => {
            visitor("part.length", length);
            visitor("part.height", height);
        }
        Outline::Polygon { vertices } => {
            for (i, vertex) in vertices.iter_mut().enumerate() {
                visit_pair("part.vertices", &i.to_string(), vertex, visitor);
            }
        }
        Outline::Disc { radius } => visitor("part.radius", radius),
        Outline::File { scale, .. } => visitor("part.scale", scale),
    }
    if let Some(radius) = &mut part.corner_radius {
        visitor("part.corner_radius", radius);
    }
    match &mut part.heft {
        Heft::Mass(mass) => visitor("part.mass", mass),
        Heft::Density { density, depth } => {
            visitor("part.density", density);
            visitor("part.depth", depth);
        }
    }
    if let Some(inertia) = &mut part.inertia {
        visitor("part.inertia", inertia);
    }
}

fn visit_place(path: &str, place: &mut Place, visitor: &mut Visitor<'_>) {
    let of = |key: &str| format!("{path}.{key}");
    match place {
        Place::Origin { slope, length, .. } => {
            visitor(&of("slope"), slope);
            if let Some(length) = length {
                visitor(&of("length"), length);
            }
        }
        Place::Hinged { level, slope, reach, .. } => {
            match level {
                Level::Height(height) => visitor(&of("height"), height),
                Level::Drop(drop) => visitor(&of("drop"), drop),
            }
            visitor(&of("slope"), slope);
            match reach {
                Reach::Gap(gap) => visitor(&of("gap"), gap),
                Reach::Length(length) => visitor(&of("length"), length),
            }
        }
        Place::Line { along, normal, .. } => {
            visitor(&of("line.along"), along);
            visitor(&of("line.normal"), normal);
        }
        Place::Through { slope, below, .. } => {
            visitor(&of("slope"), slope);
            visit_pair(path, "below", below, visitor);
        }
        Place::Edge { edge, slope, length, .. } => {
            visit_pair(path, "edge", edge, visitor);
            visitor(&of("slope"), slope);
            visitor(&of("length"), length);
        }
        Place::Ends { from, to } => {
            visit_pair(path, "from", from, visitor);
            visit_pair(path, "to", to, visitor);
        }
    }
}

fn visit_surface(path: &str, surface: &mut Surface, visitor: &mut Visitor<'_>) {
    if let Some(friction) = &mut surface.friction {
        visitor(&format!("{path}.friction"), friction);
    }
    if let Some(restitution) = &mut surface.restitution {
        visitor(&format!("{path}.restitution"), restitution);
    }
}

fn visit_pair(path: &str, key: &str, pair: &mut [Quantity; 2], visitor: &mut Visitor<'_>) {
    let [x, y] = pair;
    visitor(&format!("{path}.{key}.x"), x);
    visitor(&format!("{path}.{key}.y"), y);
}
