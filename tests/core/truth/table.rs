//! Random tables as people and programs write them, each with the truth about every row: computed here in whole nanometres from the
//! published table of limits, in no way from the code under test.

use std::fmt::Write as _;
use std::sync::LazyLock;

use fitcheck::verdict::Status;

use crate::fuzzing::Random;

/// Classes and sizes with their limits in nanometres: `limits_47_classes.csv`.
struct Zone {
    class: String,
    over: i64,
    to: i64,
    upper: i64,
    lower: i64,
}

const MILLIMETRE: i64 = 1_000_000;

static ZONES: LazyLock<Vec<Zone>> = LazyLock::new(|| {
    let text = include_str!("../../data/iso286/limits_47_classes.csv");
    let zone = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        let whole = |at: usize| cells[at].parse::<i64>().unwrap();
        let micrometres = |at: usize| {
            let (micrometres, behind) = cells[at].split_once('.').unwrap_or((cells[at], ""));
            format!("{micrometres}{behind:0<3}").parse::<i64>().unwrap()
        };
        Zone {
            class: cells[0].to_owned(),
            over: whole(1) * MILLIMETRE,
            to: whole(2) * MILLIMETRE,
            upper: micrometres(3),
            lower: micrometres(4),
        }
    };
    text.lines().skip(1).map(zone).collect()
});

