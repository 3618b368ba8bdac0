//! `SQLite`: it has no decimals, so lengths are whole nanometres in integers, and texts are read figure by figure.
//!
//! It has no regular expressions and no stored functions either; `materialized` keeps it from reading a text again for
//! every column that uses it.

use fitcheck_core::length::Length;

use super::{Dialect, quoted};

pub(super) const DIALECT: Dialect = Dialect {
    name: "sqlite",
    engine: "SQLite 3.37 or later",
    usage: USAGE,
    begin: "begin;\n",
    tables: TABLES,
    text: quoted,
    deviation: nanometres,
    rows: 1000,
    views: all_views,
    end: "\ncommit;\n",
};

const USAGE: &str = "
Load it once: sqlite3 fit.sqlite < fitcheck.sql

SQLite has no decimals: deviations are whole nanometres (lower_nm, upper_nm), and min_mm, max_mm, deviation_um and
remove_um of an answer are texts with all decimals; beside them are min_nm, max_nm, deviation_nm and remove_nm.

Say which rows are to be judged, where they are, then read the verdicts. Three equality joins, nothing is copied.
  drop view fitcheck_input_text;
  create view fitcheck_input_text as select part as id, callout, measured from parts;      -- callout, measured: text
  select * from fitcheck_verdict_text;                        -- id, callout, measured and the verdict
  drop view fitcheck_input;
  create view fitcheck_input as select part as id, nominal_nm, class, measured_nm from parts;   -- integers, text
  select * from fitcheck_verdict;                             -- id, nominal_nm, class, measured_nm and the verdict
  select * from fitcheck_size_limits;                         -- id, nominal_nm, class, min_mm, max_mm, source, error
Sizes that have their limits beside them; feature is 'hole', 'shaft' or null:
  drop view fitcheck_input_limits;
  create view fitcheck_input_limits as
    select part as id, lsl_nm as minimum_nm, usl_nm as maximum_nm, null as feature, measured_nm from parts;   -- integers
  select * from fitcheck_verdict_limits;                      -- GOOD or OUT OF LIMITS, beyond_um
One value is an input of one row:
  drop view fitcheck_input_text;
  create view fitcheck_input_text as select 1 as id, '25 H7' as callout, '24.998' as measured;
  select * from fitcheck_verdict_text;                        -- REWORK, deviation_um -2.000, remove_um 2.000

Measured values that are stored as real numbers are refused. To take them, round on purpose: printf('%.6f', measured).
Of millions of rows, give some hundred thousand at a time: SQLite keeps the steps of an answer. Tried with SQLite 3.40.
";

const TABLES: &str = "
create table fitcheck_source (source integer primary key, name text not null) strict;
create table fitcheck_class (class text primary key, hole integer not null) strict, without rowid;
create table fitcheck_step (mm integer primary key, step integer not null) strict;
create table fitcheck_limits (
  class text not null, step integer not null, over_mm integer not null, to_mm integer not null,
  lower_nm integer not null, upper_nm integer not null, source integer not null,
  primary key (class, step)
) strict, without rowid;
";

const INPUTS: &str = "
create view fitcheck_input_text (id, callout, measured) as select null, null, null where false;

create view fitcheck_input (id, nominal_nm, class, measured_nm) as select null, null, null, null where false;

create view fitcheck_input_limits (id, minimum_nm, maximum_nm, feature, measured_nm) as
select null, null, null, null, null where false;
";

fn nanometres(length: Length) -> String {
    length.nanometres().to_string()
}

/// Whether a text is a class: what the regular expression of the other engines says.
const IS_CLASS: &str = "length(class) <= 8 and class glob '[A-Za-z]*' and class not glob '*[^A-Za-z0-9]*'
      and (class = upper(class) or class = lower(class)) and class not in ('F', 'M', 'C', 'V', 'f', 'm', 'c', 'v')";

/// Plain ASCII without a zero byte, so that lengths and places are those of characters; without spaces around.
fn plain(column: &str) -> String {
    format!(
        "case when typeof({column}) = 'text' and length(cast({column} as blob)) = length({column}) \
         then trim({column}, ' ') end"
    )
}

