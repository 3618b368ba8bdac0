//! The words that people use to name columns, in English, Dutch, German, Italian, French and
//! Spanish, and what each of them says.
//!
//! To add a name of a column: add it to its list, in small letters, with one blank for each sign. Names of labels, of a status and of an
//! origin are in `words`.

use std::collections::{HashMap, HashSet};
use std::sync::{LazyLock, OnceLock};

use super::role::Role;

/// How sure a name is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Rank {
    /// The whole name is known.
    Exact,
    /// A word of it is known.
    Contained,
    /// The name fits, but others do as well: `diameter` may be nominal or measured.
    Weak,
    /// The name may be that of a measured value and may say another one: `gemeten voor` is "measured before" or "measured at the
    /// front". It is never taken, and beside a measured value it is asked about.
    Unsure,
}

const ID: &str = "id|nr|no|number|nummer|num|numero|part|part no|part number|part id|teil|teilenummer|deel|onderdeel|\
    workpiece|werkstuk|werkstück|pezzo|stuk|name|naam|nome|bezeichnung|benaming|feature|feature id|feature name|feat name|merkmal|kenmerk|\
    caratteristica|characteristic|characteristics|characteristic name|element|elemento|bore|hole|bohrung|boring|gat|foro|shaft|as|welle|albero|label|serial|serial number|\
    seriennummer|serienummer|matricola|pos|item|code|codice|what|was|wat|\
    numéro|désignation|designation|repère|pièce|caractéristique|élément|alésage|arbre|code pièce|nombre|número|pieza|\
    característica|designación|agujero|eje|char no|char number|dimension no|print no|merkmalsname";
const TOLERANCE: &str = "callout|fit|tolerance|tol|toleranz|tolerantie|tolleranza|passing|passung|accoppiamento|\
    toleranzfeld|tolerantieveld|spec|specification|specificatie|spezifikation|specifica|size and class|\
    requirement|requirements|specifications|specs|anforderung|forderung|zeichnungsmaß|zeichnungsmass|eis|requisito|ajustement|tolérance|\
    spécification|exigence|ajuste|tolerancia|especificación|especificaciones";
const CLASS: &str = "class|klasse|classe|tolerance class|toleranzklasse|tolerantieklasse|classe di tolleranza|iso|\
    classe de tolérance|clase|clase de tolerancia";
const NOMINAL: &str = "nominal|nominal size|nominal diameter|nominal value|nom|nennmaß|nennmass|nenngröße|nennwert|\
    sollmaß|sollmass|sollwert|soll|nominaal|nominale maat|nominale diameter|nominale|quota nominale|valore nominale|\
    diametro nominale|dimensione nominale|basic size|target|\
    cote nominale|valeur nominale|dimension nominale|diamètre nominal|valor nominal|medida nominal|cota nominal|diámetro nominal";
const MEASURED: &str = "measured|meas|act|mis|measured value|measured size|measured diameter|measurement|actual|actual value|\
    actual size|actual diameter|reading|remeasured|re measured|remeasurement|recheck|re check|rechecked|nachgemessen|\
    nachmessung|hermeten|hermeting|rimisurato|rimisurata|istmaß|istmass|istwert|ist|messwert|messung|gemessen|gemessener wert|gemeten|\
    gemeten waarde|gemeten maat|meetwaarde|meting|werkelijk|werkelijke maat|werkelijke waarde|misurato|misurata|\
    valore misurato|diametro misurato|quota misurata|misurazione|effettivo|valore effettivo|dimensione effettiva|\
    mesuré|mesurée|mesure|valeur mesurée|cote mesurée|valeur réelle|cote réelle|diamètre mesuré|relevé|valeur relevée|\
    medido|medida real|valor medido|valor real|cota medida|cota real|diámetro medido|medición";
const WEAK: &str = "diameter|durchmesser|diametro|ø|dia|d|size|maat|maß|mass|grootte|value|wert|waarde|valore|misura|\
    dimension|dimensione|mm|\
    diamètre|valeur|cote|diámetro|valor|cota|medida";
const TIME: &str = "time|timestamp|time stamp|datetime|date time|time date|date and time|date|tijd|tijdstip|datum|datum tijd|\
    datum en tijd|zeit|uhrzeit|zeitstempel|zeitpunkt|data|ora|data ora|data e ora|measured at|measured on|\
    date et heure|date de mesure|heure|horodatage|fecha|fecha y hora|hora";

