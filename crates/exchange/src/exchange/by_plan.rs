//! Values judged by a plan: each finds its feature, and the plan's limits and rule decide. What the file itself says of limits is
//! compared, and what finds no feature is set aside.

use fitcheck_core::length::Length;
use fitcheck_core::message::{FilePlace, Located};
use fitcheck_core::part::{By, Clues, FeatureKind, Finder, NotFound, Plan, Size};
use fitcheck_core::probing::Measurement;
use fitcheck_core::tolerance::fit::thermal::Correction;
use fitcheck_core::verdict::{PositionVerdict, judge_size};
use jiff::civil::DateTime;

use super::claim::ClaimAnswer;
use super::error::{ImportError, ImportErrorKind, ImportWarning, ImportWarningKind};
use super::given::shorten;
use super::imported::{Item, Labels, StatedLimits, Unjudged, WhyUnjudged};
use super::quantity::Quantity;
use crate::journal::Record;

/// Judges what files hold by a plan.
#[derive(Debug)]
pub struct ByPlan<'a> {
    plan: &'a Plan,
    finder: Finder,
    /// The sizes of the plan, as the finder counts them.
    sizes: Vec<Size<'a>>,
}

impl<'a> ByPlan<'a> {
    /// Of no file yet.
    pub fn new(plan: &'a Plan) -> Self {
        let finder = Finder::new(plan);
        let sizes = plan.sizes().collect();
        Self { plan, finder, sizes }
    }

