//! Contacts as points about their own centre, and why they may fail to make a circle.
//!
//! A circle is never computed in machine coordinates: 1 km away from the origin the textbook formula for three points
//! is wrong by 0.7 µm. The points are moved to the middle of their bounding box and divided by a power of two, which
//! loses no bit that matters, and sorted, so that the order of the contacts cannot change a sum.

use super::Circle;
use crate::length::Length;
use crate::message::{Say, printed};
use crate::probing::contact::Contact;

/// Rounding of a coordinate, in units of the largest coordinate: contacts that are closer than this to each other, or
/// to a straight line, differ by rounding only.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Why contacts do not make a circle.
#[derive(Debug, Clone, PartialEq, Say)]
#[say(prefix = "circle", error)]
pub enum CircleError {
    /// Fewer than three contacts.
    TooFew {
        /// How many were given.
        contacts: usize,
    },
    /// Some contacts lie at the same place, and without the repeated ones fewer than three are left.
    Coinciding {
        /// The first of the two, counted from 1.
        first: usize,
        /// The second.
        second: usize,
        /// Where, in millimetres.
        x: f64,
        /// Where, in millimetres.
        y: f64,
    },
    /// All contacts lie on one straight line.
    Collinear {
        /// How many.
        contacts: usize,
    },
    /// The contacts are so nearly straight that every larger circle fits better.
    Straight {
        /// How many.
        contacts: usize,
    },
    /// A coordinate is NaN or infinite.
    NotFinite {
        /// Which contact, counted from 1.
        contact: usize,
        /// The axis, `x` or `y`.
        axis: char,
        /// What was given.
        value: f64,
    },
    /// A coordinate or a diameter is beyond [`Length::MAX`].
    #[say(args(value = printed(&brief(*value)), most = Length::MAX))]
    TooLarge {
        /// Which one.
        what: TooLarge,
        /// What was given or found, in millimetres.
        #[say(skip)]
        value: f64,
    },
}

/// What is beyond [`Length::MAX`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Say)]
#[say(prefix = "circle-part")]
pub enum TooLarge {
    /// A coordinate of a contact.
    Contact {
        /// Which contact, counted from 1.
        contact: usize,
        /// The axis, `x` or `y`.
        axis: char,
    },
    /// The diameter.
    Diameter,
    /// A coordinate of the centre.
    Centre {
        /// The axis, `x` or `y`.
        axis: char,
    },
}

/// A number as errors show it: 1e300 without its 300 zeros.
fn brief(value: f64) -> String {
    if value.abs() < 1e15 { value.to_string() } else { format!("{value:e}") }
}

/// A count as a factor. Exact up to 2^32, more than a file of the largest size can hold.
pub(super) fn count_f64(count: usize) -> f64 {
    f64::from(u32::try_from(count).unwrap_or(u32::MAX))
}

/// The vector from `b` to `a`.
pub(super) fn minus([a_x, a_y]: [f64; 2], [b_x, b_y]: [f64; 2]) -> [f64; 2] {
    [a_x - b_x, a_y - b_y]
}

/// Scalar product.
pub(super) fn dot([a_x, a_y]: [f64; 2], [b_x, b_y]: [f64; 2]) -> f64 {
    a_x * b_x + a_y * b_y
}

/// Product of the lengths and the sine of the angle between; positive when `b` lies to the left of `a`.
pub(super) fn cross([a_x, a_y]: [f64; 2], [b_x, b_y]: [f64; 2]) -> f64 {
    a_x * b_y - a_y * b_x
}

/// Length of a vector.
pub(super) fn norm([x, y]: [f64; 2]) -> f64 {
    libm::hypot(x, y)
}

/// The same direction with length 1; a vector of length zero has no direction and stays zero.
pub(super) fn unit([x, y]: [f64; 2]) -> [f64; 2] {
    let length = norm([x, y]);
    if length <= 0.0 { [0.0; 2] } else { [x / length, y / length] }
}

/// The place half-way between two others.
pub(super) const fn midpoint([a_x, a_y]: [f64; 2], [b_x, b_y]: [f64; 2]) -> [f64; 2] {
    [f64::midpoint(a_x, b_x), f64::midpoint(a_y, b_y)]
}

/// The mean of vectors.
pub(super) fn mean(vectors: &[[f64; 2]]) -> [f64; 2] {
    let count = count_f64(vectors.len());
    let (sum_x, sum_y) = vectors.iter().fold((0.0, 0.0), |(sum_x, sum_y), [x, y]| (sum_x + x, sum_y + y));
    [sum_x / count, sum_y / count]
}

/// Centre of the circle through three points; `None` when they are collinear to the last bit.
pub(super) fn circumcentre(first: [f64; 2], second: [f64; 2], third: [f64; 2]) -> Option<[f64; 2]> {
    // Counted from the corner opposite the longest side: from the far end of a narrow triangle, the two long sides are nearly
    // parallel, and their product would be rounding.
    let squared = |from, to| {
        let side = minus(to, from);
        dot(side, side)
    };
    let one = squared(first, second);
    let two = squared(second, third);
    let three = squared(third, first);
    let (first, second, third) = if one.max(three) <= two {
        (first, second, third)
    } else if one.max(two) <= three {
        (second, third, first)
    } else {
        (third, first, second)
    };
    let a = minus(second, first);
    let b = minus(third, first);
    let twice_area = 2.0 * cross(a, b);
    let [a_x, a_y] = a;
    let [b_x, b_y] = b;
    let [x, y] = first;
    let a_squared = dot(a, a);
    let b_squared = dot(b, b);
    let centre =
        [x + (b_y * a_squared - a_y * b_squared) / twice_area, y + (a_x * b_squared - b_x * a_squared) / twice_area];
    centre.iter().all(|coordinate| coordinate.is_finite()).then_some(centre)
}

