//! Three components in one frame.

use super::Lane;
use core::ops::{Add, AddAssign, Div, Index, IndexMut, Mul, MulAssign, Neg, Sub, SubAssign};

/// A vector of three components, all in one frame that the name of the variable or the documentation gives.
///
/// `Vec3` alone means `Vec3<f64>`, the public type; `Vec3<Wide<S>>` is several of them.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
#[repr(C)]
pub struct Vec3<T = f64> {
    /// First component.
    pub x: T,
    /// Second component.
    pub y: T,
    /// Third component.
    pub z: T,
}

impl<T> Vec3<T> {
    /// The vector (x, y, z).
    #[inline(always)]
    pub const fn new(x: T, y: T, z: T) -> Self {
        Self { x, y, z }
    }
}

impl<T: Lane> Vec3<T> {
    /// The scalar product a·b.
    #[inline(always)]
    pub fn dot(self, b: Self) -> T {
        self.x * b.x + self.y * b.y + self.z * b.z
    }
    /// The vector product a×b.
    #[inline(always)]
    pub fn cross(self, b: Self) -> Self {
        Self { x: self.y * b.z - self.z * b.y, y: self.z * b.x - self.x * b.z, z: self.x * b.y - self.y * b.x }
    }
    /// |a|².
    #[inline(always)]
    pub fn length_squared(self) -> T {
        self.dot(self)
    }
    /// |a|. Overflows above 1e154: see [`Vec3::robust_length`] for user input of any size.
    #[inline(always)]
    pub fn length(self) -> T {
        self.dot(self).sqrt()
    }
    /// The product component by component.
    #[inline(always)]
    pub fn scale(self, b: Self) -> Self {
        Self { x: self.x * b.x, y: self.y * b.y, z: self.z * b.z }
    }
    /// The same constant vector in every lane.
    #[inline(always)]
    pub fn like(self, v: Vec3) -> Self {
        Self { x: self.x.like(v.x), y: self.y.like(v.y), z: self.z.like(v.z) }
    }
    /// Lane-wise choice between two vectors.
    #[inline(always)]
    pub fn select(mask: T::Mask, if_true: Self, if_false: Self) -> Self {
        Self {
            x: T::select(mask, if_true.x, if_false.x),
            y: T::select(mask, if_true.y, if_false.y),
            z: T::select(mask, if_true.z, if_false.z),
        }
    }
}

impl Vec3 {
    /// (0, 0, 0).
    pub const ZERO: Self = Self::new(0.0, 0.0, 0.0);
    /// (1, 0, 0).
    pub const X: Self = Self::new(1.0, 0.0, 0.0);
    /// (0, 1, 0).
    pub const Y: Self = Self::new(0.0, 1.0, 0.0);
    /// (0, 0, 1).
    pub const Z: Self = Self::new(0.0, 0.0, 1.0);

    /// All three components equal to `v`.
    pub const fn splat(v: f64) -> Self {
        Self::new(v, v, v)
    }
    /// |a| without overflow or underflow in between.
    pub fn robust_length(self) -> f64 {
        let big = self.max_abs();
        if big == 0.0 || !big.is_finite() {
            return big;
        }
        (self / big).length() * big
    }
    /// The direction of a, or `None` where a is zero or not finite.
    pub fn direction(self) -> Option<Self> {
        let big = self.max_abs();
        if big == 0.0 || !self.is_finite() {
            return None;
        }
        let a = self / big;
        Some(a / a.length())
    }
    /// The largest |component|; NaN if one is NaN.
    pub fn max_abs(self) -> f64 {
        let [x, y, z] = self.to_array().map(f64::abs);
        if x.is_nan() || y.is_nan() || z.is_nan() {
            return f64::NAN;
        }
        x.greatest(y).greatest(z)
    }
    /// Whether all three components are finite.
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.z.is_finite()
    }
    /// A unit vector perpendicular to the unit vector a; continuous but for one jump.
    pub fn any_perpendicular(self) -> Self {
        // The axis least along a gives the best conditioned product.
        let [x, y, z] = self.to_array().map(f64::abs);
        let axis = if x <= y && x <= z {
            Self::X
        } else if y <= z {
            Self::Y
        } else {
            Self::Z
        };
        let n = self.cross(axis);
        n / n.length()
    }
    /// The components as an array.
    pub const fn to_array(self) -> [f64; 3] {
        [self.x, self.y, self.z]
    }
}

