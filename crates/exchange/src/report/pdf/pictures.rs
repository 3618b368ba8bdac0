//! The pictures of parts: what can be drawn of them, and where their balloons are.

use std::collections::HashMap;

use fitcheck_core::message::{Message, message};
use fitcheck_core::words::Words;
use krilla::image::Image as Dots;
use usvg::Tree;

use super::bands::narrow;
use super::flow::{Flow, base};
use super::look::{CHIP, GAP, LINE, NOTE, PAPER, RADIUS, TEXT, tone};
use super::sheet::{Area, Edge, Shape};
use super::table::outline;
use super::tags::{Kind, TagId};
use crate::report::image::{Image, ImageKind, broken};
use crate::report::part::PartSheet;
use crate::report::said::balloon_said;
use crate::report::statistics::FeatureStatistics;
use crate::report::{Report, shapes};

/// The most dots of a PNG: all of them are in memory while they are packed anew.
const MOST_DOTS: u64 = 16_000_000;
/// The least and the most height of a picture.
const HEIGHT: [f32; 2] = [150.0, 262.0];
/// The most signs of a balloon's number, and of what is said of a picture.
const LABEL: usize = 4;
const MOST_SAID: usize = 4_000;
/// The size of a balloon.
const BALLOON: f32 = 8.2;

/// A picture that can be drawn.
pub(super) enum Drawable {
    Dots(Dots),
    Shapes(Box<Tree>),
}

impl Drawable {
    /// Its height where it is 1 wide.
    pub fn proportion(&self) -> f32 {
        match self {
            Self::Dots(dots) => {
                let (width, height) = dots.size();
                narrow(f64::from(height) / f64::from(width.max(1)))
            }
            Self::Shapes(tree) => tree.size().height() / tree.size().width(),
        }
    }
}

/// The pictures of a report, each of which is kept once.
#[derive(Default)]
pub(super) struct Pictures {
    pub all: Vec<Drawable>,
    /// The same as they were given, with their names.
    pub sources: Vec<(String, Image)>,
    /// The company's logo.
    pub logo: Option<usize>,
    /// Why it is not shown.
    pub no_logo: Option<Message>,
    /// The statistics of features, each with the place of its charts.
    pub statistics: Vec<(FeatureStatistics, Option<usize>)>,
    /// Of each part: its picture, or why there is none.
    of_parts: Vec<Option<Result<usize, Message>>>,
}

impl Pictures {
    /// Looks at the pictures of all parts. `refused` says why a writer could not do with one of them.
    pub fn of(report: &Report, statistics: Vec<FeatureStatistics>, refused: Option<&str>) -> Self {
        let mut pictures = Self::default();
        let mut known: HashMap<&[u8], Result<usize, Message>> = HashMap::new();
        for part in &report.parts {
            let name = part.picture_name().unwrap_or("");
            let found = part.picture.as_ref().map(|picture| match picture {
                Err(why) => Err(why.clone()),
                Ok(image) => known
                    .entry(image.bytes().as_ref())
                    .or_insert_with(|| {
                        let drawable = match refused {
                            Some(why) => Err(broken(name, &why)),
                            None => drawable(name, image),
                        };
                        drawable.map(|drawable| {
                            pictures.all.push(drawable);
                            pictures.sources.push((name.to_owned(), image.clone()));
                            pictures.all.len() - 1
                        })
                    })
                    .clone(),
            });
            pictures.of_parts.push(found);
        }
        let name = &report.template.company.logo;
        let logo = report.template.logo.clone().filter(|_| !name.is_empty());
        let logo = logo.map(|logo| logo.and_then(|image| Ok((drawable(name, &image)?, image))));
        match logo.filter(|_| refused.is_none()) {
            Some(Ok((drawable, image))) => {
                pictures.logo = Some(pictures.all.len());
                pictures.all.push(drawable);
                pictures.sources.push((name.clone(), image));
            }
            Some(Err(why)) => pictures.no_logo = Some(why),
            None => {}
        }
        for (at, feature) in statistics.into_iter().enumerate() {
            let charts = feature.charts.as_ref().filter(|_| refused.is_none());
            let name = format!("charts-{}.svg", at + 1);
            let charts = charts.and_then(|svg| Image::read(&name, svg.as_bytes()).ok());
            let drawn = charts.and_then(|image| Some((drawable(&name, &image).ok()?, image)));
            let place = drawn.map(|(drawable, image)| {
                pictures.all.push(drawable);
                pictures.sources.push((name, image));
                pictures.all.len() - 1
            });
            pictures.statistics.push((feature, place));
        }
        pictures
    }

    /// Writes the picture of a part with its balloons, as large as what is below it allows, or why there is none.
    pub fn write(
        &self,
        flow: &mut Flow<'_>,
        section: TagId,
        part: &PartSheet,
        (number, below): (usize, f32),
        words: &Words,
    ) {
        match self.of_parts.get(number) {
            Some(Some(Ok(picture))) => {
                if let Some(drawable) = self.all.get(*picture) {
                    shown(flow, section, part, (*picture, drawable, below), words);
                }
            }
            Some(Some(Err(why))) => flow.paragraph(section, NOTE.in_ink(TEXT), &words.say(why)),
            _ => {}
        }
    }
}

