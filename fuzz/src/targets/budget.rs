//! Any text as an uncertainty budget: what can be evaluated has shares of 100 %, and halving the largest part helps.

use fitcheck::budget::{Basis, Budget, Conditions, Evaluation, Geometry, Help, uncertainty};

use super::shared::told;

pub fn run(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    let budget = match Budget::read(text) {
        Ok(budget) => budget,
        Err(error) => return told(bytes, &error),
    };
    assert!(budget.date <= budget.valid_until);
    let conditions =
        Conditions { size: "25".parse().ok(), geometry: Geometry::steps(3, 60.0).ok(), ..Conditions::default() };
    let (u, k) = match &budget.basis {
        Basis::Calibrated(piece) => {
            let Ok(repeated) = piece.evaluate(None) else { return };
            assert!(0.0 < repeated.u());
            (repeated.u(), 2.0)
        }
        Basis::Contributions(contributions) => {
            let Ok(found) = Evaluation::of(contributions, &conditions) else { return };
            let shares: f64 = found.rows.iter().map(|row| row.share).sum();
            assert!((shares - 100.0).abs() < 1e-6, "{shares}");
            assert!(2.0 <= found.k && found.k < 14.0, "{}", found.k);
            assert!(matches!(found.help[..], [Help::Halved { u }, ..] if u < found.u));
            (found.u, found.k)
        }
    };
    if let Ok(given) = uncertainty(u, k) {
        let um: f64 = given.um().parse().expect("a number");
        assert!(u <= um * (1.0 + 1e-12) + 1e-9 && um <= u * (1.0 + 1e-12) + 2e-6, "{um} for {u}");
    }
}
