//! Draws the shapes of a page. What is drawn again and again, such as hatching and signs, is in the file once.

use std::collections::BTreeMap;

use krilla::color::rgb;
use krilla::geom::{Path, PathBuilder, Point, Size, Transform};
use krilla::graphic::Graphic;
use krilla::num::NormalizedF32;
use krilla::paint::{Fill, FillRule, Stroke, StrokeDash};
use krilla::surface::Surface;

use super::bands::{BandShape, Mark};
use super::fonts::Fonts;
use super::look::{HATCH_OUT, HATCH_REWORK, HATCH_SCRAP, Ink, PAPER, QUIET, Style, TEXT, ZONE, ZONE_EDGE};
use super::paths::{block, outline_path};
use super::pictures::Drawable;
use super::sheet::{Area, Edge, Place, Shape};
use super::signs::Sign;
use crate::report::band::{Guarded, Side};

/// How a part of a band is hatched.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Hatch {
    /// Wide slanting lines.
    Rework,
    /// A narrow lattice.
    Scrap,
    /// A wide lattice.
    Out,
    /// Upright lines.
    Undecided,
    /// Level lines.
    Beyond,
}

/// The size at which a sign is kept.
const SIGN: f32 = 10.0;

/// What is drawn with.
pub(super) struct Brush<'a> {
    fonts: &'a Fonts,
    pictures: &'a [Drawable],
    signs: BTreeMap<(Sign, Ink), Graphic>,
    /// By kind, width and height.
    hatches: BTreeMap<(Hatch, u32, u32), Graphic>,
}

impl<'a> Brush<'a> {
    pub const fn new(fonts: &'a Fonts, pictures: &'a [Drawable]) -> Self {
        Self { fonts, pictures, signs: BTreeMap::new(), hatches: BTreeMap::new() }
    }

    pub fn draw(&mut self, surface: &mut Surface<'_>, shape: &Shape) {
        match shape {
            Shape::Text(at, style, text) => self.text(surface, *at, *style, text),
            Shape::Block { area, radius, fill, edge } => {
                if let Some(path) = block(*area, *radius) {
                    outlined(surface, &path, *fill, *edge);
                }
            }
            Shape::Line { from, to, width, ink } => line(surface, *from, *to, *width, *ink),
            Shape::Sign { sign, middle, size, ink } => self.sign(surface, *sign, *middle, *size, *ink),
            Shape::Outline { outline, middle, radius, fill, edge } => {
                if let Some(path) = outline_path(*outline, *middle, *radius) {
                    outlined(surface, &path, Some(*fill), Some(*edge));
                }
            }
            Shape::Band(area, band) => self.band(surface, *area, band),
            Shape::Picture(area, number) => self.picture(surface, *area, *number),
        }
    }

    fn text(&self, surface: &mut Surface<'_>, [x, y]: Place, style: Style, text: &str) {
        surface.set_stroke(None);
        surface.set_fill(Some(fill(style.ink)));
        let mut x = x;
        for run in self.fonts.runs(text, style.weight) {
            surface.draw_glyphs(Point::from_xy(x, y), &run.glyphs, run.font, run.text, style.size, false);
            x += run.width * style.size;
        }
    }

    fn sign(&mut self, surface: &mut Surface<'_>, sign: Sign, [x, y]: Place, size: f32, ink: Ink) {
        let Some((font, glyph, advance)) = self.fonts.icon(sign.icon()) else { return };
        let graphic = self.signs.entry((sign, ink)).or_insert_with(|| {
            kept(surface, |surface| {
                surface.set_fill(Some(fill(ink)));
                let start = Point::from_xy(-advance * SIGN / 2.0, MIDDLE * SIGN);
                let text = sign.icon().to_string();
                surface.draw_glyphs(start, &[glyph], font, &text, SIGN, true);
            })
        });
        let scale = size / SIGN;
        surface.push_transform(&Transform::from_row(scale, 0.0, 0.0, scale, x, y));
        surface.draw_graphic(graphic.clone());
        surface.pop();
    }

