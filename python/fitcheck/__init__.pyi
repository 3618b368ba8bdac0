"""Types and documentation of the package."""

from decimal import Decimal
from enum import StrEnum
from typing import Any, Literal, Protocol, Sequence

Number = str | Decimal | int | float
"""A length in millimetres. A str may have a decimal comma and state its own unit: "25,012", "984.7 µm", "0.98 in"."""

class _ArrowStream(Protocol):
    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object: ...

class _ArrowArray(Protocol):
    def __arrow_c_array__(self, requested_schema: object | None = None) -> tuple[object, object]: ...

class FitcheckError(ValueError):
    """What was given cannot be answered. str() says what was given, what is wrong and what is allowed, in the words of the command line."""

    code: str
    """The name of the text, the same in every version that has it."""

class Status(StrEnum):
    """What to do with a part, best first."""

    GOOD = "GOOD"
    """On the limits or between them, or in the zone that a decision rule accepts."""
    REWORK = "REWORK"
    """Outside, but material can still be taken off."""
    RE_MEASURE = "RE-MEASURE"
    """Nothing is decided: the value lies in a guard band of the rule."""
    OUT_OF_LIMITS = "OUT OF LIMITS"
    """Outside, and nobody has said hole or shaft: rework or scrap is open."""
    SCRAP = "SCRAP"
    """Outside, and material cannot be put back."""

class Limits:
    """The limits of size of a callout, in millimetres at 20 °C."""

    @property
    def callout(self) -> str: ...
    @property
    def feature(self) -> Literal["hole", "shaft"] | None:
        """None where the callout does not say it and nobody did."""
    @property
    def nominal(self) -> Decimal: ...
    @property
    def minimum(self) -> Decimal: ...
    @property
    def maximum(self) -> Decimal: ...
    @property
    def lower_um(self) -> Decimal:
        """Minimum minus nominal size, micrometres (EI or ei)."""
    @property
    def upper_um(self) -> Decimal:
        """Maximum minus nominal size, micrometres (ES or es)."""
    @property
    def source(self) -> str:
        """Where the limits come from, such as "ISO 286, over 18 up to 30 mm"."""
    @property
    def warnings(self) -> list[str]:
        """What is doubtful about the callout or its zone; mostly nothing."""

class Verdict:
    """A measured diameter, its limits and what follows."""

    @property
    def status(self) -> Status: ...
    @property
    def is_good(self) -> bool:
        """Whether the status is GOOD and nothing stands against it: no warning."""
    @property
    def callout(self) -> str: ...
    @property
    def feature(self) -> Literal["hole", "shaft"] | None: ...
    @property
    def nominal(self) -> Decimal: ...
    @property
    def minimum(self) -> Decimal: ...
    @property
    def maximum(self) -> Decimal: ...
    @property
    def measured(self) -> Decimal: ...
    @property
    def deviation_um(self) -> Decimal:
        """Measured minus nominal size, micrometres."""
    @property
    def remove_um(self) -> Decimal | None:
        """For rework: what to remove from the diameter to be accepted, micrometres."""
    @property
    def remove_to_middle_um(self) -> Decimal | None:
        """For rework: what to remove to reach the middle of the zone, micrometres."""
    @property
    def rule(self) -> str:
        """The decision rule, such as "simple" or "iso14253-2017"."""
    @property
    def accepted_minimum(self) -> Decimal | None:
        """The smallest diameter that the rule accepts; None by the limits alone, and where it accepts none."""
    @property
    def accepted_maximum(self) -> Decimal | None:
        """The largest diameter that the rule accepts."""
    @property
    def is_proven(self) -> bool | None:
        """Whether conformity or nonconformity is proven (ISO 14253-1); None where the rule proves nothing."""
    @property
    def source(self) -> str: ...
    @property
    def warnings(self) -> list[str]:
        """What stands against the answer. Look at it before the part goes."""
    def as_dict(self) -> dict[str, Any]:
        """What `fitcheck check --format json` says, with the time of this call."""

class Fit:
    """A hole and a shaft of the same nominal size (ISO 286-1)."""

    @property
    def callout(self) -> str: ...
    @property
    def kind(self) -> Literal["clearance", "transition", "interference"]: ...
    @property
    def nominal(self) -> Decimal: ...
    @property
    def minimum_clearance_um(self) -> Decimal:
        """Micrometres; negative is an interference."""
    @property
    def maximum_clearance_um(self) -> Decimal: ...
    @property
    def hole(self) -> Limits: ...
    @property
    def shaft(self) -> Limits: ...
    @property
    def clearance_um(self) -> Decimal | None:
        """Of the two measured parts: hole minus shaft, micrometres."""
    @property
    def status(self) -> Status | None:
        """The worse verdict of the two measured parts, each by its own limits."""

