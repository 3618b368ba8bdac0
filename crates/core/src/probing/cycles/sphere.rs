//! The sphere through places, by geometric least squares (Gauss–Newton).

use crate::probing::contact::Contact;
use crate::probing::vector::{along, dot, norm};

/// More steps than a sphere needs that its contacts determine.
const STEPS: usize = 50;
/// A step that changes nothing any more, mm.
const STILL: f64 = 1e-11;
/// Contacts whose directions lie nearer to a plane than this leave the centre open.
const FLAT: f64 = 1e-9;

/// A sphere, mm.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sphere {
    pub(super) centre: [f64; 3],
    pub(super) radius: f64,
}

impl Sphere {
    /// The sphere through places, from a centre near its own; `None` where they do not determine one.
    pub(super) fn through(places: &[Contact], near: [f64; 3]) -> Option<Self> {
        let mut centre = near;
        for _ in 0..STEPS {
            let (radius, step) = step(places, centre)?;
            centre = along(centre, step, 1.0);
            if norm(step) < STILL {
                return Some(Self { centre, radius });
            }
        }
        None
    }

    /// A place, moved towards the centre.
    pub(super) fn inwards(&self, place: &Contact, by: f64) -> Contact {
        let off = along(place.place(), self.centre, -1.0);
        let distance = norm(off);
        // None of them lies at the centre.
        let share = if distance <= 0.0 { 0.0 } else { by / distance };
        Contact::at(along(place.place(), off, -share))
    }
}

/// The mean distance of the places, and how the centre comes nearer to the least squares of the distances' differences from it.
fn step(places: &[Contact], centre: [f64; 3]) -> Option<(f64, [f64; 3])> {
    let off = |place: &Contact| along(place.place(), centre, -1.0);
    let count = places.iter().fold(0.0, |count, _| count + 1.0);
    let mut radius = 0.0;
    let mut mean = [0.0; 3];
    for place in places {
        let distance = norm(off(place));
        if distance <= 0.0 {
            return None;
        }
        radius += distance / count;
        mean = along(mean, off(place), 1.0 / (distance * count));
    }
    let (mut rows, mut wanted) = ([[0.0; 3]; 3], [0.0; 3]);
    for place in places {
        let distance = norm(off(place));
        let direction = along(off(place).map(|part| part / distance), mean, -1.0);
        for (row, part) in rows.iter_mut().zip(direction) {
            *row = along(*row, direction, part);
        }
        wanted = along(wanted, direction, distance - radius);
    }
    let [first, second, third] = rows;
    let across = [cross(second, third), cross(third, first), cross(first, second)];
    let [of_first, ..] = across;
    let volume = dot(first, of_first);
    let size = norm(first) * norm(second) * norm(third);
    let solved = across.into_iter().zip(wanted).fold([0.0; 3], |sum, (way, part)| along(sum, way, part / volume));
    // Nor where one of them is not a number.
    (FLAT * size < volume).then_some((radius, solved))
}

fn cross([ax, ay, az]: [f64; 3], [bx, by, bz]: [f64; 3]) -> [f64; 3] {
    [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
}
