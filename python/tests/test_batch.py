"""Tables: every row has the verdict of a check, whatever holds the table."""

import random
import threading
from collections.abc import Iterator
from datetime import UTC, datetime
from decimal import Decimal

import duckdb
import fitcheck
import pandas
import polars
import pyarrow
import pytest


def rows(count: int, seed: int = 1) -> dict[str, list]:
    chance = random.Random(seed)
    callouts = ["25 H7", "25 g6", "30 H8", "50 p6", "12 ±0.02", "10m", "25 zz9", "", None]
    made = [(chance.choice(callouts), round(25 + chance.randrange(-300_000, 300_000) / 1_000_000, 6)) for _ in range(count)]
    return {"callout": [callout for callout, _ in made], "measured": [measured for _, measured in made]}


@pytest.fixture(scope="module")
def table() -> pyarrow.Table:
    return pyarrow.table(rows(20_000))


def judged(table: object, **how: object) -> list[dict]:
    return pyarrow.table(fitcheck.batch(table, **how)).to_pylist()


def test_every_row_has_the_verdict_of_a_check(table: pyarrow.Table) -> None:
    given = table.to_pylist()
    answers = judged(table)
    assert len(answers) == len(given)
    for row, answer in zip(given, answers):
        assert {name: answer[name] for name in row} == row
        try:
            verdict = fitcheck.check(row["callout"] or "", row["measured"])
        except fitcheck.FitcheckError:
            assert answer["status"] is None and answer["error"]
            continue
        assert answer["status"] == verdict.status
        assert (answer["min_mm"], answer["max_mm"]) == (verdict.minimum, verdict.maximum)
        assert answer["deviation_um"] == verdict.deviation_um
        assert answer["remove_um"] == verdict.remove_um
        assert (answer["doubt"] is not None) == bool(verdict.warnings)
        assert answer["error"] is None


def test_every_type_of_column_gives_the_same_answers(table: pyarrow.Table) -> None:
    wanted = [answer["status"] for answer in judged(table)]
    texts, numbers = table["callout"], table["measured"]
    decimals = pyarrow.array([Decimal(str(number)) for number in numbers.to_pylist()], pyarrow.decimal128(12, 6))
    for callout in (texts, texts.dictionary_encode(), texts.cast("large_string"), texts.cast(pyarrow.string_view())):
        for measured in (numbers, decimals, decimals.cast(pyarrow.decimal256(40, 6)), numbers.cast("string")):
            other = pyarrow.table({"callout": callout, "measured": measured})
            assert [answer["status"] for answer in judged(other)] == wanted, (callout.type, measured.type)


def test_numbers_of_every_type_are_lengths() -> None:
    whole = [7, 8, 9, None]
    wanted = [answer["status"] for answer in judged(pyarrow.table({"callout": ["8 H7"] * 4, "measured": ["7", "8", "9", None]}))]
    assert wanted == ["REWORK", "GOOD", "SCRAP", None]
    kinds = [f"{sign}int{bits}" for sign in ("", "u") for bits in (8, 16, 32, 64)] + ["float32", "float64", "halffloat"]
    columns = [pyarrow.array(whole, getattr(pyarrow, kind.replace("halffloat", "float16"))()) for kind in kinds]
    tens = [None if number is None else Decimal(number) for number in whole]
    for kind in (pyarrow.decimal32(9, 3), pyarrow.decimal64(18, 6), pyarrow.decimal128(38, 0), pyarrow.decimal256(76, 30)):
        columns.append(pyarrow.array(tens, kind))
    for column in columns:
        assert [answer["status"] for answer in judged(pyarrow.table({"callout": ["8 H7"] * 4, "measured": column}))] == wanted, column.type
    hundreds = pyarrow.array([Decimal(100), Decimal(200)], pyarrow.decimal128(5, -2))
    answers = judged(pyarrow.table({"callout": ["100 H7", "200 H7"], "measured": hundreds}))
    assert [answer["status"] for answer in answers] == ["GOOD", "GOOD"]


