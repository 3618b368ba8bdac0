//! Materials and how much they expand: the built-in list, and a user's own file.
//!
//! A file is TOML with one `[[material]]` per material, like `assets/materials.toml`; it is passed in as text. Alloys
//! differ, so a user's own values come first, and no value is assumed for a material that the list lacks.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::marker::PhantomData;
use std::str::FromStr;
use std::sync::LazyLock;

use serde::Deserialize;
use serde::de::{Deserializer, Visitor};
use toml::Spanned;

use super::press::{Elastic, PressError, PressPart, Ratio};
use super::thermal::{Expansion, Range, Temperature};
use crate::message::{FilePlace, Located, Say};
use crate::words::Language;

/// The version of the file that this program reads.
const VERSION: u32 = 1;
/// The most materials in a file.
pub const MOST: usize = 1000;
/// The most bytes of a file: enough for [`MOST`] materials, and quick to read.
const LARGEST: usize = 1 << 20;
/// The largest modulus of elasticity in MPa: diamond has about as much.
const MOST_MODULUS: u32 = 1_200_000;
/// The largest yield strength in MPa.
const MOST_YIELD: u32 = 10_000;
/// The longest name in characters.
const LONGEST_NAME: usize = 60;

/// How sure a coefficient is. Alloys differ by some 10 % anyway.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Deserialize, Say)]
#[say(prefix = "material")]
#[serde(rename_all = "lowercase")]
pub enum Certainty {
    /// A published table says so.
    Published,
    /// A common handbook value that is not confirmed: check it before relying on it.
    Verify,
    /// The user's own value.
    #[default]
    Own,
}

impl Certainty {
    /// The word for machines and files, the same in every language.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Published => "published",
            Self::Verify => "verify",
            Self::Own => "own",
        }
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
    /// At which temperatures it does.
    pub range: Range,
    /// Where the value comes from.
    pub source: Option<String>,
    /// How sure the value is.
    pub certainty: Certainty,
    /// How it gives way, where that is known; a press fit needs it.
    pub elastic: Option<Elastic>,
    /// How much it shrinks far below 0 °C, where that is known.
    pub contraction: Option<Expansion>,
}

impl Material {
    /// What a press fit has to know of it.
    ///
    /// # Errors
    /// [`PressError::Material`] where its modulus and Poisson's ratio are not known.
    pub fn press_part(&self) -> Result<PressPart, PressError> {
        let elastic = self.elastic.ok_or_else(|| PressError::Material { name: self.name.clone() })?;
        Ok(PressPart { elastic, expansion: self.expansion, contraction: self.contraction, range: self.range })
    }

    /// The name in a language, or the English one where there is no other.
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

/// Why a file of materials cannot be used, or a material cannot be found.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "material", error)]
pub enum MaterialsError {
    /// The file is not TOML, or does not have the expected fields.
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
    /// A file that is too large to be read.
    #[say(args(most = LARGEST))]
    TooLarge,
    /// More than [`MOST`] materials.
    #[say(args(most = MOST))]
    TooMany {
        /// How many there are.
        count: usize,
    },
    /// A name that is empty or too long, or has control characters.
    #[say(args(longest = LONGEST_NAME))]
    Name,
    /// A range of temperatures that ends before it begins.
    Range,
    /// A modulus without Poisson's ratio or the other way round, or a yield strength without them; or one out of range.
    Elastic,
    /// Two materials have the same name.
    Twice {
        /// The name.
        name: String,
    },
    /// No material has the name.
    Unknown {
        /// What was asked for.
        name: String,
        /// The known names.
        known: String,
    },
}

static SHIPPED: LazyLock<Materials> = LazyLock::new(|| {
    #[expect(clippy::expect_used, reason = "the file is part of the program and read by a test")]
    Materials::read(include_str!("../../../../../assets/materials.toml")).expect("assets/materials.toml can be read")
});

impl Materials {
    /// The built-in list.
    pub fn shipped() -> &'static Self {
        &SHIPPED
    }

    /// Reads a file of materials.
    ///
    /// # Errors
    /// [`MaterialsError`] with the line; for two equal names, the line of the second. A file is read whole or not.
    pub fn read(text: &str) -> Result<Self, Located<MaterialsError>> {
        let of_file = |what| Located { what, place: FilePlace::default() };
        if LARGEST < text.len() {
            return Err(of_file(MaterialsError::TooLarge));
        }
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let file: File = toml::from_str(text).map_err(|error| toml_error(text, &error))?;
        if file.version != VERSION {
            return Err(of_file(MaterialsError::Version { found: file.version }));
        }
        if MOST < file.material.len() {
            return Err(of_file(MaterialsError::TooMany { count: file.material.len() }));
        }
        let mut list: Vec<Material> = Vec::with_capacity(file.material.len());
        let mut taken = BTreeSet::new();
        for entry in file.material {
            let place = FilePlace { column: None, ..FilePlace::of_byte(text, entry.name.span().start) };
            let material = entry.material();
            let material = material.map_err(|what| Located { what, place: place.clone() })?;
            if material.range.most < material.range.least {
                return Err(Located { what: MaterialsError::Range, place });
            }
            let names = || std::iter::once(&material.name).chain(material.names.values());
            if !names().all(|name| is_name(name)) {
                return Err(Located { what: MaterialsError::Name, place });
            }
            if let Some(name) = names().find(|name| taken.contains(&name.to_lowercase())) {
                return Err(Located { what: MaterialsError::Twice { name: name.clone() }, place });
            }
            taken.extend(names().map(|name| name.to_lowercase()));
            list.push(material);
        }
        Ok(Self { list })
    }

