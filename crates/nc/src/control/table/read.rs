//! Bytes to a table.
//!
//! One pass over the lines, which reads each line once; the amount of kept data is limited. Rules: `docs/SOURCES.md`.

use std::borrow::Cow;

use fitcheck_core::text::{beginning, behind, decode, first_word};

use super::block::{read_description, read_structure};
use super::fault::{TableError, TableFault, TableWarningKind};
use super::file::TableFile;
use super::reader::{MOST_COLUMNS, Reader};
use super::{Column, CommentPlace, ControlTable, Generation, TableUnit};

impl ControlTable {
    /// Reads a table of any of the three generations: UTF-8 or Windows-1252, any line ends.
    ///
    /// `file` is the name for messages.
    ///
    /// # Errors
    /// [`TableFault`] with its place. Nothing is guessed: a row that does not reach the last column, or a second column
    /// of the same name, is an error, too.
    pub fn read(bytes: &[u8], file: &str) -> Result<TableFile, TableError> {
        Self::read_rows(bytes, file, false)
    }

    /// The same for tables whose rows may end where only blank cells follow, such as `tool.t`: the cells beyond the end
    /// of a row are empty. Without `[END]` such a row may as well be cut off and is an error.
    ///
    /// # Errors
    /// As for [`Self::read`].
    pub fn read_with_short_rows(bytes: &[u8], file: &str) -> Result<TableFile, TableError> {
        Self::read_rows(bytes, file, true)
    }

    fn read_rows(bytes: &[u8], file: &str, may_be_short: bool) -> Result<TableFile, TableError> {
        let text = decode(bytes);
        let mut reader = Reader::new(&text, file);
        reader.may_be_short = may_be_short;
        let mut table = reader.begin_line()?;
        let (names_line, names) = reader.header(&mut table)?;
        let starts = reader.names(names_line, names, &mut table)?;
        let body = reader.rows(&starts, &mut table)?;
        reader.finish(&body, text.ends_with(|c: char| c.is_whitespace() || c == '\0'))?;
        let Body { row_lines, touching, .. } = body;
        Ok(TableFile { table, warnings: reader.warnings, file: reader.file, names_line, starts, row_lines, touching })
    }
}

/// What the pass over the rows found besides the rows.
#[derive(Default)]
struct Body {
    row_lines: Vec<usize>,
    touching: Vec<(usize, usize)>,
    has_end: bool,
    /// The first row that ends before the last column.
    short: Option<TableError>,
}

impl<'a> Reader<'a> {
    /// `BEGIN name[.suffix][ MM| INCH][ Version: '…'][ U]`
    fn begin_line(&mut self) -> Result<ControlTable, TableError> {
        let line = self.next_line()?.ok_or_else(|| self.fault_at(TableFault::Empty, 1, 0))?;
        let begin = line
            .trim_start()
            .strip_prefix("BEGIN")
            .filter(|rest| rest.is_empty() || rest.starts_with(char::is_whitespace));
        let Some(rest) = begin else {
            return Err(self.fault(TableFault::NoBegin { found: beginning(line) }, 0));
        };
        let (words, version) = self.split_version(line, rest)?;
        let mut words = words.split_whitespace().peekable();
        let Some(first) = words.next() else {
            return Err(self.fault(TableFault::NoName, line.chars().count()));
        };
        let (name, suffix) = match words.next_if(|word| word.starts_with('.')) {
            Some(suffix) => (first, suffix.strip_prefix('.')),
            None => first.rsplit_once('.').map_or((first, None), |(name, suffix)| (name, Some(suffix))),
        };
        let unit = words.next_if(|word| matches!(*word, "MM" | "INCH"));
        let unit = unit.map(|word| if word == "MM" { TableUnit::Millimetre } else { TableUnit::Inch });
        let mark = words.collect::<Vec<_>>().join(" ");
        let mark = Some(mark).filter(|mark| !mark.is_empty());
        if let Some(word) = mark.as_ref().filter(|mark| *mark != "U") {
            self.warn(TableWarningKind::BeginWord { word: beginning(word) }, 0);
        }
        Ok(ControlTable {
            name: name.to_owned(),
            suffix: suffix.map(str::to_owned),
            unit,
            version,
            mark,
            ..ControlTable::default()
        })
    }

