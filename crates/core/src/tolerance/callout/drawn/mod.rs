//! Callouts as drawings and other programs write them: `2x Ø8 H7`, `25 H7 (+0.021/0)`, `25 H7 Ⓔ`, `10 ISO 2768-mK`, `25 ±IT7/2`.
//!
//! | file | what |
//! |---|---|
//! | here | what stands beside a callout becomes its notes, and the rest is read by the grammar |
//! | `signs` | other signs for the grammar's |
//! | `refused` | what no callout is, with its own reason: inches, threads, exact sizes, one limit alone |
//!
//! It is tried where the grammar refuses a text, so that usual callouts cost nothing more. What is read becomes blanks: places in
//! errors are those of the text as given.

mod refused;
mod signs;

use std::ops::Range;

use super::error::{CalloutError, shorten};
use super::kind::CalloutErrorKind as Kind;
use super::notes::{FormClass, MOST_FEATURES, Modifier, Notes};
use super::reading::{self, Grammar, Reader};
use super::{Callout, Tolerance, signed, thousandths};
use crate::length::Length;
use crate::tolerance::coarsest::widest;
use crate::tolerance::deviations::Deviations;
use crate::tolerance::iso286::{Grade, standard_tolerance};
use crate::tolerance::{GeneralClass, ToleranceClass};

/// The longest text that is tried, bytes.
const LONGEST: usize = 200;

/// Reads what the grammar refused with an error; the same error where the text is nothing that a drawing has.
#[cold]
pub(super) fn callout(text: &str, error: CalloutError) -> Result<Callout, CalloutError> {
    if LONGEST < text.len() {
        return Err(error);
    }
    let mut drawing = Drawing { given: text, chars: signs::plain(text), notes: Notes::default(), class: None };
    drawing.read().unwrap_or(Err(error))
}

/// A text that is being read as a drawing's.
struct Drawing<'a> {
    given: &'a str,
    /// What has not been understood yet, with blanks instead of what has.
    chars: Vec<char>,
    notes: Notes,
    /// A class in brackets behind deviations: `25 +0.021/0 (H7)`.
    class: Option<ToleranceClass>,
}

