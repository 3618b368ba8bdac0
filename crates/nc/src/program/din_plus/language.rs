//! The words of the language and what each is. Where the sources are not sure (`docs/SOURCES.md`, "DIN PLUS"), this is the one
//! place to change.

use fitcheck_core::text::until;

use super::super::block::Unit;

/// How the name of a main program ends.
pub(super) const MAIN: &str = ".nc";
/// How the name of a subprogram in a file of its own ends.
pub(super) const SUBPROGRAM: &str = ".ncs";

/// A section of a program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Section {
    /// Data for the control's head, turret and graphics: passed over.
    Data,
    /// Where the program runs.
    Machining,
    End,
}

/// The sections, German and English.
const SECTIONS: [(&str, Section); 20] = [
    ("PROGRAMMKOPF", Section::Data),
    ("PROGRAM HEAD", Section::Data),
    ("REVOLVER", Section::Data),
    ("TURRET", Section::Data),
    ("SPANNMITTEL", Section::Data),
    ("CHUCKING EQUIPMENT", Section::Data),
    ("ROHTEIL", Section::Data),
    ("BLANK", Section::Data),
    ("FERTIGTEIL", Section::Data),
    ("FINISHED PART", Section::Data),
    ("STIRN", Section::Data),
    ("FRONT", Section::Data),
    ("AUXILIARY CONTOUR", Section::Data),
    ("SURFACE", Section::Data),
    ("CONST", Section::Data),
    ("VAR", Section::Data),
    ("BEARBEITUNG", Section::Machining),
    ("MACHINING", Section::Machining),
    ("ENDE", Section::End),
    ("END", Section::End),
];

/// The sections as errors name them.
pub(super) const MACHINING: &str = "BEARBEITUNG / MACHINING";
/// The last section.
pub(super) const END: &str = "ENDE / END";
/// What a subprogram ends with.
pub(super) const RETURN: &str = "RETURN";
pub(super) const END_OF_UNIT: &str = "END_OF_UNIT";

/// The section that a line begins, with its word: alone, or with a number behind it (`REVOLVER 1`).
pub(super) fn section(code: &str) -> Option<(&'static str, Section)> {
    let code = code.trim();
    let is_it = |word: &str| {
        let rest = code.split_at_checked(word.len()).filter(|(begin, _)| begin.eq_ignore_ascii_case(word));
        rest.is_some_and(|(_, rest)| {
            let number = rest.trim_start();
            number.is_empty() || number.len() < rest.len() && number.bytes().all(|byte| byte.is_ascii_digit())
        })
    };
    SECTIONS.into_iter().find(|(word, _)| is_it(word))
}

/// Whether only a program of a lathe control begins so.
pub(super) fn begins_programs(line: &str) -> bool {
    let code = until(line, '[');
    let words = ["PROGRAMMKOPF", "PROGRAM HEAD", "BEARBEITUNG", "MACHINING"];
    section(code).is_some_and(|(word, _)| words.contains(&word))
}

/// The unit that a line of the head gives: `#EINHEIT METRISCH`; an error where it is no word for one.
pub(super) fn unit(line: &str) -> Option<Result<Unit, ()>> {
    let (key, value) = line.strip_prefix('#')?.split_once(char::is_whitespace)?;
    let is_one_of = |text: &str, words: &[&str]| words.iter().any(|word| word.eq_ignore_ascii_case(text.trim()));
    if !is_one_of(key, &["EINHEIT", "UNIT"]) {
        return None;
    }
    Some(match value {
        value if is_one_of(value, &["METRISCH", "METRIC", "MM"]) => Ok(Unit::Mm),
        value if is_one_of(value, &["INCH", "ZOLL"]) => Ok(Unit::Inch),
        _ => Err(()),
    })
}

/// What a G function is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Function {
    /// A straight line at rapid traverse.
    Rapid,
    /// A straight line at a feed.
    Line,
    /// An arc: its end is written, its way does not matter.
    Arc,
    /// To the point where the tool is changed: only the control knows it.
    ChangePoint,
    /// What feed and speed mean.
    Setting,
    /// Reads no further ahead.
    ReadNoFurther,
}

/// G functions by number.
const FUNCTIONS: [(u32, Function); 12] = [
    (0, Function::Rapid),
    (1, Function::Line),
    (2, Function::Arc),
    (3, Function::Arc),
    (12, Function::Arc),
    (13, Function::Arc),
    (14, Function::ChangePoint),
    (94, Function::Setting),
    (95, Function::Setting),
    (96, Function::Setting),
    (97, Function::Setting),
    (909, Function::ReadNoFurther),
];

/// What a G function is, if that is known.
pub(super) fn function(number: u32) -> Option<Function> {
    FUNCTIONS.iter().find(|(known, _)| *known == number).map(|&(_, function)| function)
}

impl Function {
    /// The letters that may stand beside it, besides S, F and M. Others change the way, so the block is not understood:
    /// `B` behind `G1` is a chamfer.
    pub(super) const fn letters(self) -> &'static [&'static str] {
        match self {
            Self::Rapid | Self::Line => &["X", "Y", "Z"],
            Self::Arc => &["X", "Y", "Z", "I", "J", "K", "R", "Q"],
            Self::ChangePoint => &["Q", "D"],
            Self::Setting => &["T"],
            Self::ReadNoFurther => &[],
        }
    }
}

/// M functions that stop or end a program: never beside a tool, because a tool call has no M functions here.
pub(super) const STOPS: [u32; 4] = [0, 1, 2, 30];
/// An M function that is not run: it starts the program again.
pub(super) const STARTS_AGAIN: u32 = 99;
/// The largest numbers of G and M functions, and of tools.
pub(super) const MOST: u32 = 9_999;
/// The largest block number: five digits.
pub(super) const MOST_NUMBER: usize = 5;