/// The languages of headers: English, German, Dutch, Italian.
struct Words {
    name: &'static str,
    callout: &'static str,
    nominal: &'static str,
    class: &'static str,
    measured: &'static str,
    remark: &'static str,
    status: &'static str,
    simulated: &'static str,
    unit: &'static str,
    kinds: [&'static str; 2],
    origin: &'static str,
    origins: [&'static str; 2],
    machine: &'static str,
    preamble: [&'static str; 3],
    serial: &'static str,
    second: [&'static str; 2],
    title: &'static str,
}

const WORDS: [Words; 4] = [
    Words {
        name: "Feature",
        callout: "Callout",
        nominal: "Nominal",
        class: "Class",
        measured: "Measured",
        remark: "Remark",
        status: "Status",
        simulated: "simulated",
        unit: "Unit",
        kinds: ["Type", "Axis"],
        origin: "Origin",
        origins: ["measured", "simulated"],
        machine: "Machine",
        preamble: ["Program", "Part name", "Date"],
        serial: "Serial number",
        second: ["Measured after honing", "Final measured value"],
        title: "All values in",
    },
    Words {
        name: "Merkmal",
        callout: "Passung",
        nominal: "Nennmaß",
        class: "Toleranzklasse",
        measured: "Istmaß",
        remark: "Bemerkung",
        status: "Ergebnis",
        simulated: "simuliert",
        unit: "Einheit",
        kinds: ["Typ", "Achse"],
        origin: "Herkunft",
        origins: ["gemessen", "simuliert"],
        machine: "Maschine",
        preamble: ["Programm", "Teilename", "Datum"],
        serial: "Seriennummer",
        second: ["Istmaß nach Honen", "Messwert 2"],
        title: "Alle Werte in",
    },
    Words {
        name: "Kenmerk",
        callout: "Passing",
        nominal: "Nominale maat",
        class: "Tolerantieklasse",
        measured: "Gemeten",
        remark: "Opmerking",
        status: "Resultaat",
        simulated: "gesimuleerd",
        unit: "Eenheid",
        kinds: ["Type", "As"],
        origin: "Herkomst",
        origins: ["gemeten", "gesimuleerd"],
        machine: "Machine",
        preamble: ["Programma", "Naam van het deel", "Datum"],
        serial: "Serienummer",
        second: ["Gemeten na honen", "Meetwaarde 2"],
        title: "Alle waarden in",
    },
    Words {
        name: "Caratteristica",
        callout: "Accoppiamento",
        nominal: "Quota nominale",
        class: "Classe di tolleranza",
        measured: "Misurato",
        remark: "Nota",
        status: "Risultato",
        simulated: "simulato",
        unit: "Unità",
        kinds: ["Tipo", "Asse"],
        origin: "Origine",
        origins: ["misurato", "simulato"],
        machine: "Macchina",
        preamble: ["Programma", "Nome del pezzo", "Data"],
        serial: "Matricola",
        second: ["Misurato dopo levigatura", "Valore misurato 2"],
        title: "Tutti i valori in",
    },
];

/// A unit of length, in nanometres, with its spellings. Sizes in inches are multiples of a hundred-thousandth.
#[derive(Clone, Copy)]
struct Unit {
    nanometres: i64,
    /// The smallest step that is printed, in nanometres, and its decimals.
    step: i64,
    decimals: usize,
    spellings: &'static [&'static str],
    /// Whether Fitcheck reads it; others are refused.
    is_read: bool,
}

const UNITS: [Unit; 4] = [
    Unit {
        nanometres: MILLIMETRE,
        step: 100,
        decimals: 4,
        spellings: &["mm", "MM", "Millimeter", "millimetre"],
        is_read: true,
    },
    Unit { nanometres: 1000, step: 100, decimals: 1, spellings: &["µm", "um", "micron", "μm"], is_read: true },
    Unit { nanometres: 25_400_000, step: 254, decimals: 5, spellings: &["inch", "in", "Zoll", "INCH"], is_read: true },
    Unit { nanometres: 10 * MILLIMETRE, step: 1000, decimals: 4, spellings: &["cm", "centimetre"], is_read: false },
];

/// Where a table says its unit.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Stated {
    Nowhere,
    Brackets,
    Column,
    Comment,
    Title,
    RowBelow,
    Cell,
}

/// What stands in a table that must not be passed over.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Trap {
    /// Nothing: every row is read.
    None,
    /// A second column that may be the value.
    SecondValue,
    /// Rows of another quantity than the size.
    Quantity,
    /// Deviations in micrometres behind a size in millimetres.
    Micrometres,
    /// A nominal size beside a callout of another one.
    OtherNominal,
    /// A remark that runs over lines that look like rows.
    QuotedRows,
    /// A column that says that values were simulated.
    Simulated,
    /// A column that says where values come from.
    Origin,
    /// A column with the file's own status.
    Status,
    /// Values that are no numbers, or without any.
    NoNumber,
}

impl Trap {
    const ALL: [Self; 10] = [
        Self::None,
        Self::SecondValue,
        Self::Quantity,
        Self::Micrometres,
        Self::OtherNominal,
        Self::QuotedRows,
        Self::Simulated,
        Self::Origin,
        Self::Status,
        Self::NoNumber,
    ];
}

/// The truth about a row.
#[derive(Debug, Clone)]
pub struct Truth {
    /// Its name, which no other row has.
    pub name: String,
    /// What it should be, in millimetres.
    pub callout: String,
    /// What a verdict may be; `None` where none may be given.
    pub status: Option<Status>,
    /// Whether nobody measured.
    pub is_simulated: bool,
    /// Whether the file's own status is another one.
    pub is_contradicted: bool,
}

/// A table and the truth about it.
#[derive(Debug)]
pub struct Table {
    /// Its text; `bytes` may have it in another encoding.
    pub text: String,
    pub bytes: Vec<u8>,
    pub separator: u8,
    pub rows: Vec<Truth>,
    pub trap: Trap,
    /// Whether every row can be read: then none may be refused.
    pub is_plain: bool,
    /// How it was made, for the message of a failure.
    pub made: String,
    stated: Stated,
}

/// A length in a unit, exact.
fn printed(nanometres: i64, unit: Unit, sign: char) -> String {
    let scale = 10_i64.pow(u32::try_from(unit.decimals).unwrap());
    // A multiple of the unit's step has no more decimals.
    let (scaled, rest) = (nanometres * scale / unit.nanometres, nanometres * scale % unit.nanometres);
    assert_eq!(rest, 0, "{nanometres} nm has more decimals");
    let minus = if scaled < 0 { "-" } else { "" };
    let (whole, part) = (scaled.abs() / scale, scaled.abs() % scale);
    let part = format!("{part:0width$}", width = unit.decimals);
    format!("{minus}{whole}{sign}{part}")
}

/// Good, rework or scrap, by the limits alone.
fn judged(class: &str, (minimum, maximum): (i64, i64), measured: i64) -> Status {
    let is_hole = class.starts_with(char::is_uppercase);
    match (measured < minimum, maximum < measured) {
        (false, false) => Status::Good,
        (true, _) => {
            if is_hole {
                Status::Rework
            } else {
                Status::Scrap
            }
        }
        (_, true) => {
            if is_hole {
                Status::Scrap
            } else {
                Status::Rework
            }
        }
    }
}

fn pick<'a, T>(random: &mut Random, of: &'a [T]) -> &'a T {
    &of[random.below(of.len())]
}

