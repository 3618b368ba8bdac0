//! Spark SQL: views only, because stored functions are newer than many clusters.
//!
//! In Java `$` also matches before a last line end, so the whole match is compared with the text. No literal holds a
//! backslash or a quotation mark, which a setting of the session reads in two ways.

use super::decimals::views;
use super::{CALLOUT, CLASS, Dialect, MEASURED, millimetres};

pub(super) const DIALECT: Dialect = Dialect {
    name: "spark",
    engine: "Spark 3.2 or later",
    usage: USAGE,
    begin: "",
    tables: TABLES,
    text: literal,
    deviation: millimetres,
    rows: 8000,
    views: || format!("{INPUTS}{}", views(&text(), &typed(), &stated(), "")),
    end: "",
};

const USAGE: &str = "
Load it once, in a schema of the catalog of your lake: spark-sql -f fitcheck.sql

Say which rows are to be judged, where they are, then read the verdicts. Three equality joins with small tables that
Spark broadcasts; nothing is copied.
  create or replace view fitcheck_input_text as
    select cast(part as string) as id, callout, cast(measured as string) as measured from lake.parts;
  select * from fitcheck_verdict_text;                        -- id, callout, measured and the verdict
  create or replace view fitcheck_input as
    select cast(part as string) as id, cast(nominal as decimal(18, 6)) as nominal, class,
      cast(measured as decimal(18, 6)) as measured from lake.parts;
  select * from fitcheck_verdict;                             -- id, nominal, class, measured and the verdict
  select * from fitcheck_size_limits;                         -- id, nominal, class, min_mm, max_mm, source, error
Sizes that have their limits beside them; feature is 'hole', 'shaft' or null:
  create or replace view fitcheck_input_limits as
    select cast(part as string) as id, cast(lsl as decimal(18, 6)) as minimum, cast(usl as decimal(18, 6)) as maximum,
      cast(null as string) as feature, cast(measured as decimal(18, 6)) as measured from lake.parts;
  select * from fitcheck_verdict_limits;                      -- GOOD or OUT OF LIMITS, beyond_um
One value is an input of one row:
  create or replace view fitcheck_input_text as select '1' as id, '25 H7' as callout, '24.998' as measured;
  select * from fitcheck_verdict_text;                        -- REWORK, deviation_um -2.000, remove_um 2.000

A cast to decimal(18, 6) rounds: a value that is finer than a nanometre is refused only as text. Spark 4 takes a
double that is the nearest one to whole nanometres and refuses others; Spark 3 takes none. Tried with Spark 3.5 and 4.3.
";

const TABLES: &str = "
create table fitcheck_source (source int, name string) using parquet;
create table fitcheck_class (class string, hole boolean) using parquet;
create table fitcheck_step (mm int, step int) using parquet;
create table fitcheck_limits (
  class string, step int, over_mm int, to_mm int, lower_mm decimal(15, 6), upper_mm decimal(15, 6), source int
) using parquet;
";

const INPUTS: &str = "
create view fitcheck_input_text as
select cast(null as string) as id, cast(null as string) as callout, cast(null as string) as measured where false;

create view fitcheck_input as
select cast(null as string) as id, cast(null as decimal(18, 6)) as nominal, cast(null as string) as class,
  cast(null as decimal(18, 6)) as measured
where false;

create view fitcheck_input_limits as
select cast(null as string) as id, cast(null as decimal(18, 6)) as minimum, cast(null as decimal(18, 6)) as maximum,
  cast(null as string) as feature, cast(null as decimal(18, 6)) as measured
where false;
";

/// A literal without a quotation mark or a backslash in it: these are put in by their numbers.
fn literal(text: &str) -> String {
    let special = |c: char| c == '\'' || c == '\\';
    if !text.contains(special) {
        return format!("'{text}'");
    }
    let parts: Vec<String> = text
        .split_inclusive(special)
        .flat_map(|part| {
            let plain = part.trim_end_matches(special);
            let last = part.chars().next_back().filter(|c| special(*c));
            let number = last.map(|c| format!("char({})", u32::from(c)));
            [(!plain.is_empty()).then(|| format!("'{plain}'")), number].into_iter().flatten()
        })
        .collect();
    format!("concat({})", parts.join(", "))
}

fn text() -> String {
    format!(
        "select g.id, g.callout, g.measured,
      try_cast(case when regexp_extract(g.callout, '{CALLOUT}', 0) = g.callout
        then regexp_extract(g.callout, '{CALLOUT}', 1) end as decimal(15, 6)) as nominal_mm,
      case when regexp_extract(g.callout, '{CALLOUT}', 0) = g.callout
        then nullif(regexp_extract(g.callout, '{CALLOUT}', 2), '') end as tolerance_class,
      try_cast(case when regexp_extract(g.measured, '{MEASURED}', 0) = g.measured
        then regexp_extract(g.measured, '{MEASURED}', 1) end as decimal(15, 6)) as measured_mm
    from fitcheck_input_text g"
    )
}

/// A number of whole nanometres, or null.
fn exact(column: &str) -> String {
    format!(
        "case when try_cast(g.{column} as decimal(15, 6)) = g.{column} then try_cast(g.{column} as decimal(15, 6)) end"
    )
}

fn stated() -> String {
    let [minimum, maximum, measured] = ["minimum", "maximum", "measured"].map(exact);
    format!(
        "select g.id, g.minimum, g.maximum, g.feature, g.measured,
      {minimum} as minimum_mm,
      {maximum} as maximum_mm,
      nullif(g.feature, '') as side,
      {measured} as measured_mm
    from fitcheck_input_limits g"
    )
}

fn typed() -> String {
    format!(
        "select g.id, g.nominal, g.class, g.measured,
      {} as nominal_mm,
      case when regexp_extract(g.class, '{CLASS}', 0) = g.class then nullif(g.class, '') end as tolerance_class,
      {} as measured_mm
    from fitcheck_input g",
        exact("nominal"),
        exact("measured")
    )
}

#[cfg(test)]
mod tests {
    use super::literal;

    #[test]
    fn a_literal_holds_neither_quotation_mark_nor_backslash() {
        assert_eq!(literal("ISO 286"), "'ISO 286'");
        assert_eq!(literal("a'b\\"), "concat('a', char(39), 'b', char(92))");
        assert_eq!(literal("''"), "concat(char(39), char(39))");
    }
}
