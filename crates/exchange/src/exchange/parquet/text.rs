//! A value as the text that it would have in CSV.

use std::io::Write as _;

use fitcheck_core::length::{Length, Window};
use jiff::Timestamp;
use jiff::civil::{Date, Time};
use jiff::tz::TimeZone;
use parquet::data_type::Int96;

use super::column::Value;
use super::field::{FieldKind, Part};
use fitcheck_core::text::Within as _;

/// Appends the text of a value.
#[inline]
pub(in crate::exchange) fn put(kind: FieldKind, value: Value<'_>, out: &mut Vec<u8>) {
    match (kind, value) {
        (FieldKind::Text, Value::Bytes(text)) => out.extend_from_slice(text),
        (FieldKind::Decimal(scale), Value::Int64(number)) => put_short(number, scale, out),
        (FieldKind::Decimal(scale), Value::Int32(number)) => put_short(number.into(), scale, out),
        (FieldKind::Float, Value::Double(number)) => put_double(number, out),
        _ => put_other(kind, value, out),
    }
}

fn put_other(kind: FieldKind, value: Value<'_>, out: &mut Vec<u8>) {
    // Writing to memory does not fail.
    let _written = match (kind, value) {
        (FieldKind::Unsigned, Value::Int32(number)) => write!(out, "{}", number.cast_unsigned()),
        (FieldKind::Unsigned, Value::Int64(number)) => write!(out, "{}", number.cast_unsigned()),
        (FieldKind::Date, Value::Int32(days)) => match day(days.into()) {
            Some(date) => write!(out, "{date}"),
            None => write!(out, "{days}"),
        },
        (FieldKind::Time(part), Value::Int32(count)) => put_time(count.into(), part, out),
        (FieldKind::Time(part), Value::Int64(count)) => put_time(count, part, out),
        (FieldKind::Moment(part, is_utc), Value::Int64(count)) => {
            put_moment(i128::from(count) * part.nanoseconds(), is_utc, out)
        }
        (_, Value::Int96(moment)) => put_moment(nanoseconds(moment), false, out),
        (FieldKind::Decimal(scale), Value::Bytes(bytes)) => {
            put_large(bytes, scale, out);
            Ok(())
        }
        (FieldKind::Half, Value::Bytes(bytes)) => match bytes.try_into().map(half) {
            Ok(number) => write!(out, "{number}"),
            Err(_) => put_hexadecimal(bytes, out),
        },
        (FieldKind::Uuid, Value::Bytes(bytes)) => {
            for (at, byte) in bytes.iter().enumerate() {
                let hyphen = if matches!(at, 4 | 6 | 8 | 10) { "-" } else { "" };
                let _written = write!(out, "{hyphen}{byte:02x}");
            }
            Ok(())
        }
        (_, Value::Bytes(bytes)) => put_hexadecimal(bytes, out),
        (_, Value::Boolean(is)) => write!(out, "{is}"),
        (_, Value::Int32(number)) => write!(out, "{number}"),
        (_, Value::Int64(number)) => write!(out, "{number}"),
        (_, Value::Float(number)) => write!(out, "{number}"),
        (_, Value::Double(number)) => write!(out, "{number}"),
    };
}

fn put_hexadecimal(bytes: &[u8], out: &mut Vec<u8>) -> std::io::Result<()> {
    bytes.iter().try_for_each(|byte| write!(out, "{byte:02x}"))
}

/// A number with `scale` decimals: in the way of lengths if it may be one, three figures at a time.
#[inline]
fn put_short(number: i64, scale: usize, out: &mut Vec<u8>) {
    let factor = [1_000_000, 100_000, 10_000, 1_000, 100, 10, 1].get(scale);
    let length = factor.and_then(|factor| Length::from_nanometres(number.checked_mul(*factor)?).ok());
    match length.zip(u8::try_from(scale).ok()) {
        Some((length, scale)) => put_length(length, scale, out),
        None => put_decimal(number.into(), scale, out),
    }
}

#[inline]
fn put_length(length: Length, least: u8, out: &mut Vec<u8>) {
    let mut room = [0; _];
    let mut window = Window::new(&mut room);
    length.put_mm(least, &mut window);
    out.extend_from_slice(window.bytes());
}

/// A number with `scale` decimals; behind the sixth one zeros at the end are left out, since a nanometre needs no more.
fn put_decimal(number: i128, scale: usize, out: &mut Vec<u8>) {
    if number < 0 {
        out.push(b'-');
    }
    let mut figures = [b'0'; 40];
    let mut rest = number.unsigned_abs();
    let mut first = figures.len();
    // Sixty-four bits are divided faster.
    let mut short = u64::try_from(rest).ok();
    for (at, figure) in figures.iter_mut().enumerate().rev() {
        let digit = if let Some(short) = &mut short {
            let digit = *short % 10;
            *short /= 10;
            low_byte(digit.into())
        } else {
            let digit = rest % 10;
            rest /= 10;
            short = u64::try_from(rest).ok();
            low_byte(digit)
        };
        *figure = b'0' + digit;
        first = at;
        if short == Some(0) {
            break;
        }
    }
    put_figures(figures.within(first..), scale, out);
}

