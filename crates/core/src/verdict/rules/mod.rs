//! Decision rules: which measured values are accepted, and which are rejected, when the measurement itself is uncertain.
//!
//! | file | what |
//! |---|---|
//! | here | a rule with what it was given; the zones that follow, and a value's status in them |
//! | `names` | the list of rules; each is one file beside it, with its declaration |
//! | `uncertainty` | the standard uncertainty of a measured value and its coverage factor |
//! | `conformity` | the probability that the true value lies within the limits |
//! | `risk` | how often a process and a rule together accept what is bad or reject what is good |
//!
//! Limits of zones are whole nanometres and belong to the zone that they limit, as limits of size do. Where a guard band is no
//! whole number of nanometres, the next larger one is taken: nothing counts as proven that is not.
//!
//! To add a rule:
//!
//! 1. Write a file with its declaration; `Use` says what its bands are for, and with that whether the rule proves anything. Add its `mod`
//!    line here and its line in `names.rs`.
//! 2. Add its sentence `rule-WORD` to `tolerance.ftl` and its name `rule-name-WORD` to `check-rule.ftl`, in every folder of
//!    `assets/locales`.
//! 3. Add a row of borders for each prover in `tests/core/rules.rs`.
//! 4. Add a call of `check` and a call of `decide` to the corpus and record the answers (`tests/core/corpus.rs`).
//! 5. Describe it in `docs/manual/rules.md`, `CHANGELOG.md` and `docs/SOURCES.md` ("Decision rules").
//!
//! `--rule` of every subcommand, the list of the check page, records and reports follow.

mod asme_relaxed;
mod asme_simple;
mod asme_stringent;
mod conformity;
mod fixed;
mod ilac_g8;
mod iso14253_1998;
mod iso14253_2017;
mod names;
mod risk;
mod simple;
mod uncertainty;

pub use conformity::{Conformity, percent};
pub use names::RuleName;
pub use risk::{Acceptance, Prior, Risks, acceptance_for};
pub use uncertainty::{Uncertainty, UncertaintyError, multiple};

use serde::{Deserialize, Serialize};

use super::{Status, classify};
use crate::length::{Length, without_zeros};
use crate::message::{Message, Say};
use crate::tolerance::{Bounds, Feature};

/// Who carries the uncertainty: whoever has to prove something (ISO 14253-1).
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Prover {
    /// The supplier proves conformity: what is not proven is not accepted.
    #[default]
    Supplier,
    /// The customer proves nonconformity: what is not proven to be out is accepted.
    Customer,
}

/// What a rule is given besides limits and a measured value.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub struct RuleInputs {
    /// The uncertainty of the measured value.
    pub uncertainty: Option<Uncertainty>,
    /// By what the expanded uncertainty is multiplied, in thousandths.
    pub factor: Option<u32>,
    /// A guard band of this width.
    pub width: Option<Length>,
    /// Who has to prove.
    pub prover: Prover,
}

/// The decision rule that a verdict was made with.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub struct Rule {
    name: RuleName,
    given: RuleInputs,
}

/// Why there is no such rule.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "rule", error)]
pub enum RuleError {
    /// The rule's guard band is a multiple of the uncertainty, and there is none.
    NoUncertainty {
        /// The rule.
        rule: &'static str,
    },
    /// The rule has no factor.
    NoFactor {
        /// The rule.
        rule: &'static str,
    },
    /// The rule computes its guard band itself.
    NoWidth {
        /// The rule.
        rule: &'static str,
    },
    /// The rule is a guard band of a given width, and none was given, or none above zero.
    WidthMissing {
        /// The rule.
        rule: &'static str,
    },
    /// The rule does not depend on who has to prove.
    NoProver {
        /// The rule.
        rule: &'static str,
    },
}

/// How far a value must be from a limit so that something is proven.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Bands {
    /// Within the zone, for conformity; `None` where no value proves it.
    conforming: Option<Length>,
    /// Beyond it, for nonconformity.
    nonconforming: Length,
}

