//! The shapes of an SVG picture on a page. What would need dots, such as masks, is refused before.

use krilla::color::rgb;
use krilla::geom::{Path, PathBuilder, Transform};
use krilla::num::NormalizedF32;
use krilla::paint::{
    Fill, FillRule, LineCap, LineJoin, LinearGradient, Paint, Pattern, RadialGradient, SpreadMethod, Stop, Stroke,
    StrokeDash,
};
use krilla::surface::Surface;
use usvg::tiny_skia_path::{self as skia, PathSegment};
use usvg::{ClipPath, Group, Node, PaintOrder, Tree};

/// Whether all of it can be drawn: without masks, and without layers that are mixed with what is below them.
pub(super) fn can_draw(tree: &Tree) -> bool {
    tree.masks().is_empty() && tree.filters().is_empty() && is_plain(tree.root())
}

fn is_plain(group: &Group) -> bool {
    let is_plain_node = |node: &Node| match node {
        Node::Group(group) => is_plain(group),
        _ => true,
    };
    group.blend_mode() == usvg::BlendMode::Normal && group.children().iter().all(is_plain_node)
}

/// Draws it, its upper left corner at the origin, in its own units.
pub(super) fn draw(surface: &mut Surface<'_>, tree: &Tree) {
    group(surface, tree.root());
}

fn group(surface: &mut Surface<'_>, of: &Group) {
    let clips = clips(of);
    for clip in &clips {
        surface.push_clip_path(clip, &FillRule::NonZero);
    }
    let opacity = normal(of.opacity().get());
    surface.push_opacity(opacity);
    for node in of.children() {
        match node {
            Node::Group(inner) => group(surface, inner),
            Node::Path(path) if path.is_visible() => draw_path(surface, path),
            Node::Text(text) => group(surface, text.flattened()),
            // Pictures within the picture are not read.
            Node::Path(_) | Node::Image(_) => {}
        }
    }
    surface.pop();
    for _ in &clips {
        surface.pop();
    }
}

/// What a group is cut to, from the outermost one.
fn clips(of: &Group) -> Vec<Path> {
    let mut clips = Vec::new();
    let mut next = of.clip_path();
    while let Some(clip) = next {
        let transform = of.abs_transform().pre_concat(clip.transform());
        let mut builder = PathBuilder::new();
        outline(&mut builder, clip.root(), transform);
        // A cut to nothing shows nothing.
        clips.extend(builder.finish().or_else(nothing));
        next = ClipPath::clip_path(clip);
    }
    clips.reverse();
    clips
}

/// A path that nothing is within.
fn nothing() -> Option<Path> {
    let mut builder = PathBuilder::new();
    builder.move_to(0.0, 0.0);
    builder.line_to(1e-3, 0.0);
    builder.line_to(0.0, 1e-3);
    builder.close();
    builder.finish()
}

/// Adds the outlines of all paths of a group.
fn outline(builder: &mut PathBuilder, of: &Group, transform: skia::Transform) {
    for node in of.children() {
        match node {
            Node::Group(inner) => outline(builder, inner, transform),
            Node::Text(text) => outline(builder, text.flattened(), transform),
            Node::Path(path) => {
                let at = transform.pre_concat(path.abs_transform());
                if let Some(path) = path.data().clone().transform(at) {
                    add(builder, &path);
                }
            }
            Node::Image(_) => {}
        }
    }
}

fn add(builder: &mut PathBuilder, path: &skia::Path) {
    let at = |point: skia::Point| (rounded(point.x), rounded(point.y));
    for segment in path.segments() {
        match segment {
            PathSegment::MoveTo(to) => {
                let (x, y) = at(to);
                builder.move_to(x, y);
            }
            PathSegment::LineTo(to) => {
                let (x, y) = at(to);
                builder.line_to(x, y);
            }
            PathSegment::QuadTo(by, to) => {
                let ((x1, y1), (x, y)) = (at(by), at(to));
                builder.quad_to(x1, y1, x, y);
            }
            PathSegment::CubicTo(by, and, to) => {
                let ((x1, y1), (x2, y2), (x, y)) = (at(by), at(and), at(to));
                builder.cubic_to(x1, y1, x2, y2, x, y);
            }
            PathSegment::Close => builder.close(),
        }
    }
}

