//! The two blocks that describe the columns of a table.
//!
//! `#STRUCTBEGIN` … `#STRUCTEND` of iTNC 530 and `TableDescription ( … )` of TNC 640 and TNC7 (`docs/SOURCES.md`). The
//! width of a column is the figure in the block, 0 if there is none. Everything besides name, width, type and decimals
//! is kept as written.

use fitcheck_core::text::beginning;

use super::fault::{TableError, TableFault, TableWarningKind};
use super::reader::{MOST_COLUMNS, Reader, WIDEST};
use super::{Column, CommentPlace, ControlTable};

/// Reads the lines after `#STRUCTBEGIN` up to and including `#STRUCTEND`.
pub(super) fn read_structure(reader: &mut Reader<'_>, table: &mut ControlTable) -> Result<Vec<Column>, TableError> {
    let begin = reader.line;
    let mut columns: Vec<Column> = Vec::new();
    while let Some(line) = reader.next_line()? {
        let text = line.trim();
        let indent = line.chars().take_while(|c| c.is_whitespace()).count();
        if text == "#STRUCTEND" {
            return Ok(columns);
        }
        if let Some(comment) = line.trim_start().strip_prefix(['*', ';']) {
            let comment = reader.comment(CommentPlace::Block, comment)?;
            table.comments.push(comment);
            continue;
        }
        let Some((key, value)) = text.split_once('=') else {
            return Err(reader.fault(TableFault::Unexpected { expected: "=", found: beginning(text) }, indent));
        };
        let key = key.trim_end();
        let value = value.trim_start();
        reader.keep(1)?;
        if key == "NAME" {
            push(reader, &mut columns, Column::plain(value, 0))?;
            continue;
        }
        let Some(column) = columns.last_mut() else {
            return Err(reader.fault(TableFault::Unexpected { expected: "NAME =", found: beginning(text) }, indent));
        };
        match key {
            "TYPE" => column.kind = Some(value.to_owned()),
            "WIDTH" => column.width = size(reader, "WIDTH", value, indent)?,
            "DEC" => column.decimals = Some(size(reader, "DEC", value, indent)?),
            _ => column.settings.push((key.to_owned(), value.to_owned())),
        }
    }
    Err(unclosed(reader, "#STRUCTBEGIN", begin))
}

fn push(reader: &Reader<'_>, columns: &mut Vec<Column>, column: Column) -> Result<(), TableError> {
    if MOST_COLUMNS <= columns.len() {
        return Err(reader.fault(TableFault::TooManyColumns { limit: MOST_COLUMNS }, 0));
    }
    if columns.iter().any(|other| other.name == column.name) {
        return Err(reader.fault(TableFault::ColumnTwice { name: column.name }, 0));
    }
    columns.push(column);
    Ok(())
}

fn size(reader: &Reader<'_>, key: &'static str, text: &str, character: usize) -> Result<usize, TableError> {
    let number = text.parse().ok().filter(|&number| number <= WIDEST);
    number.ok_or_else(|| reader.fault(TableFault::NotASize { key, text: beginning(text), limit: WIDEST }, character))
}

fn unclosed(reader: &Reader<'_>, block: &'static str, line: usize) -> TableError {
    reader.fault(TableFault::UnclosedBlock { block, line }, 0)
}

