//! From the fields to what is asked. Whatever changes, no answer stays beside what it was not made with.

use std::sync::Arc;

use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_exchange::series::{Reference, StudyKind, StudyWanted};
use fitcheck_statistics::Reason;

use super::{Study, StudyAsked, StudyCommand, StudyFile};
use crate::effect::Effect;
use crate::notice::Notice;
use crate::shared::Shared;
use crate::statistics::StatisticsField;
use crate::texts::{Range, Texts};

/// What stands between the references of several masters.
const BETWEEN: char = ';';

impl StatisticsField {
    /// The fields of a kind of study; no other one refuses an answer.
    pub fn of_study(kind: StudyKind) -> &'static [Self] {
        match kind {
            StudyKind::Type1 => &[Self::StudyLower, Self::StudyUpper, Self::StudyReference, Self::StudyResolution],
            StudyKind::Crossed | StudyKind::Nested => &[Self::StudyLower, Self::StudyUpper],
            StudyKind::Linearity => &[Self::StudyReference],
            StudyKind::Stability => &[Self::StudyLower, Self::StudyUpper, Self::StudyReference],
        }
    }

    /// Whether it is one of a study.
    pub(crate) const fn is_of_study(self) -> bool {
        matches!(self, Self::StudyLower | Self::StudyUpper | Self::StudyReference | Self::StudyResolution)
    }
}

impl Study {
    pub(in crate::statistics) fn apply(
        &mut self,
        command: StudyCommand,
        texts: &Texts<StatisticsField>,
        shared: &mut Shared,
    ) {
        match command {
            StudyCommand::Read { name, result } => {
                if let Some(file) = shared.file_answered(result) {
                    self.take(&name, file, shared);
                }
            }
            StudyCommand::SetKind(kind) => self.kind = kind,
            StudyCommand::ChooseFeature(feature) => self.feature = Some(feature),
            StudyCommand::Evaluate { all_the_same } => return self.evaluate(texts, all_the_same),
            StudyCommand::Evaluated { run, result } => {
                if self.evaluating.take_if(|of| *of == run).is_some() {
                    self.found = Some(result);
                }
                return;
            }
        }
        self.read_anew(texts);
    }

    /// Another file is there, with what is to be said of it.
    fn take(&mut self, name: &str, file: Arc<StudyFile>, shared: &mut Shared) {
        let said = message!("statistics-study-opened").text("name", name).count("count", file.values.len());
        let mut notice = Notice { details: file.notes.clone(), ..Notice::of(said, file.values.is_empty()) };
        shared.add_columns(&mut notice, name);
        shared.notices.push(notice);
        self.feature = None;
        self.file = Some(file);
    }

    /// Understands the readings anew; an answer to what was asked before is none any more.
    pub(in crate::statistics) fn read_anew(&mut self, texts: &Texts<StatisticsField>) {
        self.found = None;
        self.evaluating = None;
        self.errors.clear();
        self.read = self.asked(texts, false).map(|asked| asked.understood());
    }

    /// Asks for an answer, where the layout is confirmed.
    fn evaluate(&mut self, texts: &Texts<StatisticsField>, all_the_same: bool) {
        if !self.is_whole() || self.is_doubted() && !all_the_same {
            return;
        }
        let Some(asked) = self.asked(texts, all_the_same) else { return };
        self.runs += 1;
        self.evaluating = Some(self.runs);
        self.found = None;
        self.errands.push(Effect::EvaluateStudy { run: self.runs, asked: Box::new(asked) });
    }

    /// What is asked; a field that cannot be read says why.
    fn asked(&mut self, texts: &Texts<StatisticsField>, is_confirmed: bool) -> Option<StudyAsked> {
        let is_asked = |field| StatisticsField::of_study(self.kind).contains(&field);
        let text = |field| if is_asked(field) { texts.text(field).trim() } else { "" };
        let mm = |field, range: Range| match text(field) {
            "" => Ok(None),
            text => range.read(text).map(|length| Some(length.to_mm_f64())).map_err(|why| (field, why)),
        };
        let lower = mm(StatisticsField::StudyLower, Range::Any);
        let upper = mm(StatisticsField::StudyUpper, Range::Any);
        let resolution = mm(StatisticsField::StudyResolution, Range::AboveZero);
        let given = references(text(StatisticsField::StudyReference), self.kind);
        let given = given.map_err(|why| (StatisticsField::StudyReference, why));
        let limits = [self.taken(lower).flatten(), self.taken(upper).flatten()];
        if let [Some(lower), Some(upper)] = limits
            && upper <= lower
        {
            self.errors.insert(StatisticsField::StudyUpper, Reason::SwappedLimits.message());
        }
        let resolution = self.taken(resolution).flatten();
        let references = self.taken(given).unwrap_or_default();
        let wanted = StudyWanted { kind: self.kind, references, resolution, is_confirmed };
        let file = Arc::clone(self.file.as_ref()?);
        Some(StudyAsked { file, feature: self.feature.clone(), wanted, limits })
    }

    fn taken<T>(&mut self, read: Result<T, (StatisticsField, Message)>) -> Option<T> {
        read.map_err(|(field, why)| self.errors.insert(field, why)).ok()
    }
}

/// The references of a field: one size, or those of several masters by their names.
fn references(text: &str, kind: StudyKind) -> Result<Vec<Reference>, Message> {
    let read = |given: &str| {
        let reference = Reference::read(given).map_err(|error| error.message())?;
        // A size within the range of the other fields.
        let size = given.rsplit_once('=').map_or(given, |(_, size)| size);
        Range::Any.read(size)?;
        match (&reference.part, kind) {
            (None, StudyKind::Linearity) => Err(message!("statistics-study-reference-unnamed").text("given", given)),
            _ => Ok(reference),
        }
    };
    text.split(BETWEEN).map(str::trim).filter(|given| !given.is_empty()).map(read).collect()
}