    /// Takes `Version: '…'` out of the BEGIN line.
    fn split_version<'t>(&self, line: &str, rest: &'t str) -> Result<(Cow<'t, str>, Option<String>), TableError> {
        let found = ["Version:", "VERSION:"].into_iter().find_map(|key| rest.split_once(key));
        let Some((before, after)) = found else { return Ok((rest.into(), None)) };
        let Some(quoted) = after.trim_start().strip_prefix('\'') else {
            let found = beginning(after);
            return Err(self.fault(TableFault::Unexpected { expected: "'", found }, 0));
        };
        let Some((version, after)) = quoted.split_once('\'') else {
            return Err(self.fault(TableFault::UnclosedQuote, line.chars().count()));
        };
        Ok((format!("{before} {after}").into(), Some(version.to_owned())))
    }

    /// Comments and a block, up to the line with the names: its number and text.
    fn header(&mut self, table: &mut ControlTable) -> Result<(usize, &'a str), TableError> {
        let mut described: Option<Vec<Column>> = None;
        loop {
            let Some(line) = self.next_line()? else {
                return Err(self.fault_at(TableFault::NoColumns, self.line + 1, 0));
            };
            let text = line.trim();
            let is_structure = text == "#STRUCTBEGIN";
            let is_description = text.strip_prefix("TableDescription").is_some_and(|rest| {
                let rest = rest.trim_start();
                rest.is_empty() || rest.starts_with('(')
            });
            if let Some(comment) = line.trim_start().strip_prefix(';') {
                let comment = self.comment(CommentPlace::Header, comment)?;
                table.comments.push(comment);
            } else if is_structure || is_description {
                if described.is_some() {
                    return Err(self.fault(TableFault::SecondBlock, 0));
                }
                described = Some(if is_structure {
                    table.generation = Generation::Structure;
                    read_structure(self, table)?
                } else {
                    table.generation = Generation::Description;
                    read_description(self, line, table)?
                });
            } else if is_end(text) {
                return Err(self.fault(TableFault::NoColumns, 0));
            } else if text.starts_with('#') {
                return Err(self.fault(TableFault::Unexpected { expected: "#STRUCTBEGIN", found: beginning(text) }, 0));
            } else {
                // Without a block the names alone are the columns.
                if let Some(columns) = described {
                    table.columns = columns;
                }
                return Ok((self.line, line));
            }
        }
    }

    /// The names, merged with what the block says. Returns where the columns start.
    fn names(&mut self, line: usize, names: &str, table: &mut ControlTable) -> Result<Vec<usize>, TableError> {
        self.no_tab(names)?;
        let mut described = std::mem::take(&mut table.columns);
        let found = words(names);
        if MOST_COLUMNS < found.len() {
            return Err(self.fault(TableFault::TooManyColumns { limit: MOST_COLUMNS }, 0));
        }
        self.keep(found.len())?;
        // The first column includes everything to the left of its name, so that no text of a row is lost.
        let starts: Vec<usize> =
            found.iter().enumerate().map(|(i, (start, _))| if i == 0 { 0 } else { *start }).collect();
        let end = names.chars().count();
        for (number, (&(start, name), &from)) in found.iter().zip(&starts).enumerate() {
            if table.column(name).is_some() {
                return Err(self.fault_at(TableFault::ColumnTwice { name: name.to_owned() }, line, start));
            }
            let next = starts.get(number + 1);
            let width = next.map_or(end.max(start + name.chars().count() + 1), |&next| next) - from;
            let Some(at) = described.iter().position(|column| column.name == name) else {
                // No #STRUCTBEGIN block contains the row number.
                if table.generation != Generation::Plain && name != "NR" {
                    self.warn(TableWarningKind::NotDescribed { name: name.to_owned() }, start);
                }
                table.columns.push(Column::plain(name, width));
                continue;
            };
            let mut column = described.remove(at);
            // 0: the block gives no width.
            let span = if column.width == 0 { width } else { span(&column, table.generation) };
            if next.is_some() && span != width {
                self.warn(TableWarningKind::Width { name: name.to_owned(), found: width, described: span }, start);
            }
            column.width = if next.is_some() { width } else { width.max(span) };
            table.columns.push(column);
        }
        for column in described {
            self.warn(TableWarningKind::NotInTable { name: column.name }, 0);
        }
        Ok(starts)
    }

    fn no_tab(&self, line: &str) -> Result<(), TableError> {
        let tab = line.chars().position(|c| c == '\t');
        tab.map_or(Ok(()), |at| Err(self.fault(TableFault::Tab, at)))
    }

    /// The rows up to the end.
    fn rows(&mut self, starts: &[usize], table: &mut ControlTable) -> Result<Body, TableError> {
        let mut body = Body::default();
        let last_start = starts.last().map_or(0, |start| *start);
        while let Some(line) = self.next_line()? {
            if let Some(comment) = line.strip_prefix(';') {
                let comment = self.comment(CommentPlace::Row(table.rows.len()), comment)?;
                table.comments.push(comment);
                continue;
            }
            if body.has_end {
                return Err(self.fault(TableFault::TextAfterEnd { found: beginning(line) }, 0));
            }
            if is_end(line.trim()) {
                body.has_end = true;
                continue;
            }
            self.no_tab(line)?;
            self.keep(table.columns.len())?;
            let (cells, characters) = self.cells(line, table, &mut body)?;
            table.rows.push(cells);
            body.row_lines.push(self.line);
            if let Some(last) = table.columns.last_mut() {
                last.width = last.width.max(characters.saturating_sub(last_start));
            }
        }
        Ok(body)
    }

    /// The trimmed cells of a row and its number of characters.
    fn cells(&self, line: &str, table: &ControlTable, body: &mut Body) -> Result<(Vec<String>, usize), TableError> {
        let mut cells = Vec::with_capacity(table.columns.len());
        let mut rest = line;
        let mut characters = 0;
        let mut ends_in_text = false;
        let last = table.columns.len().saturating_sub(1);
        for (number, column) in table.columns.iter().enumerate() {
            if rest.is_empty() && 0 < number {
                let short = self.fault(TableFault::ShortRow { name: column.name.clone() }, characters);
                if !self.may_be_short {
                    return Err(short);
                }
                body.short.get_or_insert(short);
                cells.resize(table.columns.len(), String::new());
                break;
            }
            let (cell, after) = if number == last { (rest, "") } else { split_at_characters(rest, column.width) };
            if ends_in_text && cell.starts_with(|c: char| !c.is_whitespace()) {
                body.touching.push((table.rows.len(), number));
            }
            ends_in_text = cell.ends_with(|c: char| !c.is_whitespace());
            characters += cell.chars().count();
            rest = after;
            cells.push(cell.trim().to_owned());
        }
        Ok((cells, characters))
    }

    /// Checks the end of the file.
    fn finish(&mut self, body: &Body, ends_in_blank: bool) -> Result<(), TableError> {
        if body.has_end {
            return Ok(());
        }
        if let Some(short) = &body.short {
            return Err(short.clone());
        }
        // Without a blank or a line end after it, the last number may have had more digits.
        if !ends_in_blank && body.row_lines.last() == Some(&self.line) {
            return Err(self.fault(TableFault::Truncated, 0));
        }
        self.warn(TableWarningKind::NoEnd, 0);
        Ok(())
    }
}

