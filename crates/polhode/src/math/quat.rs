//! Unit quaternions: orientation and rotation.

use super::{Lane, Mat3, Vec3};
use core::ops::Mul;

/// A quaternion w + xi + yj + zk. Everywhere in this crate it is a unit: a rotation.
///
/// `rot` of a body takes body components to world components: `v_w = rot.rotate(v_b)`. `q` and `-q` are the same rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Quat<T = f64> {
    /// Scalar part.
    pub w: T,
    /// Vector part, first component.
    pub x: T,
    /// Vector part, second component.
    pub y: T,
    /// Vector part, third component.
    pub z: T,
}

impl<T> Quat<T> {
    /// The quaternion w + xi + yj + zk. It is not normalised here.
    #[inline(always)]
    pub const fn new(w: T, x: T, y: T, z: T) -> Self {
        Self { w, x, y, z }
    }
}

impl<T: Lane> Quat<T> {
    /// From scalar and vector part.
    #[inline(always)]
    pub fn from_parts(w: T, v: Vec3<T>) -> Self {
        Self { w, x: v.x, y: v.y, z: v.z }
    }
    /// The vector part.
    #[inline(always)]
    pub fn vector(self) -> Vec3<T> {
        Vec3::new(self.x, self.y, self.z)
    }
    /// The inverse rotation of a unit quaternion.
    #[inline(always)]
    pub fn conjugate(self) -> Self {
        Self { w: self.w, x: -self.x, y: -self.y, z: -self.z }
    }
    /// Sum of squares: 1 for a rotation.
    #[inline(always)]
    pub fn norm_squared(self) -> T {
        self.w * self.w + self.x * self.x + self.y * self.y + self.z * self.z
    }
    /// The four components times `s`.
    #[inline(always)]
    pub fn scaled(self, s: T) -> Self {
        Self { w: self.w * s, x: self.x * s, y: self.y * s, z: self.z * s }
    }
    /// The unit quaternion along this one.
    #[inline(always)]
    pub fn normalized(self) -> Self {
        let n = self.norm_squared().sqrt();
        Self { w: self.w / n, x: self.x / n, y: self.y / n, z: self.z / n }
    }
    /// One Newton step towards unit length, q(3 − |q|²)/2: exact to rounding for a quaternion that rounding alone has
    /// moved off the unit sphere, and without a square root or a division.
    #[inline(always)]
    pub fn renormalized(self) -> Self {
        let half = self.w.like(0.5);
        self.scaled(self.w.like(1.5) - half * self.norm_squared())
    }
    /// R v: body components to world components.
    #[inline(always)]
    pub fn rotate(self, v: Vec3<T>) -> Vec3<T> {
        let u = self.vector();
        let t = u.cross(v);
        let t = t + t;
        v + t * self.w + u.cross(t)
    }
    /// Rᵀ v: world components to body components.
    #[inline(always)]
    pub fn inverse_rotate(self, v: Vec3<T>) -> Vec3<T> {
        self.conjugate().rotate(v)
    }
    /// The orientation halfway to another, along the shorter way.
    #[inline(always)]
    pub fn halfway_to(self, other: Self) -> Self {
        let dot = self.w * other.w + self.vector().dot(other.vector());
        let other = Self::select(dot.lt(self.w.like(0.0)), other.scaled(self.w.like(-1.0)), other);
        Self::from_parts(self.w + other.w, self.vector() + other.vector()).normalized()
    }
    /// Lane-wise choice.
    #[inline(always)]
    pub fn select(mask: T::Mask, if_true: Self, if_false: Self) -> Self {
        Self {
            w: T::select(mask, if_true.w, if_false.w),
            x: T::select(mask, if_true.x, if_false.x),
            y: T::select(mask, if_true.y, if_false.y),
            z: T::select(mask, if_true.z, if_false.z),
        }
    }
    /// The rotation matrix R; its columns are the body axes in world components.
    #[inline(always)]
    pub fn to_mat3(self) -> Mat3<T> {
        let one = self.w.like(1.0);
        let (x2, y2, z2) = (self.x + self.x, self.y + self.y, self.z + self.z);
        let (xx, yy, zz) = (self.x * x2, self.y * y2, self.z * z2);
        let (xy, xz, yz) = (self.x * y2, self.x * z2, self.y * z2);
        let (wx, wy, wz) = (self.w * x2, self.w * y2, self.w * z2);
        Mat3::from_cols(
            Vec3::new(one - (yy + zz), xy + wz, xz - wy),
            Vec3::new(xy - wz, one - (xx + zz), yz + wx),
            Vec3::new(xz + wy, yz - wx, one - (xx + yy)),
        )
    }
}

impl<T: Lane> Mul for Quat<T> {
    type Output = Self;
    /// Composition: `(a * b).rotate(v) = a.rotate(b.rotate(v))`.
    #[inline(always)]
    fn mul(self, b: Self) -> Self {
        let a = self;
        Self {
            w: a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
            x: a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            y: a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            z: a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w,
        }
    }
}

impl Quat {
    /// No rotation.
    pub const IDENTITY: Self = Self::new(1.0, 0.0, 0.0, 0.0);

