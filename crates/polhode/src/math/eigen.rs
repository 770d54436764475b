//! Eigenvalues and eigenvectors of a symmetric 3×3 matrix, by Jacobi's rotations.
//!
//! Each rotation makes one off-diagonal pair zero; a few sweeps over the three pairs converge quadratically. The rotations
//! are by at most 45°, so the eigenvectors stay as near as can be to the axes they started from: nothing is sorted, and
//! an already diagonal matrix keeps its axes to the bit. Jacobi's method also keeps the small eigenvalue of a needle, which
//! the closed form by the characteristic polynomial loses (Demmel & Veselić 1992).

use super::{Mat3, Vec3};

/// A = V diag(λ) Vᵀ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SymmetricEigen {
    /// The eigenvalues λ, in the order of the columns of `vectors`; not sorted.
    pub values: Vec3,
    /// The eigenvectors as columns: a right-handed rotation matrix.
    pub vectors: Mat3,
}

/// Cyclic Jacobi needs 5 or 6 sweeps for a full f64; more than this never happens for finite elements.
const MAX_SWEEPS: usize = 30;

impl Mat3 {
    /// Eigenvalues and eigenvectors of a symmetric matrix, to rounding; reads the upper triangle only.
    ///
    /// A diagonal matrix gives its diagonal and the unit matrix, exactly. The elements must be finite; otherwise the result
    /// means nothing.
    pub fn symmetric_eigen(&self) -> SymmetricEigen {
        let mut a = *self;
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            a.cols[p][q] = a.cols[q][p];
        }
        let mut v = Self::IDENTITY;
        for _ in 0..MAX_SWEEPS {
            let rotated = [(0, 1), (0, 2), (1, 2)].map(|(p, q)| rotate(&mut a, &mut v, p, q));
            if rotated == [false; 3] {
                break;
            }
        }
        SymmetricEigen { values: a.diag(), vectors: v }
    }
}

/// Makes `a[p][q]` zero by a rotation in the plane of axes `p` and `q`; false where it already is, to rounding.
fn rotate(a: &mut Mat3, v: &mut Mat3, p: usize, q: usize) -> bool {
    let (app, aqq, apq) = (a.cols[p][p], a.cols[q][q], a.cols[q][p]);
    // Relative to both diagonal elements, not to the largest: this is what keeps the small eigenvalue of a needle.
    let negligible = 0.25 * f64::EPSILON * app.abs().sqrt() * aqq.abs().sqrt();
    let must_rotate = apq.abs() > negligible;
    if must_rotate {
        // tan of the angle: the smaller root of t² + 2θt − 1 = 0.
        let theta = 0.5 * (aqq - app) / apq;
        let t = theta.signum() / (theta.abs() + (theta * theta + 1.0).sqrt());
        let c = 1.0 / (t * t + 1.0).sqrt();
        let s = t * c;
        let r = 3 - p - q;
        let (arp, arq) = (a.cols[p][r], a.cols[q][r]);
        let (new_rp, new_rq) = (c * arp - s * arq, s * arp + c * arq);
        a.cols[p][p] = app - t * apq;
        a.cols[q][q] = aqq + t * apq;
        (a.cols[p][r], a.cols[r][p]) = (new_rp, new_rp);
        (a.cols[q][r], a.cols[r][q]) = (new_rq, new_rq);
        let (vp, vq) = (v.cols[p], v.cols[q]);
        v.cols[p] = vp * c - vq * s;
        v.cols[q] = vp * s + vq * c;
    }
    a.cols[q][p] = 0.0;
    a.cols[p][q] = 0.0;
    must_rotate
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Quat;
    use proptest::prelude::*;

    /// R diag(d) Rᵀ, with the upper triangle copied down.
    fn turned(d: Vec3, u: Vec3) -> Mat3 {
        let r = Quat::from_rotation_vector(u).to_mat3();
        let mut a = r * Mat3::diagonal(d) * r.transposed();
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            a.cols[p][q] = a.cols[q][p];
        }
        a
    }

    #[test]
    fn a_diagonal_matrix_keeps_its_axes_to_the_bit() {
        for d in [[3.0, 1.0, 2.0], [0.1, 0.1, 0.1], [0.0, 0.0, 1.0], [1e-300, 1e300, 1.0], [-1.0, 2.0, 0.0]] {
            let e = Mat3::diagonal(d.into()).symmetric_eigen();
            assert_eq!(e.values, d.into());
            assert_eq!(e.vectors, Mat3::IDENTITY);
        }
    }

    #[test]
    fn a_needle_keeps_its_small_moment() {
        // diag(1, 1e10, 1e10) D-scaled: off-diagonals of a Gram matrix D H D with H well conditioned. The condition number
        // of the matrix is 1e10, that of H is 3, and it is H that bounds the relative error: a few 1e-16.
        let s = 1e5;
        let a = Mat3::from([[1.0, 0.5 * s, 0.0], [0.5 * s, s * s, 0.5 * s * s], [0.0, 0.5 * s * s, s * s]]);
        let e = a.symmetric_eigen();
        // det = s⁴(1 − ¼ − ¼) = s⁴/2, an exact number; the product of eigenvalues has to give it.
        let product = e.values.x * e.values.y * e.values.z;
        assert!((product / (0.5 * s * s * s * s) - 1.0).abs() < 1e-14, "{product:e}");
    }

    #[test]
    fn small_rotations_stay_small() {
        let a = turned(Vec3::new(3.0, 1.0, 2.0), Vec3::new(0.01, -0.02, 0.03));
        let e = a.symmetric_eigen();
        assert!((e.values - Vec3::new(3.0, 1.0, 2.0)).max_abs() < 1e-14);
        assert!(Quat::from_mat3(&e.vectors).angle_to(Quat::IDENTITY) < 0.04);
    }

    proptest! {
        #[test]
        fn reconstruction_is_exact_to_rounding(
            d in prop::array::uniform3(-10.0..10.0_f64),
            u in prop::array::uniform3(-2.0..2.0_f64),
            exponent in -100..100_i32,
        ) {
            let size = libm::exp2(f64::from(exponent));
            let a = turned(Vec3::from(d) * size, u.into());
            let e = a.symmetric_eigen();
            let v = e.vectors;
            let back = v * Mat3::diagonal(e.values) * v.transposed();
            // Five sweeps of three rotations, each of a few roundings of 1.1e-16: below 40 ε of the largest element.
            let allowed = 40.0 * f64::EPSILON * a.max_abs();
            prop_assert!((back - a).max_abs() <= allowed, "{:e}", (back - a).max_abs() / a.max_abs());
            prop_assert!((v.transposed() * v - Mat3::IDENTITY).max_abs() < 40.0 * f64::EPSILON);
            prop_assert!((v.determinant() - 1.0).abs() < 40.0 * f64::EPSILON);
        }
    }
}
