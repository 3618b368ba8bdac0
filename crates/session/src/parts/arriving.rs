//! Values from files: those of an import, and those that a watched folder brings.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use fitcheck_core::message::{Located, Message, Say as _, message};
use fitcheck_core::part::{Plan, Size};
use fitcheck_exchange::exchange::{ByPlan, Item, Labels};
use fitcheck_exchange::journal::Record;
use fitcheck_exchange::journal::entry::{FileRole, UsedFile};

use super::PartsPage;
use super::judging::judged_by;
use super::measuring::Arriving;
use crate::notice::Notice;
use crate::recording::used;
use crate::shared::Shared;

/// What a file held.
#[derive(Debug, Default)]
pub(super) struct Arrived {
    /// Its checks.
    pub values: Vec<Arriving>,
    /// What found no feature or could not be used.
    pub problems: Vec<Message>,
    /// What is worth knowing.
    pub warnings: Vec<Message>,
    /// The serial numbers of other parts.
    pub others: BTreeSet<String>,
    /// The part that the file names, where that is not the plan's name of it and its values were taken all the same.
    pub label: Option<String>,
}

impl PartsPage {
    /// Takes what a file holds into the part that is being measured.
    pub(super) fn imported(&mut self, run: u64, name: &str, result: Result<Vec<Item>, Message>, shared: &mut Shared) {
        let Some(items) = shared.file_answered(result) else { return };
        let sha256 = shared.recording.of_file(name);
        // It was read for a part that has been ended meanwhile.
        let Some(plan) = self.walking.plan.as_ref().filter(|_| run == self.walking.run).map(Arc::clone) else {
            return shared.tell(message!("walk-page-import-late").text("name", name));
        };
        let judged = ByPlan::new(&plan).file(items);
        let found = said_of_finding(&judged);
        let arrived = self.arrive(&plan, judged, used(FileRole::Measurements, name, sha256).as_ref(), shared);
        let message = message!("walk-page-imported")
            .text("name", name)
            .count("good", arrived.values.len())
            .count("bad", arrived.problems.len());
        let is_problem = arrived.values.is_empty();
        let said = said_of_others(&arrived);
        let other_way = is_problem.then(|| message!("walk-page-file-for-check"));
        let problems = arrived.problems.iter();
        let details = other_way.iter().chain(&found).chain(problems).chain(&said).chain(&arrived.warnings);
        let unplanned = is_problem.then(|| name.to_owned());
        let details = details.cloned().collect();
        let mut notice = Notice { details, unplanned, ..Notice::of(message.clone(), is_problem) };
        shared.add_columns(&mut notice, name);
        shared.notices.push(notice);
        self.keep(arrived.values, shared);
        if !is_problem {
            let change = shared.history.last_change();
            // What could not be recorded is told after it.
            if let Some(notice) = shared.notices.of_mut(&message) {
                notice.change = change;
            }
        }
        self.stay_open();
    }

    /// What a plan made of a file, with the rule of the check page where the plan has none.
    pub(super) fn arrive(
        &mut self,
        plan: &Plan,
        items: Vec<Item>,
        file: Option<&UsedFile>,
        shared: &Shared,
    ) -> Arrived {
        let mut arrived = Arrived::default();
        let of_walk = self.walking.plan.as_ref().is_some_and(|own| **own == *plan).then_some(plan);
        if of_walk.is_some() {
            arrived.label = self.one_label(plan, &items);
            self.walking.label = self.walking.label.take().or_else(|| arrived.label.clone());
        }
        let is_one_piece = has_one_piece(&items);
        let sizes: BTreeMap<String, Size<'_>> = plan.sizes().map(|size| (size.name(), size)).collect();
        for item in items {
            match item {
                Item::Record { line, record, labels } => {
                    let size = sizes.get(&record.id);
                    let is_other = of_walk.is_some() && !is_one_piece && labels.serial.is_empty() && size.is_some();
                    let arriving = if is_other && !labels.sample.is_empty() {
                        Err(message!("walk-page-other-label").text("part", &labels.sample))
                    } else {
                        self.arriving(size, *record, labels, of_walk, shared)
                    };
                    match arriving {
                        Ok(mut value) => {
                            value.file = file.cloned();
                            if let Some(labels) = value.labels.as_deref().filter(|_| value.at.is_none())
                                && !labels.serial.is_empty()
                            {
                                arrived.others.insert(labels.serial.clone());
                            }
                            arrived.values.push(value);
                        }
                        Err(why) => {
                            let not = message!("walk-page-not-judged").text("line", line).message("why", why);
                            arrived.problems.push(not);
                        }
                    }
                }
                Item::Unjudged(unjudged) => {
                    arrived.problems.push(Located::in_line(unjudged.line, unjudged.why.clone()).message());
                }
                Item::Error(error) => arrived.problems.push(error.message()),
                Item::Warning(warning) => arrived.warnings.push(warning.message()),
                Item::Contacts(_) => {}
            }
        }
        arrived
    }

