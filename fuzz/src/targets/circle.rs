//! Contacts as circles by every criterion: the floats' answers against a computation with twice the digits, and against
//! every circle through two or three of the contacts.

use fitcheck::probing::Contact;
use fitcheck::probing::circle::{Circle, CircleWarning, Evaluation, evaluate};

use super::exact::Exact;
use super::shared::{Figures, told};

/// More contacts would take long with three nested loops.
const MOST: usize = 9;

pub fn run(bytes: &[u8]) {
    let mut figures = Figures(bytes);
    // From 1e-6 mm to a metre a step, up to 1e8 mm away.
    let step = figures.one_of(&[1e-6, 1e-3, 0.037, 1.0, 32.0, 1000.0]);
    let away = figures.one_of(&[0.0, 0.1, 1000.0, 1e6, 1e8]);
    let count = 3 + usize::from(figures.byte()) % (MOST - 2);
    let is_round = figures.byte() % 2 == 0;
    let contacts: Vec<Contact> = (0..count)
        .map(|_| {
            let (x, y) = (f64::from(figures.short()), f64::from(figures.short()));
            let [x, y] = if is_round {
                // About a circle of a thousand steps: an angle, and a few steps off it.
                let (sin, cos) = (x / 1000.0).sin_cos();
                [(1000.0 + y / 8192.0) * cos, (1000.0 + y / 8192.0) * sin]
            } else {
                [x, y]
            };
            Contact { x: away + step * x, y: -away + step * y, z: 0.0 }
        })
        .collect();
    check(bytes, &contacts);
}

/// Holds the answers for contacts against each other and against exact ones.
pub fn check(bytes: &[u8], contacts: &[Contact]) {
    let found = match evaluate(contacts) {
        Ok(found) => found,
        Err(error) => return told(bytes, &error),
    };
    for warning in &found.warnings {
        told(bytes, warning);
    }
    let backwards: Vec<Contact> = contacts.iter().rev().copied().collect();
    let again = evaluate(&backwards).expect("the same contacts");
    assert_eq!(again.least_squares, found.least_squares);
    assert_eq!(again.minimum_circumscribed, found.minimum_circumscribed);
    assert_eq!((again.maximum_inscribed, again.minimum_zone), (found.maximum_inscribed, found.minimum_zone));
    if contacts.len() <= MOST {
        let set = Set::new(contacts);
        set.residuals(&found);
        set.least_squares(&found);
        set.circumscribed(&found.minimum_circumscribed);
        set.inscribed(&found);
        set.zone(&found);
    }
}

struct Set<'a> {
    contacts: &'a [Contact],
    /// The middle of the box around the contacts, and half its size.
    middle: [f64; 2],
    extent: f64,
    /// What a coordinate may be off by, wherever the contacts are.
    rounding: f64,
    /// The centres of the circles through two contacts (on their diameter) or three.
    centres: Vec<[f64; 2]>,
}

