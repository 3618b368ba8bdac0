//! Whole nanometres as decimal figures, three at a time.

use super::Window;

/// Appends a number of nanometres in a unit of `ONE` of them, which has three or six decimals; zeros at the end go, but at
/// least `least` decimals stay.
#[expect(clippy::inline_always, reason = "its answer stays in registers, for each of millions of rows")]
#[inline(always)]
pub(super) fn put<const ONE: u64>(nm: i64, least: u8, out: &mut Window<'_>) {
    if nm < 0 {
        out.push(b'-');
    }
    let magnitude = nm.unsigned_abs();
    put_whole(magnitude / ONE, out);
    let part = magnitude % ONE;
    let (first, second) = if ONE == 1_000 { (part, 0) } else { (part / 1_000, part % 1_000) };
    if second == 0 && least <= 3 {
        let decimals = decimals(first).max(least);
        let count = if decimals == 0 { 0 } else { 1 + decimals };
        return out.piece(pointed(first), count);
    }
    out.piece(pointed(first), 4);
    let [_, figures @ ..] = pointed(second);
    out.piece(figures, decimals(second).max(least.saturating_sub(3)).min(3));
}

/// Appends a whole number.
#[expect(clippy::inline_always, reason = "called four times for each of millions of rows")]
#[inline(always)]
fn put_whole(number: u64, out: &mut Window<'_>) {
    if let Some(&piece) = usize::try_from(number).ok().and_then(|number| LEADING.get(number)) {
        let [.., count] = piece;
        out.piece(piece, count);
    } else {
        put_large(number, out);
    }
}

/// Appends any number.
#[inline(never)]
fn put_large(number: u64, out: &mut Window<'_>) {
    if number < 1_000 {
        put_whole(number, out);
    } else if number < 1_000_000 {
        put_whole(number / 1_000, out);
        put_thousand(number % 1_000, out);
    } else {
        put_large(number / 1_000_000, out);
        put_thousand(number / 1_000 % 1_000, out);
        put_thousand(number % 1_000, out);
    }
}

/// Appends the three figures of a number below a thousand.
fn put_thousand(number: u64, out: &mut Window<'_>) {
    let [_, figures @ ..] = pointed(number);
    out.piece(figures, 3);
}

/// How many of three decimals are left without the zeros at their end.
#[inline]
const fn decimals(number: u64) -> u8 {
    if number == 0 {
        0
    } else if !number.is_multiple_of(10) {
        3
    } else if !number.is_multiple_of(100) {
        2
    } else {
        1
    }
}

/// In the place of figures that no number below a thousand has: no reader takes them for some.
const NO_FIGURES: [u8; 4] = *b".???";

/// The three figures of a number below a thousand, behind a point.
#[inline]
fn pointed(number: u64) -> [u8; 4] {
    usize::try_from(number).ok().and_then(|number| POINTED.get(number)).copied().unwrap_or(NO_FIGURES)
}

static POINTED: [[u8; 4]; 1_000] = {
    let mut all = [*b".000"; 1_000];
    let mut rest = all.as_mut_slice();
    let mut figures = *b".000";
    while let [first, others @ ..] = rest {
        *first = figures;
        figures = after(figures);
        rest = others;
    }
    all
};

/// The figures of a number below a thousand, and in the last byte how many they are.
static LEADING: [[u8; 4]; 1_000] = {
    let mut all = [[0; 4]; 1_000];
    let mut rest = all.as_mut_slice();
    let mut figures = *b".000";
    while let [first, others @ ..] = rest {
        *first = match figures {
            [_, b'0', b'0', ones] => [ones, 0, 0, 1],
            [_, b'0', tens, ones] => [tens, ones, 0, 2],
            [_, hundreds, tens, ones] => [hundreds, tens, ones, 3],
        };
        figures = after(figures);
        rest = others;
    }
    all
};

/// The next number; 000 after 999.
const fn after([point, hundreds, tens, ones]: [u8; 4]) -> [u8; 4] {
    match (hundreds, tens, ones) {
        (b'9', b'9', b'9') => *b".000",
        (_, b'9', b'9') => [point, hundreds + 1, b'0', b'0'],
        (_, _, b'9') => [point, hundreds, tens + 1, b'0'],
        _ => [point, hundreds, tens, ones + 1],
    }
}
