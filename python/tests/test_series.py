"""Pairs, budgets and statistics, against other computations of the same."""

import itertools
import json
import random
import statistics as reference
from decimal import Decimal
from pathlib import Path

import fitcheck
import pytest

DATA = Path(__file__).parents[2] / "tests" / "data"


def test_as_many_pairs_as_trying_all_ways_finds() -> None:
    chance = random.Random(4)
    for _ in range(40):
        holes = [25_000 + chance.randrange(22) for _ in range(5)]
        shafts = [24_980 + chance.randrange(22) for _ in range(5)]
        found = fitcheck.pair([f"{size} µm" for size in holes], [f"{size} µm" for size in shafts], clearance=("0.012", 0.02))
        best = max(
            sum(12 <= hole - shaft <= 20 for hole, shaft in zip(holes, order)) for order in itertools.permutations(shafts)
        )
        assert len(found.pairs) == best
        assert all(clearance == holes[hole] - shafts[shaft] and 12 <= clearance <= 20 for hole, shaft, clearance in found.pairs)
        assert len(found.holes_left) == len(found.shafts_left) == 5 - best
    by_fit = fitcheck.pair(["25.01"], ["24.985"], fit="25 H7/g6")
    assert by_fit.pairs == [(0, 0, Decimal(25))]


def test_what_cannot_be_paired_is_named() -> None:
    with pytest.raises(fitcheck.FitcheckError, match=r"holes\[1\]"):
        fitcheck.pair([25, float("nan")], [25], clearance=(0, 1))
    for given in ({}, {"clearance": (0, 1), "fit": "25 H7/g6"}, {"clearance": (1, 0)}, {"fit": "25 H7"}):
        with pytest.raises(fitcheck.FitcheckError):
            fitcheck.pair([25], [25], **given)
    assert fitcheck.pair([], [], clearance=(0, 1)).pairs == []


def test_a_budget_is_that_of_the_command_line() -> None:
    text = (DATA / "corpus" / "inputs" / "station3.toml").read_text(encoding="utf-8")
    budget = fitcheck.budget(text, size=25)
    assert (budget.name, budget.valid_until) == ("Station 3, probe 1", "2999-01-14")
    assert (round(budget.u_um, 3), round(budget.k, 3), round(budget.expanded_um, 3)) == (0.957, 2.008, 1.922)
    assert round(budget.degrees_of_freedom, 1) == 322.2
    assert any("figures of the template" in warning for warning in budget.warnings)
    sparse = fitcheck.budget(text, size=25, touches=3, step_deg=60)
    assert (round(sparse.u_um, 3), round(sparse.expanded_um, 3)) == (1.915, 3.967)
    verdict = fitcheck.check("25 H7", "25.0205", rule="iso14253-2017", u_um=budget.rule_u_um)
    assert verdict.status == fitcheck.Status.RE_MEASURE
    for wrong in ("", "fitcheck_budget = 1", "[[contribution]"):
        with pytest.raises(fitcheck.FitcheckError):
            fitcheck.budget(wrong)
    with pytest.raises(fitcheck.FitcheckError):
        fitcheck.budget(text, size=25, touches=3)


def test_figures_are_those_of_other_computations() -> None:
    chance = random.Random(2)
    values = [round(chance.gauss(25.010, 0.002), 6) for _ in range(60)]
    found = fitcheck.statistics(values, callout="25 H7")
    assert (found.count, found.left_out, found.level) == (60, {}, 0.95)
    assert f"{float(found.figures['ppk']):.2f}" == f"{found.figures['ppk'].value:.2f}"
    mean, s = reference.mean(values), reference.stdev(values)
    ranges = [abs(one - other) for one, other in itertools.pairwise(values)]
    within = reference.mean(ranges) / 1.128_379_167
    figures = found.figures
    assert figures["mean_mm"].value == pytest.approx(mean, rel=1e-12)
    assert figures["sd_mm"].value == pytest.approx(s, rel=1e-9)
    assert figures["ppk"].value == pytest.approx(min(25.021 - mean, mean - 25) / (3 * s), rel=1e-6)
    assert figures["cp"].value == pytest.approx(0.021 / (6 * within), rel=1e-6)
    for figure in figures.values():
        if figure.lower is not None:
            assert figure.lower <= figure.value <= figure.upper
        assert (figure.value is None) == bool(figure.reason)
    assert found.outside == (sum(value < 25 for value in values), sum(value > 25.021 for value in values))
    by_limits = fitcheck.statistics(values, lower=25, upper="25.021")
    assert by_limits.figures["ppk"].value == figures["ppk"].value
    assert json.dumps(found.rules) and all(isinstance(advice, str) for advice in found.advice)


def test_doubtful_values_are_left_out_and_counted() -> None:
    found = fitcheck.statistics(["25.01", "25.012", "0.985", "25.011"], callout="25 H7")
    assert (found.count, found.left_out) == (3, {"doubtful": 1})


def test_what_is_no_series_is_refused() -> None:
    for given in ({"callout": "25 H7", "lower": 1}, {"level": 1}, {"level": float("nan")}, {"group": 0}, {"callout": "x"}):
        with pytest.raises(fitcheck.FitcheckError):
            fitcheck.statistics(["25.01", "25.012"], **given)
    with pytest.raises(fitcheck.FitcheckError, match=r"values\[1\]"):
        fitcheck.statistics(["25.01", None])
    few = fitcheck.statistics(["25.01"], callout="25 H7")
    assert few.count == 1 and few.figures["ppk" if "ppk" in few.figures else "cpk"].reason
