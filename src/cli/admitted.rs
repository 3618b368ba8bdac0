//! What a run must admit by its exit code: whether what is told beside an answer stands against it, or says that something measured was left
//! out of it.
//!
//! The rule: everything that was asked for has an answer, and a colleague would stop all the same. What only explains an answer, such as a
//! column of remarks that is not read or an option without an effect, is told and no more. Each kind decides in a match without a default, or
//! beside its own declaration, so that a new one has to decide, too.

use crate::budget::BudgetWarning;
use crate::control::deviations::DeviationWarning;
use crate::control::mask::{MaskWarning, OtherLanguages};
use crate::control::probe_block::Unused;
use crate::control::table::TableWarning;
use crate::exchange::ImportWarningKind;
use crate::files::{FileError, ZoneError};
use crate::journal::entry::CheckRemark;
use crate::message::{Located, Say};
use crate::nc::machine::Alone;
use crate::nc::program::ProgramWarning;
use crate::part::PlanRemark;
use crate::probing::Caveat;
use crate::probing::circle::CircleWarning;
use crate::store::{StoreError, StoreRemark};
use crate::tolerance::fit::thermal::ThermalDoubt;
use crate::tolerance::{FigureWarning, ZoneDoubt};
use crate::verdict::{Doubt, Undecided};
use crate::watch::Waiting;

/// Something that is told beside an answer.
pub(super) trait Admits: Say {
    /// Whether it asks somebody to look before the answer counts.
    fn wants_a_look(&self) -> bool;
}

/// What was measured counts twice, not at all, or by less than was asked for; it contradicts itself; or it was to be kept and is not.
pub(super) const LOOK_FIRST: bool = true;

/// Bad data already, and what says nothing against an answer.
pub(super) const TOLD: bool = false;

/// Declares what is told beside an answer, each with whether somebody has to look first.
macro_rules! told {
    (
        $(#[$about:meta])*
        $seen:vis enum $kind:ident $(<$life:lifetime>)? {
            $($(#[$what:meta])* $name:ident $({ $($fields:tt)* })? => $look:ident),+ $(,)?
        }
    ) => {
        $(#[$about])*
        $seen enum $kind $(<$life>)? {
            $($(#[$what])* $name $({ $($fields)* })?,)+
        }

        impl $(<$life>)? $crate::cli::admitted::Admits for $kind $(<$life>)? {
            fn wants_a_look(&self) -> bool {
                match self {
                    $(Self::$name { .. } => $look,)+
                }
            }
        }
    };
}

/// What only explains an answer.
macro_rules! explains {
    ($($kind:ty: $why:literal),+ $(,)?) => {
        $(
            #[doc = $why]
            impl Admits for $kind {
                fn wants_a_look(&self) -> bool {
                    false
                }
            }
        )+
    };
}

explains! {
    ZoneError: "The time zone of this computer: an entry without one says so itself.",
    ThermalDoubt: "Told where the temperature was said to be meant; elsewhere it is refused.",
    ZoneDoubt: "Told where the zone was said to be meant; elsewhere it is refused.",
    CircleWarning: "The same of the circles of a file of contacts.",
    DeviationWarning: "Tables: what was not understood of one has no limits.",
    FigureWarning: "Where limits come from: those that were asked for count.",
    FileError: "A note beside a file that could not be written.",
    Located<PlanRemark>: "A plan judges nothing yet.",
    MaskWarning: "How something is printed.",
    OtherLanguages: "The same.",
    ProgramWarning: "How a program was read: a machine says for itself what it left out.",
    StoreError: "A journal that was not put in order has all its entries.",
    StoreRemark: "A journal: `verify` has an exit code of its own.",
    TableWarning: "Tables of tools and probes.",
    Undecided: "It is a verdict of its own.",
    Unused: "Blocks beside the one that was asked for.",
    Waiting: "A file that cannot be read is bad data.",
}

impl Admits for ImportWarningKind {
    fn wants_a_look(&self) -> bool {
        self.stands_against()
    }
}

/// The value may be another quantity, or that of another part.
impl Admits for Doubt {
    fn wants_a_look(&self) -> bool {
        true
    }
}

/// How well a diameter is known, which the rules count; a form that the limits do not allow; a callout that contradicts itself.
impl Admits for Caveat {
    fn wants_a_look(&self) -> bool {
        match self {
            Self::TwoPoint { .. } | Self::Form { .. } | Self::Stated { .. } => true,
            Self::OnlyADiameter
            | Self::OnlyACircle
            | Self::ThreeContacts
            | Self::FourContacts
            | Self::FewContacts { .. }
            | Self::ShortArc { .. }
            | Self::Heights { .. }
            | Self::Count { .. }
            | Self::FormClass { .. }
            | Self::EachTwoPoint { .. }
            | Self::MeanOfTwoPoints { .. }
            | Self::NotLeastSquares { .. }
            | Self::OneSection { .. }
            | Self::Envelope { .. }
            | Self::OtherSize { .. }
            | Self::Condition { .. } => false,
        }
    }
}

/// The block measures where its numbers do not say, or not at all.
impl Admits for Located<Alone> {
    fn wants_a_look(&self) -> bool {
        true
    }
}

/// A kept verdict that would be another one today.
impl Admits for CheckRemark {
    fn wants_a_look(&self) -> bool {
        match self {
            Self::JudgedOtherwise { .. } => true,
        }
    }
}

/// A budget of something else than what was measured.
impl Admits for BudgetWarning {
    fn wants_a_look(&self) -> bool {
        match self {
            Self::Expired { .. }
            | Self::NotYet { .. }
            | Self::OtherSize { .. }
            | Self::OtherSide { .. }
            | Self::OtherExpansion { .. }
            | Self::OtherTemperature { .. }
            | Self::FailedStudy { .. }
            | Self::OfTemplate => true,
            Self::TemplateFigures { .. }
            | Self::FewReadings { .. }
            | Self::BiasCorrected { .. }
            | Self::BiasNotCorrected { .. }
            | Self::Recorded { .. } => false,
        }
    }
}
