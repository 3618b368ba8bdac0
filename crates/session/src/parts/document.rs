//! The plan that is edited, and the file that holds it.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use fitcheck_core::message::{Message, Say};
use fitcheck_core::part::{
    self, Column, Draft, DraftFeature, Finding, HeadField, Plan, PlanError, PlanFeature, Review, Spot,
};
use fitcheck_core::tolerance::Sources;

use crate::document::{Document, DocumentFile};

/// What a plan is called that no file holds yet.
const NEW: &str = "plan.toml";

/// How many changes can be taken back.
const MOST_UNDO: usize = 200;

/// What is typed into, or dragged: until it is settled it is one change.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Typing {
    Cell(usize, Column),
    /// A field of the part.
    Head(HeadField),
    /// The balloon of a feature.
    Balloon(usize),
}

/// A plan and its file.
#[derive(Debug, Clone, Default)]
pub struct PlanDocument {
    draft: Arc<Draft>,
    file: DocumentFile<Arc<Draft>>,
    /// A file that is being written with less than the plan, and what it has no place for.
    copying: Option<(PathBuf, Vec<&'static str>)>,
    /// The drafts before the changes, and those that were taken back.
    before: Vec<Arc<Draft>>,
    after: Vec<Arc<Draft>>,
    /// Those that were taken back before something is typed: they are there again where it is left.
    after_typing: Vec<Arc<Draft>>,
    /// What the last change goes on with.
    typing: Option<Typing>,
    /// What its file has that a draft has no place for.
    pub problems: Vec<PlanError>,
    /// Whether some of that was left out: its file says more than the draft until it is saved.
    has_left_out: bool,
    /// What it does not take over of its file on purpose: told when it is opened.
    remarks: Vec<Message>,
    /// How many comments its file has.
    pub comments: usize,
    review: Review,
    /// The first finding of every cell, by its place among all of them.
    by_cell: BTreeMap<(usize, Option<Column>), usize>,
    /// What is wrong with the fields of the part.
    head_errors: BTreeMap<HeadField, Message>,
    plan: Option<Arc<Plan>>,
}

impl PlanDocument {
    /// A plan that no file holds.
    pub(super) fn new(draft: Draft, sources: &Sources) -> Self {
        let draft = Arc::new(draft);
        let mut new = Self { file: DocumentFile::unnamed(Arc::clone(&draft)), ..Self::default() };
        new.show(draft, sources);
        new
    }

    /// What a file holds.
    pub(super) fn read(path: PathBuf, read: part::Document, sources: &Sources) -> Self {
        let part::Document { draft, problems, remarks, comments } = read;
        let draft = Arc::new(draft);
        let file = DocumentFile::read(path, Arc::clone(&draft));
        let remarks = remarks.iter().map(Say::message).collect();
        let mut document = Self { file, problems, remarks, comments, ..Self::default() };
        document.show(draft, sources);
        document
    }

    /// The plan as it is written.
    pub fn draft(&self) -> &Draft {
        &self.draft
    }

    /// The plan, where nothing is wrong with it and its file was read whole: what was not understood may be a feature.
    pub const fn plan(&self) -> Option<&Arc<Plan>> {
        self.plan.as_ref()
    }

    /// What is wrong with it.
    pub fn findings(&self) -> &[Finding] {
        &self.review.findings
    }

    /// What is wrong with a cell, or with a row as a whole.
    pub fn finding(&self, row: usize, column: Option<Column>) -> Option<&Finding> {
        self.review.findings.get(*self.by_cell.get(&(row, column))?)
    }

    /// Whether anything is wrong with a row.
    pub fn is_wrong(&self, row: usize) -> bool {
        self.by_cell.range((row, None)..(row + 1, None)).next().is_some()
    }

    /// What is wrong with a field of the part.
    pub fn head_error(&self, field: HeadField) -> Option<&Message> {
        self.head_errors.get(&field)
    }

