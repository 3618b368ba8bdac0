//! The answer as the page shows it: pairs row by row, leftovers by name, the text for a spreadsheet.

use fitcheck_core::length::{Length, Unit};
use fitcheck_core::message::Message;
use fitcheck_core::pairing::{Pair, PairClearances};
use fitcheck_core::words::Words;
use fitcheck_exchange::exchange::Size;
use fitcheck_exchange::report::csv::harmless;
use fitcheck_exchange::report::pairing::{PairingAnswer, PairingParts, PairingRequest, PartsFrom};

use super::picture::PairsPicture;

/// An answer with its picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Paired {
    pub answer: PairingAnswer,
    pub picture: PairsPicture,
    /// How many pairs have a part that nobody measured.
    pub simulated: usize,
    /// How many decimals the figures of the list have, so that they stand below each other.
    decimals: Decimals,
}

/// The decimals that the most exact figure of a column has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Decimals {
    /// Of a size, mm.
    size: usize,
    /// Of a clearance, µm.
    clearance: usize,
    /// Of a distance from the middle, µm.
    from_middle: usize,
}

impl Decimals {
    fn of<'a>(rows: impl Iterator<Item = PairRow<'a>>) -> Self {
        let after_point = |text: &str| text.split_once('.').map_or(0, |(_, decimals)| decimals.len());
        rows.fold(Self { size: 3, clearance: 0, from_middle: 0 }, |most, row| {
            let size = |size: &Size| after_point(&size.measured.exact(Unit::Millimetre, 3));
            Self {
                size: most.size.max(size(row.hole)).max(size(row.shaft)),
                clearance: most.clearance.max(after_point(&row.clearance.exact(Unit::Micrometre, 0))),
                from_middle: most.from_middle.max(after_point(&row.from_middle.signed_um())),
            }
        })
    }
}

/// A figure with at least this many decimals.
fn padded(figure: &str, decimals: usize) -> String {
    match figure.split_once('.') {
        Some((whole, rest)) => format!("{whole}.{rest:0<decimals$}"),
        None if decimals == 0 => figure.to_owned(),
        None => format!("{figure}.{:0<decimals$}", ""),
    }
}

/// A pair of the list.
#[derive(Debug, Clone, Copy)]
pub struct PairRow<'a> {
    pub hole: &'a Size,
    pub shaft: &'a Size,
    /// Hole minus shaft.
    pub clearance: Length,
    /// How far the clearance is from the middle of the wanted ones.
    pub from_middle: FromMiddle,
}

/// How far a clearance is from the middle of the wanted ones, which may lie on a half nanometre: twice the distance is
/// exact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FromMiddle {
    twice: Length,
}

impl FromMiddle {
    fn of(wanted: PairClearances, clearance: Length) -> Self {
        let below = clearance.saturating_sub(wanted.minimum());
        let above = wanted.maximum().saturating_sub(clearance);
        Self { twice: below.saturating_sub(above) }
    }

    /// Micrometres with a sign, for machines: `+3`, `-0.0005`, `0`.
    pub fn signed_um(self) -> String {
        let twice = self.twice.abs();
        let odd = Length::constant(twice.nanometres() % 2);
        let whole = twice.saturating_sub(odd).midpoint(Length::ZERO);
        let amount = match odd {
            Length::ZERO => whole.exact(Unit::Micrometre, 0),
            _ => whole.exact(Unit::Micrometre, 3) + "5",
        };
        let sign = match self.twice.nanometres().signum() {
            0 => "",
            1 => "+",
            _ => "-",
        };
        format!("{sign}{amount}")
    }
}

/// The middle of the wanted clearances in micrometres with a sign, for machines; exact also on a half nanometre.
pub(super) fn middle_um(wanted: PairClearances) -> String {
    // As far from zero as zero is from it.
    let twice = wanted.minimum().saturating_sub(wanted.maximum().negated());
    FromMiddle { twice }.signed_um()
}

impl Paired {
    /// Pairs and sorts, and prepares the picture: what takes longer than a frame.
    pub fn of(asked: PairingRequest) -> Self {
        let answer = asked.answer();
        let is_simulated = |parts: &PairingParts, at: usize| parts.sizes.get(at).is_some_and(|part| part.is_simulated);
        let asked = &answer.asked;
        let simulated = answer.pairing.pairs.iter();
        let simulated = simulated
            .filter(|pair| is_simulated(&asked.holes, pair.hole) || is_simulated(&asked.shafts, pair.shaft))
            .count();
        let picture = PairsPicture::of(&answer);
        let mut paired = Self { answer, picture, simulated, decimals: Decimals::of(std::iter::empty()) };
        paired.decimals = Decimals::of((0..paired.count()).filter_map(|at| paired.row(at)));
        paired
    }