impl<'a> Set<'a> {
    fn new(contacts: &'a [Contact]) -> Self {
        let range = |of: fn(&Contact) -> f64| {
            let numbers = contacts.iter().map(of);
            numbers.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), at| (least.min(at), most.max(at)))
        };
        let ((left, right), (bottom, top)) = (range(|at| at.x), range(|at| at.y));
        let extent = (right - left).max(top - bottom) / 2.0;
        let largest = [left, right, bottom, top].into_iter().fold(0.0, |most: f64, at| most.max(at.abs()));
        let mut centres = Vec::new();
        for (number, a) in contacts.iter().enumerate() {
            for (behind, b) in contacts.iter().enumerate().skip(number + 1) {
                centres.push([f64::midpoint(a.x, b.x), f64::midpoint(a.y, b.y)]);
                centres.extend(contacts.iter().skip(behind + 1).filter_map(|c| circumcentre([a, b, c])));
            }
        }
        let middle = [f64::midpoint(left, right), f64::midpoint(bottom, top)];
        // Contacts nearly on a line have centres so far away that even 32 digits lose the contacts beside them.
        centres.retain(|[x, y]: &[f64; 2]| (x - middle[0]).hypot(y - middle[1]) < 1e9 * extent);
        Self { contacts, middle, extent, rounding: 4.0 * f64::EPSILON * largest + 1e-12 * extent, centres }
    }

    /// The exact distances of the contacts from a place.
    fn distances(&self, [x, y]: [f64; 2]) -> impl Iterator<Item = Exact> {
        self.contacts.iter().map(move |contact| {
            let off = [Exact::from(contact.x) - Exact::from(x), Exact::from(contact.y) - Exact::from(y)];
            (off[0] * off[0] + off[1] * off[1]).sqrt()
        })
    }

    fn least_and_most(&self, centre: [f64; 2]) -> (f64, f64) {
        let distances = self.distances(centre).map(Exact::float);
        distances
            .fold((f64::INFINITY, 0.0), |(least, most): (f64, f64), distance| (least.min(distance), most.max(distance)))
    }

    fn squares(&self, centre: [f64; 2]) -> f64 {
        let distances: Vec<Exact> = self.distances(centre).collect();
        let mean = mean(&distances);
        distances.iter().map(|&distance| (distance - mean) * (distance - mean)).fold(Exact::ZERO, |a, b| a + b).float()
    }

    /// Each contact lies as far off the least-squares circle as the evaluation says.
    fn residuals(&self, found: &Evaluation) {
        let circle = found.least_squares;
        let radius = Exact::from(circle.diameter) / Exact::from(2.0);
        let allowed = self.rounding + 4.0 * f64::EPSILON * circle.diameter;
        for (distance, residual) in self.distances([circle.x, circle.y]).zip(&found.residuals) {
            let off = ((distance - radius) - Exact::from(*residual)).float().abs();
            assert!(off <= allowed, "a residual is off by {off:e}, allowed is {allowed:e}");
        }
    }

    /// An exact step of Newton's from the centre would not move it; no round circle through three contacts fits better.
    fn least_squares(&self, found: &Evaluation) {
        let Circle { x, y, diameter } = found.least_squares;
        // On a short arc the centre moves by many times a contact's rounding.
        let worse = found.uncertainty.centre_along.max(1.0);
        if 1e5 < worse {
            return;
        }
        let distances: Vec<Exact> = self.distances([x, y]).collect();
        let radius = mean(&distances);
        let rounding = self.rounding * worse * worse;
        let off = (radius.float() - diameter / 2.0).abs();
        assert!(off <= rounding + 4.0 * f64::EPSILON * diameter, "the radius is off by {off:e}");
        let root = |squares: f64| (squares / f64::from(u8::try_from(self.contacts.len()).unwrap_or(1))).sqrt();
        let rms = root(self.squares([x, y]));
        for &centre in &self.centres {
            let (other, distances) = (root(self.squares(centre)), self.distances(centre).collect::<Vec<_>>());
            // What is round to a tenth of its radius; anything else has many circles that fit about as badly.
            let is_round = other < 0.1 * mean(&distances).float() && other < 0.1 * self.extent;
            assert!(!is_round || rms <= other + rounding, "least squares: {rms:e}, but {other:e} about {centre:?}");
        }
        let Some(step) = self.newton_step([x, y], &distances, radius) else { return };
        assert!(step <= rounding, "the centre is off by {step:e}, allowed is {rounding:e}");
    }

    /// How far an exact step of Newton's goes; `None` where the sum of squares is so flat that it says nothing.
    fn newton_step(&self, [x, y]: [f64; 2], distances: &[Exact], radius: Exact) -> Option<f64> {
        let count = Exact::from(f64::from(u8::try_from(self.contacts.len()).ok()?));
        let mut downhill = [Exact::ZERO; 2];
        let (mut xx, mut xy, mut yy, mut mean_x, mut mean_y) = (0.0, 0.0, 0.0, 0.0, 0.0);
        for (contact, &distance) in self.contacts.iter().zip(distances) {
            if distance.float() <= 1e-9 * self.extent {
                return None;
            }
            let along = [Exact::from(contact.x) - Exact::from(x), Exact::from(contact.y) - Exact::from(y)]
                .map(|at| at / distance);
            let residual = distance - radius;
            downhill = [downhill[0] + residual * along[0], downhill[1] + residual * along[1]];
            let ([along_x, along_y], bend) = (along.map(Exact::float), (residual / distance).float());
            mean_x += along_x / count.float();
            mean_y += along_y / count.float();
            xx += along_x * along_x + bend * along_y * along_y;
            xy += along_x * along_y - bend * along_x * along_y;
            yy += along_y * along_y + bend * along_x * along_x;
        }
        xx -= count.float() * mean_x * mean_x;
        xy -= count.float() * mean_x * mean_y;
        yy -= count.float() * mean_y * mean_y;
        let determinant = xx * yy - xy * xy;
        let [down_x, down_y] = downhill.map(Exact::float);
        // Nearly flat in one direction: a saddle or a valley.
        if xx + yy <= 0.0 || determinant <= 1e-3 * (xx + yy) * (xx + yy) {
            return None;
        }
        Some(((down_x * yy - down_y * xy) / determinant).hypot((down_y * xx - down_x * xy) / determinant))
    }

    /// Every contact is inside, and no circle through two or three of them that holds all is smaller.
    fn circumscribed(&self, circle: &Circle) {
        let (_, most) = self.least_and_most([circle.x, circle.y]);
        let off = (most - circle.diameter / 2.0).abs();
        assert!(
            off <= self.rounding + 4.0 * f64::EPSILON * circle.diameter,
            "the circumscribed circle is off by {off:e}"
        );
        let best = self.centres.iter().map(|&centre| self.least_and_most(centre).1).fold(f64::INFINITY, f64::min);
        let larger = circle.diameter / 2.0 - best;
        assert!(larger <= 4.0 * self.rounding, "a circumscribed circle is smaller by {larger:e}");
    }

    /// No contact is inside, and a circle through three contacts that surround its centre is no larger.
    fn inscribed(&self, found: &Evaluation) {
        let Some(circle) = found.maximum_inscribed else { return };
        let radius = circle.diameter / 2.0;
        let (least, _) = self.least_and_most([circle.x, circle.y]);
        let off = (least - radius).abs();
        assert!(off <= self.rounding + 4.0 * f64::EPSILON * circle.diameter, "the inscribed circle is off by {off:e}");
        assert!(radius <= found.minimum_circumscribed.diameter / 2.0 + self.rounding);
        for centre in self.centres.iter().filter(|&&centre| self.surround(centre, 1e-6)) {
            let larger = self.least_and_most(*centre).0 - radius;
            assert!(larger <= 4.0 * self.rounding, "an inscribed circle is larger by {larger:e}");
        }
    }

    /// Whether the contacts lie on all sides of a place: no gap of half a turn, by this much.
    fn surround(&self, [x, y]: [f64; 2], by: f64) -> bool {
        let mut angles: Vec<f64> = self.contacts.iter().map(|at| (at.y - y).atan2(at.x - x)).collect();
        angles.sort_by(f64::total_cmp);
        let across = angles[0] + std::f64::consts::TAU - angles[angles.len() - 1];
        let widest = angles.windows(2).fold(across, |widest, pair| widest.max(pair[1] - pair[0]));
        widest < std::f64::consts::PI - by
    }

    /// The ring holds every contact, and none about the centre of a circle through two or three of them is narrower.
    fn zone(&self, found: &Evaluation) {
        let Some(zone) = found.minimum_zone else {
            assert!(found.warnings.contains(&CircleWarning::NoZone));
            return;
        };
        let (least, most) = self.least_and_most([zone.x, zone.y]);
        let allowed = self.rounding + 4.0 * f64::EPSILON * zone.outer_diameter;
        for (is, said) in
            [(least, zone.inner_diameter / 2.0), (most, zone.outer_diameter / 2.0), (most - least, zone.width)]
        {
            assert!((is - said).abs() <= 4.0 * allowed, "the ring has {is} instead of {said}");
        }
        let circle = found.least_squares;
        let others = self.centres.iter().copied().chain([[circle.x, circle.y]]);
        // Ten thousand half extents away, a ring counts as a straight strip.
        let [x, y] = self.middle;
        for centre in others.filter(|centre| (centre[0] - x).hypot(centre[1] - y) < 4e3 * self.extent) {
            let (least, most) = self.least_and_most(centre);
            let narrower = zone.width - (most - least);
            assert!(narrower <= 8.0 * allowed, "a ring is narrower by {narrower:e} about {centre:?}");
        }
    }
}

fn mean(numbers: &[Exact]) -> Exact {
    let sum = numbers.iter().fold(Exact::ZERO, |sum, &number| sum + number);
    sum / Exact::from(f64::from(u32::try_from(numbers.len()).unwrap_or(1)))
}

/// The centre of the circle through three contacts, with twice the digits on the way.
fn circumcentre([first, second, third]: [&Contact; 3]) -> Option<[f64; 2]> {
    let off = |to: &Contact| [Exact::from(to.x) - Exact::from(first.x), Exact::from(to.y) - Exact::from(first.y)];
    let (second, third) = (off(second), off(third));
    let square = |[x, y]: [Exact; 2]| x * x + y * y;
    let twice_area = Exact::from(2.0) * (second[0] * third[1] - second[1] * third[0]);
    let along = (third[1] * square(second) - second[1] * square(third)) / twice_area;
    let across = (second[0] * square(third) - third[0] * square(second)) / twice_area;
    let centre = [Exact::from(first.x) + along, Exact::from(first.y) + across].map(Exact::float);
    centre.iter().all(|number| number.is_finite()).then_some(centre)
}
