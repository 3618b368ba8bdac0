//! Any text as a simulated workpiece: it is written and read back as the same, and a probe finds a place or nothing.

use fitcheck::probing::simulated::Part;
use fitcheck::probing::{NoContact, Prober, Touch, TouchProbe};

use super::shared::told;

/// From where and in which direction: into a hole, from outside, from above, along nothing.
const TOUCHES: [([f64; 3], [f64; 3]); 4] = [
    ([50.0, 50.0, -5.0], [1.0, 0.0, 0.0]),
    ([200.0, 30.0, 0.0], [-1.0, 0.0, 0.0]),
    ([40.0, 30.0, 100.0], [0.0, 0.0, -1.0]),
    ([0.0, 0.0, 0.0], [0.6, 0.0, 0.8]),
];

pub fn run(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    let part = match Part::read(text) {
        Ok(part) => part,
        Err(error) => return told(bytes, &error),
    };
    // TOML holds seeds up to i64::MAX, and no more can have been read.
    let written = part.write().expect("figures that were read");
    assert_eq!(Part::read(&written), Ok(part.clone()));
    let machine = match part.machine() {
        Ok(machine) => machine.calibrated(&TouchProbe::default()),
        // Warm, it may be larger than any machine.
        Err(error) => return told(bytes, &error),
    };
    for (from, direction) in TOUCHES {
        let to = std::array::from_fn(|axis| from[axis] + 100.0 * direction[axis]);
        assert!(machine.collision(from, to, None).is_none_or(|found| found.place.iter().all(|part| part.is_finite())));
        let mut machine = machine.clone();
        match machine.touch(&Touch { from, direction, longest: 1000.0 }) {
            Ok(contact) => assert!(contact.place().iter().all(|part| part.is_finite())),
            Err(NoContact::UsedUp { .. }) => panic!("a workpiece is never used up"),
            Err(error) => told(bytes, &error),
        }
    }
}
