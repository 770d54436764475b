//! Integrals of 1, r and r rᵀ over segments, triangles and tetrahedra: one formula.
//!
//! Over a simplex with K corners and measure μ (length, area, volume), with s = Σ corners:
//!
//! ```text
//! ∫ 1 = μ      ∫ r = μ s / K      ∫ r rᵀ = μ (s sᵀ + Σ corner cornerᵀ) / (K (K + 1))
//! ```
//!
//! With the origin as fourth corner of a tetrahedron and μ = a·(b×c)/6 these are the polyhedral mass integrals of
//! Mirtich (1996) in the form of Eberly: S += d/24 (a + b + c), C += d/120 (s sᵀ + a aᵀ + b bᵀ + c cᵀ), d = a·(b×c).

use super::Moments;
use crate::math::{Lane, Mat3, Vec3};

/// Running integrals over simplices; measures are signed.
#[derive(Clone, Copy, Debug)]
pub(super) struct SimplexSum {
    pub(super) measure: f64,
    first: Vec3,
    second: Mat3,
}

impl SimplexSum {
    pub(super) const ZERO: Self = Self { measure: 0.0, first: Vec3::ZERO, second: Mat3::ZERO };

    pub(super) fn add<const K: usize>(&mut self, measure: f64, corners: [Vec3; K]) {
        let mut s = Vec3::ZERO;
        let mut squares = Mat3::ZERO;
        for corner in corners {
            s += corner;
            squares += Mat3::outer(corner, corner);
        }
        let k = K as f64;
        self.measure += measure;
        self.first += s * (measure / k);
        self.second += (squares + Mat3::outer(s, s)).scaled(measure / (k * (k + 1.0)));
    }
    /// The moments at `density` per measure of what was summed relative to `origin`.
    pub(super) fn moments(&self, density: f64, origin: Vec3) -> Moments {
        let d = self.first / self.measure;
        let second = self.second - Mat3::outer(d, d).scaled(self.measure);
        Moments { mass: density * self.measure, center: origin + d, second: second.scaled(density) }
    }
}

/// The middle of the bounding box: sums relative to it keep their digits wherever the shape is.
pub(super) fn middle(points: impl IntoIterator<Item = Vec3>) -> Vec3 {
    let (mut low, mut high) = (Vec3::splat(f64::INFINITY), Vec3::splat(f64::NEG_INFINITY));
    for p in points {
        (low, high) = (least(low, p), greatest(high, p));
    }
    low + (high - low) * 0.5
}

/// The lesser of each component.
pub(super) fn least(a: Vec3, b: Vec3) -> Vec3 {
    Vec3::new(a.x.least(b.x), a.y.least(b.y), a.z.least(b.z))
}

/// The greater of each component.
pub(super) fn greatest(a: Vec3, b: Vec3) -> Vec3 {
    Vec3::new(a.x.greatest(b.x), a.y.greatest(b.y), a.z.greatest(b.z))
}