    pub const fn plan(&self) -> &'a Plan {
        self.plan
    }

    /// Judges all that a file holds. A number that may be a running one finds a feature only where every size of the file is one of the
    /// plan: the rows of any file may be numbered.
    pub fn file(&self, items: Vec<Item>) -> Vec<Item> {
        let is_strange = |value: &Value| value.labels.may_be_running && self.find(value).is_err();
        let is_of_plan = !items.iter().filter_map(plain).any(|value| is_strange(&value));
        let mut judged = Vec::new();
        for item in items {
            match plain(&item).filter(|_| !is_of_plan).and_then(|value| self.only_numbered(value)) {
                Some(unjudged) => judged.push(Item::Unjudged(Box::new(unjudged))),
                None => self.item(item, &mut |item| judged.push(item)),
            }
        }
        judged
    }

    /// A value that nothing but a number speaks for which may be a running one.
    fn only_numbered(&self, value: Value) -> Option<Unjudged> {
        match self.find(&value) {
            Ok((at, By::Number)) if value.labels.may_be_running => {
                Some(value.without(NotFound::RunningNumber { name: self.name(at) }))
            }
            _ => None,
        }
    }

    /// Judges one thing of a file by the plan; warnings about it come before it.
    pub fn item(&self, item: Item, take: &mut dyn FnMut(Item)) {
        match item {
            Item::Record { line, record, labels } => self.value(Value::of_record(line, *record, labels), take),
            Item::Unjudged(unjudged) => match unjudged.measured.filter(|_| is_plain(&unjudged.why)) {
                Some(measured) => self.value(Value::of_unjudged(*unjudged, measured), take),
                None => self.other_quantity(unjudged, take),
            },
            // Compared with the limits of the file: those of the plan are below.
            Item::Warning(Located { what: ImportWarning { kind, .. }, .. }) if kind.is_of_claim() => {}
            item => take(item),
        }
    }

    /// A coordinate may be what the plan asks of a face, and a length what it asks of a form; every other quantity that is no size stays what
    /// its file calls it.
    fn other_quantity(&self, unjudged: Box<Unjudged>, take: &mut dyn FnMut(Item)) {
        let measured = unjudged.measured.filter(|_| matches!(unjudged.why, WhyUnjudged::NotASize { .. }));
        let is_asked = |value: &Value| self.find(value).is_ok();
        match measured.zip(unjudged.labels.quantity.as_ref()) {
            Some((measured, Quantity::Coordinate(_) | Quantity::Length)) => {
                let value = Value::of_unjudged((*unjudged).clone(), measured);
                if is_asked(&value) { self.value(value, take) } else { left(*unjudged, take) }
            }
            _ => left(*unjudged, take),
        }
    }

    fn value(&self, value: Value, take: &mut dyn FnMut(Item)) {
        let (at, by) = match self.find(&value) {
            Ok(found) => found,
            Err(why) => return left(value.without(why), take),
        };
        let Value { line, id, labels, asked, time, measurement, position, correction, not_positive, .. } = value;
        let Some(size) = self.sizes.get(at) else { return };
        if let Some((given, column)) = not_positive.filter(|_| !may_be_below_zero(size)) {
            let what = ImportError { kind: ImportErrorKind::NotPositive { given: given.clone() }, given };
            return take(Item::Error(Box::new(Located { what, place: FilePlace::in_line(line, column) })));
        }
        let status = judge_size(size.limits, measurement.diameter).status;
        // As it was measured: nobody expects the value at 20 °C.
        let measured = correction.map_or(measurement.diameter, |correction| correction.measured);
        let implausible = size.excludes(measured).map(|range| {
            let (lower, upper) = (range.lower(), range.upper());
            WhyUnjudged::Implausible { measured, lower, upper }
        });
        if let Some(why) = implausible.or_else(|| labels.too_coarse(size.limits, measurement.diameter, status)) {
            let measured = Some(measurement.diameter);
            let origin = measurement.origin;
            let id = size.name();
            let unjudged = Unjudged { line, id, labels, time, measured, origin, position, asked, correction, why };
            return take(Item::Unjudged(Box::new(unjudged)));
        }
        let record = Record::judged(time, size.name(), size.callout, size.limits.clone(), measurement, position);
        let record = match correction {
            Some(correction) => record.corrected(correction),
            None => record,
        };
        let record = match size.feature.rule {
            Some(rule) => record.by(rule),
            None => record,
        };
        let answer = ClaimAnswer::of(&record);
        let kind = &size.feature.kind;
        // A face has one side, and a point none.
        let has_sides = !matches!(kind, FeatureKind::Face(..) | FeatureKind::Point(..) | FeatureKind::Form(_));
        let claims = labels.claims.iter().filter(|claim| has_sides || !claim.is_of_feature());
        let told = found(&size.name(), by, &id, &labels.number)
            .into_iter()
            .chain(self.other_part(&labels.part))
            .chain(other_limits(&asked, size))
            .chain(claims.filter_map(|claim| claim.tells(&answer)));
        for kind in told {
            take(warning(line, kind));
        }
        take(Item::Record { line, record: Box::new(record), labels });
    }

    /// The size of the plan.
    fn find(&self, value: &Value) -> Result<(usize, By), NotFound> {
        let Value { id, labels, asked, kinds, .. } = value;
        let clues = Clues { name: id, number: &labels.number, place: labels.place, side: labels.side };
        let (at, by) = self.finder.find(&clues)?;
        let kind = self.sizes.get(at).map_or("", |size| size.feature.kind.word());
        let fits = |quantity: &Quantity| self.sizes.get(at).is_none_or(|size| quantity.fits(&size.feature.kind));
        if !kinds.is_empty() && !kinds.contains(&kind) || !labels.quantity.as_ref().is_none_or(fits) {
            return Err(NotFound::OtherKind { name: self.name(at), kind });
        }
        if let Some(why) = self.sizes.get(at).and_then(|size| contradiction(value, size, by)) {
            return Err(why);
        }
        // A name that is known to no feature speaks against the number, unless the size speaks for it.
        if by == By::Number && has_name_and_number(value) && !self.agrees(at, asked) {
            return Err(NotFound::OtherName { given: shorten(id.trim()), name: self.name(at) });
        }
        Ok((at, by))
    }

    /// Whether a file asks for what the plan asks for: the same nominal size, or else limits that are all the plan's.
    fn agrees(&self, at: usize, asked: &StatedLimits) -> bool {
        let Some(limits) = self.sizes.get(at).map(|size| size.limits) else { return false };
        match (asked.nominal, asked.minimum, asked.maximum) {
            (Some(nominal), ..) => nominal == limits.nominal,
            (None, None, None) => false,
            (None, minimum, maximum) => {
                minimum.is_none_or(|minimum| minimum == limits.minimum())
                    && maximum.is_none_or(|maximum| maximum == limits.maximum())
            }
        }
    }

    fn name(&self, at: usize) -> String {
        self.sizes.get(at).map_or_else(String::new, Size::name)
    }

    /// That the file names another part than the plan.
    fn other_part(&self, given: &str) -> Option<ImportWarningKind> {
        let part = &self.plan.head.part;
        let is_other = !part.is_empty() && !given.trim().is_empty() && !given.trim().eq_ignore_ascii_case(part);
        is_other.then(|| ImportWarningKind::PartDiffers { given: shorten(given), part: part.clone() })
    }
}

/// The value of a record, or of what a plan may judge all the same.
fn plain(item: &Item) -> Option<Value> {
    match item {
        Item::Record { line, record, labels } => Some(Value::of_record(*line, (**record).clone(), labels.clone())),
        Item::Unjudged(unjudged) if is_plain(&unjudged.why) => {
            Some(Value::of_unjudged((**unjudged).clone(), unjudged.measured?))
        }
        _ => None,
    }
}

