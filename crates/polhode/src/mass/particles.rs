//! Mass properties of particles.

use super::{Moments, check, tensor};
use crate::error::Error;
use crate::math::{Mat3, Vec3};

/// A point mass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Particle {
    /// Position \[m\].
    pub position: Vec3,
    /// Mass \[kg\], positive.
    pub mass: f64,
}

impl Particle {
    /// A particle of `mass` \[kg\] at `position` \[m\].
    pub fn new(position: impl Into<Vec3>, mass: f64) -> Self {
        Self { position: position.into(), mass }
    }
    /// J = m(|r|² 1 − r rᵀ), its inertia about the origin \[kg·m²\]; the (z, z) element is m(x² + y²).
    pub fn inertia_about_origin(&self) -> Mat3 {
        tensor::of_point(self.position).scaled(self.mass)
    }
}

impl Moments {
    /// Total mass, centre Σ m r / M and second moment of particles.
    ///
    /// In two passes, the second about the centre that the first has found, so that particles far from the origin lose
    /// nothing. Particles on a line, or one alone, are fine here; only [`Moments::properties`] refuses them.
    ///
    /// # Errors
    /// If there is no particle, or one has a mass that is not positive or a position that is not finite:
    /// `particles[3].mass: must be positive and finite, is -1 kg`.
    pub fn from_particles(particles: &[Particle]) -> Result<Self, Error> {
        let Some(first) = particles.first() else {
            return Err(Error::new("particles", "there must be at least one"));
        };
        for (i, particle) in particles.iter().enumerate() {
            check_particle(particle).map_err(|e| e.inside(format_args!("particles[{i}]")))?;
        }
        let origin = first.position;
        let mass: f64 = particles.iter().map(|p| p.mass).sum();
        let offset = particles.iter().map(|p| (p.position - origin) * p.mass).sum::<Vec3>() / mass;
        let mut second = Mat3::ZERO;
        for p in particles {
            let d = (p.position - origin) - offset;
            second += Mat3::outer(d, d).scaled(p.mass);
        }
        Ok(Self { mass, center: origin + offset, second })
    }
}

fn check_particle(p: &Particle) -> Result<(), Error> {
    check::positive("mass", p.mass, "kg")?;
    check::finite("position", p.position)?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mass::MassProperties;
    use proptest::prelude::*;

    fn cloud() -> impl Strategy<Value = Vec<Particle>> {
        let one = (prop::array::uniform3(-1.0..1.0_f64), 0.1..1.0_f64);
        prop::collection::vec(one, 4..50).prop_map(|v| v.into_iter().map(|(r, m)| Particle::new(r, m)).collect())
    }

    proptest! {
        #[test]
        fn trace_is_twice_the_sum_of_squared_radii(particles in cloud()) {
            let j = Moments::from_particles(&particles).unwrap().inertia_about(Vec3::ZERO);
            let polar: f64 = particles.iter().map(|p| p.mass * p.position.length_squared()).sum();
            let by_particle = particles.iter().fold(Mat3::ZERO, |j, p| j + p.inertia_about_origin());
            // Sums of n positive terms, each off by at most n ε/2 of itself, three of them with a few factors.
            let allowed = 2.0 * (particles.len() + 8) as f64 * f64::EPSILON * 2.0 * polar;
            prop_assert!((j.trace() - 2.0 * polar).abs() < allowed);
            prop_assert!((j - by_particle).max_abs() < allowed);
        }

        #[test]
        fn the_sum_of_two_parts_is_the_whole(particles in cloud(), cut in 1..3_usize) {
            let (a, b) = particles.split_at(cut);
            let sum = Moments::from_particles(a).unwrap() + Moments::from_particles(b).unwrap();
            let whole = Moments::from_particles(&particles).unwrap();
            // Coordinates up to 1, total mass M: n ε M bounds every sum here.
            let allowed = 2.0 * (particles.len() + 8) as f64 * f64::EPSILON * whole.mass;
            prop_assert!((sum.mass - whole.mass).abs() < allowed);
            prop_assert!((sum.center - whole.center).max_abs() < allowed);
            prop_assert!((sum.second - whole.second).max_abs() < allowed);
            let rest = whole - Moments::from_particles(b).unwrap();
            // The mass of the rest is at least M/1000, which is what the subtraction can amplify by, squared in C.
            prop_assert!((rest.center - Moments::from_particles(a).unwrap().center).max_abs() < 1e6 * allowed);
        }
    }

    #[test]
    fn far_from_the_origin_nothing_is_lost() {
        // Positions are multiples of 2⁻²⁰, so that adding 2²⁰ to each is exact and only our own rounding is left.
        let step = libm::exp2(-20.0);
        let near: Vec<Particle> = (0..100_u32)
            .map(|i| {
                let r = [f64::from(i * 7919 % 1009), f64::from(i * 104_729 % 997), f64::from(i * 1299 % 1013)];
                Particle::new(Vec3::from(r) * (1024.0 * step), 1.0 + f64::from(i % 3))
            })
            .collect();
        let far = libm::exp2(20.0);
        let away = Vec3::new(far, -far, far);
        let moved: Vec<Particle> = near.iter().map(|p| Particle::new(p.position + away, p.mass)).collect();
        let (a, b) = (Moments::from_particles(&near).unwrap(), Moments::from_particles(&moved).unwrap());
        // The first particle is the origin of both sums, so that they see the same numbers.
        assert_eq!(a.second, b.second);
        assert!((a.center + away - b.center).max_abs() <= far * f64::EPSILON);
    }

    #[test]
    fn a_line_of_particles_has_moments_but_is_no_rigid_body() {
        let u = Vec3::new(1.0, 2.0, -0.5);
        let line: Vec<Particle> = (0..1000_i32).map(|i| Particle::new(u * (0.01 * f64::from(i)), 0.1)).collect();
        let m = Moments::from_particles(&line).unwrap();
        // Sums of n = 1000 terms: n ε of the result at worst.
        assert!((m.center - u * 4.995).length() < 1000.0 * f64::EPSILON * m.center.length());
        assert!((m.inertia() * u).length() < 1000.0 * f64::EPSILON * m.inertia().max_abs() * u.length());
        let e = MassProperties::from_particles(&line).unwrap_err();
        assert!(e.to_string().starts_with("inertia: is that of a line without thickness: I1 = "), "{e}");
        let e = MassProperties::from_particles(&line[..1]).unwrap_err();
        assert_eq!(e.to_string(), "inertia: is zero: a point of mass needs a size to turn as a rigid body");
    }

    #[test]
    fn a_refusal_names_the_particle() {
        let mut p = vec![Particle::new([0.0; 3], 1.0); 5];
        p[3].mass = -1.0;
        let e = Moments::from_particles(&p).unwrap_err();
        assert_eq!(e.to_string(), "particles[3].mass: must be positive and finite, is -1 kg");
        p[2].position.y = f64::INFINITY;
        let e = Moments::from_particles(&p).unwrap_err();
        assert_eq!(e.to_string(), "particles[2].position: must be finite, is (0, inf, 0)");
        let e = Moments::from_particles(&[]).unwrap_err();
        assert_eq!(e.to_string(), "particles: there must be at least one");
    }
}
