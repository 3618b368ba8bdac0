//! A characteristic as files of other tools declare it, and its values judged by the limits that it has.
//!
//! Formats of measuring machines and of statistics (AQDEF, QIF, tables of CALYPSO) say the same in different words: a number, a name, a
//! nominal size, limits, perhaps a tolerance class. What they leave open stays open: without a class a diameter may be a hole or a shaft,
//! and beyond its limits it could be rework or scrap.

use std::collections::HashMap;
use std::sync::Arc;

use fitcheck_core::length::Length;
use fitcheck_core::message::FilePlace;
use fitcheck_core::probing::{Measurement, Origin};
use fitcheck_core::tolerance::{Callout, Feature, Limits, LimitsError};
use fitcheck_core::verdict::judge_size;
use jiff::civil::DateTime;

use super::claim::ClaimAnswer;
use super::error::{ImportErrorKind, ImportWarningKind};
use super::head::Head;
use super::imported::{Labels, Sink, StatedLimits, Unjudged, WhyUnjudged};
use super::limits::{Given, NoLimits};
use super::source::Context;
use crate::journal::Record;

/// What is measured.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum CharacteristicKind {
    /// A diameter or a width: a feature of size.
    Size,
    /// Another length, a form, a place, a radius: it is judged by the limits of the file, and without them this is why it is not.
    Length(WhyUnjudged),
    /// A quantity of AQDEF other than a diameter, by its number.
    Quantity(u32),
    /// Anything else, as the file calls it.
    Other(String),
}

/// A characteristic as a file declares it. Lengths are sizes, not deviations.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Characteristic {
    /// Its name; empty where it has a number alone.
    pub(super) name: String,
    pub(super) what: CharacteristicKind,
    /// The tolerance class as it is written, such as `H7`; empty where it has none.
    pub(super) class: String,
    /// Whether it is a hole or a shaft, where the file says so in another way than by a class.
    pub(super) feature: Option<Feature>,
    pub(super) nominal: Option<Length>,
    pub(super) minimum: Option<Length>,
    pub(super) maximum: Option<Length>,
    /// The expanded uncertainty that it is measured with.
    pub(super) expanded: Option<Length>,
    /// Its number, the part, and where it should lie; serial number and operator come with a value.
    pub(super) labels: Labels,
}

#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Value {
    /// Its line in the file, from 1.
    pub(super) line: usize,
    pub(super) measured: Length,
    /// When it was measured, where the file says so.
    pub(super) time: Option<DateTime>,
    /// Those of the characteristic, with the part's serial number and the operator.
    pub(super) labels: Labels,
    pub(super) is_simulated: bool,
}

impl Characteristic {
    /// What its values are called: its name, else its number.
    pub(super) fn id(&self) -> String {
        if self.name.is_empty() { self.labels.number.clone() } else { self.name.clone() }
    }

    /// The callout of nominal size and class; none where the file has no class, or one that is none.
    pub(super) fn callout(&self) -> Option<Callout> {
        let nominal = self.nominal.filter(|_| !self.class.is_empty())?;
        format!("{nominal} {}", self.class).parse().ok()
    }

    /// Whether it is a hole or a shaft.
    pub(super) fn feature(&self) -> Option<Feature> {
        self.callout().and_then(|callout| callout.feature()).or(self.feature)
    }

    /// What the file says that its values should be.
    pub(super) const fn said(&self) -> StatedLimits {
        StatedLimits { nominal: self.nominal, minimum: self.minimum, maximum: self.maximum }
    }

