"""Texts that `fitcheck check` reads and the SQL refuses, or that only a database can hold: (callout, measured, error)."""

CALLOUTS = ["25 H7/g6", "10m", "10 m", "12 ±0.02", "12 +0.01 -0.015", "12.01/11.985", "25,5 H7", "+25 H7", "25mm H7", "25 mm H7",
            ".5 H7", "25. H7", "Ø25 H7", "⌀25 H7", "1234567890 H7", "0000000025 H7", "25\tH7", "25\u00a0H7", "\t25 H7", "25 H7\t",
            "25 H7\n", "\n25 H7", "25 H7\r", "25\nH7", "25 H7\u2028", "25 H7\x00", "25\x00 H7", "25 H7\x00H7", "２５ H7", "25 Ｈ7", "٢٥ H7",
            "−25 H7", "25 H７", "25 H7\u200b", "'25 H7'", "25 H7--", "25 H7'; drop table fitcheck_limits; --", "25\\ H7", "\ufeff25 H7"]
MEASURED = ["25,012", "+25.012", "25.012 mm", "25.012mm", "25012 µm", ".5", "25.", "1234567890", "0000000025", "25.012\n", "\n25.012",
            "25.012\t", "25.012\r", "\u00a025.012", "٢٥", "２５", "25.012\x00", "25\x00.012", "−25", "1e1", "25_0", "25.0 1", "2 5", "0b1",
            "25d", "25f", "25L", "$25", "25.012\u2028", "\ufeff25"]


def rows():
    for callout in CALLOUTS:
        for measured in ("25.012", "abc", "-1"):
            yield callout, measured, "callout-not-read"
    for measured in MEASURED:
        yield "25 H7", measured, "measured-not-read"
        yield "25 Q7", measured, "class-unknown"
        yield "4000 H7", measured, "no-limits-at-size"
        yield "-25 H7", measured, "nominal-not-positive"
    yield None, None, "callout-not-read"
    yield None, "25.012", "callout-not-read"
    yield "25 H7", None, "measured-not-read"