/// What can be drawn of a picture.
fn drawable(name: &str, image: &Image) -> Result<Drawable, Message> {
    let failed = |error: String| broken(name, &error);
    match image.kind() {
        ImageKind::Svg => {
            let tree = shapes::tree(name, image.bytes())?;
            if svg_is_shown(&tree) {
                Ok(Drawable::Shapes(Box::new(tree)))
            } else {
                Err(message!("parts-page-picture-heavy").text("name", name))
            }
        }
        ImageKind::Png => {
            let dots = image.dots().map_or(0, |(width, height)| u64::from(width) * u64::from(height));
            if MOST_DOTS < dots {
                return Err(message!("report-picture-room").text("name", name));
            }
            Dots::from_png(image.bytes().to_vec().into(), false).map(Drawable::Dots).map_err(failed)
        }
        ImageKind::Jpeg => Dots::from_jpeg(image.bytes().to_vec().into(), false).map(Drawable::Dots).map_err(failed),
    }
}

fn svg_is_shown(tree: &Tree) -> bool {
    super::svg::can_draw(tree)
}

/// The picture in its frame.
fn shown(
    flow: &mut Flow<'_>,
    section: TagId,
    part: &PartSheet,
    (number, drawable, below): (usize, &Drawable, f32),
    words: &Words,
) {
    let width = flow.width();
    let free = flow.bottom() - flow.y - below;
    let most = if free < HEIGHT[0] { HEIGHT[1] } else { free.min(HEIGHT[1]) };
    let height = (drawable.proportion() * (width - 16.0) + 12.0 + NOTE.line()).clamp(60.0, most);
    flow.room(height);
    let frame = Area::new(super::look::SIDE, flow.y, width, height);
    let edge = Edge { ink: LINE, width: 0.8, is_dashed: false };
    flow.put(None, Shape::Block { area: frame, radius: RADIUS, fill: Some(PAPER), edge: Some(edge) });
    // The caption has its place below the picture.
    let room = Area::new(frame.x + 8.0, frame.y + 8.0, frame.width - 16.0, frame.height - 12.0 - NOTE.line());
    let scaled = (room.height / drawable.proportion().max(1e-4)).min(room.width);
    let [x, y] = room.middle();
    let tall = scaled * drawable.proportion();
    let area = Area::new(x - scaled / 2.0, y - tall / 2.0, scaled, tall);
    let place = Some((flow.page(), [frame.x, frame.y, frame.width, frame.height]));
    let figure = flow.tags.add(section, Kind::Figure(said(part, words), place));
    flow.put(Some(figure), Shape::Picture(area, number));
    let beside = balloons(flow, figure, part, area);
    let mut caption = part.plan.head.picture.clone();
    if 0 < beside {
        caption = format!("{caption}; {}", words.say(&message!("report-picture-beside").count("count", beside)));
    }
    let element = flow.tags.add(section, Kind::Paragraph);
    let at = base(frame.bottom() - NOTE.line() - 3.0, NOTE.line(), NOTE);
    for line in flow.wrap(&caption, NOTE, width - 16.0, 1) {
        flow.say(Some(element), [frame.x + 8.0, at], NOTE, line);
    }
    flow.y += height + GAP / 2.0;
}

/// Draws the balloons; gives how many features have none.
fn balloons(flow: &mut Flow<'_>, figure: TagId, part: &PartSheet, area: Area) -> usize {
    let mut beside = 0;
    for (label, feature, standing) in labelled(part) {
        let Some([x, y]) = feature.balloon else {
            beside += 1;
            continue;
        };
        let share = |share: f64| narrow(share.clamp(0.0, 1.0));
        let middle = [area.x + area.width * share(x), area.y + area.height * share(y)];
        let label: String = label.chars().take(LABEL).collect();
        flow.put(Some(figure), outline(standing.status, standing.is_simulated, middle, BALLOON));
        let ink = if standing.is_simulated { TEXT } else { tone(standing.status).on };
        let style = CHIP.in_ink(ink);
        let at = base(middle[1] - BALLOON, 2.0 * BALLOON, style);
        flow.say_round(Some(figure), [middle[0], at], style, label);
    }
    beside
}

/// The picture in words: every balloon and what became of it, up to a length that can still be listened to.
fn said(part: &PartSheet, words: &Words) -> String {
    let mut said = words.get("parts-page-picture");
    for (label, feature, standing) in labelled(part).filter(|(_, feature, _)| feature.balloon.is_some()) {
        let next = balloon_said(&label, &feature.name, &standing, words);
        if MOST_SAID < said.len() + next.len() {
            said.push_str("; …");
            break;
        }
        said.push_str("; ");
        said.push_str(&next);
    }
    super::fonts::Fonts::clean(&said).into_owned()
}

/// The features with the numbers of their balloons, and what became of them.
fn labelled(
    part: &PartSheet,
) -> impl Iterator<Item = (String, &fitcheck_core::part::PlanFeature, fitcheck_core::part::FeatureStanding)> {
    let features = (1_usize..).zip(part.plan.features()).zip(part.features());
    features.map(|((place, feature), standing)| {
        let label = if feature.number.is_empty() { place.to_string() } else { feature.number.clone() };
        (label, feature, standing)
    })
}
