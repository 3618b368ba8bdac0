"""Cuts the fonts in this folder from their upstream packages; README.md has the commands.

usage: python subset.py <Source Sans folder> <Source Code Pro folder> <DejaVu folder> <Phosphor folder> <output folder>
"""

import re
import sys
from pathlib import Path

from fontTools.misc.transform import Transform
from fontTools.pens.boundsPen import BoundsPen
from fontTools.pens.recordingPen import DecomposingRecordingPen
from fontTools.pens.transformPen import TransformPen
from fontTools.pens.ttGlyphPen import TTGlyphPen
from fontTools.subset import Options, Subsetter
from fontTools.ttLib import TTFont

# One line for all three files: where egui falls back from one to another, the baselines meet.
ASCENT, DESCENT = 1.000, -0.326
# Where the window names its icons.
ICONS = Path(__file__).parent.parent.parent / "src/gui/theme/icon.rs"
# Half the height of a capital in Source Sans; its circles and squares are centred on it too.
CENTRE = 0.33

TEXT = [
    (0x0020, 0x007E),  # ASCII
    (0x00A0, 0x017F),  # Latin-1 and Latin Extended-A
    (0x0192, 0x0192), (0x0218, 0x021B), (0x02C6, 0x02C7), (0x02D8, 0x02DD),
    (0x0384, 0x03CE),  # Greek
    (0x1E9E, 0x1E9E),  # capital sharp s
    (0x2002, 0x200B), (0x2010, 0x2027), (0x202F, 0x2033), (0x2039, 0x203A), (0x2044, 0x2044),
    (0x2070, 0x208E),  # superscripts and subscripts
    (0x20AC, 0x20AC), (0x2113, 0x2113), (0x2116, 0x2116), (0x2122, 0x2122), (0x2126, 0x2126),
    (0x2150, 0x215E),  # fractions
    (0x2190, 0x2199), (0x21D0, 0x21D4),  # arrows
    (0x2202, 0x2265),  # mathematical operators
    (0x25A0, 0x25FF),  # geometric shapes
    (0x2610, 0x2611), (0x2713, 0x2718),  # boxes, check marks and crosses
]

# Taken from DejaVu Sans: scale, then centred on CENTRE.
SYMBOLS = {
    "↩": 0.95, "↪": 0.95, "↺": 1.06, "↻": 1.06, "⏎": 1.00, "◎": 0.90, "☰": 0.80,
    "⚠": 0.90, "⟲": 1.00, "⟳": 1.00,
}


def subset(font, codepoints):
    options = Options()
    options.hinting = False
    options.layout_features = []
    options.drop_tables += ["BASE", "DSIG", "GDEF", "GPOS", "GSUB", "MATH", "FFTM", "kern", "gasp"]
    options.name_IDs = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 13, 14]
    options.name_languages = [0x409]
    options.notdef_outline = True
    options.recalc_timestamp = False
    subsetter = Subsetter(options)
    subsetter.populate(unicodes=codepoints)
    subsetter.subset(font)


def name(font, family, style):
    names = font["name"]
    names.names = [record for record in names.names if record.platformID == 3]
    version = names.getDebugName(5).split(";")[0].strip()
    full = family if style == "Regular" else f"{family} {style}"
    postscript = f"{family.replace(' ', '')}-{style}"
    texts = {1: full if style != "Regular" else family, 2: "Regular", 3: f"{version};{postscript}", 4: full,
             5: f"{version}; subset", 6: postscript}
    if style != "Regular":
        texts |= {16: family, 17: style}
    for identifier, text in texts.items():
        names.setName(text, identifier, 3, 1, 0x409)
    font["OS/2"].achVendID = "    "


def line(font):
    units = font["head"].unitsPerEm
    ascent, descent = round(ASCENT * units), round(DESCENT * units)
    header, metrics = font["hhea"], font["OS/2"]
    header.ascent, header.descent, header.lineGap = ascent, descent, 0
    metrics.sTypoAscender, metrics.sTypoDescender, metrics.sTypoLineGap = ascent, descent, 0
    metrics.usWinAscent, metrics.usWinDescent = ascent, -descent


def text_font(source, target, family, style):
    font = TTFont(source, recalcTimestamp=False)
    subset(font, [point for first, last in TEXT for point in range(first, last + 1)])
    name(font, family, style)
    line(font)
    font.save(target)


def set_glyph(font, glyph_name, draw, advance):
    pen = TTGlyphPen(None)
    draw(pen)
    glyph = pen.glyph()
    glyph.recalcBounds(font["glyf"])
    font["glyf"][glyph_name] = glyph
    font["hmtx"][glyph_name] = (round(advance), glyph.xMin)


