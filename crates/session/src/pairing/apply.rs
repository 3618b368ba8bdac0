//! How commands and news change the pairing page.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_core::tolerance::Feature;
use fitcheck_exchange::report::pairing::{PairingParts, PairingRequest};
use jiff::civil::DateTime;

use super::{Paired, PairingCommand, PairingField, PairingPage};
use crate::effect::Effect;
use crate::files::Content;
use crate::saved::Saved;
use crate::shared::{News, Shared};
use crate::state::PageState;
use crate::texts::Texts;

impl PageState for PairingPage {
    type Command = PairingCommand;
    type Field = PairingField;

    fn restored(saved: &Saved, shared: &Shared) -> Self {
        let mut page = Self { texts: Texts::restored(&saved.inputs.texts), ..Self::default() };
        page.read(&shared.sources);
        page
    }

    fn save(&self, saved: &mut Saved) {
        saved.inputs.texts.extend(self.texts.saved());
    }

    fn apply(&mut self, command: PairingCommand, shared: &mut Shared, _now: DateTime) -> Vec<Effect> {
        match command {
            PairingCommand::Type(field, text) => {
                self.texts.set(field, text);
                self.read(&shared.sources);
                self.ask();
            }
            PairingCommand::Read { feature, path, result } => self.take_file(feature, &path, result, shared),
            PairingCommand::TakeHistory(feature) => self.take_history(feature, shared),
            PairingCommand::NoSideFree { name } => {
                shared.tell(message!("pairing-page-no-side").text("name", name));
            }
            PairingCommand::Paired { run, paired } => self.take_answer(run, paired),
            PairingCommand::Move(step) => {
                if let Some(last) = self.count().checked_sub(1) {
                    self.go_to(step.place(self.selected, last));
                }
            }
            PairingCommand::Select(at) if at < self.count() => self.go_to(at),
            PairingCommand::Select(_) => {}
            PairingCommand::Copy => {
                let words = shared.words();
                return self.paired.iter().map(|paired| Effect::Copy(paired.copied(&words))).collect();
            }
        }
        Vec::new()
    }

    fn follow(&mut self, news: &News, shared: &mut Shared) {
        if *news == News::Sources {
            self.read(&shared.sources);
            self.ask();
        }
    }

    fn take_errands(&mut self) -> Vec<Effect> {
        std::mem::take(&mut self.errands)
    }

    fn text(&self, field: PairingField) -> &str {
        self.texts.text(field)
    }

    fn error(&self, field: PairingField) -> Option<&Message> {
        self.errors.get(&field)
    }

    fn is_free_text(&self, field: PairingField) -> bool {
        // Two points stand between two clearances.
        field == PairingField::Wanted
    }
}

impl PairingPage {
    /// How many pairs the list has.
    fn count(&self) -> usize {
        self.paired.as_ref().map_or(0, |paired| paired.count())
    }

    fn go_to(&mut self, at: usize) {
        self.selected = Some(at);
        self.look += 1;
    }

    /// A file of holes or shafts is asked for: only its answer counts from now on.
    pub(crate) fn awaits(&mut self, feature: Feature, path: PathBuf) {
        let side = self.side_mut(feature);
        side.awaited.retain(|awaited| *awaited == path);
        side.awaited.push(path);
    }

    /// What was asked for as a file is a folder: nothing else will come of it.
    pub(crate) fn is_no_file(&mut self, path: &Path) {
        for side in [&mut self.holes, &mut self.shafts] {
            side.awaited.retain(|awaited| awaited != path);
        }
    }

    /// Takes the parts of a file, unless another file or the history was taken since it was asked for.
    fn take_file(
        &mut self,
        feature: Feature,
        path: &Path,
        result: Result<Arc<PairingParts>, Message>,
        shared: &mut Shared,
    ) {
        let side = self.side_mut(feature);
        let Some(at) = side.awaited.iter().position(|awaited| awaited == path) else { return };
        side.awaited.remove(at);
        if let Some(parts) = shared.file_answered(result) {
            self.take(feature, parts);
        }
    }