    /// The feature of a row, where nothing is wrong with it.
    pub fn feature(&self, row: usize) -> Option<&PlanFeature> {
        self.review.features.get(row)?.as_ref()
    }

    /// How much is wrong: with the plan, and with its file.
    pub fn faults(&self) -> usize {
        self.review.findings.len() + self.problems.len()
    }

    /// The feature in which, or behind which, the file has something that could not be read.
    pub(super) fn row_of_problem(&self, place: usize) -> Option<usize> {
        let line = self.problems.get(place)?.place.line?;
        self.draft.rows.iter().rposition(|row| row.place.line.is_some_and(|begins| begins <= line))
    }

    /// The plan is what could be read of its file; returns what could not.
    pub(super) fn leave_out(&mut self, sources: &Sources) -> Vec<PlanError> {
        let left = std::mem::take(&mut self.problems);
        self.has_left_out |= !left.is_empty();
        self.check(sources);
        left
    }

    /// What it does not take over of its file: told once.
    pub(super) fn take_remarks(&mut self) -> Vec<Message> {
        std::mem::take(&mut self.remarks)
    }

    /// The file that it is from, or that it was saved to last.
    pub fn path(&self) -> Option<&Path> {
        self.file.path()
    }

    /// Whether there is a plan at all.
    pub fn is_empty(&self) -> bool {
        self.draft.rows.is_empty() && *self.draft == Draft::default() && self.before.is_empty()
    }

    /// Whether it is a new plan that nothing was written into: nothing is wrong with it yet.
    pub fn is_blank(&self) -> bool {
        self.path().is_none()
            && self.before.is_empty()
            && !self.draft.rows.is_empty()
            && *self.draft == Draft::of(vec![DraftFeature::default(); self.draft.rows.len()])
    }

    /// Whether a change can be taken back, and made again.
    pub fn can_undo(&self) -> (bool, bool) {
        (!self.before.is_empty(), !self.after.is_empty())
    }

    /// Makes a change, which can be taken back.
    pub(super) fn change(&mut self, sources: &Sources, change: impl FnOnce(&mut Draft)) {
        self.settle();
        self.go_on(None, sources, change);
    }

    /// Makes a change that is one with the last one, where that went into the same place.
    pub(super) fn type_into(&mut self, typing: Typing, sources: &Sources, change: impl FnOnce(&mut Draft)) {
        if self.typing != Some(typing) {
            self.settle();
        }
        self.go_on(Some(typing), sources, change);
    }

    fn go_on(&mut self, typing: Option<Typing>, sources: &Sources, change: impl FnOnce(&mut Draft)) {
        let mut draft = (*self.draft).clone();
        change(&mut draft);
        if draft == *self.draft {
            return;
        }
        if typing.is_none() || self.typing != typing {
            self.after_typing = std::mem::take(&mut self.after);
            self.before.push(Arc::clone(&self.draft));
            if MOST_UNDO < self.before.len() {
                self.before.remove(0);
            }
        }
        self.typing = typing;
        self.show(Arc::new(draft), sources);
    }

    /// Whether something is typed that is not settled.
    pub(super) const fn is_typing(&self) -> bool {
        self.typing.is_some()
    }

    /// What was typed is a change of its own from now on; typed back to what it was, it is none.
    pub(super) fn settle(&mut self) {
        if self.typing.take().is_some()
            && let Some(before) = self.before.pop_if(|before| before.says_the_same(&self.draft))
        {
            // Its texts are where its file has them.
            self.draft = before;
            self.after = std::mem::take(&mut self.after_typing);
        }
        self.after_typing.clear();
    }

    /// Takes back what was typed and is not settled.
    pub(super) fn revert(&mut self, sources: &Sources) {
        if self.typing.take().is_some()
            && let Some(before) = self.before.pop()
        {
            self.after = std::mem::take(&mut self.after_typing);
            self.show(before, sources);
        }
    }