    /// Judges a value by the limits that the file has; where it has a class alone, by those of the class.
    pub(super) fn judge(&self, value: Value, context: &Context<'_>, sink: &mut Sink<'_>) {
        let line = value.line;
        let file = Arc::clone(&context.file);
        let origin = if value.is_simulated { Origin::ImportedSimulation { file } } else { Origin::Imported { file } };
        match self.asked(line, context, sink) {
            Ok(_) if self.what == CharacteristicKind::Size && value.measured <= Length::ZERO => {
                let given = value.measured.to_string();
                sink.refuse(FilePlace::line(line), ImportErrorKind::NotPositive { given: given.clone() }, given);
            }
            Ok((callout, limits)) => {
                let status = judge_size(&limits, value.measured).status;
                if let Some(why) = value.labels.too_coarse(&limits, value.measured, status) {
                    return self.set_aside(value, origin, why, context, sink);
                }
                let measurement = Measurement::of_diameter(value.measured, origin);
                let time = value.time.unwrap_or(context.now);
                let record = Record::judged(time, self.id(), callout, limits, measurement, None);
                self.tell_uncertainty(line, sink);
                let answer = ClaimAnswer::of(&record);
                for claim in &value.labels.claims {
                    if let Some(warning) = claim.tells(&answer) {
                        sink.warn(FilePlace::line(line), Some(line), warning);
                    }
                }
                sink.keep(line, record, value.labels);
            }
            Err(NoLimits::Unjudged(why)) => self.set_aside(value, origin, why, context, sink),
            Err(NoLimits::Refused(error)) => {
                sink.refuse(FilePlace::line(line), ImportErrorKind::Limits(*error), value.measured.to_string());
            }
        }
    }

    fn set_aside(&self, value: Value, origin: Origin, why: WhyUnjudged, context: &Context<'_>, sink: &mut Sink<'_>) {
        sink.set_aside(Unjudged {
            line: value.line,
            id: self.id(),
            labels: value.labels,
            time: value.time.unwrap_or(context.now),
            measured: Some(value.measured),
            origin,
            position: None,
            asked: self.said(),
            correction: None,
            why,
        });
    }

    fn tell_uncertainty(&self, line: usize, sink: &mut Sink<'_>) {
        if let Some(expanded) = self.expanded {
            sink.warn(FilePlace::line(line), Some(line), ImportWarningKind::UncertaintyNotUsed { expanded });
        }
    }

    /// What its values are judged by.
    fn asked(
        &self,
        line: usize,
        context: &Context<'_>,
        sink: &mut Sink<'_>,
    ) -> Result<(Option<Callout>, Limits), NoLimits> {
        match &self.what {
            CharacteristicKind::Size => {}
            CharacteristicKind::Length(otherwise) => {
                return match self.said().limits(given(context, None, false)) {
                    Ok(limits) => Ok((None, limits)),
                    Err(NoLimits::Unjudged(WhyUnjudged::NoCallout)) => Err(NoLimits::Unjudged(otherwise.clone())),
                    Err(why) => Err(why),
                };
            }
            CharacteristicKind::Quantity(quantity) => {
                return Err(NoLimits::Unjudged(WhyUnjudged::Quantity { quantity: *quantity }));
            }
            CharacteristicKind::Other(what) => {
                return Err(NoLimits::Unjudged(WhyUnjudged::NotASize { what: what.clone() }));
            }
        }
        let mut warn = |kind| sink.warn(FilePlace::line(line), Some(line), kind);
        let callout = self.callout();
        let of_class = callout.map(|callout| context.sources.limits(&callout, self.feature));
        let (minimum, maximum) = match (self.minimum, self.maximum) {
            (Some(minimum), Some(maximum)) => (minimum, maximum),
            // The class says what the file leaves out.
            (None, None) => {
                return match of_class {
                    Some(Ok(limits)) => Ok((callout, limits)),
                    Some(Err(error)) => Err(NoLimits::Refused(Box::new(error))),
                    None => Err(NoLimits::Unjudged(WhyUnjudged::NoTolerance)),
                };
            }
            _ => return Err(NoLimits::Unjudged(WhyUnjudged::OneLimit)),
        };
        match of_class {
            Some(Ok(limits)) if (limits.minimum(), limits.maximum()) == (minimum, maximum) => {
                return Ok((callout, limits));
            }
            Some(Ok(limits)) => {
                if let Some(callout) = callout {
                    let minimum = limits.minimum();
                    let maximum = limits.maximum();
                    warn(ImportWarningKind::LimitsDiffer { callout, minimum, maximum });
                }
            }
            Some(Err(error @ LimitsError::Zone(_))) => return Err(NoLimits::Refused(Box::new(error))),
            Some(Err(_)) => warn(ImportWarningKind::ClassUnknown { given: self.class.clone() }),
            None if !self.class.is_empty() => warn(ImportWarningKind::ClassUnknown { given: self.class.clone() }),
            None => {}
        }
        let stated = StatedLimits { minimum: Some(minimum), maximum: Some(maximum), ..self.said() };
        Ok((None, stated.limits(given(context, self.feature(), true))?))
    }
}

