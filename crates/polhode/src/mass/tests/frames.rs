//! Invariance: where the frame is, how it is turned, and into which parts a body is cut, changes nothing.

use super::surfaces::{self, Mesh};
use crate::mass::{MassProperties, Moments, Particle, mesh};
use crate::math::{Mat3, Pose, Quat, Vec3};
use proptest::prelude::*;

fn vector(size: f64) -> impl Strategy<Value = Vec3> {
    prop::array::uniform3(-size..size).prop_map(Vec3::from)
}

fn pose() -> impl Strategy<Value = Pose> {
    (vector(10.0), vector(2.0)).prop_map(|(x, u)| Pose::new(x, Quat::from_rotation_vector(u)))
}

/// A closed surface without symmetry: a sphere of radius 1 with each vertex moved along its radius by up to a third.
fn potato() -> impl Strategy<Value = Mesh> {
    prop::collection::vec(0.67..1.33_f64, 26).prop_map(|radii| {
        let (positions, triangles) = surfaces::ellipsoid([1.0; 3], 2);
        (positions.iter().zip(radii).map(|(&p, r)| p * r).collect(), triangles)
    })
}

/// Coordinates up to 30 in all, some thousand roundings of their squares times the mass.
fn allowed(mass: f64) -> f64 {
    1000.0 * f64::EPSILON * 900.0 * mass
}

fn assert_same(a: &Moments, b: &Moments) {
    let allowed = allowed(a.mass);
    assert!((a.mass - b.mass).abs() <= allowed, "{a:?} {b:?}");
    assert!((a.center - b.center).max_abs() * a.mass <= allowed, "{a:?} {b:?}");
    assert!((a.second - b.second).max_abs() <= allowed, "{a:?} {b:?}");
}

proptest! {
    #[test]
    fn a_moved_mesh_has_moved_moments((positions, triangles) in potato(), pose in pose()) {
        let moved: Vec<Vec3> = positions.iter().map(|&p| pose.point(p)).collect();
        let here = mesh::solid(&positions, &triangles, 500.0).unwrap();
        let there = mesh::solid(&moved, &triangles, 500.0).unwrap();
        assert_same(&here.transformed(pose), &there);
        assert_same(&here, &there.transformed(pose.inverse()));
        let here = mesh::shell(&positions, &triangles, 0.01, 500.0).unwrap();
        let there = mesh::shell(&moved, &triangles, 0.01, 500.0).unwrap();
        assert_same(&here.transformed(pose), &there);
    }

    #[test]
    fn properties_and_moments_move_alike((positions, triangles) in potato(), pose in pose(), point in vector(3.0)) {
        let moments = mesh::solid(&positions, &triangles, 500.0).unwrap();
        let properties = moments.properties().unwrap();
        assert_same(&properties.transformed(pose).into(), &moments.transformed(pose));
        assert_same(&Moments::from(properties), &moments);
        let difference = properties.inertia_about(point) - moments.inertia_about(point);
        prop_assert!(difference.max_abs() <= allowed(moments.mass));
        // The inertia of a turned body needs no new sum: J = R J₀ Rᵀ, about its own centre.
        let turned: Vec<Vec3> = positions.iter().map(|&p| pose.rot.rotate(p)).collect();
        let again = mesh::solid(&turned, &triangles, 500.0).unwrap().inertia();
        let r = pose.rot.to_mat3();
        prop_assert!((r * properties.inertia() * r.transposed() - again).max_abs() <= allowed(moments.mass));
        prop_assert_eq!(properties.rotated(pose.rot).inertia().transposed(), properties.rotated(pose.rot).inertia());
    }

    #[test]
    fn scaling_a_mesh_scales_its_properties((positions, triangles) in potato(), factor in 0.1..3.0_f64) {
        let scaled: Vec<Vec3> = positions.iter().map(|&p| p * factor).collect();
        let a = mesh::solid(&positions, &triangles, 500.0).unwrap().properties().unwrap().scaled(factor).unwrap();
        let b = mesh::solid(&scaled, &triangles, 500.0).unwrap().properties().unwrap();
        assert_same(&a.into(), &b.into());
    }

    #[test]
    fn two_pieces_of_a_tetrahedron_are_the_whole(
        moved in prop::array::uniform4(vector(0.4)),
        share in 0.1..0.9_f64,
    ) {
        // The edges are 3·1 plus elements below 0.8: diagonally dominant (2.2 > 1.6), so never flat.
        let corners = [Vec3::ZERO, Vec3::X * 3.0, Vec3::Y * 3.0, Vec3::Z * 3.0];
        let corners = [0, 1, 2, 3].map(|i| corners[i] + moved[i]);
        let [a, b, c, d] = corners;
        let of = |p: [Vec3; 4]| {
            let (positions, triangles) = surfaces::tetrahedron(p);
            mesh::solid(&positions, &triangles, 2.0).unwrap()
        };
        // Cut by the plane through c, d and a point of the edge a–b.
        let cut = a + (b - a) * share;
        let (whole, parts) = (of(corners), [of([a, cut, c, d]), of([cut, b, c, d])]);
        assert_same(&whole, &parts.into_iter().sum());
        let properties = parts.map(|p| p.properties().unwrap());
        assert_same(&whole, &MassProperties::sum(&properties).unwrap().into());
        assert_same(&parts[0], &(whole - parts[1]));
        // The exact moments of a tetrahedron: those of five particles, 1/20 of the mass at each corner and 4/5 in the middle.
        let center = (a + b + c + d) * 0.25;
        let mut five: Vec<_> = corners.iter().map(|&p| Particle::new(p, whole.mass / 20.0)).collect();
        five.push(Particle::new(center, 0.8 * whole.mass));
        assert_same(&whole, &Moments::from_particles(&five).unwrap());
    }

    #[test]
    fn principal_axes_turn_with_the_body((positions, triangles) in potato(), rot in vector(2.0)) {
        let rot = Quat::from_rotation_vector(rot);
        let properties = mesh::solid(&positions, &triangles, 500.0).unwrap().properties().unwrap();
        let (a, b) = (properties.principal(), properties.rotated(rot).principal());
        let sorted = |v: Vec3| {
            let mut moments = v.to_array();
            moments.sort_by(f64::total_cmp);
            Vec3::from(moments)
        };
        prop_assert!((sorted(a.moments) - sorted(b.moments)).max_abs() <= allowed(properties.mass()));
        for principal in [a, b] {
            prop_assert!((principal.axes.norm_squared() - 1.0).abs() < 8.0 * f64::EPSILON);
        }
        let r = b.axes.to_mat3();
        let back = r * Mat3::diagonal(b.moments) * r.transposed() - properties.rotated(rot).inertia();
        prop_assert!(back.max_abs() <= 50.0 * f64::EPSILON * properties.inertia().max_abs());
    }
}

#[test]
fn the_order_of_parts_does_not_matter_and_nothing_adds_nothing() {
    let part = |x: f64, mass: f64| Moments::from_particles(&[Particle::new([x, 2.0 * x, -x], mass)]).unwrap();
    let (a, b, c) = (part(1.0, 1.0), part(-2.0, 2.0), part(0.5, 4.0));
    assert_same(&((a + b) + c), &(c + (b + a)));
    assert_eq!(Moments::ZERO + a, a);
    assert_eq!(a + Moments::ZERO, a);
    assert_eq!(Moments::default().properties().unwrap_err().to_string(), "mass: must be positive and finite, is 0 kg");
    assert!((a - a).properties().is_err());
}