fn is_end(text: &str) -> bool {
    matches!(text, "[END]" | "END")
}

/// The span that follows from a block: `#STRUCTBEGIN` adds a blank to the width or the name, whichever is longer,
/// `TableDescription` gives the span itself (`docs/SOURCES.md`).
fn span(column: &Column, generation: Generation) -> usize {
    let name = column.name.chars().count();
    match generation {
        Generation::Structure => column.width.max(name) + 1,
        Generation::Description | Generation::Plain => column.width.max(name + 1),
    }
}

/// The words of a line with the characters (from 0) where they start.
fn words(line: &str) -> Vec<(usize, &str)> {
    let mut found: Vec<(usize, &str)> = Vec::new();
    let mut before_is_blank = true;
    for (character, (byte, c)) in line.char_indices().enumerate() {
        if before_is_blank && !c.is_whitespace() {
            found.push((character, first_word(behind(line, byte))));
            // One more than the limit is enough to reject the line.
            if MOST_COLUMNS < found.len() {
                break;
            }
        }
        before_is_blank = c.is_whitespace();
    }
    found
}

pub(super) fn split_at_characters(text: &str, characters: usize) -> (&str, &str) {
    let end = text.char_indices().nth(characters).map_or(text.len(), |(byte, _)| byte);
    text.split_at_checked(end).unwrap_or((text, ""))
}