const SIMULATED: &str = "simulated|is simulated|gesimuleerd|simuliert|simulato|simulata";

/// Words that give a longer name another meaning: limits, deviations, whoever or whatever measured.
const OTHER: &str = "deviation|dev|afwijking|abweichung|scostamento|error|fout|fehler|errore|min|max|minimum|maximum|\
    minimaal|maximaal|minimo|massimo|lower|upper|onder|boven|unten|oben|inferiore|superiore|limit|limits|grens|grenze|\
    limite|by|door|von|at|on|op|am|gauge|tool|device|unit|eenheid|einheit|unità|height|hoogte|höhe|altezza|temp|\
    temperature|temperatuur|temperatur|temperatura|position|positie|posizione|x|y|z|status|result|resultaat|ergebnis|\
    risultato|count|anzahl|aantal|bar|plus|minus|um|form|rundheit|roundness|rondheid|type|typ|tipo|\
    maxi|mini|supérieur|supérieure|inférieur|inférieure|superior|inferior|écart|desviación|écarts|limites|límite|máximo|mínimo|par|por|unité|unidad|\
    résultat|résultats|resultado|estado|état|statut|quantité|cantidad|observation|observaciones|température|temperatura|appareil";

/// Words that say another measurement or another quantity than the diameter that was measured now: an earlier or an expected one,
/// that of a master or at the setting of a gauge, a radius. In a name for a part they say nothing.
const STRANGE: &str = "simulated|simulation|sim|previous|prev|prior|old|former|earlier|last|expected|predicted|estimated|\
    calculated|computed|assumed|planned|reference|ref|radius|radial|roughness|depth|angle|runout|concentricity|\
    cylindricity|flatness|straightness|parallelism|wear|correction|uncertainty|sigma|std|stdev|range|spread|scatter|\
    force|torque|pressure|humidity|\
    gesimuleerd|gesimuleerde|simulatie|vorig|vorige|eerder|eerdere|oud|oude|laatste|verwacht|verwachte|geschat|\
    geschatte|berekend|berekende|referentie|straal|ruwheid|diepte|hoek|slingering|cilindriciteit|vlakheid|rechtheid|\
    slijtage|correctie|onzekerheid|spreiding|\
    simuliert|simulierter|simulierte|simuliertes|vorherig|vorheriger|vorherige|vorheriges|voriger|voriges|früher|\
    früherer|frühere|früheres|alt|alter|alte|altes|letzter|letzte|letztes|erwartet|erwarteter|erwartete|erwartetes|\
    geschätzt|geschätzter|geschätzte|geschätztes|berechnet|berechneter|berechnete|berechnetes|referenz|halbmesser|\
    rauheit|rauigkeit|rauhigkeit|tiefe|winkel|rundlauf|zylindrizität|ebenheit|geradheit|parallelität|verschleiß|\
    verschleiss|korrektur|unsicherheit|streuung|spannweite|\
    simulato|simulata|precedente|vecchio|vecchia|ultimo|ultima|atteso|attesa|previsto|prevista|stimato|stimata|\
    calcolato|calcolata|riferimento|raggio|rugosità|rugosita|profondità|profondita|angolo|cilindricità|planarità|\
    usura|correzione|incertezza|dispersione|\
    before|pre|beforehand|vorher|vóór|vooraf|uncoated|prehone|prehoned|rough|rohteil|roh|vorgedreht|vorbearbeitet|vorbearbeitung|\
    unbeschichtet|voorbewerkt|onbehandeld|ruw|grezzo|grezza|sgrossato|sgrossata|\
    counterpart|mating|gegenstück|gegenstueck|gegenteil|tegenstuk|controparte|prüfring|pruefring|normal|vorgabe|\
    master|masters|setting|preset|calibration|calibrated|calibrating|cal|zero|zeroing|zeroed|gage|\
    einstellring|einstellmeister|einstellung|einstellmaß|einstellmass|einstellnormal|meister|meisterring|meisterteil|\
    lehrring|kalibrierung|kalibriert|kalibrierring|eichung|eichring|null|nullung|nullpunkt|nullmaß|nullmass|referenzring|\
    referenzteil|referenzmaß|referenzmass|\
    instelring|instelmaat|instelling|kalibratie|kalibreren|kalibreerring|ijking|ijkring|ijkmaat|nul|nulpunt|nulling|meester|\
    meesterring|referentiering|\
    azzeramento|azzerato|taratura|calibrazione|calibratura|calibro|impostazione|regolazione";

