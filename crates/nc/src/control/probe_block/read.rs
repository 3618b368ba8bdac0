//! A block as pairs of name and text: one line at a time, split at every `~`.

use fitcheck_core::probing::cycle::{Control, Cycle, Inputs, Range};
use fitcheck_core::probing::cycles::{cycle_named, cycles_of};
use fitcheck_core::text::{first_word, lines, part};

use super::fault::{MOST_PARTS, ProbeBlockError, ProbeBlockFault};
use super::{ProbeBlock, Setting, Unused, shown};

/// How a parameter of a milling control is written, for errors.
const EXAMPLE: &str = "Q263=+35";

/// Reads the one block of a probing cycle in a text: the block alone, or a program with one.
///
/// Block numbers and names do not matter, blank lines and comments are skipped, `~` at the end of a line continues the
/// block on the next one. Other blocks of a program are skipped, and reported in [`ProbeBlock::unused`].
///
/// ```
/// use fitcheck_nc::control::probe_block::read;
/// use fitcheck_core::probing::cycle::Inputs;
///
/// let block = read("5 TCH PROBE 427 MEASURE COORDINATE ~\n  Q272=+3 ;MEASURING AXIS ~\n  Q263=+35 ;1ST POINT 1ST AXIS")?;
/// assert_eq!((block.cycle.code, block.settings.len()), ("427", 2));
/// assert!(block.put_into(Inputs::new())?.is_given(272));
/// # Ok::<(), fitcheck_nc::control::probe_block::ProbeBlockError>(())
/// ```
///
/// # Errors
/// [`ProbeBlockError`]: no block or two, an unknown cycle, a line that is not a parameter, a parameter given twice, a
/// block that is cut off.
pub fn read(text: &str) -> Result<ProbeBlock, ProbeBlockError> {
    read_with(text, Reader::default())
}

/// As [`read()`], of a program with several blocks the one that this line is of, from 1.
///
/// ```
/// use fitcheck_nc::control::probe_block::{beginnings, read_at};
///
/// let text = "1 TCH PROBE 421 A ~\n  Q262=+25\n2 L Z+50\n3 TCH PROBE 422 B ~\n  Q262=+10";
/// assert_eq!(read_at(text, 5)?.line, 4);
/// assert!(read_at(text, 3).is_err());
/// assert_eq!(beginnings(text), "1 (421), 4 (422)");
/// # Ok::<(), fitcheck_nc::control::probe_block::ProbeBlockError>(())
/// ```
///
/// # Errors
/// [`ProbeBlockFault::NoBlockAt`] where no block has the line; those of [`read()`] for this block.
pub fn read_at(text: &str, line: usize) -> Result<ProbeBlock, ProbeBlockError> {
    let none = || ProbeBlockFault::NoBlockAt { blocks: beginnings(text) }.at(line);
    let begins = heads(text).map(|(at, _)| at).take_while(|at| *at <= line).last().ok_or_else(none)?;
    let block = read_with(text, Reader { only: Some(begins), ..Reader::default() })?;
    let last = block.settings.iter().map(|setting| setting.line).max();
    if last.unwrap_or(block.line).max(block.line) < line { Err(none()) } else { Ok(block) }
}

/// The lines that the blocks of probing cycles in a text begin on, from 1, each with its cycle.
pub fn beginnings(text: &str) -> String {
    let listed: Vec<String> = heads(text).map(|(line, cycle)| format!("{line} ({})", cycle.code)).collect();
    listed.join(", ")
}

fn heads(text: &str) -> impl Iterator<Item = (usize, &'static Cycle)> {
    lines(text).filter_map(|(number, line)| {
        let (segments, _) = segments(line);
        let of = |segment: &Segment<'_>| head(body(segment.code)).ok().flatten().map(|(cycle, _)| cycle);
        segments.iter().find_map(of).map(|cycle| (number, cycle))
    })
}

fn read_with(text: &str, mut reader: Reader) -> Result<ProbeBlock, ProbeBlockError> {
    for (number, line) in lines(text) {
        let (segments, is_closed) = segments(line);
        if MOST_PARTS < segments.len() {
            return Err(ProbeBlockFault::TooManyParts.at(number));
        }
        // Any other block of a program may hold anything.
        if !is_closed && reader.state == State::Promised {
            return Err(ProbeBlockFault::UnclosedQuote.at(number));
        }
        for segment in segments {
            reader.take(&segment, number)?;
        }
        reader.last = number;
    }
    reader.end()
}

