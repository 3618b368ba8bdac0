//! Vectors in the machine's space: X, Y, Z.

/// Scalar product.
pub fn dot([x, y, z]: [f64; 3], [with_x, with_y, with_z]: [f64; 3]) -> f64 {
    x * with_x + y * with_y + z * with_z
}

/// Length of a vector.
pub(crate) fn norm(vector: [f64; 3]) -> f64 {
    dot(vector, vector).sqrt()
}

/// The direction of a vector, with length 1; the vector must not be zero.
pub(crate) fn unit(vector: [f64; 3]) -> [f64; 3] {
    let length = norm(vector);
    vector.map(|part| part / length)
}

/// The unit vector of a direction of any length; `None` where it is zero or not finite.
pub fn direction(vector: [f64; 3]) -> Option<[f64; 3]> {
    let longest = vector.iter().fold(0.0, |longest: f64, part| longest.max(part.abs()));
    let has_one = vector.iter().all(|part| part.is_finite()) && 0.0 < longest;
    // The longest part is scaled to 1 first: otherwise the squares of very small and very large parts would be lost.
    has_one.then(|| unit(vector.map(|part| part / longest)))
}

/// The place at a distance along a direction.
pub fn along([x, y, z]: [f64; 3], [along_x, along_y, along_z]: [f64; 3], distance: f64) -> [f64; 3] {
    [x + distance * along_x, y + distance * along_y, z + distance * along_z]
}
