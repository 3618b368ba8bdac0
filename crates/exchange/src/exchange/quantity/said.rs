//! What words, letters and signs say of what was measured: those of a cell, of the name of a column, of the name of a feature.

use fitcheck_core::probing::cycle::Axis;

use super::Quantity;
use crate::exchange::units::words_of;
use crate::exchange::vocabulary::Names;

/// Names of columns that say what was measured.
static STRONG: Names = Names::of(
    "axis|axes|achse|messachse|assi|asse|quantity|measured quantity|measurand|messgröße|messgrösse|messgroesse|\
    meetgrootheid|grootheid|grandezza|grandezza misurata|characteristic type|char type|type of characteristic|merkmalsart|\
    merkmalstyp|merkmalart|art des merkmals|kenmerktype|kenmerksoort|soort kenmerk|type kenmerk|tipo caratteristica|\
    tipo di caratteristica|measurement type|measure type|type of measurement|messart|meettype|soort meting|tipo misura|\
    tipo di misura|dimension type|dim type|maßart|massart|maatsoort|tipo dimensione|tipo di quota|feature axis",
);

/// Names of columns that may say so.
static WEAK: Names = Names::of(
    "type|typ|tipo|soort|art|kind|as|dim|dimension|dimensione|feature type|element type|elementtyp|elementtype|\
    tipo elemento|tipo di elemento|tolerance type|toleranztyp|toleranzart|tolerantietype|tipo tolleranza|tipo di tolleranza|\
    property|eigenschaft|eigenschap|proprietà|hole shaft|hole or shaft|bohrung welle|boring as|gat as|foro albero|alésage arbre|\
    agujero eje|genre|nature|clase de medida",
);

/// Words of a diameter; German, Dutch and Italian ones may end a longer word.
static DIAMETERS: Names = Names::of(
    "diameter|durchmesser|diametro|diamètre|diámetro|diam|dia|ø|innendurchmesser|außendurchmesser|aussendurchmesser|binnendiameter|\
    buitendiameter|bohrungsdurchmesser|lochdurchmesser|wellendurchmesser",
);

/// Words of a distance between two walls, or from a datum.
static WIDTHS: Names = Names::of(
    "width|breite|breedte|larghezza|distance|abstand|distanz|afstand|distanza|length|länge|laenge|lengte|\
    lunghezza|thickness|dicke|dikte|spessore|slot|nut|sleuf|groef|cava|largeur|longueur|épaisseur|rainure|ancho|anchura|longitud|distancia|espesor|ranura",
);

/// Words of a size.
static SIZES: Names =
    Names::of("size|maß|mass|maat|misura|dimension|dimensione|quota|measure|cote|dimensión|medida|cota");

/// Words of what has a diameter; beside the name of a feature they say nothing new.
static ROUND: Names = Names::of(
    "bore|hole|bohrung|boring|gat|foro|shaft|welle|albero|circle|kreis|cirkel|cerchio|cylinder|zylinder|cilinder|\
    cilindro|pin|stift|pen|perno|zapfen|tap|alésage|trou|arbre|cercle|cylindre|agujero|taladro|eje|círculo|goupille|pasador",
);

/// Those of them that are holes; the others are shafts, but for circles and cylinders.
static HOLES: Names = Names::of("bore|hole|bohrung|boring|gat|foro|alésage|trou|agujero|taladro");
static SHAFTS: Names = Names::of("shaft|welle|albero|pin|stift|pen|perno|zapfen|tap|arbre|goupille|eje|pasador");

/// Words that change none of these.
static NEUTRAL: Names = Names::of(
    "inner|outer|inside|outside|innen|außen|aussen|binnen|buiten|interno|esterno|of|a|the|des|der|di|van|nominal|\
    linear|lineare|lineair|min|max|gauss|lsc|mic|mcc|mzc|ls|mi|mc|two|2pt|int|ext|est",
);

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
    kraft|torque|planéité|circularité|rectitude|cylindricité|perpendicularité|parallélisme|coaxialité|rayon|profondeur|hauteur|rugosité|\
    battement|filetage|planitud|redondez|circularidad|rectitud|cilindricidad|perpendicularidad|paralelismo|coaxialidad|concentricidad|\
    profundidad|altura|rugosidad|alabeo|rosca|ángulo|posición";

