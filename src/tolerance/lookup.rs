//! The lookup that program 82551 does (LBL 1 to LBL 99): from a callout to limits.

use std::sync::Arc;

use super::callout::Callout;
use super::class::{Feature, ToleranceClass};
use super::limits::{Deviations, Limits, Source};
use super::table::{Column, DeviationTable};
use crate::length::Length;
use crate::words::{Message, Say};

/// The tables that limits are looked up in: the user's own first, then the shipped ones.
///
/// A table that holds the class and reaches to the size answers, also with "not defined here"; a class or a size that
/// it does not have is looked up in the next table. A user's table with the name of a shipped one takes its place.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Tables {
    /// In the order of asking.
    tables: Vec<Arc<DeviationTable>>,
    /// The shipped tables, also where one was replaced: to tell where a user's cell differs.
    shipped: Vec<Arc<DeviationTable>>,
}

/// Why a callout has no limits.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum LimitsError {
    /// No table has the class.
    #[error("{}", unknown_class(*.class, .table, .known, *.other_case))]
    UnknownClass {
        /// The class that was asked for.
        class: ToleranceClass,
        /// The tables for this kind of feature, by name.
        table: String,
        /// The classes that there are for this kind of feature.
        known: Vec<ToleranceClass>,
        /// The class of the other case, where a table has it: the user may have meant that.
        other_case: Option<ToleranceClass>,
    },
    /// The size is beyond the table's last range.
    #[error(
        "nominal size {nominal} mm is beyond table {table}, whose last range is over {over} up to and including {to} mm"
    )]
    BeyondLastRange {
        /// The size that was asked for.
        nominal: Length,
        /// The table.
        table: Arc<str>,
        /// The last range: above this,
        over: Length,
        /// up to and including this.
        to: Length,
    },
    /// The table's cell is empty.
    #[error("{class} is not defined over {over} up to {to} mm in table {table}; {}", where_defined(.defined))]
    NotDefined {
        /// The class that was asked for.
        class: ToleranceClass,
        /// The table.
        table: Arc<str>,
        /// The range: above this,
        over: Length,
        /// up to and including this.
        to: Length,
        /// Where the class is defined, above and up to: joined ranges, ascending.
        defined: Vec<(Length, Length)>,
    },
    /// The callout asks for no single tolerance class.
    #[error("{callout} has no single tolerance class to look up")]
    NoClass {
        /// What was asked for.
        callout: Callout,
    },
    /// A limit would be beyond what a length can hold.
    #[error("the limits of {nominal} mm are too large")]
    TooLarge {
        /// The size that was asked for.
        nominal: Length,
    },
}

impl Say for LimitsError {
    fn message(&self) -> Message {
        match self {
            Self::UnknownClass { class, table, other_case: Some(other), .. } => {
                let id = match class.feature() {
                    Feature::Hole => "limits-hole-class",
                    Feature::Shaft => "limits-shaft-class",
                };
                Message::new(id).text("class", class).text("table", table).text("other", other)
            }
            Self::UnknownClass { class, table, known, .. } => {
                let known: Vec<&str> = known.iter().map(ToleranceClass::as_str).collect();
                let message = Message::new("limits-unknown-class").text("class", class).text("table", table);
                message.text("known", known.join(" "))
            }
            Self::BeyondLastRange { nominal, table, over, to } => Message::new("limits-beyond-last-range")
                .mm("nominal", *nominal)
                .text("table", table)
                .mm("over", *over)
                .mm("to", *to),
            Self::NotDefined { class, table, over, to, defined } => Message::new("limits-not-defined")
                .text("class", class)
                .text("table", table)
                .mm("over", *over)
                .mm("to", *to)
                .message("where", where_defined_message(defined)),
            Self::NoClass { callout } => Message::new("limits-no-class").text("callout", callout),
            Self::TooLarge { nominal } => Message::new("limits-too-large").mm("nominal", *nominal),
        }
    }
}

fn where_defined_message(ranges: &[(Length, Length)]) -> Message {
    match ranges {
        [] => Message::new("limits-defined-nowhere"),
        _ => Message::new("limits-defined").message("ranges", ranges_message(ranges)),
    }
}

