//! Triangle meshes of the shapes that have closed forms.

use crate::math::Vec3;
use core::f64::consts::{FRAC_PI_2, TAU};

/// Positions and triangles, closed and outward.
pub(super) type Mesh = (Vec<Vec3>, Vec<[u32; 3]>);

/// The surface that a profile of points (distance from z, z) sweeps about z. It begins and ends on the axis and goes up,
/// or outward along the bottom and inward along the top.
pub(super) fn revolved(profile: &[[f64; 2]], n_around: u32) -> Mesh {
    let rings = &profile[1..profile.len() - 1];
    let mut positions = vec![Vec3::Z * profile[0][1]];
    for &[rho, z] in rings {
        for j in 0..n_around {
            let (sin, cos) = libm::sincos(TAU * f64::from(j) / f64::from(n_around));
            positions.push(Vec3::new(rho * cos, rho * sin, z));
        }
    }
    positions.push(Vec3::Z * profile[profile.len() - 1][1]);
    let (bottom, top) = (0, positions.len() as u32 - 1);
    let vertex = |ring: u32, j: u32| 1 + ring * n_around + j % n_around;
    let last = rings.len() as u32 - 1;
    let mut triangles = Vec::new();
    for j in 0..n_around {
        triangles.push([bottom, vertex(0, j + 1), vertex(0, j)]);
        for ring in 0..last {
            let [a, b] = [vertex(ring, j), vertex(ring, j + 1)];
            let [c, d] = [vertex(ring + 1, j + 1), vertex(ring + 1, j)];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
        triangles.push([vertex(last, j), vertex(last, j + 1), top]);
    }
    (positions, triangles)
}

/// `n` points of a quarter circle of radius `r` about (0, z), from `from` to `from` + 90°, without the first.
fn quarter(r: f64, z: f64, from: f64, n: u32) -> impl Iterator<Item = [f64; 2]> {
    (1..=n).map(move |i| {
        let (sin, cos) = libm::sincos(from + FRAC_PI_2 * f64::from(i) / f64::from(n));
        [r * cos, z + r * sin]
    })
}

fn line(a: [f64; 2], b: [f64; 2], n: u32) -> impl Iterator<Item = [f64; 2]> {
    (1..=n).map(move |i| {
        let u = f64::from(i) / f64::from(n);
        [a[0] + (b[0] - a[0]) * u, a[1] + (b[1] - a[1]) * u]
    })
}

pub(super) fn capsule(r: f64, l: f64, n: u32) -> Mesh {
    let h = 0.5 * l;
    let mut profile = vec![[0.0, -h - r]];
    profile.extend(quarter(r, -h, -FRAC_PI_2, n));
    profile.extend(line([r, -h], [r, h], n));
    profile.extend(quarter(r, h, 0.0, n));
    revolved(&profile, 4 * n)
}

pub(super) fn cylinder(r: f64, l: f64, n: u32) -> Mesh {
    let h = 0.5 * l;
    let mut profile = vec![[0.0, -h]];
    profile.extend(line([0.0, -h], [r, -h], n));
    profile.extend(line([r, -h], [r, h], n));
    profile.extend(line([r, h], [0.0, h], n));
    revolved(&profile, 4 * n)
}

pub(super) fn cone(r: f64, l: f64, n: u32) -> Mesh {
    let mut profile = vec![[0.0, -0.25 * l]];
    profile.extend(line([0.0, -0.25 * l], [r, -0.25 * l], n));
    profile.extend(line([r, -0.25 * l], [0.0, 0.75 * l], n));
    revolved(&profile, 4 * n)
}

pub(super) fn ellipsoid(semi_axes: [f64; 3], n: u32) -> Mesh {
    let mut profile = vec![[0.0, -1.0]];
    profile.extend(quarter(1.0, 0.0, -FRAC_PI_2, n));
    profile.extend(quarter(1.0, 0.0, 0.0, n));
    let (mut positions, triangles) = revolved(&profile, 4 * n);
    for p in &mut positions {
        *p = p.scale(semi_axes.into());
    }
    (positions, triangles)
}

pub(super) fn torus(major: f64, minor: f64, n: u32) -> Mesh {
    let (n_around, n_tube) = (4 * n, 2 * n);
    let mut positions = Vec::new();
    for j in 0..n_around {
        let (sin, cos) = libm::sincos(TAU * f64::from(j) / f64::from(n_around));
        for i in 0..n_tube {
            let (up, out) = libm::sincos(TAU * f64::from(i) / f64::from(n_tube));
            let rho = major + minor * out;
            positions.push(Vec3::new(rho * cos, rho * sin, minor * up));
        }
    }
    let vertex = |j: u32, i: u32| (j % n_around) * n_tube + i % n_tube;
    let mut triangles = Vec::new();
    for j in 0..n_around {
        for i in 0..n_tube {
            let [a, b] = [vertex(j, i), vertex(j + 1, i)];
            let [c, d] = [vertex(j + 1, i + 1), vertex(j, i + 1)];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    (positions, triangles)
}

/// A box with corners at `low` and `high`: 12 triangles.
pub(super) fn cuboid(low: [f64; 3], high: [f64; 3]) -> Mesh {
    let ends = [low, high];
    let positions = (0..8_usize).map(|i| Vec3::new(ends[i & 1][0], ends[i >> 1 & 1][1], ends[i >> 2][2])).collect();
    let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    (positions, quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect())
}

/// The tetrahedron of four points, in whichever order encloses a positive volume.
pub(super) fn tetrahedron(p: [Vec3; 4]) -> Mesh {
    let outward = (p[1] - p[0]).dot((p[2] - p[0]).cross(p[3] - p[0])) > 0.0;
    let triangles = vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];
    let turned = |t: Vec<[u32; 3]>| t.into_iter().map(|[a, b, c]| [a, c, b]).collect();
    (p.to_vec(), if outward { triangles } else { turned(triangles) })
}

/// Several meshes as one.
pub(super) fn together(parts: &[Mesh]) -> Mesh {
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    for (p, t) in parts {
        let offset = positions.len() as u32;
        positions.extend_from_slice(p);
        triangles.extend(t.iter().map(|t| t.map(|i| i + offset)));
    }
    (positions, triangles)
}

/// The same surface with the other side out.
pub(super) fn inside_out((positions, triangles): &Mesh) -> Mesh {
    (positions.clone(), triangles.iter().map(|&[a, b, c]| [a, c, b]).collect())
}
