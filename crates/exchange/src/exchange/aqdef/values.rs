//! A value with what is said of it, judged.

use std::sync::Arc;

use fitcheck_core::length::{Length, LengthError};
use fitcheck_core::probing::Origin;
use jiff::civil::DateTime;

use super::dates;
use super::declared::Declared;
use super::error::{AqdefFault, AqdefWarning};
use super::keys::Key;
use super::reader::Reader;
use super::row::Fields;
use super::unit::FileUnit;
use crate::exchange::Labels;
use crate::exchange::characteristic::{CharacteristicKind, Value};
use crate::exchange::error::{ImportErrorKind, ImportWarningKind};
use crate::exchange::given::shorten;
use crate::exchange::imported::{Unjudged, WhyUnjudged};

/// What our own files say in words of a value that was brought to 20 °C.
pub(in crate::exchange) const CORRECTED: &str = "corrected to 20 °C";

/// Attributes of a value that is none.
const NO_VALUE: [u32; 2] = [255, 256];

impl Reader<'_, '_> {
    pub(super) fn judge(&mut self, number: u32, fields: Fields) {
        let line = fields.line;
        // Values of characteristics that are not declared are refused when they are read.
        let Some(declared) = self.declared(number) else { return };
        if !fields.is_value() {
            return self.told.warn(line, AqdefWarning::Late { key: fields.first().to_string() }.into());
        }
        match &fields.cut_off {
            Some((Key(4), given)) => self.told.warn_of(line, AqdefWarning::CutOff { given: given.clone() }.into()),
            Some((_, given)) => {
                let given = given.clone();
                return self.told.refuse(line, AqdefFault::CutOff { given: given.clone() }.into(), &given);
            }
            None => {}
        }
        if let Some(given) = &fields.doubt {
            let given = given.clone();
            return self.told.refuse(line, AqdefFault::MarkBetween { given: given.clone() }.into(), &given);
        }
        let counted = if fields.is_counted() { Some(1) } else { None };
        if let Some(kind) = declared.kind.filter(|&kind| kind != 0).or(counted) {
            return self.set_aside(&declared, fields, None, WhyUnjudged::Kind { kind });
        }
        let attribute = fields.attribute.trim();
        let marked = super::keys::number(attribute);
        if fields.value.is_empty() || marked.is_some_and(|marked| NO_VALUE.contains(&marked)) {
            return self.told.missing(line);
        }
        if let Some(declaration) = declared.fault {
            let unit = declared.unit.as_ref().ok();
            let measured = unit.and_then(|&unit| self.measured(line, &fields.value, unit).ok());
            return self.set_aside(&declared, fields, measured, WhyUnjudged::Declaration { declaration });
        }
        if let Some(declaration) = declared.unit_assumed {
            self.told.unit_assumed(declaration);
        }
        let unit = match (&declared.unit, &declared.characteristic.what) {
            (Ok(unit), _) => *unit,
            (Err(_), CharacteristicKind::Quantity(quantity)) => {
                let why = WhyUnjudged::Quantity { quantity: *quantity };
                return self.set_aside(&declared, fields, None, why);
            }
            (Err(unit), _) => {
                let kind = ImportErrorKind::Unit { unit: unit.clone() };
                return self.told.refuse(line, kind, &fields.value);
            }
        };
        match self.measured(line, &fields.value, unit) {
            Ok(measured) if attribute.is_empty() || marked == Some(0) => {
                let time = self.time(line, &fields.date);
                let labels = labels(&declared, fields);
                let value = Value { line, measured, time, labels, is_simulated: false };
                declared.characteristic.judge(value, &self.context, self.told.sink);
            }
            // What another mark means is not known, so the value may be none.
            Ok(measured) => {
                let why = WhyUnjudged::Attribute { given: shorten(attribute) };
                self.set_aside(&declared, fields, Some(measured), why);
            }
            Err(reason) => self.told.refuse(line, ImportErrorKind::Measured(reason), &fields.value),
        }
    }

    fn measured(&mut self, line: usize, text: &str, unit: FileUnit) -> Result<Length, LengthError> {
        let (measured, is_rounded) = unit.parse(text)?;
        if is_rounded {
            self.told.rounded(line);
        }
        Ok(measured)
    }

    /// When it was measured; a date that cannot be read, and one that is missing among others, is told.
    fn time(&mut self, line: usize, text: &str) -> Option<DateTime> {
        if text.is_empty() {
            if self.has_times {
                self.told.warn_of(line, ImportWarningKind::NoTime);
            }
            return None;
        }
        self.has_times = true;
        let found = dates::date_time(text);
        let without_offset = || dates::date_time(dates::without_offset(text)?);
        match found.or_else(without_offset) {
            None => self.told.warn_of(line, ImportWarningKind::Time { given: shorten(text) }),
            Some(_) if found.is_none() => {
                self.told.warn_of(line, ImportWarningKind::Offset { given: shorten(text) });
            }
            Some(_) => {}
        }
        found.or_else(without_offset)
    }

    fn set_aside(&mut self, declared: &Declared, fields: Fields, measured: Option<Length>, why: WhyUnjudged) {
        let line = fields.line;
        let time = self.time(line, &fields.date).unwrap_or(self.context.now);
        let labels = labels(declared, fields);
        let id = declared.characteristic.id();
        let origin = Origin::Imported { file: Arc::clone(&self.context.file) };
        let position = None;
        let asked = declared.characteristic.said();
        let correction = None;
        let unjudged = Unjudged { line, id, labels, time, measured, origin, position, asked, correction, why };
        self.told.sink.set_aside(unjudged);
    }
}

/// What the file says of the value besides.
fn labels(declared: &Declared, fields: Fields) -> Labels {
    let labels = declared.characteristic.labels.clone();
    let who = if fields.who.is_empty() { labels.who } else { fields.who };
    // This sign marks a batch that is a text.
    let batch = fields.batch.strip_prefix('#').map_or(fields.batch.as_str(), str::trim).to_owned();
    let is_corrected = fields.text.contains(CORRECTED);
    Labels { who, batch, serial: fields.serial, machine: fields.machine, gauge: fields.gauge, is_corrected, ..labels }
}