/// The characteristics that a file declares, in its order, with their lines: the features of a plan.
#[derive(Debug, Default)]
pub(super) struct Characteristics {
    pub(super) found: Vec<(usize, Characteristic)>,
    /// What cannot be one, with its line and the reason.
    pub(super) refused: Vec<(usize, ImportErrorKind)>,
    /// What the file leaves open and how it is read.
    pub(super) told: Vec<(usize, ImportWarningKind)>,
    /// What the file says of all of them.
    pub(super) head: Head,
    /// Where those of a name are.
    of_name: HashMap<String, Vec<usize>>,
}

impl Characteristics {
    /// Adds one, unless one of its name asks for the same, as that of another part does; where it lies may be another for each part.
    pub(super) fn add(&mut self, line: usize, characteristic: Characteristic) {
        let same = |(_, known): &(usize, Characteristic)| {
            known.what == characteristic.what && known.said() == characteristic.said()
        };
        if self.of_name(&characteristic.name).all(|known| !same(known)) {
            self.of_name.entry(characteristic.name.clone()).or_default().push(self.found.len());
            self.found.push((line, characteristic));
        }
    }

    /// The characteristics of this name so far, in the order of the file; several where they ask for different things.
    pub(super) fn of_name(&self, name: &str) -> impl Iterator<Item = &(usize, Characteristic)> {
        self.of_name.get(name).into_iter().flatten().filter_map(|at| self.found.get(*at))
    }

    /// Adds something that is no length: its name, and what it is.
    pub(super) fn add_other(&mut self, line: usize, name: String, what: String) {
        let other = Characteristic {
            name,
            what: CharacteristicKind::Other(what),
            class: String::new(),
            feature: None,
            nominal: None,
            minimum: None,
            maximum: None,
            expanded: None,
            labels: Labels::default(),
        };
        self.add(line, other);
    }

    /// Says once how the file is read.
    pub(super) fn tell(&mut self, line: usize, kind: ImportWarningKind) {
        if self.told.iter().all(|(_, told)| *told != kind) {
            self.told.push((line, kind));
        }
    }

    /// Says why something cannot be one.
    pub(super) fn refuse(&mut self, line: usize, kind: ImportErrorKind) {
        self.refused.push((line, kind));
    }
}

/// What is known of a value besides its limits.
const fn given<'a>(context: &'a Context<'_>, feature: Option<Feature>, is_size: bool) -> Given<'a> {
    Given { feature, is_size, file: &context.file, sources: context.sources }
}

#[cfg(test)]
impl super::Format {
    /// What a file declares, or the first thing that is wrong with it.
    pub(super) fn declared(
        &self,
        name: &str,
        bytes: &[u8],
        beside: Option<&[u8]>,
    ) -> Result<Vec<(usize, Characteristic)>, String> {
        let sources = fitcheck_core::tolerance::Sources::default();
        let beside = |_ending: &str| beside.map(<[u8]>::to_vec);
        let given = super::ImportInputs { beside: &beside, ..super::ImportInputs::new(&sources, DateTime::default()) };
        let mut body = std::io::Cursor::new(bytes);
        let mut source = super::Source::new(name, &mut body, given).unwrap();
        let mut found = Characteristics::default();
        self.plan.unwrap()(&mut source, &mut found).map_err(|error| error.to_string())?;
        match found.refused.first() {
            Some((_, refused)) => Err(refused.to_string()),
            None => Ok(found.found),
        }
    }
}