/// Words beside a measured value that say how it was found and leave it what it is.
const BESIDE: &str = "average|avg|mean|median|final|raw|corrected|in|gemiddeld|gemiddelde|mediaan|mittel|mittelwert|mittlerer|\
    mittlere|median|media|medio|mediana|of|the|a|an|de|het|een|van|der|die|das|des|von|il|la|lo|di|del|della|bei|bij|a|\
    with|mit|met|con|probe|taster|tastsystem|tastatore|cmm|kmg|machine|maschine|messmaschine|meetmachine|macchina|\
    point|points|punkt|punkte|punt|punten|punto|punti|two|three|four|inner|outer|inside|outside|innen|außen|aussen|\
    binnen|buiten|interno|esterno|round|zone|hand|val|eff|dim|1st|2nd|3rd|4th|vor|voor|prima|after|nach|na|dopo|ort|r";

/// Names of the upper limit deviation. The sign of `+TOL` and `Tol +` is looked at elsewhere.
pub(super) const UPPER_DEVIATION: &str = "upper tol|upper tolerance|upper deviation|upper dev|upper limit deviation|upper allowance|uppertol|tol upper|\
    tolerance upper|tol plus|plus tol|plus tolerance|tolerance plus|pos tol|positive tolerance|oberes abmaß|oberes abmass|\
    oberes grenzabmaß|oberes grenzabmass|obere toleranz|obere tol|ob tol|obere abweichung|toleranz oben|tol oben|bovenafwijking|bovenste afwijking|\
    boventolerantie|boventol|bovenste tolerantie|bovenste tol|tol boven|tolerantie boven|scostamento superiore|tolleranza superiore|toll superiore|toll sup|tol superiore|\
    écart supérieur|tolérance supérieure|tol supérieure|tolérance sup|tol sup|desviación superior|tolerancia superior|tol superior";

/// Names of the lower one.
pub(super) const LOWER_DEVIATION: &str = "lower tol|lower tolerance|lower deviation|lower dev|lower limit deviation|lower allowance|lowertol|tol lower|\
    tolerance lower|unteres abmaß|unteres abmass|unteres grenzabmaß|unteres grenzabmass|untere toleranz|untere tol|unt tol|untere abweichung|toleranz unten|\
    tol unten|onderafwijking|onderste afwijking|ondertolerantie|ondertol|onderste tolerantie|onderste tol|tol onder|tolerantie onder|scostamento inferiore|\
    tolleranza inferiore|toll inferiore|toll inf|tol inferiore|écart inférieur|tolérance inférieure|tol inférieure|tolérance inf|tol inf|desviación inferior|\
    tolerancia inferior|tol inferior";

/// Names of a lower one that may stand without its sign: the name has it.
pub(super) const MINUS: &str = "tol minus|minus tol|minus tolerance|tolerance minus|neg tol|negative tolerance";

/// Names of the largest permitted size.
pub(super) const MAXIMUM: &str = "usl|utl|upper limit|upper spec limit|upper specification limit|upper tolerance limit|max limit|max size|max dimension|\
    maximum size|maximum dimension|maximum limit|limit max|otg|ogw|größtmaß|größtmass|grösstmaß|grösstmass|groesstmass|höchstmaß|\
    höchstmass|hoechstmass|obergrenze|obere grenze|obere toleranzgrenze|obere spezifikationsgrenze|oberes grenzmaß|oberes grenzmass|\
    oberer grenzwert|bovengrens|bovenste grens|bovenmaat|grootste maat|maximale maat|limite superiore|quota massima|\
    dimensione massima|limite supérieure|cote maximale|cote maxi|cote max|dimension maximale|límite superior|limite superior|\
    cota máxima|cota maxima|medida máxima|dimensión máxima";

