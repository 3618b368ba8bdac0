//! Limits and verdict in standard SQL, for engines with exact decimals.
//!
//! A dialect reads what it is given into `nominal_mm`, `tolerance_class` and `measured_mm`, each null where it cannot be
//! read; everything behind that is the same in all of them.

/// What is kept of the input beside the answer.
#[derive(Debug, Clone, Copy)]
pub(super) enum InputColumns {
    /// A callout and a measured value as texts.
    Text,
    /// Nominal size, class and measured value.
    Typed,
    /// Nothing: the arguments of a function.
    Arguments,
}

impl InputColumns {
    /// The columns of a verdict before the answer.
    const fn columns(self) -> &'static str {
        match self {
            Self::Text => " id, callout, measured,",
            Self::Typed => " id, nominal, class, measured,",
            Self::Arguments => "",
        }
    }

    /// The same without the measured value.
    const fn of_limits(self) -> &'static str {
        match self {
            Self::Text => " id, callout,",
            Self::Typed => " id, nominal, class,",
            Self::Arguments => "",
        }
    }
}

/// The limits of what `read` gives: one row for each of its rows, refused or not.
///
/// `fence` ends each part where an engine would otherwise compute an expression again for every column that uses it.
fn looked_up(read: &str, fence: &str) -> String {
    format!(
        "select r.*, k.hole, o.name as source_name,
    r.nominal_mm + l.lower_mm as lower_limit_mm, r.nominal_mm + l.upper_mm as upper_limit_mm,
    case when r.nominal_mm is null or r.tolerance_class is null then 'callout-not-read'
      when r.nominal_mm <= 0 then 'nominal-not-positive'
      when k.class is null then 'class-unknown'
      when l.class is null then 'no-limits-at-size'
    end as limits_error
  from ({read}) r
  left join fitcheck_class k on k.class = r.tolerance_class
  left join fitcheck_step s on s.mm = cast(ceil(r.nominal_mm) as integer)
  left join fitcheck_limits l on l.class = r.tolerance_class and l.step = s.step
  left join fitcheck_source o on o.source = l.source{fence}"
    )
}

/// The limits of size alone: `min_mm`, `max_mm`, `source`, `error`.
pub(super) fn limits(given: InputColumns, read: &str, fence: &str) -> String {
    format!(
        "select{}
  case when limits_error is null then lower_limit_mm end as min_mm,
  case when limits_error is null then upper_limit_mm end as max_mm,
  case when limits_error is null then source_name end as source,
  limits_error as error
from (
  {}
) x",
        given.of_limits(),
        looked_up(read, fence)
    )
}

/// The verdict: `min_mm`, `max_mm`, `deviation_um`, `status`, `remove_um`, `error`.
pub(super) fn verdict(given: InputColumns, read: &str, fence: &str) -> String {
    format!(
        "select{}
  case when error is null then lower_limit_mm end as min_mm,
  case when error is null then upper_limit_mm end as max_mm,
  case when error is null then cast((measured_mm - nominal_mm) * 1000 as decimal(18, 3)) end as deviation_um,
  case when error is not null then null
    when measured_mm < lower_limit_mm then case when hole then 'REWORK' else 'SCRAP' end
    when upper_limit_mm < measured_mm then case when hole then 'SCRAP' else 'REWORK' end
    else 'GOOD'
  end as status,
  case when error is not null then null
    when hole and measured_mm < lower_limit_mm then cast((lower_limit_mm - measured_mm) * 1000 as decimal(18, 3))
    when not hole and upper_limit_mm < measured_mm then cast((measured_mm - upper_limit_mm) * 1000 as decimal(18, 3))
  end as remove_um,
  error
from (
  select x.*,
    case when limits_error is not null then limits_error
      when measured_mm is null then 'measured-not-read'
      when measured_mm <= 0 then 'measured-not-positive'
    end as error
  from (
  {}
  ) x{fence}
) y",
        given.columns(),
        looked_up(read, fence)
    )
}

/// The verdict by limits that the input has: `status`, `beyond_um`, `remove_um`, `error`. `read` gives `minimum_mm`, `maximum_mm`,
/// `measured_mm`, and as `side` hole, shaft or nothing.
fn by_limits(read: &str, fence: &str) -> String {
    let um = |less: &str, more: &str| format!("cast(({more} - {less}) * 1000 as decimal(18, 3))");
    format!(
        "select id, minimum, maximum, feature, measured,
  case when error is not null then null
    when minimum_mm <= measured_mm and measured_mm <= maximum_mm then 'GOOD'
    when side is null then 'OUT OF LIMITS'
    when measured_mm < minimum_mm then case side when 'hole' then 'REWORK' else 'SCRAP' end
    else case side when 'hole' then 'SCRAP' else 'REWORK' end
  end as status,
  case when error is not null then null
    when measured_mm < minimum_mm then {}
    when maximum_mm < measured_mm then {}
  end as beyond_um,
  case when error is not null then null
    when side = 'hole' and measured_mm < minimum_mm then {}
    when side = 'shaft' and maximum_mm < measured_mm then {}
  end as remove_um,
  error
from (
  select r.*,
    case when minimum_mm is null or maximum_mm is null then 'limits-not-read'
      when maximum_mm < minimum_mm then 'limits-reversed'
      when side not in ('hole', 'shaft') then 'feature-unknown'
      when measured_mm is null then 'measured-not-read'
    end as error
  from (
  {read}
  ) r{fence}
) y",
        um("minimum_mm", "measured_mm"),
        um("maximum_mm", "measured_mm"),
        um("measured_mm", "minimum_mm"),
        um("maximum_mm", "measured_mm"),
    )
}

/// The views over every form of input; `text`, `typed` and `stated` read them.
pub(super) fn views(text: &str, typed: &str, stated: &str, fence: &str) -> String {
    format!(
        "
create view fitcheck_size_limits as
{};

create view fitcheck_size_limits_text as
{};

create view fitcheck_verdict as
{};

create view fitcheck_verdict_text as
{};

create view fitcheck_verdict_limits as
{};
",
        limits(InputColumns::Typed, typed, fence),
        limits(InputColumns::Text, text, fence),
        verdict(InputColumns::Typed, typed, fence),
        verdict(InputColumns::Text, text, fence),
        by_limits(stated, fence)
    )
}
