//! Systems of coordinates that are turned against that of the workpiece.

use super::cycle::Plane;

/// The directions of a system's axes: those of the workpiece, or turned.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Orientation {
    /// The unit vectors of its X, Y and Z in the coordinates of the workpiece.
    axes: [[f64; 3]; 3],
}

impl Default for Orientation {
    fn default() -> Self {
        Self { axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] }
    }
}

/// Sine and cosine of an angle in degrees, exact at every quarter turn.
fn sin_cos(degrees: f64) -> (f64, f64) {
    let quarters = (degrees / 90.0).round();
    let (sin, cos) = libm::sincos((degrees - 90.0 * quarters).to_radians());
    match quarters.rem_euclid(4.0) {
        turn if turn < 0.5 => (sin, cos),
        turn if turn < 1.5 => (cos, -sin),
        turn if turn < 2.5 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

impl Orientation {
    /// Turned by an angle in degrees about the axis at right angles to a plane, plus from its first axis to its second.
    pub fn in_plane(plane: Plane, degrees: f64) -> Self {
        let (sin, cos) = sin_cos(degrees);
        let turned = |vector: [f64; 3]| {
            let [first, second, height] = plane.within(vector);
            plane.place([cos * first - sin * second, sin * first + cos * second, height])
        };
        Self { axes: Self::default().axes.map(turned) }
    }

    /// Turned by the spatial angles A, B and C in degrees: by A about X, then by B about Y, then by C about Z, each about the axes before
    /// anything is turned.
    ///
    /// As `PLANE SPATIAL` and cycle 19 are remembered (`docs/SOURCES.md`, "Tilted planes").
    pub fn spatial([a, b, c]: [f64; 3]) -> Self {
        Self::in_plane(Plane::Xy, c).then(Self::in_plane(Plane::Zx, b)).then(Self::in_plane(Plane::Yz, a))
    }

    /// A system that is turned within this one.
    #[must_use]
    pub fn then(self, inner: Self) -> Self {
        Self { axes: inner.axes.map(|axis| self.out(axis)) }
    }

    /// A vector of the system in the coordinates of the workpiece.
    pub fn out(self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = self.axes;
        [xx * x + yx * y + zx * z, xy * x + yy * y + zy * z, xz * x + yz * y + zz * z]
    }

    /// A vector of the workpiece in the coordinates of the system.
    pub fn within(self, vector: [f64; 3]) -> [f64; 3] {
        self.axes.map(|axis| super::vector::dot(axis, vector))
    }

    /// The same with parts that may not be known: a part is known where all are that it depends on.
    pub fn out_of_known(self, vector: [Option<f64>; 3]) -> [Option<f64>; 3] {
        let [x, y, z] = self.axes;
        [0, 1, 2].map(|part: usize| sum([x, y, z].map(|axis| axis.get(part).copied().unwrap_or_default()), vector))
    }

    /// The same for a vector of the workpiece in the coordinates of the system.
    pub fn within_known(self, vector: [Option<f64>; 3]) -> [Option<f64>; 3] {
        self.axes.map(|axis| sum(axis, vector))
    }

    /// Whether nothing is turned.
    pub fn is_level(self) -> bool {
        self == Self::default()
    }

    /// Whether Z is that of the workpiece: what is turned is turned about it.
    pub fn is_upright(self) -> bool {
        let [_, _, [x, y, z]] = self.axes;
        x.abs() + y.abs() <= 0.0 && 0.0 < z
    }

    /// By how many degrees X is turned about Z.
    pub fn about_z(self) -> f64 {
        let [[x, y, _], ..] = self.axes;
        libm::atan2(y, x).to_degrees()
    }
}

/// A scalar product of a vector that is known in part.
fn sum(axis: [f64; 3], vector: [Option<f64>; 3]) -> Option<f64> {
    let parts = axis.into_iter().zip(vector).filter(|(share, _)| 0.0 < share.abs());
    parts.map(|(share, part)| Some(share * part?)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(found: [f64; 3], right: [f64; 3]) {
        assert!(found.iter().zip(right).all(|(found, right)| (found - right).abs() < 1e-12), "{found:?}, {right:?}");
    }

    #[test]
    fn axes_of_a_tilted_plane_are_those_worked_out_by_hand() {
        let tilted = Orientation::spatial([0.0, 90.0, 30.0]);
        let half = 3.0_f64.sqrt() / 2.0;
        check(tilted.out([1.0, 0.0, 0.0]), [0.0, 0.0, -1.0]);
        check(tilted.out([0.0, 1.0, 0.0]), [-0.5, half, 0.0]);
        check(tilted.out([0.0, 0.0, 1.0]), [half, 0.5, 0.0]);
        check(tilted.within(tilted.out([3.0, -4.0, 5.0])), [3.0, -4.0, 5.0]);
    }

    #[test]
    fn a_quarter_turn_is_exact() {
        let exact = |found: [f64; 3], right: [f64; 3]| {
            assert!(found.iter().zip(right).all(|(found, right)| (found - right).abs() <= 0.0), "{found:?}, {right:?}");
        };
        exact(Orientation::in_plane(Plane::Xy, 90.0).out([1.0, 2.0, 3.0]), [-2.0, 1.0, 3.0]);
        exact(Orientation::in_plane(Plane::Zx, -90.0).out([0.0, 0.0, 1.0]), [-1.0, 0.0, 0.0]);
        assert!(Orientation::in_plane(Plane::Yz, 360.0).is_level());
        assert!(Orientation::in_plane(Plane::Xy, 0.4).is_upright());
    }

    #[test]
    fn what_is_known_stays_known_where_it_depends_on_nothing_else() {
        let turned = Orientation::in_plane(Plane::Xy, 90.0);
        assert_eq!(turned.out_of_known([Some(1.0), None, Some(5.0)]), [None, Some(1.0), Some(5.0)]);
        assert_eq!(turned.within_known([None, Some(1.0), Some(5.0)]), [Some(1.0), None, Some(5.0)]);
    }
}