/// Contacts as points between -2 and 2.
pub(super) struct Frame {
    origin: [f64; 2],
    scale: f64,
    points: Vec<[f64; 2]>,
    repeated: Vec<[usize; 2]>,
}

impl Frame {
    /// Moves, scales and sorts contacts that can make a circle.
    pub(super) fn new(contacts: &[Contact]) -> Result<Self, CircleError> {
        check_numbers(contacts)?;
        if contacts.len() < 3 {
            return Err(CircleError::TooFew { contacts: contacts.len() });
        }
        let [least, most] = bounds(contacts);
        let [least_x, least_y] = least;
        let [most_x, most_y] = most;
        let origin = [least_x / 2.0 + most_x / 2.0, least_y / 2.0 + most_y / 2.0];
        let largest = [least_x, least_y, most_x, most_y].iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        let extent = (most_x - least_x).max(most_y - least_y);
        let mut frame =
            Self { origin, scale: power_of_two_below(extent / 2.0), points: Vec::new(), repeated: Vec::new() };
        let rounding = ROUNDING * largest;
        let mut numbered: Vec<_> = (1_usize..).zip(contacts).collect();
        numbered.sort_by(|(_, a), (_, b)| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
        let distinct = frame.find_repeated(&numbered, rounding);
        // Of three contacts at fewer places some are repeated.
        if distinct < 3
            && let Some(&[first, second]) = frame.repeated.first()
            && let Some((_, contact)) = numbered.iter().find(|(number, _)| *number == first)
        {
            return Err(CircleError::Coinciding { first, second, x: contact.x, y: contact.y });
        }
        frame.points = numbered.iter().map(|(_, contact)| frame.place(contact)).collect();
        if is_straight(&frame.points, rounding / frame.scale) {
            return Err(CircleError::Collinear { contacts: contacts.len() });
        }
        Ok(frame)
    }

    /// Records pairs of contacts at the same place and returns how many different places there are.
    fn find_repeated(&mut self, sorted: &[(usize, &Contact)], rounding: f64) -> usize {
        let mut distinct: usize = 0;
        let mut kept: Option<(usize, &Contact)> = None;
        for &(number, contact) in sorted {
            match kept {
                Some((before, other))
                    if (contact.x - other.x).abs() <= rounding && (contact.y - other.y).abs() <= rounding =>
                {
                    self.repeated.push([before.min(number), before.max(number)]);
                }
                _ => {
                    distinct += 1;
                    kept = Some((number, contact));
                }
            }
        }
        self.repeated.sort_unstable();
        distinct
    }

    /// The points, sorted.
    pub(super) fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// Pairs of contacts at the same place, by number from 1.
    pub(super) fn repeated(&self) -> &[[usize; 2]] {
        &self.repeated
    }

    /// Where a contact lies in this frame.
    pub(super) fn place(&self, contact: &Contact) -> [f64; 2] {
        let [x, y] = self.origin;
        [(contact.x - x) / self.scale, (contact.y - y) / self.scale]
    }

    /// A length of this frame in millimetres.
    pub(super) fn length(&self, length: f64) -> f64 {
        length * self.scale
    }

    /// A point of this frame in millimetres.
    pub(super) fn point(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [origin_x, origin_y] = self.origin;
        [origin_x + x * self.scale, origin_y + y * self.scale]
    }

    /// A circle of this frame in millimetres.
    pub(super) fn circle(&self, centre: [f64; 2], radius: f64) -> Circle {
        let [x, y] = self.point(centre);
        Circle { x, y, diameter: 2.0 * radius * self.scale }
    }
}

fn check_numbers(contacts: &[Contact]) -> Result<(), CircleError> {
    for (contact, touched) in (1..).zip(contacts) {
        for (axis, value) in [('x', touched.x), ('y', touched.y)] {
            if !value.is_finite() {
                return Err(CircleError::NotFinite { contact, axis, value });
            }
            if Length::MAX.to_mm_f64() < value.abs() {
                return Err(CircleError::TooLarge { what: TooLarge::Contact { contact, axis }, value });
            }
        }
    }
    Ok(())
}

fn bounds(contacts: &[Contact]) -> [[f64; 2]; 2] {
    let start = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
    contacts.iter().fold(start, |[[least_x, least_y], [most_x, most_y]], contact| {
        [[least_x.min(contact.x), least_y.min(contact.y)], [most_x.max(contact.x), most_y.max(contact.y)]]
    })
}

/// The largest power of two that is not above a number; 1 for zero and for numbers too small to scale by.
fn power_of_two_below(number: f64) -> f64 {
    /// The bits of an `f64` that hold the exponent.
    const EXPONENT: u64 = 0x7ff0_0000_0000_0000;
    if number < 1e-300 { 1.0 } else { f64::from_bits(number.to_bits() & EXPONENT) }
}

/// Whether all points lie within `rounding` of the line through the two that are farthest apart along an axis.
fn is_straight(sorted: &[[f64; 2]], rounding: f64) -> bool {
    let lowest = sorted.iter().min_by(|[_, a], [_, b]| a.total_cmp(b));
    let highest = sorted.iter().max_by(|[_, a], [_, b]| a.total_cmp(b));
    let (Some(&left), Some(&right), Some(&lowest), Some(&highest)) = (sorted.first(), sorted.last(), lowest, highest)
    else {
        return true;
    };
    let across = minus(right, left);
    let up = minus(highest, lowest);
    let (start, along) = if norm(across) < norm(up) { (lowest, up) } else { (left, across) };
    let allowed = rounding.max(ROUNDING) * norm(along);
    sorted.iter().all(|&point| cross(along, minus(point, start)).abs() <= allowed)
}
