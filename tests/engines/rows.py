"""Rows to judge: (callout, measured, nominal, class, value), the first two as texts, the others as exact decimals.

Where a text is no callout or no number, the numbers that belong to it are missing: both forms have the same answer.
"""

import csv
import io
import random
import subprocess

NM = 1_000_000
ENDS = [1, 3, 6, 10, 14, 18, 24, 30, 40, 50, 65, 80, 100, 120, 140, 160, 180, 200, 225, 250, 280, 315, 355, 400, 450, 500,
        560, 630, 710, 800, 900, 1000, 1120, 1250, 1400, 1600, 1800, 2000, 2240, 2500, 2800, 3150]
LETTERS = "a b c cd d e ef f fg g h j js k m n p r s t u v x y z za zb zc".split()
GRADES = ["01", "0"] + [str(number) for number in range(1, 19)]
CLASSES = [(letters.upper() if hole else letters) + grade for hole in (True, False) for letters in LETTERS for grade in GRADES]

# Callouts that both refuse, with nominal size and class where they have both.
BAD_CALLOUTS = [
    ("", "", ""), ("   ", "", ""), ("abc", "", ""), ("25", "25", ""), ("25 ", "25", ""), ("H7", "", "H7"), ("h 7 25", "", ""),
    ("25 H", "25", "H"), ("25 7", "25", "7"), ("25 H7x", "25", "H7x"), ("25 H7 H7", "25", "H7 H7"), ("25 Hh7", "25", "Hh7"),
    ("25 hH7", "25", "hH7"), ("25 H007", "25", "H007"), ("25 ABCDEFGH7", "25", "ABCDEFGH7"), ("25 H-7", "25", "H-7"),
    ("25 ABCDEFG07", "25", "ABCDEFG07"), ("0.0000001 H7", "", "H7"), ("25.0000001 H7", "", "H7"), ("25.01.2 H7", "", "H7"),
    ("25 ?H7", "25", "?H7"), ("1e3 H7", "", ""), ("--25 H7", "", "H7"), ("- 25 H7", "", "H7"), ("25- H7", "", "H7"),
    ("0 H7", "0", "H7"), ("0.000000 h6", "0.000000", "h6"), ("-5 H7", "-5", "H7"), ("-25.5 Q7", "-25.5", "Q7"),
    ("-0 H7", "0", "H7"), ("25 Q7", "25", "Q7"), ("25 H19", "25", "H19"), ("25 H07", "25", "H07"), ("25 H00", "25", "H00"),
    ("25 i6", "25", "i6"), ("25 mm6", "25", "mm6"), ("25 IT7", "25", "IT7"), ("25 JSS7", "25", "JSS7"), ("25 H99", "25", "H99"),
    ("25 ABCDEFG7", "25", "ABCDEFG7"), ("25 abcdef01", "25", "abcdef01"), ("25 U77", "25", "U77"), ("25 L7", "25", "L7"),
    ("4000 H7", "4000", "H7"), ("3150.000001 h7", "3150.000001", "h7"), ("999999999.999999 H7", "999999999.999999", "H7"),
    ("4000 Q7", "4000", "Q7"), ("4000 J9", "4000", "J9"), ("25 J9", "25", "J9"), ("5 y7", "5", "y7"), ("0.5 A11", "0.5", "A11"),
    ("501 a11", "501", "a11"), ("25 h 7", "25", "h 7"), ("25 'H7", "25", "'H7"), ("25 H7;", "25", "H7;"), ("25 %7", "25", "%7"),
    ("25 _7", "25", "_7"), ("25 H_", "25", "H_"), ("25 Ä7", "25", "Ä7"), ("25 ß7", "25", "ß7"),
]
GOOD_CALLOUTS = [("25 H7", "25", "H7"), ("25H7", "25", "H7"), (" 25   h6  ", "25", "h6"), ("025.000000 js13", "25", "js13"),
                 ("25.0000000000 H01", "25", "H01"), ("3150 IT0".replace("IT", "h"), "3150", "h0"), ("0.000001 H7", "0.000001", "H7")]
