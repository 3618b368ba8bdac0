//! One measuring cycle as a block of an NC program: `TCH PROBE 427 … ~ Q263=+35 ;TEXT ~`, or `G785 R0 BR0 K2` of a lathe
//! control. Reading and writing; a whole program is another matter.
//!
//! Blocks as in seeds `004_5791de5c83bc5f1a.txt` and `003_a450c9437c7f7424.txt`. Remarks behind a semicolon are not read:
//! they differ with the dialogue language.

use crate::probing::cycle::{Cycle, CycleError, Inputs, Key, Parameter, Value};
use crate::probing::cycles::cycle_named;
use crate::words::{Language, Message, Say};

/// The longest block that is read, in characters: a real one has a thousand.
const LONGEST: usize = 100_000;

/// What a block says.
#[derive(Debug)]
pub struct Block {
    /// Its cycle, where it names one.
    pub cycle: Option<&'static Cycle>,
    /// Names and values as they stand there, in their order.
    pub settings: Vec<(String, String)>,
}

/// Why a text is no block.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum BlockError {
    /// Nothing is set.
    #[error("the block sets no parameter")]
    Empty,
    /// Far too much.
    #[error("the block is longer than {LONGEST} characters")]
    TooLong,
    /// A cycle that is not known.
    #[error("cycle {code} is not known")]
    UnknownCycle {
        /// What stands there.
        code: String,
    },
    /// A piece that is neither a header nor a setting.
    #[error("{piece} is no setting such as Q263=+35")]
    NoSetting {
        /// What stands there.
        piece: String,
    },
    /// A parameter that occurs twice.
    #[error("{key} stands there twice")]
    Twice {
        /// The parameter.
        key: Key,
    },
    /// A parameter that the cycle does not have.
    #[error(transparent)]
    Cycle(#[from] CycleError),
}

impl Say for BlockError {
    fn message(&self) -> Message {
        match self {
            Self::Empty => Message::new("block-empty"),
            Self::TooLong => Message::new("block-too-long").text("most", LONGEST),
            Self::UnknownCycle { code } => Message::new("block-unknown-cycle").text("code", code),
            Self::NoSetting { piece } => Message::new("block-no-setting").text("piece", piece),
            Self::Twice { key } => Message::new("block-twice").text("key", key),
            Self::Cycle(error) => error.message(),
        }
    }
}

impl Block {
    /// Reads a block, with its line breaks or without.
    ///
    /// # Errors
    /// [`BlockError`] for a piece that cannot be read.
    pub fn read(text: &str) -> Result<Self, BlockError> {
        if LONGEST < text.chars().take(LONGEST + 1).count() {
            return Err(BlockError::TooLong);
        }
        let mut block = Self { cycle: None, settings: Vec::new() };
        // A remark ends with its line, or where the block goes on.
        let pieces = text.split(['~', '\n', '\r']).map(|piece| piece.split(';').next().unwrap_or_default().trim());
        for piece in pieces.filter(|piece| !piece.is_empty()) {
            match (piece.split_once('='), code(piece)) {
                (Some((name, value)), _) if name.split_whitespace().count() == 1 => {
                    let value = value.trim().trim_matches('"').trim_start_matches('+');
                    block.settings.push((name.trim().to_owned(), value.to_owned()));
                }
                (None, Some((code, rest))) if block.cycle.is_none() => {
                    let unknown = || BlockError::UnknownCycle { code: code.to_owned() };
                    block.cycle = Some(cycle_named(code).ok_or_else(unknown)?);
                    if code.starts_with(['G', 'g']) {
                        block.settings.extend(rest.split_whitespace().map(word).collect::<Result<Vec<_>, _>>()?);
                    }
                }
                _ => return Err(BlockError::NoSetting { piece: shortened(piece) }),
            }
        }
        if block.settings.is_empty() { Err(BlockError::Empty) } else { Ok(block) }
    }