    fn band(&mut self, surface: &mut Surface<'_>, area: Area, band: &BandShape) {
        let at = |share: f32| area.x + area.width * share;
        for (side, [from, to]) in band.sides {
            self.hatch(surface, area, [at(from), at(to)], side.into());
        }
        let [from, to] = band.zone.map(at);
        let tall =
            |x: f32, width: f32, more: f32| Area::new(x - width / 2.0, area.y - more, width, area.height + 2.0 * more);
        filled(surface, Area::new(from, area.y + 0.8, to - from, area.height - 1.6), ZONE);
        for (span, guarded) in &band.guards {
            self.hatch(surface, area, span.map(at), (*guarded).into());
        }
        filled(surface, tall(from, 1.0, 0.6), ZONE_EDGE);
        filled(surface, tall(to, 1.0, 0.6), ZONE_EDGE);
        let [_, middle] = area.middle();
        match band.mark {
            Mark::At(share) => {
                filled(surface, tall(at(share), 4.0, 0.6), PAPER);
                filled(surface, tall(at(share), 2.2, 1.2), TEXT);
            }
            Mark::Left => arrow(surface, [area.x, middle], -1.0),
            Mark::Right => arrow(surface, [area.right(), middle], 1.0),
        }
    }

    fn hatch(&mut self, surface: &mut Surface<'_>, area: Area, [from, to]: [f32; 2], hatch: Hatch) {
        let part = Area::new(from, area.y + 0.8, to - from, area.height - 1.6);
        let Some(clip) = block(part, 0.0).filter(|_| 0.6 < part.width) else { return };
        let key = (hatch, area.width.to_bits(), area.height.to_bits());
        let graphic =
            self.hatches.entry(key).or_insert_with(|| kept(surface, |surface| lines_of(surface, hatch, area)));
        surface.push_clip_path(&clip, &FillRule::NonZero);
        surface.push_transform(&Transform::from_translate(area.x, area.y));
        surface.draw_graphic(graphic.clone());
        surface.pop();
        surface.pop();
    }

    fn picture(&self, surface: &mut Surface<'_>, area: Area, number: usize) {
        let Some(size) = Size::from_wh(area.width, area.height) else { return };
        surface.push_transform(&Transform::from_translate(area.x, area.y));
        match self.pictures.get(number) {
            Some(Drawable::Dots(dots)) => surface.draw_image(dots.clone(), size),
            Some(Drawable::Shapes(tree)) => {
                if let Some(clip) = block(Area::new(0.0, 0.0, area.width, area.height), 0.0) {
                    surface.push_clip_path(&clip, &FillRule::NonZero);
                    let scale = area.width / tree.size().width();
                    surface.push_transform(&Transform::from_scale(scale, scale));
                    super::svg::draw(surface, tree);
                    surface.pop();
                    surface.pop();
                }
            }
            None => {}
        }
        surface.pop();
    }
}

/// How far the middle of an icon is above its base line, in ems.
pub(super) const MIDDLE: f32 = 0.4375;

/// Something that is in the file once, however often it is drawn.
fn kept(surface: &mut Surface<'_>, draw: impl FnOnce(&mut Surface<'_>)) -> Graphic {
    let mut builder = surface.stream_builder();
    let mut inner = builder.surface();
    draw(&mut inner);
    inner.finish();
    Graphic::new(builder.finish(), false)
}

/// The hatching of a whole band.
fn lines_of(surface: &mut Surface<'_>, hatch: Hatch, area: Area) {
    let (lines, ink) = hatched(hatch, Area::new(0.0, 0.0, area.width, area.height));
    let mut builder = PathBuilder::new();
    for [from, to] in lines {
        builder.move_to(from[0], from[1]);
        builder.line_to(to[0], to[1]);
    }
    if let Some(path) = builder.finish() {
        surface.set_fill(None);
        surface.set_stroke(Some(stroke(Edge { ink, width: 0.5, is_dashed: false })));
        surface.draw_path(&path);
        surface.set_stroke(None);
    }
}

