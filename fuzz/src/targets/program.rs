//! Any bytes as an NC program, in any notation: what is read is written as it was; every body that is printed (in Klartext)
//! reads back as the same; warnings point into the text.

use fitcheck::nc::program::{Body, Notation, Program, TextPlace, write};

use super::shared::told;

pub fn run(bytes: &[u8]) {
    let (program, warnings) = match Program::read(bytes) {
        Ok(read) => read,
        Err(error) => return told(bytes, &error),
    };
    assert_eq!(program.write(), bytes);
    for warning in warnings {
        assert!(warning.place.line.is_some_and(|line| line <= program.line_count()));
        told(bytes, &warning);
    }
    let mut behind = 0;
    for (index, block) in program.blocks().iter().enumerate() {
        assert!(behind <= block.lines.start && block.lines.start < block.lines.end);
        assert_eq!(program.block_at(block.lines.start), Some(index));
        behind = block.lines.end;
        // Printing cleans texts of control characters and of ~ at their ends.
        let is_clean = |line: &str| !line.contains(char::is_control) && line.matches('~').count() <= 1;
        // Only Klartext is printed, and not all of it.
        let is_printed = program.notation() == Notation::Klartext && !write::block(1, &block.body).is_empty();
        if is_printed && program.text_of(index).all(is_clean) {
            reads_back(&block.body);
        }
    }
    assert!(behind <= program.line_count());
}

fn reads_back(body: &Body) {
    let text = write::block(1, body).join("\n");
    // Blocks around a measurement are only read.
    if text.is_empty() {
        return;
    }
    let (program, _) = Program::read(text.as_bytes()).expect("a block is text");
    let read = program.blocks().first().map(|block| without_places(&block.body));
    assert_eq!(read, Some(without_places(body)), "{text}");
}

fn without_places(body: &Body) -> Body {
    let mut body = body.clone();
    if let Body::Probe(cycle) | Body::CycleDefinition(cycle) | Body::GlobalDefinition(cycle) = &mut body {
        for line in &mut cycle.lines {
            line.place = TextPlace { line: 0, column: 0 };
        }
    }
    body
}