/// A row before it is written.
struct TruthRow {
    nominal: i64,
    class: String,
    measured: i64,
    status: Status,
}

/// A row whose value lies in the zone, on its border or beside it, in whole steps of the unit.
fn row(random: &mut Random, unit: Unit) -> TruthRow {
    loop {
        let nominal = if unit.nanometres == 25_400_000 {
            25_400_000 * i64::try_from(1 + random.below(18)).unwrap()
        } else {
            MILLIMETRE * *pick(random, &[3, 6, 8, 10, 12, 16, 20, 25, 30, 40, 50, 63, 80, 100, 125, 180, 250, 315, 400])
        };
        let zones: Vec<&Zone> = ZONES.iter().filter(|zone| zone.over < nominal && nominal <= zone.to).collect();
        if zones.is_empty() {
            continue;
        }
        let zone = *pick(random, &zones);
        let limits = (nominal + zone.lower, nominal + zone.upper);
        let width = zone.upper - zone.lower;
        let from = match random.below(4) {
            0 => limits.0 + i64::try_from(random.below(usize::try_from(width + 1).unwrap())).unwrap(),
            1 => *pick(random, &[limits.0, limits.1]),
            2 => limits.0 - 1 - i64::try_from(random.below(60_000)).unwrap(),
            _ => limits.1 + 1 + i64::try_from(random.below(60_000)).unwrap(),
        };
        let measured = from - from.rem_euclid(unit.step);
        let status = judged(&zone.class, limits, measured);
        return TruthRow { nominal, class: zone.class.clone(), measured, status };
    }
}

/// What other quantities are called, and what the size is.
const OTHERS: [&str; 7] = ["Position", "Radius", "Depth", "Flatness", "Roundness", "X", "TP"];
const SIZES: [&str; 3] = ["Diameter", "DIA", "D"];

impl Table {
    /// What is special about it.
    pub fn kind(&self) -> String {
        format!("{:?} {:?}", self.trap, self.stated)
    }

