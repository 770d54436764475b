//! Where a frame is: a rotation and a translation.

use super::{Lane, Quat, Vec3};
use core::ops::Mul;

/// A rigid motion. `pose_ab` takes b-coordinates to a-coordinates: p_a = rot p_b + x.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Pose<T = f64> {
    /// The origin of b in a-coordinates \[m\].
    pub x: Vec3<T>,
    /// The axes of b in a-coordinates.
    pub rot: Quat<T>,
}

impl<T: Lane> Pose<T> {
    /// From the origin and axes of the inner frame.
    #[inline(always)]
    pub fn new(x: Vec3<T>, rot: Quat<T>) -> Self {
        Self { x, rot }
    }
    /// A point of the inner frame, in coordinates of the outer.
    #[inline(always)]
    pub fn point(self, p: Vec3<T>) -> Vec3<T> {
        self.rot.rotate(p) + self.x
    }
    /// A point of the outer frame, in coordinates of the inner.
    #[inline(always)]
    pub fn inverse_point(self, p: Vec3<T>) -> Vec3<T> {
        self.rot.inverse_rotate(p - self.x)
    }
    /// `pose_ba` from `pose_ab`.
    #[inline(always)]
    pub fn inverse(self) -> Self {
        let rot = self.rot.conjugate();
        Self { x: -rot.rotate(self.x), rot }
    }
}

impl Pose {
    /// Both frames are the same.
    pub const IDENTITY: Self = Self { x: Vec3::ZERO, rot: Quat::IDENTITY };
}

impl Default for Pose {
    fn default() -> Self {
        Self::IDENTITY
    }
}

impl<T: Lane> Mul for Pose<T> {
    type Output = Self;
    /// `pose_ac = pose_ab * pose_bc`.
    #[inline(always)]
    fn mul(self, b: Self) -> Self {
        Self { x: self.point(b.x), rot: self.rot * b.rot }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inverse_undoes() {
        let a = Pose::new(Vec3::new(1.0, -2.0, 0.5), Quat::from_rotation_vector(Vec3::new(0.2, 1.0, -0.7)));
        let p = Vec3::new(0.3, 4.0, -1.0);
        assert!((a.inverse().point(a.point(p)) - p).length() < 1e-15 * 8.0);
        assert!((a.inverse_point(a.point(p)) - p).length() < 1e-15 * 8.0);
        assert!(((a * a.inverse()).x).length() < 1e-15);
    }
}
