"""Every call of the command line's corpus that the package covers: the recorded answer is the package's."""

import csv
import json
import shlex
from decimal import Decimal
from pathlib import Path

import fitcheck
import pytest

CORPUS = Path(__file__).parents[2] / "tests" / "data" / "corpus"
VALUES = {
    "check": {"--measured", "--feature", "--rule", "--u", "--expanded", "--k", "--factor", "--guard", "--prover", "--format"},
    "limits": {"--format"},
    "fit": {"--hole", "--shaft", "--format"},
    "circle": {"--format"},
}
EXITS = {"GOOD": 0, "REWORK": 10, "SCRAP": 11, "RE-MEASURE": 12, "OUT OF LIMITS": 13}


class Call:
    """A call with what it finds and what it said."""

    def __init__(self, name: str, words: list[str]) -> None:
        self.name, self.words = name, words
        self.input: list[str] = []
        self.files: dict[str, list[str]] = {}
        self.out: list[str] = []
        self.err: list[str] = []
        self.code = 0
        self.has_other_files = False

    @property
    def options(self) -> dict[str, str] | None:
        """Its options and their values; nothing where it uses what the package does not have."""
        known, found, places, words = VALUES[self.words[1]], {}, [], self.words[2:]
        while words:
            word = words.pop(0)
            name, sign, value = word.partition("=")
            if not word.startswith("--") or word == "--":
                if word.startswith("-") and word != "-":
                    return None
                places.append(word)
            elif name not in known or name in found or not (sign or words):
                return None
            else:
                found[name] = value if sign else words.pop(0)
        found["places"] = places
        return found


def calls() -> list[Call]:
    found: list[Call] = []
    for path in sorted(CORPUS.glob("*.txt")):
        into: list[str] | None = None
        for number, line in enumerate(path.read_text(encoding="utf-8").split("\n"), 1):
            mark, rest = line[:1], line[2:]
            if mark == "$":
                found.append(Call(f"{path.name}:{number}", shlex.split(rest)))
                into = found[-1].input
            elif not found:
                continue
            elif mark == "@":
                into = []
                found[-1].has_other_files |= "=" in rest or rest.endswith("/")
                found[-1].files[rest.strip()] = into
            elif line.startswith("<*") or mark == "<" and any("␀" <= sign <= "␟" for sign in rest):
                # Lines that are repeated, and control characters as their pictures.
                found[-1].has_other_files = True
            elif mark == "<" and into is not None:
                into.append(rest)
            elif mark == "|":
                found[-1].out.append(rest)
            elif mark == "!":
                found[-1].err.append(rest)
            elif mark == "=":
                found[-1].code = int(rest)
    return found


def of(subcommand: str) -> list:
    """The calls of a subcommand that the package covers."""
    covered = [call for call in calls() if call.words[1:2] == [subcommand]]
    covered = [call for call in covered if call.options is not None and not call.has_other_files]
    return [pytest.param(call, id=call.name) for call in covered if call.code != 2]


def reason(error: fitcheck.FitcheckError) -> str:
    """What is wrong, without what stands before it."""
    return str(error).split(": ", 1)[-1]


def told(call: Call) -> str:
    return " ".join(call.out + call.err)


def answered(call: Call) -> list[dict]:
    """The recorded answers, where they are for machines."""
    match call.options.get("--format"):
        case "json":
            answer = json.loads("\n".join(call.out), parse_float=Decimal, parse_int=Decimal)
            return answer if isinstance(answer, list) else [answer]
        case "csv":
            return list(csv.DictReader(call.out))
    return []


@pytest.mark.parametrize("call", of("limits"))
def test_limits_are_those_of_the_command_line(call: Call) -> None:
    asked = call.options["places"]
    if asked == ["-"]:
        asked = [line for line in call.input if line.strip()]
    answers = answered(call)
    if any("/" in callout and callout.count("/") == 1 and any(c.isalpha() for c in callout) for callout in asked):
        pytest.skip("a fit has two answers there")
    for callout in asked:
        try:
            limits = fitcheck.limits(callout)
        except fitcheck.FitcheckError as error:
            assert reason(error) in told(call)
            assert call.code == 1
            continue
        mine = [answer for answer in answers if answer["callout"] == callout]
        assert mine or call.options.get("--format", "text") == "text"
        for answer in mine:
            assert Decimal(answer["min_mm"]) == limits.minimum
            assert Decimal(answer["max_mm"]) == limits.maximum
            assert Decimal(answer["lower_um"]) == limits.lower_um
            assert Decimal(answer["upper_um"]) == limits.upper_um
            assert answer["source"] == limits.source
        if not mine:
            assert any(limits.source in line for line in call.out)
        for warning in limits.warnings:
            assert warning in told(call)


