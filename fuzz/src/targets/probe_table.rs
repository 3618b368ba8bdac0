//! Any bytes as a touch-probe table: each probe is found by its number, and a cycle runs with it.

use fitcheck::control::probe_table::ProbeTable;
use fitcheck::length::{Length, Unit};
use fitcheck::probing::Source;
use fitcheck::probing::cycle::{Inputs, ResultName};
use fitcheck::probing::cycles::cycle;

use super::shared::told;

/// A coordinate of 5 mm.
const SETTINGS: [(&str, &str); 6] =
    [("Q263", "35"), ("Q264", "45"), ("Q261", "5"), ("Q272", "1"), ("Q267", "-1"), ("Q260", "20")];

pub fn run(bytes: &[u8]) {
    let table = match ProbeTable::read(bytes, "a.tp") {
        Ok(table) => table,
        Err(error) => return told(bytes, &error),
    };
    for warning in &table.warnings {
        told(bytes, warning);
    }
    assert_eq!(table.probe(None), table.probes.first());
    for probe in &table.probes {
        assert_eq!(table.probe(Some(probe.number)), Some(probe));
        assert!(Length::ZERO <= probe.set_up && Length::ZERO < probe.longest_path);
    }
    let cycle = cycle(427).expect("a cycle");
    for probe in table.probes.iter().take(3) {
        let inputs = SETTINGS.iter().fold(Inputs::new().with_probe(*probe), |inputs, (name, value)| {
            cycle.set(inputs, name, value).expect("a value")
        });
        let mut prober = Source::Perfect.prober(cycle, &inputs).expect("a face");
        match cycle.measure(&inputs, &mut *prober) {
            Ok(result) => {
                assert_eq!(result.length(ResultName::COORDINATE), Length::parse_in("35", Unit::Millimetre).ok());
            }
            Err(error) => told(bytes, &error),
        }
    }
}
