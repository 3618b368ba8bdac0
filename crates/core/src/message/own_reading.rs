//! Reads a file of the user's own texts: each text is taken, or refused with its place and the remedy.

use std::borrow::Cow;
use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

use fitcheck_shipped as shipped;
use fluent_syntax::ast::Entry;
use fluent_syntax::parser;

use super::bundle::{Bundle, NAMES};
use super::own::{DEEPEST, LARGEST_TEXTS, LONGEST, OwnTextFault, OwnTexts, READ_BACK};
use super::placeables::{self, Difference};
use super::{FilePlace, Located, is_wild, shortened};

/// For as many unknown names another one is looked for.
const MOST_GUESSED: usize = 100;

/// What a language says of itself; the program is built with it.
const PROPERTIES: [&str; 2] = ["language-name", "language-decimal-sign"];

/// The words of verdicts, line by line those that mean the same. No word of one line may be one of another line.
const VERDICTS: [&[&str]; 12] = [
    &["status-good", "report-side-good"],
    &["status-accepted", "guard-band-beyond"],
    &["status-rework", "report-side-rework", "side-rework", "found-rework"],
    &["status-re-measure", "guard-band"],
    &["status-out-of-limits", "report-side-out", "side-out"],
    &["status-scrap", "report-side-scrap", "side-scrap", "found-scrap"],
    &["rows-not-judged", "cycles-word-no-verdict"],
    &["cycles-word-stopped", "parts-page-balloon-open", "report-position-unknown", "walk-page-open"],
    &["fit-conforms", "report-inside", "report-position-in", "position-in"],
    &["fit-conforms-not", "beyond-limits", "report-position-out", "position-out"],
    &["records-page-not-good"],
    &["simulated", "cycles-simulated"],
];

/// What a reader has found so far.
struct Reading<'a> {
    built_in: &'a HashMap<&'static str, &'a str>,
    own: OwnTexts,
    /// The line in which each name was given first, also where its text was refused.
    given: HashMap<&'static str, usize>,
    guessed: usize,
}

impl OwnTexts {
    /// Reads a file by the name that the user gave it, `nl_OurShop.ftl`: it begins with the code of a language. Lines and columns count
    /// from 1, columns in characters.
    ///
    /// # Errors
    /// [`OwnTextFault`] where nothing of the file counts: no language, too large, or not UTF-8. What is wrong with single texts is in
    /// [`Self::refused`].
    pub fn read(file: &str, bytes: &[u8]) -> Result<Self, Located<OwnTextFault>> {
        let file: Arc<str> = file.into();
        let at_file =
            |what| Located { what, place: FilePlace { file: Some(Arc::clone(&file)), line: None, column: None } };
        let code = code_of(&file).ok_or_else(|| {
            let codes: Vec<&str> = shipped::languages().map(|(code, ..)| code).collect();
            at_file(OwnTextFault::Language { given: shortened(&file, 60), codes: codes.join(", ") })
        })?;
        if LARGEST_TEXTS < bytes.len() {
            return Err(at_file(OwnTextFault::TooLarge { bytes: bytes.len(), most: LARGEST_TEXTS }));
        }
        let text = std::str::from_utf8(bytes).map_err(|error| {
            let (before, rest) = bytes.split_at_checked(error.valid_up_to()).unwrap_or((bytes, &[]));
            let (line, column) = end_of(&String::from_utf8_lossy(before));
            let byte = rest.first().map_or_else(String::new, |byte| format!("{byte:02X}"));
            Located { what: OwnTextFault::NotUtf8 { byte }, place: FilePlace::in_file(&file, line, column) }
        })?;
        // The code is that of a built-in language, which has its texts; without them every name would be an unknown one.
        let texts = shipped::texts(code).unwrap_or(Cow::Borrowed(""));
        let built_in = NAMES.all().zip(texts.split('\0')).collect();
        let own = Self { code, file: Arc::clone(&file), texts: BTreeMap::new(), refused: Vec::new(), refused_count: 0 };
        let mut reading = Reading { built_in: &built_in, own, given: HashMap::new(), guessed: 0 };
        for (line, entry) in entries(text.strip_prefix('\u{feff}').unwrap_or(text)) {
            if let Err((what, at)) = reading.take(line, &entry) {
                let (further, column) = end_of(before(&entry, at));
                reading.own.refuse(what, line.saturating_add(further).saturating_sub(1), column);
            }
        }
        let mut own = reading.own;
        own.keep_verdicts_apart();
        own.refused.sort_by_key(|refused| (refused.place.line, refused.place.column));
        Ok(own)
    }

    /// How many texts a language has.
    pub fn count_of_all() -> usize {
        NAMES.all().count()
    }

