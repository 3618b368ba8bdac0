//! What a row says that was measured of its feature: its diameter, or a coordinate, a radius, a roundness of the same name.
//!
//! Measuring machines write several rows of one feature, and a column tells them apart: `AXIS` with `D`, `X`, `TP`, or `Type` with
//! `Diameter`, `Flatness`. A row that says another quantity than a size is never judged as that size. The words are English, Dutch,
//! German and Italian.
//!
//! | a column | is read |
//! |---|---|
//! | whose name says a quantity: `AXIS`, `Merkmalsart` | always |
//! | whose name may say one: `Type`, `as` | where its words do; otherwise they say nothing of what was measured, which is told |
//! | of any other name, or none | where its words can hardly be anything else |
//!
//! A word that is not known is another quantity in a column that knows others. Where a column has that one word alone, or says nothing
//! known, its values are taken as sizes, and the file is told of it: with a plan, name and nominal size still have to be right.

use std::collections::BTreeMap;

use csv::StringRecord;
use fitcheck_core::part::Kind;
use fitcheck_core::probing::cycle::Axis;

use super::cells;
use super::columns::{Sample, name_of};
use super::given::shorten;
use super::units::words_of;

/// What a file says that was measured of a feature.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Quantity {
    /// A size, of whatever kind.
    Size,
    /// A diameter.
    Diameter,
    /// A distance of two walls or from a datum.
    Width,
    /// A coordinate.
    Coordinate(Axis),
    /// Anything else.
    Other,
}

impl Quantity {
    /// Whether it is the size of something: a row of it may be judged by a callout.
    pub const fn is_size(&self) -> bool {
        matches!(self, Self::Size | Self::Diameter | Self::Width)
    }

    /// Whether it is what a plan asks of a feature of a kind.
    pub fn fits(&self, kind: &Kind) -> bool {
        match self {
            Self::Size => true,
            Self::Diameter => matches!(kind, Kind::Diameter(_)),
            Self::Width => matches!(kind, Kind::Width(..) | Kind::Pocket(_) | Kind::Boss(_) | Kind::Face(..)),
            Self::Coordinate(axis) => matches!(kind, Kind::Face(_, towards) if towards.axis == *axis),
            Self::Other => false,
        }
    }
}

/// A column that says what was measured.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct QuantityColumn {
    pub(super) at: usize,
    /// Whether words that are not known are taken for a size.
    takes_unknown: bool,
    /// Whether letters such as `R` are quantities in it.
    reads_codes: bool,
    /// Its first words that are not known, and its name, where they are taken for a size.
    unknown: Option<(String, String)>,
    /// Its first cells that say a size, as they stand.
    sizes: Vec<String>,
}

/// Names of columns that say what was measured.
const STRONG: &str = "axis|axes|achse|messachse|assi|asse|quantity|measured quantity|measurand|messgröße|messgrösse|messgroesse|\
    meetgrootheid|grootheid|grandezza|grandezza misurata|characteristic type|char type|type of characteristic|merkmalsart|\
    merkmalstyp|merkmalart|art des merkmals|kenmerktype|kenmerksoort|soort kenmerk|type kenmerk|tipo caratteristica|\
    tipo di caratteristica|measurement type|measure type|type of measurement|messart|meettype|soort meting|tipo misura|\
    tipo di misura|dimension type|dim type|maßart|massart|maatsoort|tipo dimensione|tipo di quota|feature axis";

/// Names of columns that may say so.
const WEAK: &str = "type|typ|tipo|soort|art|kind|as|dim|dimension|dimensione|feature type|element type|elementtyp|elementtype|\
    tipo elemento|tipo di elemento|tolerance type|toleranztyp|toleranzart|tolerantietype|tipo tolleranza|tipo di tolleranza|\
    property|eigenschaft|eigenschap|proprietà";

/// Words of a diameter; German, Dutch and Italian ones may end a longer word.
const DIAMETERS: &str = "diameter|durchmesser|diametro|diam|dia|ø|innendurchmesser|außendurchmesser|aussendurchmesser|binnendiameter|\
    buitendiameter|bohrungsdurchmesser|lochdurchmesser|wellendurchmesser";

