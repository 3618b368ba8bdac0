//! What the fields mean: callout and limits, and an error beside each field that caused one.

use std::collections::BTreeMap;
use std::ops;

use fitcheck_core::length::Length;
use fitcheck_core::message::{Message, Say as _};
use fitcheck_core::probing::cycle::{Angle, Axis, Meaning, Value};
use fitcheck_core::probing::cycles::measuring;
use fitcheck_core::tolerance::callout::halves;
use fitcheck_core::tolerance::{Callout, Feature, Limits, LimitsError, Sources, Tolerance};

use super::doubted::{DoubtedText, Meant};
use super::worth::RuleFields;
use super::{CheckField, RuleChoice};
use crate::texts::{Range, Texts, whole};

/// The meaning of the fields. Made anew at every change.
#[derive(Debug, Clone, Default)]
pub struct CheckInputs {
    /// The callout, when it can be read (its limits may still be refused).
    pub callout: Option<Callout>,
    /// Where in the callout's text an error shows, in characters.
    pub culprit: Option<ops::Range<usize>>,
    /// The limits on screen.
    pub limits: Option<Limits>,
    lengths: BTreeMap<CheckField, Length>,
    /// The angle of the first contact.
    pub(super) first_angle: Option<Angle>,
    /// The seed of the simulation.
    pub(super) seed: Option<u64>,
    /// The number of lobes of the simulated workpiece.
    pub(super) lobes: Option<u32>,
    /// What a measured value is worth: rule, uncertainty, temperature.
    pub worth: RuleFields,
    /// What is asked about first.
    pub doubted: Option<DoubtedText>,
    errors: BTreeMap<CheckField, Message>,
}

/// The fields that are parameters of the measuring cycle: the cycle's declaration says what they may be.
const PARAMETERS: [(CheckField, Meaning); 6] = [
    (CheckField::CentreX, Meaning::Centre(Axis::First)),
    (CheckField::CentreY, Meaning::Centre(Axis::Second)),
    (CheckField::Height, Meaning::MeasuringHeight),
    (CheckField::FirstAngle, Meaning::FirstAngle),
    (CheckField::Clearance, Meaning::SetUpClearance),
    (CheckField::CentreTolerance, Meaning::CentreTolerance(Axis::First)),
];

/// The other fields that hold a length, with what they may be.
const LENGTHS: [(CheckField, Range); 8] = [
    (CheckField::Measured, Range::AboveZero),
    (CheckField::TrueDiameter, Range::AboveZero),
    (CheckField::OffsetX, Range::Any),
    (CheckField::OffsetY, Range::Any),
    (CheckField::Ovality, Range::ZeroOrMore),
    (CheckField::LobeHeight, Range::ZeroOrMore),
    (CheckField::SurfaceScatter, Range::ZeroOrMore),
    (CheckField::ProbeScatter, Range::ZeroOrMore),
];

/// The size part of a callout as it is typed.
pub(crate) fn nominal_text(callout: &str) -> &str {
    halves(callout).0
}

/// The tolerance part of a callout as it is typed.
pub(crate) fn class_text(callout: &str) -> &str {
    halves(callout).1
}

impl CheckInputs {
    /// Reads the fields. Empty optional fields are not an error; a number that cannot be used is one.
    pub(super) fn read(
        texts: &Texts<CheckField>,
        feature: Option<Feature>,
        judging: RuleChoice,
        sources: &Sources,
        meant: &Meant,
    ) -> Self {
        let mut asked = Self::default();
        asked.read_callout(texts.text(CheckField::Callout), feature, sources, meant);
        asked.worth = RuleFields::read(texts, judging, &mut |field, problem| _ = asked.errors.insert(field, problem));
        asked.worth.look_at(asked.limits.as_ref());
        if let Some(doubted) = DoubtedText::temperature(texts, meant) {
            asked.errors.insert(doubted.field, doubted.why.clone());
            asked.worth.doubt_temperature(doubted.field, doubted.why.clone());
            asked.doubted.get_or_insert(doubted);
        }
        for (field, meaning) in PARAMETERS {
            asked.read_parameter(field, meaning, texts.text(field));
        }
        for (field, range) in LENGTHS {
            asked.read_length(field, range, texts.text(field));
        }
        asked.seed = asked.read_whole(CheckField::Seed, texts.text(CheckField::Seed));
        asked.lobes = asked.read_whole(CheckField::Lobes, texts.text(CheckField::Lobes));
        asked
    }

