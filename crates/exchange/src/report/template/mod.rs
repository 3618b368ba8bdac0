//! What a report for people shows, in which order and on which paper: one small file a template.
//!
//! | file | what |
//! |---|---|
//! | here | a template, and reading one |
//! | `parts` | the sections, columns and head fields that it chooses from |
//!
//! A template is TOML with `version = 1`; unknown keys and words are refused with what is allowed. There is no language in it and no
//! code: it chooses and orders, and its texts are plain. The shipped ones are in `assets/report/templates`; `docs/manual/reports.md`
//! describes the file.
//!
//! A template cannot make a report say less than it must: what is missing, left out, simulated, corrected or guarded, and every note of
//! the report stand on its first page whatever the template says.
//!
//! To add a section, a column or a head field: a line in `parts`, its text in the locales, and drawing it in `pdf`.

mod parts;
mod sample;

use std::collections::BTreeSet;
use std::hash::Hash;
use std::sync::{Arc, LazyLock};

use fitcheck_core::message::{FilePlace, Located, Message, Say};
use fitcheck_core::words::{Language, Words};
use serde::Deserialize;

pub use parts::{Column, HeadField, Section};

use super::image::Image;
use super::paper::Paper;

/// What the names of the shipped ones begin with.
const SHIPPED_NAME: &str = "report-template-";

/// The version of the file that this program reads.
const VERSION: u32 = 1;

/// The most bytes of a file.
const LARGEST: usize = 64 << 10;

/// The longest text in a file, characters.
pub const LONGEST: usize = 2_000;

/// What a report for people shows, and how.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Template {
    version: u32,
    /// What the template is called where one is chosen; the name of a text for a shipped one.
    pub name: String,
    /// What it is for, in a few words; the name of a text for a shipped one.
    #[serde(default)]
    pub purpose: String,
    /// The title of its reports; empty where the language's own word for an inspection report, or the caller's, stands there. The name of a
    /// text for a shipped one.
    #[serde(default)]
    pub title: String,
    #[serde(default)]
    pub paper: Paper,
    /// The code of its language, such as `de`; `None` where whoever makes the report chooses.
    #[serde(default)]
    pub language: Option<String>,
    /// What stands on the page, from top to bottom.
    pub sections: Vec<Section>,
    /// The fields of the head, row by row; those without a value are left out.
    #[serde(default = "HeadField::usual")]
    pub head: Vec<HeadField>,
    /// The columns of the table of features.
    #[serde(default = "Column::usual")]
    pub columns: Vec<Column>,
    /// Said beside the decision rule, in the words of whoever signs.
    #[serde(default)]
    pub rule_text: String,
    #[serde(default)]
    pub company: Company,
    /// The logo that it names, or why it is not shown: whoever reads the file reads it, too.
    #[serde(skip)]
    pub logo: Option<Result<Image, Message>>,
}

/// Who stands at the top of the page.
#[derive(Debug, Clone, Default, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Company {
    #[serde(default)]
    pub name: String,
    /// Its lines.
    #[serde(default)]
    pub address: Vec<String>,
    /// The file name of its logo beside the template, a PNG, JPEG or SVG; empty where it has none.
    #[serde(default)]
    pub logo: String,
}

/// Why a file is no template.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "report-template", error)]
pub enum TemplateError {
    /// Not TOML, or a key or a word that no template has.
    Toml {
        /// What the reader of TOML says.
        reason: String,
    },
    /// A version that this program does not know.
    #[say(args(known = VERSION))]
    Version {
        /// What was given.
        found: u32,
    },
    #[say(args(most = LARGEST))]
    TooLarge,
    /// A text that is empty where it must not be, is too long, or has control characters.
    #[say(args(longest = LONGEST))]
    Text {
        /// Its key.
        key: &'static str,
    },
    /// A list that has the same word twice.
    Twice {
        /// The list's key.
        key: &'static str,
        word: &'static str,
    },
    /// A list that has to have a word has none.
    Empty {
        /// The list's key.
        key: &'static str,
    },
    #[say(args(known = languages()))]
    Language { given: String },
    /// A logo in another folder.
    Logo { given: String },
}

static SHIPPED: LazyLock<Vec<Arc<Template>>> = LazyLock::new(|| {
    #[expect(clippy::expect_used, reason = "the files are part of the program and read by a test")]
    let read = |(name, bytes): &(&str, &[u8])| Arc::new(Template::read(&String::from_utf8_lossy(bytes)).expect(name));
    let mut all: Vec<Arc<Template>> = fitcheck_shipped::TEMPLATES.iter().map(read).collect();
    // The usual one comes first; the others keep the order of their files.
    all.sort_by_key(|template| template.name != "report-template-inspection");
    all
});

impl Template {
    /// Reads a template.
    ///
    /// # Errors
    /// [`TemplateError`], with line and column where the file has a place for it.
    pub fn read(text: &str) -> Result<Self, Located<TemplateError>> {
        let of_file = |what| Located { what, place: FilePlace::default() };
        if LARGEST < text.len() {
            return Err(of_file(TemplateError::TooLarge));
        }
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let template: Self = toml::from_str(text).map_err(|error| {
            let place = FilePlace::of_byte(text, error.span().map_or(0, |span| span.start));
            Located { what: TemplateError::Toml { reason: error.message().trim().replace('\n', ", ") }, place }
        })?;
        template.checked().map_err(of_file)
    }

