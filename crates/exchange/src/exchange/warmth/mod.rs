//! At which temperature a file says that something was measured: by the name of a column, or in the words of a line, a cell or a name.

mod said;
mod token;
mod words;

use fitcheck_core::tolerance::fit::thermal::Temperature;
use token::{TokenKind, plain, tokens};
pub(super) use words::Whose;

/// The unit of a temperature.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Scale {
    Celsius,
    Fahrenheit,
    Kelvin,
    /// How many kelvins above 20 °C.
    Above,
}

impl Scale {
    fn degrees(self, number: f64) -> Option<Temperature> {
        let celsius = match self {
            Self::Celsius => number,
            Self::Fahrenheit => (number - 32.0) / 1.8,
            Self::Kelvin => number - 273.15,
            Self::Above => number + 20.0,
        };
        Temperature::from_thousandths(format!("{:.0}", celsius * 1e3).parse().ok()?)
    }
}

/// A column of temperatures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct OfTemperature {
    pub(super) scale: Scale,
    /// Whose they are, where the name says so.
    pub(super) whose: Option<Whose>,
}

/// Words behind which a temperature is a number or a state.
const NO_VALUE: [&str; 9] = ["id", "no", "nr", "number", "nummer", "sensor", "status", "ok", "class"];

/// What the name of a column says of the temperatures in it; `None` where it says none of a part or of its place.
pub(super) fn of_column(name: &str) -> Option<OfTemperature> {
    let text = plain(&name.replace('_', " "));
    let tokens = tokens(&text);
    let all: Vec<&str> = tokens
        .iter()
        .filter_map(|token| match token.kind {
            TokenKind::Word(word) => Some(word),
            _ => None,
        })
        .collect();
    let unit = tokens.windows(2).find_map(|pair| match pair {
        [sign, letter] if sign.is('°') => scale_of(letter.kind),
        _ => None,
    });
    let last = all.last().copied().filter(|_| 1 < all.len());
    let letter = last.and_then(|last| scale_of(TokenKind::Word(last)));
    let is_difference = all
        .iter()
        .any(|word| ["δ", "delta", "diff", "difference", "differenz", "verschil", "δt", "dt", "deltat"].contains(word));
    let whose = |whose: Whose| all.iter().any(|word| words::whose(word) == Some(whose)).then_some(whose);
    let is_of_part = whose(Whose::Part).is_some();
    let is_named =
        all.iter().any(|word| words::names_temperature(word) || ["celsius", "degc", "fahrenheit"].contains(word))
            || is_of_part && all.contains(&"t")
            || is_difference && letter == Some(Scale::Kelvin);
    let is_denied = denies_correction(name);
    let is_none = all.iter().any(|word| {
        let is_corrected = words::correction(word).is_some() && !is_denied;
        NO_VALUE.contains(word) || words::is_no_temperature(word) || is_corrected
    });
    // "Temp 1" is the first of several.
    let is_said = mentioned(name.trim().trim_end_matches(|c: char| c.is_ascii_digit())).is_some();
    if is_none || !is_named && unit.is_none() || is_said {
        return None;
    }
    let whose = whose(Whose::Part).or_else(|| whose(Whose::Other)).or_else(|| whose(Whose::Place));
    let scale = if is_difference { Scale::Above } else { unit.or(letter).unwrap_or(Scale::Celsius) };
    Some(OfTemperature { scale, whose }).filter(|_| whose != Some(Whose::Other))
}

fn scale_of(letter: TokenKind<'_>) -> Option<Scale> {
    match letter {
        TokenKind::Word("c" | "celsius") => Some(Scale::Celsius),
        TokenKind::Word("f" | "fahrenheit") => Some(Scale::Fahrenheit),
        TokenKind::Word("k" | "kelvin") => Some(Scale::Kelvin),
        _ => None,
    }
}

