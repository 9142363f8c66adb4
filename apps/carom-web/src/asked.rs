//! What a scene asks of a design, for a form.

use crate::reply::{DesignAsked, DesignLimit, FreeRange};
use carom::study::design::Aim;
use carom_scene::quantity::Quantity;
use carom_scene::{Scene, Want};
use carom_words::{Words, part};

/// What a scene's `[design]` says, for a form.
pub(crate) fn design(scene: &Scene) -> DesignAsked {
    let none = carom_scene::Design::default();
    let design = scene.design().unwrap_or(&none);
    let written = |of: &Quantity| of.span.clone().and_then(|span| scene.source().get(span));
    let limit = |key, label, of: &Option<Quantity>, unit| DesignLimit {
        key,
        label,
        text: of.as_ref().and_then(written).unwrap_or_default().trim_matches('"').to_owned(),
        unit,
    };
    let want = |want: &Option<Want>| match want {
        None => String::new(),
        Some(Want::Face(face)) => face.to_string(),
        Some(want) => want.word().to_owned(),
    };
    let plates = scene.wants().iter().enumerate();
    DesignAsked {
        wants: plates.map(|(plate, of)| [part::obstacle(scene.feeder(), plate), want(of)]).collect(),
        free: design
            .free
            .iter()
            .map(|free| FreeRange { path: free.path.clone(), from: free.low, to: free.high })
            .collect(),
        limits: vec![
            limit("max_impact_speed", "strikes at most", &design.max_impact_speed, "m/s"),
            limit("max_sliding_speed", "slides at most", &design.max_sliding_speed, "m/s"),
            limit("max_height", "height at most", &design.max_height, "m"),
            limit("max_width", "width at most", &design.max_width, "m"),
            limit("max_time", "takes at most", &design.max_time, "s"),
        ],
        forbid_walls: design.forbid_walls,
        aim: design.aim.word(),
        aims: Aim::ALL.iter().map(|aim| aim.word()).collect(),
    }
}
