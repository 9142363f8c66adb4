//! The answer to an impact problem: the staged walk and every end state, or one end state of many contacts.

use crate::impact_contacts::{ImpactContacts, MOST_PIVOTED};
use crate::impact_file::{Convention, ImpactProblem};
use crate::impact_verdict::{Certainty, SharingVerdict};
use carom_impact::planar::{
    ContactSet6, ImpactType, MOST_CONTACTS,
    end_states::{self, EndState, EndStates},
    pivoting,
    share::{self, Share},
    sharing::{self, Sharing},
    single,
    staged::{self, StagedOutcome},
};
use carom_impact::{ImpactError, Law};
use carom_num::Vec2;
use carom_words::Words;

/// The staged walk: what happens.
///
/// # Example
/// A ball of 2 kg that strikes with 3 m/s and e = 1/2 takes `m (1 + e) v`, 9 N s, in two stages.
/// ```
/// use carom_scene::*;
/// let ball = ImpactProblem::parse("ball.toml", r#"
///     body = { mass = 2, inertia = 0.4, velocity = [0, -3] }
///     contact = [{ point = [0, -1], normal = [0, 1], friction = 0.3, restitution = 0.5 }]
/// "#)?;
/// let answer = ball.solve();
/// let walk = answer.walk().unwrap();
/// assert_eq!((walk.stages.len(), walk.path_dependent), (2, false));
/// assert!((walk.outcome.impulse[0][1] - 9.0).abs() < 1e-14);
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Walk {
    /// Its outcome.
    pub outcome: StagedOutcome<MOST_CONTACTS>,
    /// Its straight stages.
    pub stages: Vec<staged::Stage<MOST_CONTACTS>>,
    /// Type, where one contact acts.
    pub kind: Option<ImpactType>,
    /// True where it ends in none of the end states: the end depends on the way there.
    pub path_dependent: bool,
    /// How many contacts act.
    pub contacts: usize,
    /// False where it obeys another law than the end states, Stronge's or that of springs: they are not compared then.
    pub compared: bool,
    /// What other shares of compression leave, where these are open and matter.
    pub shares: Vec<(Share, StagedOutcome<MOST_CONTACTS>)>,
}

/// The numbers that decide the class of an impact at one contact.
///
/// ```text
/// P_d = s u_t (W_nn − sμW_tn)    P_q = −u_n (μW_tt − sW_tn)    μ_s = W_tn/W_tt    s = sign u_t
/// ```
///
/// Source: Wang and Mason, J. Appl. Mech. 59 (1992) 635.
///
/// # Example
/// A block without lever (W_tt = W_nn = 1, W_tn = 0) that slips with 0.1 m/s and approaches with 1 m/s: `P_d
/// = 0.1`, `P_q = 0.3`.
/// ```
/// use carom_scene::*;
/// let operator = "operator = { w_tt = 1, w_tn = 0, w_nn = 1, slip = 0.1, approach = -1, friction = 0.3 }";
/// let answer = ImpactProblem::parse("block.toml", operator)?.solve();
/// let ImpactAnswer::Examined(examined) = answer else { panic!("one contact") };
/// let Deciders { slip_demand, friction_supply, sticking_friction, .. } = examined.deciders.unwrap();
/// assert_eq!((slip_demand, friction_supply, sticking_friction), (0.1, 0.3, 0.0));
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Deciders {
    /// `P_d`.
    pub slip_demand: f64,
    /// `P_q`.
    pub friction_supply: f64,
    /// `μ_s`: friction that holds a contact without slip.
    pub sticking_friction: f64,
    /// The inequality that decided, in words.
    pub because: String,
}

