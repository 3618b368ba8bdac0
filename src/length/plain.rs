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

/// The most bytes that such a number has.
const LONGEST: usize = 16;

/// The most figures before the sign.
const MOST_WHOLE: usize = 9;

/// How many bytes are read in one step.
const STEP: usize = 8;

/// Reads the bytes of a text from `start` to `end`: one to nine figures, and others behind a point or a comma. `None` for
/// anything else. What stands before them in the text may be read, too.
#[expect(
    clippy::inline_always,
    reason = "a number and a sign are given back in registers, twice for each of millions of rows"
)]
#[inline(always)]
pub(super) fn read(text: &[u8], start: usize, end: usize) -> Option<Plain> {
    let length = end.checked_sub(start)?;
    let last = end.checked_sub(STEP).and_then(|first| text.get(first..)?.first_chunk::<STEP>());
    match last {
        Some(bytes) if (1..=STEP).contains(&length) => short(u64::from_le_bytes(*bytes), STEP - length),
        _ => long(text.get(start..end)?),
    }
}

/// The number in the upper bytes of a word: the first byte is the lowest, and the first `before` do not belong to it.
#[expect(clippy::inline_always, reason = "as above")]
#[inline(always)]
fn short(word: u64, before: usize) -> Option<Plain> {
    // Figures become their values, and what stands before the number counts as zeros.
    let digits = (word ^ each(b'0')) & (u64::MAX << (8 * before));
    let others = above_nine(digits);
    let Some(others) = NonZeroU64::new(others) else {
        return Some(Plain { number: value(digits), decimals: 0, sign: None });
    };
    let place = others.trailing_zeros() / 8 * 8;
    let sign = word >> place & 0xff;
    let at = usize::try_from(place / 8).ok()?;
    // Only one byte is no figure, there is a figure before it, and it is a sign.
    if others.get() & (others.get() - 1) != 0 || at <= before || sign != u64::from(b'.') && sign != u64::from(b',') {
        return None;
    }
    // Without it, what stands before it moves up by one place.
    let up_to = u64::MAX << place;
    let digits = (digits & (up_to << 8)) | ((digits & !up_to) << 8);
    let sign = if sign == u64::from(b'.') { b'.' } else { b',' };
    Some(Plain { number: value(digits), decimals: STEP - 1 - at, sign: Some(sign) })
}

/// A number of any length, byte by byte.
#[inline(never)]
fn long(text: &[u8]) -> Option<Plain> {
    if LONGEST < text.len() {
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
