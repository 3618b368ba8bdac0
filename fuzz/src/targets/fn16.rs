//! Any bytes as a mask and what it printed, byte 0x1C between them: a mask that can be read backwards reads what it prints itself, and a
//! file through it loses nothing.

use std::io::Cursor;

use fitcheck::control::mask::{Context, Mask, PrintMatch};
use fitcheck::control::variables::{Value, Variables};
use fitcheck::exchange::{ImportInputs, Item, import_from};
use fitcheck::tolerance::Sources;
use fitcheck::words::Dialogue;

use super::shared::{NOW, told};

pub fn run(bytes: &[u8]) {
    let (mask, file) = bytes.split_at(bytes.iter().position(|byte| *byte == 0x1c).unwrap_or(bytes.len()));
    let Ok((mask, _)) = Mask::read(mask) else { return };
    match mask.inverse() {
        Ok(inverse) => {
            let mut variables = Variables::new();
            for parameter in mask.parameters() {
                let is_text = parameter.family.is_text();
                let value = if is_text { Value::Text(format!("T{}", parameter.number)) } else { Value::Number(25.0) };
                variables.set(parameter, value);
            }
            let context = Context { language: Dialogue::En, time: NOW, call_path: "TNC:" };
            if let Ok(printed) = mask.render(&variables, &context) {
                let lines: Vec<&str> = printed.text.lines().collect();
                if !lines.is_empty()
                    && lines.iter().all(|line| line.len() < 1_000 && !line.contains(['\r', '\0', '\n']))
                {
                    assert_ne!(inverse.at(&lines), PrintMatch::Nothing, "{lines:?}");
                }
            }
        }
        Err(error) => told(bytes, &error),
    }
    let masks = [("m.a".to_owned(), mask)];
    let sources = Sources::default();
    let mut items = 0;
    let given = ImportInputs { masks: &masks, ..ImportInputs::new(&sources, NOW) };
    let file = file.get(1..).unwrap_or_default();
    import_from("list.txt", &mut Cursor::new(file), given, &mut |item| {
        items += 1;
        if let Item::Record { record, .. } = item {
            assert!(record.limits.minimum() <= record.limits.maximum());
        }
    });
    assert!(0 < items);
}
