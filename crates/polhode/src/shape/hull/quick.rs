//! Quickhull (Barber, Dobkin, Huhdanpaa 1996) on triangles, with exact signs.
//!
//! ```text
//! start with a tetrahedron; every point above a face waits at one such face
//! while some face has a point waiting more than the tolerance above it:
//!     p        = the farthest of them
//!     visible  = the faces that p is strictly above, found from neighbour to neighbour
//!     horizon  = the edges between visible and other faces: one closed loop
//!     replace the visible faces by the triangles from the horizon to p
//!     points that waited at visible faces wait at a new face that they are above, or are inside for good
//! ```
//!
//! "Strictly above" is the exact sign of a determinant. The triangulated surface is therefore exactly convex at all times:
//! the visible faces of one plane are visible together, the visible part is a disc, its border one loop, and no triangle of
//! p with an edge of that loop is without area, for p would lie in the plane of a face that it is strictly above. Nothing
//! can fail to fit. Tolerances only choose which points are worth adding.

use super::NONE;
use crate::math::{Lane, Vec3};
use robust::{Coord3D, orient3d};
use std::collections::VecDeque;

/// A closed surface of triangles, exactly convex, counter-clockwise as seen from outside.
pub(super) struct Triangles {
    /// Indices of points.
    pub(super) corners: Vec<[u32; 3]>,
    /// The triangle across the edge from corner i to corner i + 1.
    pub(super) neighbours: Vec<[u32; 3]>,
}

/// Points that span no volume: how far they reach in the direction in which they are too thin.
pub(super) enum Flat {
    /// All at one place.
    Coincident(f64),
    /// All on one line.
    Collinear(f64),
    /// All in one plane.
    Coplanar(f64),
}

/// Four corners thinner than this many tolerances are flat: within one tolerance, faces are merged.
const FLAT: f64 = 4.0;

struct Face {
    corners: [u32; 3],
    neighbours: [u32; 3],
    origin: Vec3,
    /// Twice the area, outward.
    normal: Vec3,
    inverse_length: f64,
    /// Where the determinant is not greater than this, rounding may have turned its sign.
    uncertainty: f64,
    alive: bool,
    visible: bool,
    /// The last walk that came by.
    walk: u32,
    /// The first of the points that wait here.
    waiting: u32,
    farthest: u32,
    height: f64,
}

struct Builder<'a> {
    points: &'a [Vec3],
    size: Vec3,
    tolerance: f64,
    faces: Vec<Face>,
    free: Vec<u32>,
    /// The point that waits after this one, at the same face.
    next: Vec<u32>,
    /// The new face whose horizon edge begins at this point.
    spoke: Vec<u32>,
    /// First come, first served: a face left coarse among fine ones would hand on its points again and again.
    queue: VecDeque<u32>,
    walk: u32,
}

/// An edge of the horizon, with the face beyond it.
struct Horizon {
    from: u32,
    to: u32,
    beyond: u32,
}

/// The exact hull of those of `points` that are needed for every point to lie at most `tolerance` above every face.
///
/// Coordinates are at most 1 in absolute value and multiples of 2⁻³⁰⁰, so that no product underflows.
pub(super) fn quickhull(points: &[Vec3], tolerance: f64) -> Result<Triangles, Flat> {
    let simplex = simplex(points, tolerance)?;
    let (low, high) = bounds(points);
    let mut builder = Builder {
        points,
        size: high - low,
        tolerance,
        faces: Vec::new(),
        free: Vec::new(),
        next: vec![NONE; points.len()],
        spoke: vec![NONE; points.len()],
        queue: VecDeque::new(),
        walk: 0,
    };
    builder.start(simplex);
    loop {
        while let Some(face) = builder.queue.pop_front() {
            let f = &builder.faces[face as usize];
            if f.alive && f.height > tolerance {
                builder.add(f.farthest, face);
            }
        }
        if !builder.wait_anew() {
            return Ok(builder.finish());
        }
    }
}

/// The least and the greatest of each coordinate.
pub(super) fn bounds(points: &[Vec3]) -> (Vec3, Vec3) {
    let (mut low, mut high) = (Vec3::splat(f64::INFINITY), Vec3::splat(f64::NEG_INFINITY));
    for p in points {
        low = Vec3::new(low.x.least(p.x), low.y.least(p.y), low.z.least(p.z));
        high = Vec3::new(high.x.greatest(p.x), high.y.greatest(p.y), high.z.greatest(p.z));
    }
    (low, high)
}

/// The index and value of the greatest `measure`; the first of several.
fn greatest(points: &[Vec3], measure: impl Fn(Vec3) -> f64) -> (u32, f64) {
    let mut best = (0, f64::NEG_INFINITY);
    for (i, &p) in points.iter().enumerate() {
        let value = measure(p);
        if value > best.1 {
            best = (i as u32, value);
        }
    }
    best
}

