//! A characteristic as its entries declare it.

use fitcheck_core::length::{Length, LengthError};
use fitcheck_core::tolerance::Feature;

use super::description::CharacteristicEntries;
use super::error::{AqdefFault, AqdefWarning};
use super::keys::{Key, number};
use super::unit::FileUnit;
use crate::exchange::Labels;
use crate::exchange::characteristic::{Characteristic, CharacteristicKind};
use crate::exchange::error::{ImportErrorKind, ImportWarningKind};
use crate::exchange::given::shorten;
use crate::exchange::imported::WhyUnjudged;
use crate::exchange::quantity::Quantity;

/// K2009 of a roundness, a position and a coordinate: public readers of AQDEF agree on these.
const LENGTHS: [u32; 3] = [102, 109, 117];

/// The width of the zone, or the class as a text; and the same as it was computed.
const TOLERANCES: [u16; 2] = [2151, 2152];

/// K2009 of a diameter.
const DIAMETER: u32 = 202;

/// A characteristic with what is needed to read its values.
#[derive(Debug, Clone)]
pub(super) struct Declared {
    pub(super) characteristic: Characteristic,
    /// The unit of its values, or what is none.
    pub(super) unit: Result<FileUnit, String>,
    /// Where it begins, if it has no unit.
    pub(super) unit_assumed: Option<usize>,
    /// K2004: 0 is measured, 1 counted, 5 and 6 are error log sheets.
    pub(super) kind: Option<u32>,
    /// How many decimals its values have.
    pub(super) decimals: Option<usize>,
    /// The line of an entry that cannot be used.
    pub(super) fault: Option<usize>,
    /// Errors and warnings, with their lines.
    pub(super) errors: Vec<(usize, ImportErrorKind, String)>,
    pub(super) warnings: Vec<(usize, ImportWarningKind)>,
}

/// Reads the entries of a characteristic.
struct Reading<'a> {
    asked: CharacteristicEntries<'a>,
    unit: FileUnit,
    is_unit_assumed: bool,
    fault: Option<usize>,
    errors: Vec<(usize, ImportErrorKind, String)>,
    warnings: Vec<(usize, ImportWarningKind)>,
}

impl Declared {
    /// Reads the entries.
    pub(super) fn read(asked: CharacteristicEntries<'_>) -> Self {
        let mut reading = Reading {
            asked,
            unit: FileUnit::MILLIMETRE,
            is_unit_assumed: false,
            fault: None,
            errors: Vec::new(),
            warnings: Vec::new(),
        };
        for (key, line, other) in asked.twice() {
            let text = asked.text(key.0);
            let other = shorten(other);
            reading.fail(line, AqdefFault::Twice { key: key.to_string(), other }, text);
        }
        let kind = reading.whole(2004);
        let quantity = reading.whole(2009);
        let decimals = reading.whole(2022).and_then(|decimals| decimals.try_into().ok());
        let what = match quantity {
            None | Some(DIAMETER) => CharacteristicKind::Size,
            Some(quantity) if LENGTHS.contains(&quantity) => {
                CharacteristicKind::Length(WhyUnjudged::Quantity { quantity })
            }
            Some(quantity) => CharacteristicKind::Quantity(quantity),
        };
        let unit = reading.read_unit();
        // Figures in a unit that is not known say nothing.
        let lengths = if let Ok(unit) = unit {
            reading.unit = unit;
            let lengths = reading.lengths();
            reading.compare_tolerance(&lengths);
            lengths
        } else {
            Lengths::default()
        };
        let class = class(&asked);
        let labels = Labels {
            number: first(&asked, &[2001]).map_or_else(|| asked.number.to_string(), str::to_owned),
            part: first(&asked, &[1001, 1002]).map_or_else(String::new, str::to_owned),
            who: asked.text(1222).to_owned(),
            quantity: match what {
                CharacteristicKind::Length(_) => Some(Quantity::Length),
                _ => (quantity == Some(DIAMETER)).then_some(Quantity::Diameter),
            },
            ..Labels::default()
        };
        let mut characteristic = Characteristic {
            name: asked.text(2002).to_owned(),
            what,
            class,
            feature: None,
            nominal: lengths.nominal,
            minimum: lengths.minimum,
            maximum: lengths.maximum,
            expanded: lengths.expanded,
            labels,
        };
        characteristic.feature = reading.scrap_side(&characteristic, &lengths);
        let Reading { is_unit_assumed, fault, errors, warnings, .. } = reading;
        let unit_assumed = is_unit_assumed.then(|| asked.line());
        Self { characteristic, unit, unit_assumed, kind, decimals, fault, errors, warnings }
    }
}

/// The lengths of a characteristic, each with the line of its entry where that matters.
#[derive(Debug, Clone, Copy, Default)]
struct Lengths {
    nominal: Option<Length>,
    minimum: Option<Length>,
    maximum: Option<Length>,
    expanded: Option<Length>,
    lower_scrap: Option<(usize, Length)>,
    upper_scrap: Option<(usize, Length)>,
}