    /// exp(u): the rotation by |u| \[rad\] about the direction of u.
    pub fn from_rotation_vector(u: Vec3) -> Self {
        let angle2 = u.length_squared();
        if angle2 < 1e-8 {
            // sin(a/2)/a and cos(a/2) to a⁶: the next terms are below 1e-28.
            let s = 0.5 - angle2 / 48.0 + angle2 * angle2 / 3840.0;
            let w = 1.0 - angle2 / 8.0 + angle2 * angle2 / 384.0;
            return Self::from_parts(w, u * s);
        }
        let angle = angle2.sqrt();
        let (sin, cos) = libm::sincos(0.5 * angle);
        Self::from_parts(cos, u * (sin / angle))
    }
    /// The rotation by `angle` \[rad\] about the unit vector `axis`.
    pub fn from_axis_angle(axis: Vec3, angle: f64) -> Self {
        let (sin, cos) = libm::sincos(0.5 * angle);
        Self::from_parts(cos, axis * sin)
    }
    /// log: the rotation vector u with |u| ≤ π and exp(u) = ±q \[rad\].
    pub fn to_rotation_vector(self) -> Vec3 {
        let q = if self.w < 0.0 { self.scaled(-1.0) } else { self };
        let v = q.vector();
        let sin = v.length();
        if sin < 1e-10 {
            // atan(s)/s = 1 to 1e-20.
            return v * 2.0;
        }
        v * (2.0 * libm::atan2(sin, q.w) / sin)
    }
    /// The angle of the rotation that takes `other` to `self`, in [0, π] rad; accurate also where it is tiny.
    pub fn angle_to(self, other: Self) -> f64 {
        let d = self * other.conjugate();
        2.0 * libm::atan2(d.vector().length(), d.w.abs())
    }
    /// From a rotation matrix (Shepperd's method: the largest of four divisors).
    pub fn from_mat3(m: &Mat3) -> Self {
        let [c0, c1, c2] = m.cols;
        let (t0, t1, t2, t3) =
            (1.0 + c0.x + c1.y + c2.z, 1.0 + c0.x - c1.y - c2.z, 1.0 - c0.x + c1.y - c2.z, 1.0 - c0.x - c1.y + c2.z);
        let q = if t0 >= t1 && t0 >= t2 && t0 >= t3 {
            Self::new(t0, c1.z - c2.y, c2.x - c0.z, c0.y - c1.x)
        } else if t1 >= t2 && t1 >= t3 {
            Self::new(c1.z - c2.y, t1, c0.y + c1.x, c2.x + c0.z)
        } else if t2 >= t3 {
            Self::new(c2.x - c0.z, c0.y + c1.x, t2, c1.z + c2.y)
        } else {
            Self::new(c0.y - c1.x, c2.x + c0.z, c1.z + c2.y, t3)
        };
        q.normalized()
    }
    /// The shortest rotation that takes the unit vector `a` to the unit vector `b`.
    pub fn from_to(a: Vec3, b: Vec3) -> Self {
        let w = 1.0 + a.dot(b);
        if w < 1e-14 {
            return Self::from_parts(0.0, a.any_perpendicular());
        }
        Self::from_parts(w, a.cross(b)).normalized()
    }
    /// Whether all four components are finite.
    pub fn is_finite(self) -> bool {
        self.w.is_finite() && self.x.is_finite() && self.y.is_finite() && self.z.is_finite()
    }
}

impl Default for Quat {
    fn default() -> Self {
        Self::IDENTITY
    }
}
impl From<[f64; 4]> for Quat {
    /// In the order w, x, y, z.
    fn from([w, x, y, z]: [f64; 4]) -> Self {
        Self { w, x, y, z }
    }
}
impl From<Quat> for [f64; 4] {
    /// In the order w, x, y, z.
    fn from(q: Quat) -> Self {
        [q.w, q.x, q.y, q.z]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rotation_matrix_and_quaternion_agree() {
        for u in [[0.3, -0.2, 0.9], [3.0, 0.1, -0.4], [0.0, 0.0, 3.1], [1e-9, 2e-9, 0.0]] {
            let q = Quat::from_rotation_vector(u.into());
            let v = Vec3::new(0.3, -1.2, 2.0);
            // Some 16 roundings of numbers up to |v|: 16 ε/2 |v| = 4e-15.
            assert!((q.to_mat3() * v - q.rotate(v)).length() < 4e-15);
            assert!((q.inverse_rotate(q.rotate(v)) - v).length() < 4e-15);
            let back = Quat::from_mat3(&q.to_mat3());
            assert!(back.angle_to(q) < 4e-15);
            assert!((q.to_rotation_vector() - Vec3::from(u)).length() < 4e-15, "{u:?}");
        }
    }

    #[test]
    fn exp_is_continuous_where_the_series_takes_over() {
        let d = Vec3::new(1.0, 2.0, -2.0) / 3.0;
        let (a, b) = (0.9999999e-4, 1.0000001e-4);
        let step = Quat::from_rotation_vector(d * a).angle_to(Quat::from_rotation_vector(d * b));
        assert!((step - (b - a)).abs() < 1e-19);
    }

    #[test]
    fn from_to_handles_opposite_directions() {
        for (a, b) in [(Vec3::X, -Vec3::X), (Vec3::Y, Vec3::Y), (Vec3::Z, Vec3::X)] {
            assert!((Quat::from_to(a, b).rotate(a) - b).length() < 1e-15);
        }
    }
}
