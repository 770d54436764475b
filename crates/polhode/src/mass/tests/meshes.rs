//! Mesh integrals in closed form, far away, with cavities; and every refusal.

use super::surfaces::{self, Mesh, cuboid, inside_out, together};
use crate::error::Error;
use crate::mass::{MassProperties, Moments, mesh};
use crate::math::{Mat3, Vec3};
use proptest::prelude::*;

fn solid((positions, triangles): &Mesh, density: f64) -> Result<Moments, Error> {
    mesh::solid(positions, triangles, density)
}

fn refusal(m: &Mesh) -> String {
    // The shell of a bad mesh is refused for the same reason.
    let said = solid(m, 1.0).unwrap_err().to_string();
    assert_eq!(mesh::shell(&m.0, &m.1, 0.1, 1.0).unwrap_err().to_string(), said);
    said
}

#[test]
fn the_unit_tetrahedron() {
    let t = surfaces::tetrahedron([Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z]);
    let m = solid(&t, 1.0).unwrap();
    // V = 1/6, centre ¼, second moment about the origin 1/60 on the diagonal and 1/120 off it; four triangles' roundings.
    let allowed = 40.0 * f64::EPSILON;
    assert!((m.mass - 1.0 / 6.0).abs() < allowed);
    assert!((m.center - Vec3::splat(0.25)).max_abs() < allowed);
    let about_origin = m.second + Mat3::outer(m.center, m.center).scaled(m.mass);
    for i in 0..3 {
        for j in 0..3 {
            let expected = if i == j { 1.0 / 60.0 } else { 1.0 / 120.0 };
            assert!((about_origin.at(i, j) - expected).abs() < allowed);
        }
    }
}

#[test]
fn the_unit_cube() {
    let m = solid(&cuboid([0.0; 3], [1.0; 3]), 1.0).unwrap();
    let expected = Mat3::diagonal(Vec3::splat(1.0 / 6.0));
    // Twelve triangles' roundings of numbers up to one.
    assert!((m.inertia() - expected).max_abs() < 50.0 * f64::EPSILON);
    assert!((m.center - Vec3::splat(0.5)).max_abs() < 50.0 * f64::EPSILON);
    assert_eq!(m.properties().unwrap().principal().axes, crate::math::Quat::IDENTITY);
}

#[test]
fn a_million_metres_away_no_digit_is_lost() {
    // Vertices are multiples of 2⁻²⁰ m, so that moving them by 2²⁰ m is exact; then nothing else may differ.
    let (mut near, triangles) = surfaces::ellipsoid([0.5, 0.9, 0.7], 8);
    let grid = libm::exp2(20.0);
    for p in &mut near {
        *p = Vec3::from(p.to_array().map(|x| libm::round(x * grid) / grid));
    }
    let away = Vec3::new(grid, -grid, grid);
    let far: Vec<Vec3> = near.iter().map(|&p| p + away).collect();
    for (a, b) in [
        (mesh::solid(&near, &triangles, 700.0).unwrap(), mesh::solid(&far, &triangles, 700.0).unwrap()),
        (mesh::shell(&near, &triangles, 0.1, 700.0).unwrap(), mesh::shell(&far, &triangles, 0.1, 700.0).unwrap()),
    ] {
        assert_eq!((a.mass, a.second), (b.mass, b.second));
        assert!((a.center + away - b.center).max_abs() <= grid * f64::EPSILON);
    }
}

#[test]
fn a_cavity_is_a_piece_that_is_inside_out() {
    let (outer, hole) = (cuboid([-1.0; 3], [1.0; 3]), cuboid([0.0, -0.5, -0.5], [0.5, 0.5, 0.5]));
    let hollow = solid(&together(&[outer.clone(), inside_out(&hole)]), 3.0).unwrap();
    let difference = solid(&outer, 3.0).unwrap() - solid(&hole, 3.0).unwrap();
    // 24 triangles' roundings of numbers up to the mass of 24.
    assert!((hollow.mass - difference.mass).abs() < 100.0 * f64::EPSILON * 24.0);
    assert!((hollow.center - difference.center).max_abs() < 100.0 * f64::EPSILON);
    assert!((hollow.second - difference.second).max_abs() < 100.0 * f64::EPSILON * 24.0);
}

#[test]
fn separate_pieces_are_one_body() {
    let (a, b) = (cuboid([0.0; 3], [1.0; 3]), cuboid([3.0; 3], [4.0, 5.0, 6.0]));
    let both = solid(&together(&[a.clone(), b.clone()]), 2.0).unwrap();
    let sum = solid(&a, 2.0).unwrap() + solid(&b, 2.0).unwrap();
    assert!((both.center - sum.center).max_abs() < 100.0 * f64::EPSILON * 6.0);
    assert!((both.second - sum.second).max_abs() < 100.0 * f64::EPSILON * sum.second.max_abs());
}

#[test]
fn an_open_mesh_names_the_first_open_edge() {
    let (positions, mut triangles) = cuboid([0.0; 3], [1.0; 3]);
    triangles.remove(7);
    assert_eq!(
        refusal(&(positions, triangles)),
        "triangles[0]: its edge 2–3 has no neighbour: the mesh is open (vertices at the same place must be one)"
    );
}

