//! Mass properties in the plane, where inertia is one number.

use super::{MassProperties, Moments, Particle, check};
use crate::error::Error;
use crate::math::{Mat3, Vec3};
use core::ops::Add;

/// A point mass in the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Particle2 {
    /// Position \[m\].
    pub position: [f64; 2],
    /// Mass \[kg\], positive.
    pub mass: f64,
}

impl From<Particle2> for Particle {
    /// At z = 0.
    fn from(p: Particle2) -> Self {
        Self::new([p.position[0], p.position[1], 0.0], p.mass)
    }
}

/// I = Σ m |r − c|², the inertia about the centre of mass by its definition \[kg·m²\].
///
/// Not finite without particles.
pub fn inertia_about_center(particles: &[Particle2]) -> f64 {
    let (_, [cx, cy]) = mass_and_center(particles);
    particles.iter().fold(0.0, |sum, p| {
        let (x, y) = (p.position[0] - cx, p.position[1] - cy);
        sum + p.mass * (x * x + y * y)
    })
}

/// I = Σ m |r|² − M |c|², the same by the parallel-axis theorem \[kg·m²\].
///
/// What is subtracted is one number, M times the squared distance of the centre. Far from the origin both terms are large
/// and digits are lost; prefer [`inertia_about_center`].
pub fn inertia_by_parallel_axis(particles: &[Particle2]) -> f64 {
    let (mass, [cx, cy]) = mass_and_center(particles);
    let about_origin = particles.iter().fold(0.0, |sum, p| {
        let [x, y] = p.position;
        sum + p.mass * (x * x + y * y)
    });
    about_origin - mass * (cx * cx + cy * cy)
}

fn mass_and_center(particles: &[Particle2]) -> (f64, [f64; 2]) {
    let (mut mass, mut mx, mut my) = (0.0, 0.0, 0.0);
    for p in particles {
        mass += p.mass;
        mx += p.mass * p.position[0];
        my += p.mass * p.position[1];
    }
    (mass, [mx / mass, my / mass])
}

/// The mass, centre of mass and scalar inertia of a rigid body in the plane, known to be physical.
///
/// The inertia is about the axis through the centre of mass, perpendicular to the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassProperties2 {
    mass: f64,
    center: [f64; 2],
    inertia: f64,
}

impl MassProperties2 {
    /// From mass \[kg\], centre of mass \[m\] and inertia about it \[kg·m²\].
    ///
    /// # Errors
    /// Names the first of `mass` (positive and finite), `center` (finite) and `inertia` (positive and finite) that is not
    /// as it must be.
    pub fn new(mass: f64, center: [f64; 2], inertia: f64) -> Result<Self, Error> {
        check::positive("mass", mass, "kg")?;
        if !center.iter().all(|c| c.is_finite()) {
            let [x, y] = center.map(check::show);
            return Err(Error::new("center", format!("must be finite, is ({x}, {y})")));
        }
        check::positive("inertia", inertia, "kg·m²")?;
        Ok(Self { mass, center, inertia })
    }
    /// Of particles that keep their distances.
    ///
    /// # Errors
    /// As [`Moments::from_particles`] and [`MassProperties2::new`]: one particle alone makes no rigid body.
    pub fn from_particles(particles: &[Particle2]) -> Result<Self, Error> {
        let in_space: Vec<Particle> = particles.iter().map(|&p| p.into()).collect();
        Moments::from_particles(&in_space)?.planar()
    }

