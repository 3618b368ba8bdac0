//! The mark of what a simulation has written in a control's formats, which have no place for it: a line that no control writes.
//!
//! Every reader of Fitcheck knows it, and takes what stands below it for simulated. Others find a line of words without a figure.

/// The line, in ASCII and without a separator of any table.
pub(crate) const MARK: &str = "# Simulated by Fitcheck - not measured";

/// A window of the control as it leaves the program: below the mark where a simulation has measured.
pub fn marked(text: &str, is_simulated: bool) -> String {
    if is_simulated { format!("{MARK}\n{text}") } else { text.to_owned() }
}

/// Whether a line is the mark, whatever was put around it.
pub fn is_mark(line: &str) -> bool {
    /// What no other line says.
    const SAYS: &[u8] = b"simulated by fitcheck";
    line.as_bytes().windows(SAYS.len()).any(|window| window.eq_ignore_ascii_case(SAYS))
}
