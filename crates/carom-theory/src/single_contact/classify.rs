//! The two legs of an impact, and the inequalities that choose its type.

use super::contact::{Contact, ImpactType};
use crate::products::{difference_of_products, product_plus};

/// An inequality that separates two types.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Inequality {
    /// P_d against (1+e) P_q: does the slip outlast the impact?
    SlipOutlastsImpact,
    /// P_d against P_q: does the slip outlast compression?
    SlipOutlastsCompression,
    /// μ against |μ_s|: does the friction cone hold the contact once its slip is zero?
    ConeHolds,
    /// B₂ + sμB₃ against 0, of a contact that grazes (C₀ = 0): does pressing the slipping contact drive it in (Painlevé)?
    PressingCloses,
    /// C₀ against 0: does the contact close at all?
    Closes,
}

/// The numbers that classify an impact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Numbers {
    /// The type they lead to, or `None` when no impulse is transmitted.
    pub kind: Option<ImpactType>,
    /// P_d = (B₂ + sμB₃)|S₀| (Wang and Mason 1992).
    pub p_d: f64,
    /// P_q = (μB₁ + sB₃)|C₀| (Wang and Mason 1992).
    pub p_q: f64,
    /// μ_s = −B₃/B₁ = W_tn/W_tt: friction of at least |μ_s| holds the contact once its slip is zero.
    pub mu_s: f64,
    /// B₂ + sμB₃ = W_nn − sμW_tn, the normal velocity per normal impulse while it slips [1/kg]. Not positive: Painlevé's case.
    pub normal_response: f64,
    /// μB₁ + sB₃ = μW_tt − sW_tn, the slip speed lost per normal impulse while it slips [1/kg].
    pub slip_response: f64,
    /// Of the inequalities that chose the type, the one that was closest to choosing otherwise.
    pub decided_by: Inequality,
    /// The distance of that inequality to its boundary, divided by the sum of its terms' magnitudes: in 0…1.
    pub margin: f64,
    /// How much a relative error of the data is magnified in the impulses: the sum, over the denominators used, of the magnitudes
    /// of their terms over their value. At least 1.
    pub condition: f64,
}

/// The two legs of the impact in the notation of the module.
#[derive(Clone, Copy, Debug)]
pub(super) struct Legs {
    pub(super) contact: Contact,
    /// sign S₀, 0 without slip.
    pub(super) s: f64,
    /// |S₀|.
    pub(super) slip: f64,
    /// |C₀|.
    pub(super) closing: f64,
    /// B₁.
    pub(super) b1: f64,
    /// B₂.
    pub(super) b2: f64,
    /// B₃.
    pub(super) b3: f64,
    /// μB₁ + sB₃.
    pub(super) k: f64,
    /// a₁ = B₂ + sμB₃.
    pub(super) a1: f64,
    /// B₁B₂ − B₃².
    pub(super) det: f64,
}

impl Legs {
    pub(super) fn of(contact: &Contact) -> Self {
        let (b1, b2, b3) = (contact.w.tt, contact.w.nn, -contact.w.tn);
        let mu = contact.friction;
        let s = if contact.slip == 0.0 { 0.0 } else { contact.slip.signum() };
        Self {
            contact: *contact,
            s,
            slip: contact.slip.abs(),
            closing: contact.approach.abs(),
            b1,
            b2,
            b3,
            k: product_plus(mu, b1, s * b3),
            a1: product_plus(s * mu, b3, b2),
            det: contact.w.determinant(),
        }
    }

    /// μB₁ − |B₃|: not negative if the cone holds a contact without slip.
    pub(super) fn cone(&self) -> f64 {
        product_plus(self.contact.friction, self.b1, -self.b3.abs())
    }

    /// a₂ of the slipping second leg: B₂ − μ|B₃|.
    pub(super) fn a2_slipping(&self) -> f64 {
        product_plus(-self.contact.friction, self.b3.abs(), self.b2)
    }

    /// a₂ of the leg on which the impact of this type ends.
    pub(super) fn last_response(&self, kind: ImpactType) -> f64 {
        match kind {
            ImpactType::SlidesThroughout => self.a1,
            kind if kind.sticks() => self.det / self.b1,
            _ => self.a2_slipping(),
        }
    }

    /// p_s = |S₀|/k, where the slip stops.
    pub(super) fn slip_stop(&self) -> f64 {
        self.slip / self.k
    }