impl Drawing<'_> {
    /// The callout, or why there is none; `None` where the grammar's own reason is the better one.
    fn read(&mut self) -> Option<Result<Callout, CalloutError>> {
        if let Err(error) = self.take_beside() {
            return Some(Err(error));
        }
        let text = self.text();
        if let Some(read) = self.half_grade(&text) {
            return Some(read.and_then(|callout| self.with_notes(callout)));
        }
        let read = reading::callout(&text).or_else(|error| self.class_and_band(&text).unwrap_or(Err(error)));
        let is_untouched = text == self.given && self.notes.is_empty() && self.class.is_none();
        match read {
            Err(_) if is_untouched => None,
            Err(error) => Some(Err(CalloutError { text: shorten(self.given.trim()), ..error })),
            Ok(callout) => Some(self.with_notes(callout)),
        }
    }

    /// Takes out what stands beside size and tolerance.
    fn take_beside(&mut self) -> Result<(), CalloutError> {
        self.count_before();
        self.refuse()?;
        self.brackets()?;
        self.circles()?;
        self.last_words();
        self.general_class();
        Ok(())
    }

    fn text(&self) -> String {
        self.chars.iter().collect()
    }

    fn slice(&self, range: &Range<usize>) -> String {
        self.chars.get(range.clone()).unwrap_or_default().iter().collect()
    }

    fn blank(&mut self, range: Range<usize>) {
        if let Some(chars) = self.chars.get_mut(range) {
            chars.fill(' ');
        }
    }

    fn error(&self, place: &Range<usize>, kind: Kind) -> CalloutError {
        let text = shorten(self.given.trim());
        CalloutError { text, at: place.start + 1, length: place.end - place.start, kind }
    }

    /// The whole text without blanks around it.
    fn whole(&self) -> Range<usize> {
        let is_text = |c: &char| !c.is_whitespace();
        let start = self.chars.iter().position(is_text).unwrap_or(0);
        start..self.chars.iter().rposition(is_text).map_or(start, |last| last + 1)
    }

    /// `2x`, `2 x`, `(4x)` or `4-Ø` at the beginning.
    fn count_before(&mut self) {
        let Range { start, .. } = self.whole();
        let has_bracket = self.chars.get(start) == Some(&'(');
        let mut at = start + usize::from(has_bracket);
        let digits = self.digits(at);
        at += digits.len();
        at += self.blanks(at);
        let is_dash = self.chars.get(at) == Some(&'-') && !has_bracket;
        if !is_dash && !matches!(self.chars.get(at), Some('x' | 'X')) {
            return;
        }
        at += 1;
        let behind = at + self.blanks(at);
        if is_dash && self.chars.get(behind) != Some(&'Ø') {
            return;
        }
        if has_bracket && self.chars.get(behind) != Some(&')') {
            return;
        }
        // In "2x45°" a number follows at once as in "2x8"; what no size follows is a size of class x: "2 x (E)".
        if self.has_size(behind) && self.take_count(&digits) {
            self.blank(start..if has_bracket { behind + 1 } else { at });
        }
    }

    /// Whether a size may stand behind a place: a figure that is in no bracket.
    fn has_size(&self, at: usize) -> bool {
        let mut depth = 0_usize;
        self.chars.iter().skip(at).any(|c| {
            match c {
                '(' => depth += 1,
                ')' => depth = depth.saturating_sub(1),
                _ => {}
            }
            depth == 0 && c.is_ascii_digit()
        })
    }

    fn take_count(&mut self, digits: &str) -> bool {
        let count = digits.parse().ok().filter(|count| (1..=MOST_FEATURES).contains(count));
        let is_new = count.is_some() && self.notes.count.is_none();
        if is_new {
            self.notes.count = count;
        }
        is_new
    }

    fn digits(&self, at: usize) -> String {
        self.chars.iter().skip(at).take_while(|c| c.is_ascii_digit()).collect()
    }

    fn blanks(&self, at: usize) -> usize {
        self.chars.iter().skip(at).take_while(|c| c.is_whitespace()).count()
    }

    /// Every pair of round brackets: deviations, a class, a modifier, a count.
    fn brackets(&mut self) -> Result<(), CalloutError> {
        while let Some(open) = self.chars.iter().position(|c| *c == '(') {
            let Some(length) = self.chars.iter().skip(open).position(|c| *c == ')') else { break };
            let group = open..open + length + 1;
            let inside = self.slice(&(open + 1..open + length));
            self.bracket(inside.trim(), &group)?;
            self.blank(group);
        }
        Ok(())
    }

    fn bracket(&mut self, inside: &str, group: &Range<usize>) -> Result<(), CalloutError> {
        if let Some(modifier) = Modifier::from_letters(inside) {
            self.notes.modifiers.add(modifier);
            return Ok(());
        }
        let is_new = self.notes.stated.is_none() && self.class.is_none();
        if inside.strip_suffix(['x', 'X']).is_some_and(|digits| self.take_count(digits.trim())) {
            return Ok(());
        }
        if let Ok(class) = inside.parse::<ToleranceClass>()
            && class.has_grade()
            && is_new
        {
            self.class = Some(class);
            return Ok(());
        }
        if inside.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '±' | '.')) && is_new {
            self.notes.stated = Some(self.stated(group)?);
            return Ok(());
        }
        if !inside.is_empty() && inside.chars().all(|c| c.is_ascii_uppercase()) {
            let known: Vec<&str> = Modifier::ALL.into_iter().map(Modifier::letters).collect();
            let kind = Kind::Modifier { given: shorten(inside), known: known.join(" ") };
            return Err(self.error(group, kind));
        }
        Err(self.error(group, Kind::TooMuch { found: shorten(&self.slice(group)) }))
    }

    /// Deviations in brackets, or limits of size.
    fn stated(&self, group: &Range<usize>) -> Result<Deviations, CalloutError> {
        let is_inside = |at: usize| group.start < at && at + 1 < group.end;
        let text: String = self.chars.iter().enumerate().map(|(at, c)| if is_inside(at) { *c } else { ' ' }).collect();
        let given = |error| CalloutError { text: shorten(self.given.trim()), ..error };
        if let Ok(Callout { nominal: middle, tolerance: Tolerance::Limits { maximum, minimum }, .. }) =
            reading::callout(&text)
        {
            let before: String = self.chars.iter().take(group.start).collect();
            let nominal = Reader::new(&before, Grammar::Callout).size().map_or(middle, |size| size.value);
            return Ok(Deviations::spanning(maximum.saturating_sub(nominal), minimum.saturating_sub(nominal)));
        }
        Reader::new(&text, Grammar::Callout).lone_band().map_err(given)
    }

    /// Letters in circles: `Ⓔ`, `ⒼⒼ`.
    fn circles(&mut self) -> Result<(), CalloutError> {
        let letter = |c: &char| match c {
            '\u{24b6}'..='\u{24cf}' => u32::from(*c).checked_sub(0x24b6 - 0x41).and_then(char::from_u32),
            _ => None,
        };
        while let Some(start) = self.chars.iter().position(|c| letter(c).is_some()) {
            let letters: String = self.chars.iter().skip(start).map_while(letter).collect();
            let group = start..start + letters.len();
            self.bracket(&letters, &group)?;
            self.blank(group);
        }
        Ok(())
    }

    /// Modifiers and a count as the last words: `25 H7 E`, `8 H7 2x`.
    fn last_words(&mut self) {
        loop {
            let Range { start, end } = self.whole();
            let length = self.chars.iter().take(end).rev().take_while(|c| !c.is_whitespace()).count();
            let word = end - length..end;
            if word.start <= start {
                return;
            }
            let text = self.slice(&word);
            let modifier = Modifier::from_letters(&text);
            if let Some(modifier) = modifier {
                self.notes.modifiers.add(modifier);
            } else if !text.strip_suffix(['x', 'X']).is_some_and(|digits| self.take_count(digits)) {
                return;
            }
            self.blank(word);
        }
    }

    /// `ISO 2768-mK`, `ISO 2768-1 m`, `mK`: the class for sizes stays, that for form is noted.
    fn general_class(&mut self) {
        let text = self.text().to_ascii_uppercase();
        if let Some(found) = text.find("2768") {
            // ASCII alone: a byte is a character here, for what stands before may only be a size and these words.
            let before = text.get(..found).unwrap_or("");
            let name = before.trim_end().trim_end_matches("ISO").trim_end().trim_end_matches("EN").trim_end();
            let name = name.trim_end_matches("DIN").trim_end();
            let start = name.chars().count();
            let mut end = before.chars().count() + "2768".len();
            let part = self.slice(&(end..end + 2));
            end += if part == "-1" { 2 } else { 0 };
            while matches!(self.chars.get(end), Some('-' | ' ')) {
                end += 1;
            }
            self.blank(start..end);
        }
        let Range { end, .. } = self.whole();
        let Some(form) = end.checked_sub(1).and_then(|at| FormClass::from_letter(*self.chars.get(at)?)) else { return };
        let dash = usize::from(end.checked_sub(2).and_then(|at| self.chars.get(at)) == Some(&'-'));
        let at = |back: usize| end.checked_sub(back + dash).and_then(|at| self.chars.get(at)).copied();
        let is_general = at(2).is_some_and(|c| GeneralClass::from_letter(c.encode_utf8(&mut [0; 4])).is_some());
        if is_general && at(3).is_some_and(|c| c.is_ascii_digit() || c.is_whitespace() || matches!(c, '.' | ',')) {
            self.notes.form = Some(form);
            self.blank(end - 1 - dash..end);
        }
    }

    /// `25 ±IT7/2` and `25 ±IT7`; `None` where there is no such thing.
    fn half_grade(&self, text: &str) -> Option<Result<Callout, CalloutError>> {
        let (before, behind) = text.split_once('±')?;
        let grade = behind.trim().strip_prefix("IT")?;
        let (digits, half) = match grade.split_once('/') {
            Some((digits, two)) if two.trim() == "2" => (digits, 2),
            Some(_) => return None,
            None => (grade, 1),
        };
        let size = match Reader::new(before, Grammar::Callout).size() {
            Ok(size) => size,
            Err(error) => return Some(Err(error)),
        };
        let nominal = size.value;
        let width = digits.trim().parse().ok().and_then(Grade::numbered);
        let width = width.and_then(|grade| standard_tolerance(grade, nominal));
        let Some(around) = width.and_then(|width| Length::from_nanometres(width.nanometres() / half).ok()) else {
            let start = before.chars().count();
            let kind = Kind::Grade { given: format!("IT{}", shorten(digits.trim())), nominal };
            return Some(Err(self.error(&(start..start + behind.trim_end().chars().count() + 1), kind)));
        };
        Some(Callout::with_deviations(nominal, Deviations::spanning(around, around.negated())))
    }

    /// A class with its deviations behind it and no brackets: `25 H7 +0.021 0`.
    fn class_and_band(&mut self, text: &str) -> Option<Result<Callout, CalloutError>> {
        let is_new = self.notes.stated.is_none() && self.class.is_none();
        let at = text.find([' ']).filter(|_| is_new)?;
        let signs = text.match_indices(" +").chain(text.match_indices(" ±")).chain(text.match_indices(" -"));
        let at = signs.map(|(place, _)| place).filter(|place| at <= *place).min()?;
        let (before, behind) = text.split_at_checked(at)?;
        let callout = reading::callout(before).ok().filter(|callout| callout.class().is_some())?;
        let stated = Reader::new(behind, Grammar::Callout).lone_band().ok()?;
        self.notes.stated = Some(stated);
        Some(Ok(callout))
    }

    fn with_notes(&mut self, callout: Callout) -> Result<Callout, CalloutError> {
        let mut callout = callout;
        if let Some(class) = self.class {
            // Class and deviations together mean the same, whichever of them is in brackets.
            match callout.tolerance() {
                Tolerance::Deviations(deviations) => self.notes.stated = Some(deviations),
                Tolerance::Limits { maximum, minimum } => {
                    let from = |limit: Length| limit.saturating_sub(callout.nominal());
                    self.notes.stated = Some(Deviations::spanning(from(maximum), from(minimum)));
                }
                Tolerance::Class(_) | Tolerance::Fit { .. } | Tolerance::General(_) => {
                    let whole = self.whole();
                    return Err(self.error(&whole, Kind::TooMuch { found: format!("({class})") }));
                }
            }
            callout = Callout::new(callout.nominal(), class)?;
        }
        let Some(stated) = self.notes.stated else { return Ok(callout.with_notes(self.notes)) };
        let whole = 0..self.chars.len();
        if matches!(callout.tolerance(), Tolerance::Fit { .. }) {
            return Err(self.error(&whole, Kind::StatedOfFit));
        }
        let nominal = callout.nominal();
        if let Some(meant) = thousandths(stated).filter(|_| widest(nominal) < stated.width())
            && meant.width() <= widest(nominal)
        {
            let offer = format!("{} {}", signed(meant.upper()), signed(meant.lower()));
            return Err(self.error(&whole, Kind::StatedMicrometres { nominal, offer }));
        }
        Ok(callout.with_notes(self.notes))
    }
}
