//! Mask and parameters to text.

use fitcheck_core::message::{FilePlace, Located};
use fitcheck_core::words::Dialogue;
use jiff::civil::DateTime;

use super::{Format, FormatLetter, Keyword, Line, Mask, NAMES, Name, Part, Record, RenderError, RenderFault};
use crate::control::variables::{Family, Value, Variables};

/// What a mask prints besides parameters.
#[derive(Debug, Clone, Copy)]
pub struct Context<'a> {
    /// The dialogue language, for `L_` sections.
    pub language: Dialogue,
    /// Local date and time.
    pub time: DateTime,
    /// Path of the NC program, for `CALL_PATH`.
    pub call_path: &'a str,
}

/// What happens to the output file.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum FileUse {
    /// The control's default.
    #[default]
    Replace,
    /// `M_APPEND`.
    Append,
    /// `M_APPEND_MAX`: up to this many kilobytes.
    AppendMax(u32),
}

/// What a mask printed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Output {
    /// The text, every line ended by LF.
    pub text: String,
    /// What happens to the output file.
    pub file: FileUse,
    /// Whether the file is closed afterwards (`M_CLOSE`).
    pub close: bool,
}

impl Mask {
    /// Prints parameters, by C's rules: a width is a minimum, numbers are rounded half away from zero on their exact
    /// decimal value, the decimal sign is a point.
    ///
    /// # Errors
    /// [`RenderError`] for an undefined parameter or one of the wrong kind.
    pub fn render(&self, variables: &Variables, context: &Context<'_>) -> Result<Output, RenderError> {
        let mut output = Output { text: String::new(), file: FileUse::Replace, close: false };
        let mut speaks = true;
        let mut hides = false;
        for line in &self.lines {
            match line {
                Line::Language(language) => {
                    speaks = language.as_deref().is_none_or(|word| word == context.language.words().mask_language);
                }
                Line::Keyword(Keyword::Close) => output.close = true,
                Line::Keyword(Keyword::File(file)) => output.file = *file,
                Line::Keyword(Keyword::EmptyHide) => hides = true,
                Line::Keyword(Keyword::EmptyShow) => hides = false,
                Line::Record(_) if !speaks => {}
                Line::Record(record) if hides && record.has_empty_text(variables) => {}
                Line::Record(record) => {
                    record.render(variables, context, &mut output.text)?;
                    output.text.push('\n');
                }
            }
        }
        Ok(output)
    }
}

impl Record {
    /// Whether a text parameter is empty, for `M_EMPTY_HIDE`. An undefined one stays an error: a mistake in its number
    /// must not hide the status line.
    fn has_empty_text(&self, variables: &Variables) -> bool {
        self.parts.iter().any(|part| match part {
            Part::Field { name: Name::Parameter(parameter), .. } if parameter.family == Family::Qs => {
                matches!(variables.get(*parameter), Some(Value::Text(text)) if text.is_empty())
            }
            _ => false,
        })
    }

    fn render(&self, variables: &Variables, context: &Context<'_>, out: &mut String) -> Result<(), RenderError> {
        for part in &self.parts {
            match part {
                Part::Text(text) => out.push_str(text),
                Part::Field { format, name, column } => {
                    let at = At { line: self.line, column: *column, name: *name };
                    out.push_str(&at.field(format, variables, context)?);
                }
            }
        }
        Ok(())
    }
}

/// A field being rendered, and its place.
struct At {
    line: usize,
    column: usize,
    name: Name,
}

/// What a field prints before it is formatted.
enum Printed<'a> {
    Text(&'a str),
    /// A plain decimal number.
    Number(String),
}

impl At {
    fn fault(&self, what: RenderFault) -> RenderError {
        Located { what, place: FilePlace::in_line(self.line, self.column) }
    }

    fn field(&self, format: &Format, variables: &Variables, context: &Context<'_>) -> Result<String, RenderError> {
        let printed = self.printed(variables, context)?;
        let name = || self.name.to_string();
        match (format.kind, printed) {
            (FormatLetter::Raw, Printed::Text(text)) => Ok(text.to_owned()),
            (FormatLetter::Text, Printed::Text(text)) => {
                let text: String = text.chars().take(format.digits.unwrap_or(usize::MAX)).collect();
                Ok(padded(&text, format.width, format.left))
            }
            (FormatLetter::Decimal, Printed::Number(number)) => {
                let digits = format.digits.unwrap_or(6);
                Ok(signed(&told(&number, digits), format))
            }
            (FormatLetter::Whole, Printed::Number(number)) => {
                let whole = told(&number, 0);
                let (sign, figures) = whole.strip_prefix('-').map_or(("", whole.as_str()), |figures| ("-", figures));
                let figures = match format.digits {
                    Some(least) => format!("{figures:0>least$}"),
                    None => figures.to_owned(),
                };
                // In C the least number of digits takes the place of filling with zeros.
                let format = Format { zeros: format.zeros && format.digits.is_none(), ..*format };
                Ok(signed(&format!("{sign}{figures}"), &format))
            }
            (FormatLetter::Text | FormatLetter::Raw, Printed::Number(_)) => {
                Err(self.fault(RenderFault::NumberAsText { name: name() }))
            }
            (FormatLetter::Decimal | FormatLetter::Whole, Printed::Text(_)) => {
                Err(self.fault(RenderFault::TextAsNumber { name: name() }))
            }
        }
    }

