//! From the fields to cells and columns. A built-in table is never changed: an edit makes a copy and shows that.

use super::document::{Document, Origin};
use crate::length::{Length, Unit};
use crate::message::{Message, Say as _};
use crate::session::{Field, Session};
use crate::tolerance::table::TableShapeError;
use crate::tolerance::table_edit::{MakeError, TableEdit, standard_column, standard_table};
use crate::tolerance::{DeviationTable, Deviations, Feature, ToleranceClass, iso286};

/// What the fields of the cell say, or which of them is wrong.
type Typed = Result<Option<Deviations>, (Field, Message)>;

impl Session {
    /// Whether the fields of the cell can be put into it.
    pub fn cell_is_readable(&self) -> bool {
        self.typed_cell().is_ok()
    }

    /// Both fields in micrometres; both empty is an empty cell.
    fn typed_cell(&self) -> Typed {
        let text = |field| self.inputs.text(field).trim();
        let read = |field| Length::parse_in(text(field), Unit::Micrometre).map_err(|error| (field, error.message()));
        if text(Field::CellUpper).is_empty() && text(Field::CellLower).is_empty() {
            return Ok(None);
        }
        let (upper, lower) = (read(Field::CellUpper)?, read(Field::CellLower)?);
        let order = |_| Message::new("tables-order").text("upper", self.plain(upper)).text("lower", self.plain(lower));
        Deviations::new(upper, lower).map(Some).map_err(|error| (Field::CellUpper, order(error)))
    }

    /// Micrometres with sign, as the window's language writes them.
    fn plain(&self, length: Length) -> String {
        let plus = if Length::ZERO < length { "+" } else { "" };
        let number = length.exact(Unit::Micrometre, 0).replace('-', "\u{2212}");
        format!("{plus}{}", number.replace('.', &self.language.decimal_sign().to_string()))
    }

    /// What the fields of a cell are filled with.
    fn cell_texts(&self) -> [(Field, String); 2] {
        let document = self.tables.shown();
        let cell =
            document.and_then(|document| document.selected().and_then(|(class, range)| document.cell(class, range)));
        let text = |length: Option<Length>| length.map(|length| self.plain(length)).unwrap_or_default();
        [
            (Field::CellUpper, text(cell.map(|cell| cell.upper()))),
            (Field::CellLower, text(cell.map(|cell| cell.lower()))),
        ]
    }

    /// The fields follow the selected cell.
    pub(super) fn fill_cell_fields(&mut self) {
        for (field, text) in self.cell_texts() {
            self.tables.errors.remove(&field);
            self.inputs.set(field, text);
        }
    }

    /// Says what is no number while it is typed; the order of the two counts when they are put into the cell.
    pub(super) fn check_cell_fields(&mut self) {
        for field in [Field::CellUpper, Field::CellLower] {
            let text = self.inputs.text(field).trim();
            match Length::parse_in(text, Unit::Micrometre) {
                Err(error) if !text.is_empty() => _ = self.tables.errors.insert(field, error.message()),
                _ => _ = self.tables.errors.remove(&field),
            }
        }
    }

    /// Whether something was typed that is not in the cell.
    pub(super) fn cell_is_pending(&self) -> bool {
        self.cell_texts().iter().any(|(field, text)| self.inputs.text(*field) != text)
    }

    /// Puts what was typed into the selected cell. `false` when it cannot be read: then the field says why.
    pub(in crate::session) fn settle_cell(&mut self) -> bool {
        if !self.cell_is_pending() {
            return true;
        }
        match self.typed_cell() {
            Ok(value) => self.put_into_cell(value),
            Err((field, problem)) => {
                self.tables.errors.insert(field, problem);
                return false;
            }
        }
        true
    }

    pub(super) fn put_into_cell(&mut self, value: Option<Deviations>) {
        let Some(document) = self.tables.shown() else { return };
        let Some((class, range)) = document.selected() else { return };
        if document.cell(class, range) != value {
            self.change(|edit| _ = edit.set(class, range, value));
        }
        self.fill_cell_fields();
    }

    pub(super) fn take_standard(&mut self) {
        let Some(document) = self.tables.shown() else { return };
        let standard = document.selected().and_then(|(class, range)| document.standard(class, range));
        if standard.is_some() {
            self.put_into_cell(standard);
        }
    }

    pub(super) fn step_back(&mut self, step: fn(&mut Document)) {
        if let Some(document) = self.tables.shown_mut() {
            step(document);
        }
        self.shown_changed();
    }

