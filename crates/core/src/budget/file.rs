//! A budget as one TOML file.
//!
//! ```toml
//! name = "Station 3, probe 1"
//! date = 2026-01-15
//! by = "J. Jansen"
//! valid_until = 2027-01-14      # this day included
//! failed_study = "…"            # why a study found the gauge not good enough; without it none did
//!
//! [[contribution]]
//! name = "Scatter of a touch"
//! kind = "scatter"              # times the geometry factor of the contacts
//! type = "A"
//! law = "normal"
//! standard_um = 0.5
//! degrees_of_freedom = 24       # infinite without it
//! touches = 4                   # with step_deg, unless contacts are given
//! step_deg = 90
//!
//! [[contribution]]
//! name = "Setting ring"
//! type = "B"
//! law = "normal"
//! expanded_um = 1.0
//! k = 2
//!
//! [[contribution]]
//! name = "Temperature of the part"
//! kind = "part-temperature"     # times size and expansion; "scale-temperature" likewise
//! type = "B"
//! law = "rectangular"
//! half_width_k = 1.0
//! alpha_per_k = 11.5e-6
//!
//! [[contribution]]
//! name = "Expansion of the part"
//! kind = "part-expansion"       # u(alpha), times size and delta_k; "scale-expansion" likewise
//! type = "B"
//! law = "rectangular"
//! half_width_per_k = 1e-6
//! delta_k = 3.0                 # how far the temperature is from 20 °C
//!
//! [[contribution]]
//! name = "Geometry of the machine"
//! type = "B"
//! law = "rectangular"           # or "u-shaped", "triangular"
//! half_width_um = 1.0
//! sensitivity = 1.0             # 1 without it
//!
//! [[contribution]]
//! name = "Display"
//! kind = "resolution"           # the step of the display; rectangular
//! type = "B"
//! resolution_um = 0.1
//! ```
//!
//! Instead of contributions a file can have one table `[calibrated]` (ISO 15530-3):
//!
//! ```toml
//! [calibrated]
//! x_cal_mm = 30.0012
//! expanded_um = 0.6             # with k, or standard_um
//! k = 2
//! u_b_um = 0.1                  # or temperature_c and u_alpha_per_k of the piece
//! u_w_um = 0.3                  # or temperature_c and u_alpha_parts_per_k; both add up
//! bias_corrected = false        # whether measured values are corrected before they are judged; false without it
//! feature = "hole"              # or "shaft", for files of readings
//! readings_mm = [30.0021, 30.0024]
//! ```
//!
//! An unknown key is an error.

use serde::Deserialize;
use toml::Spanned;

use super::error::{BudgetError, MOST};
use super::kinds::{Keys, KindName};
use super::numbers::{ALPHA, DEGREES, FAR, Number, Numbers, Refusal, refused};
use super::piece::{Piece, calibrated};
use super::{Basis, Budget, Contribution, ContributionKind, Evaluated, Geometry, Law};
use crate::message::{FilePlace, Located, shortened};
use crate::probing::simulated::{LARGEST, bounded, plain};

/// The most characters of a list of keys.
const LONGEST_LIST: usize = 600;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    name: Spanned<String>,
    date: Spanned<toml::Value>,
    by: Spanned<String>,
    valid_until: Spanned<toml::Value>,
    failed_study: Option<Spanned<String>>,
    #[serde(default)]
    contribution: Vec<WrittenContribution>,
    calibrated: Option<Spanned<Piece>>,
}

/// A contribution as it is written.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct WrittenContribution {
    name: Spanned<String>,
    #[serde(rename = "type")]
    evaluated: Evaluated,
    law: Option<Law>,
    kind: Option<KindName>,
    half_width_um: Number,
    half_width_k: Number,
    half_width_per_k: Number,
    standard_um: Number,
    standard_k: Number,
    standard_per_k: Number,
    expanded_um: Number,
    expanded_k: Number,
    expanded_per_k: Number,
    k: Number,
    resolution_um: Number,
    alpha_per_k: Number,
    delta_k: Number,
    sensitivity: Number,
    degrees_of_freedom: Number,
    touches: Option<Spanned<u32>>,
    step_deg: Number,
}

