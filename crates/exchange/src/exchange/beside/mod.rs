//! Columns beside a value whose cells may contradict its answer: a status, a tick for accepted or rejected, limits, a deviation, whether it
//! is a hole or a shaft.
//!
//! | a column | is compared |
//! |---|---|
//! | whose name is one of a status | always; a word that is not known is told |
//! | whose name says that a value is accepted, or rejected: `Pass`, `NOK`, `Deleted` | with its ticks and its words |
//! | whose name has a word of a status: `Overall status` | where its words are known |
//! | with a word of a verdict in one of its cells, whatever it is called | the same |
//! | of an upper or lower limit, or of a deviation | with the limits and the value, as a size or as a deviation |
//! | of the type of a feature | where it says hole or shaft |
//! | of a temperature, or with one in its words: `part at 35 °C` | with the one that counts for the part |
//! | any, where the name of the values or a line above all names says a temperature | the same of every row |
//! | of the names, where one of the first speaks of a roundness, a mean or a master | the same names |
//!
//! The names and words are English, Dutch, German and Italian. Nothing here changes an answer.

mod claims;
mod find;

use fitcheck_core::length::Unit;
use fitcheck_core::tolerance::Feature;

use super::claim::{Claim, Figure, letters};
use super::evidence::yes_or_no;
use super::limits::{self, LimitName};
use super::quantity::{is_form, is_shape};
use super::role::Role;
use super::vocabulary::Names;
use super::warmth::{self, OfTemperature};
use super::{cells, words};

/// What a column says of each value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Says {
    /// A status; with `is_named` its name says so, and a word that is not known is one as well.
    Status {
        is_named: bool,
    },
    /// Whether it is accepted, or rejected, by a tick or a word.
    Accepted,
    Rejected,
    Upper,
    Lower,
    Deviation,
    /// Hole or shaft.
    Feature,
    /// How warm the part was, by a number.
    Temperature(OfTemperature),
    /// The same, in its words.
    Warmth,
    /// What it is of, by a name that speaks of no size of one part.
    Name,
}

impl Says {
    const fn is_of_temperature(self) -> bool {
        matches!(self, Self::Temperature(_) | Self::Warmth)
    }
}

/// A column beside the value of which something is compared.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct BesideColumn {
    at: usize,
    name: String,
    unit: Option<Unit>,
    says: Says,
}

/// Both sides of a decision as one name, without blanks and signs: `i.O./n.i.O.`, `OK/NOK`, `P/F`.
static BOTH: Names = Names::of(
    "ionio|niooio|oknok|nokok|okng|okko|passfail|pf|gutschlecht|goedfout|goedslecht|goedafgekeurd|acceptreject|gonogo|conformenonconforme",
);

/// Names of a column of ticks for accepted values, written the same way.
static ACCEPTED: Names = Names::of(
    "ok|pass|passed|accept|accepted|approved|conform|conforming|good|valid|intolerance|intol|io|inordnung|gut|gültig|\
    freigegeben|akkoord|goed|goedgekeurd|geldig|conforme|buono|valido|approvato|accettato",
);

/// The same for rejected ones, or for how far they are out.
static REJECTED: Names = Names::of(
    "nok|ng|notok|fail|failed|reject|rejected|scrap|scrapped|defect|defective|invalid|deleted|void|voided|superseded|outlier|\
    outtol|outoftol|outoftolerance|outoflimits|outofspec|out|oot|exceed|exceedance|exceeded|nonconforming|nonconformity|nio|ausschuss|ungültig|gelöscht|\
    ausreißer|überschreitung|toleranzüberschreitung|defekt|afkeur|afgekeurd|ongeldig|verwijderd|vervallen|uitschieter|overschrijding|\
    tolerantieoverschrijding|scarto|scartato|annullato|nonvalido|fuoritolleranza",
);

/// Words that reject a value where a column says its status, and may say something else elsewhere.
static REJECTS: Names = Names::of("out|red|rot|rood|rosso|aborted|abgebrochen|afgebroken|interrotto");

/// Words of a status within a longer name.
static STATUS_WORDS: Names = Names::of(
    "status|state|judge|judged|judgement|judgment|verdict|evaluation|disposition|conformity|conformance|qc|result|check|\
    inspection|decision|stato|ergebnis|messergebnis|gesamtergebnis|endergebnis|prüfergebnis|pruefergebnis|prüfurteil|prüfstatus|pruefstatus|prüfbefund|beurteilung|bewertung|freigabe|resultaat|keuring|keuringsresultaat|goedkeuring|\
    beoordeling|oordeel|risultato|esito|conformità|giudizio|verdetto|controllo",
);

static DEVIATION: Names = Names::of(
    "deviation|dev|deviation from nominal|nominal deviation|diff|difference|delta|abweichung|abw|istabweichung|soll ist abweichung|\
    afwijking|verschil|scostamento|differenza",
);