# Measured values that both refuse, with the number where there is one; then some that both take.
MEASURED = [
    ("", ""), ("  ", ""), ("abc", ""), ("25.0l2", ""), ("25.0120001", ""), ("25.01.2", ""), ("1e3", ""), ("NaN", ""), ("inf", ""),
    ("Infinity", ""), ("0x19", ""), ("25 012", ""), ("--25", ""), ("- 25", ""), ("25-", ""), ("1_000", ""), ("+", ""), (".", ""),
    ("-", ""), ("1.234,5", ""), ("true", ""), ("null", ""), ("25.0120000001", ""), ("-0.0000001", ""), ("0.0000001", ""),
    ("0", "0"), ("0.000000", "0.000000"), ("-0", "0"), ("-25", "-25"), ("-0.000001", "-0.000001"), ("-999999999.999999", "-999999999.999999"),
    ("25", "25"), ("25.000", "25.000"), (" 25.021 ", "25.021"), ("025.021001", "25.021001"), ("24.99999900000", "24.999999"),
    ("0.000001", "0.000001"), ("999999999.999999", "999999999.999999"), ("000000025", "25"),
]


def mm(nm):
    """Nanometres as millimetres, without zeros at the end."""
    sign = "-" if nm < 0 else ""
    whole, part = divmod(abs(nm), NM)
    return f"{sign}{whole}.{part:06d}".rstrip("0") if part else f"{sign}{whole}"


def nm(text):
    """Millimetres as nanometres, exactly."""
    whole, _, part = text.partition(".")
    value = int(whole.lstrip("-")) * NM + int(part.ljust(6, "0")[:6] or 0)
    return -value if text.startswith("-") else value


def limits(program, sizes, options):
    """The limits in nm of every class at every size, as `fitcheck limits` says them; nothing where it refuses."""
    asked = [(cls, size) for cls in CLASSES for size in sizes]
    lines = "".join(f"{mm(size)} {cls}\n" for cls, size in asked)
    run = subprocess.run([program, "limits", "-", "--format", "csv", *options], input=lines, capture_output=True, text=True, check=False)
    found = {}
    answers = list(csv.DictReader(io.StringIO(run.stdout)))
    assert len(answers) == len(asked), (len(answers), len(asked))
    for key, row in zip(asked, answers):
        if not row["error"]:
            found[key] = (nm(row["min_mm"]), nm(row["max_mm"]))
    return found


def sizes_at_borders():
    """Just above the lower end, the middle, the end and a nanometre to either side of it; beyond the last end, too."""
    sizes, before = [1], 0
    for end in ENDS:
        middle = (before + end) * NM // 2
        sizes += [middle, end * NM - 1, end * NM, end * NM + 1]
        before = end
    return sizes


def row(size, cls, value):
    nominal, measured = mm(size), mm(value)
    return f"{nominal} {cls}", measured, nominal, cls, measured


