//! Archimedes' lift of a fluid at rest on spheres and cuboids: exact volume and centre of the part below the surface.
//!
//! The surface is a plane across the world's gravity. The lift ρ V |g| acts at the centroid of the submerged part, and its
//! potential is ρ |g| V d, with d the depth of that centroid: the work of pushing the fluid aside.

use super::{BodyView, Field, Law, Wrench, at_least};
use crate::Error;
use crate::math::{Pose, Vec3};
use crate::shape::Geometry;

/// The lift of a fluid at rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Buoyancy {
    /// Density ρ of the fluid \[kg/m³\], at least 0.
    pub density: f64,
    /// Height of the surface above the origin, against gravity \[m\].
    pub level: f64,
}

/// The part of a shape below the surface.
#[derive(Clone, Copy, Debug, Default)]
struct Submerged {
    /// \[m³\]
    volume: f64,
    /// World \[m\].
    centroid: Vec3,
}

impl Field {
    /// The lift of a fluid of `density` \[kg/m³\] whose surface is `level` \[m\] above the origin, against gravity.
    ///
    /// It acts on spheres and cuboids; a body with another shape is refused when the field is added.
    pub fn buoyancy(density: f64, level: f64) -> Self {
        Self { law: Law::Buoyancy(Buoyancy { density, level }), only: None }
    }
}

impl Buoyancy {
    /// Whether the law knows the submerged part of a shape.
    pub fn knows(geometry: &Geometry) -> bool {
        matches!(geometry, Geometry::Sphere(_) | Geometry::Cuboid(_))
    }

    /// The lift on the body.
    pub fn wrench(&self, body: &BodyView) -> Wrench {
        let mut sum = Wrench::ZERO;
        self.each_part(body, |part| {
            sum += Wrench::at(body.gravity * (-self.density * part.volume), part.centroid - body.x);
        });
        sum
    }
    /// ρ |g| V d \[J\].
    pub fn potential(&self, body: &BodyView) -> f64 {
        let mut sum = 0.0;
        let g = body.gravity.length();
        self.each_part(body, |part| {
            let up = -body.gravity / g;
            sum += self.density * g * part.volume * (self.level - up.dot(part.centroid));
        });
        sum
    }

    fn each_part(&self, body: &BodyView, mut visit: impl FnMut(Submerged)) {
        let Some(down) = body.gravity.direction() else { return };
        let pose = body.pose();
        for shape in body.shapes {
            let pose = pose * shape.pose;
            let part = match &shape.geometry {
                Geometry::Sphere(s) => submerged_sphere(s.radius, pose.x, -down, self.level),
                Geometry::Cuboid(c) => submerged_cuboid(c.size, pose, -down, self.level),
                _ => continue,
            };
            if part.volume > 0.0 {
                visit(part);
            }
        }
    }

    pub(super) fn validate(&self) -> Result<(), Error> {
        at_least("density", self.density, 0.0, "kg/m³")?;
        at_least("level", self.level, f64::MIN, "m")
    }
}

/// The cap of depth d: V = π d² (3r − d)/3, its centroid 3 (2r − d)²/(4 (3r − d)) below the centre.
fn submerged_sphere(r: f64, center: Vec3, up: Vec3, level: f64) -> Submerged {
    let depth = (level - up.dot(center) + r).clamp(0.0, 2.0 * r);
    let volume = core::f64::consts::PI / 3.0 * depth * depth * (3.0 * r - depth);
    let below = 0.75 * (2.0 * r - depth) * (2.0 * r - depth) / (3.0 * r - depth);
    Submerged { volume, centroid: center - up * below }
}

/// The box below the plane, by the divergence theorem over its clipped faces.
///
/// Seen from a point of the surface the lid has no volume, so the six faces are all that is summed.
fn submerged_cuboid(size: Vec3, pose: Pose, up: Vec3, level: f64) -> Submerged {
    let origin = pose.x + up * (level - up.dot(pose.x));
    let half = size * 0.5;
    let mut volume = 0.0;
    let mut moment = Vec3::ZERO;
    for axis in 0..3 {
        for side in [-1.0, 1.0] {
            let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
            let corner = |sj: f64, sk: f64| {
                let mut c = Vec3::ZERO;
                c[axis] = side * half[axis];
                // Turning the other way on the far side keeps the outside to the right.
                c[j] = side * sj * half[j];
                c[k] = sk * half[k];
                pose.point(c) - origin
            };
            let face = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
            let (polygon, n) = below(face, up);
            for i in 1..n.max(2) - 1 {
                let (a, b, c) = (polygon[0], polygon[i], polygon[i + 1]);
                let d = a.dot(b.cross(c));
                volume += d / 6.0;
                moment += (a + b + c) * (d / 24.0);
            }
        }
    }
    if volume <= 0.0 {
        return Submerged::default();
    }
    Submerged { volume, centroid: origin + moment / volume }
}

