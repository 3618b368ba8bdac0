//! The parts of a line of an ISO program.

use super::super::lines::{Front, Piece, front_of, next, trimmed};

/// Reads what precedes a block: `N10`, and the skip mark on either side of it.
pub(super) fn front(line: &str) -> Front {
    front_of(line, is_blank, |rest| rest.strip_prefix(['N', 'n']))
}

fn is_blank(c: char) -> bool {
    c.is_whitespace() || c == '\u{feff}'
}

/// The parts of a line behind its front, and whether its `*` ends the block: behind the code, or behind the comment.
pub(super) fn piece(text: &str, line: usize, from: usize) -> (Piece<'_>, bool) {
    let mut piece = next(text, line, from);
    let mut ends = false;
    let mut goes_on = piece.goes_on;
    let mut without_star = |part: &mut &str| {
        if let Some(before) = part.strip_suffix('*') {
            ends = true;
            *part = trimmed(before);
            // A `~` before it would say that the block goes on.
            if let Some(before) = part.strip_suffix('~') {
                goes_on = true;
                *part = trimmed(before);
            }
        }
    };
    without_star(&mut piece.code);
    if let Some(comment) = &mut piece.comment {
        without_star(comment);
    }
    piece.goes_on = goes_on;
    (piece, ends)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(line: &str, number: Option<u32>, code: &str, comment: Option<&str>, ends: bool) {
        let front = front(line);
        let (piece, does_end) = piece(line, 0, front.end);
        assert_eq!((front.number, piece.code, piece.comment, does_end), (number, code, comment, ends), "{line}");
        assert!(line.get(piece.start..).unwrap().starts_with(code), "{line}");
    }

    #[test]
    fn a_line_is_taken_apart() {
        check("N10 G00 X+5 *", Some(10), "G00 X+5", None, true);
        check("N10G00X+5*", Some(10), "G00X+5", None, true);
        check("/N20 Q1 = Q2 * 3 * ;twice", Some(20), "Q1 = Q2 * 3", Some("twice"), true);
        check("N20 / M8 *", Some(20), "M8", None, true);
        check("N30 ;18 K7 *", Some(30), "", Some("18 K7"), true);
        check(" *", None, "", None, true);
        check("    Q320=+1    ;CLEARANCE ~", None, "Q320=+1", Some("CLEARANCE"), false);
        check("N99999999999 M3 *", None, "N99999999999 M3", None, true);
        check("%A G71 *", None, "%A G71", None, true);
        assert!(front("/N20 M3 *").may_be_skipped && front("N20 /M3 *").may_be_skipped && front("/M3*").may_be_skipped);
    }
}