/// What a rule does with its bands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Use {
    /// Nothing: the limits themselves decide.
    Limits,
    /// Nothing, as long as the uncertainty is small against the tolerance; otherwise nothing is decided.
    LimitsWithRatio,
    /// Whoever has to prove keeps the distance.
    Proof,
    /// The zone of accepted values is smaller, and what lies beyond a limit is rejected.
    Stringent,
    /// The zone of accepted values is larger.
    Relaxed,
}

/// What a rule declares about itself.
struct Declaration {
    name: &'static str,
    /// The id of its sentence.
    text: &'static str,
    how: Use,
    takes_factor: bool,
    takes_width: bool,
    /// `None` where the rule has no bands.
    bands: Option<fn(&RuleInputs, &Bounds) -> Bands>,
}

impl Declaration {
    fn needs_uncertainty(&self) -> bool {
        !self.takes_width && (self.bands.is_some() || self.how == Use::LimitsWithRatio)
    }
}

/// Which values a rule accepts and which it rejects.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Zones {
    /// The smallest and the largest accepted value; `None` where no value is.
    pub accepted: Option<[Length; 2]>,
    /// Smaller than the first or larger than the second is rejected. Between accepted and rejected nothing is decided.
    pub rejected: [Length; 2],
    /// Whether a value on or between these is proven to conform; `None` where no value is, or the rule proves nothing.
    pub proven_in: Option<[Length; 2]>,
    /// Whether a value beyond these is proven not to conform; `None` where the rule proves nothing.
    pub proven_out: Option<[Length; 2]>,
}

impl Rule {
    /// The control's own rule: no guard band, limits belong to the zone.
    pub const SIMPLE: Self = Self {
        name: RuleName::Simple,
        given: RuleInputs { uncertainty: None, factor: None, width: None, prover: Prover::Supplier },
    };

    /// A rule with what it needs.
    ///
    /// # Errors
    /// [`RuleError`] where something is missing, or given without effect.
    pub fn new(name: RuleName, given: RuleInputs) -> Result<Self, RuleError> {
        let Declaration { name: rule, how, takes_factor, takes_width, .. } = *name.declaration();
        match given {
            RuleInputs { uncertainty: None, .. } if name.declaration().needs_uncertainty() => {
                Err(RuleError::NoUncertainty { rule })
            }
            RuleInputs { factor: Some(_), .. } if !takes_factor => Err(RuleError::NoFactor { rule }),
            RuleInputs { width: Some(_), .. } if !takes_width => Err(RuleError::NoWidth { rule }),
            RuleInputs { prover: Prover::Customer, .. } if how != Use::Proof => Err(RuleError::NoProver { rule }),
            RuleInputs { width, .. } if takes_width && width.is_none_or(|width| width <= Length::ZERO) => {
                Err(RuleError::WidthMissing { rule })
            }
            _ => Ok(Self { name, given }),
        }
    }

    /// Which rule it is.
    pub const fn name(&self) -> RuleName {
        self.name
    }

    /// What it was given.
    pub const fn given(&self) -> &RuleInputs {
        &self.given
    }

    /// The uncertainty that it was given.
    pub const fn uncertainty(&self) -> Option<Uncertainty> {
        self.given.uncertainty
    }

    /// Whether it is the control's own, and nothing is known of the uncertainty.
    pub fn is_plain(&self) -> bool {
        *self == Self::SIMPLE
    }

