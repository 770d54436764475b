//! The convex hull of points.
//!
//! ```text
//! points ─ scaled by a power of two ─→ quick: exact triangles ─→ merge: convex polygons ─→ ConvexHull
//!                                          ↑                        │ some corners are no vertices
//!                                          └────────────────────────┘
//! ```
//!
//! Signs are exact, so that the surface is always closed and convex; tolerances only decide which points matter and which
//! triangles are one face. With the extent e, the largest absolute value of a coordinate, two points within 16 ε e of each
//! other are one vertex, and every point lies within [`ConvexHull::rounding`] = 64 ε e of the inside of every face.

mod merge;
mod quick;
mod support;

use super::Fill;
use crate::error::Error;
use crate::mass::{Moments, check, mesh};
use crate::math::{Lane, Vec3};
use merge::{Loops, Merged, merge};
use quick::{Flat, bounds, quickhull};

/// No index.
const NONE: u32 = u32::MAX;
/// What coordinates of one plane, computed by a rotation and a shift, may be off it, relative to the extent.
const TOLERANCE: f64 = 16.0 * f64::EPSILON;
/// How far points may be outside, and corners off their plane, relative to the extent: the tolerance of adding, of merging,
/// of leaving out a corner, and of the normal.
const ROUNDING: f64 = 64.0 * f64::EPSILON;
/// Coordinates beyond these lose their products with normals to overflow or underflow.
const RANGE: [f64; 2] = [1e-280, 1e300];

/// A convex polyhedron: the hull of points, with faces that are convex polygons.
///
/// The surface is given as half-edges. Those of face f are a range of numbers h; half-edge h begins at a vertex, runs
/// counter-clockwise around its face as seen from outside, and has a twin that runs the other way along the same edge.
///
/// ```
/// use polhode::{math::Vec3, shape::ConvexHull};
///
/// let corners: Vec<Vec3> = (0..8).map(|i| [i & 1, i >> 1 & 1, i >> 2].map(f64::from).into()).collect();
/// let cube = ConvexHull::new(&corners)?;
/// assert_eq!((cube.vertices().len(), cube.n_edges(), cube.n_faces()), (8, 12, 6));
/// assert_eq!(cube.support(Vec3::new(1.0, 2.0, 3.0)), (7, Vec3::splat(1.0)));
/// # Ok::<(), polhode::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ConvexHull {
    vertices: Vec<Vec3>,
    face_starts: Vec<u32>,
    origins: Vec<u32>,
    twins: Vec<u32>,
    faces_of: Vec<u32>,
    normals: Vec<Vec3>,
    offsets: Vec<f64>,
    neighbour_starts: Vec<u32>,
    neighbours: Vec<u32>,
    extremes: [u32; 6],
    low: Vec3,
    high: Vec3,
    rounding: f64,
}

/// Building.
impl ConvexHull {
    /// The hull of points \[m\], in any order, with any repetitions; those inside are left out.
    ///
    /// O(n log n) for points in no particular arrangement. Vertices keep the order of the points.
    ///
    /// # Errors
    /// Names the first point that is not finite or larger than 1e300 m; or says of `points` that there are fewer than four,
    /// or that they lie at one place, on one line or in one plane, and how far they are off it.
    pub fn new(points: &[Vec3]) -> Result<Self, Error> {
        refuse(points)?;
        let mut hull = Self::attempt(points)?;
        // What a finer tolerance leaves may have a coarser hull: the answer is the one that is its own hull.
        while hull.vertices.len() < points.len() {
            let again = Self::attempt(&hull.vertices)?;
            if again.vertices.len() == hull.vertices.len() {
                return Ok(again);
            }
            hull = again;
        }
        Ok(hull)
    }

    /// The hull at the coarsest tolerance that leaves no face torn.
    fn attempt(points: &[Vec3]) -> Result<Self, Error> {
        let mut trouble = None;
        for fineness in [1.0, 0.25, 0.0625] {
            match Self::with_tolerance(points, fineness * TOLERANCE) {
                Ok(Some(hull)) => return Ok(hull),
                Ok(None) => {}
                Err(e) => {
                    trouble.get_or_insert(e);
                }
            }
        }
        let message = "are too close to a plane or a line: rounding cannot tell their faces apart";
        Err(trouble.unwrap_or_else(|| Error::new("points", message)))
    }