/// A figure, or another number below 256, as a byte.
const fn low_byte(number: u128) -> u8 {
    let [low, ..] = number.to_le_bytes();
    low
}

/// Figures, the last `scale` of them behind a point.
fn put_figures(figures: &[u8], scale: usize, out: &mut Vec<u8>) {
    let (whole, decimals) = figures.split_at(figures.len().saturating_sub(scale));
    out.extend_from_slice(if whole.is_empty() { b"0" } else { whole });
    if scale == 0 {
        return;
    }
    out.push(b'.');
    let begin = out.len();
    out.extend(std::iter::repeat_n(b'0', scale.saturating_sub(figures.len())));
    out.extend_from_slice(decimals);
    while begin + 6 < out.len() && out.last() == Some(&b'0') {
        out.pop();
    }
}

/// A whole number of any size, the largest byte first, in two's complement.
fn put_large(bytes: &[u8], scale: usize, out: &mut Vec<u8>) {
    let is_negative = bytes.first().is_some_and(|byte| 0x80 <= *byte);
    let sign = if is_negative { 0xff } else { 0 };
    if bytes.len() <= 16 {
        let mut all = [sign; 16];
        for (to, from) in all.iter_mut().rev().zip(bytes.iter().rev()) {
            *to = *from;
        }
        return put_decimal(i128::from_be_bytes(all), scale, out);
    }
    let mut rest: Vec<u8> = bytes.iter().map(|byte| byte ^ sign).collect();
    if is_negative {
        out.push(b'-');
        for byte in rest.iter_mut().rev() {
            let (next, carries) = byte.overflowing_add(1);
            *byte = next;
            if !carries {
                break;
            }
        }
    }
    let mut figures = Vec::new();
    while rest.iter().any(|byte| *byte != 0) || figures.is_empty() {
        let mut remainder = 0_u16;
        for byte in &mut rest {
            let whole = remainder << 8 | u16::from(*byte);
            *byte = low_byte((whole / 10).into());
            remainder = whole % 10;
        }
        figures.push(b'0' + low_byte(remainder.into()));
    }
    figures.reverse();
    put_figures(&figures, scale, out);
}

/// The shortest decimal that stands for a binary fraction and no other.
fn put_double(number: f64, out: &mut Vec<u8>) {
    // Of 15 figures a binary fraction stands for one decimal only, so what gives the number back is its shortest text.
    let millionths = (number * 1e6).round();
    if millionths.abs() < 1e15 && (millionths / 1e6).to_bits() == number.to_bits() {
        #[expect(
            clippy::as_conversions,
            clippy::cast_possible_truncation,
            reason = "a whole number of at most 15 figures"
        )]
        let whole = millionths as i64;
        // Zero has a sign here.
        if whole != 0
            && let Ok(length) = Length::from_nanometres(whole)
        {
            return put_length(length, 0, out);
        }
    }
    // Writing to memory does not fail.
    let _written = write!(out, "{number}");
}

/// IEEE 754 binary16, the smaller byte first.
fn half(bytes: [u8; 2]) -> f32 {
    let bits = u16::from_le_bytes(bytes);
    let exponent = i32::from(bits >> 10 & 0x1f);
    let fraction = f32::from(bits & 0x3ff);
    let magnitude = match exponent {
        0 => fraction * 2_f32.powi(-24),
        0x1f if fraction == 0.0 => f32::INFINITY,
        0x1f => f32::NAN,
        _ => (1024.0 + fraction) * 2_f32.powi(exponent - 25),
    };
    if bits >> 15 == 1 { -magnitude } else { magnitude }
}

/// A day; `None` outside the years that can be written.
fn day(days: i64) -> Option<Date> {
    let seconds = days.checked_mul(86_400)?;
    Some(TimeZone::UTC.to_datetime(Timestamp::from_second(seconds).ok()?).date())
}

fn put_time(count: i64, part: Part, out: &mut Vec<u8>) -> std::io::Result<()> {
    let nanoseconds = i128::from(count) * part.nanoseconds();
    match i64::try_from(nanoseconds)
        .ok()
        .and_then(|all| Time::midnight().checked_add(jiff::SignedDuration::from_nanos(all)).ok())
    {
        Some(time) if 0 <= count => write!(out, "{time}"),
        _ => write!(out, "{count}"),
    }
}

fn put_moment(nanoseconds: i128, is_utc: bool, out: &mut Vec<u8>) -> std::io::Result<()> {
    match Timestamp::from_nanosecond(nanoseconds) {
        Ok(moment) if is_utc => write!(out, "{moment}"),
        Ok(moment) => write!(out, "{}", TimeZone::UTC.to_datetime(moment)),
        Err(_) => write!(out, "{nanoseconds}"),
    }
}

/// Nanoseconds since 1970-01-01 of a moment as nanoseconds of a Julian day.
fn nanoseconds(moment: Int96) -> i128 {
    let &[low, high, day] = moment.data() else { return 0 };
    let of_day = u64::from(high) << 32 | u64::from(low);
    (i128::from(day) - 2_440_588) * 86_400_000_000_000 + i128::from(of_day)
}
