//! The statistics of each feature, on a page of its own: figures, charts, and what they say.

use super::flow::Flow;
use super::head;
use super::look::{BODY, GAP, SIDE};
use super::pictures::Pictures;
use super::sheet::{Area, Shape};
use super::tags::{Kind, Tags};

/// Writes them; gives their headings with their places.
pub(super) fn write(flow: &mut Flow<'_>, pictures: &Pictures) -> Vec<(String, usize, f32)> {
    let mut outline = Vec::new();
    for (feature, picture) in &pictures.statistics {
        flow.turn();
        outline.push((feature.heading.clone(), flow.page(), flow.y));
        let section = flow.tags.add(Tags::ROOT, Kind::Section);
        head::write_heading(flow, section, &feature.heading);
        flow.paragraph(section, BODY, &feature.read);
        flow.y += GAP / 2.0;
        head::write_card(flow, section, None, &feature.figures);
        if let Some((number, drawable)) = picture.and_then(|number| Some((number, pictures.all.get(number)?))) {
            let area = Area::new(SIDE, flow.y, flow.width(), flow.width() * drawable.proportion());
            flow.room(area.height);
            let area = Area::new(SIDE, flow.y, area.width, area.height);
            let place = Some((flow.page(), [area.x, area.y, area.width, area.height]));
            let figure = flow.tags.add(section, Kind::Figure(feature.said(), place));
            flow.put(Some(figure), Shape::Picture(area, number));
            flow.y += area.height + GAP;
        }
        for line in &feature.told {
            flow.paragraph(section, BODY, line);
            flow.y += 2.0;
        }
    }
    outline
}
