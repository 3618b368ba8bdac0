//! Texts that may not mean what they say: deviations in micrometres, temperatures in degrees Fahrenheit. They are asked about before
//! anything is judged, and each is judged as it stands only after somebody said that this very text is meant.

use std::collections::BTreeSet;

use fitcheck_core::message::{Message, Say as _};
use fitcheck_core::tolerance::fit::thermal::{Temperature, ThermalDoubt};
use fitcheck_core::tolerance::{Callout, CalloutError, CalloutErrorKind, ZoneDoubt};

use super::CheckField;
use crate::texts::Texts;

/// A text that is asked about.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DoubtedText {
    pub field: CheckField,
    /// The text, as it was understood.
    pub text: String,
    /// What is strange about it.
    pub why: Message,
    /// What was probably meant.
    pub meant: Option<String>,
    /// Whether it can be taken as it stands.
    pub can_stay: bool,
}

impl DoubtedText {
    /// A callout with a zone out of all proportion.
    pub(super) fn zone(callout: &Callout, doubt: &ZoneDoubt) -> Self {
        let text = callout.to_string();
        let meant = doubt.meant().map(ToString::to_string);
        Self { field: CheckField::Callout, text, why: doubt.message(), meant, can_stay: true }
    }

    /// A text that is no callout, and would be one with micrometres.
    pub(super) fn callout(text: &str, error: &CalloutError) -> Option<Self> {
        let CalloutErrorKind::MicrometresMeant { offer, .. } = &error.kind else { return None };
        let text = text.trim().to_owned();
        let meant = Some(offer.to_string());
        Some(Self { field: CheckField::Callout, text, why: error.message(), meant, can_stay: false })
    }

    /// The first temperature that is not one of a workshop, unless it is meant.
    pub(super) fn temperature(texts: &Texts<CheckField>, meant: &Meant) -> Option<Self> {
        [CheckField::PartTemperature, CheckField::ScaleTemperature].into_iter().find_map(|field| {
            let given: Temperature = texts.text(field).parse().ok()?;
            let text = given.to_string();
            let doubt = ThermalDoubt::of_measured(given).filter(|_| !meant.has(field, &text))?;
            let meant = doubt.meant().map(|meant| meant.to_string());
            Some(Self { field, text, why: doubt.message(), meant, can_stay: true })
        })
    }
}

/// The texts that somebody said are meant.
#[derive(Debug, Clone, Default)]
pub(super) struct Meant(BTreeSet<(CheckField, String)>);

impl Meant {
    pub(super) fn has(&self, field: CheckField, text: &str) -> bool {
        self.0.contains(&(field, text.to_owned()))
    }

    /// Takes a text as it stands from now on.
    pub(super) fn add(&mut self, doubted: &DoubtedText) {
        self.0.insert((doubted.field, doubted.text.clone()));
    }
}