/// The nanometres of a number whose figures before and after the point are `whole` and `fraction`.
fn read_nm(name: &str) -> String {
    format!(
        "case when length({name}_whole) between 1 and 9 and {name}_whole not glob '*[^0-9]*'
      and length({name}_part) >= 1 and {name}_part not glob '*[^0-9]*' and length(rtrim({name}_part, '0')) <= 6
      then (1 - 2 * {name}_minus)
        * (cast({name}_whole as integer) * 1000000 + cast(substr({name}_part || '000000', 1, 6) as integer)) end"
    )
}

/// Splits a number into its sign and its figures before and after the point; without a point the part is one zero.
fn split(name: &str) -> (String, String) {
    let sign = format!(
        "{name} glob '-*' as {name}_minus, case when {name} glob '-*' then substr({name}, 2) else {name} end \
         as {name}_figures"
    );
    let point = format!(
        "{name}_minus,
      case instr({name}_figures, '.') when 0 then {name}_figures \
         else substr({name}_figures, 1, instr({name}_figures, '.') - 1) end as {name}_whole,
      case instr({name}_figures, '.') when 0 then '0' \
         else substr({name}_figures, instr({name}_figures, '.') + 1) end as {name}_part"
    );
    (sign, point)
}

/// `read`: the text input, read.
fn text() -> String {
    let (size_sign, size_point) = split("size");
    let (value_sign, value_point) = split("value");
    format!(
        "given as materialized (
    select id, callout, measured, {} as text, {} as value from fitcheck_input_text
  ), halves as materialized (
    select id, callout, measured, value, substr(text, 1, length(text) - length(ltrim(text, '-.0123456789'))) as size,
      ltrim(ltrim(text, '-.0123456789'), ' ') as class
    from given
  ), signs as materialized (
    select id, callout, measured, class,
      {size_sign},
      {value_sign}
    from halves
  ), points as materialized (
    select id, callout, measured, class,
      {size_point},
      {value_point}
    from signs
  ), read as materialized (
    select id, callout, measured,
      {} as nominal,
      case when {IS_CLASS} then class end as tolerance_class,
      {} as value
    from points
  )",
        plain("callout"),
        plain("measured"),
        read_nm("size"),
        read_nm("value")
    )
}

/// An integer of the range, or null.
fn whole(column: &str) -> String {
    format!(
        "case when typeof({column}) = 'integer' and {column} between -999999999999999 and 999999999999999 \
         then {column} end"
    )
}

/// The verdict by limits that the input has.
fn by_limits() -> String {
    format!(
        "
create view fitcheck_verdict_limits as
with read as materialized (
    select id, minimum_nm, maximum_nm, feature, measured_nm,
      {} as low, {} as high, nullif(feature, '') as side, {} as value
    from fitcheck_input_limits
  ), checked as materialized (
    select r.*,
      case when low is null or high is null then 'limits-not-read'
        when high < low then 'limits-reversed'
        when side not in ('hole', 'shaft') then 'feature-unknown'
        when value is null then 'measured-not-read'
      end as refused
    from read r
  ), judged as materialized (
    select c.*,
      case when refused is not null then null
        when value between low and high then 'GOOD'
        when side is null then 'OUT OF LIMITS'
        when value < low then case side when 'hole' then 'REWORK' else 'SCRAP' end
        else case side when 'hole' then 'SCRAP' else 'REWORK' end
      end as status,
      case when refused is not null then null
        when value < low then value - low
        when high < value then value - high
      end as beyond_nm,
      case when refused is not null then null
        when side = 'hole' and value < low then low - value
        when side = 'shaft' and high < value then value - high
      end as remove_nm
    from checked c
  )
select id, minimum_nm, maximum_nm, feature, measured_nm, status,
  {} as beyond_um,
  {} as remove_um,
  refused as error, beyond_nm, remove_nm
from judged;
",
        whole("minimum_nm"),
        whole("maximum_nm"),
        whole("measured_nm"),
        decimal("beyond_nm", 3),
        decimal("remove_nm", 3)
    )
}

