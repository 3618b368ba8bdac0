//! A drawing as SVG. Colours are those of a light page; the sides of a chart are told apart by their lines, too, so a grey printer suffices.

use std::fmt::Write as _;

use super::{Anchor, Mark, Picture, TEXT_SIZE, Tone};

const fn colour(tone: Tone) -> &'static str {
    match tone {
        Tone::Text | Tone::Law => "#14181f",
        Tone::Quiet => "#4a5363",
        Tone::Ground => "#f5f7fa",
        Tone::Grid => "#e1e6ed",
        Tone::Data | Tone::Centre | Tone::Control => "#274d82",
        Tone::Bar => "#7d9ab5",
        Tone::Limit => "#14452f",
        Tone::Zone => "#e2f3ea",
        Tone::Signal => "#dfe7f3",
        Tone::LeftOut => "#69748a",
        Tone::Band => "#dde5ed",
    }
}

/// The whole file, with the sentence that a screen reader says.
pub fn svg(picture: &Picture, said: &str) -> String {
    let [width, height] = picture.size;
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" \
         role=\"img\" font-family=\"sans-serif\" font-size=\"{TEXT_SIZE}\"><title>{}</title>\n<rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n",
        escaped(said)
    );
    for mark in &picture.marks {
        put(&mut text, mark);
    }
    text.push_str("</svg>\n");
    text
}

fn put(out: &mut String, mark: &Mark) {
    // Writing to a text cannot fail.
    let _infallible = match mark {
        Mark::Area { from: [left, top], to: [right, below], tone } => writeln!(
            out,
            "<rect x=\"{left:.2}\" y=\"{top:.2}\" width=\"{:.2}\" height=\"{:.2}\" fill=\"{}\"/>",
            right - left,
            below - top,
            colour(*tone)
        ),
        Mark::Shape { points, tone } => {
            writeln!(out, "<polygon points=\"{}\" fill=\"{}\"/>", corners(points), colour(*tone))
        }
        Mark::Line { points, tone, width, is_dashed } => {
            let dashes = if *is_dashed { " stroke-dasharray=\"7 5\"" } else { "" };
            let points = corners(points);
            let colour = colour(*tone);
            writeln!(
                out,
                "<polyline points=\"{points}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\"{dashes}/>"
            )
        }
        Mark::Dot { at: [x, y], radius, tone } => {
            writeln!(out, "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"{radius}\" fill=\"{}\"/>", colour(*tone))
        }
        Mark::Ring { at: [x, y], radius, tone } => writeln!(
            out,
            "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"{radius}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>",
            colour(*tone)
        ),
        Mark::Text { at: [x, y], anchor, is_bold, tone, text } => {
            let anchor = match anchor {
                Anchor::Start => "start",
                Anchor::Middle => "middle",
                Anchor::End => "end",
            };
            let weight = if *is_bold { " font-weight=\"bold\"" } else { "" };
            // The middle of small letters and figures is about a third of the size above the line.
            let line = y + TEXT_SIZE * 0.35;
            let (colour, text) = (colour(*tone), escaped(text));
            writeln!(
                out,
                "<text x=\"{x:.2}\" y=\"{line:.2}\" text-anchor=\"{anchor}\" fill=\"{colour}\"{weight}>{text}</text>"
            )
        }
    };
}

fn corners(points: &[[f64; 2]]) -> String {
    let corners: Vec<String> = points.iter().map(|[x, y]| format!("{x:.2},{y:.2}")).collect();
    corners.join(" ")
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
