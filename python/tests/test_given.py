"""Numbers as Python has them: exact, or refused with a reason."""

import math
from decimal import Decimal
from fractions import Fraction

import fitcheck
import pytest


@pytest.mark.parametrize("measured", ["25.012", "25,012", " 25.012 mm ", "25012 µm", Decimal("25.012"), Decimal("2.5012E1"), 25.012])
def test_one_value_in_many_ways(measured: object) -> None:
    verdict = fitcheck.check("25 H7", measured)
    assert (verdict.status, verdict.measured, verdict.is_good) == (fitcheck.Status.GOOD, Decimal("25.012"), True)


def test_whole_numbers_and_those_of_numpy() -> None:
    numpy = pytest.importorskip("numpy")
    for whole in (25, numpy.int64(25), numpy.uint8(25)):
        assert fitcheck.check("25 H7", whole).measured == 25
    for number in (numpy.float64(25.012), numpy.float32(25.012)):
        assert fitcheck.check("25 H7", number).measured == Decimal("25.012")


@pytest.mark.parametrize(
    ("measured", "reason"),
    [
        (math.nan, "nan"),
        (math.inf, "inf"),
        (-math.inf, "inf"),
        (Decimal("NaN"), "NaN"),
        (Decimal("-Infinity"), "Infinity"),
        (None, "NoneType"),
        (True, "True"),
        (b"25", "bytes"),
        ([25], "list"),
        (Fraction(1, 3), "Fraction"),
        (0.1 + 0.2, "finer than a nanometre"),
        (10**30, "too large"),
        (2**64, "too large"),
        (Decimal("1E+30"), "too large"),
        (0, "not above 0"),
        (-25, "not above 0"),
        ("", "missing"),
        ("25.0.1", "25.0.1"),
        ("1.234,5", "1.234,5"),
        ("\ud800", "half a character"),
    ],
)
def test_what_is_no_diameter_is_refused_with_a_reason(measured: object, reason: str) -> None:
    with pytest.raises(fitcheck.FitcheckError, match="measured: ") as told:
        fitcheck.check("25 H7", measured)
    assert reason in str(told.value)
    assert told.value.code


@pytest.mark.parametrize("callout", ["", "25", "25 zz9", "4000 H7", "25 H7/g6", "\ud800", 25, None])
def test_what_is_no_callout_is_refused(callout: object) -> None:
    with pytest.raises(fitcheck.FitcheckError):
        fitcheck.limits(callout)


@pytest.mark.parametrize(
    "given",
    [
        {"rule": "iso"},
        {"rule": "iso14253-2017"},
        {"rule": "simple", "guard_um": 1},
        {"rule": "fixed"},
        {"rule": "simple", "u_um": 1, "expanded_um": 2},
        {"k": 2},
        {"rule": "simple", "u_um": 0},
        {"rule": "simple", "u_um": math.nan},
        {"rule": "simple", "u_um": 1, "k": 20},
        {"rule": "ilac-g8", "u_um": 1, "factor": 0},
        {"rule": "simple", "prover": "customer"},
        {"prover": "nobody"},
        {"feature": "bore"},
    ],
)
def test_a_rule_that_lacks_something_is_refused(given: dict) -> None:
    with pytest.raises(fitcheck.FitcheckError):
        fitcheck.check("25 H7", "25.01", **given)


@pytest.mark.parametrize("given", [{"u_um": 1.2}, {"expanded_um": 2.4}, {"expanded_um": 2.4, "k": 2}])
def test_an_uncertainty_without_a_rule_is_not_passed_over(given: dict) -> None:
    with pytest.raises(fitcheck.FitcheckError, match="give the rule that uses the uncertainty"):
        fitcheck.check("25 H7", "25.0195", **given)
    told = fitcheck.check("25 H7", "25.0195", rule="simple", **given)
    assert told.status == "GOOD"


def test_a_value_far_off_is_never_green() -> None:
    verdict = fitcheck.check("25 H7", "0.984")
    assert verdict.warnings and not verdict.is_good


def test_the_limits_alone_decide_at_the_nanometre() -> None:
    status = [fitcheck.check("25 H7", measured).status for measured in ("24.999999", "25", "25.021", "25.021001")]
    assert status == ["REWORK", "GOOD", "GOOD", "SCRAP"]