class Circle:
    """A circle, millimetres."""

    x: float
    y: float
    diameter: float

class Ring:
    """The ring of least width that holds all contacts (minimum zone, ISO 1101), millimetres."""

    x: float
    y: float
    width: float
    outer_diameter: float
    inner_diameter: float

class TwoPoint:
    """The distance of two opposite contacts (ISO 14405-1, LP)."""

    contacts: tuple[int, int]
    size: float
    direction_deg: float

class Evaluation:
    """Everything that contacts say about a circle (ISO 14405-1), millimetres."""

    least_squares: Circle
    """Gaussian circle (GG)."""
    form: float
    """Largest minus smallest radial deviation from the Gaussian circle."""
    residuals: list[float]
    minimum_circumscribed: Circle
    """GN."""
    maximum_inscribed: Circle | None
    """GX; None where the contacts do not surround one."""
    minimum_zone: Ring | None
    two_point: list[TwoPoint]
    contacts: int
    arc_deg: float
    warnings: list[str]
    """What the contacts cannot tell, and what is suspicious."""

class Rows:
    """The rows of a table with their answers: a stream of Arrow, which is read once.

    Counts and notes are those of all rows: before the stream was read to its end, as by polars.DataFrame(rows), asking for them raises
    FitcheckError. So does reading it a second time.
    """

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object: ...
    def __arrow_c_schema__(self) -> object: ...
    @property
    def counts(self) -> dict[Status, int]:
        """How many rows have which verdict."""
    @property
    def refused(self) -> int:
        """How many rows have no verdict; the column `error` says why."""
    @property
    def doubtful(self) -> int:
        """How many verdicts have a doubt; they are among the counts. The column `doubt` says what to look at."""
    @property
    def simulated(self) -> int:
        """How many of the judged rows say that nobody measured."""
    @property
    def notes(self) -> list[tuple[int, str]]:
        """The first remarks of each kind, with the number of the row from 0."""
    @property
    def warnings(self) -> list[str]:
        """What is to be said of the columns, such as those that no verdict depends on."""

class Pairing:
    """Which measured holes go with which measured shafts: as many pairs as possible, those closest to the middle of the clearances."""

    @property
    def pairs(self) -> list[tuple[int, int, Decimal]]:
        """For each pair the positions of hole and shaft in the given lists, and hole minus shaft in micrometres; in order of size."""
    @property
    def holes_left(self) -> list[int]: ...
    @property
    def shafts_left(self) -> list[int]: ...
    @property
    def band_um(self) -> Decimal:
        """The width of the narrowest band around the middle of the wanted clearances that all pairs lie in, micrometres."""

class Budget:
    """An uncertainty budget and what it comes to (JCGM 100, ISO 15530-3), micrometres."""

    @property
    def name(self) -> str: ...
    @property
    def u_um(self) -> float:
        """The combined standard uncertainty."""
    @property
    def k(self) -> float: ...
    @property
    def expanded_um(self) -> float: ...
    @property
    def degrees_of_freedom(self) -> float | None:
        """None where they are infinite."""
    @property
    def rule_u_um(self) -> Decimal:
        """The standard uncertainty that a decision rule gets, for check(..., u_um=…)."""
    @property
    def valid_until(self) -> str: ...
    @property
    def warnings(self) -> list[str]: ...

class Figure:
    """A figure with its interval, or the reason why there is none. float() gives the value."""

    value: float | None
    lower: float | None
    """The interval at the level of the statistics; None where the figure is not estimated."""
    upper: float | None
    method: str
    reason: str | None
    def __float__(self) -> float: ...

class Statistics:
    """What the values of one feature say, in the order in which they were made."""

    @property
    def count(self) -> int:
        """How many values count."""
    @property
    def level(self) -> float:
        """The level of the intervals, such as 0.95."""
    @property
    def left_out(self) -> dict[str, int]:
        """How many values count for nothing, by the reason: those that may be another part's are "doubtful"."""
    @property
    def outside(self) -> tuple[int, int]:
        """How many are below the lower and above the upper limit."""
    @property
    def figures(self) -> dict[str, Figure]:
        """Every figure by the name that `fitcheck stats --format json` has: mean_mm, s_within_mm, cp, cpk, pp, ppk, …"""
    @property
    def rules(self) -> dict[str, list[int]]:
        """The rules of control charts that fire (Nelson), each with its points from 1."""
    @property
    def advice(self) -> list[str]: ...