/// The lines of the hatching of an area, and their colour; some begin or end beside it.
pub(super) fn hatched(hatch: Hatch, Area { x, y, width, height }: Area) -> (Vec<[Place; 2]>, Ink) {
    let (step, end) = match hatch {
        Hatch::Rework => (5.0, width + height),
        Hatch::Scrap => (4.4, width + height),
        Hatch::Out => (9.0, width + height),
        Hatch::Undecided => (2.2, width),
        Hatch::Beyond => (2.2, height),
    };
    let mut lines = Vec::new();
    let mut add = |[x1, y1]: Place, [x2, y2]: Place| lines.push([[x + x1, y + y1], [x + x2, y + y2]]);
    let mut at = step / 2.0;
    while at < end {
        match hatch {
            Hatch::Rework => add([at, 0.0], [at - height, height]),
            Hatch::Scrap | Hatch::Out => {
                add([at, 0.0], [at - height, height]);
                add([at - height, 0.0], [at, height]);
            }
            Hatch::Undecided => add([at, 0.0], [at, height]),
            Hatch::Beyond => add([0.0, at], [width, at]),
        }
        at += step;
    }
    let ink = match hatch {
        Hatch::Rework => HATCH_REWORK,
        Hatch::Scrap => HATCH_SCRAP,
        Hatch::Out => HATCH_OUT,
        Hatch::Undecided | Hatch::Beyond => QUIET,
    };
    (lines, ink)
}

impl From<Side> for Hatch {
    fn from(side: Side) -> Self {
        match side {
            Side::Rework => Self::Rework,
            Side::Scrap => Self::Scrap,
            Side::Out => Self::Out,
        }
    }
}

impl From<Guarded> for Hatch {
    fn from(guarded: Guarded) -> Self {
        match guarded {
            Guarded::Undecided => Self::Undecided,
            Guarded::AcceptedBeyond => Self::Beyond,
        }
    }
}

/// That a value lies farther out than the band shows.
fn arrow(surface: &mut Surface<'_>, [x, y]: Place, direction: f32) {
    let mut builder = PathBuilder::new();
    builder.move_to(x, y);
    builder.line_to(x - 7.0 * direction, y - 5.0);
    builder.line_to(x - 7.0 * direction, y + 5.0);
    builder.close();
    if let Some(path) = builder.finish() {
        outlined(surface, &path, Some(TEXT), Some(Edge { ink: PAPER, width: 0.8, is_dashed: false }));
    }
}

fn filled(surface: &mut Surface<'_>, area: Area, ink: Ink) {
    if let Some(path) = block(area, 0.0) {
        outlined(surface, &path, Some(ink), None);
    }
}

fn line(surface: &mut Surface<'_>, from: Place, to: Place, width: f32, ink: Ink) {
    let mut builder = PathBuilder::new();
    builder.move_to(from[0], from[1]);
    builder.line_to(to[0], to[1]);
    if let Some(path) = builder.finish() {
        outlined(surface, &path, None, Some(Edge { ink, width, is_dashed: false }));
    }
}

/// Fills a path, and draws its edge.
fn outlined(surface: &mut Surface<'_>, path: &Path, ink: Option<Ink>, edge: Option<Edge>) {
    surface.set_fill(ink.map(fill));
    surface.set_stroke(edge.map(stroke));
    if ink.is_some() || edge.is_some() {
        surface.draw_path(path);
    }
    surface.set_stroke(None);
}

fn fill([red, green, blue]: Ink) -> Fill {
    Fill { paint: rgb::Color::new(red, green, blue).into(), opacity: NormalizedF32::ONE, rule: FillRule::NonZero }
}

fn stroke(edge: Edge) -> Stroke {
    let [red, green, blue] = edge.ink;
    Stroke {
        paint: rgb::Color::new(red, green, blue).into(),
        width: edge.width,
        dash: edge.is_dashed.then(|| StrokeDash { array: vec![2.6, 1.9], offset: 0.0 }),
        ..Stroke::default()
    }
}