/// The ranges one after the other; halved each time, so that many ranges do not nest deeply.
fn ranges_message(ranges: &[(Length, Length)]) -> Message {
    if let Some((first @ [_, ..], rest)) = ranges.split_at_checked(ranges.len() / 2) {
        let ranges = Message::new("limits-ranges").message("first", ranges_message(first));
        return ranges.message("rest", ranges_message(rest));
    }
    let (over, to) = ranges.first().copied().unwrap_or_default();
    Message::new("limits-range").mm("over", over).mm("to", to)
}

fn unknown_class(
    class: ToleranceClass,
    table: &str,
    known: &[ToleranceClass],
    other_case: Option<ToleranceClass>,
) -> String {
    let feature = class.feature();
    if let Some(other) = other_case {
        return format!(
            "{class} is a {feature} class and table {table} does not have it; the {} class is {other}",
            feature.other()
        );
    }
    let known: Vec<&str> = known.iter().map(ToleranceClass::as_str).collect();
    format!("{class} is not in table {table}; it has {}", known.join(" "))
}

fn where_defined(ranges: &[(Length, Length)]) -> String {
    if ranges.is_empty() {
        return "it is defined nowhere".to_owned();
    }
    let ranges: Vec<String> = ranges.iter().map(|(over, to)| format!("over {over} up to {to} mm")).collect();
    format!("it is defined {}", ranges.join(", "))
}

impl Tables {
    /// Tables from the shipped ones alone.
    pub fn shipped(tables: Vec<DeviationTable>) -> Self {
        let shipped: Vec<_> = tables.into_iter().map(Arc::new).collect();
        Self { tables: shipped.clone(), shipped }
    }

    /// The same with a user's own tables: asked first; one with a shipped table's name takes its place.
    #[must_use]
    pub fn with_own(&self, own: Vec<DeviationTable>) -> Self {
        let mut tables: Vec<_> = own.into_iter().map(Arc::new).collect();
        let kept = self.shipped.iter().filter(|shipped| !tables.iter().any(|own| same_name(own, shipped)));
        let kept: Vec<_> = kept.cloned().collect();
        tables.extend(kept);
        Self { tables, shipped: self.shipped.clone() }
    }

    /// All tables in the order of asking.
    pub fn iter(&self) -> impl Iterator<Item = &DeviationTable> {
        self.tables.iter().map(AsRef::as_ref)
    }

    /// The classes for holes or for shafts, each once, in the tables' order.
    pub fn classes(&self, feature: Feature) -> Vec<ToleranceClass> {
        let mut classes = Vec::new();
        for column in self.tables.iter().flat_map(|table| table.columns()) {
            if column.class.feature() == feature && !classes.contains(&column.class) {
                classes.push(column.class);
            }
        }
        classes
    }

    /// The limits of a callout: first range whose end is not below the nominal size, as LBL 11 of program 82551.
    ///
    /// # Errors
    /// [`LimitsError`] names what is missing and what there is instead; nothing is clamped.
    pub fn limits(&self, callout: &Callout) -> Result<Limits, LimitsError> {
        let Some(class) = callout.class() else { return Err(LimitsError::NoClass { callout: *callout }) };
        let mut beyond = None;
        for table in &self.tables {
            let Some(column) = table.column(class) else { continue };
            let Some((number, over, to)) = table.range(callout.nominal()) else {
                beyond.get_or_insert(table);
                continue;
            };
            let Some(deviations) = column.cells.get(number).copied().flatten() else {
                let name = Arc::clone(&table.name);
                return Err(LimitsError::NotDefined {
                    class,
                    table: name,
                    over,
                    to,
                    defined: defined_ranges(table, column),
                });
            };
            let instead_of = self.instead_of(table, callout, deviations);
            let source =
                Source::Table { name: Arc::clone(&table.name), shipped: table.shipped(), over, to, instead_of };
            return Limits::new(class.feature(), callout.nominal(), deviations, source)
                .ok_or(LimitsError::TooLarge { nominal: callout.nominal() });
        }
        match beyond {
            Some(table) => Err(LimitsError::BeyondLastRange {
                nominal: callout.nominal(),
                table: Arc::clone(&table.name),
                over: table.last_over(),
                to: table.last_end(),
            }),
            None => Err(self.unknown(class)),
        }
    }

