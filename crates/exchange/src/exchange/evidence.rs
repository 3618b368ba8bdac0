//! What columns state of how a value came about: whether anybody measured it, and whether it was brought to 20 °C already. Both are
//! read wherever a file has them: a simulated value is no evidence, and a value is corrected once.

use std::collections::HashSet;
use std::sync::LazyLock;

use csv::StringRecord;
use fitcheck_core::message::{Message, READ_BACK};
use fitcheck_core::words::{Language, Words};
use fitcheck_nc::control::simulated::is_mark;

use super::claim::Claim;
use super::error::ImportErrorKind;
use super::given::shorten;
use super::refused::{Cell, Refused};
use super::{cells, warmth, words};
use crate::exchange::cell::Cells as _;

#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Evidence {
    /// A column that says where a value comes from: `simulated, cycle 421`, `typed`.
    pub(super) origin: Option<usize>,
    /// A column that says whether a value was brought to 20 °C.
    corrected: Option<usize>,
    /// Whether the name of the measured values says so.
    pub(super) are_corrected: bool,
    /// At which temperature all values were measured, as the name of their column or a line above it says.
    pub(super) warm: Option<Claim>,
    /// A column of any other name that says of some value that nobody measured.
    pub(super) word: Option<usize>,
    /// Whether the mark of a simulation stands above all rows.
    pub(super) are_simulated: bool,
}

impl Evidence {
    /// The columns of a header beside that of the measured values.
    pub(super) fn of(header: &StringRecord, measured: usize) -> Self {
        let at =
            |is: fn(&str) -> bool| (0..).zip(header).find(|(at, name)| *at != measured && is(name)).map(|(at, _)| at);
        let is_done = |name: &str| words::says_corrected(name) && !warmth::denies_correction(name);
        let are_corrected = header.get(measured).is_some_and(is_done);
        let origin = at(words::is_origin);
        let corrected = at(words::is_corrected);
        Self { origin, corrected, are_corrected, warm: None, word: None, are_simulated: false }
    }

    /// Whether a row says that its value was brought to 20 °C. What is neither yes nor no says so as well: it refuses a correction, and
    /// nothing else.
    pub(super) fn is_corrected(&self, cells: &StringRecord) -> bool {
        let text = cells.cell(self.corrected).trim();
        self.are_corrected || !text.is_empty() && yes_or_no(text) != Some(false) && text.parse() != Ok(0.0)
    }

    /// Whether a row says by its origin that nobody measured.
    pub(super) fn is_simulated<'c>(&self, cells: &'c StringRecord) -> Result<bool, Refused<'c>> {
        let text = cells.cell(self.origin).trim();
        let unknown = || (Cell { at: self.origin, text }, ImportErrorKind::Origin { given: shorten(text) });
        let says_so = self.word.and_then(|at| cells.get(at)).is_some_and(says_simulated);
        Ok(is_simulated(text).ok_or_else(unknown)? || self.are_simulated || says_so)
    }
}

/// Whether a row is the mark below which all is simulated, as it stands in what a control would have printed.
pub(super) fn marks_simulation(cells: &StringRecord) -> bool {
    cells::is_comment(cells) && cells.iter().any(is_mark)
}

/// What a cell says of a question.
pub(super) fn yes_or_no(text: &str) -> Option<bool> {
    match text.trim().to_lowercase().as_str() {
        "true" | "yes" | "y" | "ja" | "j" | "sì" | "si" | "1" | "x" | "wahr" | "waar" | "vero" | "on" | "ein"
        | "aan" => Some(true),
        "false" | "no" | "n" | "nein" | "nee" | "0" | "-" | "falsch" | "onwaar" | "falso" | "off" | "aus" | "uit" => {
            Some(false)
        }
        _ => None,
    }
}

/// Words of a value that nobody measured. What Fitcheck itself writes in its languages is in [`Said`].
const SIMULATED: &str = "simulated|simulation|simuliert|simulierte|simulierter|simuliertes|gesimuleerd|gesimuleerde|simulatie|simulato|\
    simulata|simulazione|simulé|simulée|simulado|simulada|simulación|symulacja|symulowany|symulowana|symulowane|simulováno|simulovaný|\
    simulovaná|simulace";

/// Whether a cell is nothing but such a word.
pub(super) fn says_simulated(cell: &str) -> bool {
    is_of_simulation(&cell.trim().to_lowercase())
}

/// Whether a text has such a word.
pub(super) fn mentions_simulation(text: &str) -> bool {
    let small = text.to_lowercase();
    small.split(|c: char| !c.is_alphanumeric()).any(is_of_simulation)
}

