//! Three-by-three matrices.

use super::{Lane, Vec3};
use core::ops::{Add, AddAssign, Mul, Sub};

/// A 3×3 matrix, stored by columns.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Mat3<T = f64> {
    /// The three columns.
    pub cols: [Vec3<T>; 3],
}

impl<T: Lane> Mat3<T> {
    /// From three columns.
    #[inline(always)]
    pub fn from_cols(c0: Vec3<T>, c1: Vec3<T>, c2: Vec3<T>) -> Self {
        Self { cols: [c0, c1, c2] }
    }
    /// From three rows.
    #[inline(always)]
    pub fn from_rows(r0: Vec3<T>, r1: Vec3<T>, r2: Vec3<T>) -> Self {
        Self::from_cols(r0, r1, r2).transposed()
    }
    /// diag(d).
    #[inline(always)]
    pub fn diagonal(d: Vec3<T>) -> Self {
        let o = d.x.like(0.0);
        Self::from_cols(Vec3::new(d.x, o, o), Vec3::new(o, d.y, o), Vec3::new(o, o, d.z))
    }
    /// The cross matrix \[a\]×, with \[a\]× b = a × b.
    #[inline(always)]
    pub fn cross(a: Vec3<T>) -> Self {
        let o = a.x.like(0.0);
        Self::from_cols(Vec3::new(o, a.z, -a.y), Vec3::new(-a.z, o, a.x), Vec3::new(a.y, -a.x, o))
    }
    /// The dyad a bᵀ.
    #[inline(always)]
    pub fn outer(a: Vec3<T>, b: Vec3<T>) -> Self {
        Self::from_cols(a * b.x, a * b.y, a * b.z)
    }
    /// The transposed matrix.
    #[inline(always)]
    pub fn transposed(self) -> Self {
        let [a, b, c] = self.cols;
        Self::from_cols(Vec3::new(a.x, b.x, c.x), Vec3::new(a.y, b.y, c.y), Vec3::new(a.z, b.z, c.z))
    }
    /// The sum of the diagonal.
    #[inline(always)]
    pub fn trace(self) -> T {
        self.cols[0].x + self.cols[1].y + self.cols[2].z
    }
    /// The determinant.
    #[inline(always)]
    pub fn determinant(self) -> T {
        self.cols[0].dot(self.cols[1].cross(self.cols[2]))
    }
    /// The inverse, by cofactors. Not finite for a singular matrix.
    #[inline(always)]
    pub fn inverse(self) -> Self {
        let [a, b, c] = self.cols;
        let (bc, ca, ab) = (b.cross(c), c.cross(a), a.cross(b));
        let det = a.dot(bc);
        Self::from_rows(bc / det, ca / det, ab / det)
    }
    /// Every element times `s`.
    #[inline(always)]
    pub fn scaled(self, s: T) -> Self {
        let [a, b, c] = self.cols;
        Self::from_cols(a * s, b * s, c * s)
    }
}

impl Mat3 {
    /// The unit matrix.
    pub const IDENTITY: Self = Self { cols: [Vec3::X, Vec3::Y, Vec3::Z] };
    /// The zero matrix.
    pub const ZERO: Self = Self { cols: [Vec3::ZERO; 3] };

    /// The element of row `i`, column `j`.
    ///
    /// # Panics
    /// If `i` or `j` exceeds 2.
    pub fn at(&self, i: usize, j: usize) -> f64 {
        self.cols[j][i]
    }
    /// The diagonal.
    pub fn diag(&self) -> Vec3 {
        Vec3::new(self.cols[0].x, self.cols[1].y, self.cols[2].z)
    }
    /// The largest |element|.
    pub fn max_abs(&self) -> f64 {
        let [a, b, c] = self.cols.map(Vec3::max_abs);
        Vec3::new(a, b, c).max_abs()
    }
    /// Whether all nine elements are finite.
    pub fn is_finite(&self) -> bool {
        self.cols.iter().all(|c| c.is_finite())
    }
}

impl Default for Mat3 {
    fn default() -> Self {
        Self::ZERO
    }
}

impl<T: Lane> Mul<Vec3<T>> for Mat3<T> {
    type Output = Vec3<T>;
    #[inline(always)]
    fn mul(self, v: Vec3<T>) -> Vec3<T> {
        self.cols[0] * v.x + self.cols[1] * v.y + self.cols[2] * v.z
    }
}
impl<T: Lane> Mul for Mat3<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, b: Self) -> Self {
        Self::from_cols(self * b.cols[0], self * b.cols[1], self * b.cols[2])
    }
}
impl<T: Lane> Add for Mat3<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, b: Self) -> Self {
        Self::from_cols(self.cols[0] + b.cols[0], self.cols[1] + b.cols[1], self.cols[2] + b.cols[2])
    }
}
impl<T: Lane> Sub for Mat3<T> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, b: Self) -> Self {
        Self::from_cols(self.cols[0] - b.cols[0], self.cols[1] - b.cols[1], self.cols[2] - b.cols[2])
    }
}
impl<T: Lane> AddAssign for Mat3<T> {
    #[inline(always)]
    fn add_assign(&mut self, b: Self) {
        *self = *self + b;
    }
}
/// From rows, as a matrix is written on paper.
impl From<[[f64; 3]; 3]> for Mat3 {
    fn from([a, b, c]: [[f64; 3]; 3]) -> Self {
        Self::from_rows(a.into(), b.into(), c.into())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inverse_and_products_agree() {
        let m = Mat3::from([[2.0, -1.0, 0.5], [0.25, 3.0, 1.0], [-1.0, 0.5, 4.0]]);
        assert!((m * m.inverse() - Mat3::IDENTITY).max_abs() < 1e-15);
        assert!((m.transposed().determinant() - m.determinant()).abs() < 1e-14);
        assert_eq!(m.at(0, 1), -1.0);
        let (a, b) = (Vec3::new(1.0, 2.0, 3.0), Vec3::new(-2.0, 0.5, 1.0));
        assert_eq!(Mat3::cross(a) * b, a.cross(b));
        assert_eq!(Mat3::outer(a, b) * Vec3::Y, a * 0.5);
    }
}