/// A value on its way to the plan, whether its file had judged it or not.
struct Value {
    line: usize,
    id: String,
    labels: Labels,
    asked: StatedLimits,
    time: DateTime,
    measurement: Measurement,
    position: Option<PositionVerdict>,
    correction: Option<Correction>,
    /// The kinds that its file can have measured; any where there are none.
    kinds: &'static [&'static str],
    /// Whether its nominal size is one: a file with limits alone has the smaller one for it.
    has_nominal: bool,
    /// What is given and its column, where that is no diameter.
    not_positive: Option<(String, usize)>,
}

impl Value {
    /// A value that its file has limits for.
    fn of_record(line: usize, record: Record, labels: Labels) -> Self {
        let Record { id, callout, limits: own, time, measurement, verdict, correction, .. } = record;
        let asked =
            StatedLimits { nominal: Some(own.nominal), minimum: Some(own.minimum()), maximum: Some(own.maximum()) };
        let has_nominal = callout.is_some() || own.nominal != own.minimum();
        let kinds: &[&str] = if measurement.centre.is_some() { &["diameter"] } else { &[] };
        let position = verdict.position;
        let not_positive = None;
        Self { line, id, labels, asked, time, measurement, position, correction, kinds, has_nominal, not_positive }
    }

    /// A value that its file does not judge, or not as a hole or shaft.
    fn of_unjudged(unjudged: Unjudged, measured: Length) -> Self {
        let asked = unjudged.asked();
        let Unjudged { line, id, labels, time, origin, position, correction, why, .. } = unjudged;
        let kinds: &[&str] = match why {
            WhyUnjudged::Coordinate(_) | WhyUnjudged::CoordinateWithoutLimits => &["face", "length"],
            WhyUnjudged::Size { .. } | WhyUnjudged::SizeWithoutLimits { .. } => &["width", "pocket", "boss", "length"],
            WhyUnjudged::Point(_) | WhyUnjudged::PointWithoutTolerance => &["point"],
            WhyUnjudged::NoLimits { .. } => &["diameter"],
            _ => &[],
        };
        let not_positive = match why {
            WhyUnjudged::NotPositive { given, column } => Some((given, column)),
            _ => None,
        };
        let measurement = Measurement::of_diameter(measured, origin);
        let has_nominal = true;
        Self { line, id, labels, asked, time, measurement, position, correction, kinds, has_nominal, not_positive }
    }

    /// The same without a feature of the plan.
    fn without(self, why: NotFound) -> Unjudged {
        let Self { line, id, labels, asked, time, measurement, position, correction, .. } = self;
        let measured = Some(measurement.diameter);
        let origin = measurement.origin;
        let why = WhyUnjudged::NotInPlan(why);
        Unjudged { line, id, labels, time, measured, origin, position, asked, correction, why }
    }
}

/// Gives what no size of the plan asks for, after what its file says against it: a part may be good by its plan and bad elsewhere.
fn left(unjudged: Unjudged, take: &mut dyn FnMut(Item)) {
    let Unjudged { line, asked: StatedLimits { minimum, maximum, .. }, measured, .. } = unjudged;
    let above = maximum.filter(|maximum| measured.is_some_and(|measured| *maximum < measured));
    let below = minimum.filter(|minimum| measured.is_some_and(|measured| measured < *minimum));
    let said = above.map(|maximum| ImportWarningKind::AboveOwnLimit { maximum });
    if let Some(kind) = said.or(below.map(|minimum| ImportWarningKind::BelowOwnLimit { minimum })) {
        take(warning(line, kind));
    }
    take(Item::Unjudged(Box::new(unjudged)));
}

/// Half a thousandth of an inch: how far a file may round a nominal size.
const ROUNDED: Length = Length::constant(12_700);

/// That a file asks for something else than the plan does of a size: the value is of another quantity, or of another feature.
///
/// A number may be a running one and a place that of another operation: there the nominal size must be the plan's. A value with the name
/// of the size may have its nominal size rounded, or the middle of the plan's limits; what lies within them is told and nothing more.
/// Without a nominal size its limits must have something in common with the plan's.
fn contradiction(value: &Value, size: &Size<'_>, by: By) -> Option<NotFound> {
    let asked = &value.asked;
    let limits = size.limits;
    let planned = limits.nominal;
    let is_compared = |given: &Length| by != By::Name || value.has_nominal || *given == planned;
    if let Some(given) = asked.nominal.filter(is_compared) {
        let is_rounded = given.saturating_sub(planned).abs() <= ROUNDED;
        let is_within = limits.minimum() <= given && given <= limits.maximum();
        let agrees = given == planned || by == By::Name && (is_rounded || is_within);
        return (!agrees).then(|| NotFound::OtherNominal { name: size.name(), given, planned });
    }
    let is_above = asked.minimum.is_some_and(|minimum| limits.maximum() < minimum);
    let is_below = asked.maximum.is_some_and(|maximum| maximum < limits.minimum());
    if !is_above && !is_below {
        return None;
    }
    let range = |minimum: Option<Length>, maximum: Option<Length>| {
        let text = |limit: Option<Length>| limit.map_or_else(String::new, |limit| limit.to_string());
        format!("{} … {}", text(minimum), text(maximum)).trim().to_owned()
    };
    let planned = range(Some(limits.minimum()), Some(limits.maximum()));
    Some(NotFound::OtherLimits { name: size.name(), given: range(asked.minimum, asked.maximum), planned })
}

