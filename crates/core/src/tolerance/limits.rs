//! Limits of size, and where the deviations come from.

use std::sync::Arc;

use super::class::Feature;
use super::deviations::Deviations;
use super::iso2768::GeneralClass;
use crate::length::Length;
use crate::message::{Message, Say, display, message};

/// Where deviations come from. Every number that is shown comes with this.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Source {
    /// A standard.
    Standard {
        /// The size step: above this,
        over: Length,
        /// up to and including this.
        to: Length,
        /// Its name and step, and what a reader should know about the figure.
        said: Arc<Message>,
        /// Why the figure may be wrong for a reader: contested, for trial use.
        doubt: Option<Message>,
    },
    /// ISO 2768-1, general tolerances of linear sizes.
    Iso2768 {
        /// The class.
        class: GeneralClass,
        /// The size range: above this,
        over: Length,
        /// up to and including this.
        to: Length,
    },
    /// The callout states them itself: deviations or limits of size.
    Callout,
    /// A control's table.
    Table {
        /// The table's name, `82553_hole.tab`.
        name: Arc<str>,
        /// Whether the table is one of the two built-in ones, which agree with ISO 286 cell by cell.
        shipped: bool,
        /// The size range: above this,
        over: Length,
        /// up to and including this.
        to: Length,
        /// What ISO 286 says here, where a user's table differs.
        instead_of: Option<Deviations>,
    },
    /// The limits came with the measurement, from the named file.
    File(Arc<str>),
    /// Another source answered, because the user's own tables could not be read.
    WithoutOwn {
        /// The folder of the own tables.
        folder: Arc<str>,
        /// The source that answered.
        source: Box<Self>,
    },
    /// Whatever a kept record says, in English: its tables are no longer at hand.
    Recorded {
        /// Where the deviations came from, with what ISO 286 says where a user's own table differed.
        text: Arc<str>,
        /// The size range, above and up to, where they have one.
        range: Option<(Length, Length)>,
    },
}

display!(Source);

impl Source {
    /// The size range in which the figure was found, where it has one: above, and up to and including.
    pub fn range(&self) -> Option<(Length, Length)> {
        match self {
            Self::Standard { over, to, .. } | Self::Iso2768 { over, to, .. } | Self::Table { over, to, .. } => {
                Some((*over, *to))
            }
            Self::WithoutOwn { source, .. } => source.range(),
            Self::Recorded { range, .. } => *range,
            Self::Callout | Self::File(_) => None,
        }
    }

    /// In English for files and machines, with what ISO 286 says where a user's own table differs:
    /// `table own.tab, over 0 up to 3 mm, instead of 0 / +10 µm in ISO 286`.
    pub fn with_difference(&self) -> String {
        match self {
            Self::Table { instead_of: Some(standard), .. } => {
                format!(
                    "{self}, instead of {} / {} µm in ISO 286",
                    standard.lower().signed_um(),
                    standard.upper().signed_um()
                )
            }
            _ => self.to_string(),
        }
    }
}

impl Say for Source {
    fn message(&self) -> Message {
        match self {
            Self::Standard { said, .. } => said.as_ref().clone(),
            Self::Iso2768 { class, over, to } => {
                message!("source-iso2768").with("class", class).with("over", over).with("to", to)
            }
            Self::Callout => message!("source-callout"),
            Self::Table { name, shipped, over, to, .. } => {
                let id = if *shipped { "source-shipped-table" } else { "source-table" };
                Message::new(id).with("name", name).with("over", over).with("to", to)
            }
            Self::File(name) => message!("source-file").with("name", name),
            Self::WithoutOwn { folder, source } => {
                message!("source-without-own").message("source", source.message()).with("folder", folder)
            }
            Self::Recorded { text, .. } => message!("source-recorded").with("text", text),
        }
    }
}

/// The sizes that a verdict needs, without where they come from. The maximum is never below the minimum.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Bounds {
    /// Hole or shaft; `None` where nobody has said which, or where it is neither.
    pub feature: Option<Feature>,
    /// Nominal size.
    pub nominal: Length,
    maximum: Length,
    minimum: Length,
}

impl Bounds {
    /// Bounds from a nominal size and deviations. `None` where a limit would lie beyond [`Length::MAX`].
    #[inline]
    pub fn new(feature: impl Into<Option<Feature>>, nominal: Length, deviations: Deviations) -> Option<Self> {
        let feature = feature.into();
        let maximum = nominal.checked_add(deviations.upper())?;
        let minimum = nominal.checked_add(deviations.lower())?;
        Some(Self { feature, nominal, maximum, minimum })
    }

    /// Upper limit of size; it belongs to the zone.
    pub const fn maximum(&self) -> Length {
        self.maximum
    }

    /// Lower limit of size; it belongs to the zone.
    pub const fn minimum(&self) -> Length {
        self.minimum
    }

    /// The middle of the zone, with a half nanometre rounded up.
    #[inline]
    pub fn middle(&self) -> Length {
        self.minimum.midpoint(self.maximum)
    }
}

/// Limits of size: what a measured part is judged by. The maximum is never below the minimum.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Limits {
    /// Hole or shaft; `None` where nobody has said which, or where it is neither, as a distance or a depth is.
    pub feature: Option<Feature>,
    /// Nominal size.
    pub nominal: Length,
    /// Deviations from the nominal size.
    pub deviations: Deviations,
    /// Where the deviations come from.
    pub source: Source,
    maximum: Length,
    minimum: Length,
}

impl Limits {
    /// Limits from a nominal size and deviations: like Q23 and Q33 of program 82551 (LBL 99), but exact.
    ///
    /// `None` where a limit would lie beyond [`Length::MAX`].
    pub fn new(
        feature: impl Into<Option<Feature>>,
        nominal: Length,
        deviations: Deviations,
        source: Source,
    ) -> Option<Self> {
        let Bounds { feature, maximum, minimum, .. } = Bounds::new(feature, nominal, deviations)?;
        Some(Self { feature, nominal, deviations, source, maximum, minimum })
    }

    /// The sizes alone.
    pub const fn bounds(&self) -> Bounds {
        Bounds { feature: self.feature, nominal: self.nominal, maximum: self.maximum, minimum: self.minimum }
    }

    /// Upper limit of size; it belongs to the zone.
    pub const fn maximum(&self) -> Length {
        self.maximum
    }

    /// Lower limit of size; it belongs to the zone.
    pub const fn minimum(&self) -> Length {
        self.minimum
    }

    /// The middle of the zone, with a half nanometre rounded up.
    #[inline]
    pub fn middle(&self) -> Length {
        self.bounds().middle()
    }
}
