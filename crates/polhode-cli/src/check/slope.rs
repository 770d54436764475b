//! The order of a scheme, from its errors at two step sizes.

use super::suite::Findings;
use polhode::Error;

/// What a slope may differ from the order by.
pub(super) const ROOM: f64 = 0.1;
/// Why.
pub(super) const WHY: &str =
    "the next term of the error bends the slope by less than a tenth at these steps; the nearest other order is 1 away";

/// The slope of log error over log step between steps `h` and `h/2`.
pub(super) fn slope(error: f64, error_at_half: f64) -> f64 {
    libm::log2(error / error_at_half)
}

/// Measures `error` at `h` and `h/2`, and adds the deviation of the slope from the order.
pub(super) fn expect(
    findings: &mut Findings,
    name: &str,
    order: u32,
    h: f64,
    mut error: impl FnMut(f64) -> Result<f64, Error>,
) -> Result<(), Error> {
    let (coarse, fine) = (error(h)?, error(0.5 * h)?);
    let slope = slope(coarse, fine);
    let what = format!("order of {name} by slope, {slope:.2} for {order} (h = {h} and {} s)", 0.5 * h);
    findings.at_most(what, (slope - f64::from(order)).abs(), ROOM, WHY);
    Ok(())
}