    /// Refuses every own word of a verdict where one of them is also a word of another verdict: of the own ones, of the built-in ones of
    /// its language, or of the English ones that files of machines have.
    fn keep_verdicts_apart(&mut self) {
        let is_own = |name: &&&str| self.texts.contains_key(**name);
        let own: Vec<&'static str> = VERDICTS.iter().copied().flatten().filter(is_own).copied().collect();
        if own.is_empty() {
            return;
        }
        let replaced = Bundle::of(self.code).with_own(Some(Arc::new(self.clone())));
        let bundles = [&replaced, &Bundle::of(self.code), &Bundle::of("en")];
        let clash =
            VERDICTS.iter().flat_map(|same| same.iter().map(move |name| (same, *name))).find_map(|(same, name)| {
                let word = own.contains(&name).then(|| replaced.get(name))?;
                let is_said = |other: &&&str| bundles.iter().any(|bundle| plain(&bundle.get(other)) == plain(&word));
                let others = VERDICTS.iter().filter(|others| *others != same).copied().flatten();
                Some((name, word.clone(), *others.into_iter().find(is_said)?))
            });
        let Some((clash, word, other)) = clash else { return };
        for name in own {
            if let Some((line, _)) = self.texts.remove(name) {
                let word = shortened(&word, 60);
                self.refuse(OwnTextFault::SameVerdict { name, clash, word, other }, line, 1);
            }
        }
    }
}

impl<'a> Reading<'a> {
    /// Takes an entry.
    ///
    /// # Errors
    /// Why not, and at which byte of it.
    fn take(&mut self, line: usize, entry: &str) -> Result<(), (OwnTextFault, usize)> {
        let given = || shortened(entry.split(['=', '\n']).next().unwrap_or(entry).trim(), 60);
        if let Some((at, c)) = entry.char_indices().find(|(_, c)| is_wild(*c) && *c != '\n') {
            return Err((OwnTextFault::Control { given: given(), code: code_point(c) }, at));
        }
        let too_much = || OwnTextFault::TooMuch { given: given(), longest: LONGEST, deepest: DEEPEST };
        if LONGEST < entry.chars().count() || DEEPEST < depth(entry) {
            return Err((too_much(), 0));
        }
        if entry.split_once('=').is_some_and(|(_, text)| text.trim().is_empty()) {
            return Err((OwnTextFault::Empty { given: given() }, 0));
        }
        if let Some(at) = bad_escape(entry) {
            let reason = r"\u takes four hexadecimal digits, and \U six".to_owned();
            return Err((OwnTextFault::Syntax { given: given(), reason }, at));
        }
        let read = parser::parse_runtime(entry).map_err(|(_, errors)| {
            let first = errors.first();
            let reason = first.map_or_else(String::new, ToString::to_string);
            (
                OwnTextFault::Syntax { given: given(), reason },
                first.map_or(0, |error| error.pos.start.min(entry.trim_end().len())),
            )
        })?;
        let [Entry::Message(_)] = read.body.as_slice() else {
            return Err((OwnTextFault::NotAText { given: given() }, 0));
        };
        let (name, value) = read
            .body
            .first()
            .and_then(placeables::value)
            .ok_or_else(|| (OwnTextFault::NotAText { given: given() }, 0))?;
        let (name, built_in) = self.known(name).map_err(|fault| (fault, 0))?;
        if let Some(first) = self.given.get(name) {
            self.own.texts.remove(name);
            return Err((OwnTextFault::Twice { name, first: *first }, 0));
        }
        self.given.insert(name, line);
        if READ_BACK.contains(&name) {
            return Err((OwnTextFault::ReadBack { name }, 0));
        }
        if PROPERTIES.contains(&name) {
            return Err((OwnTextFault::Property { name }, 0));
        }
        placeables::compare(&value, &format!("{name} = {built_in}\n")).map_err(|difference| {
            let fault = match difference {
                Difference::Empty => OwnTextFault::Empty { given: given() },
                Difference::Wild(c) => OwnTextFault::Control { given: given(), code: code_point(c) },
                Difference::Surplus(given, allowed) if allowed.is_empty() => {
                    OwnTextFault::SurplusOfNone { name, given }
                }
                Difference::Surplus(given, allowed) => OwnTextFault::Surplus { name, given, allowed },
                Difference::Lost(lost) => OwnTextFault::Lost { name, lost },
                Difference::TooMany => too_much(),
            };
            (fault, 0)
        })?;
        self.own.texts.insert(name, (line, entry.to_owned()));
        Ok(())
    }

    /// A name with its built-in text.
    fn known(&mut self, name: &str) -> Result<(&'static str, &'a str), OwnTextFault> {
        if let Some((known, text)) = self.built_in.get_key_value(name) {
            return Ok((known, text));
        }
        self.guessed = self.guessed.saturating_add(1);
        let nearest = if self.guessed <= MOST_GUESSED { nearest(name) } else { None };
        let name = shortened(name, 60);
        Err(nearest
            .map_or(OwnTextFault::Unknown { name: name.clone() }, |nearest| OwnTextFault::Misspelt { name, nearest }))
    }
}

