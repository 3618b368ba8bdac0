//! Whole numbers as packed differences (the format's `DELTA_BINARY_PACKED`): half the size of the plain encoding where
//! numbers have no order at all, next to nothing where they count up, and much faster than to pack the plain ones.

use fitcheck_core::text::long;

/// How many numbers share a smallest difference.
const BLOCK: usize = 128;

/// How many of them share a width.
const MINI: usize = 32;

/// Appends some numbers.
pub(super) fn put(numbers: &[i64], out: &mut Vec<u8>) {
    put_varint(long(BLOCK), out);
    put_varint(long(BLOCK / MINI), out);
    put_varint(long(numbers.len()), out);
    // Of no numbers, the first one is 0.
    let (first, others) = numbers.split_first().map_or((0, numbers), |(first, others)| (*first, others));
    put_varint(zigzag(first), out);
    let mut before = first;
    for block in others.chunks(BLOCK) {
        let mut differences = [0_i64; BLOCK];
        let mut least = i64::MAX;
        for (difference, number) in differences.iter_mut().zip(block) {
            // As every reader adds them up.
            *difference = number.wrapping_sub(before);
            least = least.min(*difference);
            before = *number;
        }
        put_varint(zigzag(least), out);
        let mut above = [0_u64; BLOCK];
        for (above, difference) in above.iter_mut().zip(differences).take(block.len()) {
            *above = difference.wrapping_sub(least).cast_unsigned();
        }
        let widths = out.len();
        out.extend_from_slice(&[0; BLOCK / MINI]);
        for (at, mini) in above.chunks(MINI).enumerate().take(block.len().div_ceil(MINI)) {
            let width = u64::BITS - mini.iter().fold(0, |all, one| all | one).leading_zeros();
            if let Some(place) = out.get_mut(widths + at) {
                [*place, ..] = width.to_le_bytes();
            }
            pack(mini, width, out);
        }
    }
}

/// The bits of numbers one behind the other, the lowest first.
fn pack(numbers: &[u64], width: u32, out: &mut Vec<u8>) {
    let mut waiting = 0_u128;
    let mut bits = 0;
    for number in numbers {
        waiting |= u128::from(*number) << bits;
        bits += width;
        if u64::BITS <= bits {
            out.extend(waiting.to_le_bytes().into_iter().take(size_of::<u64>()));
            waiting >>= u64::BITS;
            bits -= u64::BITS;
        }
    }
    // Thirty-two numbers fill whole bytes.
    out.extend(waiting.to_le_bytes().into_iter().zip(0..bits / 8).map(|(byte, _)| byte));
}

/// Small numbers of both signs as small ones without.
const fn zigzag(number: i64) -> u64 {
    ((number << 1) ^ (number >> 63)).cast_unsigned()
}

/// Seven bits a byte, the lowest first, with a mark on all bytes but the last.
pub(super) fn put_varint(mut number: u64, out: &mut Vec<u8>) {
    loop {
        let [low, ..] = (number & 0x7f).to_le_bytes();
        number >>= 7;
        if number == 0 {
            return out.push(low);
        }
        out.push(low | 0x80);
    }
}