impl Budget {
    /// Whether a text, or the beginning of one, is a budget: one with `[[contribution]]` tables or a table `[calibrated]`.
    pub fn is_file(text: &str) -> bool {
        text.lines().any(|line| {
            let line: String = line.chars().filter(|character| !character.is_whitespace()).collect();
            line.starts_with("[[contribution]]") || line.starts_with("[calibrated]")
        })
    }

    /// Reads a file.
    ///
    /// # Errors
    /// [`BudgetError`] with line and column.
    pub fn read(text: &str) -> Result<Self, Located<BudgetError>> {
        let of_file = |what| Located { what, place: FilePlace::default() };
        if LARGEST < text.len() {
            return Err(of_file(BudgetError::TooLarge));
        }
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let file: File = toml::from_str(text).map_err(|error| {
            let said = told(&plain(&error, text));
            refused(text, error.span().map_or(0, |span| span.start), BudgetError::Toml { said })
        })?;
        let date = day("date", &file.date, text)?;
        let valid_until = day("valid_until", &file.valid_until, text)?;
        if valid_until < date {
            let what = BudgetError::Days { date: date.to_string(), until: valid_until.to_string() };
            return Err(refused(text, file.valid_until.span().start, what));
        }
        let basis = match (&file.calibrated, file.contribution.as_slice()) {
            (Some(piece), []) => Basis::Calibrated(calibrated(piece, text)?),
            (None, given) if MOST < given.len() => return Err(of_file(BudgetError::TooMany { count: given.len() })),
            (None, given) if !given.is_empty() => {
                Basis::Contributions(given.iter().map(|given| given.contribution(text)).collect::<Result<_, _>>()?)
            }
            _ => return Err(of_file(BudgetError::NotOne)),
        };
        let name = filled("name", &file.name, text)?;
        let by = filled("by", &file.by, text)?;
        let failed_study = file.failed_study.as_ref().map(|why| filled("failed_study", why, text)).transpose()?;
        Ok(Self { name, date, by, valid_until, failed_study, basis })
    }
}

/// The TOML reader's message. What was given is cut off where it is very long, and what is allowed is whole.
fn told(said: &str) -> String {
    const ALLOWED: &str = ", expected one of ";
    match said.rsplit_once(ALLOWED) {
        Some((given, allowed)) => format!("{}{ALLOWED}{}", bounded(given), shortened(allowed, LONGEST_LIST)),
        None => bounded(said),
    }
}

/// A text with something in it.
fn filled(key: &'static str, given: &Spanned<String>, text: &str) -> Result<String, Refusal> {
    let said = given.get_ref().trim();
    if said.is_empty() {
        return Err(refused(text, given.span().start, BudgetError::Empty { key }));
    }
    Ok(said.to_owned())
}

/// A day, as TOML's own or as a text.
fn day(key: &'static str, given: &Spanned<toml::Value>, text: &str) -> Result<jiff::civil::Date, Refusal> {
    let said = match given.get_ref() {
        toml::Value::String(said) => said.clone(),
        other => other.to_string(),
    };
    // Longer texts have a time, which would be passed over.
    let day = (said.len() == "2026-01-15".len()).then(|| said.parse().ok()).flatten();
    day.ok_or_else(|| refused(text, given.span().start, BudgetError::Day { key, given: bounded(&said) }))
}

