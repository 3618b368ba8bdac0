"""One function an engine: loads the SQL, lets it judge the rows, writes the answers ordered by id.

Each takes the SQL, the files of rows (text form, typed form, and the rows of `narrow`), and the folder for its answers.
"""

import csv
import subprocess
import time
from pathlib import Path

ANSWER = "min_mm, max_mm, deviation_um, status, remove_um, error"
OF_LIMITS = "status, beyond_um, remove_um, error"


def timed(what, run):
    before = time.monotonic()
    run()
    print(f"    {what}: {time.monotonic() - before:.1f} s", flush=True)


# A class of the other case, where the column ignores case.
CASES = [("1", "25 H7", "H7"), ("2", "25 h7", "h7"), ("3", "25 Hh7", "Hh7")]


def case_matters(ask):
    """Whatever a column says about case, H7 is a hole and h7 a shaft."""
    for view in ("fitcheck_verdict_text", "fitcheck_verdict"):
        found = ask(view)
        assert found == [("GOOD", None), ("REWORK", None), (None, "callout-not-read")], (view, found)


def sqlite(sql, texts, typed, narrow, folder):
    import sqlite3

    from rows import nm

    database = Path(folder, "engine.sqlite")
    database.unlink(missing_ok=True)
    db = sqlite3.connect(database, isolation_level=None)
    db.executescript(Path(sql).read_text(encoding="utf-8"))
    db.execute("pragma synchronous = off")
    db.execute("create table rows_text (id integer primary key, callout text, measured text)")
    db.execute("create table rows_narrow (id integer primary key, callout text, measured text)")
    db.execute("create table rows_typed (id integer primary key, nominal_nm integer, class text, measured_nm integer)")

    def load():
        number = lambda text: nm(text) if text else None  # noqa: E731
        db.execute("begin")
        for path in texts:
            with open(path, encoding="utf-8", newline="") as file:
                db.executemany("insert into rows_text values (?, ?, ?)", csv.reader(file))
        for path in typed:
            with open(path, encoding="utf-8", newline="") as file:
                rows = ((i, number(nominal), cls, number(value)) for i, nominal, cls, value in csv.reader(file))
                db.executemany("insert into rows_typed values (?, ?, ?, ?)", rows)
        db.executemany("insert into rows_narrow values (?, ?, ?)", ((at, c, m) for at, (c, m, _) in enumerate(narrow)))
        db.execute("commit")

    def judge(name, view, source, columns):
        db.execute(f"drop view {source}")
        db.execute(f"create view {source} as select {columns} from {name}")
        with Path(folder, f"sqlite_{name}.csv").open("w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file, lineterminator="\n")
            last = db.execute(f"select coalesce(max(id), 0) from {name}").fetchone()[0]
            # In parts, because materialized steps of millions of rows fill the memory.
            for start in range(0, last + 1, 500_000):
                db.execute(f"drop view {source}")
                db.execute(f"create view {source} as select {columns} from {name} where id >= {start} and id < {start + 500_000}")
                writer.writerows(db.execute(f"select id, {ANSWER} from {view} order by id"))

    timed("load", load)
    timed("text", lambda: judge("rows_text", "fitcheck_verdict_text", "fitcheck_input_text", "id, callout, measured"))
    timed("typed", lambda: judge("rows_typed", "fitcheck_verdict", "fitcheck_input", "id, nominal_nm, class, measured_nm"))
    judge("rows_narrow", "fitcheck_verdict_text", "fitcheck_input_text", "id, callout, measured")
    db.execute("create table rows_limits (id integer primary key, minimum_nm integer, maximum_nm integer, feature text, measured_nm integer)")
    with Path(folder, "limits.csv").open(encoding="utf-8", newline="") as file:
        number = lambda text: nm(text) if text else None  # noqa: E731
        given = ((at, number(low), number(high), feature, number(value)) for at, low, high, feature, value in csv.reader(file))
        db.executemany("insert into rows_limits values (?, ?, ?, ?, ?)", given)
    db.execute("drop view fitcheck_input_limits")
    db.execute("create view fitcheck_input_limits as select * from rows_limits")
    with Path(folder, "sqlite_rows_limits.csv").open("w", newline="", encoding="utf-8") as file:
        csv.writer(file, lineterminator="\n").writerows(db.execute(f"select id, {OF_LIMITS} from fitcheck_verdict_limits order by id"))
    db.execute("create table cases (id, callout text collate nocase, class text collate nocase)")
    db.executemany("insert into cases values (?, ?, ?)", CASES)
    db.execute("drop view fitcheck_input_text")
    db.execute("create view fitcheck_input_text as select id, callout, '25.01' as measured from cases")
    db.execute("drop view fitcheck_input")
    db.execute("create view fitcheck_input as select id, 25000000 as nominal_nm, class, 25010000 as measured_nm from cases")
    case_matters(lambda view: db.execute(f"select status, error from {view} order by id").fetchall())
    refuses_reals = "select typeof(measured), error from fitcheck_verdict_text"
    db.execute("drop view fitcheck_input_text")
    db.execute("create view fitcheck_input_text as select 1 as id, '25 H7' as callout, 25.01 as measured")
    assert db.execute(refuses_reals).fetchall() == [("real", "measured-not-read")]
    db.close()
    return sqlite3.sqlite_version


def duckdb(sql, texts, typed, narrow, folder):
    import duckdb as engine

    database = Path(folder, "engine.duckdb")
    database.unlink(missing_ok=True)
    db = engine.connect(str(database))
    db.execute("set threads = 2")
    db.execute(f"set temp_directory = '{folder}/duckdb'")
    db.execute(Path(sql).read_text(encoding="utf-8"))
    files = lambda paths: "[" + ", ".join(f"'{path}'" for path in paths) + "]"  # noqa: E731
    csv_of = lambda paths, names: (f"read_csv({files(paths)}, header = false, auto_detect = false, delim = ',', quote = '\"', "  # noqa: E731
                                   f"escape = '\"', columns = {names})")
    text = csv_of(texts, "{'id': 'VARCHAR', 'callout': 'VARCHAR', 'measured': 'VARCHAR'}")
    number = csv_of(typed, "{'id': 'VARCHAR', 'nominal': 'DECIMAL(18,6)', 'class': 'VARCHAR', 'measured': 'DECIMAL(18,6)'}")
    db.execute(f"create or replace view fitcheck_input_text as select id, callout, measured from {text}")
    db.execute(f"create or replace view fitcheck_input as select id, nominal, class, measured from {number}")

    def judge(name, view):
        out = Path(folder, f"duckdb_{name}.csv")
        db.execute(f"copy (select cast(id as bigint) as id, {ANSWER} from {view} order by 1) to '{out}' (header false)")

    timed("text", lambda: judge("rows_text", "fitcheck_verdict_text"))
    timed("typed", lambda: judge("rows_typed", "fitcheck_verdict"))
    db.execute("create table narrow (id varchar, callout varchar, measured varchar)")
    db.executemany("insert into narrow values (?, ?, ?)", [(str(at), c, m) for at, (c, m, _) in enumerate(narrow)])
    db.execute("create or replace view fitcheck_input_text as select id, callout, measured from narrow")
    judge("rows_narrow", "fitcheck_verdict_text")
    number = csv_of([Path(folder, "limits.csv")], "{'id': 'VARCHAR', 'minimum': 'DECIMAL(18,6)', 'maximum': 'DECIMAL(18,6)', "
                    "'feature': 'VARCHAR', 'measured': 'DECIMAL(18,6)'}")
    db.execute(f"create or replace view fitcheck_input_limits as select * from {number}")
    out = Path(folder, "duckdb_rows_limits.csv")
    db.execute(f"copy (select cast(id as bigint) as id, {OF_LIMITS} from fitcheck_verdict_limits order by 1) to '{out}' (header false)")
    macros(db)
    db.execute("create table cases (id varchar, callout varchar collate nocase, class varchar collate nocase)")
    db.executemany("insert into cases values (?, ?, ?)", CASES)
    db.execute("create or replace view fitcheck_input_text as select id, callout, '25.01' as measured from cases")
    db.execute("create or replace view fitcheck_input as select id, 25::decimal(18, 6) as nominal, class, 25.01::decimal(18, 6) as measured from cases")
    case_matters(lambda view: db.execute(f"select status, error from {view} order by id").fetchall())
    db.close()
    return engine.__version__


def macros(db):
    """The macros of single values give what the views give."""
    ask = lambda query: db.execute(query).fetchall()  # noqa: E731
    assert ask("select min_mm::varchar, max_mm::varchar, error from fitcheck_limits_of(25, 'H7')") == [("25.000000", "25.021000", None)]
    assert ask("select status, remove_um::varchar from fitcheck_verdict_of('25 H7', '24.998')") == [("REWORK", "2.000")]
    assert ask("select status from fitcheck_verdict_of_typed(25, 'H7', 25.022)") == [("SCRAP",)]
    assert ask("select status, error from fitcheck_verdict_of_typed(25, 'H7', 25.0::double)") == [(None, "measured-not-read")]
    assert ask("select status, error from fitcheck_verdict_of_typed(25, 'H7', 25.0000001)") == [(None, "measured-not-read")]
    assert ask("select status, error from fitcheck_verdict_of_typed(25.0000001, 'H7', 25)") == [(None, "callout-not-read")]
    assert ask("select status, error from fitcheck_verdict_of_typed(25, 'H7', '25')") == [(None, "measured-not-read")]
    assert ask("select error from fitcheck_limits_of(12345678901234, 'H7')") == [("callout-not-read",)]


def psql(*commands, **options):
    steps = [part for command in commands for part in ("-c", command)]
    return subprocess.run(["psql", "-qXAt", "-v", "ON_ERROR_STOP=1", *steps], check=True, capture_output=True, text=True, **options).stdout


def postgres(sql, texts, typed, narrow, folder):
    schema = "fitcheck_compare"
    path = f"set search_path = {schema}"
    psql(f"drop schema if exists {schema} cascade", f"create schema {schema}")
    subprocess.run(["psql", "-qX", "-v", "ON_ERROR_STOP=1", "-c", path, "-f", sql], check=True, stdout=subprocess.DEVNULL)
    psql(path, "create table rows_text (id bigint, callout text, measured text)",
         "create table rows_typed (id bigint, nominal numeric, class text, measured numeric)",
         "create table rows_narrow (id bigint, callout text, measured text)")

    def load():
        for name, paths in (("rows_text", texts), ("rows_typed", typed)):
            for file in paths:
                psql(path, f"\\copy {name} from '{file}' csv")
            psql(path, f"analyze {name}")

    # A zero byte cannot be in a text of PostgreSQL.
    kept = [(at, c, m) for at, (c, m, _) in enumerate(narrow) if "\0" not in (c or "") + (m or "")]
    odd = Path(folder, "narrow.csv")
    with odd.open("w", newline="", encoding="utf-8") as file:
        for at, *cells in kept:
            quoted = ['"' + cell.replace('"', '""') + '"' if cell is not None else "" for cell in cells]
            file.write(",".join([str(at), *quoted]) + "\n")
    psql(path, f"\\copy rows_narrow from '{odd}' csv")

    def judge(name, view, source, columns):
        out = Path(folder, f"postgres_{name}.csv")
        psql(path, f"create or replace view {source} as select {columns} from {name}",
             f"\\copy (select id::bigint, {ANSWER} from {view} order by id::bigint) to '{out}' csv")

    timed("load", load)
    text = "id::text as id, callout, measured"
    timed("text", lambda: judge("rows_text", "fitcheck_verdict_text", "fitcheck_input_text", text))
    timed("typed", lambda: judge("rows_typed", "fitcheck_verdict", "fitcheck_input", "id::text as id, nominal, class, measured"))
    judge("rows_narrow", "fitcheck_verdict_text", "fitcheck_input_text", text)
    limits, out = Path(folder, "limits.csv"), Path(folder, "postgres_rows_limits.csv")
    psql(path, "create table rows_limits (id bigint, minimum numeric, maximum numeric, feature text, measured numeric)",
         f"\\copy rows_limits from '{limits}' (format csv)",
         "create or replace view fitcheck_input_limits as select id::text as id, minimum, maximum, feature, measured from rows_limits")
    psql(path, f"\\copy (select id::bigint as id, {OF_LIMITS} from fitcheck_verdict_limits order by 1) to '{out}' (format csv)")
    functions(path)
    cases = ", ".join(f"('{at}', '{callout}', '{cls}')" for at, callout, cls in CASES)
    psql(path, f"create table cases as select * from (values {cases}) v (id, callout, class)",
         "create or replace view fitcheck_input_text as select id, callout, '25.01'::text as measured from cases",
         "create or replace view fitcheck_input as select id, 25::numeric as nominal, class, 25.01::numeric as measured from cases")
    fields = lambda line: tuple(cell or None for cell in line.split("|"))  # noqa: E731
    case_matters(lambda view: [fields(line) for line in psql(path, f"select status, error from {view} order by id").splitlines()])
    version = psql("show server_version").strip()
    psql(f"drop schema {schema} cascade")
    return version


def functions(path):
    """The functions of single values give what the views give, for a sample of rows."""
    columns = "(min_mm, max_mm, deviation_um, status, remove_um, error)"
    for view, call in (("fitcheck_verdict_text", "fitcheck_verdict_of(v.callout, v.measured)"),
                       ("fitcheck_verdict", "fitcheck_verdict_of(v.nominal, v.class, v.measured)")):
        source = "rows_text" if view.endswith("text") else "rows_typed"
        sample = f"(select * from {view} where id::bigint % 997 = 0)"
        differ = f"select count(*) from {sample} v, {call} f where {columns.replace('(', '(v.').replace(', ', ', v.')} is distinct from {columns.replace('(', '(f.').replace(', ', ', f.')}"
        both = psql(path, f"select count(*) from {source} where id % 997 = 0", differ).split()
        assert both[1:] == ["0"], both
        print(f"    {call.split('(')[0]}: {both[0]} rows, {both[1]} differ", flush=True)
    for bad in ("'NaN'", "'Infinity'", "'-Infinity'", "25.0000001", "1e9", "null"):
        answer = psql(path, f"select coalesce(status, '-'), error from fitcheck_verdict_of(25, 'H7', {bad}::numeric)").strip()
        assert answer == "-|measured-not-read", (bad, answer)
        answer = psql(path, f"select coalesce(min_mm::text, '-'), error from fitcheck_limits_of({bad}::numeric, 'H7')").strip()
        assert answer == "-|callout-not-read", (bad, answer)


def spark(sql, texts, typed, narrow, folder):
    from pyspark.sql import SparkSession

    session = (SparkSession.builder.master("local[2]").appName("fitcheck").config("spark.ui.enabled", "false")
               .config("spark.driver.memory", "3g").config("spark.sql.shuffle.partitions", "4")
               .config("spark.sql.warehouse.dir", f"{folder}/spark").getOrCreate())
    session.sparkContext.setLogLevel("ERROR")
    try:
        text = Path(sql).read_text(encoding="utf-8")
        code = "\n".join(line for line in text.splitlines() if not line.startswith("--"))
        timed("load", lambda: [session.sql(statement) for statement in code.split(";\n") if statement.strip()])
        session.read.csv(list(map(str, texts)), schema="id string, callout string, measured string",
                         ignoreLeadingWhiteSpace=False, ignoreTrailingWhiteSpace=False).createOrReplaceTempView("rows_text")
        session.read.csv(list(map(str, typed)), schema="id string, nominal decimal(18,6), class string, measured decimal(18,6)",
                         ignoreLeadingWhiteSpace=False, ignoreTrailingWhiteSpace=False).createOrReplaceTempView("rows_typed")
        odd = [(str(at), c, m) for at, (c, m, _) in enumerate(narrow)]
        session.createDataFrame(odd, "id string, callout string, measured string").createOrReplaceTempView("rows_narrow")

        def judge(name, view, source, columns, answer=ANSWER):
            # A temporary view hides the stored one of this name only within its session, so the views are asked by their text.
            session.sql(f"select {columns} from {name}").createOrReplaceTempView("given")
            query = session.sql(f"show create table {view}").collect()[0][0]
            body = query[query.index(" AS ") + 4:] if " AS " in query else query[query.index("\nAS ") + 4:]
            answers = session.sql(body.replace(source + " g", "given g"))
            chosen = answers.selectExpr("cast(id as bigint) as id", *[column.strip() for column in answer.split(",")]).orderBy("id")
            with Path(folder, f"spark_{name}.csv").open("w", newline="", encoding="utf-8") as file:
                writer = csv.writer(file, lineterminator="\n")
                writer.writerows(chosen.toLocalIterator(prefetchPartitions=True))

        timed("text", lambda: judge("rows_text", "fitcheck_verdict_text", "fitcheck_input_text", "id, callout, measured"))
        timed("typed", lambda: judge("rows_typed", "fitcheck_verdict", "fitcheck_input", "id, nominal, class, measured"))
        judge("rows_narrow", "fitcheck_verdict_text", "fitcheck_input_text", "id, callout, measured")
        schema = "id string, minimum decimal(18,6), maximum decimal(18,6), feature string, measured decimal(18,6)"
        session.read.csv(str(Path(folder, "limits.csv")), schema=schema).createOrReplaceTempView("rows_limits")
        judge("rows_limits", "fitcheck_verdict_limits", "fitcheck_input_limits", "*", OF_LIMITS)
        return session.version
    finally:
        session.stop()


ENGINES = {"sqlite": sqlite, "duckdb": duckdb, "postgres": postgres, "spark": spark}
