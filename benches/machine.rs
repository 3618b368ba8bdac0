//! How many blocks of NC programs run in a second: a counting loop, and the programs of NC-Solution 8255.
#![expect(clippy::expect_used, reason = "a bench may stop")]

use std::sync::Arc;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use fitcheck::nc::machine::{Contacts, Machine, Settings, Shipped, Step};
use fitcheck::nc::program::Program;
use fitcheck::words::Dialogue;

fn program(text: &[u8]) -> Arc<Program> {
    Arc::new(Program::read(text).expect("a program").0)
}

fn machine(program: &Arc<Program>) -> Machine {
    let settings = Settings::new(Dialogue::Nl, jiff::civil::date(2026, 1, 31).at(12, 0, 0, 0));
    Machine::new("main.h", Arc::clone(program), Shipped, Contacts::Perfect, settings)
}

/// Runs to the end and returns how many blocks that took.
fn run(machine: &mut Machine) -> u64 {
    while machine.run(u64::MAX).expect("no fault") != Step::Ended {}
    machine.blocks_run()
}

fn machines(criterion: &mut Criterion) {
    let counting =
        "BEGIN PGM count MM\nQ1 = 0\nLBL 1\nQ1 = Q1 + 1\nFN 12: IF +Q1 LT +10000 GOTO LBL 1\nEND PGM count MM\n";
    let shipped = Shipped::file("8255_nl.h").expect("a shipped program");
    let programs = [("a loop that counts to 10000", counting.as_bytes()), ("8255 with its cycle and window", shipped)];
    let mut group = criterion.benchmark_group("NC programs");
    for (name, text) in programs {
        let program = program(text);
        let mut again = machine(&program);
        group.throughput(Throughput::Elements(run(&mut again)));
        group.bench_function(name, |bencher| bencher.iter(|| run(&mut machine(&program))));
        group.bench_function(format!("{name}, restarted"), |bencher| {
            bencher.iter(|| {
                again.restart(Contacts::Perfect);
                run(&mut again)
            });
        });
    }
    group.finish();
}

criterion_group!(benches, machines);
criterion_main!(benches);
