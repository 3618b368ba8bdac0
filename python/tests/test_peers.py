"""Limits and fits beside those of two public packages. Where they differ, the standard says which is right."""

import fitcheck
import pytest

# isofits 1.0, micrometres. E7 over 315 to 400: EI = 125 and IT7 = 57 make ES = 182. K6 over 6 to 10: ISO 286-2, table 8, has +2/-7.
# f6 over 120 to 180: es = -43 and IT6 = 25 make ei = -68.
WRONG_IN_ISOFITS = {
    (355, "E7"): (185, 125),
    (400, "E7"): (185, 125),
    (10, "K6"): (2, -6),
    (140, "f6"): (-43, -48),
    (160, "f6"): (-43, -48),
    (180, "f6"): (-43, -48),
}
SIZES = [1, 3, 5, 6, 10, 14, 18, 24, 30, 40, 50, 65, 80, 100, 120, 140, 160, 180, 200, 225, 250, 280, 315, 355, 400, 450, 500]


def test_isofits_has_the_same_limits_but_for_its_mistakes() -> None:
    isofits = pytest.importorskip("isofits")
    data = pytest.importorskip("data")
    compared, differ = 0, {}
    for body, table in (("hole", data.hole_data), ("shaft", data.shaft_data)):
        for name in list(table)[2:]:
            for size in (int(size) for size in table["inc."] if 3 <= int(size) <= 400):
                try:
                    peer = isofits.isotol(body, size, name, "both")
                except (IndexError, ValueError):
                    continue
                limits = fitcheck.limits(f"{size} {name}")
                compared += 1
                if peer != (float(limits.upper_um), float(limits.lower_um)):
                    differ[size, name] = peer
    assert compared > 1_400
    assert differ == WRONG_IN_ISOFITS


def test_pressfit_has_the_same_fits() -> None:
    pressfit = pytest.importorskip("pressfit")
    compared = 0
    for size in SIZES:
        for grade in pressfit.GRADES:
            for shaft in (f"{letter}{other}" for letter in pressfit.SHAFT_LETTERS for other in pressfit.GRADES):
                try:
                    peer = pressfit.fit(f"{size} H{grade}/{shaft}")
                except ValueError:
                    continue
                fit = fitcheck.fit(f"{size} H{grade}/{shaft}")
                mine = (fit.hole.upper_um, fit.hole.lower_um, fit.shaft.upper_um, fit.shaft.lower_um, fit.kind)
                assert mine == (peer.hole_es_um, peer.hole_ei_um, peer.shaft_es_um, peer.shaft_ei_um, peer.kind), peer.spec
                compared += 1
    assert compared > 10_000