def test_columns_that_are_no_lengths_go_through_unchanged() -> None:
    moment = datetime(2026, 12, 1, 10, 30, tzinfo=UTC)
    columns = {"callout": ["25 H7"], "measured": [25.01]}
    for unit in ("s", "ms", "us", "ns"):
        columns[f"moment_{unit}"] = pyarrow.array([moment], pyarrow.timestamp(unit, "UTC"))
        columns[f"local_{unit}"] = pyarrow.array([moment.replace(tzinfo=None)], pyarrow.timestamp(unit))
    columns |= {"day": pyarrow.array([moment.date()], pyarrow.date32()), "day_64": pyarrow.array([moment.date()], pyarrow.date64())}
    for kind in (pyarrow.time32("s"), pyarrow.time32("ms"), pyarrow.time64("us"), pyarrow.time64("ns")):
        columns[f"time_{kind}"] = pyarrow.array([moment.time()], kind)
    for kind in (pyarrow.binary(), pyarrow.large_binary(), pyarrow.binary_view(), pyarrow.binary(2)):
        columns[f"bytes_{kind}"] = pyarrow.array([b"ab"], kind)
    # Beyond what nanoseconds in 64 bits can say.
    columns["far"] = pyarrow.array([2**61], pyarrow.timestamp("s"))
    table = pyarrow.table(columns)
    answers = pyarrow.table(fitcheck.batch(table))
    assert answers.select(table.column_names).equals(table) and answers["status"].to_pylist() == ["GOOD"]


def test_whoever_speaks_arrow_may_ask(table: pyarrow.Table) -> None:
    wanted = [answer["status"] for answer in judged(table)]
    assert [answer["status"] for answer in judged(polars.from_arrow(table))] == wanted
    assert [answer["status"] for answer in judged(table.to_pandas())] == wanted
    assert [answer["status"] for answer in judged(duckdb.from_arrow(table))] == wanted
    assert [answer["status"] for answer in judged(table.combine_chunks().to_batches()[0])] == wanted
    assert polars.DataFrame(fitcheck.batch(table))["status"].to_list() == wanted


def test_a_stream_comes_as_it_is_asked_for_however_it_is_cut(table: pyarrow.Table) -> None:
    wanted = judged(table)
    batches = table.to_batches(max_chunksize=7)
    empty = batches[0].slice(0, 0)
    stream = pyarrow.RecordBatchReader.from_batches(table.schema, [empty, *batches, empty])
    assert judged(stream) == wanted


def test_counts_and_notes_are_of_all_rows(table: pyarrow.Table) -> None:
    asked = fitcheck.batch(table)
    answers = pyarrow.table(asked).to_pylist()
    for status in fitcheck.Status:
        assert asked.counts[status] == sum(answer["status"] == status for answer in answers)
    assert asked.refused == sum(answer["status"] is None for answer in answers)
    row, reason = asked.notes[0]
    assert answers[row]["error"] == reason
    assert asked.doubtful == sum(answer["doubt"] is not None for answer in answers)
    with pytest.raises(fitcheck.FitcheckError, match="read once"):
        pyarrow.table(asked)


def test_counts_of_some_rows_are_not_given_for_those_of_all(table: pyarrow.Table) -> None:
    asked = fitcheck.batch(table)
    for name in ("counts", "refused", "doubtful", "simulated", "notes"):
        with pytest.raises(fitcheck.FitcheckError, match="not read to their end"):
            getattr(asked, name)
    reader = pyarrow.RecordBatchReader.from_stream(asked)
    reader.read_next_batch()
    with pytest.raises(fitcheck.FitcheckError, match="not read to their end"):
        asked.counts


def test_a_stream_that_breaks_off_has_no_counts(table: pyarrow.Table) -> None:
    def broken() -> Iterator[pyarrow.RecordBatch]:
        yield from table.to_batches(max_chunksize=1000)[:15]
        raise OSError("the disk went away")

    asked = fitcheck.batch(pyarrow.RecordBatchReader.from_batches(table.schema, broken()))
    reader = pyarrow.RecordBatchReader.from_stream(asked)
    with pytest.raises(Exception, match="the disk went away"):
        reader.read_all()
    # Whoever goes on after the error finds no rows, and no counts that look like those of all.
    with pytest.raises(StopIteration):
        reader.read_next_batch()
    with pytest.raises(fitcheck.FitcheckError, match="not read to their end"):
        asked.counts


