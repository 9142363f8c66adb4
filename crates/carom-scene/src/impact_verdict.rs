//! What is known of an impact's answer: whether it is the only one, and if not, why not.

use carom_impact::ImpactError;
use schemars::JsonSchema;
use serde::Serialize;
use std::fmt::Write as _;

/// Whether an impact has one answer.
///
/// # Example
/// A ball has one.
/// ```
/// use carom_scene::*;
/// let ball = ImpactProblem::parse("ball.toml", r#"
///     body = { mass = 2, inertia = 0.4, velocity = [0, -3] }
///     contact = [{ point = [0, -1], normal = [0, 1], friction = 0.3, restitution = 0.5 }]
/// "#)?;
/// assert_eq!(ImpactAnswerReport::new(&ball, &ball.solve()).outcome, ImpactOutcome::Unique);
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ImpactOutcome {
    /// One end state is consistent, the walk ends in it, and nothing was chosen on the way.
    Unique,
    /// The walk chose, one of several ways on or one of many shares of compression; or several end states are consistent, and it ends in
    /// one of them.
    Several,
    /// The walk chose nothing and ends in none of the end states: the end depends on the way there.
    PathDependent,
    /// No end state is consistent.
    None,
    /// End states are consistent, but the walk that tells which of them is reached has no answer.
    Unresolved,
    /// One end state was found; others were not searched for.
    Found,
    /// No end state was found; that there is none is not known.
    NotFound,
}

/// Whether every end state was examined.
///
/// # Example
/// ```
/// use carom_scene::Uniqueness;
/// assert_eq!(serde_json::to_string(&Uniqueness::NotExamined).unwrap(), r#""not_examined""#);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Uniqueness {
    /// Every end state is listed.
    Examined,
    /// Of more contacts than can be enumerated one end state is sought, and no other.
    NotExamined,
}

/// What a convention on sharing says of the answer.
///
/// # Example
/// Contacts that return nothing are no springs: that convention does not apply, and so it does not differ.
/// ```
/// use carom_scene::*;
/// let text = std::fs::read_to_string("../../examples/impact_step.toml")?;
/// let step = ImpactProblem::parse("step.toml", &text)?;
/// let report = ImpactAnswerReport::new(&step, &step.solve());
/// let verdicts: Vec<SharingVerdict> = report.sharing.iter().map(|shared| shared.verdict).collect();
/// assert_eq!(verdicts, [SharingVerdict::Agrees, SharingVerdict::Agrees, SharingVerdict::DoesNotApply]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SharingVerdict {
    /// It moves as the answer does.
    Agrees,
    /// It moves otherwise.
    Differs,
    /// It is not for these contacts: `because` names what it would need.
    DoesNotApply,
    /// It was followed and came to no end: `because` says how.
    NoAnswer,
}

impl SharingVerdict {
    /// In words: "does not apply".
    ///
    /// # Example
    /// ```
    /// use carom_scene::SharingVerdict;
    /// assert_eq!(SharingVerdict::NoAnswer.words(), "no answer");
    /// ```
    pub fn words(self) -> &'static str {
        match self {
            Self::Agrees => "agrees",
            Self::Differs => "differs",
            Self::DoesNotApply => "does not apply",
            Self::NoAnswer => "no answer",
        }
    }

    pub(crate) fn of_error(error: &ImpactError) -> Self {
        match error {
            ImpactError::OutsideDomain { .. } | ImpactError::Faults(_) | ImpactError::TooMany { .. } => {
                Self::DoesNotApply
            }
            _ => Self::NoAnswer,
        }
    }
}

/// What all conventions say together: "all conventions agree"; those that do not apply have no part in it.
///
/// # Example
/// ```
/// use carom_scene::{SharingVerdict::*, sharing_words};
/// assert_eq!(sharing_words(&[Agrees, Agrees, DoesNotApply]), "all conventions that apply agree");
/// assert_eq!(sharing_words(&[Agrees, Differs, NoAnswer]), "the conventions disagree");
/// ```
pub fn sharing_words(verdicts: &[SharingVerdict]) -> &'static str {
    let any = |of: SharingVerdict| verdicts.contains(&of);
    if any(SharingVerdict::Differs) {
        "the conventions disagree"
    } else if any(SharingVerdict::DoesNotApply) || any(SharingVerdict::NoAnswer) {
        if any(SharingVerdict::NoAnswer) {
            "all conventions with an answer agree"
        } else {
            "all conventions that apply agree"
        }
    } else {
        "all conventions agree"
    }
}