impl Reading<'_> {
    fn warn(&mut self, line: usize, warning: AqdefWarning) {
        self.warnings.push((line, warning.into()));
    }

    fn fail(&mut self, line: usize, fault: AqdefFault, given: &str) {
        self.fault = self.fault.or(Some(line));
        self.errors.push((line, fault.into(), shorten(given)));
    }

    fn whole(&mut self, key: u16) -> Option<u32> {
        let (line, text) = self.asked.get(key)?;
        let found = number(text);
        if found.is_none() {
            let given = shorten(text);
            self.fail(line, AqdefFault::Whole { key: Key(key).to_string(), given }, text);
        }
        found
    }

    /// A length in the unit of the characteristic, with its line.
    fn length(&mut self, key: u16) -> Option<(usize, Length)> {
        let (line, text) = self.asked.get(key)?;
        match self.unit.parse(text) {
            Ok((length, is_rounded)) => {
                if is_rounded {
                    let given = shorten(text);
                    self.warnings.push((line, ImportWarningKind::Rounded { given }));
                }
                Some((line, length))
            }
            Err(reason) => {
                self.fail(line, AqdefFault::Number { key: Key(key).to_string(), reason }, text);
                None
            }
        }
    }

    fn read_unit(&mut self) -> Result<FileUnit, String> {
        let Some((_, text)) = self.asked.get(2142) else {
            self.is_unit_assumed = true;
            return Ok(FileUnit::MILLIMETRE);
        };
        FileUnit::named(text).ok_or_else(|| shorten(text))
    }

    fn lengths(&mut self) -> Lengths {
        let nominal = self.length(2101).map(|(_, nominal)| nominal);
        Lengths {
            nominal,
            minimum: self.limit(nominal, [2110, 2112, 2120]),
            maximum: self.limit(nominal, [2111, 2113, 2121]),
            expanded: self.length(2106).map(|(_, expanded)| expanded),
            lower_scrap: self.length(2114),
            upper_scrap: self.length(2115),
        }
    }

    /// K2151 and K2152 may have the width of the zone as a number, which is compared with the limits.
    fn compare_tolerance(&mut self, lengths: &Lengths) {
        let width = lengths.maximum.zip(lengths.minimum).map(|(maximum, minimum)| maximum.saturating_sub(minimum));
        for key in TOLERANCES {
            if !is_figure(self.asked.text(key)) {
                continue;
            }
            let Some(((line, given), expected)) = self.length(key).zip(width) else { continue };
            // Each of the figures may be rounded to the nanometre.
            if 2 < given.saturating_sub(expected).nanometres().abs() {
                self.warn(line, AqdefWarning::Tolerance { key: Key(key).to_string(), given, expected });
            }
        }
    }

    /// A limit: as such, else as the nominal size and an allowance, unless the file says that it is none.
    fn limit(&mut self, nominal: Option<Length>, [limit, allowance, kind]: [u16; 3]) -> Option<Length> {
        let key = if self.asked.get(limit).is_some() { limit } else { allowance };
        let given = self.length(limit);
        let by_allowance = self.length(allowance).and_then(|(line, allowance)| {
            let sum = nominal?.checked_add(allowance);
            if sum.is_none() {
                let reason = LengthError::TooLarge { text: self.asked.text(key).to_owned() };
                self.fail(line, AqdefFault::Number { key: Key(key).to_string(), reason }, self.asked.text(key));
            }
            Some((line, sum?))
        });
        if let (Some((_, limit)), Some((line, other))) = (given, by_allowance)
            && limit != other
        {
            self.warn(line, AqdefWarning::Allowance { limit: other });
        }
        let (line, found) = given.or(by_allowance)?;
        match self.whole(kind) {
            Some(0) => {
                self.warn(line, AqdefWarning::NoLimit { key: Key(key).to_string() });
                return None;
            }
            // A natural limit, such as 0 of a roundness, is one as well.
            Some(1 | 2) | None => {}
            Some(other) => self.warn(line, AqdefWarning::KindOfLimit { given: other.to_string() }),
        }
        Some(found)
    }

    /// What the scrap limits say: too large a hole is scrap, and too small a shaft.
    fn scrap_side(&mut self, characteristic: &Characteristic, lengths: &Lengths) -> Option<Feature> {
        let sides = [
            (lengths.lower_scrap, characteristic.minimum, Feature::Shaft),
            (lengths.upper_scrap, characteristic.maximum, Feature::Hole),
        ];
        let callout = characteristic.callout();
        let of_class = callout.and_then(|callout| callout.feature());
        for (scrap, limit, feature) in sides {
            let Some((line, scrap)) = scrap else { continue };
            if limit.is_some_and(|limit| limit != scrap) {
                self.warn(line, AqdefWarning::ScrapLimit { limit: scrap });
            }
            if let Some(callout) = callout
                && of_class.is_some_and(|of_class| of_class != feature)
            {
                self.warn(line, AqdefWarning::ScrapFeature { callout, feature });
            }
        }
        match sides.map(|(scrap, _, _)| scrap.is_some()) {
            _ if of_class.is_some() => None,
            [true, false] => Some(Feature::Shaft),
            [false, true] => Some(Feature::Hole),
            // With both, or none, anything beyond is scrap, or nobody knows.
            _ => None,
        }
    }
}

/// The class of letters and grade, else the tolerance as a text.
fn class(asked: &CharacteristicEntries<'_>) -> String {
    let class = format!("{}{}", asked.text(2103), asked.text(2104));
    let written = || Some(asked.text(2151)).filter(|text| !is_figure(text)).unwrap_or_default().to_owned();
    if class.is_empty() { written() } else { class }
}

/// Whether a text is a figure: no class begins like one.
fn is_figure(text: &str) -> bool {
    text.trim_start_matches(['+', '-', '\u{b1}']).starts_with(|sign: char| sign.is_ascii_digit() || ".,".contains(sign))
}

fn first<'a>(asked: &CharacteristicEntries<'a>, keys: &[u16]) -> Option<&'a str> {
    keys.iter().find_map(|&key| asked.get(key)).map(|(_, text)| text)
}
