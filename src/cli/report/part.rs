//! `--plan`: the whole parts that values of files belong to.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::Arc;

use super::super::parts::PlanParts;
use super::super::{CliError, CliWarning, Io, Outcome};
use crate::exchange::Labels;
use crate::files;
use crate::journal::Record;
use crate::message::{Message, Say as _, message};
use crate::part::{Plan, Repeats};
use crate::report::image::{Image, is_plain_name};
use crate::report::part::PartSheet;
use crate::tolerance::Sources;
use crate::verdict::Status;

/// The most parts that a report shows as a whole.
const MOST: usize = 1_000;

/// Name and serial number, as the files have them.
type Key = (String, String);

/// What is known of the parts of a report.
#[derive(Debug)]
pub(super) struct ReportParts {
    pub(super) plan: Arc<Plan>,
    repeats: Repeats,
    picture: Option<Result<Image, Message>>,
    /// What all of them make of the exit code.
    all: PlanParts,
    /// The place of each size, by its name.
    places: BTreeMap<String, usize>,
    sheets: Vec<PartSheet>,
    /// The place of each part among them.
    known: BTreeMap<Key, usize>,
    /// Those that are not shown as a whole.
    others: BTreeSet<Key>,
}

impl ReportParts {
    /// By a plan, with the picture beside it.
    pub(super) fn read(path: &Path, sources: &Sources, repeats: Repeats, io: &mut Io<'_>) -> Result<Self, CliError> {
        let plan = Arc::new(super::super::plan::read_plan(path, sources, io)?);
        let name = Some(plan.head.picture.as_str()).filter(|name| !name.is_empty());
        let picture = name.map(|name| image(path, name));
        let places = plan.sizes().map(|size| size.name()).zip(0..).collect();
        let all = PlanParts::of(&plan, repeats);
        Ok(Self {
            plan,
            repeats,
            picture,
            all,
            places,
            sheets: Vec::new(),
            known: BTreeMap::new(),
            others: BTreeSet::new(),
        })
    }

    /// A value of a part.
    pub(super) fn see(&mut self, record: &Record, labels: &Labels, line: usize) {
        self.all.see(record, labels, Some(line));
        let Some(at) = self.places.get(&record.id).copied() else { return };
        let key = (labels.part.clone(), labels.piece().to_owned());
        if let Some(sheet) = self.known.get(&key).and_then(|known| self.sheets.get_mut(*known)) {
            return sheet.take(at, Arc::new(record.clone()), labels.time);
        }
        if MOST <= self.sheets.len() {
            self.others.insert(key);
            return;
        }
        let mut sheet = PartSheet::new(&self.plan, labels.piece()).by(self.repeats);
        sheet.picture.clone_from(&self.picture);
        sheet.take(at, Arc::new(record.clone()), labels.time);
        self.known.insert(key, self.sheets.len());
        self.sheets.push(sheet);
    }

    /// Whether no value was of a part.
    pub(super) const fn is_empty(&self) -> bool {
        self.sheets.is_empty()
    }

    /// A part of the plan that nobody has measured.
    pub(super) fn unmeasured(&self) -> PartSheet {
        let mut sheet = PartSheet::new(&self.plan, "");
        sheet.picture.clone_from(&self.picture);
        sheet
    }

    /// The values that contradict each other.
    pub(super) fn contradictions(&self) -> Vec<Message> {
        self.all.contradictions().map(|said| said.message()).collect()
    }

    /// Why the picture is not shown.
    pub(super) fn unseen(&self) -> Option<&Message> {
        self.picture.as_ref().and_then(|picture| picture.as_ref().err())
    }

    /// What the parts make of the exit code; a verdict of no part counts, too.
    pub(super) fn outcome(&self, of_none: Option<Status>) -> Outcome {
        self.all.outcome(of_none)
    }

    /// The parts, and a note where there are more. What is missing is told.
    pub(super) fn end(self, io: &mut Io<'_>) -> (Vec<PartSheet>, Option<Message>) {
        let is_one = self.all.count() == (1, false);
        let names: Vec<String> = self.plan.sizes().map(|size| size.name()).collect();
        for (who, walk) in self.all.each() {
            let missing: Vec<&str> = walk.missing().filter_map(|at| names.get(at)).map(String::as_str).collect();
            let names = missing.join(", ");
            if missing.is_empty() {
                continue;
            }
            io.warn(&CliWarning::missing(if is_one { String::new() } else { who }, names));
        }
        let more = self.others.len();
        let note = (0 < more).then(|| message!("report-more-parts").count("count", more).count("most", MOST));
        (self.sheets, note)
    }
}

/// The picture beside a plan.
fn image(plan: &Path, name: &str) -> Result<Image, Message> {
    if !is_plain_name(name) {
        return Err(message!("parts-page-picture-folder").text("given", name));
    }
    let bytes = files::read_file(&plan.with_file_name(name)).map_err(|error| error.message())?;
    Image::read(name, &bytes)
}
