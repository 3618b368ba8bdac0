//! What is drawn where: titles, scales and labels have their room.

use eframe::egui::{Rect, Shape};

use super::*;

/// The texts of a drawing and where they are, and the lines of it.
fn painted(harness: &Harness<'_>) -> (Vec<(String, Rect)>, Vec<Rect>) {
    fn collect(shape: &Shape, texts: &mut Vec<(String, Rect)>, lines: &mut Vec<Rect>) {
        match shape {
            Shape::Vec(shapes) => shapes.iter().for_each(|shape| collect(shape, texts, lines)),
            Shape::Text(text) => texts.push((text.galley.text().to_owned(), text.visual_bounding_rect())),
            Shape::LineSegment { .. } | Shape::Path(_) | Shape::Circle(_) => lines.push(shape.visual_bounding_rect()),
            _ => {}
        }
    }
    let mut texts = Vec::new();
    let mut lines = Vec::new();
    for clipped in &harness.output().shapes {
        collect(&clipped.shape, &mut texts, &mut lines);
    }
    (texts, lines)
}

#[test]
fn a_path_seen_as_a_point_has_a_scale_that_a_person_can_use() {
    // The ball goes straight down to the face: from above it is one point.
    let (result, nominal) = top(5.0);
    let harness = drawn([640.0, 400.0], Theme::Light, Language::En, |ui, view| {
        path_picture(ui, view, &result.path, 3, Surroundings::of(Some(nominal), 0.0));
    });
    let (texts, _) = painted(&harness);
    let scales: Vec<f64> = texts.iter().filter_map(|(text, _)| text.strip_suffix(" mm")?.parse().ok()).collect();
    assert_eq!(scales.len(), 2, "{texts:?}");
    assert!(scales.iter().all(|mm| (0.5..=20.0).contains(mm)), "{scales:?}");
}

#[test]
fn no_line_of_a_path_crosses_the_title_of_its_view() {
    let (result, nominal) = bore();
    for size in [[640.0, 400.0], [330.0, 220.0], [230.0, 150.0]] {
        let harness = drawn(size, Theme::Light, Language::En, |ui, view| {
            path_picture(ui, view, &result.path, result.path.len(), Surroundings::of(Some(nominal), 2.0));
        });
        let (texts, lines) = painted(&harness);
        let titles: Vec<_> = texts.iter().filter(|(text, _)| text.starts_with("X/")).collect();
        assert_eq!(titles.len(), 2, "{texts:?}");
        for (title, rect) in titles {
            assert!(!lines.iter().any(|line| line.intersects(rect.shrink(1.0))), "{title} at {size:?}");
            let covers = |(text, other): &&(String, Rect)| text != title && other.intersects(*rect);
            assert_eq!(texts.iter().find(covers), None, "{title} at {size:?}");
        }
    }
}

#[test]
fn a_narrow_picture_of_contacts_keeps_its_circle_and_tells_the_deviations_below() {
    let (result, _) = bore();
    let shown = |width: f32| {
        let harness = drawn([width, 220.0], Theme::Light, Language::En, |ui, view| {
            contacts_picture(ui, view, &result, None);
        });
        let (texts, lines) = painted(&harness);
        let widest = lines.iter().map(Rect::width).fold(0.0, f32::max);
        (texts.into_iter().map(|(text, _)| text).collect::<Vec<_>>(), widest)
    };
    let (wide, _) = shown(420.0);
    assert!(wide.iter().any(|text| text.starts_with("1  ") && !text.contains("2  ")), "{wide:?}");
    let (narrow, circle) = shown(200.0);
    assert!(narrow.contains(&"1".to_owned()), "{narrow:?}");
    assert!(narrow.iter().any(|text| text.starts_with("1  ") && text.contains("4  ")), "{narrow:?}");
    assert!(60.0 < circle, "{circle}");
}
