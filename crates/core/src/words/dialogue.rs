//! A dialogue language of the control, and the few words that all of the control's files share.

use std::fmt;
use std::sync::OnceLock;

use fitcheck_shipped as shipped;
use serde::Deserialize;

use super::Language;

/// A dialogue language of the control: for masks, logs, NC programs, and the names and questions of cycles.
///
/// It is here, beside [`Language`], because the cycles declare their names and questions in it, and `probing` is below
/// `control`. The two lists differ: a control has Italian where the window does not.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum Dialogue {
    /// English.
    #[default]
    En,
    /// Dutch.
    Nl,
    /// German.
    De,
    /// Italian.
    It,
}

/// What `assets/dialogues` has for one dialogue language.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DialogueWords {
    /// Its name in its own language.
    pub name: String,
    /// The decimal sign of logs for people.
    pub decimal_sign: char,
    /// Its English name after `L_` in a mask: `DUTCH`.
    pub mask_language: String,
    /// The name of the page that comes with a set of files for a control.
    pub readme: String,
    /// The status words of program 82551.
    pub status: StatusWords,
    /// The words of a protocol of a series.
    pub series: SeriesWords,
}

/// What the protocol of a series calls its figures. All of them are ASCII, and the readers of measurements know them.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SeriesWords {
    /// The number of the part.
    pub part: String,
    /// The status of the part.
    pub status: String,
    /// The worst status of the parts so far.
    pub worst: String,
    pub minimum: String,
    pub maximum: String,
    pub measured: String,
    /// The mean of the parts so far.
    pub mean: String,
    /// The largest less the smallest value so far.
    pub range: String,
    /// Heading of the blocks that find the row of the next part.
    pub next_part: String,
    /// Heading of those that write it.
    pub row: String,
    /// Heading of those that compute mean, range and worst status.
    pub so_far: String,
    /// Heading of those that print.
    pub protocol: String,
}

/// The status words that program 82551 puts into QS3.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StatusWords {
    /// Between the limits.
    pub good: String,
    /// Beyond the limit that can still be machined.
    pub rework: String,
    /// Beyond the other limit.
    pub scrap: String,
    /// Cannot be judged.
    pub re_measure: String,
    /// Beyond a limit, and neither a hole nor a shaft.
    pub out_of_limits: String,
}

impl Dialogue {
    /// Every built-in dialogue language.
    pub const ALL: [Self; 4] = [Self::En, Self::Nl, Self::De, Self::It];

    /// The two-letter code, as in `--language nl` and `82552_nl.a`.
    pub const fn code(self) -> &'static str {
        match self {
            Self::En => "en",
            Self::Nl => "nl",
            Self::De => "de",
            Self::It => "it",
        }
    }

    /// The dialogue language of a code; case does not matter.
    pub fn from_code(code: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|dialogue| dialogue.code().eq_ignore_ascii_case(code))
    }

    /// Its words: `assets/dialogues/nl.toml`.
    pub fn words(self) -> &'static DialogueWords {
        static WORDS: PerDialogue<DialogueWords> = PerDialogue::new(|dialogue| {
            let text = shipped::text(shipped::DIALOGUES, &format!("{dialogue}.toml"));
            #[expect(clippy::expect_used, reason = "the file is part of the program and read by a test")]
            toml::from_str(text).expect("words of a dialogue can be read")
        });
        WORDS.of(self)
    }

    /// Its name in its own language.
    pub fn name(self) -> &'static str {
        &self.words().name
    }

    /// The language of notes for the person at Fitcheck: this one where the window has it, otherwise English.
    pub fn language(self) -> Language {
        Language::from_code(self.code()).unwrap_or(Language::En)
    }
}

impl Language {
    /// The control's dialogue for a person of this language; English where the control has no such dialogue.
    pub fn dialogue(self) -> Dialogue {
        Dialogue::from_code(self.code()).unwrap_or(Dialogue::En)
    }
}

/// One value per dialogue language, all made at the first use.
pub struct PerDialogue<T> {
    made: OnceLock<[(Dialogue, T); Dialogue::ALL.len()]>,
    make: fn(Dialogue) -> T,
}

impl<T> PerDialogue<T> {
    /// A value that is made by this function, for all languages at once.
    pub const fn new(make: fn(Dialogue) -> T) -> Self {
        Self { made: OnceLock::new(), make }
    }

    /// The value of a language; at the first call, all of them are made.
    #[expect(clippy::expect_used, clippy::missing_panics_doc, reason = "ALL has every dialogue")]
    pub fn of(&self, dialogue: Dialogue) -> &T {
        let made = self.made.get_or_init(|| Dialogue::ALL.map(|dialogue| (dialogue, (self.make)(dialogue))));
        made.iter().find(|(known, _)| *known == dialogue).map(|(_, value)| value).expect("a dialogue of ALL")
    }
}

impl fmt::Display for Dialogue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.code())
    }
}
