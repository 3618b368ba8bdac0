//! Values judged by a plan: each finds its feature, and the plan's limits and rule decide. What the file itself says of limits is
//! compared, and what finds no feature is set aside.

use std::collections::BTreeMap;

use jiff::civil::DateTime;

use super::error::{ImportError, ImportErrorKind, ImportWarning, ImportWarningKind};
use super::imported::{Item, Labels, Unjudged, WhyUnjudged};
use crate::journal::Record;
use crate::length::Length;
use crate::message::{Located, Place};
use crate::part::{By, Clues, Finder, Kind, NotFound, Plan, Size, Taken, Walk};
use crate::probing::Measurement;
use crate::verdict::PositionVerdict;

/// The most parts whose missing features are told; more are counted.
const MOST_PARTS: usize = 10_000;

/// Judges what files hold by a plan, and knows what is missing of each part.
#[derive(Debug)]
pub struct ByPlan<'a> {
    plan: &'a Plan,
    finder: Finder,
    /// The sizes of the plan, as the finder counts them.
    sizes: Vec<Size<'a>>,
    /// The parts by serial number, and by name where a file names several.
    parts: BTreeMap<(String, String), Walk>,
    /// Whether there were more parts than are known.
    has_more: bool,
}

impl<'a> ByPlan<'a> {
    /// Of no file yet.
    pub fn new(plan: &'a Plan) -> Self {
        let (finder, sizes) = (Finder::new(plan), plan.sizes().collect());
        Self { plan, finder, sizes, parts: BTreeMap::new(), has_more: false }
    }

