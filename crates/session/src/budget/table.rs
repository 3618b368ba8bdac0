//! The contributions as a table. Its fields write into the text, which is the budget: what is typed in one of them is
//! there at once, and every other line stays as it is.

use fitcheck_core::budget::{Basis, Budget, Evaluated, Keys, KindName, Law};
use fitcheck_core::message::{Say as _, message};

use super::{BudgetField, BudgetPage, lines};
use crate::shared::Shared;

/// How the budget is shown.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum BudgetView {
    #[default]
    Table,
    Text,
}

impl BudgetView {
    pub const ALL: [Self; 2] = [Self::Table, Self::Text];
}

/// What a contribution does to the diameter: nothing but its sensitivity, or what its kind says.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct KindChoice(pub Option<KindName>);

impl KindChoice {
    pub fn all() -> impl Iterator<Item = Self> {
        [None].into_iter().chain(KindName::ALL.map(Some)).map(Self)
    }
}

/// How the uncertainty of a normal law is given.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum GivenAs {
    Standard,
    /// With a coverage factor.
    Expanded,
}

impl GivenAs {
    pub const ALL: [Self; 2] = [Self::Standard, Self::Expanded];
}

/// The key of the step of a display.
const STEP: &str = "resolution_um";

/// What a key begins with that a kind needs.
const FIRST: [(&str, &str); 2] = [("alpha_per_k", "11.5e-6"), ("delta_k", "1.0")];

impl BudgetPage {
    /// The contribution that is open in the table.
    pub fn open_row(&self) -> Option<&lines::WrittenContribution> {
        self.rows.get(self.chosen?)
    }

    /// Whether the table shows what the text does not say any more.
    pub fn is_stale(&self) -> bool {
        let is_elsewhere = |line| self.row_at(line).is_none() && self.head_field_at(line).is_none();
        self.is_other || matches!(&self.read, Some(Err(error)) if is_elsewhere(error.place.line))
    }

    /// The field of the budget as a whole in whose line something is, by the line from 1.
    fn head_field_at(&self, line: Option<usize>) -> Option<BudgetField> {
        let line = line?.checked_sub(1)?;
        let head = lines::head(&self.document.text);
        BudgetField::OF_HEAD.into_iter().find(|(_, key)| head.line(key) == Some(line)).map(|(field, _)| field)
    }

    /// The contribution in whose lines something is, by the line from 1.
    pub fn row_at(&self, line: Option<usize>) -> Option<usize> {
        let line = line?.checked_sub(1)?;
        self.rows.iter().position(|row| row.lines.contains(&line))
    }

    /// Whether the budget has contributions that the table can change.
    pub fn has_table(&self) -> bool {
        !self.is_stale() && !matches!(&self.read, None | Some(Ok(Budget { basis: Basis::Calibrated(_), .. })))
    }

    /// The kind of a contribution.
    pub fn kind(row: &lines::WrittenContribution) -> Option<KindName> {
        KindName::ALL.into_iter().find(|kind| kind.name() == row.value("kind"))
    }

    /// The law of a contribution; a step is rectangular.
    pub fn law(row: &lines::WrittenContribution) -> Option<Law> {
        if Self::kind(row) == Some(KindName::Resolution) {
            return Some(Law::Rectangular);
        }
        Law::ALL.into_iter().find(|law| law.name() == row.value("law"))
    }

    /// How a contribution was evaluated.
    pub fn evaluated(row: &lines::WrittenContribution) -> Option<Evaluated> {
        [Evaluated::A, Evaluated::B].into_iter().find(|evaluated| evaluated.letter() == row.value("type"))
    }

    /// How its uncertainty is given, where its law is normal.
    pub fn given_as(row: &lines::WrittenContribution) -> Option<GivenAs> {
        let is_normal = Self::law(row) == Some(Law::Normal);
        let is_expanded = row.has(KindName::keys(Self::kind(row)).expanded);
        is_normal.then_some(if is_expanded { GivenAs::Expanded } else { GivenAs::Standard })
    }