/// Names of the smallest one.
pub(super) const MINIMUM: &str = "lsl|ltl|lower limit|lower spec limit|lower specification limit|lower tolerance limit|min limit|min size|min dimension|\
    minimum size|minimum dimension|minimum limit|limit min|utg|ugw|kleinstmaß|kleinstmass|mindestmaß|mindestmass|untergrenze|\
    untere grenze|untere toleranzgrenze|untere spezifikationsgrenze|unteres grenzmaß|unteres grenzmass|unterer grenzwert|ondergrens|\
    onderste grens|ondermaat|kleinste maat|minimale maat|limite inferiore|quota minima|dimensione minima|limite inférieure|\
    cote minimale|cote mini|cote min|dimension minimale|límite inferior|limite inferior|cota mínima|cota minima|medida mínima|\
    dimensión mínima";

/// Names of either an upper limit or an upper deviation: the numbers tell.
pub(super) const UPPER: &str = "upper|boven|superiore|supérieur|superior";

/// The same of the lower one.
pub(super) const LOWER: &str = "lower|onder|inferiore|inférieur|inferior";

/// Names of the largest permitted size, or of the largest of several readings: beside a callout they are compared alone.
pub(super) const LARGEST: &str = "max|maximum|massimo|maxi|máximo";

/// The same of the smallest one.
pub(super) const SMALLEST: &str = "min|minimum|minimo|mini|mínimo";

/// Words that make a sign one of a deviation: `+TOL`, `Abw. -`.
pub(super) static SIGNED: Names = Names::of(
    "tol|toll|tols|tolerance|toleranz|tolerantie|tolleranza|tolérance|tolerancia|dev|abmaß|abmass|afwijking|scostamento|écart",
);

/// A list of names between bars, taken apart when it is first asked: a file has many names, and most lists are asked for each.
pub(in crate::exchange) struct Names {
    list: &'static str,
    all: OnceLock<HashSet<&'static str>>,
}

impl Names {
    pub(in crate::exchange) const fn of(list: &'static str) -> Self {
        Self { list, all: OnceLock::new() }
    }

    pub(in crate::exchange) fn has(&self, name: &str) -> bool {
        self.all.get_or_init(|| self.list.split('|').collect()).contains(name)
    }
}

/// Lists of names to be asked by a name; where two have it, the first counts.
pub(super) fn by_word<T: Copy>(lists: impl IntoIterator<Item = (&'static str, T)>) -> HashMap<&'static str, T> {
    let mut found = HashMap::new();
    for (list, means) in lists {
        for name in list.split('|') {
            found.entry(name).or_insert(means);
        }
    }
    found
}

/// The lists above, to be asked by a word.
pub(super) struct Known {
    /// What a whole name says.
    pub(super) whole: HashMap<&'static str, (Role, Rank)>,
    /// What a word within a longer name says; the first of these roles counts.
    pub(super) within: HashMap<&'static str, usize>,
    pub(super) other: HashSet<&'static str>,
    pub(super) strange: HashSet<&'static str>,
    /// Every word of any list: none of them is a unit.
    words: HashSet<&'static str>,
}

/// The roles that one word within a longer name is enough for, the most telling first.
pub(super) const WITHIN: [(Role, &str); 3] =
    [(Role::Nominal, NOMINAL), (Role::Measured, MEASURED), (Role::Tolerance, TOLERANCE)];

pub(super) static KNOWN: LazyLock<Known> = LazyLock::new(|| {
    let exact = [
        (Role::Measured, MEASURED),
        (Role::Nominal, NOMINAL),
        (Role::Tolerance, TOLERANCE),
        (Role::Time, TIME),
        (Role::Simulated, SIMULATED),
        (Role::Id, ID),
    ];
    let exact = exact.map(|(role, list)| (list, (role, Rank::Exact)));
    let unsure = [(CLASS, (Role::Tolerance, Rank::Contained)), (WEAK, (Role::Measured, Rank::Weak))];
    let whole = by_word(exact.into_iter().chain(unsure));
    let within = by_word(WITHIN.iter().map(|(_, list)| *list).zip(0..));
    let names = whole.keys().flat_map(|name| name.split(' '));
    let words = names.chain([OTHER, STRANGE, BESIDE].into_iter().flat_map(|list| list.split('|'))).collect();
    Known { words, whole, within, other: OTHER.split('|').collect(), strange: STRANGE.split('|').collect() }
});

/// Whether a word, in small letters, says something else than a unit.
pub(super) fn is_word(word: &str) -> bool {
    KNOWN.words.contains(word)
}
