//! The laws, against 30 digits of mpmath. What they must keep: twelve digits, in the tails too.

use fitcheck_core::law::{
    chi_square, chi_square_quantile, fisher, fisher_quantile, gamma, gamma_density, normal, normal_quantile, student,
    student_quantile,
};

use crate::{data, near, number, within};

/// Calls a check for each row of a table.
fn each(table: &str, check: impl Fn(&[f64])) {
    let all = data("laws.json");
    let rows = all[table].as_array().unwrap();
    assert!(5 <= rows.len());
    for row in rows {
        let row: Vec<f64> = row.as_array().unwrap().iter().map(number).collect();
        check(&row);
    }
}

#[test]
fn the_normal_law_has_its_quantiles_and_tails() {
    each("normal_quantile", |row| within(normal_quantile(row[0]), row[1], 1e-12 * row[1].abs().max(1e-3)));
    each("normal_above", |row| near(normal(row[0]).above, row[1], 1e-12));
    assert!(normal_quantile(0.0).is_infinite() && normal_quantile(1.0).is_infinite());
    assert!(normal_quantile(-0.1).is_nan() && normal_quantile(f64::NAN).is_nan());
}

#[test]
fn the_gamma_law_keeps_its_digits_in_both_tails_and_with_large_shapes() {
    each("gamma", |row| {
        let tails = gamma(row[0], row[1]);
        near(tails.below, row[2], 1e-12);
        near(tails.above, row[3], 1e-12);
        near(gamma_density(row[0], row[1]), row[4], 1e-12);
    });
}

#[test]
fn the_chi_square_law_has_its_quantiles() {
    each("chi_square_quantile", |row| near(chi_square_quantile(row[0], row[1]), row[2], 1e-11));
    within(chi_square(4.0, 3.0).below + chi_square(4.0, 3.0).above, 1.0, 1e-15);
}

#[test]
fn students_law_has_its_quantiles() {
    each("student_quantile", |row| near(student_quantile(row[0], row[1]), row[2], 1e-11));
    within(student_quantile(5.0, 0.05), -student_quantile(5.0, 0.95), 1e-12);
    within(student(5.0, -2.0).below, student(5.0, 2.0).above, 1e-15);
}

#[test]
fn fishers_law_keeps_its_digits_in_both_tails() {
    each("fisher", |row| {
        near(fisher([row[0], row[1]], row[2]).above, row[3], 1e-12);
        near(fisher([row[0], row[1]], row[2]).below, row[4], 1e-12);
    });
    each("fisher_quantile", |row| near(fisher_quantile([row[0], row[1]], row[2]), row[3], 1e-11));
}
