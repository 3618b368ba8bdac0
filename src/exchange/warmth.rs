//! At which temperature a file says that something was measured: by the name of a column, or in the words of a line, a cell or a name.

use super::units;
use crate::tolerance::fit::thermal::Temperature;

/// The unit of a temperature.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Scale {
    Celsius,
    Fahrenheit,
    Kelvin,
}

/// How the names of temperatures end, in four languages.
const ENDS: [&str; 5] = ["temp", "temperature", "temperatur", "temperatuur", "temperatura"];

/// Parts of words that say the temperature of something else than the part, or that it counts already.
const OTHER: &str = "spindle|spindel|spil|mandrin|cool|kühl|kuehl|koel|refriger|oil|öl|olie|olio|scale|maßstab|massstab|schaal|harden|härt|haert|temper |\
    anneal|compens|kompens|temp comp|tempcomp|temp_comp|temp. comp|temp komp|tempkomp|correct|korrig|korrekt|gecorrig|corrett|correz|reference|referenz|bezug|referentie|riferimento|wash|clean|gereinigt";

fn speaks_of_other(text: &str) -> bool {
    let small = text.to_lowercase();
    OTHER.split('|').any(|part| small.contains(part))
}

/// How a unit of temperature is written, where nothing else may be meant; in small letters.
const UNITS: [(&str, Scale); 12] = [
    ("°c", Scale::Celsius),
    ("\u{ba}c", Scale::Celsius),
    ("\u{2103}", Scale::Celsius),
    ("° c", Scale::Celsius),
    ("degc", Scale::Celsius),
    ("deg c", Scale::Celsius),
    ("celsius", Scale::Celsius),
    ("grad c", Scale::Celsius),
    ("graden c", Scale::Celsius),
    ("gradi c", Scale::Celsius),
    ("°f", Scale::Fahrenheit),
    ("\u{2109}", Scale::Fahrenheit),
];

/// The unit of the temperatures in a column of this name; `None` where it is none of a part.
pub(super) fn of_column(name: &str) -> Option<Scale> {
    let small = name.to_lowercase();
    let words = units::words_of(name);
    let is_number =
        words.iter().any(|word| ["id", "no", "nr", "number", "sensor", "status", "ok"].contains(&word.as_str()));
    let is_temperature = !is_number && words.iter().any(|word| ENDS.iter().any(|end| word.ends_with(end)));
    let stated = UNITS.iter().find(|(unit, _)| small.contains(unit)).map(|(_, scale)| *scale);
    if speaks_of_other(name) || !is_temperature && (stated.is_none() || mentioned(name).is_some()) {
        return None;
    }
    let letter = words.last().filter(|_| 1 < words.len()).map(String::as_str);
    let by_letter = match letter {
        Some("k" | "kelvin") => Scale::Kelvin,
        Some("f" | "fahrenheit") => Scale::Fahrenheit,
        _ => Scale::Celsius,
    };
    Some(stated.unwrap_or(by_letter))
}

/// The temperature in a cell of such a column; `None` where it has none.
pub(super) fn read(cell: &str, scale: Scale) -> Option<Temperature> {
    let text = cell.trim();
    let number = text.trim_end_matches(|c: char| !c.is_ascii_digit());
    let scale = match text.strip_prefix(number)?.trim().trim_start_matches(['°', '\u{ba}', ' ']).to_lowercase().as_str()
    {
        "f" | "\u{2109}" => Scale::Fahrenheit,
        "k" => Scale::Kelvin,
        "c" | "\u{2103}" => Scale::Celsius,
        _ => scale,
    };
    in_celsius(number, scale)
}

fn in_celsius(number: &str, scale: Scale) -> Option<Temperature> {
    let number: f64 = number.trim().trim_start_matches('+').replace(',', ".").replace('\u{2212}', "-").parse().ok()?;
    let celsius = match scale {
        Scale::Celsius => number,
        Scale::Fahrenheit => (number - 32.0) / 1.8,
        Scale::Kelvin => number - 273.15,
    };
    Temperature::from_thousandths(format!("{:.0}", celsius * 1e3).parse().ok()?)
}

/// The number behind the name of a temperature: `Part temperature: 31.0C`, `temperatuur = 31`.
fn named(small: &str) -> impl Iterator<Item = Temperature> {
    let is_figure = |c: char| c.is_ascii_digit() || ".,".contains(c);
    let behind = ["temperatur", "temperatuur"].into_iter().flat_map(|name| small.match_indices(name));
    behind.filter_map(move |(at, name)| {
        let rest = small.get(at + name.len()..)?.trim_start_matches(char::is_alphabetic);
        let rest = rest.trim_start_matches([' ', ':', ';', '=', '\t']);
        let unit = rest.trim_start_matches(is_figure);
        let number = rest.strip_suffix(unit)?.trim_end_matches(['.', ',']);
        // No time, date or share.
        let is_alone = !unit.starts_with([':', '-', '/', '%']);
        let unit = unit.trim_start().trim_start_matches(['°', '\u{ba}']);
        let letters = unit.split(|c: char| !c.is_alphanumeric()).next()?;
        let scale = match letters {
            "f" => Scale::Fahrenheit,
            "k" => Scale::Kelvin,
            _ => Scale::Celsius,
        };
        in_celsius(number, scale).filter(|_| is_alone)
    })
}