    /// The parameters of a cycle that the block sets, each with its value as a text.
    ///
    /// # Errors
    /// [`BlockError`] for a parameter that the cycle does not have, or has twice.
    pub fn parameters(&self, cycle: &Cycle) -> Result<Vec<(&'static Parameter, &str)>, BlockError> {
        let mut found: Vec<(&'static Parameter, &str)> = Vec::new();
        for (name, value) in &self.settings {
            let unknown = || CycleError::NoSuchParameter { cycle: cycle.code, parameter: name.clone() };
            let parameter = cycle.parameter_named(name).ok_or_else(unknown)?;
            if found.iter().any(|(known, _)| known.key == parameter.key) {
                return Err(BlockError::Twice { key: parameter.key });
            }
            found.push((parameter, value));
        }
        Ok(found)
    }
}

/// The cycle that a header names, and what stands behind it: `11 TCH PROBE 427 MEASURE COORDINATE`, `N3 G785 R0`.
fn code(piece: &str) -> Option<(&str, &str)> {
    let (_, behind) = piece.split_once("PROBE ").or_else(|| {
        let at = piece.find(['G', 'g']).filter(|at| *at == 0 || piece.get(..*at).is_some_and(|n| n.ends_with(' ')))?;
        piece.split_at_checked(at)
    })?;
    let behind = behind.trim_start();
    Some(behind.split_once(char::is_whitespace).unwrap_or((behind, "")))
}

/// An address of a lathe control: letters and a number.
fn word(text: &str) -> Result<(String, String), BlockError> {
    let figure = text.find(|c: char| !c.is_ascii_alphabetic()).filter(|at| 0 < *at);
    let (name, value) = figure
        .and_then(|at| text.split_at_checked(at))
        .ok_or_else(|| BlockError::NoSetting { piece: shortened(text) })?;
    Ok((name.to_owned(), value.trim_start_matches(['=', '+']).to_owned()))
}

fn shortened(piece: &str) -> String {
    piece.chars().take(40).collect()
}

/// The block of a cycle with its inputs, defaults filled in, as a control writes it.
pub fn write_block(cycle: &Cycle, inputs: &Inputs, language: Language) -> String {
    let value = |parameter: &Parameter| inputs.value(parameter.key).cloned().or_else(|| parameter.default_value());
    let given = cycle.parameters.iter().filter_map(|parameter| Some((parameter, value(parameter)?)));
    if cycle.code.starts_with('G') {
        let words = given.map(|(parameter, value)| format!(" {}{}", parameter.key, bare(&value)));
        return format!("{}{}\n", cycle.code, words.collect::<String>());
    }
    let header = format!("TCH PROBE {} {}", cycle.code, cycle.name(language));
    given.fold(header, |block, (parameter, value)| {
        let (key, value) = match (parameter.key, &value) {
            (Key::Q(number), Value::Text(_)) => (Key::Qs(number), bare(&value)),
            (key, Value::Text(_) | Value::Band(_) | Value::Predef) => (key, bare(&value)),
            (key, _) => (key, signed(&bare(&value))),
        };
        let value = if matches!(key, Key::Qs(_)) { format!("\"{value}\"") } else { value };
        format!("{block} ~\n    {:<16};{}", format!("{key}={value}"), parameter.name_in(language))
    }) + "\n"
}

fn bare(value: &Value) -> String {
    value.to_string().trim_end_matches('°').to_owned()
}

fn signed(figures: &str) -> String {
    if figures.starts_with('-') { figures.to_owned() } else { format!("+{figures}") }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::Words;

    #[track_caller]
    fn check(text: &str, expected: &str) {
        let said = match Block::read(text) {
            Ok(block) => {
                let settings: Vec<_> = block.settings.iter().map(|(name, value)| format!("{name}={value}")).collect();
                format!("{} {}", block.cycle.map_or("?", |cycle| cycle.code), settings.join(" "))
            }
            Err(error) => {
                assert_eq!(Words::new(Language::En).told(&error), error.to_string());
                let dutch = Words::new(Language::Nl).told(&error);
                assert!(dutch != error.to_string() && dutch != error.message().id, "{dutch}");
                error.to_string()
            }
        };
        assert_eq!(said, expected);
    }

    #[test]
    fn blocks_of_the_seeds_are_read() {
        check(
            "11 TCH PROBE 427 MISURAZ. COORDINATA ~\n\nQ263=+35\n\n;1. PUNTO 1. ASSE ~\n\nQ267=-1 ;DIREZIONE ~\r\nQ330=+0",
            "427 Q263=35 Q267=-1 Q330=0",
        );
        check(
            "TCH PROBE 427 MEASURE COORDINATE ~ Q263=+35 ;1ST POINT ~ Q320= PREDEF ;CLEARANCE",
            "427 Q263=35 Q320=PREDEF",
        );
        check("N3 G785 R0 BR0 K2 C0 RC60 I0 J0 Q0 P0 H0", "G785 R=0 BR=0 K=2 C=0 RC=60 I=0 J=0 Q=0 P=0 H=0");
        check("QS400=\"0.4-0.1\" ;TOLERANCE", "? QS400=0.4-0.1");
    }

    #[test]
    fn what_is_no_block_is_refused() {
        check("", "the block sets no parameter");
        check("TCH PROBE 427 MEASURE COORDINATE", "the block sets no parameter");
        check("TCH PROBE 431 MEASURE PLANE ~ Q263=1", "cycle 431 is not known");
        check("Q263 35", "Q263 35 is no setting such as Q263=+35");
        check("L X+10 R0 FMAX", "L X+10 R0 FMAX is no setting such as Q263=+35");
        check("G785 R0 +5", "+5 is no setting such as Q263=+35");
        check(&"x".repeat(100_001), "the block is longer than 100000 characters");
        let cycle = cycle_named("427").unwrap();
        let refused = |text: &str| Block::read(text).unwrap().parameters(cycle).unwrap_err().to_string();
        assert_eq!(refused("Q263=1 ~ Q999=2"), "cycle 427 has no parameter Q999");
        assert_eq!(refused("Q263=1 ~ q263=2"), "Q263 stands there twice");
    }

    #[test]
    fn what_is_written_is_read_back() {
        for (code, settings) in [
            ("427", &["Q263=35", "Q264=-45", "Q261=5", "Q272=3", "Q267=-1", "Q330=\"T 1\"", "Q320=PREDEF"][..]),
            ("444", &["Q263=1.5", "Q264=2", "Q294=3", "Q581=0", "Q582=0.5", "Q583=1", "QS400=0.4-0.1"]),
            ("421", &["Q273=50", "Q274=50", "Q262=75", "Q325=45", "Q247=-30"]),
            ("G785", &["K=-2.5", "RC=60", "BR=1"]),
        ] {
            let cycle = cycle_named(code).unwrap();
            let inputs = settings.iter().fold(Inputs::new(), |inputs, setting| {
                let (name, text) = setting.split_once('=').unwrap();
                cycle.set(inputs, name, text.trim_matches('"')).unwrap()
            });
            let text = write_block(cycle, &inputs, Language::It);
            let block = Block::read(&text).unwrap();
            assert_eq!(block.cycle.map(|cycle| cycle.code), Some(code), "{text}");
            for (parameter, value) in block.parameters(cycle).unwrap() {
                let expected = inputs.value(parameter.key).cloned().or_else(|| parameter.default_value());
                assert_eq!(parameter.read(value).ok(), expected, "{text}");
            }
        }
        let cycle = cycle_named("427").unwrap();
        let text = write_block(cycle, &Inputs::new(), Language::It);
        assert!(
            text.starts_with("TCH PROBE 427 MISURAZ. COORDINATA ~\n    Q320=+0         ;DISTANZA SICUREZZA ~\n"),
            "{text}"
        );
    }

    #[test]
    fn no_text_makes_the_reader_panic() {
        proptest::proptest!(|(text in "(TCH PROBE |G785|Q[0-9]{1,3}=|[ -~\n;~]){0,12}")| {
            let _read = Block::read(&text);
        });
    }
}