/// Whether a file has both: without a number cell its name is the number.
fn has_name_and_number(value: &Value) -> bool {
    !value.id.trim().is_empty() && !value.labels.number.trim().is_empty()
}

/// Whether a value of a size may be zero or less: a coordinate or a deviation, not a distance.
const fn may_be_below_zero(size: &Size<'_>) -> bool {
    matches!(size.feature.kind, FeatureKind::Face(..) | FeatureKind::Point(..) | FeatureKind::Form(_))
}

/// By what a feature was found, where it was not by its name; and what the value is called where that is known to no feature.
fn found(name: &str, by: By, id: &str, number: &str) -> Option<ImportWarningKind> {
    let name = name.to_owned();
    let given = [id, number].into_iter().map(str::trim).find(|text| !text.is_empty()).map(shorten);
    match (by, given) {
        (By::Name, _) => None,
        // The name itself is the number.
        (By::Number, Some(given)) if !number.trim().is_empty() && !id.trim().is_empty() => {
            Some(ImportWarningKind::FoundByNumberOf { name, given })
        }
        (By::Number, _) => Some(ImportWarningKind::FoundByNumber { name }),
        (By::Place, Some(given)) => Some(ImportWarningKind::FoundByPlaceOf { name, given }),
        (By::Place, None) => Some(ImportWarningKind::FoundByPlace { name }),
    }
}

/// That the file has other limits than the plan, or another nominal size where it has none.
fn other_limits(asked: &StatedLimits, size: &Size<'_>) -> Option<ImportWarningKind> {
    let limits = size.limits;
    match (asked.minimum, asked.maximum) {
        (Some(minimum), Some(maximum)) => ((minimum, maximum) != (limits.minimum(), limits.maximum()))
            .then_some(ImportWarningKind::PlanDiffers { minimum, maximum }),
        (Some(minimum), None) => {
            (minimum != limits.minimum()).then_some(ImportWarningKind::PlanDiffersBelow { minimum })
        }
        (None, Some(maximum)) => {
            (maximum != limits.maximum()).then_some(ImportWarningKind::PlanDiffersAbove { maximum })
        }
        (None, None) => {
            let nominal = asked.nominal.filter(|nominal| *nominal != limits.nominal)?;
            Some(ImportWarningKind::PlanDiffersNominal { nominal })
        }
    }
}

/// Whether a value has no verdict because nothing says what it should be; another quantity, or a value that its file marks as none, is
/// not judged by a plan either.
const fn is_plain(why: &WhyUnjudged) -> bool {
    match why {
        WhyUnjudged::NoCallout
        | WhyUnjudged::NotPositive { .. }
        | WhyUnjudged::NoLimits { .. }
        | WhyUnjudged::OneLimit
        | WhyUnjudged::NoTolerance
        | WhyUnjudged::SwappedLimits { .. }
        | WhyUnjudged::Rounded { .. }
        | WhyUnjudged::Implausible { .. }
        | WhyUnjudged::Coordinate(_)
        | WhyUnjudged::CoordinateWithoutLimits
        | WhyUnjudged::Size { .. }
        | WhyUnjudged::SizeWithoutLimits { .. }
        | WhyUnjudged::Point(_)
        | WhyUnjudged::PointWithoutTolerance => true,
        WhyUnjudged::NotASize { .. }
        | WhyUnjudged::NotInPlan(_)
        | WhyUnjudged::Quantity { .. }
        | WhyUnjudged::Kind { .. }
        | WhyUnjudged::Attribute { .. }
        | WhyUnjudged::NotValid { .. }
        | WhyUnjudged::Declaration { .. }
        | WhyUnjudged::Contacts { .. } => false,
    }
}

fn warning(line: usize, kind: ImportWarningKind) -> Item {
    Item::Warning(Located { what: ImportWarning { row: Some(line), kind }, place: FilePlace::line(line) })
}