/// Words that are another quantity where nothing else is said: a diameter may be one of two points.
static POINTS: Names = Names::of("point|points|punkt|punkte|punt|punten|punto|punti");

/// Letters of other quantities, as measuring software writes them.
static CODES: Names = Names::of("r|rad|tp|pos|pr|pa|a|ang|h|t|v|rn|tx|ty|tz|px|py|pz|dx|dy|dz|ppos|ptp|gdt|ra|rz");

/// The same of diameters and of distances.
static DIAMETER_CODES: Names = Names::of("d|df|dm|id|od|di|da");
static WIDTH_CODES: Names = Names::of("m|l|w|lg|wd");

/// Signs of tolerances of form and place in drawings.
const SIGNS: &str = "⏤⏥○⌭⌒⌓⟂∥∠⌖◎⌯↗⌰";

/// The longest word that is the code of a quantity.
const LONGEST_CODE: usize = 4;

/// What a cell says, and how plainly.
#[derive(Clone, PartialEq, Eq)]
pub(super) struct Said {
    pub(super) quantity: Quantity,
    /// Whether nothing else stands in the cell, and the words are no shorthand.
    pub(super) is_plain: bool,
    /// Whether it is said by a shape, such as "bore".
    pub(super) is_shape: bool,
    /// Whether it is said by a letter or two.
    pub(super) is_code: bool,
}

fn is_other(word: &str) -> bool {
    // "lineal" is not "line": short words are whole.
    let begins = |known: &str| word == known || 4 < known.chars().count() && word.starts_with(known);
    let is_neutral = NEUTRAL.has(word);
    !is_neutral && OTHERS.split('|').any(begins)
        || ["abweichung", "toleranz", "toleranza", "tolleranza"].iter().any(|end| word.ends_with(end))
}

