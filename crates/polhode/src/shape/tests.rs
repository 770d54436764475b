use super::*;
use crate::mass::{lamina, outline, shell, solid};
use core::f64::consts::FRAC_PI_2;

const RHO: f64 = 700.0;
const T: f64 = 0.002;

fn tetrahedron() -> TriangleMesh {
    TriangleMesh::new(vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z], vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
        .unwrap()
}

#[test]
fn each_shape_has_the_moments_of_its_closed_form() {
    let l = vec![[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];
    let size = [0.3, 0.5, 0.7];
    let rows = [
        (Shape::sphere(0.5), solid::sphere(0.5, RHO), shell::sphere(0.5, T, RHO)),
        (Shape::cuboid(size), solid::cuboid(size, RHO), shell::cuboid(size, T, RHO)),
        (Shape::capsule(0.5, 0.9), solid::capsule(0.5, 0.9, RHO), shell::capsule(0.5, 0.9, T, RHO)),
        (Shape::cylinder(0.5, 0.9), solid::cylinder(0.5, 0.9, RHO), shell::cylinder(0.5, 0.9, T, RHO)),
        (Shape::cone(0.5, 0.9), solid::cone(0.5, 0.9, RHO), shell::cone(0.5, 0.9, T, RHO)),
        (Shape::ellipsoid(size), solid::ellipsoid(size, RHO), shell::ellipsoid(size, T, RHO)),
        (Shape::torus(0.9, 0.5), solid::torus(0.9, 0.5, RHO), shell::torus(0.9, 0.5, T, RHO)),
        (Shape::disc(0.5), lamina::disc(0.5, RHO), outline::disc(0.5, T, RHO)),
        (Shape::rectangle([0.3, 0.5]), lamina::rectangle([0.3, 0.5], RHO), outline::rectangle([0.3, 0.5], T, RHO)),
        (Shape::polygon(l.clone()), lamina::polygon(&l, RHO), outline::polygon(&l, T, RHO)),
        (Shape::ring(0.5, 0.9), lamina::ring(0.5, 0.9, RHO), outline::ring(0.5, 0.9, T, RHO)),
    ];
    for (shape, full, hollow) in rows {
        let name = shape.geometry.name();
        let full = full.unwrap();
        assert_eq!(shape.clone().density(RHO).moments().unwrap(), full, "{name}");
        assert_eq!(shape.clone().density(RHO).shell(T).moments().unwrap(), hollow.unwrap(), "{name}");
        assert!(shape.validate().is_ok() && shape.mass_properties().is_ok(), "{name}");
        assert_eq!(shape.geometry.is_planar(), full.second.at(2, 2) == 0.0, "{name}");

        let given = shape.clone().mass(3.0).mass_properties().unwrap();
        // One division and one product: 2 roundings.
        assert!((given.mass() - 3.0).abs() <= 6.0 * f64::EPSILON, "{name}");
        assert_eq!(shape.mass(3.0).density(RHO).moments().unwrap(), full, "{name}");
    }
}

#[test]
fn the_pose_places_the_shape_on_the_body() {
    let turn = Quat::from_axis_angle(Vec3::X, FRAC_PI_2);
    let rod = Shape::cylinder(0.1, 2.0).at([1.0, 0.0, 0.0]).rotated(turn);
    let p = rod.mass_properties().unwrap();
    assert_eq!(p.center(), Vec3::X);
    // Along −y now: the small moment is the middle one.
    let own = solid::cylinder(0.1, 2.0, 1000.0).unwrap().inertia().diag();
    let expected = Vec3::new(own.x, own.z, own.y);
    assert!((p.inertia().diag() - expected).max_abs() <= 10.0 * f64::EPSILON * own.max_abs());
    assert_eq!(Shape::cylinder(0.1, 2.0).posed(Pose::new(Vec3::X, turn)), rod);
    // A quaternion of any length is a rotation.
    assert_eq!(Shape::sphere(1.0).rotated([2.0, 0.0, 0.0, 0.0]), Shape::sphere(1.0));
}

#[test]
fn planar_mass_properties_are_those_about_z() {
    let p = Shape::ring(0.3, 0.5).mass(2.0).at([1.0, 2.0, 0.0]).planar_mass_properties().unwrap();
    assert_eq!(p.center(), [1.0, 2.0]);
    // I = ½ m (r² + R²), to the roundings of its few products.
    assert!((p.inertia() - 0.34).abs() <= 8.0 * f64::EPSILON);
    let ball = Shape::sphere(0.5);
    let (plane, space) = (ball.planar_mass_properties().unwrap(), ball.mass_properties().unwrap());
    assert_eq!(plane.inertia(), space.inertia().at(2, 2));
}

#[test]
fn a_mesh_has_mass_if_it_is_closed() {
    let p = Shape::mesh(tetrahedron()).density(6.0).mass_properties().unwrap();
    // Four triangles' roundings.
    assert!((p.mass() - 1.0).abs() < 40.0 * f64::EPSILON);
    assert!((p.center() - Vec3::splat(0.25)).max_abs() < 40.0 * f64::EPSILON);
    let sheet = TriangleMesh::new(vec![Vec3::ZERO, Vec3::X, Vec3::Y], vec![[0, 1, 2]]).unwrap();
    let ground = Shape::mesh(sheet);
    assert!(ground.validate().is_ok());
    let e = ground.mass_properties().unwrap_err();
    assert_eq!(
        e.to_string(),
        "triangles[0]: its edge 0–1 has no neighbour: the mesh is open (vertices at the same place must be one)"
    );
}

#[test]
fn merging_closes_a_soup_of_triangles() {
    let mesh = tetrahedron();
    let mut positions: Vec<Vec3> = mesh.triangles().iter().flatten().map(|&i| mesh.positions()[i as usize]).collect();
    positions[0].x = -0.0;
    let triangles = (0..4).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).chain([[0, 3, 1]]).collect();
    let soup = TriangleMesh::new(positions, triangles).unwrap();
    assert!(soup.moments(Fill::Solid, 1.0).is_err());
    let merged = soup.merged();
    assert_eq!((merged.positions().len(), merged.triangles().len()), (4, 4));
    assert_eq!(merged.moments(Fill::Solid, 1.0).unwrap(), mesh.moments(Fill::Solid, 1.0).unwrap());
    assert_eq!(merged.clone().merged(), merged);
}