    /// The plan.
    pub const fn plan(&self) -> &'a Plan {
        self.plan
    }

    /// What was measured of every part: name, serial number, and the walk.
    pub fn parts(&self) -> impl Iterator<Item = (&str, &Walk)> {
        self.parts.iter().map(|((part, _), walk)| (part.as_str(), walk))
    }

    /// Whether there were more parts than [`Self::parts`] has.
    pub const fn has_more(&self) -> bool {
        self.has_more
    }

    /// The names of the sizes that a part has no value of.
    pub fn missing(&self, walk: &Walk) -> Vec<String> {
        walk.missing().map(|at| self.name(at)).collect()
    }

    /// Judges one thing of a file by the plan; warnings about it come before it.
    pub fn item(&mut self, item: Item, take: &mut dyn FnMut(Item)) {
        match item {
            Item::Record { line, record, labels } => self.value(line, *record, labels, take),
            Item::Unjudged(unjudged) => match unjudged.measured.filter(|_| is_plain(&unjudged.why)) {
                Some(measured) => self.unjudged(*unjudged, measured, take),
                None => take(Item::Unjudged(unjudged)),
            },
            item => take(item),
        }
    }

    /// A value that its file has limits for.
    fn value(&mut self, line: usize, record: Record, labels: Labels, take: &mut dyn FnMut(Item)) {
        let own = &record.limits;
        let kinds: &[&str] = if record.measurement.centre.is_some() { &["diameter"] } else { &[] };
        match self.find(&record.id, &labels, (Some(own.nominal), kinds)) {
            Ok((at, by)) => {
                let mut warn = |kind| take(warning(line, kind));
                if let Some(Size { limits, .. }) = self.sizes.get(at)
                    && (limits.minimum(), limits.maximum()) != (own.minimum(), own.maximum())
                {
                    let (minimum, maximum) = (own.minimum(), own.maximum());
                    warn(ImportWarningKind::PlanDiffers { minimum, maximum });
                }
                let Record { time, measurement, verdict, correction, .. } = record;
                self.tell(at, by, &mut warn);
                let Some(judged) = self.judged(at, time, measurement, verdict.position) else { return };
                let judged = match correction {
                    Some(correction) => judged.corrected(correction),
                    None => judged,
                };
                self.keep(at, line, judged, labels, take);
            }
            Err(why) => {
                take(Item::Unjudged(Box::new(Unjudged {
                    line,
                    id: record.id,
                    labels,
                    time: record.time,
                    measured: Some(record.measurement.diameter),
                    origin: record.measurement.origin,
                    position: record.verdict.position,
                    why: WhyUnjudged::NotInPlan(why),
                })));
            }
        }
    }

    /// A value that its file does not judge, or not as a hole or shaft.
    fn unjudged(&mut self, unjudged: Unjudged, measured: Length, take: &mut dyn FnMut(Item)) {
        let nominal = match &unjudged.why {
            WhyUnjudged::Coordinate(own) | WhyUnjudged::Size { judged: own, .. } => own.nominal,
            WhyUnjudged::NoLimits { nominal } => Some(*nominal),
            _ => None,
        };
        let kinds: &[&str] = match &unjudged.why {
            WhyUnjudged::Coordinate(_) | WhyUnjudged::CoordinateWithoutLimits => &["face"],
            WhyUnjudged::Size { .. } | WhyUnjudged::SizeWithoutLimits { .. } => &["width", "pocket", "boss"],
            WhyUnjudged::Point(_) | WhyUnjudged::PointWithoutTolerance => &["point"],
            WhyUnjudged::NoLimits { .. } => &["diameter"],
            _ => &[],
        };
        match self.find(&unjudged.id, &unjudged.labels, (nominal, kinds)) {
            Ok((at, _)) if self.refuses(at, &unjudged.why) => {
                let WhyUnjudged::NotPositive { given, column } = unjudged.why else { return };
                let what = ImportError { kind: ImportErrorKind::NotPositive { given: given.clone() }, given };
                take(Item::Error(Box::new(Located { what, place: Place::in_line(unjudged.line, column) })));
            }
            Ok((at, by)) => {
                let line = unjudged.line;
                self.tell(at, by, &mut |kind| take(warning(line, kind)));
                let measurement = Measurement::of_diameter(measured, unjudged.origin);
                let Some(judged) = self.judged(at, unjudged.time, measurement, unjudged.position) else { return };
                self.keep(at, line, judged, unjudged.labels, take);
            }
            Err(why) => {
                take(Item::Unjudged(Box::new(Unjudged { why: WhyUnjudged::NotInPlan(why), ..unjudged })));
            }
        }
    }

    /// The size of the plan; `kinds` are those that the file can have measured, any where there are none.
    fn find(
        &self,
        name: &str,
        labels: &Labels,
        (nominal, kinds): (Option<Length>, &[&str]),
    ) -> Result<(usize, By), NotFound> {
        let clues = Clues { name, number: &labels.number, place: labels.place, side: labels.side };
        let (at, by) = self.finder.find(&clues)?;
        let kind = self.sizes.get(at).map_or("", |size| size.feature.kind.word());
        if !kinds.is_empty() && !kinds.contains(&kind) {
            return Err(NotFound::OtherKind { name: self.name(at), kind });
        }
        // A number may be a running one and a place that of another operation: the nominal size must be the plan's.
        let planned = self.sizes.get(at).map(|size| size.limits.nominal);
        match nominal {
            Some(given) if by != By::Name && planned.is_some_and(|planned| planned != given) => {
                Err(NotFound::OtherNominal { name: self.name(at), given })
            }
            _ => Ok((at, by)),
        }
    }

    /// Whether a value is refused because it is not above zero: only faces and points have deviations and coordinates.
    fn refuses(&self, at: usize, why: &WhyUnjudged) -> bool {
        let may_be_any = |size: &Size<'_>| matches!(size.feature.kind, Kind::Face(..) | Kind::Point(..));
        matches!(why, WhyUnjudged::NotPositive { .. }) && !self.sizes.get(at).is_some_and(may_be_any)
    }

    fn name(&self, at: usize) -> String {
        self.sizes.get(at).map_or_else(String::new, Size::name)
    }

    /// Says by what a feature was found, where it was not by its name.
    fn tell(&self, at: usize, by: By, warn: &mut dyn FnMut(ImportWarningKind)) {
        let name = self.name(at);
        match by {
            By::Name => {}
            By::Number => warn(ImportWarningKind::FoundByNumber { name }),
            By::Place => warn(ImportWarningKind::FoundByPlace { name }),
        }
    }

    fn judged(
        &self,
        at: usize,
        time: DateTime,
        measurement: Measurement,
        position: Option<PositionVerdict>,
    ) -> Option<Record> {
        let size = self.sizes.get(at)?;
        let record = Record::judged(time, size.name(), size.callout, size.limits.clone(), measurement, position);
        Some(match size.feature.rule {
            Some(rule) => record.by(rule),
            None => record,
        })
    }

    fn keep(&mut self, at: usize, line: usize, record: Record, labels: Labels, take: &mut dyn FnMut(Item)) {
        let key = (labels.part.clone(), labels.serial.clone());
        if self.parts.len() < MOST_PARTS || self.parts.contains_key(&key) {
            let walk = self.parts.entry(key).or_insert_with(|| Walk::new(self.plan, labels.serial.clone()));
            let is_simulated = record.measurement.origin.is_simulated();
            walk.take(at, Taken { status: record.verdict.status(), is_simulated });
        } else {
            self.has_more = true;
        }
        take(Item::Record { line, record: Box::new(record), labels });
    }
}

/// Whether a value has no verdict because nothing says what it should be; another quantity, or a value that its file marks as none, is
/// not judged by a plan either.
const fn is_plain(why: &WhyUnjudged) -> bool {
    matches!(
        why,
        WhyUnjudged::NoCallout
            | WhyUnjudged::NotPositive { .. }
            | WhyUnjudged::NoLimits { .. }
            | WhyUnjudged::NoFeature { .. }
            | WhyUnjudged::OneLimit
            | WhyUnjudged::NoTolerance
            | WhyUnjudged::SwappedLimits { .. }
            | WhyUnjudged::Coordinate(_)
            | WhyUnjudged::CoordinateWithoutLimits
            | WhyUnjudged::Size { .. }
            | WhyUnjudged::SizeWithoutLimits { .. }
            | WhyUnjudged::Point(_)
            | WhyUnjudged::PointWithoutTolerance
    )
}

fn warning(line: usize, kind: ImportWarningKind) -> Item {
    Item::Warning(Located { what: ImportWarning { row: Some(line), kind }, place: Place::line(line) })
}