/// To a ten-thousandth, less than is seen. Arcs come with the sines of the system, and a quarter of a circle ends near zero: its
/// last digits, which differ from one system to the next, would make two files of one report.
fn rounded(coordinate: f32) -> f32 {
    (coordinate * 1e4).round() / 1e4 + 0.0
}

fn draw_path(surface: &mut Surface<'_>, path: &usvg::Path) {
    let mut builder = PathBuilder::new();
    add(&mut builder, path.data());
    let Some(data) = builder.finish() else { return };
    let fill = path.fill().map(|of| Fill {
        paint: paint(surface, of.paint()),
        opacity: normal(of.opacity().get()),
        rule: match of.rule() {
            usvg::FillRule::NonZero => FillRule::NonZero,
            usvg::FillRule::EvenOdd => FillRule::EvenOdd,
        },
    });
    let stroke = path.stroke().map(|of| stroke(surface, of));
    surface.push_transform(&transform(path.abs_transform()));
    let mut both = [(fill, None), (None, stroke)];
    if path.paint_order() == PaintOrder::StrokeAndFill {
        both.reverse();
    }
    for (fill, stroke) in both {
        if fill.is_some() || stroke.is_some() {
            surface.set_fill(fill);
            surface.set_stroke(stroke);
            surface.draw_path(&data);
        }
    }
    surface.pop();
    surface.set_stroke(None);
}

fn stroke(surface: &mut Surface<'_>, of: &usvg::Stroke) -> Stroke {
    Stroke {
        paint: paint(surface, of.paint()),
        width: of.width().get(),
        miter_limit: of.miterlimit().get(),
        line_cap: match of.linecap() {
            usvg::LineCap::Butt => LineCap::Butt,
            usvg::LineCap::Round => LineCap::Round,
            usvg::LineCap::Square => LineCap::Square,
        },
        line_join: match of.linejoin() {
            usvg::LineJoin::Miter | usvg::LineJoin::MiterClip => LineJoin::Miter,
            usvg::LineJoin::Round => LineJoin::Round,
            usvg::LineJoin::Bevel => LineJoin::Bevel,
        },
        opacity: normal(of.opacity().get()),
        dash: of.dasharray().map(|dashes| StrokeDash { array: dashes.to_vec(), offset: of.dashoffset() }),
    }
}

/// Colours and gradients. A gradient ends with its last colour: to repeat it, a file that is kept would need a program.
fn paint(surface: &mut Surface<'_>, of: &usvg::Paint) -> Paint {
    match of {
        usvg::Paint::Color(colour) => rgb::Color::new(colour.red, colour.green, colour.blue).into(),
        usvg::Paint::LinearGradient(of) => LinearGradient {
            x1: of.x1(),
            y1: of.y1(),
            x2: of.x2(),
            y2: of.y2(),
            transform: transform(of.transform()),
            spread_method: SpreadMethod::Pad,
            stops: of.stops().iter().map(stop).collect(),
            anti_alias: false,
        }
        .into(),
        usvg::Paint::RadialGradient(of) => RadialGradient {
            cx: of.cx(),
            cy: of.cy(),
            cr: of.r().get(),
            fx: of.fx(),
            fy: of.fy(),
            fr: of.fr().get(),
            transform: transform(of.transform()),
            spread_method: SpreadMethod::Pad,
            stops: of.stops().iter().map(stop).collect(),
            anti_alias: false,
        }
        .into(),
        usvg::Paint::Pattern(of) => {
            let mut builder = surface.stream_builder();
            let mut tile = builder.surface();
            group(&mut tile, of.root());
            tile.finish();
            let place = skia::Transform::from_translate(of.rect().x(), of.rect().y());
            Pattern {
                stream: builder.finish(),
                transform: transform(of.transform().pre_concat(place)),
                width: of.rect().width(),
                height: of.rect().height(),
            }
            .into()
        }
    }
}

fn stop(of: &usvg::Stop) -> Stop {
    let colour = of.color();
    Stop {
        offset: normal(of.offset().get()),
        color: rgb::Color::new(colour.red, colour.green, colour.blue).into(),
        opacity: normal(of.opacity().get()),
    }
}

fn normal(share: f32) -> NormalizedF32 {
    NormalizedF32::new(share.clamp(0.0, 1.0)).unwrap_or(NormalizedF32::ONE)
}

fn transform(of: skia::Transform) -> Transform {
    Transform::from_row(of.sx, of.ky, of.kx, of.sy, of.tx, of.ty)
}
