//! A text as the block of a probing cycle: it is written and read back as the same inputs, and an NC program with the
//! block finds what the cycle finds on its own.

use std::sync::Arc;

use fitcheck::control::probe_block::{ProbeBlock, read, read_or_lines, write};
use fitcheck::nc::machine::{Contacts, InMemory, Machine, Settings, Step, alone};
use fitcheck::nc::program::Program;
use fitcheck::probing::Source;
use fitcheck::probing::cycle::{Control, Cycle, Inputs};
use fitcheck::probing::cycles::cycle_named;
use fitcheck::words::Dialogue;

use super::shared::{NOW, told};

pub fn run(bytes: &[u8]) {
    let text = fitcheck::text::decode(bytes);
    let lines = read_or_lines(&text, cycle_named("427").expect("a cycle"));
    let block = match read(&text).or(lines) {
        Ok(block) => block,
        Err(error) => return told(bytes, &error),
    };
    for lost in alone(&text, &block) {
        told(bytes, &lost);
    }
    let ProbeBlock { cycle, .. } = block;
    let inputs = match block.put_into(Inputs::new()) {
        Ok(inputs) => inputs,
        Err(error) => return told(bytes, &error),
    };
    let language = Dialogue::ALL[bytes.len() % Dialogue::ALL.len()];
    let written = match write(cycle, &inputs, language) {
        Ok(written) => written,
        Err(error) => return told(bytes, &error),
    };
    let again = read(&written).expect("a block that was written");
    assert_eq!((again.cycle.code, &again.unused), (cycle.code, &None));
    assert_eq!(alone(&written, &again), []);
    let again = again.put_into(Inputs::new()).expect("values that were written");
    for parameter in cycle.parameters {
        let given = inputs.value(parameter.key).cloned().or_else(|| parameter.default_with(&inputs));
        assert_eq!(again.value(parameter.key), given.as_ref(), "{}", parameter.key);
    }
    if cycle.checked(&inputs).is_ok() && cycle.control == Control::Milling {
        runs_alike(bytes, cycle, &again, &written);
    }
}

/// In a program, against the cycle on its own, both on a perfect workpiece.
fn runs_alike(bytes: &[u8], cycle: &Cycle, inputs: &Inputs, block: &str) {
    let native = match Source::Perfect.prober(cycle, inputs) {
        Ok(mut prober) => cycle.measure(inputs, &mut *prober).map_err(|error| error.to_string()),
        Err(error) => Err(error.to_string()),
    };
    let program = format!("0 BEGIN PGM A MM\r\n1 {block}2 END PGM A MM\r\n");
    let (program, warnings) = Program::read(program.as_bytes()).expect("a program");
    assert_eq!(warnings, [], "{block}");
    let mut settings = Settings::new(Dialogue::En, NOW);
    // A cycle on its own needs no TOOL CALL.
    settings.assumes_tool = true;
    let mut machine = Machine::new("a.h", Arc::new(program), InMemory::new(), Contacts::Perfect, settings);
    let ended = loop {
        match machine.run(10) {
            Ok(Step::Ended) => break Ok(()),
            Ok(_) => {}
            Err(fault) => break Err(fault),
        }
    };
    match (native, machine.cycles().first()) {
        (Ok(native), Some(run)) => {
            let all = |result: &fitcheck::probing::cycle::CycleResult| {
                format!("{:?} {:?} {:?} {:?}", result.status, result.checks, result.results, result.contacts)
            };
            assert_eq!(all(&native), all(&run.result));
        }
        (Err(native), None) => {
            let fault = ended.expect_err("the cycle alone does not run").to_string();
            assert!(fault.ends_with(&native), "{native} in the program: {fault}");
        }
        // What a program may use up: a path of moves; what a parameter can hold.
        (Ok(_), None) => told(bytes, &ended.expect_err("without a result")),
        (Err(native), Some(_)) => panic!("the cycle alone does not run: {native}"),
    }
}