/// Four points far apart: the longest of the distances between extreme points, then the farthest from the line, then the
/// farthest from the plane, turned so that the last is below the first three.
fn simplex(points: &[Vec3], tolerance: f64) -> Result<[u32; 4], Flat> {
    let mut extremes = [0; 6];
    for axis in 0..3 {
        extremes[2 * axis] = greatest(points, |p| -p[axis]).0;
        extremes[2 * axis + 1] = greatest(points, |p| p[axis]).0;
    }
    let at = |i: u32| points[i as usize];
    let mut pair = (0, 0, -1.0);
    for (k, &i) in extremes.iter().enumerate() {
        for &j in &extremes[k + 1..] {
            let length = (at(j) - at(i)).length();
            if length > pair.2 {
                pair = (i, j, length);
            }
        }
    }
    let (a, b, length) = pair;
    if length <= FLAT * tolerance {
        return Err(Flat::Coincident(length));
    }
    let along = (at(b) - at(a)) / length;
    let (c, width) = greatest(points, |p| along.cross(p - at(a)).length());
    if width <= FLAT * tolerance {
        return Err(Flat::Collinear(width));
    }
    let normal = along.cross(at(c) - at(a));
    let normal = normal / normal.length();
    let (d, thickness) = greatest(points, |p| normal.dot(p - at(a)).abs());
    let sign = above([at(a), at(b), at(c)], at(d));
    if thickness <= FLAT * tolerance || sign == 0.0 {
        return Err(Flat::Coplanar(thickness));
    }
    Ok(if sign > 0.0 { [a, c, b, d] } else { [a, b, c, d] })
}

/// (b − a) × (c − a) · (p − a): the sign is exact, the size right to a few roundings.
fn above([a, b, c]: [Vec3; 3], p: Vec3) -> f64 {
    let coord = |v: Vec3| Coord3D { x: v.x, y: v.y, z: v.z };
    -orient3d(coord(a), coord(b), coord(c), coord(p))
}

