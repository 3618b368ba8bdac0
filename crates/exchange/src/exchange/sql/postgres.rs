//! `PostgreSQL`: `numeric` is exact at any scale. Classes compare by bytes, whatever the database's language.

use super::decimals::{InputColumns, limits, verdict, views};
use super::{CALLOUT, CLASS, Dialect, MEASURED, millimetres, quoted};

pub(super) const DIALECT: Dialect = Dialect {
    name: "postgres",
    engine: "PostgreSQL 12 or later",
    usage: USAGE,
    begin: "begin;\nset local client_encoding to 'UTF8';\n",
    tables: TABLES,
    text: quoted,
    deviation: millimetres,
    rows: 1000,
    views: all_views,
    end: "\nanalyze fitcheck_source, fitcheck_class, fitcheck_step, fitcheck_limits;\ncommit;\n",
};

const USAGE: &str = "
Load it once, if you like into a schema of its own that stays in the search_path:
  psql -v ON_ERROR_STOP=1 -f fitcheck.sql

One value:
  select * from fitcheck_limits_of(25, 'H7');                 -- min_mm, max_mm, source, error: 25.000000 to 25.021000
  select * from fitcheck_verdict_of('25 H7', '24.998');       -- texts: REWORK, deviation_um -2.000, remove_um 2.000
  select * from fitcheck_verdict_of(25, 'H7', 25.022);        -- numeric: SCRAP

Many rows, where they are: say which they are, then read the verdicts. Three equality joins, nothing is copied.
  create or replace view fitcheck_input_text as select part::text as id, callout::text, measured::text from parts;
  select * from fitcheck_verdict_text;                        -- id, callout, measured and the verdict
  create or replace view fitcheck_input as
    select part::text as id, nominal::numeric, class::text, measured::numeric from parts;
  select * from fitcheck_verdict;                             -- id, nominal, class, measured and the verdict
  select * from fitcheck_size_limits;                         -- id, nominal, class, min_mm, max_mm, source, error
Sizes that have their limits beside them; feature is 'hole', 'shaft' or null:
  create or replace view fitcheck_input_limits as
    select part::text as id, lsl::numeric as minimum, usl::numeric as maximum, null::text as feature,
      measured::numeric from parts;
  select * from fitcheck_verdict_limits;                      -- GOOD or OUT OF LIMITS, beyond_um

A numeric that is finer than a nanometre is refused, as are NaN and infinity. A cast of double precision to numeric
rounds to 15 figures: keep measured values as numeric or text. Tried with PostgreSQL 15.
";

const TABLES: &str = "
create table fitcheck_source (source integer primary key, name text not null);
create table fitcheck_class (class text collate \"C\" primary key, hole boolean not null);
create table fitcheck_step (mm integer primary key, step integer not null);
create table fitcheck_limits (
  class text collate \"C\" not null, step integer not null, over_mm integer not null, to_mm integer not null,
  lower_mm numeric(15, 6) not null, upper_mm numeric(15, 6) not null, source integer not null,
  primary key (class, step)
);
";

const INPUTS: &str = "
create view fitcheck_input_text as
select null::text as id, null::text as callout, null::text as measured where false;

create view fitcheck_input as
select null::text as id, null::numeric as nominal, null::text as class, null::numeric as measured where false;

create view fitcheck_input_limits as
select null::text as id, null::numeric as minimum, null::numeric as maximum, null::text as feature,
  null::numeric as measured
where false;
";

/// Keeps the planner from pasting an expression into every place that uses it.
const FENCE: &str = "\n    offset 0";

/// Groups of a regular expression are slow here: the text is matched as a whole, and cut before its first letter.
fn text(from: &str) -> String {
    format!(
        "select g.id, g.callout, g.measured,
      case when g.is_callout then cast(left(g.callout, length(g.callout) - length(g.rest)) as numeric(15, 6)) end
        as nominal_mm,
      case when g.is_callout then rtrim(g.rest, ' ') end collate \"C\" as tolerance_class,
      case when g.measured collate \"C\" ~ '{MEASURED}' then cast(g.measured as numeric(15, 6)) end as measured_mm
    from (
      select id, callout, measured, callout collate \"C\" ~ '{CALLOUT}' as is_callout,
        ltrim(callout, ' -.0123456789') as rest
      from {from}
    ) g{FENCE}"
    )
}

/// A number of whole nanometres, or null.
fn exact(column: &str) -> String {
    format!(
        "case when abs(g.{column}) < 1000000000 and round(g.{column}, 6) = g.{column} \
         then cast(g.{column} as numeric(15, 6)) end"
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
    from fitcheck_input_limits g{FENCE}"
    )
}

fn typed(from: &str) -> String {
    format!(
        "select g.id, g.nominal, g.class, g.measured,
      {} as nominal_mm,
      case when g.class collate \"C\" ~ '{CLASS}' then g.class end collate \"C\" as tolerance_class,
      {} as measured_mm
    from {from} g{FENCE}",
        exact("nominal"),
        exact("measured")
    )
}

fn all_views() -> String {
    let arguments = "(select null::text as id, given_callout as callout, given_measured as measured)";
    let of_text = text(&format!("{arguments} a"));
    let of_typed = |measured: &str| {
        typed(&format!(
            "(select null::text as id, given_nominal as nominal, given_class as class, {measured} as measured)"
        ))
    };
    let judged = "returns table (min_mm numeric, max_mm numeric, deviation_um numeric, status text, remove_um numeric, \
                  error text)\nlanguage sql stable parallel safe as $$";
    format!(
        "{INPUTS}{}
create function fitcheck_limits_of(given_nominal numeric, given_class text)
returns table (min_mm numeric, max_mm numeric, source text, error text)
language sql stable parallel safe as $$
{}
$$;

create function fitcheck_verdict_of(given_callout text, given_measured text)
{judged}
{}
$$;

create function fitcheck_verdict_of(given_nominal numeric, given_class text, given_measured numeric)
{judged}
{}
$$;
",
        views(&text("fitcheck_input_text"), &typed("fitcheck_input"), &stated(), FENCE),
        limits(InputColumns::Arguments, &of_typed("null::numeric"), FENCE),
        verdict(InputColumns::Arguments, &of_text, FENCE),
        verdict(InputColumns::Arguments, &of_typed("given_measured"), FENCE)
    )
}