/// The answer to an impact problem.
///
/// # Example
/// One contact is examined.
/// ```
/// use carom_scene::*;
/// let ball = ImpactProblem::parse("ball.toml", r#"
///     body = { mass = 2, inertia = 0.4, velocity = [0, -3] }
///     contact = [{ point = [0, -1], normal = [0, 1], friction = 0.3, restitution = 0.5 }]
/// "#)?;
/// assert!(matches!(ball.solve(), ImpactAnswer::Examined(_)));
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum ImpactAnswer {
    /// Up to [`MOST_CONTACTS`] contacts: what happens, and every end state.
    Examined(Box<Examined>),
    /// More: one end state by pivoting, or why none was found. Others were not searched for.
    Pivoted(Result<Box<EndState<MOST_PIVOTED>>, ImpactError>),
}

/// The answer at few contacts.
///
/// # Example
/// One contact has one end state, and nobody to share with.
/// ```
/// use carom_scene::*;
/// let ball = ImpactProblem::parse("ball.toml", r#"
///     body = { mass = 2, inertia = 0.4, velocity = [0, -3] }
///     contact = [{ point = [0, -1], normal = [0, 1], friction = 0.3, restitution = 0.5 }]
/// "#)?;
/// let ImpactAnswer::Examined(examined) = ball.solve() else { panic!("one contact") };
/// assert_eq!((examined.ends.found.len(), examined.shared.len()), (1, 0));
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Examined {
    /// The walk, or why there is none.
    pub walk: Result<Walk, ImpactError>,
    /// Every end state.
    pub ends: EndStates<MOST_CONTACTS>,
    /// What decided the class, at one contact that approaches.
    pub deciders: Option<Deciders>,
    /// What every convention on sharing says, where several contacts close together.
    pub shared: Vec<Shared>,
}

impl ImpactAnswer {
    /// The walk, where there is one.
    pub fn walk(&self) -> Option<&Walk> {
        match self {
            Self::Examined(examined) => examined.walk.as_ref().ok(),
            Self::Pivoted(_) => None,
        }
    }

    /// Whether this is the only answer, and if not, why not.
    pub fn certainty(&self) -> Certainty {
        match self {
            Self::Pivoted(found) => {
                Certainty { examined: false, ..Certainty::of_ends(usize::from(found.is_ok())) }
            }
            Self::Examined(examined) => {
                let certainty = Certainty::of_ends(examined.ends.found.len());
                match &examined.walk {
                    Err(_) => Certainty { resolved: false, ..certainty },
                    Ok(walk) => Certainty {
                        path_dependent: walk.path_dependent,
                        branches: walk.outcome.branches,
                        open_share: !walk.shares.is_empty(),
                        compared: walk.compared,
                        alone: walk.contacts == 1,
                        ..certainty
                    },
                }
            }
        }
    }

    /// Why the answer could not be computed: a budget of stages ran out, or numbers overflowed. That contacts are jammed, or hand the load
    /// round for ever, is an answer.
    pub fn undone(&self) -> Option<ImpactError> {
        let error = match self {
            Self::Examined(examined) => examined.walk.as_ref().err(),
            Self::Pivoted(found) => found.as_ref().err(),
        };
        error.copied().filter(|error| !matches!(error, ImpactError::Jammed | ImpactError::Circling { .. }))
    }

    /// The law that the answer to `problem` obeys: Poisson's where several contacts close or the end alone is sought by Stronge's, Stronge's
    /// where they share as springs.
    pub fn law(&self, problem: &ImpactProblem) -> Law {
        match self {
            Self::Examined(_) => self.walk().map_or(problem.law, |walk| walk.outcome.law),
            Self::Pivoted(_) if problem.law == Law::Newton => Law::Newton,
            Self::Pivoted(_) => Law::Poisson,
        }
    }
}

