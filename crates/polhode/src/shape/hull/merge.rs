//! From triangles to faces: neighbours that lie in one plane, to rounding, become one convex polygon.
//!
//! A face grows from the widest triangle left, whose plane rounding disturbs least, over all neighbours that stay within
//! the tolerance of that plane; the plane is fitted to what was found, and the face grows again, until it grows no more.
//! A corner that is left with fewer than three faces around it lies inside a face or on an edge: it is no vertex, and the
//! hull is made again without it. So every vertex that remains has three faces or more, every face is bounded by one loop,
//! and V − E + F = 2.

use super::NONE;
use super::quick::Triangles;
use crate::math::{Lane, Vec3};

/// Faces as loops of half-edges: half-edge h begins at `origins[h]`, and those of face f are `starts[f]..starts[f + 1]`.
pub(super) struct Loops {
    pub(super) starts: Vec<u32>,
    pub(super) origins: Vec<u32>,
    pub(super) normals: Vec<Vec3>,
}

/// What came of an attempt to merge.
pub(super) enum Merged {
    /// The faces, all of whose corners are vertices.
    Faces(Loops),
    /// The points that are vertices, ascending: fewer than there were.
    Fewer(Vec<u32>),
    /// The border of a face touches itself.
    Torn,
}

/// Merges triangles over `points` into faces whose corners are at most `tolerance` off their plane.
pub(super) fn merge(triangles: &Triangles, points: &[Vec3], tolerance: f64) -> Merged {
    let faces = Regions::grow(triangles, points, tolerance);
    let Some(vertices) = vertices(triangles, &faces.of_triangle, points.len()) else {
        return Merged::Torn;
    };
    if vertices.len() < points.len() {
        return Merged::Fewer(vertices);
    }
    loops(triangles, &faces, points).map_or(Merged::Torn, Merged::Faces)
}

/// Connected triangles in one plane.
struct Regions {
    of_triangle: Vec<u32>,
    /// Sums of the areas of their triangles as vectors.
    areas: Vec<Vec3>,
}

impl Regions {
    fn grow(triangles: &Triangles, points: &[Vec3], tolerance: f64) -> Self {
        let corners = |t: u32| triangles.corners[t as usize].map(|i| points[i as usize]);
        let n_triangles = triangles.corners.len() as u32;
        let areas: Vec<Vec3> = (0..n_triangles).map(|t| area(corners(t))).collect();
        let widths: Vec<f64> = (0..n_triangles).map(|t| areas[t as usize].length() / longest(corners(t))).collect();
        let mut order: Vec<u32> = (0..n_triangles).collect();
        order.sort_unstable_by(|&s, &t| widths[t as usize].total_cmp(&widths[s as usize]).then(s.cmp(&t)));
        let mut grown = Self { of_triangle: vec![NONE; n_triangles as usize], areas: Vec::new() };
        let mut reached = vec![0_u32; n_triangles as usize];
        let mut walk = 0;
        for seed in order {
            if grown.of_triangle[seed as usize] != NONE {
                continue;
            }
            let mut members = vec![seed];
            let mut area = areas[seed as usize];
            // Each fit makes the plane better by the factor by which the face grew: a few suffice.
            for _ in 0..8 {
                walk += 1;
                let found: Vec<Vec3> = members.iter().flat_map(|&t| corners(t)).collect();
                let unit = normal(&found, area);
                let origin = found[0];
                let before = members.len();
                members = flood(triangles, &mut reached, walk, seed, |t| {
                    let flat = |p: Vec3| unit.dot(p - origin).abs() <= tolerance;
                    grown.of_triangle[t as usize] == NONE
                        && areas[t as usize].dot(unit) >= 0.0
                        && corners(t).into_iter().all(flat)
                });
                if members.len() == before {
                    break;
                }
                area = members.iter().map(|&t| areas[t as usize]).sum();
            }
            for &t in &members {
                grown.of_triangle[t as usize] = grown.areas.len() as u32;
            }
            grown.areas.push(members.iter().map(|&t| areas[t as usize]).sum());
        }
        grown
    }
}

/// The unit normal on the side of `area` of the plane through three of the points that are far apart.
///
/// A product of edges would be wrong for a needle of length l and width w by the angle ε l/w, all of it along the needle,
/// and take its far end l times that off the plane. Here the long direction is made perpendicular to the normal to
/// rounding, and the error of the short one only matters over its own length.
fn normal(points: &[Vec3], area: Vec3) -> Vec3 {
    let farthest_from = |q: Vec3| farthest(points, |p| (p - q).length_squared());
    let a = farthest_from(points[0]);
    let b = farthest_from(a);
    let along = (b - a) / (b - a).length();
    let across = |p: Vec3| (p - a) - along * along.dot(p - a);
    let c = across(farthest(points, |p| across(p).length_squared()));
    let short = c / c.length().greatest(f64::MIN_POSITIVE);
    let short = short - along * along.dot(short);
    let n = along.cross(short);
    let n = n / n.length().greatest(f64::MIN_POSITIVE);
    if n.dot(area) < 0.0 { -n } else { n }
}

