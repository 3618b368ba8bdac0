//! The cells of a column in memory, as values with types.

use std::sync::Arc;

use arrow_array::cast::AsArray as _;
use arrow_array::types::{
    Date32Type, Date64Type, Decimal32Type, Decimal64Type, Decimal128Type, Decimal256Type, Float16Type, Float32Type,
    Float64Type, Int8Type, Int16Type, Int32Type, Int64Type, Time32MillisecondType, Time32SecondType,
    Time64MicrosecondType, Time64NanosecondType, TimestampMicrosecondType, TimestampMillisecondType,
    TimestampNanosecondType, TimestampSecondType, UInt8Type, UInt16Type, UInt32Type, UInt64Type,
};
use arrow_array::{
    Array, ArrayRef, ArrowPrimitiveType, BinaryArray, BinaryViewArray, BooleanArray, Decimal128Array,
    FixedSizeBinaryArray, Float32Array, Float64Array, Int64Array, LargeBinaryArray, LargeStringArray, PrimitiveArray,
    StringArray, StringViewArray, UInt64Array,
};
use arrow_schema::{DataType, TimeUnit};
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
    /// What has more than 38 figures, or tens as its unit: read as text, as a length or to be refused.
    LongDecimal(StringArray),
    Day(Int64Array),
    /// With the nanoseconds of one.
    Time(Int64Array, i64),
    /// With the nanoseconds of one, and whether it is in UTC or of no zone.
    Moment(Int64Array, i128, bool),
    Text(StringArray),
    LongText(LargeStringArray),
    TextView(StringViewArray),
    Bytes(BinaryArray),
    LongBytes(LargeBinaryArray),
    BytesView(BinaryViewArray),
    FixedBytes(FixedSizeBinaryArray),
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
    pub(super) fn of(column: &ArrayRef, is_needed: bool) -> Self {
        if !is_needed && !is_text(column.data_type()) {
            return Self::Present(Arc::clone(column));
        }
        match column.data_type() {
            DataType::Boolean => Self::Boolean(column.as_boolean().clone()),
            DataType::Int8 => Self::Whole(wide::<Int8Type, _>(column)),
            DataType::Int16 => Self::Whole(wide::<Int16Type, _>(column)),
            DataType::Int32 => Self::Whole(wide::<Int32Type, _>(column)),
            DataType::Int64 => Self::Whole(column.as_primitive::<Int64Type>().clone()),
            DataType::UInt8 => Self::Unsigned(wide::<UInt8Type, _>(column)),
            DataType::UInt16 => Self::Unsigned(wide::<UInt16Type, _>(column)),
            DataType::UInt32 => Self::Unsigned(wide::<UInt32Type, _>(column)),
            DataType::UInt64 => Self::Unsigned(column.as_primitive::<UInt64Type>().clone()),
            DataType::Float16 => Self::Float(wide::<Float16Type, _>(column)),
            DataType::Float32 => Self::Float(column.as_primitive::<Float32Type>().clone()),
            DataType::Float64 => Self::Double(column.as_primitive::<Float64Type>().clone()),
            DataType::Decimal32(_, scale) => Self::decimal(wide::<Decimal32Type, Decimal128Type>(column), *scale),
            DataType::Decimal64(_, scale) => Self::decimal(wide::<Decimal64Type, Decimal128Type>(column), *scale),
            DataType::Decimal128(_, scale) => Self::decimal(column.as_primitive::<Decimal128Type>().clone(), *scale),
            DataType::Decimal256(_, scale) => {
                let numbers = column.as_primitive::<Decimal256Type>();
                let short = numbers.try_unary::<_, Decimal128Type, _>(|number| number.to_i128().ok_or(()));
                let long = |()| Self::LongDecimal(texts(numbers, |row| numbers.value_as_string(row)));
                short.map_or_else(long, |short| Self::decimal(short, *scale))
            }
            DataType::Date32 => Self::Day(wide::<Date32Type, _>(column)),
            DataType::Date64 => {
                Self::Day(column.as_primitive::<Date64Type>().unary(|milliseconds| milliseconds.div_euclid(86_400_000)))
            }
            DataType::Time32(TimeUnit::Second) => Self::Time(wide::<Time32SecondType, _>(column), 1_000_000_000),
            DataType::Time32(_) => Self::Time(wide::<Time32MillisecondType, _>(column), 1_000_000),
            DataType::Time64(TimeUnit::Microsecond) => Self::Time(wide::<Time64MicrosecondType, _>(column), 1_000),
            DataType::Time64(_) => Self::Time(wide::<Time64NanosecondType, _>(column), 1),
            DataType::Timestamp(unit, zone) => {
                let (moments, nanoseconds) = match unit {
                    TimeUnit::Second => (wide::<TimestampSecondType, _>(column), 1_000_000_000),
                    TimeUnit::Millisecond => (wide::<TimestampMillisecondType, _>(column), 1_000_000),
                    TimeUnit::Microsecond => (wide::<TimestampMicrosecondType, _>(column), 1_000),
                    TimeUnit::Nanosecond => (wide::<TimestampNanosecondType, _>(column), 1),
                };
                Self::Moment(moments, nanoseconds, zone.is_some())
            }
            DataType::Utf8 => Self::Text(column.as_string::<i32>().clone()),
            DataType::LargeUtf8 => Self::LongText(column.as_string::<i64>().clone()),
            DataType::Utf8View => Self::TextView(column.as_string_view().clone()),
            DataType::Dictionary(..) => {
                let listed = column.as_any_dictionary();
                let keys = if listed.values().is_empty() { Vec::new() } else { listed.normalized_keys() };
                Self::Listed(Arc::clone(column), keys, Box::new(Self::of(listed.values(), true)))
            }
            DataType::Binary => Self::Bytes(column.as_binary::<i32>().clone()),
            DataType::LargeBinary => Self::LongBytes(column.as_binary::<i64>().clone()),
            DataType::BinaryView => Self::BytesView(column.as_binary_view().clone()),
            DataType::FixedSizeBinary(_) => Self::FixedBytes(column.as_fixed_size_binary().clone()),
            // Nothing at all, lists and their like.
            _ => Self::Present(Arc::clone(column)),
        }
    }

    /// Whole numbers with decimals; with a negative scale, of tens.
    fn decimal(numbers: Decimal128Array, scale: i8) -> Self {
        let Ok(decimals) = usize::try_from(scale) else {
            let zeros = "0".repeat(scale.unsigned_abs().into());
            return Self::LongDecimal(texts(&numbers, |row| format!("{}{zeros}", numbers.value(row))));
        };
        Self::Decimal(numbers, decimals)
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
            Self::Day(cells) if cells.is_valid(row) => TypedValue::Day(cells.value(row)),
            Self::Time(cells, unit) if cells.is_valid(row) => TypedValue::Time(cells.value(row), *unit),
            Self::Moment(cells, unit, is_utc) if cells.is_valid(row) => {
                TypedValue::Moment(i128::from(cells.value(row)) * unit, *is_utc)
            }
            Self::Text(cells) | Self::LongDecimal(cells) if cells.is_valid(row) => {
                TypedValue::Text(cells.value(row).as_bytes())
            }
            Self::LongText(cells) if cells.is_valid(row) => TypedValue::Text(cells.value(row).as_bytes()),
            Self::TextView(cells) if cells.is_valid(row) => TypedValue::Text(cells.value(row).as_bytes()),
            Self::Bytes(cells) if cells.is_valid(row) => TypedValue::Bytes(cells.value(row)),
            Self::LongBytes(cells) if cells.is_valid(row) => TypedValue::Bytes(cells.value(row)),
            Self::BytesView(cells) if cells.is_valid(row) => TypedValue::Bytes(cells.value(row)),
            Self::FixedBytes(cells) if cells.is_valid(row) => TypedValue::Bytes(cells.value(row)),
            Self::Listed(column, keys, values) if column.is_valid(row) => return values.get(*keys.get(row)?),
            _ => return None,
        })
    }
}

/// The same numbers in a type that holds all of them.
fn wide<Of, To>(column: &ArrayRef) -> PrimitiveArray<To>
where
    Of: ArrowPrimitiveType,
    To: ArrowPrimitiveType,
    To::Native: From<Of::Native>,
{
    column.as_primitive::<Of>().unary(To::Native::from)
}

/// The cells as texts.
fn texts(numbers: &dyn Array, text: impl Fn(usize) -> String) -> StringArray {
    (0..numbers.len()).map(|row| numbers.is_valid(row).then(|| text(row))).collect()
}
