//! The simulated workpiece as text fields: there and back, and what each of them may hold.

#![cfg(test)]

use fitcheck::probing::simulated::{Simulation, Surface};
use fitcheck::session::{Session, WorkpieceCommand, WorkpieceField, WorkpieceForm};
use fitcheck::words::{Language, Words};
use jiff::civil::date;

#[track_caller]
fn check(toml: &str) {
    let simulation = Simulation::read(toml).unwrap();
    let form = WorkpieceForm::of(&simulation);
    assert_eq!(form.problem(), None);
    let read = form.simulation.as_ref().unwrap();
    let again = Simulation::read(&read.write().unwrap()).unwrap();
    assert_eq!(*read, again, "what is written is read as the same");
    assert_eq!(WorkpieceForm::of(&again).simulation.as_ref(), Some(read));
}

#[test]
fn every_kind_of_machine_goes_through_the_fields_and_a_file_unchanged() {
    check(
        "[bore]\ncentre = [50, 20]\ndiameter = 25.0123456789\nplane = 'ZX'\novality = { count = 2, amplitude = 0.001, angle = 30 }\n",
    );
    check(
        "seed = 7\ntemperature = 23.7\n[stud]\ncentre = [0, -1]\ndiameter = 8\nlobes = { count = 5, amplitude = 0.0005, angle = -3 }\nsurface_scatter = 0.0003\n",
    );
    check(
        "[face]\npoint = [1, 2, 3]\nnormal = [0, 0, 2]\nwave = { amplitude = 0.01, length = 4, direction = [1, 1, 0] }\n[probe]\nball_radius = 3\noffset = [0.01, 0]\n",
    );
    check("[slot]\ncentre = [50, -20]\nwidth = 20.01\nangle = 90\n[probe]\nball_radius = 2\n");
    check("[ridge]\ncentre = [1, 2]\nwidth = 8\nsurface_scatter = 0.001\n");
    check("[pocket]\ncentre = [1, 2]\nlengths = [60, 40.5]\nangle = 0.25\n");
    check("seed = 2\n[boss]\ncentre = [1, 2]\nlengths = [60, 40.5]\n");
    check(
        "[point]\npoint = [1, 2, 3]\nnormal = [0, 1, 1]\ndeviation = -0.02\nradius = -30\n[probe]\nlobing = { count = 3, amplitude = 0.0004 }\n",
    );
}

#[test]
fn a_figure_that_cannot_be_is_told_beside_its_field() {
    let mut session = Session::new(Language::En);
    let set = |session: &mut Session, field, text: &str| {
        let command = WorkpieceCommand::Type(field, text.to_owned()).into();
        assert_eq!(session.apply(command, date(2026, 11, 21).at(10, 42, 7, 0)), []);
    };
    for (field, text, id) in [
        (WorkpieceField::Diameter, "-1", "workpiece-cannot-be"),
        (WorkpieceField::Diameter, "7.5.2", "length-not-a-number"),
        (WorkpieceField::Diameter, "", "length-empty"),
        (WorkpieceField::Ovality, "5", "workpiece-cannot-be"),
        (WorkpieceField::LobeCount, "x", "field-not-whole"),
        (WorkpieceField::Temperature, "500", "workpiece-cannot-be"),
        (WorkpieceField::Temperature, "20 mm", "length-not-a-number"),
        (WorkpieceField::CalibrationError, "-4", "workpiece-cannot-be"),
    ] {
        let before = session.workpiece().text(field).to_owned();
        set(&mut session, field, text);
        let form = session.workpiece();
        assert_eq!(form.error(field).map(|error| error.id), Some(id), "{field:?} {text}");
        assert!(form.simulation.is_none());
        set(&mut session, field, &before);
        assert!(session.workpiece().simulation.is_some(), "{field:?}");
    }
    // Half an offset would be guessed.
    set(&mut session, WorkpieceField::OffsetX, "0,01");
    let form = session.workpiece();
    assert!(form.error(WorkpieceField::OffsetY).is_some() && form.simulation.is_none());
    let said = form.problem().map(|problem| Words::new(Language::En).say(&problem));
    assert_eq!(said.as_deref(), Some("Offset of the ball Y: a length is missing"));
    set(&mut session, WorkpieceField::OffsetX, "");
    set(&mut session, WorkpieceField::Ovality, "2 µm");
    let Surface::Round(round, _) = session.workpiece().simulation.as_ref().unwrap().surface else { panic!("no bore") };
    assert!((round.ovality.amplitude - 0.002).abs() < 1e-12);
}
