//! A feature of a simulated part in words: its name, kind, size and place.

use fitcheck_core::message::Message;
use fitcheck_core::probing::simulated::{Face, FreePoint, PartFeature, Shape, Surface};

/// The name of a shape's word.
pub const fn shape_id(shape: Shape) -> &'static str {
    match shape {
        Shape::Hole => "cycles-shape-bore",
        Shape::Stud => "cycles-shape-stud",
        Shape::Face => "cycles-shape-face",
        Shape::Point => "cycles-shape-point",
        Shape::Slot => "cycles-shape-slot",
        Shape::Ridge => "cycles-shape-ridge",
        Shape::Pocket => "cycles-shape-pocket",
        Shape::Boss => "cycles-shape-boss",
    }
}

/// A feature in one line, for people.
pub fn feature_message(feature: &PartFeature) -> Message {
    let surface = &feature.surface;
    let message = |id| {
        let kind = Message::new(shape_id(surface.shape()));
        Message::new(id).text("name", &feature.name).message("kind", kind)
    };
    let at = |message: Message, centre: [f64; 2]| {
        let ([first, second], [x, y]) = (surface.plane().axes(), centre);
        message.text("first", first).text("second", second).number("x", x).number("y", y)
    };
    match surface {
        Surface::Round(round, _) => at(message("part-round").number("size", round.diameter), round.centre),
        Surface::Walls(walls) => match walls.lengths {
            (width, None) => at(message("part-width").number("size", width), walls.centre),
            (one, Some(other)) => at(message("part-sides").number("size", one).number("size2", other), walls.centre),
        },
        Surface::Face(Face { point: [x, y, z], .. }) | Surface::Point(FreePoint { point: [x, y, z], .. }) => {
            message("part-face").number("x", x).number("y", y).number("z", z)
        }
    }
}