@pytest.mark.parametrize("call", of("check"))
def test_a_check_is_that_of_the_command_line(call: Call) -> None:
    options = dict(call.options)
    places, measured, format = options.pop("places"), options.pop("--measured", None), options.pop("--format", "text")
    if measured is None:
        pytest.skip("contacts and simulations are not in the package")
    names = {"--u": "u_um", "--expanded": "expanded_um", "--guard": "guard_um"}
    given = {names.get(name, name[2:]): value for name, value in options.items()}
    if "u_um" in given or "expanded_um" in given:
        given.setdefault("rule", "simple")
    try:
        verdict = fitcheck.check(places[0], measured, **given)
    except fitcheck.FitcheckError as error:
        assert call.code == 1 and reason(error) in told(call)
        return
    warned = " ".join(call.err)
    for warning in verdict.warnings:
        assert warning in warned
    if call.code == 14:
        assert verdict.warnings and not verdict.is_good
    else:
        assert call.code == EXITS[verdict.status]
    answer = verdict.as_dict()
    for recorded in answered(call):
        if format == "json":
            mine = json.loads(json.dumps(answer), parse_float=Decimal, parse_int=Decimal)
            assert {**mine, "time": None} == {**recorded, "time": None}
        else:
            assert recorded["status"] == verdict.status
            assert Decimal(recorded["min_mm"]) == verdict.minimum
            assert Decimal(recorded["max_mm"]) == verdict.maximum
            assert Decimal(recorded["deviation_um"]) == verdict.deviation_um
            assert (Decimal(recorded["remove_um"]) if recorded["remove_um"] else None) == verdict.remove_um


@pytest.mark.parametrize("call", of("fit"))
def test_a_fit_is_that_of_the_command_line(call: Call) -> None:
    options = call.options
    for callout in options["places"] if options["places"] != ["-"] else call.input:
        measured = {name[2:]: options[name] for name in ("--hole", "--shaft") if name in options}
        if len(measured) == 1:
            pytest.skip("one part of a fit is a check")
        try:
            fit = fitcheck.fit(callout, **measured)
        except fitcheck.FitcheckError as error:
            assert reason(error) in told(call)
            continue
        for recorded in answered(call):
            if recorded["callout"] != callout:
                continue
            assert recorded["kind"] == fit.kind
            assert Decimal(recorded["minimum_clearance_um"]) == fit.minimum_clearance_um
            assert Decimal(recorded["maximum_clearance_um"]) == fit.maximum_clearance_um


@pytest.mark.parametrize("call", of("circle"))
def test_a_circle_is_that_of_the_command_line(call: Call) -> None:
    if call.options.get("--format") != "json" or call.code != 0:
        pytest.skip("only JSON has all figures")
    lines = call.files.get(call.options["places"][0], call.input)
    rows = list(csv.DictReader(lines))
    if not rows or not {"x", "y"} <= set(rows[0]):
        pytest.skip("columns that only files have")
    found = fitcheck.circle([tuple(float(row[axis]) for axis in ("x", "y", "z") if axis in row) for row in rows])
    recorded = json.loads("\n".join(call.out))
    assert recorded["least_squares"]["diameter"] == found.least_squares.diameter
    assert recorded["least_squares"]["form"] == found.form
    assert recorded["minimum_circumscribed"]["diameter"] == found.minimum_circumscribed.diameter
    assert (recorded["minimum_zone"] or {}).get("width") == (found.minimum_zone and found.minimum_zone.width)
    assert recorded["warnings"] == found.warnings
    assert recorded["residuals"] == found.residuals


def test_the_corpus_has_calls_of_each() -> None:
    counts = {name: len(of(name)) for name in VALUES}
    assert counts["check"] > 20 and counts["limits"] > 20 and counts["fit"] > 5 and counts["circle"] > 3, counts
