//! Which temperature a text says of the part, or of the place around it.
//!
//! Each number with a unit, or behind the name of a temperature, belongs to the words of its own clause: `coolant 25 °C, part 35 °C` says 35,
//! and so does `not compensated, 35 °C`. A text that says of its values that they are corrected says 20.

use super::token::{Token, TokenKind, plain, tokens};
use super::words::{self, Whose};
use super::{Scale, Temperature};
use fitcheck_core::text::Within as _;

/// How a number says that it is one of degrees.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Unit {
    /// `35 °C`, `35 degC`, `35 degrees Celsius`.
    Sure(Scale),
    /// `35 C`, `308 K`: a letter that has other meanings as well.
    Letter(Scale),
    /// `35°`, `35 Grad`: also an angle.
    Degrees,
    None,
}

impl Unit {
    const fn scale(self) -> Option<Scale> {
        match self {
            Self::Sure(scale) | Self::Letter(scale) => Some(scale),
            Self::Degrees => Some(Scale::Celsius),
            Self::None => None,
        }
    }
}

/// A temperature in a text.
#[derive(Debug, Clone, Copy)]
struct Mention {
    degrees: Temperature,
    whose: Option<Whose>,
}

/// The temperature that a text says, the one furthest from 20 °C; with `column`, it stands in one of temperatures, in this unit.
pub(super) fn said(text: &str, column: Option<Scale>) -> Option<Temperature> {
    if column.is_none() && !may_say(text.as_bytes()) {
        return None;
    }
    let text = plain(text);
    let tokens = tokens(&text);
    let text = Text::of(&tokens, column);
    let found = text.mentions();
    if text.is_corrected(&found) {
        return Some(Temperature::REFERENCE);
    }
    let off = |mention: &Mention| (mention.degrees.thousandths() - Temperature::REFERENCE.thousandths()).abs();
    let has_part = found.iter().any(|mention| mention.whose == Some(Whose::Part));
    let counts = |mention: &&Mention| match mention.whose {
        Some(Whose::Other) => false,
        Some(Whose::Reference) => off(mention) != 0,
        Some(Whose::Place) => !has_part,
        Some(Whose::Part) | None => true,
    };
    found.iter().filter(counts).max_by_key(|mention| off(mention)).map(|mention| mention.degrees)
}

/// Whether a text has a sign of degrees, the name of a temperature or a number before the letter of a unit: most have none.
fn may_say(text: &[u8]) -> bool {
    // What begins so: temp, °, º, ℃, ℉, degrees, grad, Celsius, Fahrenheit, Kelvin.
    const BEGIN: [&[u8]; 8] = [b"temp", b"\xc2\xb0", b"\xc2\xba", b"\xe2\x84", b"deg", b"gra", b"kel", b"fah"];
    let begins =
        |at: usize, begin: &[u8]| text.get(at..at + begin.len()).is_some_and(|here| here.eq_ignore_ascii_case(begin));
    let is_letter = |at: usize| {
        let before = text.within(..at).trim_ascii_end();
        let is_alone = text.get(at + 1).is_none_or(|next| !next.is_ascii_alphabetic());
        before.last().is_some_and(u8::is_ascii_digit) && (is_alone || begins(at, b"cel") || begins(at, b"cen"))
    };
    text.iter().enumerate().any(|(at, byte)| match byte {
        b't' | b'T' | 0xc2 | 0xe2 | b'd' | b'D' | b'g' | b'G' => BEGIN.iter().any(|begin| begins(at, begin)),
        b'c' | b'C' | b'k' | b'K' | b'f' | b'F' => is_letter(at) || BEGIN.iter().any(|begin| begins(at, begin)),
        _ => false,
    })
}

/// Whether a text says that values were not corrected.
pub(super) fn denies_correction(text: &str) -> bool {
    let text = plain(text);
    let tokens = tokens(&text);
    Text::of(&tokens, None).denies_correction()
}

/// What the words of a clause say together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[expect(clippy::struct_excessive_bools, reason = "each answers another question about the words")]
struct Clause {
    /// A correction, and whether a word alone says that it is done.
    corrects: Option<bool>,
    is_done: bool,
    is_denied: bool,
    /// Whether it has a word that begins as a temperature.
    of_temperature: bool,
    names_temperature: bool,
    /// Whether it speaks of the part or its place.
    of_part: bool,
    of_angle: bool,
    /// Whether it speaks of values, their temperature and its correction alone.
    is_of_values: bool,
}

