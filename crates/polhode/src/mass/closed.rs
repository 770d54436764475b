//! Whether a triangle mesh is the surface of a body: closed, oriented outward, enclosing a volume.

use super::check::{finite, show};
use super::simplex::{greatest, least};
use crate::error::Error;
use crate::math::Vec3;

/// The three corners of a triangle whose indices are in range.
pub(super) fn corners(positions: &[Vec3], triangle: [u32; 3]) -> [Vec3; 3] {
    triangle.map(|i| positions[i as usize])
}

/// Refuses a mesh that is not the surface of a body, and names the first vertex, triangle or edge at fault.
pub(super) fn check(positions: &[Vec3], triangles: &[[u32; 3]]) -> Result<(), Error> {
    check_indices(positions, triangles)?;
    check_areas(positions, triangles)?;
    check_edges(triangles)?;
    check_pieces(&pieces(positions, triangles))
}

/// Refuses positions that are not finite and triangles that name a vertex which does not exist.
pub(super) fn check_indices(positions: &[Vec3], triangles: &[[u32; 3]]) -> Result<(), Error> {
    if triangles.is_empty() {
        return Err(Error::new("triangles", "there must be at least one"));
    }
    for (i, &p) in positions.iter().enumerate() {
        finite("", p).map_err(|e| e.inside(format_args!("positions[{i}]")))?;
    }
    let n = positions.len();
    for (i, triangle) in triangles.iter().enumerate() {
        if let Some(index) = triangle.iter().find(|&&index| index as usize >= n) {
            return Err(at(i, format!("names vertex {index}, but there are {n}, numbered from 0")));
        }
    }
    Ok(())
}

fn at(triangle: usize, message: impl Into<String>) -> Error {
    Error::new(format!("triangles[{triangle}]"), message)
}

fn check_areas(positions: &[Vec3], triangles: &[[u32; 3]]) -> Result<(), Error> {
    // Rounding of the product of two edges: below this their angle is zero as far as f64 can tell.
    const FLAT: f64 = 16.0 * f64::EPSILON;
    for (i, &triangle) in triangles.iter().enumerate() {
        let [a, b, c] = corners(positions, triangle);
        let (ab, ac) = (b - a, c - a);
        if ab.cross(ac).length() <= FLAT * ab.length() * ac.length() {
            let [u, v, w] = triangle;
            return Err(at(i, format!("is degenerate: its corners {u}, {v}, {w} lie on one line")));
        }
    }
    Ok(())
}

/// An edge as one triangle runs through it.
struct HalfEdge {
    /// The smaller and the larger vertex, in one number to sort by.
    key: u64,
    triangle: u32,
    /// From the smaller vertex to the larger.
    upward: bool,
}

/// Every edge must belong to two triangles, in opposite directions. Sorted rather than hashed: the same order everywhere.
fn check_edges(triangles: &[[u32; 3]]) -> Result<(), Error> {
    let mut edges = Vec::with_capacity(3 * triangles.len());
    for (triangle, &[a, b, c]) in triangles.iter().enumerate() {
        for (from, to) in [(a, b), (b, c), (c, a)] {
            let upward = from < to;
            let (low, high) = if upward { (from, to) } else { (to, from) };
            edges.push(HalfEdge { key: u64::from(low) << 32 | u64::from(high), triangle: triangle as u32, upward });
        }
    }
    edges.sort_unstable_by_key(|e| (e.key, e.triangle));
    let bad = |group: &&[HalfEdge]| group.len() != 2 || group[0].upward == group[1].upward;
    match edges.chunk_by(|e, f| e.key == f.key).filter(bad).min_by_key(|group| (group[0].triangle, group[0].key)) {
        None => Ok(()),
        Some(group) => Err(edge_error(group)),
    }
}

fn edge_error(group: &[HalfEdge]) -> Error {
    let (low, high) = (group[0].key >> 32, group[0].key & u64::from(u32::MAX));
    let message = match group {
        [_] => {
            format!("its edge {low}–{high} has no neighbour: the mesh is open (vertices at the same place must be one)")
        }
        [_, other] => {
            let other = other.triangle;
            format!("runs through its edge {low}–{high} in the same direction as triangles[{other}]: one is inside-out")
        }
        more => format!(
            "its edge {low}–{high} belongs to {} triangles; on the surface of a body it belongs to 2",
            more.len()
        ),
    };
    at(group[0].triangle as usize, message)
}

