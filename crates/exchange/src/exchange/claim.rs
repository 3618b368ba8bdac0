//! What a file itself says of a value beside it: its status, its limits, its deviation, whether it is of a hole or a shaft. It is told where
//! the answer is another one, and changes none.

use fitcheck_core::length::{Length, Unit};
use fitcheck_core::tolerance::fit::thermal::Temperature;
use fitcheck_core::tolerance::{Bounds, Feature};
use fitcheck_core::verdict::Status;
use fitcheck_nc::control::status::status_of;

use super::error::ImportWarningKind;
use super::given::shorten;
use super::quantity::is_form;
use super::vocabulary::Names;
use crate::journal::Record;

/// Words and marks of a value within its limits, without their stops and blanks.
static GOOD: Names = Names::of(
    "ok|pass|passed|accept|accepted|conform|conforms|conforming|io|inordnung|oke|akkoord|goedgekeurd|conforme|intolerance|\
    intol|withintolerance|withinlimits|gut|goed|buono|bestanden|freigegeben|innerhalb|idoneo|accettato|✓|✔|✅|☑",
);

/// The same of one out of its limits.
static OUT: Names = Names::of(
    "nok|notok|ng|fail|failed|reject|rejected|nio|nichtinordnung|nietok|nietakkoord|afgekeurd|nonconform|nonconforme|\
    nonconforming|nonok|ko|bad|schlecht|slecht|scrapped|outoftolerance|outoftol|outoflimits|oot|zurückgewiesen|gesperrt|nichtbestanden|\
    außerhalb|ausserhalb|fout|fuoritolleranza|nonidoneo|respinto|blocked|✗|✘|✕|❌|☒",
);

/// Words that say how far a value has come, and nothing of its verdict.
static NO_VERDICT: Names =
    Names::of("measured|done|complete|completed|finished|gemessen|fertig|erledigt|gemeten|gereed|klaar|misurato|none");

/// Marks that say something without a letter.
const MARKS: &str = "✓✔✅☑✗✘✕❌☒?!+";

pub(super) fn letters(word: &str) -> String {
    word.to_lowercase().chars().filter(|c| c.is_alphanumeric()).collect()
}

fn says_nothing(text: &str) -> bool {
    let small = text.trim().to_lowercase();
    // "NA" without its stroke may be rework.
    let is_none = matches!(small.as_str(), "n/a" | "n.a." | "n.v.t." | "n. v. t.");
    is_none || NO_VERDICT.has(&small)
}

/// Marks that turn a word round, or put it in doubt.
const AGAINST: [char; 8] = ['✗', '✘', '✕', '❌', '☒', '≠', '!', '?'];

/// What a file says of a value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Claim {
    /// As the file says it.
    said: String,
    what: ClaimContent,
}

#[derive(Debug, Clone, PartialEq, Eq)]
enum ClaimContent {
    /// The verdicts that agree with it.
    Status(&'static [Status]),
    /// A status that is not known.
    Unknown,
    Upper(Figure),
    Lower(Figure),
    /// The largest of something: a limit, or one of several readings.
    Largest(Figure),
    Smallest(Figure),
    Deviation(Figure),
    Feature(Feature),
    /// How warm the part was, and from which temperature its value was brought to 20 °C.
    Warm {
        said: Temperature,
        counted: Temperature,
    },
    /// That it is no size of one part.
    NoSize,
    Unit,
    /// That nobody measured it.
    Simulated,
}

/// The answer that a claim is compared with.
#[derive(Debug, Clone, Copy)]
pub(super) struct ClaimAnswer {
    pub(super) bounds: Bounds,
    pub(super) measured: Length,
    pub(super) status: Status,
}

impl ClaimAnswer {
    /// The answer that a record gives.
    pub(super) fn of(record: &Record) -> Self {
        let measured = record.measurement.diameter;
        let status = record.verdict.status();
        Self { bounds: record.limits.bounds(), measured, status }
    }
}

/// A number of which nobody says whether it is a size or a deviation: all readings, each with how far it may be rounded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Figure([Option<(Length, Length)>; 2]);

impl Figure {
    /// In its unit, and in micrometres where that may be meant; `None` for what is no number.
    pub(super) fn read(text: &str, unit: Unit) -> Option<Self> {
        // "+0.021", and a minus sign of typesetters.
        let text = text.trim().trim_start_matches('+').replace('\u{2212}', "-");
        let decimals = text.rsplit_once(['.', ',']).map_or(0, |(_, decimals)| decimals.len());
        let read = |unit: Unit| Some((Length::parse_in(&text, unit).ok()?, rounded_by(unit, decimals)));
        let own = read(unit)?;
        Some(Self([Some(own), read(Unit::Micrometre).filter(|_| unit == Unit::Millimetre)]))
    }

