//! From contacts to a measurement.
//!
//! | file | what |
//! |---|---|
//! | `contact` | one probing and its contact |
//! | `circle` | least-squares and other reference circles |
//! | `measurement` | the outcome: diameter, centre, contacts, and what they cannot tell |
//! | `noted` | what a measurement leaves open of the notes beside a callout |
//! | `orientation` | systems of coordinates that are turned |
//! | `cycle` | what a measuring cycle declares: parameters, ranges, results |
//! | `cycles` | the cycles, one file each |
//! | `measure` | from limits and a position to a measurement |
//! | `source` | where a cycle's contacts come from |
//! | `touch_probe` | what the touch-probe table says about a probe |
//! | `vector` | vectors in the machine's space |
//! | `simulated` | a workpiece and a probe that exist only in Fitcheck |
//!
//! A cycle gets limits, never tolerance classes, and asks a [`Prober`] for its contacts.

pub mod circle;
pub mod contact;
pub mod cycle;
pub mod cycles;
pub mod measure;
pub mod measurement;
pub mod noted;
pub mod orientation;
pub mod simulated;
pub mod source;
pub mod touch_probe;
pub mod vector;

pub use circle::Circle;
pub use contact::{Contact, NoContact, Prober, Recorded, Touch};
pub use measurement::{Caveat, Measurement, Origin, measure_contacts};
pub use orientation::Orientation;
pub use source::{Source, SourceError};
pub use touch_probe::TouchProbe;
