//! What a stored value is, by the type of its column.

use parquet::data_type::Int96;

use super::column::Value;
use super::field::FieldKind;
use crate::exchange::typed_value::TypedValue;

/// A stored value as what its column says that it is.
#[inline]
pub(in crate::exchange) fn typed(kind: FieldKind, value: Value<'_>) -> TypedValue<'_> {
    match (kind, value) {
        (FieldKind::Text, Value::Bytes(text)) => TypedValue::Text(text),
        (FieldKind::Decimal(scale), Value::Int64(number)) => TypedValue::Decimal(number, scale),
        (FieldKind::Decimal(scale), Value::Int32(number)) => TypedValue::Decimal(number.into(), scale),
        (FieldKind::Decimal(scale), Value::Bytes(bytes)) => TypedValue::Large(bytes, scale),
        (FieldKind::Unsigned, Value::Int32(number)) => TypedValue::Unsigned(number.cast_unsigned().into()),
        (FieldKind::Unsigned, Value::Int64(number)) => TypedValue::Unsigned(number.cast_unsigned()),
        (FieldKind::Date, Value::Int32(days)) => TypedValue::Day(days.into()),
        (FieldKind::Time(part), Value::Int32(count)) => TypedValue::Time(count.into(), part.nanoseconds()),
        (FieldKind::Time(part), Value::Int64(count)) => TypedValue::Time(count, part.nanoseconds()),
        (FieldKind::Moment(part, is_utc), Value::Int64(count)) => {
            TypedValue::Moment(i128::from(count) * i128::from(part.nanoseconds()), is_utc)
        }
        (FieldKind::Half, Value::Bytes(bytes)) => {
            bytes.try_into().map_or(TypedValue::Bytes(bytes), |bytes| TypedValue::Float(half(bytes)))
        }
        (FieldKind::Uuid, Value::Bytes(bytes)) => TypedValue::Uuid(bytes),
        (_, Value::Int96(moment)) => TypedValue::Moment(nanoseconds(moment), false),
        (_, Value::Bytes(bytes)) => TypedValue::Bytes(bytes),
        (_, Value::Boolean(is)) => TypedValue::Boolean(is),
        (_, Value::Int32(number)) => TypedValue::Whole(number.into()),
        (_, Value::Int64(number)) => TypedValue::Whole(number),
        (_, Value::Float(number)) => TypedValue::Float(number),
        (_, Value::Double(number)) => TypedValue::Double(number),
    }
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

/// Nanoseconds since 1970-01-01 of a moment as nanoseconds of a Julian day.
fn nanoseconds(moment: Int96) -> i128 {
    let &[low, high, day] = moment.data() else { return 0 };
    let of_day = u64::from(high) << 32 | u64::from(low);
    (i128::from(day) - 2_440_588) * 86_400_000_000_000 + i128::from(of_day)
}
