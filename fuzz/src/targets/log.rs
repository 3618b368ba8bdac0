//! Any bytes as measuring logs: a log that is written reads back as printed and is written the same again; a file with
//! one more log keeps those that it has; an import has a row for each size.

use fitcheck::control::log::{Log, append, read, write};
use fitcheck::exchange::import;
use fitcheck::tolerance::Sources;
use fitcheck::words::Dialogue;

use super::shared::{NOW, told};

pub fn run(bytes: &[u8]) {
    let logs = read(bytes);
    assert!(!logs.is_empty());
    for answer in &logs {
        match answer {
            Ok(log) => {
                for warning in &log.warnings {
                    told(bytes, warning);
                }
                written(bytes, log, Dialogue::ALL[bytes.len() % Dialogue::ALL.len()]);
            }
            Err(error) => told(bytes, error),
        }
    }
    let imported = import("TCHPR421.TXT", bytes, &Sources::default(), NOW);
    assert_eq!(imported.rows, imported.records.len() + imported.unjudged.len() + imported.errors.len());
}

fn written(bytes: &[u8], log: &Log, language: Dialogue) {
    let file = match write(log, language) {
        Ok(file) => file,
        Err(error) => return told(bytes, &error),
    };
    let again = match read(&file).as_slice() {
        [Ok(again)] => again.clone(),
        other => panic!("one log was written: {other:?}"),
    };
    assert_eq!(again.figures, log.printed(language).figures);
    assert_eq!(write(&again, language).as_ref(), Ok(&file));
    if let Ok(two) = append(&file, &again, language) {
        let logs = read(&two);
        assert!(logs.len() == 2 && logs[0].as_ref() == Ok(&again), "{logs:?}");
    }
}
