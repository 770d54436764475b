//! Gravitation: the ellipse of Kepler, and bodies that attract each other.

use super::suite::Check;
use polhode::math::Vec3;

pub(super) const CHECKS: &[Check] = &[];

/// Where a body is, time t \[s\] after it was nearest to the centre on the x axis, on the ellipse of a = 1 m, µ = 1 m³/s² \[m\].
pub(super) fn kepler_position(e: f64, t: f64) -> Vec3 {
    // Kepler's equation E − e sin E = t by Newton's iteration.
    let mut anomaly = t;
    for _ in 0..50 {
        let step = (anomaly - e * libm::sin(anomaly) - t) / (1.0 - e * libm::cos(anomaly));
        anomaly -= step;
    }
    Vec3::new(libm::cos(anomaly) - e, libm::sqrt(1.0 - e * e) * libm::sin(anomaly), 0.0)
}
