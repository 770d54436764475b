//! Every closed form against a mesh and against particles, with the slope of the difference.

use super::surfaces::{self, Mesh};
use crate::error::Error;
use crate::mass::{Moments, Particle, lamina, mesh, outline, shell, solid};
use crate::math::Vec3;
use core::f64::consts::{FRAC_PI_2, PI, TAU};

const RHO: f64 = 700.0;
const T: f64 = 0.002;

/// What a closed form says that symmetry does not: mass, height of the centre, mean squares.
fn numbers(m: &Moments) -> [f64; 5] {
    let c = m.second.diag();
    // A centre at zero has no relative error: measured in units of the shape's own height.
    let height = 1.0 + m.center.z / (c.max_abs() / m.mass).sqrt();
    [m.mass, height, c.x, c.y, c.z]
}

/// Asserts that `approach(n)` tends to `limit` as n⁻² and that the n⁻² term taken out leaves n⁻⁴.
///
/// With errors c n⁻² + d n⁻⁴, the slope between n and 2n is 2 + ¾ (d/c) n⁻²/ln 2, and the extrapolated value is off by
/// ¼ d n⁻⁴. The shapes below are functions of angles of 90°/n and shares of 1/n, so that |d/c| ≤ (π/2)² ≈ 2.5 and
/// |c| ≤ 3 · 2.5: at n = 16 at most 0.011 in slope and 1e-4 · 0.7 in value; doubled for products of two such factors.
fn assert_second_order(name: &str, limit: &Moments, approach: impl Fn(u32) -> Moments) {
    const N: u32 = 16;
    let (exact, coarse, fine) = (numbers(limit), numbers(&approach(N)), numbers(&approach(2 * N)));
    for i in 0..5 {
        if exact[i] == 0.0 {
            assert_eq!((coarse[i], fine[i]), (0.0, 0.0), "{name}[{i}]");
            continue;
        }
        let (e1, e2) = (coarse[i] / exact[i] - 1.0, fine[i] / exact[i] - 1.0);
        // Sums of some ten thousand terms: what is below is rounding, and the number is exact already.
        if e1.abs() > 1e-11 {
            let slope = libm::log2((e1 / e2).abs());
            assert!((slope - 2.0).abs() < 0.022, "{name}[{i}]: slope {slope}, errors {e1:e} {e2:e}");
        }
        let extrapolated = (4.0 * e2 - e1) / 3.0;
        assert!(extrapolated.abs() < 1.4e-4, "{name}[{i}]: {extrapolated:e}");
    }
    let off = |m: &Moments| [m.second.at(0, 1), m.second.at(0, 2), m.second.at(1, 2), m.center.x, m.center.y];
    for o in off(limit).into_iter().chain(off(&approach(2 * N))) {
        assert!(o.abs() < 1e-12 * limit.mass, "{name}: {o:e}");
    }
}