#[test]
fn a_refusal_names_the_culprit() {
    let said = |shape: Shape| shape.validate().unwrap_err().to_string();
    assert_eq!(said(Shape::sphere(0.0)), "radius: must be positive and finite, is 0 m");
    assert_eq!(said(Shape::cuboid([1.0, 1.0, -2.0])), "size[2]: must be positive and finite, is -2 m");
    assert_eq!(said(Shape::sphere(1.0).density(-1.0)), "density: must be positive and finite, is -1 kg/m³");
    assert_eq!(said(Shape::disc(1.0).density(f64::NAN)), "density: must be positive and finite, is NaN kg/m²");
    assert_eq!(said(Shape::disc(1.0).mass(0.0)), "mass: must be positive and finite, is 0 kg");
    assert_eq!(said(Shape::disc(1.0).shell(-1.0)), "thickness: must be positive and finite, is -1 m");
    assert_eq!(said(Shape::disc(1.0).at([0.0, f64::NAN, 0.0])), "position: must be finite, is (0, NaN, 0)");
    assert_eq!(said(Shape::disc(1.0).rotated([0.0; 4])), "rotation: must be a unit quaternion, has length NaN");
    let mut stretched = Shape::disc(1.0);
    stretched.pose.rot = Quat::new(2.0, 0.0, 0.0, 0.0);
    assert_eq!(said(stretched), "rotation: must be a unit quaternion, has length 2");
    assert_eq!(said(Shape::half_space([0.0; 3])), "normal: must not be zero");
    assert_eq!(said(Shape::half_space([0.0, 0.0, f64::INFINITY])), "normal: must be finite, is (0, 0, inf)");
    assert_eq!(said(Shape::polygon([[0.0, 0.0], [1.0, 0.0]])), "points: a polygon needs at least 3 corners, has 2");
    let plane = Shape::half_space([0.0, 0.0, 1.0]);
    assert!(plane.validate().is_ok());
    assert_eq!(
        plane.mass_properties().unwrap_err().to_string(),
        "half_space: has no mass: it belongs on a fixed body, or on one whose mass properties are given"
    );
    let e = TriangleMesh::new(vec![Vec3::ZERO], vec![[0, 0, 1]]).unwrap_err();
    assert_eq!(e.to_string(), "triangles[0]: names vertex 1, but there are 1, numbered from 0");
    // In range on its own, out of range as a mass.
    assert_eq!(Shape::sphere(1e200).mass_properties().unwrap_err().path(), "mass");
}