/// What a convention on sharing says.
///
/// # Example
/// Newton's cradle: every convention keeps the momentum, 1 kg m/s.
/// ```
/// use carom_scene::*;
/// let text = std::fs::read_to_string("../../examples/impact_cradle.toml")?;
/// let cradle = ImpactProblem::parse("cradle.toml", &text)?;
/// let ImpactAnswer::Examined(examined) = cradle.solve() else { panic!("two contacts") };
/// let group = cradle.group.unwrap();
/// for Shared { outcome, .. } in examined.shared {
///     let bodies = group.after(&outcome?.impulse)?;
///     let momentum = bodies.iter().map(|body| body.mass * body.velocity.x).sum::<f64>();
///     assert!((momentum - 1.0).abs() < 1e-9);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Shared {
    /// Which it is.
    pub convention: Convention,
    /// Its outcome, or why it has none.
    pub outcome: Result<StagedOutcome<MOST_CONTACTS>, ImpactError>,
    /// Whether it moves as the answer does.
    pub verdict: SharingVerdict,
}

impl ImpactProblem {
    /// Resolves the impact: up to [`MOST_CONTACTS`] contacts by the walk and by every end state, more by pivoting.
    ///
    /// # Example
    /// A ball of 2 kg that strikes with 3 m/s and e = 1/2 leaves with 1.5 m/s.
    /// ```
    /// use carom_scene::*;
    /// let ball = ImpactProblem::parse("ball.toml", r#"
    ///     body = { mass = 2, inertia = 0.4, velocity = [0, -3] }
    ///     contact = [{ point = [0, -1], normal = [0, 1], friction = 0.3, restitution = 0.5 }]
    /// "#)?;
    /// let answer = ball.solve();
    /// let (velocity, spin) = ball.body_after(&answer.walk().unwrap().outcome.impulse).unwrap();
    /// assert!((velocity.y - 1.5).abs() < 1e-14 && spin == 0.0);
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn solve(&self) -> ImpactAnswer {
        let mut answer = self.solve_as_asked();
        if let (ImpactAnswer::Examined(examined), ImpactContacts::Several(set)) =
            (&mut answer, &self.contacts)
            && let Ok(walk) = &examined.walk
        {
            examined.shared = self.conventions(set, &walk.outcome);
        }
        answer
    }

