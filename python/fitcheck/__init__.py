"""Whether a measured hole or shaft is good, rework or scrap, and why: all of ISO 286, exact to the nanometre.

>>> import fitcheck
>>> fitcheck.limits("25 H7").maximum
Decimal('25.021')
>>> fitcheck.check("25 H7", "25.012").status
<Status.GOOD: 'GOOD'>

Lengths come in as str, Decimal, int or float, in millimetres, and go out as Decimal. A float is read as the shortest decimal that
stands for it; nothing is rounded. What cannot be answered raises FitcheckError, which says why.
"""

from enum import StrEnum

from ._fitcheck import (
    Budget,
    Circle,
    Evaluation,
    Figure,
    Fit,
    FitcheckError,
    Limits,
    Pairing,
    Ring,
    Rows,
    Statistics,
    TwoPoint,
    Verdict,
    batch,
    budget,
    check,
    circle,
    fit,
    limits,
    pair,
    statistics,
)

__all__ = [
    "Budget",
    "Circle",
    "Evaluation",
    "Figure",
    "Fit",
    "FitcheckError",
    "Limits",
    "Pairing",
    "Ring",
    "Rows",
    "Statistics",
    "Status",
    "TwoPoint",
    "Verdict",
    "batch",
    "budget",
    "check",
    "circle",
    "fit",
    "limits",
    "pair",
    "statistics",
]


class Status(StrEnum):
    """What to do with a part, best first."""

    GOOD = "GOOD"
    REWORK = "REWORK"
    RE_MEASURE = "RE-MEASURE"
    OUT_OF_LIMITS = "OUT OF LIMITS"
    SCRAP = "SCRAP"