/// The temperature in a cell of such a column; `None` where it has none.
pub(super) fn read(cell: &str, scale: Scale) -> Option<Temperature> {
    let text = cell.trim();
    let is_plain = text.bytes().all(|byte| byte.is_ascii_digit() || b".,".contains(&byte));
    match text.replace(',', ".").parse() {
        Ok(number) if is_plain => scale.degrees(number),
        _ => said::said(text, Some(scale)),
    }
}

/// Whether two temperatures differ by more than 1 K: what counts where no zone is known.
pub(super) fn differ(one: Temperature, other: Temperature) -> bool {
    1_000 < (one.thousandths() - other.thousandths()).abs()
}

/// Whether a text says a temperature, or whether values were corrected to one.
pub(super) fn speaks(text: &str) -> bool {
    mentioned(text).is_some() || denies_correction(text)
}

/// Whether a text says that values were not corrected.
pub(super) fn denies_correction(text: &str) -> bool {
    said::denies_correction(text)
}

/// The temperature that a text says of the part, or of the place around it.
pub(super) fn mentioned(text: &str) -> Option<Temperature> {
    said::said(text, None)
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
    fn cells_of_a_temperature_are_read_as_people_write_them() {
        for (cell, expected) in [
            ("~35", "35"),
            ("ca. 35 °C", "35"),
            (">30", "30"),
            ("35-36", "36"),
            ("20,1 – 22", "22"),
            ("−3", "-3"),
            ("21 ± 1", "21"),
            ("35 (compensated)", "20"),
            ("35 not compensated", "35"),
        ] {
            assert_eq!(read(cell, Scale::Celsius), Some(degrees(expected)), "{cell}");
        }
        assert_eq!(read("1.5", Scale::Above), Some(degrees("21.5")));
        for cell in ["10:30", "2026-11-26", "-", "n/a"] {
            assert_eq!(read(cell, Scale::Celsius), None, "{cell}");
        }
    }

    #[test]
    fn a_text_says_a_temperature_of_the_part() {
        for (text, expected) in [
            ("Raumtemperatur 35,5 °C", "35.5"),
            ("Part temperature: 31.0C", "31"),
            ("Werkstücktemperatur 31,5", "31.5"),
            ("temperatuur = 88 F, 10:00", "31.111"),
            ("Temperature 20.1 C Probe 3 mm", "20.1"),
            ("part at 95°F, room 20 °C", "35"),
            ("20 °C ± 1 °C", "20"),
            // In small letters it has more bytes.
            ("İ 35 °C °", "35"),
            ("Temp. 35", "35"),
            ("Temperatur [°C] 35,0", "35"),
            ("Werkstück [°C] 35,0", "35"),
            ("temperature of the part: 35", "35"),
            ("T = 35 °C", "35"),
            ("part 35C", "35"),
            ("measured at 35 C", "35"),
            ("part 35 degrees C", "35"),
            ("Teil 35 Grad", "35"),
            ("onderdeel gemeten bij 35 graden", "35"),
            ("pezzo misurato a 35 gradi", "35"),
            ("Part temp: 95 F", "35"),
            ("part 308 K", "34.85"),
            ("part -3 °C", "-3"),
            ("Teil: −3 °C", "-3"),
            ("20-35 °C", "35"),
            ("from 20 to 35 °C", "35"),
            ("Teil 70 °C", "70"),
            ("# 35 degrees C", "35"),
            ("deel 35 graden", "35"),
            ("35° warm", "35"),
            ("part temp (after coolant) 35", "35"),
            ("35 °C (Teil), 20 °C (Raum)", "35"),
            ("compensation = 0, T = 35 °C", "35"),
        ] {
            assert_eq!(mentioned(text), Some(degrees(expected)), "{text}");
        }
    }

    #[test]
    fn a_word_speaks_of_its_own_clause_only() {
        for (text, expected) in [
            ("Reference temperature 20 °C, part measured at 35 °C", "35"),
            ("Tol. bei 20 °C, gemessen bei 35 °C ohne Korrektur", "35"),
            ("part 35 °C not compensated", "35"),
            ("nicht temperaturkompensiert, 35 °C", "35"),
            ("unkompensiert bei 35 °C", "35"),
            ("temperature compensated: NO, part 35 °C", "35"),
            ("Temp. comp. off, 35 °C", "35"),
            ("temperature compensation off 35 °C", "35"),
            ("to be corrected, 35 °C", "35"),
            ("tool radius corrected, part 35 °C", "35"),
            ("spindle compensated, part 35 °C", "35"),
            ("Kühlmittel 25 °C, Teil 35 °C", "35"),
            ("Coolant 35 °C, part 35 °C", "35"),
            ("Temperatur 35 °C Kühlmittel 25 °C", "35"),
            ("Spindle 40 °C / workpiece 35 °C", "35"),
            ("after hardening still 45 °C", "45"),
            ("nach dem Waschen 45 °C, Teil 35 °C", "45"),
            ("ambient 27 °C, part 20 °C", "20"),
            ("Reference temperature 23 °C", "23"),
            ("measured at 35 °C, corrected to 20 °C", "20"),
            ("corrected from 35 °C to 20 °C", "20"),
            ("Werte auf 20 °C umgerechnet", "20"),
            ("gemessen bei 35 °C, temperaturkompensiert", "20"),
            ("mit Temperaturkompensation, 35 °C", "20"),
            ("temperature compensation: on, 35 °C", "20"),
            ("temperature compensated", "20"),
        ] {
            assert_eq!(mentioned(text), Some(degrees(expected)), "{text}");
        }
    }

    #[test]
    fn a_text_of_something_else_says_none() {
        for text in [
            "25 H7",
            "35 C",
            "temperature 10:00",
            "Temperature 2026-11-01",
            "temperature:",
            "cleaned at 80 °C",
            "Teile gewaschen bei 60 °C",
            "lavato a 45 °C",
            "Drying 45 °C",
            "eloxiert bei 20,5 °C",
            "KSS 28 °C",
            "Waschmaschine 55 °C",
            "Lagertemperatur 5 °C",
            "Storage temperature 5 °C",
            "alarm at 45 °C",
            "temperature limit 30 °C",
            "Calibration of probe 22 °C",
            "Kühlmittel 35 °C",
            "35 °C coolant",
            "Außentemperatur 5 °C",
            "Reference temperature 20 °C",
            "°C",
            "35° clockwise",
            "30° C-Achse",
            "B30° C=45°",
            "2x45°",
            "part turned by 35 degrees clockwise",
            "Template 35",
            "Temperature sensor 3",
            "heated by 2 °C/min",
            "corrected typing error",
            "batch 300 K",
            "Temperature uncertainty 0.5 °C",
        ] {
            assert_eq!(mentioned(text), None, "{text}");
        }
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
            ("Temp. Teil nach Kühlung", Some(Scale::Celsius)),
            ("t_part", Some(Scale::Celsius)),
            ("Bauteil-T", Some(Scale::Celsius)),
            ("Werkstück [°C]", Some(Scale::Celsius)),
            ("ΔT [K]", Some(Scale::Above)),
            ("Temp. difference", Some(Scale::Above)),
            ("measured at 20 °C", None),
            ("Spindeltemperatur", None),
            ("Temp sensor no", None),
            ("TempID", None),
            ("temp comp", None),
            ("template", None),
            ("Temperature uncertainty", None),
            ("u(Temp)", None),
            ("Temp drift [K]", None),
            ("Temperature limit", None),
            ("Temp. Korr.", None),
            ("Werkzeugtemperatur", None),
            ("Ofentemperatur", None),
            ("Waschtemperatur", None),
            ("T", None),
            ("TempC", Some(Scale::Celsius)),
            ("Temp 1", Some(Scale::Celsius)),
            ("Temp. (comp. off)", Some(Scale::Celsius)),
            ("Temp [°C] uncorrected", Some(Scale::Celsius)),
        ] {
            assert_eq!(of_column(name).map(|column| column.scale), expected, "{name}");
        }
    }
}