/// The code with which the name of a file begins: `nl.ftl`, `nl_OurShop.ftl`.
fn code_of(file: &str) -> Option<&'static str> {
    let begin = file.split(['_', '-', '.']).next()?;
    shipped::languages().map(|(code, ..)| code).find(|code| code.eq_ignore_ascii_case(begin))
}

/// The entries of a file, each with the line in which it begins. Comments are none.
fn entries(text: &str) -> Vec<(usize, String)> {
    let mut entries: Vec<(usize, String)> = Vec::new();
    let mut goes_on = false;
    for (line, content) in (1..).zip(text.lines()) {
        if content.starts_with('#') {
            goes_on = false;
            continue;
        }
        goes_on &= content.is_empty() || content.starts_with([' ', '\t', '}', '[', '*', '.']);
        match entries.last_mut() {
            Some((_, entry)) if goes_on => {
                entry.push('\n');
                entry.push_str(content);
            }
            _ if content.trim().is_empty() => {}
            _ => {
                entries.push((line, content.to_owned()));
                goes_on = true;
            }
        }
    }
    for (_, entry) in &mut entries {
        entry.truncate(entry.trim_end().len());
        entry.push('\n');
    }
    entries
}

/// What stands before a byte of a text, up to the beginning of its letter.
fn before(text: &str, at: usize) -> &str {
    (0..=at.min(text.len())).rev().find_map(|at| text.get(..at)).unwrap_or("")
}

/// The line and the column behind a text, from 1.
fn end_of(text: &str) -> (usize, usize) {
    let last = text.rsplit('\n').next().unwrap_or(text);
    (text.matches('\n').count().saturating_add(1), last.chars().count().saturating_add(1))
}

/// How deep braces and parentheses stand in each other.
fn depth(text: &str) -> usize {
    let (mut now, mut most) = (0_usize, 0_usize);
    for byte in text.bytes() {
        match byte {
            b'{' | b'(' => now = now.saturating_add(1),
            b'}' | b')' => now = now.saturating_sub(1),
            _ => {}
        }
        most = most.max(now);
    }
    most
}

/// The byte at which an escape in a quoted text lacks its hexadecimal digits: Fluent's reader counts their bytes without looking at them, and
/// ends within a letter.
fn bad_escape(entry: &str) -> Option<usize> {
    let bytes = entry.as_bytes();
    let (mut depth, mut is_quoted, mut at) = (0_usize, false, 0_usize);
    while let Some(byte) = bytes.get(at) {
        match byte {
            b'"' if 0 < depth => is_quoted = !is_quoted,
            b'\n' => is_quoted = false,
            b'{' if !is_quoted => depth = depth.saturating_add(1),
            b'}' if !is_quoted => depth = depth.saturating_sub(1),
            b'\\' if is_quoted => {
                at = at.saturating_add(1);
                let digits = match bytes.get(at) {
                    Some(b'u') => 4,
                    Some(b'U') => 6,
                    _ => 0,
                };
                let given = bytes.iter().skip(at.saturating_add(1)).take(digits);
                if given.filter(|byte| byte.is_ascii_hexdigit()).count() < digits {
                    return Some(at);
                }
            }
            _ => {}
        }
        at = at.saturating_add(1);
    }
    None
}

fn code_point(c: char) -> String {
    format!("U+{:04X}", u32::from(c))
}

/// A word without what nobody reads as a difference: case, blanks, signs.
fn plain(word: &str) -> String {
    let letters: String = word.chars().filter(|c| c.is_alphanumeric()).flat_map(char::to_lowercase).collect();
    if letters.is_empty() { word.trim().to_owned() } else { letters }
}

/// The existing name that is nearest to an unknown one, where it is near enough to be meant.
fn nearest(name: &str) -> Option<&'static str> {
    let most = (name.len() / 4).clamp(2, 6);
    let near = NAMES.all().filter(|known| known.len().abs_diff(name.len()) <= most);
    let (changes, known) = near.map(|known| (changes(name, known), known)).min()?;
    (changes <= most).then_some(known)
}

/// How many letters have to be put in, left out or replaced to make one name of another (Levenshtein's distance).
fn changes(from: &str, to: &str) -> usize {
    let mut row: Vec<usize> = (0..=to.len()).collect();
    for (number, a) in (1..).zip(from.bytes()) {
        let mut diagonal = std::mem::replace(row.first_mut().map_or(&mut 0, |first| first), number);
        let mut left = number;
        for (here, b) in row.iter_mut().skip(1).zip(to.bytes()) {
            let replaced = diagonal.saturating_add(usize::from(a != b));
            diagonal = *here;
            *here = replaced.min(diagonal.saturating_add(1)).min(left.saturating_add(1));
            left = *here;
        }
    }
    row.last().copied().unwrap_or(0)
}
