//! The moments of order 0, 1 and 2 of a distribution of mass.

use super::{MassProperties, MassProperties2, tensor};
use crate::error::Error;
use crate::math::{Mat3, Pose, Quat, Vec3};
use core::iter::Sum;
use core::ops::{Add, Sub};

/// How much mass, where, and how spread: M = Σ m, c = Σ m r / M, C = Σ m (r − c)(r − c)ᵀ.
///
/// Anything with mass has moments, also what no rigid body of its own can be: a point, a rod, a lamina. They add, so that a
/// body is the sum of its parts, and subtract, so that a part can be a hole. A planar distribution is one with z = 0.
///
/// The second moment is held about the centre and not about the origin, so that no digits are lost far from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moments {
    /// Total mass M \[kg\].
    pub mass: f64,
    /// Centre of mass c, in the axes and from the origin of the frame of the parts \[m\].
    pub center: Vec3,
    /// Second moment C about the centre, symmetric, same axes \[kg·m²\].
    pub second: Mat3,
}

impl Moments {
    /// No mass.
    pub const ZERO: Self = Self { mass: 0.0, center: Vec3::ZERO, second: Mat3::ZERO };

    /// From the mass and the mean squares of the three coordinates from the centre \[m²\]; the mean products are zero.
    pub(super) fn from_mean_squares(mass: f64, center: Vec3, mean_squares: Vec3) -> Self {
        Self { mass, center, second: Mat3::diagonal(mean_squares * mass) }
    }
    /// J = tr(C) 1 − C, the inertia about the centre of mass \[kg·m²\]; singular for a point or a rod.
    pub fn inertia(&self) -> Mat3 {
        tensor::inertia_of(&self.second)
    }
    /// The inertia about `point`, by the parallel-axis theorem \[kg·m²\].
    pub fn inertia_about(&self, point: impl Into<Vec3>) -> Mat3 {
        self.inertia() + tensor::of_point(self.center - point.into()).scaled(self.mass)
    }
    /// The same mass in a frame that sees it displaced by `by` \[m\].
    pub fn translated(self, by: impl Into<Vec3>) -> Self {
        Self { center: self.center + by.into(), ..self }
    }
    /// The same mass turned about the origin by `rot`.
    pub fn rotated(self, rot: Quat) -> Self {
        Self { center: rot.rotate(self.center), second: tensor::rotated(&self.second, rot), ..self }
    }
    /// The moments in frame a, from those in frame b.
    pub fn transformed(self, pose_ab: Pose) -> Self {
        self.rotated(pose_ab.rot).translated(pose_ab.x)
    }
    /// All masses times `factor`; −1 makes a hole to add.
    pub fn with_mass_times(self, factor: f64) -> Self {
        Self { mass: self.mass * factor, second: self.second.scaled(factor), ..self }
    }
    /// As the mass properties of a rigid body in space.
    ///
    /// # Errors
    /// As [`MassProperties::new`]: no mass, or a point or rod, which no rigid body can be.
    pub fn properties(&self) -> Result<MassProperties, Error> {
        MassProperties::new(self.mass, self.center, self.inertia())
    }
    /// As the mass properties of a rigid body in the plane z = 0: the inertia is that about the z axis.
    ///
    /// # Errors
    /// As [`MassProperties2::new`]: no mass, or all of it in one point.
    pub fn planar(&self) -> Result<MassProperties2, Error> {
        let c = self.second.diag();
        MassProperties2::new(self.mass, [self.center.x, self.center.y], c.x + c.y)
    }
}

impl Add for Moments {
    type Output = Self;
    /// Both masses together; both must be given in the same frame. Not finite where two masses cancel.
    fn add(self, b: Self) -> Self {
        if self.mass == 0.0 {
            return b;
        }
        if b.mass == 0.0 {
            return self;
        }
        let mass = self.mass + b.mass;
        let d = b.center - self.center;
        let share = b.mass / mass;
        Self {
            mass,
            center: self.center + d * share,
            second: self.second + b.second + Mat3::outer(d, d).scaled(self.mass * share),
        }
    }
}

impl Sub for Moments {
    type Output = Self;
    /// The first without the second, which must lie within it to make sense.
    fn sub(self, hole: Self) -> Self {
        self + hole.with_mass_times(-1.0)
    }
}

impl Sum for Moments {
    fn sum<I: Iterator<Item = Self>>(parts: I) -> Self {
        parts.fold(Self::ZERO, Add::add)
    }
}

impl Default for Moments {
    fn default() -> Self {
        Self::ZERO
    }
}

impl From<MassProperties> for Moments {
    /// The inverse of J = tr(C) 1 − C: C = ½ tr(J) 1 − J.
    fn from(p: MassProperties) -> Self {
        let j = p.inertia();
        let d = j.diag();
        let diagonal = Vec3::new(d.y + d.z - d.x, d.x + d.z - d.y, d.x + d.y - d.z) * 0.5;
        let second = tensor::symmetric(diagonal, -j.at(0, 1), -j.at(0, 2), -j.at(1, 2));
        Self { mass: p.mass(), center: p.center(), second }
    }
}