/// Words of a distance between two walls, or from a datum.
const WIDTHS: &str = "width|breite|breedte|larghezza|distance|abstand|distanz|afstand|distanza|length|länge|laenge|lengte|\
    lunghezza|thickness|dicke|dikte|spessore|slot|nut|sleuf|groef|cava";

/// Words of a size.
const SIZES: &str = "size|maß|mass|maat|misura|dimension|dimensione|quota|measure";

/// Words of what has a diameter; beside the name of a feature they say nothing new.
const ROUND: &str = "bore|hole|bohrung|boring|gat|foro|shaft|welle|albero|circle|kreis|cirkel|cerchio|cylinder|zylinder|cilinder|\
    cilindro|pin|stift|pen|perno|zapfen|tap";

/// Those of them that are holes; the others are shafts, but for circles and cylinders.
const HOLES: &str = "bore|hole|bohrung|boring|gat|foro";
const SHAFTS: &str = "shaft|welle|albero|pin|stift|pen|perno|zapfen|tap";

/// Words that change none of these.
const NEUTRAL: &str = "inner|outer|inside|outside|innen|außen|aussen|binnen|buiten|interno|esterno|of|a|the|des|der|di|van|nominal|\
    linear|lineare|lineair|min|max|gauss|lsc|mic|mcc|mzc|ls|mi|mc|two|2pt|int|ext|est";

/// Words of other quantities. A word that begins with one of them is one as well.
const OTHERS: &str = "radius|radii|radien|radial|raggio|straal|halbmesser|roundness|round|rondheid|rundheit|circularit|circolarit|\
    rotondit|flat|flatness|eben|ebenheit|vlakheid|planarit|planlauf|straight|gerad|geradheit|rechtheid|rettilin|cylindricit|\
    zylindrizit|zylinderform|cilindricit|kreisform|parallel|perpendic|squareness|rechtwink|haaks|ortogonal|angular|angle|winkel|\
    neigung|hoek|angol|inclinaz|position|positie|posizion|lage|location|localizz|concentr|konzentr|coaxial|koaxial|coassial|\
    symmetr|simmetri|profil|form|runout|rundlauf|gesamtlauf|slinger|rondloop|oscillaz|eccentr|exzentr|excentr|ovalit|ovalitä|depth|tiefe|diepte|\
    profond|height|höhe|hoehe|hoogte|altezza|rough|rauheit|rauhigkeit|rauigkeit|ruwheid|rugos|deviation|abweich|afwijk|scostam|\
    error|fehler|fout|errore|thread|gewinde|draad|filett|chamfer|fase|afschuin|smuss|pitch|steigung|spoed|passo|hardness|härte|\
    hardheid|durezz|temperat|coordinate|koordinat|coördinaat|coordinat|taper|kegel|conic|cono|cone|sphere|kugel|bol|sfera|plane|\
    ebene|vlak|piano|line|linie|lijn|linea|edge|kante|bordo|surface|fläche|oppervlak|superficie|area|weight|gewicht|peso|force|\
    kraft|torque";

/// Words that are another quantity where nothing else is said: a diameter may be one of two points.
const POINTS: &str = "point|points|punkt|punkte|punt|punten|punto|punti";

/// Letters of other quantities, as measuring software writes them.
const CODES: &str = "r|rad|tp|pos|pr|pa|a|ang|h|t|v|rn|tx|ty|tz|px|py|pz|dx|dy|dz|ppos|ptp|gdt|ra|rz";

/// The same of diameters and of distances.
const DIAMETER_CODES: &str = "d|df|dm|id|od|di|da";
const WIDTH_CODES: &str = "m|l|w|lg|wd";

/// Signs of tolerances of form and place in drawings.
const SIGNS: &str = "⏤⏥○⌭⌒⌓⟂∥∠⌖◎⌯↗⌰";

/// How many words a message names.
const NAMED: usize = 3;

/// The longest word that is the code of a quantity.
const LONGEST_CODE: usize = 4;

