//! Hole or shaft, said after a value was found outside its limits: it is judged again by them at once, and what it was before is undone.

use std::sync::Arc;

use fitcheck_core::message::message;
use fitcheck_core::tolerance::Feature;
use fitcheck_core::verdict::Status;
use fitcheck_exchange::journal::Record;
use fitcheck_exchange::journal::query::RecordId;

use super::CheckPage;
use crate::shared::Shared;

/// Whether nobody has said hole or shaft of a value outside its limits.
fn is_open(record: &Record) -> bool {
    record.limits.feature.is_none() && record.verdict.status() == Status::OutOfLimits
}

impl CheckPage {
    /// Whether the verdict on screen waits for hole or shaft.
    pub fn is_open(&self) -> bool {
        self.shown.as_ref().is_some_and(|shown| is_open(&shown.record))
    }

    /// Judges the check on screen again as a hole or a shaft, and with it every such row of its file. `false` where the last thing that was
    /// done was not this check: an older one is corrected on the page of records.
    pub(super) fn judge_as(&mut self, feature: Feature, shared: &mut Shared) -> bool {
        let Some(id) = self.shown.as_ref().and_then(|shown| shown.id).filter(|_| self.is_open()) else { return false };
        let taken = shared.history.taken_by_undo();
        let standing: Vec<RecordId> = taken.iter().filter_map(|id| shared.history.standing(*id)).collect();
        if !taken.contains(&id) || !taken.iter().eq(&standing) {
            return false;
        }
        let before: Vec<Arc<Record>> = standing.iter().filter_map(|id| shared.history.get(*id)).collect();
        let count = before.iter().filter(|record| is_open(record)).count();
        let again: Vec<Arc<Record>> = before.iter().map(|record| judged_as(record, feature)).collect();
        let sent = shared.recording.sent_of(&standing, &again);
        let typed = self.inputs.typed(Some(id)).map(str::to_owned);
        let lot = self.lot.take();
        shared.history.take_back();
        shared.withdraw(taken, &standing);
        let first = shared.history.next();
        shared.history.add(again.clone());
        if let Some((count, why)) = shared.recording.keep_named(first, sent).refused {
            shared.tell(message!("records-page-refused").count("count", count).message("why", why));
        }
        self.clear(&shared.sources);
        self.lot = lot.map(|lot| lot.judged_again(&again, first));
        match &self.lot {
            Some(_) => {
                let word = fitcheck_exchange::report::text::feature(Some(feature));
                shared.note(message!("check-judged-again").count("count", count).message("as", word), Vec::new());
                self.show_of_lot(shared);
            }
            None => {
                typed.into_iter().for_each(|text| self.inputs.keep_typed(first, &text));
                self.show(first, shared);
            }
        }
        true
    }
}

/// The same value as that of a hole or a shaft, where it waits for that.
fn judged_as(record: &Arc<Record>, feature: Feature) -> Arc<Record> {
    if !is_open(record) {
        return Arc::clone(record);
    }
    let callout = record.callout.map(|callout| callout.of_part(Some(feature)));
    let mut limits = record.limits.clone();
    limits.feature = Some(feature);
    Arc::new(record.asked_again(callout, limits))
}