impl Clause {
    const EMPTY: Self = Self {
        corrects: None,
        is_done: false,
        is_denied: false,
        of_temperature: false,
        names_temperature: false,
        of_part: false,
        of_angle: false,
        is_of_values: true,
    };

    fn take(&mut self, word: &str) {
        let correction = words::correction(word);
        let whose = words::whose(word);
        let of_temperature = word.contains("temp");
        self.corrects = self.corrects.max(correction);
        self.is_done |= words::says_done(word);
        self.is_denied |= words::says_not(word);
        self.of_temperature |= of_temperature;
        self.names_temperature |= words::names_temperature(word);
        self.of_part |= matches!(whose, Some(Whose::Part | Whose::Place));
        self.of_angle |= words::is_of_angle(word);
        self.is_of_values &= of_temperature
            || correction.is_some()
            || whose.is_some_and(|whose| whose != Whose::Other)
            || words::is_filler(word)
            || words::says_done(word);
    }
}

struct Text<'a> {
    tokens: &'a [Token<'a>],
    column: Option<Scale>,
    clauses: Vec<Clause>,
    /// The clause of each token.
    clause_of: Vec<usize>,
}

impl<'a> Text<'a> {
    fn of(tokens: &'a [Token<'a>], column: Option<Scale>) -> Self {
        let mut text =
            Self { tokens, column, clauses: vec![Clause::EMPTY], clause_of: Vec::with_capacity(tokens.len()) };
        for at in 0..tokens.len() {
            text.clause_of.push(text.clauses.len() - 1);
            if let (Some(word), Some(clause)) = (text.word(at), text.clauses.last_mut()) {
                clause.take(word);
            } else if text.ends_clause(at) {
                text.clauses.push(Clause::EMPTY);
            }
        }
        text
    }

    fn clause(&self, at: usize) -> Clause {
        self.clause_of.get(at).and_then(|clause| self.clauses.get(*clause)).copied().unwrap_or(Clause::EMPTY)
    }

    fn at(&self, at: usize) -> Option<&Token<'a>> {
        self.tokens.get(at)
    }

    fn word(&self, at: usize) -> Option<&'a str> {
        match self.at(at)?.kind {
            TokenKind::Word(word) => Some(word),
            _ => None,
        }
    }

    fn number(&self, at: usize) -> Option<f64> {
        match self.at(at)?.kind {
            TokenKind::Number(number) => Some(number),
            _ => None,
        }
    }

    fn is(&self, at: usize, sign: char) -> bool {
        self.at(at).is_some_and(|token| token.is(sign))
    }

    fn is_glued(&self, at: usize) -> bool {
        self.at(at).is_some_and(|token| token.is_glued)
    }

    /// Whether a clause ends with a token.
    fn ends_clause(&self, at: usize) -> bool {
        let Some(Token { kind: TokenKind::Sign(sign), is_glued }) = self.at(at) else { return false };
        match sign {
            ',' | ';' | '|' | ')' | '/' => true,
            // No abbreviation: "Temp. comp. off".
            '.' => {
                !self.is_glued(at + 1)
                    && at.checked_sub(1).and_then(|at| self.word(at)).is_some_and(|word| 4 < word.len())
            }
            '-' | '\u{2013}' | '\u{2014}' => !is_glued && !self.is_glued(at + 1),
            _ => false,
        }
    }

    /// The unit behind a number, and how many tokens it has.
    fn unit(&self, number: usize) -> (Unit, usize) {
        let at = number + 1;
        let letter = |at: usize| match self.word(at) {
            Some("c" | "celsius" | "centigrade") => Some(Scale::Celsius),
            Some("f" | "fahrenheit") => Some(Scale::Fahrenheit),
            Some("k" | "kelvin") => Some(Scale::Kelvin),
            _ => None,
        };
        // "30° C-axis" and "B30° C=45" say an axis.
        let is_axis = |at: usize| {
            let is_sign = self.is(at + 1, '=') || self.is(at + 1, '-') && self.word(at + 2).is_some();
            !self.is_glued(at) && (is_sign || self.is_glued(at + 1) && self.number(at + 1).is_some())
        };
        let sure = |at: usize| letter(at).filter(|_| !is_axis(at)).map(Unit::Sure);
        if self.is(at, '°') {
            return sure(at + 1).map_or((Unit::Degrees, 1), |unit| (unit, 2));
        }
        match self.word(at) {
            Some("degc" | "celsius" | "centigrade") => (Unit::Sure(Scale::Celsius), 1),
            Some("degf" | "fahrenheit") => (Unit::Sure(Scale::Fahrenheit), 1),
            Some("kelvin") => (Unit::Sure(Scale::Kelvin), 1),
            Some("deg" | "degree" | "degrees" | "grad" | "graden" | "gradi") => {
                sure(at + 1).map_or((Unit::Degrees, 1), |unit| (unit, 2))
            }
            _ => letter(at).map_or((Unit::None, 0), |scale| (Unit::Letter(scale), 1)),
        }
    }

    /// Whether a number is part of a time or a date, a spread, a share, a rate or a name.
    fn is_no_value(&self, at: usize, behind: usize) -> bool {
        let joins = |sign: usize, signs: &[char]| {
            self.is_glued(sign) && self.is_glued(sign + 1) && signs.iter().any(|known| self.is(sign, *known))
        };
        let is_joined = |signs: &[char]| {
            let before = 1 < at && joins(at - 1, signs) && self.number(at - 2).is_some();
            let behind = joins(at + 1, signs) && self.number(at + 2).is_some();
            (before, behind)
        };
        let time = is_joined(&[':']);
        let date = is_joined(&['-', '/', '.']);
        let of_three = |sign: usize, number: usize| joins(sign, &['-', '/', '.']) && self.number(number).is_some();
        let is_date = date.0 && (date.1 || 3 < at && of_three(at - 3, at - 4)) || date.1 && of_three(at + 3, at + 4);
        let before = |sign: char| 0 < at && self.is(at - 1, sign);
        let is_rate = self.is(behind, '/') && matches!(self.word(behind + 1), Some("h" | "min" | "s" | "m" | "k"));
        time.0
            || time.1
            || is_date
            || before('±')
            || before('#') && self.is_glued(at)
            || self.is(behind, '%')
            || is_rate
    }

    /// Whether the name of a temperature, or a unit without a number, stands before a number, with words of the part between them at most.
    fn is_named(&self, number: usize) -> bool {
        for at in (0..number).rev() {
            match self.at(at).map(|token| token.kind) {
                Some(TokenKind::Word("c" | "f" | "k")) if 0 < at && self.is(at - 1, '°') => {
                    return at < 2 || self.number(at - 2).is_none();
                }
                Some(TokenKind::Word(word)) if words::names_temperature(word) => return true,
                Some(TokenKind::Word(word))
                    if words::is_filler(word) || words::is_time(word) || words::whose(word).is_some() => {}
                Some(TokenKind::Word(_) | TokenKind::Number(_) | TokenKind::Sign(',' | ';' | '|' | '#' | '%'))
                | None => return false,
                Some(TokenKind::Sign(_)) => {}
            }
        }
        false
    }

    /// Whether a number with such a unit is a temperature.
    fn is_temperature(&self, at: usize, unit: Unit) -> bool {
        let after_word = self.is_glued(at) && 0 < at && self.word(at - 1).is_some();
        let clause = self.clause(at);
        let is_named = || self.is_named(at);
        match unit {
            Unit::Sure(_) => true,
            _ if self.column.is_some() => true,
            Unit::None => !after_word && is_named(),
            Unit::Degrees => {
                let is_sign = self.is(at + 1, '°');
                let speaks = clause.names_temperature || !is_sign && clause.of_part;
                !clause.of_angle && (is_named() || speaks)
            }
            Unit::Letter(scale) => {
                let before = at.checked_sub(1).and_then(|at| self.word(at)).unwrap_or("");
                let is_number = ["no", "nr", "number", "nummer", "id"].contains(&before);
                let is_place = ["at", "bei", "bij", "a"].contains(&before);
                let is_near = scale == Scale::Kelvin || is_place || self.is_glued(at + 1) && scale == Scale::Celsius;
                let is_said = clause.names_temperature || is_near && clause.of_part;
                !after_word && !is_number && (is_named() || is_said)
            }
        }
    }

    fn mentions(&self) -> Vec<Mention> {
        let mut found = Vec::new();
        let mut from = 0;
        for at in 0..self.tokens.len() {
            let Some(number) = self.number(at) else { continue };
            let (unit, length) = self.unit(at);
            let behind = at + 1 + length;
            let unit = if unit == Unit::None { self.unit_of_range(at).unwrap_or(unit) } else { unit };
            if self.is_no_value(at, behind) || !self.is_temperature(at, unit) {
                continue;
            }
            let scale = unit.scale().or(self.column).unwrap_or(Scale::Celsius);
            let whose = self.whose(from, at, behind);
            from = behind;
            let is_sure = whose == Some(Whose::Part) || self.is_named(at);
            let far = match self.column {
                Some(_) => i32::MIN..=i32::MAX,
                None if is_sure => -100_000..=150_000,
                None => -20_000..=60_000,
            };
            let degrees = scale.degrees(number).filter(|warm| far.contains(&warm.thousandths()));
            // "300 K" is a number of pieces as well.
            let is_kelvin = unit != Unit::Letter(Scale::Kelvin) || (200.0..400.0).contains(&number);
            found.extend(degrees.filter(|_| is_kelvin).map(|degrees| Mention { degrees, whose }));
        }
        found
    }

    /// The unit behind the second number of a range: `35-36 °C`, `35 to 36 °C`.
    fn unit_of_range(&self, at: usize) -> Option<Unit> {
        let is_sign = self
            .at(at + 1)
            .is_some_and(|token| ['-', '\u{2013}', '\u{2026}', '/', '±'].iter().any(|sign| token.is(*sign)));
        let is_word = matches!(self.word(at + 1), Some("to" | "bis" | "tot" | "a" | "and" | "und" | "en"));
        let unit = self.number(at + 2).filter(|_| is_sign || is_word).map(|_| self.unit(at + 2).0)?;
        Some(unit).filter(|unit| *unit != Unit::None)
    }

    /// Whose temperature stands at a place: by the nearest word of its clause before it, or where there are none, behind it.
    fn whose(&self, from: usize, number: usize, behind: usize) -> Option<Whose> {
        let mut has_words = false;
        for at in (from..number).rev() {
            if self.ends_clause(at) {
                break;
            }
            let Some(word) = self.word(at) else { continue };
            // "After hardening": what is over.
            let is_over = || {
                let mut before = (from..at).rev().map_while(|at| self.word(at));
                before.find(|word| !words::is_article(word)).is_some_and(words::is_time)
            };
            if words::is_no_temperature(word) {
                return Some(Whose::Other);
            }
            match words::whose(word) {
                Some(Whose::Other) if is_over() => return Some(Whose::Part),
                Some(whose) => return Some(whose),
                None => has_words |= !words::is_filler(word),
            }
        }
        if has_words {
            return None;
        }
        let end = (behind..self.tokens.len()).find(|at| self.ends_clause(*at) || self.number(*at).is_some());
        let is_of_next = end.is_some_and(|end| self.number(end).is_some());
        let mut words = (behind..end.unwrap_or(self.tokens.len())).filter_map(|at| self.word(at));
        words.find_map(words::whose).filter(|_| !is_of_next)
    }

    /// Whether the text says of its values, and of nothing else, that they were corrected.
    fn is_corrected(&self, found: &[Mention]) -> bool {
        let mut of_correction = self.clauses.iter().filter(|clause| clause.corrects.is_some()).peekable();
        let has_any = of_correction.peek().is_some();
        let is_done = |clause: &Clause| {
            let by_word = clause.corrects == Some(true) || clause.is_done;
            by_word && (clause.of_temperature || !found.is_empty()) && clause.is_of_values
        };
        has_any && !self.denies_correction() && of_correction.any(is_done)
    }

    fn denies_correction(&self) -> bool {
        self.clauses.iter().any(|clause| clause.corrects.is_some() && clause.is_denied)
    }
}
