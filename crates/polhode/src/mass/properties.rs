//! Mass, centre of mass and inertia of a rigid body in space.

use super::{Moments, Particle, check, tensor};
use crate::error::Error;
use crate::math::{Mat3, Pose, Quat, Vec3};
use core::ops::Add;

/// The mass, centre of mass and inertia of a rigid body, known to be physical.
///
/// The inertia is about the centre of mass, in the axes of the frame in which the centre is given. Values exist only by way
/// of [`MassProperties::new`] and of operations that keep what it checks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassProperties {
    mass: f64,
    center: Vec3,
    inertia: Mat3,
}

/// Principal moments and axes: J = R diag(moments) Rᵀ with R the rotation `axes`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Principal {
    /// The principal moments, in the order of the axes, not sorted \[kg·m²\].
    pub moments: Vec3,
    /// Takes principal components to components in the frame of the inertia.
    pub axes: Quat,
}

/// Products of inertia below this share of the largest moment are what rounding leaves of a zero.
const NO_PRODUCT: f64 = 8.0 * f64::EPSILON;

impl MassProperties {
    /// From mass \[kg\], centre of mass \[m\] and inertia about it \[kg·m²\].
    ///
    /// Asymmetry and a violated triangle inequality of up to 1e-9 of the largest moment count as rounding; the mean of the
    /// two elements is kept.
    ///
    /// # Errors
    /// Names the first of `mass` (positive and finite), `center` (finite) and `inertia` that is not as it must be. The
    /// inertia must be finite, symmetric and positive, and its principal moments I1 ≤ I2 ≤ I3 must obey I3 ≤ I1 + I2, as
    /// those of every distribution of mass do. I1 must be more than 1e-12 I3: a line of mass is no rigid body in space,
    /// because nothing resists a turn about it.
    pub fn new(mass: f64, center: impl Into<Vec3>, inertia: impl Into<Mat3>) -> Result<Self, Error> {
        let mass = check::positive("mass", mass, "kg")?;
        let center = check::finite("center", center.into())?;
        let inertia = check::inertia(&inertia.into())?;
        Ok(Self { mass, center, inertia })
    }
    /// Of particles that keep their distances: [`Moments::from_particles`], validated.
    ///
    /// # Errors
    /// As [`Moments::from_particles`] and [`MassProperties::new`]: particles on one line have moments but make no rigid body.
    pub fn from_particles(particles: &[Particle]) -> Result<Self, Error> {
        Moments::from_particles(particles)?.properties()
    }

    /// Mass \[kg\], positive.
    pub fn mass(&self) -> f64 {
        self.mass
    }
    /// Centre of mass \[m\].
    pub fn center(&self) -> Vec3 {
        self.center
    }
    /// Inertia about the centre of mass \[kg·m²\], symmetric to the bit.
    pub fn inertia(&self) -> Mat3 {
        self.inertia
    }
    /// Inertia about `point`, by the parallel-axis theorem \[kg·m²\].
    pub fn inertia_about(&self, point: impl Into<Vec3>) -> Mat3 {
        self.inertia + tensor::of_point(self.center - point.into()).scaled(self.mass)
    }
    /// Principal moments and axes, to rounding.
    ///
    /// A diagonal inertia keeps its order and gives `axes == Quat::IDENTITY` exactly; otherwise the axes are the nearest that
    /// Jacobi's rotations find, right-handed. Products of inertia of 8 ε of the largest moment or less count as zero, so that
    /// a meshed cube keeps the axes it was drawn in.
    pub fn principal(&self) -> Principal {
        let mut j = self.inertia;
        let zero = NO_PRODUCT * j.max_abs();
        for (row, col) in [(0, 1), (0, 2), (1, 2)] {
            if j.at(row, col).abs() <= zero {
                j.cols[col][row] = 0.0;
            }
        }
        let eigen = j.symmetric_eigen();
        let axes = if eigen.vectors == Mat3::IDENTITY { Quat::IDENTITY } else { Quat::from_mat3(&eigen.vectors) };
        Principal { moments: eigen.values, axes }
    }