    /// C_s = C₀ + a₁p_s = (P_d − P_q)/k, the normal velocity where the slip stops.
    pub(super) fn normal_velocity_at_stop(&self) -> f64 {
        difference_of_products(self.a1, self.slip, self.k, self.closing) / self.k
    }

    pub(super) fn numbers(&self) -> Numbers {
        let kind = self.kind();
        let (margin, decided_by) = self.margin(kind);
        Numbers {
            kind,
            p_d: self.a1 * self.slip,
            p_q: self.k * self.closing,
            mu_s: -self.b3 / self.b1,
            normal_response: self.a1,
            slip_response: self.k,
            decided_by,
            margin,
            condition: kind.map_or(1.0, |kind| self.condition(kind)),
        }
    }

    /// `P_d − factor·P_q`; the sign is right unless the two agree to rounding.
    pub(super) fn slip_excess(&self, factor: f64) -> f64 {
        difference_of_products(self.a1, self.slip, self.k, factor * self.closing)
    }

    fn kind(&self) -> Option<ImpactType> {
        let c = &self.contact;
        if c.approach > 0.0 || (c.approach == 0.0 && (self.slip == 0.0 || self.a1 >= 0.0)) {
            return None;
        }
        let holds = self.cone() >= 0.0;
        let choose = |sticks, slips| Some(if holds { sticks } else { slips });
        if self.slip == 0.0 {
            choose(ImpactType::SticksFromRest, ImpactType::SlipsFromRest)
        } else if self.slip_excess(1.0 + c.restitution) >= 0.0 {
            Some(ImpactType::SlidesThroughout)
        } else if self.slip_excess(1.0) >= 0.0 {
            choose(ImpactType::StopsInRestitution, ImpactType::ReversesInRestitution)
        } else {
            choose(ImpactType::StopsInCompression, ImpactType::ReversesInCompression)
        }
    }

    fn margin(&self, kind: Option<ImpactType>) -> (f64, Inequality) {
        use ImpactType as T;
        let cone = (self.cone_margin(), Inequality::ConeHolds);
        let whole = (self.slip_margin(1.0 + self.contact.restitution), Inequality::SlipOutlastsImpact);
        let compression = (self.slip_margin(1.0), Inequality::SlipOutlastsCompression);
        let nearer = |a: (f64, Inequality), b: (f64, Inequality)| if b.0 < a.0 { b } else { a };
        match kind {
            Some(T::SlidesThroughout) => whole,
            Some(T::SlipsFromRest | T::SticksFromRest) => cone,
            Some(T::ReversesInRestitution | T::StopsInRestitution) => {
                nearer(whole, nearer(compression, cone))
            }
            Some(T::ReversesInCompression | T::StopsInCompression) => nearer(compression, cone),
            None if self.contact.approach == 0.0 && self.slip > 0.0 => {
                (self.a1.abs() / self.normal_terms(), Inequality::PressingCloses)
            }
            None => (if self.contact.approach > 0.0 { 1.0 } else { 0.0 }, Inequality::Closes),
        }
    }

    fn cone_margin(&self) -> f64 {
        let terms = self.slip_terms();
        // μ = 0 and B₃ = 0: nothing pushes the contact sideways, and sticking and slipping from rest are one motion.
        if terms > 0.0 { self.cone().abs() / terms } else { 0.0 }
    }

    fn slip_margin(&self, factor: f64) -> f64 {
        let terms = self.normal_terms() * self.slip + self.slip_terms() * factor * self.closing;
        self.slip_excess(factor).abs() / terms
    }

    /// B₂ + μ|B₃|.
    fn normal_terms(&self) -> f64 {
        self.b2 + self.contact.friction * self.b3.abs()
    }

    /// μB₁ + |B₃|.
    fn slip_terms(&self) -> f64 {
        self.contact.friction * self.b1 + self.b3.abs()
    }

    fn condition(&self, kind: ImpactType) -> f64 {
        use ImpactType as T;
        let first = self.normal_terms() / self.a1.abs();
        let stop = self.slip_terms() / self.k;
        let last = if kind.sticks() {
            (self.b1 * self.b2 + self.b3 * self.b3) / self.det
        } else {
            self.normal_terms() / self.a2_slipping()
        };
        match kind {
            T::SlidesThroughout => first,
            T::SlipsFromRest | T::SticksFromRest => last,
            T::ReversesInRestitution | T::StopsInRestitution => first + stop + last,
            T::ReversesInCompression | T::StopsInCompression => stop + last,
        }
    }
}
