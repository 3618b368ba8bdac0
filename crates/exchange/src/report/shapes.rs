//! The picture of a part as shapes: an SVG file read for drawing, and one that would take long refused before it is drawn.

use std::sync::Arc;

use fitcheck_core::message::{Message, message};
use fitcheck_shipped::fonts;
use resvg::tiny_skia::{Pixmap, Transform};
use usvg::{Group, ImageHrefResolver, Node, Options, Tree};

use super::image::{broken, check_dots};

/// The most shapes, each counted as often as it is drawn.
const MOST_SHAPES: usize = 200_000;

/// The most groups that are drawn apart and then put together, in all and within each other: each has dots of its own.
const MOST_LAYERS: usize = 256;
const MOST_DEEP: usize = 12;

/// The largest tile of a pattern, the side in units of the picture.
const LARGEST_TILE: f32 = 1_000.0;

/// How often the filled shapes may cover the picture.
const MOST_COVERS: f32 = 1_000.0;

/// The shapes and texts of an SVG file with this name. Other files and pictures within it are left out; its texts have the program's own font.
///
/// # Errors
/// Why it is refused: it cannot be read, or it would take long to draw.
pub fn tree(name: &str, bytes: &[u8]) -> Result<Tree, Message> {
    let mut options = Options {
        resources_dir: None,
        image_href_resolver: ImageHrefResolver {
            resolve_data: Box::new(|_, _, _| None),
            resolve_string: Box::new(|_, _| None),
        },
        ..Options::default()
    };
    let all = Arc::make_mut(&mut options.fontdb);
    all.load_font_data(fonts::SANS.to_vec());
    let family = all.faces().find_map(|face| Some(face.families.first()?.0.clone()));
    if let Some(family) = family {
        all.set_sans_serif_family(family.clone());
        all.set_serif_family(family.clone());
        all.set_monospace_family(family.clone());
        options.font_family = family;
    }
    let tree = Tree::from_data(bytes, &options).map_err(|error| broken(name, &error))?;
    if is_light(&tree) { Ok(tree) } else { Err(message!("parts-page-picture-heavy").text("name", name)) }
}

/// The dots of a picture in this size: red, green, blue and opacity, row by row.
///
/// # Errors
/// A side of no dots, or more than fit.
pub fn dots(name: &str, tree: &Tree, [width, height]: [u32; 2]) -> Result<Vec<u8>, Message> {
    check_dots(name, (width, height))?;
    let ratio = |drawn: u32, given: f32| u16::try_from(drawn).map_or(1.0, |drawn| f32::from(drawn) / given.max(1e-3));
    let [x, y] = [ratio(width, tree.size().width()), ratio(height, tree.size().height())];
    let mut map = Pixmap::new(width, height).ok_or_else(|| broken(name, &"0 × 0"))?;
    resvg::render(tree, Transform::from_scale(x, y), &mut map.as_mut());
    let dots = map.pixels().iter().flat_map(|dot| {
        let dot = dot.demultiply();
        [dot.red(), dot.green(), dot.blue(), dot.alpha()]
    });
    Ok(dots.collect())
}

/// What drawing a picture needs.
struct Work {
    shapes: usize,
    layers: usize,
    covers: f32,
    /// The size of the whole picture.
    area: f32,
}

/// Whether a picture is drawn in a reasonable time and room.
fn is_light(tree: &Tree) -> bool {
    let is_small = |side: f32| side <= LARGEST_TILE;
    let mut patterns = tree.patterns().iter();
    let tiles = patterns.all(|pattern| is_small(pattern.rect().width()) && is_small(pattern.rect().height()));
    let area = (tree.size().width() * tree.size().height()).max(1.0);
    let mut work = Work { shapes: 0, layers: 0, covers: 0.0, area };
    // Filters repeat their steps as often as a file says.
    tiles && tree.filters().is_empty() && work.add(tree.root(), 0)
}

impl Work {
    /// Adds what a group needs; whether it still is little enough.
    fn add(&mut self, group: &Group, deep: usize) -> bool {
        let deep = deep + usize::from(group.should_isolate());
        self.layers += usize::from(group.should_isolate());
        for node in group.children() {
            self.shapes += 1;
            if let Node::Path(path) = node
                && path.fill().is_some()
            {
                let of = path.abs_bounding_box();
                self.covers += (of.width() * of.height() / self.area).min(1.0);
            }
            let mut is_light = self.is_little(deep);
            if let Node::Group(group) = node {
                is_light = is_light && self.add(group, deep);
            }
            node.subroots(|group| is_light = is_light && self.add(group, deep));
            if !is_light {
                return false;
            }
        }
        self.is_little(deep)
    }

    fn is_little(&self, deep: usize) -> bool {
        self.shapes <= MOST_SHAPES && self.layers <= MOST_LAYERS && deep <= MOST_DEEP && self.covers <= MOST_COVERS
    }
}