/// Words with which the origin of a measured value begins.
const MEASURED: &str = "measured|measurement|measuring|typed|manual|imported|recorded|contacts|probed|cmm|gauge|gemessen|messung|messwert|\
    getippt|eingegeben|eingetippt|manuell|importiert|aufgezeichnet|antastpunkte|angetastet|gemeten|meting|getypt|ingevoerd|handmatig|\
    geïmporteerd|opgenomen|geregistreerd|meetpunten|misurato|misurata|misura|misurazione|digitato|inserito|manuale|importato|registrato|\
    contatti|messmaschine|meetmachine|kmg|mesuré|mesurée|mesure|saisi|importé|enregistré|medido|medida|medición|escrito|importado|\
    registrado|zmierzono|zmierzony|pomiar|wpisano|změřeno|naměřeno|měřeno|měření|zadáno|importováno";

/// How Fitcheck says in each of its languages where a value comes from.
#[derive(Debug)]
struct Said {
    /// What comes before the name of a file.
    of_file: Vec<String>,
    /// The words of a value that nobody measured.
    simulated: HashSet<String>,
    /// The first words of a value that was measured.
    measured: HashSet<String>,
}

static SAID: LazyLock<Said> = LazyLock::new(|| {
    // A sign that no text has.
    const FILE: &str = "@";
    let words = |list: &str| list.split('|').map(str::to_owned).collect();
    let mut said = Said { of_file: Vec::new(), simulated: words(SIMULATED), measured: words(MEASURED) };
    // Nobody's own texts: those of no file would be known again.
    let [contacts, imported, typed, simulation, _of_cycle] = READ_BACK;
    for words in Language::all().map(Words::new) {
        let of = |id: &'static str| words.say(&Message::new(id).text("file", FILE)).to_lowercase();
        for id in [contacts, imported] {
            let text = of(id);
            let before = text.split(FILE).next().unwrap_or("").to_owned();
            said.measured.extend(before.split_whitespace().next().map(str::to_owned));
            said.of_file.extend(Some(before).filter(|before| !before.is_empty()));
        }
        said.measured.extend(Some(of(typed)));
        let simulated = of(simulation);
        said.simulated.extend(simulated.rsplit(", ").next().map(str::to_owned));
    }
    said
});

/// Whether a word is of a value that nobody measured.
fn is_of_simulation(word: &str) -> bool {
    SAID.simulated.contains(word)
}

/// Whether the text of an origin says that nobody measured; an empty one says nothing. `None` where it says neither.
pub(super) fn is_simulated(text: &str) -> Option<bool> {
    let small = text.trim().to_lowercase();
    if small.is_empty() {
        return Some(false);
    }
    // Of a cycle: `cycle 421, contacts from a.csv`.
    let said =
        small.strip_prefix("cycle ").and_then(|rest| rest.split_once(", ")).map_or(small.as_str(), |(_, rest)| rest);
    let words = |text: &str| -> Vec<String> {
        let words = text.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
        words.map(str::to_owned).collect()
    };
    // A name of a file may have any words; what is said of it stands behind it.
    if SAID.of_file.iter().any(|begin| said.starts_with(begin)) {
        return Some(said.rsplit_once(", ").is_some_and(|(_, last)| is_of_simulation(last)));
    }
    let words = words(said);
    if words.iter().any(|word| is_of_simulation(word)) {
        return Some(true);
    }
    let is_measured = |word: &&String| SAID.measured.contains(*word);
    words.first().filter(is_measured).map(|_| false)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_said_in_a_language_is_read_in_every_language() {
        for language in Language::all() {
            let words = Words::new(language);
            let of = |id: &'static str| {
                words.say(&Message::new(id).text("file", "simulated.csv").text("cycle", 421).text("seed", 7))
            };
            for (id, expected) in [
                ("origin-simulated", true),
                ("origin-contacts", false),
                ("origin-imported", false),
                ("origin-imported-simulation", true),
                ("origin-typed", false),
            ] {
                assert_eq!(is_simulated(&of(id)), Some(expected), "{language}: {}", of(id));
            }
        }
    }

    #[test]
    fn an_origin_says_measured_or_simulated_or_nothing() {
        for (text, expected) in [
            ("", Some(false)),
            ("simulated, cycle 421, seed 7", Some(true)),
            ("cycle 421, simulated, a workpiece without faults", Some(true)),
            ("cycle 421, contacts from simulated.csv", Some(false)),
            ("imported from simulated, 3.csv", Some(false)),
            ("imported from a.csv, simulated", Some(true)),
            ("typed", Some(false)),
            ("Simuliert", Some(true)),
            ("gemeten", Some(false)),
            ("measured (simulation)", Some(true)),
            ("not measured", None),
            ("Werk 2", None),
        ] {
            assert_eq!(is_simulated(text), expected, "{text}");
        }
    }
}