#[test]
fn a_turned_triangle_is_named_with_its_neighbour() {
    let (positions, mut triangles) = cuboid([0.0; 3], [1.0; 3]);
    triangles[0].swap(1, 2);
    assert_eq!(
        refusal(&(positions, triangles)),
        "triangles[0]: runs through its edge 0–2 in the same direction as triangles[9]: one is inside-out"
    );
}

#[test]
fn an_edge_of_four_triangles_is_named() {
    // Two cubes that share the edge of vertices 6–7 of the first.
    let mut both = together(&[cuboid([0.0; 3], [1.0; 3]), cuboid([0.0, 1.0, 1.0], [1.0, 2.0, 2.0])]);
    for t in &mut both.1 {
        *t = t.map(|i| if i == 8 || i == 9 { i - 2 } else { i });
    }
    assert_eq!(
        refusal(&both),
        "triangles[3]: its edge 6–7 belongs to 4 triangles; on the surface of a body it belongs to 2"
    );
}

#[test]
fn a_surface_inside_out_names_its_first_triangle() {
    // An edge of 6 m, so that the sixths of the volume are whole numbers.
    let right = cuboid([0.0; 3], [6.0; 3]);
    let said = "inside-out: the piece of surface it belongs to has the volume -216 m³ and is no cavity of another; \
                corners run counter-clockwise as seen from outside";
    assert_eq!(refusal(&inside_out(&right)), format!("triangles[0]: {said}"));
    // One piece of three, apart from the others.
    let apart = inside_out(&cuboid([11.0; 3], [17.0; 3]));
    let pieces = together(&[cuboid([-19.0; 3], [-2.0; 3]), apart, right.clone()]);
    assert_eq!(refusal(&pieces), format!("triangles[12]: {said}"));
    // Two cavities in one place, in a box hardly larger.
    let hole = inside_out(&right);
    let holes = together(&[cuboid([-0.0625; 3], [6.0625; 3]), hole.clone(), hole]);
    assert!(refusal(&holes).starts_with("triangles: the cavities leave a volume of -202."));
}

#[test]
fn degenerate_triangles_and_bad_numbers_are_named() {
    let good = cuboid([0.0; 3], [1.0; 3]);
    let mut bad = good.clone();
    bad.1[4] = [1, 5, 5];
    assert_eq!(refusal(&bad), "triangles[4]: is degenerate: its corners 1, 5, 5 lie on one line");
    let mut bad = good.clone();
    bad.0.push(Vec3::new(0.1, 0.2, 0.7));
    bad.0.push(Vec3::new(0.2, 0.4, 1.4));
    bad.1.push([0, 8, 9]);
    assert_eq!(refusal(&bad), "triangles[12]: is degenerate: its corners 0, 8, 9 lie on one line");
    let mut bad = good.clone();
    bad.1[2][1] = 8;
    assert_eq!(refusal(&bad), "triangles[2]: names vertex 8, but there are 8, numbered from 0");
    let mut bad = good.clone();
    bad.0[3].y = f64::NAN;
    assert_eq!(refusal(&bad), "positions[3]: must be finite, is (1, NaN, 0)");
    assert_eq!(refusal(&(good.0.clone(), vec![])), "triangles: there must be at least one");
    // Both sides of one triangle: closed, but nothing is inside.
    assert_eq!(
        refusal(&(good.0.clone(), vec![[0, 1, 2], [0, 2, 1]])),
        "triangles[0]: the piece of surface it belongs to encloses no volume"
    );
    assert_eq!(solid(&good, -1.0).unwrap_err().to_string(), "density: must be positive and finite, is -1 kg/m³");
    let e = mesh::shell(&good.0, &good.1, f64::NAN, 1.0).unwrap_err();
    assert_eq!(e.to_string(), "thickness: must be positive and finite, is NaN m");
}

#[test]
fn the_normals_of_a_closed_surface_cancel() {
    // Σ area n = 0 is what the pairing of edges implies; it would catch a mesh generator or a check that is wrong.
    for (positions, triangles) in [surfaces::torus(0.9, 0.4, 8), surfaces::capsule(0.4, 0.9, 8)] {
        let sum: Vec3 = triangles
            .iter()
            .map(|t| {
                let [a, b, c] = t.map(|i| positions[i as usize]);
                (b - a).cross(c - a) * 0.5
            })
            .sum();
        assert!(sum.max_abs() < triangles.len() as f64 * f64::EPSILON);
    }
}
proptest! {
    #[test]
    fn no_mesh_panics(
        positions in prop::collection::vec(prop::array::uniform3(any::<f64>()), 0..6),
        triangles in prop::collection::vec(prop::array::uniform3(0..6_u32), 0..12),
    ) {
        let positions: Vec<Vec3> = positions.into_iter().map(Vec3::from).collect();
        for m in [mesh::solid(&positions, &triangles, 1.0), mesh::shell(&positions, &triangles, 1.0, 1.0)] {
            if let Ok(p) = m.and_then(|m| m.properties()) {
                prop_assert!(p.mass() > 0.0 && p.principal().moments.is_finite());
            }
        }
    }

    #[test]
    fn no_inertia_panics(mass in any::<f64>(), center in prop::array::uniform3(any::<f64>()), j in any::<[[f64; 3]; 3]>()) {
        if let Ok(p) = MassProperties::new(mass, center, j) {
            prop_assert!(p.principal().axes.is_finite());
        }
    }
}