/// The point of the greatest `measure`; the first of several.
fn farthest(points: &[Vec3], measure: impl Fn(Vec3) -> f64) -> Vec3 {
    let mut best = (points[0], measure(points[0]));
    for &p in points {
        let value = measure(p);
        if value > best.1 {
            best = (p, value);
        }
    }
    best.0
}

/// Half the product of two edges: the area as an outward vector.
fn area([a, b, c]: [Vec3; 3]) -> Vec3 {
    // The two shorter edges lose least.
    let (ab, bc, ca) = (b - a, c - b, a - c);
    let (u, v, w) = (ab.length_squared(), bc.length_squared(), ca.length_squared());
    let product = if u >= v && u >= w {
        bc.cross(ca)
    } else if v >= w {
        ca.cross(ab)
    } else {
        ab.cross(bc)
    };
    product * 0.5
}

fn longest([a, b, c]: [Vec3; 3]) -> f64 {
    (b - a).length().greatest((c - b).length()).greatest((a - c).length())
}

/// The triangles that are reached from `seed` over triangles that belong.
fn flood(triangles: &Triangles, reached: &mut [u32], walk: u32, seed: u32, belongs: impl Fn(u32) -> bool) -> Vec<u32> {
    reached[seed as usize] = walk;
    let mut members = vec![seed];
    let mut next = 0;
    while let Some(&t) = members.get(next) {
        next += 1;
        for neighbour in triangles.neighbours[t as usize] {
            if reached[neighbour as usize] != walk && belongs(neighbour) {
                reached[neighbour as usize] = walk;
                members.push(neighbour);
            }
        }
    }
    members
}

/// The points with three or more faces around them; `None` if a face is around a point twice.
fn vertices(triangles: &Triangles, face: &[u32], n_points: usize) -> Option<Vec<u32>> {
    // Borders between faces, by the point at which they begin.
    let mut borders: Vec<(u32, u32)> = Vec::new();
    for (t, corners) in triangles.corners.iter().enumerate() {
        for i in 0..3 {
            if face[t] != face[triangles.neighbours[t][i] as usize] {
                borders.push((corners[i], face[t]));
            }
        }
    }
    borders.sort_unstable();
    // A face that begins a border at a point once has one piece there.
    if borders.windows(2).any(|pair| pair[0] == pair[1]) {
        return None;
    }
    let mut vertices = Vec::with_capacity(n_points);
    vertices.extend(borders.chunk_by(|a, b| a.0 == b.0).filter(|around| around.len() >= 3).map(|around| around[0].0));
    Some(vertices)
}

/// The border of each face, beginning at its least vertex, in the order of the loops; `None` if one is not a single loop.
fn loops(triangles: &Triangles, regions: &Regions, points: &[Vec3]) -> Option<Loops> {
    let face = &regions.of_triangle;
    let mut borders: Vec<(u32, u32, u32)> = Vec::new();
    for (t, corners) in triangles.corners.iter().enumerate() {
        for i in 0..3 {
            if face[t] != face[triangles.neighbours[t][i] as usize] {
                borders.push((face[t], corners[i], corners[(i + 1) % 3]));
            }
        }
    }
    borders.sort_unstable();
    let mut faces: Vec<(Vec<u32>, Vec3)> = Vec::with_capacity(regions.areas.len());
    for border in borders.chunk_by(|a, b| a.0 == b.0) {
        let first = border[0].1;
        let mut corners = vec![first];
        let mut at = border[0].2;
        while at != first {
            corners.push(at);
            let edge = border.binary_search_by_key(&at, |e| e.1).ok()?;
            at = border[edge].2;
            if corners.len() > border.len() {
                return None;
            }
        }
        if corners.len() != border.len() || corners.len() < 3 {
            return None;
        }
        let area = regions.areas[border[0].0 as usize];
        let positions: Vec<Vec3> = corners.iter().map(|&v| points[v as usize]).collect();
        faces.push((corners, normal(&positions, area)));
    }
    faces.sort_unstable_by(|a, b| a.0.cmp(&b.0));
    let mut loops = Loops { starts: vec![0], origins: Vec::new(), normals: Vec::with_capacity(faces.len()) };
    for (corners, normal) in faces {
        loops.origins.extend(corners);
        loops.starts.push(loops.origins.len() as u32);
        loops.normals.push(normal);
    }
    Some(loops)
}