    /// Whether what is typed begins a row, or has begun it.
    pub(super) fn begins_row(&self, row: usize) -> bool {
        let is_typed = matches!(self.typing, Some(Typing::Cell(of, _)) if of == row);
        is_typed && self.before.last().is_some_and(|before| before.rows.len() == row)
    }

    /// Takes the last change back, or makes it again; where it was made.
    pub(super) fn step(&mut self, back: bool, sources: &Sources) -> Option<Spot> {
        self.settle();
        let (from, to) = if back { (&mut self.before, &mut self.after) } else { (&mut self.after, &mut self.before) };
        let draft = from.pop()?;
        to.push(Arc::clone(&self.draft));
        let spot = first_difference(&self.draft, &draft);
        self.show(draft, sources);
        spot
    }

    /// Limits come from other sources.
    pub(super) fn check(&mut self, sources: &Sources) {
        self.show(Arc::clone(&self.draft), sources);
    }

    /// It is being written: the text of its file. CSV has the features alone.
    pub(crate) fn save(&mut self, path: &Path) -> Vec<u8> {
        let is_csv = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("csv"));
        let is_left = |field: &HeadField| self.draft.text(*field).is_some() && field.column().is_none();
        let left: Vec<_> = HeadField::ALL.into_iter().filter(|field| is_csv && is_left(field)).collect();
        if left.is_empty() {
            self.file.save(path, Arc::clone(&self.draft));
        } else {
            self.copying = Some((path.to_owned(), left.into_iter().map(HeadField::key).collect()));
        }
        if is_csv { self.draft.to_csv().into_bytes() } else { self.draft.to_toml().into_bytes() }
    }

    /// A file was written, or not; whether this plan was saved by that, as it was then.
    pub(super) fn written(&mut self, path: &Path, is_whole: bool) -> bool {
        let is_saved = self.file.written(path, is_whole);
        self.has_left_out &= !is_saved;
        is_saved
    }

    /// A file with less than the plan was written, or not: what it has no place for.
    pub(super) fn copied(&mut self, path: &Path, is_whole: bool) -> Option<Vec<&'static str>> {
        self.copying.take_if(|(copying, _)| copying == path).filter(|_| is_whole).map(|(_, left)| left)
    }

    fn show(&mut self, draft: Arc<Draft>, sources: &Sources) {
        self.draft = draft;
        self.review = Review::of(&self.draft, sources);
        self.plan = self.review.plan().filter(|_| self.problems.is_empty()).map(Arc::new);
        if self.is_blank() {
            self.review.findings.clear();
        }
        self.by_cell.clear();
        self.head_errors.clear();
        for (place, finding) in self.review.findings.iter().enumerate() {
            match finding.spot {
                Spot::Feature(row, column) => _ = self.by_cell.entry((row, column)).or_insert(place),
                Spot::Head(field) => _ = self.head_errors.entry(field).or_insert_with(|| finding.what.message()),
                Spot::Plan => {}
            }
        }
    }
}

impl Document for PlanDocument {
    fn name(&self) -> String {
        self.file.name(NEW)
    }

    fn is_unsaved(&self) -> bool {
        self.file.kept() != Some(&self.draft) || self.has_left_out
    }
}

/// The first place in which two drafts differ.
fn first_difference(one: &Draft, other: &Draft) -> Option<Spot> {
    let head = HeadField::ALL.into_iter().find(|field| one.cell(*field) != other.cell(*field));
    let rows = one.rows.len().max(other.rows.len());
    let row = || (0..rows).find(|row| one.rows.get(*row) != other.rows.get(*row));
    head.map(Spot::Head).or_else(|| {
        let row = row()?;
        let pair = one.rows.get(row).zip(other.rows.get(row)).filter(|_| one.rows.len() == other.rows.len());
        let differs = |column: &Column| pair.is_some_and(|(one, other)| one.cell(*column) != other.cell(*column));
        Some(Spot::Feature(row, Column::ALL.into_iter().find(differs)))
    })
}