def polygon(pen, points):
    pen.moveTo(points[0])
    for point in points[1:]:
        pen.lineTo(point)
    pen.closePath()


def circle(pen, centre, radius, clockwise):
    """Eight quadratic arcs: the corners of an octagon as control points."""
    x, y = centre
    k = 2**0.5 - 1
    corners = [(1, k), (k, 1), (-k, 1), (-1, k), (-1, -k), (-k, -1), (k, -1), (1, -k)]
    if clockwise:
        corners.reverse()
    pen.qCurveTo(*((round(x + radius * a), round(y + radius * b)) for a, b in corners), None)
    pen.closePath()


def ring(pen, centre, radius, stroke):
    circle(pen, centre, radius, clockwise=True)
    circle(pen, centre, radius - stroke, clockwise=False)


def place(drawing, scale, x, y):
    """Draws a recorded outline, scaled, with its middle at a point (x None: where it stands)."""
    bounds = BoundsPen(None)
    drawing.replay(bounds)
    left, bottom, right, top = bounds.bounds
    dx = 0 if x is None else x - scale * (left + right) / 2
    transform = Transform(scale, 0, 0, scale, dx, y - scale * (bottom + top) / 2)
    return lambda pen: drawing.replay(TransformPen(pen, transform))


def symbols_font(source, target):
    font = TTFont(source, recalcTimestamp=False)
    subset(font, [ord(sign) for sign in [*SYMBOLS, "⌀", "E"]])
    units, cmap = font["head"].unitsPerEm, font.getBestCmap()
    glyphs, centre = font.getGlyphSet(), CENTRE * units
    drawings = {}
    for sign in [*SYMBOLS, "E"]:
        drawings[sign] = DecomposingRecordingPen(glyphs)
        glyphs[cmap[ord(sign)]].draw(drawings[sign])
    advances = {sign: scale * glyphs[cmap[ord(sign)]].width for sign, scale in SYMBOLS.items()}

    for sign, scale in SYMBOLS.items():
        set_glyph(font, cmap[ord(sign)], place(drawings[sign], scale, None, centre), advances[sign])

    def diameter(pen):
        """As tall as a capital; DejaVu's own is no taller than an o."""
        stroke, outer = 0.074 * units, 0.33 * units
        ring(pen, (outer, centre), 0.285 * units, stroke)
        inner = outer - stroke / 2**0.5
        corners = [(-outer, -inner), (inner, outer), (outer, inner), (-inner, -outer)]
        polygon(pen, [(round(outer + x), round(centre + y)) for x, y in corners])

    def circled_e(pen):
        """DejaVu Sans has none: its E in a ring."""
        middle = 0.45 * units
        ring(pen, (middle, centre), 0.40 * units, 0.055 * units)
        place(drawings["E"], 0.56, middle + 0.012 * units, centre)(pen)

    set_glyph(font, cmap[ord("⌀")], diameter, 0.66 * units)
    set_glyph(font, cmap[ord("E")], circled_e, 0.90 * units)
    for table in font["cmap"].tables:
        table.cmap = {ord("Ⓔ") if point == ord("E") else point: glyph for point, glyph in table.cmap.items()}
    name(font, "Fitcheck Symbols", "Regular")
    line(font)
    font.save(target)


def icons_font(source, target, style):
    """The icons that the window names; their squares keep Phosphor's own line, so that one is centred in its row."""
    named = re.findall(r"= '\\u\{([0-9a-f]+)\}'", ICONS.read_text())
    font = TTFont(source, recalcTimestamp=False)
    subset(font, [int(point, 16) for point in named])
    name(font, "Fitcheck Icons", style)
    font.save(target)


def main():
    sans, mono, dejavu, phosphor, target = map(Path, sys.argv[1:])
    text_font(sans / "TTF/SourceSans3-Regular.ttf", target / "sans-regular.ttf", "Fitcheck Sans", "Regular")
    text_font(sans / "TTF/SourceSans3-Semibold.ttf", target / "sans-semibold.ttf", "Fitcheck Sans", "Semibold")
    text_font(mono / "TTF/SourceCodePro-Regular.ttf", target / "mono-regular.ttf", "Fitcheck Mono", "Regular")
    symbols_font(dejavu / "ttf/DejaVuSans.ttf", target / "symbols.ttf")
    for style, file in [("Regular", "regular/Phosphor"), ("Bold", "bold/Phosphor-Bold"), ("Fill", "fill/Phosphor-Fill")]:
        icons_font(phosphor / f"src/{file}.ttf", target / f"icons-{style.lower()}.ttf", style)


if __name__ == "__main__":
    main()