    /// As [`Self::solve`], without what the other conventions on sharing say: they take most of the time where several contacts close.
    ///
    /// # Example
    /// Newton's cradle by the convention of its file alone, with the same end.
    /// ```
    /// use carom_scene::*;
    /// let text = std::fs::read_to_string("../../examples/impact_cradle.toml")?;
    /// let cradle = ImpactProblem::parse("cradle.toml", &text)?;
    /// let ImpactAnswer::Examined(alone) = cradle.solve_as_asked() else { panic!("two contacts") };
    /// let ImpactAnswer::Examined(all) = cradle.solve() else { panic!("two contacts") };
    /// assert_eq!((alone.shared.len(), all.shared.len()), (0, 3));
    /// assert_eq!(alone.walk, all.walk);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn solve_as_asked(&self) -> ImpactAnswer {
        match &self.contacts {
            ImpactContacts::Several(set) => ImpactAnswer::Examined(Box::new(self.examine(set))),
            ImpactContacts::Many(set) => {
                ImpactAnswer::Pivoted(pivoting::one_end_state(&**set, self.law).map(Box::new))
            }
        }
    }

    /// The walk and every end state, by the law and the convention that are asked for.
    fn examine(&self, set: &ContactSet6) -> Examined {
        let mut stages = vec![];
        let walked = match self.sharing {
            Sharing::Together => staged::resolve_observed(set, self.law, &mut |stage| stages.push(*stage)),
            _ => sharing::resolve(set, self.law, &self.sharing),
        };
        let ends = end_states::enumerate(set, self.law);
        let one = (set.count == 1).then(|| set.alone(0));
        let walk = walked.map(|outcome| {
            let kind = one.and_then(|contact| single::resolve(&contact, self.law).ok()?.kind);
            let bounces = set.restitution[..set.count].iter().any(|e| *e > 0.0);
            // End states do not know work: by Stronge's law, and of springs, they are those of Poisson's.
            let compared = outcome.law != Law::Stronge || !bounces;
            let path_dependent = compared && !ends.reach(set, &outcome.velocity);
            let is_open = self.sharing == Sharing::Together && outcome.open_share.contains(&true);
            let shares = if is_open { share::outcomes(set, self.law).unwrap_or_default() } else { vec![] };
            Walk { outcome, stages, kind, path_dependent, contacts: set.count, compared, shares }
        });
        // What has no answer has no class, and nothing decided it.
        let decided = one.filter(|_| walk.is_ok());
        let deciders = decided.and_then(|contact| deciders(&contact, self.law));
        Examined { walk, ends, deciders, shared: vec![] }
    }

    /// What the conventions on sharing say, where more than one contact acts and one closes.
    fn conventions(&self, set: &ContactSet6, answer: &StagedOutcome<MOST_CONTACTS>) -> Vec<Shared> {
        let closing = set.normal[..set.count].iter().filter(|u| **u < 0.0).count();
        if set.count < 2 || closing == 0 {
            return vec![];
        }
        let conventions = [
            (Convention::Together, Sharing::Together),
            (Convention::InSequence, Sharing::InSequence),
            (Convention::ByStiffness, self.by_stiffness),
        ];
        let say = |(convention, sharing)| {
            let outcome = sharing::resolve(set, self.law, &sharing);
            let verdict = match &outcome {
                Ok(out) if sharing::alike(set, out, answer) => SharingVerdict::Agrees,
                Ok(_) => SharingVerdict::Differs,
                Err(error) => SharingVerdict::of_error(error),
            };
            Shared { convention, outcome, verdict }
        };
        conventions.into_iter().map(say).collect()
    }

    /// Velocity [m/s] and spin [rad/s] of the body after these impulses (tangential, normal).
    pub fn body_after(&self, impulse: &[[f64; 2]]) -> Option<(Vec2, f64)> {
        let body = self.body.as_ref()?;
        let (mut velocity, mut spin) = (body.velocity, body.spin);
        for (touch, [tangential, normal]) in body.touches.iter().zip(impulse) {
            let on_body = touch.normal.turned_right() * *tangential + touch.normal * *normal;
            velocity += on_body / body.mass;
            spin += touch.arm.cross(on_body) / body.inertia;
        }
        Some((velocity, spin))
    }

    /// Kinetic energy of the body at a velocity and spin [J].
    pub fn energy(&self, velocity: Vec2, spin: f64) -> Option<f64> {
        let body = self.body.as_ref()?;
        Some(0.5 * body.mass * velocity.dot(velocity) + 0.5 * body.inertia * spin * spin)
    }
}

fn deciders(contact: &single::Contact, law: Law) -> Option<Deciders> {
    let single::Contact { w_tt, w_tn, w_nn, slip, normal, friction, restitution } = *contact;
    if normal >= 0.0 {
        return None;
    }
    let sticking_friction = w_tn / w_tt;
    let s = if slip > 0.0 { 1.0 } else { -1.0 };
    let (demand, supply) = if slip == 0.0 {
        (0.0, 0.0)
    } else {
        (s * slip * (w_nn - s * friction * w_tn), -normal * (friction * w_tt - s * w_tn))
    };
    let holds = friction >= sticking_friction.abs();
    let held = if holds { "and μ ≥ |μ_s|: it sticks" } else { "and μ < |μ_s|: it reverses" };
    let because = if slip == 0.0 {
        let word = if holds { "μ ≥ |μ_s|: it sticks" } else { "μ < |μ_s|: it slips" };
        format!("no initial slip; {word}")
    } else if demand <= supply {
        format!("P_d ≤ P_q: the slip stops in compression, {held}")
    } else if law != Law::Poisson && restitution > 0.0 {
        format!(
            "P_d > P_q: the slip lasts through compression; {}'s measure of restitution decides the rest",
            law.word()
        )
    } else if demand < (1.0 + restitution) * supply {
        format!("P_q < P_d < (1 + e) P_q: the slip stops in restitution, {held}")
    } else {
        "P_d ≥ (1 + e) P_q: it slides throughout".to_owned()
    };
    Some(Deciders { slip_demand: demand, friction_supply: supply, sticking_friction, because })
}
