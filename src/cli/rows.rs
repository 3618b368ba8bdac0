//! Answers in figures, declared: every value is one line with its name in JSON, which is its column in CSV, too.

use super::Io;
use crate::report::csv::{CsvLine, cell};
use crate::row::figure::Figure;
use crate::verdict::Status;

/// What has columns: a value has one, a row has those of its values.
pub(super) trait Columns {
    /// Adds the names of its columns: its own, or those within it behind it.
    fn names(name: &str, all: &mut Vec<String>) {
        all.push(name.to_owned());
    }

    /// Adds its cells to a line; where there is nothing, as many empty ones.
    fn put(of: Option<&Self>, line: &mut CsvLine);
}

/// The names of the columns of a row.
pub(super) fn names<R: Columns>() -> Vec<String> {
    let mut all = Vec::new();
    R::names("", &mut all);
    all
}

/// The cells of a row, in the order of its columns.
pub(super) fn line<R: Columns>(row: &R) -> CsvLine {
    let mut line = CsvLine::default();
    R::put(Some(row), &mut line);
    line
}

/// A line of CSV; a text that a spreadsheet would compute gets an apostrophe, as in every CSV of Fitcheck.
pub(super) fn csv_line<T: AsRef<str>>(cells: impl IntoIterator<Item = T>, io: &mut Io<'_>) {
    let mut line = CsvLine::default();
    cells.into_iter().for_each(|text| line.cell(&cell(text.as_ref())));
    io.data().write_all(line.end());
}

/// Prints rows as CSV, below the names of their columns.
pub(super) fn csv<R: Columns>(rows: impl IntoIterator<Item = R>, io: &mut Io<'_>) {
    csv_line(names::<R>(), io);
    rows.into_iter().for_each(|row| io.data().write_all(line(&row).end()));
}

/// A name within another one.
pub(super) fn within(name: &str, inner: &str) -> String {
    // A name that is a word of the language has its mark in the source alone.
    let inner = inner.trim_start_matches("r#");
    if name.is_empty() { inner.to_owned() } else { format!("{name}_{inner}") }
}

/// What a line of a row finds: there a question mark ends the search for a value that may be missing.
pub(super) fn found<T>(find: impl FnOnce() -> T) -> T {
    find()
}

/// Values of one column, with their text. One that a spreadsheet would compute gets an apostrophe.
macro_rules! one_column {
    ($($value:ty: |$one:ident| $text:expr),+ $(,)?) => {
        $(impl Columns for $value {
            fn put(of: Option<&Self>, line: &mut CsvLine) {
                match of {
                    Some($one) => line.cell(&cell($text)),
                    None => line.cell(""),
                }
            }
        })+
    };
}

one_column! {
    String: |text| text,
    &str: |text| text,
    Figure: |figure| &figure.0,
    Status: |status| status.word(),
    bool: |is| if *is { "true" } else { "false" },
    usize: |count| &count.to_string(),
    u64: |count| &count.to_string(),
    f64: |number| &number.to_string(),
}

impl<C: Columns> Columns for Option<C> {
    fn names(name: &str, all: &mut Vec<String>) {
        C::names(name, all);
    }

    fn put(of: Option<&Self>, line: &mut CsvLine) {
        C::put(of.and_then(Self::as_ref), line);
    }
}

/// Declares objects of JSON: what each is made of, and each value with its name, its type and how it is found. The names must not change.
macro_rules! object {
    ($(
        $(#[$about:meta])*
        $seen:vis struct $row:ident $(<$life:lifetime>)? of($($given:ident: $from:ty),+ $(,)?) {
            $($(#[$how:meta])* $name:ident: $value:ty = $find:expr),+ $(,)?
        }
    )+) => {$(
        $(#[$about])*
        #[derive(Debug, serde::Serialize)]
        $seen struct $row $(<$life>)? {
            $($(#[$how])* $name: $value,)+
        }

        impl $(<$life>)? $row $(<$life>)? {
            $seen fn of($($given: $from),+) -> Self {
                Self { $($name: $crate::cli::rows::found(|| -> $value { $find }),)+ }
            }
        }
    )+};
}

/// The same with columns of CSV: what follows `json:` has none.
macro_rules! row {
    ($(
        $(#[$about:meta])*
        $seen:vis struct $row:ident $(<$life:lifetime>)? of($($given:ident: $from:ty),+ $(,)?) {
            $($name:ident: $value:ty = $find:expr),+
            $(; json: $($(#[$how:meta])* $more:ident: $other:ty = $find_more:expr),+)? $(,)?
        }
    )+) => {$(
        object! {
            $(#[$about])*
            $seen struct $row $(<$life>)? of($($given: $from),+) {
                $($name: $value = $find,)+
                $($($(#[$how])* $more: $other = $find_more,)+)?
            }
        }

        impl $(<$life>)? $crate::cli::rows::Columns for $row $(<$life>)? {
            fn names(name: &str, all: &mut Vec<String>) {
                $(<$value as $crate::cli::rows::Columns>::names(
                    &$crate::cli::rows::within(name, stringify!($name)),
                    all,
                );)+
            }

            fn put(of: Option<&Self>, line: &mut $crate::report::csv::CsvLine) {
                $($crate::cli::rows::Columns::put(of.map(|of| &of.$name), line);)+
            }
        }
    )+};
}

#[cfg(test)]
mod tests {
    use super::*;

    row! {
        struct Outer of(number: Option<usize>) {
            number: Option<usize> = number,
            r#type: &'static str = "=1",
            inner: Option<Inner> = Some(Inner::of(number?));
            json:
            more: bool = true,
        }

        struct Inner of(number: usize) {
            twice: usize = number * 2,
            text: String = "a,b".to_owned(),
        }
    }

    #[test]
    fn a_row_has_the_same_columns_whatever_it_lacks() {
        assert_eq!(names::<Outer>(), ["number", "type", "inner_twice", "inner_text"]);
        assert_eq!(line(&Outer::of(Some(2))).end(), b"2,'=1,4,\"a,b\"\n");
        assert_eq!(line(&Outer::of(None)).end(), b",'=1,,\n");
        let json = serde_json::to_string(&Outer::of(None)).unwrap();
        assert_eq!(json, r#"{"number":null,"type":"=1","inner":null,"more":true}"#);
    }
}
