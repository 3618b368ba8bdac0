//! Text to mask.

use fitcheck_core::message::{FilePlace, Located};
use fitcheck_core::text::{beginning, decode, lines};

use super::{
    FileUse, Format, FormatLetter, Keyword, Line, Mask, MaskError, MaskFault, MaskWarning, MaskWarningKind, NAMES,
    Name, Part, Record,
};

/// The widest field; a control's line is 200 characters at most.
const WIDEST: usize = 255;
/// The largest mask, 1 MiB: a real one has a few hundred bytes, and every line may print or warn many times its size.
const LARGEST: usize = 1 << 20;
/// The most digits after the point.
const MOST_DIGITS: usize = 30;

impl Mask {
    /// Reads a mask: UTF-8 or Windows-1252, any line ends.
    ///
    /// ```
    /// use fitcheck_nc::control::mask::Mask;
    ///
    /// let (_, warnings) = Mask::read(b"\"STATUS: %S\", QS3\n")?;
    /// assert_eq!(warnings[0].to_string(), "line 1: the ; at the end is missing");
    /// # Ok::<(), fitcheck_nc::control::mask::MaskError>(())
    /// ```
    ///
    /// # Errors
    /// [`MaskError`] with line and column.
    pub fn read(bytes: &[u8]) -> Result<(Self, Vec<MaskWarning>), MaskError> {
        let whole = |what| Located { what, place: FilePlace::default() };
        if LARGEST < bytes.len() {
            return Err(whole(MaskFault::TooLarge { most: LARGEST >> 10 }));
        }
        let text = decode(bytes);
        let mut reader = Reader { line: 0, warnings: Vec::new() };
        let mut read = Vec::new();
        for (number, line) in lines(&text) {
            reader.line = number;
            read.extend(reader.line(line)?);
        }
        if read.is_empty() {
            return Err(whole(MaskFault::Empty));
        }
        Ok((Self { lines: read }, reader.warnings))
    }
}

struct Reader {
    line: usize,
    warnings: Vec<MaskWarning>,
}

/// A place in a line: the rest of the line, and the column.
#[derive(Clone)]
struct Cursor<'a> {
    rest: std::str::Chars<'a>,
    column: usize,
}

impl<'a> Cursor<'a> {
    fn new(line: &'a str) -> Self {
        Self { rest: line.chars(), column: 1 }
    }

    fn peek(&self) -> Option<char> {
        self.rest.clone().next()
    }

    fn next(&mut self) -> Option<char> {
        let c = self.rest.next()?;
        self.column += 1;
        Some(c)
    }

    fn take_if(&mut self, wanted: impl Fn(char) -> bool) -> Option<char> {
        if self.peek().is_some_and(wanted) { self.next() } else { None }
    }

    fn take_while(&mut self, wanted: impl Fn(char) -> bool) -> String {
        std::iter::from_fn(|| self.take_if(&wanted)).collect()
    }

    fn skip_blanks(&mut self) {
        self.take_while(char::is_whitespace);
    }

    fn rest(&self) -> &'a str {
        self.rest.as_str()
    }
}

/// A record before its parameters are known.
enum Piece {
    Text(String),
    /// A format, and its column.
    Slot(Format, usize),
}

impl Reader {
    fn fault(&self, column: usize, what: MaskFault) -> MaskError {
        Located { what, place: FilePlace::in_line(self.line, column) }
    }

    fn unknown(&self, column: usize, found: &str) -> MaskError {
        self.fault(column, MaskFault::Unknown { found: beginning(found) })
    }

    fn warn(&mut self, what: MaskWarningKind) {
        self.warnings.push(Located::in_line(self.line, what));
    }

    fn line(&mut self, line: &str) -> Result<Option<Line>, MaskError> {
        let mut cursor = Cursor::new(line);
        cursor.skip_blanks();
        match cursor.peek() {
            None | Some('*') => Ok(None),
            Some('"') => self.record(&mut cursor).map(Some),
            Some(c) if c.is_ascii_alphabetic() => self.word(&mut cursor),
            Some(_) => Err(self.unknown(cursor.column, cursor.rest())),
        }
    }

