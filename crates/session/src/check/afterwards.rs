//! Hole or shaft, said after a value was found outside its limits: the value is judged again by that at once. One choice is for the value on
//! screen; another one, which says so, is for every such value of a file.

use std::sync::Arc;

use fitcheck_core::message::message;
use fitcheck_core::tolerance::Feature;
use fitcheck_exchange::journal::query::RecordId;
use fitcheck_exchange::report::text;

use super::CheckPage;
use crate::history::History;
use crate::shared::Shared;

impl CheckPage {
    /// Whether the verdict on screen waits for hole or shaft.
    pub fn is_open(&self) -> bool {
        self.shown.as_ref().is_some_and(|shown| shown.record.is_open())
    }

    /// Whether hole or shaft can be said of the value on screen, though its callout may be none.
    pub fn can_be_said(&self, history: &History) -> bool {
        self.is_open() || self.shown.as_ref().and_then(|shown| shown.id).is_some_and(|id| history.is_said(id))
    }

    /// The values of the file that wait for hole or shaft, the worst first.
    pub fn open_of_lot(&self, history: &History) -> Vec<RecordId> {
        let ids = self.lot.iter().flat_map(super::Lot::records);
        ids.filter(|id| history.replaced_by(*id).is_none() && history.get(*id).is_some_and(|record| record.is_open()))
            .collect()
    }

    /// Judges the value on screen again as a hole or a shaft, or as neither. `false` where it does not wait for that.
    pub(super) fn judge_as(&mut self, feature: Option<Feature>, shared: &mut Shared) -> bool {
        let id = self.shown.as_ref().and_then(|shown| shown.id).filter(|_| self.can_be_said(&shared.history));
        let Some(id) = id else { return false };
        if !say(&[id], feature, shared) {
            return false;
        }
        let lot = self.lot.take().map(|lot| lot.counted_again(&shared.history));
        self.clear(&shared.sources);
        self.lot = lot;
        self.show(id, shared);
        true
    }

    /// Judges every value of the file that waits for it as a hole or a shaft.
    pub(super) fn judge_all_as(&mut self, feature: Feature, shared: &mut Shared) {
        let ids = self.open_of_lot(&shared.history);
        if ids.is_empty() || !say(&ids, Some(feature), shared) {
            return;
        }
        let word = text::feature(Some(feature));
        shared.note(message!("check-judged-again").count("count", ids.len()).message("as", word), Vec::new());
        shared.note_change();
        let lot = self.lot.take().map(|lot| lot.counted_again(&shared.history));
        self.clear(&shared.sources);
        self.lot = lot;
        self.show_of_lot(shared);
    }

    /// Undo takes back that hole or shaft was said: `false` where it would take something else back.
    pub(super) fn undo_judging(&mut self, shared: &mut Shared) -> bool {
        let Some(before) = shared.history.undoes_judging().map(<[_]>::to_vec) else { return false };
        let reason = shared.recorded_words().get("records-page-undone-reason");
        if shared.recording.judge_again(&before, &reason) {
            shared.history.take_back();
        }
        let shown = self.shown.as_ref().and_then(|shown| shown.id);
        let lot = self.lot.take().map(|lot| lot.counted_again(&shared.history));
        self.clear(&shared.sources);
        self.lot = lot;
        if let Some(id) = shown.or_else(|| before.first().map(|(id, _)| *id)) {
            self.show(id, shared);
        }
        true
    }
}

/// Judges checks again as holes, shafts or neither. `false` where one of them cannot be corrected now.
fn say(ids: &[RecordId], feature: Option<Feature>, shared: &mut Shared) -> bool {
    let judged = |id: &RecordId| Some((*id, Arc::new(shared.history.get(*id)?.of_feature(feature))));
    let again = ids.iter().filter_map(judged).collect();
    let reason = shared.recorded_words().say(&message!("check-said-afterwards").message("as", text::feature(feature)));
    shared.judge_again(again, &reason)
}
