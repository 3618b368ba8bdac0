//! Materials and how much they expand: the shipped list, and a user's own file.
//!
//! A file is TOML with a `[[material]]` for each, as `assets/materials.toml`; it arrives as text. Alloys differ, so a
//! user's own values come first and nothing is taken for a material that the list does not have.

use std::collections::BTreeMap;
use std::fmt;
use std::sync::LazyLock;

use serde::Deserialize;
use serde::de::{Deserializer, Visitor};
use toml::Spanned;

use super::thermal::Expansion;
use crate::message::{Message, Say};
use crate::words::Language;

/// The version of the file that this program reads.
const VERSION: u32 = 1;
/// The most materials in a file.
pub const MOST: usize = 1000;
/// The most bytes of a file: enough for so many materials, and read in no time.
const LARGEST: usize = 1 << 20;
/// The longest name in characters.
const LONGEST_NAME: usize = 60;

/// How sure a coefficient is. Alloys differ by some 10 % anyway.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Certainty {
    /// A published table says so.
    Published,
    /// A usual handbook value that nobody confirmed: check it before relying on it.
    Verify,
    /// The user's own value.
    #[default]
    Own,
}

impl Certainty {
    /// The word for machines and files, in every language the same.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Published => "published",
            Self::Verify => "verify",
            Self::Own => "own",
        }
    }
}

/// In English, as the remark beside a coefficient.
impl fmt::Display for Certainty {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Published => "published value",
            Self::Verify => "usual value, to be verified",
            Self::Own => "own value",
        })
    }
}

impl Say for Certainty {
    fn message(&self) -> Message {
        Message::new(match self {
            Self::Published => "material-published",
            Self::Verify => "material-verify",
            Self::Own => "material-own",
        })
    }
}

/// A material.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Material {
    /// Its English name, by which it is replaced.
    pub name: String,
    /// Its name in other languages, by code.
    pub names: BTreeMap<String, String>,
    /// How much it expands.
    pub expansion: Expansion,
    /// Where the value comes from.
    pub source: Option<String>,
    /// How sure the value is.
    pub certainty: Certainty,
}

impl Material {
    /// The name in a language, the English one where there is no other.
    pub fn name_in(&self, language: Language) -> &str {
        self.names.get(language.code()).unwrap_or(&self.name)
    }

    fn is_called(&self, name: &str) -> bool {
        let called = |own: &str| own.to_lowercase() == name.to_lowercase();
        called(&self.name) || self.names.values().any(|own| called(own))
    }
}

/// A list of materials.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Materials {
    list: Vec<Material>,
}

/// Why a file of materials cannot be used, or a material not be found.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum MaterialsError {
    /// Not TOML, or not the expected fields.
    #[error("line {line}, column {column}: {reason}")]
    Toml {
        /// Line, from 1.
        line: usize,
        /// Column, from 1.
        column: usize,
        /// What the reader of TOML says.
        reason: String,
    },
    /// A version that this program does not know.
    #[error("version {found} of a file of materials is not known, only version {VERSION}")]
    Version {
        /// What was given.
        found: u32,
    },
    /// A file that is too large to be read.
    #[error("a file of materials has at most {LARGEST} bytes")]
    TooLarge,
    /// More than [`MOST`] materials.
    #[error("there are {count} materials: at most {MOST}")]
    TooMany {
        /// How many there are.
        count: usize,
    },
    /// An empty or endless name, or one with control characters.
    #[error("line {line}: a material's name has 1 to {LONGEST_NAME} characters and no control characters")]
    Name {
        /// Line, from 1.
        line: usize,
    },
    /// Two materials have the same name.
    #[error("line {line}: there are two materials called {name}")]
    Twice {
        /// Line of the second, from 1.
        line: usize,
        /// The name.
        name: String,
    },
    /// No material has the name.
    #[error("no material is called {name}; there are {known}, or give the expansion itself, such as 11.5")]
    Unknown {
        /// What was asked for.
        name: String,
        /// The names that there are.
        known: String,
    },
}

impl Say for MaterialsError {
    fn message(&self) -> Message {
        match self {
            // Numbers of lines are texts: plural forms and thousands separators have no place in them.
            Self::Toml { line, column, reason } => {
                Message::new("material-toml").text("line", line).text("column", column).text("reason", reason)
            }
            Self::Version { found } => Message::new("material-version").text("found", found).text("known", VERSION),
            Self::TooLarge => Message::new("material-too-large").text("most", LARGEST),
            Self::TooMany { count } => Message::new("material-too-many").text("count", count).text("most", MOST),
            Self::Name { line } => Message::new("material-name").text("line", line).text("longest", LONGEST_NAME),
            Self::Twice { line, name } => Message::new("material-twice").text("line", line).text("name", name),
            Self::Unknown { name, known } => Message::new("material-unknown").text("name", name).text("known", known),
        }
    }
}