/// The smallest parts of a description block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Token<'a> {
    Word(&'a str),
    /// A text with its quotation marks.
    Quoted(&'a str),
    /// One of `:=`, `,` and the brackets.
    Sign(&'static str),
}

impl<'a> Token<'a> {
    const fn text(self) -> &'a str {
        match self {
            Self::Word(text) | Self::Quoted(text) | Self::Sign(text) => text,
        }
    }
}

const SIGNS: [&str; 6] = [":=", ",", "(", ")", "[", "]"];

/// The parts of a description block, line by line.
struct Tokens<'r, 'a> {
    reader: &'r mut Reader<'a>,
    begin: usize,
    rest: &'a str,
    /// Where `rest` starts in its line, in characters from 0.
    character: usize,
}

impl<'a> Tokens<'_, 'a> {
    fn next(&mut self, table: &mut ControlTable) -> Result<Token<'a>, TableError> {
        loop {
            let text = self.rest.trim_start();
            self.character += self.rest.chars().take_while(|c| c.is_whitespace()).count();
            self.rest = text;
            if !text.is_empty() {
                break;
            }
            let line = self.reader.next_line()?;
            let Some(line) = line else { return Err(unclosed(self.reader, "TableDescription", self.begin)) };
            self.rest = line;
            self.character = 0;
            if let Some(comment) = line.trim_start().strip_prefix(';') {
                let comment = self.reader.comment(CommentPlace::Block, comment)?;
                table.comments.push(comment);
                self.rest = "";
            }
        }
        for sign in SIGNS {
            if self.rest.starts_with(sign) {
                self.take(sign.len());
                return Ok(Token::Sign(sign));
            }
        }
        if let Some(quoted) = self.rest.strip_prefix('"') {
            let end = quoted.find('"').ok_or_else(|| self.reader.fault(TableFault::UnclosedQuote, self.character))?;
            return Ok(Token::Quoted(self.take(end + 2)));
        }
        let end = self.rest.find(|c: char| c.is_whitespace() || ":=,()[]\"".contains(c)).unwrap_or(self.rest.len());
        if end == 0 {
            let found = beginning(self.rest);
            return Err(self.reader.fault(TableFault::Unexpected { expected: ":=", found }, self.character));
        }
        Ok(Token::Word(self.take(end)))
    }

    /// Takes this many bytes off the line.
    fn take(&mut self, bytes: usize) -> &'a str {
        let (taken, rest) = self.rest.split_at_checked(bytes).unwrap_or((self.rest, ""));
        self.character += taken.chars().count();
        self.rest = rest;
        taken
    }

    /// An error at the token that was read last.
    fn unexpected(&self, expected: &'static str, found: &str) -> TableError {
        let before = self.character.saturating_sub(found.chars().count());
        self.reader.fault(TableFault::Unexpected { expected, found: beginning(found) }, before)
    }

    fn expect(&mut self, sign: &'static str, table: &mut ControlTable) -> Result<(), TableError> {
        let token = self.next(table)?;
        if token == Token::Sign(sign) { Ok(()) } else { Err(self.unexpected(sign, token.text())) }
    }

    /// The next key before `:=`, or `None` at the closing bracket. Commas between entries are skipped.
    fn key(&mut self, close: &'static str, table: &mut ControlTable) -> Result<Option<&'a str>, TableError> {
        loop {
            match self.next(table)? {
                Token::Sign(",") => {}
                Token::Sign(sign) if sign == close => return Ok(None),
                Token::Word(word) => return Ok(Some(word)),
                other => return Err(self.unexpected(close, other.text())),
            }
        }
    }

    /// A value as written; `None` for a bracketed one, which is skipped with a warning.
    fn value(&mut self, key: &str, table: &mut ControlTable) -> Result<Option<&'a str>, TableError> {
        self.expect(":=", table)?;
        match self.next(table)? {
            Token::Word(text) | Token::Quoted(text) => Ok(Some(text)),
            Token::Sign("(" | "[") => self.skip(key, table).map(|()| None),
            Token::Sign(sign) => Err(self.unexpected("value", sign)),
        }
    }

    /// Skips to the bracket that closes the one just read.
    fn skip(&mut self, name: &str, table: &mut ControlTable) -> Result<(), TableError> {
        let character = self.character;
        self.reader.warn(TableWarningKind::Skipped { name: beginning(name) }, character);
        self.reader.keep(1)?;
        let mut depth = 1_usize;
        while 0 < depth {
            match self.next(table)? {
                Token::Sign("(" | "[") => depth += 1,
                Token::Sign(")" | "]") => depth -= 1,
                _ => {}
            }
        }
        Ok(())
    }

    /// The entries of one `CfgColumnDescription ( … )`, after its opening bracket.
    fn column(&mut self, table: &mut ControlTable) -> Result<Column, TableError> {
        let mut column = Column::plain("", 0);
        while let Some(key) = self.key(")", table)? {
            let Some(value) = self.value(key, table)? else { continue };
            self.reader.keep(1)?;
            match key {
                "key" => value.trim_matches('"').clone_into(&mut column.name),
                "width" => column.width = size(self.reader, "width", value, self.character)?,
                "unit" => column.kind = Some(value.to_owned()),
                _ => column.settings.push((key.to_owned(), value.to_owned())),
            }
        }
        Ok(column)
    }

    /// The list of columns, after its opening bracket.
    fn columns(&mut self, table: &mut ControlTable) -> Result<Vec<Column>, TableError> {
        let mut columns: Vec<Column> = Vec::new();
        while let Some(object) = self.key("]", table)? {
            self.expect("(", table)?;
            if object != "CfgColumnDescription" {
                self.skip(object, table)?;
                continue;
            }
            let column = self.column(table)?;
            push(self.reader, &mut columns, column)?;
        }
        Ok(columns)
    }
}

/// Reads a block that begins in `line` with `TableDescription`, up to the bracket that closes it.
pub(super) fn read_description<'a>(
    reader: &mut Reader<'a>,
    line: &'a str,
    table: &mut ControlTable,
) -> Result<Vec<Column>, TableError> {
    let begin = reader.line;
    let mut tokens = Tokens { reader, begin, rest: line, character: 0 };
    // The word itself, which the caller has already read.
    let _table_description = tokens.next(table)?;
    tokens.expect("(", table)?;
    let mut columns = Vec::new();
    while let Some(key) = tokens.key(")", table)? {
        if key == "columns" && columns.is_empty() {
            tokens.expect(":=", table)?;
            tokens.expect("[", table)?;
            columns = tokens.columns(table)?;
        } else if let Some(value) = tokens.value(key, table)? {
            tokens.reader.keep(1)?;
            table.properties.push((key.to_owned(), value.to_owned()));
        }
    }
    let rest = tokens.rest.trim();
    let character = tokens.character;
    if rest.is_empty() {
        return Ok(columns);
    }
    Err(tokens.reader.fault(TableFault::Unexpected { expected: "line end", found: beginning(rest) }, character))
}