    /// `feature` counts where the callout does not say hole or shaft itself.
    fn read_callout(&mut self, text: &str, feature: Option<Feature>, sources: &Sources, meant: &Meant) {
        if text.trim().is_empty() {
            return;
        }
        let problem = match text.parse::<Callout>() {
            Ok(callout) => {
                self.callout = Some(callout);
                let sources = sources.clone().with_wide_zones(meant.has(CheckField::Callout, &callout.to_string()));
                match sources.limits(&callout, callout.feature().or(feature)) {
                    Ok(limits) => return self.limits = Some(limits),
                    Err(error) => {
                        if let LimitsError::Zone(doubt) = &error {
                            self.doubted = Some(DoubtedText::zone(&callout, doubt));
                        }
                        error.message()
                    }
                }
            }
            Err(error) => {
                self.culprit = error.span();
                self.doubted = DoubtedText::callout(text, &error);
                error.message()
            }
        };
        self.errors.insert(CheckField::Callout, problem);
    }

    /// The cycles for a hole and for a shaft have the same ranges except for their limits.
    fn read_parameter(&mut self, field: CheckField, meaning: Meaning, text: &str) {
        let Some(parameter) = measuring(Feature::Hole).meant(meaning) else { return };
        match parameter.accept(text) {
            Ok(Value::Length(length)) => _ = self.lengths.insert(field, length),
            Ok(Value::Angle(angle)) => self.first_angle = Some(angle),
            Ok(_) => {}
            Err(error) => _ = self.errors.insert(field, error.message()),
        }
    }

    fn read_length(&mut self, field: CheckField, range: Range, text: &str) {
        let optional = matches!(field, CheckField::Measured | CheckField::TrueDiameter);
        if optional && text.trim().is_empty() {
            return;
        }
        match range.read(text) {
            Ok(value) => _ = self.lengths.insert(field, value),
            Err(problem) => _ = self.errors.insert(field, problem),
        }
    }

    fn read_whole<T: std::str::FromStr>(&mut self, field: CheckField, text: &str) -> Option<T> {
        whole(text).map_err(|error| self.errors.insert(field, error)).ok()
    }

    /// Whether the callout is a fit: one of its parts has to be chosen.
    pub fn is_fit(&self) -> bool {
        self.callout.is_some_and(|callout| matches!(callout.tolerance(), Tolerance::Fit { .. }))
    }

    /// Whether the callout does not say hole or shaft, so that it can be chosen; of a fit it has to be.
    pub fn needs_feature(&self) -> bool {
        self.callout.is_some_and(|callout| callout.feature().is_none())
    }

    /// The length in a field, mm, when it can be read.
    pub fn length(&self, field: CheckField) -> Option<Length> {
        self.lengths.get(&field).copied()
    }

    /// What is wrong with a field.
    pub fn error(&self, field: CheckField) -> Option<&Message> {
        self.errors.get(&field)
    }

    /// Puts an error beside a field that measuring refused.
    pub(super) fn refuse(&mut self, field: CheckField, problem: Message) {
        self.errors.insert(field, problem);
    }

    /// Shows the limits of a record, which may have come without a callout, and not what the chosen source says of it.
    /// A fit stays a fit: its other part can still be chosen.
    pub(super) fn show_limits(&mut self, limits: Limits, callout: Option<Callout>) {
        if self.callout.map(|asked| asked.of_part(limits.feature)) != callout {
            self.callout = callout;
        }
        self.worth.look_at(Some(&limits));
        self.limits = Some(limits);
        self.culprit = None;
        self.errors.remove(&CheckField::Callout);
        self.doubted = self.doubted.take().filter(|doubted| doubted.field != CheckField::Callout);
    }
}