    /// The zones for limits.
    pub fn zones(&self, bounds: &Bounds) -> Zones {
        let declaration = self.name.declaration();
        let limits = [bounds.minimum(), bounds.maximum()];
        let everything = [Length::MAX.negated(), Length::MAX];
        let plain = Zones { accepted: Some(limits), rejected: limits, proven_in: None, proven_out: None };
        let Some(bands) = declaration.bands.map(|bands| bands(&self.given, bounds)) else {
            let is_decided = declaration.how != Use::LimitsWithRatio || asme_simple::is_met(&self.given, bounds);
            return if is_decided { plain } else { Zones { accepted: None, rejected: everything, ..plain } };
        };
        let within = bands.conforming.and_then(|band| moved(limits, band));
        let beyond = moved(limits, bands.nonconforming.negated()).unwrap_or(everything);
        let accepted = match (declaration.how, self.given.prover) {
            (Use::Limits | Use::LimitsWithRatio, _) => Some(limits),
            (Use::Relaxed, _) | (Use::Proof, Prover::Customer) => Some(beyond),
            (Use::Proof | Use::Stringent, _) => within,
        };
        let rejected = if declaration.how == Use::Stringent { limits } else { beyond };
        Zones { accepted, rejected, proven_in: within, proven_out: Some(beyond) }
    }

    /// The status of a measured value.
    pub fn status(&self, bounds: &Bounds, measured: Length) -> Status {
        self.zones(bounds).status(bounds.feature, measured)
    }

    /// The probability that the true value conforms; `None` where the uncertainty is not known.
    pub fn conformity(&self, bounds: &Bounds, measured: Length) -> Option<Conformity> {
        Some(Conformity::of(bounds, measured, self.given.uncertainty?))
    }
}

/// Limits moved inwards; `None` where nothing is left between them.
fn moved([minimum, maximum]: [Length; 2], inwards: Length) -> Option<[Length; 2]> {
    let least = minimum.saturating_sub(inwards.negated());
    let most = maximum.saturating_sub(inwards);
    (least <= most).then_some([least, most])
}

impl Zones {
    /// The status of a measured value: good where it is accepted, rework or scrap (out of limits where it is neither hole nor shaft) where
    /// it is rejected, re-measure between.
    pub fn status(&self, feature: Option<Feature>, measured: Length) -> Status {
        let [least, most] = self.rejected;
        match classify(feature, least, most, measured) {
            _ if self.accepted.is_some_and(|[least, most]| least <= measured && measured <= most) => Status::Good,
            Status::Good => Status::ReMeasure,
            rejected => rejected,
        }
    }

    /// Whether the rule proves what it says of a value; `None` where it proves nothing.
    pub fn is_proven(&self, measured: Length) -> Option<bool> {
        let [below, above] = self.proven_out?;
        let is_in = self.proven_in.is_some_and(|[least, most]| least <= measured && measured <= most);
        Some(is_in || measured < below || above < measured)
    }
}

impl Say for Rule {
    fn message(&self) -> Message {
        let sentence = Message::new(self.name.declaration().text);
        self.told(match self.given.uncertainty {
            Some(uncertainty) => sentence.message("u", uncertainty.message()),
            None => sentence.text("u", ""),
        })
    }
}

impl Rule {
    /// Its sentence with something else in the place of its uncertainty.
    pub fn message_with(&self, uncertainty: Message) -> Message {
        self.told(Message::new(self.name.declaration().text).message("u", uncertainty))
    }

    /// Its sentence with its uncertainty as a person reads it.
    pub fn rounded_message(&self) -> Message {
        self.given.uncertainty.map_or_else(|| self.message(), |given| self.message_with(given.rounded_message()))
    }

    /// The rest of what the sentence needs.
    fn told(&self, mut message: Message) -> Message {
        message = message.number("factor", thousandths(self.given.factor.unwrap_or(1000)));
        // The sentence of a rule without a width does not name it.
        let width = self.given.width.unwrap_or(Length::ZERO);
        message = message.number("width", width.exact(crate::length::Unit::Micrometre, 0));
        message.text("prover", if self.given.prover == Prover::Customer { "customer" } else { "supplier" })
    }
}

impl std::fmt::Display for Rule {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}", self.message())
    }
}

/// A number of thousandths as a decimal, without zeros at its end.
pub fn thousandths(number: u32) -> String {
    without_zeros(&format!("{}.{:03}", number / 1000, number % 1000)).to_owned()
}
