"""What `fitcheck` says about the rows: lines `id,min_mm,max_mm,deviation_um,status,remove_um,error`.

The errors of `import` are sentences; `code` puts them to the SQL's codes. `import` looks at the measured value first, `check`
at the callout and its limits: a row with a bad measured value is asked again with a good one, and the first reason is that
of `check`.
"""

import csv
import subprocess
from pathlib import Path

# import reads at most this many rows of a file.
MOST = 400_000


CODES = ("callout-not-read", "nominal-not-positive", "class-unknown", "no-limits-at-size", "measured-not-read",
         "measured-not-positive")


def code(error):
    if error in CODES:
        return error
    if error.startswith("measured: a diameter of"):
        return "measured-not-positive"
    if error.startswith("measured:"):
        return "measured-not-read"
    if error.startswith(("callout: nominal size", "nominal size")) and error.endswith("is not above 0"):
        return "nominal-not-positive"
    if error.startswith("callout:") or error == "not judged: no callout given":
        return "callout-not-read"
    if "is not an ISO 286 tolerance class" in error or " is a grade: " in error or " is not in table " in error or " does not have it; the " in error:
        return "class-unknown"
    if "is beyond ISO 286" in error or "is beyond table" in error or " is not defined at " in error or " is not defined over " in error:
        return "no-limits-at-size"
    raise ValueError(f"unknown error: {error}")


def padded(figure, places):
    if not figure:
        return ""
    whole, _, part = figure.partition(".")
    return f"{whole}.{part.ljust(places, '0')}"


def asked(program, rows, folder, options, by_batch):
    """One answer for each row (callout, measured), in their order."""
    path = Path(folder, "asked.csv")
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, delimiter=";")
        writer.writerow(["id", "callout", "measured"])
        writer.writerows((number, callout, measured) for number, (callout, measured) in enumerate(rows))
    if by_batch:
        out = Path(folder, "answered.csv")
        subprocess.run([program, "batch", path, "-o", out, *options], check=False, stderr=subprocess.DEVNULL)
        stream, process = out.open(encoding="utf-8", newline=""), None
        delimiter = ";"
    else:
        command = [program, "import", "--format", "csv", "--time", "2026-01-01T00:00", path, *options]
        process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, encoding="utf-8")
        stream, delimiter = process.stdout, ","
    reader = csv.reader(stream, delimiter=delimiter)
    names = next(reader)
    places = [names.index(name) for name in ("min_mm", "max_mm", "deviation_um", "status", "remove_um", "error")]
    count = 0
    for answer in reader:
        low, high, deviation, status, remove, error = (answer[place] for place in places)
        count += 1
        if error:
            yield f",,,,,{code(error)}"
        else:
            yield f"{padded(low, 6)},{padded(high, 6)},{padded(deviation, 3)},{status},{padded(remove, 3)},"
    stream.close()
    if process:
        process.wait()
    assert count == len(rows), f"{count} answers to {len(rows)} rows"


def answers(program, rows, folder, options, by_batch):
    """The answers to a chunk of at most MOST rows."""
    first = list(asked(program, rows, folder, options, by_batch))
    again = [at for at, answer in enumerate(first) if answer.endswith(("measured-not-read", "measured-not-positive"))]
    if again:
        second = asked(program, [(rows[at][0], "1") for at in again], folder, options, by_batch)
        for at, answer in zip(again, list(second)):
            if answer.startswith(",,"):
                first[at] = answer
    return first


def by_limits(program, rows, folder):
    """What `import` says of rows (minimum, maximum, feature, measured): lines `status,remove_um`, where it judges."""
    path = Path(folder, "stated.csv")
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, delimiter=";")
        writer.writerow(["id", "lower limit", "upper limit", "kind", "measured"])
        writer.writerows((number, *row) for number, row in enumerate(rows))
    command = [program, "import", "--format", "csv", "--time", "2026-01-01T00:00", path]
    said = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, encoding="utf-8", check=False).stdout
    return [f"{row['status']},{padded(row['remove_um'], 3)}" for row in csv.DictReader(said.splitlines())]


def by_check(program, callout, measured, options):
    """What `fitcheck check` itself says: a status or a code."""
    command = [program, "check", "--measured", measured, *options, "--", callout]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    # Of a doubted value the exit code says nothing but that.
    status = {0: "GOOD", 10: "REWORK", 11: "SCRAP"}.get(run.returncode) or run.stdout.partition("FIT STATUS: ")[2].split("\n")[0]
    if status:
        return status
    assert run.returncode == 1, run
    said = run.stderr.splitlines()[-1].removeprefix("fitcheck: ")
    if said.startswith("measured value: "):
        return "measured-not-positive" if said.endswith(" is not above 0") else "measured-not-read"
    said = said.removeprefix(f"{callout.strip() or 'callout'}: ")
    try:
        return code(said)
    except ValueError:
        return code(f"callout: {said}")