    /// Whether it lies between two sizes, as it stands.
    fn is_within(self, from: Length, to: Length) -> bool {
        self.0.first().copied().flatten().is_some_and(|(size, _)| from <= size && size <= to)
    }

    /// Whether a reading is one of these lengths, each made of the number.
    fn is(self, length: Length, made: impl Fn(Length) -> [Option<Length>; 3]) -> bool {
        let mut readings = self.0.into_iter().flatten();
        readings.any(|(number, half)| {
            made(number).into_iter().flatten().any(|made| made.saturating_sub(length).abs() <= half)
        })
    }
}

/// How far a number of so many decimals may be from what it was rounded from. With few decimals it was not rounded: 25 is 25.000.
fn rounded_by(unit: Unit, decimals: usize) -> Length {
    let (half, least) = match unit {
        Unit::Millimetre => (500_000, 2),
        Unit::Micrometre => (500, 0),
        Unit::Inch => (12_700_000, 4),
    };
    let power = u32::try_from(decimals).ok().and_then(|decimals| 10_i64.checked_pow(decimals));
    let half = power.filter(|_| least <= decimals).map_or(0, |power| half / power);
    Length::from_nanometres(half).unwrap_or(Length::ZERO)
}

impl Claim {
    const fn new(said: String, what: ClaimContent) -> Self {
        Self { said, what }
    }

    pub(super) fn of(said: &str, status: Status) -> Self {
        let agrees: &'static [Status] = match status {
            Status::Good => &[Status::Good],
            Status::Rework => &[Status::Rework, Status::OutOfLimits],
            Status::OutOfLimits => &[Status::OutOfLimits, Status::Rework, Status::Scrap],
            Status::Scrap => &[Status::Scrap, Status::OutOfLimits],
            Status::ReMeasure => &[Status::ReMeasure],
        };
        Self::new(shorten(said), ClaimContent::Status(agrees))
    }

    /// Whether it says something of each value of a part when it is said of the part: all values of a good part are good, and which value of
    /// another part is not, it does not say.
    pub(super) fn is_of_each(&self) -> bool {
        !matches!(self.what, ClaimContent::Status([first, ..]) if *first != Status::Good)
    }

    /// That a value is out of its limits, or that something else is wrong with it.
    pub(super) fn out(said: &str) -> Self {
        // Whoever knows no rework calls it so as well.
        Self::new(shorten(said), ClaimContent::Status(&[Status::Rework, Status::OutOfLimits, Status::Scrap]))
    }

    /// A claim that no verdict agrees with.
    pub(super) fn unknown(said: &str) -> Self {
        Self::new(shorten(said), ClaimContent::Status(&[]))
    }

    /// An upper limit, which may be a size or a deviation.
    pub(super) fn upper(said: &str, figure: Figure) -> Self {
        Self::new(shorten(said), ClaimContent::Upper(figure))
    }

    /// A lower limit, which may stand without its sign as a deviation.
    pub(super) fn lower(said: &str, figure: Figure) -> Self {
        Self::new(shorten(said), ClaimContent::Lower(figure))
    }

    /// The same of a limit that may be the largest or the smallest of several readings as well.
    #[must_use]
    pub(super) fn or_reading(self) -> Self {
        let what = match self.what {
            ClaimContent::Upper(figure) => ClaimContent::Largest(figure),
            ClaimContent::Lower(figure) => ClaimContent::Smallest(figure),
            other => other,
        };
        Self { what, ..self }
    }

    pub(super) fn deviation(said: &str, figure: Figure) -> Self {
        Self::new(shorten(said), ClaimContent::Deviation(figure))
    }