    fn printed<'a>(&self, variables: &'a Variables, context: &Context<'a>) -> Result<Printed<'a>, RenderError> {
        let time = context.time;
        let number = |number: i16| Ok(Printed::Number(number.to_string()));
        match self.name {
            Name::Day => number(time.day().into()),
            Name::Month => number(time.month().into()),
            Name::Year2 => number(time.year().rem_euclid(100)),
            Name::Year4 => number(time.year()),
            Name::Hour => number(time.hour().into()),
            Name::Minute => number(time.minute().into()),
            Name::Second => number(time.second().into()),
            Name::CallPath => Ok(Printed::Text(context.call_path)),
            Name::Parameter(parameter) => {
                let name = || parameter.to_string();
                match variables.get(parameter) {
                    None => Err(self.fault(RenderFault::Undefined { name: name() })),
                    Some(Value::Text(text)) => Ok(Printed::Text(text)),
                    Some(Value::Length(length)) => Ok(Printed::Number(length.to_string())),
                    // The shortest decimal for this number: what a user typed, not the binary number next to it.
                    Some(Value::Number(value)) if value.is_finite() => Ok(Printed::Number(value.to_string())),
                    Some(Value::Number(_)) => Err(self.fault(RenderFault::NotFinite { name: name() })),
                }
            }
        }
    }
}

/// A sign if the format wants one, and the width, filled with blanks or zeros.
fn signed(number: &str, format: &Format) -> String {
    let (minus, figures) = number.strip_prefix('-').map_or((false, number), |figures| (true, figures));
    let sign = match (minus, format.plus, format.blank) {
        (true, ..) => "-",
        (false, true, _) => "+",
        (false, false, true) => " ",
        (false, false, false) => "",
    };
    if format.zeros && !format.left {
        let width = format.width.saturating_sub(sign.len());
        return format!("{sign}{figures:0>width$}");
    }
    padded(&format!("{sign}{figures}"), format.width, format.left)
}

fn padded(text: &str, width: usize, left: bool) -> String {
    if left { format!("{text:<width$}") } else { format!("{text:>width$}") }
}

/// A number with this many digits after the point, rounded half away from zero; `None` if it is not a finite number.
pub(crate) fn decimal(value: &Value, digits: usize) -> Option<String> {
    match value {
        Value::Length(length) => Some(told(&length.to_string(), digits)),
        Value::Number(number) if number.is_finite() => Some(told(&number.to_string(), digits)),
        Value::Number(_) | Value::Text(_) => None,
    }
}

/// A plain decimal number with this many digits. A result of binary arithmetic is a little off the intended decimal:
/// with fewer digits than a nanometre needs, it is first rounded to the nearest nanometre.
fn told(number: &str, digits: usize) -> String {
    /// The decimals of a nanometre in millimetres.
    const NANOMETRE: usize = 6;
    if digits < NANOMETRE { rounded(&rounded(number, NANOMETRE), digits) } else { rounded(number, digits) }
}

/// A plain decimal number with this many digits after the point, rounded half away from zero.
fn rounded(number: &str, digits: usize) -> String {
    let (minus, unsigned) = number.strip_prefix('-').map_or((false, number), |unsigned| (true, unsigned));
    let (whole, decimals) = unsigned.split_once('.').unwrap_or((unsigned, ""));
    let mut figures: Vec<u8> =
        whole.bytes().chain(decimals.bytes().chain(std::iter::repeat(b'0')).take(digits)).collect();
    if decimals.as_bytes().get(digits).is_some_and(|next| b'5' <= *next) {
        let mut carry = true;
        for figure in figures.iter_mut().rev() {
            if !carry {
                break;
            }
            carry = *figure == b'9';
            *figure = if carry { b'0' } else { *figure + 1 };
        }
        if carry {
            figures.insert(0, b'1');
        }
    }
    let point = figures.len() - digits;
    let is_zero = figures.iter().all(|figure| *figure == b'0');
    let mut text = String::from(if minus && !is_zero { "-" } else { "" });
    for (place, figure) in figures.into_iter().enumerate() {
        if place == point {
            text.push('.');
        }
        text.push(char::from(figure));
    }
    text
}

impl std::fmt::Display for Name {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        if let Self::Parameter(parameter) = self {
            return parameter.fmt(f);
        }
        f.write_str(NAMES.iter().find(|(_, known)| known == self).map_or("", |(word, _)| *word))
    }
}

#[cfg(test)]
mod tests {
    use super::{rounded, told};

    #[test]
    fn takes_what_was_computed_at_the_nearest_nanometre() {
        // Sums that a program computes from 25.00005 + 0 / 1000, 8.0001 - 7.5 / 1000 and the like.
        for (number, expected) in
            [("25.000049999999998", "25.0001"), ("25.020999999999997", "25.0210"), ("-0.00005000000001", "-0.0001")]
        {
            assert_eq!(told(number, 4), expected, "{number}");
        }
        assert_eq!(told("0.12345678", 8), "0.12345678");
    }

    #[test]
    fn rounds_half_away_from_zero_on_the_decimal_value() {
        for (number, digits, expected) in [
            ("25", 4, "25.0000"),
            ("25.00005", 4, "25.0001"),
            ("25.00004999", 4, "25.0000"),
            ("-25.00005", 4, "-25.0001"),
            ("-0.00004", 4, "0.0000"),
            ("9.99995", 4, "10.0000"),
            ("0.5", 0, "1"),
            ("1.005", 2, "1.01"),
            ("-1.5", 0, "-2"),
        ] {
            assert_eq!(rounded(number, digits), expected, "{number}");
        }
    }
}
