//! `DuckDB`: table macros take the place of functions. A macro is pasted text, so its parameters bear no column's name.
//! Classes compare by bytes: a column or a database that ignores case would take h7 for H7.

use super::decimals::{InputColumns, limits, verdict, views};
use super::{CALLOUT, CLASS, Dialect, MEASURED, millimetres, quoted};

pub(super) const DIALECT: Dialect = Dialect {
    name: "duckdb",
    engine: "DuckDB 1.1 or later",
    usage: USAGE,
    begin: "begin transaction;\n",
    tables: TABLES,
    text: quoted,
    deviation: millimetres,
    rows: 1000,
    views: all_views,
    end: "\ncommit;\n",
};

const USAGE: &str = "
Load it once: duckdb fit.duckdb < fitcheck.sql

One value:
  from fitcheck_limits_of(25, 'H7');                          -- min_mm, max_mm, source, error: 25.000000 to 25.021000
  from fitcheck_verdict_of('25 H7', '24.998');                -- texts: REWORK, deviation_um -2.000, remove_um 2.000
  from fitcheck_verdict_of_typed(25, 'H7', 25.022);           -- decimals: SCRAP

Many rows, where they are: say which they are, then read the verdicts. Three equality joins, nothing is copied.
  create or replace view fitcheck_input_text as
    select part::varchar as id, callout, measured::varchar as measured from 'parts/*.parquet';
  from fitcheck_verdict_text;                                 -- id, callout, measured and the verdict
  create or replace view fitcheck_input as
    select part::varchar as id, nominal::decimal(18, 6) as nominal, class, measured::decimal(18, 6) as measured
    from 'parts/*.parquet';
  from fitcheck_verdict;                                      -- id, nominal, class, measured and the verdict
  from fitcheck_size_limits;                                  -- id, nominal, class, min_mm, max_mm, source, error
Sizes that have their limits beside them; feature is 'hole', 'shaft' or null:
  create or replace view fitcheck_input_limits as
    select part::varchar as id, lsl::decimal(18, 6) as minimum, usl::decimal(18, 6) as maximum, null::varchar as feature,
      measured::decimal(18, 6) as measured
    from 'parts/*.parquet';
  from fitcheck_verdict_limits;                               -- GOOD or OUT OF LIMITS, beyond_um

The order of the rows is not kept: order by id. A cast to decimal(18, 6) rounds: a value that is finer than a nanometre
is refused only as text. Numbers of type float or double are refused; cast them on purpose. Tried with DuckDB 1.1 and
2.0.
";

const TABLES: &str = "
create table fitcheck_source (source integer primary key, name varchar not null);
create table fitcheck_class (class varchar collate \"C\" primary key, hole boolean not null);
create table fitcheck_step (mm integer primary key, step integer not null);
create table fitcheck_limits (
  class varchar collate \"C\" not null, step integer not null, over_mm integer not null, to_mm integer not null,
  lower_mm decimal(15, 6) not null, upper_mm decimal(15, 6) not null, source integer not null,
  primary key (class, step)
);
";

const INPUTS: &str = "
create view fitcheck_input_text as
select null::varchar as id, null::varchar as callout, null::varchar as measured where false;

create view fitcheck_input as
select null::varchar as id, null::decimal(18, 6) as nominal, null::varchar as class, null::decimal(18, 6) as measured
where false;

create view fitcheck_input_limits as
select null::varchar as id, null::decimal(18, 6) as minimum, null::decimal(18, 6) as maximum, null::varchar as feature,
  null::decimal(18, 6) as measured
where false;
";

fn text(from: &str) -> String {
    format!(
        "select g.id, g.callout, g.measured,
      try_cast(regexp_extract(g.callout, '{CALLOUT}', 1) as decimal(15, 6)) as nominal_mm,
      nullif(regexp_extract(g.callout, '{CALLOUT}', 2), '') collate \"C\" as tolerance_class,
      try_cast(regexp_extract(g.measured, '{MEASURED}', 1) as decimal(15, 6)) as measured_mm
    from {from} g"
    )
}

/// A number of whole nanometres, or null: a cast that changed the value has rounded it, and a float has been rounded before.
fn exact(column: &str) -> String {
    format!(
        "case when (typeof(g.{column}) like 'DECIMAL%' or typeof(g.{column}) like '%INT%')
        and try_cast(g.{column} as decimal(15, 6)) = g.{column} then try_cast(g.{column} as decimal(15, 6)) end"
    )
}

fn stated() -> String {
    let [minimum, maximum, measured] = ["minimum", "maximum", "measured"].map(exact);
    format!(
        "select g.id, g.minimum, g.maximum, g.feature, g.measured,
      {minimum} as minimum_mm,
      {maximum} as maximum_mm,
      nullif(g.feature, '') collate \"C\" as side,
      {measured} as measured_mm
    from fitcheck_input_limits g"
    )
}

fn typed(from: &str) -> String {
    format!(
        "select g.id, g.nominal, g.class, g.measured,
      {} as nominal_mm,
      (case when regexp_matches(g.class, '{CLASS}') then g.class end) collate \"C\" as tolerance_class,
      {} as measured_mm
    from {from} g",
        exact("nominal"),
        exact("measured")
    )
}

fn all_views() -> String {
    let of_text = text("(select null as id, given_callout::varchar as callout, given_measured::varchar as measured)");
    let of_typed = |measured: &str| {
        typed(&format!(
            "(select null as id, given_nominal as nominal, given_class::varchar as class, {measured} as measured)"
        ))
    };
    format!(
        "{INPUTS}{}
create macro fitcheck_limits_of(given_nominal, given_class) as table
{};

create macro fitcheck_verdict_of(given_callout, given_measured) as table
{};

create macro fitcheck_verdict_of_typed(given_nominal, given_class, given_measured) as table
{};
",
        views(&text("fitcheck_input_text"), &typed("fitcheck_input"), &stated(), ""),
        limits(InputColumns::Arguments, &of_typed("null::decimal(15, 6)"), ""),
        verdict(InputColumns::Arguments, &of_text, ""),
        verdict(InputColumns::Arguments, &of_typed("given_measured"), "")
    )
}