static SHIPPED: LazyLock<Materials> = LazyLock::new(|| {
    #[expect(clippy::expect_used, reason = "the file is part of the program and read by a test")]
    Materials::read(include_str!("../../../assets/materials.toml")).expect("assets/materials.toml can be read")
});

impl Materials {
    /// The shipped list.
    pub fn shipped() -> &'static Self {
        &SHIPPED
    }

    /// Reads a file of materials.
    ///
    /// # Errors
    /// [`MaterialsError`] with the line; a file is taken whole or not at all.
    pub fn read(text: &str) -> Result<Self, MaterialsError> {
        if LARGEST < text.len() {
            return Err(MaterialsError::TooLarge);
        }
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let file: File = toml::from_str(text).map_err(|error| toml_error(text, &error))?;
        if file.version != VERSION {
            return Err(MaterialsError::Version { found: file.version });
        }
        if MOST < file.material.len() {
            return Err(MaterialsError::TooMany { count: file.material.len() });
        }
        let mut list: Vec<Material> = Vec::with_capacity(file.material.len());
        for entry in file.material {
            let (line, _) = place(text, entry.name.span().start);
            let material = entry.material();
            let names = || std::iter::once(&material.name).chain(material.names.values());
            if !names().all(|name| is_name(name)) {
                return Err(MaterialsError::Name { line });
            }
            if let Some(name) = names().find(|name| list.iter().any(|other| other.is_called(name))) {
                return Err(MaterialsError::Twice { line, name: name.clone() });
            }
            list.push(material);
        }
        Ok(Self { list })
    }

    /// The same with a user's own: one of the same English name takes the place, the others follow.
    #[must_use]
    pub fn with_own(&self, own: Self) -> Self {
        let mut list = self.list.clone();
        for material in own.list {
            match list.iter_mut().find(|known| known.name.to_lowercase() == material.name.to_lowercase()) {
                Some(known) => *known = material,
                None => list.push(material),
            }
        }
        Self { list }
    }

    /// Every material, in the file's order.
    pub fn iter(&self) -> impl Iterator<Item = &Material> {
        self.list.iter()
    }

    /// The material of a name in any language; capitals make no difference.
    ///
    /// # Errors
    /// [`MaterialsError::Unknown`] with the names that there are.
    pub fn find(&self, name: &str) -> Result<&Material, MaterialsError> {
        let name = name.trim();
        // The last one first: a user's own name is not hidden by a translated name of a shipped one.
        self.list.iter().rev().find(|material| material.is_called(name)).ok_or_else(|| {
            let known: Vec<&str> = self.list.iter().map(|material| material.name.as_str()).collect();
            MaterialsError::Unknown { name: name.to_owned(), known: known.join(", ") }
        })
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    version: u32,
    #[serde(default)]
    material: Vec<Entry>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    name: Spanned<String>,
    #[serde(default)]
    names: BTreeMap<String, String>,
    #[serde(deserialize_with = "expansion")]
    expansion: Expansion,
    source: Option<String>,
    #[serde(default)]
    certainty: Certainty,
}

impl Entry {
    fn material(self) -> Material {
        let Self { name, names, expansion, source, certainty } = self;
        Material { name: name.into_inner(), names, expansion, source, certainty }
    }
}

fn is_name(name: &str) -> bool {
    (1..=LONGEST_NAME).contains(&name.trim().chars().count()) && !name.contains(char::is_control)
}

/// A number, or the number as a text. The shortest text of a float is the decimal that was written.
fn expansion<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Expansion, D::Error> {
    struct Millionths;

    impl Visitor<'_> for Millionths {
        type Value = Expansion;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.write_str("an expansion in millionths a kelvin, such as 11.5")
        }

        fn visit_i64<E: serde::de::Error>(self, number: i64) -> Result<Expansion, E> {
            self.visit_str(&number.to_string())
        }

        fn visit_f64<E: serde::de::Error>(self, number: f64) -> Result<Expansion, E> {
            self.visit_str(&number.to_string())
        }

        fn visit_str<E: serde::de::Error>(self, text: &str) -> Result<Expansion, E> {
            text.parse().map_err(E::custom)
        }
    }

    deserializer.deserialize_any(Millionths)
}

fn toml_error(text: &str, error: &toml::de::Error) -> MaterialsError {
    let (line, column) = place(text, error.span().map_or(0, |span| span.start));
    MaterialsError::Toml { line, column, reason: error.message().trim().replace('\n', ", ") }
}

/// Line and column, from 1, of a byte.
fn place(text: &str, byte: usize) -> (usize, usize) {
    let before = text.get(..byte).unwrap_or(text);
    let line = before.matches('\n').count() + 1;
    let column = before.rsplit('\n').next().unwrap_or_default().chars().count() + 1;
    (line, column)
}
