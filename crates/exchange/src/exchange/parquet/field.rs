//! What a column of a file is: its name, its type, and how its values are read.

use parquet::basic::{ConvertedType, LogicalType, Repetition, TimeUnit, Type as Physical};
use parquet::errors::ParquetError;
use parquet::schema::types::{ColumnDescriptor, Type, TypePtr};

/// How a value is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::exchange) enum FieldKind {
    /// `true` or `false`.
    Boolean,
    Whole,
    /// A whole number whose bits are taken without a sign.
    Unsigned,
    /// A whole number with this many decimals, in any physical type.
    Decimal(usize),
    /// A binary fraction of 32 or 64 bits.
    Float,
    /// A binary fraction of 16 bits.
    Half,
    /// Days since 1970-01-01.
    Date,
    /// A time of day in parts of a second.
    Time(Part),
    /// A moment in parts of a second since 1970-01-01; with `true` in UTC, else of no zone.
    Moment(Part, bool),
    /// A moment as days and nanoseconds, as older tools write it.
    OldMoment,
    /// Characters.
    Text,
    /// A universally unique identifier.
    Uuid,
    /// Bytes without a meaning here.
    Bytes,
}

/// Parts of a second.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::exchange) enum Part {
    Milli,
    Micro,
    Nano,
}

impl Part {
    fn of(unit: TimeUnit) -> Self {
        match unit {
            TimeUnit::MILLIS => Self::Milli,
            TimeUnit::MICROS => Self::Micro,
            TimeUnit::NANOS => Self::Nano,
        }
    }

    /// How many nanoseconds it has.
    pub(super) const fn nanoseconds(self) -> i64 {
        match self {
            Self::Milli => 1_000_000,
            Self::Micro => 1_000,
            Self::Nano => 1,
        }
    }
}

/// A column of a file.
#[derive(Debug, Clone)]
pub struct Field {
    name: String,
    pub(in crate::exchange) kind: FieldKind,
    pub(super) is_optional: bool,
    pub(super) declared: TypePtr,
}

impl PartialEq for Field {
    fn eq(&self, other: &Self) -> bool {
        self.declared == other.declared
    }
}

impl Field {
    /// A column of a file; the name of a nested one is the error.
    pub(super) fn of(column: &ColumnDescriptor) -> Result<Self, String> {
        let [name] = column.path().parts() else { return Err(column.path().string()) };
        if 0 < column.max_rep_level() || 1 < column.max_def_level() {
            return Err(name.clone());
        }
        Ok(Self {
            name: name.clone(),
            kind: kind(column),
            is_optional: 0 < column.max_def_level(),
            declared: column.self_type_ptr(),
        })
    }

    /// A column of texts, empty where there is none.
    pub(in crate::exchange) fn text(name: &str) -> Result<Self, ParquetError> {
        let builder =
            Type::primitive_type_builder(name, Physical::BYTE_ARRAY).with_logical_type(Some(LogicalType::String));
        Ok(Self::new(name, FieldKind::Text, builder.with_repetition(Repetition::OPTIONAL).build()?))
    }

    /// A column of decimals of at most 18 figures; of these, `scale` are decimals.
    pub(in crate::exchange) fn decimal(name: &str, scale: u8, is_optional: bool) -> Result<Self, ParquetError> {
        let builder = Type::primitive_type_builder(name, Physical::INT64)
            .with_logical_type(Some(LogicalType::decimal(scale.into(), 18)))
            .with_precision(18)
            .with_scale(scale.into());
        let repetition = if is_optional { Repetition::OPTIONAL } else { Repetition::REQUIRED };
        let kind = FieldKind::Decimal(scale.into());
        Ok(Self::new(name, kind, builder.with_repetition(repetition).build()?))
    }

    /// A column of texts without gaps.
    pub(in crate::exchange) fn required_text(name: &str) -> Result<Self, ParquetError> {
        let builder =
            Type::primitive_type_builder(name, Physical::BYTE_ARRAY).with_logical_type(Some(LogicalType::String));
        Ok(Self::new(name, FieldKind::Text, builder.with_repetition(Repetition::REQUIRED).build()?))
    }

    /// A column of `true` and `false` without gaps.
    pub(in crate::exchange) fn boolean(name: &str) -> Result<Self, ParquetError> {
        let builder = Type::primitive_type_builder(name, Physical::BOOLEAN).with_repetition(Repetition::REQUIRED);
        Ok(Self::new(name, FieldKind::Boolean, builder.build()?))
    }