#[test]
fn meshes_of_round_shapes_tend_to_their_closed_forms() {
    type Row = (&'static str, Moments, Moments, fn(u32) -> Mesh);
    let rows: [Row; 6] = [
        ("sphere", solid::sphere(0.7, RHO).unwrap(), shell::sphere(0.7, T, RHO).unwrap(), |n| {
            surfaces::ellipsoid([0.7; 3], n)
        }),
        ("capsule", solid::capsule(0.4, 0.9, RHO).unwrap(), shell::capsule(0.4, 0.9, T, RHO).unwrap(), |n| {
            surfaces::capsule(0.4, 0.9, n)
        }),
        ("cylinder", solid::cylinder(0.4, 0.9, RHO).unwrap(), shell::cylinder(0.4, 0.9, T, RHO).unwrap(), |n| {
            surfaces::cylinder(0.4, 0.9, n)
        }),
        ("cone", solid::cone(0.4, 0.9, RHO).unwrap(), shell::cone(0.4, 0.9, T, RHO).unwrap(), |n| {
            surfaces::cone(0.4, 0.9, n)
        }),
        (
            "ellipsoid",
            solid::ellipsoid([0.5, 0.9, 0.7], RHO).unwrap(),
            shell::ellipsoid([0.5, 0.9, 0.7], T, RHO).unwrap(),
            |n| surfaces::ellipsoid([0.5, 0.9, 0.7], n),
        ),
        ("torus", solid::torus(0.9, 0.4, RHO).unwrap(), shell::torus(0.9, 0.4, T, RHO).unwrap(), |n| {
            surfaces::torus(0.9, 0.4, n)
        }),
    ];
    for (name, filled, hollow, surface) in rows {
        assert_second_order(name, &filled, |n| {
            let (positions, triangles) = surface(n);
            mesh::solid(&positions, &triangles, RHO).unwrap()
        });
        assert_second_order(&format!("{name} shell"), &hollow, |n| {
            let (positions, triangles) = surface(n);
            mesh::shell(&positions, &triangles, T, RHO).unwrap()
        });
    }
}

#[test]
fn a_meshed_box_is_the_closed_form() {
    let (positions, triangles) = surfaces::cuboid([-0.5, -1.0, -1.5], [0.5, 1.0, 1.5]);
    let filled = (solid::cuboid([1.0, 2.0, 3.0], RHO).unwrap(), mesh::solid(&positions, &triangles, RHO).unwrap());
    let hollow =
        (shell::cuboid([1.0, 2.0, 3.0], T, RHO).unwrap(), mesh::shell(&positions, &triangles, T, RHO).unwrap());
    for (a, b) in [filled, hollow] {
        // Twelve triangles with some ten roundings each.
        let allowed = 120.0 * f64::EPSILON;
        assert!((b.mass / a.mass - 1.0).abs() < allowed);
        assert!(b.center.max_abs() < allowed);
        assert!((b.second - a.second).max_abs() < allowed * a.second.max_abs());
    }
}

#[test]
fn a_box_of_one_by_two_by_three() {
    let p = solid::cuboid([1.0, 2.0, 3.0], 1.0).unwrap().properties().unwrap();
    let j = p.inertia();
    // m (y² + z²)/12 and so on with m = 6; the last is x² + y², not y² + z².
    let expected = Vec3::new(6.5, 5.0, 2.5);
    assert!((j.diag() - expected).max_abs() <= 4.0 * f64::EPSILON * 6.5);
    // tr J = 2 ∫ r² dm = 2 m (1 + 4 + 9)/12.
    assert!((j.trace() - 14.0).abs() <= 8.0 * f64::EPSILON * 14.0);
    let i = p.principal().moments;
    assert!(i.x <= i.y + i.z && i.y <= i.x + i.z && i.z <= i.x + i.y);
}

#[test]
fn a_unit_cube_has_a_sixth() {
    let j = solid::cuboid([1.0; 3], 1.0).unwrap().properties().unwrap().inertia();
    assert!((j.diag() - Vec3::splat(1.0 / 6.0)).max_abs() < f64::EPSILON);
}

/// The middles of n³ equal cells of the unit cube, taken into space by `map`, which also gives the volume ratio.
fn cells(n: u32, n_deep: u32, map: impl Fn([f64; 3]) -> (Vec3, f64)) -> Moments {
    let middle = |i: u32, n: u32| (f64::from(i) + 0.5) / f64::from(n);
    let cell = 1.0 / (f64::from(n) * f64::from(n) * f64::from(n_deep));
    let mut particles = Vec::new();
    for i in 0..n {
        for j in 0..n {
            for k in 0..n_deep {
                let (r, ratio) = map([middle(i, n), middle(j, n), middle(k, n_deep)]);
                particles.push(Particle::new(r, RHO * ratio * cell));
            }
        }
    }
    Moments::from_particles(&particles).unwrap()
}

#[test]
fn particles_in_a_box_miss_exactly_one_over_n_squared() {
    // ⟨x²⟩ of n equidistant points is (1 − n⁻²)/12: a closed form for every n, hence slope 2.
    let whole = solid::cuboid([1.0, 2.0, 3.0], RHO).unwrap();
    for n in [1, 2, 4, 8, 16_u32] {
        let m = cells(n, n, |[u, v, w]| (Vec3::new(u, 2.0 * v, 3.0 * w), 6.0));
        let expected = whole.second.scaled(1.0 - 1.0 / f64::from(n * n));
        // Sums of n³ equal terms.
        let allowed = f64::from(n * n * n + 8) * f64::EPSILON;
        assert!((m.second - expected).max_abs() <= allowed * whole.second.max_abs());
        assert!((m.center - Vec3::new(0.5, 1.0, 1.5)).max_abs() <= 3.0 * allowed);
    }
}

#[test]
fn particles_in_round_shapes_tend_to_the_closed_forms() {
    let polar = |rho: f64, phi: f64, z: f64| {
        let (sin, cos) = libm::sincos(phi);
        Vec3::new(rho * cos, rho * sin, z)
    };
    // An angle all around is summed exactly by any equidistant points (trigonometric sums), so it costs no error.
    assert_second_order("ball", &solid::sphere(0.7, RHO).unwrap(), |n| {
        cells(n, n, |[u, v, w]| {
            let (sin, cos) = libm::sincos(PI * v);
            (polar(0.7 * u * sin, TAU * w, 0.7 * u * cos), 0.7 * 0.7 * 0.7 * u * u * sin * PI * TAU)
        })
    });
    assert_second_order("cone", &solid::cone(0.4, 0.9, RHO).unwrap(), |n| {
        cells(n, n, |[u, v, w]| {
            let rho = 0.4 * u * v;
            (polar(rho, TAU * w, 0.9 * (0.75 - u)), rho * 0.4 * u * 0.9 * TAU)
        })
    });
    // On a sphere equal steps in z are equal areas.
    assert_second_order("sphere shell", &shell::sphere(0.7, T, RHO).unwrap(), |n| {
        cells(n, 1, |[u, v, _]| {
            let z = 2.0 * v - 1.0;
            (polar((1.0 - z * z).sqrt(), TAU * u, z) * 0.7, T * 0.7 * 0.7 * 2.0 * TAU)
        })
    });
    assert_second_order("ellipsoid shell", &shell::ellipsoid([0.5, 0.9, 0.7], T, RHO).unwrap(), |n| {
        cells(4 * n, 1, |[u, v, _]| {
            let z = 2.0 * v - 1.0;
            let unit = polar((1.0 - z * z).sqrt(), TAU * u, z);
            let normal = Vec3::new(unit.x / 0.5, unit.y / 0.9, unit.z / 0.7);
            (unit.scale(Vec3::new(0.5, 0.9, 0.7)), T * 0.5 * 0.9 * 0.7 * normal.length() * 2.0 * TAU)
        })
    });
    assert_second_order("disc", &lamina::disc(0.7, RHO).unwrap(), |n| {
        cells(n, 1, |[u, v, _]| (polar(0.7 * u, TAU * v, 0.0), 0.7 * u * 0.7 * TAU))
    });
    assert_second_order("ring", &lamina::ring(0.3, 0.7, RHO).unwrap(), |n| {
        cells(n, 1, |[u, v, _]| {
            let rho = 0.3 + 0.4 * u;
            (polar(rho, TAU * v, 0.0), rho * 0.4 * TAU)
        })
    });
    assert_second_order("rectangle", &lamina::rectangle([0.3, 0.7], RHO).unwrap(), |n| {
        cells(n, 1, |[u, v, _]| (Vec3::new(0.3 * (u - 0.5), 0.7 * (v - 0.5), 0.0), 0.3 * 0.7))
    });
}

#[test]
fn a_thin_shell_is_the_difference_of_two_solids() {
    // Between offsets ±t/2 the difference quotient is the derivative to t²/24 of the third one: slope 2 in t.
    let (r, l) = (0.4, 0.9);
    let between = |t: f64, solid: &dyn Fn(f64) -> Moments| solid(0.5 * t) - solid(-0.5 * t);
    let check = |name: &str, shell: &dyn Fn(f64) -> Moments, solid: &dyn Fn(f64) -> Moments| {
        let error = |t: f64| {
            let (thin, thick) = (shell(t), between(t, solid));
            (thin.second - thick.second).max_abs() / thin.second.max_abs()
        };
        let slope = libm::log2(error(0.02) / error(0.01));
        // The next term is t² smaller: 0.02²/0.4² = 2.5e-3 of the first at most, times a factor of order one.
        assert!((slope - 2.0).abs() < 0.01, "{name}: {slope}");
        assert!(error(0.01) < 5e-3, "{name}");
    };
    check("sphere", &|t| shell::sphere(r, t, RHO).unwrap(), &|d| solid::sphere(r + d, RHO).unwrap());
    check("capsule", &|t| shell::capsule(r, l, t, RHO).unwrap(), &|d| solid::capsule(r + d, l, RHO).unwrap());
    check("torus", &|t| shell::torus(l, r, t, RHO).unwrap(), &|d| solid::torus(l, r + d, RHO).unwrap());
    check("disc", &|t| outline::disc(r, t, RHO).unwrap(), &|d| lamina::disc(r + d, RHO).unwrap());
    check("cylinder", &|t| shell::cylinder(r, l, t, RHO).unwrap(), &|d| {
        solid::cylinder(r + d, l + 2.0 * d, RHO).unwrap()
    });
    check("cuboid", &|t| shell::cuboid([0.5, 0.7, 0.9], t, RHO).unwrap(), &|d| {
        solid::cuboid([0.5 + 2.0 * d, 0.7 + 2.0 * d, 0.9 + 2.0 * d], RHO).unwrap()
    });
    check("rectangle", &|t| outline::rectangle([0.5, 0.7], t, RHO).unwrap(), &|d| {
        lamina::rectangle([0.5 + 2.0 * d, 0.7 + 2.0 * d], RHO).unwrap()
    });
    check("ring", &|t| outline::ring(0.3, 0.7, t, RHO).unwrap(), &|d| lamina::ring(0.3 - d, 0.7 + d, RHO).unwrap());
}

#[test]
fn shapes_that_meet_agree() {
    // The same body by two formulas: 30 roundings at most.
    let same = |a: Moments, b: Moments| {
        assert!((a.mass / b.mass - 1.0).abs() < 30.0 * f64::EPSILON);
        assert!((a.second - b.second).max_abs() < 30.0 * f64::EPSILON * a.second.max_abs());
    };
    same(solid::sphere(0.7, RHO).unwrap(), solid::ellipsoid([0.7; 3], RHO).unwrap());
    same(solid::sphere(0.7, RHO).unwrap(), solid::capsule(0.7, 1e-30, RHO).unwrap());
    same(shell::sphere(0.7, T, RHO).unwrap(), shell::capsule(0.7, 1e-30, T, RHO).unwrap());
    same(lamina::disc(0.7, RHO).unwrap(), lamina::ring(1e-30, 0.7, RHO).unwrap());
    let hole = lamina::disc(0.7, RHO).unwrap() - lamina::disc(0.3, RHO).unwrap();
    same(hole, lamina::ring(0.3, 0.7, RHO).unwrap());
    let [a, b] = [0.5, 0.8];
    same(lamina::rectangle([a, b], RHO).unwrap(), lamina::polygon(&rectangle_points(a, b), RHO).unwrap());
    same(outline::rectangle([a, b], T, RHO).unwrap(), outline::polygon(&rectangle_points(a, b), T, RHO).unwrap());
}

fn rectangle_points(w: f64, h: f64) -> [[f64; 2]; 4] {
    let (x, y) = (0.5 * w, 0.5 * h);
    [[-x, -y], [x, -y], [x, y], [-x, y]]
}

#[test]
fn regular_polygons_tend_to_the_disc() {
    let corners = |n: u32| -> Vec<[f64; 2]> {
        (0..4 * n)
            .map(|i| {
                let (sin, cos) = libm::sincos(FRAC_PI_2 * f64::from(i) / f64::from(n));
                [0.7 * cos, 0.7 * sin]
            })
            .collect()
    };
    assert_second_order("disc", &lamina::disc(0.7, RHO).unwrap(), |n| lamina::polygon(&corners(n), RHO).unwrap());
    assert_second_order("circle", &outline::disc(0.7, T, RHO).unwrap(), |n| {
        outline::polygon(&corners(n), T, RHO).unwrap()
    });
}

#[test]
fn a_lamina_in_space_has_the_sum_of_its_planar_moments() {
    let plate = lamina::rectangle([0.3, 0.7], RHO).unwrap();
    let (space, plane) = (plate.properties().unwrap(), plate.planar().unwrap());
    let j = space.inertia();
    assert_eq!(j.at(2, 2), plane.inertia());
    assert!((j.at(0, 0) + j.at(1, 1) - j.at(2, 2)).abs() <= f64::EPSILON * j.at(2, 2));
    assert_eq!(space.mass(), plane.mass());
}

#[test]
fn a_refusal_names_the_dimension() {
    let said = |m: Result<Moments, Error>| m.unwrap_err().to_string();
    assert_eq!(said(solid::sphere(-1.0, RHO)), "radius: must be positive and finite, is -1 m");
    assert_eq!(said(solid::sphere(1.0, 0.0)), "density: must be positive and finite, is 0 kg/m³");
    assert_eq!(said(solid::cuboid([1.0, 0.0, 1.0], RHO)), "size[1]: must be positive and finite, is 0 m");
    assert_eq!(said(solid::capsule(1.0, f64::NAN, RHO)), "length: must be positive and finite, is NaN m");
    assert_eq!(said(solid::cylinder(f64::INFINITY, 1.0, RHO)), "radius: must be positive and finite, is inf m");
    assert_eq!(said(solid::cone(1.0, -1e-9, RHO)), "length: must be positive and finite, is -1e-9 m");
    assert_eq!(said(solid::ellipsoid([1.0, 1.0, -2.0], RHO)), "semi_axes[2]: must be positive and finite, is -2 m");
    assert_eq!(said(solid::torus(0.3, 0.5, RHO)), "minor: must not exceed the major radius 0.3 m, is 0.5 m");
    assert_eq!(said(shell::torus(0.3, 0.0, T, RHO)), "minor: must be positive and finite, is 0 m");
    assert_eq!(said(shell::sphere(1.0, 0.0, RHO)), "thickness: must be positive and finite, is 0 m");
    assert_eq!(said(lamina::disc(1.0, -3.0)), "density: must be positive and finite, is -3 kg/m²");
    assert_eq!(said(lamina::rectangle([-1.0, 1.0], RHO)), "size[0]: must be positive and finite, is -1 m");
    assert_eq!(said(lamina::ring(0.5, 0.5, RHO)), "inner: must be less than the outer radius 0.5 m, is 0.5 m");
    assert_eq!(said(outline::ring(0.5, 0.7, -1.0, RHO)), "thickness: must be positive and finite, is -1 m");
}