/// The part of a quadrilateral below the plane through the origin (Sutherland–Hodgman): at most five corners.
fn below(face: [Vec3; 4], up: Vec3) -> ([Vec3; 5], usize) {
    let mut out = [Vec3::ZERO; 5];
    let mut n = 0;
    for i in 0..4 {
        let (a, b) = (face[i], face[(i + 1) % 4]);
        let (ha, hb) = (up.dot(a), up.dot(b));
        if ha <= 0.0 {
            out[n] = a;
            n += 1;
        }
        if (ha <= 0.0) != (hb <= 0.0) {
            out[n] = a + (b - a) * (ha / (ha - hb));
            n += 1;
        }
    }
    (out, n)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Quat;

    #[test]
    fn half_a_sphere_and_all_of_it() {
        let half = submerged_sphere(2.0, Vec3::ZERO, Vec3::Z, 0.0);
        assert!((half.volume - 16.0 * core::f64::consts::PI / 3.0).abs() < 1e-14);
        assert!((half.centroid.z + 0.75).abs() < 1e-15, "3r/8 below the centre");
        let all = submerged_sphere(2.0, Vec3::ZERO, Vec3::Z, 9.0);
        assert!((all.volume - 32.0 * core::f64::consts::PI / 3.0).abs() < 1e-13);
        assert_eq!(all.centroid, Vec3::ZERO);
        assert_eq!(submerged_sphere(2.0, Vec3::ZERO, Vec3::Z, -2.0).volume, 0.0);
    }

    #[test]
    fn a_level_box_displaces_its_draught() {
        let s = submerged_cuboid(Vec3::new(2.0, 3.0, 4.0), Pose::IDENTITY, Vec3::Z, -1.0);
        assert!((s.volume - 6.0).abs() < 1e-14);
        assert!((s.centroid - Vec3::new(0.0, 0.0, -1.5)).length() < 1e-14);
    }

    /// The part below the plane and the part above it (the same box seen upside down) are the box.
    #[test]
    fn below_and_above_make_the_whole() {
        let size = Vec3::new(1.0, 0.4, 2.0);
        for k in 0..200 {
            let k = f64::from(k);
            let pose = Pose::new(
                Vec3::new(0.3, -0.2, 0.01 * k - 1.0),
                Quat::from_rotation_vector(Vec3::new(0.1 * k, 1.0 - 0.03 * k, 0.02 * k)),
            );
            let up = Vec3::Z;
            let (a, b) = (submerged_cuboid(size, pose, up, 0.1), submerged_cuboid(size, pose, -up, -0.1));
            // Some 36 triangles of |d| ≤ 10 m³, each rounded a few times.
            assert!((a.volume + b.volume - 0.8).abs() < 1e-13, "{k}");
            let moment = a.centroid * a.volume + b.centroid * b.volume;
            assert!((moment - pose.x * 0.8).length() < 1e-13, "{k}");
        }
    }

    /// The lift is minus the gradient of the potential, and the torque its derivative by rotation.
    #[test]
    fn lift_is_the_gradient_of_the_potential() {
        let size = Vec3::new(1.0, 0.4, 2.0);
        let energy = |pose: Pose| {
            let s = submerged_cuboid(size, pose, Vec3::Z, 0.2);
            s.volume * (0.2 - s.centroid.z)
        };
        let pose = Pose::new(Vec3::new(0.0, 0.0, 0.1), Quat::from_rotation_vector(Vec3::new(0.4, -0.7, 0.2)));
        let s = submerged_cuboid(size, pose, Vec3::Z, 0.2);
        let d = 1e-5;
        // Central differences: d² times the third derivative, some 1e-9, and rounding 1e-16/d.
        let slope = (energy(Pose::new(pose.x + Vec3::Z * d, pose.rot))
            - energy(Pose::new(pose.x - Vec3::Z * d, pose.rot)))
            / (2.0 * d);
        assert!((slope + s.volume).abs() < 1e-9);
        for axis in [Vec3::X, Vec3::Y, Vec3::Z] {
            let turned = |a: f64| Pose::new(pose.x, Quat::from_axis_angle(axis, a) * pose.rot);
            let slope = (energy(turned(d)) - energy(turned(-d))) / (2.0 * d);
            let torque = (s.centroid - pose.x).cross(Vec3::Z * s.volume).dot(axis);
            assert!((slope + torque).abs() < 1e-9, "{axis:?}");
        }
    }
}