/// A connected part of a closed surface.
struct Piece {
    first_triangle: usize,
    /// A corner of the piece: volumes are relative to it, so that no digits are lost far from the origin.
    origin: Vec3,
    volume: f64,
    area: f64,
    low: Vec3,
    high: Vec3,
}

impl Piece {
    fn new(first_triangle: usize, origin: Vec3) -> Self {
        Self { first_triangle, origin, volume: 0.0, area: 0.0, low: origin, high: origin }
    }
    fn add(&mut self, corners: [Vec3; 3]) {
        let [a, b, c] = corners.map(|p| p - self.origin);
        self.volume += a.dot(b.cross(c)) / 6.0;
        self.area += 0.5 * (b - a).cross(c - a).length();
        for p in corners {
            (self.low, self.high) = (least(self.low, p), greatest(self.high, p));
        }
    }
    /// Whether `cavity` can be a hollow within this piece. The boxes decide: an honest cavity always passes, and a piece
    /// turned inside-out by mistake lies apart from the others.
    fn can_hold(&self, cavity: &Self) -> bool {
        let (from, to) = (cavity.low - self.low, self.high - cavity.high);
        let inside = [from, to].iter().all(|v| v.x >= 0.0 && v.y >= 0.0 && v.z >= 0.0);
        inside && self.volume > -cavity.volume
    }
}

/// The connected parts of a surface, in the order of their first triangles.
fn pieces(positions: &[Vec3], triangles: &[[u32; 3]]) -> Vec<Piece> {
    let mut parent: Vec<u32> = (0..positions.len() as u32).collect();
    for &[a, b, c] in triangles {
        for (u, v) in [(a, b), (b, c)] {
            let (u, v) = (root(&mut parent, u), root(&mut parent, v));
            // The smaller number is the root: the same forest whatever the machine.
            parent[u.max(v) as usize] = u.min(v);
        }
    }
    const NONE: u32 = u32::MAX;
    let mut piece_of_root = vec![NONE; positions.len()];
    let mut pieces = Vec::new();
    for (i, &triangle) in triangles.iter().enumerate() {
        let root = root(&mut parent, triangle[0]) as usize;
        if piece_of_root[root] == NONE {
            piece_of_root[root] = pieces.len() as u32;
            pieces.push(Piece::new(i, positions[triangle[0] as usize]));
        }
        pieces[piece_of_root[root] as usize].add(corners(positions, triangle));
    }
    pieces
}

fn root(parent: &mut [u32], mut v: u32) -> u32 {
    while parent[v as usize] != v {
        let up = parent[parent[v as usize] as usize];
        parent[v as usize] = up;
        v = up;
    }
    v
}

/// Every piece must enclose a volume, and one that is inside-out must be a cavity of another.
fn check_pieces(pieces: &[Piece]) -> Result<(), Error> {
    // Rounding of the sum of tetrahedra of a piece, relative to the product of its area and its size.
    const NO_VOLUME: f64 = 1e-13;
    for piece in pieces {
        if piece.volume.abs() <= NO_VOLUME * piece.area * (piece.high - piece.low).length() {
            return Err(at(piece.first_triangle, "the piece of surface it belongs to encloses no volume"));
        }
    }
    let mut outer: Vec<&Piece> = pieces.iter().filter(|p| p.volume > 0.0).collect();
    outer.sort_by(|p, q| p.low.x.total_cmp(&q.low.x));
    for cavity in pieces.iter().filter(|p| p.volume < 0.0) {
        // What holds a cavity begins before it, and most often just before.
        let n_before = outer.partition_point(|p| p.low.x <= cavity.low.x);
        if !outer[..n_before].iter().rev().any(|p| p.can_hold(cavity)) {
            let volume = show(cavity.volume);
            let message = format!(
                "inside-out: the piece of surface it belongs to has the volume {volume} m³ and is no cavity of another; \
                 corners run counter-clockwise as seen from outside"
            );
            return Err(at(cavity.first_triangle, message));
        }
    }
    let total: f64 = pieces.iter().map(|p| p.volume).sum();
    if total <= 0.0 {
        return Err(Error::new("triangles", format!("the cavities leave a volume of {} m³", show(total))));
    }
    Ok(())
}
