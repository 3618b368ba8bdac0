//! The masks of a set, made from the built-in ones.

use fitcheck_core::probing::cycle::Window;
use fitcheck_core::tolerance::Feature;
use fitcheck_shipped as shipped;

use super::Target;
use super::called::Called;
use super::names::Control;

/// The mask, lines in CRLF. iTNC 530: that of a diameter as built in, the Dutch one as NC-Solution 8255 has it. Otherwise
/// every record ends in a semicolon, with `F` instead of `LF` if the control has it.
pub(super) fn mask(target: &Target, called: Called) -> Vec<u8> {
    let window = match called.cycle(Feature::Hole).map(|cycle| cycle.window) {
        Some(Window::Own(name)) if called != Called::Diameter => name,
        _ => "82552",
    };
    let original = shipped::file(shipped::MASKS, &format!("{window}_{}.a", target.language));
    // No set with an empty mask reads back.
    let text = original.map_or_else(|| "".into(), String::from_utf8_lossy);
    let limits = called.limits();
    let number = if target.control == Control::Itnc530 { "LF" } else { "F" };
    let is_as_built_in = target.control == Control::Itnc530 && called == Called::Diameter;
    let lines = text.lines().map(|line| {
        if is_as_built_in {
            return format!("{line}\r\n");
        }
        let line = line.trim_end().replace("LF", number);
        // The limits are those of the called program, as in the mask of a diameter.
        // What that cycle calls the measured diameter.
        let line = if target.by_text && called == Called::Diameter { line.replace("Q153", "Q966") } else { line };
        let line = limits.iter().fold(line, |line, (from, to)| line.replace(&from.to_string(), to));
        format!("{}{}\r\n", line, if line.ends_with(';') { "" } else { ";" })
    });
    lines.collect::<String>().into_bytes()
}