    /// Changes the shown table, or a copy of it where it is built in.
    fn change<T>(&mut self, change: impl FnOnce(&mut TableEdit) -> T) -> Option<T> {
        let document = self.tables.shown()?;
        if document.origin() == Origin::Shipped {
            let stem = document.title().rsplit_once('.').map_or(document.title(), |(stem, _)| stem);
            // No blank: a control's table ends its name at one.
            let copy = document.copy(self.tables.free_title(&format!("{stem}_copy.tab")));
            let Some(number) = self.tables.add(copy) else {
                self.tell(Message::new("tables-too-many").count("count", super::MOST_DOCUMENTS));
                return None;
            };
            self.tables.shown = number;
        }
        let answer = self.tables.shown_mut().map(|document| document.change(change));
        self.shown_changed();
        answer
    }

    /// The classes in their field, each once and known to ISO 286.
    fn typed_classes(&self) -> Result<Vec<ToleranceClass>, Message> {
        let text = self.inputs.text(Field::TableClasses);
        let mut classes = Vec::new();
        for word in text.split([' ', ',', ';', '/', '\t']).filter(|word| !word.is_empty()) {
            let class: ToleranceClass = word.parse().map_err(|error: crate::tolerance::ClassError| error.message())?;
            if iso286::parts(class).is_none() {
                let undefined = iso286::deviations(class, Length::MAX, self.sources.options()).err();
                return Err(undefined.map_or_else(|| Message::new("class-missing"), |undefined| undefined.message()));
            }
            if !classes.contains(&class) {
                classes.push(class);
            }
        }
        if classes.is_empty() { Err(Message::new("class-missing")) } else { Ok(classes) }
    }

    fn refuse_table(&mut self, field: Field, problem: Message) {
        self.tables.errors.insert(field, problem);
    }

    pub(super) fn add_columns(&mut self) {
        let Some(document) = self.tables.shown() else { return };
        let options = self.sources.options();
        let classes = match self.typed_classes() {
            Ok(classes) => classes,
            Err(problem) => return self.refuse_table(Field::TableClasses, problem),
        };
        let has = |class: &ToleranceClass| document.table().columns().iter().any(|column| column.class == *class);
        if let Some(&class) = classes.iter().find(|class| has(class)) {
            return self.refuse_table(Field::TableClasses, TableShapeError::Twice { class }.message());
        }
        if let Some(error) = both_features(document.table(), &classes) {
            return self.refuse_table(Field::TableClasses, error.message());
        }
        let ends = document.table().ends().to_vec();
        let first = classes.first().copied();
        self.change(|edit| {
            for class in classes {
                // Named once and not there yet, as just checked: nothing is refused.
                let _added = edit.add_column(standard_column(class, &ends, options));
            }
        });
        self.inputs.set(Field::TableClasses, String::new());
        if let Some(class) = first {
            self.inputs.set(Field::TableFilter, String::new());
            self.shown_changed();
            self.select(class, 0);
        }
    }

    pub(super) fn remove_column(&mut self) {
        let selected = self.tables.shown().and_then(Document::selected);
        if let Some((class, _)) = selected {
            self.change(|edit| _ = edit.remove_column(class));
        }
    }

    /// Makes a table from ISO 286 and shows it.
    pub(super) fn make_table(&mut self) {
        let options = self.sources.options();
        let classes = self.typed_classes();
        let to = self.inputs.text(Field::TableTo).parse::<Length>();
        let (classes, to) = match (classes, to) {
            (Err(problem), _) => return self.refuse_table(Field::TableClasses, problem),
            (_, Err(error)) => return self.refuse_table(Field::TableTo, error.message()),
            (Ok(classes), Ok(to)) => (classes, to),
        };
        let name = match classes.first().map(|class| class.feature()) {
            Some(Feature::Shaft) => "iso286_shaft.tab",
            _ => "iso286_hole.tab",
        };
        match standard_table(&self.tables.free_title(name), &classes, to, options) {
            Ok(table) => {
                self.inputs.set(Field::TableClasses, String::new());
                self.add_and_show(Document::unsaved(table, Origin::Made, options));
            }
            Err(error @ MakeError::LastSize { .. }) => self.refuse_table(Field::TableTo, error.message()),
            Err(error) => self.refuse_table(Field::TableClasses, error.message()),
        }
    }
}

/// Why classes cannot join a table: holes among shafts, or the other way round.
fn both_features(table: &DeviationTable, classes: &[ToleranceClass]) -> Option<MakeError> {
    let all = || table.columns().iter().map(|column| column.class).chain(classes.iter().copied());
    let first = |feature| all().find(|class| class.feature() == feature);
    Some(MakeError::BothFeatures { hole: first(Feature::Hole)?, shaft: first(Feature::Shaft)? })
}