fn is_diameter(word: &str) -> bool {
    DIAMETERS.has(word) || ["durchmesser", "diameter"].iter().any(|end| word.ends_with(end))
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
pub(super) fn said(cell: &str) -> Option<Said> {
    let of = |quantity, is_plain| Some(Said { quantity, is_plain, is_shape: false, is_code: false });
    let cell = cell.trim();
    if cell.contains(|c| SIGNS.contains(c)) {
        return of(Quantity::Length, true);
    }
    // Most cells are numbers.
    if !cell.contains(char::is_alphabetic) {
        return None;
    }
    let words = words_of(cell);
    let other = || if is_no_length(cell) { Quantity::Other } else { Quantity::Length };
    if let [word] = words.as_slice()
        && word.chars().count() <= LONGEST_CODE
    {
        let code = match word.as_str() {
            code if CODES.has(code) => Some(other()),
            code if DIAMETER_CODES.has(code) => Some(Quantity::Diameter),
            code if WIDTH_CODES.has(code) => Some(Quantity::Width),
            code => axis(code).map(Quantity::Coordinate),
        };
        if let Some(quantity) = code {
            return Some(Said { quantity, is_plain: false, is_shape: false, is_code: true });
        }
    }
    let is_known = |word: &String| {
        is_other(word)
            || is_diameter(word)
            || WIDTHS.has(word)
            || SIZES.has(word)
            || NEUTRAL.has(word)
            || POINTS.has(word)
    };
    let is_plain = words.iter().all(is_known);
    let any = |is: &dyn Fn(&str) -> bool| words.iter().any(|word| is(word));
    if any(&is_other) {
        return of(other(), is_plain);
    }
    if any(&is_diameter) {
        return of(Quantity::Diameter, is_plain);
    }
    if any(&|word| WIDTHS.has(word)) {
        return of(Quantity::Width, is_plain);
    }
    if any(&|word| SIZES.has(word)) {
        return of(Quantity::Size, is_plain);
    }
    if any(&|word| POINTS.has(word)) {
        return of(Quantity::Other, is_plain);
    }
    any(&|word| ROUND.has(word)).then_some(Said {
        quantity: Quantity::Size,
        is_plain: false,
        is_shape: true,
        is_code: false,
    })
}

/// Whether a text says that it is of a hole, or else of a shaft; `None` where it says neither, or both.
pub(in crate::exchange) fn is_shape(text: &str) -> Option<bool> {
    if !text.contains(char::is_alphabetic) {
        return None;
    }
    let words = words_of(text);
    let any = |list: &Names| words.iter().any(|word| list.has(word));
    match (any(&HOLES), any(&SHAFTS)) {
        (true, false) => Some(true),
        (false, true) => Some(false),
        _ => None,
    }
}

/// Beginnings of words of form, of roughness and of radii: in the name of a feature they hardly say anything else.
const FORMS: [&str; 36] = [
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
    "planéité",
    "circularité",
    "rugosité",
    "planitud",
    "redondez",
    "rugosidad",
];

/// Whether the name of a feature says that its form was measured, or its radius.
pub(in crate::exchange) fn is_form(name: &str) -> bool {
    words_of(name).iter().any(|word| FORMS.iter().any(|form| word.starts_with(form)))
}

/// Beginnings of words of what is no length.
const NO_LENGTHS: &str = "angle|angular|winkel|hoek|angol|ángulo|hardness|härte|hardheid|durezz|temperat|area|weight|gewicht|peso|force|kraft|\
    torque|kąt|úhel|úhly|rough|rauheit|rauhigkeit|rauigkeit|ruwheid|rugos|chropowat|drsnost";

/// Codes of angles and of roughness.
static NO_LENGTH_CODES: Names = Names::of("a|ang|pa|ra|rz|rt|rq");

/// Whether a text says that an angle was measured, or a roughness, or something else that no length of the part is.
pub(in crate::exchange) fn is_no_length(text: &str) -> bool {
    let words = words_of(text);
    let begins = |word: &String| NO_LENGTHS.split('|').any(|known| word.starts_with(known));
    // Angularity is a zone between two planes.
    let is_zone = |word: &String| word.starts_with("angularit") || word.starts_with("angolarit");
    match words.as_slice() {
        [word] if NO_LENGTH_CODES.has(word) => true,
        words => words.iter().any(|word| begins(word) && !is_zone(word)),
    }
}

/// Beginnings of words of tolerances of place, besides those of form.
const PLACES: &str = "angularit|position|posizion|positie|posición|lage|symmetr|simmetri|coaxial|coassial|profil|gesamtlauf|oscillaz|battement";

/// Whether a text names a tolerance of form or place: nothing is rounder than round, so its nominal value is zero.
pub(in crate::exchange) fn is_of_ideal_form(text: &str) -> bool {
    let is_radius = |word: &str| word.starts_with("radi") || word.starts_with("raggi");
    words_of(text).iter().any(|word| {
        let is_form = FORMS.iter().any(|form| word.starts_with(form)) && !is_radius(word);
        is_form || PLACES.split('|').any(|place| word.starts_with(place))
    })
}

/// What the words of a text say that was measured; letters alone say nothing.
pub(in crate::exchange) fn of_text(text: &str) -> Option<Quantity> {
    said(text).filter(|said| !said.is_code).map(|said| said.quantity)
}

/// Whether the name of a column says that it may tell what was measured.
pub(in crate::exchange) fn may_be_named(header: &str) -> bool {
    name(header) != Name::None
}

/// How surely the name of a column says that its cells are quantities.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Name {
    Strong,
    Weak,
    None,
}

pub(super) fn name(header: &str) -> Name {
    let name = words_of(header).join(" ");
    match name.as_str() {
        name if STRONG.has(name) => Name::Strong,
        name if WEAK.has(name) => Name::Weak,
        _ => Name::None,
    }
}
