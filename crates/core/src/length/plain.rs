//! The figures of plain numbers: up to eight bytes at once and without a step for each, because the processor cannot guess
//! how many there are.

use std::num::NonZeroU64;

/// A number as it stands in a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Plain {
    /// All its figures as one number.
    pub(super) number: u64,
    /// How many of them stand behind the sign.
    pub(super) decimals: usize,
    /// Its decimal sign, if it has one.
    pub(super) sign: Option<u8>,
}

/// The most figures before the sign.
const MOST_WHOLE: usize = 9;

/// How many bytes are read in one step.
const STEP: usize = 8;

/// Reads the bytes of a text from `start` to `end`: one to nine figures, and others behind a point or a comma. `None` for
/// anything else. What stands before them in the text may be read, too.
#[expect(clippy::inline_always, reason = "its answer stays in registers, for each of millions of rows")]
#[inline(always)]
pub(super) fn read(text: &[u8], start: usize, end: usize) -> Option<Plain> {
    let length = end.checked_sub(start)?;
    match word_before(text, end) {
        Some(last) if (1..=STEP).contains(&length) => {
            let before = STEP - length;
            let (number, sign) = figures(last, before)?;
            match sign {
                None => Some(Plain { number, decimals: 0, sign: None }),
                Some((at, sign)) if before < at => Some(Plain { number, decimals: STEP - 1 - at, sign: Some(sign) }),
                Some(_) => None,
            }
        }
        Some(last) if (STEP + 1..=2 * STEP).contains(&length) => long(text, length, end, last),
        _ => slow(text.get(start..end)?),
    }
}

/// The eight bytes before a place, the first of them the lowest.
#[inline]
fn word_before(text: &[u8], end: usize) -> Option<u64> {
    let first = end.checked_sub(STEP)?;
    text.get(first..)?.first_chunk().map(|bytes| u64::from_le_bytes(*bytes))
}

/// The number in the upper bytes of a word, and where its sign stands among all eight; the first `before` bytes do not
/// belong to it. `None` where another byte is no figure.
#[expect(clippy::inline_always, reason = "as above")]
#[inline(always)]
fn figures(word: u64, before: usize) -> Option<(u64, Option<(usize, u8)>)> {
    // Figures become their values, and what stands before the number counts as zeros.
    let digits = (word ^ each(b'0')) & (u64::MAX << (8 * before));
    let Some(others) = NonZeroU64::new(above_nine(digits)) else { return Some((value(digits), None)) };
    let place = others.trailing_zeros() / 8 * 8;
    let sign = match word >> place & 0xff {
        sign if sign == u64::from(b'.') => b'.',
        sign if sign == u64::from(b',') => b',',
        _ => return None,
    };
    if others.get() & (others.get() - 1) != 0 {
        return None;
    }
    // Without it, what stands before it moves up by one place.
    let up_to = u64::MAX << place;
    let digits = (digits & (up_to << 8)) | ((digits & !up_to) << 8);
    Some((value(digits), Some((usize::try_from(place / 8).ok()?, sign))))
}

/// A number of nine to sixteen bytes in two words, of which the second is `last`.
#[inline(never)]
fn long(text: &[u8], length: usize, end: usize, last: u64) -> Option<Plain> {
    let Some(first) = word_before(text, end - STEP) else { return slow(text.get(end - length..end)?) };
    let before = 2 * STEP - length;
    let (first, first_sign) = figures(first, before)?;
    let (last, last_sign) = figures(last, 0)?;
    let (whole, decimals, sign, factor) = match (first_sign, last_sign) {
        (None, None) => (length, 0, None, 100_000_000),
        (Some((at, sign)), None) => (at - before, 2 * STEP - 1 - at, Some(sign), 100_000_000),
        (None, Some((at, sign))) => (STEP - before + at, STEP - 1 - at, Some(sign), 10_000_000),
        (Some(_), Some(_)) => return None,
    };
    // At most sixteen figures, far below 2^64.
    (1..=MOST_WHOLE).contains(&whole).then(|| Plain { number: first * factor + last, decimals, sign })
}

/// A number near the beginning of its text, or none that is plain, byte by byte.
#[inline(never)]
fn slow(text: &[u8]) -> Option<Plain> {
    if 2 * STEP < text.len() {
        return None;
    }
    let whole = text.iter().take_while(|byte| byte.is_ascii_digit()).count();
    let (figures, rest) = text.split_at_checked(whole)?;
    let (sign, decimals) = match rest {
        [] => (None, rest),
        [sign @ (b'.' | b','), decimals @ ..] => (Some(*sign), decimals),
        _ => return None,
    };
    if !(1..=MOST_WHOLE).contains(&whole) || !decimals.iter().all(u8::is_ascii_digit) {
        return None;
    }
    // At most sixteen figures, far below 2^64.
    let number = figures.iter().chain(decimals).fold(0, |number, digit| number * 10 + u64::from(digit - b'0'));
    Some(Plain { number, decimals: decimals.len(), sign })
}

/// A byte in all eight places.
const fn each(byte: u8) -> u64 {
    u64::from_le_bytes([byte; STEP])
}

/// The top bit of each byte above nine, and no other bit.
#[inline]
const fn above_nine(bytes: u64) -> u64 {
    (((bytes & each(0x7f)) + each(0x7f - 9)) | bytes) & each(0x80)
}

/// The number of eight digits, the first in the lowest byte: pairs of digits first, then pairs of pairs, then both fours.
#[inline]
const fn value(digits: u64) -> u64 {
    // Each pair stands in the lower of its two bytes, which has room for 99.
    let pairs = (digits * 10 + (digits >> 8)) & 0x00ff_00ff_00ff_00ff;
    let fours = (pairs * 100 + (pairs >> 16)) & 0x0000_ffff_0000_ffff;
    (fours * 10_000 + (fours >> 32)) & 0xffff_ffff
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// Digit by digit.
    fn slowly(text: &[u8]) -> Option<Plain> {
        let at = text.iter().position(|byte| !byte.is_ascii_digit());
        let whole = at.unwrap_or(text.len());
        if 16 < text.len() || !(1..=9).contains(&whole) {
            return None;
        }
        let sign = at.map(|at| text[at]);
        if sign.is_some_and(|sign| !matches!(sign, b'.' | b',')) {
            return None;
        }
        let decimals = text.get(whole + 1..).unwrap_or_default();
        if !decimals.iter().all(u8::is_ascii_digit) {
            return None;
        }
        let digits = text[..whole].iter().chain(decimals);
        let number = digits.fold(0, |number, digit| number * 10 + u64::from(digit - b'0'));
        Some(Plain { number, decimals: decimals.len(), sign })
    }

    proptest! {
        #[test]
        fn every_shape_of_a_number_reads_as_digit_by_digit(
            before in "[0-9.,;]{0,20}",
            number in "[0-9]{0,10}([.,][0-9]{0,9})?|[0-9.,/: e+\\x00-]{0,17}|.{0,5}",
        ) {
            let text = [before.as_bytes(), number.as_bytes(), b"9"].concat();
            prop_assert_eq!(read(&text, before.len(), text.len() - 1), slowly(number.as_bytes()));
        }
    }
}