impl WrittenContribution {
    fn contribution(&self, text: &str) -> Result<Contribution, Refusal> {
        let name = filled("name", &self.name, text)?;
        let touches = self.touches.as_ref().map(|touches| Spanned::new(touches.span(), f64::from(*touches.get_ref())));
        let all = [
            ("half_width_um", &self.half_width_um),
            ("half_width_k", &self.half_width_k),
            ("half_width_per_k", &self.half_width_per_k),
            ("standard_um", &self.standard_um),
            ("standard_k", &self.standard_k),
            ("standard_per_k", &self.standard_per_k),
            ("expanded_um", &self.expanded_um),
            ("expanded_k", &self.expanded_k),
            ("expanded_per_k", &self.expanded_per_k),
            ("k", &self.k),
            ("resolution_um", &self.resolution_um),
            ("alpha_per_k", &self.alpha_per_k),
            ("delta_k", &self.delta_k),
            ("sensitivity", &self.sensitivity),
            ("degrees_of_freedom", &self.degrees_of_freedom),
            ("touches", &touches),
            ("step_deg", &self.step_deg),
        ];
        let numbers = Numbers { text, offset: self.name.span().start, table: &name, all: &all };
        let (law, u) = self.law_and_u(&numbers)?;
        let kind = match self.kind {
            None => ContributionKind::Plain,
            Some(KindName::Resolution) => ContributionKind::Resolution,
            Some(KindName::PartTemperature) => {
                ContributionKind::PartTemperature(numbers.needed("alpha_per_k", 0.0, ALPHA)?)
            }
            Some(KindName::ScaleTemperature) => {
                ContributionKind::ScaleTemperature(numbers.needed("alpha_per_k", 0.0, ALPHA)?)
            }
            Some(KindName::PartExpansion) => {
                ContributionKind::PartExpansion(numbers.needed("delta_k", -DEGREES, DEGREES)?)
            }
            Some(KindName::ScaleExpansion) => {
                ContributionKind::ScaleExpansion(numbers.needed("delta_k", -DEGREES, DEGREES)?)
            }
            Some(KindName::Scatter) => ContributionKind::Scatter(self.geometry(&numbers)?),
        };
        let sensitivity = numbers.within("sensitivity", -FAR, FAR)?.unwrap_or(1.0);
        let degrees = numbers.within("degrees_of_freedom", 1.0, f64::INFINITY)?;
        let degrees_of_freedom = degrees.filter(|degrees| degrees.is_finite());
        Ok(Contribution { evaluated: self.evaluated, law, kind, u, sensitivity, degrees_of_freedom, name })
    }

    /// The law, and the standard uncertainty that follows from what is given for it.
    fn law_and_u(&self, numbers: &Numbers<'_>) -> Result<(Law, f64), Refusal> {
        let always = ["sensitivity", "degrees_of_freedom"];
        if self.kind == Some(KindName::Resolution) {
            if self.law.is_some_and(|law| law != Law::Rectangular) {
                let what = BudgetError::ResolutionLaw { table: numbers.table.to_owned() };
                return Err(refused(numbers.text, numbers.offset, what));
            }
            numbers.only(&["resolution_um", "sensitivity", "degrees_of_freedom"])?;
            let step = numbers.needed("resolution_um", 0.0, FAR)?;
            return Ok((Law::Rectangular, step / 2.0 / Law::Rectangular.divisor()));
        }
        let law = self.law.ok_or_else(|| numbers.missing("law"))?;
        let Keys { standard, expanded, half_width, normal, unit, most } = *KindName::keys(self.kind);
        let by_law: &[&str] = match law {
            Law::Normal if numbers.has(standard) => &[standard],
            Law::Normal => &[standard, expanded, "k"],
            _ => &[half_width],
        };
        numbers.only(&[by_law, KindName::besides(self.kind), &always].concat())?;
        let u = if law != Law::Normal {
            numbers.needed(half_width, 0.0, most)? / law.divisor()
        } else if let Some(u) = numbers.within(standard, 0.0, most)? {
            u
        } else if let Some(expanded) = numbers.within(expanded, 0.0, most)? {
            expanded / numbers.needed("k", 1.0, 10.0)?
        } else {
            return Err(numbers.missing(normal));
        };
        Ok((law, u * unit))
    }

    fn geometry(&self, numbers: &Numbers<'_>) -> Result<Option<Geometry>, Refusal> {
        let (touches, step) = match (&self.touches, &self.step_deg) {
            (None, None) => return Ok(None),
            (Some(touches), Some(step)) => (touches, step),
            (None, Some(_)) => return Err(numbers.missing("touches")),
            (Some(_), None) => return Err(numbers.missing("step_deg")),
        };
        let geometry = Geometry::steps(*touches.get_ref(), *step.get_ref());
        geometry.map(Some).map_err(|error| {
            let what = BudgetError::Geometry { table: numbers.table.to_owned(), error };
            refused(numbers.text, touches.span().start, what)
        })
    }
}