def limits(callout: str, *, feature: Literal["hole", "shaft"] | None = None) -> Limits:
    """The limits of size of a callout: "25 H7", "12 ±0.02", "10m", "12 +0.01 -0.015", or one part of "25 H7/g6" with its feature.

    Limits: ISO 286-1 and -2 (classes to 3150 mm), ISO 2768-1. Raises FitcheckError where a class is not defined at a size.
    """

def check(
    callout: str,
    measured: Number,
    *,
    feature: Literal["hole", "shaft"] | None = None,
    rule: str | None = None,
    u_um: Number | None = None,
    expanded_um: Number | None = None,
    k: Number | None = None,
    factor: Number | None = None,
    guard_um: Number | None = None,
    prover: Literal["supplier", "customer"] | None = None,
) -> Verdict:
    """Judges one measured diameter.

    Without a rule the limits alone decide, and belong to the zone, as on a control. rule: simple, iso14253-2017, iso14253-1998,
    ilac-g8, asme-simple, asme-stringent, asme-relaxed or fixed. u_um is the standard uncertainty, expanded_um the expanded one
    with its coverage factor k (2 unless given), guard_um the guard band of "fixed": micrometres. prover: who has to prove
    (ISO 14253-1). Raises FitcheckError for what is not defined or is no number, and for an uncertainty without the rule that uses it.
    """

def fit(callout: str, *, hole: Number | None = None, shaft: Number | None = None) -> Fit:
    """A fit such as "25 H7/g6"; with both measured diameters, how the parts go together. Raises FitcheckError as limits() does."""

def circle(contacts: Sequence[tuple[float, float] | tuple[float, float, float]]) -> Evaluation:
    """The circle through contacts, millimetres: by least squares and by every other criterion of ISO 14405-1.

    Raises FitcheckError for fewer than three contacts, contacts on a line, or numbers that are not finite.
    """

def batch(
    table: _ArrowStream | _ArrowArray,
    *,
    callout: str | None = None,
    measured: str | None = None,
    prefix: str = "",
) -> Rows:
    """Judges every row of a table, in its order, by the limits alone, as `fitcheck batch` does.

    table: whatever speaks the C stream of Arrow, such as a frame of Polars or pandas, a table of pyarrow, a relation of DuckDB. Its
    columns are found by their names in English, Dutch, German, Italian, French or Spanish and by their contents, or named by callout and measured.
    Texts may have a decimal comma. All columns are given on without copies,
    followed by min_mm, max_mm, deviation_um, status, remove_um, error and doubt, each behind the prefix. A row without a verdict
    has the reason in error. Raises FitcheckError where nothing in the table can be judged, as without a column of callouts or limits.
    """

def pair(
    holes: Sequence[Number],
    shafts: Sequence[Number],
    *,
    clearance: tuple[Number, Number] | None = None,
    fit: str | None = None,
) -> Pairing:
    """Pairs measured holes with measured shafts (selective assembly), for clearances in millimetres, both ends included, or for a fit.

    A negative clearance is an interference. Raises FitcheckError for a size that is none, named by its place.
    """

def budget(
    text: str,
    *,
    size: Number | None = None,
    touches: int | None = None,
    step_deg: float | None = None,
    day: str | None = None,
) -> Budget:
    """Evaluates the text of a budget file (TOML, as `fitcheck budget` reads it).

    size: the measured size in millimetres, for contributions that grow with it. touches and step_deg: how many contacts were taken,
    and the angle between them in degrees. day: YYYY-MM-DD, today unless given; a budget that is not valid then says so.
    """

def statistics(
    values: Sequence[Number],
    *,
    callout: str | None = None,
    lower: Number | None = None,
    upper: Number | None = None,
    target: Number | None = None,
    group: int = 1,
    level: float = 0.95,
) -> Statistics:
    """Control chart, capability, trend and advice for measured values in their order, as `fitcheck stats` computes them.

    Limits come from a callout, or are given in millimetres. group: how many values in a row are a subgroup. level: of the intervals,
    from 0.5 to below 1. What cannot be computed of too few values has its reason in the figure.
    """