/// What a cell says, and how plainly.
#[derive(Clone, PartialEq, Eq)]
struct Said {
    quantity: Quantity,
    /// Whether nothing else stands in the cell, and the words are no shorthand.
    is_plain: bool,
    /// Whether it is said by a shape, such as "bore".
    is_shape: bool,
    /// Whether it is said by a letter or two.
    is_code: bool,
}

fn has(list: &str, word: &str) -> bool {
    list.split('|').any(|known| known == word)
}

fn is_other(word: &str) -> bool {
    // "lineal" is not "line": short words are whole.
    let begins = |known: &str| word == known || 4 < known.chars().count() && word.starts_with(known);
    let is_neutral = has(NEUTRAL, word);
    !is_neutral && OTHERS.split('|').any(begins)
        || ["abweichung", "toleranz", "toleranza", "tolleranza"].iter().any(|end| word.ends_with(end))
}

fn is_diameter(word: &str) -> bool {
    has(DIAMETERS, word) || ["durchmesser", "diameter"].iter().any(|end| word.ends_with(end))
}

fn axis(word: &str) -> Option<Axis> {
    Some(match word {
        "x" => Axis::First,
        "y" => Axis::Second,
        "z" => Axis::Third,
        _ => return None,
    })
}

/// What a cell says of what was measured; `None` where none of its words is known.
fn said(cell: &str) -> Option<Said> {
    let of = |quantity, is_plain| Some(Said { quantity, is_plain, is_shape: false, is_code: false });
    let cell = cell.trim();
    if cell.contains(|c| SIGNS.contains(c)) {
        return of(Quantity::Other, true);
    }
    // Most cells are numbers.
    if !cell.contains(char::is_alphabetic) {
        return None;
    }
    let words = words_of(cell);
    if let [word] = words.as_slice()
        && word.chars().count() <= LONGEST_CODE
    {
        let code = match word.as_str() {
            code if has(CODES, code) => Some(Quantity::Other),
            code if has(DIAMETER_CODES, code) => Some(Quantity::Diameter),
            code if has(WIDTH_CODES, code) => Some(Quantity::Width),
            code => axis(code).map(Quantity::Coordinate),
        };
        if let Some(quantity) = code {
            return Some(Said { quantity, is_plain: false, is_shape: false, is_code: true });
        }
    }
    let is_known = |word: &String| {
        is_other(word)
            || is_diameter(word)
            || has(WIDTHS, word)
            || has(SIZES, word)
            || has(NEUTRAL, word)
            || has(POINTS, word)
    };
    let is_plain = words.iter().all(is_known);
    let any = |is: &dyn Fn(&str) -> bool| words.iter().any(|word| is(word));
    if any(&is_other) {
        return of(Quantity::Other, is_plain);
    }
    if any(&is_diameter) {
        return of(Quantity::Diameter, is_plain);
    }
    if any(&|word| has(WIDTHS, word)) {
        return of(Quantity::Width, is_plain);
    }
    if any(&|word| has(SIZES, word)) {
        return of(Quantity::Size, is_plain);
    }
    if any(&|word| has(POINTS, word)) {
        return of(Quantity::Other, is_plain);
    }
    any(&|word| has(ROUND, word)).then_some(Said {
        quantity: Quantity::Size,
        is_plain: false,
        is_shape: true,
        is_code: false,
    })
}

/// Whether a text says that it is of a hole, or else of a shaft; `None` where it says neither, or both.
pub(super) fn is_shape(text: &str) -> Option<bool> {
    if !text.contains(char::is_alphabetic) {
        return None;
    }
    let words = words_of(text);
    let any = |list: &str| words.iter().any(|word| has(list, word));
    match (any(HOLES), any(SHAFTS)) {
        (true, false) => Some(true),
        (false, true) => Some(false),
        _ => None,
    }
}

/// Beginnings of words of form, of roughness and of radii: in the name of a feature they hardly say anything else.
const FORMS: [&str; 30] = [
    "roundness",
    "rundheit",
    "rondheid",
    "circularit",
    "rotondit",
    "radius",
    "radii",
    "raggio",
    "flatness",
    "ebenheit",
    "vlakheid",
    "planarit",
    "cylindricit",
    "zylindrizit",
    "cilindricit",
    "straightness",
    "geradheit",
    "rechtheid",
    "rettilin",
    "parallelis",
    "perpendicularit",
    "rechtwinklig",
    "haaksheid",
    "concentricit",
    "konzentrizit",
    "koaxialit",
    "runout",
    "rundlauf",
    "roughness",
    "rauheit",
];

