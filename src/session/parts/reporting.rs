//! The part that is being measured as a report: its status, what is missing, its picture, and every value with where it is from.

use std::sync::Arc;

use jiff::civil::DateTime;

use super::{PartsPage, Sight};
use crate::journal::Record;
use crate::message::Message;
use crate::report::Report;
use crate::report::image::Image;
use crate::report::part::PartSheet;

impl PartsPage {
    /// The report; `None` before a part is begun.
    pub(in crate::session) fn report(&self, now: DateTime) -> Option<Report> {
        let plan = self.walking.plan()?;
        let mut sheet = PartSheet::new(plan, self.walking.serial());
        for at in 0..self.walking.count() {
            for value in self.walking.values(at) {
                sheet.take(at, Arc::clone(&value.record));
            }
            let reason = self.walking.walk().steps().get(at).and_then(|step| step.skipped.clone());
            if let Some(reason) = reason {
                sheet.skip(at, &reason);
            }
        }
        sheet.picture = (!plan.head.picture.is_empty()).then(|| self.image());
        let records: Vec<Arc<Record>> = sheet.records().map(Arc::clone).collect();
        let part = Some(plan.head.part.clone()).filter(|part| !part.is_empty());
        Some(Report { part, parts: vec![sheet], ..Report::new(now, records) })
    }

    /// The picture that the plan had when the part was begun, or why it is not at hand.
    fn image(&self) -> Result<Image, Message> {
        match self.walk_sight() {
            Some(Sight::Seen(picture)) => Ok(picture.file.clone()),
            Some(Sight::Refused(why)) => Err(why),
            Some(Sight::Awaited) => Err(Message::new("parts-page-picture-awaited")),
            None => Err(Message::new("parts-page-picture-none")),
        }
    }
}
