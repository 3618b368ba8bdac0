//! How long reading and writing an NC program takes, in blocks per second. The budget is 0.3 s for 100 000 blocks.
#![expect(clippy::expect_used, reason = "a bench may stop")]

use std::fmt::Write;
use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use fitcheck::nc::program::{Program, write};

/// A program of many blocks: `round` writes some of them, given the number of the first.
fn program(blocks: usize, blocks_a_round: usize, round: impl Fn(&mut String, usize)) -> Vec<u8> {
    let mut text = "0  BEGIN PGM long MM \r\n".to_owned();
    let mut number = 1;
    while number < blocks - 1 {
        round(&mut text, number);
        number += blocks_a_round;
    }
    write!(text, "{number} END PGM long MM \r\n").expect("memory");
    text.into_bytes()
}

/// What a measuring program is made of.
fn measuring(text: &mut String, number: usize) {
    let (x, label) = (number % 977, number % 60_000 + 1);
    let lines = [
        format!("L  X+{x}.125  Y-{x} R0 FMAX M3"),
        format!("Q1 = Q1 + ( SQRT ( Q2 ^ 2 + {x}.5 ^ 2 ) - 3 ) / 2 ;SUM"),
        format!("FN 9: IF +Q1 EQU +{x} GOTO LBL {label}"),
        "* - next bore".to_owned(),
        "QS2 = QS5 || QS4 || QS1".to_owned(),
        "FN 28: TABREAD Q4 = +Q22/\"H7\"".to_owned(),
        format!("CALL LBL \"BORE {x}\" REP 3"),
        "TCH PROBE 421 MEASURE HOLE ~\r\n    Q273=+Q11  ;CENTER IN 1ST AXIS ~\r\n    Q262=+25.5 ;NOMINAL DIAMETER"
            .to_owned(),
        "BLK FORM 0.1 Z  X-50  Y-50  Z-20".to_owned(),
        "FN 16: F-PRINT TNC:\\fit\\mask.a / SCREEN:".to_owned(),
    ];
    for (index, line) in lines.iter().enumerate() {
        write!(text, "{} {line}\r\n", number + index).expect("memory");
    }
}

/// What a milling program is made of.
fn moves(text: &mut String, number: usize) {
    let x = number % 977;
    write!(text, "{number} L X-{x}.484 Y+{x}.045 Z-6.523\r\n").expect("memory");
}

fn reading(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("100 000 blocks");
    group.sample_size(20);
    for (name, bytes) in
        [("of measuring", program(100_000, 10, measuring)), ("of straight lines", program(100_000, 1, moves))]
    {
        let (read, _) = Program::read(&bytes).expect("a program");
        assert!(99_000 < read.blocks().len() && read.blocks().len() < 101_000);
        group.throughput(Throughput::Elements(100_000));
        group.bench_function(format!("read, {name}"), |bencher| bencher.iter(|| Program::read(black_box(&bytes))));
        group.bench_function(format!("write as read, {name}"), |bencher| bencher.iter(|| black_box(&read).write()));
        group.bench_function(format!("print anew, {name}"), |bencher| {
            bencher.iter(|| write::program(read.blocks().iter().map(|block| (&block.body, ""))));
        });
    }
    group.finish();
}

criterion_group!(benches, reading);
criterion_main!(benches);