    /// The same body in a frame that sees it displaced by the finite vector `by` \[m\].
    pub fn translated(self, by: impl Into<Vec3>) -> Self {
        Self { center: self.center + by.into(), ..self }
    }
    /// The same body turned about the origin: c ← R c, J ← R J Rᵀ.
    pub fn rotated(self, rot: Quat) -> Self {
        Self { center: rot.rotate(self.center), inertia: tensor::rotated(&self.inertia, rot), ..self }
    }
    /// The mass properties in frame a, from those in frame b, for a finite pose.
    pub fn transformed(self, pose_ab: Pose) -> Self {
        self.rotated(pose_ab.rot).translated(pose_ab.x)
    }
    /// All lengths from the origin times `factor` at the same density: mass × factor³, inertia × factor⁵.
    ///
    /// # Errors
    /// If `factor` is not positive and finite, or takes the mass or inertia out of the range of f64.
    pub fn scaled(self, factor: f64) -> Result<Self, Error> {
        let f = check::positive("factor", factor, "")?;
        Self::new(self.mass * f * f * f, self.center * f, self.inertia.scaled(f * f * f * f * f))
    }
    /// The same shape with another total mass \[kg\]: the inertia in proportion.
    ///
    /// # Errors
    /// If `mass` is not positive and finite, or takes the inertia out of the range of f64.
    pub fn with_mass(self, mass: f64) -> Result<Self, Error> {
        let mass = check::positive("mass", mass, "kg")?;
        Self::new(mass, self.center, self.inertia.scaled(mass / self.mass))
    }
    /// The rigid sum of parts that are given in one frame.
    ///
    /// # Errors
    /// If there are no parts.
    pub fn sum(parts: &[Self]) -> Result<Self, Error> {
        parts.iter().copied().reduce(Add::add).ok_or_else(|| Error::new("parts", "there must be at least one"))
    }
}

impl Add for MassProperties {
    type Output = Self;
    /// Both bodies as one: J = J₁ + J₂ + m₁m₂/(m₁+m₂) (|d|² 1 − d dᵀ), d from one centre to the other.
    fn add(self, b: Self) -> Self {
        let mass = self.mass + b.mass;
        let d = b.center - self.center;
        let share = b.mass / mass;
        Self {
            mass,
            center: self.center + d * share,
            inertia: self.inertia + b.inertia + tensor::of_point(d).scaled(self.mass * share),
        }
    }
}