/// As [`read()`], but a text that begins no block is read as lines of this cycle: what people cut out of a program.
///
/// # Errors
/// As for [`read()`].
pub fn read_or_lines(text: &str, cycle: &'static Cycle) -> Result<ProbeBlock, ProbeBlockError> {
    match read(text) {
        Err(ProbeBlockError { what: ProbeBlockFault::NoBlock, .. }) if !text.trim().is_empty() => {
            let head = match cycle.control {
                Control::Lathe => cycle.code.to_owned(),
                Control::Milling => format!("TCH PROBE {} ~", cycle.code),
            };
            read(&format!("{head} {text}"))
        }
        answer => answer,
    }
}

/// What is between two `~`, or a line without one.
#[derive(Debug)]
struct Segment<'a> {
    code: &'a str,
    has_comment: bool,
    /// Whether a `~` follows it.
    goes_on: bool,
}

/// A line split at every `~` outside quotation marks, without a blank rest; and whether every mark has its partner.
/// What comes after one part too many is left out.
fn segments(line: &str) -> (Vec<Segment<'_>>, bool) {
    let mut found = Vec::new();
    let mut start = 0;
    let mut comment = None;
    let mut quoted = false;
    let segment = |start: usize, end: usize, comment: Option<usize>, goes_on: bool| {
        let code = part(line, start, comment.unwrap_or(end)).trim();
        Segment { code, has_comment: comment.is_some(), goes_on }
    };
    for (at, character) in line.char_indices() {
        match character {
            '"' if comment.is_none() => quoted = !quoted,
            ';' if !quoted && comment.is_none() => comment = Some(at),
            '~' if !quoted && MOST_PARTS < found.len() => break,
            '~' if !quoted => {
                found.push(segment(start, at, comment, true));
                start = at + 1;
                comment = None;
            }
            _ => {}
        }
    }
    let rest = segment(start, line.len(), comment, false);
    if !rest.code.is_empty() || rest.has_comment {
        found.push(rest);
    }
    (found, !quoted)
}

/// Where the reader is.
#[derive(Debug, Default, PartialEq, Eq)]
enum State {
    /// Before the block, or well after it.
    #[default]
    Outside,
    /// A `~` has announced another line.
    Promised,
    /// The last line had neither `~` nor comment; both may follow on the next line, as in the manual of cycle 427.
    Open,
    /// After the last line of the block.
    Behind,
    /// In a block of ISO: lines of it follow up to its `*`.
    Iso,
}

#[derive(Debug, Default)]
struct Reader {
    state: State,
    block: Option<ProbeBlock>,
    unused: Option<Unused>,
    last: usize,
    /// The line of the one block that counts, where it is known; others are left out.
    only: Option<usize>,
}

impl Reader {
    fn take(&mut self, segment: &Segment<'_>, line: usize) -> Result<(), ProbeBlockError> {
        if segment.code.is_empty() {
            if self.state == State::Open {
                self.state = if segment.goes_on { State::Promised } else { State::Behind };
            }
            return Ok(());
        }
        if self.state == State::Promised {
            self.settings(segment.code, line)?;
            self.follow(segment);
            return Ok(());
        }
        let first = first_word(segment.code);
        if self.state == State::Iso && (first.contains('=') || first.starts_with('*')) {
            return self.words(segment.code, line);
        }
        self.outside(segment, line)
    }

    /// Sets the state after a line of the block.
    const fn follow(&mut self, segment: &Segment<'_>) {
        self.state = match (segment.goes_on, segment.has_comment) {
            (true, _) => State::Promised,
            (false, true) => State::Behind,
            (false, false) => State::Open,
        };
    }

    fn outside(&mut self, segment: &Segment<'_>, line: usize) -> Result<(), ProbeBlockError> {
        let body = body(segment.code);
        if self.only.is_some_and(|only| only != line) {
            return self.beside(segment, line);
        }
        let Some((cycle, words)) = head(body).map_err(|fault| fault.at(line))? else {
            return self.beside(segment, line);
        };
        if let Some(first) = &self.block {
            return Err(ProbeBlockFault::SecondBlock { first: first.line }.at(line));
        }
        self.block = Some(ProbeBlock { line, cycle, settings: Vec::new(), unused: None });
        match words {
            HeadWords::None => self.follow(segment),
            HeadWords::Settings(settings) => {
                self.settings(settings, line)?;
                self.follow(segment);
            }
            HeadWords::Addresses(words) => self.words(words, line)?,
        }
        Ok(())
    }