    fn instead_of(&self, table: &DeviationTable, callout: &Callout, deviations: Deviations) -> Option<Deviations> {
        if table.shipped() {
            return None;
        }
        self.shipped.iter().find_map(|shipped| shipped.deviations(callout)).filter(|shipped| *shipped != deviations)
    }

    fn unknown(&self, class: ToleranceClass) -> LimitsError {
        let feature = class.feature();
        let has = |table: &DeviationTable| table.columns().iter().any(|column| column.class.feature() == feature);
        let names: Vec<&str> = self.iter().filter(|table| has(table)).map(DeviationTable::name).collect();
        let other = class.other_case();
        let other_case = self.tables.iter().any(|table| table.column(other).is_some()).then_some(other);
        LimitsError::UnknownClass { class, table: names.join(", "), known: self.classes(feature), other_case }
    }
}

fn same_name(one: &DeviationTable, other: &DeviationTable) -> bool {
    one.name.eq_ignore_ascii_case(&other.name)
}

/// The ranges where a column has values, neighbours joined.
fn defined_ranges(table: &DeviationTable, column: &Column) -> Vec<(Length, Length)> {
    let mut ranges: Vec<(Length, Length)> = Vec::new();
    let mut over = Length::ZERO;
    for (&to, cell) in table.ends.iter().zip(&column.cells) {
        match ranges.last_mut() {
            Some(last) if cell.is_some() && last.1 == over => last.1 = to,
            _ if cell.is_some() => ranges.push((over, to)),
            _ => {}
        }
        over = to;
    }
    ranges
}

#[cfg(test)]
mod tests {
    use std::fmt;

    use super::super::table::TableShapeError;
    use super::*;

    fn mm(text: &str) -> Length {
        text.parse().unwrap()
    }

    fn pair(upper: i32, lower: i32) -> Option<Deviations> {
        Deviations::new(Length::from_micrometres(upper), Length::from_micrometres(lower)).ok()
    }

    fn table(name: &str, shipped: bool, columns: &[(&str, &[Option<Deviations>])]) -> DeviationTable {
        let columns =
            columns.iter().map(|(class, cells)| Column { class: class.parse().unwrap(), cells: cells.to_vec() });
        DeviationTable::new(name, shipped, vec![mm("1"), mm("3"), mm("6")], columns.collect()).unwrap()
    }

    fn shipped() -> Tables {
        Tables::shipped(vec![
            table(
                "hole.tab",
                true,
                &[("H7", &[pair(10, 0), pair(10, 0), pair(12, 0)]), ("N9", &[None, pair(-4, -29), pair(0, -30)])],
            ),
            table("shaft.tab", true, &[("h7", &[pair(0, -10), pair(0, -10), pair(0, -12)]), ("g6", &[None; 3])]),
        ])
    }

    #[track_caller]
    fn check(tables: &Tables, callout: &str, expected: &str) {
        let said = match tables.limits(&callout.parse().unwrap()) {
            Ok(limits) => format!("{} to {} from {}", limits.minimum(), limits.maximum(), limits.source),
            Err(error) => error.to_string(),
        };
        assert_eq!(said, expected, "for {callout}");
    }

    #[test]
    fn a_range_end_belongs_to_the_range() {
        check(&shipped(), "3 H7", "3 to 3.01 from ISO 286 table hole.tab, over 1 up to 3 mm");
        check(&shipped(), "3.000001 H7", "3.000001 to 3.012001 from ISO 286 table hole.tab, over 3 up to 6 mm");
        check(&shipped(), "6 h7", "5.988 to 6 from ISO 286 table shaft.tab, over 3 up to 6 mm");
    }

    #[test]
    fn refusals_tell_the_way_out() {
        let tables = shipped();
        check(
            &tables,
            "6.000001 H7",
            "nominal size 6.000001 mm is beyond table hole.tab, whose last range is over 3 up to and including 6 mm",
        );
        check(&tables, "5 G6", "G6 is a hole class and table hole.tab does not have it; the shaft class is g6");
        check(&tables, "5 Z9", "Z9 is not in table hole.tab; it has H7 N9");
        check(
            &tables,
            "1 N9",
            "N9 is not defined over 0 up to 1 mm in table hole.tab; it is defined over 1 up to 6 mm",
        );
        check(&tables, "5 g6", "g6 is not defined over 3 up to 6 mm in table shaft.tab; it is defined nowhere");
    }