def borders(program, options):
    """Every class at every border of every step, measured on each limit, a nanometre to either side, and in the middle."""
    sizes = sizes_at_borders()
    found = limits(program, sizes, options)
    for cls in CLASSES:
        for size in sizes:
            if (cls, size) in found:
                low, high = found[cls, size]
                for value in sorted({low - 1, low, low + 1, (low + high) // 2, high - 1, high, high + 1}):
                    yield row(size, cls, value)
            else:
                yield row(size, cls, size)


def refusals():
    """Every callout of the lists with every measured value of the lists."""
    for callout, nominal, cls in BAD_CALLOUTS + GOOD_CALLOUTS:
        for measured, value in MEASURED:
            yield callout, measured, nominal, cls, value


def stated(count, seed):
    """Rows with their limits beside them: (minimum, maximum, feature, measured, answer) with the answer by the rule, reckoned here."""
    rand = random.Random(seed)
    for minimum, maximum, feature, measured, error in STATED_REFUSALS:
        yield minimum, maximum, feature, measured, f",,,{error}"
    for _ in range(count):
        low = rand.randrange(-5 * NM, 500 * NM)
        high = low + rand.choice([0, 1, rand.randrange(1, 200_000), rand.randrange(1, 9 * NM)])
        value = rand.choice([low - 1, low, low + 1, high - 1, high, high + 1, (low + high) // 2, rand.randrange(2 * low - high - 9, 2 * high - low + 9)])
        # A size of 0 or less is refused by the program.
        value = max(value, 1) if 0 < low else value
        # Wider than IT 18 of its size, and for a hole or a shaft the program asks first; the SQL does not.
        feature = rand.choice(["", "hole", "shaft"]) if 3 * NM < low and high - low < NM else ""
        beyond = value - low if value < low else value - high if high < value else 0
        status = "GOOD" if not beyond else "OUT OF LIMITS" if not feature else "REWORK" if (beyond < 0) == (feature == "hole") else "SCRAP"
        um = lambda nm: f"{'-' if nm < 0 else ''}{abs(nm) // 1000}.{abs(nm) % 1000:03d}"  # noqa: E731
        remove = um(abs(beyond)) if status == "REWORK" else ""
        yield mm(low), mm(high), feature, mm(value), f"{status},{um(beyond) if beyond else ''},{remove},"


STATED_REFUSALS = [
    ("", "8.1", "", "8", "limits-not-read"), ("7.9", "", "hole", "8", "limits-not-read"), ("", "", "", "", "limits-not-read"),
    ("8.1", "7.9", "", "8", "limits-reversed"), ("8.000001", "8", "hole", "", "limits-reversed"),
    ("7.9", "8.1", "Hole", "8", "feature-unknown"), ("7.9", "8.1", "x", "", "feature-unknown"), ("7.9", "8.1", "", "", "measured-not-read"),
]


def randoms(program, options, count, seed):
    """Seeded random rows: a third of the sizes at borders, a third of the values on a limit, some of them refused."""
    rand = random.Random(seed)
    found = limits(program, [end * NM for end in ENDS], options)
    cells = {}
    for (cls, size), (low, high) in found.items():
        cells[cls, size // NM] = (low - size, high - size)
    odd = ["Q7", "H19", "L6", "i7", "H07", "w3"]
    pick, uniform, below = rand.random, rand.uniform, rand.randrange
    for _ in range(count):
        cls = CLASSES[below(len(CLASSES))] if pick() < 0.98 else odd[below(len(odd))]
        at = below(len(ENDS))
        end = ENDS[at] * NM
        start = ENDS[at - 1] * NM if at else 0
        if pick() < 0.3:
            size = end + below(-1, 2)
        elif pick() < 0.5:
            size = start + (1 + below(ENDS[at] - start // NM)) * NM - (0 if pick() < 0.5 else 500_000)
        else:
            size = start + 1 + below(end - start)
        low, high = cells.get((cls, ENDS[at]), (-20_000, 20_000))
        kind = pick()
        if kind < 0.3:
            value = size + (low if pick() < 0.5 else high) + below(-1, 2)
        elif kind < 0.97:
            value = size + int(uniform(2 * low - high, 2 * high - low))
        else:
            value = below(-5 * NM, 4000 * NM)
        nominal, measured = mm(size), mm(value)
        text, given = nominal, measured
        variant = pick()
        if variant < 0.03:
            text = nominal + (".000" if "." not in nominal else "0000000")
        elif variant < 0.06:
            given = f" {measured}{'.0' if '.' not in measured else '0'} "
        if 0.97 < variant:
            callout = f"{text}{cls}" if variant < 0.985 else f"  {text}   {cls} "
        else:
            callout = f"{text} {cls}"
        if 0.5 < variant < 0.505:
            yield callout, BAD[below(len(BAD))], nominal, cls, ""
        else:
            yield callout, given, nominal, cls, measured


BAD = [measured for measured, value in MEASURED if value == ""]
