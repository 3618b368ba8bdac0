//! What drawings have that is no callout of a length: each with its own reason and what to write instead.

use super::super::error::{CalloutError, shorten};
use super::super::kind::CalloutErrorKind as Kind;
use super::super::reading;
use super::{Drawing, Tolerance};
use crate::length::{Length, Unit};
use crate::tolerance::iso286::ANSI;

/// Units of inches behind a number; words are whole words.
const INCHES: [&str; 6] = ["\"", "''", "inches", "inch", "in", "zoll"];

/// An inch, in nanometres.
const INCH: i128 = 25_400_000;

/// Words beside a theoretically exact size.
const EXACT: [&str; 3] = ["TED", "BASIC", "BSC"];

/// Beginnings of threads that no other callout has: a figure follows.
const THREADS: [&str; 4] = ["M", "MJ", "TR", "G"];

/// Words of threads.
const THREAD_WORDS: [&str; 8] = ["UNC", "UNF", "UNEF", "UNS", "NPT", "BSP", "BSPP", "BSW"];

/// Names of roughness.
const ROUGHNESS: [&str; 5] = ["RA", "RZ", "RT", "RQ", "RMAX"];

/// Words of one limit alone.
const ONE_SIDED: [&str; 4] = ["MIN", "MAX", "MINIMUM", "MAXIMUM"];

impl Drawing<'_> {
    /// Refuses what is no callout.
    pub(super) fn refuse(&self) -> Result<(), CalloutError> {
        let place = self.whole();
        let text = self.slice(&place);
        kind(&text, self.given.trim()).map_or(Ok(()), |kind| Err(self.error(&place, kind)))
    }
}

fn kind(text: &str, as_given: &str) -> Option<Kind> {
    let given = || shorten(as_given);
    let capital = text.to_ascii_uppercase();
    let words: Vec<&str> = capital.split_whitespace().map(|word| word.trim_matches(['.', ',', ';'])).collect();
    let has = |known: &[&str]| words.iter().any(|word| known.contains(word));
    if text.starts_with('[') && text.ends_with(']') || has(&EXACT) {
        return Some(Kind::Exact);
    }
    let is_closed = text.starts_with('(') && text.find(')') == Some(text.len().saturating_sub(1));
    let has_size = |c: char| c.is_ascii_digit() || c == 'Ø';
    if is_closed && text.trim_start_matches('(').trim_start().starts_with(has_size) || has(&["REF"]) {
        return Some(Kind::Reference);
    }
    if words.iter().any(|word| ROUGHNESS.contains(&word.trim_end_matches(is_number))) {
        return Some(Kind::Roughness { given: given() });
    }
    if has(&ONE_SIDED) || text.starts_with(['<', '>', '≤', '≥']) {
        return Some(Kind::OneSided { given: given() });
    }
    let first = words.first().copied().unwrap_or("");
    let is_thread = |name: &&str| first.strip_prefix(*name).is_some_and(|rest| rest.starts_with(is_number));
    let is_two_words = first == "G" && words.get(1).is_some_and(|word| word.starts_with(is_number));
    if THREADS.iter().any(is_thread) || is_two_words || has_thread_word(&words) {
        return Some(Kind::Thread { given: given() });
    }
    let ansi = words.iter().zip(words.iter().skip(1)).find(|(name, grade)| ANSI.contains(name) && is_grade(grade));
    if let Some((name, grade)) = ansi {
        return Some(Kind::Ansi { class: format!("{name}{grade}") });
    }
    inches(text)
}

/// Words such as `UNC-2B`.
fn has_thread_word(words: &[&str]) -> bool {
    words.iter().any(|word| word.split('-').any(|part| THREAD_WORDS.contains(&part)))
}

fn is_grade(word: &str) -> bool {
    word.len() == 1 && word.bytes().all(|byte| byte.is_ascii_digit())
}

const fn is_number(c: char) -> bool {
    c.is_ascii_digit() || matches!(c, '.' | ',')
}

/// A size in inches, or inches elsewhere.
fn inches(text: &str) -> Option<Kind> {
    let body = text.trim_start_matches('Ø').trim_start();
    let end = body.find(|c: char| !(is_number(c) || c == '/' || c == '-' || c.is_whitespace()))?;
    let (number, behind) = body.split_at_checked(end)?;
    let Some((unit, rest)) = unit(behind).filter(|_| number.contains(|c: char| c.is_ascii_digit())) else {
        return text.contains('"').then(|| Kind::InchSomewhere { given: shorten(text) });
    };
    let given = shorten(&format!("{}{}{unit}", number.trim(), if unit.starts_with(['"', '\'']) { "" } else { " " }));
    let Some(nominal) = exact(number.trim()) else { return Some(Kind::InchSomewhere { given }) };
    let offer = reading::callout(&format!("{nominal} {}", rest.trim())).ok();
    let offer = offer.filter(|offer| matches!(offer.tolerance(), Tolerance::Class(_) | Tolerance::Fit { .. }));
    Some(match offer {
        Some(offer) => Kind::Inch { given, nominal, offer },
        None => Kind::InchSize { given, nominal },
    })
}

/// A unit of inches at the beginning, and what follows it.
fn unit(text: &str) -> Option<(&str, &str)> {
    INCHES.into_iter().find_map(|unit| {
        let (found, rest) = text.split_at_checked(unit.len())?;
        let is_word = unit.starts_with(|c: char| c.is_ascii_alphabetic());
        let ends = !is_word || !rest.starts_with(char::is_alphanumeric);
        (found.eq_ignore_ascii_case(unit) && ends).then_some((found, rest))
    })
}

/// `0.5`, `1/2`, `1 1/2` or `1-1/2` inches as a length, where that is a whole number of nanometres above zero.
fn exact(number: &str) -> Option<Length> {
    let (whole, fraction) = match number.split_once([' ', '-']) {
        Some((whole, fraction)) => (whole.trim().parse::<u32>().ok()?, fraction.trim()),
        None => (0, number),
    };
    let Some((top, bottom)) = fraction.split_once('/') else {
        let length = Length::parse_in(number, Unit::Inch).ok()?;
        return (Length::ZERO < length).then_some(length);
    };
    let [top, bottom] = [top, bottom].map(|part| part.trim().parse::<u32>().map(i128::from));
    let (top, bottom) = (top.ok()?, bottom.ok()?);
    let nanometres = (i128::from(whole) * bottom + top) * INCH;
    // The remainder by zero is none.
    let is_exact = nanometres.checked_rem(bottom) == Some(0);
    let nanometres = i64::try_from(nanometres.checked_div(bottom).filter(|_| is_exact)?).ok()?;
    Length::from_nanometres(nanometres).ok().filter(|length| Length::ZERO < *length)
}