    /// `None` if rounding cannot tell the faces apart at this tolerance, relative to the extent.
    fn with_tolerance(points: &[Vec3], tolerance: f64) -> Result<Option<Self>, Error> {
        let mut chosen = points.to_vec();
        loop {
            let extent = extent(&chosen);
            let scale = Scale::to_one(extent);
            let scaled: Vec<Vec3> = chosen.iter().map(|&p| scale.of(p)).collect();
            let unit = extent * scale.factor;
            let triangles = quickhull(&scaled, tolerance * unit).map_err(|flat| too_flat(&flat, scale.factor))?;
            let mut used = triangles.corners.as_flattened().to_vec();
            used.sort_unstable();
            used.dedup();
            if used.len() < chosen.len() {
                chosen = pick(&chosen, &used);
                continue;
            }
            match merge(&triangles, &scaled, tolerance * unit) {
                // All in few planes: what is left has no volume.
                Merged::Fewer(vertices) if vertices.len() < 4 => return Ok(None),
                Merged::Fewer(vertices) => chosen = pick(&chosen, &vertices),
                Merged::Faces(loops) => {
                    return Ok(Self::assemble(chosen, loops, ROUNDING * extent).settled(&scaled, ROUNDING * unit));
                }
                Merged::Torn => return Ok(None),
            }
        }
    }

    /// Adds what follows from loops around faces; offsets are left open.
    fn assemble(vertices: Vec<Vec3>, loops: Loops, rounding: f64) -> Self {
        let Loops { starts, origins, normals } = loops;
        let n_half_edges = origins.len();
        let mut faces_of = vec![0; n_half_edges];
        let mut ends = vec![0; n_half_edges];
        for (f, range) in starts.windows(2).enumerate() {
            let (first, last) = (range[0] as usize, range[1] as usize);
            for h in first..last {
                faces_of[h] = f as u32;
                ends[h] = origins[if h + 1 == last { first } else { h + 1 }];
            }
        }
        let mut order: Vec<u32> = (0..n_half_edges as u32).collect();
        order.sort_unstable_by_key(|&h| (origins[h as usize], ends[h as usize]));
        let mut neighbour_starts = vec![0_u32; vertices.len() + 1];
        for &v in &origins {
            neighbour_starts[v as usize + 1] += 1;
        }
        for v in 0..vertices.len() {
            neighbour_starts[v + 1] += neighbour_starts[v];
        }
        let neighbours: Vec<u32> = order.iter().map(|&h| ends[h as usize]).collect();
        let mut twins = vec![NONE; n_half_edges];
        for &h in &order {
            let (from, to) = (origins[h as usize], ends[h as usize]);
            let range = neighbour_starts[to as usize] as usize..neighbour_starts[to as usize + 1] as usize;
            if let Ok(i) = neighbours[range.clone()].binary_search(&from) {
                twins[h as usize] = order[range.start + i];
            }
        }
        let (low, high) = bounds(&vertices);
        let offsets = vec![0.0; normals.len()];
        let mut hull = Self {
            vertices,
            face_starts: starts,
            origins,
            twins,
            faces_of,
            normals,
            offsets,
            neighbour_starts,
            neighbours,
            extremes: [0; 6],
            low,
            high,
            rounding,
        };
        hull.extremes = hull.find_extremes();
        hull
    }

