//! Blocks of a program after which the numbers of the next ones mean other places: a shift, a rotation, a mirror, a scale, a tilted plane.

/// Whether a block, in capitals and without its number, moves the system of coordinates. What only resets it does not; a value that is a
/// parameter may.
pub(super) fn moves_coordinates(block: &str) -> bool {
    let words: Vec<&str> = block.split_whitespace().filter(|word| *word != "*").collect();
    let differs = |words: &[&str], neutral: f64| words.iter().any(|word| is_other(word, neutral));
    match words.as_slice() {
        ["CYCL", "DEF", number, values @ ..] => match number.split_once('.') {
            None | Some((_, "0")) => false,
            Some(("7" | "10" | "19", _)) => differs(values, 0.0),
            Some(("8", _)) => !values.is_empty(),
            Some(("11" | "26", _)) => differs(values, 1.0),
            Some(_) => false,
        },
        ["PLANE", "RESET", ..] | ["TRANS", _, "RESET", ..] => false,
        ["PLANE", "SPATIAL" | "PROJECTED" | "EULER" | "RELATIV" | "RELATIVE", values @ ..] => {
            let is_angle = |word: &&str| !["MB", "F", "DIST", "SEQ"].iter().any(|other| word.starts_with(other));
            differs(&values.iter().copied().filter(is_angle).collect::<Vec<_>>(), 0.0)
        }
        ["PLANE", ..] | ["TRANS", "MIRROR", ..] | ["TRANS", "DATUM", "TABLE", ..] => true,
        ["TRANS", "DATUM" | "ROTATION", values @ ..] | ["G54" | "G73" | "G80", values @ ..] => differs(values, 0.0),
        ["TRANS", "SCALE", values @ ..] | ["G72", values @ ..] => differs(values, 1.0),
        ["G28", axes @ ..] => !axes.is_empty(),
        _ => false,
    }
}

/// Whether a word has a value other than this one: `X+10`, `ROT+Q1`. A word alone has none, and a function beside it is another one.
fn is_other(word: &str, neutral: f64) -> bool {
    if word.starts_with('G') {
        return false;
    }
    let at = word.find(|c: char| c.is_ascii_digit() || "+-.#".contains(c));
    let Some(value) = at.and_then(|at| word.get(at..)) else { return false };
    value.replace(',', ".").trim_end_matches('*').parse() != Ok(neutral)
}

#[cfg(test)]
mod tests {
    use super::moves_coordinates;

    #[test]
    fn blocks_that_move_the_coordinates_are_known() {
        for block in [
            "CYCL DEF 7.1 X+10",
            "CYCL DEF 7.1 #5",
            "CYCL DEF 7.2 Y+Q1",
            "CYCL DEF 8.1 X",
            "CYCL DEF 10.1 ROT+15",
            "CYCL DEF 11.1 SCL 0.99",
            "CYCL DEF 26.1 X1.001 Y1",
            "CYCL DEF 19.1 A+0 B+30",
            "PLANE SPATIAL SPA+0 SPB+30 SPC+0 STAY",
            "PLANE POINTS P1X+0",
            "TRANS DATUM AXIS X+10",
            "TRANS MIRROR AXIS X",
            "TRANS ROTATION ROT+15",
            "TRANS SCALE SCL 1.01",
            "G54 X+10 Y+0 *",
            "G28 X *",
            "G73 G90 H+30*",
            "G72 F0.99*",
        ] {
            assert!(moves_coordinates(block), "{block}");
        }
    }

    #[test]
    fn blocks_that_only_reset_them_do_not() {
        for block in [
            "CYCL DEF 7.0 DATUM SHIFT",
            "CYCL DEF 7.1 X+0",
            "CYCL DEF 8.1",
            "CYCL DEF 10.1 ROT+0",
            "CYCL DEF 11.1 SCL 1",
            "CYCL DEF 32.1 T0.05",
            "CYCL DEF 247 DATUM SETTING",
            "PLANE RESET STAY",
            "PLANE SPATIAL SPA+0 SPB+0 SPC+0 TURN MB MAX FMAX",
            "TRANS DATUM RESET",
            "TRANS DATUM AXIS X+0 Y+0",
            "G54 X+0 *",
            "G28 *",
            "G73 H+0*",
            "L X+10 R0 FMAX",
        ] {
            assert!(!moves_coordinates(block), "{block}");
        }
    }
}