    /// A table of some rows, whose names begin with its own.
    #[expect(clippy::too_many_lines, reason = "a table is made as it is written, from its first line to its last one")]
    pub fn random(random: &mut Random, own: &str, rows: usize) -> Self {
        let words = pick(random, &WORDS);
        let separator = *pick(random, &[';', ',', '\t', '|']);
        let sign = if separator == ',' { '.' } else { *pick(random, &['.', ',']) };
        let line_end = *pick(random, &["\n", "\r\n"]);
        // Most tables state no unit and hide nothing.
        let mut trap = if random.below(3) == 0 { *pick(random, &Trap::ALL) } else { Trap::None };
        let stated = match random.below(12) {
            0 => Stated::Brackets,
            1 => Stated::Column,
            2 => Stated::Comment,
            3 => Stated::Title,
            4 => Stated::RowBelow,
            5 => Stated::Cell,
            _ => Stated::Nowhere,
        };
        let unit = if stated == Stated::Nowhere { UNITS[0] } else { *pick(random, &UNITS) };
        if stated != Stated::Nowhere && random.below(4) != 0 {
            trap = Trap::None;
        }
        // Sizes and classes in columns of their own, or as one callout in millimetres.
        let is_split = random.below(2) == 0 && trap != Trap::Micrometres || unit.nanometres == 25_400_000;
        let spelling = *pick(random, unit.spellings);
        let mut text = String::new();
        let cell = |text: &str| {
            let quoted = text.contains([separator, '"', '\n']);
            if quoted { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.to_owned() }
        };
        let put = |text: &mut String, cells: &[String]| {
            let cells: Vec<String> = cells.iter().map(|text| cell(text)).collect();
            text.push_str(&cells.join(&separator.to_string()));
            text.push_str(line_end);
        };
        if random.below(8) == 0 {
            let (lines, facts) = (1 + random.below(6), ["PLATE_OP20", "4711", "2026-07-10"]);
            for (word, fact) in words.preamble.iter().zip(facts).cycle().take(lines) {
                let _always = write!(text, "{word}{separator}{fact}{line_end}");
            }
            text.push_str(if random.below(2) == 0 { line_end } else { "" });
        }
        if stated == Stated::Comment {
            let comment = *pick(random, &["# unit: ", "# Einheit: ", "# units = "]);
            let _always = write!(text, "{comment}{spelling}{line_end}");
        }
        if stated == Stated::Title {
            let title = if random.below(2) == 0 {
                format!("{} {spelling}", words.title)
            } else {
                format!("{}:{separator}{spelling}", words.unit)
            };
            let _always = write!(text, "{title}{line_end}");
        }
        let bracket = |name: &str| {
            if stated == Stated::Brackets { format!("{name} [{spelling}]") } else { name.to_owned() }
        };
        let mut header = vec![words.name.to_owned()];
        if is_split {
            header.extend([bracket(words.nominal), words.class.to_owned()]);
        } else {
            header.push(words.callout.to_owned());
        }
        if trap == Trap::OtherNominal && !is_split {
            header.push(bracket(words.nominal));
        }
        header.push(bracket(words.measured));
        let value_at = header.len() - 1;
        if stated == Stated::Column {
            header.push(words.unit.to_owned());
        }
        match trap {
            Trap::SecondValue => header.push(bracket(pick::<&str>(random, words.second.as_slice()))),
            Trap::Quantity => header.push((*pick(random, &words.kinds)).to_owned()),
            Trap::Simulated => header.push(words.simulated.to_owned()),
            Trap::Origin => header.push(words.origin.to_owned()),
            Trap::Status => header.push(words.status.to_owned()),
            _ => {}
        }
        if random.below(4) == 0 {
            header.push(words.serial.to_owned());
        }
        let has_machine = random.below(4) == 0;
        if has_machine {
            header.push(words.machine.to_owned());
        }
        header.push(words.remark.to_owned());
        put(&mut text, &header);
        if stated == Stated::RowBelow {
            let unit_cell = |(at, name): (usize, &String)| {
                let is_length = at == value_at || *name == words.nominal;
                let is_second = words.second.contains(&name.as_str());
                if is_length || is_second { spelling.to_owned() } else { String::new() }
            };
            let cells: Vec<String> = header.iter().enumerate().map(unit_cell).collect();
            put(&mut text, &cells);
        }
        let mut truths = Vec::new();
        for number in 0..rows {
            let made = row(random, unit);
            let name = format!("{own}B{number}");
            let mut truth = Truth {
                name: name.clone(),
                callout: format!("{} {}", printed(made.nominal, UNITS[0], '.'), made.class),
                status: Some(made.status).filter(|_| trap != Trap::SecondValue),
                is_simulated: false,
                is_contradicted: false,
            };
            let in_unit = |nanometres: i64| {
                let printed = printed(nanometres, unit, sign);
                if stated == Stated::Cell { format!("{printed} {spelling}") } else { printed }
            };
            let mut cells = vec![name];
            if is_split {
                // Whole where it can be, as people write it.
                let is_whole = made.nominal % unit.nanometres == 0;
                let whole = (made.nominal / unit.nanometres).to_string();
                let nominal = if is_whole { whole } else { printed(made.nominal, unit, sign) };
                let nominal = if stated == Stated::Cell { format!("{nominal} {spelling}") } else { nominal };
                cells.extend([nominal, made.class.clone()]);
            } else if trap == Trap::Micrometres && random.below(3) == 0 {
                let upper = 2 + random.below(90);
                let lower = random.below(upper);
                let size = made.nominal / MILLIMETRE;
                let callout = *pick(random, &["P +U/+L", "P +U +L", "P ±U"]);
                let callout = callout.replace('P', &size.to_string());
                let callout = callout.replace('U', &upper.to_string()).replace('L', &lower.to_string());
                // A zone of whole millimetres: nobody means it, and a class stands beside nothing.
                let widest = i64::try_from(upper - lower).unwrap() * if callout.contains('±') { 2 } else { 1 };
                let is_absurd = 10 < widest || callout.contains('±') && 3 < upper;
                if is_absurd {
                    truth.status = None;
                    cells.push(callout);
                } else {
                    cells.push(format!("{size} {}", made.class));
                }
            } else {
                cells.push(format!("{} {}", made.nominal / MILLIMETRE, made.class));
            }
            if trap == Trap::OtherNominal && !is_split {
                let other = if random.below(2) == 0 {
                    truth.status = None;
                    made.nominal + MILLIMETRE * i64::try_from(1 + random.below(5)).unwrap()
                } else {
                    made.nominal
                };
                cells.push(printed(other, unit, sign));
            }
            if trap == Trap::NoNumber && random.below(4) == 0 {
                truth.status = None;
                let odd = *pick(random, &["", "n/a", "25.0.1", "-", "#DIV/0!", "1e400", "--25", "OVER"]);
                cells.push(odd.to_owned());
            } else {
                cells.push(in_unit(made.measured));
            }
            if stated == Stated::Column {
                cells.push(spelling.to_owned());
            }
            match trap {
                Trap::SecondValue => cells.push(in_unit(made.measured + unit.step * 7)),
                Trap::Quantity => {
                    if random.below(2) == 0 {
                        truth.status = None;
                        cells.push((*pick(random, &OTHERS)).to_owned());
                    } else {
                        cells.push((*pick(random, &SIZES)).to_owned());
                    }
                }
                Trap::Simulated => {
                    truth.is_simulated = random.below(2) == 0;
                    cells.push(if truth.is_simulated { "true" } else { "false" }.to_owned());
                }
                Trap::Origin => {
                    truth.is_simulated = random.below(2) == 0;
                    cells.push(words.origins[usize::from(truth.is_simulated)].to_owned());
                }
                Trap::Status => {
                    let is_good = random.below(2) == 0;
                    truth.is_contradicted = is_good != (made.status == Status::Good);
                    let said: &[&str] =
                        if is_good { &["OK", "i.O.", "GOOD", "pass"] } else { &["NOK", "n.i.O.", "fail"] };
                    cells.push((*pick(random, said)).to_owned());
                }
                _ => {}
            }
            if header.iter().any(|name| *name == words.serial) {
                cells.push(format!("S-{number}"));
            }
            if has_machine {
                cells.push("DMU 50".to_owned());
            }
            if trap == Trap::QuotedRows && random.below(3) == 0 {
                // A row of another name, of which the remark tells.
                let mut inner = cells.clone();
                inner[0] = format!("{own}X{number}");
                inner.push("there".to_owned());
                cells.push(format!("as here{line_end}{}", inner.join(&separator.to_string())));
            } else {
                cells.push("seen".to_owned());
            }
            assert_eq!(cells.len(), header.len());
            put(&mut text, &cells);
            truths.push(truth);
        }
        let may_be_refused = !unit.is_read || trap != Trap::None || stated == Stated::Cell;
        let made = format!("{trap:?}, {stated:?} {spelling}, separator {separator:?}, sign {sign}");
        let bytes = encoded(random, &text);
        let separator = u8::try_from(separator).unwrap();
        Self { bytes, text, separator, rows: truths, trap, is_plain: !may_be_refused, made, stated }
    }
}

/// The text in one of the encodings that programs write; one of bytes for each character only where it has all of them.
fn encoded(random: &mut Random, text: &str) -> Vec<u8> {
    let wide = |mark: u16, order: fn(u16) -> [u8; 2]| {
        std::iter::once(mark).chain(text.encode_utf16()).flat_map(order).collect::<Vec<u8>>()
    };
    match random.below(8) {
        0 => ["\u{feff}".as_bytes(), text.as_bytes()].concat(),
        1 => wide(0xfeff, u16::to_le_bytes),
        2 => wide(0xfeff, u16::to_be_bytes),
        3 if text.chars().all(|c| u32::from(c) < 0x80 || (0xa0..0x100).contains(&u32::from(c))) => {
            text.chars().map(|c| u8::try_from(u32::from(c)).unwrap()).collect()
        }
        _ => text.as_bytes().to_vec(),
    }
}