/// `read`: the typed input, read.
fn typed() -> String {
    format!(
        "given as materialized (
    select id, nominal_nm, class as given_class, measured_nm,
      case when typeof(class) = 'text' and length(cast(class as blob)) = length(class) then class end as class
    from fitcheck_input
  ), read as materialized (
    select id, nominal_nm, given_class, measured_nm,
      {} as nominal,
      case when {IS_CLASS} then class end as tolerance_class,
      {} as value
    from given
  )",
        whole("nominal_nm"),
        whole("measured_nm")
    )
}

/// `found`: the limits of what was read.
const FOUND: &str = "found as materialized (
    select r.*, k.hole, o.name as source_name, r.nominal + l.lower_nm as lowest, r.nominal + l.upper_nm as highest,
      case when r.nominal is null or r.tolerance_class is null then 'callout-not-read'
        when r.nominal <= 0 then 'nominal-not-positive'
        when k.class is null then 'class-unknown'
        when l.class is null then 'no-limits-at-size'
      end as limits_error
    from read r
    left join fitcheck_class k on k.class = r.tolerance_class collate binary
    left join fitcheck_step s on s.mm = (r.nominal + 999999) / 1000000
    left join fitcheck_limits l on l.class = r.tolerance_class collate binary and l.step = s.step
    left join fitcheck_source o on o.source = l.source
  )";

/// `judged`: the verdict on them, in nanometres.
const JUDGED: &str = "checked as materialized (
    select f.*,
      case when limits_error is not null then limits_error
        when value is null then 'measured-not-read'
        when value <= 0 then 'measured-not-positive'
      end as refused
    from found f
  ), judged as materialized (
    select c.*,
      case when refused is null then lowest end as min_nm, case when refused is null then highest end as max_nm,
      case when refused is null then value - nominal end as deviation_nm,
      case when refused is not null then null
        when value < lowest then case when hole then 'REWORK' else 'SCRAP' end
        when highest < value then case when hole then 'SCRAP' else 'REWORK' end
        else 'GOOD'
      end as status,
      case when refused is not null then null
        when hole and value < lowest then lowest - value
        when not hole and highest < value then value - highest
      end as remove_nm
    from checked c
  )";

/// Nanometres as millimetres or micrometres with all decimals.
fn decimal(column: &str, places: u32) -> String {
    let one = 10_i64.pow(places);
    format!(
        "case when {column} is not null then printf('%s%d.%0{places}d', case when {column} < 0 then '-' else '' end, \
         abs({column}) / {one}, abs({column}) % {one}) end"
    )
}

fn limits(name: &str, columns: &str, read: &str) -> String {
    format!(
        "
create view {name} as
with {read}, {FOUND}, limited as materialized (
    select f.*, case when limits_error is null then lowest end as min_nm,
      case when limits_error is null then highest end as max_nm
    from found f
  )
select {columns},
  {} as min_mm,
  {} as max_mm,
  case when limits_error is null then source_name end as source, limits_error as error, min_nm, max_nm
from limited;
",
        decimal("min_nm", 6),
        decimal("max_nm", 6)
    )
}

fn verdict(name: &str, columns: &str, read: &str) -> String {
    format!(
        "
create view {name} as
with {read}, {FOUND}, {JUDGED}
select {columns},
  {} as min_mm,
  {} as max_mm,
  {} as deviation_um,
  status,
  {} as remove_um,
  refused as error, min_nm, max_nm, deviation_nm, remove_nm
from judged;
",
        decimal("min_nm", 6),
        decimal("max_nm", 6),
        decimal("deviation_nm", 3),
        decimal("remove_nm", 3)
    )
}

fn all_views() -> String {
    let text = text();
    let typed = typed();
    [
        INPUTS.to_owned(),
        limits("fitcheck_size_limits", "id, nominal_nm, given_class as class", &typed),
        limits("fitcheck_size_limits_text", "id, callout", &text),
        verdict("fitcheck_verdict", "id, nominal_nm, given_class as class, measured_nm", &typed),
        verdict("fitcheck_verdict_text", "id, callout, measured", &text),
        by_limits(),
    ]
    .concat()
}