    /// The key of the figure of its uncertainty.
    pub fn value_key(row: &lines::WrittenContribution) -> &'static str {
        let kind = Self::kind(row);
        let Keys { standard, expanded, half_width, .. } = *KindName::keys(kind);
        match Self::given_as(row) {
            _ if kind == Some(KindName::Resolution) => STEP,
            Some(GivenAs::Standard) => standard,
            Some(GivenAs::Expanded) => expanded,
            None => half_width,
        }
    }

    /// The key that a field of the open contribution writes; `None` where it has none.
    pub fn key_of(field: BudgetField, row: &lines::WrittenContribution) -> Option<&'static str> {
        let besides = KindName::besides(Self::kind(row));
        let of_kind = |key: &'static str| besides.contains(&key).then_some(key);
        match field {
            BudgetField::RowName => Some("name"),
            BudgetField::RowValue => Some(Self::value_key(row)),
            BudgetField::RowCoverage => (Self::given_as(row) == Some(GivenAs::Expanded)).then_some("k"),
            BudgetField::RowAlpha => of_kind("alpha_per_k"),
            BudgetField::RowDelta => of_kind("delta_k"),
            BudgetField::RowTouches => of_kind("touches"),
            BudgetField::RowStep => of_kind("step_deg"),
            BudgetField::RowSensitivity => Some("sensitivity"),
            BudgetField::RowFreedom => Some("degrees_of_freedom"),
            BudgetField::Size
            | BudgetField::Touches
            | BudgetField::Step
            | BudgetField::Day
            | BudgetField::HeadName
            | BudgetField::HeadBy => None,
        }
    }

    /// Reads the contributions of the text again.
    pub(super) fn read_rows(&mut self) {
        let read = lines::read(&self.document.text);
        let is_as_read = |rows: &[lines::WrittenContribution]| match &self.read {
            Some(Ok(Budget { basis: Basis::Contributions(all), .. })) => all.len() == rows.len(),
            _ => true,
        };
        let rows = read.filter(|rows| is_as_read(rows));
        self.is_other = rows.is_none();
        if let Some(rows) = rows {
            self.rows = rows;
        }
        self.chosen = self.chosen.filter(|row| *row < self.rows.len());
        self.fill_fields();
    }

    /// The fields of the open contribution get what the text says; one that says the same in other words stays.
    fn fill_fields(&mut self) {
        let head = lines::head(&self.document.text);
        for (field, key) in BudgetField::OF_HEAD {
            if self.texts.text(field).trim() != head.value(key) {
                self.texts.set(field, head.value(key));
            }
        }
        let Some(row) = self.open_row().cloned() else { return };
        for field in BudgetField::OF_ROW {
            let value = Self::key_of(field, &row).map_or("", |key| row.value(key));
            if literal(field, self.texts.text(field)).trim_matches('"') != value {
                self.texts.set(field, value);
            }
        }
    }

    /// What is wrong in the lines of the open contribution stands beside its field.
    pub(super) fn refuse_row(&mut self) {
        let Some(Err(error)) = &self.read else { return };
        if let Some(field) = self.head_field_at(error.place.line) {
            self.errors.insert(field, error.what.message());
            return;
        }
        let Some(row) = self.open_row() else { return };
        let Some(line) = error.place.line.and_then(|line| line.checked_sub(1)) else { return };
        let is_at = |field: &BudgetField| Self::key_of(*field, row).and_then(|key| row.line(key)) == Some(line);
        if let Some(field) = BudgetField::OF_ROW.into_iter().find(is_at) {
            self.errors.insert(field, error.what.message());
        }
    }

    pub(super) fn choose(&mut self, row: Option<usize>) {
        self.chosen = row.filter(|row| *row < self.rows.len());
        self.fill_fields();
        self.answer_anew();
    }

    /// Another text, as the table has changed it.
    fn write(&mut self, text: String) {
        self.document.text = text;
        self.read_anew();
    }

    /// Puts a value at a key of the open contribution.
    pub(super) fn put(&mut self, key: &str, value: &str) {
        if let Some(row) = self.open_row().filter(|_| !self.is_stale()) {
            let text = lines::with_value(&self.document.text, row, key, value);
            self.write(text);
        }
    }

    /// What is typed in a field of the budget as a whole stands in its text.
    pub(super) fn type_in_head(&mut self, field: BudgetField, text: String) {
        let Some(key) = field.head_key() else { return };
        let is_same = text == self.texts.text(field);
        let value = literal(field, &text);
        self.texts.set(field, text);
        if !is_same && !self.is_stale() && !self.document.text.is_empty() {
            let text = lines::with_value(&self.document.text, &lines::head(&self.document.text), key, &value);
            self.write(text);
        }
    }

    pub(super) fn type_in_row(&mut self, field: BudgetField, text: String, shared: &mut Shared) {
        let value = literal(field, &text);
        let is_same = text == self.texts.text(field);
        self.texts.set(field, text);
        let Some(row) = self.open_row().filter(|_| !is_same && !self.is_stale()) else { return };
        let Some(key) = Self::key_of(field, row) else { return };
        if value.is_empty() { self.drop_keys(&[key], shared) } else { self.put(key, &value) }
    }

    /// Removes keys of the open contribution, and says that comments went with them.
    fn drop_keys(&mut self, keys: &[&str], shared: &mut Shared) {
        let mut lost = Vec::new();
        for key in keys {
            let Some(row) = self.open_row() else { return };
            let (text, comments) = lines::without_key(&self.document.text, row, key);
            lost.extend(comments);
            self.write(text);
        }
        tell_lost(&lost, shared);
    }

    /// Adds a contribution and opens it.
    pub(super) fn add_row(&mut self, shared: &Shared) {
        if self.is_stale() {
            return;
        }
        let name = shared.words().get("budget-row-new");
        let (text, row) = lines::with_row(&self.document.text, &self.rows, &name);
        self.write(text);
        self.choose(Some(row));
    }

    /// Removes the open contribution with the comments that are about it.
    pub(super) fn remove_row(&mut self, shared: &mut Shared) {
        let Some(row) = self.open_row().filter(|_| !self.is_stale()) else { return };
        let name = row.value("name").to_owned();
        let (text, _comments) = lines::without_row(&self.document.text, row);
        self.chosen = None;
        self.write(text);
        shared.note(message!("budget-row-removed").text("name", name), Vec::new());
    }

    /// Another kind: the figure keeps its number under the key of that kind, and what the kind needs is there.
    pub(super) fn set_kind(&mut self, KindChoice(kind): KindChoice, shared: &mut Shared) {
        let Some(row) = self.open_row().filter(|_| !self.is_stale()) else { return };
        let before = Self::value_key(row);
        let old = KindName::besides(Self::kind(row));
        let was_step = Self::kind(row) == Some(KindName::Resolution);
        match kind {
            Some(kind) => self.put("kind", &lines::quoted(kind.name())),
            None => self.drop_keys(&["kind"], shared),
        }
        if was_step {
            self.put("law", &lines::quoted(Law::Rectangular.name()));
        }
        if kind == Some(KindName::Resolution) {
            self.drop_keys(&["law", "k"], shared);
        }
        let stay = KindName::besides(kind);
        let gone: Vec<&str> = old.iter().copied().filter(|key| !stay.contains(key)).collect();
        self.drop_keys(&gone, shared);
        self.move_value(before);
        for (key, first) in FIRST {
            if stay.contains(&key) && self.open_row().is_some_and(|row| !row.has(key)) {
                self.put(key, first);
            }
        }
    }

    /// Another law: the figure keeps its number.
    pub(super) fn set_law(&mut self, law: Law, shared: &mut Shared) {
        let Some(row) = self.open_row().filter(|_| !self.is_stale()) else { return };
        let before = Self::value_key(row);
        self.put("law", &lines::quoted(law.name()));
        if law != Law::Normal {
            self.drop_keys(&["k"], shared);
        }
        self.move_value(before);
    }

    /// A standard or an expanded uncertainty: the figure keeps its number.
    pub(super) fn give(&mut self, given: GivenAs, shared: &mut Shared) {
        let Some(row) = self.open_row().filter(|_| !self.is_stale()) else { return };
        let Keys { standard, expanded, .. } = *KindName::keys(Self::kind(row));
        let (from, to) = match given {
            GivenAs::Standard => (expanded, standard),
            GivenAs::Expanded => (standard, expanded),
        };
        let text = lines::with_key(&self.document.text, row, from, to);
        self.write(text);
        match given {
            GivenAs::Standard => self.drop_keys(&["k"], shared),
            GivenAs::Expanded => self.put("k", "2"),
        }
    }

    /// The figure that stood at a key stands where it has to be now.
    fn move_value(&mut self, before: &str) {
        let Some(row) = self.open_row() else { return };
        let key = Self::value_key(row);
        if key != before {
            let text = lines::with_key(&self.document.text, row, before, key);
            self.write(text);
        }
    }
}

/// What a field writes: a text in quotation marks, a number with a point; nothing where it is empty.
fn literal(field: BudgetField, text: &str) -> String {
    let text = text.trim();
    match field {
        BudgetField::RowName | BudgetField::HeadName | BudgetField::HeadBy => lines::quoted(text),
        _ if text.is_empty() => String::new(),
        _ => {
            let number = text.replace(',', ".").replace('\u{2212}', "-");
            number.strip_suffix('.').map_or_else(|| number.clone(), str::to_owned)
        }
    }
}

fn tell_lost(lost: &[String], shared: &mut Shared) {
    if !lost.is_empty() {
        shared.note(message!("budget-row-comments-removed"), Vec::new());
    }
}