    /// Mass \[kg\], positive.
    pub fn mass(&self) -> f64 {
        self.mass
    }
    /// Centre of mass \[m\].
    pub fn center(&self) -> [f64; 2] {
        self.center
    }
    /// Inertia about the centre of mass \[kg·m²\], positive.
    pub fn inertia(&self) -> f64 {
        self.inertia
    }
    /// Inertia about `point`, by the parallel-axis theorem \[kg·m²\].
    pub fn inertia_about(&self, point: [f64; 2]) -> f64 {
        let (x, y) = (self.center[0] - point[0], self.center[1] - point[1]);
        self.inertia + self.mass * (x * x + y * y)
    }
    /// The same body in a frame that sees it displaced by the finite vector `by` \[m\].
    pub fn translated(self, by: [f64; 2]) -> Self {
        Self { center: [self.center[0] + by[0], self.center[1] + by[1]], ..self }
    }
    /// The same body turned about the origin by `angle` \[rad\], counter-clockwise; its inertia is the same number.
    pub fn rotated(self, angle: f64) -> Self {
        let (sin, cos) = libm::sincos(angle);
        let [x, y] = self.center;
        Self { center: [cos * x - sin * y, sin * x + cos * y], ..self }
    }
    /// All lengths from the origin times `factor` at the same density per area: mass × factor², inertia × factor⁴.
    ///
    /// # Errors
    /// If `factor` is not positive and finite, or takes the mass or inertia out of the range of f64.
    pub fn scaled(self, factor: f64) -> Result<Self, Error> {
        let f = check::positive("factor", factor, "")?;
        Self::new(self.mass * f * f, self.center.map(|c| c * f), self.inertia * f * f * f * f)
    }
    /// The same shape with another total mass \[kg\]: the inertia in proportion.
    ///
    /// # Errors
    /// If `mass` is not positive and finite, or takes the inertia out of the range of f64.
    pub fn with_mass(self, mass: f64) -> Result<Self, Error> {
        check::positive("mass", mass, "kg")?;
        Self::new(mass, self.center, self.inertia * (mass / self.mass))
    }
    /// The rigid sum of parts that are given in one frame.
    ///
    /// # Errors
    /// If there are no parts.
    pub fn sum(parts: &[Self]) -> Result<Self, Error> {
        parts.iter().copied().reduce(Add::add).ok_or_else(|| Error::new("parts", "there must be at least one"))
    }
    /// A body in space that moves in the plane z = 0 as this one: inertia diag(I/2, I/2, I), as of a disc or a square.
    ///
    /// One number cannot say how the mass is spread along x and y, and a planar motion does not ask. The planar shapes keep
    /// the full moments: see [`lamina`](super::lamina) and [`Moments::properties`].
    ///
    /// # Errors
    /// If half the inertia is below the range of f64.
    pub fn lamina(&self) -> Result<MassProperties, Error> {
        let [x, y] = self.center;
        let half = 0.5 * self.inertia;
        MassProperties::new(self.mass, [x, y, 0.0], Mat3::diagonal(Vec3::new(half, half, self.inertia)))
    }
}