    /// A copy with a user's own materials: they replace those with the same English name, and the others follow.
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

    /// At which temperatures a coefficient holds: that of the first material that has it, else the usual range.
    pub fn range_of(&self, expansion: Expansion) -> Range {
        self.of_expansion(expansion).map_or(Range::USUAL, |material| material.range)
    }

    /// The first material that expands so.
    pub fn of_expansion(&self, expansion: Expansion) -> Option<&Material> {
        self.list.iter().find(|material| material.expansion == expansion)
    }

    /// Every material, in the file's order.
    pub fn iter(&self) -> impl Iterator<Item = &Material> {
        self.list.iter()
    }

    /// Finds a material by its name in any language; case does not matter.
    ///
    /// # Errors
    /// [`MaterialsError::Unknown`] with the known names.
    pub fn find(&self, name: &str) -> Result<&Material, MaterialsError> {
        let name = name.trim();
        // The last one first: a translated name of a built-in material must not hide a user's own.
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
    #[serde(default)]
    range: Option<[Degrees; 2]>,
    source: Option<String>,
    #[serde(default)]
    certainty: Certainty,
    /// MPa.
    modulus: Option<u32>,
    #[serde(default, deserialize_with = "ratio")]
    poisson: Option<Ratio>,
    /// MPa.
    #[serde(rename = "yield")]
    yield_strength: Option<u32>,
    #[serde(default, deserialize_with = "contraction")]
    contraction: Option<Expansion>,
}

/// A temperature of a file.
#[derive(Deserialize)]
struct Degrees(#[serde(deserialize_with = "temperature")] Temperature);

impl Entry {
    fn material(self) -> Result<Material, MaterialsError> {
        let elastic = self.elastic()?;
        let Self { name, names, expansion, range, source, certainty, contraction, .. } = self;
        let range = range.map_or(Range::USUAL, |[Degrees(least), Degrees(most)]| Range { least, most });
        // A name that is looked for has no blanks around it either.
        let bare = |name: &str| name.trim().to_owned();
        let names = names.into_iter().map(|(language, name)| (language, bare(&name))).collect();
        let name = bare(name.get_ref());
        Ok(Material { name, names, expansion, range, source, certainty, elastic, contraction })
    }

    fn elastic(&self) -> Result<Option<Elastic>, MaterialsError> {
        let (modulus_mpa, poisson) = match (self.modulus, self.poisson) {
            (Some(modulus), Some(poisson)) => (modulus, poisson),
            (None, None) if self.yield_strength.is_none() => return Ok(None),
            _ => return Err(MaterialsError::Elastic),
        };
        let is_yield = self.yield_strength.is_none_or(|strength| (1..=MOST_YIELD).contains(&strength));
        if !(1..=MOST_MODULUS).contains(&modulus_mpa) || 0.5 < poisson.value() || !is_yield {
            return Err(MaterialsError::Elastic);
        }
        Ok(Some(Elastic { modulus_mpa, poisson, yield_mpa: self.yield_strength }))
    }
}

fn is_name(name: &str) -> bool {
    (1..=LONGEST_NAME).contains(&name.trim().chars().count()) && !name.contains(char::is_control)
}

fn expansion<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Expansion, D::Error> {
    deserializer.deserialize_any(NumberOrText("an expansion in millionths per kelvin, such as 11.5", PhantomData))
}

fn temperature<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Temperature, D::Error> {
    deserializer.deserialize_any(NumberOrText("a temperature in °C, such as 100", PhantomData))
}

fn contraction<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<Expansion>, D::Error> {
    expansion(deserializer).map(Some)
}

fn ratio<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<Ratio>, D::Error> {
    deserializer.deserialize_any(NumberOrText("Poisson's ratio, such as 0.3", PhantomData)).map(Some)
}

/// A number, or the number as a text. The shortest text of a float is the decimal that was written.
struct NumberOrText<T>(&'static str, PhantomData<T>);

impl<T: FromStr<Err: fmt::Display>> Visitor<'_> for NumberOrText<T> {
    type Value = T;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0)
    }

    fn visit_i64<E: serde::de::Error>(self, number: i64) -> Result<T, E> {
        self.visit_str(&number.to_string())
    }

    fn visit_f64<E: serde::de::Error>(self, number: f64) -> Result<T, E> {
        self.visit_str(&number.to_string())
    }

    fn visit_str<E: serde::de::Error>(self, text: &str) -> Result<T, E> {
        text.parse().map_err(E::custom)
    }
}

fn toml_error(text: &str, error: &toml::de::Error) -> Located<MaterialsError> {
    let what = MaterialsError::Toml { reason: error.message().trim().replace('\n', ", ") };
    Located { what, place: FilePlace::of_byte(text, error.span().map_or(0, |span| span.start)) }
}
