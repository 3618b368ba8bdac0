"""The limits by number of size step: the join that an engine does fastest is one on equal values."""

import csv


def read(limits_name):
    """The upper ends of all steps in mm, ascending, and rows of class, step, lower and upper deviation in mm, whether a hole.

    The ranges of some classes hold several steps: each gets a row.
    """
    with open(limits_name, encoding="utf-8") as file:
        cells = list(csv.DictReader(file))
    ends = sorted({float(cell[name]) for cell in cells for name in ("over_mm", "to_mm")} - {0.0})
    rows = []
    for cell in cells:
        over, to = float(cell["over_mm"]), float(cell["to_mm"])
        lower, upper = float(cell["lower_um"]) / 1000, float(cell["upper_um"]) / 1000
        rows += [
            (cell["class"], step, lower, upper, cell["class"][0].isupper())
            for step, end in enumerate(ends)
            if over < end <= to
        ]
    return ends, rows