impl Add for MassProperties2 {
    type Output = Self;
    /// Both bodies as one: I = I₁ + I₂ + m₁m₂/(m₁+m₂) |d|², d from one centre to the other.
    fn add(self, b: Self) -> Self {
        let mass = self.mass + b.mass;
        let (x, y) = (b.center[0] - self.center[0], b.center[1] - self.center[1]);
        let share = b.mass / mass;
        Self {
            mass,
            center: [self.center[0] + x * share, self.center[1] + y * share],
            inertia: self.inertia + b.inertia + self.mass * share * (x * x + y * y),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn both_textbook_forms_are_equal(
            points in prop::collection::vec((prop::array::uniform2(-1.0..1.0_f64), 0.1..1.0_f64), 2..40),
            angle in -4.0..4.0_f64,
        ) {
            let particles: Vec<_> = points.into_iter().map(|(position, mass)| Particle2 { position, mass }).collect();
            let (a, b) = (inertia_about_center(&particles), inertia_by_parallel_axis(&particles));
            let about_origin: f64 = particles.iter().map(|p| p.mass * (p.position[0] * p.position[0] + p.position[1] * p.position[1])).sum();
            // Sums of n positive terms that total at most Σ m|r|²: n roundings each, three sums, a few products.
            let allowed = (3 * particles.len() + 10) as f64 * 0.5 * f64::EPSILON * about_origin;
            prop_assert!((a - b).abs() <= allowed, "{a} {b}");
            let p = MassProperties2::from_particles(&particles).unwrap();
            prop_assert!((p.inertia() - a).abs() <= allowed);
            prop_assert!((p.inertia_about([0.0, 0.0]) - about_origin).abs() <= allowed);

            // The inertia is the same in every frame; the centre goes along.
            let (sin, cos) = libm::sincos(angle);
            let turned: Vec<_> = particles.iter().map(|p| {
                let [x, y] = p.position;
                Particle2 { position: [cos * x - sin * y + 3.0, sin * x + cos * y], mass: p.mass }
            }).collect();
            let q = MassProperties2::from_particles(&turned).unwrap();
            let expected = p.rotated(angle).translated([3.0, 0.0]);
            // Coordinates up to 4.5 and total mass M bound every sum.
            let allowed = (3 * particles.len() + 10) as f64 * f64::EPSILON * 20.0 * p.mass();
            prop_assert!((q.inertia() - expected.inertia()).abs() <= allowed);
            prop_assert!((q.center()[0] - expected.center()[0]).abs() <= allowed);
            prop_assert!((q.center()[1] - expected.center()[1]).abs() <= allowed);
        }
    }

    #[test]
    fn a_dumbbell_in_numbers() {
        // 1 kg and 3 kg, 2 m apart: reduced mass 3/4 kg, I = ¾·4 = 3 kg·m², centre at ¾ of the way.
        let particles = [Particle2 { position: [0.0, 0.0], mass: 1.0 }, Particle2 { position: [2.0, 0.0], mass: 3.0 }];
        let p = MassProperties2::from_particles(&particles).unwrap();
        assert_eq!((p.mass(), p.center(), p.inertia()), (4.0, [1.5, 0.0], 3.0));
        // Σ m|r|² − M|c|² = 12 − 9: what is subtracted is one number with the total mass, not a pair.
        assert_eq!(inertia_by_parallel_axis(&particles), 3.0);
        assert_eq!(p.lamina().unwrap().inertia().diag(), Vec3::new(1.5, 1.5, 3.0));
        assert_eq!(p.scaled(2.0).unwrap().inertia(), 48.0);
        assert_eq!(p.with_mass(8.0).unwrap().inertia(), 6.0);
        let halves = [p.translated([1.0, 0.0]), p.translated([-1.0, 0.0])];
        let sum = MassProperties2::sum(&halves).unwrap();
        assert_eq!((sum.mass(), sum.center(), sum.inertia()), (8.0, [1.5, 0.0], 6.0 + 8.0));
    }

    #[test]
    fn refusals_name_the_number() {
        let said = |m, c, i| MassProperties2::new(m, c, i).unwrap_err().to_string();
        assert_eq!(said(0.0, [0.0; 2], 1.0), "mass: must be positive and finite, is 0 kg");
        assert_eq!(said(1.0, [0.0, f64::NAN], 1.0), "center: must be finite, is (0, NaN)");
        assert_eq!(said(1.0, [0.0; 2], -2.0), "inertia: must be positive and finite, is -2 kg·m²");
        let one = [Particle2 { position: [1.0, 2.0], mass: 1.0 }];
        let e = MassProperties2::from_particles(&one).unwrap_err();
        assert_eq!(e.to_string(), "inertia: must be positive and finite, is 0 kg·m²");
        let bad = [one[0], Particle2 { position: [0.0; 2], mass: f64::NAN }];
        let e = MassProperties2::from_particles(&bad).unwrap_err();
        assert_eq!(e.to_string(), "particles[1].mass: must be positive and finite, is NaN kg");
        assert_eq!(MassProperties2::sum(&[]).unwrap_err().path(), "parts");
    }
}