    fn record(&mut self, cursor: &mut Cursor<'_>) -> Result<Line, MaskError> {
        let pieces = self.quoted(cursor)?;
        let names = self.parameters(cursor)?;
        self.end(cursor)?;
        let formats = pieces.iter().filter(|piece| matches!(piece, Piece::Slot(..))).count();
        if formats != names.len() {
            return Err(Located::in_line(self.line, MaskFault::Count { formats, parameters: names.len() }));
        }
        let mut names = names.into_iter();
        let parts = pieces.into_iter().filter_map(|piece| match piece {
            Piece::Text(text) => Some(Part::Text(text)),
            // There are as many names as slots; they have just been counted.
            Piece::Slot(format, column) => names.next().map(|name| Part::Field { format, name, column }),
        });
        Ok(Line::Record(Record { line: self.line, parts: parts.collect() }))
    }

    fn quoted(&self, cursor: &mut Cursor<'_>) -> Result<Vec<Piece>, MaskError> {
        let begin = cursor.column;
        cursor.next();
        let mut pieces = Vec::new();
        let mut text = String::new();
        // The place of a `%"` that was read as a quotation mark: in `"100 %"` it was meant to close the record.
        let mut last_mark = None;
        loop {
            let column = cursor.column;
            let Some(c) = cursor.next() else { return Err(self.unclosed(begin, last_mark)) };
            match c {
                '"' => break,
                '%' if cursor.take_if(|c| c == '%').is_some() => text.push('%'),
                '%' if cursor.take_if(|c| c == '"').is_some() => {
                    last_mark = Some(column);
                    text.push('"');
                }
                '%' if cursor.rest().starts_with("\\\"") => {
                    cursor.next();
                    cursor.next();
                    text.push('"');
                }
                '%' => {
                    if !text.is_empty() {
                        pieces.push(Piece::Text(std::mem::take(&mut text)));
                    }
                    pieces.push(Piece::Slot(self.format(cursor, column)?, column));
                }
                '\\' if cursor.take_if(|c| c == '\\').is_some() => text.push('\\'),
                '\\' if cursor.take_if(|c| c == '"').is_some() => text.push('"'),
                '\\' if cursor.take_if(|c| c == 'n').is_some() => text.push('\n'),
                c => text.push(c),
            }
        }
        if !text.is_empty() {
            pieces.push(Piece::Text(text));
        }
        Ok(pieces)
    }

    /// A record without an end: its last `%"` is a likelier mistake than a forgotten quotation mark.
    fn unclosed(&self, begin: usize, last_mark: Option<usize>) -> MaskError {
        match last_mark {
            Some(column) => self.fault(column, MaskFault::UnknownFormat { found: "%\"".to_owned() }),
            None => self.fault(begin, MaskFault::UnclosedQuote),
        }
    }

    fn format(&self, cursor: &mut Cursor<'_>, column: usize) -> Result<Format, MaskError> {
        let flags = cursor.take_while(|c| "-+ 0".contains(c));
        let width = cursor.take_while(|c| c.is_ascii_digit());
        let digits = cursor.take_if(|c| c == '.').map(|_| cursor.take_while(|c| c.is_ascii_digit()));
        let bounded = |text: &str, most: usize| match text {
            "" => Ok(0),
            text => {
                let number = text.parse().ok().filter(|number| *number <= most);
                number.ok_or_else(|| self.fault(column, MaskFault::TooWide { found: beginning(text), most }))
            }
        };
        let letters: String = cursor.rest().chars().take(2).collect::<String>().to_ascii_uppercase();
        let (kind, length) = match letters.as_str() {
            "RS" => (FormatLetter::Raw, 2),
            "LF" => (FormatLetter::Decimal, 2),
            letters if letters.starts_with('S') => (FormatLetter::Text, 1),
            letters if letters.starts_with('F') => (FormatLetter::Decimal, 1),
            letters if letters.starts_with(['D', 'I']) => (FormatLetter::Whole, 1),
            letters => {
                let found = std::iter::once('%').chain(letters.chars().take(1)).collect();
                return Err(self.fault(column, MaskFault::UnknownFormat { found }));
            }
        };
        for _ in 0..length {
            cursor.next();
        }
        Ok(Format {
            left: flags.contains('-'),
            plus: flags.contains('+'),
            blank: flags.contains(' '),
            zeros: flags.contains('0'),
            width: bounded(&width, WIDEST)?,
            digits: digits.map(|digits| bounded(&digits, MOST_DIGITS)).transpose()?,
            kind,
        })
    }