    /// Moves every plane out to the last vertex; `None` if that, or a corner that turns inward, takes a corner of the face
    /// farther from where it should be than `rounding`.
    fn settled(mut self, scaled: &[Vec3], rounding: f64) -> Option<Self> {
        for f in 0..self.n_faces() {
            let normal = self.normals[f];
            let corners = self.face(f);
            let origin = scaled[corners[0] as usize];
            let height = |v: u32| normal.dot(scaled[v as usize] - origin);
            // In a valid hull no extreme vertex is above the face, and the walk has nothing to climb.
            let higher = |u: u32, v: u32| if height(v) > height(u) { v } else { u };
            let start = self.extremes.into_iter().fold(corners[0], higher);
            let top = self.climb(start, |from, to| support::rise(normal, scaled[to as usize] - scaled[from as usize]));
            let highest = height(top);
            let n = corners.len();
            for i in 0..n {
                let [a, b, c] = [i, (i + 1) % n, (i + 2) % n].map(|k| scaled[corners[k] as usize]);
                let inward = normal.dot((c - a).cross(b - a));
                let beyond = self.beyond(self.half_edges(f).start + i)?;
                if height(beyond) > rounding
                    || height(corners[i]) < highest - rounding
                    || inward > rounding * (c - a).length()
                {
                    return None;
                }
            }
            self.offsets[f] = normal.dot(self.vertices[top as usize]);
        }
        let opposite = |h: usize| self.twins[h] != NONE && self.twins[self.twins[h] as usize] as usize == h;
        (0..self.twins.len()).all(opposite).then_some(self)
    }
}

impl ConvexHull {
    /// A vertex of the face across a half-edge, not on the edge; `None` if there is no such face.
    fn beyond(&self, half_edge: usize) -> Option<u32> {
        let twin = self.twins[half_edge];
        let face = *self.faces_of.get(twin as usize)?;
        let range = self.half_edges(face as usize);
        let n = range.len();
        Some(self.origins[range.start + (twin as usize - range.start + 2) % n])
    }
}

/// What it is made of.
impl ConvexHull {
    /// Positions of the vertices, no two the same \[m\].
    pub fn vertices(&self) -> &[Vec3] {
        &self.vertices
    }
    /// How many faces there are.
    pub fn n_faces(&self) -> usize {
        self.normals.len()
    }
    /// How many edges there are: V − E + F = 2.
    pub fn n_edges(&self) -> usize {
        self.twins.len() / 2
    }
    /// The vertices of a face, counter-clockwise as seen from outside.
    ///
    /// # Panics
    /// If there is no such face.
    pub fn face(&self, face: usize) -> &[u32] {
        &self.origins[self.half_edges(face)]
    }
    /// The half-edges of a face, in the order of [`ConvexHull::face`].
    ///
    /// # Panics
    /// If there is no such face.
    pub fn half_edges(&self, face: usize) -> core::ops::Range<usize> {
        self.face_starts[face] as usize..self.face_starts[face + 1] as usize
    }
    /// Where the half-edges of each face begin, and their number at the end, (`n_faces` + 1).
    pub fn face_starts(&self) -> &[u32] {
        &self.face_starts
    }
    /// The vertex at which each half-edge begins.
    pub fn origins(&self) -> &[u32] {
        &self.origins
    }
    /// The half-edge that runs the other way along the same edge.
    pub fn twins(&self) -> &[u32] {
        &self.twins
    }
    /// The face of each half-edge.
    pub fn faces_of(&self) -> &[u32] {
        &self.faces_of
    }
    /// Each edge once: its half-edge with the smaller number.
    pub fn edges(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.twins.len()).filter(|&h| h < self.twins[h] as usize)
    }
    /// Outward unit normals of the faces.
    pub fn normals(&self) -> &[Vec3] {
        &self.normals
    }
    /// Distances of the planes of the faces from the origin, along their normals: n · p ≤ offset inside \[m\].
    pub fn offsets(&self) -> &[f64] {
        &self.offsets
    }
    /// The vertices joined to a vertex by an edge, ascending.
    ///
    /// # Panics
    /// If there is no such vertex.
    pub fn neighbours(&self, vertex: usize) -> &[u32] {
        &self.neighbours[self.neighbour_starts[vertex] as usize..self.neighbour_starts[vertex + 1] as usize]
    }
    /// The least and the greatest corner of its box \[m\].
    pub fn bounds(&self) -> [Vec3; 2] {
        [self.low, self.high]
    }
    /// Middle and radius of a ball that holds it, about the middle of its box \[m\].
    pub fn bounding_sphere(&self) -> (Vec3, f64) {
        let middle = self.low + (self.high - self.low) * 0.5;
        let radius = self.vertices.iter().fold(0.0, |r: f64, &v| r.greatest((v - middle).robust_length()));
        (middle, radius)
    }
    /// How far the points it was made from may be outside a face, and the vertices of a face off its plane: 64 ε times the
    /// largest absolute value of a coordinate \[m\].
    pub fn rounding(&self) -> f64 {
        self.rounding
    }
    /// Its faces as triangles, counter-clockwise as seen from outside: a fan around the first vertex of each.
    pub fn triangles(&self) -> Vec<[u32; 3]> {
        let fan = |f| self.face(f)[1..].windows(2).map(move |edge| [self.face(f)[0], edge[0], edge[1]]);
        (0..self.n_faces()).flat_map(fan).collect()
    }
    /// Mass, centre and second moment, at `density` \[kg/m³\].
    ///
    /// # Errors
    /// If the density or the thickness is not positive and finite.
    pub fn moments(&self, fill: Fill, density: f64) -> Result<Moments, Error> {
        match fill {
            Fill::Solid => mesh::solid_of_convex(&self.vertices, &self.triangles(), density),
            Fill::Shell { thickness } => mesh::shell_of_closed(&self.vertices, &self.triangles(), thickness, density),
        }
    }
}

