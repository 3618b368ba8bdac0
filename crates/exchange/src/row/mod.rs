//! A record in figures: the names that CSV and JSON share, the same in every language.
//!
//! | file | what |
//! |---|---|
//! | here | a row: what a check has under each name |
//! | `columns` | columns of CSV, each declared once |
//! | `figure` | an exact decimal in files for programs |
//!
//! The names say millimetres or micrometres; the decimal sign is always a point. Sizes are exact.

pub mod columns;
pub mod figure;

use fitcheck_core::length::{Length, Unit};
use fitcheck_core::tolerance::Source;
use fitcheck_core::tolerance::fit::thermal::Warm;
use fitcheck_core::verdict::PositionVerdict;
use serde::Serialize;

use crate::journal::{Decision, Record};

/// One record. The fields' order is the order of the columns.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct ReportRow {
    pub time: String,
    pub id: String,
    pub callout: Option<String>,
    pub feature: Option<&'static str>,
    pub nominal_mm: Millimetres,
    pub min_mm: Millimetres,
    pub max_mm: Millimetres,
    pub measured_mm: Millimetres,
    pub deviation_um: Micrometres,
    pub status: &'static str,
    pub remove_um: Option<Micrometres>,
    pub remove_to_middle_um: Option<Micrometres>,
    pub position: Option<&'static str>,
    pub centre_x_mm: Option<Millimetres>,
    pub centre_y_mm: Option<Millimetres>,
    pub contacts: Vec<[f64; 3]>,
    pub source: String,
    pub origin: String,
    pub rule: String,
    pub warnings: Vec<String>,
    pub simulated: bool,
    /// Brought to 20 °C only.
    #[serde(flatten)]
    pub corrected: Option<Corrected>,
    /// By a rule of its own only.
    #[serde(flatten)]
    pub guarded: Option<Guarded>,
    /// With an uncertainty from a budget only.
    #[serde(flatten)]
    pub budgeted: Option<Budgeted>,
    #[serde(flatten)]
    pub undecided: Option<LeftUndecided>,
}

/// What the correction of a measured value to 20 °C adds: `measured_mm` is the value at 20 °C.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Corrected {
    pub as_measured_mm: Millimetres,
    pub correction_um: Micrometres,
    pub temperature_c: f64,
    pub expansion_um_per_m_k: f64,
    pub scale_temperature_c: Option<f64>,
    pub scale_expansion_um_per_m_k: Option<f64>,
}

impl Corrected {
    fn of(record: &Record) -> Option<Self> {
        let correction = record.correction.as_ref()?;
        let celsius = |warm: Warm| f64::from(warm.temperature.thousandths()) / 1e3;
        let expansion = |warm: Warm| f64::from(warm.expansion.thousandths()) / 1e3;
        Some(Self {
            as_measured_mm: Millimetres(correction.measured),
            correction_um: Micrometres(correction.change()),
            temperature_c: celsius(correction.part),
            expansion_um_per_m_k: expansion(correction.part),
            scale_temperature_c: correction.scale.map(celsius),
            scale_expansion_um_per_m_k: correction.scale.map(expansion),
        })
    }
}

/// What a decision rule adds.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Guarded {
    /// The word of the rule.
    pub rule_name: &'static str,
    /// The standard uncertainty, µm, and its coverage factor.
    pub u_um: Option<f64>,
    pub k: Option<f64>,
    /// The accepted values; none where the rule accepts no value.
    pub zone_min_mm: Option<Millimetres>,
    pub zone_max_mm: Option<Millimetres>,
    /// The probability that the part conforms.
    pub conformity: Option<f64>,
    /// Whether the rule proves the status.
    pub proven: Option<bool>,
}

impl Guarded {
    fn of(record: &Record) -> Option<Self> {
        let Decision { zones, proven, conformity } = record.decision()?;
        let rule = record.verdict.rule;
        let number = |text: String| text.parse().ok();
        Some(Self {
            rule_name: rule.name().word(),
            u_um: rule.uncertainty().and_then(|uncertainty| number(uncertainty.um())),
            k: rule.uncertainty().and_then(|uncertainty| number(uncertainty.k())),
            zone_min_mm: zones.accepted.map(|[least, _]| Millimetres(least)),
            zone_max_mm: zones.accepted.map(|[_, most]| Millimetres(most)),
            conformity: conformity.map(|conformity| conformity.within),
            proven,
        })
    }
}

/// What a budget adds.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Budgeted {
    pub budget: String,
    pub budget_date: String,
    pub budget_valid_until: String,
    pub budget_validity: &'static str,
}

impl Budgeted {
    fn of(record: &Record) -> Option<Self> {
        let budget = record.budget.as_ref()?;
        Some(Self {
            budget: budget.name.clone(),
            budget_date: budget.date.to_string(),
            budget_valid_until: budget.valid_until.to_string(),
            budget_validity: budget.validity.word(),
        })
    }
}