    fn parameters(&self, cursor: &mut Cursor<'_>) -> Result<Vec<Name>, MaskError> {
        let mut names = Vec::new();
        loop {
            cursor.skip_blanks();
            if cursor.take_if(|c| c == ',').is_none() {
                return Ok(names);
            }
            cursor.skip_blanks();
            let column = cursor.column;
            let word = cursor.take_while(|c| c.is_ascii_alphanumeric() || c == '_');
            let unknown = || {
                let found = beginning(if word.is_empty() { cursor.rest() } else { &word });
                self.fault(column, MaskFault::UnknownParameter { found })
            };
            names.push(name(&word).ok_or_else(unknown)?);
        }
    }

    fn word(&mut self, cursor: &mut Cursor<'_>) -> Result<Option<Line>, MaskError> {
        let column = cursor.column;
        let word = cursor.take_while(|c| c.is_ascii_alphanumeric() || c == '_');
        let line = match word.to_ascii_uppercase().as_str() {
            "M_CLOSE" => Line::Keyword(Keyword::Close),
            "M_APPEND" => Line::Keyword(Keyword::File(FileUse::Append)),
            "M_TRUNCATE" => Line::Keyword(Keyword::File(FileUse::Replace)),
            "M_EMPTY_HIDE" => Line::Keyword(Keyword::EmptyHide),
            "M_EMPTY_SHOW" => Line::Keyword(Keyword::EmptyShow),
            "L_ALL" => Line::Language(None),
            other => {
                let kilobytes = other.strip_prefix("M_APPEND_MAX").and_then(|number| number.parse().ok());
                let language = other.strip_prefix("L_").filter(|language| LANGUAGES.contains(language));
                match (kilobytes, language) {
                    (Some(kilobytes), _) => Line::Keyword(Keyword::File(FileUse::AppendMax(kilobytes))),
                    (None, Some(language)) => Line::Language(Some(language.to_owned())),
                    (None, None) if other.starts_with("M_") || other.starts_with("L_") => {
                        self.warn(MaskWarningKind::UnknownWord { word: beginning(&word) });
                        self.end(cursor)?;
                        return Ok(None);
                    }
                    (None, None) => return Err(self.unknown(column, &word)),
                }
            }
        };
        self.end(cursor)?;
        Ok(Some(line))
    }

    /// The `;` and what may follow it. Without a `;` only a comment may follow: anything else would be lost unprinted.
    fn end(&mut self, cursor: &mut Cursor<'_>) -> Result<(), MaskError> {
        cursor.skip_blanks();
        if cursor.take_if(|c| c == ';').is_none() {
            if cursor.peek().is_some_and(|c| c != '*') {
                return Err(self.unknown(cursor.column, cursor.rest()));
            }
            self.warn(MaskWarningKind::NoSemicolon);
        }
        cursor.skip_blanks();
        if cursor.peek().is_some_and(|c| c != '*') {
            self.warn(MaskWarningKind::BehindSemicolon { found: beginning(cursor.rest()) });
        }
        Ok(())
    }
}

/// The language words of a control, cut to eight letters as in its tables.
const LANGUAGES: [&str; 22] = [
    "ENGLISH",
    "GERMAN",
    "CZECH",
    "FRENCH",
    "ITALIAN",
    "SPANISH",
    "PORTUGUE",
    "SWEDISH",
    "DANISH",
    "FINNISH",
    "DUTCH",
    "POLISH",
    "HUNGARIA",
    "RUSSIAN",
    "CHINESE",
    "CHINESE_TRAD",
    "SLOVENIAN",
    "KOREAN",
    "NORWEGIAN",
    "ROMANIAN",
    "SLOVAK",
    "TURKISH",
];

fn name(word: &str) -> Option<Name> {
    let known = NAMES.into_iter().find(|(known, _)| known.eq_ignore_ascii_case(word));
    known.map(|(_, name)| name).or_else(|| word.parse().ok().map(Name::Parameter))
}