/// What decides whether an impact has one answer.
///
/// # Example
/// One end state, but the walk ends elsewhere.
/// ```
/// use carom_scene::{Certainty, ImpactOutcome};
/// let certainty = Certainty { path_dependent: true, ..Certainty::of_ends(1) };
/// assert_eq!(certainty.outcome(), ImpactOutcome::PathDependent);
/// let words = "one end state, but the walk ends elsewhere: the end depends on the way there";
/// assert_eq!(certainty.words(), words);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Certainty {
    /// Consistent end states.
    pub ends: usize,
    /// Whether every end state was examined.
    pub examined: bool,
    /// True where the walk has an answer, or where none is walked.
    pub resolved: bool,
    /// The walk ends in none of the end states.
    pub path_dependent: bool,
    /// Largest number of ways on that the walk met.
    pub branches: usize,
    /// Another share of compression leaves another motion.
    pub open_share: bool,
    /// False where the walk obeys another law than the end states, Stronge's or that of springs: the two are not compared then.
    pub compared: bool,
    /// One contact acts: its walk is the only one where it chose nothing.
    pub alone: bool,
}

impl Certainty {
    /// Of so many end states, all examined, where nothing else is open.
    ///
    /// # Example
    /// ```
    /// use carom_scene::{Certainty, ImpactOutcome};
    /// assert_eq!(Certainty::of_ends(2).outcome(), ImpactOutcome::Several);
    /// assert_eq!(Certainty::of_ends(2).words(), "2 end states");
    /// ```
    pub fn of_ends(ends: usize) -> Self {
        Self {
            ends,
            examined: true,
            resolved: true,
            path_dependent: false,
            branches: 1,
            open_share: false,
            compared: true,
            alone: false,
        }
    }

    /// The one word for it.
    ///
    /// # Example
    /// A walk that chose has not the only answer.
    /// ```
    /// use carom_scene::{Certainty, ImpactOutcome};
    /// let chose = Certainty { branches: 2, ..Certainty::of_ends(1) };
    /// assert_eq!(chose.outcome(), ImpactOutcome::Several);
    /// ```
    pub fn outcome(&self) -> ImpactOutcome {
        match (self.examined, self.ends) {
            // End states of another law say nothing about this walk, nor that there is no other.
            (true, _) if !self.compared && self.resolved => {
                match (self.branches > 1 || self.open_share, self.alone) {
                    (true, _) => ImpactOutcome::Several,
                    (false, true) => ImpactOutcome::Unique,
                    (false, false) => ImpactOutcome::Found,
                }
            }
            (false, 0) => ImpactOutcome::NotFound,
            (false, _) => ImpactOutcome::Found,
            (true, 0) => ImpactOutcome::None,
            (true, _) if !self.resolved => ImpactOutcome::Unresolved,
            (true, _) if self.branches > 1 || self.open_share => ImpactOutcome::Several,
            (true, _) if self.path_dependent => ImpactOutcome::PathDependent,
            (true, 1) => ImpactOutcome::Unique,
            (true, _) => ImpactOutcome::Several,
        }
    }

    /// In words, for a headline: how many end states there are, and what else is open.
    ///
    /// # Example
    /// ```
    /// use carom_scene::Certainty;
    /// let words = Certainty { open_share: true, ..Certainty::of_ends(1) }.words();
    /// assert_eq!(words, "one end state, but the share of compression is open: others leave other motions");
    /// ```
    pub fn words(&self) -> String {
        let mut words = match (self.ends, self.examined) {
            _ if !self.compared => {
                "one answer of the walk; end states obey Poisson's law, contacts closing together, and are not compared"
                    .to_owned()
            }
            (0, false) => "no end state was found".to_owned(),
            (_, false) => "one end state, others not searched for".to_owned(),
            (0, true) => "no end state is consistent".to_owned(),
            (1, true) => "one end state".to_owned(),
            (n, true) => format!("{n} end states"),
        };
        let mut joint = ", but";
        let mut say = |open: bool, what: &str| {
            if open {
                // Writing to a String cannot fail.
                let _ = write!(words, "{joint} {what}");
                joint = "; and";
            }
        };
        let ways = format!("up to {} ways on were consistent, and one was chosen", self.branches);
        say(
            self.path_dependent && self.ends > 0,
            "the walk ends elsewhere: the end depends on the way there",
        );
        say(self.branches > 1, &ways);
        say(self.open_share, "the share of compression is open: others leave other motions");
        words
    }
}
