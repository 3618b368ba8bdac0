//! The cells of a column in memory, as values with types.

use std::sync::Arc;

use arrow_array::cast::AsArray as _;
use arrow_array::types::{
    Date32Type, Decimal128Type, Float32Type, Float64Type, Int64Type, Time64NanosecondType, TimestampNanosecondType,
    UInt64Type,
};
use arrow_array::{
    Array, ArrayRef, BinaryArray, BooleanArray, Date32Array, Decimal128Array, Float32Array, Float64Array, Int64Array,
    LargeStringArray, StringArray, StringViewArray, Time64NanosecondArray, TimestampNanosecondArray, UInt64Array,
};
use arrow_cast::cast::{CastOptions, cast_with_options};
use arrow_schema::{ArrowError, DataType, TimeUnit};
use fitcheck_exchange::exchange::typed_value::TypedValue;

/// A column of some rows.
#[derive(Debug)]
pub(super) enum Cells {
    /// Of no use here: only whether there is something in a cell.
    Present(ArrayRef),
    Boolean(BooleanArray),
    Whole(Int64Array),
    Unsigned(UInt64Array),
    Float(Float32Array),
    Double(Float64Array),
    Decimal(Decimal128Array, usize),
    Day(Date32Array),
    Time(Time64NanosecondArray),
    /// Of no zone, or in UTC.
    Moment(TimestampNanosecondArray, bool),
    Text(StringArray),
    LongText(LargeStringArray),
    TextView(StringViewArray),
    Bytes(BinaryArray),
    /// For each row the place of its value; with the column of the values.
    Listed(ArrayRef, Vec<usize>, Box<Self>),
}

/// Whether a column has characters.
pub(super) fn is_text(of: &DataType) -> bool {
    match of {
        DataType::Utf8 | DataType::LargeUtf8 | DataType::Utf8View => true,
        DataType::Dictionary(_, values) => is_text(values),
        _ => false,
    }
}

/// Whether a cell may hold several values: such a column is given on, and never judged.
pub(super) fn is_nested(of: &DataType) -> bool {
    of.is_nested() && !matches!(of, DataType::Dictionary(_, values) if !values.is_nested())
}

impl Cells {
    /// The cells of a column. `is_needed` says whether more is read of it than that something is there.
    ///
    /// # Errors
    /// A value that its type does not hold.
    pub(super) fn of(column: &ArrayRef, is_needed: bool) -> Result<Self, ArrowError> {
        if !is_needed && !is_text(column.data_type()) {
            return Ok(Self::Present(Arc::clone(column)));
        }
        Ok(match column.data_type() {
            DataType::Boolean => Self::Boolean(column.as_boolean().clone()),
            DataType::Int8 | DataType::Int16 | DataType::Int32 | DataType::Int64 => {
                Self::Whole(cast(column, &DataType::Int64)?.as_primitive::<Int64Type>().clone())
            }
            DataType::UInt8 | DataType::UInt16 | DataType::UInt32 | DataType::UInt64 => {
                Self::Unsigned(cast(column, &DataType::UInt64)?.as_primitive::<UInt64Type>().clone())
            }
            DataType::Float16 | DataType::Float32 => {
                Self::Float(cast(column, &DataType::Float32)?.as_primitive::<Float32Type>().clone())
            }
            DataType::Float64 => Self::Double(column.as_primitive::<Float64Type>().clone()),
            DataType::Decimal32(_, scale)
            | DataType::Decimal64(_, scale)
            | DataType::Decimal128(_, scale)
            | DataType::Decimal256(_, scale) => Self::decimal(column, *scale)?,
            DataType::Date32 | DataType::Date64 => {
                Self::Day(cast(column, &DataType::Date32)?.as_primitive::<Date32Type>().clone())
            }
            DataType::Time32(_) | DataType::Time64(_) => {
                let nanoseconds = cast(column, &DataType::Time64(TimeUnit::Nanosecond))?;
                Self::Time(nanoseconds.as_primitive::<Time64NanosecondType>().clone())
            }
            DataType::Timestamp(_, zone) => {
                let nanoseconds = cast(column, &DataType::Timestamp(TimeUnit::Nanosecond, zone.clone()))?;
                Self::Moment(nanoseconds.as_primitive::<TimestampNanosecondType>().clone(), zone.is_some())
            }
            DataType::Utf8 => Self::Text(column.as_string::<i32>().clone()),
            DataType::LargeUtf8 => Self::LongText(column.as_string::<i64>().clone()),
            DataType::Utf8View => Self::TextView(column.as_string_view().clone()),
            DataType::Dictionary(..) => {
                let listed = column.as_any_dictionary();
                let keys = if listed.values().is_empty() { Vec::new() } else { listed.normalized_keys() };
                Self::Listed(Arc::clone(column), keys, Box::new(Self::of(listed.values(), true)?))
            }
            DataType::Binary | DataType::LargeBinary | DataType::BinaryView | DataType::FixedSizeBinary(_) => {
                Self::Bytes(cast(column, &DataType::Binary)?.as_binary::<i32>().clone())
            }
            // Nothing at all, lists and their like.
            _ => Self::Present(Arc::clone(column)),
        })
    }

