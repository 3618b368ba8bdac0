//! One block of a probing cycle in an NC program: `TCH PROBE 427 …` of a milling control, `G785 …` of a lathe.
//!
//! | file | what |
//! |---|---|
//! | this one | reading a block into pairs of name and text; writing one from a cycle's declaration |
//! | `fault` | what is wrong with a block |
//!
//! A reader goes by numbers and order of characters, never by names and comments, which follow the dialogue language.
//! Grammar and layout: the examples of seeds `003_a450c9437c7f7424.txt` and `004_5791de5c83bc5f1a.txt`. Nothing here
//! runs a program: a value that is a Q parameter stays text.

mod fault;

pub use fault::{ProbeBlockError, ProbeBlockFault};

use super::text::lines;
use crate::probing::cycle::{Cycle, Inputs, Key, Parameter, Value};
use crate::probing::cycles::{CYCLES, cycle_named};
use crate::words::Language;

/// Between lines that are written.
const LINE_END: &str = "\r\n";

/// How a parameter of a milling control is written, for errors.
const EXAMPLE: &str = "Q263=+35";

/// A block as it was read: the cycle and its parameters as texts.
#[derive(Debug, Clone)]
pub struct ProbeBlock {
    /// The line that it begins on, from 1.
    pub line: usize,
    /// The cycle.
    pub cycle: &'static Cycle,
    /// Its parameters in the order of the block.
    pub settings: Vec<Setting>,
    /// The first line that is part of no block and was not used, if there is one.
    pub unused: Option<Unused>,
}

/// A parameter of a block.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Setting {
    /// The line that it stands on, from 1.
    pub line: usize,
    /// Its name as it was written: `Q263`, `QS400`, `BR`.
    pub key: String,
    /// Its value as it was written, without quotation marks: `+35`, `PREDEF`, `+Q1`.
    pub text: String,
}

/// Lines of a program beside the block.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unused {
    /// The first of them, from 1.
    pub line: usize,
    /// Its text.
    pub text: String,
    /// How many more there are.
    pub more: usize,
}

impl std::fmt::Display for Unused {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { line, text, more } = self;
        write!(f, "line {line}: {text} is not part of the probing cycle and was not used")?;
        if 0 < *more { write!(f, ", and {more} more") } else { Ok(()) }
    }
}

impl crate::words::Say for Unused {
    fn message(&self) -> crate::words::Message {
        let id = if self.more == 0 { "block-unused" } else { "block-unused-more" };
        let message = crate::words::Message::new(id).text("line", self.line).text("text", &self.text);
        if self.more == 0 { message } else { message.text("more", self.more) }
    }
}

impl ProbeBlock {
    /// The block's values put into inputs; ranges are checked when the cycle runs.
    ///
    /// # Errors
    /// [`ProbeBlockError`] with the line of a parameter that the cycle does not have, or of a text that is no value.
    pub fn put_into(&self, inputs: Inputs) -> Result<Inputs, ProbeBlockError> {
        self.settings.iter().try_fold(inputs, |inputs, Setting { line, key, text }| {
            let fault = match self.cycle.set(inputs, key, text) {
                Ok(inputs) => return Ok(inputs),
                Err(_) if is_reference(text) => ProbeBlockFault::Reference {
                    key: key.clone(),
                    given: text.trim_start_matches(['+', '-']).to_owned(),
                },
                Err(error) => ProbeBlockFault::Cycle(error),
            };
            Err(fault.at(*line))
        })
    }
}

/// Whether a text is a parameter of a program, `+Q1`, `QS12`, `-QL3`.
fn is_reference(text: &str) -> bool {
    let bare = text.trim().trim_start_matches(['+', '-']).trim_start().to_ascii_uppercase();
    bare.strip_prefix('Q').is_some_and(|rest| {
        let number = rest.trim_start_matches(['L', 'R', 'S']);
        rest.len() <= number.len() + 1 && !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit())
    })
}

