//! A number in a format of a mask, `%+08.3F`: as rounded on paper and filled as C does.

use fitcheck::control::mask::{Context, Mask};
use fitcheck::control::variables::{Parameter, Value, Variables};
use fitcheck::length::Length;
use fitcheck::words::Dialogue;

use super::decimal::Decimal;
use super::shared::{Figures, NOW};

/// The decimals of a nanometre in millimetres: with fewer, a number is taken at the nearest nanometre first.
const NANOMETRE: usize = 6;

pub fn run(bytes: &[u8]) {
    let mut figures = Figures(bytes);
    let flags: String = ['-', '+', ' ', '0'].into_iter().filter(|_| figures.byte() % 2 == 1).collect();
    let width = usize::from(figures.byte()) % 40;
    let digits = usize::from(figures.byte()) % 32;
    let digits = (digits < 31).then_some(digits);
    let letter = figures.one_of(&["F", "LF", "D", "I"]);
    let value = match figures.byte() % 3 {
        0 => Value::Length(Length::from_nanometres(figures.up_to(2_000_000) - 1_000_000).expect("a millimetre")),
        1 => Value::Length(
            Length::from_nanometres(figures.up_to(2_000_000_000_000_000) - 1_000_000_000_000_000).expect("the most"),
        ),
        _ => Value::Number(f64::from_le_bytes(figures.bytes())),
    };
    let plain = match value {
        Value::Length(length) => length.to_string(),
        // Longer numbers only take longer.
        Value::Number(number) if number.abs() < 1e30 && 1e-30 < number.abs() => number.to_string(),
        _ => return,
    };
    let width_text = if width == 0 { String::new() } else { width.to_string() };
    let digits_text = digits.map_or(String::new(), |digits| format!(".{digits}"));
    let mask = format!("\"%{flags}{width_text}{digits_text}{letter}\", Q1;");
    let (mask, warnings) = Mask::read(mask.as_bytes()).expect("a mask");
    assert_eq!(warnings, []);
    let mut variables = Variables::new();
    variables.set(Parameter::q(1), value);
    let context = Context { language: Dialogue::En, time: NOW, call_path: "" };
    let printed = mask.render(&variables, &context).expect("a number").text;
    let is_whole = matches!(letter, "D" | "I");
    let number = on_paper(&plain, digits, is_whole);
    // C: with a precision, the flag 0 means nothing to whole numbers.
    let filling = if is_whole && digits.is_some() { flags.replace('0', "") } else { flags.clone() };
    assert_eq!(
        printed,
        format!("{}\n", filled(&number, &filling, width)),
        "%{flags}{width_text}{digits_text}{letter} of {plain}"
    );
}

fn on_paper(plain: &str, digits: Option<usize>, is_whole: bool) -> String {
    let decimals = if is_whole { 0 } else { digits.unwrap_or(6) };
    let number = Decimal::plain(plain);
    let number = if decimals < NANOMETRE { number.rounded(NANOMETRE) } else { number };
    let text = number.rounded(decimals).text();
    let (sign, figures) = text.strip_prefix('-').map_or(("", text.as_str()), |figures| ("-", figures));
    let least = if is_whole { digits.unwrap_or(0) } else { 0 };
    format!("{sign}{}{figures}", "0".repeat(least.saturating_sub(figures.len())))
}

/// With its sign and in its width, by C's flags.
fn filled(number: &str, flags: &str, width: usize) -> String {
    let (sign, figures) = match number.strip_prefix('-') {
        Some(figures) => ("-", figures),
        None if flags.contains('+') => ("+", number),
        None if flags.contains(' ') => (" ", number),
        None => ("", number),
    };
    let missing = width.saturating_sub(sign.len() + figures.len());
    match (flags.contains('-'), flags.contains('0')) {
        (true, _) => format!("{sign}{figures}{}", " ".repeat(missing)),
        (false, true) => format!("{sign}{}{figures}", "0".repeat(missing)),
        (false, false) => format!("{}{sign}{figures}", " ".repeat(missing)),
    }
}
