//! What the lines above a header say of all values below it: `Part Name;Plate 4711`, `SER NUMBER : 3`. A column of the same counts first.

use std::ops::RangeInclusive;

use csv::StringRecord;
use fitcheck_core::part::{Draft, HeadField};
use jiff::civil::DateTime;

use super::given::shorten;
use super::measurements::date_time;
use super::role::Role;
use super::vocabulary::{KNOWN, Names, Rank};
use super::words;

/// More names of a part than those of a column: beside a title they can hardly be anything else.
static PART: Names = Names::of(
    "part name|teilename|teilebezeichnung|benennung|item description|part description|naam onderdeel|\
    nome pezzo|nom de la pièce|nombre de la pieza",
);

/// Names of a drawing, and of its revision.
static DRAWING: Names = Names::of(
    "drawing|drawing no|drawing number|drawing no rev|drg no|drg no rev|zeichnung|zeichnungsnummer|zeichnungs nr|tekening|\
    tekeningnummer|disegno|numero disegno|plan|numéro de plan|plano|número de plano",
);
static REVISION: Names = Names::of(
    "revision|rev|rev no|rev number|drawing revision|revisie|revisione|révision|revisión|änderungsstand|änderungsindex|index|indice",
);

fn has(list: &Names, key: &str) -> bool {
    list.has(&words::bare(key))
}

/// What is said of all values.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Head {
    pub(super) part: String,
    pub(super) serial: String,
    pub(super) who: String,
    pub(super) machine: String,
    pub(super) batch: String,
    pub(super) time: Option<DateTime>,
    /// The drawing and its revision, for a plan.
    pub(super) drawing: String,
    pub(super) revision: String,
    /// The words of all that, and the line of the first.
    pub(super) said: Option<(usize, String)>,
    /// The cells that say it: line and column.
    used: Vec<(usize, usize)>,
}

impl Head {
    /// What some lines say; the first of two that say the same thing counts.
    pub(super) fn of<'l>(lines: impl Iterator<Item = &'l (usize, StringRecord)>) -> Self {
        let mut head = Self::default();
        let mut day = String::new();
        let mut clock = String::new();
        let mut said: Vec<String> = Vec::new();
        for (line, cells) in lines {
            for (columns, key, value) in pairs(cells) {
                let place = match role(key) {
                    _ if has(&DRAWING, key) => &mut head.drawing,
                    _ if has(&REVISION, key) => &mut head.revision,
                    Some(Role::Part) => &mut head.part,
                    Some(Role::Serial) => &mut head.serial,
                    Some(Role::Who) => &mut head.who,
                    Some(Role::Machine) => &mut head.machine,
                    Some(Role::Batch) => &mut head.batch,
                    Some(Role::Time) if value.contains(':') && !value.contains(['-', '.', '/']) => &mut clock,
                    Some(Role::Time) => &mut day,
                    _ => continue,
                };
                if place.is_empty() && !value.is_empty() {
                    value.clone_into(place);
                    said.push(shorten(&format!("{key} {value}")));
                    head.used.extend(columns.map(|column| (*line, column)));
                    head.said.get_or_insert((*line, String::new()));
                }
            }
        }
        if !day.is_empty() {
            head.time = date_time(format!("{day} {clock}").trim()).or_else(|| date_time(&day));
        }
        if let Some((_, text)) = &mut head.said {
            *text = said.join(", ");
        }
        head
    }

    /// The cells of a line of which it has taken nothing.
    pub(super) fn rest(&self, line: usize, cells: &StringRecord) -> StringRecord {
        let is_used = |column: usize| self.used.contains(&(line, column));
        cells.iter().enumerate().map(|(column, cell)| if is_used(column) { "" } else { cell }).collect()
    }
}

impl Head {
    /// Writes part and drawing into a plan; the part as something else names it where no line does.
    pub(super) fn write_into(&self, draft: &mut Draft, part: &str) {
        draft.set(HeadField::Part, if self.part.is_empty() { part.to_owned() } else { self.part.clone() });
        let drawing = [self.drawing.as_str(), self.revision.as_str()].into_iter().filter(|text| !text.is_empty());
        draft.set(HeadField::Drawing, drawing.collect::<Vec<_>>().join(" "));
    }

    /// Takes what lines further down say, which counts from there; `false` where nothing of it is new.
    pub(super) fn go_on(&mut self, other: Self) -> bool {
        let Self { part, serial, who, machine, batch, time, drawing, revision, said, used } = other;
        self.used.extend(used);
        let texts = [
            (&mut self.part, part),
            (&mut self.serial, serial),
            (&mut self.who, who),
            (&mut self.machine, machine),
            (&mut self.batch, batch),
            (&mut self.drawing, drawing),
            (&mut self.revision, revision),
        ];
        let mut is_new = false;
        for (own, new) in texts.into_iter().filter(|(own, new)| !new.is_empty() && **own != *new) {
            *own = new;
            is_new = true;
        }
        if time.is_some() && time != self.time {
            self.time = time;
            is_new = true;
        }
        self.said = said;
        is_new
    }
}

/// The keys of a line with their values, and the columns of both: in cells beside each other, or in one cell with a colon.
fn pairs(cells: &StringRecord) -> Vec<(RangeInclusive<usize>, &str, &str)> {
    let cells: Vec<(usize, &str)> =
        (0..).zip(cells.iter().map(str::trim)).filter(|(_, cell)| !cell.is_empty()).collect();
    let mut found = Vec::new();
    let mut rest = cells.as_slice();
    while let [(at, first), more @ ..] = rest {
        rest = more;
        if let Some((key, value)) =
            first.split_once([':', '=']).filter(|(key, value)| role(key).is_some() && !value.trim().is_empty())
        {
            found.push((*at..=*at, key.trim(), value.trim()));
            continue;
        }
        let key = first.trim_end_matches([':', '=']).trim();
        if let [(value_at, value), more @ ..] = more
            && role(key).is_some()
            && role(value.trim_end_matches(':')).is_none()
        {
            found.push((*at..=*value_at, key, *value));
            rest = more;
        }
    }
    found
}

fn role(key: &str) -> Option<Role> {
    let bare = words::bare(key);
    if has(&DRAWING, key) || has(&REVISION, key) {
        // Beside the lines of a head a drawing is none of its parts.
        return Some(Role::Id);
    }
    if PART.has(&bare) {
        return Some(Role::Part);
    }
    let is_time = || KNOWN.whole.get(bare.as_str()) == Some(&(Role::Time, Rank::Exact));
    words::label(key)
        .filter(|role| !matches!(role, Role::Number | Role::X | Role::Y | Role::Z))
        .or_else(|| is_time().then_some(Role::Time))
}
