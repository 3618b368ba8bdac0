//! Whole nanometres as decimal figures, three at a time.

/// Appends a number of nanometres in a unit of `one` of them, which has three or six decimals; zeros at the end go, but at
/// least `least` decimals stay.
#[inline]
pub(super) fn put(nm: i64, one: u64, least: usize, out: &mut Vec<u8>) {
    if nm < 0 {
        out.push(b'-');
    }
    let magnitude = nm.unsigned_abs();
    put_whole(magnitude / one, out);
    let part = magnitude % one;
    let (first, second) = if one == 1_000 { (part, 0) } else { (part / 1_000, part % 1_000) };
    if least == 0 && part == 0 {
        return;
    }
    out.push(b'.');
    // Either three figures are followed by others, or some of the three are not needed.
    if second == 0 && least <= 3 {
        put_trimmed(first, least, out);
    } else {
        out.extend_from_slice(&figures(first));
        put_trimmed(second, least.saturating_sub(3), out);
    }
}

/// Appends a whole number.
#[inline]
fn put_whole(number: u64, out: &mut Vec<u8>) {
    if number < 1_000 {
        put_leading(number, out);
    } else if number < 1_000_000 {
        put_leading(number / 1_000, out);
        out.extend_from_slice(&figures(number % 1_000));
    } else {
        out.extend_from_slice(number.to_string().as_bytes());
    }
}

/// Appends a number below a thousand.
#[inline]
fn put_leading(number: u64, out: &mut Vec<u8>) {
    let [hundreds, tens, ones] = figures(number);
    if 100 <= number {
        out.extend_from_slice(&[hundreds, tens, ones]);
    } else if 10 <= number {
        out.extend_from_slice(&[tens, ones]);
    } else {
        out.push(ones);
    }
}

/// Appends three decimals without the zeros at their end, but at least so many.
#[inline]
fn put_trimmed(number: u64, least: usize, out: &mut Vec<u8>) {
    let [tenths, hundredths, thousandths] = figures(number);
    if 3 <= least || thousandths != b'0' {
        out.extend_from_slice(&[tenths, hundredths, thousandths]);
    } else if 2 <= least || hundredths != b'0' {
        out.extend_from_slice(&[tenths, hundredths]);
    } else if 1 <= least || tenths != b'0' {
        out.push(tenths);
    }
}

/// The three figures of a number below a thousand.
#[inline]
fn figures(number: u64) -> [u8; 3] {
    usize::try_from(number).ok().and_then(|number| FIGURES.get(number)).copied().unwrap_or_default()
}

static FIGURES: [[u8; 3]; 1_000] = {
    let mut all = [[b'0'; 3]; 1_000];
    let mut rest = all.as_mut_slice();
    let mut figures = *b"000";
    while let [first, others @ ..] = rest {
        *first = figures;
        figures = after(figures);
        rest = others;
    }
    all
};

/// The next number; 000 after 999.
const fn after([hundreds, tens, ones]: [u8; 3]) -> [u8; 3] {
    match (hundreds, tens, ones) {
        (b'9', b'9', b'9') => *b"000",
        (_, b'9', b'9') => [hundreds + 1, b'0', b'0'],
        (_, _, b'9') => [hundreds, tens + 1, b'0'],
        _ => [hundreds, tens, ones + 1],
    }
}