    /// The size of a part in mm, for machines, with the decimals of the list.
    pub fn mm(&self, part: &Size) -> String {
        part.measured.exact(Unit::Millimetre, self.decimals.size)
    }

    /// The figures of a row, for machines, each column with the same decimals: hole and shaft in mm, clearance and distance
    /// from the middle in µm with signs.
    pub fn figures(&self, row: PairRow<'_>) -> [String; 4] {
        let Decimals { clearance, from_middle, .. } = self.decimals;
        [
            self.mm(row.hole),
            self.mm(row.shaft),
            padded(&row.clearance.signed_um(), clearance),
            padded(&row.from_middle.signed_um(), from_middle),
        ]
    }

    /// How many pairs there are.
    pub fn count(&self) -> usize {
        self.answer.pairing.pairs.len()
    }

    fn row_of(&self, pair: &Pair) -> Option<PairRow<'_>> {
        let PairingRequest { holes, shafts, wanted, .. } = &self.answer.asked;
        Some(PairRow {
            hole: holes.sizes.get(pair.hole)?,
            shaft: shafts.sizes.get(pair.shaft)?,
            clearance: pair.clearance,
            from_middle: FromMiddle::of(*wanted, pair.clearance),
        })
    }

    /// The pair at a place of the list.
    pub fn row(&self, at: usize) -> Option<PairRow<'_>> {
        self.row_of(self.answer.pairing.pairs.get(at)?)
    }

    /// A leftover hole, in order of size.
    pub fn left_hole(&self, at: usize) -> Option<&Size> {
        self.answer.asked.holes.sizes.get(*self.answer.pairing.holes.get(at)?)
    }

    /// A leftover shaft, in order of size.
    pub fn left_shaft(&self, at: usize) -> Option<&Size> {
        self.answer.asked.shafts.sizes.get(*self.answer.pairing.shafts.get(at)?)
    }

    /// The name of a hole, or where it stands.
    pub fn hole_name(&self, hole: &Size, words: &Words) -> String {
        name(&self.answer.asked.holes, hole, words)
    }

    /// The name of a shaft, or where it stands.
    pub fn shaft_name(&self, shaft: &Size, words: &Words) -> String {
        name(&self.answer.asked.shafts, shaft, words)
    }

    /// The middle of the wanted clearances, in micrometres with a sign.
    pub fn middle_um(&self) -> String {
        middle_um(self.answer.asked.wanted)
    }

    /// All pairs as a spreadsheet takes them: tab-separated, exact, with the user's decimal sign.
    pub(super) fn copied(&self, words: &Words) -> String {
        let with_unit = |id: &str, unit: &str| format!("{} ({unit})", words.get(id));
        let heads = [
            words.get("pairing-page-hole"),
            with_unit("pairing-page-hole", "mm"),
            words.get("pairing-page-shaft"),
            with_unit("pairing-page-shaft", "mm"),
            with_unit("pairing-page-clearance", "µm"),
            with_unit("pairing-page-from-middle", "µm"),
            words.get("pairing-page-remark"),
        ];
        // A spreadsheet reads `-12,5` as a number, a true minus sign as text, and `+3` as a formula.
        let sign = words.decimal_sign().to_string();
        let number = |text: String| text.trim_start_matches('+').replace('.', &sign);
        let mm = |size: &Size| number(size.measured.exact(Unit::Millimetre, 3));
        let line = |row: PairRow<'_>| {
            [
                harmless(&self.hole_name(row.hole, words)),
                mm(row.hole),
                harmless(&self.shaft_name(row.shaft, words)),
                mm(row.shaft),
                number(row.clearance.exact(Unit::Micrometre, 0)),
                number(row.from_middle.signed_um()),
                row.remark().map_or_else(String::new, |remark| words.say(&remark)),
            ]
        };
        let lines = self.answer.pairing.pairs.iter().filter_map(|pair| self.row_of(pair)).map(line);
        std::iter::once(heads).chain(lines).map(|cells| cells.join("\t") + "\n").collect()
    }
}

impl PairRow<'_> {
    /// What has to be said of the pair: which of its parts nobody measured.
    pub fn remark(&self) -> Option<Message> {
        let id = match (self.hole.is_simulated, self.shaft.is_simulated) {
            (false, false) => return None,
            (true, false) => "pairing-page-hole-simulated",
            (false, true) => "pairing-page-shaft-simulated",
            (true, true) => "pairing-page-both-simulated",
        };
        Some(Message::new(id))
    }
}

/// The name of a part, or its line or check where it has none.
fn name(parts: &PairingParts, part: &Size, words: &Words) -> String {
    if !part.id.is_empty() {
        return part.id.replace(char::is_control, "\u{fffd}");
    }
    let id = match parts.from {
        PartsFrom::File(_) => "pairing-page-line",
        PartsFrom::Checks => "pairing-page-check",
    };
    words.say(&Message::new(id).count("line", part.line))
}
