//! From the fields to cells and columns. A built-in table is never changed: an edit makes a copy and shows that.

use fitcheck_core::length::{Length, Unit};
use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_core::tolerance::table::TableShapeError;
use fitcheck_core::tolerance::table_edit::{MakeError, TableEdit, standard_column, standard_table};
use fitcheck_core::tolerance::{DeviationTable, Deviations, Feature, ToleranceClass, iso286};

use super::{Document, Origin, TablesField, TablesPage};
use crate::shared::Shared;
use crate::state::PageState as _;

/// What the fields of the cell contain, or which of them is wrong.
type Typed = Result<Option<Deviations>, (TablesField, Message)>;

impl TablesPage {
    /// Whether the fields of the cell can be put into it.
    pub fn cell_is_readable(&self) -> bool {
        // The sign matters only for the text of an error, which is not read here.
        self.typed_cell('.').is_ok()
    }

    /// Both fields in micrometres; two empty fields are an empty cell.
    fn typed_cell(&self, sign: char) -> Typed {
        let text = |field| self.text(field).trim();
        let read = |field| Length::parse_in(text(field), Unit::Micrometre).map_err(|error| (field, error.message()));
        if text(TablesField::CellUpper).is_empty() && text(TablesField::CellLower).is_empty() {
            return Ok(None);
        }
        let upper = read(TablesField::CellUpper)?;
        let lower = read(TablesField::CellLower)?;
        let plain = |length| plain(length, sign);
        let order = |_| message!("tables-order").text("upper", plain(upper)).text("lower", plain(lower));
        Deviations::new(upper, lower).map(Some).map_err(|error| (TablesField::CellUpper, order(error)))
    }

    /// What the fields of a cell are filled with.
    fn cell_texts(&self, sign: char) -> [(TablesField, String); 2] {
        let document = self.shown();
        let cell =
            document.and_then(|document| document.selected.and_then(|(class, range)| document.cell(class, range)));
        // The fields of an empty cell are empty.
        let text = |length: Option<Length>| length.map_or_else(String::new, |length| plain(length, sign));
        [
            (TablesField::CellUpper, text(cell.map(|cell| cell.upper()))),
            (TablesField::CellLower, text(cell.map(|cell| cell.lower()))),
        ]
    }

    /// The fields follow the selected cell.
    pub(super) fn fill_cell_fields(&mut self, shared: &Shared) {
        for (field, text) in self.cell_texts(shared.decimal_sign()) {
            self.errors.remove(&field);
            self.texts.set(field, text);
        }
    }

    /// Reports what is not a number while it is typed; the order of the two is checked when the cell is set.
    pub(super) fn check_cell_fields(&mut self) {
        for field in [TablesField::CellUpper, TablesField::CellLower] {
            let text = self.text(field).trim();
            match Length::parse_in(text, Unit::Micrometre) {
                Err(error) if !text.is_empty() => _ = self.errors.insert(field, error.message()),
                _ => _ = self.errors.remove(&field),
            }
        }
    }

    /// Whether something was typed that is not in the cell.
    pub(super) fn cell_is_pending(&self, shared: &Shared) -> bool {
        self.cell_texts(shared.decimal_sign()).iter().any(|(field, text)| self.text(*field) != text)
    }

    /// Puts what was typed into the selected cell. `false` when it cannot be read: then the field shows why.
    pub(crate) fn settle_cell(&mut self, shared: &mut Shared) -> bool {
        if !self.cell_is_pending(shared) {
            return true;
        }
        match self.typed_cell(shared.decimal_sign()) {
            Ok(value) => self.put_into_cell(value, shared),
            Err((field, problem)) => {
                self.errors.insert(field, problem);
                return false;
            }
        }
        true
    }

    pub(super) fn put_into_cell(&mut self, value: Option<Deviations>, shared: &mut Shared) {
        let Some(document) = self.shown() else { return };
        let Some((class, range)) = document.selected else { return };
        if document.cell(class, range) != value {
            self.change(shared, |edit| _ = edit.set(class, range, value));
        }
        self.fill_cell_fields(shared);
    }

    pub(super) fn take_standard(&mut self, shared: &mut Shared) {
        let Some(document) = self.shown() else { return };
        let standard = document.selected.and_then(|(class, range)| document.standard(class, range));
        if standard.is_some() {
            self.put_into_cell(standard, shared);
        }
    }

    pub(super) fn step_back(&mut self, step: fn(&mut Document), shared: &Shared) {
        if let Some(document) = self.shown_mut() {
            step(document);
        }
        self.shown_changed(shared);
    }