impl Builder<'_> {
    fn at(&self, point: u32) -> Vec3 {
        self.points[point as usize]
    }

    fn face(&self, corners: [u32; 3], neighbours: [u32; 3]) -> Face {
        let [a, b, c] = corners.map(|i| self.at(i));
        let (u, v) = (b - a, c - a);
        let normal = u.cross(v);
        let sum = |p: f64, q: f64| p.abs() + q.abs();
        let terms = Vec3::new(sum(u.y * v.z, u.z * v.y), sum(u.z * v.x, u.x * v.z), sum(u.x * v.y, u.y * v.x));
        // Four roundings of ε/2 in a component of the normal, four more in the scalar product with a difference that is at
        // most the size of the box; twice that, for the terms of second order and the roundings of the bound itself.
        let uncertainty = 8.0 * f64::EPSILON * terms.dot(self.size);
        let length = normal.length().greatest(4.0 * f64::EPSILON * terms.length()).greatest(f64::MIN_POSITIVE);
        Face {
            corners,
            neighbours,
            origin: a,
            normal,
            inverse_length: 1.0 / length,
            uncertainty,
            alive: true,
            visible: false,
            walk: 0,
            waiting: NONE,
            farthest: NONE,
            height: 0.0,
        }
    }

    /// How far a point is above a face; the sign is exact.
    fn height(&self, face: u32, point: u32) -> f64 {
        let f = &self.faces[face as usize];
        let p = self.at(point);
        let det = f.normal.dot(p - f.origin);
        if det.abs() > f.uncertainty {
            return det * f.inverse_length;
        }
        above(f.corners.map(|i| self.at(i)), p) * f.inverse_length
    }

    fn start(&mut self, [a, b, c, d]: [u32; 4]) {
        // d is below (a, b, c): the other three faces run through its edges backwards.
        let faces = [([a, b, c], [1, 2, 3]), ([b, a, d], [0, 3, 2]), ([c, b, d], [0, 1, 3]), ([a, c, d], [0, 2, 1])];
        for (corners, neighbours) in faces {
            let face = self.face(corners, neighbours);
            self.faces.push(face);
        }
        for point in 0..self.points.len() as u32 {
            self.wait_at_one_of(point, &[0, 1, 2, 3]);
        }
        self.queue.extend([0, 1, 2, 3]);
    }

    /// Lets the point wait at the first of the faces that it is above; a point above none is inside.
    fn wait_at_one_of(&mut self, point: u32, faces: &[u32]) {
        for &face in faces {
            let height = self.height(face, point);
            if height > 0.0 {
                self.wait(point, face, height);
                return;
            }
        }
    }

    fn wait(&mut self, point: u32, face: u32, height: f64) {
        let f = &mut self.faces[face as usize];
        self.next[point as usize] = f.waiting;
        f.waiting = point;
        // Of several equally high, the first in the input: the lists run backwards.
        if height > f.height || (height == f.height && point < f.farthest) {
            (f.farthest, f.height) = (point, height);
        }
    }

    /// The faces that a point is strictly above, beginning with one of them, and the edges around them.
    fn visible_from(&mut self, point: u32, first: u32) -> (Vec<u32>, Vec<Horizon>) {
        self.walk += 1;
        let mut visible = vec![first];
        let mut horizon = Vec::new();
        let f = &mut self.faces[first as usize];
        (f.walk, f.visible) = (self.walk, true);
        let mut next = 0;
        while let Some(&face) = visible.get(next) {
            next += 1;
            for i in 0..3 {
                let f = &self.faces[face as usize];
                let (from, to, beyond) = (f.corners[i], f.corners[(i + 1) % 3], f.neighbours[i]);
                if self.faces[beyond as usize].walk != self.walk {
                    let above = self.height(beyond, point) > 0.0;
                    let f = &mut self.faces[beyond as usize];
                    (f.walk, f.visible) = (self.walk, above);
                    if above {
                        visible.push(beyond);
                    }
                }
                if !self.faces[beyond as usize].visible {
                    horizon.push(Horizon { from, to, beyond });
                }
            }
        }
        (visible, horizon)
    }

    /// Adds a point that is strictly above `face` to the surface.
    fn add(&mut self, point: u32, face: u32) {
        let (visible, horizon) = self.visible_from(point, face);
        let mut orphans = Vec::new();
        for &face in &visible {
            let f = &mut self.faces[face as usize];
            f.alive = false;
            let mut orphan = f.waiting;
            while orphan != NONE {
                if orphan != point {
                    orphans.push(orphan);
                }
                orphan = self.next[orphan as usize];
            }
            self.free.push(face);
        }
        let mut created = Vec::with_capacity(horizon.len());
        for &Horizon { from, to, beyond } in &horizon {
            let face = self.face([from, to, point], [beyond, NONE, NONE]);
            let slot = if let Some(slot) = self.free.pop() {
                self.faces[slot as usize] = face;
                slot
            } else {
                self.faces.push(face);
                self.faces.len() as u32 - 1
            };
            let f = &mut self.faces[beyond as usize];
            for i in 0..3 {
                if f.corners[i] == to && f.corners[(i + 1) % 3] == from {
                    f.neighbours[i] = slot;
                }
            }
            self.spoke[from as usize] = slot;
            created.push(slot);
        }
        for &slot in &created {
            let after = self.spoke[self.faces[slot as usize].corners[1] as usize];
            self.faces[slot as usize].neighbours[1] = after;
            self.faces[after as usize].neighbours[2] = slot;
        }
        // Lists run backwards; ascending order makes the first of equals win whatever the history.
        orphans.sort_unstable();
        for orphan in orphans {
            self.wait_at_one_of(orphan, &created);
        }
        self.queue.extend(created.iter().filter(|&&slot| self.faces[slot as usize].height > self.tolerance));
    }

    /// A point waits at one face, and may be higher above another. Lets each wait where it is highest; false if none of
    /// them is higher than the tolerance.
    fn wait_anew(&mut self) -> bool {
        let mut waiting = Vec::new();
        for face in 0..self.faces.len() as u32 {
            let f = &mut self.faces[face as usize];
            let mut point = if f.alive { f.waiting } else { NONE };
            (f.waiting, f.farthest, f.height) = (NONE, NONE, 0.0);
            while point != NONE {
                waiting.push((point, face));
                point = self.next[point as usize];
            }
        }
        waiting.sort_unstable();
        for (point, face) in waiting {
            let (visible, _) = self.visible_from(point, face);
            let mut best = (face, 0.0);
            for face in visible {
                let height = self.height(face, point);
                if height > best.1 {
                    best = (face, height);
                }
            }
            self.wait(point, best.0, best.1);
            if best.1 > self.tolerance {
                self.queue.push_back(best.0);
            }
        }
        !self.queue.is_empty()
    }

    fn finish(self) -> Triangles {
        let mut place = vec![NONE; self.faces.len()];
        let mut corners = Vec::new();
        for (i, f) in self.faces.iter().enumerate() {
            if f.alive {
                place[i] = corners.len() as u32;
                corners.push(f.corners);
            }
        }
        let alive = self.faces.iter().filter(|f| f.alive);
        let neighbours = alive.map(|f| f.neighbours.map(|i| place[i as usize])).collect();
        Triangles { corners, neighbours }
    }
}