    /// Whole numbers with decimals. What has more than 38 figures is no length: it is read, and refused, as text.
    fn decimal(column: &ArrayRef, scale: i8) -> Result<Self, ArrowError> {
        let decimals = scale.max(0);
        match cast(column, &DataType::Decimal128(38, decimals)) {
            Ok(numbers) => {
                let numbers = numbers.as_primitive::<Decimal128Type>().clone();
                Ok(Self::Decimal(numbers, usize::from(decimals.unsigned_abs())))
            }
            Err(_too_large) => Ok(Self::Text(cast(column, &DataType::Utf8)?.as_string::<i32>().clone())),
        }
    }

    /// The cell of a row; nothing where it is empty.
    #[inline]
    pub(super) fn get(&self, row: usize) -> Option<TypedValue<'_>> {
        Some(match self {
            Self::Present(column) if column.is_valid(row) && *column.data_type() != DataType::Null => {
                TypedValue::Boolean(true)
            }
            Self::Boolean(cells) if cells.is_valid(row) => TypedValue::Boolean(cells.value(row)),
            Self::Whole(cells) if cells.is_valid(row) => TypedValue::Whole(cells.value(row)),
            Self::Unsigned(cells) if cells.is_valid(row) => TypedValue::Unsigned(cells.value(row)),
            Self::Float(cells) if cells.is_valid(row) => TypedValue::Float(cells.value(row)),
            Self::Double(cells) if cells.is_valid(row) => TypedValue::Double(cells.value(row)),
            Self::Decimal(cells, scale) if cells.is_valid(row) => {
                let number = cells.value(row);
                match i64::try_from(number) {
                    Ok(number) => TypedValue::Decimal(number, *scale),
                    Err(_long) => TypedValue::Long(number, *scale),
                }
            }
            Self::Day(cells) if cells.is_valid(row) => TypedValue::Day(cells.value(row).into()),
            Self::Time(cells) if cells.is_valid(row) => TypedValue::Time(cells.value(row), 1),
            Self::Moment(cells, is_utc) if cells.is_valid(row) => TypedValue::Moment(cells.value(row).into(), *is_utc),
            Self::Text(cells) if cells.is_valid(row) => TypedValue::Text(cells.value(row).as_bytes()),
            Self::LongText(cells) if cells.is_valid(row) => TypedValue::Text(cells.value(row).as_bytes()),
            Self::TextView(cells) if cells.is_valid(row) => TypedValue::Text(cells.value(row).as_bytes()),
            Self::Bytes(cells) if cells.is_valid(row) => TypedValue::Bytes(cells.value(row)),
            Self::Listed(column, keys, values) if column.is_valid(row) => return values.get(*keys.get(row)?),
            _ => return None,
        })
    }
}

/// The same values in another type; a value that it does not hold is an error, and never a gap.
fn cast(column: &ArrayRef, to: &DataType) -> Result<ArrayRef, ArrowError> {
    cast_with_options(column, to, &CastOptions { safe: false, ..CastOptions::default() })
}