/// Reads the one block of a probing cycle in a text: the block alone, or a program with one.
///
/// Block numbers and names are not looked at, blank lines and comments are passed over, `~` at the end of a line takes
/// the next one in. Other blocks of a program are not used, and named in [`ProbeBlock::unused`].
///
/// ```
/// use fitcheck::control::probe_block::read;
/// use fitcheck::probing::cycle::Inputs;
///
/// let block = read("5 TCH PROBE 427 MEASURE COORDINATE ~\n  Q272=+3 ;MEASURING AXIS ~\n  Q263=+35 ;1ST POINT 1ST AXIS")?;
/// assert_eq!((block.cycle.code, block.settings.len()), ("427", 2));
/// assert!(block.put_into(Inputs::new())?.is_given(272));
/// # Ok::<(), fitcheck::control::probe_block::ProbeBlockError>(())
/// ```
///
/// # Errors
/// [`ProbeBlockError`]: no block or two, a cycle that is not known, a line that is no parameter, a parameter twice, a
/// block that is cut off.
pub fn read(text: &str) -> Result<ProbeBlock, ProbeBlockError> {
    let mut reader = Reader::default();
    for (number, line) in lines(text) {
        let (segments, is_closed) = segments(line);
        // Any other block of a program may hold what it likes.
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

/// What stands between two `~`, or a line without one.
#[derive(Debug)]
struct Segment<'a> {
    code: &'a str,
    has_comment: bool,
    /// Whether a `~` stands behind it.
    goes_on: bool,
}

/// A line cut at every `~` outside quotation marks, a blank rest is none; and whether every mark has its partner.
fn segments(line: &str) -> (Vec<Segment<'_>>, bool) {
    let mut found = Vec::new();
    let (mut start, mut comment, mut quoted) = (0, None, false);
    let segment = |start: usize, end: usize, comment: Option<usize>, goes_on: bool| {
        let code = line.get(start..comment.unwrap_or(end)).unwrap_or_default().trim();
        Segment { code, has_comment: comment.is_some(), goes_on }
    };
    for (at, character) in line.char_indices() {
        match character {
            '"' if comment.is_none() => quoted = !quoted,
            ';' if !quoted && comment.is_none() => comment = Some(at),
            '~' if !quoted => {
                found.push(segment(start, at, comment, true));
                (start, comment) = (at + 1, None);
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
    /// Before the block, or well behind it.
    #[default]
    Outside,
    /// A `~` has promised another line.
    Promised,
    /// The last line had neither `~` nor comment: as the seed is printed, its comment and its `~` may follow.
    Open,
    /// Behind the last line of the block.
    Behind,
}

#[derive(Debug, Default)]
struct Reader {
    state: State,
    block: Option<ProbeBlock>,
    unused: Option<Unused>,
    last: usize,
}

impl Reader {
    fn take(&mut self, segment: &Segment<'_>, line: usize) -> Result<(), ProbeBlockError> {
        if segment.code.is_empty() {
            if self.state == State::Open || self.state == State::Promised {
                self.state = match (segment.goes_on, &self.state) {
                    (true, _) | (false, State::Promised) => State::Promised,
                    _ => State::Behind,
                };
            }
            return Ok(());
        }
        if self.state == State::Promised {
            self.setting(segment.code, line)?;
            self.follow(segment);
            return Ok(());
        }
        self.outside(segment, line)
    }

    /// What comes behind a line of the block.
    const fn follow(&mut self, segment: &Segment<'_>) {
        self.state = match (segment.goes_on, segment.has_comment) {
            (true, _) => State::Promised,
            (false, true) => State::Behind,
            (false, false) => State::Open,
        };
    }

    fn outside(&mut self, segment: &Segment<'_>, line: usize) -> Result<(), ProbeBlockError> {
        let body = body(segment.code);
        let (cycle, words) = match head(body).map_err(|fault| fault.at(line))? {
            Some(head) => head,
            None => return self.beside(segment, line),
        };
        if let Some(first) = &self.block {
            return Err(ProbeBlockFault::SecondBlock { first: first.line }.at(line));
        }
        self.block = Some(ProbeBlock { line, cycle, settings: Vec::new(), unused: None });
        let Some(words) = words else {
            self.follow(segment);
            return Ok(());
        };
        for word in words.split_whitespace().filter(|word| *word != "*") {
            self.word(word, line)?;
        }
        self.state = State::Outside;
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
        if upper.starts_with("BEGIN PGM") || upper.starts_with("END PGM") || upper.starts_with('*') || upper == "%" {
            return Ok(());
        }
        match &mut self.unused {
            Some(unused) => unused.more += 1,
            None => self.unused = Some(Unused { line, text: shown(segment.code), more: 0 }),
        }
        Ok(())
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
        // More names than a cycle has parameters would be refused later; here they would only fill the memory.
        if block.cycle.parameter_named(key).is_none() {
            let error = block.cycle.set(Inputs::new(), key, text).map(drop);
            return error.map_err(|error| ProbeBlockFault::Cycle(error).at(line));
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

/// A block without its number and its mark for skipping, `/12`, `12 /`, `N3`.
fn body(code: &str) -> &str {
    let bare = code.trim_start_matches(|c: char| c == '/' || c.is_ascii_digit() || c.is_whitespace());
    let numbered = bare.strip_prefix(['N', 'n']).and_then(|rest| {
        let body = rest.trim_start_matches(|c: char| c.is_ascii_digit());
        (body.len() < rest.len()).then_some(body)
    });
    numbered.unwrap_or(bare).trim_start_matches(|c: char| c == '/' || c.is_whitespace())
}

/// The cycle that a block calls, and the words of its line where they stand on it: `G785 R0 BR0`. `None` for any other
/// block.
fn head(body: &str) -> Result<Option<(&'static Cycle, Option<&str>)>, ProbeBlockFault> {
    let (first, rest) = body.split_once(char::is_whitespace).unwrap_or((body, ""));
    if first.strip_prefix(['G', 'g']).is_some_and(|number| !number.is_empty()) {
        return Ok(cycle_named(first).map(|cycle| (cycle, Some(rest))));
    }
    let (second, rest) = rest.trim_start().split_once(char::is_whitespace).unwrap_or((rest.trim_start(), ""));
    if !first.eq_ignore_ascii_case("TCH") || !second.eq_ignore_ascii_case("PROBE") {
        return Ok(None);
    }
    let number = rest.split_whitespace().next().unwrap_or_default();
    let known = || CYCLES.iter().filter(|cycle| !is_lathe(cycle));
    let Some(cycle) = known().find(|cycle| cycle.code == number) else {
        let known = known().map(|cycle| cycle.code).collect::<Vec<_>>().join(", ");
        return Err(ProbeBlockFault::UnknownCycle { given: shown(number), known });
    };
    Ok(Some((cycle, None)))
}

/// A piece of the text as errors show it: not longer than a line of a program.
fn shown(text: &str) -> String {
    const MOST: usize = 80;
    let short: String = text.chars().take(MOST).map(|c| if c.is_control() { '\u{fffd}' } else { c }).collect();
    if text.chars().nth(MOST).is_some() { format!("{short}…") } else { short }
}

/// Whether the cycle is one of a lathe control, with address letters in one line.
fn is_lathe(cycle: &Cycle) -> bool {
    cycle.code.starts_with('G')
}

/// The block of a cycle with these inputs: every parameter of the declaration that was given or has a default, in its
/// order, with its name in a dialogue language where that is known. Without a block number; CRLF between lines.
///
/// ```
/// use fitcheck::control::probe_block::write;
/// use fitcheck::probing::cycle::Inputs;
/// use fitcheck::probing::cycles::cycle_named;
/// use fitcheck::words::Language;
///
/// let cycle = cycle_named("427").unwrap();
/// let block = write(cycle, &cycle.set(Inputs::new(), "Q263", "35")?, Language::It)?;
/// assert!(block.starts_with("TCH PROBE 427 MISURAZ. COORDINATA ~\r\n    Q263=+35   ;1. PUNTO 1. ASSE ~\r\n"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`ProbeBlockFault::NotWritable`], with the line of the block, for a text that no block can hold.
pub fn write(cycle: &Cycle, inputs: &Inputs, language: Language) -> Result<String, ProbeBlockError> {
    let mut pairs = Vec::new();
    for (line, parameter) in (2..).zip(cycle.parameters) {
        let given = inputs.value(parameter.key).cloned();
        if let Some(value) = given.or_else(|| parameter.default_with(inputs)) {
            let text = value_text(cycle, parameter, &value).map_err(|fault| fault.at(line))?;
            pairs.push((parameter, text));
        }
    }
    if is_lathe(cycle) {
        let words = pairs.iter().map(|(parameter, text)| format!(" {}{text}", parameter.key));
        return Ok(format!("{}{}{LINE_END}", cycle.code, words.collect::<String>()));
    }
    let mut block = format!("TCH PROBE {} {}", cycle.code, cycle.name(language));
    for (parameter, text) in pairs {
        let pair = match (parameter.key, inputs.value(parameter.key)) {
            // The name of a tool goes into the text parameter of the same number.
            (Key::Q(number), Some(Value::Text(_))) => format!("QS{number}={text}"),
            (key, _) => format!("{key}={text}"),
        };
        block.push_str(&format!(" ~{LINE_END}    {pair:<10} ;{}", parameter.name_in(language)));
    }
    block.push_str(LINE_END);
    Ok(block)
}

/// A value as a block has it: a sign for numbers of a milling control, quotation marks round a text.
fn value_text(cycle: &Cycle, parameter: &Parameter, value: &Value) -> Result<String, ProbeBlockFault> {
    let number = |number: String| {
        let is_plain = is_lathe(cycle) || number.starts_with('-');
        if is_plain { number } else { format!("+{number}") }
    };
    Ok(match value {
        Value::Length(length) => number(length.to_string()),
        Value::Angle(angle) => number(angle.to_string().trim_end_matches('°').to_owned()),
        Value::Whole(whole) => number(whole.to_string()),
        Value::Number(float) => number(float.to_string()),
        Value::Predef => value.to_string(),
        Value::Text(_) | Value::Band(_) => {
            let text = value.to_string();
            if text.contains(|c: char| c == '"' || c.is_control()) {
                return Err(ProbeBlockFault::NotWritable { key: parameter.key, given: shown(&text) });
            }
            format!("\"{text}\"")
        }
    })
}