    fn new(name: &str, kind: FieldKind, declared: Type) -> Self {
        let is_optional = declared.is_optional();
        Self { name: name.to_owned(), kind, is_optional, declared: declared.into() }
    }

    pub fn name(&self) -> &str {
        &self.name
    }

    /// Whether its values are characters.
    pub(in crate::exchange) fn is_text(&self) -> bool {
        self.kind == FieldKind::Text
    }

    /// Whether its values are binary fractions, which are read as the shortest decimals that stand for them.
    pub fn is_float(&self) -> bool {
        matches!(self.kind, FieldKind::Float | FieldKind::Half)
    }

    /// Its declaration in the words of the format, such as `OPTIONAL INT64 measured (DECIMAL(18,6));`.
    pub fn declaration(&self) -> String {
        let mut text = Vec::new();
        parquet::schema::printer::print_schema(&mut text, &self.declared);
        String::from_utf8_lossy(&text).trim_end().to_owned()
    }
}

/// The columns of the answers, in the order of [`ADDED`](crate::exchange::batch::ADDED), each behind a prefix.
pub(in crate::exchange) fn added(prefix: &str) -> Result<Vec<Field>, ParquetError> {
    crate::exchange::batch::ADDED
        .into_iter()
        .map(|name| {
            let prefixed = format!("{prefix}{name}");
            match name {
                "min_mm" | "max_mm" => Field::decimal(&prefixed, 6, true),
                "deviation_um" | "remove_um" => Field::decimal(&prefixed, 3, true),
                _ => Field::text(&prefixed),
            }
        })
        .collect()
}

/// What a column's type says of its values: the newer annotation, else the older one, else the physical type.
fn kind(column: &ColumnDescriptor) -> FieldKind {
    let physical = column.physical_type();
    // The format: a scale that is not said is 0.
    let decimal = || FieldKind::Decimal(usize::try_from(column.type_scale()).unwrap_or(0));
    if physical == Physical::INT96 {
        return FieldKind::OldMoment;
    }
    if let Some(logical) = column.logical_type_ref() {
        match logical {
            LogicalType::String | LogicalType::Enum | LogicalType::Json => return FieldKind::Text,
            LogicalType::Decimal(_) => return decimal(),
            LogicalType::Integer(int) if !int.is_signed => return FieldKind::Unsigned,
            LogicalType::Date => return FieldKind::Date,
            LogicalType::Time(time) => return FieldKind::Time(Part::of(time.unit)),
            LogicalType::Timestamp(time) => return FieldKind::Moment(Part::of(time.unit), time.is_adjusted_to_u_t_c),
            LogicalType::Uuid => return FieldKind::Uuid,
            LogicalType::Float16 => return FieldKind::Half,
            _ => {}
        }
    }
    match column.converted_type() {
        ConvertedType::UTF8 | ConvertedType::ENUM | ConvertedType::JSON => FieldKind::Text,
        ConvertedType::DECIMAL => decimal(),
        ConvertedType::UINT_8 | ConvertedType::UINT_16 | ConvertedType::UINT_32 | ConvertedType::UINT_64 => {
            FieldKind::Unsigned
        }
        ConvertedType::DATE => FieldKind::Date,
        ConvertedType::TIME_MILLIS => FieldKind::Time(Part::Milli),
        ConvertedType::TIME_MICROS => FieldKind::Time(Part::Micro),
        ConvertedType::TIMESTAMP_MILLIS => FieldKind::Moment(Part::Milli, true),
        ConvertedType::TIMESTAMP_MICROS => FieldKind::Moment(Part::Micro, true),
        ConvertedType::BSON => FieldKind::Bytes,
        _ => match physical {
            Physical::BOOLEAN => FieldKind::Boolean,
            Physical::INT32 | Physical::INT64 => FieldKind::Whole,
            Physical::INT96 => FieldKind::OldMoment,
            Physical::FLOAT | Physical::DOUBLE => FieldKind::Float,
            // Older tools write texts without saying so.
            Physical::BYTE_ARRAY if column.logical_type_ref().is_none() => FieldKind::Text,
            Physical::BYTE_ARRAY | Physical::FIXED_LEN_BYTE_ARRAY => FieldKind::Bytes,
        },
    }
}
