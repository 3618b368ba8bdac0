//! A value of a gauge goes where a typed one would go, as if it had been typed and Enter pressed, or is told.

use fitcheck_core::length::Length;
use fitcheck_core::message::{Message, message};
use fitcheck_exchange::exchange::gauge::Gauged;
use jiff::civil::DateTime;

use super::FromGauge;
use crate::Session;
use crate::check::CheckField;
use crate::command::Command;
use crate::effect::Effect;
use crate::field::Field;
use crate::page::Page;
use crate::parts::{PartsView, WalkField};

/// A gauge gives one value in this time at most, and after a verdict that is not good somebody looks at that for as long.
const SOON: i64 = 1_000;

impl Session {
    /// Where a value goes on the open page.
    fn field_of_values(&self) -> Option<Field> {
        match self.shared.page {
            Page::Check => Some(CheckField::Measured.into()),
            Page::Parts if self.parts.view == PartsView::Walk && self.parts.walking.asked().is_some() => {
                Some(WalkField::Value.into())
            }
            _ => None,
        }
    }

    /// The size that the open page asks for.
    pub(super) fn size_asked(&self) -> Option<Length> {
        match self.field_of_values()? {
            Field::Check(_) => self.check.asked.limits.as_ref().map(|limits| limits.nominal),
            _ => self.parts.walking.asked().map(|size| size.limits.nominal),
        }
    }

    /// Takes a value, or tells why not.
    pub(super) fn value_came(&mut self, at: usize, gauged: Gauged, now: DateTime) -> Vec<Effect> {
        let given = self.shared.as_typed(&gauged.value.to_string());
        let last = self.settings_page.gauges.comes(at, now);
        let too_soon = || is_soon(last, now).then(|| message!("gauges-too-soon"));
        let refusal = too_soon().or_else(|| self.why_not(now));
        let field = match (refusal, self.field_of_values()) {
            (None, Some(field)) => field,
            (None, None) => {
                self.pass_over(at, &given, message!("gauges-no-place"));
                return Vec::new();
            }
            (Some(why), _) => {
                self.pass_over(at, &given, why);
                return Vec::new();
            }
        };
        let Some(gauge) = self.settings_page.gauges.list.get_mut(at) else { return Vec::new() };
        gauge.unused = 0;
        let from = FromGauge { name: gauge.name().to_owned(), remarks: gauged.remarks };
        let mut effects = self.apply(field.typed(given), now);
        match field {
            Field::Check(_) => self.check.gauge = Some(from),
            _ => self.parts.gauge = Some(from),
        }
        effects.extend(self.apply(Command::Enter(field), now));
        effects
    }

    /// Why nothing is taken at the moment.
    fn why_not(&self, now: DateTime) -> Option<Message> {
        let field = self.field_of_values()?;
        let shared = &self.shared;
        let is_unread = shared.is_for_operators()
            && match field {
                Field::Check(_) => self.check.waits(),
                _ => self.parts.walking.waits(),
            };
        let is_covered = shared.dialog.is_some()
            || self.asks_for_mode()
            || self.palette.is_some()
            || shared.leaving
            || shared.columns.open().is_some()
            || shared.notices.shows_earlier
            || self.help.explains
            || self.asks_about().is_some()
            || shared.page == Page::Check && self.records().leaves_form().is_some()
            || self.closes_on_page().is_some();
        let is_asking = !self.answers().is_empty()
            || self.check.doubted().is_some() && field == CheckField::Measured.into()
            || self.parts.asks_which_plan() && field == WalkField::Value.into();
        let is_typing = match field {
            Field::Check(_) => self.check.is_being_typed(),
            _ => self.parts.gauge.is_none() && !self.text(WalkField::Value).trim().is_empty(),
        };
        if is_covered {
            Some(message!("gauges-covered"))
        } else if is_asking {
            Some(message!("gauges-asking"))
        } else if is_typing {
            Some(message!("gauges-typing"))
        } else if is_unread {
            Some(message!("gauges-unread"))
        } else {
            is_soon(self.settings_page.gauges.not_good, now).then(|| message!("gauges-not-good"))
        }
    }
}

/// Whether something happened less than a second ago. A clock that was set back keeps nobody waiting.
fn is_soon(then: Option<DateTime>, now: DateTime) -> bool {
    then.is_some_and(|then| {
        let since = now.duration_since(then).as_millis();
        (0..i128::from(SOON)).contains(&since)
    })
}
