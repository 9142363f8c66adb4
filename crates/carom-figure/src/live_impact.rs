//! The report of an impact piece by piece, for a page that stays open while the impact changes.

use crate::impact_page::{ImpactFigure, ImpactPicture, after, examined, shared};
use crate::impulse_drawing::{drawing, track};
use crate::joint_drawing::{joint_drawing, joint_tracks};
use crate::markup::notes;

/// What the report of an impact says, section by section, as HTML.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LiveImpact {
    /// Sentences that must not be missed.
    pub notes: String,
    /// Contacts and bodies after it.
    pub after: String,
    /// What other conventions on sharing say.
    pub shared: String,
    /// The end states, and what rejects the others.
    pub hypotheses: String,
}

/// The sections of the report of an impact.
///
/// # Example
/// ```
/// use carom_figure::{ImpactFigure, live_impact};
/// let figure = ImpactFigure { found: vec!["A sticks".to_owned()], rejected: Some(vec![]), ..ImpactFigure::default() };
/// assert!(live_impact(&figure).hypotheses.contains("One end state is consistent"));
/// ```
pub fn live_impact(figure: &ImpactFigure) -> LiveImpact {
    LiveImpact {
        notes: notes(&figure.notes).into_string(),
        after: after(figure).into_string(),
        shared: shared(&figure.shared).into_string(),
        hypotheses: examined(figure).into_string(),
    }
}

/// The walk through an impact, for a page that lets it go on.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LiveWalk {
    /// The picture, as SVG.
    pub svg: String,
    /// Places in the picture at the start and at the end of each stage, straight between; each with the number of its contact.
    pub tracks: Vec<(usize, Vec<[f64; 2]>)>,
}

/// The walk as a picture with the places that go on in it; `None` where there is no impulse to draw.
///
/// # Example
/// ```
/// use carom_figure::{ImpactPicture, ImpulsePlane, ImpulsePoint, live_walk};
/// use carom_impact::Phase;
/// let end = ImpulsePoint { normal: 2.0, tangential: -0.3, phase: Phase::Compression, label: String::new() };
/// let plane = ImpulsePlane { operator: None, slip: 1.0, approach: -2.0, friction: 0.3, points: vec![end] };
/// let walk = live_walk(&ImpactPicture::Plane(plane)).unwrap();
/// assert_eq!(walk.tracks[0].1.len(), 2, "from the start to the end of the one stage");
/// ```
pub fn live_walk(picture: &ImpactPicture) -> Option<LiveWalk> {
    let (svg, tracks) = match picture {
        ImpactPicture::Walk(walk) => (joint_drawing(walk, false)?, joint_tracks(walk)),
        ImpactPicture::Plane(plane) => (drawing(plane, false)?, vec![(0, track(plane))]),
    };
    Some(LiveWalk { svg: svg.into_string(), tracks })
}