    /// The words of a line; a `*` ends a block of ISO, and lathe controls have one line for each.
    fn words(&mut self, words: &str, line: usize) -> Result<(), ProbeBlockError> {
        let words = words.trim_end();
        let bare = words.trim_end_matches('*');
        for word in bare.split_whitespace() {
            self.word(word, line)?;
        }
        let is_milling = self.block.as_ref().is_some_and(|block| block.cycle.control == Control::Milling);
        self.state = if is_milling && bare == words { State::Iso } else { State::Outside };
        Ok(())
    }

    /// A line that begins no block.
    fn beside(&mut self, segment: &Segment<'_>, line: usize) -> Result<(), ProbeBlockError> {
        let is_behind = matches!(self.state, State::Open | State::Behind);
        let key = segment.code.split_once('=').map(|(key, _)| key.trim());
        let cycle = self.block.as_ref().map(|block| block.cycle);
        if is_behind && key.zip(cycle).is_some_and(|(key, cycle)| cycle.parameter_named(key).is_some()) {
            return Err(ProbeBlockFault::BehindEnd { given: shown(segment.code) }.at(line));
        }
        self.state = State::Outside;
        let upper = body(segment.code).to_ascii_uppercase();
        let is_begin = upper.starts_with("BEGIN PGM") || upper.starts_with('%');
        if is_begin && (upper.ends_with(" INCH") || upper.ends_with(" G70") || upper.ends_with(" G70 *")) {
            return Err(ProbeBlockFault::Inches.at(line));
        }
        if upper.starts_with("BEGIN PGM") || upper.starts_with("END PGM") || upper.starts_with('*') || upper == "%" {
            return Ok(());
        }
        match &mut self.unused {
            Some(unused) => unused.more += 1,
            None => self.unused = Some(Unused { line, text: shown(segment.code), more: 0 }),
        }
        Ok(())
    }

    /// `Q263=+35`, or several beside each other: `Q263=+35 Q264=+20`.
    fn settings(&mut self, code: &str, line: usize) -> Result<(), ProbeBlockError> {
        let starts = names(code);
        let ends = starts.iter().skip(1).copied().chain([code.len()]);
        // What stands before the first name belongs to it, so that it is refused with it.
        let begins = std::iter::once(0).chain(starts.iter().skip(1).copied());
        begins.zip(ends).try_for_each(|(start, end)| self.setting(part(code, start, end).trim(), line))
    }

    /// `Q263=+35`
    fn setting(&mut self, code: &str, line: usize) -> Result<(), ProbeBlockError> {
        let none = || ProbeBlockFault::NotAParameter { given: shown(code), example: EXAMPLE }.at(line);
        let (key, text) = code.split_once('=').ok_or_else(none)?;
        let key = key.trim();
        if key.is_empty() {
            return Err(none());
        }
        self.pair(key, text.trim(), line)
    }

    /// `K2`, `RC60`, `Q263=+35`: letters, then the value.
    fn word(&mut self, word: &str, line: usize) -> Result<(), ProbeBlockError> {
        if word.contains('=') {
            return self.setting(word, line);
        }
        let end = word.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(word.len());
        match word.split_at_checked(end) {
            Some((key, text)) if !key.is_empty() => self.pair(key, text, line),
            _ => Err(ProbeBlockFault::NotAParameter { given: shown(word), example: "K2" }.at(line)),
        }
    }