/// Whether the name of a feature says that its form was measured, or its radius.
pub(super) fn is_form(name: &str) -> bool {
    words_of(name).iter().any(|word| FORMS.iter().any(|form| word.starts_with(form)))
}

/// Whether the name of a column says that it may tell what was measured.
pub(super) fn may_be_named(header: &str) -> bool {
    name(header) != Name::None
}

impl QuantityColumn {
    /// What a row says was measured; `None` where its cell is empty, or says nothing and is taken for a size.
    pub(super) fn of(&self, cells: &StringRecord) -> Option<Quantity> {
        let text = cells.get(self.at).unwrap_or_default().trim();
        if text.is_empty() {
            return None;
        }
        let said = said(text).filter(|said| self.reads_codes || !said.is_code);
        said.map(|said| said.quantity).or_else(|| (!self.takes_unknown).then_some(Quantity::Other))
    }

    /// Whether a cell is one of those that say a size, byte by byte.
    pub(super) fn is_known_size(&self, cell: &[u8]) -> bool {
        cell.is_empty() || self.sizes.iter().any(|size| size.as_bytes() == cell)
    }

    /// The name of the column and its words that say nothing known and are taken for a size.
    pub(super) fn taken(&self) -> Option<&(String, String)> {
        self.unknown.as_ref()
    }
}

/// What a row says was measured, by all columns that do, with the text of the first that says it is no size.
pub(super) fn of_row<'c>(columns: &[QuantityColumn], cells: &'c StringRecord) -> Option<(usize, &'c str, Quantity)> {
    let all = columns.iter().filter_map(|column| {
        let quantity = column.of(cells)?;
        Some((column.at, cells.get(column.at).unwrap_or_default().trim(), quantity))
    });
    let rank = |quantity: &Quantity| match quantity {
        Quantity::Other => 0,
        Quantity::Coordinate(_) => 1,
        Quantity::Diameter | Quantity::Width => 2,
        Quantity::Size => 3,
    };
    all.min_by_key(|(_, _, quantity)| rank(quantity))
}

/// How surely the name of a column says that its cells are quantities.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Name {
    Strong,
    Weak,
    None,
}

/// What the first cells of a column hold.
#[derive(Default)]
struct Seen<'s> {
    filled: usize,
    numbers: usize,
    /// Cells with a word that is known, and those with nothing else.
    known: usize,
    plain: usize,
    shapes: usize,
    codes: usize,
    has_diameter: bool,
    has_other: bool,
    sizes: Vec<&'s str>,
    unknown: Vec<&'s str>,
}

impl<'s> Seen<'s> {
    fn of(cells: impl Iterator<Item = &'s str>, reads_codes: bool) -> Self {
        let mut seen = Self::default();
        for cell in cells {
            seen.filled += 1;
            seen.numbers += usize::from(cells::is_number(cell));
            let Some(said) = said(cell).filter(|said| reads_codes || !said.is_code) else {
                if !seen.unknown.contains(&cell) {
                    seen.unknown.push(cell);
                }
                continue;
            };
            seen.known += 1;
            seen.plain += usize::from(said.is_plain);
            seen.shapes += usize::from(said.is_shape);
            seen.codes += usize::from(said.is_code);
            seen.has_diameter |= said.quantity == Quantity::Diameter;
            seen.has_other |= !said.quantity.is_size();
            if said.quantity.is_size() && !seen.sizes.contains(&cell) {
                seen.sizes.push(cell);
            }
        }
        seen
    }

    /// Whether the cells can hardly be anything else than quantities, whatever their column is called: words, or letters of which some
    /// are a diameter and others are none. One letter alone may be a tick, and `L` and `R` are left and right.
    fn are_quantities(&self) -> bool {
        self.filled < self.plain * 2 || self.known == self.filled && self.has_diameter && self.has_other
    }

