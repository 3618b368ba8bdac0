//! Text in lines: broken where it may be, cut with an ellipsis where there is no more room.

use super::fonts::{ELLIPSIS, Fonts};
use super::look::Style;

/// A text in lines. Every line but the last one keeps the space that it was broken at, so that what is copied or read aloud has its words apart.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Wrapped {
    pub lines: Vec<String>,
    /// Whether some of it is left out.
    pub is_cut: bool,
}

/// Breaks a text into at most so many lines of this width. It takes no longer than the lines that it makes.
pub(super) fn wrap(fonts: &Fonts, text: &str, style: Style, width: f32, most: usize) -> Wrapped {
    let width = width / style.size;
    let mut wrapped = Wrapped::default();
    let mut start = 0;
    while wrapped.lines.len() < most {
        let rest = text.get(start..).unwrap_or("");
        let Some(end) = line_end(fonts, rest, style, width) else {
            wrapped.lines.push(rest.to_owned());
            return wrapped;
        };
        let is_last = wrapped.lines.len() + 1 == most;
        if is_last {
            wrapped.lines.push(cut(fonts, rest, style, width));
            wrapped.is_cut = true;
            return wrapped;
        }
        wrapped.lines.push(rest.get(..end).unwrap_or("").to_owned());
        start += end;
    }
    wrapped.is_cut = start < text.len();
    wrapped
}

/// Where a line of this width, in ems, ends; `None` where the rest of the text fits.
fn line_end(fonts: &Fonts, text: &str, style: Style, width: f32) -> Option<usize> {
    let mut taken = 0.0;
    let mut space = None;
    let mut mark = None;
    for (at, sign) in text.char_indices() {
        let end = at + sign.len_utf8();
        taken += fonts.advance(sign, style.weight);
        // A space at the end of a line takes no room.
        if sign == ' ' {
            space = Some(end);
            continue;
        }
        if width < taken {
            // Better within a word than a line of which little is used.
            let first = text.chars().next().map_or(0, char::len_utf8);
            return Some(space.or(mark).unwrap_or(at).max(first)).filter(|end| *end < text.len());
        }
        if matches!(sign, '-' | '/' | '_' | ',' | ';' | '.' | '\\') {
            mark = Some(end);
        }
    }
    None
}

/// As much of a text as fits in a line with an ellipsis.
fn cut(fonts: &Fonts, text: &str, style: Style, width: f32) -> String {
    let mut taken = fonts.advance(ELLIPSIS, style.weight);
    let mut line = String::new();
    for sign in text.chars() {
        taken += fonts.advance(sign, style.weight);
        if width < taken {
            break;
        }
        line.push(sign);
    }
    line.truncate(line.trim_end().len());
    line.push(ELLIPSIS);
    line
}

#[cfg(test)]
mod tests {
    use super::super::look::BODY;
    use super::*;

    #[track_caller]
    fn check(text: &str, width: f32, most: usize, lines: &[&str], is_cut: bool) {
        let wrapped = wrap(&Fonts::new().unwrap(), text, BODY, width, most);
        assert_eq!((wrapped.lines, wrapped.is_cut), (lines.iter().map(ToString::to_string).collect(), is_cut));
    }

    #[test]
    fn lines_break_at_spaces_then_at_marks_then_anywhere() {
        check("", 50.0, 2, &[""], false);
        check("one two three", 500.0, 1, &["one two three"], false);
        check("one two three", 40.0, 3, &["one two ", "three"], false);
        check("one-two-three", 30.0, 3, &["one-", "two-", "three"], false);
        check("MMMMMMMM", 24.0, 9, &["MMM", "MMM", "MM"], false);
        check("M", 1.0, 2, &["M"], false);
    }

    #[test]
    fn what_has_no_room_ends_in_an_ellipsis() {
        check("one two three fourteen", 40.0, 2, &["one two ", "three fo…"], true);
        check(&"M".repeat(10_000), 24.0, 2, &["MMM", "MM…"], true);
    }
}