impl<T: Lane> Add for Vec3<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, b: Self) -> Self {
        Self { x: self.x + b.x, y: self.y + b.y, z: self.z + b.z }
    }
}
impl<T: Lane> Sub for Vec3<T> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, b: Self) -> Self {
        Self { x: self.x - b.x, y: self.y - b.y, z: self.z - b.z }
    }
}
impl<T: Lane> Neg for Vec3<T> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { x: -self.x, y: -self.y, z: -self.z }
    }
}
impl<T: Lane> Mul<T> for Vec3<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, s: T) -> Self {
        Self { x: self.x * s, y: self.y * s, z: self.z * s }
    }
}
impl Mul<Vec3> for f64 {
    type Output = Vec3;
    #[inline(always)]
    fn mul(self, v: Vec3) -> Vec3 {
        v * self
    }
}
impl<T: Lane> Div<T> for Vec3<T> {
    type Output = Self;
    #[inline(always)]
    fn div(self, s: T) -> Self {
        Self { x: self.x / s, y: self.y / s, z: self.z / s }
    }
}
impl<T: Lane> AddAssign for Vec3<T> {
    #[inline(always)]
    fn add_assign(&mut self, b: Self) {
        *self = *self + b;
    }
}
impl<T: Lane> SubAssign for Vec3<T> {
    #[inline(always)]
    fn sub_assign(&mut self, b: Self) {
        *self = *self - b;
    }
}
impl<T: Lane> MulAssign<T> for Vec3<T> {
    #[inline(always)]
    fn mul_assign(&mut self, s: T) {
        *self = *self * s;
    }
}
impl core::iter::Sum for Vec3 {
    fn sum<I: Iterator<Item = Self>>(iter: I) -> Self {
        iter.fold(Self::ZERO, Add::add)
    }
}
impl Index<usize> for Vec3 {
    type Output = f64;
    /// # Panics
    /// If `i > 2`.
    fn index(&self, i: usize) -> &f64 {
        match i {
            0 => &self.x,
            1 => &self.y,
            2 => &self.z,
            _ => panic!("a Vec3 has components 0, 1, 2; asked for {i}"),
        }
    }
}
impl IndexMut<usize> for Vec3 {
    /// # Panics
    /// If `i > 2`.
    fn index_mut(&mut self, i: usize) -> &mut f64 {
        match i {
            0 => &mut self.x,
            1 => &mut self.y,
            2 => &mut self.z,
            _ => panic!("a Vec3 has components 0, 1, 2; asked for {i}"),
        }
    }
}
impl From<[f64; 3]> for Vec3 {
    fn from([x, y, z]: [f64; 3]) -> Self {
        Self { x, y, z }
    }
}
impl From<Vec3> for [f64; 3] {
    fn from(v: Vec3) -> Self {
        v.to_array()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cross_is_right_handed() {
        assert_eq!(Vec3::X.cross(Vec3::Y), Vec3::Z);
        assert_eq!(Vec3::Y.cross(Vec3::Z), Vec3::X);
    }

    #[test]
    fn direction_survives_every_size() {
        for s in [1e-300, 1e-160, 1.0, 1e160, 1e300] {
            let d = Vec3::new(3.0 * s, 0.0, -4.0 * s).direction().unwrap();
            assert!((d - Vec3::new(0.6, 0.0, -0.8)).length() < 1e-15, "{s}");
            assert!((Vec3::new(3.0 * s, 0.0, -4.0 * s).robust_length() / (5.0 * s) - 1.0).abs() < 1e-15);
        }
        assert_eq!(Vec3::ZERO.direction(), None);
        assert_eq!(Vec3::new(f64::NAN, 1.0, 0.0).direction(), None);
        assert_eq!(Vec3::new(f64::INFINITY, 1.0, 0.0).direction(), None);
    }
}