    /// Whether the letters of a column that may say a quantity say one.
    const fn tells_codes(&self) -> bool {
        self.codes < self.known || self.has_diameter || self.unknown.is_empty()
    }

    /// Whether a column of a name that says a quantity holds nothing else.
    fn all_known(&self, name: Name) -> bool {
        name != Name::None && 0 < self.filled && self.known == self.filled
    }
}

fn name(header: &str) -> Name {
    let name = words_of(header).join(" ");
    match name.as_str() {
        name if has(STRONG, name) => Name::Strong,
        name if has(WEAK, name) => Name::Weak,
        _ => Name::None,
    }
}

/// A column that may say what was measured, before its cells are looked at.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Free {
    /// Nothing else is known of it.
    Yes,
    /// Its name says that it names features, and another column does so as well.
    NamesToo,
    /// It is used otherwise.
    No,
}

impl Sample {
    /// The columns that say what was measured, of those that are free to; `names` is the column of the features' names.
    pub(super) fn quantities(
        &self,
        header: &StringRecord,
        names: Option<usize>,
        free: impl Fn(usize) -> Free,
    ) -> Vec<QuantityColumn> {
        let width = self.rows.iter().map(|(_, cells)| cells.len()).max().unwrap_or_default();
        let all = (0..width).filter_map(|at| {
            let free = free(at);
            if free == Free::No {
                return None;
            }
            let name = name(header.get(at).unwrap_or_default());
            let (column, seen) = self.look(header, at, name, names)?;
            let is_read = match name {
                _ if free == Free::NamesToo => seen.shapes == 0 && (seen.are_quantities() || seen.all_known(name)),
                // What is empty in the first rows may say it further down.
                Name::Strong | Name::Weak => true,
                Name::None => seen.shapes == 0 && seen.are_quantities(),
            };
            is_read.then_some(column)
        });
        all.collect()
    }

    /// The column that the user says has them.
    pub(super) fn quantity(&self, header: &StringRecord, at: usize, names: Option<usize>) -> Option<QuantityColumn> {
        self.look(header, at, Name::Strong, names).map(|(column, _)| column)
    }

    /// What a column would say; `None` where it holds numbers.
    fn look(
        &self,
        header: &StringRecord,
        at: usize,
        name: Name,
        names: Option<usize>,
    ) -> Option<(QuantityColumn, Seen<'_>)> {
        let with_codes = Seen::of(self.cells(at), true);
        if 0 < with_codes.numbers && with_codes.filled <= with_codes.numbers * 2 {
            return None;
        }
        // "A" and "B" are variants of a part, unless something else is said, too.
        let reads_codes = name != Name::Weak || with_codes.tells_codes();
        let seen = if reads_codes { with_codes } else { Seen::of(self.cells(at), false) };
        let takes_unknown = seen.known == 0
            && match name {
                // One word for all rows tells nothing apart.
                Name::Strong => seen.unknown.len() == 1,
                Name::Weak => !names.is_some_and(|names| self.tells_apart(at, names)),
                Name::None => false,
            };
        let is_taken = takes_unknown && !seen.unknown.is_empty();
        let words = || seen.unknown.iter().take(NAMED).map(|word| shorten(word)).collect::<Vec<_>>().join(", ");
        let column = QuantityColumn {
            at,
            takes_unknown,
            reads_codes,
            unknown: is_taken.then(|| (name_of(at, header.get(at).unwrap_or_default()), words())),
            sizes: seen.sizes.iter().map(|size| (*size).to_owned()).collect(),
        };
        Some((column, seen))
    }

    /// Whether rows of one name have different words in a column: then these say different things of one feature.
    fn tells_apart(&self, at: usize, names: usize) -> bool {
        let mut words: BTreeMap<&str, &str> = BTreeMap::new();
        let rows = self.rows.iter().skip(self.above).filter_map(|(_, cells)| Some((cells.get(names)?, cells.get(at)?)));
        rows.map(|(name, word)| (name.trim(), word.trim()))
            .filter(|(name, word)| !name.is_empty() && !word.is_empty())
            .any(|(name, word)| words.insert(name, word).is_some_and(|other| other != word))
    }
}