    /// A hole or a shaft.
    pub(super) fn feature(said: &str, feature: Feature) -> Self {
        Self::new(shorten(said), ClaimContent::Feature(feature))
    }

    /// How warm the part was.
    pub(super) fn warm(said: &str, warm: Temperature) -> Self {
        Self::new(shorten(said), ClaimContent::Warm { said: warm, counted: Temperature::REFERENCE })
    }

    /// Whether it says how warm the part was.
    pub(super) const fn is_of_temperature(&self) -> bool {
        matches!(self.what, ClaimContent::Warm { .. })
    }

    /// Whether it says 20 °C.
    pub(super) fn is_of_reference(&self) -> bool {
        matches!(self.what, ClaimContent::Warm { said, .. } if said == Temperature::REFERENCE)
    }

    /// The same beside values that are brought to 20 °C from this temperature.
    #[must_use]
    pub(super) fn from(self, counted: Temperature) -> Self {
        let what = match self.what {
            ClaimContent::Warm { said, .. } => ClaimContent::Warm { said, counted },
            other => other,
        };
        Self { what, ..self }
    }

    /// That a value is in another unit.
    pub(super) fn of_unit(said: &str) -> Self {
        Self::new(shorten(said), ClaimContent::Unit)
    }

    /// That nobody measured a value.
    pub(super) fn simulated(said: &str) -> Self {
        Self::new(shorten(said), ClaimContent::Simulated)
    }

    /// A name that is none of a size of one part.
    pub(super) fn no_size(said: &str) -> Self {
        Self::new(shorten(said), ClaimContent::NoSize)
    }

    /// What a cell of a table says of the status; `None` where it says nothing of a verdict.
    pub(super) fn of_cell(text: &str) -> Option<Self> {
        let is_said = text.contains(|c: char| c.is_alphanumeric() || MARKS.contains(c)) && !says_nothing(text);
        is_said.then(|| Self::of_word(text).unwrap_or_else(|| Self::new(shorten(text), ClaimContent::Unknown)))
    }

    /// What a word says of the status; `None` for one that is not known.
    pub(super) fn of_word(word: &str) -> Option<Self> {
        if let Some(status) = status_of(word).or_else(|| of_workbook(word)) {
            return Some(Self::of(word, status));
        }
        let small = letters(word);
        let is = |list: &Names| list.has(&small) || list.has(word.trim());
        if is(&OUT) {
            return Some(Self::out(word));
        }
        if word.contains(AGAINST) {
            return Some(Self::new(shorten(word), ClaimContent::Unknown));
        }
        if is(&GOOD) {
            return Some(Self::of(word, Status::Good));
        }
        // "n.i.O. (scratch)", "rejected - burr"
        let (first, rest) =
            word.split_once(" (").or_else(|| word.split_once(" - ")).or_else(|| word.split_once(": "))?;
        let claim = Self::of_word(first)?;
        // "OK (Ausschuss)"
        let words = rest.split([' ', '(', ')', ',', ';', '/']).filter(|word| !word.is_empty());
        let is_against = words.filter_map(Self::of_word).any(|more| more.is_rejection() != claim.is_rejection());
        let what = if is_against { ClaimContent::Unknown } else { claim.what };
        Some(Self::new(shorten(word), what))
    }

    /// Whether it says something that can be compared.
    pub(super) const fn is_known(&self) -> bool {
        !matches!(self.what, ClaimContent::Unknown)
    }

    /// Whether it says that the value is not good.
    pub(super) fn is_rejection(&self) -> bool {
        matches!(self.what, ClaimContent::Status(agrees) if !agrees.contains(&Status::Good))
    }

    /// As the file says it.
    pub(super) fn said(&self) -> &str {
        &self.said
    }

    /// Whether it says that a value is of a hole or a shaft.
    pub(super) const fn is_of_feature(&self) -> bool {
        matches!(self.what, ClaimContent::Feature(_))
    }