/// What the name of a column says, alone and with its unit.
fn by_name(header: &str, with_unit: &str) -> Option<Says> {
    let name = letters(header);
    let bare = words::bare(header);
    let limit = limits::by_name(header);
    let says = match name.as_str() {
        _ if words::is_status(header) => Says::Status { is_named: true },
        name if BOTH.has(name) => Says::Status { is_named: true },
        name if ACCEPTED.has(name) => Says::Accepted,
        name if REJECTED.has(name) => Says::Rejected,
        _ if limit.is_some_and(LimitName::is_upper) => Says::Upper,
        _ if limit.is_some() => Says::Lower,
        _ if is_deviation(header) => Says::Deviation,
        _ => match warmth::of_column(with_unit) {
            Some(column) => Says::Temperature(column),
            None if bare.split(' ').any(|word| STATUS_WORDS.has(word)) => Says::Status { is_named: false },
            None => return None,
        },
    };
    Some(says)
}

/// Whether a column of this name has deviations from the nominal value.
pub(super) fn is_deviation(header: &str) -> bool {
    DEVIATION.has(&words::bare(header))
}

/// What a name says that is not the size of one part: another quantity, or a figure of several parts.
pub(super) fn of_no_size(name: &str) -> Option<Claim> {
    (words::is_of_several_parts(name) || is_form(name)).then(|| Claim::no_size(name))
}

/// Whether a cell of rejected values is marked: `*`, `>`, `##`. A stroke says that there is nothing.
fn is_mark(text: &str) -> bool {
    let is_stroke = |c: char| matches!(c, '-' | '\u{2013}' | '\u{2014}' | '.' | '/' | ' ');
    !text.chars().any(char::is_alphanumeric) && !text.chars().all(is_stroke)
}

impl BesideColumn {
    pub(super) const fn at(&self) -> usize {
        self.at
    }

    /// What the column holds, where that is one thing that a user may say.
    pub(super) const fn role(&self) -> Option<Role> {
        match self.says {
            Says::Status { .. } => Some(Role::Status),
            Says::Feature => Some(Role::Kind),
            _ => None,
        }
    }

    /// Whether its claims depend on nothing but the cell.
    pub(super) const fn has_words(&self) -> bool {
        !matches!(self.says, Says::Upper | Says::Lower | Says::Deviation)
    }

    /// Measuring machines write the largest and the smallest reading below short names, too.
    fn limit(&self, claim: Claim) -> Claim {
        let may_be_reading = limits::by_name(&self.name).is_some_and(LimitName::may_be_reading);
        if may_be_reading { claim.or_reading() } else { claim }
    }

    /// What a cell says; numbers without a unit of their column are in the unit of the row.
    pub(super) fn claim(&self, text: &str, unit: Unit) -> Option<Claim> {
        let text = text.trim();
        if text.is_empty() {
            return None;
        }
        let said = || if self.name.is_empty() { text.to_owned() } else { format!("{} {text}", self.name) };
        let figure = || Figure::read(text, self.unit.unwrap_or(unit));
        match self.says {
            Says::Status { .. } if REJECTS.has(&letters(text)) && !self.name.is_empty() => Some(Claim::out(text)),
            Says::Status { is_named: true } => Claim::of_cell(text),
            Says::Status { is_named: false } => Claim::of_word(text).filter(Claim::is_known),
            Says::Name => of_no_size(text),
            Says::Accepted => match yes_or_no(text) {
                Some(true) => Claim::of_word("OK"),
                Some(false) => Some(Claim::out(&said())),
                None => Claim::of_cell(text),
            },
            Says::Rejected => match yes_or_no(text) {
                Some(true) => Some(Claim::out(&said())),
                Some(false) => None,
                None if cells::is_number(text) => {
                    text.contains(|c| ('1'..='9').contains(&c)).then(|| Claim::out(&said()))
                }
                None if is_mark(text) => Some(Claim::out(&said())),
                None => Claim::of_cell(text),
            },
            Says::Upper => figure().map(|figure| self.limit(Claim::upper(&said(), figure))),
            Says::Lower => figure().map(|figure| self.limit(Claim::lower(&said(), figure))),
            Says::Deviation => figure().map(|figure| Claim::deviation(&said(), figure)),
            Says::Temperature(column) => warmth::read(text, column.scale).map(|warm| Claim::warm(&said(), warm)),
            Says::Warmth => warmth::mentioned(text).map(|warm| Claim::warm(&said(), warm)),
            Says::Feature => Some(Claim::feature(text, self.feature(text)?)),
        }
    }

    /// Whether it tells holes and shafts apart.
    pub(super) fn tells_sides(&self) -> bool {
        self.says == Says::Feature
    }

    /// Hole or shaft, where the column tells them apart and the cell says one of them.
    pub(super) fn feature(&self, text: &str) -> Option<Feature> {
        let is_hole = if self.says == Says::Feature { is_shape(text)? } else { return None };
        Some(if is_hole { Feature::Hole } else { Feature::Shaft })
    }
}
