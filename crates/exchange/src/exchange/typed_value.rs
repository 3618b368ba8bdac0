//! A value of a column with types, as the text that it would have in CSV.

use std::io::Write as _;

use fitcheck_core::length::{Length, Window};
use fitcheck_core::text::Within as _;
use jiff::Timestamp;
use jiff::civil::{Date, Time};
use jiff::tz::TimeZone;

/// A value whose type its column states, as in Parquet and Arrow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TypedValue<'a> {
    /// `true` or `false`.
    Boolean(bool),
    /// A whole number.
    Whole(i64),
    /// A whole number without a sign.
    Unsigned(u64),
    /// A whole number with this many decimals.
    Decimal(i64, usize),
    /// The same with up to 38 figures.
    Long(i128, usize),
    /// The same of any size: two's complement, the largest byte first.
    Large(&'a [u8], usize),
    /// A binary fraction of 32 bits.
    Float(f32),
    /// A binary fraction of 64 bits.
    Double(f64),
    /// Days since 1970-01-01.
    Day(i64),
    /// A time of day: a count, and how many nanoseconds each of it has.
    Time(i64, i64),
    /// Nanoseconds since 1970-01-01; with `true` in UTC, else of no zone.
    Moment(i128, bool),
    /// Characters in UTF-8.
    Text(&'a [u8]),
    /// A universally unique identifier.
    Uuid(&'a [u8]),
    /// Bytes without a meaning here.
    Bytes(&'a [u8]),
}

impl<'a> TypedValue<'a> {
    /// Appends its text. A binary fraction is written as the shortest decimal that stands for it and no other.
    #[inline]
    pub fn put(self, out: &mut Vec<u8>) {
        match self {
            Self::Text(text) => out.extend_from_slice(text),
            Self::Decimal(number, scale) => put_short(number, scale, out),
            Self::Double(number) => put_double(number, out),
            other => other.put_other(out),
        }
    }

    /// Its bytes, where it has as many as it likes.
    #[inline]
    pub(super) const fn bytes(self) -> Option<&'a [u8]> {
        match self {
            Self::Text(bytes) | Self::Bytes(bytes) | Self::Uuid(bytes) | Self::Large(bytes, _) => Some(bytes),
            _ => None,
        }
    }

    fn put_other(self, out: &mut Vec<u8>) {
        // Writing to memory does not fail.
        let _written = match self {
            Self::Boolean(is) => write!(out, "{is}"),
            Self::Whole(number) => write!(out, "{number}"),
            Self::Unsigned(number) => write!(out, "{number}"),
            Self::Float(number) => write!(out, "{number}"),
            Self::Day(days) => match day(days) {
                Some(date) => write!(out, "{date}"),
                None => write!(out, "{days}"),
            },
            Self::Time(count, nanoseconds) => put_time(count, nanoseconds, out),
            Self::Moment(nanoseconds, is_utc) => put_moment(nanoseconds, is_utc, out),
            Self::Uuid(bytes) => bytes.iter().enumerate().try_for_each(|(at, byte)| {
                let hyphen = if matches!(at, 4 | 6 | 8 | 10) { "-" } else { "" };
                write!(out, "{hyphen}{byte:02x}")
            }),
            Self::Bytes(bytes) => bytes.iter().try_for_each(|byte| write!(out, "{byte:02x}")),
            Self::Long(number, scale) => {
                put_decimal(number, scale, out);
                Ok(())
            }
            Self::Large(bytes, scale) => {
                put_large(bytes, scale, out);
                Ok(())
            }
            // As above.
            Self::Text(_) | Self::Decimal(..) | Self::Double(_) => {
                self.put(out);
                Ok(())
            }
        };
    }
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

/// A day; `None` outside the years that can be written.
fn day(days: i64) -> Option<Date> {
    let seconds = days.checked_mul(86_400)?;
    Some(TimeZone::UTC.to_datetime(Timestamp::from_second(seconds).ok()?).date())
}

fn put_time(count: i64, nanoseconds: i64, out: &mut Vec<u8>) -> std::io::Result<()> {
    let nanoseconds = i128::from(count) * i128::from(nanoseconds);
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