    fn take_history(&mut self, feature: Feature, shared: &mut Shared) {
        let parts = PairingParts::of_records(shared.history.for_report().map(Arc::as_ref), feature);
        if parts.sizes.is_empty() {
            let are_chosen = 0 < shared.history.chosen_count();
            let id = if are_chosen { "pairing-page-none-chosen" } else { "pairing-page-none-in-history" };
            shared.tell(Message::new(id).with("feature", &feature));
            return;
        }
        let (listed, all) = (shared.history.listed().count(), shared.history.len());
        if shared.history.chosen_count() == 0 && listed < all {
            let said = message!("pairing-page-listed-only").count("listed", listed).count("all", all);
            shared.note(said.with("feature", &feature), Vec::new());
        }
        self.side_mut(feature).awaited.clear();
        self.take(feature, Arc::new(parts));
    }

    fn take(&mut self, feature: Feature, parts: Arc<PairingParts>) {
        self.side_mut(feature).parts = Some(parts);
        self.ask();
    }

    /// Asks for the pairs of what the page holds now. An answer to anything else is gone at once; while one is still being
    /// computed, this question waits for it, so that only one is computed at a time.
    pub(super) fn ask(&mut self) {
        let asked = self.asked();
        self.is_asked = asked.is_some();
        let is_answered = self.paired.as_ref().is_some_and(|paired| Some(&paired.answer.asked) == asked.as_ref());
        if is_answered {
            // What was typed meanwhile was taken back: no later answer is wanted.
            self.run += 1;
            return;
        }
        self.paired = None;
        self.selected = None;
        self.look += 1;
        self.run += 1;
        if self.at_work.is_none() {
            self.send(asked);
        }
    }

    fn send(&mut self, asked: Option<PairingRequest>) {
        if let Some(asked) = asked {
            self.at_work = Some(self.run);
            self.errands.push(Effect::Pair { run: self.run, asked: Box::new(asked) });
        }
    }

    fn take_answer(&mut self, run: u64, paired: Arc<Paired>) {
        if self.at_work != Some(run) {
            return;
        }
        self.at_work = None;
        if run == self.run {
            self.paired = Some(paired);
            self.look += 1;
        } else if self.paired.is_none() {
            // The page has moved on meanwhile.
            let asked = self.asked();
            self.send(asked);
        }
    }

    /// What the page asks now; `None` where something is missing.
    fn asked(&self) -> Option<PairingRequest> {
        let wanted = self.wanted.clone()?;
        if self.errors.contains_key(&PairingField::Groups) {
            return None;
        }
        Some(PairingRequest {
            holes: Arc::clone(self.parts(Feature::Hole)?),
            shafts: Arc::clone(self.parts(Feature::Shaft)?),
            wanted: wanted.wanted,
            fit: wanted.fit,
            group_count: self.group_count,
        })
    }

    /// The pairs as a file.
    pub(crate) fn content(&self, format: usize) -> Result<Content, Message> {
        let paired = self.paired.as_ref().ok_or_else(|| message!("pairing-page-nothing-to-save"))?;
        let format =
            fitcheck_exchange::report::pairing::FORMATS.get(format).ok_or_else(|| message!("dialog-no-path"))?;
        Ok(Content::Pairs { paired: Arc::clone(paired), format })
    }
}

/// The parts of a file, or why it has none: a file of which nothing can be used takes nobody's place.
///
/// # Errors
/// The first reason, and how many rows were refused.
pub fn usable(name: &str, parts: PairingParts) -> Result<Arc<PairingParts>, Message> {
    let first = parts.errors.first().filter(|_| parts.sizes.is_empty());
    match first {
        Some(first) => Err(message!("pairing-page-nothing-read")
            .text("name", name)
            .message("reason", first.message())
            .count("count", parts.errors.len())),
        None => Ok(Arc::new(parts)),
    }
}
