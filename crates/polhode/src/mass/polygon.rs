//! Simple polygons: whether one is, and its integrals.

use super::Moments;
use super::simplex::{SimplexSum, middle};
use crate::error::Error;
use crate::math::Vec3;
use robust::{Coord, orient2d};

type Point = [f64; 2];

/// Refuses what is not a simple polygon.
pub(super) fn check(points: &[Point]) -> Result<(), Error> {
    if points.len() < 3 {
        return Err(Error::new("points", format!("a polygon needs at least 3 corners, has {}", points.len())));
    }
    for (i, [x, y]) in points.iter().enumerate() {
        if !(x.is_finite() && y.is_finite()) {
            return Err(Error::new(format!("points[{i}]"), format!("must be finite, is ({x}, {y})")));
        }
    }
    for i in 0..points.len() {
        let (a, b, c) = (points[i], end(points, i), end(points, (i + 1) % points.len()));
        let next = (i + 1) % points.len();
        if a == b {
            return Err(Error::new(format!("points[{next}]"), "is the same as the corner before it"));
        }
        let along = (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1]);
        if along < 0.0 && side(a, b, c) == 0 {
            return Err(Error::new(format!("points[{next}]"), "the outline turns back on itself"));
        }
    }
    match first_crossing(points) {
        None => Ok(()),
        Some((i, j)) => {
            let name = |edge: usize| format!("{edge}–{}", (edge + 1) % points.len());
            let message = format!("is not simple: its edge {} touches or crosses its edge {}", name(i), name(j));
            Err(Error::new("points", message))
        }
    }
}

/// Where edge `i` ends.
fn end(points: &[Point], i: usize) -> Point {
    points[(i + 1) % points.len()]
}

/// On which side of the line a→b the point c is: the sign is exact (Shewchuk 1997).
fn side(a: Point, b: Point, c: Point) -> i32 {
    let [a, b, c] = [a, b, c].map(|[x, y]| Coord { x, y });
    let twice_area = orient2d(a, b, c);
    i32::from(twice_area > 0.0) - i32::from(twice_area < 0.0)
}

/// The first two edges, in order of their numbers, that share a point and are not neighbours.
///
/// Edges are swept in order of their left ends, so that only those are compared that overlap in x.
fn first_crossing(points: &[Point]) -> Option<(usize, usize)> {
    let span = |i: usize, axis: usize| {
        let (a, b) = (points[i][axis], end(points, i)[axis]);
        if a < b { (a, b) } else { (b, a) }
    };
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_unstable_by(|&i, &j| span(i, 0).0.total_cmp(&span(j, 0).0).then(i.cmp(&j)));
    let mut first = None;
    for (k, &i) in order.iter().enumerate() {
        let (right, (low, high)) = (span(i, 0).1, span(i, 1));
        for &j in order[k + 1..].iter().take_while(|&&j| span(j, 0).0 <= right) {
            let (j_low, j_high) = span(j, 1);
            if j_low <= high && low <= j_high && !neighbours(i, j, points.len()) && share_a_point(points, i, j) {
                let pair = if i < j { (i, j) } else { (j, i) };
                first = Some(first.map_or(pair, |best| if pair < best { pair } else { best }));
            }
        }
    }
    first
}

fn neighbours(i: usize, j: usize, n: usize) -> bool {
    (i + 1) % n == j || (j + 1) % n == i
}

/// Whether two edges whose bounding boxes overlap have a point in common: each one's ends are on both sides of the other's
/// line, or on it.
fn share_a_point(points: &[Point], i: usize, j: usize) -> bool {
    let (a, b) = (points[i], end(points, i));
    let (c, d) = (points[j], end(points, j));
    side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0
}

/// The moments of the area of a simple polygon, by triangles from the middle of its bounding box.
pub(super) fn area_moments(points: &[Point], surface_density: f64) -> Moments {
    let origin = middle(points.iter().copied().map(in_space));
    let mut sum = SimplexSum::ZERO;
    for i in 0..points.len() {
        let (a, b) = (in_space(points[i]) - origin, in_space(end(points, i)) - origin);
        sum.add(0.5 * (a.x * b.y - a.y * b.x), [Vec3::ZERO, a, b]);
    }
    // Clockwise corners have negative area.
    let sign = if sum.measure < 0.0 { -1.0 } else { 1.0 };
    sum.moments(sign * surface_density, origin)
}

/// The moments of the edges of a polygon.
pub(super) fn edge_moments(points: &[Point], mass_per_length: f64) -> Moments {
    let origin = middle(points.iter().copied().map(in_space));
    let mut sum = SimplexSum::ZERO;
    for i in 0..points.len() {
        let (a, b) = (in_space(points[i]) - origin, in_space(end(points, i)) - origin);
        sum.add((b - a).length(), [a, b]);
    }
    sum.moments(mass_per_length, origin)
}

fn in_space([x, y]: Point) -> Vec3 {
    Vec3::new(x, y, 0.0)
}