    /// Changes the shown table, or a copy of it where it is built in.
    fn change<T>(&mut self, shared: &mut Shared, change: impl FnOnce(&mut TableEdit) -> T) -> Option<T> {
        let document = self.shown()?;
        if document.origin == Origin::Shipped {
            let stem = document.title.rsplit_once('.').map_or(document.title.as_str(), |(stem, _)| stem);
            // No blank: in a control's table a blank ends the name.
            let copy = document.copy(self.free_title(&format!("{stem}_copy.tab")));
            let Some(number) = self.add(copy) else {
                shared.tell(message!("tables-too-many").count("count", super::MOST_DOCUMENTS));
                return None;
            };
            self.shown = number;
        }
        let answer = self.shown_mut().map(|document| document.change(change));
        self.shown_changed(shared);
        answer
    }

    /// The classes in their field, each once and known to ISO 286.
    fn typed_classes(&self, options: iso286::Options) -> Result<Vec<ToleranceClass>, Message> {
        let text = self.text(TablesField::Classes);
        let mut classes = Vec::new();
        for word in text.split([' ', ',', ';', '/', '\t']).filter(|word| !word.is_empty()) {
            let class: ToleranceClass =
                word.parse().map_err(|error: fitcheck_core::tolerance::ClassError| error.message())?;
            if iso286::parts(class).is_none() {
                let undefined = iso286::deviations(class, Length::MAX, options).err();
                return Err(undefined.map_or_else(|| message!("class-missing"), |undefined| undefined.message()));
            }
            if !classes.contains(&class) {
                classes.push(class);
            }
        }
        if classes.is_empty() { Err(message!("class-missing")) } else { Ok(classes) }
    }

    fn refuse_table(&mut self, field: TablesField, problem: Message) {
        self.errors.insert(field, problem);
    }

    pub(super) fn add_columns(&mut self, shared: &mut Shared) {
        let Some(document) = self.shown() else { return };
        let options = shared.sources.options();
        let classes = match self.typed_classes(options) {
            Ok(classes) => classes,
            Err(problem) => return self.refuse_table(TablesField::Classes, problem),
        };
        let has = |class: &ToleranceClass| document.table().columns().iter().any(|column| column.class == *class);
        if let Some(&class) = classes.iter().find(|class| has(class)) {
            return self.refuse_table(TablesField::Classes, TableShapeError::Twice { class }.message());
        }
        if let Some(error) = both_features(document.table(), &classes) {
            return self.refuse_table(TablesField::Classes, error.message());
        }
        let ends = document.table().ends().to_vec();
        let first = classes.first().copied();
        self.change(shared, |edit| {
            for class in classes {
                // Each class is named once and new, as just checked: none is refused.
                let _added = edit.add_column(standard_column(class, &ends, options));
            }
        });
        self.texts.set(TablesField::Classes, "");
        if let Some(class) = first {
            self.texts.set(TablesField::Filter, "");
            self.shown_changed(shared);
            self.select(class, 0, shared);
        }
    }

    pub(super) fn remove_column(&mut self, shared: &mut Shared) {
        let selected = self.shown().and_then(|document| document.selected);
        if let Some((class, _)) = selected {
            self.change(shared, |edit| _ = edit.remove_column(class));
        }
    }

    /// Makes a table from ISO 286 and shows it.
    pub(super) fn make_table(&mut self, shared: &mut Shared) {
        let options = shared.sources.options();
        let classes = self.typed_classes(options);
        let to = self.text(TablesField::To).parse::<Length>();
        let (classes, to) = match (classes, to) {
            (Err(problem), _) => return self.refuse_table(TablesField::Classes, problem),
            (_, Err(error)) => return self.refuse_table(TablesField::To, error.message()),
            (Ok(classes), Ok(to)) => (classes, to),
        };
        let name = match classes.first().map(|class| class.feature()) {
            Some(Feature::Shaft) => "iso286_shaft.tab",
            _ => "iso286_hole.tab",
        };
        match standard_table(&self.free_title(name), &classes, to, options) {
            Ok(table) => {
                self.texts.set(TablesField::Classes, "");
                self.add_and_show(Document::unsaved(table, Origin::Made, options), shared);
            }
            Err(error @ MakeError::LastSize { .. }) => self.refuse_table(TablesField::To, error.message()),
            Err(error) => self.refuse_table(TablesField::Classes, error.message()),
        }
    }
}

/// Micrometres with sign, as the window writes them.
fn plain(length: Length, sign: char) -> String {
    let plus = if Length::ZERO < length { "+" } else { "" };
    let number = length.exact(Unit::Micrometre, 0).replace('-', "\u{2212}");
    format!("{plus}{}", number.replace('.', &sign.to_string()))
}

/// Why classes cannot join a table: holes among shafts, or the other way round.
fn both_features(table: &DeviationTable, classes: &[ToleranceClass]) -> Option<MakeError> {
    let all = || table.columns().iter().map(|column| column.class).chain(classes.iter().copied());
    let first = |feature| all().find(|class| class.feature() == feature);
    Some(MakeError::BothFeatures { hole: first(Feature::Hole)?, shaft: first(Feature::Shaft)? })
}
