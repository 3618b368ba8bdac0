//! What a word says of a temperature: English, Dutch, German and Italian, in small letters.

use crate::exchange::vocabulary::Names;

/// How the names of temperatures end.
const NAMES: [&str; 12] = [
    "temp",
    "tempc",
    "tempf",
    "warm",
    "heiß",
    "temps",
    "temperature",
    "temperatures",
    "temperatur",
    "temperaturen",
    "temperatuur",
    "temperatura",
];

/// Parts of words of what is warm beside the part, and of what is done to it at another time.
const OTHER: &str = "spindle|spindel|mandrin|cool|kühl|kuehl|koel|refriger|emulsi|scale|maßst|massst|schaal|harden|härt|haert|tempering|\
    anneal|wash|wasch|gewass|lavat|lavag|clean|reinig|pulit|trockn|droog|droge|asciug|anodis|anodiz|eloxier|coated|coating|beschicht|\
    storage|stored|lagertemp|lagerung|gelagert|opslag|opgeslagen|magazz|limit|grenztemp|alarm|allowed|zuläss|zulaess|toegestaan|ammess|\
    calib|kalib|taratur|furnace|werkzeug|gereedschap|utensil|außentemp|aussentemp|buitentemp|outdoor|esterna|weather|wetter|schaltschrank";

/// How other such words begin: within others they say something else, as in "bovenste".
const OTHER_BEGINS: &str = "oil|öl|olie|olio|kss|dry|dried|tool|spil|oven|ofen|forno";

/// Parts of words of the part itself, or of its measuring.
const PART: &str = "part|teil|deel|workpiece|werkst|pezz|component|measur|gemess|gemeten|misur|mess|meet|meting|probed|still|noch|nog|ancora|warm|heiß|heet|caldo";

/// Whole words behind which a step is over: what is warm then is the part.
const TIMES: [&str; 8] = ["after", "nach", "na", "dopo", "before", "vor", "voor", "prima"];

/// Parts of words of the place around the part: they count where nothing is said of the part.
const PLACE: &str = "air|luft|lucht|aria|ambient|umgebung|omgeving|room|raum|ruimte|stanza|hall|halle|climate|klima|klimaat|shop|werkstatt";

/// Parts of words of a temperature that limits or norms are meant for, and not one that was measured.
const REFERENCE: &str = "referen|bezug|riferim|toler|nominal|soll|drawing|zeichnung|tekening|disegno|norm";

/// Parts of words of how sure a temperature is, or how it changed.
const NO_TEMPERATURE: &str = "uncert|unsicher|onzeker|incert|drift|gradient|spread|accura|genauig|error|fehler";

/// Parts of words of an angle.
const ANGLE: &str = "rotat|clockwise|dreh|drehen|gedreht|winkel|angle|angol|hoek|schwenk|tilt|geneigt|chamfer|fase|phase|cone|kegel|conus|\
    conic|axis|achse|taper|orient|index";

/// Parts of words of a correction that is done.
const CORRECTED: &str = "corrected|compensated|korrigiert|kompensiert|gecorrigeerd|gecompenseerd|corretto|corretta|corretti|compensato|compensata|\
    umgerechnet|omgerekend|converted|normalised|normalized";

/// Parts of words of a correction; whether it is done another word says.
const CORRECTION: &str =
    "correction|compensation|korrektur|kompensation|correctie|compensatie|correzion|compensazion|tempcomp|tempkomp";

/// Words of a correction that is done.
const DONE: [&str; 16] = [
    "on", "yes", "y", "active", "done", "with", "ein", "ja", "aktiv", "mit", "aan", "actief", "met", "sì", "attiva",
    "con",
];

/// Words with which a correction is not done.
static NOT: Names = Names::of(
    "not|no|non|off|none|without|never|un|inactive|disabled|nicht|kein|keine|keiner|aus|ohne|nie|inaktiv|deaktiviert|niet|geen|\
    uit|zonder|nooit|inactief|senza|mai|disattiva|disattivata|be|must|should|needs|need|needed|required|todo|yet|muss|noch|soll|bitte|\
    erforderlich|moet|nog|deve|deb|da|ancora|false|falsch|onwaar|falso|if|wenn|falls|als|se",
);

/// Words that say nothing of their own.
static FILLERS: Names = Names::of(
    "at|a|an|the|to|of|is|are|was|were|all|by|from|for|in|as|and|value|values|size|sizes|dimension|dimensions|\
    diameter|result|results|bei|bij|auf|op|der|die|das|des|dem|den|von|van|het|de|een|ist|sind|wurde|wurden|war|alle|werte|wert|maße|\
    masse|maß|durchmesser|ergebnisse|zu|waarden|maten|zijn|werd|werden|naar|tot|il|la|i|le|del|della|di|tutti|valori|misure|sono|era|ca|\
    circa|approx|about|ungefähr|ungefaehr|etwa|ongeveer|ing|actual|ist|mean|average|mittel|mittlere|gemiddelde|media|und|en|e|during|\
    während|tijdens|durante|with|mit|met|con|c|f|k|celsius|fahrenheit|kelvin|degrees|grad|graden|gradi|deg|t|start|end|beginn|ende|begin|\
    einde|inizio|fine",
);

/// Whether a word has a part that stands in a list.
fn has_part(list: &str, word: &str) -> bool {
    list.split('|').any(|part| word.contains(part))
}

pub(super) fn names_temperature(word: &str) -> bool {
    NAMES.iter().any(|end| word.ends_with(end))
}

/// Whose temperature a word says.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::exchange) enum Whose {
    Part,
    Place,
    Reference,
    Other,
}

pub(super) fn whose(word: &str) -> Option<Whose> {
    if has_part(OTHER, word) || OTHER_BEGINS.split('|').any(|begin| word.starts_with(begin)) {
        Some(Whose::Other)
    } else if has_part(PART, word) {
        Some(Whose::Part)
    } else if has_part(PLACE, word) {
        Some(Whose::Place)
    } else if word == "tol" || has_part(REFERENCE, word) {
        Some(Whose::Reference)
    } else {
        None
    }
}

pub(super) fn is_time(word: &str) -> bool {
    TIMES.contains(&word)
}

pub(super) fn is_article(word: &str) -> bool {
    ["the", "der", "die", "das", "dem", "den", "de", "het", "il", "la", "i", "le"].contains(&word)
}

/// Whether a temperature with such a word in its name is none.
pub(super) fn is_no_temperature(word: &str) -> bool {
    word == "u" || has_part(NO_TEMPERATURE, word)
}

pub(super) fn is_of_angle(word: &str) -> bool {
    has_part(ANGLE, word) || word == "cw" || word == "ccw" || word == "rot"
}

/// A correction, and whether the word alone says that it is done.
pub(super) fn correction(word: &str) -> Option<bool> {
    let has = |list: &str| has_part(list, word);
    (has(CORRECTED) || has(CORRECTION) || ["comp", "komp", "corr", "korr"].contains(&word)).then(|| has(CORRECTED))
}

pub(super) fn says_done(word: &str) -> bool {
    DONE.contains(&word)
}

/// Whether a word says that a correction is not done, also as a part of it: `unkompensiert`, `ongecorrigeerd`.
pub(super) fn says_not(word: &str) -> bool {
    let begins = ["un", "on", "non"]
        .iter()
        .any(|begin| word.strip_prefix(begin).is_some_and(|rest| correction(rest) == Some(true)));
    NOT.has(word) || begins
}

pub(super) fn is_filler(word: &str) -> bool {
    FILLERS.has(word)
}