def test_columns_may_be_named() -> None:
    table = pyarrow.table({"Passung": ["25 H7"], "A": [25.5], "Wert": [25.01]})
    assert judged(table, callout="Passung", measured="Wert")[0]["status"] == "GOOD"
    with pytest.raises(fitcheck.FitcheckError, match="no column .x.; its columns are Passung, A, Wert"):
        fitcheck.batch(table, callout="Passung", measured="x")
    again = pyarrow.table(fitcheck.batch(pyarrow.table({"callout": ["25 H7"], "measured": [25.01]})))
    with pytest.raises(fitcheck.FitcheckError, match="prefix="):
        fitcheck.batch(again)
    assert pyarrow.table(fitcheck.batch(again, prefix="my_"))["my_status"].to_pylist() == ["GOOD"]


@pytest.mark.parametrize(
    "table",
    [
        None,
        3,
        "25 H7",
        polars.DataFrame(),
        polars.DataFrame({"a": ["x"], "b": ["y"]}),
        polars.DataFrame({"callout": ["25 H7"], "measured": [[25.0]]}),
        pyarrow.table({"callout": [{"a": "25 H7"}], "measured": [25.0]}),
    ],
)
def test_what_is_no_table_of_measurements_is_refused(table: object) -> None:
    with pytest.raises(fitcheck.FitcheckError):
        pyarrow.table(fitcheck.batch(table))


def test_a_table_whose_callouts_are_not_known_is_refused_and_says_which_column_may_have_them() -> None:
    table = polars.DataFrame({"Pezzo": ["P1", "P2"], "Quota": ["25 H7", "30 g6"], "Valore misurato": ["25,01", "29,99"]})
    with pytest.raises(fitcheck.FitcheckError) as refused:
        fitcheck.batch(table)
    for word in ("2 (Quota) looks as if it had callouts", "Pezzo, Quota, Valore misurato", "callout="):
        assert word in str(refused.value)
    assert [answer["status"] for answer in judged(table, callout="Quota")] == ["GOOD", "GOOD"]
    with pytest.raises(fitcheck.FitcheckError, match="measured="):
        fitcheck.batch(polars.DataFrame({"callout": ["25 H7"], "a": [1.0], "b": [2.0]}))
    with pytest.raises(fitcheck.FitcheckError, match="no column is known to have callouts"):
        fitcheck.batch(polars.DataFrame({"id": ["a"], "measured": [25.0]}))


def test_a_table_without_rows_has_none() -> None:
    none = polars.DataFrame(schema={"callout": polars.String, "measured": polars.Float64})
    assert judged(none) == []


def test_numbers_that_are_none_have_no_verdict() -> None:
    values = [float("nan"), float("inf"), None, 0.0, -1.0, 0.1 + 0.2]
    answers = judged(polars.DataFrame({"callout": ["25 H7"] * len(values), "measured": values}))
    assert [answer["status"] for answer in answers] == [None] * len(values)
    assert all(answer["error"] for answer in answers)
    large = pyarrow.table({"callout": ["25 H7"], "measured": pyarrow.array([Decimal(10) ** 60], pyarrow.decimal256(70, 2))})
    assert judged(large)[0]["error"]
    beyond = pyarrow.table({"callout": ["25 H7"], "measured": pyarrow.array([2**64 - 1], pyarrow.uint64())})
    assert judged(beyond)[0]["error"]


def test_a_million_categories_are_read() -> None:
    count = 1_000_000
    names = pyarrow.array([f"{1 + number % 3000} H7" for number in range(count)]).dictionary_encode()
    keys = pyarrow.DictionaryArray.from_arrays(pyarrow.array(range(count), pyarrow.int32()), names.dictionary.take(names.indices))
    answers = pyarrow.table(fitcheck.batch(pyarrow.table({"callout": keys, "measured": pyarrow.nulls(count, pyarrow.float64())})))
    assert answers.num_rows == count and answers["status"].null_count == count


def test_threads_may_ask_at_the_same_time(table: pyarrow.Table) -> None:
    wanted = judged(table)
    found: list[bool] = []
    asking = [threading.Thread(target=lambda: found.append(judged(table) == wanted)) for _ in range(4)]
    for thread in asking:
        thread.start()
    for thread in asking:
        thread.join()
    assert found == [True] * 4


def test_a_frame_of_pandas_keeps_its_own_columns() -> None:
    frame = pandas.DataFrame({"part": [1, 2], "callout": ["25 H7", "25 H7"], "measured": [25.01, 25.03]})
    answers = pyarrow.table(fitcheck.batch(frame)).to_pandas()
    assert list(answers.columns[:3]) == ["part", "callout", "measured"]
    assert list(answers["status"]) == ["GOOD", "SCRAP"]