    fn pair(&mut self, key: &str, text: &str, line: usize) -> Result<(), ProbeBlockError> {
        let quoted = text.strip_prefix('"').and_then(|text| text.strip_suffix('"'));
        if text.is_empty() {
            return Err(ProbeBlockFault::NoValue { key: shown(key) }.at(line));
        }
        let Some(block) = &mut self.block else { return Ok(()) };
        let same = |other: &Setting| match (block.cycle.parameter_named(key), block.cycle.parameter_named(&other.key)) {
            (Some(one), Some(other)) => (one.key == other.key).then_some(one.key),
            _ => None,
        };
        if let Some((first, key)) = block.settings.iter().find_map(|other| Some((other.line, same(other)?))) {
            return Err(ProbeBlockFault::Twice { key, first }.at(line));
        }
        // More names than a cycle has parameters would be an error later; here they would only fill the memory.
        if block.cycle.parameter_named(key).is_none() {
            let error = block.cycle.set(Inputs::new(), key, text).map(drop);
            return error.map_err(|error| ProbeBlockFault::Cycle(Box::new(error)).at(line));
        }
        if let (None, Some(parameter)) = (quoted, block.cycle.parameter_named(key)) {
            // What else is wrong with it is found when it is used.
            if parameter.range == Range::Tool
                && let Err(error) = parameter.read_word(text)
            {
                return Err(ProbeBlockFault::Cycle(Box::new(error)).at(line));
            }
        }
        block.settings.push(Setting { line, key: key.to_owned(), text: quoted.unwrap_or(text).to_owned() });
        Ok(())
    }

    fn end(self) -> Result<ProbeBlock, ProbeBlockError> {
        if self.state == State::Promised {
            return Err(ProbeBlockFault::CutOff.at(self.last.max(1)));
        }
        let block = self.block.ok_or_else(|| ProbeBlockFault::NoBlock.at(1))?;
        Ok(ProbeBlock { unused: self.unused, ..block })
    }
}

/// A block without its number and its mark for block skip, `/12`, `12 /`, `N3`.
fn body(code: &str) -> &str {
    let bare = code.trim_start_matches(|c: char| c == '/' || c.is_ascii_digit() || c.is_whitespace());
    let numbered = bare.strip_prefix(['N', 'n']).and_then(|rest| {
        let body = rest.trim_start_matches(|c: char| c.is_ascii_digit());
        (body.len() < rest.len()).then_some(body)
    });
    numbered.unwrap_or(bare).trim_start_matches(|c: char| c == '/' || c.is_whitespace())
}

/// What stands behind the name of the cycle on the line that calls it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum HeadWords<'a> {
    /// Nothing, or the name of the cycle in words.
    None,
    /// `Q273=+50 Q274=+20`
    Settings(&'a str),
    /// `R0 BR0`, or the words of ISO.
    Addresses(&'a str),
}

/// Where each name before an equals sign begins; signs in quotation marks are none.
fn names(code: &str) -> Vec<usize> {
    let mut is_quoted = false;
    let mut starts = Vec::new();
    for (at, character) in code.char_indices() {
        match character {
            '"' => is_quoted = !is_quoted,
            '=' if !is_quoted => {
                let before = part(code, 0, at).trim_end();
                starts.push(before.rsplit(char::is_whitespace).next().map_or(0, |name| before.len() - name.len()));
            }
            _ => {}
        }
    }
    starts
}

/// The cycle that a block calls, and the words after it on its line: `G785 R0 BR0`. `None` for any other block.
fn head(body: &str) -> Result<Option<(&'static Cycle, HeadWords<'_>)>, ProbeBlockFault> {
    let (first, rest) = body.split_once(char::is_whitespace).unwrap_or((body, ""));
    let (first, rest) = first.strip_suffix('*').map_or((first, rest), |first| (first, "*"));
    if first.strip_prefix(['G', 'g']).is_some_and(|number| !number.is_empty()) {
        return Ok(cycle_named(first).map(|cycle| (cycle, HeadWords::Addresses(rest))));
    }
    let (second, rest) = rest.trim_start().split_once(char::is_whitespace).unwrap_or((rest.trim_start(), ""));
    if !first.eq_ignore_ascii_case("TCH") || !second.eq_ignore_ascii_case("PROBE") {
        return Ok(None);
    }
    let number = first_word(rest);
    let known = || cycles_of(Control::Milling);
    let Some(cycle) = known().find(|cycle| cycle.code == number) else {
        let known = known().map(|cycle| cycle.code).collect::<Vec<_>>().join(", ");
        return Err(ProbeBlockFault::UnknownCycle { given: shown(number), known });
    };
    // A name in words may come first: `421 MEASURE HOLE Q273=+50`.
    let words =
        names(rest).first().map_or(HeadWords::None, |start| HeadWords::Settings(part(rest, *start, rest.len())));
    Ok(Some((cycle, words)))
}