impl TryFrom<Moments> for MassProperties {
    type Error = Error;
    fn try_from(moments: Moments) -> Result<Self, Error> {
        moments.properties()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mass::solid;

    fn refusal(inertia: [[f64; 3]; 3]) -> String {
        MassProperties::new(1.0, [0.0; 3], inertia).unwrap_err().to_string()
    }

    #[test]
    fn a_refusal_says_which_and_by_how_much() {
        assert_eq!(
            refusal([[1.0, 0.0, 0.0], [0.0, 5.0, 0.0], [0.0, 0.0, 2.0]]),
            "inertia: violates the triangle inequality: I3 = 5 > I1 + I2 = 3 kg·m²"
        );
        assert_eq!(
            refusal([[1.0, 0.5, 0.0], [0.4, 1.0, 0.0], [0.0, 0.0, 1.0]]),
            "inertia: is not symmetric: element xy is 0.5, element yx is 0.4 kg·m²"
        );
        assert_eq!(
            refusal([[2.0, 0.0, 0.0], [0.0, -1e-5, 0.0], [0.0, 0.0, 2.0]]),
            "inertia: is not positive: its smallest principal moment is I1 = -1e-5 kg·m²"
        );
        assert_eq!(
            refusal([[0.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]]),
            "inertia: is that of a line without thickness: I1 = 0, I3 = 2 kg·m², and nothing resists a turn about the line"
        );
        assert_eq!(refusal([[0.0; 3]; 3]), "inertia: is zero: a point of mass needs a size to turn as a rigid body");
        assert_eq!(refusal([[f64::NAN; 3]; 3]), "inertia: has elements that are not finite");
        let unit = Mat3::IDENTITY;
        for (mass, said) in [(0.0, "0"), (-1.0, "-1"), (f64::NAN, "NaN"), (f64::INFINITY, "inf")] {
            let e = MassProperties::new(mass, Vec3::ZERO, unit).unwrap_err();
            assert_eq!(e.to_string(), format!("mass: must be positive and finite, is {said} kg"));
        }
        let e = MassProperties::new(1.0, [0.0, f64::NAN, 1.0], unit).unwrap_err();
        assert_eq!(e.to_string(), "center: must be finite, is (0, NaN, 1)");
    }

    #[test]
    fn refusals_do_not_depend_on_the_axes() {
        let rot = Quat::from_rotation_vector(Vec3::new(0.4, -1.0, 0.3));
        for (d, said) in [
            ([1.0, 5.0, 2.0], "triangle"),
            ([1.0, -0.5, 1.0], "not positive"),
            ([0.0, 2.0, 2.0], "line without thickness"),
        ] {
            let j = tensor::rotated(&Mat3::diagonal(d.into()), rot);
            let e = MassProperties::new(1.0, Vec3::ZERO, j).unwrap_err();
            assert!(e.message().contains(said), "{e}");
        }
    }

    #[test]
    fn a_lamina_is_accepted_in_any_axes_and_size() {
        // I3 = I1 + I2 exactly: rounding may fall on either side of the equality.
        for size in [1e-12, 1.0, 1e12] {
            let rot = Quat::from_rotation_vector(Vec3::new(0.4, -1.0, 0.3));
            let j = tensor::rotated(&Mat3::diagonal(Vec3::new(0.1, 0.2, 0.1 + 0.2) * size), rot);
            assert!(MassProperties::new(size, Vec3::ZERO, j).is_ok());
        }
    }

    #[test]
    fn diagonal_inertia_keeps_its_axes_exactly() {
        let p = solid::cuboid([0.3, 0.1, 0.2], 700.0).unwrap().properties().unwrap();
        assert_eq!(p.principal(), Principal { moments: p.inertia().diag(), axes: Quat::IDENTITY });
    }

    #[test]
    fn principal_axes_are_right_handed_and_rebuild_the_inertia() {
        let rot = Quat::from_rotation_vector(Vec3::new(2.0, -1.0, 0.5));
        let p = solid::cuboid([1.0, 2.0, 3.0], 1.0).unwrap().rotated(rot).properties().unwrap();
        let principal = p.principal();
        assert_eq!(p.principal(), principal);
        let back = tensor::rotated(&Mat3::diagonal(principal.moments), principal.axes);
        // As in the eigenvalue test, and the quaternion's own few roundings: 50 ε of the largest moment.
        assert!((back - p.inertia()).max_abs() < 50.0 * f64::EPSILON * p.inertia().max_abs());
        let mut moments = principal.moments.to_array();
        moments.sort_by(f64::total_cmp);
        for (i, expected) in moments.iter().zip([6.0 * 5.0 / 12.0, 6.0 * 10.0 / 12.0, 6.0 * 13.0 / 12.0]) {
            assert!((i - expected).abs() < 50.0 * f64::EPSILON * 6.5);
        }
    }

    #[test]
    fn scaling_keeps_the_density() {
        let small = solid::cuboid([0.1, 0.2, 0.3], 500.0).unwrap().translated([1.0, 2.0, 3.0]).properties().unwrap();
        let big = solid::cuboid([0.2, 0.4, 0.6], 500.0).unwrap().translated([2.0, 4.0, 6.0]).properties().unwrap();
        let scaled = small.scaled(2.0).unwrap();
        // Powers of two are exact; the sizes 0.1 and 0.2 round alike.
        assert_eq!(scaled, big);
        let heavy = small.with_mass(2.0 * small.mass()).unwrap();
        assert_eq!(heavy.inertia(), small.inertia().scaled(2.0));
        assert_eq!(small.scaled(-1.0).unwrap_err().path(), "factor");
        assert_eq!(small.with_mass(0.0).unwrap_err().path(), "mass");
        assert_eq!(small.scaled(1e200).unwrap_err().path(), "mass");
    }

    #[test]
    fn a_sum_needs_parts() {
        assert_eq!(MassProperties::sum(&[]).unwrap_err().to_string(), "parts: there must be at least one");
    }
}