/// Why a value decides nothing although the rule would, in English.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct LeftUndecided {
    pub remeasure_reason: String,
}

impl LeftUndecided {
    fn of(record: &Record) -> Option<Self> {
        Some(Self { remeasure_reason: record.verdict.undecided?.to_string() })
    }
}

/// A length as a number of millimetres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Millimetres(pub Length);

/// A length as a number of micrometres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Micrometres(pub Length);

// A length has at most 16 significant figures, and a float's shortest text gives back 15 figures of any number and 16
// of nearly every number; the rest are sizes above 1 000 km. So the JSON number reads as the exact decimal.
impl Serialize for Millimetres {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_f64(self.0.to_mm_f64())
    }
}

impl Serialize for Micrometres {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_f64(self.0.to_um_f64())
    }
}

impl Millimetres {
    /// Exact, with at least this many decimals.
    #[cfg(feature = "reports")]
    pub fn text(self, decimals: usize) -> String {
        self.0.exact(Unit::Millimetre, decimals)
    }
}

impl Micrometres {
    /// Exact, with only the decimals it has.
    pub fn text(self) -> String {
        self.0.exact(Unit::Micrometre, 0)
    }
}

impl ReportRow {
    pub fn of(record: &Record) -> Self {
        let Record { limits, measurement, verdict, .. } = record;
        let [centre_x_mm, centre_y_mm] =
            measurement.centre.map_or([None; 2], |axes| axes.map(|a| Some(Millimetres(a))));
        let removal = verdict.size.removal;
        Self {
            time: record.time.to_string(),
            id: record.id.clone(),
            callout: record.callout.map(|callout| callout.to_string()),
            feature: limits.feature.map(fitcheck_core::tolerance::Feature::word),
            nominal_mm: Millimetres(limits.nominal),
            min_mm: Millimetres(limits.minimum()),
            max_mm: Millimetres(limits.maximum()),
            measured_mm: Millimetres(measurement.diameter),
            deviation_um: Micrometres(verdict.size.deviation),
            status: verdict.status().word(),
            remove_um: removal.map(|removal| Micrometres(removal.to_limit)),
            remove_to_middle_um: removal.map(|removal| Micrometres(removal.to_middle)),
            position: verdict.position.map(position),
            centre_x_mm,
            centre_y_mm,
            // `+ 0.0` turns a negative zero into zero.
            contacts: measurement.contacts.iter().map(|c| [c.x + 0.0, c.y + 0.0, c.z + 0.0]).collect(),
            source: limits.source.to_string(),
            origin: measurement.origin.to_string(),
            rule: verdict.rule.to_string(),
            warnings: warnings(record),
            simulated: measurement.origin.is_simulated(),
            corrected: Corrected::of(record),
            guarded: Guarded::of(record),
            budgeted: Budgeted::of(record),
            undecided: LeftUndecided::of(record),
        }
    }
}

/// The position for machines; the size has its own column, so neither hides the other.
pub fn position(position: PositionVerdict) -> &'static str {
    if position.is_out() {
        "OUT"
    } else if position.is_monitored() {
        "IN"
    } else {
        "NOT MONITORED"
    }
}

/// The warnings about the check, then what the measurement cannot tell, in English.
pub fn warnings(record: &Record) -> Vec<String> {
    let Record { limits, verdict, doubt, .. } = record;
    let mut warnings: Vec<String> = doubt.iter().map(ToString::to_string).collect();
    if verdict.status() != verdict.size.status {
        warnings.push(format!("the centre is out of position; the size alone is {}", verdict.size.status));
    }
    if verdict.is_beyond_limits() {
        warnings.push(
            "the size is outside the limits; the rule accepts it, since it does not prove it to be out".to_owned(),
        );
    }
    if let Source::Table { instead_of: Some(standard), .. } = &limits.source {
        let um = |length| Micrometres(length).text();
        let upper = um(standard.upper());
        let lower = um(standard.lower());
        warnings.push(format!("own table: ISO 286 says {upper} and {lower} µm here"));
    }
    if let Some(budget) = &record.budget {
        warnings.extend(budget.warnings.iter().map(ToString::to_string));
    }
    warnings.extend(record.caveats().iter().map(ToString::to_string));
    warnings
}

/// One record as an object with the CSV's names; missing values are left out.
///
/// # Errors
/// What JSON cannot hold.
pub fn object(record: &Record) -> serde_json::Result<serde_json::Map<String, serde_json::Value>> {
    let value = serde_json::to_value(ReportRow::of(record))?;
    let serde_json::Value::Object(mut object) = value else { return Ok(serde_json::Map::new()) };
    // Leave out missing values: nulls, and the empty contacts and name of a typed value. That it is neither hole nor shaft is said.
    object.retain(|name, value| {
        name == "feature"
            || !value.is_null()
                && value.as_str() != Some("")
                && !matches!(value, serde_json::Value::Array(array) if array.is_empty())
    });
    Ok(object)
}