    #[test]
    fn a_users_table_comes_first_and_says_what_it_overrides() {
        let own = table("own.tab", false, &[("H7", &[pair(10, 0), pair(20, 0), None]), ("U1", &[pair(8, 3); 3])]);
        let tables = shipped().with_own(vec![own]);
        check(&tables, "5 U1", "5.003 to 5.008 from table own.tab, over 3 up to 6 mm");
        check(&tables, "2 H7", "2 to 2.02 from table own.tab, over 1 up to 3 mm");
        check(&tables, "5 H7", "H7 is not defined over 3 up to 6 mm in table own.tab; it is defined over 0 up to 3 mm");
        check(&tables, "5 N9", "4.97 to 5 from ISO 286 table hole.tab, over 3 up to 6 mm");
        let instead = |callout: &str| match tables.limits(&callout.parse().unwrap()).unwrap().source {
            Source::Table { instead_of, .. } => instead_of,
            Source::File(_) => None,
        };
        assert_eq!(instead("1 H7"), None, "the same as the shipped table");
        assert_eq!(instead("2 H7"), pair(10, 0));
        assert_eq!(instead("2 U1"), None, "not a class of the shipped tables");
    }

    #[test]
    fn a_users_table_of_the_same_name_takes_the_place() {
        let tables = shipped().with_own(vec![table("HOLE.TAB", false, &[("H7", &[pair(10, 0); 3])])]);
        check(&tables, "5 N9", "N9 is not in table HOLE.TAB; it has H7");
    }

    #[test]
    fn every_error_is_said_in_english_and_in_dutch() {
        use crate::words::{Language, Words};
        #[track_caller]
        fn check(error: &(impl Say + fmt::Display)) {
            assert_eq!(Words::new(Language::En).told(error), error.to_string());
            let dutch = Words::new(Language::Nl).told(error);
            assert!(dutch != error.message().id && dutch != error.to_string(), "{dutch}");
        }
        let tables = shipped();
        for callout in ["6.5 H7", "5 G6", "5 ±0.1", "5 H6", "5 z7", "1 N9", "5 g6"] {
            check(&tables.limits(&callout.parse().unwrap()).unwrap_err());
        }
        let (class, table): (_, Arc<str>) = ("H7".parse().unwrap(), "own.tab".into());
        let defined = [("0", "1"), ("3", "6.5"), ("10", "18")].map(|(over, to)| (mm(over), mm(to))).to_vec();
        let error = LimitsError::NotDefined { class, table, over: mm("1"), to: mm("3"), defined };
        check(&error);
        assert_eq!(
            Words::new(Language::Nl).told(&error),
            "H7 is niet gedefinieerd boven 1 tot en met 3 mm in tabel own.tab; wel boven 0 tot en met 1 mm, \
             boven 3 tot en met 6,5 mm, boven 10 tot en met 18 mm"
        );
        check(&LimitsError::TooLarge { nominal: Length::MAX });
        check(&TableShapeError::NoRanges);
        check(&TableShapeError::NotAscending { end: mm("-1.5"), before: mm("3") });
        check(&TableShapeError::Cells { class, cells: 2, ranges: 3 });
        check(&TableShapeError::Twice { class });
    }

    #[test]
    fn shapes_that_cannot_be_right_are_refused() {
        let column = |class: &str, cells: usize| Column { class: class.parse().unwrap(), cells: vec![None; cells] };
        let said = |ends: &[&str], columns: Vec<Column>| {
            DeviationTable::new("x", false, ends.iter().map(|end| mm(end)).collect(), columns).unwrap_err().to_string()
        };
        assert_eq!(said(&[], vec![]), "the table has no size range");
        assert_eq!(said(&["3", "3"], vec![]), "size range up to 3 mm does not end above the one before it, 3 mm");
        assert_eq!(said(&["3"], vec![column("H7", 2)]), "column H7 has 2 cells for 1 size ranges");
        assert_eq!(said(&["3"], vec![column("H7", 1), column("H7", 1)]), "column H7 occurs twice");
    }
}
