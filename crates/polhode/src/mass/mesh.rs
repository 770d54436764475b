//! Mass properties of closed triangle meshes of uniform density.
//!
//! The surface must be closed and oriented: every edge belongs to two triangles that run through it in opposite directions,
//! and corners run counter-clockwise as seen from outside. Several separate pieces are one body, and a piece that is
//! inside-out within another is a cavity. The cost is O(n log n) in the number of triangles.

use super::closed::{self, corners};
use super::simplex::{SimplexSum, middle};
use super::{Moments, check};
use crate::error::Error;
use crate::math::Vec3;
use robust::{Coord3D, orient3d};

/// The interior of a closed mesh, filled at `density` \[kg/m³\] (Mirtich 1996; Eberly, *Game Physics*).
///
/// Each triangle spans a tetrahedron of signed volume a·(b×c)/6 with the middle of the mesh; their integrals are sums of
/// products of corners and exact for the polyhedron. Rounding costs digits in proportion to the size of the mesh, not to
/// its distance from the origin.
///
/// # Errors
/// Names the first offending vertex, triangle or edge: an index out of range, a position that is not finite, a triangle
/// without area, an edge without its opposite (the mesh is open, or two neighbours disagree about the outside) or with more
/// than two triangles, a piece that is inside-out or has no volume. Also if the density is not positive and finite.
pub fn solid(positions: &[Vec3], triangles: &[[u32; 3]], density: f64) -> Result<Moments, Error> {
    let rho = check::density(density)?;
    closed::check(positions, triangles)?;
    let origin = middle(triangles.iter().flat_map(|&t| corners(positions, t)));
    let mut sum = SimplexSum::ZERO;
    for &triangle in triangles {
        let [a, b, c] = corners(positions, triangle).map(|p| p - origin);
        sum.add(a.dot(b.cross(c)) / 6.0, [Vec3::ZERO, a, b, c]);
    }
    Ok(sum.moments(rho, origin))
}

/// [`solid`] of a convex surface that is closed by construction, where triangles without area do no harm.
///
/// About one of its corners no tetrahedron has a negative volume, and the volumes are exact to a few roundings: nothing
/// cancels, however thin the body is.
pub(crate) fn solid_of_convex(positions: &[Vec3], triangles: &[[u32; 3]], density: f64) -> Result<Moments, Error> {
    let rho = check::density(density)?;
    let coord = |p: Vec3| Coord3D { x: p.x, y: p.y, z: p.z };
    let origin = triangles.first().map_or(Vec3::ZERO, |t| positions[t[0] as usize]);
    let mut sum = SimplexSum::ZERO;
    for &triangle in triangles {
        let corners = corners(positions, triangle);
        let [p, q, r] = corners.map(coord);
        let [a, b, c] = corners.map(|p| p - origin);
        sum.add(orient3d(p, q, r, coord(origin)) / 6.0, [Vec3::ZERO, a, b, c]);
    }
    Ok(sum.moments(rho, origin))
}

/// The surface of a closed mesh as a thin shell, with mass = `density` \[kg/m³\] · `thickness` \[m\] · area.
///
/// # Errors
/// As [`solid`]; also if the thickness is not positive and finite.
pub fn shell(positions: &[Vec3], triangles: &[[u32; 3]], thickness: f64, density: f64) -> Result<Moments, Error> {
    check::positive("thickness", thickness, "m")?;
    check::density(density)?;
    closed::check(positions, triangles)?;
    shell_of_closed(positions, triangles, thickness, density)
}

/// [`shell`] of a surface that is closed by construction.
pub(crate) fn shell_of_closed(
    positions: &[Vec3],
    triangles: &[[u32; 3]],
    thickness: f64,
    density: f64,
) -> Result<Moments, Error> {
    let sigma = check::positive("thickness", thickness, "m")? * check::density(density)?;
    let origin = middle(triangles.iter().flat_map(|&t| corners(positions, t)));
    let mut sum = SimplexSum::ZERO;
    for &triangle in triangles {
        let [a, b, c] = corners(positions, triangle).map(|p| p - origin);
        sum.add(0.5 * (b - a).cross(c - a).length(), [a, b, c]);
    }
    Ok(sum.moments(sigma, origin))
}

/// Checks that indices are in range and positions finite: what any mesh must be, closed or not.
///
/// # Errors
/// Names the first position or triangle that is not as it must be, or `triangles` where there are none.
pub fn check(positions: &[Vec3], triangles: &[[u32; 3]]) -> Result<(), Error> {
    closed::check_indices(positions, triangles)
}