/// The temperature that a text says of the place or the part, the one furthest from 20 °C: a number with its unit or behind the name of
/// a temperature, between 0 and 60 °C.
pub(super) fn mentioned(text: &str) -> Option<Temperature> {
    let small = text.to_lowercase();
    let is_said = small.contains("temperat") || UNITS.iter().any(|(unit, _)| small.contains(unit));
    if !is_said || speaks_of_other(text) {
        return None;
    }
    let is_near = |warm: &Temperature| (0..=60_000).contains(&warm.thousandths());
    let mut found: Vec<Temperature> = named(&small).filter(is_near).collect();
    for (unit, scale) in UNITS {
        for (at, _) in small.match_indices(unit) {
            let before = small.get(..at).unwrap_or_default().trim_end();
            let rest = before.trim_end_matches(|c: char| c.is_ascii_digit() || c == '.' || c == ',');
            let number = before.get(rest.len()..).unwrap_or_default();
            // "± 1 °C" is how far it may be off.
            let is_spread = rest.trim_end().ends_with('±') || rest.trim_end().ends_with("+/-");
            let sign = if rest.ends_with(['-', '\u{2212}']) { "-" } else { "" };
            let warm = in_celsius(&format!("{sign}{number}"), scale);
            found.extend(warm.filter(|warm| !is_spread && is_near(warm)));
        }
    }
    found.into_iter().max_by_key(|warm| (warm.thousandths() - Temperature::REFERENCE.thousandths()).abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn degrees(text: &str) -> Temperature {
        text.parse().unwrap()
    }

    #[test]
    fn temperatures_are_read_in_their_unit() {
        for (cell, scale, expected) in [
            ("35", Scale::Celsius, "35"),
            ("35,5 °C", Scale::Celsius, "35.5"),
            ("95", Scale::Fahrenheit, "35"),
            ("95 °F", Scale::Celsius, "35"),
            ("308.15K", Scale::Celsius, "35"),
            ("+21", Scale::Celsius, "21"),
        ] {
            assert_eq!(read(cell, scale), Some(degrees(expected)), "{cell}");
        }
        assert_eq!(read("warm", Scale::Celsius), None);
        assert_eq!(read("", Scale::Celsius), None);
    }

    #[test]
    fn a_text_mentions_a_temperature_with_its_unit_and_no_other_number() {
        assert_eq!(mentioned("Raumtemperatur 35,5 °C"), Some(degrees("35.5")));
        assert_eq!(mentioned("Part temperature: 31.0C"), Some(degrees("31")));
        assert_eq!(mentioned("Werkstücktemperatur 31,5"), Some(degrees("31.5")));
        assert_eq!(mentioned("temperatuur = 88 F, 10:00"), Some(degrees("31.111")));
        assert_eq!(mentioned("Temperature 20.1 C Probe 3 mm"), Some(degrees("20.1")));
        assert_eq!(mentioned("part at 95°F, room 20 °C"), Some(degrees("35")));
        assert_eq!(mentioned("20 °C ± 1 °C"), Some(degrees("20")));
        for text in [
            "25 H7",
            "35 C",
            "temperature 10:00",
            "Temperature 2026-11-01",
            "temperature:",
            "cleaned at 80 °C",
            "Kühlmittel 35 °C",
            "from 35 °C corrected to 20 °C",
            "°C",
        ] {
            assert_eq!(mentioned(text), None, "{text}");
        }
        // In small letters it has more bytes.
        assert_eq!(mentioned("İ 35 °C °"), Some(degrees("35")));
    }

    #[test]
    fn columns_of_a_temperature_are_known_by_their_names() {
        for (name, expected) in [
            ("Temp", Some(Scale::Celsius)),
            ("T [°C]", Some(Scale::Celsius)),
            ("Teiletemperatur", Some(Scale::Celsius)),
            ("Temperature [K]", Some(Scale::Kelvin)),
            ("temperature_f", Some(Scale::Fahrenheit)),
            ("T [°F]", Some(Scale::Fahrenheit)),
            ("measured at 20 °C", None),
            ("Spindeltemperatur", None),
            ("Temp sensor no", None),
            ("TempID", None),
            ("temp comp", None),
            ("template", None),
        ] {
            assert_eq!(of_column(name), expected, "{name}");
        }
    }
}