    fn arriving(
        &self,
        size: Option<&Size<'_>>,
        record: Record,
        labels: Labels,
        of_walk: Option<&Plan>,
        shared: &Shared,
    ) -> Result<Arriving, Message> {
        let size = size.ok_or_else(|| message!("walk-page-nothing-asked"))?;
        let is_own = of_walk.is_some() && (labels.serial.is_empty() || labels.serial == self.walking.serial());
        if labels.serial.is_empty() && of_walk.is_some_and(|plan| !self.is_of_label(plan, &labels.part)) {
            return Err(message!("walk-page-other-label").text("part", labels.part.trim()));
        }
        let (record, remarks) = judged_by(size, record, labels.is_corrected, shared)?;
        let at = self.walking.place_of(&record.id).filter(|_| is_own);
        Ok(Arriving {
            at,
            record: Arc::new(record),
            remarks,
            labels: Some(Box::new(labels)),
            file: None,
            remark: String::new(),
        })
    }

    /// Whether a value without a serial number is of the part that is being measured, by what its file calls that.
    fn is_of_label(&self, plan: &Plan, given: &str) -> bool {
        is_own_label(plan, self.walking.serial(), given)
            || self.walking.label.as_deref().is_some_and(|label| label.eq_ignore_ascii_case(given.trim()))
    }

    /// The one part that a file without serial numbers names, where the walk knows no other name of its part yet: several of them are
    /// several parts, and nobody says which one is measured here.
    fn one_label(&self, plan: &Plan, items: &[Item]) -> Option<String> {
        let mut labels = BTreeMap::new();
        for item in items {
            if let Item::Record { labels: Labels { part, serial, .. }, .. } = item
                && serial.is_empty()
                && !part.trim().is_empty()
            {
                labels.entry(part.trim().to_ascii_uppercase()).or_insert_with(|| part.trim());
            }
        }
        let is_new = labels.len() == 1 && self.walking.label.is_none();
        let one =
            labels.into_values().next().filter(|label| is_new && !is_own_label(plan, self.walking.serial(), label));
        one.map(str::to_owned)
    }
}

/// Whether the values of a file without serial numbers are of one part: several columns side by side are several parts.
fn has_one_piece(items: &[Item]) -> bool {
    let mut samples = items.iter().filter_map(|item| match item {
        Item::Record { labels, .. } if labels.serial.is_empty() => Some(labels.sample.as_str()),
        _ => None,
    });
    let first = samples.next();
    samples.all(|sample| Some(sample) == first)
}

/// Whether what a file calls a part is nothing, the plan's name of the part, or its serial number.
fn is_own_label(plan: &Plan, serial: &str, given: &str) -> bool {
    let given = given.trim();
    given.is_empty() || [plan.head.part.as_str(), serial].iter().any(|own| own.eq_ignore_ascii_case(given))
}

/// By what the values of a file were found, where that was not only their names.
fn said_of_finding(judged: &[Item]) -> Vec<Message> {
    use fitcheck_exchange::exchange::ImportWarningKind::{
        FoundByNumber, FoundByNumberOf, FoundByPlace, FoundByPlaceOf,
    };
    let (mut numbers, mut places) = (Vec::new(), Vec::new());
    for item in judged {
        let Item::Warning(Located { what, .. }) = item else { continue };
        let Some(line) = what.row else { continue };
        match &what.kind {
            FoundByNumber { name } | FoundByNumberOf { name, .. } => numbers.push((line, name)),
            FoundByPlace { name } | FoundByPlaceOf { name, .. } => places.push((line, name)),
            _ => {}
        }
    }
    let all = judged.iter().filter(|item| matches!(item, Item::Record { .. })).count();
    let named = all.saturating_sub(numbers.len() + places.len());
    if named == all {
        return Vec::new();
    }
    let listed = |found: &[(usize, &String)]| {
        let rows: Vec<_> = found.iter().map(|(line, name)| format!("{name} ({line})")).collect();
        rows.join(", ")
    };
    let by_name = (0 < named).then(|| message!("walk-page-found-by-name").count("count", named));
    let of = |id: &'static str, found: &[(usize, &String)]| {
        (!found.is_empty()).then(|| Message::new(id).text("rows", listed(found)))
    };
    let by_number = of("walk-page-found-by-number", &numbers);
    by_name.into_iter().chain(by_number).chain(of("walk-page-found-by-place", &places)).collect()
}

/// That the file calls the part otherwise than the plan does, and that some values are of other parts: they are recorded under their own
/// serial numbers.
pub(super) fn said_of_others(arrived: &Arrived) -> Vec<Message> {
    /// The most serial numbers that are named.
    const MOST: usize = 10;
    let label = arrived.label.as_ref().map(|label| message!("walk-page-label").text("part", label));
    if arrived.others.is_empty() {
        return label.into_iter().collect();
    }
    let named = arrived.others.iter().take(MOST).cloned().collect::<Vec<_>>().join(", ");
    let more = if MOST < arrived.others.len() { " …" } else { "" };
    let others = message!("walk-page-other-parts").text("serials", format!("{named}{more}"));
    label.into_iter().chain([others]).collect()
}
