//! The part that is being measured as a report: its status, what is missing, its picture, and every value with where it is from.

use std::sync::Arc;

use fitcheck_core::message::{Message, message};
use fitcheck_exchange::journal::Record;
use fitcheck_exchange::journal::chain::Head;
use fitcheck_exchange::report::Report;
use fitcheck_exchange::report::image::Image;
use fitcheck_exchange::report::part::PartSheet;
use jiff::civil::DateTime;

use super::{PartsPage, PictureState};
use crate::recording::Recording;

impl PartsPage {
    /// The report; `None` before a part is begun.
    pub(crate) fn report(&self, now: DateTime) -> Option<Report> {
        let plan = self.walking.plan.as_ref()?;
        let values = (0..self.walking.count()).map(|at| self.walking.values(at));
        let values = values.map(|values| values.iter().map(|value| Arc::clone(&value.record)).collect());
        let mut sheet = PartSheet::of_walk(plan, self.walking.walk.clone(), values.collect());
        sheet.picture = (!plan.head.picture.is_empty()).then(|| self.image());
        let records: Vec<Arc<Record>> = sheet.records().map(Arc::clone).collect();
        let part = Some(plan.head.part.clone()).filter(|part| !part.is_empty());
        Some(Report { part, parts: vec![sheet], ..Report::new(now, records) })
    }

    /// The numbers in the journal of the values of a report, in its order; `None` of one that the journal does not have.
    pub(crate) fn numbers_for_report(&self, report: &Report, recording: &Recording) -> Vec<Option<u64>> {
        let values: Vec<_> = (0..self.walking.count()).flat_map(|at| self.walking.values(at)).collect();
        let number = |record: &Arc<Record>| {
            let value = values.iter().find(|value| Arc::ptr_eq(&value.record, record))?;
            value.number.or_else(|| recording.number_of(value.id?))
        };
        report.parts.iter().flat_map(PartSheet::records).map(number).collect()
    }

    /// The newest entry of the journal among its values, as far as this window wrote it.
    pub(crate) fn newest_for_report(&self, recording: &Recording) -> Option<Head> {
        let values = (0..self.walking.count()).flat_map(|at| self.walking.values(at));
        values.filter_map(|value| recording.head_of(value.id?)).max_by_key(|head| head.number)
    }

    /// The picture that the plan had when the part was begun, or why it is not at hand.
    fn image(&self) -> Result<Image, Message> {
        match self.walk_sight() {
            Some(PictureState::Seen(picture)) => Ok(picture.file.clone()),
            Some(PictureState::Refused(why)) => Err(why),
            Some(PictureState::Awaited) => Err(message!("parts-page-picture-awaited")),
            None => Err(message!("parts-page-picture-none")),
        }
    }
}