/// A power of two that brings coordinates below 1, in two factors, for it may itself be out of range.
struct Scale {
    factor: f64,
}

impl Scale {
    fn to_one(extent: f64) -> Self {
        // The exponent of `extent` turned around: between 2⁻¹⁰⁰⁰ and 2⁹³⁵ for the range of extents accepted.
        let biased = extent.to_bits() >> 52;
        Self { factor: f64::from_bits((2045 - biased) << 52) }
    }
    /// Coordinates that no product of three can underflow: multiples of 2⁻³⁰⁰.
    fn of(&self, p: Vec3) -> Vec3 {
        const SMALLEST: f64 = f64::from_bits((1023 - 248) << 52);
        let scaled = (p * self.factor).to_array().map(|x| if x.abs() < SMALLEST { 0.0 } else { x });
        scaled.into()
    }
}

fn pick(points: &[Vec3], chosen: &[u32]) -> Vec<Vec3> {
    chosen.iter().map(|&i| points[i as usize]).collect()
}

fn extent(points: &[Vec3]) -> f64 {
    points.iter().fold(0.0, |e: f64, p| e.greatest(p.max_abs()))
}

/// Refuses what cannot be computed with.
fn refuse(points: &[Vec3]) -> Result<(), Error> {
    let n = points.len();
    for (i, &p) in points.iter().enumerate() {
        check::finite("", p).map_err(|e| e.inside(format_args!("points[{i}]")))?;
        if p.max_abs() > RANGE[1] {
            let message = format!("must not exceed {:e} m, has a coordinate of {:e} m", RANGE[1], p.max_abs());
            return Err(Error::new(format!("points[{i}]"), message));
        }
    }
    if n < 4 {
        return Err(Error::new("points", format!("a convex hull needs at least 4, has {n}")));
    }
    if n >= NONE as usize / 8 {
        return Err(Error::new("points", format!("there are {n}; at most {} can be numbered", NONE / 8)));
    }
    let extent = extent(points);
    if extent < RANGE[0] {
        return Err(Error::new("points", format!("all lie within {extent:e} m of the origin: too small for a volume")));
    }
    Ok(())
}

fn too_flat(flat: &Flat, factor: f64) -> Error {
    let (what, width) = match flat {
        Flat::Coincident(width) => ("are all at one place", width),
        Flat::Collinear(width) => ("all lie on one line", width),
        Flat::Coplanar(width) => ("all lie in one plane", width),
    };
    let width = check::show(width / factor);
    Error::new("points", format!("{what}, to rounding: they are at most {width} m off it, so there is no volume"))
}

#[cfg(test)]
mod tests;