    /// Whether its reports are sheets that are filled in by hand: they show no value.
    pub fn is_blank(&self) -> bool {
        self.columns.contains(&Column::Blank) && !self.columns.contains(&Column::Measured)
    }

    /// The shipped templates; the first one is the usual inspection report.
    pub fn shipped() -> &'static [Arc<Self>] {
        &SHIPPED
    }

    /// The usual template: an inspection report of parts and checks.
    pub fn usual() -> Arc<Self> {
        SHIPPED.first().map_or_else(|| Arc::new(Self::plain()), Arc::clone)
    }

    /// What a report shows that nobody chose a template for.
    fn plain() -> Self {
        Self {
            version: VERSION,
            name: "report-template-inspection".to_owned(),
            purpose: "report-template-inspection-purpose".to_owned(),
            title: String::new(),
            paper: Paper::default(),
            language: None,
            sections: Section::usual(),
            head: HeadField::usual(),
            columns: Column::usual(),
            rule_text: String::new(),
            company: Company::default(),
            logo: None,
        }
    }

    /// The same on a paper, without some sections.
    #[must_use]
    pub fn without(&self, hidden: &BTreeSet<Section>, paper: Paper) -> Self {
        let shown = self.sections.iter().copied().filter(|section| !hidden.contains(section));
        Self { sections: shown.collect(), paper, ..self.clone() }
    }

    /// What a shipped one is called on the command line: `first-article`.
    pub fn word(&self) -> &str {
        self.name.strip_prefix(SHIPPED_NAME).unwrap_or(&self.name)
    }

    /// Takes the logo that it names, where it names one; `read` reads a file beside the template.
    #[must_use]
    pub fn with_logo(self, read: impl FnOnce(&str) -> Result<Vec<u8>, Message>) -> Self {
        let name = self.company.logo.as_str();
        let logo = (!name.is_empty()).then(|| read(name).and_then(|bytes| Image::read(name, &bytes)));
        Self { logo, ..self }
    }

    /// The same with a company and its logo, or why that is not shown.
    #[must_use]
    pub fn of_company(&self, company: Company, logo: Option<Result<Image, Message>>) -> Self {
        Self { company, logo, ..self.clone() }
    }

    /// A text of it in a language: those of a shipped one are names of texts.
    pub fn text(&self, text: &str, words: &Words) -> String {
        if self.is_shipped() && !text.is_empty() { words.get(text) } else { text.to_owned() }
    }

    /// One of a user's own is free to have the name of a shipped one.
    fn is_shipped(&self) -> bool {
        let texts = |template: &Self| [&template.name, &template.purpose, &template.title].map(Clone::clone);
        SHIPPED.iter().any(|shipped| texts(shipped) == texts(self))
    }

    /// The language that it is set in, where it names one.
    pub fn language(&self) -> Option<Language> {
        let code = self.language.as_deref()?;
        Language::all().find(|language| language.code() == code)
    }

    /// Whether a section stands on its pages.
    pub fn has(&self, section: Section) -> bool {
        self.sections.contains(&section)
    }

    fn checked(self) -> Result<Self, TemplateError> {
        if self.version != VERSION {
            return Err(TemplateError::Version { found: self.version });
        }
        if self.name.trim().is_empty() {
            return Err(TemplateError::Text { key: "name" });
        }
        let texts = [
            ("name", &self.name),
            ("purpose", &self.purpose),
            ("title", &self.title),
            ("rule-text", &self.rule_text),
            ("company.name", &self.company.name),
        ];
        let address = self.company.address.iter().map(|line| ("company.address", line));
        let is_text = |text: &str| text.chars().count() <= LONGEST && !text.chars().any(char::is_control);
        if let Some((key, _)) = texts.into_iter().chain(address).find(|(_, text)| !is_text(text)) {
            return Err(TemplateError::Text { key });
        }
        once("sections", &self.sections, Section::word)?;
        once("head", &self.head, HeadField::word)?;
        once("columns", &self.columns, Column::word)?;
        if self.sections.is_empty() {
            return Err(TemplateError::Empty { key: "sections" });
        }
        if self.has(Section::Features) && self.columns.is_empty() {
            return Err(TemplateError::Empty { key: "columns" });
        }
        if let Some(given) = &self.language
            && !Language::all().any(|language| language.code() == given)
        {
            return Err(TemplateError::Language { given: given.clone() });
        }
        if !self.company.logo.is_empty() && !super::image::is_plain_name(&self.company.logo) {
            return Err(TemplateError::Logo { given: self.company.logo.clone() });
        }
        Ok(self)
    }
}

fn once<T: Copy + Eq + Hash + Ord>(
    key: &'static str,
    all: &[T],
    word: impl Fn(T) -> &'static str,
) -> Result<(), TemplateError> {
    let mut seen = BTreeSet::new();
    match all.iter().find(|one| !seen.insert(**one)) {
        Some(again) => Err(TemplateError::Twice { key, word: word(*again) }),
        None => Ok(()),
    }
}

fn languages() -> String {
    Language::all().map(Language::code).collect::<Vec<_>>().join(", ")
}