    /// What is to be told beside an answer: that the file says another one, or something that is not known.
    pub(super) fn tells(&self, answer: &ClaimAnswer) -> Option<ImportWarningKind> {
        let ClaimAnswer { bounds, measured, status } = answer;
        let nominal = bounds.nominal;
        let given = self.said.clone();
        let above = |by: Length| nominal.checked_add(by);
        let is_so = match &self.what {
            ClaimContent::Status(_) => return self.differs(*status),
            ClaimContent::Warm { said, counted } if !is_felt(*said, *counted, bounds) => return None,
            ClaimContent::Warm { counted, .. } => {
                return Some(ImportWarningKind::TemperatureDiffers { given, counted: counted.to_string() });
            }
            // A form that is judged as one is what its name says.
            ClaimContent::NoSize if nominal == Length::ZERO && bounds.minimum() == Length::ZERO && is_form(&given) => {
                return None;
            }
            ClaimContent::NoSize => return Some(ImportWarningKind::NameOfNoSize { given }),
            ClaimContent::Unit => return Some(ImportWarningKind::SpeaksOfUnit { text: given }),
            ClaimContent::Simulated => return Some(ImportWarningKind::SpeaksOfSimulation { text: given }),
            ClaimContent::Unknown => {
                return Some(ImportWarningKind::StatusUnknown { given, status: status.word().to_owned() });
            }
            ClaimContent::Largest(figure) if figure.is_within(*measured, bounds.maximum()) => true,
            ClaimContent::Smallest(figure) if figure.is_within(bounds.minimum(), *measured) => true,
            ClaimContent::Upper(figure) | ClaimContent::Largest(figure) => {
                figure.is(bounds.maximum(), |number| [Some(number), above(number), None])
            }
            // A lower deviation may stand without its sign.
            ClaimContent::Lower(figure) | ClaimContent::Smallest(figure) => {
                figure.is(bounds.minimum(), |number| [Some(number), above(number), nominal.checked_sub(number)])
            }
            ClaimContent::Deviation(figure) => {
                figure.is(*measured, |by| [above(by), bounds.middle().checked_add(by), None])
            }
            ClaimContent::Feature(said) => match bounds.feature {
                Some(feature) if *said != feature => {
                    return Some(ImportWarningKind::FeatureDiffers { given, feature });
                }
                _ => true,
            },
        };
        let minimum = bounds.minimum();
        let maximum = bounds.maximum();
        let differs = match self.what {
            ClaimContent::Deviation(_) => ImportWarningKind::DeviationDiffers { given, measured: *measured, nominal },
            _ => ImportWarningKind::LimitDiffers { given, minimum, maximum },
        };
        (!is_so).then_some(differs)
    }

    /// The warning where a verdict is another one.
    pub(super) fn differs(&self, status: Status) -> Option<ImportWarningKind> {
        let ClaimContent::Status(agrees) = self.what else { return None };
        let warning =
            || ImportWarningKind::StatusDiffers { given: self.said.clone(), status: status.word().to_owned() };
        (!agrees.contains(&status)).then(warning)
    }
}

/// The verdict of a cell of our own workbooks: its mark, a blank and its word.
fn of_workbook(cell: &str) -> Option<Status> {
    let (mark, word) = cell.trim().split_once(' ')?;
    let expected = match status_of(word)? {
        Status::Good => "✓",
        Status::Rework => "\u{21bb}",
        Status::ReMeasure => "?",
        Status::OutOfLimits => "\u{2195}",
        Status::Scrap => "✗",
    };
    status_of(word).filter(|_| mark == expected)
}

/// The expansion by which a difference of temperatures is weighed, in nanometres per metre and kelvin: that of aluminium, the largest of
/// what shops turn and mill most.
const EXPANSION: i128 = 24_000;

/// Whether a part may grow by more than a tenth of its zone between two temperatures: less is within what a station shows of itself.
fn is_felt(said: Temperature, counted: Temperature, bounds: &Bounds) -> bool {
    let thousandths = i128::from((said.thousandths() - counted.thousandths()).abs());
    let zone = i128::from(bounds.maximum().saturating_sub(bounds.minimum()).nanometres());
    // Nanometres · thousandths of a kelvin · nanometres per metre and kelvin.
    let growth = i128::from(bounds.nominal.nanometres()) * thousandths * EXPANSION;
    zone * 1_000_000_000 * 1_000 < growth * 10
}
